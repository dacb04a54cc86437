"""The Python of the pages: what a notebook stores comes out there, too, and answers are judged."""

import inspect
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

import nbformat
import pytest
import test_exercises
import test_right_answers
from bs4 import BeautifulSoup
from html_pages import parse
from nbformat import NotebookNode
from node import run_node
from notebook_language import BOOK, ROOT, Page, notebooks, part_of, tags
from runtime import put_together

SCRIPT = "live/live.js"
ONE_PAGE = """\
format: jb-book
root: book/01-introduction
chapters:
  - file: book/glossary
"""
EXPLORED = re.compile(r"\bexplore\(scenes\.(\w+)")
# Lets the page's Python read the tests of the checks.
STAND_INS = """\
import sys
from unittest.mock import MagicMock

for name in ("pytest", "notebook_language"):
    sys.modules[name] = MagicMock()
sys.modules["pytest"].mark.parametrize = lambda *_, **__: lambda test: test
"""
# What the conventions say of the Python of a page; no word comes of the division.
FACTS = """\
import platform
import numpy as np
print(platform.python_version(), np.__version__, np.arange(1, 14).prod())
with np.errstate(all="raise"):
    np.ones(1) / 0
"""
JUDGE = """\
for number, answer, hint in WRONG:
    test_a_wrong_answer_hears_what_is_wrong(number, answer, hint)
for number, answer in RIGHT:
    test_a_right_answer_passes_in_every_form(number, answer)
for number in EXERCISES:
    TestCheck().test_each_mistake_and_all_else_get_their_own_hints(number)
    TestCheck().test_says_what_it_expects(number)
"""


class Ran(NamedTuple):
    """A cell, and what came of it in the page's Python."""

    cell: NotebookNode
    done: dict[str, Any]

    @property
    def stored(self) -> tuple[str, str]:
        """What the notebook stores: what is printed, and the value of the last line."""
        out = "".join(o.text for o in self.cell.outputs if o.output_type == "stream")
        data = next((o.data for o in self.cell.outputs if o.output_type == "execute_result"), {})
        return out, data.get("text/markdown", data.get("text/plain", ""))


def in_order(page: Page) -> list[NotebookNode]:
    """Return the cells of a page: text, exercises, and at the end what needs a desk.

    When it runs the cells above one, a page leaves out exercises, cells to try and what needs a
    desk.
    """

    def later(cell: NotebookNode) -> int:
        return 2 if "desk" in tags(cell) else bool(part_of(cell.id)[0] or "try" in tags(cell))

    return sorted(page.code, key=later)


def figures(page: Page) -> list[str]:
    """Return the names of the figures of a page that answer the hand."""
    shown = [name for cell in page.code for name in EXPLORED.findall(cell.source)]
    return [name.replace("_", "-") for name in shown]


def in_page(pages: list[dict[str, Any]], folder: Path) -> list[list[dict[str, Any]]]:
    """Run lists of cells in the page's Python, each list in a namespace of its own."""
    cases, answers = folder / "cases.json", folder / "answers.json"
    cases.write_text(json.dumps(pages), encoding="utf-8")
    run_node("tools/page_python.mjs", str(put_together()), str(answers), str(cases))
    results: list[list[dict[str, Any]]] = json.loads(answers.read_text("utf-8"))
    return results


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> list[list[dict[str, Any]]]:
    cases = [
        {"figures": figures(page), "cells": [cell.source for cell in in_order(page)]}
        for page in notebooks()
    ]
    facts = {"figures": [], "cells": [FACTS]}
    return in_page([*cases, facts], tmp_path_factory.mktemp("live"))


@pytest.fixture(scope="module")
def ran(results: list[list[dict[str, Any]]]) -> dict[str, list[Ran]]:
    return {
        page.name: list(map(Ran, in_order(page), done))
        for page, done in zip(notebooks(), results, strict=False)
    }


def test_the_conventions_say_what_runs(results: list[list[dict[str, Any]]]) -> None:
    [facts] = results[-1]
    assert facts["error"] == ""
    said = (BOOK / "conventions.md").read_text("utf-8").replace(" ", "")
    for fact in facts["out"].split():
        assert fact in said


