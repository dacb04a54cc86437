"""Pages of the built book, parsed once for all tests."""

import functools
import os
import subprocess
import sys
from pathlib import Path

from bs4 import BeautifulSoup

ROOT = Path(__file__).parents[1]
ONE_PAGE = """\
format: jb-book
root: book/01-introduction
chapters:
  - file: book/glossary
"""


@functools.cache
def parse(page: Path) -> BeautifulSoup:
    """The elements of a page."""
    return BeautifulSoup(page.read_text(encoding="utf-8"), "html.parser")


@functools.cache
def anchors(page: Path) -> set[str]:
    """All targets of links on a page."""
    return {element["id"] for element in parse(page).find_all(id=True)}


def build_one_page(folder: Path, setting: str, changed: str) -> Path:
    """Build a page and the glossary into a folder, with another setting; return where they are."""
    config = (ROOT / "_config.yml").read_text("utf-8")
    assert config.count(setting) == 1
    (folder / "config.yml").write_text(config.replace(setting, changed), encoding="utf-8")
    (folder / "toc.yml").write_text(ONE_PAGE, encoding="utf-8")
    command = [Path(sys.executable).with_name("jupyter-book"), "build", ROOT]
    options = ["--config", folder / "config.yml", "--toc", folder / "toc.yml"]
    subprocess.run(
        [*command, *options, "--path-output", folder],
        env=os.environ | {"PYTHONPATH": str(ROOT / "book" / "_ext")},
        check=True,
    )
    return folder / "_build" / "html"
