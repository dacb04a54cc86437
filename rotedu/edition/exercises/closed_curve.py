"""Checks of the exercises of page 5 III."""

from collections.abc import Iterator

import numpy as np

from rotedu._vectors import Array
from rotedu.arcs import angle_between, slerp
from rotedu.closed_curve import closed_curve, de_casteljau
from rotedu.control_points import bisect, control_points, double
from rotedu.edition.exercises.answers import (
    along_equator,
    normalised,
    numbers,
    on_equator,
    outcomes,
    parts,
    unit,
    word,
)
from rotedu.edition.exercises.control_points import middle_as_printed
from rotedu.edition.exercises.judging import Part, exercise, in_radians, otherwise, when
from rotedu.errors import DegenerateError

# How far points may be from their middle, and how near each other: 60 and 40 degrees, as read
# from a picture.
SPREAD, APART = np.deg2rad([60.5, 39.5])


@exercise(
    "5.16",
    "three numbers in degrees: two speeds and an angle",
    fields={"leaving": "° per unit", "arriving": "° per unit", "second control point": "°"},
)
def leaving_and_arriving() -> Iterator[Part]:
    """The first and the last arc alone decide the velocity at the ends."""
    points = on_equator([0, 20, 70, 80])
    first, middle, last = np.rad2deg(angle_between(points[:-1], points[1:]))
    hints = {
        "The arcs are right, but the curve is faster.": when(
            [first, last], "Each of the three levels of the construction adds the same small step."
        ),
        "You have the two speeds the wrong way round.": when(
            [3 * last, 3 * first], "The curve starts at 0°."
        ),
        "That is the mean speed on the whole piece.": when(
            [first + middle + last] * 2,
            "The speed of the curve varies. Which arc decides how fast it leaves?",
        ),
        "Are your speeds in radians?": when(
            np.deg2rad([3 * first, 3 * last]), "The exercise asks for degrees."
        ),
        "The speeds are not right yet.": otherwise(
            "How long is the first arc, how long is the last, and how many levels are there?"
        ),
    }
    yield Part([3 * first, 3 * last], hints, item=slice(2), within=0.01)
    hints = {
        "From there the next piece would turn back.": when(
            along_equator(points[2]), "The velocity must keep its direction, not only its size."
        ),
        "The next piece would leave too fast.": when(
            along_equator(points[3]) + 3 * last,
            "A speed is not the length of an arc. What did you multiply by?",
        ),
        **in_radians(np.deg2rad(along_equator(double(points[2], points[3])))),
        "The speeds are right, but the angle is not yet.": otherwise(
            "The next piece begins at 80° and must leave as fast as this one arrives."
        ),
    }
    yield Part(along_equator(double(points[2], points[3])), hints, item=2, within=0.01, period=360)


@exercise("5.17", "two numbers of arcs", fields={"cubic curve": "arcs", "m = 10": "arcs"})
def number_of_arcs() -> Iterator[Part]:
    """Each level has one arc fewer than the one before."""
    degrees = np.array([3, 10])
    right = [sum(range(1, m + 1)) for m in degrees]
    hints = {
        "You count the first level only.": when(
            degrees, "The points on these arcs are joined by arcs as well, and so on."
        ),
        "You count the control points.": when(degrees + 1, "How many arcs join them, one by one?"),
        "You count the points, the control points included.": when(
            [sum(range(1, m + 2)) for m in degrees],
            "The control points are given. Each of the other points lies on an arc of its own.",
        ),
        "m = 10 does not mean ten control points.": when(
            [right[0], sum(range(1, 10))],
            "A cubic curve has m = 3. How many control points does it have?",
        ),
        "The number does not grow in proportion to m.": when(
            [right[0], 2 * degrees[1]],
            "Each further control point adds an arc to every level, and a level.",
        ),
        "How many levels are there, and how many arcs has each of them?": otherwise(
            "Count those of Picture 5-f by their colours. Then begin with ten arcs in place of"
            " three."
        ),
    }
    yield Part(right, hints)


FIGURE_8 = normalised([[0.8, -0.4, 0.4], [0.5, 0.8, -0.4], [0.6, 0.7, 0.4], [0.1, 0.4, 0.9]])


