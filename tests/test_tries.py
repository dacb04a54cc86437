"""What to try in a figure: each chip leads to a state that shows what the page says it does.

A new chip gets a row here: the words on it, and the numbers on which its discovery rests, as a
reader sees them; `test_outputs.py` computes them in another way. What else a discovery rests on, a
test below does.
"""

from itertools import product
from typing import Any

import numpy as np
import pytest
from explorables import EXPLORABLES, outputs, panels, states, turn_of
from oracles.motion import spinning_bodies
from scipy.spatial.transform import Rotation

from rotedu import scenes
from rotedu.arcs import angle_between
from rotedu.control_points import control_points
from rotedu.figures.explorable import Explorable
from rotedu.orientation_curves import closed_rotation_curve, squad
from rotedu.quaternions import Quaternion
from rotedu.scenes.rigid_motion import SKINS

# Of each figure, by the words on a chip, what its outputs are then.
SHOWN: dict[str, dict[str, dict[str, str]]] = {
    # In the order of the films that are shown.
    "animate": {
        "small turns": {"fastest": "51, 53°/s", "corner": "62°/s"},
        "wide turns": {"fastest": "238, 1720°/s"},
        "one sign changed": {"fastest": "250, 188°/s"},
        "two poses alike": {"speed": "6, 56, 79, 82, 36°/s"},
    },
    "the_swing": {
        "at 100°": {"route": "100°", "shortest": "100°"},
        "where the other is farthest": {"route": "92°", "shortest": "127°"},
        "at −60°": {"route": "−60°", "shortest": "−60°"},
    },
    "arcs_of_arcs": {
        "close to the start": {"way_1": "3.1°", "way_2": "6.1°", "way_3": "8.9°"},
        "even closer": {"way_1": "0.6°", "way_2": "1.2°", "way_3": "1.8°"},
        "half of every arc": {"way_1": "30.7°", "way_2": "52.7°", "way_3": "62.9°"},
    },
    "the_arm": {
        "a door handle": {"wrist": "9%", "volume": "89.5%"},
        "repaired, and the elbow bent": {"wrist": "100%", "volume": "100.9%"},
        "an elbow that bulges": {"wrist": "100%", "stretch": "178%", "volume": "99.9%"},
        "past half a turn": {"wrist": "100%", "stretch": "133%", "volume": "99.6%"},
    },
    "from_a_to_b": {
        "a quarter turn": {"angle": "90.0°", "share": "1.00"},
        "almost opposite": {"angle": "172.0°", "share": "101.50"},
        "from the other side": {"angle": "172.0°", "share": "101.50"},
    },
    "pull_the_thread": {
        "home, once through the skin": {"crossings": "1", "verdict": "loose", "home": "yes"},
        "pulled tight": {"crossings": "1", "degrees": "360°", "verdict": "sticks", "home": "yes"},
        "home, twice through the skin": {"crossings": "2", "verdict": "loose", "home": "yes"},
        "and pulled tight": {"crossings": "0", "degrees": "0°", "verdict": "gone", "home": "yes"},
    },
    "routes_by_hand": {
        "a swing to 100°": {"turn": "190.0°", "apart": "39.9°", "signs": "can agree"},
        "once right round": {"turn": "0.0°", "apart": "0.0°", "signs": "cannot agree"},
        "turns about many axes": {"turn": "201.9°", "apart": "41.2°", "signs": "can agree"},
    },
    "slerp_by_hand": {
        "nlerp hurries in the middle": {"angle": "150.0°", "way": "300.0°", "speed": "2.85"},
        "flip the sign of the end": {"angle": "30.0°", "way": "60.0°", "speed": "1.02"},
        "just before the opposite point": {"angle": "172.6°", "way": "345.2°", "speed": "10.27"},
        "just past it": {"angle": "172.5°", "way": "345.0°", "speed": "10.12"},
    },
    "carried_around_by_hand": {
        "there and back": {"twist": "−4.2°", "area": "−4.2°", "difference": "0°"},
        "the arrow comes back reversed": {"twist": "180.0°", "area": "180.0°", "difference": "0°"},
        "an even larger triangle": {"twist": "−120.1°", "area": "239.9°", "difference": "360°"},
        "clockwise": {"twist": "−90.0°", "area": "−90.0°", "difference": "0°"},
    },
    "closed_curve_by_hand": {
        "once round": {"velocity_jump": "0.0°/s"},
        "two points close together": {"speed_range": "1, 90°/s"},
        "points on a great circle": {"curvature_jump": "0.00", "speed_range": "68, 135°/s"},
        "the same, a third of the way": {"curvature_jump": "0.00", "speed_range": "90, 90°/s"},
    },
    "camera_by_hand": {
        "the corner at the clock": {
            "rolled": "0°",
            "bends": "door 36°, clock 82°, window 30°, desk 89°",
        },
        "once round along the curve": {
            "rolled": "166°",
            "bends": "door 0°, clock 0°, window 0°, desk 0°",
        },
        "who turns it past the window?": {"rolled": "0°", "spin": "−526°/s"},
    },
    "control_points_by_hand": {
        "all four steps": {"now": "4 Double: go beyond", "tests": "all say yes"},
        "the next point straight ahead": {"tests": "all say yes"},
        "before the jump": {"to_jump": "5°", "tests": "all say yes"},
        "behind it": {"to_jump": "5°", "tests": "all say yes"},
    },
    "grab_the_spoon": {
        "half turns about *U*, *V*, *W*": {"q": "1.00, 0.00, 0.00, 0.00", "home": "yes"},
        "about *U*, *W*, *V*": {"q": "−1.00, 0.00, 0.00, 0.00", "angle": "360°", "home": "yes"},
        "a wobbling full turn": {"q": "−1.00, 0.00, 0.00, 0.00", "angle": "360°", "home": "yes"},
        "home by Euler angles": {"q": "−1.00, 0.00, 0.00, 0.00", "angle": "360°", "home": "yes"},
    },
    "plate_and_arm": {
        "one turn": {"spoon_back": "yes", "arm_straight": "no", "q": "−1.00, 0.00, 0.00, 0.00"},
        "one and a half": {"spoon_back": "no", "arm_straight": "no"},
        "two turns": {"spoon_back": "yes", "arm_straight": "yes"},
    },
    "three_turns_by_hand": {
        "*W* *V* *U*, axes carried along": {
            "apart": "0°",
            "upper": "M(w) M(v) M(u)",
            "lower": "M(w) M(v) M(u)",
        },
        "turns of 10°": {"apart": "3°", "lower": "M(u) M(v) M(w)"},
        "half turns": {"apart": "0°", "lower": "M(u) M(v) M(w)"},
    },
    "euler_angles_by_hand": {
        "the spoon 1° aside": {"rings": "0, 89, 0°", "by_slerp": "89°"},
        "*v* = 30°": {"rings": "90, 30, 90°", "apart": "1.00°"},
        "the longest way": {"by_angles": "305°", "by_slerp": "119°"},
    },
    "spinning_by_hand": {
        "a fine step": {
            "exponential": "edge 1.00, 0° off",
            "Euler, matrix": "edge 1.11, 2° off",
            "Euler, quaternion": "edge 1.06, 2° off",
        },
        "repaired after every step": {
            "Euler, matrix": "edge 1.00, 11° off",
            "Euler, quaternion": "edge 1.00, 9° off",
        },
        "both arrows alike": {
            "Euler, matrix": "edge 2.01, 8° off",
            "Euler, quaternion": "edge 1.44, 2° off",
        },
        "the opposite arrow": {
            "Euler, matrix": "edge 1.00, 0° off",
            "Euler, quaternion": "edge 1.00, 0° off",
        },
    },
    "mean_by_hand": {
        "give *q₃* the other sign": {"apart": "73.0°", "by_matrices": "37, 36, 42°"},
        "no choice of signs helps": {"apart": "22.6°"},
        "thirds of a whole turn": {
            "apart": "not unique",
            "by_quaternions": "120, 0, 120°",
            "singular": "1.000, 0.000, 0.000",
        },
    },
    "the_balance": {
        "two points": {"matrix": "51", "quaternion": "55"},
        "ten points": {"matrix": "171", "quaternion": "247"},
        "10,000 points": {"matrix": "150,021", "quaternion": "240,007", "spoon": "1,000"},
    },
    "the_balance_of_works": {
        "many points": {"matrix": "15,021", "quaternion": "24,007"},
        "turns in a row": {"matrix": "390", "quaternion": "280"},
        "one arc, 60 times": {"matrix": "2,113", "quaternion": "791"},
        "worn turns": {"matrix": "2,800", "quaternion": "700"},
    },
    "figure_1_by_hand": {
        "all three arrows": {"first": "0.50", "across": "0.87"},
        "*θ* = 90°": {"first": "0.00", "across": "1.00"},
        "*θ* = 180°": {"first": "−1.00", "across": "0.00"},
        "another vector to the circle": {"along_apart": "0.00"},
    },
    "half_the_work": {"the first product": {"scalar": "−0.51"}, "both": {"scalar": "0.00"}},
    "two_mirrors_by_hand": {
        "both mirrors, 60° on": {"between": "60°", "turned": "120°"},
        "mirrors at right angles": {"turned": "180°", "q": "0.00, 0.00, 0.00, 1.00"},
        "mirrors in one plane": {"turned": "360°", "home": "yes", "q": "−1.00, 0.00, 0.00, 0.00"},
    },
    "worn_spoons_by_hand": {
        "a thousand turns": {"matrix_off": "21 % in length", "quaternion_off": "17 % in length"},
        "then repair both": {
            "matrix_off": "5.5°",
            "quaternion_off": "16°",
            "matrix_edges": "1.000, 1.000, 1.000",
            "quaternion_edges": "1.000, 1.000, 1.000",
        },
        "with 32 bits": {
            "times": "1",
            "matrix_off": "0.000072 % in length",
            "quaternion_off": "0.000060 % in length",
        },
        "… under the magnifier": {
            "times": "100,000",
            "matrix_off": "0.000072 % in length",
            "quaternion_off": "0.000060 % in length",
        },
    },
}
CHIPS = [(name, words) for name, chips in SHOWN.items() for words in chips]


