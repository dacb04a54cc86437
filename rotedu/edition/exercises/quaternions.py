"""Checks of the exercises of Chapter 2."""

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
    same_turn,
    unit,
    word,
)
from rotedu.edition.exercises.judging import (
    Part,
    angle_in_radians,
    exercise,
    otherwise,
    scalar_last,
    the_truth,
    when,
)
from rotedu.quaternions import Quaternion


@exercise(
    "2.2",
    "a quaternion, four numbers with the scalar part first",
    fields={"scalar part": "", "along U": "", "along V": "", "along W": ""},
)
def product_by_hand() -> Iterator[Part]:
    """The norms multiply, too."""
    p, q = Quaternion(1, [2, 0, 0]), Quaternion(3, [1, 1, 0])
    # Half the difference of the two products is the part that the order decides.
    crossed = (p * q - q * p).components / 2
    dotted = np.array([p.v @ q.v, 0, 0, 0])
    right = (p * q).components
    hints = {
        "You multiplied in the other order.": when(
            (q * p).components, "Which vector comes first in the cross product?"
        ),
        "One part of the vector is missing.": when(
            right - crossed,
            "The vector of a product has three parts, one of which is a product of vectors.",
        ),
        "The scalar part has a wrong sign in it.": when(right + 2 * dotted, "What is i times i?"),
        "The scalar part is incomplete.": when(
            right + dotted, "What do the two vectors add to it?"
        ),
        "You multiplied number by number.": when(
            p.components * q.components,
            "Each of the four numbers on the left is multiplied by each of those on the right.",
        ),
        **scalar_last(np.roll(right, -1)),
        "This is not the product.": otherwise(
            "Find the scalar part first, then the three parts of the vector, one by one."
        ),
    }
    yield Part(right, hints)


@exercise("2.3", "a quaternion, four numbers with the scalar part first", read=numbers(4))
def unit_quaternion_of_a_turn() -> Iterator[Part]:
    """Its negative would do as well."""
    axis, angle = np.array([0, 3, 4]), np.deg2rad(60)
    right = Quaternion.from_axis_angle(axis, angle)
    in_degrees = Quaternion.from_axis_angle(axis, 60).components
    hints = {
        "This quaternion turns too far.": when(
            Quaternion.from_axis_angle(axis, 2 * angle).components,
            "The rotation has the quaternion on both sides. How much does each of them turn?",
        ),
        "This turns in the opposite sense.": when(
            right.conjugate().components, "Which of the two factors, q or q*, has the minus sign?"
        ),
        "Your cosine and sine took degrees for radians.": when(
            lambda q: close(np.sign(q[0]) * q, in_degrees, 1e-2),
            "np.deg2rad converts an angle.",
            example=in_degrees,
        ),
        "Your quaternion does not have norm 1.": when(
            lambda q: not unit(q, 1e-2),
            "How long is the axis (0, 3, 4), and how long should it be?",
            example=[np.cos(angle / 2), *(axis * np.sin(angle / 2))],
        ),
        **scalar_last(np.roll(right.components, -1)),
        "This is another rotation.": otherwise(
            "Find the angle from the scalar part and the axis from the vector, and compare.",
            example=[1, 0, 0, 0],
        ),
    }
    yield Part(right.components, hints, within=5e-3, either_sign=True)


@exercise(
    "2.4",
    "four pairs of an axis and an angle in degrees, and the image of U, three numbers",
    read=parts(parts(*4 * [parts(numbers(3), numbers())]), numbers(3)),
)
def axis_and_angle_at_sight() -> Iterator[Part]:
    four = [
        Quaternion(0, [0, 0, 1]),
        Quaternion(-1, [0, 0, 0]),
        Quaternion(np.sqrt(0.5), [0, np.sqrt(0.5), 0]),
        Quaternion(0.5, [0.5, 0.5, 0.5]),
    ]
    u, v, w = np.eye(3)
    pairs = [(w, 180), (u, 360), (v, 90), ([1, 1, 1], 120)]

    def right(*given: Any, factor: float) -> bool:
        turns = [(axis, factor * degrees) for axis, degrees in given]
        return all(same_turn(turn, q, 1e-2) for turn, q in zip(turns, four, strict=True))

    names = "The scalar part gives half the angle, and the vector gives the axis."
    hints = {
        "One of your axes is the zero vector.": otherwise(
            "Where nothing turns, every axis is right: choose one. Elsewhere the vector gives it.",
            example=([pairs[0], (0 * u, 0), *pairs[2:]], v),
        )
    }
    yield Part(lambda *given: all(axis.any() for axis, _ in given), hints, item=0)
    hints = {
        "All your angles are half of what they should be.": when(
            lambda *given: right(*given, factor=2),
            "What does the scalar part tell: the cosine of the angle, or of something else?",
            example=([(axis, degrees / 2) for axis, degrees in pairs], v),
        ),
        "Your angles are in radians.": when(
            lambda *given: right(*given, factor=180 / np.pi),
            "A full turn has 360 degrees.",
            example=([(axis, np.deg2rad(degrees)) for axis, degrees in pairs], v),
        ),
        "The first pair is not that rotation.": otherwise(
            names, example=([(u, 180), *pairs[1:]], v)
        ),
    }
    yield Part(lambda *given: same_turn(given[0], four[0], 1e-2), hints, item=0)
    for i, which in enumerate(("second", "third", "fourth"), start=1):
        wrong = [*pairs[:i], (w, 90), *pairs[i + 1 :]], v
        hints = {f"The {which} pair is not that rotation.": otherwise(names, example=wrong)}
        yield Part(lambda *given, i=i: same_turn(given[i], four[i], 1e-2), hints, item=0)
    hints = {
        "U went the wrong way round.": when(
            four[-1].conjugate().rotate(u),
            "Look from the tip of (1, 1, 1): which axis comes next after U, anticlockwise?",
        ),
        "The fourth rotation sends U elsewhere.": otherwise(
            "It takes each axis to the next, all three in a ring."
        ),
    }
    yield Part(four[-1].rotate(u), hints, item=1)


