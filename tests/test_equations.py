"""The tables of equations and figures: nothing is missing, and every row has a target."""

import ast
import functools
import importlib
import inspect
import os
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import pyvista
from notebook_language import Block, pages

from rotedu.edition.equations import (
    EQUATIONS,
    FIGURES,
    Equation,
    Figure,
    equation_table,
    figure_table,
)
from rotedu.edition.errata import ERRATA, errata_table

NUMBERED = {2: 6, 3: 3, 4: 7, 5: 15}
LINK = re.compile(r"\]\(#([\w-]+)\)")


def found(kind: str) -> Iterator[Block]:
    """All blocks of a kind on all pages."""
    for page in pages().values():
        yield from page.all(kind)


def marked() -> Iterator[tuple[str, str]]:
    """Number and name of each test that has the mark of an equation."""
    for file in Path(__file__).parent.glob("test_*.py"):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            for mark in getattr(node, "decorator_list", []):
                if isinstance(mark, ast.Call) and ast.unparse(mark.func) == "pytest.mark.equation":
                    for number in mark.args:
                        yield ast.literal_eval(number), node.name


def function(name: str) -> Callable[..., Any]:
    """Import the object with a dotted name inside the package."""
    module, *path = name.split(".")
    result: Any = functools.reduce(getattr, path, importlib.import_module(f"rotedu.{module}"))
    assert callable(result)
    return result


class TestEquations:
    def test_all_31_are_there_in_order(self) -> None:
        expected = [f"{section}-{k}" for section, n in NUMBERED.items() for k in range(1, n + 1)]
        assert len(expected) == 31
        assert [row.number for row in EQUATIONS] == expected

    @pytest.mark.parametrize("row", EQUATIONS, ids=lambda row: row.number)
    def test_the_functions_can_be_imported_and_say_what_they_do(self, row: Equation) -> None:
        assert row.functions
        for name in row.functions:
            assert inspect.getdoc(function(name))
            module, public, *_ = name.split(".")
            assert public in importlib.import_module(f"rotedu.{module}").__all__

    def test_each_has_a_test_that_bears_its_number(self) -> None:
        assert {number for number, _ in marked()} == {row.number for row in EQUATIONS}
        assert all(name.startswith("test_") for _, name in marked())

    def test_each_label_is_on_one_page(self) -> None:
        labels = Counter(equation.options["label"] for equation in found("math"))
        assert labels == Counter(row.label for row in EQUATIONS)

    @pytest.mark.parametrize("row", EQUATIONS, ids=lambda row: row.number)
    def test_what_is_not_as_printed_says_why(self, row: Equation) -> None:
        assert row.remark or row.status == "as printed"
        if row.status == "corrected":
            assert re.search(r"\bE\d|\(#likely-glitches\)", row.remark)


class TestFigures:
    def test_all_8_are_there_in_order(self) -> None:
        assert [row.number for row in FIGURES] == list(range(1, 9))

    @pytest.mark.parametrize("row", FIGURES, ids=lambda row: row.label)
    def test_the_scene_is_there_and_needs_no_arguments(self, row: Figure) -> None:
        signature = inspect.signature(function(row.function))
        assert signature.parameters
        signature.bind()
        assert signature.return_annotation is pyvista.Plotter

    def test_each_caption_is_on_one_page(self) -> None:
        titles = [caption.title for caption in found("caption")]
        figures = Counter(title for title in titles if title.startswith("Figure"))
        assert figures == Counter(f"Figure {row.number}" for row in FIGURES)


class TestTables:
    tables = (*map(equation_table, NUMBERED), figure_table(), errata_table())

    def test_every_row_is_in_a_table(self) -> None:
        links = Counter(
            LINK.findall(line.split("|")[1])[0]
            for table in self.tables
            for line in repr(table).splitlines()[2:]
        )
        assert links == Counter(row.label for row in (*EQUATIONS, *FIGURES, *ERRATA))

    def test_links_lead_to_what_there_is(self) -> None:
        labels = {row.label for row in (*EQUATIONS, *FIGURES, *ERRATA)} | {"likely-glitches"}
        for table in self.tables:
            assert set(LINK.findall(repr(table))) <= labels
        assert "(likely-glitches)=" in pages()["errata.ipynb"].text

    def test_cells_have_no_bars(self) -> None:
        for table in self.tables:
            header, *lines = repr(table).splitlines()
            assert {line.count("|") for line in lines} == {header.count("|")}

    def test_pages_show_them(self) -> None:
        tables = [f"equation_table({section})" for section in NUMBERED]
        assert all(table in pages()["equations.md"].text for table in [*tables, "figure_table()"])


def test_the_search_keeps_the_numbers_of_pages_that_stay(tmp_path: Path) -> None:
    source, built = tmp_path / "source", tmp_path / "built"
    source.mkdir()
    for name, number in (("index", "1-1"), ("other", "1-2")):
        equation = f".. math:: a\n   :label: eq-{number}\n"
        (source / f"{name}.rst").write_text(
            f"{name}\n=====\n\n{equation}\n.. toctree::\n   :glob:\n\n   o*\n"
        )
    command = [sys.executable, "-m", "sphinx", "-q", "-C", "-D", "extensions=paper_numbers"]
    path = Path(__file__).parents[1] / "book" / "_ext"
    for changed in ("", "A word more.\n"):
        with (source / "index.rst").open("a") as page:
            page.write(f"\n{changed}")
        environment = os.environ | {"PYTHONPATH": str(path)}
        subprocess.run([*command, source, built], env=environment, check=True)
        index = (built / "searchindex.js").read_text("utf-8")
        entries = re.search(r'"indexentries": ?\{(.*?)\}', index)[1]
        assert re.findall(r'"(\d-\d)":', entries) == ["1-1", "1-2"]
