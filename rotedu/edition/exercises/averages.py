"""Checks of the exercises of page B."""

from collections.abc import Iterator

import numpy as np

from rotedu.averages import angular_distance, mean_rotation
from rotedu.edition.exercises.answers import as_array, as_rotation
from rotedu.edition.exercises.judging import (
    Part,
    exercise,
    in_radians,
    otherwise,
    scalar_last,
    the_truth,
    when,
)
from rotedu.five_numbers import matrix_from_two_columns
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion


@exercise("B.1", "three distances", fields={"matrices": "", "quaternions": "", "other sign": ""})
def three_chords() -> Iterator[Part]:
    """The two chords of quaternions and a diameter make a right-angled triangle."""
    theta = np.deg2rad(60)
    right = np.array([2 * 2**0.5 * np.sin(theta / 2), 2 * np.sin(theta / 4), 2 * np.cos(theta / 4)])
    matrices, quaternions, other = right
    hints = {
        "You take the sine of twice the angle that belongs in it.": when(
            [2 * 2**0.5 * np.sin(theta), 2 * np.sin(theta / 2), 2 * np.cos(theta / 2)],
            "A chord of a circle is twice the sine of half the arc.",
        ),
        "Your quaternions are as far apart as the rotations.": when(
            [matrices, 2 * np.sin(theta / 2), 2 * np.cos(theta / 2)],
            "A quaternion holds half the angle. How long is the arc between yours?",
        ),
        "The two signs are the wrong way round.": when(
            [matrices, other, quaternions],
            "Of two opposite points of a sphere, which is nearer to a third one?",
        ),
        "The first number is too small.": when(
            [matrices / 2**0.5, quaternions, other],
            "A turn moves two of the three columns of a matrix, and each counts.",
        ),
        "These are the squares of the distances.": when(
            [8 * np.sin(theta / 2) ** 2, quaternions**2, other**2],
            "Only the sum of squares is simple. What is missing?",
        ),
        "Between quaternions you give the arcs.": when(
            [matrices, theta / 2, np.pi - theta / 2],
            "The chord goes straight through the sphere. How long is it?",
        ),
        "These are angles, in degrees.": when(
            [60, 30, 150],
            "A chord has a length. How long is the chord of such an arc?",
        ),
        "Have you given degrees to a function that wants radians?": when(
            [2 * 2**0.5 * np.sin(30), 2 * np.sin(15), 2 * np.cos(15)],
            "A distance is not negative, and no chord exceeds the diameter.",
        ),
        "How large is the turn that leads from one to the other?": otherwise(
            "Draw the two quaternions as points of a circle: the arc between them is half the angle"
            " of the turn."
        ),
    }
    yield Part(right, hints, within=5e-3)


@exercise("B.2", "two angles in degrees", fields={"by chord": "°", "by angle": "°"})
def two_means_about_one_axis() -> Iterator[Part]:
    """The chord listens less to the one that strays."""
    by_chord, by_angle = np.degrees(np.arctan2(1, 2)), 30.0
    by_quaternions = 2 * np.degrees(np.arctan2(0.5**0.5, 2 + 0.5**0.5))
    right = np.array([by_chord, by_angle])
    hints = {
        "You have the two the wrong way round.": when(
            right[::-1], "Which of them is the mean of the numbers 0, 0 and 90?"
        ),
        "By angle that is right, by chord it is not.": when(
            [by_angle, by_angle], "Where does the mean matrix send U? In which direction is that?"
        ),
        "By chord that is right, by angle it is not.": when(
            [by_chord, by_chord], "About one axis, angles are numbers. What is their mean?"
        ),
        "The first is the direction of the sum of the quaternions.": when(
            [by_quaternions, by_angle],
            "Its chords are those of quaternions. Take those of the matrices.",
        ),
        **in_radians(np.deg2rad(right)),
        "You count one turn by 0° and two by 90°.": when(
            90 - right, "Two of the three bodies are not turned."
        ),
        "There are two turns by 0° and one by 90°.": when(
            [45, 45], "Each of the three counts once, so the mean is not halfway."
        ),
        "In the plane each turn sends U to a point of the circle. Add up the points.": otherwise(
            "The nearest rotation to the mean matrix sends U in the direction of the mean point."
        ),
    }
    yield Part(right, hints, within=0.1)


