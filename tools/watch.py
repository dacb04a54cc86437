"""Serve the book, and keep it up with what is edited: ``make watch``, with a PORT if you like.

A changed page or module builds the book again, as `make book` does, and a changed style or script
only goes where pages load it from. Browsers then reload. The pages around keep what they say of
styles, scripts and glossary; the next `make book` writes them again.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from bundle import ROOT, bundle
from livereload import Server
from runtime import bundle as bundle_cells
from runtime import put_together

BOOK = ROOT / "book"
HTML = ROOT / "_build" / "html"
STATIC = HTML / "_static"


def build() -> None:
    """Build what has changed; whatever is wrong stands in the terminal."""
    jupyter_book = Path(sys.executable).with_name("jupyter-book")
    command = [str(jupyter_book), "build", ".", "-W", "--keep-going"]
    # For book/_ext/cache_keys.py.
    subprocess.run(command, cwd=ROOT, env=os.environ | {"ROTEDU_WATCHED": "yes"}, check=False)


def copy_styles() -> None:
    """Copy the styles and scripts of all pages."""
    shutil.copytree(BOOK / "_static", STATIC, dirs_exist_ok=True)


def bundle_viewer() -> None:
    """Bundle what draws figures, with the models of the scenes."""
    bundle(STATIC)


def build_with_viewer() -> None:
    """Draw posters anew from changed models, and let pages have these."""
    bundle_viewer()
    build()


def bundle_page_python() -> None:
    """Bundle what runs cells in a page."""
    shutil.copytree(put_together(), STATIC / "page_python", dirs_exist_ok=True)
    bundle_cells(STATIC / "page_python")


def no_source(file: str) -> bool:
    """Tell whether a change of a file changes no page by itself."""
    path = Path(file).relative_to(ROOT)
    return path.suffix == ".js" or bool({"_static", "static", ".ipynb_checkpoints"} & {*path.parts})


if __name__ == "__main__":
    build()
    server = Server()
    for source in (BOOK, ROOT / "rotedu", ROOT / "_config.yml", ROOT / "_toc.yml"):
        server.watch(str(source), build, ignore=no_source)
    server.watch(str(BOOK / "_static"), copy_styles)
    server.watch(str(ROOT / "viewer"), bundle_viewer)
    server.watch(str(ROOT / "rotedu" / "scenes" / "*.js"), build_with_viewer)
    server.watch(str(ROOT / "page_python"), bundle_page_python)
    server.serve(*map(int, sys.argv[1:]), root=str(HTML))
