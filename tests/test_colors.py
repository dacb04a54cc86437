"""A colour has one code, in scenes, formulas, charts and on the page that explains it."""

import re

import matplotlib.pyplot as plt
import pytest
from derive import INKS
from matplotlib.colors import to_hex
from notebook_language import BOOK, Page, notebooks, pages

from rotedu import colors

CODES = {name: getattr(colors, name) for name in colors.__all__}


@pytest.mark.parametrize("page", notebooks(), ids=repr)
def test_a_formula_names_its_colours(page: Page) -> None:
    assert "textcolor" not in page.text


def test_charts_use_the_same_colours() -> None:
    with plt.style.context("rotedu.book"):
        cycle = plt.rcParams["axes.prop_cycle"].by_key()["color"]
        ink = to_hex(plt.rcParams["text.color"])
    known = {*CODES.values(), ink}
    assert set(map(to_hex, cycle)) <= known
    for cell in (cell for page in notebooks() for cell in page.code):
        assert set(re.findall(r"#[0-9a-f]{6}\b", cell.source)) <= known


def test_the_page_of_conventions_lists_them() -> None:
    table = re.findall(r"\| `(\w+)` \| `(#\w+)` \|", pages()["conventions.md"].text)
    assert dict(table) == CODES


def test_text_has_a_shade_of_each_for_light_and_dark_pages() -> None:
    styles = (BOOK / "_static" / "book.css").read_text("utf-8")
    settings = (BOOK.parent / "_config.yml").read_text("utf-8")
    for name in INKS:
        variable = f"color-{name.lower()}"
        assert f'[style*="{CODES[name]}"] {{ color: var(--{variable})' in styles
        assert settings.count(f"{variable}: ") == 2
