"""Checks of the exercises of page D."""

from collections.abc import Iterator

import numpy as np

from rotedu._vectors import Array
from rotedu.averages import angular_distance
from rotedu.edition.exercises.answers import numbers, outcomes
from rotedu.edition.exercises.judging import Part, exercise, in_radians, otherwise, when
from rotedu.five_numbers import five_numbers, matrix_from_two_columns
from rotedu.general_rotation import euler_angles, matrix_from_euler_angles
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion

SOME = rotation_matrix([[1, 2, 2], [0, 3, 4], [1, 1, 0]], [0.7, -2.0, np.pi])


@exercise(
    "D.1",
    "a function of a matrix, shape (3, 3), that returns five numbers",
    read=outcomes([(matrix,) for matrix in SOME]),
)
def five_on_a_map() -> Iterator[Part]:
    """The denominator is at least 0.41, since no entry exceeds 1."""
    six = np.concatenate([SOME[:, :, 0], SOME[:, :, 1]], axis=1)
    rows = np.concatenate([SOME[:, 0], SOME[:, 1]], axis=1)
    hints = {
        "You took rows for columns.": when(
            rows[:, 1:] / (2**0.5 - rows[:, :1]), "`M[:, 0]` is the first column."
        ),
        "You forgot to divide.": when(six[:, 1:], "By how much is the first number short of √2?"),
        "Your map is seen from another point.": when(
            six[:, 1:] / (1 - six[:, :1]),
            "The radius of the sphere is √2: two columns of length 1.",
            also=six[:, 1:] / (2**0.5 + six[:, :1]),
        ),
        "These are other numbers.": otherwise(
            "Five numbers, divided by √2 less the one that is left out, a₁."
        ),
    }
    yield Part(five_numbers(SOME), hints)


@exercise("D.2", "five numbers, 0 or 1")
def threads_that_come_off() -> Iterator[Part]:
    """Crossings go in pairs, so an odd number never becomes none."""
    hints = {
        "You have exchanged yes and no.": when(
            [0, 1, 0, 1, 0], "1 is for a thread that can be pulled to a point."
        ),
        "Only what never leaves?": when(
            [1, 0, 0, 0, 0], "Two crossings can be pulled out of the skin together."
        ),
        "Not all of them.": otherwise("By how much does a pull change the number of crossings?"),
    }
    yield Part(np.array([1, 0, 1, 0, 1]), hints, within=0)


def halfway_errors() -> Array:
    """Return the errors, in degrees, halfway between the rows: a row for each form.

    The forms are the four of the exercise and, last, Euler angles without jumps.
    """
    table, truth = (
        rotation_matrix([1, 2, 2], np.deg2rad(np.arange(*degrees)))
        for degrees in [(5, 366, 10), (10, 361, 10)]
    )
    q = Quaternion.from_matrix(table).components
    signs = np.cumprod(np.sign(np.sum(q[1:] * q[:-1], axis=1)))
    followed = np.concatenate([q[:1], signs[:, np.newaxis] * q[1:]])

    def middle(rows: Array) -> Array:
        return (rows[1:] + rows[:-1]) / 2

    def matrices(rows: Array) -> Array:
        return Quaternion(rows[:, 0], rows[:, 1:]).matrix()

    def from_angles(angles: Array) -> Array:
        return matrix_from_euler_angles(*middle(angles).T)[:, :3, :3]

    angles, columns = np.stack(euler_angles(table), axis=-1), middle(table)
    found = [
        from_angles(angles),
        matrices(middle(q)),
        matrices(middle(followed)),
        matrix_from_two_columns(columns[..., 0], columns[..., 1]),
        from_angles(np.unwrap(angles, axis=0)),
    ]
    return np.rad2deg([angular_distance(truth, way) for way in found])


@exercise(
    "D.5",
    "four angles in degrees",
    fields={
        "Euler angles": "°",
        "quaternions as they come": "°",
        "quaternions followed": "°",
        "two columns": "°",
    },
)
def worst_of_a_table() -> Iterator[Part]:
    """A sign that is followed is as good as two columns; a rule for the sign is not."""
    errors = halfway_errors()
    euler, rule, followed, columns, unwrapped = errors.max(axis=1)
    right = np.array([euler, rule, followed, columns])
    hints = {
        **in_radians(np.deg2rad(right)),
        "These are mean errors.": when(
            errors[:4].mean(axis=1), "One bad row is enough to break a machine. Take the worst."
        ),
        "Your followed quaternions still jump.": when(
            [euler, rule, rule, columns],
            "Compare each with the one before it, as it is after its own sign has been chosen.",
        ),
        "Your second form has no jump.": when(
            [euler, followed, followed, columns], "Leave the signs as `from_matrix` chooses them."
        ),
        "These are chords.": when(
            2 * 2**0.5 * np.sin(np.deg2rad(right) / 2),
            "The exercise asks for angles. Which function measures them?",
        ),
        "Your Euler angles do not jump.": when(
            [unwrapped, rule, followed, columns],
            "The machine knows nothing of full turns. Average the angles as `euler_angles` gives"
            " them.",
        ),
        "In each form, take the mean of neighbouring rows, make a rotation,"
        " and compare.": otherwise(
            "The truth halfway is a turn about the same axis by 10°, 20°, 30° and so on."
        ),
    }
    yield Part(right, hints, within=0.1)


@exercise("D.3", "three numbers", fields={"about U": "", "about V": "", "about W": ""})
def stretched_most() -> Iterator[Part]:
    """Both columns move if the turn is about W, and only one of them if it is about U or V."""
    map_scale = 1 / (2**0.5 - 1)
    right = map_scale * np.array([1, 1, 2**0.5])
    hints = {
        "You left the map out.": when(
            [1, 1, 2**0.5], "These are the moves of the six numbers. Divide by √2 − a₁."
        ),
        "Both columns move about W.": when(
            [map_scale] * 3, "Add their squares: about W the first moves to V, the second to −U."
        ),
        "The two moves are at right angles in six dimensions.": when(
            map_scale * np.array([1, 1, 2]), "Lengths add by their squares, not as numbers."
        ),
        "Each turn moves another number of columns.": otherwise(
            "Without a turn a = (1, 0, 0) and b = (0, 1, 0). Which of the two does U leave alone?"
        ),
    }
    yield Part(right, hints, within=5e-3)


@exercise("D.4", "the numbers of five lines, in order", read=numbers(5))
def no_rule_without_a_jump() -> Iterator[Part]:
    """Followed round once, a quaternion becomes the other one, which no rule can allow."""
    hints = {
        "One of your lines is not true.": when(
            lambda lines: 3 in lines,
            "Which line would make every rule fail at once?",
            example=[4, 6, 2, 3, 1],
        ),
        "It begins with what is to be refuted.": when(
            lambda lines: lines[0] != 4, "Which line says *suppose*?", example=[6, 4, 2, 5, 1]
        ),
        "It ends with what cannot be.": when(
            lambda lines: lines[-1] != 1,
            "Which line says that two things do not agree?",
            example=[4, 6, 2, 1, 5],
        ),
        "In between, each line needs the one before.": otherwise(
            "Two candidates; far apart; so no change from one to the other; so at the end...",
            example=[4, 2, 6, 5, 1],
        ),
    }
    yield Part([4, 6, 2, 5, 1], hints, within=0)
