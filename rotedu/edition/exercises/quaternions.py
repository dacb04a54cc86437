"""Checks of the exercises of Chapter 2."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from rotedu._vectors import Array
from rotedu.edition.exercises.judging import (
    NOT_THE_TRUTH,
    SCALAR_LAST,
    YOUR_RADIANS,
    Mistake,
    Part,
    Wrong,
    close,
    exercise,
    numbers,
    parts,
    radians_for_degrees,
    same_turn,
    unit,
    word,
)
from rotedu.quaternions import Quaternion


@exercise(
    "2.1",
    fields={"scalar part": "", "along U": "", "along V": "", "along W": ""},
    expects="a quaternion, four numbers with the scalar part first",
    because="The norms multiply, too.",
    read=numbers(4),
)
def product_by_hand() -> Iterator[Part]:
    """Yield the product, then products of wrong order and wrong parts."""
    p, q = Quaternion(1, [2, 0, 0]), Quaternion(3, [1, 1, 0])
    # Half the difference of the two products is the part that the order decides.
    crossed = (p * q - q * p).components / 2
    dotted = np.array([p.v @ q.v, 0, 0, 0])
    right = (p * q).components
    yield Part(
        right,
        Mistake(
            (q * p).components,
            "You multiplied in the other order.",
            "Which vector comes first in the cross product?",
        ),
        Mistake(
            right - crossed,
            "One part of the vector is missing.",
            "The vector of a product has three parts, one of which is a product of vectors.",
        ),
        Mistake(
            right + 2 * dotted, "The scalar part has a wrong sign in it.", "What is i times i?"
        ),
        Mistake(
            right + dotted, "The scalar part is incomplete.", "What do the two vectors add to it?"
        ),
        Mistake(
            p.components * q.components,
            "You multiplied number by number.",
            "Each of the four numbers on the left is multiplied by each of those on the right.",
        ),
        Mistake(np.roll(right, -1), *SCALAR_LAST),
        otherwise=Wrong(
            "This is not the product.",
            "Find the scalar part first, then the three parts of the vector, one by one.",
        ),
    )


@exercise(
    "2.2",
    expects="a quaternion, four numbers with the scalar part first",
    because="Its negative would do as well.",
    read=numbers(4),
)
def unit_quaternion_of_a_turn() -> Iterator[Part]:
    """Accept either sign."""
    axis, angle = np.array([0, 3, 4]), np.deg2rad(60)
    right = Quaternion.from_axis_angle(axis, angle)
    in_degrees = Quaternion.from_axis_angle(axis, 60).components
    yield Part(
        right.components,
        Mistake(
            Quaternion.from_axis_angle(axis, 2 * angle).components,
            "This quaternion turns too far.",
            "The rotation has the quaternion on both sides. How much does each of them turn?",
        ),
        Mistake(
            right.conjugate().components,
            "This turns in the opposite sense.",
            "Compare the signs of both sines.",
        ),
        Mistake(
            lambda q: close(np.sign(q[0]) * q, in_degrees, 1e-2),
            "Your cosine and sine took degrees for radians.",
            "np.deg2rad converts an angle.",
            example=in_degrees,
        ),
        Mistake(
            lambda q: not unit(q, 1e-2),
            "Your quaternion does not have norm 1.",
            "How long is the axis (0, 3, 4), and how long should it be?",
            example=[np.cos(angle / 2), *(axis * np.sin(angle / 2))],
        ),
        Mistake(np.roll(right.components, -1), *SCALAR_LAST),
        otherwise=Wrong(
            "This is another rotation.",
            "Find the angle from the scalar part and the axis from the vector, and compare.",
        ),
        within=5e-3,
        either_sign=True,
        example=[1, 0, 0, 0],
    )


@exercise(
    "2.3",
    expects="four pairs of an axis and an angle in degrees, and the image of U, three numbers",
    read=parts(parts(*4 * [parts(numbers(3), numbers())]), numbers(3)),
)
def axis_and_angle_at_sight() -> Iterator[Part]:
    """Accept every axis and angle of each rotation."""
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

    def not_that(which: str) -> Wrong:
        return Wrong(
            f"The {which} pair is not that rotation.",
            "The scalar part gives half the angle, and the vector gives the axis.",
        )

    yield Part(
        lambda *given: all(axis.any() for axis, _ in given),
        otherwise=Wrong(
            "One of your axes is the zero vector.",
            "Where nothing turns, every axis is right: choose one. Elsewhere the vector gives it.",
        ),
        item=0,
        example=([pairs[0], (0 * u, 0), *pairs[2:]], v),
    )
    yield Part(
        lambda *given: same_turn(given[0], four[0], 1e-2),
        Mistake(
            lambda *given: right(*given, factor=2),
            "All your angles are half of what they should be.",
            "What does the scalar part tell: the cosine of the angle, or of something else?",
            example=([(axis, degrees / 2) for axis, degrees in pairs], v),
        ),
        Mistake(
            lambda *given: right(*given, factor=180 / np.pi),
            "Your angles are in radians.",
            "A full turn has 360 degrees.",
            example=([(axis, np.deg2rad(degrees)) for axis, degrees in pairs], v),
        ),
        otherwise=not_that("first"),
        item=0,
        example=([(u, 180), *pairs[1:]], v),
    )
    for i, which in enumerate(("second", "third", "fourth"), start=1):
        yield Part(
            lambda *given, i=i: same_turn(given[i], four[i], 1e-2),
            otherwise=not_that(which),
            item=0,
            example=([*pairs[:i], (w, 90), *pairs[i + 1 :]], v),
        )
    yield Part(
        four[-1].rotate(u),
        Mistake(
            four[-1].conjugate().rotate(u),
            "U went the wrong way round.",
            "Look from the tip of the axis (1, 1, 1): which axis comes counterclockwise?",
        ),
        otherwise=Wrong(
            "The fourth rotation sends U elsewhere.", "It exchanges the three axes in turn."
        ),
        item=1,
    )


@exercise(
    "2.4",
    expects="two quaternions, each of four numbers with the scalar part first",
    because="For half turns about perpendicular axes the order does not matter.",
    read=parts(numbers(4), numbers(4)),
)
def two_turns_in_a_row() -> Iterator[Part]:
    """Accept either sign of each product."""
    u, v = [1, 0, 0], [0, 1, 0]
    (u2, v2), (u4, v4) = (
        [Quaternion.from_axis_angle(axis, angle) for axis in (u, v)] for angle in (np.pi, np.pi / 2)
    )
    halves, quarters = (v2 * u2).components, (v4 * u4).components
    yield Part(
        halves,
        Mistake(
            lambda q: not unit(q),
            "The first quaternion does not have norm 1.",
            "Norms multiply, and i and j have norm 1.",
            example=([0, 1, 1, 0], quarters),
        ),
        otherwise=Wrong(
            "The two half turns make another rotation.",
            "Their quaternions are i and j. Which rule gives their product?",
        ),
        item=0,
        either_sign=True,
        example=([1, 0, 0, 0], quarters),
    )
    yield Part(
        quarters,
        Mistake(
            (u4 * v4).components,
            "For the quarter turns, V came before U.",
            "In q r q*, which factor is nearer to r, the first rotation or the second?",
        ),
        Mistake(
            lambda q: not unit(q),
            "The second quaternion does not have norm 1.",
            "Norms multiply. Did you keep the factors 1 / sqrt(2)?",
            example=(halves, 2 * quarters),
        ),
        otherwise=Wrong(
            "The two quarter turns make another rotation.",
            "Multiply out the brackets. There are four products, one of them of i and j.",
        ),
        either_sign=True,
        example=(halves, [1, 0, 0, 0]),
        item=1,
    )


@exercise(
    "2.5",
    expects='an angle in degrees, two axes, and "first", "second", "both" or "neither"',
    because="One axis is given in the room, the other in the object.",
    read=parts(numbers(), numbers(3), numbers(3), word("first", "second", "both", "neither")),
)
def between_two_photographs() -> Iterator[Part]:
    """Accept an axis and an angle that are both opposite."""
    photo_1 = Quaternion.from_axis_angle([0, 0, 1], np.deg2rad(90))
    photo_2 = Quaternion.from_axis_angle([1, 0, 0], np.deg2rad(40)) * photo_1
    in_room, in_object = photo_2 / photo_1, photo_1.inverse() * photo_2
    right = np.rad2deg(in_room.axis_angle()[1])
    u, v, w = np.eye(3)

    def turns(first: Quaternion, second: Quaternion) -> Callable[..., bool]:
        return lambda degrees, one, other: (
            same_turn((one, degrees), first, 2e-3) and same_turn((other, degrees), second, 2e-3)
        )

    def does_not_fit(which: str) -> Wrong:
        return Wrong(
            f"Axis and angle of the {which} colleague do not fit.",
            "Compute the product as it is written, then take its axis_angle.",
        )

    yield Part(
        turns(in_room, in_object),
        Mistake(
            lambda degrees, one, other: radians_for_degrees(abs(degrees), right),
            *YOUR_RADIANS,
            example=(0.698, u, -v, "both"),
        ),
        Mistake(
            lambda degrees, one, other: close(abs(degrees), right / 2, 0.1),
            "This is half the angle.",
            "The scalar part belongs to half the angle.",
            example=(20, u, -v, "both"),
        ),
        Mistake(
            turns(in_object, in_room),
            "The two axes are exchanged.",
            "Which colleague has the inverse on the right?",
            example=(40, -v, u, "both"),
        ),
        Mistake(
            lambda degrees, one, other: same_turn((one, degrees), in_room, 2e-3),
            *does_not_fit("second"),
            example=(40, u, v, "both"),
        ),
        otherwise=does_not_fit("first"),
        item=slice(3),
        example=(40, w, -v, "both"),
    )
    yield Part(
        lambda who: who == "both",
        otherwise=Wrong(
            "Axes and angle are right, but your judgement is not.",
            "Try each result once to the left of the first photograph and once to its right.",
        ),
        item=3,
        example=(40, u, -v, "first"),
    )


@exercise(
    "2.6",
    expects="a quaternion, four numbers with the scalar part first",
    read=numbers(4),
)
def average_of_orientations() -> Iterator[Part]:
    """Measure the angle to the truth; length and sign are free."""
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

    yield Part(
        lambda average: not nearer(1e-2, truth)(average),
        otherwise=NOT_THE_TRUTH,
        example=truth,
    )
    yield Part(
        nearer(0.5, truth),
        Mistake(
            np.zeros(4),
            "Four zeros are not a rotation.",
            "Did the signs cancel? Look at two of your terms.",
        ),
        Mistake(
            nearer(1, truth.conjugate()),
            "You averaged the inverse rotations.",
            "Is there a conjugate in your mean? Compare its signs with those of one measurement.",
            example=truth.conjugate(),
        ),
        Mistake(
            lambda average: nearer(1, truth)(np.roll(average, 1)),
            *SCALAR_LAST,
            example=np.roll(truth.components, -1),
        ),
        Mistake(
            nearer(1, Quaternion(mean[0], mean[1:])),
            "The random signs spoil this mean.",
            "How long is the mean before you divide by its length, and what makes it so short?",
            example=mean,
        ),
        Mistake(
            nearer(1, Quaternion(upright[0], upright[1:])),
            "You made all the scalar parts positive. How large are they?",
            "The scalar part is near 0, so noise decides its sign. Compare all four numbers.",
            example=upright,
        ),
        Mistake(
            nearer(1, Quaternion(sizes[0], sizes[1:])),
            "Absolute values also lose signs that belong to the rotation.",
            "A quaternion has one sign to choose, for all four numbers together.",
            example=sizes,
        ),
        Mistake(
            nearer(8, truth),
            "You are close to the truth, but not within half a degree.",
            "Make use of all the measurements, each with a sign that fits the others.",
            example=truth + Quaternion(0.02, [0, 0, 0]),
        ),
        otherwise=Wrong(
            "Your average is far from the truth: a single measurement may be as good.",
            "Which expression in q is the same for q and -q, and can be added up?",
        ),
        example=[0, 0, 0, 1],
    )
