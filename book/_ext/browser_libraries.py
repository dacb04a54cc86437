"""Serve what the pages need from npm from the book itself."""

import os
import shutil
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from fontTools import subset
from fontTools.ttLib import TTFont
from fontTools.varLib.instancer import instantiateVariableFont
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.errors import ExtensionError
from sphinxcontrib import katex

from rotedu import colors

sys.path.append(str(Path(__file__).parents[2] / "tools"))
from browser import node
from bundle import LIBRARIES, bundle, install
from lock import hold_checkout

KATEX = LIBRARIES / "katex"
LICENCES = LIBRARIES.parent / "LICENSES" / "VIEWER.txt"
FONTS = [LIBRARIES / "@fontsource-variable" / name for name in ("source-serif-4", "source-sans-3")]
# What the pages use of a font: weights by style; pairs, ligatures, accents, figures of one width.
WEIGHTS: dict[str, int | tuple[int, int]] = {"normal": (400, 700), "italic": 400}
FEATURES = ["kern", "liga", "mark", "tnum"]


def serve(app: Sphinx, config: Config) -> None:
    """Put fonts, styles, the viewer and their licences among the static files of the book."""
    try:
        install()
    except RuntimeError as error:
        raise ExtensionError(str(error)) from error
    static = Path(app.outdir).parent / "static"
    shutil.rmtree(static, ignore_errors=True)
    config.html_static_path.append(str(static))
    shutil.copytree(KATEX / "dist" / "fonts", static / "katex" / "fonts")
    shutil.copy(KATEX / "dist" / "katex.min.css", static / "katex")
    (static / "fonts").mkdir()
    for font in FONTS:
        for style, weights in WEIGHTS.items():
            file = font / "files" / f"{font.name}-latin-wght-{style}.woff2"
            slim(file, weights, static / "fonts" / file.name)
    bundle(static)
    files = (LICENCES, *(font / "LICENSE" for font in FONTS))
    # Both fonts have the same licence.
    licences = "\n\n\n".join(dict.fromkeys(file.read_text(encoding="utf-8") for file in files))
    (static / "licences.txt").write_text(licences, encoding="utf-8")


def slim(file: Path, weights: int | tuple[int, int], target: Path) -> None:
    """Write what the pages use of a font, half of it, without the name it had as a whole."""
    font = TTFont(file)
    options = subset.Options(flavor="woff2", hinting=False, layout_features=FEATURES, name_IDs=[])
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=font.getBestCmap())
    subsetter.subset(font)
    instantiateVariableFont(font, {"wght": weights}, inplace=True)
    font.save(target)


def typeset(app: Sphinx, config: Config) -> None:
    """Typeset formulas while building."""
    config.katex_css_path = "katex/katex.min.css"
    config.katex_js_path = str(KATEX / "dist" / "katex.min.js")
    katex.NODEJS_BINARY = str(node())
    katex.STARTUP_TIMEOUT = katex.RENDER_TIMEOUT = 60
    if os.name == "posix":
        katex.KaTeXServer.start_server_process = start_katex
    katex.KATEX_DEFAULT_OPTIONS.update(
        throwOnError=True,
        strict="error",
        # \vector{...} gives its argument the colour VECTOR; in a macro, ## stands for #.
        macros={
            f"\\{name.lower()}": rf"\textcolor{{#{getattr(colors, name)}}}{{#1}}"
            for name in colors.__all__
        },
    )


def start_katex(rundir: Path, timeout: float) -> tuple[subprocess.Popen[bytes], socket.socket]:
    """Start the server that typesets, and connect to it as soon as it listens.

    sphinxcontrib.katex 0.9.11 connects as soon as the socket is there. On a busy machine the server
    does not always listen yet, and the build fails: it did in 83 of 1000 starts.
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


def setup(app: Sphinx) -> dict[str, Any]:
    """Prepare the libraries before Sphinx looks for static files, alone in this checkout."""
    hold_checkout()
    app.connect("config-inited", serve)
    app.connect("config-inited", typeset)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
