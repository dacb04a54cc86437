"""One module says what pages say."""

from collections import Counter
from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook
from notebook_language import Page, blocks, pages, part_of, unfolded

QUESTION = """\
::::{admonition} Before you read on
:class: question

Which way?

:::{dropdown} Left
No.
:::
::::
"""


def page(folder: Path, *exercise: tuple[str, str]) -> Page:
    kinds = {"exercise": new_markdown_cell, "why": new_markdown_cell}
    cells = [kinds.get(part_of(id)[0], new_code_cell)(source, id=id) for id, source in exercise]
    nbformat.write(new_notebook(cells=cells), folder / "page.ipynb")
    return Page(folder / "page.ipynb")


ASKED = "(exercise-A-1)=\n\n**Exercise A.1** (a small project, 25 minutes). Why?"
PARTS = (("start-A-1", "answer = ..."), ("solution-A-1", "answer = 1"), ("why-A-1", "Because."))


def test_an_exercise(tmp_path: Path) -> None:
    [asked] = page(tmp_path, ("exercise-A-1", ASKED), *PARTS).exercises.values()
    assert (asked.number, asked.kind, asked.minutes) == ("A.1", "a small project", 25)
    assert (asked.text.source, asked.why.source) == (ASKED, "Because.")
    assert (asked.start.source, asked.solution.source) == ("answer = ...", "answer = 1")
    assert page(tmp_path, ("exercise-A-1", ASKED), *PARTS[:2]).exercises["A.1"].why is None


def test_an_exercise_that_is_not_complete_is_refused(tmp_path: Path) -> None:
    with pytest.raises(
        ValueError, match=r"page.ipynb, Exercise A.1: expected .*, got exercise, so"
    ):
        _ = page(tmp_path, ("exercise-A-1", ASKED), PARTS[1]).exercises
    with pytest.raises(ValueError, match=r"exercise-A-2: expected \*\*Exercise A.2\*\* \("):
        _ = page(
            tmp_path, ("exercise-A-2", ASKED), ("start-A-2", ""), ("solution-A-2", "")
        ).exercises


def test_blocks() -> None:
    text = "## A title\n\n**Picture A-a.** What $x$ is.\n\n:::{math}\n:label: eq-A-1\n\nx\n:::\n"
    heading, caption, equation, box = blocks(text + QUESTION)
    assert (heading.kind, heading.title, heading.level) == ("heading_open", "A title", 2)
    assert (caption.kind, caption.title, caption.anchor) == (
        "caption",
        "Picture A-a",
        "picture-a-a",
    )
    assert (equation.kind, equation.anchor, equation.body) == ("math", "eq-A-1", "x")
    assert (box.kind, box.title, box.options) == (
        "admonition",
        "Before you read on",
        {"class": "question"},
    )
    assert [(choice.title, choice.body) for choice in box.choices] == [("Left", "No.")]
    assert [block.source for block in unfolded(box.body)][-1] == "No."


@pytest.mark.parametrize("text", ["**Picture 3**", "**Picture 3-a**. No.", "A **Figure 1.**"])
def test_what_is_no_caption(text: str) -> None:
    assert [block.kind for block in blocks(text)] == ["paragraph_open"]


def test_every_name_is_given_once() -> None:
    names = [block.anchor for page in pages().values() for block in page.blocks if block.anchor]
    assert [name for name, uses in Counter(names).items() if uses > 1] == []
