"""Count how long each page takes to read, and what the rules of its telling count.

130 words take a minute, a line of code in view 6 seconds, a displayed formula 30, a scene a minute,
one that answers the hand two and a half, and a small one half a minute. What is folded takes no
time: the rest must do without it. Each exercise states its own minutes.
``python tools/reading_time.py`` prints the count of every page; ``tools/derive.py`` writes the
minutes into the line **Time** of the pages that have one.
"""

import re
from collections.abc import Iterator
from itertools import pairwise
from math import ceil
from typing import NamedTuple

from notebook_language import (
    Block,
    Page,
    answers_the_hand,
    blocks,
    pages,
    part_of,
    plain,
    tags,
    unfolded,
)

LOOKED_UP = {"api", "claims", "equations", "glossary", "references"}
SECONDS = {"words": 60 / 130, "lines": 6, "formulas": 30, "scenes": 60, "by_hand": 150, "small": 30}

FOLDED_CODE = {"hide-input", "hide-cell", "remove-input", "remove-cell"}
FOLDED_OUTPUT = {"hide-output", "hide-cell", "remove-output", "remove-cell", "claims"}
WORD = re.compile(r"[^\s|]*\w[^\s|]*")


class Count(NamedTuple):
    """The amount to read on a page."""

    words: int
    lines: int
    formulas: int
    scenes: int
    by_hand: int
    """Large scenes that answer the hand."""
    small: int
    """Small scenes that answer the hand, which have no number."""
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


def is_fold(block: Block) -> bool:
    """Tell whether a page shows of a box its title alone: a fold, or a misprint in the margin."""
    classes = block.options.get("class", "").split()
    return block.kind == "dropdown" or bool({"dropdown", "erratum"} & set(classes))


def in_view(text: str) -> Iterator[Block]:
    """Yield the blocks of a text, and after each box those inside it, but of a fold its title."""
    for block in blocks(text):
        yield block
        if block.kind in ("admonition", "div") and not is_fold(block):
            yield from in_view(block.body)


def words_in(block: Block) -> int:
    """Count the words of a block, of a box those of its title."""
    if block.kind in ("front_matter", "html_block", "myst_target", "container", "div"):
        return 0
    boxed = block.kind in ("admonition", "dropdown")
    text = block.title if boxed else block.source
    return len(WORD.findall(text if block.kind == "printed" else plain(text)))


def folded_words(page: Page) -> int:
    """Count the words of a page that are folded, its exercises apart."""
    texts = [cell.source for cell in page.text_cells if not part_of(cell.id)[0]]
    folds = (block for text in texts for block in in_view(text) if is_fold(block))
    in_texts = sum(words_in(block) for fold in folds for block in unfolded(fold.body))
    outputs = (output for cell in page.cells if "claims" in tags(cell) for output in cell.outputs)
    tables = (output["data"]["text/markdown"] for output in outputs)
    return in_texts + sum(words_in(block) for table in tables for block in in_view(table))


def shown(page: Page) -> Iterator[Block]:
    """Yield what a reader sees of a page, its exercises apart: texts, code and outputs."""
    for cell in page.cells:
        if part_of(cell.id)[0]:
            continue
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
    """Count what there is to read on a page, its exercises apart."""
    words = lines = formulas = scenes = 0
    for block in shown(page):
        if block.kind in ("fence", "code-cell", "literalinclude"):
            lines += sum(bool(line.strip()) for line in block.body.splitlines())
        elif block.kind.startswith("math"):
            formulas += 1
        else:
            scenes += block.kind == "caption"
            words += words_in(block)
    shows = [
        next(blocks(after.source)).kind == "caption"
        for cell, after in pairwise(page.cells)
        if answers_the_hand(cell)
    ]
    minutes = sum(exercise.minutes for exercise in page.exercises.values())
    large = sum(shows)
    return Count(words, lines, formulas, scenes - large, large, len(shows) - large, minutes)


def told(page: Page) -> dict[str, int]:
    """Count what the rules of telling count: words by place, *way*, and checks in view."""
    seen = list(shown(page))
    places = [i for i, block in enumerate(seen) if block.kind == "heading_open"]
    opening = [b for b in seen if b.kind == "div" and b.title == "opening"]
    printed = [block.source for block in seen if block.kind == "printed"]
    prose = " ".join(plain(block.source) for block in seen if block.kind != "printed")
    counted = count(page)
    figures = counted.scenes + counted.by_hand + counted.small
    return {
        "folded": folded_words(page),
        "opening": sum(words_in(b) for box in opening for b in unfolded(box.body)),
        "to heading": sum(map(words_in, seen[: places[1]])) if places[1:] else 0,
        "way": len(re.findall(r"\bways?\b", prose)),
        "agree": " ".join(printed).count("numbers agree"),
        "a figure": counted.words // figures if figures else 0,
    }


if __name__ == "__main__":
    table = {}
    for page in pages().values():
        if page.file.stem not in LOOKED_UP:
            counted = count(page)
            row = {"minutes": counted.minutes} | counted._asdict() | told(page)
            table[page.file.stem] = row
    print(f"{'page':22}" + "".join(f"{name:>11}" for name in row))
    for name, row in table.items():
        print(f"{name:22}" + "".join(f"{number:11}" for number in row.values()))
