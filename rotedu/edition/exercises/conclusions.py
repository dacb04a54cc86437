"""Checks of the exercises of Chapter 6."""

from collections.abc import Iterator
from dataclasses import astuple
from itertools import count
from typing import Any

import numpy as np

from rotedu.cost import OperationCount
from rotedu.edition.exercises.judging import (
    Numbers,
    Wrong,
    as_array,
    close,
    exercise,
    judged,
    numeric,
    radians_for_degrees,
)
from rotedu.ordinary_rotation import axis_angle
from rotedu.orientations import nearest_rotation
from rotedu.quaternions import Quaternion

__all__: list[str] = []

MATRICES, QUATERNIONS = OperationCount(27, 18), OperationCount(16, 12)
CONVERSION, POINT = OperationCount(9, 15), OperationCount(9, 6)


def as_two_numbers(cost: Any) -> Any:
    """Return the multiplications and additions of an operation count, or a pair as it is."""
    return astuple(cost)[:2] if isinstance(cost, OperationCount) else cost


@numeric(
    "6.1",
    fields={"multiplications": "", "additions": ""},
    expects="two numbers: multiplications and additions",
    because="The product is computed once, for all points.",
    read=as_two_numbers,
)
def one_product_for_all() -> Iterator[Numbers]:
    """Yield the cost of turning points by the product of two matrices."""

    def numbers(cost: OperationCount) -> tuple[int, int]:
        return cost.multiplications, cost.additions

    yield Numbers(
        numbers(MATRICES + 50 * POINT),
        (
            numbers(2 * 50 * POINT),
            Wrong(
                "You turn each point twice.",
                "Multiply the matrices first. By how many matrices is each point turned then?",
            ),
        ),
        (
            numbers(50 * (MATRICES + POINT)),
            Wrong(
                "You multiply the matrices again for each point.",
                "Does their product depend on the point?",
            ),
        ),
        (
            numbers(50 * POINT),
            Wrong(
                "The product of the two matrices is not free.",
                "Add what one product takes.",
            ),
        ),
        (
            numbers(2 * MATRICES + 50 * POINT),
            Wrong("Two matrices have one product.", "How many products does a chain of two need?"),
        ),
        (
            numbers(MATRICES + 50 * POINT)[::-1],
            Wrong("The two numbers have changed places.", "Multiplications come first."),
        ),
        otherwise=Wrong(
            "Count the product once and each of the points once.",
            "The starter cell has both costs: one of them is needed 50 times.",
        ),
        within=0,
    )


@numeric(
    "6.2",
    fields={"random turns": "", "one turn repeated": ""},
    expects="two numbers: two errors",
    because="Errors that cancel grow like a square root; an error that is repeated adds up.",
)
def two_laws_of_growth() -> Iterator[Numbers]:
    """Yield how errors of a long product grow."""
    first, longer = 1e-6, 27_000 / 3000
    root = np.sqrt(longer)
    yield Numbers(
        [first * root, first * longer],
        (
            [first * longer, first * longer],
            Wrong(
                "Random errors partly cancel.",
                "By which power of the number of products do they grow?",
            ),
        ),
        (
            [first * root, first * root],
            Wrong(
                "An error that is always the same does not cancel.",
                "After twice as many equal steps, how large is the sum?",
            ),
        ),
        (
            [first * longer, first * root],
            Wrong("You have the two laws the wrong way round.", "Which errors can cancel?"),
        ),
        (
            [first, first * longer],
            Wrong(
                "Random errors do not cancel completely.",
                "How far does a random walk get?",
            ),
        ),
        (
            [first * longer**2, first * longer],
            Wrong(
                "Random errors grow more slowly, not faster.",
                "You squared what you should have done the reverse with.",
            ),
        ),
        (
            [root, longer],
            Wrong(
                "These are the factors by which the errors grow.",
                "How large is the error that they multiply?",
            ),
        ),
        otherwise=Wrong(
            "How many times as long is the second chain?",
            "One of the errors grows in proportion to that number, the other like its root.",
        ),
        within=0.06 * first,
    )


@numeric(
    "6.3",
    fields={"joints": ""},
    expects="a number of joints",
    because="Each product saves 17 operations, and the conversion costs 24, once.",
)
def joints_of_an_arm() -> Iterator[Numbers]:
    """Yield the number of joints from which on quaternions are cheaper."""

    def total(cost: OperationCount) -> int:
        return cost.multiplications + cost.additions

    def saved(joints: int, matrices: OperationCount = MATRICES) -> int:
        return (joints - 1) * (total(matrices) - total(QUATERNIONS)) - total(CONVERSION)

    shorter = OperationCount(24, 15)
    enough = next(joints for joints in count(1) if saved(joints) > 0)
    yield Numbers(
        enough,
        (
            enough - 1,
            Wrong(
                "That many joints do not save quite enough.",
                "How many products does a chain of that many rotations have?",
            ),
        ),
        (
            next(joints for joints in count(1) if saved(joints, shorter) > 0),
            Wrong(
                "With one joint fewer, quaternions are already cheaper.",
                "Take the product of matrices with the cost in the starter cell.",
            ),
        ),
        otherwise=Wrong(
            "Compare the totals for a whole number of joints and for one joint fewer.",
            "The points cost the same on both sides. What does each product save, and what does"
            " the conversion cost?",
        ),
        within=0,
    )


