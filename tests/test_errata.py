"""The list of errata: each has a section that states the error and computes it."""

import re
from functools import cache

import pytest
from notebook_language import blocks, pages

from rotedu.edition.errata import ERRATA, Erratum


@cache
def sections() -> dict[str, tuple[str, list[str]]]:
    """The text of each section that a link can name, and what its code prints."""
    found: dict[str, tuple[list[str], list[str]]] = {"": ([], [])}
    for cell in pages()["errata.ipynb"].cells:
        for block in blocks(cell.source) if cell.cell_type == "markdown" else ():
            if block.kind == "myst_target":
                found[block.title] = ([], [])
            else:
                [*found.values()][-1][0].append(block.source)
        printed = [output.text for output in cell.get("outputs", ()) if "text" in output]
        [*found.values()][-1][1].extend(printed)
    return {label: ("\n".join(text), printed) for label, (text, printed) in found.items()}


def test_each_has_its_section_in_order() -> None:
    labels = [label for label in sections() if label.startswith("erratum-")]
    assert labels == [row.label for row in ERRATA]
    for row in ERRATA:
        assert sections()[row.label][0].startswith(f"## {row.number}. {row.title}\n")


@pytest.mark.parametrize("row", ERRATA, ids=lambda row: row.number)
def test_a_section_says_what_is_printed_what_is_right_and_what_it_changes(row: Erratum) -> None:
    for part in ("**As printed.**", "**What it should be.**", "**What it changes.**"):
        assert sections()[row.label][0].count(part) == 1


@pytest.mark.parametrize("row", ERRATA, ids=lambda row: row.number)
def test_each_computes_something_or_leads_to_the_chapter_that_does(row: Erratum) -> None:
    text, printed = sections()[row.label]
    chapters = re.findall(r"\]\((\d\d-[\w-]+\.ipynb)\)", text)
    assert printed or any(f"](#{row.label})" in pages()[chapter].text for chapter in chapters)


def test_a_box_in_the_colour_of_errata_links_to_one() -> None:
    boxes = [box for page in pages().values() for box in page.boxes("erratum")]
    assert len(boxes) > 10
    assert all("](#erratum-e" in box.body for box in boxes)