def tried(name: str, words: str = "") -> dict[str, Any]:
    """The inputs of a figure after a press on a chip, or at the start."""
    figure = Explorable(EXPLORABLES[name])
    return figure.start | (figure.checked(EXPLORABLES[name].tries[words]) if words else {})


@pytest.fixture(scope="module")
def pressed() -> dict[tuple[str, str], dict[str, str]]:
    """The numbers that a reader sees after each press."""
    written = panels([(name, tried(name, words)) for name, words in CHIPS])
    return {
        chip: {output["name"]: output.text for output in panel.select("output")}
        for chip, panel in zip(CHIPS, written, strict=True)
    }


@pytest.mark.parametrize(("name", "words"), CHIPS)
def test_a_chip_shows_what_it_promises(name: str, words: str, pressed: dict[Any, Any]) -> None:
    promised = SHOWN[name][words]
    assert {key: pressed[name, words][key] for key in promised} == promised


def test_the_control_point_goes_halfway_straight_ahead_and_jumps_by_almost_a_right_angle() -> None:
    place = {}
    for words in list(EXPLORABLES["control_points_by_hand"].tries)[1:]:
        inputs = tried("control_points_by_hand", words)
        a = np.array(states("control_points_by_hand", [inputs])[0]["parts"]["$a_i$"]["at"])
        place[words] = np.degrees(np.arctan2(a[1], a[0]))
    # P_i is at 60 degrees of the equator, and two halvings leave a quarter of a turn but for 2.5.
    assert place["the next point straight ahead"] == pytest.approx(90)
    assert place["before the jump"] - place["behind it"] == pytest.approx(90 - 2.5)


