"""Figures that answer the hand, tried by mouse, finger and keys in a real browser.

After each touch the figure tells the values of its inputs and outputs. Python computes the outputs
again from the inputs (`oracles`), and draws the scene that the figure must show. Set EXPLORE_SEED
to the seed in a failure's message to repeat random inputs. What needs no browser, such as Play,
links and what is said, is tested in viewer/test.
"""

import gzip
import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista
from explorables import EXPLORABLES, SEED, moved
from html_pages import parse
from live_pages import (
    LABELS,
    LIKE_A_POSTER,
    NO_WEBGL,
    PHONE,
    Open,
    center,
    check,
    come_to,
    complaints_of_axe,
    difference,
    figure_in,
    fling,
    largest_difference,
    live,
    live_picture,
    open_figure,
    open_page,
    pages,
    settle,
    swipe,
    turn,
    values,
)
from nightly import nightly
from PIL import Image

from rotedu.figures import backend

__all__ = ["open_figure", "open_page", "pages"]

# Out of 255, of whole pictures and of squares of 16 pixels: the viewer draws lines smoother than
# VTK, and see-through faces in another order.
TOLERANCE, TOLERANCE_IN_A_SQUARE = 1.5, 75
CURVE, MIRRORS = "closed_curve_by_hand", "two_mirrors_by_hand"
# As Python in the page sets a figure.
SET = "(figure, detail) => figure.dispatchEvent(new CustomEvent('rotedu:set', { detail }))"

pytestmark = pytest.mark.filterwarnings("ignore:.*almost antipodal")


def check_picture(figure: Any, plotter: pyvista.Plotter, where: str) -> None:
    """Compare a figure, at rest and as large as posters, with the scene that Python has made."""
    plotter.render()
    for name in plotter.record.views:
        with backend.seen_from(plotter, name):
            box = figure.locator(f".scene-view[data-view={name}]")
            compare(box, plotter, backend.scene_labels(plotter, name), where)
    compare(figure.locator(".scene"), plotter, backend.scene_labels(plotter), where)
    plotter.close()


def compare(box: Any, plotter: pyvista.Plotter, named: list[dict[str, Any]], where: str) -> None:
    """Compare one picture of a figure and its labels with those of a scene."""
    labels = {label["name"]: label for label in named}
    for mine in box.evaluate(LABELS):
        label = labels.pop(mine["name"])
        there = [label["left"], label["top"]]
        # Beyond the border of the picture the viewer shows no label.
        inside = min(there) >= 0 and max(there) <= 1
        assert mine["seen"] == (inside and not label["hidden"]), (mine, where)
        if mine["seen"]:
            np.testing.assert_allclose([mine["left"], mine["top"]], there, atol=3e-4, err_msg=where)
    assert not labels, where
    python = np.asarray(Image.open(io.BytesIO(backend.take_poster(plotter))), float)
    mine = live_picture(box)
    assert difference(mine, python) < TOLERANCE, where
    assert largest_difference(mine, python) < TOLERANCE_IN_A_SQUARE, where


def handles(figure: Any) -> list[Any]:
    """The points that can be caught. Each keeps its place here when a drag hides another."""
    caught = "[data-handle][aria-roledescription=point]:not([hidden]):not([data-behind])"
    seen = figure.locator(caught).all()
    names = [handle.get_attribute("data-handle") for handle in seen]
    return [figure.locator(f'[data-handle="{name}"]') for name in names]


def in_sight(figure: Any) -> dict[str, float]:
    """Scroll to a live figure, and return the box of its scene."""
    scene = figure.locator(".scene")
    come_to(scene)
    settle(figure.page)
    return scene.bounding_box()


