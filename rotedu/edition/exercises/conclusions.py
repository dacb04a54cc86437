"""Checks of the exercises of Chapter 6."""

from collections.abc import Iterator
from itertools import count

import numpy as np

from rotedu.cost import OperationCount
from rotedu.edition.exercises.judging import (
    Mistake,
    Part,
    Wrong,
    close,
    exercise,
    numbers,
    radians_for_degrees,
)
from rotedu.ordinary_rotation import axis_angle
from rotedu.orientations import nearest_rotation
from rotedu.quaternions import Quaternion

__all__: list[str] = []

MATRICES, QUATERNIONS = OperationCount(27, 18), OperationCount(16, 12)
CONVERSION, POINT = OperationCount(9, 15), OperationCount(9, 6)


@exercise(
    "6.1",
    fields={"multiplications": "", "additions": ""},
    expects="two numbers: multiplications and additions",
    because="The product is computed once, for all points.",
)
def one_product_for_all() -> Iterator[Part]:
    """Yield the cost of turning points by the product of two matrices."""

    def numbers(cost: OperationCount) -> tuple[int, int]:
        return cost.multiplications, cost.additions

    yield Part(
        numbers(MATRICES + 50 * POINT),
        Mistake(
            numbers(2 * 50 * POINT),
            "You turn each point twice.",
            "Multiply the matrices first. By how many matrices is each point turned then?",
        ),
        Mistake(
            numbers(50 * (MATRICES + POINT)),
            "You multiply the matrices again for each point.",
            "Does their product depend on the point?",
        ),
        Mistake(
            numbers(50 * POINT),
            "The product of the two matrices is not free.",
            "Add the operations that one product takes.",
        ),
        Mistake(
            numbers(2 * MATRICES + 50 * POINT),
            "Two matrices have one product.",
            "How many products does a chain of two need?",
        ),
        Mistake(
            numbers(MATRICES + 50 * POINT)[::-1],
            "The two numbers have changed places.",
            "Multiplications come first.",
        ),
        otherwise=Wrong(
            "Count the product once and each of the points once.",
            "The starter cell has both costs: one of them is needed 50 times.",
        ),
        within=0,
    )


@exercise(
    "6.2",
    fields={"random turns": "", "one turn repeated": ""},
    expects="two numbers: two errors",
    because="Errors that cancel grow like a square root; an error that is repeated adds up.",
)
def two_laws_of_growth() -> Iterator[Part]:
    """Yield how errors of a long product grow."""
    first, longer = 1e-6, 27_000 / 3000
    root = np.sqrt(longer)
    yield Part(
        [first * root, first * longer],
        Mistake(
            [first * longer, first * longer],
            "Random errors partly cancel.",
            "By which power of the number of products do they grow?",
        ),
        Mistake(
            [first * root, first * root],
            "An error that is always the same does not cancel.",
            "After twice as many equal steps, how large is the sum?",
        ),
        Mistake(
            [first * longer, first * root],
            "You have the two laws the wrong way round.",
            "Which errors can cancel?",
        ),
        Mistake(
            [first, first * longer],
            "Random errors do not cancel completely.",
            "How far does a random walk get?",
        ),
        Mistake(
            [first * longer**2, first * longer],
            "Random errors grow more slowly, not faster.",
            "You squared where you should have done the reverse.",
        ),
        Mistake(
            [root, longer],
            "These are the factors by which the errors grow.",
            "How large is the error that they multiply?",
        ),
        Mistake(
            [longer, root],
            "These are factors, and the wrong way round.",
            "How large is the error that they multiply, and which errors can cancel?",
        ),
        otherwise=Wrong(
            "How many times as long is the second chain?",
            "One of the errors grows in proportion to that number, the other like its root.",
        ),
        within=0.06 * first,
    )


@exercise(
    "6.3",
    fields={"joints": ""},
    expects="a number of joints",
    because="Each product saves 17 operations, and the conversion costs 24, once.",
)
def joints_of_an_arm() -> Iterator[Part]:
    """Yield the number of joints from which on quaternions are cheaper."""

    def total(cost: OperationCount) -> int:
        return cost.multiplications + cost.additions

    def saved(joints: int, matrices: OperationCount = MATRICES) -> int:
        return (joints - 1) * (total(matrices) - total(QUATERNIONS)) - total(CONVERSION)

    shorter = OperationCount(24, 15)
    enough = next(joints for joints in count(1) if saved(joints) > 0)
    yield Part(
        enough,
        Mistake(
            enough - 1,
            "That many joints do not save quite enough.",
            "How many products does a chain of that many rotations have?",
        ),
        Mistake(
            next(joints for joints in count(1) if saved(joints, shorter) > 0),
            "With one joint fewer, quaternions are already cheaper.",
            "Take the product of matrices with the cost in the starter cell.",
        ),
        otherwise=Wrong(
            "The answer is the smallest whole number of joints that will do. Compare the totals for"
            " a whole number and for one joint fewer.",
            "The points cost the same on both sides. What does each product save, and what does"
            " the conversion cost?",
        ),
        within=0,
    )