def test_chips_are_few_and_short_and_each_has_its_row() -> None:
    chips = {name: {*function.tries} for name, function in EXPLORABLES.items() if function.tries}
    assert chips == {name: {*rows} for name, rows in SHOWN.items()}
    for name, words in chips.items():
        assert 2 <= len(words) <= 4, name
        assert max(map(len, words)) <= 32, name


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
    frames = states("slerp_by_hand", [tried("slerp_by_hand"), flipped])
    there, opposite = (np.array(state["parts"]["end"]["at"]) for state in frames)
    assert np.allclose(there, -opposite)
    spoons = [state["parts"]["spoon at the end"]["matrix"] for state in frames]
    assert np.allclose(*spoons, atol=1e-5)


@pytest.mark.parametrize(
    ("aim", "bends"), [(0, (35, 108)), (38, (49, 66)), (41, (52, 62)), (82, (98, 39))]
)
def test_bends_of_the_arrow_at_the_clock(aim: float, bends: tuple[float, float]) -> None:
    """And where it points: from straight on to the window; 38 degrees is what the page makes."""
    told = outputs("arrow_at_the_clock", aim=aim)["bends"]
    parts = states("arrow_at_the_clock", [{"aim": aim}])[0]["parts"]
    assert np.round(told).tolist() == list(bends)
    # Straight on, and towards the window.
    clock, window, door = (np.array(parts[name]["at"]) for name in ("clock", "window", "door"))
    arrow = np.subtract(parts["arrow"]["to"], parts["arrow"]["from"])
    desk = np.array(scenes.CAMERA_TARGETS[3])
    finished = control_points([door, clock, window, desk / np.linalg.norm(desk)])[0][1]
    straight, *others = (p - (p @ clock) * clock for p in (-door, arrow, window, finished))
    angles = [np.degrees(angle_between(straight, other)) for other in others]
    assert angles == pytest.approx([aim, 82, 38], abs=0.5)


