"""Handles of figures under a fast hand, and under a finger on a small screen."""

import random
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from nightly import nightly
from test_explorables_in_browser import (
    EXPLORABLES,
    PHONE,
    center,
    in_sight,
    live,
    off_screen,
    open_figure,
    pages,
    values,
)
from test_figures_in_browser import open_page, settle

from rotedu.figures import Handles

__all__ = ["off_screen", "open_figure", "open_page", "pages"]

POINTS = {
    name: [key for key, kind in f.inputs.items() if isinstance(kind, Handles)]
    for name, f in EXPLORABLES.items()
}
WITH_POINTS = [name for name, keys in POINTS.items() if keys]
CURVE = "closed_curve_by_hand"
# The handle under a place of the screen, if it can be caught there.
CAUGHT = "([x, y]) => document.elementFromPoint(x, y)?.closest('[data-handle]')?.dataset.handle"
ALL = "[data-handle]:not([role=slider]):not(.scene-body)"


def points_of(figure: Any) -> list[str]:
    """Names of the points that can be caught."""
    seen = figure.locator(f"{ALL}:not([hidden]):not([data-behind])").all()
    return [handle.get_attribute("data-handle") for handle in seen]


def beyond(box: dict[str, float], angle: float) -> tuple[float, float]:
    """A place well outside of the ball of a scene, in some direction."""
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    radius = 0.62 * box["height"]
    return x + radius * np.cos(angle), y + radius * np.sin(angle)


def caught(figure: Any, name: str) -> bool:
    """Say whether a handle, or one that lies over it, can be caught where it is."""
    settle(figure.page)
    handle = figure.locator(f'[data-handle="{name}"]')
    if handle.get_attribute("data-behind") is not None:
        return False
    return figure.page.evaluate(CAUGHT, center(handle)) is not None


def fling(figure: Any, start: tuple[float, float], ends: list[tuple[float, float]]) -> None:
    """Drag by mouse as fast as it goes: one event for each place."""
    mouse = figure.page.mouse
    mouse.move(*start)
    mouse.down()
    for end in ends:
        mouse.move(*end)
    mouse.up()


def fling_by_finger(
    figure: Any, start: tuple[float, float], ends: list[tuple[float, float]]
) -> None:
    session = figure.page.context.new_cdp_session(figure.page)
    for i, (x, y) in enumerate([start, *ends]):
        points = [{"x": x, "y": y, "id": 0}]
        kind = "touchStart" if i == 0 else "touchMove"
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


def flings(figure: Any, hand: Callable[..., None], count: int) -> None:
    """Fling points to the rim in all directions; each can be caught again."""
    rng = random.Random(1)
    in_sight(figure)
    names = points_of(figure)
    for i in range(count):
        box = figure.locator(".scene").bounding_box()
        name = names[i % len(names)]
        handle = figure.locator(f'[data-handle="{name}"]')
        before = values(figure)
        angle = rng.uniform(0, 2 * np.pi)
        hand(figure, center(handle), [beyond(box, angle), beyond(box, angle + rng.uniform(-1, 1))])
        assert caught(figure, name), (i, name, angle)
        assert values(figure) != before, (i, name)


@pytest.mark.slow
@pytest.mark.parametrize("name", [CURVE])
def test_no_point_is_lost_at_the_rim(name: str, open_figure: Callable[..., Any]) -> None:
    flings(live(open_figure(name)), fling, 5)


@pytest.mark.slow
@pytest.mark.parametrize("name", WITH_POINTS)
def test_no_point_of_any_figure_is_lost_at_the_rim(
    name: str, open_figure: Callable[..., Any]
) -> None:
    flings(live(open_figure(name)), fling, 72)


@pytest.mark.slow
@pytest.mark.chromium
def test_no_point_is_lost_at_the_rim_by_finger(open_figure: Callable[..., Any]) -> None:
    flings(live(open_figure(CURVE, **PHONE)), fling_by_finger, 8)


