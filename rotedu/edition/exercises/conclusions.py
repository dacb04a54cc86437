"""Checks of the exercises of Chapter 6."""

from collections.abc import Iterator

import numpy as np

from rotedu.cost import OperationCount
from rotedu.edition.exercises.answers import close, normalised, numbers, radians_for_degrees
from rotedu.edition.exercises.judging import Part, exercise, otherwise, when
from rotedu.ordinary_rotation import axis_angle
from rotedu.orientations import nearest_rotation
from rotedu.quaternions import Quaternion

MATRICES, QUATERNIONS = OperationCount(27, 18), OperationCount(16, 12)
CONVERSION, POINT = OperationCount(9, 15), OperationCount(9, 6)


@exercise(
    "6.1",
    "two numbers: multiplications and additions",
    fields={"multiplications": "", "additions": ""},
)
def one_product_for_all() -> Iterator[Part]:
    """The product is computed once, for all points."""

    def numbers(cost: OperationCount) -> tuple[int, int]:
        return cost.multiplications, cost.additions

    hints = {
        "You turn each point twice.": when(
            numbers(2 * 50 * POINT),
            "Multiply the matrices first. By how many matrices is each point turned then?",
        ),
        "You multiply the matrices again for each point.": when(
            numbers(50 * (MATRICES + POINT)), "Does their product depend on the point?"
        ),
        "The product of the two matrices is not free.": when(
            numbers(50 * POINT), "Add the operations that one product takes."
        ),
        "Two matrices have one product.": when(
            numbers(2 * MATRICES + 50 * POINT), "How many products does a chain of two need?"
        ),
        "The two numbers have changed places.": when(
            numbers(MATRICES + 50 * POINT)[::-1], "Multiplications come first."
        ),
        "Count the product once and each of the points once.": otherwise(
            "The starter cell has both costs: one of them is needed 50 times."
        ),
    }
    yield Part(numbers(MATRICES + 50 * POINT), hints, within=0)


@exercise("6.2", "two numbers: two errors", fields={"random turns": "", "one turn repeated": ""})
def two_laws_of_growth() -> Iterator[Part]:
    """Errors that cancel grow like a square root; an error that is repeated adds up."""
    first, longer = 1e-6, 27_000 / 3000
    root = np.sqrt(longer)
    hints = {
        "Random errors partly cancel.": when(
            [first * longer, first * longer],
            "By which power of the number of products do they grow?",
        ),
        "An error that is always the same does not cancel.": when(
            [first * root, first * root], "After twice as many equal steps, how large is the sum?"
        ),
        "You have the two laws the wrong way round.": when(
            [first * longer, first * root], "Which errors can cancel?"
        ),
        "Random errors do not cancel completely.": when(
            [first, first * longer], "How far does a random walk get?"
        ),
        "Random errors grow more slowly, not faster.": when(
            [first * longer**2, first * longer],
            "You squared where you should have done the reverse.",
        ),
        "These are the factors by which the errors grow.": when(
            [root, longer], "How large is the error that they multiply?"
        ),
        "These are factors, and the wrong way round.": when(
            [longer, root],
            "How large is the error that they multiply, and which errors can cancel?",
        ),
        "How many times as long is the second chain?": otherwise(
            "One of the errors grows in proportion to that number, the other like its root."
        ),
    }
    yield Part([first * root, first * longer], hints, within=0.06 * first)


@exercise("6.3", "a number of joints", fields={"joints": ""})
def joints_of_an_arm() -> Iterator[Part]:
    """Each product saves 17 operations, and the conversion costs 24, once."""

    def total(cost: OperationCount) -> int:
        return cost.multiplications + cost.additions

    def enough(matrices: OperationCount) -> int:
        return total(CONVERSION) // (total(matrices) - total(QUATERNIONS)) + 2

    hints = {
        "That many joints do not save quite enough.": when(
            enough(MATRICES) - 1, "How many products does a chain of that many rotations have?"
        ),
        "With one joint fewer, quaternions are already cheaper.": when(
            enough(OperationCount(24, 15)),
            "Take the product of matrices with the cost in the starter cell.",
        ),
        "The answer is the smallest whole number of joints that will do. Compare the totals for"
        " a whole number and for one joint fewer.": otherwise(
            "The points cost the same on both sides. What does each product save, and what does the"
            " conversion cost?"
        ),
    }
    yield Part(enough(MATRICES), hints, within=0)


