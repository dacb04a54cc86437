"""What follows from the rest of a page stands in it as the one step writes it."""

import shutil
import tomllib
from pathlib import Path

import nbformat
import pytest
import yaml
from derive import ROOT, derive, derive_citation
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook
from notebook_language import Page, pages

HIDDEN = {"source_hidden": True}


@pytest.mark.parametrize("page", pages().values(), ids=repr)
def test_nothing_is_left_to_write(page: Page, tmp_path: Path) -> None:
    copy = Path(shutil.copy(page.file, tmp_path))
    derive(copy)
    written = copy.read_text("utf-8") == page.file.read_text("utf-8")
    assert written, f"{page.name} is not up to date: run .venv/bin/python tools/derive.py"


def test_the_citation_has_the_addresses_of_the_settings(tmp_path: Path) -> None:
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["rotedu"]
    addresses = settings["book"], settings["repository"]
    file = Path(shutil.copy(ROOT / "CITATION.cff", tmp_path))
    derive_citation(file, *addresses)
    stored = (ROOT / "CITATION.cff").read_text("utf-8")
    assert file.read_text("utf-8") == stored, "call .venv/bin/python tools/derive.py"
    derive_citation(file, "https://book.example", "https://github.example/rotedu")
    derive_citation(file, "https://new.example", "https://github.example/rotedu")
    written = yaml.safe_load(file.read_text("utf-8"))
    assert written["url"] == "https://new.example"
    assert written["repository-code"] == "https://github.example/rotedu"
    derive_citation(file, *addresses)
    assert file.read_text("utf-8") == stored


def test_what_is_written(tmp_path: Path) -> None:
    file = tmp_path / "page.ipynb"
    asked = "**Exercise A.1** (drill, 4 minutes). Why?"
    cells = [
        new_markdown_cell("**Time** 9 minutes to read.\n\n:::{math}\n:label: eq-A-1\n\na = b\n:::"),
        new_code_cell("import this", metadata={"tags": ["hide-input"]}),
        new_markdown_cell(asked, id="exercise-A-1"),
        new_code_cell("answer = ...", id="start-A-1", metadata={"jupyter": HIDDEN}),
        new_code_cell("answer = 42", id="solution-A-1"),
    ]
    nbformat.write(new_notebook(cells=cells), file)
    derive(file)
    colours, text, imports, _, start, solution = Page(file).cells
    assert colours.source.count(r"\def\vector#1{\textcolor{##0072b2}{#1}}") == 1
    assert text.source == (
        "**Time** 1 minutes to read, 4 for the exercises.\n\n"
        ":::{math}\n:label: eq-A-1\n:enumerated: true\n:enumerator: A-1\n\na = b\n:::"
    )
    assert imports.metadata.jupyter == HIDDEN
    assert "jupyter" not in start.metadata
    assert solution.metadata.tags == ["hide-cell"]
    assert solution.metadata.jupyter == HIDDEN | {"outputs_hidden": True}
