"""Set up .venv for the Makefile, as uv does, from what requirements.txt locks.

A note in .venv says what it was made of. It is taken away first and written last, so the next call
mends what was interrupted. Something outside the checkout is installed only if the system lacks an
OpenGL library or, with ``--browser``, a browser, and only if apt may be used. ``set_up.py uv ...``
calls uv with what pip is told. An old Python must be able to read this file, to be refused.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from lock import hold_checkout

ROOT = Path(__file__).resolve().parents[1]
VENV = ROOT / ".venv"
PYTHON = VENV / "bin" / "python"
MADE_OF = VENV / "made-of"
OLDEST, NEWEST = (3, 11), (3, 13)
REFUSED = "rotedu needs Python {}.{} to {}.{}, not {}.{}: call make with, for example, {}"
# uv does not read what pip is told, in its environment or its files, under these names.
TOLD = {
    "index-url": "UV_DEFAULT_INDEX",
    "extra-index-url": "UV_INDEX",
    "trusted-host": "UV_INSECURE_HOST",
    "cert": "SSL_CERT_FILE",
}
# In a process of its own, because VTK crashes without an OpenGL library. rotedu tells it which of
# its windows has one: by itself, VTK asks for X11 and crashes beside a library that would do.
DRAW = """
import pyvista
import rotedu.figures.backend
plotter = pyvista.Plotter(off_screen=True)
plotter.add_mesh(pyvista.Sphere())
assert plotter.screenshot().std() > 1
"""
NO_OPENGL = """\
VTK finds no OpenGL library that it can draw with. Install one, then call make again: libosmesa6
on Debian and Ubuntu, mesa-libEGL and mesa-dri-drivers on Fedora."""


def uv(*arguments: "str | Path") -> None:
    """Call uv with the settings of pip; settings of its own come first."""
    listed = subprocess.check_output([PYTHON, "-m", "pip", "config", "list"], text=True)
    # pip names the environment first, which comes before its files.
    told = dict(reversed(re.findall(r"(?m)^[^.]*\.([\w-]+)='(.*)'$", listed)))
    settings = {TOLD[name]: told[name].replace("\\n", " ") for name in TOLD if name in told}
    subprocess.check_call([VENV / "bin" / "uv", *arguments], env={**settings, **os.environ})


def apt_install(package: str) -> bool:
    """Install a Debian package if apt is there and this user may use it."""
    if not shutil.which("apt-get") or os.geteuid() != 0:
        return False
    print(f"[set-up] installing the system package {package}", flush=True)
    command = "apt-get update -qq && apt-get install -qq --no-install-recommends " + package
    environment = dict(os.environ, DEBIAN_FRONTEND="noninteractive")
    return subprocess.run(command, shell=True, env=environment, capture_output=True).returncode == 0


def can_draw() -> bool:
    """Tell whether VTK draws on this machine; what else is wrong is shown."""
    trial = subprocess.run([PYTHON, "-c", DRAW], stderr=subprocess.PIPE)
    if trial.returncode > 0:
        sys.exit(trial.stderr.decode())
    return trial.returncode == 0


def set_up() -> None:
    """Make the environment, unless it is made of the same; anew for another Python or folder."""
    here = sys.version.encode() + os.fsencode(ROOT)
    lists = [(ROOT / name).read_bytes() for name in ("requirements.txt", "pyproject.toml")]
    made_of = b"\n".join([here, *lists])
    if MADE_OF.exists() and MADE_OF.read_bytes() == made_of:
        return
    hold_checkout()
    before = MADE_OF.read_bytes() if MADE_OF.exists() else b""
    if before == made_of:
        return
    if before:
        MADE_OF.unlink()
    print("[set-up] installing the packages of requirements.txt into .venv", flush=True)
    if not before.startswith(here):
        [locked] = re.findall(rb"(?m)^uv==.*", lists[0])
        subprocess.check_call([sys.executable, "-m", "venv", "--clear", VENV])
        subprocess.check_call([PYTHON, "-m", "pip", "install", "--quiet", locked])
    uv("pip", "install", "--quiet", "--python", PYTHON, "-r", "requirements.txt")
    if not can_draw() and not (apt_install("libosmesa6") and can_draw()):
        sys.exit(NO_OPENGL)
    MADE_OF.write_bytes(made_of)


def find_browser() -> None:
    """Look for a browser for the tests of the built book; install one where possible."""
    from browser import installed_chromium

    trial = [PYTHON, ROOT / "tools" / "browser.py"]
    if not installed_chromium():
        hold_checkout()
        if not apt_install("chromium"):
            subprocess.run([*trial, "chromium"], capture_output=True)
    sys.exit(subprocess.call(trial))


if __name__ == "__main__":
    here = sys.version_info[:2]
    if not OLDEST <= here <= NEWEST:
        sys.exit(REFUSED.format(*OLDEST, *NEWEST, *here, "PYTHON=python{}.{}".format(*NEWEST)))
    os.chdir(ROOT)
    try:
        if "--browser" in sys.argv:
            find_browser()
        elif "uv" in sys.argv:
            uv(*sys.argv[2:])
        else:
            set_up()
    except subprocess.CalledProcessError as failed:
        sys.exit(f"[set-up] this failed, as said above: {failed.cmd}")
    except KeyboardInterrupt:
        sys.exit("[set-up] interrupted; the next call mends what is half done")