def test_no_choice_of_signs_brings_the_plain_mean_to_the_mean() -> None:
    inputs = tried("mean_by_hand", "no choice of signs helps")
    told = outputs("mean_by_hand", **inputs)["apart"]
    q = np.array(inputs["poses"])
    mean = Rotation.from_quat(q, scalar_first=True).mean().as_quat(scalar_first=True)
    totals = [np.array(signs) @ q for signs in product((1, -1), repeat=3)]
    nearest = max(abs(total @ mean) / np.linalg.norm(total) for total in totals)
    assert np.degrees(2 * np.arccos(nearest)) == pytest.approx(told, abs=1e-6)


def test_acceleration_jumps_as_told() -> None:
    """From curves a thousand times as fine as the hand sees them."""
    told = outputs("animate")["jumps"]
    q, n = np.array(tried("animate")["poses"]), 1000
    rotations = Quaternion(q[:, 0], q[:, 1:]).matrix()
    ways = Rotation.from_quat(squad(q, n), scalar_first=True).as_matrix()
    # The second derivative at the first of five times.
    weights = n**2 * np.array([35, -104, 114, -56, 11]) / 12
    for curve, jump in zip((ways, closed_rotation_curve(rotations, n)), told, strict=True):
        change = []
        for pose in n * np.arange(len(q)):
            near = [curve[(pose + way * np.arange(5)) % len(curve)] for way in (-1, 1)]
            turns = [Rotation.from_matrix(curve[pose].T @ r).as_rotvec() for r in near]
            change.append(np.linalg.norm(weights @ turns[1] - weights @ turns[0]))
        assert np.degrees(max(change)) == pytest.approx(jump, rel=0.02)


@pytest.mark.parametrize("words", ["", *EXPLORABLES["spinning_by_hand"].tries])
def test_a_spinning_body_is_drawn_where_scipy_has_it(words: str) -> None:
    inputs = tried("spinning_by_hand", words)
    [state] = states("spinning_by_hand", [inputs])
    for name, expected in spinning_bodies(**inputs).items():
        np.testing.assert_allclose(turn_of(state, name), expected, atol=2e-6)
    parts = state["parts"]
    turned = Rotation.from_rotvec(np.pi / 2 * inputs["t"] * np.array(inputs["space"]))
    np.testing.assert_allclose(parts["body"]["to"], 0.85 * turned.apply(inputs["body"]), atol=2e-6)
    np.testing.assert_allclose(parts["space"]["to"], 0.85 * np.array(inputs["space"]), atol=2e-6)


