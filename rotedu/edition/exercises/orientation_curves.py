"""Checks of the exercises of page 5 V."""

from collections.abc import Iterator

import numpy as np

from rotedu.closed_curve import closed_curve
from rotedu.edition.exercises.answers import close
from rotedu.edition.exercises.judging import Part, exercise, otherwise, when
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion


@exercise("5.26", "two angles in degrees", fields={"way round": "°", "shorter way": "°"})
def two_middles_of_a_gate() -> Iterator[Part]:
    """On a circle, two points have two middles, half a turn apart."""
    hints = {
        "You have exchanged the two.": when(
            [300, 120], "From 220° back to 20° it is 200°. Is that the shorter way?"
        ),
        "You have the same middle twice.": when(
            [120, 120],
            "One way leads from 220° back to 20°; the other goes on, through 360°.",
            also=[300, 300],
        ),
        "One of them is not in the middle.": otherwise(
            "Walk from 220° to 20° both ways round, and stop halfway."
        ),
    }
    yield Part([120, 300], hints, within=0.01, period=360)


@exercise("5.27", "an angle in degrees", fields={"angle": "°"})
def two_turns_kept_as_one() -> Iterator[Part]:
    """The sign of the cosine of half the angle remembers the route."""
    hints = {
        "That is the sum; it is more than 360°.": when(
            450, "Add the halves, and bring the axis to where the sine is positive."
        ),
        "That is what a matrix shows.": when(90, "Half of your angle has another cosine."),
        "About which axis?": when(
            270, "A half angle from 0 to 180° has a sine that is not negative."
        ),
        "Your turn ends elsewhere.": otherwise("Add the halves: 100° and 125°."),
    }
    yield Part(-270, hints, within=0.01)


@exercise("5.28", "two whole numbers from 0 to 32")
def choices_of_signs() -> Iterator[Part]:
    """After an odd number of full turns, signs agree only on a second round."""
    quaternions = Quaternion.from_axis_angle([1, 2, 2], np.arange(5) * 2 * np.pi / 5).components
    steady = rotation_matrix([1, 2, 2], np.arange(100) * 2 * np.pi / 100)
    refused = turning = 0
    for number in range(32):
        signs = 1 - 2 * ((number >> np.arange(5)) & 1)
        try:
            curve = closed_curve(signs[:, np.newaxis] * quaternions, 20, 1 / 3)
        except DegenerateError:
            refused += 1
        else:
            turning += close(Quaternion(curve[:, 0], curve[:, 1:]).matrix(), steady)
    drawn = 32 - refused
    hints = {
        "A curve that is drawn need not be the steady turn.": when(
            [refused, drawn], "Convert its quaternions to matrices and compare them with `steady`."
        ),
        "You count the choices that are not refused.": when(
            [drawn, turning], "A choice is refused if the function raises an error."
        ),
        "Some of the choices raise an error.": when(
            [0, turning], "Catch DegenerateError and count it."
        ),
        "Have you tried all 32? If all signs change, the rotations stay the same.": when(
            [refused / 2, turning], "Such a pair counts as two choices here."
        ),
        "These numbers do not count what happens.": otherwise(
            "Let each sign agree with the one before. Does the fifth then agree with the first? And"
            " what becomes of that if you change a single sign?"
        ),
    }
    yield Part([refused, turning], hints, within=0)
