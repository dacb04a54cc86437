"""Checks of the exercises of page 5 II."""

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from rotedu._vectors import Array
from rotedu.arcs import angle_between, arc_axis
from rotedu.control_points import bisect, control_points, double
from rotedu.edition.exercises.answers import (
    along_equator,
    close,
    normalised,
    numbers,
    on_equator,
    outcomes,
)
from rotedu.edition.exercises.judging import Part, exercise, in_radians, otherwise, usual, when
from rotedu.ordinary_rotation import rotate


@exercise("5.9", "a point, shape (3,)", fields={"U": "", "V": "", "W": ""})
def reflected_in_the_pole() -> Iterator[Part]:
    """Reflecting in a point is a half turn about it."""
    point, pole = np.array([1, 2, 2]) / 3, np.array([0, 0, 1])
    hints = {
        "That is the mirror image in the plane of the equator.": when(
            point * [1, 1, -1], "The pole should be halfway between the point and its reflection."
        ),
        "That is the opposite point, the reflection in the centre of the sphere.": when(
            -point, "Go from the point to the pole, and then as far again. Where are you?"
        ),
        "Your point is not on the sphere.": when(
            3 * double(point, pole), "Its direction is right. Divide it by its length."
        ),
        "You reflected the pole in the point.": when(
            double(pole, point),
            "Double(p, q) goes from p to q and beyond it. Which is p, and which is q?",
        ),
        "The pole is not halfway between the point and your answer.": otherwise(
            "Think of a half turn about the W axis. Which coordinates does it leave alone?"
        ),
    }
    yield Part(double(point, pole), hints, within=5e-3)


@exercise("5.10", "a point, shape (3,)", fields={"U": "", "V": "", "W": ""})
def middle_of_an_arc() -> Iterator[Part]:
    """The midpoint has the direction of the sum, and no angle is needed."""
    p, q = np.array([1, 0, 0]), np.array([0.28, 0.96, 0])
    hints = {
        "Your point is not on the sphere.": when(
            (p + q) / 2,
            "The direction is right. What is the length of your vector, and what should it be?",
            also=p + q,
        ),
        "That is the middle of the way round the other side.": when(
            -bisect(p, q), "The shortest arc joins the points. Is your point near them?"
        ),
        "That is the direction of the chord.": when(
            (q - p) / np.linalg.norm(q - p),
            "Which vector points between the two, and not from one to the other?",
        ),
        "Your point is not in the middle of the arc.": otherwise(
            "A sum of two vectors of one length points halfway between them."
        ),
    }
    yield Part(bisect(p, q), hints, within=2e-3)


def construction(before: float, after: float) -> tuple[Array, Array, Array, Array]:
    """Return the four points of the construction, for two gaps on the equator in degrees."""
    previous, here, following = on_equator([-before, 0, after])
    reflected = double(previous, here)
    middle = bisect(reflected, following)
    a = bisect(here, middle)
    return reflected, middle, a, double(a, here)


@exercise(
    "5.11",
    "five angles in degrees",
    fields={
        "first point with a bar": "°",
        "second": "°",
        "a": "°",
        "b": "°",
        "a, for gaps of 30° and 110°": "°",
    },
)
def construction_on_a_circle() -> Iterator[Part]:
    """On a great circle, a_i is a quarter of both gaps together beyond P_i."""
    before, after = 30, 110
    steps = {
        "first": "Double goes through 0°, and as far beyond it as it has come.",
        "second": "Bisect takes the mean of the first angle and the angle of the third point.",
        "third": "Bisect takes the mean of the second angle and that of the middle point.",
        "fourth": "Double reflects the third angle in that of the middle point, not the other way"
        " round.",
    }
    for i, (which, rule) in enumerate(steps.items()):
        angle = along_equator(construction(60, 100)[i])
        hints = {
            **in_radians(np.deg2rad(angle)),
            f"The {which} angle is not right yet.": otherwise(rule),
        }
        yield Part(angle, hints, item=i, within=0.01, period=360)
    hints = {
        "Your rule gives the midpoint of step two, not a_i.": when(
            (before + after) / 2, "There is one more Bisect after that."
        ),
        "Your rule takes the difference of the gaps.": when(
            (after - before) / 4, "Double carries the gap before the point to the side after it."
        ),
        "The four angles are right, but the rule is not yet.": otherwise(
            "Do the four steps with letters in place of numbers."
        ),
    }
    yield Part(
        along_equator(construction(before, after)[2]), hints, item=4, within=0.01, period=360
    )


