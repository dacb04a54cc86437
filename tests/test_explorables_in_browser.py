"""Figures that answer the hand, tried by mouse, finger and keys in a real browser.

After each touch the figure tells the values of its inputs and outputs. Python computes the outputs
again from the inputs (`oracles`), and draws the scene that the figure must show. Set EXPLORE_SEED
to the seed in a failure's message to repeat random inputs.
"""

import functools
import gzip
import io
import json
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import numpy as np
import pytest
import pyvista
from explorables import EXPLORABLES, SEED, expected, moved, spec
from html_pages import parse
from nightly import nightly
from notebook_language import chapters
from PIL import Image
from test_figures_in_browser import (
    AXE,
    CONTEXTS,
    LABELS,
    LIKE_A_POSTER,
    NO_WEBGL,
    Open,
    bring_live,
    come_to,
    difference,
    largest_difference,
    live_picture,
    lost_contexts,
    open_page,
    settle,
)

from rotedu.figures import backend

__all__ = ["open_page"]

TRIES = 3
# Out of 255, of whole pictures and of squares of 16 pixels: the viewer draws lines smoother than
# VTK, and see-through faces in another order.
TOLERANCE, TOLERANCE_IN_A_SQUARE = 1.5, 75
PHONE = {"viewport": {"width": 390, "height": 800}, "has_touch": True, "is_mobile": True}

pytestmark = pytest.mark.filterwarnings("ignore:.*almost antipodal")


@pytest.fixture(scope="session")
def pages(book: Any) -> dict[str, str]:
    """The chapter in which each figure stands; the first page shows one without its controls."""
    found = {}
    for file in sorted(book / "book" / f"{page}.html" for page in chapters()):
        text = file.read_text("utf-8")
        for name in EXPLORABLES:
            if f'data-name="{name.replace("_", "-")}"' in text:
                found[name] = file.relative_to(book).as_posix()
    return found


