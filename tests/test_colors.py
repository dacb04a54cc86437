"""A colour has one code, in scenes, formulas, charts and on the page that explains it."""

import re
from pathlib import Path

import matplotlib.pyplot as plt
import nbformat
import pytest
from matplotlib.colors import to_hex

from rotedu import colors

BOOK = Path(__file__).parents[1] / "book"
CODES = {name: getattr(colors, name) for name in colors.__all__}
INKS = ("VECTOR", "AXIS", "RESULT", "CROSS", "WRONG")
MACROS = {rf"\{name.lower()}": rf"\textcolor{{#{CODES[name]}}}{{#1}}" for name in INKS}
# MyST in JupyterLab reads the front matter, which other notebooks take for a comment between two
# rules; MathJax reads the formula. The book leaves the cell out.
DEFINITIONS = "\n".join(
    (
        "---",
        "<!--: Numbers and colours of formulas, for MyST in JupyterLab and for MathJax",
        "numbering:",
        "  equation: false",
        "math:",
        *(f"  {macro}: {meaning}" for macro, meaning in MACROS.items()),
        "# -->",
        "---",
        "",
        "$" + "".join(rf"\def{macro}#1{{{meaning}}}" for macro, meaning in MACROS.items()) + "$",
    )
)


@pytest.mark.parametrize("file", sorted(BOOK.glob("*.ipynb")), ids=lambda file: file.stem)
def test_a_notebook_defines_the_colours_of_its_formulas(file: Path) -> None:
    first, *cells = nbformat.read(file, as_version=4).cells
    assert first.source == DEFINITIONS
    assert first.metadata.tags == ["remove-cell"]
    text = "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")
    assert "textcolor" not in text


def test_charts_use_the_same_colours() -> None:
    with plt.style.context("rotedu.book"):
        cycle = plt.rcParams["axes.prop_cycle"].by_key()["color"]
        ink = to_hex(plt.rcParams["text.color"])
    known = {*CODES.values(), ink}
    assert set(map(to_hex, cycle)) <= known
    for file in BOOK.glob("*.ipynb"):
        for cell in nbformat.read(file, as_version=4).cells:
            if cell.cell_type == "code":
                assert set(re.findall(r"#[0-9a-f]{6}\b", cell.source)) <= known


def test_the_page_of_conventions_lists_them() -> None:
    table = re.findall(r"\| `(\w+)` \| `(#\w+)` \|", (BOOK / "conventions.md").read_text("utf-8"))
    assert dict(table) == CODES


def test_text_has_a_shade_of_each_for_light_and_dark_pages() -> None:
    styles = (BOOK / "_static" / "book.css").read_text("utf-8")
    settings = (BOOK.parent / "_config.yml").read_text("utf-8")
    for name in INKS:
        variable = f"color-{name.lower()}"
        assert f'[style*="{CODES[name]}"] {{ color: var(--{variable})' in styles
        assert settings.count(f"{variable}: ") == 2