def test_the_spline_of_matrices_whips_round_where_the_page_says() -> None:
    q = np.array(tried("animate")["poses"])
    *_, fastest = outputs("animate", films="both splines")["fastest"]
    assert round(fastest / 24) == 72
    assert round(np.degrees(2 * np.arccos(q[4] @ q[0]))) == 147


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


def test_past_half_a_turn_the_wrist_goes_the_other_way_round() -> None:
    """In the middle it is turned by half of 200 degrees less a whole turn; repaired, as well."""
    inputs = tried("the_arm", "past half a turn") | {"bend": 0}
    cases = [inputs | {"skin": skin, "twist": x} for skin in SKINS[1:] for x in (0, 200)]
    rest, moved, *again = (x["parts"]["vertex"]["at"] for x in states("the_arm", cases))
    for start, end in ((rest, moved), again):
        turned = np.degrees(np.arctan2(end[2], end[1]) - np.arctan2(start[2], start[1]))
        assert (turned + 180) % 360 - 180 == pytest.approx(-80)


def test_two_arrows_close_together_can_have_spoons_that_are_not() -> None:
    """Either is nearly half a turn, about axes at right angles to each other."""
    ends = [tried("from_a_to_b", words) for words in ("almost opposite", "from the other side")]
    assert np.degrees(angle_between(ends[0]["b"], ends[1]["b"])) < 12
    first, second = (turn_of(state, "spoon after") for state in states("from_a_to_b", ends))
    assert np.degrees(Rotation.from_matrix(first.T @ second).magnitude()) > 175


@pytest.mark.parametrize("turns", [1, 2, 3, 4])
def test_a_thread_sticks_if_it_crosses_an_odd_number_of_times(turns: int) -> None:
    """Pulled, it keeps both ends; crossings go in pairs, and the end's sign is their parity."""
    rng = np.random.default_rng(turns)
    t = np.linspace(0, 1, 40)[:, np.newaxis]
    for _ in range(5):
        phase, far = rng.uniform(0, 7, 3), rng.uniform(0.2, 0.9, 3)
        axes = [1, 0.3, 0.5] + far * np.sin(2 * np.pi * t + phase)
        # At home it does not matter about which axis the last turn was.
        thread = Quaternion.from_axis_angle(axes, 2 * np.pi * turns * t[:, 0]).components
        given = {"thread": thread.tolist(), "spoon": thread[-1].tolist()}
        cases = [given | {"pulled": pulled} for pulled in (0, 0.1, 0.2, 0.4, 0.7, 1)]
        found = states("pull_the_thread", cases)
        crossings = np.array([state["outputs"]["crossings"] for state in found])
        assert crossings[0] == turns
        assert (crossings % 2 == turns % 2).all()
        assert found[-1]["outputs"]["verdict"] == ("sticks" if turns % 2 else "gone")
        for state in found:
            np.testing.assert_allclose(state["inputs"]["spoon"], thread[-1], atol=1e-9)
            begin = "odd" if turns % 2 else "even"
            np.testing.assert_allclose(state["parts"][f"{begin} end"]["at"], 0, atol=1e-6)


def test_near_home_the_spoon_falls_into_place_and_the_thread_goes_on() -> None:
    """Within 12 degrees of home; the thread keeps what the hand has left of it when pulled."""
    near = Quaternion.from_axis_angle([1, 2, 0], np.deg2rad(-11)).components.tolist()
    away = Quaternion.from_axis_angle([1, 2, 0], np.deg2rad(-13)).components.tolist()
    given = tried("pull_the_thread", "pulled tight")
    home, left = states("pull_the_thread", [given | {"spoon": q} for q in (near, away)])
    assert home["inputs"]["spoon"] == pytest.approx([-1, 0, 0, 0])
    assert home["inputs"]["pulled"] == 1
    assert np.abs(left["inputs"]["spoon"]) == pytest.approx(np.abs(away))
    assert left["inputs"]["pulled"] == 0
    assert left["outputs"]["degrees"] == pytest.approx(360, abs=14)