@pytest.fixture(autouse=True)
def off_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let Python draw scenes without a window."""
    monkeypatch.setattr(pyvista, "OFF_SCREEN", True)


@pytest.fixture
def open_figure(site: str, pages: dict[str, str], open_page: Open) -> Callable[..., Any]:
    def open_one(name: str, hash: str = "", **options: Any) -> Any:
        page = open_page(f"{site}/{pages[name]}{hash}", **options)
        return page.locator(f'.explorable[data-name="{name.replace("_", "-")}"]')

    return open_one


def live(figure: Any) -> Any:
    """Bring the scene of a figure live, and wait for its values."""
    bring_live(figure.locator(".scene"))
    figure.page.wait_for_function(
        "element => element.dataset.values", arg=figure.element_handle(), timeout=10_000
    )
    settle(figure.page)
    return figure


def values(figure: Any) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(figure.get_attribute("data-values"))
    return found


def address(name: str, inputs: dict[str, Any]) -> str:
    """The end of the address at which a figure has these inputs."""

    def text(value: Any) -> str:
        if isinstance(value, bool):
            return str(value).lower()
        if isinstance(value, str):
            return value
        points = (",".join(f"{x:.5f}" for x in point) for point in np.atleast_2d(value))
        return " ".join(points)

    state = urlencode({key: text(value) for key, value in inputs.items()})
    return f"#explore-{name.replace('_', '-')}?{state}"


def check_picture(figure: Any, plotter: pyvista.Plotter, where: str = "") -> None:
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


@functools.cache
def outputs_of(name: str) -> list[dict[str, Any]]:
    """How the outputs of a figure are written."""
    found: list[dict[str, Any]] = spec(name)["outputs"]
    return found


def check(name: str, figure: Any) -> dict[str, Any]:
    """Compare the numbers of a figure with those of the oracle; return them."""
    settle(figure.page)
    told = values(figure)
    outputs = expected(name, {key: told[key] for key in EXPLORABLES[name].inputs})
    assert told.get("refused") == outputs.get("refused")
    if "refused" in told:
        return told
    for output in outputs_of(name):
        key = output["name"]
        text = figure.locator(f'output[name="{key}"]').text_content().replace("\N{MINUS SIGN}", "-")
        if isinstance(outputs[key], str):
            assert told[key] == outputs[key], (key, told)
            assert text.replace("-", "\N{MINUS SIGN}") == told[key].replace("-", "\N{MINUS SIGN}")
            continue
        np.testing.assert_allclose(told[key], outputs[key], rtol=2e-6, atol=2e-6, err_msg=str(told))
        numbers = np.array(text.removesuffix(output["unit"]).replace(",", "").split(), float)
        np.testing.assert_allclose(
            numbers, np.ravel(told[key]), atol=0.51 * 10 ** -output["digits"]
        )
    return told


def same(told: dict[str, Any], before: dict[str, Any]) -> bool:
    """Compare values."""
    return told.keys() == before.keys() and all(
        value == before[key]
        if isinstance(value, (str, bool))
        else np.allclose(value, before[key], rtol=1e-6, atol=1e-6)
        for key, value in told.items()
    )


def center(handle: Any) -> tuple[float, float]:
    box = handle.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def handles(figure: Any) -> list[Any]:
    """The points that can be caught. Each keeps its place here when a drag hides another."""
    caught = "[data-handle][aria-roledescription=point]:not([hidden]):not([data-behind])"
    seen = figure.locator(caught).all()
    names = [handle.get_attribute("data-handle") for handle in seen]
    return [figure.locator(f'[data-handle="{name}"]') for name in names]


def in_sight(figure: Any) -> None:
    figure.locator(".scene").evaluate(
        "element => element.scrollIntoView({block: 'center', behavior: 'instant'})"
    )
    settle(figure.page)


def turn(figure: Any, selector: str, keys: tuple[str, ...]) -> None:
    control = figure.locator(selector)
    control.focus()
    for key in keys:
        control.page.keyboard.press(key)


@pytest.mark.parametrize("name", EXPLORABLES)
def test_a_figure_stands_on_a_page_and_loads_little(
    name: str, pages: dict[str, str], book: Path
) -> None:
    page = book / pages[name]
    [figure] = parse(page).select(f'.explorable[data-name="{name.replace("_", "-")}"]')
    # A cache of notebooks would sort them.
    sliders = [slider["name"] for slider in figure.select("input[type=range]")]
    assert sliders == [key for key in EXPLORABLES[name].inputs if key in sliders]
    file = page.parent / figure["data-explore"]
    assert list(json.loads(file.read_bytes())["inputs"]) == list(EXPLORABLES[name].inputs)
    assert len(gzip.compress(file.read_bytes(), 9)) < 60_000


@pytest.mark.parametrize(
    "name",
    nightly(EXPLORABLES, "closed_curve_by_hand", "grab_the_spoon"),
)
def test_a_figure_moves_and_tells_true_numbers(name: str, open_figure: Callable[..., Any]) -> None:
    """One touch: the first point is dragged, or the first slider or body is moved by keys.

    By day: a figure with points, one with rings, and one with a body.
    """
    figure = live(open_figure(name))
    before = check(name, figure)
    picture = live_picture(figure)
    in_sight(figure)
    if found := handles(figure):
        touched = found[0].get_attribute("data-handle")
        mouse = figure.page.mouse
        x, y = center(found[0])
        mouse.move(x, y)
        mouse.down()
        mouse.move(x + 14, y + 9, steps=4)
        mouse.up()
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
    # A spoon that is turned keeps its way among its inputs, or takes its rings along.
    ways = {"way", "left", "along", "u", "v", "w"} if touched == "spoon" else set()
    assert changed(name, before, after) - ways == {touched}
    assert difference(picture, live_picture(figure)) > 0.01


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


# One of each kind: points and curves; two pictures; parts that turn.
LIKE_PYTHON: dict[str, dict[str, Any]] = {
    "closed_curve_by_hand": {"u": 0.7, "fraction": 0.3},
    "camera_by_hand": {"u": 0.6, "path": "curve"},
    "two_mirrors_by_hand": {"first": 20.0, "second": 75.0, "letter": -30.0},
}


@pytest.mark.parametrize("name", nightly(LIKE_PYTHON, "closed_curve_by_hand"))
def test_a_figure_looks_as_python_draws_it(name: str, open_figure: Callable[..., Any]) -> None:
    inputs = LIKE_PYTHON[name]
    figure = open_figure(name, hash=address(name, inputs), device_scale_factor=2)
    figure.page.add_style_tag(content=LIKE_A_POSTER)
    told = check(name, live(figure))
    check_picture(figure, EXPLORABLES[name](**{key: told[key] for key in EXPLORABLES[name].inputs}))


@pytest.mark.slow
@pytest.mark.parametrize("name", EXPLORABLES)
def test_a_figure_looks_as_python_draws_it_for_any_inputs(
    name: str, open_figure: Callable[..., Any]
) -> None:
    figure = open_figure(name, device_scale_factor=2)
    figure.page.add_style_tag(content=LIKE_A_POSTER)
    live(figure)
    rng = np.random.default_rng(SEED)
    for _ in range(TRIES):
        inputs = moved(rng, name)
        figure.page.evaluate("hash => { location.hash = hash; }", address(name, inputs))
        told = check(name, figure)
        if "refused" in told:
            continue
        inputs = {key: told[key] for key in inputs}
        where = f"EXPLORE_SEED={SEED}: {name}({inputs})"
        check_picture(figure, EXPLORABLES[name](**inputs), where)


@pytest.mark.slow
@pytest.mark.parametrize("name", EXPLORABLES)
def test_each_handle_by_mouse_and_keys(name: str, open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(name))
    page = figure.page
    for handle in handles(figure):
        which = handle.get_attribute("data-handle")
        in_sight(figure)
        before = check(name, figure)
        x, y = center(handle)
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x - 20, y + 12, steps=5)
        page.mouse.up()
        dragged = check(name, figure)
        assert dragged != before, which
        said = handle.get_attribute("aria-label")
        if handle.get_attribute("role") == "slider":
            handle.focus()
            page.keyboard.press("ArrowLeft")
            assert check(name, figure)[which] != dragged[which]
            assert float(handle.get_attribute("aria-valuenow")) == values(figure)[which]
            continue
        for keys, degrees in (("ArrowLeft", 2), ("Shift+ArrowUp", 10), ("Alt+ArrowRight", 0.2)):
            key, old = which.partition("-")[0], values(figure)
            handle.focus()
            page.keyboard.press(keys)
            new = check(name, figure)
            p, q = (np.reshape(told[key], (-1, 3)) for told in (old, new))
            cosines = np.sum(p * q, axis=1) / np.linalg.norm(p, axis=1) / np.linalg.norm(q, axis=1)
            assert np.degrees(np.arccos(np.clip(cosines.min(), -1, 1))) <= degrees + 1e-6
            assert cosines.min() < 1, (which, keys)
        assert handle.get_attribute("aria-label") != said
        assert "at" in said
    figure.get_by_role("button", name="Reset", exact=True).click()
    page.wait_for_timeout(700)
    assert figure.locator(".explorable-status").inner_text() == "Reset"


@pytest.mark.slow
@pytest.mark.chromium
@pytest.mark.parametrize("name", EXPLORABLES)
def test_each_handle_by_finger(name: str, open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(name, **PHONE))
    page = figure.page
    session = page.context.new_cdp_session(page)
    for handle in handles(figure):
        in_sight(figure)
        box = handle.bounding_box()
        assert min(box["width"], box["height"]) >= 44
        before, down = values(figure), page.evaluate("scrollY")
        x, y = center(handle)
        for i in range(6):
            kind = "touchStart" if i == 0 else "touchMove"
            points = [{"x": x + 4 * i, "y": y - i, "id": 0}]
            session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        assert check(name, figure) != before
        assert abs(page.evaluate("scrollY") - down) <= 1


@pytest.mark.slow
@pytest.mark.parametrize("name", EXPLORABLES)
def test_each_slider_switch_and_button(name: str, open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(name))
    page = figure.page
    start = check(name, figure)
    for slider in figure.locator("input[type=range]").all():
        key = slider.get_attribute("name")
        for press in ("Home", "ArrowRight", "End"):
            slider.focus()
            page.keyboard.press(press)
            check(name, figure)
        field = figure.locator(f'input[name="{key}-number"]')
        low, high = (float(slider.get_attribute(end)) for end in ("min", "max"))
        field.fill(f"{low + 0.25 * (high - low):g}")
        assert values(figure)[key] == pytest.approx(
            low + 0.25 * (high - low), abs=(high - low) / 16
        )
        check(name, figure)
    for control in figure.locator("input[type=checkbox], input[type=radio]:not(:checked)").all():
        control.click()
        check(name, figure)
    for button in figure.locator("button[data-action]").all():
        action = button.get_attribute("data-action")
        if action in ("play", "link", "reset"):
            continue
        before = values(figure)
        if button.is_enabled():
            button.click()
            assert check(name, figure) != before, action
    figure.get_by_role("button", name="Reset", exact=True).click()
    assert same(check(name, figure), start)


@pytest.mark.slow
@pytest.mark.parametrize("name", EXPLORABLES)
def test_play_goes_on_and_stops(name: str, open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(name))
    for button in figure.locator("[data-action=play]").all():
        key = button.get_attribute("data-input")
        slider = figure.locator(f'input[type=range][name="{key}"]')
        slider.focus()
        figure.page.keyboard.press("Home")
        first = values(figure)[key]
        button.click()
        figure.page.wait_for_timeout(1200)
        button.click()
        stopped = values(figure)[key]
        assert stopped > first
        figure.page.wait_for_timeout(300)
        assert values(figure)[key] == stopped
        check(name, figure)


@pytest.mark.slow
def test_who_wants_no_motion_gets_steps(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure("closed_curve_by_hand", reduced_motion="reduce"))
    assert not figure.get_by_role("button", name="Play").count()
    before = check("closed_curve_by_hand", figure)
    figure.get_by_role("button", name="Step").click()
    after = check("closed_curve_by_hand", figure)
    assert after["u"] == pytest.approx((np.floor(8 * before["u"]) + 1) / 8)


@pytest.mark.slow
@pytest.mark.parametrize("name", EXPLORABLES)
def test_ten_seconds_of_anything(name: str, open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure(name, script=CONTEXTS))
    page, rng = figure.page, random.Random(name)
    in_sight(figure)
    box = figure.locator(".scene").bounding_box()
    end = page.evaluate("performance.now()") + 10_000
    while page.evaluate("performance.now()") < end:
        found = handles(figure)
        if found and rng.random() < 0.8:
            page.mouse.move(*center(rng.choice(found)))
        else:
            page.mouse.move(box["x"] + rng.random() * box["width"], box["y"] + 5)
        page.mouse.down()
        for _ in range(6):
            x, y = (rng.uniform(-0.1, 1.1) for _ in "xy")
            page.mouse.move(box["x"] + x * box["width"], box["y"] + y * box["height"], steps=3)
        page.mouse.up()
        check(name, figure)
    assert lost_contexts(page) == [False]


@pytest.mark.slow
def test_beyond_the_rim_a_point_slides_along_it(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure("closed_curve_by_hand"))
    in_sight(figure)
    handle = figure.locator('[data-handle="points-2"]')
    mouse, box = figure.page.mouse, figure.locator(".scene").bounding_box()
    mouse.move(*center(handle))
    mouse.down()
    mouse.move(box["x"] + 3, box["y"] + box["height"] / 2, steps=5)
    left = check("closed_curve_by_hand", figure)["points"][2]
    mouse.move(box["x"] + box["width"] - 3, box["y"] + box["height"] / 2, steps=5)
    mouse.up()
    right = check("closed_curve_by_hand", figure)["points"][2]
    eye = np.array([4.28, 2.42, 2.51])
    for point in (left, right):
        assert np.linalg.norm(point) == pytest.approx(1)
        assert point @ eye == pytest.approx(1, abs=1e-6)
    assert np.linalg.norm(np.subtract(left, right)) > 1.5


@pytest.mark.slow
def test_a_geometry_without_an_answer_stays_pale(open_figure: Callable[..., Any]) -> None:
    opposite = "#explore-closed-curve-by-hand?points=1,0,0+0,1,0+1,0,0+0,0,1"
    figure = live(open_figure("closed_curve_by_hand", hash=opposite))
    told = check("closed_curve_by_hand", figure)
    assert "antipodal" in told["refused"]
    scene, line = figure.locator(".scene"), figure.locator(".explorable-status")
    assert line.inner_text() == f"{told['refused'].capitalize()[0]}{told['refused'][1:]}."
    numbers = " ".join(output.text_content() for output in figure.locator("output").all())
    assert set(numbers.split()) == {"–"}
    pale = float(scene.locator("canvas").evaluate("e => getComputedStyle(e).opacity"))
    assert 0.2 < pale < 0.6
    assert live_picture(figure).any()
    handle = figure.locator('[data-handle="points-2"]')
    handle.focus()
    for _ in range(4):
        figure.page.keyboard.press("Shift+ArrowRight")
    assert "refused" not in check("closed_curve_by_hand", figure)
    assert scene.get_attribute("data-refused") is None


@pytest.mark.slow
def test_a_letter_can_be_dragged_round_the_axis(open_figure: Callable[..., Any]) -> None:
    name = "two_mirrors_by_hand"
    figure = live(open_figure(name))
    in_sight(figure)
    before = check(name, figure)
    mouse = figure.page.mouse
    x, y = center(figure.locator('[data-handle="letter"]'))
    mouse.move(x, y)
    mouse.down()
    mouse.move(x + 30, y + 60, steps=5)
    mouse.up()
    after = check(name, figure)
    assert after["letter"] < before["letter"] - 10
    assert after["q"] == pytest.approx(before["q"])
    there = center(figure.locator('[data-handle="letter"]'))
    np.testing.assert_allclose(there, (x + 30, y + 60), atol=15)


@pytest.mark.slow
def test_a_mirror_is_grabbed_by_its_sheet(open_figure: Callable[..., Any]) -> None:
    """In the middle of the sheet, far from its ring, and it follows the hand."""
    name = "two_mirrors_by_hand"
    figure = live(open_figure(name))
    in_sight(figure)
    before = check(name, figure)
    mouse, box = figure.page.mouse, figure.locator(".scene").bounding_box()
    ring = np.array(center(figure.locator('[data-handle="second"]')))
    axis = np.array([box["x"] + box["width"] / 2, box["y"] + 0.47 * box["height"]])
    mouse.move(*(0.25 * axis + 0.75 * ring))
    mouse.down()
    mouse.move(box["x"] + 0.3 * box["width"], box["y"] + 0.4 * box["height"], steps=5)
    mouse.up()
    after = check(name, figure)
    assert before | {key: after[key] for key in ("second", "between", "turned", "q")} == after
    assert 90 < after["second"] < 150


@pytest.mark.slow
def test_a_chart_is_dragged_wherever_its_names_stand(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure("closed_curve_by_hand"))
    chart = figure.locator("svg[data-handle]").first
    chart.evaluate("chart => chart.scrollIntoView({block: 'end', behavior: 'instant'})")
    box, mouse = chart.bounding_box(), figure.page.mouse
    # Where the name of the second point stands, and a quarter further
    for share, height in ((0.26, 0.92), (0.51, 0.5)):
        mouse.move(box["x"] + share * box["width"], box["y"] + height * box["height"])
        mouse.down()
        mouse.move(box["x"] + (share + 0.1) * box["width"], box["y"] + 0.5 * box["height"])
        mouse.up()
        assert values(figure)["u"] == pytest.approx(share + 0.1, abs=0.01)
    assert figure.page.evaluate("getSelection().toString()") == ""


@pytest.mark.slow
def test_a_scene_of_three_turns_only_so_far(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure("euler_angles_by_hand"))
    canvas = figure.locator("canvas")
    canvas.focus()
    for _ in range(8):
        figure.page.keyboard.press("ArrowRight")
    settle(figure.page)
    there = live_picture(figure)
    figure.page.keyboard.press("ArrowRight")
    settle(figure.page)
    assert difference(there, live_picture(figure)) < 0.001


@pytest.mark.slow
def test_play_starts_over(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure("euler_angles_by_hand"))
    slider = figure.locator("input[name=t-number]")
    slider.fill("0.98")
    figure.get_by_role("button", name="Play").click()
    figure.page.wait_for_function(
        "element => JSON.parse(element.dataset.values).t < 0.5", arg=figure.element_handle()
    )
    figure.get_by_role("button", name="Pause").click()
    check("euler_angles_by_hand", figure)


@pytest.mark.slow
def test_the_status_line_forgets(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure("figure_1_by_hand"))
    line = figure.locator(".explorable-status")
    figure.locator("button[name=copy]").click()
    line.get_by_text("to the figure as it is set").or_(line.get_by_text("Link copied")).wait_for()
    turn(figure, "input[name=theta]", ("ArrowRight",))
    assert line.inner_text() == ""


@pytest.mark.slow
def test_the_status_line_says_where_the_point_came_to_lie(
    open_figure: Callable[..., Any],
) -> None:
    figure = live(open_figure("control_points_by_hand"))
    figure.locator("input[name=one_circle]").check()
    handle = figure.locator('[data-handle="points-2"]')
    before = handle.get_attribute("aria-label")
    handle.focus()
    for _ in range(4):
        figure.page.keyboard.press("Shift+ArrowRight")
        figure.page.keyboard.press("Shift+ArrowUp")
    label = handle.get_attribute("aria-label")
    assert label != before
    figure.page.wait_for_timeout(700)
    said = figure.locator(".explorable-status").inner_text()
    assert said.startswith(f"{label}. ")


@pytest.mark.slow
def test_a_link_brings_the_state_back(open_figure: Callable[..., Any]) -> None:
    name = "closed_curve_by_hand"
    figure = live(open_figure(name))
    in_sight(figure)
    assert "#" not in figure.page.url
    x, y = center(figure.locator('[data-handle="points-1"]'))
    figure.page.mouse.move(x, y)
    figure.page.mouse.down()
    figure.page.mouse.move(x - 30, y, steps=3)
    figure.page.mouse.up()
    turn(figure, "input[name=fraction]", ("Home",))
    left = check(name, figure)
    figure.locator("button[name=copy]").click()
    address = "#" + figure.page.url.partition("#")[2]
    assert "fraction=0.2" in address
    assert "u=" not in address
    found = check(name, live(open_figure(name, hash=address)))
    np.testing.assert_allclose(found["points"], left["points"], atol=1e-4)
    assert found["fraction"] == 0.2


@pytest.mark.slow
def test_reset_brings_figure_numbers_and_camera_back(open_figure: Callable[..., Any]) -> None:
    name = "closed_curve_by_hand"
    figure = live(open_figure(name))
    before = check(name, figure)
    in_sight(figure)
    # The viewer draws round lines a little smoother than Python, so it draws both pictures.
    figure.get_by_role("button", name="Reset", exact=True).click()
    settle(figure.page)
    first = live_picture(figure)
    figure.locator("canvas").focus()
    figure.page.keyboard.press("ArrowLeft")
    turn(figure, '[data-handle="points-0"]', ("Shift+ArrowDown",))
    assert check(name, figure) != before
    assert difference(first, live_picture(figure)) > 0.3
    figure.get_by_role("button", name="Reset", exact=True).click()
    assert same(check(name, figure), before)
    assert difference(first, live_picture(figure)) < 0.05


@pytest.mark.slow
def test_a_point_behind_cannot_be_caught(open_figure: Callable[..., Any]) -> None:
    figure = live(open_figure("closed_curve_by_hand"))
    figure.locator("canvas").focus()
    for _ in range(24):
        figure.page.keyboard.press("ArrowRight")
    settle(figure.page)
    behind = figure.locator("[data-handle][data-behind]")
    assert behind.count() >= 2
    style = "e => [getComputedStyle(e).pointerEvents, getComputedStyle(e).opacity]"
    events, opacity = behind.first.evaluate(style)
    assert events == "none"
    assert float(opacity) < 0.4


@pytest.mark.slow
def test_without_webgl_two_pictures_stand_side_by_side(open_figure: Callable[..., Any]) -> None:
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


def test_without_scripts_there_is_the_poster(
    site: str, pages: dict[str, str], open_page: Open
) -> None:
    page = open_page(f"{site}/{pages['closed_curve_by_hand']}", java_script_enabled=False)
    figure = page.locator('.explorable[data-name="closed-curve-by-hand"]')
    assert figure.locator(".scene-poster").is_visible()
    assert figure.locator("output[name=speed]").text_content()
    assert figure.locator("input").first.is_disabled()


def test_without_a_server_a_figure_says_how_to_move_it(
    book: Any, pages: dict[str, str], open_page: Open
) -> None:
    page = open_page((book / pages["closed_curve_by_hand"]).as_uri(), quiet=False)
    figure = page.locator('.explorable[data-name="closed-curve-by-hand"]')
    come_to(figure.locator(".scene"))
    line = figure.locator(".scene-message[role=status]")
    line.wait_for(timeout=20_000)
    assert "move this figure" in line.inner_text()
    assert "python -m http.server" in line.inner_text()


@pytest.mark.slow
@pytest.mark.parametrize("name", EXPLORABLES)
def test_axe_finds_nothing_in_the_middle_of_a_drag(
    name: str, open_figure: Callable[..., Any]
) -> None:
    figure = live(open_figure(name))
    in_sight(figure)
    found = handles(figure)
    if found:
        figure.page.mouse.move(*center(found[0]))
        figure.page.mouse.down()
        figure.page.mouse.move(400, 300)
    figure.page.add_script_tag(path=AXE)
    run = "axe.run('.explorable').then(({violations}) => violations.map(({id}) => id))"
    assert figure.page.evaluate(run) == []
