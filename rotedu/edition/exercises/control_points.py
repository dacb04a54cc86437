"""Checks of the exercises of page 5 II."""

from collections.abc import Iterator

import numpy as np

from rotedu._vectors import Array
from rotedu.arcs import angle_between, arc_axis
from rotedu.control_points import bisect, control_points, double
from rotedu.edition.exercises.judging import (
    RADIANS,
    Mistake,
    Part,
    Wrong,
    along_equator,
    close,
    exercise,
    numbers,
    on_equator,
    without_full_turns,
)
from rotedu.ordinary_rotation import rotate

__all__: list[str] = []


@exercise(
    "5.6",
    fields={"U": "", "V": "", "W": ""},
    expects="a point, shape (3,)",
    because="Reflecting in a point is a half turn about it.",
)
def reflected_in_the_pole() -> Iterator[Part]:
    """Yield the reflection of a point in the pole."""
    point, pole = np.array([1, 2, 2]) / 3, np.array([0, 0, 1])
    yield Part(
        double(point, pole),
        Mistake(
            point * [1, 1, -1],
            "That is the mirror image in the plane of the equator.",
            "The pole should be halfway between the point and its reflection.",
        ),
        Mistake(
            -point,
            "That is the opposite point, the reflection in the centre of the sphere.",
            "Go from the point to the pole, and then as far again. Where are you?",
        ),
        Mistake(
            3 * double(point, pole),
            "Your point is not on the sphere.",
            "Its direction is right. Divide it by its length.",
        ),
        Mistake(
            double(pole, point),
            "You reflected the pole in the point.",
            "Double(p, q) goes from p to q and beyond it. Which is p, and which is q?",
        ),
        otherwise=Wrong(
            "The pole is not halfway between the point and your answer.",
            "Think of a half turn about the W axis. Which coordinates does it leave alone?",
        ),
        within=5e-3,
    )


@exercise(
    "5.7",
    fields={"U": "", "V": "", "W": ""},
    expects="a point, shape (3,)",
    because="The midpoint has the direction of the sum, and no angle is needed.",
)
def middle_of_an_arc() -> Iterator[Part]:
    """Yield the midpoint of two points of the equator."""
    p, q = np.array([1, 0, 0]), np.array([0.28, 0.96, 0])
    inside = Wrong(
        "Your point is not on the sphere.",
        "The direction is right. What is the length of your vector, and what should it be?",
    )
    yield Part(
        bisect(p, q),
        Mistake((p + q) / 2, *inside),
        Mistake(p + q, *inside),
        Mistake(
            -bisect(p, q),
            "That is the middle of the way round the other side.",
            "The shortest arc joins the points. Is your point near them?",
        ),
        Mistake(
            (q - p) / np.linalg.norm(q - p),
            "That is the direction of the chord.",
            "Which vector points between the two, and not from one to the other?",
        ),
        otherwise=Wrong(
            "Your point is not in the middle of the arc.",
            "A sum of two vectors of one length points halfway between them.",
        ),
        within=2e-3,
    )


def construction(before: float, after: float) -> tuple[Array, Array, Array, Array]:
    """Return the four points of the construction, for two gaps on the equator in degrees."""
    previous, here, following = on_equator([-before, 0, after])
    reflected = double(previous, here)
    middle = bisect(reflected, following)
    a = bisect(here, middle)
    return reflected, middle, a, double(a, here)


