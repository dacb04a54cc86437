"""The margin of a page: notes, captions and the contents, which never stand on each other."""

from itertools import combinations
from typing import Any

import pytest
from html_pages import ROOT
from nightly import nightly
from test_preview_in_browser import read

NAMES = sorted(file.stem for file in ROOT.glob("book/*.ipynb"))
OPEN = "opened => document.querySelectorAll('.misprint').forEach((n) => { n.open = opened })"
# Notes and captions, by their words, and where they stand.
NOTES = """() => [...document.querySelectorAll("article :is(.misprint, .in-margin, figcaption)")]
    .map((note) => [note.innerText.slice(0, 30), note.getBoundingClientRect().toJSON()])
    .filter(([, { width }]) => width)"""


@pytest.mark.parametrize("name", nightly(NAMES, "05-control-points"))
def test_no_note_stands_on_another(name: str, browser: Any, site: str) -> None:
    page = read(browser, site, name, viewport={"width": 1440, "height": 900})
    for opened in (False, True):
        page.evaluate(OPEN, opened)
        notes = page.evaluate(NOTES)
        assert notes or name != "05-control-points"
        on_each_other = [
            (words, others)
            for (words, box), (others, other) in combinations(notes, 2)
            if min(box["bottom"], other["bottom"]) - max(box["top"], other["top"]) > 1
            and min(box["right"], other["right"]) - max(box["left"], other["left"]) > 1
        ]
        assert not on_each_other
    page.close()


def test_a_note_on_paper_stands_on_the_sheet(browser: Any, site: str) -> None:
    # 170 mm of text and margin
    page = read(browser, site, "05-control-points", viewport={"width": 642, "height": 900})
    page.emulate_media(media="print")
    page.evaluate(OPEN, True)
    notes = [box for words, box in page.evaluate(NOTES) if not words.startswith("Picture")]
    assert len(notes) > 3
    assert all(box["left"] > 480 and box["right"] < 644 for box in notes)
    page.close()


@pytest.mark.parametrize("width", [1000, 1440])
def test_two_pictures_of_a_figure_stand_apart(width: int, browser: Any, site: str) -> None:
    page = read(browser, site, "05-closed-curve", viewport={"width": width, "height": 900})
    figure = page.locator(".explorable:has(> .scene-view)")
    one, other = (figure.locator(f"> {part}").bounding_box() for part in (".scene", ".scene-view"))
    beside = one["x"] + one["width"] <= other["x"]
    assert beside or one["y"] + one["height"] <= other["y"]
    page.close()


@pytest.mark.parametrize("width", [1320, 1440])
def test_the_open_rail_covers_nothing(width: int, browser: Any, site: str) -> None:
    page = read(browser, site, "02-quaternions", viewport={"width": width, "height": 900})
    rail = page.locator(".toc-drawer")
    titles = rail.locator("li li a")
    closed = rail.locator(".toc-sticky").bounding_box()["width"]
    ticks = [title.bounding_box()["y"] for title in titles.all()]
    rail.locator(".toc-sticky").hover()
    opened = rail.locator(".toc-sticky").bounding_box()
    assert opened["width"] > 2 * closed
    assert [title.bounding_box()["y"] for title in titles.all()] == pytest.approx(ticks, abs=1)
    margin = max(box["right"] for _, box in page.evaluate(NOTES))
    assert margin <= opened["x"]
    assert opened["x"] + opened["width"] <= width
    assert all(title.bounding_box()["width"] > 40 for title in titles.all())
    page.close()


def test_a_finger_opens_the_rail_before_it_leads_anywhere(browser: Any, site: str) -> None:
    screen = {"width": 1366, "height": 1024}
    page = read(browser, site, "02-quaternions", viewport=screen, has_touch=True)
    rail = page.locator(".toc-drawer .toc-sticky")
    tick = rail.locator("li li a").nth(3).bounding_box()
    at = tick["x"] + tick["width"] / 2, tick["y"] + tick["height"] / 2
    page.touchscreen.tap(*at)
    page.wait_for_function("document.activeElement.closest('.toc-drawer')")
    assert "#" not in page.url
    assert rail.bounding_box()["width"] > 150
    rail.locator("li li a").nth(3).tap()
    assert "#" in page.url
    page.close()
