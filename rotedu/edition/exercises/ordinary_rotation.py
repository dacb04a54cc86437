"""Checks of the exercises of Chapter 3."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from rotedu._vectors import Array
from rotedu.edition.exercises.judging import (
    NOT_THE_TRUTH,
    YOUR_RADIANS,
    Mistake,
    Part,
    Wrong,
    close,
    degrees_for_radians,
    exercise,
    numbers,
    parts,
    radians_for_degrees,
    same_rotation,
    same_turn,
    unit,
    word,
)
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix


@exercise(
    "3.1",
    fields={"U": "", "V": "", "W": ""},
    expects="a point, three numbers",
    because="What lies along the axis stays where it is.",
)
def quarter_turn_of_a_point() -> Iterator[Part]:
    """Yield the turned point, then what other senses, angles and axes lead to."""
    point, w = [1, 2, 3], [0, 0, 1]
    yield Part(
        rotate(point, w, np.pi / 2),
        Mistake(
            rotate(point, w, -np.pi / 2),
            "This turns clockwise.",
            "Seen from the tip of W, where does U go first?",
        ),
        Mistake(
            rotate(point, w, 90),
            "You turned by 90 radians.",
            "The functions of this book take radians; np.deg2rad converts.",
        ),
        Mistake(rotate(point, w, np.pi), "This is a half turn.", "A full turn has 360 degrees."),
        Mistake(
            rotate(point, [1, 0, 0], np.pi / 2),
            "You turned about U.",
            "Which coordinate must not change?",
        ),
        Mistake(
            rotate(point, [0, 1, 0], np.pi / 2),
            "You turned about V.",
            "Which coordinate must not change?",
        ),
        otherwise=Wrong(
            "The point has gone elsewhere.",
            "One coordinate stays. The other two change places, and one of them its sign.",
        ),
        within=1e-3,
    )


@exercise(
    "3.2",
    expects="an axis of three numbers and an angle in degrees",
    because="The trace shows the angle, and three differences show the axis.",
    read=parts(numbers(3), numbers()),
)
def axis_and_angle_of_a_matrix() -> Iterator[Part]:
    """Accept an axis and an angle that are both opposite."""
    matrix = np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
    right = np.rad2deg(axis_angle(matrix)[1])
    one_third = np.rad2deg(np.arccos(matrix.trace() / 3))
    n = np.ones(3) / np.sqrt(3)
    yield Part(
        lambda axis, degrees: unit(axis, 1e-2) and same_turn((axis, degrees), matrix, 2e-3),
        Mistake(
            lambda axis, degrees: radians_for_degrees(abs(degrees), right),
            *YOUR_RADIANS,
            example=(n, np.pi / 3),
        ),
        Mistake(
            lambda *turn: same_turn(turn, matrix.T, 2e-3),
            "This is the inverse rotation.",
            "In each difference, which of the two entries comes first?",
            example=(-n, 60),
        ),
        Mistake(
            lambda axis, degrees: close(abs(degrees), one_third, 0.1),
            "The trace is not three times the cosine.",
            "What is the trace of (3-3)?",
            example=(n, 48.19),
        ),
        Mistake(
            lambda axis, degrees: (
                not close(abs(degrees), right, 0.1) and not same_turn((axis, degrees), matrix, 2e-3)
            ),
            "The angle is not that of the matrix.",
            "The trace is the sum of the diagonal. How does it depend on the angle?",
            example=(n, 30),
        ),
        Mistake(
            lambda axis, degrees: not unit(axis, 1e-2),
            "Your axis does not have length 1.",
            "The differences give a multiple of the axis. Divide by its length.",
            example=([1, 1, 1], 60),
        ),
        otherwise=Wrong(
            "The axis is not that of the matrix.",
            "Multiply the matrix by your axis: it should not change.",
        ),
        example=([1, 0, 0], 60),
    )


@exercise(
    "3.3",
    expects=(
        'two words, the first for -turn, the second for -diagonal, each of them "same",'
        ' "negative", "transpose" or "identity"'
    ),
    because="It is the inverse rotation, both times.",
    read=parts(*2 * [word("same", "negative", "transpose", "inverse", "identity")]),
)
def turned_back() -> Iterator[Part]:
    """Compute the matrix that each word names, and accept the inverse under its own name."""
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

    yield Part(
        lambda *words: not wrong(*words),
        Mistake(
            lambda *words: "negative" in wrong(*words),
            "The negative of a rotation matrix mirrors.",
            "(3-3) is a sum of three matrices. Which of them changes its sign?",
            example=("negative", "negative"),
        ),
        Mistake(
            lambda *words: "identity" in wrong(*words),
            "One of the two matrices still turns points.",
            "Turning forward and then back gives the identity, but here you turn only once.",
            example=("identity", "transpose"),
        ),
        otherwise=Wrong(
            "A matrix that you call the same does change.",
            "Where does the sine change its sign, and where does the axis appear once, not twice?",
        ),
        example=("transpose", "same"),
    )


@exercise(
    "3.4",
    expects="two pairs, each of an axis and an angle in degrees",
    because="Angles do not add up when the axes differ.",
    read=parts(*2 * [parts(numbers(3), numbers())]),
)
def two_turns_in_a_row() -> Iterator[Part]:
    """Accept every axis and angle of the two rotations."""
    u, v, w = np.eye(3)
    (u2, v2), (u4, v4) = (
        [rotation_matrix(axis, angle) for axis in (u, v)] for angle in (np.pi, np.pi / 2)
    )

    yield Part(
        lambda halves, quarters: same_turn(halves, v2 @ u2, 1e-2),
        Mistake(
            lambda halves, quarters: (
                same_rotation(halves, v2 @ u2, 1e-2) and same_rotation(quarters, v4 @ u4, 1e-2)
            ),
            "Your angles are in radians.",
            "A full turn has 360 degrees.",
            example=((w, np.pi), ([1, 1, -1], 2 * np.pi / 3)),
        ),
        otherwise=Wrong(
            "The two half turns make another rotation.",
            "Follow the tip of each axis through both turns. Which axis comes back?",
        ),
        example=(([1, 1, 0], 180), ([1, 1, -1], 120)),
    )
    yield Part(
        lambda *turn: same_turn(turn, v4 @ u4, 1e-2),
        Mistake(
            lambda *turn: same_turn(turn, u4 @ v4, 1e-2),
            "For the quarter turns, V came before U.",
            "In a product that acts on a column, which factor acts first?",
            example=((w, 180), ([1, 1, 1], 120)),
        ),
        Mistake(
            lambda *turn: same_turn(turn, (v4 @ u4).T, 1e-2),
            "The quarter turns go backwards.",
            "Reverse the axis or the angle.",
            example=((w, 180), ([-1, -1, 1], 120)),
        ),
        Mistake(
            lambda axis, degrees: close(abs(degrees), 180, 0.1) or close(abs(degrees), 90, 0.1),
            "The quarter turns make another angle.",
            "Do it with a book: how often must you repeat both turns until it is back?",
            example=((w, 180), ([1, 1, -1], 180)),
        ),
        otherwise=Wrong(
            "The two quarter turns make another rotation.",
            "Multiply the two matrices, and give the product to axis_angle.",
        ),
        item=1,
        example=((w, 180), ([1, 0, -1], 120)),
    )


def as_printed(n: Any, angle: float) -> Any:
    """(3-3) with the axis taken as it comes."""
    cos, sin = np.cos(angle), np.sin(angle)
    return cos * np.eye(3) + (1 - cos) * np.outer(n, n) + sin * np.cross(n, np.eye(3)).T


@exercise(
    "3.5",
    fields={"largest entry": ""},
    expects="a number",
    because="It is more than three times the error of the axis, and the formula gives no warning.",
)
def axis_too_long() -> Iterator[Part]:
    """Yield the residual, then other residuals."""
    n = np.array([0, 0.6, 0.8])

    def residual(matrix: Any) -> Any:
        return np.abs(matrix.T @ matrix - np.eye(3)).max()

    bent = as_printed(1.001 * n, np.pi / 2)
    yield Part(
        residual(bent),
        Mistake(
            residual(as_printed(1.001 * n, 90)),
            "You turned by 90 radians.",
            "np.deg2rad converts an angle.",
        ),
        Mistake(
            np.abs(bent - as_printed(n, np.pi / 2)).max(),
            "This is how far the matrix is from the right one.",
            "The question is how far it is from being a rotation at all.",
        ),
        Mistake(
            np.abs(bent - np.eye(3)).max(),
            "This compares the matrix with the identity, but it turns by 90°.",
            "Multiply the matrix by its transpose first.",
        ),
        Mistake(
            0.001,
            "This is the error of the axis.",
            "Compute the matrix first, then what its transpose times itself should be.",
        ),
        Mistake(
            0.003,
            "The number is close, but not to two digits.",
            "Three times the error of the axis is only a guess. Compute the matrix.",
        ),
        Mistake(
            0,
            "This axis was scaled to length 1.",
            "Use the function of the starter cell, which leaves the axis as it is.",
        ),
        otherwise=Wrong(
            "This is not the size of the largest entry.",
            "Let M be `as_printed(too_long, np.pi / 2)`. Take the largest of the absolute values of"
            " MᵀM − I.",
        ),
        within=6e-5,
    )


@exercise(
    "3.6",
    expects="an axis of three numbers and an angle in radians",
    because="Thousands of vertices average out the noise of each.",
    read=parts(numbers(3), numbers()),
)
def rotation_of_a_spoon() -> Iterator[Part]:
    """Compare with the truth, up to the noise."""
    secret = np.random.default_rng(12)
    truth = rotation_matrix(secret.normal(size=3), secret.uniform(0, np.pi))
    n, turn = axis_angle(truth)

    def right(axis: Array, angle: Array) -> bool:
        # Every axis and angle of one rotation become the same ones.
        axis, angle = axis_angle(rotation_matrix(axis, angle))
        return close(angle, turn, np.deg2rad(0.1)) and close(axis, n, 1e-2)

    yield Part(
        lambda axis, angle: unit(axis, 1e-2) and right(axis, angle),
        Mistake(
            lambda axis, angle: degrees_for_radians(abs(angle), turn),
            "Your angle is in degrees.",
            "axis_angle gives radians, and so should you.",
            example=(n, np.rad2deg(turn)),
        ),
        Mistake(
            lambda axis, angle: same_rotation((axis, angle), truth.T, 2e-2),
            "You turn the spoon back.",
            "The matrix in the hint has the points after the turn on the left.",
            example=(n, -turn),
        ),
        Mistake(
            lambda axis, angle: not unit(axis, 1e-2),
            "Your axis does not have length 1.",
            "Divide it by its length.",
            example=(2 * n, turn),
        ),
        Mistake(
            lambda axis, angle: same_rotation((axis, angle), truth, 3e-2),
            "You are close, but not within 0.1° and 0.01.",
            "Use all the vertices, and round at the end, if at all.",
            example=(n, turn.round(2)),
        ),
        otherwise=Wrong(
            "The spoon does not arrive where it was measured.",
            "Turn the points by your axis and angle. The rest should be as small as the noise.",
        ),
        example=(n, turn + 0.1),
    )
    yield Part(
        lambda *turn: not same_rotation(turn, truth, 1e-5),
        otherwise=NOT_THE_TRUTH,
        example=(n, turn),
    )
