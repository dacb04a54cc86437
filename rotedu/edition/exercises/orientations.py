"""Checks of the exercises of page 5 IV."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from rotedu._vectors import Array
from rotedu.arcs import angle_between, arc_axis, slerp
from rotedu.edition.exercises.answers import as_rotation, normalised, numbers, radians_for_degrees
from rotedu.edition.exercises.judging import Part, exercise, in_radians, otherwise, when
from rotedu.ordinary_rotation import axis_angle, rotation_matrix
from rotedu.orientations import slerp_rotations
from rotedu.quaternions import Quaternion


@exercise("5.22", "a turn: a matrix, shape (3, 3), or a unit quaternion", read=as_rotation)
def turn_between_cameras() -> Iterator[Part]:
    """The axis of this turn belongs to the camera, not to the room."""
    r1, r2 = rotation_matrix([[1, 0, 0], [0, 1, 0]], np.pi / 2)
    hints = {
        "Your turn leads from the first to the second if it stands on the left.": when(
            r2 @ r1.T,
            "Here it stands on the right: R1 D = R2. From which side do you multiply by the inverse"
            " of R1?",
        ),
        "Your turn leads from the second to the first.": when(
            r2.T @ r1, "Multiply R1 by your matrix. Which of the two has to be undone?"
        ),
        "You do both turns and undo neither.": when(
            r1 @ r2, "D has to take back the first turn before it does the second."
        ),
        "You undo the second turn in place of the first.": when(
            r1 @ r2.T, "Solve R1 D = R2 for D. The inverse of a rotation is its transpose."
        ),
        "R1 times your turn is not R2.": otherwise(
            "Solve R1 D = R2 for D. The inverse of a rotation is its transpose."
        ),
    }
    yield Part(r1.T @ r2, hints, within=2e-3)


@exercise(
    "5.23",
    "three angles in degrees",
    fields={"as they stand": "°", "sign changed": "°", "matrices": "°"},
)
def halfway_in_three_ways() -> Iterator[Part]:
    """The sign chooses the way of slerp; two matrices alone give the shorter turn."""
    total = np.deg2rad(300)
    q1, q2 = Quaternion.from_axis_angle([0, 0, 1], [0, total]).components
    ends = rotation_matrix([0, 0, 1], [0, total])

    def turned(matrix: Array) -> float:
        return float(np.rad2deg(np.arctan2(matrix[1, 0], matrix[0, 0])))

    def by_slerp(end: Array) -> float:
        return turned(as_rotation(slerp(q1, end, 1 / 2)))

    as_they_stand, changed = by_slerp(q2), by_slerp(-q2)
    right = np.array([as_they_stand, changed, turned(slerp_rotations(*ends, 1 / 2))])
    hints = {
        "A change of sign leads round the other way.": when(
            [as_they_stand] * 3,
            "How large is the turn from one end to the other, in each of the two directions?",
            also=[changed] * 3,
        ),
        "You have the two signs the wrong way round.": when(
            [changed, as_they_stand, changed],
            "The sign of the dot product tells which way slerp goes. It is the cosine of half the"
            " angle.",
        ),
        "The third way is not right yet.": when(
            [as_they_stand, changed, as_they_stand],
            "The matrix of a turn by 300° is also that of a shorter turn. By which angle?",
        ),
        "These are the angles in the quaternions.": when(
            right / 2, "A quaternion holds half the angle by which it turns."
        ),
        **in_radians(np.deg2rad(right)),
        "Halfway is half of the turn. Which turn is it in each of the three?": otherwise(
            "The body can turn to the same end by 300° or by the rest of a full turn backwards."
        ),
    }
    yield Part(right, hints, within=0.1, period=360)


@exercise("5.24", "an angle in degrees", fields={"angle": "°"})
def carried_platform() -> Iterator[Part]:
    """It is the area of the triangle, as an angle."""
    east = np.deg2rad(40)
    corners = np.array([[0, 0, 1], [1, 0, 0], [np.cos(east), np.sin(east), 0]])
    trip = np.eye(3)
    for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        trip = rotation_matrix(arc_axis(start, end), angle_between(start, end)) @ trip
    _, turn = axis_angle(trip)
    right = np.rad2deg(turn)
    hints = {
        "The platform has turned the other way.": when(
            -right, "Follow its front edge round the triangle, and look from above."
        ),
        "That is the sum of the angles of the triangle.": when(
            180 + right, "The area is the excess of this sum over the sum in the plane."
        ),
        "Is this an angle in radians?": when(np.deg2rad(right), "The exercise asks for degrees."),
        "That the platform was never turned about its vertical does not answer the question.": when(
            0, "Which way does a mark on it point on the equator, and which way when it is back?"
        ),
        "That is the answer for an eighth of the sphere.": when(
            90, "How large is the angle of this triangle at the pole?"
        ),
        "Find the three angles of the triangle first.": otherwise(
            "Two are between a meridian and the equator. By how much does the sum exceed 180°?"
        ),
    }
    yield Part(right, hints, within=0.1, period=360)


def columns_of_flights(answer: Any) -> tuple[Array, Array, Array]:
    """Return the columns of a table of flights. The sign of a roll does not count."""
    rolls, turned, uneven = numbers(4, 3)(answer).T
    return np.abs(rolls), turned, uneven


@exercise("5.25", "four rows of three numbers, shape (4, 3)", read=columns_of_flights)
def upright_flights() -> Iterator[Part]:
    """The steeper the line of sight, the more a level horizon costs."""
    sights = normalised([(1.0, 0.0, -0.2), (0.3, 1.0, 0.2), (0.2, 0.3, 1.0), (0.3, -0.9, 0.3)])
    pairs = list(zip(sights, np.roll(sights, -1, axis=0), strict=True))
    rolls, turned, uneven = np.transpose([flight(*ends) for ends in pairs])
    by_sight = [
        angle_between(start, end) / axis_angle(standing(start).T @ standing(end))[1]
        for start, end in pairs
    ]
    hints = {
        **in_radians(
            lambda given: radians_for_degrees(given, rolls),
            example=np.transpose([np.deg2rad(rolls), turned, uneven]),
        ),
        "On the shortest turn the camera does not stay upright.": when(
            np.zeros(4),
            "Compare the camera on its way with an upright one that looks the same way.",
        ),
        "Your flights begin at the wrong sight.": when(
            np.roll(rolls, -1), "The first flight leads from the first sight to the second."
        ),
        "The rolls, in the first column, are not right yet.": otherwise(
            "At many moments, make an upright camera with the same line of sight. The turn from it"
            " to the camera is the roll."
        ),
    }
    yield Part(rolls, hints, item=0, within=0.5)
    hints = {
        "Your second column is about the line of sight alone.": when(
            by_sight, "The camera also turns about it. Add up the small turns of the camera."
        ),
        "Your second column is upside down.": when(
            1 / turned, "No motion turns less than the shortest one."
        ),
        "The second column is not right yet.": otherwise(
            "Add up the small turns from moment to moment, and divide by the turn that leads"
            " straight from the first orientation to the last."
        ),
    }
    yield Part(turned, hints, item=1, within=0.02)
    hints = {
        "The line of sight moves evenly, but the camera does not turn evenly.": when(
            np.ones(4), "Compare the small turns of the upright camera from moment to moment."
        ),
        "Your third column is upside down.": when(
            1 / uneven, "Divide the greatest speed by the least."
        ),
        "The third column is not right yet.": otherwise(
            "Take enough moments on the way, a thousand or so, at equal distances."
        ),
    }
    yield Part(uneven, hints, item=2, within=0.1)


def standing(sight: Array) -> Array:
    """Return upright cameras; their columns point left, up and ahead."""
    left = normalised(np.cross([0, 0, 1], sight))
    return np.stack([left, np.cross(sight, left), sight], axis=-1)


def flight(start: Array, end: Array) -> tuple[float, float, float]:
    """Return the largest roll in degrees, the angle turned over the least, and its unevenness."""
    moments = np.linspace(0, 1, 1001)
    free = slerp_rotations(standing(start), standing(end), moments)
    tilt = standing(free[:, :, 2]).swapaxes(1, 2) @ free
    roll = np.rad2deg(np.arctan2(tilt[:, 1, 0], tilt[:, 0, 0]))
    upright = standing(slerp(start, end, moments))
    _, small = axis_angle(upright[:-1].swapaxes(1, 2) @ upright[1:])
    _, least = axis_angle(standing(start).T @ standing(end))
    return np.abs(roll).max(), small.sum() / least, small.max() / small.min()
