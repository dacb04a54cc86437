"""What to try in a figure: each chip leads to a state that shows what the page says it does.

A new chip gets a row here: the words on it, and the numbers on which its discovery rests, as a
reader sees them; `test_outputs.py` computes them in another way. What else a discovery rests on, a
test below does.
"""

from itertools import pairwise, product
from typing import Any

import numpy as np
import pytest
from explorables import EXPLORABLES, outputs, panels, states
from scipy.interpolate import CubicSpline
from scipy.linalg import expm, polar
from scipy.spatial.transform import Rotation

from rotedu.arcs import angle_between
from rotedu.control_points import control_points
from rotedu.figures.explorable import Explorable
from rotedu.quaternions import Quaternion
from rotedu.scenes.conclusions import random_turns
from rotedu.scenes.orientations import FILMS

# Figure, words on the chip, outputs.
SHOWN: list[tuple[str, str, dict[str, str]]] = [
    # In the order of the films: slerp, squad, spline of q, the paper's, spline of M.
    ("animate", "small turns", {"fastest": "39, 53, 51, 50, 53°/s", "corner": "62°/s"}),
    ("animate", "one sign changed", {"fastest": "250, 749, 494, 188, 1720°/s"}),
    ("animate", "two poses alike", {"speed": "6, 56, 79, 82, 36°/s"}),
    ("animate", "handles of one third", {"jumps": "478, 438°/s²"}),
    ("arcs_of_arcs", "close to the start", {"way_1": "3.1°", "way_2": "6.1°", "way_3": "8.9°"}),
    ("arcs_of_arcs", "even closer", {"way_1": "0.6°", "way_2": "1.2°", "way_3": "1.8°"}),
    ("arcs_of_arcs", "half of every arc", {"way_1": "30.7°", "way_2": "52.7°", "way_3": "62.9°"}),
    (
        "routes_by_hand",
        "a swing to 90°",
        {"turn": "170.0°", "apart": "0.0°", "signs": "can agree"},
    ),
    (
        "routes_by_hand",
        "a swing to 100°",
        {"turn": "190.0°", "apart": "39.9°", "signs": "can agree"},
    ),
    (
        "routes_by_hand",
        "once right round",
        {"turn": "0.0°", "apart": "0.0°", "signs": "cannot agree"},
    ),
    (
        "slerp_by_hand",
        "nlerp hurries in the middle",
        {"angle": "150.0°", "way": "300.0°", "speed": "2.85"},
    ),
    (
        "slerp_by_hand",
        "flip the sign of the end",
        {"angle": "30.0°", "way": "60.0°", "speed": "1.02"},
    ),
    (
        "slerp_by_hand",
        "just before the opposite point",
        {"angle": "172.6°", "way": "345.2°", "speed": "10.27"},
    ),
    (
        "slerp_by_hand",
        "just past it",
        {"angle": "172.5°", "way": "345.0°", "speed": "10.12"},
    ),
    (
        "carried_around_by_hand",
        "there and back",
        {"twist": "−4.2°", "area": "−4.2°", "difference": "0°"},
    ),
    (
        "carried_around_by_hand",
        "the arrow comes back reversed",
        {"twist": "180.0°", "area": "180.0°", "difference": "0°"},
    ),
    (
        "carried_around_by_hand",
        "an even larger triangle",
        {"twist": "−120.1°", "area": "239.9°", "difference": "360°"},
    ),
    (
        "carried_around_by_hand",
        "clockwise",
        {"twist": "−90.0°", "area": "−90.0°", "difference": "0°"},
    ),
    (
        "closed_curve_by_hand",
        "where the curvature jumps most",
        {"velocity_jump": "0.0°/s", "curvature_jump": "1.52"},
    ),
    (
        "closed_curve_by_hand",
        "two points close together",
        {"curvature_jump": "1.77", "speed_range": "1, 90°/s"},
    ),
    (
        "closed_curve_by_hand",
        "points on a great circle",
        {"curvature_jump": "0.00", "speed_range": "68, 135°/s"},
    ),
    (
        "closed_curve_by_hand",
        "the same, a third of the way",
        {"curvature_jump": "0.00", "speed_range": "90, 90°/s"},
    ),
    (
        "camera_by_hand",
        "the corner at the clock",
        {"rolled": "0°", "bends": "door 36°, clock 82°, window 30°, desk 89°"},
    ),
    (
        "camera_by_hand",
        "once round along the curve",
        {"rolled": "166°", "bends": "door 0°, clock 0°, window 0°, desk 0°"},
    ),
    (
        "camera_by_hand",
        "who turns it past the window?",
        {"rolled": "0°", "spin": "−523°/s"},
    ),
    ("control_points_by_hand", "the three points alone", {"now": "0 three given points"}),
    ("control_points_by_hand", "the next point straight ahead", {"tests": "all say yes"}),
    ("control_points_by_hand", "before the jump", {"to_jump": "5°", "tests": "all say yes"}),
    ("control_points_by_hand", "behind it", {"to_jump": "5°", "tests": "all say yes"}),
    *(
        ("grab_the_spoon", words, {"q": q, "angle": angle, "home": "yes"})
        for words, q, angle in (
            ("half turns about *U*, *V*, *W*", "1.00, 0.00, 0.00, 0.00", "0°"),
            ("about *U*, *W*, *V*", "\N{MINUS SIGN}1.00, 0.00, 0.00, 0.00", "360°"),
            ("a wobbling full turn", "\N{MINUS SIGN}1.00, 0.00, 0.00, 0.00", "360°"),
            ("home by Euler angles", "\N{MINUS SIGN}1.00, 0.00, 0.00, 0.00", "360°"),
        )
    ),
    *(
        ("double_cover_by_hand", words, {"twists": f"{n:.2f}", "q_back": back})
        for n, words, back in (
            (1, "1 turn", "no"),
            (2, "2 turns", "yes"),
            (3, "3 turns", "no"),
            (4, "4 turns", "yes"),
        )
    ),
    (
        "three_turns_by_hand",
        "*W* *V* *U*, axes carried along",
        {"apart": "0°", "upper": "M(w) M(v) M(u)", "lower": "M(w) M(v) M(u)"},
    ),
    ("three_turns_by_hand", "turns of 10°", {"apart": "3°", "lower": "M(u) M(v) M(w)"}),
    ("three_turns_by_hand", "half turns", {"apart": "0°", "lower": "M(u) M(v) M(w)"}),
    ("euler_angles_by_hand", "the spoon 1° aside", {"rings": "0, 89, 0°", "by_slerp": "89°"}),
    ("euler_angles_by_hand", "*v* = 30°", {"rings": "90, 30, 90°", "apart": "1.00°"}),
    ("euler_angles_by_hand", "the longest way", {"by_angles": "305°", "by_slerp": "119°"}),
    (
        "spinning_by_hand",
        "a fine step",
        {
            "exponential": "edge up to 1.00, 0° wrong",
            "Euler, matrix": "edge up to 1.11, 2° wrong",
            "Euler, quaternion": "edge up to 1.06, 2° wrong",
        },
    ),
    (
        "spinning_by_hand",
        "repaired after every step",
        {
            "exponential": "edge up to 1.00, 0° wrong",
            "Euler, matrix": "edge up to 1.00, 11° wrong",
            "Euler, quaternion": "edge up to 1.00, 9° wrong",
        },
    ),
    (
        "spinning_by_hand",
        "both arrows alike",
        {
            "exponential": "edge up to 1.00, 0° wrong",
            "Euler, matrix": "edge up to 2.01, 8° wrong",
            "Euler, quaternion": "edge up to 1.44, 2° wrong",
        },
    ),
    (
        "spinning_by_hand",
        "the opposite arrow",
        {
            "exponential": "edge up to 1.00, 0° wrong",
            "Euler, matrix": "edge up to 1.00, 0° wrong",
            "Euler, quaternion": "edge up to 1.00, 0° wrong",
        },
    ),
    (
        "mean_by_hand",
        "give *q₃* the other sign",
        {"apart": "0.3°", "by_matrices": "37, 36, 42°", "by_quaternions": "37, 36, 42°"},
    ),
    ("mean_by_hand", "no choice of signs helps", {"apart": "22.6°"}),
    (
        "mean_by_hand",
        "thirds of a whole turn",
        {
            "apart": "no unique mean",
            "by_quaternions": "120, 0, 120°",
            "singular": "1.000, 0.000, 0.000",
        },
    ),
    ("figure_1_by_hand", "*θ* = 90°", {"first": "0.00", "across": "1.00"}),
    ("figure_1_by_hand", "*θ* = 180°", {"first": "−1.00", "across": "0.00"}),
    ("figure_1_by_hand", "*r₂* opposite *r*", {"first_apart": "0.94", "along_apart": "0.00"}),
    ("two_mirrors_by_hand", "both mirrors, 60° on", {"between": "60°", "turned": "120°"}),
    (
        "two_mirrors_by_hand",
        "mirrors at right angles",
        {"turned": "180°", "q": "0.00, 0.00, 0.00, 1.00"},
    ),
    (
        "two_mirrors_by_hand",
        "mirrors in one plane",
        {"turned": "360°", "home": "yes", "q": "−1.00, 0.00, 0.00, 0.00"},
    ),
    (
        "worn_spoons_by_hand",
        "repair both",
        {
            "matrix_off": "5.5°",
            "quaternion_off": "16°",
            "matrix_edges": "1.000, 1.000, 1.000",
            "quaternion_edges": "1.000, 1.000, 1.000",
        },
    ),
    (
        "worn_spoons_by_hand",
        "after 100 turns",
        {"matrix_off": "1.6°", "quaternion_off": "5.4°"},
    ),
    (
        "worn_spoons_by_hand",
        "32 bits",
        {"matrix_off": "0.000021°", "quaternion_off": "0.00010°"},
    ),
    (
        "worn_spoons_by_hand",
        "tiny turns, 16 bits",
        {"matrix_off": "0.0026°", "quaternion_off": "0.0024°"},
    ),
]


