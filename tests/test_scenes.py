"""The figures in three dimensions: they show what their functions promise."""

import gzip
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import pyvista
from explorables import states, turn_of
from nightly import nightly
from scipy.spatial.transform import Rotation, Slerp

from rotedu import colors, scenes
from rotedu.arcs import angle_between
from rotedu.control_points import bisect, control_points, double
from rotedu.figures.backend import scene_labels, seen_from, still_picture, take_poster
from rotedu.figures.gltf import scene_gltf
from rotedu.figures.pages import in_two, light_poster
from rotedu.figures.state import record_of
from rotedu.ordinary_rotation import rotate
from rotedu.scenes import control_points as construction
from rotedu.scenes.balance import WORKS
from rotedu.scenes.ordinary_rotation import VECTOR_BY_HAND
from rotedu.scenes.room import camera

SCENES = [
    function
    for function in vars(scenes).values()
    if getattr(function, "__annotations__", {}).get("return") is pyvista.Plotter
    and function is not scenes.two_curves
]

TARGETS = scenes.CAMERA_TARGETS / np.linalg.norm(scenes.CAMERA_TARGETS, axis=1, keepdims=True)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_a_scene_says_what_it_shows_and_keeps_its_labels_in_the_picture(scene) -> None:
    plotter = scene()
    assert isinstance(plotter, pyvista.Plotter)
    assert len(plotter.alt_text) > 40
    labels = scene_labels(plotter)
    assert labels
    places = plotter.record.labels
    for label in labels:
        assert 0.01 < label["left"] < 0.99
        assert 0.01 < label["top"] < 0.99
        assert label["hidden"] == (places[label["name"]] is None)


def test_a_sphere_fills_its_picture_also_on_a_phone() -> None:
    """On a screen of 360 pixels a scene has 328 of them."""
    found = 0
    rim = np.linspace(0, 2 * np.pi, 360)
    # Five films are one row, and small figures are low.
    others = {scenes.animate} | {scene for scene in SCENES if getattr(scene, "small", False)}
    for plotter in (scene() for scene in SCENES if scene not in others):
        if not hasattr(plotter, "ball"):
            continue
        stack = record_of(plotter).stack or {"rows": [{"from": [0, 0, 1, 1], "to": [0, 0, 1, 1]}]}
        eye = np.array(plotter.camera.position)
        distance = np.linalg.norm(eye)
        side = np.cross(eye, [0, 0, 1])
        side /= np.linalg.norm(side)
        radius = np.sqrt(1 - 1 / distance**2)
        circle = eye / distance**2 + radius * (
            np.outer(np.cos(rim), side) + np.outer(np.sin(rim), np.cross(side, eye) / distance)
        )
        # A phone of 360 x 640 pixels has 528 of them below the head of the page.
        assert stack.get("aspect", 1) >= 328 / 528
        row = next(row for row in stack["rows"] if inside(plotter, circle, row).all())
        x, _ = in_picture(plotter, circle)
        assert np.ptp(x) / row["from"][2] * row["to"][2] * 328 >= 0.7 * 360
        found += 1
    assert found > 13


@pytest.mark.parametrize("scene", [s for s in SCENES if getattr(s, "small", False)])
def test_a_small_figure_is_small(scene: Any) -> None:
    assert len(scene.inputs) == 1
    assert not scene.tries
    for inputs in ({}, scene.answer):
        plotter = scene(**inputs)
        assert 150 <= plotter.window_size[1] <= 300
        assert len(record_of(plotter).outputs) <= 1
        assert len(light_poster(take_poster(plotter))) <= 25_000
        # All that is its own: the spoon is a file that figures share.
        assert len(gzip.compress(in_two(scene_gltf(plotter))[0])) <= 12_000


def in_picture(plotter: pyvista.Plotter, points: np.ndarray) -> np.ndarray:
    """Return where points are, as shares of the width and height, shape (2, n)."""
    width, height = plotter.window_size
    lens = plotter.camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
    x, y, _, w = pyvista.array_from_vtkmatrix(lens) @ np.vstack([points.T, np.ones(len(points))])
    return np.stack([(1 + x / w) / 2, (1 - y / w) / 2])


