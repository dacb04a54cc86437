"""Checks of the exercises of Chapter 3."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from rotedu._vectors import Array
from rotedu.edition.exercises.answers import (
    close,
    numbers,
    outcomes,
    parts,
    radians_for_degrees,
    same_rotation,
    same_turn,
    unit,
    word,
)
from rotedu.edition.exercises.judging import (
    Part,
    angle_in_radians,
    exercise,
    otherwise,
    the_truth,
    when,
)
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix


@exercise("3.2", "a point, three numbers", fields={"U": "", "V": "", "W": ""})
def quarter_turn_of_a_point() -> Iterator[Part]:
    """What lies along the axis stays where it is."""
    point, w = [1, 2, 3], [0, 0, 1]
    hints = {
        "This turns clockwise.": when(
            rotate(point, w, -np.pi / 2), "Seen from the tip of W, where does U go first?"
        ),
        "You turned by 90 radians.": when(
            rotate(point, w, 90), "The functions of this book take radians; np.deg2rad converts."
        ),
        "This is a half turn.": when(rotate(point, w, np.pi), "A full turn has 360 degrees."),
        "You turned about U.": when(
            rotate(point, [1, 0, 0], np.pi / 2), "Which coordinate must not change?"
        ),
        "You turned about V.": when(
            rotate(point, [0, 1, 0], np.pi / 2), "Which coordinate must not change?"
        ),
        "The point has gone elsewhere.": otherwise(
            "One coordinate stays. The other two change places, and one of them its sign."
        ),
    }
    yield Part(rotate(point, w, np.pi / 2), hints, within=1e-3)


@exercise(
    "3.3", "an axis of three numbers and an angle in degrees", read=parts(numbers(3), numbers())
)
def axis_and_angle_of_a_matrix() -> Iterator[Part]:
    """The trace shows the angle, and three differences show the axis."""
    matrix = np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
    right = np.rad2deg(axis_angle(matrix)[1])
    one_third = np.rad2deg(np.arccos(matrix.trace() / 3))
    n = np.ones(3) / np.sqrt(3)
    hints = {
        **angle_in_radians(
            lambda axis, degrees: radians_for_degrees(abs(degrees), right), example=(n, np.pi / 3)
        ),
        "This is the inverse rotation.": when(
            lambda *turn: same_turn(turn, matrix.T, 2e-3),
            "In each difference, which of the two entries comes first?",
            example=(-n, 60),
        ),
        "The trace is not three times the cosine.": when(
            lambda axis, degrees: close(abs(degrees), one_third, 0.1),
            "What is the trace of (3-3)?",
            example=(n, 48.19),
        ),
        "The angle is not that of the matrix.": when(
            lambda axis, degrees: (
                not close(abs(degrees), right, 0.1) and not same_turn((axis, degrees), matrix, 2e-3)
            ),
            "The trace is the sum of the diagonal. How does it depend on the angle?",
            example=(n, 30),
        ),
        "Your axis does not have length 1.": when(
            lambda axis, degrees: not unit(axis, 1e-2),
            "The differences give a multiple of the axis. Divide by its length.",
            example=([1, 1, 1], 60),
        ),
        "The axis is not that of the matrix.": otherwise(
            "Multiply the matrix by your axis: it should not change.", example=([1, 0, 0], 60)
        ),
    }
    yield Part(
        lambda axis, degrees: unit(axis, 1e-2) and same_turn((axis, degrees), matrix, 2e-3), hints
    )


@exercise(
    "3.4",
    'two words, the first for -turn, the second for -diagonal, each of them "same",'
    ' "negative", "transpose" or "identity"',
    read=parts(*2 * [word("same", "negative", "transpose", "inverse", "identity")]),
)
def turned_back() -> Iterator[Part]:
    """It is the inverse rotation, both times."""
    axis, angle = np.array([1, 2, 2]) / 3, 0.7
    forward = rotation_matrix(axis, angle)
    named = {
        "same": forward,
        "negative": -forward,
        "transpose": forward.T,
        "inverse": forward.T,
        "identity": np.eye(3),
    }
    changed = rotation_matrix(axis, -angle), rotation_matrix(-axis, angle)

    def wrong(*words: str) -> list[str]:
        pairs = zip(words, changed, strict=True)
        return [word for word, matrix in pairs if not close(named[word], matrix)]

    hints = {
        "The negative of a rotation matrix mirrors.": when(
            lambda *words: "negative" in wrong(*words),
            "(3-3) is a sum of three matrices. Which of them changes its sign?",
            example=("negative", "negative"),
        ),
        "One of the two matrices still turns points.": when(
            lambda *words: "identity" in wrong(*words),
            "Turning forward and then back gives the identity, but here you turn only once.",
            example=("identity", "transpose"),
        ),
        "A matrix that you call the same does change.": otherwise(
            "Where does the sine change its sign, and where does the axis appear once, not twice?",
            example=("transpose", "same"),
        ),
    }
    yield Part(lambda *words: not wrong(*words), hints)


@exercise(
    "3.5",
    "two pairs, each of an axis and an angle in degrees",
    read=parts(*2 * [parts(numbers(3), numbers())]),
)
def two_turns_in_a_row() -> Iterator[Part]:
    """Angles do not add up when the axes differ."""
    u, v, w = np.eye(3)
    (u2, v2), (u4, v4) = (
        [rotation_matrix(axis, angle) for axis in (u, v)] for angle in (np.pi, np.pi / 2)
    )

    hints = {
        "Your angles are in radians.": when(
            lambda halves, quarters: same_rotation(halves, v2 @ u2, 1e-2),
            "A full turn has 360 degrees.",
            example=((w, np.pi), ([1, 1, -1], 2 * np.pi / 3)),
        ),
        "The two half turns make another rotation.": otherwise(
            "Follow the tip of each axis through both turns. Which axis comes back?",
            example=(([1, 1, 0], 180), ([1, 1, -1], 120)),
        ),
    }
    yield Part(lambda halves, quarters: same_turn(halves, v2 @ u2, 1e-2), hints)
    hints = {
        "For the quarter turns, V came before U.": when(
            lambda *turn: same_turn(turn, u4 @ v4, 1e-2),
            "In a product that acts on a column, which factor acts first?",
            example=((w, 180), ([1, 1, 1], 120)),
        ),
        "The quarter turns go backwards.": when(
            lambda *turn: same_turn(turn, (v4 @ u4).T, 1e-2),
            "Reverse the axis or the angle.",
            example=((w, 180), ([-1, -1, 1], 120)),
        ),
        "The angle of the quarter turns is in radians.": when(
            lambda *turn: same_rotation(turn, v4 @ u4, 1e-2),
            "A full turn has 360 degrees.",
            example=((w, 180), ([1, 1, -1], 2 * np.pi / 3)),
        ),
        "The quarter turns make another angle.": when(
            lambda axis, degrees: close(abs(degrees), 180, 0.1) or close(abs(degrees), 90, 0.1),
            "Do it with a book: how often must you repeat both turns until it is back?",
            example=((w, 180), ([1, 1, -1], 180)),
        ),
        "The two quarter turns make another rotation.": otherwise(
            "Multiply the two matrices, and give the product to axis_angle.",
            example=((w, 180), ([1, 0, -1], 120)),
        ),
    }
    yield Part(lambda *turn: same_turn(turn, v4 @ u4, 1e-2), hints, item=1)


def as_printed(n: Any, angle: float) -> Any:
    """(3-3) with the axis taken as it comes."""
    cos, sin = np.cos(angle), np.sin(angle)
    return cos * np.eye(3) + (1 - cos) * np.outer(n, n) + sin * np.cross(n, np.eye(3)).T


@exercise("3.6", "a number", fields={"largest entry": ""})
def axis_too_long() -> Iterator[Part]:
    """It is more than three times the error of the axis, and the formula gives no warning."""
    n = np.array([0, 0.6, 0.8])

    def residual(matrix: Any) -> Any:
        return np.abs(matrix.T @ matrix - np.eye(3)).max()

    bent = as_printed(1.001 * n, np.pi / 2)
    hints = {
        "You turned by 90 radians.": when(
            residual(as_printed(1.001 * n, 90)), "np.deg2rad converts an angle."
        ),
        "This is how far the matrix is from the right one.": when(
            np.abs(bent - as_printed(n, np.pi / 2)).max(),
            "The question is how far it is from being a rotation at all.",
        ),
        "This compares the matrix with the identity, but it turns by 90°.": when(
            np.abs(bent - np.eye(3)).max(), "Multiply the matrix by its transpose first."
        ),
        "This is the error of the axis.": when(
            0.001, "Compute the matrix first, then what its transpose times itself should be."
        ),
        "The number is close, but not to two digits.": when(
            0.003, "Three times the error of the axis is only a guess. Compute the matrix."
        ),
        "An axis of length 1 would give 0.": when(
            0, "Use the function of the starter cell, which leaves the axis as it is."
        ),
        "This is not the size of the largest entry.": otherwise(
            "Let M be `as_printed(too_long, np.pi / 2)`. Take the largest of the absolute values of"
            " MᵀM − I."
        ),
    }
    yield Part(residual(bent), hints, within=6e-5)


@exercise(
    "3.7", "an axis of three numbers and an angle in radians", read=parts(numbers(3), numbers())
)
def rotation_of_a_spoon() -> Iterator[Part]:
    """Thousands of vertices average out the noise of each."""
    secret = np.random.default_rng(12)
    truth = rotation_matrix(secret.normal(size=3), secret.uniform(0, np.pi))
    n, turn = axis_angle(truth)

    def right(axis: Array, angle: Array) -> bool:
        # Every axis and angle of one rotation become the same ones.
        axis, angle = axis_angle(rotation_matrix(axis, angle))
        return close(angle, turn, np.deg2rad(0.1)) and close(axis, n, 1e-2)

    hints = {
        "Your angle is in degrees.": when(
            lambda axis, angle: close(abs(angle), np.rad2deg(turn), 0.1),
            "axis_angle gives radians, and so should you.",
            example=(n, np.rad2deg(turn)),
        ),
        "You turn the spoon back.": when(
            lambda axis, angle: same_rotation((axis, angle), truth.T, 2e-2),
            "The matrix in the hint has the points after the turn on the left.",
            example=(n, -turn),
        ),
        "Your axis does not have length 1.": when(
            lambda axis, angle: not unit(axis, 1e-2),
            "Divide it by its length.",
            example=(2 * n, turn),
        ),
        "You are close, but not within 0.1° and 0.01.": when(
            lambda axis, angle: same_rotation((axis, angle), truth, 3e-2),
            "Use all the vertices, and round at the end, if at all.",
            example=(n, turn.round(2)),
        ),
        "The spoon does not arrive where it was measured.": otherwise(
            "Turn the points by your axis and angle. The rest should be as small as the noise.",
            example=(n, turn + 0.1),
        ),
    }
    yield Part(lambda axis, angle: unit(axis, 1e-2) and right(axis, angle), hints)
    yield Part(lambda *turn: not same_rotation(turn, truth, 1e-5), the_truth(example=(n, turn)))


TURNED = [
    (np.array([3.0, 0, 0]), np.array([1, 2, 2]) / 3, np.pi / 2),
    (np.array([1.0, -2, 0.5]), np.array([2, -1, 2]) / 3, -0.7),
    (np.array([0.2, 1, 1]), np.array([0, 0, 1.0]), 2.5),
]


@exercise(
    "3.1",
    "a function of a vector, a unit vector and an angle that returns a vector",
    read=outcomes(TURNED),
)
def rodrigues_formula() -> Iterator[Part]:
    """One line turns any point about any axis."""

    rows = outcomes(TURNED)

    def with_along(factor: Callable[[float], float]) -> Array:
        """Give the part along the axis another factor than 1."""
        return rows(lambda r, n, t: rotate(r, n, t) + (factor(t) - 1) * (r @ n) * n)

    hints = {
        "Your vectors turn clockwise.": when(
            rows(lambda r, n, t: rotate(r, n, -t)),
            "Is it n before r in the cross product, or r before n?",
        ),
        "Did you count the part along the axis twice?": when(
            with_along(lambda t: 1 + np.cos(t)),
            "cos θ r contains cos θ times that part already.",
        ),
        "The part along the axis is lost.": when(
            with_along(lambda t: 0), "How much of r lies along n, and how much of it should remain?"
        ),
        "Are your angles in degrees?": when(
            rows(lambda r, n, t: rotate(r, n, np.deg2rad(t))),
            "The functions of this book take radians.",
        ),
        "Your vectors go elsewhere.": otherwise(
            "Try a quarter turn of (3, 0, 0) about (1, 2, 2)/3, as in the first section."
        ),
    }
    yield Part(rows(rotate), hints)