def tried(name: str, words: str = "") -> dict[str, Any]:
    """The inputs of a figure after a press on a chip, or at the start."""
    figure = Explorable(EXPLORABLES[name])
    return figure.start | (figure.checked(EXPLORABLES[name].tries[words]) if words else {})


@pytest.fixture(scope="module")
def pressed() -> dict[tuple[str, str], dict[str, str]]:
    """The numbers that a reader sees after each press."""
    cases = [(name, tried(name, words)) for name, words, _ in SHOWN]
    return {
        (name, words): {output["name"]: output.text for output in panel.select("output")}
        for (name, words, _), panel in zip(SHOWN, panels(cases), strict=True)
    }


@pytest.mark.parametrize(("name", "words", "outputs"), SHOWN)
def test_a_chip_shows_what_it_promises(
    name: str, words: str, outputs: dict[str, str], pressed: dict[Any, dict[str, str]]
) -> None:
    seen = pressed[name, words]
    assert {key: seen[key] for key in outputs} == outputs


def test_the_control_point_goes_halfway_straight_ahead_and_jumps_by_almost_a_right_angle() -> None:
    place = {}
    for words in list(EXPLORABLES["control_points_by_hand"].tries)[1:]:
        inputs = tried("control_points_by_hand", words)
        a = np.array(states("control_points_by_hand", [inputs])[0]["parts"]["$a_i$"]["at"])
        place[words] = np.degrees(np.arctan2(a[1], a[0]))
    # P_i is at 60 degrees of the equator, and two halvings leave a quarter of a turn but for 2.5.
    assert place["the next point straight ahead"] == pytest.approx(90)
    assert place["before the jump"] - place["behind it"] == pytest.approx(90 - 2.5)