def inside(plotter: pyvista.Plotter, points: np.ndarray, row: dict[str, list[float]]) -> np.ndarray:
    """Tell which points a row of a stack shows."""
    left, top, width, height = row["from"]
    x, y = in_picture(plotter, points)
    return (left < x) & (x < left + width) & (top < y) & (y < top + height)


def test_figure_1_turns_its_vector() -> None:
    vector, axis = np.array([1, -0.3, 0.75]), np.array([-0.15, 0.1, 1])
    plotter = scenes.figure_1()
    turn = np.radians(75) * axis / np.linalg.norm(axis)
    turned = Rotation.from_rotvec(turn).apply(vector)
    for name in ("turned", "term 3"):
        np.testing.assert_allclose(plotter.record.parts[name]["to"], turned)


def tilted() -> Iterator[dict[str, Any]]:
    """Inputs of Figure 1, with its axis and its vector in any direction."""
    rng = np.random.default_rng(1)
    for vector, axis in rng.normal(size=(20, 2, 3)):
        vector *= np.linalg.norm(VECTOR_BY_HAND) / np.linalg.norm(vector)
        theta, around = rng.uniform(0, 360, 2)
        yield {"vector": vector, "drawn": 3, "axis": axis, "theta": theta, "around": around}


@pytest.mark.parametrize(
    ("name", "cases"),
    [
        ("figure_1_by_hand", [*tilted()]),
        ("the_balance_of_works", [{"work": w, "decades": n} for w in WORKS for n in range(5)]),
    ],
)
def test_what_moves_far_stays_in_the_picture(name: str, cases: list[dict[str, Any]]) -> None:
    plotter = getattr(scenes, name)()
    for state in states(name, cases):
        parts = [part for part in state["parts"].values() if not part.get("hidden")]
        places = [place for part in parts for place in part.values() if np.size(place) > 1]
        points = np.vstack([np.reshape(p, (-1, 3)) for p in places if np.size(p) % 3 == 0])
        assert np.abs(in_picture(plotter, points) - 0.5).max() < 0.5


@pytest.mark.parametrize("path", ["arcs", "curve"])
def test_the_path_of_the_camera_leads_through_its_targets(path: str) -> None:
    [way] = states("camera_by_hand", [{}])[0]["parts"][path]["paths"]
    assert np.linalg.norm(way - TARGETS[:, None], axis=2).min(axis=1).max() < 1e-5


def test_the_camera_looks_ahead_and_stands_upright() -> None:
    direction = np.array([0.6, 0, 0.8])
    points = camera(direction, size=1).points
    left = np.array([0, 1, 0])
    frame = np.column_stack([direction, left, np.cross(direction, left)])
    np.testing.assert_allclose((points @ frame).max(axis=0), [0.7, 0.35, 0.32], atol=2e-3)
    np.testing.assert_allclose((points @ frame).min(axis=0), [-0.7, -0.35, -0.32], atol=2e-3)


def test_the_teaspoon_is_a_closed_surface_but_for_its_ends() -> None:
    spoon = scenes.teaspoon(stations=31, around=12)
    assert spoon.n_points == 31 * 12
    assert spoon.is_manifold or spoon.n_open_edges == 2 * 12


def meshes(plotter: pyvista.Plotter, color: str) -> list[pyvista.PolyData]:
    actors = [a for a in plotter.actors.values() if isinstance(a, pyvista.Actor)]
    return [a.mapper.dataset for a in actors if a.prop.color == pyvista.Color(color)]


@pytest.mark.parametrize("between", [-70, 0, 50, 60, 90, 180])
def test_two_mirrors_turn_the_letter_by_twice_their_angle(between: float) -> None:
    inputs = {"first": 80, "second": (80 + between) % 360, "both": 33, "letter": 140}
    [state] = states("two_mirrors_by_hand", [inputs])
    names = ("letter", "image", "image of the image")
    before, mirrored, after = (turn_of(state, name) for name in names)
    assert np.isclose(np.linalg.det(mirrored), -1)
    turned = Rotation.from_euler("z", [[140], [140 + 2 * between]], degrees=True).as_matrix()
    np.testing.assert_allclose([before, after], turned, rtol=0, atol=1e-14)


