"""Figures that answer the hand: what they take, what they store, and that both sides agree.

Each run compares models and panels in Node with Python for other inputs. Set EXPLORE_SEED to the
seed in a failure's message to repeat them.
"""

import json
import os
import re
import secrets
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista
from bs4 import BeautifulSoup
from node import run_cases

from rotedu import scenes
from rotedu.errors import DegenerateError
from rotedu.figures import (
    Choice,
    Handles,
    Poses,
    Slider,
    Switch,
    describe,
    explorable,
    explore,
    read_out,
)
from rotedu.figures.explorable import FRAMES, Exploration
from rotedu.figures.frames import WHOLE, frame_of, only, place_part
from rotedu.figures.panel import panel, path_of
from rotedu.ordinary_rotation import rotate
from rotedu.scenes import averages
from rotedu.scenes import quaternions as chapter_2

ROOT = Path(__file__).parents[1]
SEED = int(os.environ.get("EXPLORE_SEED") or secrets.randbits(32))
TRIES = 3
BY_HAND = {name: f for name, f in vars(scenes).items() if hasattr(f, "inputs")}
WITH_MODEL = {name: f for name, f in BY_HAND.items() if f.model}

pytestmark = pytest.mark.filterwarnings("ignore:.* are almost ")


def moved_input(rng: np.random.Generator, kind: Any, start: Any) -> Any:
    """Another value for an input: anything but for points, which turn by up to 40 degrees."""
    if isinstance(kind, Slider):
        step = kind.spec()["step"]
        steps = round((kind.high - kind.low) / step)
        return kind.low + step * int(rng.integers(steps + 1))
    if isinstance(kind, Handles):
        points = np.array(start)
        axes = rng.normal(size=points.shape)
        return rotate(points, axes, rng.uniform(0, 0.7, points.shape[:-1])).tolist()
    if isinstance(kind, Poses):
        poses = np.array(start) + rng.normal(scale=0.3, size=np.shape(start))
        return (poses / np.linalg.norm(poses, axis=-1, keepdims=True)).tolist()
    if isinstance(kind, Switch):
        return bool(rng.integers(2))
    return str(rng.choice(kind.options))


def moved(rng: np.random.Generator, figure: Exploration) -> dict[str, Any]:
    return {
        name: moved_input(rng, kind, figure.values[name]) for name, kind in figure.inputs.items()
    }


def drawn(figure: Exploration, inputs: dict[str, Any]) -> pyvista.Plotter | dict[str, Any]:
    """The scene for some inputs, or the refusal in the words of a model."""
    try:
        return figure.draw(**inputs)
    except DegenerateError as error:
        # The viewer computes one case after the other, so it has no index to tell.
        message = re.sub(r" at index \([\d, ]*\)", "", str(error))
        return {"error": "DegenerateError", "message": message}


ON_ONE_CIRCLE = {"points": [[1, 0, 0], [0, 1, 0], [0.2, -0.5, 0.8]], "one_circle": True, "step": 4}
HALF_A_TURN = [{"v": -90.0, "t": 0.25}, {"u": 180.0, "v": 90.0, "w": 0.0, "t": 0.25}]
P = [0.6, 0, 0.8]
OPPOSITE = [{"p": P, "q": [-0.6, 0, -0.8]}, {"p": P, "q": P, "flip": True}]


def round_about(count: int) -> list[list[float]]:
    """Points round the pole, at uneven heights: symmetry would leave names without a side."""
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return [[np.cos(x), np.sin(x), 0.5 + np.sin(2 * x + 1) / 3] for x in angles]


