"""Pages of the built book, parsed once for all tests."""

import functools
from pathlib import Path

from bs4 import BeautifulSoup


@functools.cache
def parse(page: Path) -> BeautifulSoup:
    """The elements of a page."""
    return BeautifulSoup(page.read_text(encoding="utf-8"), "html.parser")


@functools.cache
def anchors(page: Path) -> set[str]:
    """All targets of links on a page."""
    return {element["id"] for element in parse(page).find_all(id=True)}