@pytest.mark.parametrize("words", EXPLORABLES["worn_spoons_by_hand"].tries)
def test_rounding_harms_the_products_of_scipy_as_much(words: str) -> None:
    inputs = tried("worn_spoons_by_hand", words)
    shown = outputs("worn_spoons_by_hand", **inputs)
    kept = {
        "2 decimals": lambda x: np.rint(100 * x) / 100,
        "16 bits": lambda x: x.astype("f2").astype(float),
        "32 bits": lambda x: x.astype("f4").astype(float),
    }[inputs["precision"]]
    home = Rotation.identity()
    matrix, size, turned = np.eye(3), 1.0, Rotation.identity()
    turns = [q.components for q in random_turns(inputs["size"])[: round(inputs["turns"])]]
    for turn in [Rotation.from_quat(q, scalar_first=True) for q in turns] + [None]:
        turn = turn or home.inv()
        home = turn * home
        matrix = kept(turn.as_matrix() @ matrix)
        q = kept(size * (turn * turned).as_quat())
        size, turned = np.linalg.norm(q), Rotation.from_quat(q)
    off = np.degrees([Rotation.from_matrix(matrix).magnitude(), turned.magnitude()])
    for name, angle in zip(("matrix", "quaternion"), off, strict=True):
        assert float(shown[f"{name}_off"].rstrip("°")) == pytest.approx(angle, rel=0.06)


def test_every_chip_has_its_row() -> None:
    chips = {(name, words) for name, function in EXPLORABLES.items() for words in function.tries}
    assert chips == {(name, words) for name, words, _ in SHOWN}