# As many orientations as there may be, with a half turn from the third to the fourth, and fewer.
SIX = [*np.eye(4)[:3].tolist(), [0, 0.1, 1, 0], [0.5, 0.5, 0.5, 0.5], [1, 0.5, 0, 0]]
SUM_OF_ZERO = [[1, 0, 0, 0], [-0.5, 0.75**0.5, 0, 0], [-0.5, -(0.75**0.5), 0, 0]]
SPECIAL = {
    "animate": [
        {"poses": SIX[2:], "t": 1.0},
        {"poses": SIX},
        {"poses": [[1, 0.2, 0, 0], *SIX[1:]]},
    ],
    "camera_by_hand": [{"path": "curve", "roll": "kept upright", "u": 0.54}, {"u": 0.0}],
    "carried_around_by_hand": [{"t": 0.0}],
    "closed_curve_by_hand": [
        {"points": round_about(3), "u": 1.0},
        {"points": round_about(5), "u": 1.0},
        {"points": round_about(8), "u": 0.5},
    ],
    "worn_spoons_by_hand": [
        {"precision": precision, "size": size, "turns": 997.0, "repair": size == "any size"}
        for precision in ("2 decimals", "3 decimals", "16 bits", "32 bits")
        for size in ("any size", "about 2°", "about 0.02°")
    ],
    "control_points_by_hand": [
        ON_ONE_CIRCLE,
        {"step": 1.0},
        {"printed_double": True, "step": 3.5},
        {"printed_double": True},
        {"printed_axis": True},
    ],
    "double_cover_by_hand": [
        {"turns": n, "passed": passed} for n, passed in ((0, 0), (1, 0.3), (2, 1), (3, 1), (4, 2))
    ],
    "euler_angles_by_hand": [*HALF_A_TURN, {"spoon": [-0.6, 0.0, -0.8, 0.0]}],
    "figure_1_by_hand": [{"theta": 0.0}],
    "slerp_by_hand": [
        *OPPOSITE,
        {"flip": True},
        {"p": P, "q": P},
        {"p": P, "q": [-0.6, 0, -0.8], "flip": True},
    ],
    "mean_by_hand": [
        {"poses": averages.THIRDS, "flip": False},
        # A sum of zero: i, and two that add up to its opposite.
        {
            "poses": [[1, 0, 0, 0], [-0.5, 0.75**0.5, 0, 0], [-0.5, -(0.75**0.5), 0, 0]],
            "flip": False,
        },
    ],
    "spinning_by_hand": [
        *({"t": t, "h": h} for t in (0.0, 0.01, 0.6, 1.5) for h in (0.01, 0.03, 0.1)),
        {"t": 1.37, "h": 0.1, "repair": True},
    ],
    # Arrows too short to be drawn.
    "three_turns_by_hand": [{"u": 0.0, "v": -5.0, "axes": "carried along"}],
    # Without arrows and with the first of them; at home, almost and quite; the shorter way.
    "two_mirrors_by_hand": [
        *({"second": angle} for angle in (1.0, 4.0, 180.0)),
        *({"first": 355.0, "second": angle} for angle in (10.0, 170.0, 180.0)),
    ],
    "grab_the_spoon": [
        *({"way": way, "along": 1.0} for way in chapter_2.WAYS),
        {"way": "half turns U, V, W", "along": 0.0},
        {"way": "by hand", "spoon": [-1.0, 0.0, 0.0, 0.0]},
    ],
}


def answered(figure: Exploration, inputs: dict[str, Any], places: Any) -> dict[str, Any]:
    """Inputs, and for them a refusal, or the frame and the panel."""
    plotter = drawn(figure, inputs)
    if isinstance(plotter, dict):
        return {"inputs": inputs} | plotter
    seen = plotter.shown
    html = panel(figure.title, figure.inputs, inputs, seen, {})
    return {"inputs": inputs, "frame": only(frame_of(plotter), places), "panel": html}


def test_models_and_panels_show_what_python_does() -> None:
    rng = np.random.default_rng(SEED)
    figures = []
    for name, function in WITH_MODEL.items():
        figure = explore(function)
        plotter = figure.draw()
        spec = figure.spec(plotter)
        parts = spec["frame"]["parts"].items()
        places = {("parts", part, key) for part, place in parts for key in place}
        places |= {(kind, key) for kind in WHOLE for key in spec["frame"][kind]}
        changes = [{}, *SPECIAL.get(name, ()), *(moved(rng, figure) for _ in range(TRIES))]
        cases = [answered(figure, figure.values | change, places) for change in changes]
        assert sum("frame" in case for case in cases) >= 2
        figures.append({"spec": spec, "panel": figure.panel(plotter), "cases": cases})
    run_cases("models", {"seed": SEED, "figures": figures})


@pytest.mark.parametrize("change", OPPOSITE)
def test_opposite_ends_have_a_refusal_of_their_own(change: dict[str, Any]) -> None:
    figure = explore(scenes.slerp_by_hand)
    message = "the ends are antipodal: no unique arc joins them"
    refusal = {"error": "DegenerateError", "message": message}
    assert drawn(figure, figure.values | change) == refusal