def changed(name: str, before: dict[str, Any], after: dict[str, Any]) -> set[str]:
    """The inputs that differ; points of a list by their handles."""
    found = set()
    for key in EXPLORABLES[name].inputs:
        if np.ndim(after[key]) == 2:
            pairs = enumerate(zip(before[key], after[key], strict=True))
            found |= {f"{key}-{i}" for i, (p, q) in pairs if not np.allclose(p, q, atol=1e-6)}
        elif before[key] != after[key]:
            found.add(key)
    return found


@pytest.mark.parametrize("name", EXPLORABLES)
def test_a_figure_has_a_page_and_loads_little(name: str, pages: dict[str, str], book: Path) -> None:
    page = book / pages[name]
    [figure] = parse(page).select(f'.explorable[data-name="{name.replace("_", "-")}"]')
    # A cache of notebooks would sort them.
    sliders = [slider["name"] for slider in figure.select("input[type=range]")]
    assert sliders == [key for key in EXPLORABLES[name].inputs if key in sliders]
    file = page.parent / figure["data-explore"]
    assert list(json.loads(file.read_bytes())["inputs"]) == list(EXPLORABLES[name].inputs)
    assert len(gzip.compress(file.read_bytes(), 9)) < 60_000


@pytest.mark.parametrize("name", nightly(EXPLORABLES, CURVE, "grab_the_spoon"))
def test_a_figure_moves_and_tells_true_numbers(name: str, open_figure: Open) -> None:
    """One touch: the first point is dragged, or the first slider or body is moved by keys.

    By day: a figure with points, and one with a body and rings.
    """
    figure = live(open_figure(name))
    before = check(name, figure)
    picture = live_picture(figure)
    in_sight(figure)
    if found := handles(figure):
        touched = found[0].get_attribute("data-handle")
        x, y = center(found[0])
        fling(figure.page, (x, y), (x + 14, y + 9), steps=4)
        np.testing.assert_allclose(center(found[0]), (x + 14, y + 9), atol=1)
    else:
        control = figure.locator("input[type=range], .scene [data-handle]").first
        touched = control.get_attribute("name") or control.get_attribute("data-handle")
        control.focus()
        for key in ("Home", *3 * ("ArrowRight",)):
            figure.page.keyboard.press(key)
        if control.get_attribute("name"):
            assert values(figure)[touched] == pytest.approx(float(control.input_value()))
    after = check(name, figure)
    # A spoon that is turned keeps its way or its thread among its inputs, or takes its rings along.
    ways = {"way", "left", "along", "u", "v", "w", "thread"} if touched == "spoon" else set()
    others = {part for part in changed(name, before, after) if part.split("-")[0] not in ways}
    assert others == {touched}
    assert difference(picture, live_picture(figure)) > 0.01


@pytest.mark.parametrize("name", nightly(EXPLORABLES, CURVE))
def test_a_figure_looks_as_python_draws_it(
    name: str, open_figure: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pyvista, "OFF_SCREEN", True)
    figure = open_figure(name, device_scale_factor=2, reduced_motion="reduce")
    figure.page.add_style_tag(content=LIKE_A_POSTER)
    live(figure)
    rng = np.random.default_rng(SEED)
    for _ in range(3):
        inputs = moved(rng, name)
        figure.evaluate(SET, inputs)
        told = check(name, figure)
        if "refused" in told:
            continue
        inputs = {key: told[key] for key in inputs}
        where = f"EXPLORE_SEED={SEED}: {name}({inputs})"
        check_picture(figure, EXPLORABLES[name](**inputs), where)


@pytest.mark.chromium
@pytest.mark.parametrize("name", nightly(EXPLORABLES, CURVE))
def test_a_touch_restyles_a_figure_and_not_its_page(name: str, open_figure: Open) -> None:
    """A rule for `:has(...) > :not(...)` would make each frame look at thousands of elements."""
    figure = live(open_figure(name))
    in_sight(figure)
    touched = "input[type=range], .scene [data-handle]"
    turn(figure, f":nth-match({touched}, 1)", "ArrowRight")
    browser = figure.page.context.browser
    browser.start_tracing(page=figure.page, categories=["devtools.timeline"])
    turn(figure, f":nth-match({touched}, 1)", *3 * ("ArrowRight",))
    settle(figure.page)
    events = json.loads(browser.stop_tracing())["traceEvents"]
    restyled = [event["args"] for event in events if event["name"] == "UpdateLayoutTree"]
    assert 0 < max(args.get("elementCount", 0) for args in restyled) < 600


