"""The list of errata: each has a section that states the error and computes it."""

import re

import nbformat
import pytest
from book_text import BOOK, pages

from rotedu.edition.errata import ERRATA, Erratum

HEADING = re.compile(r"^\((erratum-\w+)\)=\n+## (\w+)\. (.+)$", re.MULTILINE)


def test_each_has_its_section_in_order() -> None:
    headings = list(HEADING.findall(pages()["errata.ipynb"]))
    assert headings == [(row.label, row.number, row.title) for row in ERRATA]


@pytest.mark.parametrize("row", ERRATA, ids=lambda row: row.number)
def test_a_section_says_what_is_printed_what_is_right_and_what_it_changes(row: Erratum) -> None:
    _, _, rest = pages()["errata.ipynb"].partition(f"({row.label})=")
    section, _, _ = rest.partition("\n(")
    for part in ("**As printed.**", "**What it should be.**", "**What it changes.**"):
        assert section.count(part) == 1


def test_each_computes_something_or_leads_to_the_chapter_that_does() -> None:
    cells = nbformat.read(BOOK / "errata.ipynb", as_version=4).cells
    computing, current = set(), ""
    for cell in cells:
        if cell.cell_type == "markdown":
            for label in re.findall(r"^\(([\w-]+)\)=$", cell.source, re.MULTILINE):
                current = label
        elif any(output.get("name") == "stdout" for output in cell.outputs):
            computing.add(current)
    for row in ERRATA:
        if row.label not in computing:
            _, _, rest = pages()["errata.ipynb"].partition(f"({row.label})=")
            section, _, _ = rest.partition("\n(")
            chapters = re.findall(r"\]\((\d\d-[\w-]+\.ipynb)\)", section)
            assert any(f"](#{row.label})" in pages()[chapter] for chapter in chapters), row.number


def test_a_box_in_the_colour_of_errata_links_to_one() -> None:
    boxes = re.findall(r"^:class: erratum (.*?)^:::$", "\n".join(pages().values()), re.M | re.S)
    assert len(boxes) > 10
    assert all("](#erratum-e" in box for box in boxes)