@exercise(
    "6.4",
    "four numbers: three times in minutes and one in days",
    read=lambda answer: np.log(numbers(4)(answer).clip(1e-9)),
)
def hours_of_a_game() -> Iterator[Part]:
    """An error that is repeated wins over one that cancels."""
    # Times are right within 3 %, so logarithms are compared.
    steps = []
    for degrees in (1, 2, 3):
        step = Quaternion.from_axis_angle([0.6, 0, 0.8], np.deg2rad(degrees))
        length = np.linalg.norm(step.components.astype(np.float32).astype(np.float64))
        steps.append(np.log(0.999 if length < 1 else 1.001) / np.log(length))
    ratio = 1e-3 / 1e-6
    minutes, per_day = np.array(steps) / 60 / 60, 60 * 3600 * 24
    days = 3000 * ratio**2 / per_day
    hints = {
        "Not all of your times are positive.": when(
            lambda times: times.min() < np.log(1e-8),
            "The length falls to 0.999 if that of a step is below 1, and otherwise grows to 1.001.",
            example=[-minutes[0], *minutes[1:], days],
        ),
        "Are your times in seconds, or steps divided by 60?": when(
            np.log(60 * minutes), "There are 60 steps in a second and 60 seconds in a minute."
        ),
        "These are numbers of steps.": when(
            np.log(3600 * minutes), "How many steps are there in a minute?"
        ),
        "Are your first times in hours?": when(
            np.log(minutes / 60), "The exercise asks for minutes."
        ),
        "Is your bound a square?": when(
            np.log(2 * minutes), "The length itself is to reach 0.999 or 1.001, not their squares."
        ),
        "Is this the time for the square of the length?": when(
            np.log(minutes / 2),
            "It is the length, the root of the sum of squares, that is to be wrong by so much.",
        ),
        "The first time is right. Each step has an error of its own.": when(
            lambda times: close(times[0], np.log(minutes[0]), 0.03),
            "Round each of the three steps to 32 bits, and measure each length.",
            example=[minutes[0]] * 3 + [days],
        ),
        "The length of the stored step is not quite 1. Have you rounded it to 32 bits?": otherwise(
            "If s has the length L, n steps have the length L to the power n. The logarithm gives"
            " n; compute it in 64 bits."
        ),
    }
    yield Part(np.log(minutes), hints, item=slice(3), within=0.03)
    hints = {
        "Random errors do not grow in proportion to the number of steps.": when(
            np.log(days / ratio),
            "They grow like its square root. How does the number depend on the error then?",
        ),
        "You took a root where you need its inverse.": when(
            np.log(days * ratio**-1.5),
            "If the error is the square root of the number, the number is ...",
        ),
        "Is your last time in minutes?": when(
            np.log(24 * 60 * days), "The exercise asks for days."
        ),
        "The minutes are right, but the days are not yet.": otherwise(
            "How many times as large must the error become, and how many times as many steps does"
            " that take?"
        ),
    }
    yield Part(np.log(days), hints, item=3, within=0.03)


@exercise("6.5", "two angles in degrees")
def two_ways_to_average() -> Iterator[Part]:
    """For two rotations the claim holds, so a test with two would have missed this."""
    noise = np.random.default_rng(15).normal(size=(3, 3))
    vote = normalised(np.column_stack([np.ones(3), noise]))
    matrices = Quaternion(vote[:, 0], vote[:, 1:]).matrix()
    right = []
    for k in (2, 3):
        w, *v = vote[:k].sum(axis=0)
        by_matrices = nearest_rotation(matrices[:k].sum(axis=0))
        right.append(np.rad2deg(axis_angle(by_matrices.T @ Quaternion(w, v).matrix())[1]))
    two, three = right
    how = (
        "Take the sum of matrices to the nearest rotation, and divide the sum of quaternions by its"
        " length."
    )
    hints = {
        "Is your second angle in radians?": when(
            lambda angles: radians_for_degrees(angles[1], three),
            "The exercise asks for degrees.",
            example=(two, np.deg2rad(three)),
        ),
        "Is that the angle between two quaternions?": when(
            [two, three / 2],
            "It is only part of the angle of the turn from one rotation to the other.",
        ),
        "The first angle is right. The two averages of all three rotations do differ.": when(
            [two, two],
            "Have you taken the sum of matrices to the nearest rotation, and the sum of quaternions"
            " to length 1?",
        ),
        "The first angle is right, but the second is not yet.": when(
            lambda angles: close(angles[0], two, 0.1), how, example=(two, 5)
        ),
        "For two rotations the averages agree. Do yours?": otherwise(how),
    }
    yield Part(right, hints, within=0.1)