@pytest.mark.parametrize("name", [name for name, function in EXPLORABLES.items() if function.tries])
def test_chips_are_few_and_short(name: str) -> None:
    tries = EXPLORABLES[name].tries
    assert 2 <= len(tries) <= 4
    assert all(len(words) <= 32 for words in tries)


@pytest.mark.parametrize(("turns", "rest"), [(1, -1), (2, 0), (3, -1), (4, 0)])
def test_pulled_round_a_ribbon_keeps_one_twist_or_none(turns: int, rest: int) -> None:
    inputs = tried("double_cover_by_hand", f"{turns} turn{'s' * (turns > 1)}")
    last = EXPLORABLES["double_cover_by_hand"].inputs["passed"].high
    assert outputs("double_cover_by_hand", **inputs | {"passed": last})["twists"] == rest


@pytest.mark.parametrize("words", EXPLORABLES["two_mirrors_by_hand"].tries)
def test_two_reflections_turn_as_far_as_the_mirrors_say(words: str) -> None:
    inputs = tried("two_mirrors_by_hand", words)

    def reflection(angle: float) -> Any:
        twice = 2 * np.radians(angle + inputs["both"])
        return np.array([[np.cos(twice), np.sin(twice)], [np.sin(twice), -np.cos(twice)]])

    (cosine, _), (sine, _) = reflection(inputs["second"]) @ reflection(inputs["first"])
    turned = outputs("two_mirrors_by_hand", **inputs)["turned"]
    np.testing.assert_allclose(
        [cosine, sine], [np.cos(np.radians(turned)), np.sin(np.radians(turned))], atol=1e-12
    )


def test_the_middle_of_every_arc_lies_along_the_sum_of_its_ends() -> None:
    inputs = tried("arcs_of_arcs", "half of every arc")
    levels = [np.array(inputs["control"])]
    while len(levels[-1]) > 1:
        sums = levels[-1][:-1] + levels[-1][1:]
        levels.append(sums / np.linalg.norm(sums, axis=1, keepdims=True))
    seen = outputs("arcs_of_arcs", **inputs)
    ways = [seen[f"way_{j}"] for j in (1, 2, 3)]
    expected = [np.degrees(angle_between(levels[0][0], level[0])) for level in levels[1:]]
    np.testing.assert_allclose(ways, expected)


@pytest.mark.filterwarnings("ignore:.* are almost ")
def test_routes_part_where_it_is_more_than_half_a_turn_from_double() -> None:
    parted = set()
    for poses in np.random.default_rng(9).normal(size=(20, 4, 4)):
        seen = outputs("routes_by_hand", poses=poses)
        parted.add((seen["turn"] > 180, seen["apart"] > 1e-6))
    assert parted == {(False, False), (True, True)}


@pytest.mark.parametrize("words", EXPLORABLES["routes_by_hand"].tries)
def test_signs_can_agree_if_one_of_all_choices_does(words: str) -> None:
    inputs = tried("routes_by_hand", words)
    q = np.array(inputs["poses"])
    choices = np.array(list(product((1, -1), repeat=4)))[..., np.newaxis] * q
    products = np.sum(choices * np.roll(choices, -1, axis=1), axis=2)
    signs = outputs("routes_by_hand", **inputs)["signs"]
    assert (products > 0).all(axis=1).any() == (signs == "can agree")


def test_past_the_opposite_point_the_arc_swings_to_the_other_side() -> None:
    middles = []
    for words in ("just before the opposite point", "just past it"):
        inputs = tried("slerp_by_hand", words)
        middles.append(np.add(inputs["p"], inputs["q"]))
    assert angle_between(*middles) > np.radians(90)


def test_a_spoon_at_the_end_does_not_tell_the_sign() -> None:
    flipped = tried("slerp_by_hand", "flip the sign of the end")
    frames = [
        states("slerp_by_hand", [inputs])[0]["parts"]
        for inputs in (tried("slerp_by_hand"), flipped)
    ]
    there, opposite = (parts["end"]["at"] for parts in frames)
    assert np.allclose(there, -np.array(opposite))
    spoons = [parts["spoon at the end"]["matrix"] for parts in frames]
    assert np.allclose(*spoons, atol=1e-5)


# The films of `animate` by textbook formulas and SciPy, as rotations at times from 0 to n.


def arc(p: Any, q: Any, t: Any) -> Any:
    theta = np.arccos(np.sum(p * q, axis=-1, keepdims=True))
    return (np.sin((1 - t) * theta) * p + np.sin(t * theta) * q) / np.sin(theta)