@exercise(
    "6.4",
    expects="four numbers: three times in minutes and one in days",
    because="An error that is repeated wins over one that cancels.",
)
def hours_of_a_game(answer: Any) -> Wrong | None:
    """Judge how long a product of rounded steps keeps its length."""
    given = as_array(answer, (4,))
    steps = []
    for degrees in (1, 2, 3):
        step = Quaternion.from_axis_angle([0.6, 0, 0.8], np.deg2rad(degrees))
        length = np.linalg.norm(step.components.astype(np.float32).astype(np.float64))
        steps.append(np.log(0.999 if length < 1 else 1.001) / np.log(length))
    ratio = 1e-3 / 1e-6
    minutes, per_day = np.array(steps) / 60 / 60, 60 * 3600 * 24
    days = 3000 * ratio**2 / per_day
    # Logarithms of quotients, so that every mistake shows to within 3 %
    times_off, days_off = np.log(given[:3] / minutes), np.log(given[3] / days)
    return judged(
        times_off,
        np.zeros(3),
        (
            np.log(np.full(3, 60)),
            Wrong(
                "Are your times in seconds, or steps divided by 60?",
                "There are 60 steps in a second and 60 seconds in a minute.",
            ),
        ),
        (
            np.log(np.full(3, 3600)),
            Wrong("These are numbers of steps.", "How many steps are there in a minute?"),
        ),
        (
            np.log(np.full(3, 1 / 60)),
            Wrong("Are your first times in hours?", "The exercise asks for minutes."),
        ),
        (
            np.log(np.full(3, 2)),
            Wrong(
                "Is your bound on the square of the length?",
                "The length itself is to be wrong by one part in a thousand.",
            ),
        ),
        (
            np.log(np.full(3, 1 / 2)),
            Wrong(
                "Is your length a square?",
                "The length of a quaternion is the root of the sum of its squares.",
            ),
        ),
        otherwise=Wrong(
            "The length of the stored step is not quite 1. Have you rounded it to 32 bits?",
            "If s has the length L, n steps have the length L to the power n. The logarithm gives"
            " n; compute it in 64 bits.",
        )
        if not close(times_off[0], 0, 0.03)
        else Wrong(
            "The first time is right. Each step has an error of its own.",
            "Round each of the three steps to 32 bits, and measure each length.",
        ),
        within=0.03,
    ) or judged(
        days_off,
        0,
        (
            -np.log(ratio),
            Wrong(
                "Random errors do not grow in proportion to the number of steps.",
                "They grow like its square root. How does the number depend on the error then?",
            ),
        ),
        (
            -1.5 * np.log(ratio),
            Wrong(
                "You took a root where you need its inverse.",
                "If the error is the square root of the number, the number is ...",
            ),
        ),
        (np.log(24 * 60), Wrong("Is your last time in minutes?", "The exercise asks for days.")),
        otherwise=Wrong(
            "The minutes are right, the days are not yet.",
            "How many times as large must the error become, and how many times as many steps does"
            " that take?",
        ),
        within=0.03,
    )


@exercise(
    "6.5",
    expects="two angles in degrees",
    because="For two rotations the claim holds, so a test with two would have missed this.",
)
def two_ways_to_average(answer: Any) -> Wrong | None:
    """Judge how far two averages of rotations are apart."""
    vote = np.column_stack([np.ones(3), np.random.default_rng(15).normal(size=(3, 3))])
    vote /= np.linalg.norm(vote, axis=1, keepdims=True)
    matrices = Quaternion(vote[:, 0], vote[:, 1:]).matrix()
    right = []
    for k in (2, 3):
        w, *v = vote[:k].sum(axis=0)
        by_matrices = nearest_rotation(matrices[:k].sum(axis=0))
        right.append(np.rad2deg(axis_angle(by_matrices.T @ Quaternion(w, v).matrix())[1]))
    two, three = right
    given = as_array(answer, (2,))
    if radians_for_degrees(given[1], three):
        return Wrong("Is your second angle in radians?", "The exercise asks for degrees.")
    return judged(
        given,
        [two, three],
        (
            [two, three / 2],
            Wrong(
                "Is that the angle between two quaternions?",
                "It is only part of the angle of the turn from one rotation to the other.",
            ),
        ),
        (
            [two, two],
            Wrong(
                "For all three, the averages are not the same.",
                "Have you taken the sum of matrices to the nearest rotation, and the sum of"
                " quaternions to length 1?",
            ),
        ),
        otherwise=Wrong(
            "For two rotations the averages agree. Do yours?"
            if not close(given[0], two, 0.1)
            else "The first angle is right, the second is not yet.",
            "Take the sum of matrices to the nearest rotation, and divide the sum of quaternions"
            " by its length.",
        ),
        within=0.1,
    )