def half_of_ribbon(done: float) -> np.ndarray:
    """The border and the middle of the ribbon, from the spoon to the bar, shape (2, n, 3)."""
    [state] = states("the_ribbon", [{"done": done}])
    return np.reshape(state["parts"]["one half"]["points"], (2, -1, 3))


@pytest.mark.parametrize("done", [0, 0.3, 1, 1.5, 2, 3])
def test_the_ribbon_has_the_twists_that_are_said(done) -> None:
    border, middle = half_of_ribbon(done)
    across = border - middle
    np.testing.assert_allclose(middle[:, :2], 0, atol=1e-5)
    angle = np.unwrap(np.arctan2(across[:, 1], across[:, 0]))
    twists = done if done <= 2 else 0
    assert np.isclose((angle[0] - angle[-1]) / (2 * np.pi), twists, atol=1e-5)


@pytest.mark.parametrize(
    "done", nightly((0, 0.03, 0.3, 0.6, 0.9, 1, 2, 2.03, 2.3, 2.6, 2.9, 3), 2.3)
)
def test_the_ribbon_meets_neither_itself_nor_the_spoon(done) -> None:
    border, middle = half_of_ribbon(done)
    far = np.linalg.norm(middle, axis=1)
    ribbon = np.stack([border, middle])
    distances = np.linalg.norm(ribbon[:, :, None, None] - ribbon[None, None], axis=-1)
    along = np.abs(far[:, None] - far)[None, :, None]
    apart = np.broadcast_to(along > 0.15, distances.shape)
    assert distances[apart].min() > 0.13
    # The spoon turns with the ribbon's end: only farther out do they differ.
    spoon = np.linalg.norm(points_of("the_ribbon", "spoon"), axis=1).max()
    assert spoon < 0.5 < far[-1]
    held = far < 0.5
    width = 0.13 * rotate([-1, 0, 0], [0, 0, 1], 2 * np.pi * min(done, 2))
    np.testing.assert_allclose((border - middle)[held], np.tile(width, (held.sum(), 1)), atol=1e-6)


@pytest.mark.parametrize("done", [0, 0.5, 1.25, 2, 2.25, 2.5, 3])
def test_what_is_grabbed_is_the_spoon_and_then_the_ribbon(done) -> None:
    [state] = states("the_ribbon", [{"done": done}])
    path = np.array(state["grips"]["done"]["path"])
    ring = path[round((len(path) - 1) * done / 3)]
    if done <= 2:
        there = rotate([0.46, 0, 0], [0, 0, 1], 2 * np.pi * done)
        np.testing.assert_allclose(ring, there, atol=1e-6)
    else:
        line = pyvista.MultipleLines(half_of_ribbon(done)[1])
        _, nearest = line.find_closest_cell(ring, return_closest_point=True)
        assert np.linalg.norm(nearest - ring) < 0.01


def points_of(scene: str, part: str) -> np.ndarray:
    """The points of a part of a scene, before anything moves it."""
    return getattr(scenes, scene)().actors[part].mapper.dataset.points


THICK = 0.09
ARMS = [round(0.05 * k, 2) for k in range(41)]