def tangent(p: Any, q: Any) -> Any:
    theta = np.arccos(np.sum(p * q, axis=-1, keepdims=True))
    return theta / np.sin(theta) * (q - np.cos(theta) * p)


def cubic(values: Any, t: Any) -> Any:
    spline = CubicSpline(
        np.arange(len(values) + 1), np.concatenate([values, values[:1]]), bc_type="periodic"
    )
    return spline(t)


def film(name: str, q: Any, fraction: float, t: Any) -> Rotation:
    if name == "spline of M":
        found = [
            polar(m)[0] for m in cubic(Rotation.from_quat(q, scalar_first=True).as_matrix(), t)
        ]
        assert np.linalg.det(found).min() > 0
        return Rotation.from_matrix(found)
    if name == "spline of q":
        return Rotation.from_quat(cubic(q, t), scalar_first=True)
    if name == "the paper's":
        for i in range(1, len(q)):
            q[i] *= np.sign(q[i] @ q[i - 1])
    i, u = np.divmod(t, 1)
    here, after = i.astype(int) % len(q), (i.astype(int) + 1) % len(q)
    u = u[:, np.newaxis]
    if name == "the paper's":
        a, b = control_points(q, fraction)
        row = [q[here], a[here], b[after], q[after]]
        while len(row) > 1:
            row = [arc(p, r, u) for p, r in pairwise(row)]
        return Rotation.from_quat(row[0], scalar_first=True)
    points = arc(q[here], q[after], u)
    if name == "squad":
        bend = -(tangent(q, np.roll(q, 1, axis=0)) + tangent(q, np.roll(q, -1, axis=0))) / 4
        size = np.linalg.norm(bend, axis=-1, keepdims=True)
        s = np.cos(size) * q + np.sin(size) * bend / size
        points = arc(points, arc(s[here], s[after], u), 2 * u * (1 - u))
    return Rotation.from_quat(points, scalar_first=True)


@pytest.mark.parametrize("words", ["", "a fine step", "both arrows alike"])
def test_a_spinning_body_is_where_linear_algebra_has_it(words: str) -> None:
    """All three methods are powers of matrices that act on the nine or four numbers."""
    inputs = tried("spinning_by_hand", words)
    h, t = inputs["h"], inputs["t"]
    a, b = (np.pi / 2 * np.array(inputs[key]) for key in ("space", "body"))
    left, right = (np.cross(v, np.eye(3)).T for v in (a, b))
    on_nine = np.kron(left, np.eye(3)) + np.kron(np.eye(3), right.T)
    on_four = np.zeros((4, 4))
    on_four[1:, 0], on_four[0, 1:], on_four[1:, 1:] = (a + b) / 2, -(a + b) / 2, (left - right) / 2
    count = round(t / h)
    exact = (expm(t * on_nine) @ np.eye(3).ravel()).reshape(3, 3)
    matrix = np.linalg.matrix_power(np.eye(9) + h * on_nine, count) @ np.eye(3).ravel()
    q = np.linalg.matrix_power(np.eye(4) + h * on_four, count)[:, 0]
    turned = q @ q * Rotation.from_quat(q, scalar_first=True).as_matrix()
    parts = states("spinning_by_hand", [inputs])[0]["parts"]
    for name, expected in (
        ("exponential", exact),
        ("Euler, matrix", matrix.reshape(3, 3)),
        ("Euler, quaternion", turned),
    ):
        drawn = np.reshape(parts[name]["matrix"], (4, 4)).T[:3, :3]
        np.testing.assert_allclose(drawn, expected, atol=2e-6)
    for name, axis in (("body", exact @ inputs["body"]), ("space", np.array(inputs["space"]))):
        np.testing.assert_allclose(parts[name]["to"], 0.85 * axis, atol=2e-6)


def test_no_choice_of_signs_brings_the_plain_mean_to_the_mean() -> None:
    inputs = tried("mean_by_hand", "no choice of signs helps")
    told = outputs("mean_by_hand", **inputs)["apart"]
    q = np.array(inputs["poses"])
    mean = Rotation.from_quat(q, scalar_first=True).mean().as_quat(scalar_first=True)
    totals = [np.array(signs) @ q for signs in product((1, -1), repeat=3)]
    nearest = max(abs(total @ mean) / np.linalg.norm(total) for total in totals)
    assert np.degrees(2 * np.arccos(nearest)) == pytest.approx(told, abs=1e-6)


