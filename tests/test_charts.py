"""Charts: drawn by Matplotlib, in the letters and colours of the page."""

import re
from collections import Counter
from pathlib import Path

import matplotlib.pyplot as plt
import pytest
from bs4 import Tag
from html_pages import parse
from notebook_language import notebooks

from rotedu import colors
from rotedu.edition.notebook import SIDES, named

Charts = dict[str, list[Tag]]
HUES = {getattr(colors, name) for name in colors.__all__}
ALTS = {
    page.file.stem: [
        cell.metadata["mystnb"]["image"]["alt"]
        for cell in page.code
        if "plt.subplots" in cell.source
    ]
    for page in notebooks()
}


@pytest.fixture(scope="module")
def drawn(book: Path) -> Charts:
    """The charts of each page that has some."""
    return {
        name: parse(book / "book" / f"{name}.html").select("article .chart")
        for name, alts in ALTS.items()
        if alts
    }


def test_every_chart_stands_in_its_page_as_few_elements_and_text(drawn: Charts) -> None:
    assert sum(map(len, ALTS.values())) >= 8
    for name, charts in drawn.items():
        assert [chart["aria-label"] for chart in charts] == ALTS[name]
        for chart in charts:
            assert chart["role"] == "img"
            assert not chart.select("style, metadata, [id*='DejaVu']"), name
            for svg in chart.select("svg[viewBox]"):
                assert len(svg.find_all()) < 200, name
                assert svg.select("text"), name


def test_no_two_elements_of_a_page_have_one_id(book: Path, drawn: Charts) -> None:
    for name, charts in drawn.items():
        page = parse(book / "book" / f"{name}.html")
        ids = Counter(element["id"] for element in page.find_all(id=True))
        for chart in charts:
            mine = {element["id"] for element in chart.find_all(id=True)}
            meant = set(re.findall(r"#(chart[\w-]+)", str(chart)))
            assert mine == meant, name
            assert all(ids[target] == 1 for target in mine), name


def test_a_drawing_has_colours_of_the_book_alone(drawn: Charts) -> None:
    """Whatever is filled or drawn has the colour of text, which pages change."""
    for name, charts in drawn.items():
        for element in (element for chart in charts for element in chart.select("svg [style]")):
            style = dict(pair.split(": ") for pair in str(element["style"]).split("; "))
            assert style.get("color", colors.NEUTRAL) in HUES, name
            paints = {style.get(part, "none") for part in ("fill", "stroke")}
            assert paints <= {"none", "currentcolor"}, name
            assert not style.keys() & {"font-size", "font-family"}, name
        assert not any(chart.select("svg [fill], svg [stroke]") for chart in charts), name


@pytest.mark.parametrize("side", SIDES)
def test_a_name_stands_beside_its_point_in_the_colour_of_its_line(side: str) -> None:
    with plt.style.context("rotedu.book"):
        figure, panel = plt.subplots()
        lines = panel.plot([0, 1, 2], [0, 1, 0], color=colors.MATRIX)
        named(lines, "matrix", side, at=1)
        figure.canvas.draw()
        (text,) = panel.texts
        box = text.get_window_extent()
        x, y = panel.transData.transform((1, 1))
        plt.close(figure)
    assert text.get_color() == colors.MATRIX
    away = {"left": x - box.x1, "right": box.x0 - x, "above": box.y0 - y, "below": y - box.y1}
    for beside, distance in away.items():
        assert 0 < distance < 20 if beside in side.split() else distance < 0