@pytest.mark.parametrize("name", BY_HAND)
def test_a_figure_says_what_it_takes(name: str) -> None:
    figure = explore(BY_HAND[name])
    plotter = figure.draw()
    assert len(plotter.alt_text) > 40
    panel = BeautifulSoup(figure.panel(plotter), "html.parser")
    controls = panel.select("input[name], output[name]")
    assert controls
    for control in panel.select("input[type=range], input[type=number]"):
        assert control.get("aria-label") or panel.select(f"label[for={control['id']}]")
    for key, kind in figure.inputs.items():
        if isinstance(kind, Slider):
            assert bool(panel.select(f"input[type=range][name={key}]")) == kind.row
        assert key in dir(figure)
    outputs = {output["name"] for output in panel.select("output")}
    assert outputs == set(plotter.shown.outputs)
    assert not outputs & set(figure.inputs)
    assert json.loads(json.dumps(figure.spec(plotter)))["start"] == figure.values


def a_ball(u: float = 0.25, v: float = 0.5, points: int = 3) -> pyvista.Plotter:
    """A ball at (u, v, 0) and a strip with some points, which is as long as u."""
    plotter = pyvista.Plotter(off_screen=True, window_size=[720, 480])
    plotter.camera_position = [(0.5, 0.5, 6), (0.5, 0.5, 0), (0, 1, 0)]
    describe(plotter, "A red ball, a blue strip and a green cube.")
    ball = pyvista.Sphere(center=(u, v, 0))
    plotter.add_mesh(ball, color="red", name=place_part(plotter, "ball", at=(u, v, 0)))
    strip = np.column_stack([np.linspace(0, u, points), np.zeros((points, 2))])
    plotter.add_mesh(pyvista.MultipleLines(strip), color="blue", name="strip")
    plotter.add_mesh(pyvista.Cube(), color="green", name="still")
    read_out(plotter, "sum", u + v, "sum", 3)
    return plotter


@pytest.fixture
def few_frames(monkeypatch: pytest.MonkeyPatch) -> None:
    """Three frames for each slider, because a frame takes as long as a scene."""
    monkeypatch.setitem(FRAMES, 1, 3)
    monkeypatch.setitem(FRAMES, 2, 3)


@pytest.mark.usefixtures("few_frames")
def test_frames_hold_what_changes_and_nothing_else() -> None:
    figure = explore(a_ball, u=(0, 1))
    frames = figure.frames()
    assert len(frames) == FRAMES[1]
    assert figure.inputs["u"].step == pytest.approx(1 / (FRAMES[1] - 1))
    for u, frame in zip(np.linspace(0, 1, FRAMES[1]), frames, strict=True):
        assert set(frame["parts"]) == {"ball", "strip"}
        assert frame["parts"]["ball"] == {"at": pytest.approx([u, 0.5, 0], abs=1e-6)}
        assert set(frame["parts"]["strip"]) == {"points"}
        assert frame["outputs"] == {"sum": pytest.approx(u + 0.5)}


def test_a_frame_undoes_what_the_frames_before_it_have_changed() -> None:
    figure = explore(a_ball, u=(0, 1))
    figure.u = 1
    assert set(figure.frame()["parts"]) == {"ball", "strip"}
    back = figure.frame(u=0.25)
    assert back["parts"]["ball"] == {"at": [0.25, 0.5, 0]}
    assert back["parts"]["strip"]["points"][-1] == [0.25, 0, 0]


@pytest.mark.usefixtures("few_frames")
def test_two_sliders_make_a_grid() -> None:
    figure = explore(a_ball, u=(0, 1), v=Slider(0, 2))
    frames = figure.frames()
    places = [frame["parts"]["ball"]["at"][:2] for frame in frames]
    grid = [(u, v) for u in np.linspace(0, 1, FRAMES[2]) for v in np.linspace(0, 2, FRAMES[2])]
    np.testing.assert_allclose(places, grid, atol=1e-6)


@pytest.mark.usefixtures("few_frames")
def test_a_grid_keeps_its_order_where_keys_are_sorted() -> None:
    figure = explore(a_ball, v=(0, 2), u=(0, 1))
    spec = json.loads(json.dumps(figure.spec(figure.draw()), sort_keys=True))
    assert spec["grid"] == [["v", 3], ["u", 3]]
    assert figure.frames()[1]["parts"]["ball"]["at"] == [0.5, 0, 0]


def test_a_name_that_every_figure_has_is_refused() -> None:
    def named(start: float = 0, values: float = 0, frames: float = 0) -> pyvista.Plotter:
        return a_ball(start)

    for name in ("start", "values", "frames"):
        with pytest.raises(ValueError, match=f"^{name}: expected a name other than .*start.*, got"):
            explore(named, **{name: (0, 1)})


