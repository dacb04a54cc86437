"""One module says what pages say."""

from collections import Counter
from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook
from notebook_language import Page, blocks, pages

ASKED = "**Exercise A.1** (a small project, 25 minutes). Why?"


@pytest.mark.parametrize(
    ("number", "parts", "message"),
    [
        ("A-1", ["solution"], r"page.ipynb, Exercise A.1: expected .*, got exercise, so"),
        ("A-2", ["start", "solution"], r"exercise-A-2: expected \*\*Exercise A.2\*\* \("),
    ],
)
def test_an_exercise_that_is_not_complete_is_refused(
    tmp_path: Path, number: str, parts: list[str], message: str
) -> None:
    cells = [new_markdown_cell(ASKED, id=f"exercise-{number}")]
    cells += [new_code_cell(id=f"{part}-{number}") for part in parts]
    nbformat.write(new_notebook(cells=cells), tmp_path / "page.ipynb")
    with pytest.raises(ValueError, match=message):
        _ = Page(tmp_path / "page.ipynb").exercises


@pytest.mark.parametrize("text", ["**Picture 3. No.**", "**Picture 3-a**. No.", "A **Figure 1.**"])
def test_what_is_no_caption(text: str) -> None:
    assert [block.kind for block in blocks(text)] == ["paragraph_open"]


def test_every_name_is_given_once() -> None:
    names = [block.anchor for page in pages().values() for block in page.blocks if block.anchor]
    assert [name for name, uses in Counter(names).items() if uses > 1] == []
