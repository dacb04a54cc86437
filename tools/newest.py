"""Build the book with the newest Sphinx and MyST-NB, and compare it with the book that is there.

``make newest`` calls this. Jupyter Book 1 holds Sphinx at version 7, so here it only translates
_config.yml. The newest packages, in an environment of their own, run the notebooks and build the
pages, and a warning is an error. A page must hold as many figures, formulas and links as in
_build/html.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

from bs4 import BeautifulSoup
from jupyter_book.config import get_final_config
from set_up import NEWEST
from uv import find_uv_bin

ROOT = Path(__file__).parents[1]
BOOK = ROOT / "_build" / "html"
FOLDER = ROOT / "_build" / "newest"
NEWEST_BOOK = FOLDER / "html"
PYTHON = FOLDER / "environment" / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
COUNTED = {
    "figures": "figure, .scene, article img",
    "formulas": ".katex",
    "links": "a[href]",
}
WITHOUT_JUPYTER_BOOK = "jupyter-book; python_version < '3'"

# For the Python of the new environment.
BUILD = """
import json, sys
from importlib.metadata import version
from sphinx.application import Sphinx

print(*(f"{name} {version(name)}" for name in ("Sphinx", "MyST-NB", "MyST-Parser")), sep=", ")
source, extensions, out, doctrees = sys.argv[1:]
sys.path.append(extensions)
settings = json.load(sys.stdin)
book = Sphinx(source, None, out, doctrees, "html", settings, warningiserror=True)
book.build()
sys.exit(book.statuscode)
"""


def settings() -> dict[str, object]:
    """Return what Sphinx must know, from _config.yml, without the extension of Jupyter Book."""
    config, _ = get_final_config(
        user_yaml=ROOT / "_config.yml",
        sourcedir=ROOT,
        cli_config={"latex_individualpages": False},
    )
    config["extensions"].remove("jupyter_book")
    del config["use_jupyterbook_latex"]
    return config


def install(extensions: list[str]) -> None:
    """Make an environment for the book; packages have the names of the extensions in them."""
    python = "{}.{}".format(*NEWEST)
    uv = [find_uv_bin(), "--quiet"]
    subprocess.run([*uv, "venv", "--clear", "-p", python, FOLDER / "environment"], check=True)
    packages = [
        name for name in extensions if name.startswith(("myst_", "sphinx_", "sphinxcontrib."))
    ]
    command = [*uv, "pip", "install", "-p", PYTHON, "--override", "-", "-e", ".[book]", *packages]
    subprocess.run(command, cwd=ROOT, input=WITHOUT_JUPYTER_BOOK, text=True, check=True)


def build(config: dict[str, object]) -> None:
    """Build the pages in the new environment; a warning is an error."""
    folders = [ROOT, ROOT / "book" / "_ext", NEWEST_BOOK, FOLDER / "doctrees"]
    command = [PYTHON, "-c", BUILD, *folders]
    built = subprocess.run(command, cwd=ROOT, input=json.dumps(config), text=True, check=False)
    if built.returncode:
        sys.exit("The newest Sphinx does not build the book without a warning or an error.")


def counts(folder: Path) -> dict[str, str]:
    """Say what each page of a book holds."""
    pages = {}
    for file in sorted(folder.rglob("*.html")):
        page = BeautifulSoup(file.read_bytes(), "html.parser")
        held = (f"{len(page.select(selector))} {name}" for name, selector in COUNTED.items())
        pages[file.relative_to(folder).as_posix()] = ", ".join(held)
    return pages


if __name__ == "__main__":
    config = settings()
    install(config["extensions"])
    build(config)
    wanted, found = counts(BOOK), counts(NEWEST_BOOK)
    for page in sorted(wanted | found):
        expected, held = (book.get(page, "no such page") for book in (wanted, found))
        print(f"{page}: {held}" + (f" INSTEAD OF {expected}" if held != expected else ""))
    sys.exit(wanted != found)
