"""Count how long each page takes to read.

200 words take a minute, a line of shown code 5 seconds, a displayed formula 20, a figure 30. Folded
text counts as if it were open; folded code does not count. Each exercise states its own minutes.
``python tools/reading_time.py`` prints the count of every page; ``tools/derive.py`` writes the
minutes into the line **Time** of the pages that have one.
"""

import re
from collections.abc import Iterator
from math import ceil
from typing import NamedTuple

from notebook_language import Block, Page, pages, plain, tags, unfolded

LOOKED_UP = {"api", "equations", "glossary", "references"}
SECONDS = {"words": 60 / 200, "lines": 5, "formulas": 20, "figures": 30}
LIMIT = 30

FOLDED_CODE = {"hide-input", "hide-cell", "remove-input", "remove-cell"}
FOLDED_OUTPUT = {"remove-output", "remove-cell"}
WORD = re.compile(r"[^\s|]*\w[^\s|]*")


class Count(NamedTuple):
    """The amount to read on a page."""

    words: int
    lines: int
    formulas: int
    figures: int
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


def shown(page: Page) -> Iterator[Block]:
    """Yield what a reader sees of a page: texts, code and outputs."""
    for cell in page.cells:
        if cell.cell_type == "markdown":
            yield from () if "remove-cell" in tags(cell) else unfolded(cell.source)
            continue
        if not tags(cell) & FOLDED_CODE:
            yield Block("fence", cell.source, body=cell.source)
        for output in [] if tags(cell) & FOLDED_OUTPUT else cell.outputs:
            data = output.get("data", {})
            if "text/markdown" in data:
                yield from unfolded(data["text/markdown"])
            else:
                printed = output.get("text", data.get("text/plain", ""))
                yield Block("printed", printed)


def count(page: Page) -> Count:
    """Count what there is to read on a page, its section *Exercises* apart."""
    words = lines = formulas = figures = 0
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
            figures += block.kind == "caption"
            prose = block.title if block.kind in ("admonition", "dropdown") else block.source
            words += len(WORD.findall(prose if block.kind == "printed" else plain(prose)))
    minutes = sum(exercise.minutes for exercise in page.exercises.values())
    return Count(words, lines, formulas, figures, minutes)


def read_through() -> list[Page]:
    """Return the pages that readers read from top to bottom."""
    return [page for page in pages().values() if page.file.stem not in LOOKED_UP]


if __name__ == "__main__":
    print(f"{'page':24} words  code  formulas  figures  minutes  exercises")
    for page in read_through():
        counted = count(page)
        words, lines, formulas, figures, exercises = counted
        print(
            f"{page.file.stem:24} {words:5} {lines:5} {formulas:9} {figures:8}"
            f" {counted.minutes:8} {exercises:10}"
        )
