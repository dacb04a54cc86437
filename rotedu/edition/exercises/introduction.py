"""Checks of the exercises of Chapter 1."""

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from rotedu.cost import count
from rotedu.edition.exercises.answers import (
    close,
    numbers,
    parts,
    radians_for_degrees,
    same_turn,
    unit,
    word,
)
from rotedu.edition.exercises.judging import Part, angle_in_radians, exercise, otherwise, when
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion


@exercise("1.1", "a matrix, shape (3, 3)")
def axes_in_turn() -> Iterator[Part]:
    """The columns say where the axes go."""
    right = np.roll(np.eye(3), 1, axis=0)
    hints = {
        "Your matrix turns the other way: it takes V to U.": when(
            right.T, "Are the images of the axes the rows of a matrix, or its columns?"
        ),
        "This matrix leaves every axis where it is.": when(np.eye(3), "Multiply it by the axis U."),
        "At least one axis does not go where it should.": otherwise(
            "Multiply your matrix by the column (1, 0, 0), and see which part of it you get."
        ),
    }
    yield Part(right, hints)


@exercise(
    "1.2",
    'an axis of three numbers, an angle in degrees, and "same", "inverse" or "another"',
    read=parts(numbers(3), numbers(), word("same", "inverse", "another")),
)
def quaternion_of_a_friend() -> Iterator[Part]:
    """All four signs together make no difference."""
    friend = Quaternion(0.6, [0, 0, -0.8])
    right = np.rad2deg(friend.axis_angle()[1])
    hints = {
        "Your axis does not have length 1.": otherwise(
            "The vector in the quaternion is the axis times a sine. Divide by that sine.",
            example=([0, 0, -0.8], 106.26, "same"),
        )
    }
    yield Part(unit, hints, item=0)
    hints = {
        **angle_in_radians(
            lambda n, degrees: radians_for_degrees(abs(degrees), right),
            example=([0, 0, -1], 1.8546, "same"),
        ),
        "You found half the angle.": when(
            lambda n, degrees: close(abs(degrees), right / 2, 0.1),
            "Of which angle is 0.6 the cosine?",
            example=([0, 0, -1], 53.13, "same"),
        ),
        "Your angle is close. It needs more digits.": when(
            lambda *turn: same_turn(turn, friend, 2e-2),
            "Double the angle before you round it, not after.",
            example=([0, 0, -1], 106, "same"),
        ),
        "This turns in the opposite sense.": when(
            lambda *turn: same_turn(turn, friend.conjugate(), 2e-3),
            "If the sine is positive, the sign of -0.8 can only be that of the axis.",
            example=([0, 0, 1], 106.26, "same"),
        ),
        "Your axis and angle do not give this quaternion.": otherwise(
            "Compare the cosine and the sine of half your angle with the four numbers.",
            example=([0, 0, -1], 120, "same"),
        ),
    }
    yield Part(lambda *turn: same_turn(turn, friend, 2e-3), hints, item=slice(2))
    hints = {
        "You are wrong about the second quaternion.": otherwise(
            "Find its axis and its angle as well, and turn a point by each quaternion.",
            example=([0, 0, -1], 106.26, "inverse"),
        )
    }
    yield Part(lambda judgement: judgement == "same", hints, item=2)


@exercise(
    "1.3",
    "a column of three numbers, a pair of counts, and a matrix of shape (3, 3)",
    read=parts(numbers(3), numbers(2), numbers(3, 3)),
)
def columns_left_out() -> Iterator[Part]:
    """Two columns are enough, and the corner is not."""
    first, second = np.array([[0.36, 0.8, 0.48], [-0.48, 0.6, -0.64]])
    third = np.cross(first, second)
    hints = {
        "With this third column the matrix mirrors.": when(
            -third, "It is perpendicular to the others. In which order did you multiply them?"
        ),
        "The third column does not complete a rotation matrix.": otherwise(
            "The right one has length 1 and is perpendicular to both of the others."
        ),
    }
    yield Part(third, hints, item=0)
    cost = count(np.cross, first, second)
    hints = {
        "The two counts have changed places.": when(
            [cost.additions, cost.multiplications], "Multiplications come first."
        ),
        "The counts are not those of the cheapest way.": otherwise(
            "Write out one entry of the third column and count, with a subtraction as an addition."
        ),
    }
    yield Part([cost.multiplications, cost.additions], hints, item=1)
    given = np.column_stack([first, second, third])
    hints = {
        "Your other matrix has another corner.": when(
            lambda another: not close(another[:2, :2], given[:2, :2]),
            "Keep the four entries in the upper left, and change signs among the other five.",
            example=(third, (6, 3), np.eye(3)),
        ),
        "Your other matrix is the one that you have completed.": when(
            lambda another: close(another, given),
            "Does the same corner force the same third row?",
            example=(third, (6, 3), given),
        ),
        "Your other matrix is not a rotation.": when(
            lambda a: not (close(a.T @ a, np.eye(3)) and np.linalg.det(a) > 0),
            "Its columns must be perpendicular and of length 1, and its determinant must be 1.",
            example=(third, (6, 3), given @ np.diag([1, 1, -1])),
        ),
    }
    yield Part(None, hints, item=2)


@exercise(
    "1.4",
    "choices of three row numbers from 0 to 8, an array of shape (number of choices, 3)",
    read=lambda answer: {frozenset(choice) for choice in numbers(None, 3)(answer)},
)
def never_free() -> Iterator[Part]:
    """Length 1 ties the entries of each row and of each column."""
    sample = np.random.default_rng(13)
    some = rotation_matrix(sample.normal(size=(100, 3)), sample.uniform(-3, 3, 100))
    moves = [np.cross(axis, some, axisb=1, axisc=1).reshape(100, 9) for axis in np.eye(3)]
    threes = np.array(list(combinations(range(9), 3)))
    free = (np.linalg.matrix_rank(np.stack(moves, axis=-1)[:, threes]) == 3).any(axis=0)
    never, ever = (
        {frozenset(choice) for choice in threes[mask].astype(float)} for mask in (~free, free)
    )
    rows = np.arange(9).reshape(3, 3)
    hints = {
        "These are the choices that are free.": when(
            lambda chosen: chosen == ever,
            "The question asks for the others.",
            example=threes[free],
        ),
        "One of your choices names a row twice.": when(
            lambda chosen: min(map(len, chosen)) < 3,
            "Choose three different rows; itertools.combinations does so.",
            example=[*rows, [0, 0, 1]],
        ),
        "A row number is too large.": when(
            lambda chosen: max(map(max, chosen)) > 8,
            "The nine rows have the numbers 0 to 8.",
            example=rows + 1,
        ),
        "All of these belong to the list, but some are missing.": when(
            lambda chosen: chosen < never,
            "What holds for a matrix often holds for its transpose as well.",
            example=rows,
        ),
        "At least one of these choices can be free.": otherwise(
            "A choice belongs to the list if its rank is below 3 at every one of the rotations.",
            example=[*rows, *rows.T, [0, 4, 8]],
        ),
    }
    yield Part(lambda chosen: chosen == never, hints)