@exercise(
    "5.8",
    fields={
        "first point with a bar": "°",
        "second": "°",
        "a": "°",
        "b": "°",
        "a, for gaps of 30° and 110°": "°",
    },
    expects="five angles in degrees",
    read=numbers(5),
    because="On a great circle, a_i is a quarter of both gaps together beyond P_i.",
)
def construction_on_a_circle() -> Iterator[Part]:
    """Yield the four points of the construction, then what the rule for a_i gives."""
    before, after = 30, 110
    hints = (
        Wrong(
            "The first angle is not right yet.",
            "Double goes through 0°, and as far beyond it as it has come.",
        ),
        Wrong(
            "The second angle is not right yet.",
            "Bisect takes the mean of the first angle and the angle of the third point.",
        ),
        Wrong(
            "The third angle is not right yet.",
            "Bisect takes the mean of the second angle and that of the middle point.",
        ),
        Wrong(
            "The fourth angle is not right yet.",
            "Double reflects the third angle in that of the middle point, not the other way round.",
        ),
    )
    for i, (angle, hint) in enumerate(
        zip(along_equator(construction(60, 100)), hints, strict=True)
    ):
        radians = Mistake(np.deg2rad(angle), *RADIANS)
        yield Part(angle, radians, otherwise=hint, item=i, within=0.01, period=360)
    yield Part(
        along_equator(construction(before, after)[2]),
        Mistake(
            (before + after) / 2,
            "Your rule gives the midpoint of step two, not a_i.",
            "There is one more Bisect after that.",
        ),
        Mistake(
            (after - before) / 4,
            "Your rule takes the difference of the gaps.",
            "Double carries the gap before the point to the side after it.",
        ),
        otherwise=Wrong(
            "The four angles are right, but the rule is not yet.",
            "Do the four steps with letters in place of numbers.",
        ),
        item=4,
        within=0.01,
        period=360,
    )


@exercise(
    "5.9",
    expects="four angles in degrees",
    because="Reversing the list reveals an error that a look at the curve does not.",
)
def reversed_ring() -> Iterator[Part]:
    """Yield how far a wrong axis breaks the symmetry of the construction."""
    ring = np.array([[1, -0.45, 0], [0.7, 0.6, -0.35], [0.1, 0.8, 0.5], [0.6, -0.05, 0.95]])
    ring /= np.linalg.norm(ring, axis=1, keepdims=True)
    a, b = with_printed_axis(ring)
    back_a, back_b = with_printed_axis(ring[::-1])
    right = np.rad2deg(angle_between(a, back_b[::-1]))
    yield Part(
        right,
        Mistake(
            np.zeros(4),
            "With the axis as printed, they are not the same points.",
            "You have the symmetry of the correct construction. Exchange the operands of the"
            " cross product.",
        ),
        Mistake(
            np.rad2deg(angle_between(a, back_b)),
            "You compare different points of the ring.",
            "The reversed list has its control points in the reversed order, too.",
        ),
        Mistake(
            np.rad2deg(angle_between(a, back_a[::-1])),
            "You compare a_i with a_i, or b_i with b_i.",
            "Which control point is after a point if you travel the other way?",
        ),
        Mistake(
            np.rad2deg(angle_between(a, control_points(ring)[0])),
            "That is the distance to the correct a_i.",
            "Suppose that you do not know them: compare your own a_i and b_i of two lists.",
        ),
        Mistake(
            np.rad2deg(angle_between(a, b)),
            "That is the distance from a_i to b_i of one list.",
            "Compute the b_i again, from the reversed list.",
        ),
        Mistake(
            right[::-1],
            "Your angles begin with the last point.",
            "Bring the reversed b_i into the order of the a_i, not the other way round.",
        ),
        Mistake(np.deg2rad(right), *RADIANS),
        otherwise=Wrong(
            "Are your a_i made with the axis as printed?",
            "Only the middle of step two is turned wrongly. It turns by half the angle between"
            " the points that it should bisect.",
        ),
        within=0.5,
    )


def with_printed_axis(points: Array) -> tuple[Array, Array]:
    """Return a and b, with the midpoint of step two turned about the axis of (5-9) as printed."""
    following = np.roll(points, -1, axis=0)
    beyond = double(np.roll(points, 1, axis=0), points)
    half = angle_between(beyond, following) / 2
    a = bisect(points, rotate(beyond, arc_axis(following, beyond), half))
    return a, double(a, points)


