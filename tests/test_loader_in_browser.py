"""How a reader comes to a figure that answers the hand: by a link, too early, by Back."""

from typing import Any

import numpy as np
import pytest
from live_pages import (
    CONTEXTS,
    PHONE,
    Open,
    arrived,
    center,
    difference,
    figure_in,
    live,
    live_picture,
    loaded,
    open_figure,
    open_page,
    pages,
    settle,
    turn,
    values,
)
from nightly import nightly
from test_explorables_in_browser import CURVE, in_sight

__all__ = ["open_figure", "open_page", "pages"]

STATE = "#explore-closed-curve-by-hand?u=0.7&fraction=0.3"
SCREENS = {
    "wide": {"viewport": {"width": 1440, "height": 900}},
    "phone": PHONE,
    "landscape": {"viewport": {"width": 844, "height": 390}},
    "zoomed": {"viewport": {"width": 640, "height": 400}},
}
# The share of a drawing that a reader sees: nothing lies over it but what belongs to it. What is
# empty above it takes the place of a margin (scene.css).
SEEN = """scene => {
    const box = scene.getBoundingClientRect();
    const blank = box.height * getComputedStyle(scene).getPropertyValue("--blank-top");
    const [left, top, width, height] = [box.left, box.top + blank, box.width, box.height - blank];
    let seen = 0;
    for (let i = 1; i < 20; i++) for (let j = 1; j < 20; j++) {
        const there = document.elementFromPoint(left + i * width / 20, top + j * height / 20);
        seen += Boolean(there && scene.contains(there));
    }
    return seen / 361;
}"""
# Something above the figure grows when the page has long been there, as a font or a picture may.
LATE = """
    addEventListener("load", () => setTimeout(() => {
        const late = Object.assign(document.createElement("div"), { className: "late" });
        late.style.height = "700px";
        document.querySelector("h1").after(late);
    }, 700));
"""
# Graphics that are taken stay away until they are given back.
LOSE = """() => {
    window.lose = contexts[0].getExtension("WEBGL_lose_context");
    lose.loseContext();
}"""


def seen(figure: Any) -> float:
    return figure.locator(".scene").evaluate(SEEN)


@pytest.mark.parametrize("script", nightly(["", LATE], LATE))
@pytest.mark.parametrize("screen", nightly(SCREENS, "phone"))
def test_a_link_opens_on_its_state(screen: str, script: str, open_figure: Open) -> None:
    figure = open_figure(CURVE, hash=STATE, script=script, **SCREENS[screen])
    if script:
        figure.page.wait_for_selector(".late", state="attached")
    told = arrived(figure)
    assert (told["u"], told["fraction"]) == (0.7, 0.3)
    assert seen(figure) == 1


@pytest.mark.slow
def test_a_reader_who_moves_on_is_left_alone(open_figure: Open) -> None:
    figure = open_figure(CURVE, hash=STATE, script=LATE)
    figure.page.keyboard.press("Control+End")
    figure.page.wait_for_selector(".late", state="attached")
    settle(figure.page)
    assert seen(figure) == 0


@pytest.mark.slow
def test_a_link_within_the_page_leads_to_its_state(open_figure: Open) -> None:
    figure = open_figure(CURVE)
    figure.page.evaluate("scrollTo({ top: document.body.scrollHeight, behavior: 'instant' })")
    figure.page.evaluate("hash => { location.hash = hash; }", STATE)
    assert arrived(figure)["u"] == 0.7
    assert seen(figure) == 1


def opened_and_held(page: Any, url: str) -> tuple[Any, list[Any]]:
    """Open the page of the curve, but hold its scenes back until these routes go on."""
    held: list[Any] = []
    page.route("**/*.glb", lambda route: held.append(route))
    page.goto(url, wait_until="domcontentloaded")
    return figure_in(page, CURVE), held


