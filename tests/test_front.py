"""The first page: what it counts and shows of the others, and its figure."""

import re
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from bs4 import BeautifulSoup
from html_pages import parse
from notebook_language import captions_by_hand, chapters, pages

from rotedu.edition.claims import CLAIMS, VERDICTS

SIGNS = {
    "holds": "holds",
    "holds under a condition": "holds-under-a-condition",
    "does not hold": "does-not-hold",
    "does not follow": "left-open",
    "not confirmed": "left-open",
    "a matter of names": "left-open",
}
VALUES = "JSON.parse(document.querySelector('.explorable').dataset.values)"


@pytest.fixture(scope="module")
def front(book: Path) -> BeautifulSoup:
    """The first page."""
    return parse(book / "book" / "index.html")


def test_what_the_first_page_counts_is_there(book: Path, front: BeautifulSoup) -> None:
    counted = [int(number.get_text()) for number in front.select(".counts strong")]
    numbered = {
        number["id"]
        for page in (book / "book").glob("0*.html")
        for number in parse(page).select("div.math[id^=equation-eq-]")
    }
    errata = parse(book / "book" / "errata.html")
    rows = errata.select("#all-errors-one-by-one tbody tr")
    kinds = [row.select("td")[-1].get_text(strip=True) for row in rows]
    mended = sum(kind != "open" for kind in kinds)
    assert counted == [len(numbered), len(CLAIMS), mended, len(captions_by_hand())]


def test_each_claim_of_the_paper_has_a_square_that_says_its_verdict(front: BeautifulSoup) -> None:
    assert SIGNS.keys() == VERDICTS.keys()
    squares = {link["href"].partition("#claim-")[2]: link for link in front.select(".squares a")}
    assert len(squares) == len(front.select(".squares a"))
    of_paper = [claim for claim in CLAIMS if claim.of_paper]
    for claim in of_paper:
        square = squares.pop(str(claim.number))
        assert SIGNS[claim.verdict] in square["class"]
        said = f"Claim {claim.number}: {claim.verdict}"
        assert square.get_text() == (f"{said}, a slip" if claim.slip else said)
        assert ("slip" in square["class"]) == claim.slip
    assert not squares
    told = {
        mark["class"][-1]: int(mark.get_text().split()[0]) for mark in front.select(".legend > *")
    }
    assert told == Counter(SIGNS[claim.verdict] for claim in of_paper)


def test_each_chapter_has_a_card(front: BeautifulSoup) -> None:
    names = {f"{page}.html" for page in chapters()}
    listed = [link for link in front.select(".sidebar-tree a.reference") if link["href"] in names]
    cards = front.select(".card")
    assert len(cards) == len(names)
    assert [card.a["href"] for card in cards] == [link["href"] for link in listed]
    for card, link in zip(cards, listed, strict=True):
        assert card.a.get_text() == link.get_text()
        text = pages()[link["href"].replace(".html", ".ipynb")].text
        assert f"**Time** {card.select_one('.minutes').get_text()}utes to read" in text
        assert card.img["loading"] == "lazy"
        assert not card.select("a.first-use")


def test_cards_are_light(book: Path, front: BeautifulSoup) -> None:
    files = [book / "book" / picture["src"] for picture in front.select(".card img")]
    assert sum(file.stat().st_size for file in files) < 11_000 * len(files)


def visit(browser: Any, site: str, **how: Any) -> Any:
    """Open the first page until its figure is live."""
    page = browser.new_page(**how)
    page.goto(f"{site}/book/index.html")
    page.locator(".scene[data-state=live]").wait_for()
    return page


def test_the_figure_plays_until_it_is_grabbed(browser: Any, site: str) -> None:
    page = visit(browser, site, viewport={"width": 1440, "height": 900})
    early = page.evaluate(
        """() => {
            const [{ loadEventStart }] = performance.getEntriesByType("navigation");
            return performance.getEntriesByType("resource")
                .filter(({ startTime }) => startTime < loadEventStart).map(({ name }) => name);
        }"""
    )
    assert any("loader.js" in name for name in early)
    late = re.compile(r"(viewer|explorables)-\w+\.js|/scene-\w+\.(glb|json)")
    assert not list(filter(late.search, early))
    buttons = [page.locator(f".explorable [data-action={name}]") for name in ("reset", "play")]
    reset, play = (button.bounding_box()["y"] for button in buttons)
    assert reset == pytest.approx(play, abs=10)
    start = page.evaluate(VALUES)
    page.wait_for_function(f"start => {VALUES}.along !== start", arg=start["along"])
    box = page.locator(".scene").bounding_box()
    assert 855 <= box["width"] <= 857
    places = [page.locator(seen).bounding_box() for seen in ("h1", ".opening", ".scene", ".ways")]
    assert [place["y"] for place in places] == sorted(place["y"] for place in places)
    assert places[-1]["y"] + page.locator(".ways a").first.bounding_box()["height"] < 900
    handle = page.locator(".scene [data-handle]").first
    spot = handle.bounding_box()
    page.mouse.move(spot["x"] + spot["width"] / 2, spot["y"] + spot["height"] / 2)
    page.mouse.down()
    page.mouse.move(spot["x"] + spot["width"] / 2 + 40, spot["y"] + spot["height"] / 2, steps=4)
    assert page.locator("[data-action=play]").text_content() == "Play"
    held = page.evaluate(VALUES)
    assert held["way"] == "by hand"
    assert held["q"] != start["q"]
    page.wait_for_timeout(300)
    assert page.evaluate(VALUES) == held
    page.close()


@pytest.mark.slow
def test_the_first_screen_of_a_phone_has_title_puzzle_and_spoon(browser: Any, site: str) -> None:
    phone = {"viewport": {"width": 390, "height": 844}, "is_mobile": True, "has_touch": True}
    page = visit(browser, site, **phone)
    parts = ("h1", ".opening", ".ways", ".scene [data-handle]")
    boxes = [page.locator(part).first.bounding_box() for part in parts]
    assert [box["y"] for box in boxes] == sorted(box["y"] for box in boxes)
    assert boxes[-1]["y"] + boxes[-1]["height"] < 844
    page.close()
