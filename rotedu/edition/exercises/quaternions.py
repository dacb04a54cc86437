"""Checks of the exercises of Chapter 2."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from rotedu.edition.exercises.judging import (
    Numbers,
    Wrong,
    as_array,
    as_number,
    as_parts,
    as_quaternion,
    as_rotation,
    as_word,
    close,
    exercise,
    judged,
    numeric,
    radians_for_degrees,
    same_rotation,
    up_to_sign,
)
from rotedu.quaternions import Quaternion


@numeric(
    "2.1",
    fields={"scalar part": "", "along U": "", "along V": "", "along W": ""},
    expects="a quaternion, four numbers with the scalar part first",
    because="The norms multiply, too.",
    read=as_quaternion,
)
def product_by_hand() -> Iterator[Numbers]:
    """Yield the product, then products of wrong order and wrong parts."""
    p, q = Quaternion(1, [2, 0, 0]), Quaternion(3, [1, 1, 0])
    # Half the difference of the two products is the part that the order decides.
    crossed = (p * q - q * p).components / 2
    dotted = np.array([p.v @ q.v, 0, 0, 0])
    right = (p * q).components
    yield Numbers(
        right,
        (
            (q * p).components,
            Wrong(
                "You multiplied in the other order.",
                "Which vector stands first in the cross product?",
            ),
        ),
        (
            right - crossed,
            Wrong(
                "One part of the vector is missing.",
                "The vector of a product has three parts, and one is a product of vectors.",
            ),
        ),
        (
            right + 2 * dotted,
            Wrong(
                "The scalar part has a wrong sign in it.",
                "What is i times i?",
            ),
        ),
        (
            right + dotted,
            Wrong("The scalar part is incomplete.", "What do the two vectors add to it?"),
        ),
        (
            p.components * q.components,
            Wrong(
                "You multiplied number by number.",
                "Each of the four numbers on the left meets each of those on the right.",
            ),
        ),
        otherwise=Wrong(
            "This is not the product.",
            "Find the scalar part first, then the three parts of the vector, one by one.",
        ),
    )


@exercise(
    "2.2",
    expects="a quaternion, four numbers with the scalar part first",
    because="Its negative would do as well.",
)
def unit_quaternion_of_a_turn(answer: Any) -> Wrong | None:
    """Accept either sign."""
    axis, angle = np.array([0, 3, 4]), np.deg2rad(60)
    q = as_quaternion(answer)
    right = Quaternion.from_axis_angle(axis, angle)
    if up_to_sign(q, right.components, 1e-3):
        return None
    if up_to_sign(q, Quaternion.from_axis_angle(axis, 2 * angle).components, 1e-3):
        return Wrong(
            "This quaternion turns too far.",
            "The rotation has the quaternion on both sides. How much does each of them turn?",
        )
    if up_to_sign(q, right.conjugate().components, 1e-3):
        return Wrong("This turns in the opposite sense.", "Compare the signs of both sines.")
    if up_to_sign(q, Quaternion.from_axis_angle(axis, 60).components, 1e-2):
        return Wrong(
            "Your cosine and sine took degrees for radians.", "np.deg2rad converts an angle."
        )
    if not close(np.linalg.norm(q), 1, 1e-3):
        return Wrong(
            "Your quaternion does not have norm 1.",
            "How long is the axis (0, 3, 4), and how long should it be?",
        )
    return Wrong(
        "This is another rotation.",
        "Find the angle from the scalar part and the axis from the vector, and compare.",
    )


@exercise("2.3", expects="four pairs of an axis and an angle in degrees, and the image of U")
def axis_and_angle_at_sight(answer: Any) -> Wrong | None:
    """Accept every axis and angle of each rotation."""
    pairs, image = as_parts(answer, 2)
    four = [
        Quaternion(0, [0, 0, 1]),
        Quaternion(-1, [0, 0, 0]),
        Quaternion(np.sqrt(0.5), [0, np.sqrt(0.5), 0]),
        Quaternion(0.5, [0.5, 0.5, 0.5]),
    ]
    given = [
        (as_array(axis, (3,)), as_number(degrees))
        for axis, degrees in (as_parts(pair, 2) for pair in as_parts(pairs, 4))
    ]
    end = as_array(image, (3,))
    if not all(axis.any() for axis, _ in given):
        return Wrong(
            "One of your axes is the zero vector.",
            "If nothing turns, every axis is right. Choose one.",
        )

    def right(factor: float) -> list[bool]:
        turned = [(axis, np.deg2rad(factor * degrees)) for axis, degrees in given]
        return [same_rotation(turn, q, 1e-2) for turn, q in zip(turned, four, strict=True)]

    if all(right(2)):
        return Wrong(
            "All your angles are half of what they should be.",
            "What does the scalar part tell: the cosine of the angle, or of something else?",
        )
    if all(right(180 / np.pi)):
        return Wrong("Your angles are in radians.", "A full turn has 360 degrees.")
    if not all(right(1)):
        which = ("first", "second", "third", "fourth")[right(1).index(False)]
        return Wrong(
            f"The {which} pair is not that rotation.",
            "The scalar part gives half the angle, and the vector gives the axis.",
        )
    expected = four[-1].rotate([1, 0, 0])
    return judged(
        end,
        expected,
        (
            four[-1].conjugate().rotate([1, 0, 0]),
            Wrong(
                "U went the wrong way round.",
                "Look from the tip of the axis (1, 1, 1): which axis comes counterclockwise?",
            ),
        ),
        otherwise=Wrong(
            "The fourth rotation sends U elsewhere.",
            "It exchanges the three axes in turn.",
        ),
    )


@exercise(
    "2.4",
    expects="two quaternions, each of four numbers with the scalar part first",
    because="For half turns about perpendicular axes the order does not matter.",
)
def two_turns_in_a_row(answer: Any) -> Wrong | None:
    """Accept either sign of each product."""
    halves, quarters = map(as_quaternion, as_parts(answer, 2))
    u, v = [1, 0, 0], [0, 1, 0]
    (u2, v2), (u4, v4) = (
        [Quaternion.from_axis_angle(axis, angle) for axis in (u, v)] for angle in (np.pi, np.pi / 2)
    )
    if not up_to_sign(halves, (v2 * u2).components):
        return Wrong(
            "The two half turns make another rotation.",
            "Their quaternions are i and j. Which rule gives their product?",
        )
    if up_to_sign(quarters, (v4 * u4).components):
        return None
    if up_to_sign(quarters, (u4 * v4).components):
        return Wrong(
            "For the quarter turns, V came before U.",
            "In q r q*, which factor is nearer to r, the first rotation or the second?",
        )
    if not close(np.linalg.norm(quarters), 1, 1e-3):
        return Wrong(
            "The second quaternion does not have norm 1.",
            "Norms multiply. Did you keep the factors 1 / sqrt(2)?",
        )
    return Wrong(
        "The two quarter turns make another rotation.",
        "Multiply out the brackets. There are four products, one of them of i and j.",
    )


@exercise(
    "2.5",
    expects='an angle in degrees, two axes, and "first", "second", "both" or "neither"',
    because="One axis is given in the room, the other in the object.",
)
def between_two_photographs(answer: Any) -> Wrong | None:
    """Accept an axis and an angle that are both opposite."""
    angle, one, other, word = as_parts(answer, 4)
    degrees = as_number(angle)
    axes = as_array(one, (3,)), as_array(other, (3,))
    who = as_word(word, ("first", "second", "both", "neither"))
    photo_1 = Quaternion.from_axis_angle([0, 0, 1], np.deg2rad(90))
    photo_2 = Quaternion.from_axis_angle([1, 0, 0], np.deg2rad(40)) * photo_1
    in_room, in_object = photo_2 / photo_1, photo_1.inverse() * photo_2
    right = np.rad2deg(in_room.axis_angle()[1])
    if radians_for_degrees(abs(degrees), right):
        return Wrong("Your angle is in radians.", "A full turn has 360 degrees.")
    if close(abs(degrees), right / 2, 0.1):
        return Wrong("This is half the angle.", "The scalar part belongs to half the angle.")
    turns = [as_rotation((axis, np.deg2rad(degrees))) for axis in axes]
    agree = [
        same_rotation(turn, q, 2e-3) for turn, q in zip(turns, (in_room, in_object), strict=True)
    ]
    if same_rotation(turns[0], in_object, 2e-3) and same_rotation(turns[1], in_room, 2e-3):
        return Wrong(
            "The two axes are exchanged.",
            "Which colleague has the inverse on the right?",
        )
    if not all(agree):
        which = "second" if agree[0] else "first"
        return Wrong(
            f"Axis and angle of the {which} colleague do not fit.",
            "Compute the product as it is written, then take its axis_angle.",
        )
    if who != "both":
        return Wrong(
            "Axes and angle are right, your judgement is not.",
            "Try each result once to the left of the first photograph and once to its right.",
        )
    return None


@exercise("2.6", expects="a quaternion, four numbers with the scalar part first")
def average_of_orientations(answer: Any) -> Wrong | None:
    """Measure the angle to the truth; length and sign are free."""
    average = as_quaternion(answer)
    if not average.any():
        return Wrong(
            "Four zeros are not a rotation.", "Did the signs cancel? Look at two of your terms."
        )
    tracker = np.random.default_rng(4)
    truth = Quaternion.from_axis_angle([1, -2, 2], np.deg2rad(100))
    noise = Quaternion.from_axis_angle(
        tracker.normal(size=(1000, 3)), tracker.normal(scale=np.deg2rad(8), size=1000)
    )
    measured = (noise * truth).components * tracker.choice([-1, 1], size=(1000, 1))

    def degrees_off(other: Any) -> float:
        rest = Quaternion(average[0], average[1:]) / other
        return float(np.rad2deg(2 * np.arctan2(np.linalg.norm(rest.v), abs(rest.w))))

    if degrees_off(truth) < 0.5:
        return None
    if degrees_off(truth.conjugate()) < 1:
        return Wrong(
            "You averaged the inverse rotations.",
            "Did a conjugate come in? Compare your signs with those of one measurement.",
        )
    mean = measured.mean(axis=0)
    if degrees_off(Quaternion(mean[0], mean[1:])) < 1:
        return Wrong(
            "The random signs spoil this mean.",
            "How long is the mean before you divide by its length, and what makes it so short?",
        )
    sizes = abs(measured).mean(axis=0)
    if degrees_off(Quaternion(sizes[0], sizes[1:])) < 1:
        return Wrong(
            "Absolute values also lose the signs that belong to the rotation.",
            "A quaternion has one sign to choose, for all four numbers together.",
        )
    if degrees_off(truth) < 8:
        return Wrong(
            "You are close to the truth, but not within half a degree.",
            "Make use of all the measurements, each with a sign that fits the others.",
        )
    return Wrong(
        "Your average is far from the truth: a single measurement may be as good.",
        "Which expression in q is the same for q and -q, and can be added up?",
    )