@pytest.mark.usefixtures("few_frames")
def test_another_number_of_points_is_refused_by_name() -> None:
    def growing(u: float = 0) -> pyvista.Plotter:
        return a_ball(u, points=3 + round(u))

    with pytest.raises(ValueError, match=r"part 'strip'.*same number of points.*3 and 4"):
        explore(growing, u=(0, 1)).frames()


@pytest.mark.usefixtures("few_frames")
def test_another_part_is_refused_by_name() -> None:
    def sudden(u: float = 0) -> pyvista.Plotter:
        plotter = a_ball(u)
        if u > 0.5:
            plotter.add_mesh(pyvista.Cone(), name="sudden cone")
        return plotter

    with pytest.raises(ValueError, match="same parts for all inputs, got sudden cone"):
        explore(sudden, u=(0, 1)).frames()


def test_three_sliders_need_a_model() -> None:
    def three(u: float = 0, v: float = 0, w: float = 0) -> pyvista.Plotter:
        return a_ball(u, v)

    figure = explore(three, u=(0, 1), v=(0, 1), w=(0, 1))
    with pytest.raises(ValueError, match="a model or at most two sliders, got u, v, w"):
        figure.spec(figure.draw())
    with pytest.raises(ValueError, match="at least one input"):
        explore(a_ball)


KINDS = {
    "u": Slider(0, 1),
    "one": Handles("P"),
    "some": Handles(["P", "Q", "R"], least=2, most=3),
    "on": Switch("on"),
    "way": Choice("way", ["short", "long"]),
}


