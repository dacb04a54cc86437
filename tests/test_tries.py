"""What to try in a figure: each chip leads to a state that shows what the page says it does.

A new chip gets a row here: the words on it, and the numbers on which its discovery rests, as a
reader sees them. Where they are not obvious, a test below computes them in another way.
"""

from typing import Any

import numpy as np
import pytest
from test_explorables import BY_HAND

from rotedu.arcs import angle_between
from rotedu.figures import explore
from rotedu.figures.explorable import Exploration
from rotedu.figures.frames import frame_of
from rotedu.figures.panel import text_of

# Figure, words on the chip, outputs.
SHOWN: list[tuple[str, str, dict[str, str]]] = [
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
        {"angle": "178.6°", "way": "357.2°", "speed": "53.18"},
    ),
    (
        "slerp_by_hand",
        "just past it",
        {"angle": "178.6°", "way": "357.2°", "speed": "53.03"},
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
        {"velocity_jump": "0.0°/s", "curvature_jumps": "0.04 0.56 0.55 1.52"},
    ),
    (
        "closed_curve_by_hand",
        "two points close together",
        {"velocity_jump": "0.0°/s", "curvature_jump": "1.77", "speed": "1°/s"},
    ),
    (
        "closed_curve_by_hand",
        "points on a great circle",
        {"velocity_jump": "0.0°/s", "curvature_jump": "0.00"},
    ),
    (
        "closed_curve_by_hand",
        "the same, a third of the way",
        {"curvature_jump": "0.00", "speed": "90°/s"},
    ),
    ("control_points_by_hand", "the three points alone", {"now": "0 three given points"}),
    ("control_points_by_hand", "the next point straight ahead", {"tests": "all say yes"}),
    ("control_points_by_hand", "before the jump", {"to_jump": "5°", "tests": "all say yes"}),
    ("control_points_by_hand", "behind it", {"to_jump": "5°", "tests": "all say yes"}),
    *(
        ("double_cover_by_hand", words, {"twists": f"{n:.2f}", "q_back": back})
        for n, words, back in (
            (1, "1 turn", "no"),
            (2, "2 turns", "yes"),
            (3, "3 turns", "no"),
            (4, "4 turns", "yes"),
        )
    ),
    ("figure_1_by_hand", "θ = 90°", {"first": "0.00", "across": "1.00"}),
    ("figure_1_by_hand", "θ = 180°", {"first": "−1.00", "across": "0.00"}),
    ("figure_1_by_hand", "r₂ opposite r", {"first_apart": "0.60", "along_apart": "0.00"}),
    ("two_mirrors_by_hand", "both mirrors, 60° on", {"between": "60°", "turned": "120°"}),
    (
        "two_mirrors_by_hand",
        "mirrors at right angles",
        {"turned": "180°", "q": "0.00 0.00 0.00 1.00"},
    ),
    (
        "two_mirrors_by_hand",
        "mirrors in one plane",
        {"turned": "360°", "home": "yes", "q": "−1.00 0.00 0.00 0.00"},
    ),
]


def tried(name: str, words: str) -> tuple[Exploration, dict[str, Any]]:
    """A figure, and its inputs after a press on a chip."""
    figure = explore(BY_HAND[name])
    chosen = BY_HAND[name].tries[words]
    return figure, figure.start | {
        key: figure.inputs[key].value(key, x) for key, x in chosen.items()
    }


@pytest.mark.parametrize(("name", "words", "outputs"), SHOWN)
def test_a_chip_shows_what_it_promises(name: str, words: str, outputs: dict[str, str]) -> None:
    figure, inputs = tried(name, words)
    seen = figure.draw(**inputs).shown.outputs
    assert {key: text_of(seen[key]) for key in outputs} == outputs


def test_the_control_point_goes_halfway_straight_ahead_and_jumps_by_almost_a_right_angle() -> None:
    place = {}
    for words in list(BY_HAND["control_points_by_hand"].tries)[1:]:
        figure, inputs = tried("control_points_by_hand", words)
        a = np.array(figure.draw(**inputs).shown.parts["$a_i$"]["at"])
        place[words] = np.degrees(np.arctan2(a[1], a[0]))
    # P_i is at 60 degrees of the equator, and two halvings leave a quarter of a turn but for 2.5.
    assert place["the next point straight ahead"] == pytest.approx(90)
    assert place["before the jump"] - place["behind it"] == pytest.approx(90 - 2.5)


def test_every_chip_has_its_row() -> None:
    chips = {(name, words) for name, function in BY_HAND.items() for words in function.tries}
    assert chips == {(name, words) for name, words, _ in SHOWN}


@pytest.mark.parametrize("name", [name for name, function in BY_HAND.items() if function.tries])
def test_chips_are_few_and_short(name: str) -> None:
    tries = BY_HAND[name].tries
    assert 2 <= len(tries) <= 4
    assert all(len(words) <= 32 for words in tries)


@pytest.mark.parametrize(("turns", "rest"), [(1, -1), (2, 0), (3, -1), (4, 0)])
def test_pulled_round_a_ribbon_keeps_one_twist_or_none(turns: int, rest: int) -> None:
    figure, inputs = tried("double_cover_by_hand", f"{turns} turn{'s' * (turns > 1)}")
    last = figure.inputs["passed"].high
    assert figure.draw(**inputs | {"passed": last}).shown.outputs["twists"].value == rest


@pytest.mark.parametrize("words", BY_HAND["carried_around_by_hand"].tries)
def test_the_area_is_what_the_angles_exceed_half_a_turn_by(words: str) -> None:
    figure, inputs = tried("carried_around_by_hand", words)
    p = np.array(inputs["corners"])
    # Where the planes of two sides meet at a corner.
    planes = np.cross(p, np.roll(p, -1, axis=0))
    angles = np.pi - angle_between(np.roll(planes, 1, axis=0), planes)
    area = figure.draw(**inputs).shown.outputs["area"].value
    assert abs(area) == pytest.approx(np.degrees(angles.sum() - np.pi))


@pytest.mark.parametrize("words", BY_HAND["two_mirrors_by_hand"].tries)
def test_two_reflections_turn_as_far_as_the_mirrors_say(words: str) -> None:
    figure, inputs = tried("two_mirrors_by_hand", words)

    def reflection(angle: float) -> Any:
        twice = 2 * np.radians(angle + inputs["both"])
        return np.array([[np.cos(twice), np.sin(twice)], [np.sin(twice), -np.cos(twice)]])

    (cosine, _), (sine, _) = reflection(inputs["second"]) @ reflection(inputs["first"])
    turned = figure.draw(**inputs).shown.outputs["turned"].value
    np.testing.assert_allclose(
        [cosine, sine], [np.cos(np.radians(turned)), np.sin(np.radians(turned))], atol=1e-12
    )


def test_past_the_opposite_point_the_arc_swings_to_the_other_side() -> None:
    middles = []
    for words in ("just before the opposite point", "just past it"):
        _, inputs = tried("slerp_by_hand", words)
        middles.append(np.add(inputs["p"], inputs["q"]))
    assert angle_between(*middles) > np.radians(90)


def test_a_spoon_at_the_end_does_not_tell_the_sign() -> None:
    figure, flipped = tried("slerp_by_hand", "flip the sign of the end")
    frames = [frame_of(figure.draw(**inputs))["parts"] for inputs in (figure.start, flipped)]
    there, opposite = (parts["end"]["at"] for parts in frames)
    assert np.allclose(there, -np.array(opposite))
    spoons = [parts["spoon at the end"]["matrix"] for parts in frames]
    assert np.allclose(*spoons, atol=1e-5)
