"""The tables of equations, figures and errata: nothing is missing, every row points somewhere."""

import ast
import functools
import importlib
import inspect
import re
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import nbformat
import pytest

from rotedu import scenes
from rotedu.edition import paper
from rotedu.edition.paper import EQUATIONS, ERRATA, FIGURES, Equation, Erratum, Figure

ROOT = Path(__file__).parents[1]
NUMBERED = {2: 6, 3: 3, 4: 7, 5: 15}
EQUATION_LABEL = re.compile(r"^\$\$ \((eq-[^)]*)\)$|^:label: (eq-.*)$", re.MULTILINE)
CAPTION = re.compile(r"^\*\*Figure (\d+)\.\*\*", re.MULTILINE)
ERRATUM_HEADING = re.compile(r"^\((erratum-\w+)\)=\n+## (\w+)\. (.+)$", re.MULTILINE)
LINK = re.compile(r"\]\(#([\w-]+)\)")


@functools.cache
def pages() -> dict[str, str]:
    """What is written on each page; of a notebook, its text cells."""
    texts = {file.name: file.read_text("utf-8") for file in (ROOT / "book").glob("*.md")}
    for file in (ROOT / "book").glob("*.ipynb"):
        cells = nbformat.read(file, as_version=4).cells
        texts[file.name] = "\n\n".join(c.source for c in cells if c.cell_type == "markdown")
    return texts


def found(pattern: re.Pattern[str]) -> Iterator[tuple[str, ...]]:
    """What a pattern finds on all pages."""
    for text in pages().values():
        for match in pattern.finditer(text):
            yield tuple(group for group in match.groups() if group is not None)


@functools.cache
def defined_in(file: str) -> set[str]:
    """Tests of a file, named as pytest does."""
    names = set()
    for node in ast.parse((ROOT / file).read_text("utf-8")).body:
        if isinstance(node, ast.ClassDef):
            names |= {f"{node.name}::{f.name}" for f in node.body if isinstance(f, ast.FunctionDef)}
        elif isinstance(node, ast.FunctionDef):
            names.add(node.name)
    return {name for name in names if name.rpartition("::")[2].startswith("test")}


def function(name: str) -> Callable[..., Any]:
    """Import what a dotted name inside the package stands for."""
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
            assert (
                name.split(".")[1]
                in importlib.import_module(f"rotedu.{name.split('.')[0]}").__all__
            )

    @pytest.mark.parametrize("row", EQUATIONS, ids=lambda row: row.number)
    def test_the_test_is_there_and_is_one_of_that_module(self, row: Equation) -> None:
        file, _, name = row.test.partition("::")
        assert name in defined_in(file)
        assert file == f"tests/test_{row.functions[0].split('.')[0]}.py"

    def test_each_label_is_on_one_page(self) -> None:
        labels = Counter(label for (label,) in found(EQUATION_LABEL))
        assert labels == Counter(row.label for row in EQUATIONS)

    @pytest.mark.parametrize("row", EQUATIONS, ids=lambda row: row.number)
    def test_what_is_not_as_printed_says_why(self, row: Equation) -> None:
        assert row.status in ("as printed", "convention", "corrected")
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
        assert signature.return_annotation is scenes.pyvista.Plotter

    def test_each_caption_is_on_one_page(self) -> None:
        numbers = Counter(int(number) for (number,) in found(CAPTION))
        # Figure 0 is on the cover; the paper has none.
        del numbers[0]
        assert numbers == Counter(row.number for row in FIGURES)


class TestErrata:
    def test_each_has_its_section_in_order(self) -> None:
        headings = list(ERRATUM_HEADING.findall(pages()["errata.ipynb"]))
        assert headings == [(row.label, row.number, row.title) for row in ERRATA]

    @pytest.mark.parametrize("row", ERRATA, ids=lambda row: row.number)
    def test_says_what_is_printed_what_is_right_and_what_it_changes(self, row: Erratum) -> None:
        _, _, rest = pages()["errata.ipynb"].partition(f"({row.label})=")
        section, _, _ = rest.partition("\n(")
        for part in ("**As printed.**", "**What it should be.**", "**What it changes.**"):
            assert section.count(part) == 1

    def test_each_computes_something(self) -> None:
        cells = nbformat.read(ROOT / "book" / "errata.ipynb", as_version=4).cells
        computing, current = set(), ""
        for cell in cells:
            if cell.cell_type == "markdown":
                for label in re.findall(r"^\(([\w-]+)\)=$", cell.source, re.MULTILINE):
                    current = label
            elif any(output.get("name") == "stdout" for output in cell.outputs):
                computing.add(current)
        assert computing >= {row.label for row in ERRATA}


class TestTables:
    tables = (*map(paper.equation_table, NUMBERED), paper.figure_table(), paper.errata_table())

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
        assert "(likely-glitches)=" in pages()["errata.ipynb"]

    def test_cells_have_no_bars(self) -> None:
        for table in self.tables:
            header, *lines = repr(table).splitlines()
            assert {line.count("|") for line in lines} == {header.count("|")}

    def test_pages_show_them(self) -> None:
        for section in NUMBERED:
            assert f"paper.equation_table({section})" in pages()["equations.md"]
        assert "paper.figure_table()" in pages()["equations.md"]
