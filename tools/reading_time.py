"""Count how long each page takes to read.

130 words take a minute, a line of code in view 6 seconds, a displayed formula 30, a scene a minute,
and one that answers the hand two and a half. What is folded is not counted: the rest must do
without it.
Each exercise states its own minutes.
``python tools/reading_time.py`` prints the count of every page; ``tools/derive.py`` writes the
minutes into the line **Time** of the pages that have one.
"""

import re
from collections.abc import Iterator
from math import ceil
from typing import NamedTuple

from notebook_language import Block, Page, answers_the_hand, blocks, pages, plain, tags

LOOKED_UP = {"api", "claims", "equations", "glossary", "references"}
SECONDS = {"words": 60 / 130, "lines": 6, "formulas": 30, "scenes": 60, "by_hand": 150}

FOLDED_CODE = {"hide-input", "hide-cell", "remove-input", "remove-cell"}
FOLDED_OUTPUT = {"remove-output", "remove-cell"}
WORD = re.compile(r"[^\s|]*\w[^\s|]*")


class Count(NamedTuple):
    """The amount to read on a page."""

    words: int
    lines: int
    formulas: int
    scenes: int
    by_hand: int
    """Scenes that answer the hand."""
    exercises: int
    """Minutes of the exercises."""

    @property
    def minutes(self) -> int:
        """Minutes to read the page, exercises apart."""
        return ceil(sum(getattr(self, name) * each for name, each in SECONDS.items()) / 60)

    @property
    def time(self) -> str:
        """The line for the top of the page."""
        exercises = f", {self.exercises} for the exercises" if self.exercises else ""
        return f"**Time** {self.minutes} minutes to read{exercises}."


def in_view(text: str) -> Iterator[Block]:
    """Yield the blocks of a text, and after each box those inside it, but of a fold its title."""
    for block in blocks(text):
        yield block
        if block.kind == "admonition" and "dropdown" not in block.options.get("class", ""):
            yield from in_view(block.body)


def shown(page: Page) -> Iterator[Block]:
    """Yield what a reader sees of a page: texts, code and outputs."""
    for cell in page.cells:
        if cell.cell_type == "markdown":
            yield from () if "remove-cell" in tags(cell) else in_view(cell.source)
            continue
        if not tags(cell) & FOLDED_CODE:
            yield Block("fence", cell.source, body=cell.source)
        for output in [] if tags(cell) & FOLDED_OUTPUT else cell.outputs:
            data = output.get("data", {})
            if "text/markdown" in data:
                yield from in_view(data["text/markdown"])
            else:
                printed = output.get("text", data.get("text/plain", ""))
                yield Block("printed", printed)


def count(page: Page) -> Count:
    """Count what there is to read on a page, its section *Exercises* apart."""
    words = lines = formulas = scenes = 0
    exercises = False
    for block in shown(page):
        if block.kind == "heading_open" and block.level == 2:
            exercises = block.title == "Exercises"
        if exercises:
            continue
        if block.kind in ("fence", "code-cell", "literalinclude"):
            lines += sum(bool(line.strip()) for line in block.body.splitlines())
        elif block.kind.startswith("math"):
            formulas += 1
        elif block.kind not in ("front_matter", "html_block", "myst_target"):
            scenes += block.kind == "caption"
            prose = block.title if block.kind in ("admonition", "dropdown") else block.source
            words += len(WORD.findall(prose if block.kind == "printed" else plain(prose)))
    minutes = sum(exercise.minutes for exercise in page.exercises.values())
    by_hand = sum(map(answers_the_hand, page.cells))
    return Count(words, lines, formulas, scenes - by_hand, by_hand, minutes)


def read_through() -> list[Page]:
    """Return the pages that readers read from top to bottom."""
    return [page for page in pages().values() if page.file.stem not in LOOKED_UP]


if __name__ == "__main__":
    print(f"{'page':24}" + "".join(f"{name:>11}" for name in ("minutes", *Count._fields)))
    for page in read_through():
        counted = count(page)
        print(f"{page.file.stem:24}" + "".join(f"{n:11}" for n in (counted.minutes, *counted)))
