"""The text of the pages of the book, for tests that look up labels."""

import functools
import re
from collections.abc import Iterator
from pathlib import Path

import nbformat

BOOK = Path(__file__).parents[1] / "book"


@functools.cache
def pages() -> dict[str, str]:
    """The text of each page; for a notebook, the text of its Markdown cells."""
    texts = {file.name: file.read_text("utf-8") for file in BOOK.glob("*.md")}
    for file in BOOK.glob("*.ipynb"):
        cells = nbformat.read(file, as_version=4).cells
        texts[file.name] = "\n\n".join(c.source for c in cells if c.cell_type == "markdown")
    return texts


def found(pattern: re.Pattern[str]) -> Iterator[tuple[str, ...]]:
    """All matches of a pattern on all pages."""
    for text in pages().values():
        for match in pattern.finditer(text):
            yield tuple(group for group in match.groups() if group is not None)
