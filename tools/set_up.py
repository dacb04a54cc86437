"""Set up everything that the Makefile's targets need, inside the checkout.

``python3 tools/set_up.py`` makes the virtual environment ``.venv`` from requirements.txt, bundles
the viewer for notebooks and makes sure that VTK can draw. With ``--browser`` it looks instead for a
browser for the tests of the built book. It installs something outside the checkout only if the
system lacks an OpenGL library or a browser, and only if it may use apt.
"""

import os
import shutil
import subprocess
import sys
import venv
from pathlib import Path

ROOT = Path(__file__).parents[1]
VENV = ROOT / ".venv"
PYTHON = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
OLDEST, NEWEST = (3, 11), (3, 13)

# Runs in a process of its own, because VTK crashes without an OpenGL library.
TRIAL_RENDER = """
import pyvista
from rotedu import scenes
pyvista.OFF_SCREEN = True
plotter = scenes.figure_1()
plotter.render()
assert plotter.screenshot().std() > 1
"""
OPENGL_PACKAGES = ("libosmesa6", "libegl1")
OPENGL_HELP = """\
VTK finds no OpenGL library that it can draw with. Install one, then call make again:
  Debian, Ubuntu  sudo apt-get install {packages}
  Fedora          sudo dnf install mesa-libEGL mesa-dri-drivers
  macOS           OpenGL is part of the system: log in to a desktop session
  Windows         OpenGL is part of the graphics driver: update the driver
"""


def say(text: str) -> None:
    """Print a step of the set-up at once."""
    print(f"[set-up] {text}", flush=True)


def is_root() -> bool:
    """Tell whether this user may change the system; Windows does not say."""
    return hasattr(os, "geteuid") and os.geteuid() == 0


def apt_install(package: str) -> bool:
    """Install a Debian package if apt is there and this user may use it."""
    if not shutil.which("apt-get") or not is_root():
        return False
    say(f"installing the system package {package}")
    quiet = {"env": os.environ | {"DEBIAN_FRONTEND": "noninteractive"}, "stdout": sys.stderr}
    subprocess.run(["apt-get", "update", "-qq"], **quiet)
    install = ["apt-get", "install", "-qq", "--no-install-recommends", package]
    return subprocess.run(install, **quiet).returncode == 0


def refusal(major: int, minor: int) -> str:
    """Say in one line why a Python is refused, or nothing if the locked packages support it.

    A Python as old as 3.6 can still read this file, and so gets that line.
    """
    if OLDEST <= (major, minor) <= NEWEST:
        return ""
    here, oldest, newest = ("{}.{}".format(*v) for v in ((major, minor), OLDEST, NEWEST))
    return (
        f"rotedu needs Python {oldest} to {newest}, not {here}: "
        f"call make with, for example, PYTHON=python{newest}"
    )


def made_by_this_python() -> bool:
    """Tell whether .venv is complete and has the same Python version as this process."""
    show = [PYTHON, "-c", "import pip, sys; print(*sys.version_info[:2])"]
    try:
        version = subprocess.run(show, capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return False
    return version.split() == [str(part) for part in sys.version_info[:2]]


def make_environment() -> None:
    """Create .venv and install the locked packages and rotedu itself."""
    if not made_by_this_python():
        say("making .venv")
        venv.create(VENV, with_pip=True, clear=True)
    say("installing the packages of requirements.txt into .venv")
    pip = [PYTHON, "-m", "pip", "install", "-qq", "--disable-pip-version-check"]
    subprocess.run([*pip, "uv"], check=True)
    # The list gives the path of rotedu relative to the checkout.
    uv = [PYTHON, "-m", "uv", "pip", "install", "--quiet", "--python", PYTHON]
    subprocess.run([*uv, "-r", "requirements.txt"], cwd=ROOT, check=True)


def bundle_viewer() -> None:
    """Bundle the viewer for notebooks, which needs what was just installed."""
    say("bundling the viewer for notebooks")
    subprocess.run([PYTHON, ROOT / "tools" / "bundle.py"], check=True)


def can_draw() -> bool:
    """Tell whether VTK draws a picture on this machine."""
    trial = subprocess.run([PYTHON, "-c", TRIAL_RENDER], stderr=subprocess.PIPE, check=False)
    if trial.returncode > 0:
        # Python itself raised an error, which no library can fix.
        sys.exit(trial.stderr.decode())
    return trial.returncode == 0


def make_vtk_draw() -> None:
    """Find out whether VTK draws; if not, install an OpenGL library or say how to."""
    say("drawing a first picture")
    if can_draw() or any(apt_install(package) and can_draw() for package in OPENGL_PACKAGES):
        return
    sys.exit(OPENGL_HELP.format(packages=OPENGL_PACKAGES[0]))


def find_browser() -> None:
    """Look for a browser for the tests of the built book; install one where possible."""
    say("looking for a browser for the tests of the built book")
    # An older Python, which gets no further than its refusal, could not read this module.
    from browser import installed_chromium

    if installed_chromium() or apt_install("chromium"):
        return
    download = [PYTHON, ROOT / "tools" / "browser.py", "chromium"]
    if subprocess.run(download, check=False).returncode != 0:
        say("no browser: the tests that need one will be skipped, and will say so")


if __name__ == "__main__":
    refused = refusal(*sys.version_info[:2])
    if refused:
        sys.exit(refused)
    if "--browser" in sys.argv:
        find_browser()
    else:
        make_environment()
        bundle_viewer()
        make_vtk_draw()
