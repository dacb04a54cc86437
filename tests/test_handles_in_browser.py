"""Handles of figures under a fast hand, and under a finger on a small screen."""

import random
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from live_pages import (
    CONTEXTS,
    PHONE,
    Open,
    center,
    check,
    fling,
    live,
    lost_contexts,
    open_figure,
    open_page,
    pages,
    settle,
    swipe,
    values,
)
from nightly import nightly
from test_explorables_in_browser import CURVE, EXPLORABLES, handles, in_sight

from rotedu.figures import Handles

__all__ = ["open_figure", "open_page", "pages"]

WITH_POINTS = [
    name
    for name, figure in EXPLORABLES.items()
    if any(isinstance(kind, Handles) for kind in figure.inputs.values())
]
# The handle under a place of the screen, if it can be caught there.
CAUGHT = "([x, y]) => document.elementFromPoint(x, y)?.closest('[data-handle]')?.dataset.handle"


def beyond(box: dict[str, float], angle: float) -> tuple[float, float]:
    """A place well outside of the ball of a scene, in some direction."""
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    radius = 0.62 * box["height"]
    return x + radius * np.cos(angle), y + radius * np.sin(angle)


def caught(handle: Any) -> str | None:
    """Return the name of what a hand catches where a handle is: it, or one that lies over it."""
    settle(handle.page)
    return handle.page.evaluate(CAUGHT, center(handle))


def flings(figure: Any, hand: Callable[..., None], count: int) -> None:
    """Fling points to the rim in all directions; each moves, and can be caught again.

    One that lies at the end of its path under the handle of the path does not: that stays there.
    """
    rng = random.Random(1)
    in_sight(figure)
    found = handles(figure)
    names = {handle.get_attribute("data-handle") for handle in found}
    moved = 0
    for i in range(count):
        box = figure.locator(".scene").bounding_box()
        handle = found[i % len(found)]
        before = values(figure)
        is_point = caught(handle) in names
        angle = rng.uniform(0, 2 * np.pi)
        hand(center(handle), beyond(box, angle), beyond(box, angle + rng.uniform(-1, 1)))
        # Away from the text, whose words explain themselves over the picture.
        figure.page.mouse.move(0, 0)
        assert handle.get_attribute("data-behind") is None, (i, angle)
        assert caught(handle), (i, angle)
        assert values(figure) != before or not is_point, (i, angle)
        moved += is_point
    assert moved > 0.4 * count


@pytest.mark.slow
@pytest.mark.parametrize("name", WITH_POINTS)
def test_no_point_is_lost_at_the_rim(name: str, open_figure: Open) -> None:
    figure = live(open_figure(name, script=CONTEXTS))
    flings(figure, lambda *places: fling(figure.page, *places), 72)
    check(name, figure)
    assert lost_contexts(figure.page) == [False]


@pytest.mark.slow
@pytest.mark.chromium
def test_no_point_is_lost_at_the_rim_by_finger(open_figure: Open) -> None:
    figure = live(open_figure(CURVE, **PHONE))
    flings(figure, lambda *places: swipe(figure.page, list(places)), 8)


@pytest.mark.slow
@pytest.mark.parametrize("key", ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"])
def test_keys_bring_a_point_round_the_rim_and_back(key: str, open_figure: Open) -> None:
    """A point that keys move goes to the far side, keeps the focus, and comes back."""
    figure = live(open_figure(CURVE))
    handle = figure.locator('[data-handle="points-2"]')
    handle.focus()
    behind = []
    for _ in range(36):
        figure.page.keyboard.press(f"Shift+{key}")
        settle(figure.page)
        behind.append(handle.get_attribute("data-behind") is not None)
        events, opacity = handle.evaluate(
            "e => [getComputedStyle(e).pointerEvents, Number(getComputedStyle(e).opacity)]"
        )
        assert (events == "none" and opacity < 0.4) == behind[-1]
        assert handle.evaluate("e => document.activeElement === e")
    assert True in behind
    assert not behind[-1]
    assert caught(handle)


def test_on_a_phone_scene_and_charts_are_seen_together(open_figure: Open) -> None:
    figure = live(open_figure(CURVE, **PHONE))
    scene = figure.locator(".scene")
    for part in figure.locator("[data-chart], .explorable-controls, .explorable-whole").all():
        part.evaluate("e => e.scrollIntoView({ block: 'end', behavior: 'instant' })")
        settle(figure.page)
        above, below = scene.bounding_box(), part.bounding_box()
        assert above["y"] >= 0
        assert above["y"] + above["height"] <= min(below["y"], 800)
        assert below["y"] + below["height"] <= 800.5


@pytest.mark.slow
def test_on_a_phone_no_button_stands_on_a_picture(open_figure: Open) -> None:
    figure = live(open_figure(CURVE, **PHONE))
    scene, tools = (figure.locator(x).bounding_box() for x in (".scene", ".scene-tools"))
    assert tools["y"] + tools["height"] <= scene["y"] + 0.5
    for button in figure.locator(".scene-tools button").all():
        button.click(trial=True)


@pytest.mark.parametrize(
    "size", nightly([(844, 390), (667, 375), (640, 400), (720, 450)], (667, 375))
)
@pytest.mark.parametrize("name", nightly([CURVE, "camera_by_hand"], CURVE))
def test_a_whole_scene_fits_a_low_screen(
    name: str, size: tuple[int, int], open_figure: Open
) -> None:
    """A phone on its side, and pages at twice their size."""
    figure = live(open_figure(name, viewport={"width": size[0], "height": size[1]}))
    box = figure.locator(".scene").bounding_box()
    header = figure.page.locator(".mobile-header").bounding_box()["height"]
    assert 0.55 * size[1] <= box["height"] <= size[1] - header
    assert box["width"] <= size[0]


@pytest.mark.slow
def test_in_full_screen_the_controls_stay(open_figure: Open) -> None:
    figure = live(open_figure(CURVE, viewport={"width": 1440, "height": 900}))
    page = figure.page
    figure.locator(".scene-canvas").first.focus()
    page.keyboard.press("f")
    page.wait_for_function("() => document.fullscreenElement?.matches('.explorable')")
    settle(page)
    above, below = (figure.locator(x).bounding_box() for x in (".scene", ".explorable-controls"))
    assert above["height"] > 450
    assert above["y"] + above["height"] <= below["y"]
    assert below["y"] + below["height"] <= 900
    page.keyboard.press("f")
    page.wait_for_function("() => !document.fullscreenElement")


@pytest.mark.parametrize("name", nightly(EXPLORABLES, CURVE))
def test_a_finger_has_room(name: str, open_figure: Open) -> None:
    figure = live(open_figure(name, **PHONE))
    pressed = "button, a.try, summary, .explorable-switch, .explorable-choice label"
    for control in figure.locator(pressed).all():
        if control.is_visible():
            box = control.bounding_box()
            assert min(box["width"], box["height"]) >= 44, control.inner_text()
    lines = "all => all.map((chip) => chip.getClientRects().length)"
    assert set(figure.locator(".explorable-tries span:visible").evaluate_all(lines)) <= {1}


@pytest.mark.slow
def test_a_finger_has_room_at_a_fold(site: str, open_page: Open) -> None:
    page = open_page(f"{site}/book/03-ordinary-rotation.html", **PHONE)
    for fold in page.locator("article summary").all():
        if fold.is_visible():
            assert fold.bounding_box()["height"] >= 44, fold.inner_text()