@pytest.mark.parametrize("words", ["", *EXPLORABLES["animate"].tries])
def test_films_are_as_fast_as_told(words: str) -> None:
    inputs = tried("animate", words)
    told = outputs("animate", **inputs)["fastest"]
    for name, fastest in zip(FILMS, told, strict=True):
        q = np.array(inputs["poses"])
        # No picture stands at a pose, where there is no arc, but close by.
        turned = film(name, q, inputs["fraction"], np.arange(24 * len(q) + 1) / 24 + 1e-9)
        steps = (turned[:-1].inv() * turned[1:]).magnitude()
        assert 24 * np.degrees(steps.max()) == pytest.approx(fastest, rel=1e-6), name


def test_the_spline_of_matrices_whips_round_where_the_page_says() -> None:
    q = np.array(tried("animate")["poses"])
    *_, fastest = outputs("animate")["fastest"]
    assert round(fastest / 24) == 72
    assert round(np.degrees(2 * np.arccos(q[4] @ q[0]))) == 147


def test_acceleration_jumps_as_told() -> None:
    told = outputs("animate")["jumps"]
    q, h = np.array(tried("animate")["poses"]), 1e-3
    for name, jump in zip(("squad", "the paper's"), told, strict=True):
        before, after = (
            [second_rate(film(name, q, 0.5, k + way * (1e-9 + h * np.arange(5))), h) for k in times]
            for way, times in ((-1, np.arange(5) + 5), (1, np.arange(5)))
        )
        jumps = np.linalg.norm(np.subtract(before, after), axis=-1)
        assert np.degrees(jumps.max()) == pytest.approx(jump, rel=0.02), name


def second_rate(turned: Rotation, h: float) -> Any:
    """The second derivative of a turn at the first of five times, by differences."""
    weights = np.array([35, -104, 114, -56, 11]) / (12 * h**2)
    return weights @ (turned[0].inv() * turned).as_rotvec()


@pytest.mark.parametrize(
    ("words", "axes", "sign"),
    [("half turns about *U*, *V*, *W*", "ijk", 1), ("about *U*, *W*, *V*", "ikj", -1)],
)
def test_three_half_turns_multiply_to_the_sign(words: str, axes: str, sign: int) -> None:
    units = dict(zip("ijk", np.eye(3), strict=True))
    first, second, third = (Quaternion(0, units[axis]) for axis in axes)
    assert third * second * first == sign
    inputs = tried("grab_the_spoon", words)
    # By continuity: no step on the way is longer than a small turn.
    cases = [inputs | {"along": along} for along in np.linspace(0, 1, 31)]
    q = [state["outputs"]["q"] for state in states("grab_the_spoon", cases)]
    assert np.linalg.norm(np.diff(q, axis=0), axis=1).max() < 0.2
    assert q[0] == [1, 0, 0, 0]
    assert q[-1] == pytest.approx([sign, 0, 0, 0], abs=1e-12)


def test_from_the_same_pose_euler_angles_and_slerp_come_home_with_opposite_signs() -> None:
    inputs = tried("grab_the_spoon", "home by Euler angles")
    for way, sign in (("home by Euler angles", -1), ("home by slerp", 1), ("home by nlerp", 1)):
        told = outputs("grab_the_spoon", **inputs | {"way": way})
        assert told["q"] == pytest.approx([sign, 0, 0, 0], abs=1e-12)


def test_at_the_lock_a_spoon_turned_by_a_degree_throws_the_rings_round() -> None:
    inputs = tried("euler_angles_by_hand", "the spoon 1° aside")
    before, after = (
        Rotation.from_euler("xyz", [values[key] for key in "uvw"], degrees=True)
        for values in (tried("euler_angles_by_hand"), inputs)
    )
    assert np.degrees((after * before.inv()).magnitude()) == pytest.approx(1)
    assert abs(after.as_matrix() - before.as_matrix()).max() < 0.018
    assert max(abs(inputs[key] - tried("euler_angles_by_hand")[key]) for key in "uvw") == 90


def test_the_longest_way_is_the_sum_of_many_small_turns() -> None:
    inputs = tried("euler_angles_by_hand", "the longest way")
    angles = np.outer(np.linspace(0, 1, 1001), [inputs[key] for key in "uvw"])
    path = Rotation.from_euler("xyz", angles, degrees=True)
    turned = np.degrees((path[:-1].inv() * path[1:]).magnitude().sum())
    assert turned == pytest.approx(304.8, abs=0.1)
    assert np.degrees(path[-1].magnitude()) == pytest.approx(119.5, abs=0.05)
