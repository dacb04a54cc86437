"""How a reader comes to a figure that answers the hand: by a link, too early, by Back."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from nightly import nightly
from test_explorables_in_browser import (
    PHONE,
    center,
    in_sight,
    live,
    off_screen,
    open_figure,
    pages,
    same,
    turn,
    values,
)
from test_figures_in_browser import CONTEXTS, SAVE_DATA, WAITS, Open, loaded, open_page, settle

__all__ = ["off_screen", "open_figure", "open_page", "pages"]

CURVE = "closed_curve_by_hand"
STATE = "#explore-closed-curve-by-hand?u=0.7&fraction=0.3"
SCREENS = {
    "wide": {"viewport": {"width": 1440, "height": 900}},
    "phone": PHONE,
    "landscape": {"viewport": {"width": 844, "height": 390}},
    "zoomed": {"viewport": {"width": 640, "height": 400}},
}
# The share of a scene that a reader sees: nothing lies over it but what belongs to it.
SEEN = """scene => {
    const { left, top, width, height } = scene.getBoundingClientRect();
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
NO_CLIPBOARD = "Object.defineProperty(navigator, 'clipboard', { value: undefined });"


def arrived(figure: Any) -> dict[str, Any]:
    """Wait, without a sign of a reader, until a figure is live; return its values."""
    figure.page.wait_for_function(
        "element => element.dataset.values", arg=figure.element_handle(), timeout=20_000
    )
    settle(figure.page)
    return values(figure)


@pytest.mark.parametrize("script", nightly(["", LATE], LATE))
@pytest.mark.parametrize("screen", nightly(SCREENS, "phone"))
def test_a_link_opens_on_its_state(
    screen: str, script: str, open_figure: Callable[..., Any]
) -> None:
    figure = open_figure(CURVE, hash=STATE, script=script, **SCREENS[screen])
    if script:
        figure.page.wait_for_selector(".late", state="attached")
    told = arrived(figure)
    assert (told["u"], told["fraction"]) == (0.7, 0.3)
    assert figure.locator(".scene").evaluate(SEEN) == 1


@pytest.mark.slow
def test_a_reader_who_moves_on_is_left_alone(open_figure: Callable[..., Any]) -> None:
    figure = open_figure(CURVE, hash=STATE, script=LATE)
    figure.page.keyboard.press("Control+End")
    figure.page.wait_for_selector(".late", state="attached")
    settle(figure.page)
    assert figure.locator(".scene").evaluate(SEEN) == 0


@pytest.mark.slow
def test_a_link_within_the_page_leads_to_its_state(open_figure: Callable[..., Any]) -> None:
    figure = open_figure(CURVE)
    figure.page.evaluate("scrollTo({ top: document.body.scrollHeight, behavior: 'instant' })")
    figure.page.evaluate("hash => { location.hash = hash; }", STATE)
    assert arrived(figure)["u"] == 0.7
    assert figure.locator(".scene").evaluate(SEEN) == 1


def test_a_figure_in_sight_is_live_before_a_reader_moves(open_figure: Callable[..., Any]) -> None:
    figure = open_figure(CURVE, hash=STATE)
    arrived(figure)
    waits = figure.page.evaluate(WAITS)
    heavy = [wait for name, wait in waits if "viewer-" in name or name.endswith(".glb")]
    assert len(heavy) >= 2
    assert min(heavy) >= 0


@pytest.mark.slow
def test_a_drag_that_begins_on_the_poster_goes_on(open_figure: Callable[..., Any]) -> None:
    """The point under the mouse moves, though it was only a picture when the mouse went down."""
    figure = live(open_figure(CURVE))
    in_sight(figure)
    x, y = center(figure.locator('[data-handle="points-0"]'))
    before = values(figure)["points"]
    page = figure.page
    context, url = page.context, page.url
    page = context.new_page()
    held: list[Any] = []
    page.route("**/*.glb", lambda route: held.append(route))
    page.goto(url, wait_until="domcontentloaded")
    figure = page.locator('.explorable[data-name="closed-curve-by-hand"]')
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
def test_who_saves_data_follows_a_link_and_clicks(open_figure: Callable[..., Any]) -> None:
    figure = open_figure(CURVE, hash=STATE, script=SAVE_DATA)
    figure.page.wait_for_timeout(500)
    assert not [name for name in loaded(figure.page) if name.endswith(".glb")]
    assert figure.locator(".scene").evaluate(SEEN) == 1
    figure.get_by_role("button", name="Turn this figure").click()
    assert arrived(figure)["u"] == 0.7


@pytest.mark.slow
def test_loading_is_said_after_a_second(site: str, pages: Any, open_page: Open) -> None:
    page = open_page("about:blank", quiet=False)
    held: list[Any] = []
    page.route("**/*.glb", lambda route: held.append(route))
    page.goto(f"{site}/{pages[CURVE]}{STATE}", wait_until="domcontentloaded")
    figure = page.locator('.explorable[data-name="closed-curve-by-hand"]')
    line, panel = figure.locator(".scene-loading"), figure.locator(".explorable-panel")
    line.wait_for(timeout=10_000)
    assert line.inner_text() == "Loading the figure…"
    assert line.get_attribute("role") == "status"
    assert float(pale(figure)) < 0.6
    place = panel.bounding_box()
    for route in held:
        route.continue_()
    arrived(figure)
    assert line.count() == 0
    assert panel.bounding_box() == place
    assert float(pale(figure)) == 1


def pale(figure: Any) -> str:
    """How clearly the controls of a figure are seen."""
    opacity: str = figure.locator(".explorable-whole").evaluate("e => getComputedStyle(e).opacity")
    return opacity


def test_without_scripts_controls_look_dead(
    site: str, pages: dict[str, str], open_page: Open
) -> None:
    page = open_page(f"{site}/{pages[CURVE]}", java_script_enabled=False)
    figure = page.locator('.explorable[data-name="closed-curve-by-hand"]')
    assert float(pale(figure)) < 0.6
    assert all(b.is_disabled() for b in figure.locator("button, input").all())
    assert not any(chip.is_visible() for chip in figure.locator("a.try").all())


@pytest.mark.slow
def test_graphics_that_stay_away_leave_the_poster(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(CURVE, script=CONTEXTS, quiet=False))
    page, scene = figure.page, figure.locator(".scene")
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
    turn(figure, "input[name=fraction]", ("Home",))
    assert values(figure)["fraction"] == 0.2


@pytest.mark.slow
@pytest.mark.parametrize("way", nightly(["Back", "a reload", "Back from memory"], "Back"))
def test_a_figure_is_found_as_it_was_left(way: str, open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(CURVE))
    page = figure.page
    before = values(figure)
    turn(figure, "input[name=fraction]", ("Home",))
    turn(figure, '[data-handle="points-0"]', ("Shift+ArrowDown",))
    left = values(figure)
    if way == "a reload":
        page.wait_for_timeout(600)
        page.reload()
    elif way == "Back":
        page.wait_for_timeout(600)
        page.goto(page.url.rpartition("/")[0] + "/")
        page.go_back()
    else:
        page.evaluate("dispatchEvent(new PageTransitionEvent('pageshow', { persisted: true }))")
    found = values(live(figure))
    assert found["fraction"] == 0.2
    np.testing.assert_allclose(found["points"], left["points"], atol=1e-4)
    figure.get_by_role("button", name="Reset", exact=True).click()
    page.reload()
    assert same(values(live(figure)), before)


@pytest.mark.slow
def test_a_link_goes_into_the_clipboard(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(CURVE, permissions=["clipboard-read", "clipboard-write"]))
    turn(figure, "input[name=fraction]", ("Home",))
    figure.locator("button[name=copy]").click()
    line = figure.locator(".explorable-status")
    line.get_by_text("Link copied").wait_for()
    address = figure.page.evaluate("navigator.clipboard.readText()")
    assert address.endswith("#explore-closed-curve-by-hand?fraction=0.2")
    assert address.startswith(figure.page.url.partition("#")[0])


@pytest.mark.slow
def test_a_link_can_be_copied_where_the_clipboard_is_refused(
    open_figure: Callable[..., Any],
) -> None:
    figure = live(open_figure(CURVE, script=NO_CLIPBOARD))
    figure.locator("button[name=copy]").click()
    field = figure.locator(".explorable-status input")
    assert "#explore-closed-curve-by-hand?" in field.input_value()
    chosen = "e => document.activeElement === e && e.selectionEnd - e.selectionStart"
    assert field.evaluate(chosen) == len(field.input_value())


@pytest.mark.slow
def test_a_change_is_told_once_the_hand_rests(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(CURVE))
    canvas, line = figure.locator("canvas"), figure.locator("[role=status]")
    alt = canvas.get_attribute("aria-label")
    assert alt == figure.locator(".scene-poster").get_attribute("alt")
    assert figure.locator(".scene-label:not([aria-hidden=true])").count() == 0
    turn(figure, "input[name=fraction]", ("Home",))
    figure.page.wait_for_timeout(700)
    assert "how far aᵢ goes 0.2" in line.inner_text()
    assert figure.locator("output[name=speed]").inner_text() in line.inner_text()
    assert canvas.get_attribute("aria-label").startswith("Changed: how far aᵢ goes 0.2. ")
    assert figure.locator("input[type=range][name=fraction]").get_attribute("aria-valuetext")
    # Only for those who listen: nothing appears, so nothing moves.
    box = line.locator("span").bounding_box()
    assert max(box["width"], box["height"]) <= 1