@pytest.mark.slow
def test_a_drag_that_begins_on_the_poster_goes_on(open_figure: Open) -> None:
    """The point under the mouse moves, though it was only a picture when the mouse went down."""
    figure = live(open_figure(CURVE))
    in_sight(figure)
    x, y = center(figure.locator('[data-handle="points-0"]'))
    before = values(figure)["points"]
    page = figure.page.context.new_page()
    figure, held = opened_and_held(page, figure.page.url)
    # A page that scrolls would end the drag, and letters that come late would move it.
    page.evaluate("document.fonts.ready.then(() => null)")
    in_sight(figure)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 4, y + 3, steps=2)
    assert figure.locator(".scene").get_attribute("data-state") in ("poster", "loading")
    for route in held:
        route.continue_()
    arrived(figure)
    page.mouse.move(x + 30, y + 20, steps=5)
    page.mouse.up()
    moved = values(figure)["points"]
    assert np.linalg.norm(np.subtract(moved[0], before[0])) > 0.1
    np.testing.assert_allclose(moved[1:], before[1:], atol=1e-6)
    there = center(figure.locator('[data-handle="points-0"]'))
    np.testing.assert_allclose(there, (x + 30, y + 20), atol=1)


@pytest.mark.slow
def test_who_saves_data_follows_a_link_and_clicks(open_figure: Open) -> None:
    saving = "Object.defineProperty(navigator, 'connection', {value: {saveData: true}})"
    figure = open_figure(CURVE, hash=STATE, script=saving)
    figure.page.wait_for_timeout(500)
    assert not [name for name in loaded(figure.page) if name.endswith(".glb")]
    assert seen(figure) == 1
    figure.get_by_role("button", name="Turn this figure").click()
    assert arrived(figure)["u"] == 0.7


@pytest.mark.slow
def test_loading_is_said_after_a_second(site: str, pages: Any, open_page: Open) -> None:
    page = open_page("about:blank", quiet=False)
    figure, held = opened_and_held(page, f"{site}/{pages[CURVE]}{STATE}")
    line, panel = figure.locator(".scene-loading"), figure.locator(".explorable-panel")
    line.wait_for(timeout=10_000)
    assert line.inner_text() == "Loading the figure…"
    assert line.get_attribute("role") == "status"
    place = panel.bounding_box()
    for route in held:
        route.continue_()
    arrived(figure)
    assert line.count() == 0
    assert panel.bounding_box() == place
    opacity = "e => Number(getComputedStyle(e).opacity)"
    assert figure.locator(".explorable-whole").evaluate(opacity) == 1


@pytest.mark.slow
def test_graphics_that_stay_away_leave_the_poster(open_figure: Open) -> None:
    figure = live(open_figure(CURVE, script=CONTEXTS, quiet=False))
    page, scene = figure.page, figure.locator(".scene")
    turn(figure, "input[name=fraction]", "Home")
    settle(page)
    before = live_picture(scene)
    page.evaluate(LOSE)
    line = figure.locator(".scene-message[role=status]")
    line.wait_for(timeout=10_000)
    assert "taken the graphics" in line.inner_text()
    assert scene.get_attribute("data-state") == "failed"
    assert scene.locator(".scene-poster").is_visible()
    assert not scene.locator(".scene-handle").first.is_visible()
    assert figure.locator("button[name=copy]").is_disabled()
    assert not figure.locator("a.try").first.is_visible()
    page.evaluate("lose.restoreContext()")
    page.wait_for_function("scene => scene.dataset.state === 'live'", arg=scene.element_handle())
    assert line.count() == 0
    settle(page)
    assert difference(before, live_picture(scene)) < 0.01
    turn(figure, "input[name=fraction]", "End")
    assert values(figure)["fraction"] == 0.5


@pytest.mark.slow
@pytest.mark.parametrize("way", ["Back", "a reload"])
def test_a_figure_is_found_as_it_was_left(way: str, open_figure: Open) -> None:
    figure = live(open_figure(CURVE))
    page = figure.page
    before = values(figure)
    turn(figure, "input[name=fraction]", "Home")
    turn(figure, '[data-handle="points-0"]', "Shift+ArrowDown")
    left = values(figure)
    page.wait_for_timeout(600)
    if way == "a reload":
        page.reload()
    else:
        page.goto(page.url.rpartition("/")[0] + "/")
        page.go_back()
    found = values(live(figure))
    assert found["fraction"] == 0.2
    np.testing.assert_allclose(found["points"], left["points"], atol=1e-4)
    figure.get_by_role("button", name="Reset", exact=True).click()
    page.reload()
    assert values(live(figure)) == before