@pytest.mark.parametrize(
    ("name", "given", "message"),
    [
        ("u", 2, "u: expected 0 to 1, got 2"),
        ("u", float("nan"), "u: expected 0 to 1, got nan"),
        ("one", [1, 2], r"one: expected shape \(3,\), got \(2,\)"),
        ("one", [0, 0, 0], "one: expected finite points other than the origin"),
        ("one", [0, np.inf, 0], "one: expected finite points other than the origin"),
        ("some", [1, 0, 0], r"some: expected shape \(n, 3\), got \(3,\)"),
        ("some", np.eye(3)[:1], "some: expected 2 to 3 points, got 1"),
        ("on", "yes", "on: expected True or False, got 'yes'"),
        ("way", "round", "way: expected one of short, long, got 'round'"),
    ],
)
def test_values_that_no_control_could_take_are_refused(name: str, given: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        KINDS[name].value(name, given)


def test_points_come_back_with_their_length() -> None:
    assert Handles("P").value("p", [0, 3, 4]) == pytest.approx([0, 0.6, 0.8])
    assert Handles("P", length=0).value("p", [0, 3, 4]) == [0, 3, 4]


def test_inputs_are_attributes() -> None:
    figure = explore(a_ball, u=(0, 1))
    assert figure.u == 0.25
    figure.u = 0.75
    assert figure.values == {"u": 0.75}
    assert figure.draw().shown.outputs["sum"].value == 1.25
    with pytest.raises(ValueError, match="u: expected 0 to 1, got 3"):
        figure.u = 3
    with pytest.raises(AttributeError, match="w: expected one of u"):
        figure.w = 1
    with pytest.raises(AttributeError, match="w: expected one of u"):
        _ = figure.w
    points = explore(scenes.closed_curve_by_hand).points
    np.testing.assert_allclose(np.linalg.norm(points, axis=1), 1)


def test_a_declared_input_can_be_given_other_bounds() -> None:
    declare: Callable[..., Any] = explorable(u=Slider(0, 1), v=Slider(0, 1))
    figure = explore(declare(a_ball), u=(0.2, 0.3))
    assert (figure.inputs["u"].low, figure.inputs["v"].high) == (0.2, 1)
    del a_ball.inputs, a_ball.model


@pytest.mark.parametrize(
    ("heights", "arrows"),
    [
        ([0.5, 0.9, 0.1, 0.5], []),
        # What only rounding puts beyond an edge is on it.
        ([-2e-16, 0.5, 0.5, 1 + 3e-16], []),
        (
            [2, 2, 0.5, -1, 0.5],
            ["36.0,7.0 40.0,0.0 44.0,7.0", "236.0,121.0 240.0,128.0 244.0,121.0"],
        ),
        ([[0.5, 0.5, 0.5, 3], [0.5] * 4], ["156.0,7.0 160.0,0.0 164.0,7.0"]),
        (None, []),
    ],
)
def test_an_arrow_stands_where_a_curve_leaves_its_chart(heights: Any, arrows: list[str]) -> None:
    paths = path_of(heights, (0, 1)).split("M")[1:]
    assert [path for path in paths if len(path.split()) == 3] == arrows


@pytest.mark.parametrize("pose", HALF_A_TURN)
def test_half_a_turn_away_the_three_angles_go_on_alone(pose: dict[str, float]) -> None:
    figure = explore(scenes.euler_angles_by_hand)
    inputs = figure.values | pose
    frame = frame_of(figure.draw(**inputs))
    assert "half a turn" in frame["outputs"]["by_slerp"]
    assert [frame["parts"][f"{name} tip"]["hidden"] for name in ("angles", "slerp")] == [
        False,
        True,
    ]
    figure.v = pose["v"]
    assert "data-curve" in figure.panel(figure.draw())


def test_a_curve_has_the_colour_of_its_name() -> None:
    """As a colour of text, which pages give a shade of their own."""
    figure = explore(scenes.worn_spoons_by_hand)
    panel = BeautifulSoup(figure.panel(figure.draw()), "html.parser")
    names = {
        name.text: re.sub("; top:.*", "", str(name["style"]))
        for name in panel.select(".explorable-names span")
    }
    assert len(names) >= 2
    assert not panel.select("figcaption span")
    assert {curve["data-curve"]: curve["style"] for curve in panel.select("[data-curve]")} == names


@pytest.mark.parametrize("repair", [False, True])
def test_a_chart_is_there_while_it_has_a_curve(repair: bool) -> None:
    """What is off has a number even so: by how much lengths, or by how many degrees."""
    figure = explore(scenes.worn_spoons_by_hand)
    plotter = figure.draw(repair=repair)
    chart = BeautifulSoup(figure.panel(plotter), "html.parser").select_one("[data-chart]")
    assert chart.has_attr("hidden") != repair
    numbers = [number.text for number in chart.select(".explorable-ticks span")]
    assert [numbers[0], numbers[-1]] == ["10⁻⁸", "100"]
    edges = np.array(plotter.shown.outputs["matrix_edges"].value)
    off = plotter.shown.outputs["matrix_off"].value
    assert off == ("5.5°" if repair else f"{100 * abs(edges - 1).max():.0f} % in length")


def test_a_number_is_named_in_the_colour_of_its_arrow() -> None:
    figure = explore(scenes.figure_1_by_hand)
    plotter = figure.draw()
    panel = BeautifulSoup(figure.panel(plotter), "html.parser")
    for k, name in enumerate(("first", "along", "across"), 1):
        label = panel.select_one(f"output[name={name}]").parent.span
        color = plotter.actors[f"term {k}"].prop.color.hex_rgb
        assert label["style"] == f"color: {color}"
    assert not panel.select_one("output[name=matrix]").parent.span.has_attr("style")


def test_a_curve_in_pieces_has_gaps_and_marks() -> None:
    figure = explore(scenes.closed_curve_by_hand)
    panel = BeautifulSoup(figure.panel(figure.draw()), "html.parser")
    speeds, curvatures = panel.select("[data-chart]")
    for chart in (speeds, curvatures):
        paths = str(chart.select_one("[data-curve]")["d"]).split("M")[1:]
        pieces = [path for path in paths if len(path.split()) > 3]
        assert [float(piece.split(",")[0]) for piece in pieces] == [0, 80, 160, 240]
        assert [float(piece.split()[-1].split(",")[0]) for piece in pieces] == [80, 160, 240, 320]
        seen = [mark.text for mark in chart.select(".explorable-marks span:not([hidden])")]
        assert seen == ["P0", "P1", "P2", "P3"]
    lines = {line["data-tick"]: float(line["y1"]) for line in curvatures.select("[data-tick]")}
    assert lines == {"-6": 128, "-3": 96, "0": 64, "3": 32, "6": 0}
    numbers = curvatures.select(".explorable-ticks span")
    assert [(n.text, n["style"]) for n in numbers[:2]] == [
        ("−6", "top: 100.0%"),
        ("−3", "top: 75.0%"),
    ]
    assert [n.text for n in speeds.select(".explorable-ticks span")] == ["0", "50", "100", "150"]
    assert [n.text for n in speeds.select(".explorable-axis span")] == ["0", "once round, u", "1"]