@pytest.mark.parametrize("turns", nightly(ARMS, 0, 0.7, 1.4, 2))
def test_the_arm_meets_neither_itself_nor_what_it_holds(turns) -> None:
    [state] = states("plate_and_arm", [{"turns": turns}])
    parts = state["parts"]
    halves = (parts[f"{name} half"]["points"] for name in ("one", "other"))
    lines = np.vstack([np.reshape(half, (12, -1, 3)) for half in halves])
    middle = lines.mean(axis=0)
    rings = np.linalg.norm(lines - middle, axis=2)
    np.testing.assert_allclose(rings, THICK, atol=0.01)
    steps = np.linalg.norm(np.diff(middle, axis=0), axis=1)
    along = np.concatenate([[0], np.cumsum(steps)])
    apart = along - along[:, None] > 0.5
    assert np.linalg.norm(middle - middle[:, None], axis=2)[apart].min() > 4 * THICK
    # Plate and spoon lie within a flat cylinder, which the arm goes round.
    held = np.vstack([points_of("plate_and_arm", part) for part in ("plate", "spoon")])
    (low, high), out = (held[:, 2].min(), held[:, 2].max()), np.hypot(*held[:, :2].T).max()
    tray = np.reshape(parts["plate"]["matrix"], (4, 4))[3, :3]
    across, up = np.hypot(*(middle - tray)[:, :2].T), (middle - tray)[:, 2]
    clear = np.hypot(np.maximum(across - out, 0), np.maximum(np.maximum(up - high, low - up), 0))
    assert clear.min() > THICK
    # No bend is so tight that the skin would fold.
    tangents = np.diff(middle, axis=0) / steps[:, None]
    bends = np.arccos(np.clip((tangents[1:] * tangents[:-1]).sum(axis=1), -1, 1))
    assert (bends * THICK < steps[1:]).all()


@pytest.mark.parametrize(("turns", "side"), [(0.4, -1), (0.8, -1), (1.2, 1), (1.6, 1)])
def test_the_arm_goes_below_the_plate_and_then_over_it(turns, side) -> None:
    [state] = states("plate_and_arm", [{"turns": turns}])
    tray = np.reshape(state["parts"]["plate"]["matrix"], (4, 4))[3, :3]
    seen = np.array(state["parts"]["one half"]["points"]) - tray
    # What is near the upright through the plate, but not held.
    beside = seen[(np.hypot(*seen[:, :2].T) < 1) & (np.linalg.norm(seen, axis=1) > 0.7)]
    assert side * beside[np.argmax(abs(beside[:, 2])), 2] > 0.3


@pytest.mark.parametrize(("turns", "farthest"), [(0, 0), (0.5, 0.5), (1, 1), (1.6, 0.4), (2, 0)])
def test_the_path_of_the_arm_reaches_the_skin_after_one_turn_and_shrinks(turns, farthest) -> None:
    [state] = states("plate_and_arm", [{"turns": turns}])
    assert np.linalg.norm(state["parts"]["end"]["at"]) == pytest.approx(farthest, abs=1e-6)
    runs = state["parts"]["path"].get("paths", [[[0, 0, 0]]])
    assert len(runs) == 1
    assert np.linalg.norm(runs[0], axis=1).max() < farthest + 0.11


@pytest.mark.parametrize(
    ("misprints", "wrong"), [([], []), (["printed_axis"], [1, 2, 3]), (["printed_double"], [3])]
)
def test_what_a_misprint_makes_wrong_is_red(misprints: list[str], wrong: list[int]) -> None:
    plotter = scenes.control_points_by_hand(step=4, **dict.fromkeys(misprints, True))
    inks = [colors.CROSS, colors.CROSS, colors.RESULT, colors.RESULT]
    names = construction.REFLECTED, construction.MIDDLE, construction.A, construction.B
    for k, (name, ink) in enumerate(zip(names, inks, strict=True)):
        meant = pyvista.Color(colors.WRONG if k in wrong else ink)
        assert {plotter.actors[part].prop.color for part in (name, f"path {k}")} == {meant}
    seen = [label for label in scene_labels(plotter) if label["position"]]
    named = {label["color"] for label in seen if label["text"] in names}
    assert named == {plotter.actors[name].prop.color.hex_rgb for name in names}


@pytest.mark.parametrize("degrees", [120, 295, 305])
def test_points_behind_the_sphere_are_named_within_it(degrees: float) -> None:
    plotter = scenes.control_points_by_hand(**construction.ahead(degrees))
    told = [label["position"] for label in scene_labels(plotter)]
    places = np.array([place for place in told if place])
    behind = places @ plotter.camera.position < 0
    assert 1 <= behind.sum() < len(behind) == 8
    np.testing.assert_array_equal(np.linalg.norm(places, axis=1) < 1, behind)