@pytest.mark.slow
def test_what_is_said_only_for_those_who_listen_moves_nothing(open_figure: Open) -> None:
    figure = live(open_figure(CURVE))
    turn(figure, '[data-handle="points-0"]', "ArrowLeft")
    figure.get_by_role("button", name="Reset", exact=True).click()
    spoken = figure.locator(".explorable-status .explorable-spoken", has_text="Reset")
    assert spoken.text_content() == "Reset"
    box = spoken.bounding_box()
    assert max(box["width"], box["height"]) <= 1


@pytest.mark.slow
@pytest.mark.chromium
@pytest.mark.parametrize("name", EXPLORABLES)
def test_each_handle_by_finger(name: str, open_figure: Open) -> None:
    figure = live(open_figure(name, **PHONE))
    page = figure.page
    for handle in handles(figure):
        in_sight(figure)
        box = handle.bounding_box()
        assert min(box["width"], box["height"]) >= 44
        before, down = values(figure), page.evaluate("scrollY")
        x, y = center(handle)
        swipe(page, [(x + 4 * i, y - i) for i in range(6)])
        assert check(name, figure) != before
        assert abs(page.evaluate("scrollY") - down) <= 1


@pytest.mark.slow
def test_a_geometry_without_an_answer_stays_pale(open_figure: Open) -> None:
    opposite = "#explore-closed-curve-by-hand?points=1,0,0+0,1,0+1,0,0+0,0,1"
    figure = live(open_figure(CURVE, hash=opposite))
    assert "antipodal" in check(CURVE, figure)["refused"]
    canvas = figure.locator(".scene canvas")
    assert 0.2 < float(canvas.evaluate("e => getComputedStyle(e).opacity")) < 0.6
    assert live_picture(figure).any()
    turn(figure, '[data-handle="points-2"]', *4 * ["Shift+ArrowRight"])
    assert "refused" not in check(CURVE, figure)
    assert float(canvas.evaluate("e => getComputedStyle(e).opacity")) == 1


@pytest.mark.slow
def test_a_ring_and_a_sheet_are_dragged_round_their_axis(open_figure: Open) -> None:
    """The letter by its ring; a mirror in the middle of its sheet, far from its ring."""
    figure = live(open_figure(MIRRORS))
    box = in_sight(figure)
    before = check(MIRRORS, figure)
    x, y = center(figure.locator('[data-handle="letter"]'))
    fling(figure.page, (x, y), (x + 30, y + 60), steps=5)
    after = check(MIRRORS, figure)
    assert changed(MIRRORS, before, after) == {"letter"}
    assert after["letter"] < before["letter"] - 10
    there = center(figure.locator('[data-handle="letter"]'))
    np.testing.assert_allclose(there, (x + 30, y + 60), atol=15)

    ring = np.array(center(figure.locator('[data-handle="second"]')))
    axis = np.array([box["x"] + box["width"] / 2, box["y"] + 0.47 * box["height"]])
    end = (box["x"] + 0.3 * box["width"], box["y"] + 0.4 * box["height"])
    fling(figure.page, tuple(0.25 * axis + 0.75 * ring), end, steps=5)
    last = check(MIRRORS, figure)
    assert changed(MIRRORS, after, last) == {"second"}
    assert 90 < last["second"] < 150