@pytest.mark.slow
@pytest.mark.parametrize("key", ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"])
def test_keys_bring_a_point_round_the_rim_and_back(
    key: str, open_figure: Callable[..., Any]
) -> None:
    """A point that keys move goes to the far side, keeps the focus, and comes back."""
    figure = live(open_figure(CURVE))
    handle = figure.locator('[data-handle="points-2"]')
    handle.focus()
    behind = []
    for _ in range(36):
        figure.page.keyboard.press(f"Shift+{key}")
        settle(figure.page)
        behind.append(handle.get_attribute("data-behind") is not None)
        assert handle.evaluate("e => document.activeElement === e")
    assert True in behind
    assert not behind[-1]
    assert caught(figure, "points-2")


@pytest.mark.slow
def test_a_point_that_is_held_is_never_behind(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(CURVE))
    in_sight(figure)
    box = figure.locator(".scene").bounding_box()
    handle = figure.locator('[data-handle="points-2"]')
    mouse = figure.page.mouse
    mouse.move(*center(handle))
    mouse.down()
    for angle in np.linspace(0, 2 * np.pi, 9):
        mouse.move(*beyond(box, angle))
        assert handle.get_attribute("data-behind") is None
    mouse.up()
    assert caught(figure, "points-2")


def test_on_a_phone_scene_and_charts_are_seen_together(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(CURVE, **PHONE))
    scene = figure.locator(".scene")
    for part in figure.locator("[data-chart], .explorable-controls, .explorable-whole").all():
        part.evaluate("e => e.scrollIntoView({ block: 'end', behavior: 'instant' })")
        settle(figure.page)
        above, below = scene.bounding_box(), part.bounding_box()
        top, bottom = above["y"], above["y"] + above["height"]
        low, high = below["y"], below["y"] + below["height"]
        assert top >= 0
        assert bottom <= min(low, 800)
        assert high <= 800.5


@pytest.mark.slow
def test_on_a_phone_no_button_stands_on_a_picture(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(CURVE, **PHONE))
    scene, tools = (figure.locator(x).bounding_box() for x in (".scene", ".scene-tools"))
    assert tools["y"] + tools["height"] <= scene["y"] + 0.5
    for button in figure.locator(".scene-tools button").all():
        button.click(trial=True)


@pytest.mark.parametrize(
    "size", nightly([(844, 390), (667, 375), (640, 400), (720, 450)], (667, 375))
)
@pytest.mark.parametrize("name", [CURVE, pytest.param("camera_by_hand", marks=pytest.mark.slow)])
def test_a_whole_scene_fits_a_low_screen(
    name: str, size: tuple[int, int], open_figure: Callable[..., Any]
) -> None:
    """A phone on its side, and pages at twice their size."""
    viewport = {"width": size[0], "height": size[1]}
    figure = live(open_figure(name, viewport=viewport))
    box = figure.locator(".scene").bounding_box()
    header = figure.page.locator(".mobile-header").bounding_box()["height"]
    assert box["height"] <= size[1] - header
    assert box["width"] <= size[0]
    assert box["height"] >= 0.55 * size[1]


@pytest.mark.slow
def test_in_full_screen_the_controls_stay(open_figure: Callable[..., Any]) -> None:
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
def test_a_finger_has_room(name: str, open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(name, **PHONE))
    pressed = "button, a.try, summary, .explorable-switch, .explorable-choice label"
    for control in figure.locator(pressed).all():
        if control.is_visible():
            box = control.bounding_box()
            assert box["height"] >= 44, control.inner_text()
            assert box["width"] >= 44, control.inner_text()


@pytest.mark.slow
def test_a_finger_has_room_at_a_fold(site: str, open_page: Any) -> None:
    page = open_page(f"{site}/book/03-ordinary-rotation.html", **PHONE)
    for fold in page.locator("article summary").all():
        if fold.is_visible():
            assert fold.bounding_box()["height"] >= 44, fold.inner_text()
