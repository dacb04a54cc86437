"""Checks of the exercises of Chapter 3."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from rotedu.edition.exercises.judging import (
    Numbers,
    Wrong,
    as_array,
    as_number,
    as_parts,
    as_word,
    close,
    degrees_for_radians,
    exercise,
    numeric,
    radians_for_degrees,
    same_rotation,
)
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix


@numeric(
    "3.1",
    fields={"U": "", "V": "", "W": ""},
    expects="a point, three numbers",
    because="What lies along the axis stays where it is.",
)
def quarter_turn_of_a_point() -> Iterator[Numbers]:
    """Yield the turned point, then what other senses, angles and axes lead to."""
    point, w = [1, 2, 3], [0, 0, 1]
    yield Numbers(
        rotate(point, w, np.pi / 2),
        (
            rotate(point, w, -np.pi / 2),
            Wrong("This turns clockwise.", "Seen from the tip of W, where does U go first?"),
        ),
        (
            rotate(point, w, 90),
            Wrong(
                "You turned by 90 radians.",
                "The functions of this book take radians; np.deg2rad converts.",
            ),
        ),
        (
            rotate(point, w, np.pi),
            Wrong("This is a half turn.", "A full turn has 360 degrees."),
        ),
        (
            rotate(point, [1, 0, 0], np.pi / 2),
            Wrong("You turned about U.", "Which coordinate must not change?"),
        ),
        (
            rotate(point, [0, 1, 0], np.pi / 2),
            Wrong("You turned about V.", "Which coordinate must not change?"),
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
)
def axis_and_angle_of_a_matrix(answer: Any) -> Wrong | None:
    """Accept an axis and an angle that are both opposite."""
    n, angle = as_parts(answer, 2)
    axis, degrees = as_array(n, (3,)), as_number(angle)
    matrix = np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
    right = np.rad2deg(axis_angle(matrix)[1])
    turned = axis, np.deg2rad(degrees)
    if radians_for_degrees(abs(degrees), right):
        return Wrong("Your angle is in radians.", "A full turn has 360 degrees.")
    if same_rotation(turned, matrix.T, 2e-3):
        return Wrong(
            "This is the inverse rotation.",
            "In each difference, which of the two entries comes first?",
        )
    if close(abs(degrees), np.rad2deg(np.arccos(matrix.trace() / 3)), 0.1):
        return Wrong("The trace is not three times the cosine.", "What is the trace of (3-3)?")
    if not close(abs(degrees), right, 0.1) and not same_rotation(turned, matrix, 2e-3):
        return Wrong(
            "The angle is not that of the matrix.",
            "The trace is the sum of the diagonal. How does it depend on the angle?",
        )
    if not close(np.linalg.norm(axis), 1, 1e-3):
        return Wrong(
            "Your axis does not have length 1.",
            "The differences give a multiple of the axis. Divide by its length.",
        )
    if not same_rotation(turned, matrix, 2e-3):
        return Wrong(
            "The axis is not that of the matrix.",
            "Multiply the matrix by your axis: it should not change.",
        )
    return None


@exercise(
    "3.3",
    expects='two words, each of them "same", "negative", "transpose" or "identity"',
    because="It is the inverse rotation, both times.",
)
def turned_back(answer: Any) -> Wrong | None:
    """Compute the matrix that each word names, and accept the inverse under its own name."""
    words = [
        as_word(word, ("same", "negative", "transpose", "inverse", "identity"))
        for word in as_parts(answer, 2)
    ]
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
    wrong = [
        word for word, matrix in zip(words, changed, strict=True) if not close(named[word], matrix)
    ]
    if not wrong:
        return None
    if "negative" in wrong:
        return Wrong(
            "The negative of a rotation matrix mirrors.",
            "(3-3) is a sum of three matrices. Which of them changes its sign?",
        )
    if "identity" in wrong:
        return Wrong(
            "One matrix of the two still turns points.",
            "You get the identity if you turn forward and then back. Here you only turn once.",
        )
    return Wrong(
        "One matrix of the two does change.",
        "Where does the sine change its sign, and where does the axis appear once, not twice?",
    )


@exercise(
    "3.4",
    expects="two pairs, each of an axis and an angle in degrees",
    because="Angles do not add up when the axes differ.",
)
def two_turns_in_a_row(answer: Any) -> Wrong | None:
    """Accept every axis and angle of the two rotations."""
    given = [
        (as_array(axis, (3,)), as_number(degrees))
        for axis, degrees in (as_parts(pair, 2) for pair in as_parts(answer, 2))
    ]
    u, v = [1, 0, 0], [0, 1, 0]
    (u2, v2), (u4, v4) = (
        [rotation_matrix(axis, angle) for axis in (u, v)] for angle in (np.pi, np.pi / 2)
    )
    halves, quarters = ((axis, np.deg2rad(degrees)) for axis, degrees in given)
    pairs = zip(given, (v2 @ u2, v4 @ u4), strict=True)
    if all(same_rotation(turn, matrix, 1e-2) for turn, matrix in pairs):
        return Wrong("Your angles are in radians.", "A full turn has 360 degrees.")
    if not same_rotation(halves, v2 @ u2, 1e-2):
        return Wrong(
            "The two half turns make another rotation.",
            "Follow the tip of each axis through both turns. Which axis comes back?",
        )
    if same_rotation(quarters, v4 @ u4, 1e-2):
        return None
    if same_rotation(quarters, u4 @ v4, 1e-2):
        return Wrong(
            "For the quarter turns, V came before U.",
            "In a product that acts on a column, which factor acts first?",
        )
    if same_rotation(quarters, (v4 @ u4).T, 1e-2):
        return Wrong("The quarter turns go backwards.", "Reverse the axis or the angle.")
    if close(abs(given[1][1]), 180, 0.1) or close(abs(given[1][1]), 90, 0.1):
        return Wrong(
            "The quarter turns make another angle.",
            "Do it with a book: how often must you repeat both turns until it is back?",
        )
    return Wrong(
        "The two quarter turns make another rotation.",
        "Multiply the two matrices, and give the product to axis_angle.",
    )


def as_printed(n: Any, angle: float) -> Any:
    """(3-3) with the axis taken as it comes."""
    cos, sin = np.cos(angle), np.sin(angle)
    return cos * np.eye(3) + (1 - cos) * np.outer(n, n) + sin * np.cross(n, np.eye(3)).T


@numeric(
    "3.5",
    fields={"largest entry": ""},
    expects="a number",
    because="It is more than three times the error of the axis, and the formula gives no warning.",
)
def axis_too_long() -> Iterator[Numbers]:
    """Yield the residual, then other residuals."""
    n = np.array([0, 0.6, 0.8])

    def residual(matrix: Any) -> Any:
        return np.abs(matrix.T @ matrix - np.eye(3)).max()

    bent = as_printed(1.001 * n, np.pi / 2)
    yield Numbers(
        residual(bent),
        (
            residual(as_printed(1.001 * n, 90)),
            Wrong("You turned by 90 radians.", "np.deg2rad converts an angle."),
        ),
        (
            np.abs(bent - as_printed(n, np.pi / 2)).max(),
            Wrong(
                "This is how far the matrix is from the right one.",
                "The question is how far it is from being a rotation at all.",
            ),
        ),
        (
            np.abs(bent - np.eye(3)).max(),
            Wrong(
                "This compares the matrix with the identity, but it turns by 90°.",
                "Multiply the matrix by its transpose first.",
            ),
        ),
        (
            0.001,
            Wrong(
                "This is the error of the axis.",
                "Compute the matrix first, then what its transpose times itself should be.",
            ),
        ),
        (
            0,
            Wrong(
                "This axis was scaled to length 1.",
                "Use the function of the starter cell, which leaves the axis as it is.",
            ),
        ),
        otherwise=Wrong(
            "The largest entry has another size.",
            "Let M be `as_printed(too_long, np.pi / 2)`. Take the largest of the absolute values of"
            " MᵀM − I.",
        ),
        within=6e-5,
    )


@exercise(
    "3.6",
    expects="an axis of three numbers and an angle in radians",
    because="Thousands of vertices average out the noise of each.",
)
def rotation_of_a_spoon(answer: Any) -> Wrong | None:
    """Compare with the truth, up to the noise."""
    n, turn = as_parts(answer, 2)
    axis, angle = as_array(n, (3,)), as_number(turn)
    secret = np.random.default_rng(12)
    truth = rotation_matrix(secret.normal(size=3), secret.uniform(0, np.pi))
    true_axis, true_angle = axis_angle(truth)
    if degrees_for_radians(abs(angle), true_angle):
        return Wrong("Your angle is in degrees.", "axis_angle gives radians, and so should you.")
    found = rotation_matrix(axis, angle)
    if same_rotation(found, truth.T, 2e-2):
        return Wrong(
            "You turn the spoon back.",
            "The matrix in the hint has the points after the turn on the left.",
        )
    if not close(np.linalg.norm(axis), 1, 1e-2):
        return Wrong("Your axis does not have length 1.", "Divide it by its length.")
    sign = np.sign(axis @ true_axis)
    if close(sign * angle, true_angle, np.deg2rad(0.1)) and close(sign * axis, true_axis, 1e-2):
        return None
    return Wrong(
        "The spoon does not arrive where it was measured.",
        "Turn the points by your axis and angle. The rest should be as small as the noise.",
    )
