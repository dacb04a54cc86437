"""Checks of the exercises of Chapter 1."""

from itertools import combinations
from typing import Any

import numpy as np

from rotedu.cost import count
from rotedu.edition.exercises.judging import (
    Wrong,
    as_array,
    as_number,
    as_parts,
    as_word,
    close,
    exercise,
    judged,
    radians_for_degrees,
    same_rotation,
)
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion


@exercise("1.1", expects="a matrix, shape (3, 3)", because="The columns say where the axes go.")
def axes_in_turn(answer: Any) -> Wrong | None:
    """Compare with the matrix whose columns are V, W and U."""
    right = np.roll(np.eye(3), 1, axis=0)
    return judged(
        as_array(answer, (3, 3)),
        right,
        (
            right.T,
            Wrong(
                "Your matrix turns the other way: it takes V to U.",
                "Do the images of the axes stand in the rows of a matrix, or in its columns?",
            ),
        ),
        (
            np.eye(3),
            Wrong("This matrix leaves every axis where it is.", "Multiply it by the axis U."),
        ),
        otherwise=Wrong(
            "Some axis does not go where it should.",
            "Multiply your matrix by the column (1, 0, 0), and see which part of it you get.",
        ),
    )


@exercise(
    "1.2",
    expects='an axis of three numbers, an angle in degrees, and "same", "inverse" or "another"',
    because="All four signs together make no difference.",
)
def quaternion_of_a_friend(answer: Any) -> Wrong | None:
    """Accept every axis and angle of the rotation."""
    axis, angle, word = as_parts(answer, 3)
    n, degrees = as_array(axis, (3,)), as_number(angle)
    verdict = as_word(word, ("same", "inverse", "another"))
    friend = Quaternion(0.6, [0, 0, -0.8])
    right = np.rad2deg(friend.axis_angle()[1])
    if not close(np.linalg.norm(n), 1, 1e-3):
        return Wrong(
            "Your axis does not have length 1.",
            "The vector in the quaternion is the axis times a sine. Divide by that sine.",
        )
    if radians_for_degrees(abs(degrees), right):
        return Wrong("Your angle is in radians.", "A full turn has 360 degrees.")
    if close(abs(degrees), right / 2, 0.1):
        return Wrong("You found half the angle.", "Of which angle is 0.6 the cosine?")
    turned = n, np.deg2rad(degrees)
    if same_rotation(turned, friend.conjugate(), 2e-3):
        return Wrong(
            "This turns in the opposite sense.",
            "A positive sine has the sign of the axis left over. Look at the sign of -0.8.",
        )
    if not same_rotation(turned, friend, 2e-3):
        return Wrong(
            "Axis and angle do not make this quaternion.",
            "Compare the cosine and the sine of half your angle with the four numbers.",
        )
    if verdict != "same":
        return Wrong(
            "The second quaternion is judged wrong.",
            "Find its axis and its angle as well, and turn a point by both.",
        )
    return None


@exercise(
    "1.3",
    expects="a column of three numbers, a pair of counts, and a matrix of shape (3, 3)",
    because="Two columns are enough, and the corner is not.",
)
def columns_left_out(answer: Any) -> Wrong | None:
    """Test the third column, its cost, and the other rotation with the same corner."""
    column, counts, matrix = as_parts(answer, 3)
    first, second = np.array([[0.36, 0.8, 0.48], [-0.48, 0.6, -0.64]])
    third, spent = as_array(column, (3,)), as_array(counts, (2,))
    another = as_array(matrix, (3, 3))
    right = np.cross(first, second)
    wrong = judged(
        third,
        right,
        (
            -right,
            Wrong(
                "With this third column the matrix mirrors.",
                "It is perpendicular to the others. In which order did you multiply them?",
            ),
        ),
        otherwise=Wrong(
            "The third column does not complete a rotation matrix.",
            "It has length 1, and it is perpendicular to both of the others.",
        ),
    )
    if wrong:
        return wrong
    cost = count(np.cross, first, second)
    if not close(spent, [cost.multiplications, cost.additions]):
        return Wrong(
            "The counts are not those of the cheapest way.",
            "Write out one entry of the third column and count. A subtraction is an addition.",
        )
    given = np.column_stack([first, second, right])
    if not close(another[:2, :2], given[:2, :2]):
        return Wrong(
            "Your other matrix has another corner.",
            "Keep the four entries in the upper left, and change signs among the other five.",
        )
    if close(another, given):
        return Wrong(
            "Your other matrix is the one that you have completed.",
            "Does a rotation have to keep the third row of this one?",
        )
    if not close(another.T @ another, np.eye(3)) or np.linalg.det(another) < 0:
        return Wrong(
            "Your other matrix is not a rotation.",
            "Its columns must be perpendicular and of length 1, and its determinant must be 1.",
        )
    return None


@exercise(
    "1.4",
    expects="choices of three row numbers from 0 to 8, an array of shape (number of choices, 3)",
    because="Length 1 ties the entries of each row and of each column.",
)
def never_free(answer: Any) -> Wrong | None:
    """Compare with the choices of deficient rank at random rotations, in any order."""
    chosen = {frozenset(choice) for choice in as_array(answer, (None, 3))}
    sample = np.random.default_rng(13)
    some = rotation_matrix(sample.normal(size=(100, 3)), sample.uniform(-3, 3, 100))
    moves = [np.cross(axis, some, axisb=1, axisc=1).reshape(100, 9) for axis in np.eye(3)]
    threes = np.array(list(combinations(range(9), 3)))
    free = np.linalg.matrix_rank(np.stack(moves, axis=-1)[:, threes]) == 3
    never, ever = (
        {frozenset(choice) for choice in threes[mask].astype(float)}
        for mask in (~free.any(axis=0), free.any(axis=0))
    )
    if chosen == never:
        return None
    if chosen == ever:
        return Wrong("These are the choices that are free.", "The question asks for the others.")
    if max(map(max, chosen)) > 8:
        return Wrong("A row number is too large.", "The nine rows have the numbers 0 to 8.")
    if chosen < never:
        return Wrong(
            "All of these belong to the list, but some are missing.",
            "What holds for a matrix often holds for its transpose as well.",
        )
    return Wrong(
        "Some of these choices can be free.",
        "A choice belongs to the list if its rank is below 3 at every one of the rotations.",
    )
