"""Set up everything that the Makefile's targets need, inside the checkout.

``python3 tools/set_up.py`` makes the virtual environment ``.venv`` from requirements.txt and makes
sure that VTK can draw. With ``--browser`` it looks instead for a browser for the tests of the built
book. It installs something outside the checkout only if the system lacks an OpenGL library or a
browser, and only if it may use apt.

It may be interrupted at any instant. A mark in ``.venv`` is taken away first and made last, and
where this Python's mark is missing, the next call makes the environment anew. ``--mark`` prints its
name for the Makefile, and takes away one that was made in another folder: an environment that has
been moved or copied does not work.
"""

import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from lock import hold_checkout

ROOT = Path(__file__).parents[1]
VENV = ROOT / ".venv"
PYTHON = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
OLDEST, NEWEST = (3, 11), (3, 13)
MARK = VENV / "made-by-python{}.{}".format(*sys.version_info[:2])

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


def run(*command: "str | Path") -> bool:
    """Run a command in the checkout, tell whether it succeeds, and show its output if it fails."""
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        print(done.stdout.decode(errors="replace"), file=sys.stderr, flush=True)
    return done.returncode == 0


def must_run(*command: "str | Path") -> None:
    """Run a command without which nothing else can be done."""
    if not run(*command):
        sys.exit(f"[set-up] this failed, as said above: {' '.join(map(str, command))}")


def is_root() -> bool:
    """Tell whether this user may change the system; Windows does not say."""
    return hasattr(os, "geteuid") and os.geteuid() == 0


def apt_install(package: str) -> bool:
    """Install a Debian package if apt is there and this user may use it."""
    if not shutil.which("apt-get") or not is_root():
        return False
    say(f"installing the system package {package}")
    os.environ["DEBIAN_FRONTEND"] = "noninteractive"
    run("apt-get", "update", "-qq")
    return run("apt-get", "install", "-qq", "--no-install-recommends", package)


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


def locked_uv() -> str:
    """Return the version of uv that requirements.txt locks, as pip wants to read it."""
    return re.search("^uv==.*", (ROOT / "requirements.txt").read_text("utf-8"), re.MULTILINE)[0]


def make_environment(whole: bool) -> None:
    """Install the locked packages and rotedu itself, into a new .venv unless it is whole."""
    if not whole:
        say("making .venv")
        must_run(sys.executable, "-m", "venv", "--clear", VENV)
    say("installing the packages of requirements.txt into .venv")
    pip = (PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check")
    must_run(*pip, locked_uv())
    uv = (PYTHON, "-m", "uv", "pip", "install", "--quiet", "--python", PYTHON)
    must_run(*uv, "-r", "requirements.txt")


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

    trial = [PYTHON, ROOT / "tools" / "browser.py"]
    if not installed_chromium() and not apt_install("chromium"):
        # What it reports is long; the trial says in one line what to do.
        subprocess.run([*trial, "chromium"], capture_output=True, check=False)
    sys.exit(subprocess.run(trial, check=False).returncode)


def set_up(called: float) -> None:
    """Do all that the Makefile's targets need, unless another call has just done it."""
    whole = MARK.exists()
    if whole and MARK.stat().st_mtime > called:
        return
    for mark in VENV.glob("made-by-*"):
        mark.unlink()
    make_environment(whole)
    make_vtk_draw()
    MARK.write_bytes(os.fsencode(ROOT))


def name_of_mark() -> str:
    """Return the name of the mark, and take away one of another folder."""
    if MARK.exists() and MARK.read_bytes() != os.fsencode(ROOT):
        MARK.unlink()
    return MARK.name


if __name__ == "__main__":
    if "--mark" in sys.argv:
        print(name_of_mark())
        sys.exit()
    refused = refusal(*sys.version_info[:2])
    if refused:
        sys.exit(refused)
    called = time.time()
    try:
        if "--browser" in sys.argv:
            find_browser()
        else:
            hold_checkout()
            set_up(called)
    except KeyboardInterrupt:
        sys.exit("[set-up] interrupted; the next call mends what is half done")