@exercise(
    "2.5",
    "two quaternions, each of four numbers with the scalar part first",
    read=parts(numbers(4), numbers(4)),
)
def two_turns_in_a_row() -> Iterator[Part]:
    """For half turns about perpendicular axes the order does not matter."""
    u, v = [1, 0, 0], [0, 1, 0]
    (u2, v2), (u4, v4) = (
        [Quaternion.from_axis_angle(axis, angle) for axis in (u, v)] for angle in (np.pi, np.pi / 2)
    )
    halves, quarters = (v2 * u2).components, (v4 * u4).components
    hints = {
        "The first quaternion does not have norm 1.": when(
            lambda q: not unit(q),
            "Norms multiply, and i and j have norm 1.",
            example=([0, 1, 1, 0], quarters),
        ),
        "The two half turns make another rotation.": otherwise(
            "Their quaternions are i and j. Which rule gives their product?",
            example=([1, 0, 0, 0], quarters),
        ),
    }
    yield Part(halves, hints, item=0, either_sign=True)
    hints = {
        "For the quarter turns, V came before U.": when(
            (u4 * v4).components,
            "In q r q*, which factor is nearer to r, the first rotation or the second?",
        ),
        "The second quaternion does not have norm 1.": when(
            lambda q: not unit(q),
            "Norms multiply. Did you keep the factors 1 / sqrt(2)?",
            example=(halves, 2 * quarters),
        ),
        "The two quarter turns make another rotation.": otherwise(
            "Multiply out the brackets. There are four products, one of them of i and j.",
            example=(halves, [1, 0, 0, 0]),
        ),
    }
    yield Part(quarters, hints, either_sign=True, item=1)


@exercise(
    "2.6",
    'an angle in degrees, two axes, and "first", "second", "both" or "neither"',
    read=parts(numbers(), numbers(3), numbers(3), word("first", "second", "both", "neither")),
)
def between_two_photographs() -> Iterator[Part]:
    """One axis is given in the room, the other in the object."""
    photo_1 = Quaternion.from_axis_angle([0, 0, 1], np.deg2rad(90))
    photo_2 = Quaternion.from_axis_angle([1, 0, 0], np.deg2rad(40)) * photo_1
    in_room, in_object = photo_2 / photo_1, photo_1.inverse() * photo_2
    right = np.rad2deg(in_room.axis_angle()[1])
    u, v, w = np.eye(3)

    def turns(first: Quaternion, second: Quaternion) -> Callable[..., bool]:
        return lambda degrees, one, other: (
            same_turn((one, degrees), first, 2e-3) and same_turn((other, degrees), second, 2e-3)
        )

    compute = "Compute the product as it is written, then take its axis_angle."
    hints = {
        **angle_in_radians(
            lambda degrees, one, other: radians_for_degrees(abs(degrees), right),
            example=(0.698, u, -v, "both"),
        ),
        "This is half the angle.": when(
            lambda degrees, one, other: close(abs(degrees), right / 2, 0.1),
            "The scalar part belongs to half the angle.",
            example=(20, u, -v, "both"),
        ),
        "The two axes are exchanged.": when(
            turns(in_object, in_room),
            "Which colleague has the inverse on the right?",
            example=(40, -v, u, "both"),
        ),
        "Axis and angle of the second colleague do not fit.": when(
            lambda degrees, one, other: same_turn((one, degrees), in_room, 2e-3),
            compute,
            example=(40, u, v, "both"),
        ),
        "Axis and angle of the first colleague do not fit.": otherwise(
            compute, example=(40, w, -v, "both")
        ),
    }
    yield Part(turns(in_room, in_object), hints, item=slice(3))
    hints = {
        "Axes and angle are right, but your judgement is not.": otherwise(
            "Try each result once to the left of the first photograph and once to its right.",
            example=(40, u, -v, "first"),
        )
    }
    yield Part(lambda who: who == "both", hints, item=3)