@pytest.mark.slow
def test_a_chart_is_dragged_wherever_its_names_stand(open_figure: Open) -> None:
    figure = live(open_figure(CURVE))
    chart = figure.locator("svg[data-handle]").first
    chart.evaluate("chart => chart.scrollIntoView({block: 'end', behavior: 'instant'})")
    box = chart.bounding_box()

    def place(across: float, down: float) -> tuple[float, float]:
        return box["x"] + across * box["width"], box["y"] + down * box["height"]

    # Where the name of the second point stands, and a quarter further
    for share, height in ((0.26, 0.92), (0.51, 0.5)):
        fling(figure.page, place(share, height), place(share + 0.1, 0.5))
        assert values(figure)["u"] == pytest.approx(share + 0.1, abs=0.01)
    assert figure.page.evaluate("getSelection().toString()") == ""


@pytest.mark.slow
def test_a_scene_of_three_turns_only_so_far(open_figure: Open) -> None:
    figure = live(open_figure("euler_angles_by_hand"))
    pictures = []
    for presses in (8, 1):
        turn(figure, "canvas", *presses * ["ArrowRight"])
        settle(figure.page)
        pictures.append(live_picture(figure))
    assert difference(*pictures) < 0.001


@pytest.mark.slow
def test_without_webgl_two_pictures_stand_side_by_side(open_figure: Open) -> None:
    """The reason stands below both."""
    figure = open_figure("camera_by_hand", script=NO_WEBGL)
    come_to(figure.locator(".scene"))
    figure.locator(".scene-message").wait_for()
    # At one moment, while the page may still scroll.
    left, right, reason = figure.evaluate(
        """element => [".scene", ".scene-view", ".scene-message"].map((part) =>
            element.querySelector(part).getBoundingClientRect().toJSON())"""
    )
    assert left["right"] <= right["left"]
    assert right["top"] < left["bottom"]
    assert reason["top"] > max(left["bottom"], right["bottom"]) - 1


def test_without_scripts_there_are_a_poster_and_dead_controls(
    site: str, pages: dict[str, str], open_page: Open
) -> None:
    page = open_page(f"{site}/{pages[CURVE]}", java_script_enabled=False)
    figure = figure_in(page, CURVE)
    assert figure.locator(".scene-poster").is_visible()
    assert figure.locator("output[name=speed]").text_content()
    pale = "e => getComputedStyle(e).opacity"
    assert float(figure.locator(".explorable-whole").evaluate(pale)) < 0.6
    assert all(b.is_disabled() for b in figure.locator("button, input").all())
    assert not any(chip.is_visible() for chip in figure.locator("a.try").all())


@pytest.mark.slow
@pytest.mark.parametrize("name", EXPLORABLES)
def test_axe_finds_nothing_in_the_middle_of_a_drag(name: str, open_figure: Open) -> None:
    figure = live(open_figure(name))
    in_sight(figure)
    if found := handles(figure):
        figure.page.mouse.move(*center(found[0]))
        figure.page.mouse.down()
        figure.page.mouse.move(400, 300)
    assert complaints_of_axe(figure.page, ".explorable") == []


# Whether a scene and the numbers below it are in sight, and neither covers the other.
SHOWN = """figure => {
    const [scene, numbers] = [".scene", ".explorable-numbers"]
        .map((kind) => figure.querySelector(kind).getBoundingClientRect());
    return scene.top >= 0 && scene.bottom < numbers.top && numbers.bottom < innerHeight;
}"""


@pytest.mark.parametrize("name", ["worn_spoons_by_hand", "slerp_by_hand"])
def test_a_link_brings_into_sight_what_it_changes(name: str, open_figure: Open) -> None:
    """One picture stays above its panel, the other goes."""
    figure = live(open_figure(name, **PHONE))
    link = figure.locator("a.try").first
    link.evaluate("link => scrollBy(0, link.getBoundingClientRect().bottom - innerHeight)")
    assert not figure.evaluate(SHOWN)
    link.tap()
    figure.page.wait_for_function(SHOWN, arg=figure.element_handle())