@exercise(
    "6.4",
    expects="four numbers: three times in minutes and one in days",
    because="An error that is repeated wins over one that cancels.",
    # Of logarithms, because every mistake is a factor. A negative time becomes hardly any.
    read=lambda answer: np.log(numbers(4)(answer).clip(1e-9)),
)
def hours_of_a_game() -> Iterator[Part]:
    """Yield how long a product of rounded steps keeps its length; within 3 %."""
    steps = []
    for degrees in (1, 2, 3):
        step = Quaternion.from_axis_angle([0.6, 0, 0.8], np.deg2rad(degrees))
        length = np.linalg.norm(step.components.astype(np.float32).astype(np.float64))
        steps.append(np.log(0.999 if length < 1 else 1.001) / np.log(length))
    ratio = 1e-3 / 1e-6
    minutes, per_day = np.array(steps) / 60 / 60, 60 * 3600 * 24
    days = 3000 * ratio**2 / per_day
    yield Part(
        np.log(minutes),
        Mistake(
            lambda times: times.min() < np.log(1e-8),
            "Not all of your times are positive.",
            "The length falls to 0.999 if that of a step is below 1, and otherwise grows to 1.001.",
            example=[-minutes[0], *minutes[1:], days],
        ),
        Mistake(
            np.log(60 * minutes),
            "Are your times in seconds, or steps divided by 60?",
            "There are 60 steps in a second and 60 seconds in a minute.",
        ),
        Mistake(
            np.log(3600 * minutes),
            "These are numbers of steps.",
            "How many steps are there in a minute?",
        ),
        Mistake(
            np.log(minutes / 60),
            "Are your first times in hours?",
            "The exercise asks for minutes.",
        ),
        Mistake(
            np.log(2 * minutes),
            "Is your bound on the square of the length?",
            "The length itself is to be wrong by one part in a thousand.",
        ),
        Mistake(
            np.log(minutes / 2),
            "Is your length a square?",
            "The length of a quaternion is the root of the sum of its squares.",
        ),
        Mistake(
            lambda times: close(times[0], np.log(minutes[0]), 0.03),
            "The first time is right. Each step has an error of its own.",
            "Round each of the three steps to 32 bits, and measure each length.",
            example=[minutes[0]] * 3 + [days],
        ),
        otherwise=Wrong(
            "The length of the stored step is not quite 1. Have you rounded it to 32 bits?",
            "If s has the length L, n steps have the length L to the power n. The logarithm gives"
            " n; compute it in 64 bits.",
        ),
        item=slice(3),
        within=0.03,
    )
    yield Part(
        np.log(days),
        Mistake(
            np.log(days / ratio),
            "Random errors do not grow in proportion to the number of steps.",
            "They grow like its square root. How does the number depend on the error then?",
        ),
        Mistake(
            np.log(days * ratio**-1.5),
            "You took a root where you need its inverse.",
            "If the error is the square root of the number, the number is ...",
        ),
        Mistake(
            np.log(24 * 60 * days), "Is your last time in minutes?", "The exercise asks for days."
        ),
        otherwise=Wrong(
            "The minutes are right, but the days are not yet.",
            "How many times as large must the error become, and how many times as many steps does"
            " that take?",
        ),
        item=3,
        within=0.03,
    )


@exercise(
    "6.5",
    expects="two angles in degrees",
    because="For two rotations the claim holds, so a test with two would have missed this.",
)
def two_ways_to_average() -> Iterator[Part]:
    """Yield how far two averages of rotations are apart."""
    vote = np.column_stack([np.ones(3), np.random.default_rng(15).normal(size=(3, 3))])
    vote /= np.linalg.norm(vote, axis=1, keepdims=True)
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
    yield Part(
        right,
        Mistake(
            lambda angles: radians_for_degrees(angles[1], three),
            "Is your second angle in radians?",
            "The exercise asks for degrees.",
            example=(two, np.deg2rad(three)),
        ),
        Mistake(
            [two, three / 2],
            "Is that the angle between two quaternions?",
            "It is only part of the angle of the turn from one rotation to the other.",
        ),
        Mistake(
            [two, two],
            "The first angle is right. The two averages of all three rotations do differ.",
            "Have you taken the sum of matrices to the nearest rotation, and the sum of"
            " quaternions to length 1?",
        ),
        Mistake(
            lambda angles: close(angles[0], two, 0.1),
            "The first angle is right, but the second is not yet.",
            how,
            example=(two, 5),
        ),
        otherwise=Wrong("For two rotations the averages agree. Do yours?", how),
        within=0.1,
    )