@pytest.mark.parametrize("page", notebooks(), ids=repr)
def test_a_cell_without_the_tag_runs(page: Page, ran: dict[str, list[Ran]]) -> None:
    found = {r.cell.id: r.done["error"] for r in ran[page.name] if "desk" not in tags(r.cell)}
    assert not {name: error for name, error in found.items() if error}


@pytest.mark.parametrize("page", notebooks(), ids=repr)
def test_a_cell_prints_what_the_notebook_stores(page: Page, ran: dict[str, list[Ran]]) -> None:
    for run in ran[page.name]:
        if not {"desk", "nbval-ignore-output"} & tags(run.cell):
            assert (run.done["out"], run.done["value"]) == run.stored, run.cell.id


@pytest.mark.parametrize("page", notebooks(), ids=repr)
def test_a_cell_with_the_tag_needs_a_desk(page: Page, ran: dict[str, list[Ran]]) -> None:
    kinds = {r.cell.id: r.done["kind"] for r in ran[page.name] if "desk" in tags(r.cell)}
    assert set(kinds.values()) <= {"NotInPage"}, kinds


def test_every_answer_of_the_tests_gets_its_verdict_in_a_page(tmp_path: Path) -> None:
    tests = [inspect.getsource(module) for module in (test_exercises, test_right_answers)]
    [done] = in_page([{"figures": [], "cells": [STAND_INS, *tests, JUDGE]}], tmp_path)
    assert [result["error"] for result in done] == [""] * 4


@pytest.fixture(scope="module")
def pages(book: Path) -> dict[str, BeautifulSoup]:
    return {page.name: parse(page) for page in (book / "book").glob("*.html")}


def test_pages_mark_the_cells_that_run_and_the_exercises(pages: dict[str, BeautifulSoup]) -> None:
    for page in notebooks():
        soup = pages[f"{page.file.stem}.html"]
        unseen = {"desk", "remove-cell"}
        run = [cell.id for cell in page.code if not unseen & tags(cell)]
        assert [cell["data-cell"] for cell in soup.select(".cell[data-cell]")] == run
        asked = soup.select(".exercise[data-exercise]")
        assert [each["data-exercise"] for each in asked] == list(page.exercises)
        for each, exercise in zip(asked, page.exercises.values(), strict=True):
            cells = [cell["data-cell"] for cell in each.select("[data-cell]")]
            assert cells[0] == exercise.start.id
            assert each.p.get_text().startswith(f"Exercise {exercise.number} ")
            assert bool(each.select("details.sd-dropdown")) == bool(exercise.why)
        assert len(soup.select(f"script[src*='{SCRIPT}']")) == 1


def test_a_page_without_cells_loads_no_script(pages: dict[str, BeautifulSoup]) -> None:
    assert not pages["glossary.html"].select(f"script[src*='{SCRIPT}']")


def test_the_site_has_notebooks_to_hand_in(book: Path) -> None:
    for page in notebooks():
        student = nbformat.read(book / "_static" / "live" / "notebooks" / page.name, as_version=4)
        parts = {part_of(cell.id)[0] for cell in student.cells}
        assert not {"solution", "why"} & parts
        assert bool(page.exercises) == ("start" in parts)


@pytest.mark.slow
def test_one_setting_leaves_python_out(tmp_path: Path) -> None:
    config = (ROOT / "_config.yml").read_text("utf-8")
    without = config.replace("python_in_page: true", "python_in_page: false")
    assert without != config
    (tmp_path / "config.yml").write_text(without, encoding="utf-8")
    (tmp_path / "toc.yml").write_text(ONE_PAGE, encoding="utf-8")
    command = [Path(sys.executable).with_name("jupyter-book"), "build", ROOT]
    options = ["--config", tmp_path / "config.yml", "--toc", tmp_path / "toc.yml"]
    subprocess.run(
        [*command, *options, "--path-output", tmp_path],
        env=os.environ | {"PYTHONPATH": str(ROOT / "book" / "_ext")},
        check=True,
    )
    html = tmp_path / "_build" / "html"
    page = (html / "book" / "01-introduction.html").read_text("utf-8")
    assert "Show the solution" in page
    assert not any(mark in page for mark in ("data-cell", "data-exercise", SCRIPT))
    assert not (html / "_static" / "live").exists()
    assert "Mozilla Public" not in (html / "_static" / "licences.txt").read_text("utf-8")