@exercise("5.12", "four angles in degrees")
def reversed_ring() -> Iterator[Part]:
    """Reversing the list reveals an error that a look at the curve does not."""
    ring = normalised([[1, -0.45, 0], [0.7, 0.6, -0.35], [0.1, 0.8, 0.5], [0.6, -0.05, 0.95]])
    a, b = with_printed_axis(ring)
    back_a, back_b = with_printed_axis(ring[::-1])
    right = np.rad2deg(angle_between(a, back_b[::-1]))
    hints = {
        "With the axis as printed, they are not the same points.": when(
            np.zeros(4),
            "You have the symmetry of the correct construction. Exchange the operands of the cross"
            " product.",
        ),
        "You compare different points of the ring.": when(
            np.rad2deg(angle_between(a, back_b)),
            "The reversed list has its control points in the reversed order, too.",
        ),
        "You compare a_i with a_i, or b_i with b_i.": when(
            np.rad2deg(angle_between(a, back_a[::-1])),
            "Which control point is after a point if you travel the other way?",
        ),
        "That is the distance to the correct a_i.": when(
            np.rad2deg(angle_between(a, control_points(ring)[0])),
            "Suppose that you do not know them: compare your own a_i and b_i of two lists.",
        ),
        "That is the distance from a_i to b_i of one list.": when(
            np.rad2deg(angle_between(a, b)), "Compute the b_i again, from the reversed list."
        ),
        "Your angles begin with the last point.": when(
            right[::-1],
            "Bring the reversed b_i into the order of the a_i, not the other way round.",
        ),
        **in_radians(np.deg2rad(right)),
        "Are your a_i made with the axis as printed?": otherwise(
            "Only the middle of step two is turned wrongly. It turns by half the angle between the"
            " points that it should bisect."
        ),
    }
    yield Part(right, hints, within=0.5)


def with_printed_axis(points: Array) -> tuple[Array, Array]:
    """Return a and b, made with the axis of (5-9) as printed."""
    a = bisect(points, middle_as_printed(points))
    return a, double(a, points)


def middle_as_printed(points: Array) -> Array:
    """Return the midpoints of step two, turned about the axis of (5-9) as printed."""
    following = np.roll(points, -1, axis=0)
    beyond = double(np.roll(points, 1, axis=0), points)
    half = angle_between(beyond, following) / 2
    return rotate(beyond, arc_axis(following, beyond), half)


@exercise("5.13", "two points, shape (2, 3)", read=numbers(2, 3))
def two_repairs() -> Iterator[Part]:
    """Both points are the midpoint, so both colleagues are right."""
    start, goal = double([1, 0, 0], [0.6, 0.8, 0]), np.array([0, 0.6, 0.8])
    printed, half = np.cross(goal, start), angle_between(start, goal) / 2
    as_printed = rotate(start, printed, half)
    nobody = usual(
        "The colleague's point is where (5-8) leads as printed.",
        "The first colleague turns another point, the second by another angle.",
    )
    too_far = usual(
        "That turns by the whole angle between the points.",
        "Look again at the angle by which (5-8) turns.",
    )
    hints = {
        **nobody(as_printed),
        "The first colleague does not change the sign of the angle.": when(
            rotate(goal, printed, -half),
            "Turn the other point, about the printed axis, by the positive angle.",
        ),
        **too_far(start),
        "The point of the first colleague is not right yet.": otherwise(
            "Which of the two points does (5-8) turn? This colleague turns the other."
        ),
    }
    yield Part(rotate(goal, printed, half), hints, item=0, within=2e-3)
    hints = {
        **nobody(as_printed),
        "The second colleague still turns the point that (5-8) turns.": when(
            rotate(goal, printed, -half), "Change the sign of the angle, and nothing else."
        ),
        **too_far(goal),
        "The point of the second colleague is not right yet.": otherwise(
            "Keep the printed axis and the point that (5-8) turns."
        ),
    }
    yield Part(rotate(start, printed, -half), hints, item=1, within=2e-3)