@exercise(
    "B.3",
    "five numbers, each 1 or 0",
    fields={f"set {k}": "" for k in range(1, 6)},
    read=lambda answer: as_array([float(each) for each in answer], (5,)),
)
def which_have_a_mean() -> Iterator[Part]:
    """What decides is the mean matrix: whether it has one nearest rotation."""
    right = np.array([1, 0, 0, 0, 1])
    slips = abs(right - np.eye(5))
    hints = {
        "Almost half a turn apart is not half a turn apart.": when(
            slips[0], "How does the mean of the two look if you come closer to 180°?"
        ),
        "Look at the second set again: how far apart are those two?": when(
            slips[1],
            "Multiply the inverse of one by the other. Which half turns follow each other?",
        ),
        "Look at the third set again: no orientation among the three is special.": when(
            slips[2], "Turn all three by 120° about W. What happens to the set, and to its mean?"
        ),
        "Add up the four matrices of the fourth set.": when(
            slips[3], "Each is diagonal. Which rotation is nearest to what you find?"
        ),
        "The fifth set counts one of its rotations twice.": when(
            slips[4], "Add up the five matrices. Which rotation is nearest to the sum?"
        ),
        "More than one of the five is not right yet.": otherwise(
            "Try each set with `mean_rotation`, and say why it refuses."
        ),
    }
    yield Part(right, hints)


@exercise("B.4", "a rotation: a matrix, shape (3, 3), or a unit quaternion", read=as_rotation)
def weighted_mean() -> Iterator[Part]:
    """Seven coarse measurements still add a little to three fine ones."""
    tracked, seeded = rotation_matrix([2, -1, 2], 2.5), np.random.default_rng(19)
    errors = np.array([2, 2, 2, 6, 6, 6, 6, 6, 6, 6.0])
    measured = rotation_matrix(seeded.normal(size=(10, 3)), np.deg2rad(errors)) @ tracked
    right = mean_rotation(measured, errors**-2)
    w, x, y, z = Quaternion.from_matrix(right).components
    hints = {
        "All ten count the same in your mean.": when(
            mean_rotation(measured),
            "How much does a measurement count whose error is three times as large?",
        ),
        "Your weights fall too slowly.": when(
            mean_rotation(measured, 1 / errors), "Variances add up, and they are squares of errors."
        ),
        "The coarse measurements count most in your mean.": when(
            mean_rotation(measured, errors**2), "A large error should make a weight small."
        ),
        "You leave the coarse tracker out.": when(
            mean_rotation(measured[:3]),
            "It knows less, but it does not know nothing. Give it a small weight.",
        ),
        "You leave the fine tracker out.": when(
            mean_rotation(measured[3:]), "It knows most. Use both."
        ),
        "Your weights are right, but this matrix does not only turn.": when(
            np.tensordot(errors**-2, measured, 1) / np.sum(errors**-2),
            "A mean matrix shrinks. Which rotation is nearest to it?",
        ),
        **the_truth(tracked),
        **scalar_last(Quaternion(x, [y, z, w]).matrix()),
        "This rotation turns back.": when(
            right.T, "Your answer is the inverse of the mean. Is a quaternion of yours conjugated?"
        ),
        "Give each measurement a weight, and let `mean_rotation` do the rest.": otherwise(
            "The best weight of a measurement is one over the square of its error."
        ),
    }
    yield Part(right, hints, within=1e-3)


@exercise("B.5", "three angles in degrees", fields={"first": "°", "second": "°", "third": "°"})
def by_two_columns() -> Iterator[Part]:
    """The column that comes first keeps its direction, and what the rest know of it is lost."""
    seeded = np.random.default_rng(6)
    copies = rotation_matrix(seeded.normal(size=(50, 3)), seeded.normal(scale=1.0, size=50))
    mean, columns = mean_rotation(copies), np.moveaxis(copies.mean(axis=0), 1, 0)
    made = [matrix_from_two_columns(columns[k], columns[(k + 1) % 3]) for k in range(3)]
    rolled = np.array([np.roll(matrix, k, axis=1) for k, matrix in enumerate(made)])
    right = np.degrees(angular_distance(mean, rolled))
    not_rolled = np.degrees(angular_distance(mean, np.array(made)))
    apart = np.degrees(angular_distance(rolled, np.roll(rolled, -1, axis=0)))
    hints = {
        **in_radians(np.deg2rad(right)),
        "Only the first is right.": when(
            not_rolled,
            "The function puts what it gets first into the first column. Put the columns back.",
        ),
        "These are the distances between the three.": when(
            apart, "Measure each from `mean_rotation` of all fifty."
        ),
        "They are near the mean, but they are not the mean.": when(
            np.zeros(3),
            "The mean columns have lost their lengths and their right angles. What does Gram and"
            " Schmidt's method do with each of them?",
        ),
        "Your three answers are in another order.": when(
            right[[1, 2, 0]],
            "Begin with the first column, then with the second, then with the third.",
        ),
        "Average the columns over all fifty, then make a rotation of two of them.": otherwise(
            "`copies.mean(axis=0)` holds the three mean columns. Those that follow the third one"
            " begin anew with the first."
        ),
    }
    yield Part(right, hints, within=0.02)