def test_construction_of_figures_3_to_7_is_that_of_control_points() -> None:
    points = np.random.default_rng(3).normal(size=(3, 3))
    found = construction.neighbours(points)
    a, b = control_points(points)
    np.testing.assert_allclose(found[construction.A], a[1], atol=1e-14)
    np.testing.assert_allclose(found[construction.B], b[1], atol=1e-14)


def test_reversed_axis_is_that_of_5_9_as_printed() -> None:
    p = TARGETS
    reflected, after = double(np.roll(p, 1, axis=0), p), np.roll(p, -1, axis=0)
    printed = np.cross(after, reflected)
    middle = rotate(reflected, printed, angle_between(reflected, after) / 2)
    a, b = construction.astray(p)
    np.testing.assert_allclose(a, bisect(p, middle), atol=1e-14)
    np.testing.assert_allclose(b, double(a, p), atol=1e-14)


def test_who_rides_on_the_camera_sees_what_its_frame_shows() -> None:
    plotter = scenes.camera_by_hand(u=0.6, path="curve")
    looks, _, up = plotter.actors["camera"].user_matrix[:3, :3].T
    with seen_from(plotter, "ride"):
        camera = plotter.camera
        assert camera.position == (0, 0, 0)
        np.testing.assert_allclose(camera.focal_point, looks, atol=1e-12)
        np.testing.assert_allclose(camera.up, up, atol=1e-12)
        own = scene_labels(plotter, "ride")
        unseen = [name for name, actor in plotter.actors.items() if not actor.GetVisibility()]
        assert {"camera", "edges", "up-labels", "door-labels"} <= set(unseen)
    assert plotter.camera.position == pytest.approx((5.1, -0.3, 2.3))
    assert plotter.actors["camera"].visibility
    names = {label["name"] for label in own}
    horizon = {f"horizon {k}" for k in range(5)}
    assert names == {f"{name} seen" for name in scenes.CAMERA_SEES} | horizon | {"straight up"}
    assert not names & {label["name"] for label in scene_labels(plotter)}
    for label in own:
        ahead = np.array(label["position"]) @ looks
        assert ahead > 0 or label["hidden"]


def test_a_still_picture_shows_all_views(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pyvista, "OFF_SCREEN", True)
    width, height = still_picture(scenes.camera_by_hand()).size
    assert (width, height) == (960, 480)


def test_one_path_of_the_camera_is_thick() -> None:
    for path, other in (("arcs", "curve"), ("curve", "arcs")):
        actors = scenes.camera_by_hand(path=path).actors
        seen = {name: actors[name].visibility for name in (path, other, f"other {other}")}
        assert seen == {path: True, other: False, f"other {other}": True}


@pytest.mark.parametrize("path", ["arcs", "curve"])
def test_the_chart_of_the_spin_is_that_of_an_upright_camera(path: str) -> None:
    upright = {"path": path, "roll": "kept upright"}
    first, *others = states(
        "camera_by_hand", [{"path": path}, *(upright | {"u": (2 + k / 12) / 4} for k in (0, 6, 11))]
    )
    shown = [first["charts"]["spins"]["spin"][2][k] for k in (0, 6, 11)]
    assert shown == pytest.approx([state["outputs"]["spin"] for state in others], abs=1e-5)


def test_speed_jumps_on_arcs_and_not_on_the_curve() -> None:
    speeds = states("camera_by_hand", [{}])[0]["charts"]["speeds"]
    jumps = {
        name: np.subtract(s, np.roll(s, 1, axis=0)[:, [-1]])[:, 0] for name, s in speeds.items()
    }
    assert abs(jumps["curve"]).max() < 1e-4
    lengths = np.degrees(np.arccos(np.sum(TARGETS * np.roll(TARGETS, -1, axis=0), axis=1)))
    np.testing.assert_allclose(jumps["arcs"], lengths - np.roll(lengths, 1), atol=1e-4)