def jumps_of_curvature(points: Array, step: float = 3e-4) -> Array:
    """Return how much the geodesic curvature of the closed curve jumps at each of its points."""
    a, b = control_points(points)
    pieces = np.stack([points, a, np.roll(b, -1, axis=0), np.roll(points, -1, axis=0)], axis=1)
    ends = np.array([0.0, 1.0])
    before, c, after = (de_casteljau(pieces[:, np.newaxis], ends + x) for x in (-step, 0, step))
    velocity, acceleration = (after - before) / (2 * step), (after - 2 * c + before) / step**2
    sideways = (np.cross(c, velocity) * acceleration).sum(axis=-1)
    leaving, arriving = (sideways / np.linalg.norm(velocity, axis=-1) ** 3).T
    return np.asarray(np.abs(leaving - np.roll(arriving, 1)))


def goes_round(points: Array) -> bool:
    """Tell whether each step from point to point goes the same way round their middle."""
    steps = np.cross(points, np.roll(points, -1, axis=0)) @ points.mean(axis=0)
    return bool((steps > 0).all() or (steps < 0).all())


def hardly_jumps(points: Array) -> bool:
    """Tell whether the curvature jumps nowhere by more than 0.2, as the figure rounds it."""
    try:
        return bool(jumps_of_curvature(points).max() < 0.205)
    except DegenerateError:
        return False


@exercise("5.18", "the four points of your curve, shape (4, 3)", read=numbers(4, 3))
def curve_without_jumps() -> Iterator[Part]:
    """With equal gaps, the pieces that meet at one of four points are mirror images."""
    # Points are found by hand, to a degree and three decimals.
    square = normalised([[1, 0.7, 0], [1, 0, 0.7], [1, -0.7, 0], [1, 0, -0.7]])
    hints = {
        "Your points are not on the sphere.": when(
            lambda points: (np.abs(np.linalg.norm(points, axis=1) - 1) >= 2e-3).any(),
            "Have you lost a digit or a decimal point? The cell prints x, y and z of each point.",
            example=2 * square,
        ),
        "One of your points is more than 60° from the middle of all.": when(
            lambda points: (points @ normalised(points.mean(axis=0)) <= np.cos(SPREAD)).any(),
            "Keep them on the side of the sphere that you look at.",
            example=normalised([[0, 1, 0.1], [1, 0, 0.1], [0, -1, 0.1], [-1, 0, 0.1]]),
        ),
        "Two of your points are less than 40° apart.": when(
            lambda points: np.triu(points @ points.T, 1).max() >= np.cos(APART),
            "They need not be neighbours.",
            example=normalised([[1, 0.3, 0], [1, 0, 0.3], [1, -0.3, 0], [1, 0, -0.3]]),
        ),
        "Your points do not follow each other round their middle.": when(
            lambda points: not goes_round(points),
            "Seen from above the middle, does the curve cross itself?",
            example=square[[0, 2, 1, 3]],
        ),
        "These are the points with which Figure 8 begins.": when(
            FIGURE_8, "Drag some, and watch the jumps under *More numbers*."
        ),
        "The curvature still jumps by more than 0.2.": when(
            lambda points: not hardly_jumps(points),
            "Where a jump is large, compare how far away the two neighbours are.",
            example=normalised([[1, 0.9, 0], [1, 0, 0.6], [1, -0.7, 0], [1, 0.3, -0.7]]),
        ),
    }
    yield Part(None, hints, within=2e-3)


@exercise("5.19", "a point, shape (3,)")
def one_row_of_points() -> Iterator[Part]:
    """Each point is overwritten when nobody needs it any more."""
    wide = normalised([[0.9, 0.3, 0.3], [0.3, 0.9, 0.3], [-0.3, 0.9, -0.3], [-0.9, 0.3, 0.3]])
    row = wide.copy()
    for j in range(1, 4):
        for k in range(j, 4):
            row[k] = slerp(row[k - 1], row[k], 0.4)
    hints = {
        "Your loop reads a point of the new level where it needs one of the old.": when(
            row[3], "When Q[k] is computed, has Q[k-1] been overwritten already?"
        ),
        "Your point is the one at this fraction from the other end.": when(
            de_casteljau(wide, 0.6), "At u = 0 the curve is at the first control point. Is yours?"
        ),
        "Your point is not on the sphere.": when(
            lambda point: not unit(point, 2e-2),
            "Use arcs, not straight lines, on every level.",
            example=wide.mean(axis=0),
        ),
        "Your point is on the sphere, but not on the curve at this u.": otherwise(
            "Four points, three levels, and one point fewer on each level.", example=wide[1]
        ),
    }
    yield Part(de_casteljau(wide, 0.4), hints, within=6e-3)