def without_full_turns(degrees: npt.ArrayLike) -> Array:
    """Return angles that differ by full turns as one angle, from -180 to 180."""
    return (np.asarray(degrees, np.float64) + 180) % 360 - 180


# Also fractions, 0, and pairs that differ by little more and little less than 180.
STEPS = (-165, -110, -82, -78, -20.5, 0, 15, 40, 100, 150, 170)
GAPS = [(g, h) for g in STEPS for h in STEPS if abs(g - h) != 180 and abs(g + h) != 360]


@exercise(
    "5.14",
    "a function of two gaps in degrees that returns an angle in degrees",
    read=lambda rule: without_full_turns([numbers()(rule(g, h)) for g, h in GAPS]),
)
def rule_for_two_gaps() -> Iterator[Part]:
    """Near a jump, a small change of a point changes the curve a lot."""
    right = np.array([along_equator(construction(g, h)[2]) for g, h in GAPS])
    before, after = np.transpose(GAPS)
    follow = "Follow the midpoint of step two. Where is it before the jump, and where after it?"
    quarter = (before + after) / 4
    far = abs(before - after) > 180
    hints = {
        "Your rule never jumps.": when(
            quarter, "Try it on a gap of 170° before and one of 20° back."
        ),
        "Your rule jumps too far.": when(
            without_full_turns(np.where(far, quarter + 180, quarter)),
            "The midpoint of step two jumps to the opposite point. How far does a_i follow?",
        ),
        "Your rule always jumps to the same side.": when(
            without_full_turns(quarter - 90 * far),
            "It is right if the gaps add up to a positive angle. Try it with both gaps negated.",
        ),
        "Your rule jumps to the wrong side.": when(
            without_full_turns(quarter + 90 * np.sign(before + after) * far),
            "Bisect takes the shorter arc, so a_i is never more than 90° from P_i.",
        ),
        **in_radians(np.deg2rad(right)),
        "Your rule is right as long as the gaps differ by less than 180°, but not beyond.": when(
            lambda places: close(places[~far], right[~far], 0.01),
            follow,
            example=lambda before, after: (before + after) / 4 * (abs(before - after) < 180),
        ),
        "Your rule is not even right for gaps that differ by less than 180°.": otherwise(
            "Start from the rule of Exercise 5.11, which holds where nothing jumps."
        ),
    }
    yield Part(right, hints, within=0.01)


PAIRS = [
    (np.array([1.0, 0, 0]), np.array([0.5, 0.75**0.5, 0])),
    (np.array([0, 0.6, 0.8]), np.array([2, -1, 2]) / 3),
]


of_pairs = outcomes(PAIRS)


@exercise("5.7", "a function of two points that returns a point", read=of_pairs)
def going_on() -> Iterator[Part]:
    """The point and its reflection add up to twice the shadow on the middle."""
    hints = {
        "You went back beyond p.": when(
            of_pairs(lambda p, q: double(q, p)),
            "Which of p and q should be halfway between the other one and your point?",
        ),
        "That is the shadow of p on q.": when(
            of_pairs(lambda p, q: (p @ q) * q), "You need a point on the other side of it."
        ),
        "On a straight line, that would be right.": when(
            of_pairs(lambda p, q: 2 * q - p), "How long is your vector? The two add up along q."
        ),
        "Your point is not as far beyond q as p is before it.": otherwise(
            "Take p from twice its shadow on q."
        ),
    }
    yield Part(of_pairs(double), hints)


@exercise("5.8", "a function of two points that returns a point", read=of_pairs)
def halfway_between() -> Iterator[Part]:
    """A diagonal of a rhombus halves its angle."""
    hints = {
        "Your point is inside the ball.": when(
            of_pairs(lambda p, q: (p + q) / 2), "How long is your vector?"
        ),
        "Your point is outside the ball.": when(
            of_pairs(lambda p, q: p + q), "How long is your vector?"
        ),
        "Your point is not in the middle.": otherwise("Start with the sum of the two."),
    }
    yield Part(of_pairs(bisect), hints)