@exercise("2.7", "a quaternion, four numbers with the scalar part first", read=numbers(4))
def average_of_orientations() -> Iterator[Part]:
    # Length and sign are free.
    tracker = np.random.default_rng(4)
    # A turn of almost 180°: noise decides the sign of its scalar part.
    truth = Quaternion.from_axis_angle([1, -2, 2], np.deg2rad(179))
    noise = Quaternion.from_axis_angle(
        tracker.normal(size=(1000, 3)), tracker.normal(scale=np.deg2rad(8), size=1000)
    )
    measured = (noise * truth).components * tracker.choice([-1, 1], size=(1000, 1))
    mean, sizes = measured.mean(axis=0), abs(measured).mean(axis=0)
    upright = (np.sign(measured[:, :1]) * measured).mean(axis=0)

    def nearer(degrees: float, other: Any) -> Callable[..., Any]:
        def test(average: Array) -> Any:
            rest = Quaternion(average[0], average[1:]) / other
            off = np.rad2deg(2 * np.arctan2(np.linalg.norm(rest.v), abs(rest.w)))
            return average.any() and off < degrees

        return test

    yield Part(lambda average: not nearer(1e-2, truth)(average), the_truth(example=truth))
    hints = {
        "Four zeros are not a rotation.": when(
            np.zeros(4), "Did the signs cancel? Look at two of your terms."
        ),
        "You averaged the inverse rotations.": when(
            nearer(1, truth.conjugate()),
            "Is there a conjugate in your mean? Compare its signs with those of one measurement.",
            example=truth.conjugate(),
        ),
        **scalar_last(
            lambda average: nearer(1, truth)(np.roll(average, 1)),
            example=np.roll(truth.components, -1),
        ),
        "The random signs spoil this mean.": when(
            nearer(1, Quaternion(mean[0], mean[1:])),
            "How long is the mean before you divide by its length, and what makes it so short?",
            example=mean,
        ),
        "You made all the scalar parts positive. How large are they?": when(
            nearer(1, Quaternion(upright[0], upright[1:])),
            "The scalar part is near 0, so noise decides its sign. Compare all four numbers.",
            example=upright,
        ),
        "Absolute values also lose signs that belong to the rotation.": when(
            nearer(1, Quaternion(sizes[0], sizes[1:])),
            "A quaternion has one sign to choose, for all four numbers together.",
            example=sizes,
        ),
        "You are close to the truth, but not within half a degree.": when(
            nearer(8, truth),
            "Make use of all the measurements, each with a sign that fits the others.",
            example=truth + Quaternion(0.02, [0, 0, 0]),
        ),
        "Your average is far from the truth: a single measurement may be as good.": otherwise(
            "Which expression in q is the same for q and -q, and can be added up?",
            example=[0, 0, 0, 1],
        ),
    }
    yield Part(nearer(0.5, truth), hints)


FACTORS = [
    (1, np.array([2, 3, 4]), 5, np.array([0, 1, -1])),
    (0, np.array([1, 0, 0]), 0, np.array([0, 1, 0])),
    (2, np.array([1, -1, 2]), -1, np.array([0, 3, 1])),
]


@exercise(
    "2.1",
    "a function of two numbers and two vectors that returns a number and a vector",
    read=outcomes(FACTORS),
)
def product_of_quaternions() -> Iterator[Part]:
    """The sixteen products of numbers and units stand in these two lines."""

    def rows(sign: int, crossed: int, own: bool = False) -> Array:
        def product(w1: float, v1: Array, w2: float, v2: Array) -> list[Any]:
            mixed = w1 * v1 + w2 * v2 if own else w1 * v2 + w2 * v1
            return [w1 * w2 + sign * v1 @ v2, mixed + crossed * np.cross(v1, v2)]

        return outcomes(FACTORS)(product)

    hints = {
        "Your dot product is added.": when(rows(1, 1), "What is the square of each unit?"),
        "Your factors have changed places.": when(
            rows(-1, -1), "Which vector comes first in the cross product?"
        ),
        "Where is the product of two different units?": when(
            rows(-1, 0), "Six of the sixteen products make a cross product."
        ),
        "Each number stands with its own vector.": when(
            rows(-1, 1, own=True), "Multiply every term of the first by every term of the second."
        ),
        "That is another product.": otherwise("Try it on the example above the exercise."),
    }
    yield Part(rows(-1, 1), hints)