@exercise(
    "5.20", "your a_i, shape (4, 3), and a number of checks", read=parts(numbers(4, 3), numbers())
)
def an_error_that_hides() -> Iterator[Part]:
    """Whatever a_i is, b_i = Double(a_i, P_i) makes the curve C1."""
    middle = middle_as_printed(FIGURE_8)
    right, (correct, _) = bisect(FIGURE_8, middle), control_points(FIGURE_8)
    hints = {
        "These are the correct a_i.": when(
            correct,
            "Exchange the operands of the cross product in (5-9), and turn about that axis.",
        ),
        "These are the b_i that belong to your a_i.": when(
            double(right, FIGURE_8), "Which of the two is after its point on the curve?"
        ),
        "These are the points of step two.": when(middle, "One more Bisect leads to a_i."),
        "You went a third of the way to the points of step two.": when(
            slerp(FIGURE_8, middle, 1 / 3), "Bisect goes half the way, and so does the paper."
        ),
        "Your a_i do not have the error of the paper.": otherwise(
            "Only the axis of step two is reversed; the angle and the point to be turned stay."
        ),
    }
    yield Part(right, hints, item=0, within=2e-3)
    hints = {
        "Which check is it? Look again, with b_i = Double(a_i, P_i).": when(
            1, "What does the proof that the curve is C1 assume about a_i?"
        ),
        "The number of checks is not right yet.": otherwise(
            "Do the three checks on the curve that has your control points."
        ),
    }
    yield Part(0, hints, item=1)


def energy(points: Array, fraction: float, samples: int = 100) -> Array:
    """Return the integral of the squared acceleration along the sphere, of closed curves."""
    c = closed_curve(points, samples, fraction)
    acceleration = (np.roll(c, 1, axis=-2) - 2 * c + np.roll(c, -1, axis=-2)) * samples**2
    outwards = (acceleration * c).sum(axis=-1, keepdims=True) * c
    return np.asarray(((acceleration - outwards) ** 2).sum(axis=(-2, -1)) / samples)


@exercise(
    "5.21", "a number and True or False", read=parts(numbers(), word("true", "false", "yes", "no"))
)
def energy_of_one_half() -> Iterator[Part]:
    """The best fraction differs from hexagon to hexagon."""
    hexagons = np.random.default_rng(35).normal(size=(40, 6, 3))
    half, third = energy(hexagons, 1 / 2), energy(hexagons, 1 / 3)
    hints = {
        "Your quotient is upside down.": when(
            np.median(third / half), "Which of the two curves has the greater energy?"
        ),
        "You divide a median by a median.": when(
            np.median(half) / np.median(third),
            "Divide for each hexagon first, then take the median.",
        ),
        "That is the median for 0.4, as it should be.": when(
            np.median(energy(hexagons, 0.4) / third), "Do the same for one half."
        ),
        "That is the mean.": when(
            np.mean(half / third),
            "A few large quotients pull the mean upwards, but hardly move the median.",
        ),
        "The median is not right yet. Does your code give 1.14 for 0.4?": otherwise(
            "Divide each energy by that of the same hexagon with one third."
        ),
    }
    yield Part(np.median(half / third), hints, item=0, within=0.01)
    hints = {
        "The median is right. Is one fraction really best for all?": otherwise(
            "Ask for each hexagon which of your fractions has the least energy.",
            example=(np.median(half / third), True),
        )
    }
    yield Part(lambda best: best in ("false", "no"), hints, item=1)


CONTROLS = [
    (np.array([[1, 0, 0], [0.5**0.5, 0.5**0.5, 0], [0.5**0.5, 0.5**0.5, 0], [0, 1.0, 0]]), 0.5),
    (np.array([[1, 0, 0], [0.6, 0.8, 0], [0, 0.6, 0.8], [0, 0, 1.0]]), 0.3),
]


@exercise(
    "5.15", "a function of four points and a number that returns a point", read=outcomes(CONTROLS)
)
def arcs_of_arcs_of_arcs() -> Iterator[Part]:
    """Three arcs, two, and one, each at the same fraction."""

    def first(points: Array, u: float, levels: int = 3) -> Array:
        for _ in range(levels):
            points = slerp(points[:-1], points[1:], u)
        return np.asarray(points[0])

    rows = outcomes(CONTROLS)

    hints = {
        "Your point comes from the other end.": when(
            rows(lambda points, u: first(points, 1 - u)),
            "At u = 0 it is the first of the four points.",
        ),
        "You stopped a level too early.": when(
            rows(lambda points, u: first(points, u, levels=2)),
            "Three arcs make two, two make one, and one makes a point.",
        ),
        "Your point is elsewhere.": otherwise("`slerp(points[:-1], points[1:], u)` is a level."),
    }
    yield Part(rows(first), hints)