@exercise(
    "5.10",
    expects="two points, shape (2, 3)",
    because="Both points are the midpoint, so both colleagues are right.",
    read=numbers(2, 3),
)
def two_repairs() -> Iterator[Part]:
    """Yield the points that two repairs of (5-9) lead to."""
    start, goal = double([1, 0, 0], [0.6, 0.8, 0]), np.array([0, 0.6, 0.8])
    printed, half = np.cross(goal, start), angle_between(start, goal) / 2
    as_printed = rotate(start, printed, half)
    nobody = Wrong(
        "The colleague's point is where (5-8) leads as printed.",
        "The first colleague turns another point, the second by another angle.",
    )
    too_far = Wrong(
        "That turns by the whole angle between the points.",
        "Look again at the angle by which (5-8) turns.",
    )
    yield Part(
        rotate(goal, printed, half),
        Mistake(as_printed, *nobody),
        Mistake(
            rotate(goal, printed, -half),
            "The first colleague does not change the sign of the angle.",
            "Turn the other point, about the printed axis, by the positive angle.",
        ),
        Mistake(start, *too_far),
        otherwise=Wrong(
            "The point of the first colleague is not right yet.",
            "Which of the two points does (5-8) turn? This colleague turns the other.",
        ),
        item=0,
        within=2e-3,
    )
    yield Part(
        rotate(start, printed, -half),
        Mistake(as_printed, *nobody),
        Mistake(
            rotate(goal, printed, -half),
            "The second colleague still turns the point that (5-8) turns.",
            "Change the sign of the angle, and nothing else.",
        ),
        Mistake(goal, *too_far),
        otherwise=Wrong(
            "The point of the second colleague is not right yet.",
            "Keep the printed axis and the point that (5-8) turns.",
        ),
        item=1,
        within=2e-3,
    )


# Also fractions, 0, and pairs that differ by little more and little less than 180.
STEPS = (-165, -110, -82, -78, -20.5, 0, 15, 40, 100, 150, 170)
GAPS = [(g, h) for g in STEPS for h in STEPS if abs(g - h) != 180 and abs(g + h) != 360]


@exercise(
    "5.11",
    expects="a function of two gaps in degrees that returns an angle in degrees",
    because="Near a jump, a small change of a point changes the curve a lot.",
    read=lambda rule: without_full_turns([numbers()(rule(g, h)) for g, h in GAPS]),
)
def rule_for_two_gaps() -> Iterator[Part]:
    """Yield the places of a_i on a great circle."""
    right = np.array([along_equator(construction(g, h)[2]) for g, h in GAPS])
    before, after = np.transpose(GAPS)
    follow = "Follow the midpoint of step two. Where is it before the jump, and where after it?"
    quarter = (before + after) / 4
    far = abs(before - after) > 180
    yield Part(
        right,
        Mistake(
            quarter, "Your rule never jumps.", "Try it on a gap of 170° before and one of 20° back."
        ),
        Mistake(
            without_full_turns(np.where(far, quarter + 180, quarter)),
            "Your rule jumps too far.",
            "The midpoint of step two jumps to the opposite point. How far does a_i follow?",
        ),
        Mistake(
            without_full_turns(quarter - 90 * far),
            "Your rule always jumps to the same side.",
            "It is right if the gaps add up to a positive angle. Try it with both gaps negated.",
        ),
        Mistake(
            without_full_turns(quarter + 90 * np.sign(before + after) * far),
            "Your rule jumps to the wrong side.",
            "Bisect takes the shorter arc, so a_i is never more than 90° from P_i.",
        ),
        Mistake(np.deg2rad(right), *RADIANS),
        Mistake(
            lambda places: close(places[~far], right[~far], 0.01),
            "Your rule is right as long as the gaps differ by less than 180°, but not beyond.",
            follow,
            example=lambda before, after: (before + after) / 4 * (abs(before - after) < 180),
        ),
        otherwise=Wrong(
            "Your rule is not even right for gaps that differ by less than 180°.", follow
        ),
        within=0.01,
    )