def test_curvature_in_the_chart_jumps_as_told() -> None:
    [state] = states("closed_curve_by_hand", [{}])
    told, charts = state["outputs"], state["charts"]
    pieces = np.array(charts["curvatures"]["curve"])
    jumps = abs(pieces[:, 0] - np.roll(pieces[:, -1], 1))
    assert jumps == pytest.approx(np.array(told["curvature_jumps"]), abs=1e-5)
    speeds = np.array(charts["speeds"]["curve"])
    assert told["speed_range"] == pytest.approx([speeds.min(), speeds.max()])
    assert (jumps > 0.5).sum() == 3


def test_the_comb_of_figure_8_is_as_long_as_the_curvature_and_on_the_outer_side() -> None:
    [state] = states("closed_curve_by_hand", [{"u": 1}])
    hairs = np.array(state["parts"]["comb"]["paths"])
    points, tips = hairs[:, 0], hairs[:, 1]
    bends = np.ravel(state["charts"]["curvatures"]["curve"])
    lengths = np.arccos(np.sum(points * tips, axis=1).clip(-1, 1))
    np.testing.assert_allclose(lengths, np.minimum(0.09 * abs(bends), 0.5), atol=1e-6)
    # The middle of its bend is on the side where the neighbours are, and the hair on the other.
    n = len(bends) // 4
    for arc, ends, bend in zip(*(x.reshape(4, n, -1) for x in (points, tips, bends)), strict=True):
        inwards = arc[:-2] + arc[2:] - 2 * arc[1:-1]
        inwards -= np.sum(inwards * arc[1:-1], axis=1, keepdims=True) * arc[1:-1]
        bent = abs(bend[1:-1, 0]) > 0.3
        assert (np.sum(inwards * (ends - arc)[1:-1], axis=1)[bent] < 0).all()


def test_four_ways_between_are_those_of_scipy() -> None:
    ends = scenes.TWO_ORIENTATIONS
    plotter = scenes.four_ways_between()
    given = Rotation.from_euler("xyz", ends, degrees=True)
    tip, t = np.array([1, 0, 0]), np.linspace(0, 1, 97)
    angles = ends[0] + t[:, None] * np.subtract(ends[1], ends[0])
    turn = (given[0].inv() * given[1]).as_rotvec()
    # The rest of the full turn, the other way round.
    long = turn * (1 - 2 * np.pi / np.linalg.norm(turn))
    ways = {
        colors.RESULT: Slerp([0, 1], given)(t).apply(tip),
        colors.CROSS: Rotation.from_euler("xyz", angles, degrees=True).apply(tip),
        colors.NEUTRAL: (given[0] * Rotation.from_rotvec(t[:, None] * long)).apply(tip),
    }
    for ink, way in ways.items():
        # A line is a tube around the path of the tip.
        line = max(meshes(plotter, ink)[ink == colors.NEUTRAL :], key=lambda mesh: mesh.n_points)
        apart = np.linalg.norm(line.points[:, None] - way, axis=-1)
        assert apart.min(axis=1).max() < 0.02, ink
        # Dashes leave out a few steps.
        assert apart.min(axis=0).max() < 0.1, ink


def test_beads_lie_where_both_are_after_each_eighth_of_the_time() -> None:
    plotter = scenes.four_ways_between()
    first, last = Rotation.from_euler("xyz", scenes.TWO_ORIENTATIONS, degrees=True)
    q, r = (turn.as_quat() for turn in (first, last))
    t = np.arange(1, 8)[:, np.newaxis] / 8
    mixed = Rotation.from_quat((1 - t) * q + t * np.sign(q @ r) * r)
    even = Slerp([0, 1], Rotation.concatenate([first, last]))(t[:, 0])
    for turns, ink, most in ((mixed, colors.CROSS, 100), (even, colors.RESULT, 250)):
        small = [np.mean(m.points, axis=0) for m in meshes(plotter, ink) if m.n_points < most]
        found = np.array(small) / np.linalg.norm(small, axis=1, keepdims=True)
        np.testing.assert_allclose(found, turns.apply([1, 0, 0]), atol=1e-6)
