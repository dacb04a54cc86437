"""Count how long each page takes to read.

200 words take a minute, a line of shown code 5 seconds, a displayed formula 20, a figure 30. Folded
text counts as if it were open; folded code does not count. Each exercise states its own minutes.
``python tools/reading_time.py`` prints the count of every page, and writes the minutes into the
line **Time** of the pages that have one.
"""

import re
from math import ceil
from pathlib import Path
from typing import Any, NamedTuple

import nbformat

BOOK = Path(__file__).parents[1] / "book"
LOOKED_UP = {"api", "equations", "glossary", "references"}
SECONDS = {"words": 60 / 200, "lines": 5, "formulas": 20, "figures": 30}
LIMIT = 30

FOLDED_CODE = {"hide-input", "hide-cell", "remove-input", "remove-cell"}
FOLDED_OUTPUT = {"remove-output", "remove-cell"}
EXERCISES = re.compile(r"^## Exercises$.*?(?=^## |\Z)", re.MULTILINE | re.DOTALL)
EXERCISE = re.compile(r"^\*\*Exercise [\d.]+\*\* \([^)]*?(\d+) minutes?\)", re.MULTILINE)
TIME = re.compile(r"\*\*Time\*\* .*? for the exercises\.|\*\*Time\*\* \d+ minutes to read\.")
FIGURE = re.compile(r"^\*\*(?:Figure|Picture) [\w-]+\.\*\*", re.MULTILINE)
FORMULA = re.compile(r"\$\$.*?\$\$|:::\{math\}.*?:::", re.DOTALL)
LISTING = re.compile(r"```.*?\n(.*?)```", re.DOTALL)
# Markup that nobody reads: comments, options and fences of directives, targets of links, roles.
MARKS = re.compile(
    r"\A---\n.*?\n---\n|<!--.*?-->|^[:`]{3,}(?:\{[\w-]+\})?|^:[\w-]+:[^\n]*|^\([\w-]+\)=$|\]\([^)]*\)"
    r"|\{[\w:]+\}|<[^>]*>",
    re.MULTILINE | re.DOTALL,
)
INLINE_FORMULA = re.compile(r"\$[^$]+\$")
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


def lines_in(code: str) -> int:
    """Count the lines that are not empty."""
    return sum(bool(line.strip()) for line in code.splitlines())


def shown(cell: Any) -> str:
    """Return the visible part of a cell, as Markdown."""
    if cell.cell_type == "markdown":
        return "" if "remove-cell" in cell.metadata.get("tags", []) else str(cell.source)
    tags = set(cell.metadata.get("tags", []))
    parts = [] if tags & FOLDED_CODE else [f"```python\n{cell.source}\n```"]
    for output in [] if tags & FOLDED_OUTPUT else cell.outputs:
        data = output.get("data", {})
        parts.append(data.get("text/markdown", output.get("text", data.get("text/plain", ""))))
    return "\n\n".join(parts)


def text_of(page: Path) -> str:
    """Return the visible part of a page."""
    if page.suffix == ".md":
        return page.read_text("utf-8")
    return "\n\n".join(map(shown, nbformat.read(page, as_version=4).cells))


def count(page: Path) -> Count:
    """Count what there is to read on a page."""
    text = text_of(page)
    minutes = sum(map(int, EXERCISE.findall("".join(EXERCISES.findall(text)))))
    text = EXERCISES.sub("", text)
    lines = sum(map(lines_in, LISTING.findall(text)))
    figures = len(FIGURE.findall(text))
    text = LISTING.sub("", text)
    formulas = len(FORMULA.findall(text))
    text = INLINE_FORMULA.sub("formula", FORMULA.sub("", text))
    return Count(len(WORD.findall(MARKS.sub(" ", text))), lines, formulas, figures, minutes)


def pages() -> list[Path]:
    """Return the pages that readers read from top to bottom."""
    files = sorted([*BOOK.glob("*.ipynb"), *BOOK.glob("*.md")])
    return [file for file in files if file.stem not in LOOKED_UP]


def main() -> None:
    """Print a line for each page, and update the line **Time** on it."""
    print(f"{'page':24} words  code  formulas  figures  minutes  exercises")
    for page in pages():
        counted = count(page)
        words, lines, formulas, figures, exercises = counted
        print(
            f"{page.stem:24} {words:5} {lines:5} {formulas:9} {figures:8}"
            f" {counted.minutes:8} {exercises:10}"
        )
        text = page.read_text("utf-8")
        page.write_text(TIME.sub(lambda _, time=counted.time: time, text), "utf-8")


if __name__ == "__main__":
    main()
