"""Checks of the exercises of page A."""

from collections.abc import Iterator

import numpy as np

from rotedu._vectors import Array
from rotedu.edition.exercises.answers import as_rotation
from rotedu.edition.exercises.judging import Part, exercise, in_radians, otherwise, when
from rotedu.motion import (
    angular_velocity,
    integrate,
    look_at,
    matrix_from_rotation_vector,
    rotation_vector,
)
from rotedu.ordinary_rotation import axis_angle, rotation_matrix


@exercise("A.1", "a rotation vector, three numbers in radians", fields={"U": "", "V": "", "W": ""})
def shortest_rotation_vector() -> Iterator[Part]:
    """Of all vectors that lead to a matrix, the logarithm is the shortest."""
    about_w = np.array([0, 0, 1])
    right = rotation_vector(rotation_matrix(about_w, 1.5 * np.pi))
    hints = {
        "This vector leads to the matrix, but a shorter one does, too.": when(
            1.5 * np.pi * about_w,
            "The same end is reached the other way round. By which angle, about which axis?",
        ),
        "This is the length, but not the direction.": when(
            -right, "Where does U go in each of the two turns?"
        ),
        "Are these degrees?": when(
            np.rad2deg(right), "The exercise asks for radians.", also=270 * about_w
        ),
        "This is half of the angle.": when(
            right / 2, "A quaternion halves the angle, a rotation vector does not."
        ),
        "This is the axis, of length 1.": when(
            -about_w, "The length of a rotation vector is the angle of the turn."
        ),
        "This vector does not lead to the matrix.": otherwise(
            "Multiply the axis by the angle. Is the angle the smallest that will do?"
        ),
    }
    yield Part(right, hints, within=1e-2)


@exercise(
    "A.2",
    "three numbers, in radians a second",
    fields={"first axis": "rad/s", "second axis": "rad/s", "third axis": "rad/s"},
)
def rates_of_a_gyroscope() -> Iterator[Part]:
    """It is the same vector, described along axes that have turned."""
    turned, omega = rotation_matrix([0, 0, 1], np.pi / 2), np.array([0, 2, 0])
    right = turned.T @ omega
    hints = {
        "This is what is seen from the ground.": when(
            omega, "Which of the drone's own axes points along V now?"
        ),
        "You have turned the vector along with the drone.": when(
            turned @ omega,
            "The columns of R are the drone's axes. Multiply so that each is compared with the"
            " vector.",
        ),
        "The drone's second axis does not point along V any more.": when(
            -omega, "Which of its axes does, after the quarter turn?"
        ),
        "This is a turn about the drone's third axis, which is still W.": when(
            [0, 0, 2], "The quarter turn is over. About which axis does it turn now?"
        ),
        "Half of the rate belongs to the derivative of the quaternion.": when(
            right / 2, "A gyroscope says how fast the body turns, whatever describes it."
        ),
        "Are these degrees a second?": when(
            np.rad2deg(right), "The exercise asks for radians a second."
        ),
        "The length of the vector is 2, and it lies along one of the drone's axes.": otherwise(
            "Find where each of the three axes points after the quarter turn."
        ),
    }
    yield Part(right, hints, within=1e-2)


@exercise("A.3", "two factors", fields={"matrix": "", "quaternion": ""})
def what_a_step_stretches() -> Iterator[Part]:
    """The quaternion grows less, because its rate has half the length."""
    step = 0.2
    factors = np.sqrt(1 + np.array([step, step / 2]) ** 2)
    matrix, quaternion = factors
    hints = {
        "You have the two the wrong way round.": when(
            factors[::-1], "In which of the two formulas does the rate have the factor one half?"
        ),
        "These are the squares.": when(factors**2, "Pythagoras gives the square of a length."),
        "The second factor is not right yet.": when(
            [matrix, matrix], "By how much of its length does a step move the quaternion?"
        ),
        "The first factor is not right yet.": when(
            [quaternion, quaternion],
            "By how much of its length does a step move a vector at right angles to the axis?",
        ),
        "You have added the lengths.": when(
            [1 + step, 1 + step / 2], "What is added is at right angles to what was there."
        ),
        "So it would be for the exponential.": when(
            [1, 1],
            "A straight step leaves the circle along its tangent. How far from the centre does it"
            " end?",
        ),
        "One of the factors is different.": otherwise(
            "A step adds something at right angles to what was there. Draw the triangle."
        ),
    }
    yield Part(factors, hints, within=6e-4)


@exercise(
    "A.4",
    "a rotation: a matrix, a unit quaternion, or an axis and an angle in radians",
    read=as_rotation,
)
def orientation_by_gyroscope() -> Iterator[Part]:
    """Seen from the body, the room turns the other way."""
    start, dt, t = np.eye(3), 0.01, np.arange(300) / 100
    log = np.stack([60 * np.cos(t), 40 + 0 * t, -90 * np.sin(2 * t)], axis=-1)
    rates = np.deg2rad(log)
    right = integrate(start, -rates, dt)[-1].T
    as_if_fixed = integrate(start, rates, dt)[-1]
    hints = {
        "Are your rates in degrees?": when(
            integrate(start, log, dt)[-1],
            "The log is in degrees a second, and integrate expects radians.",
        ),
        "You have taken the rates for those of the fixed frame.": when(
            as_if_fixed,
            "A gyroscope turns with the body. From which side must each small turn come?",
        ),
        "This takes the room's axes to the body's coordinates.": when(
            right.T, "The columns of the answer are the body's axes as seen from the room."
        ),
        "You have transposed, but something is missing.": when(
            as_if_fixed.T, "While R turns, R^T turns the other way. Which sign have its rates?"
        ),
        "You have turned by degrees as if they were radians.": when(
            integrate(start, -np.rad2deg(rates), dt)[-1].T,
            "The functions of this book take radians; np.deg2rad converts.",
        ),
        "You have added the rotation vectors.": when(
            matrix_from_rotation_vector(dt * rates.sum(axis=0)),
            "Turns about different axes do not add. Multiply the small ones, one after another.",
        ),
        "The body ends elsewhere.": otherwise(
            "Compare with a loop that multiplies each small turn from the right."
        ),
    }
    yield Part(right, hints, within=5e-3)


def wobbling(n: int, part: float) -> Array:
    """Return where two seconds of wobbling lead in n steps, with the velocity at a part of each."""
    t = (np.arange(n) + part) * 2 / n
    velocities = np.stack([2 * np.sin(5 * t), np.cos(3 * t), 1.5 * np.sin(2 * t)], axis=-1)
    return np.asarray(integrate(np.eye(3), velocities, 2 / n)[-1])


@exercise(
    "A.5", "two numbers of steps, powers of 2", fields={"beginning": "steps", "middle": "steps"}
)
def steps_that_suffice() -> Iterator[Part]:
    """Twice as many steps halve the one error and quarter the other."""
    truth, degrees = wobbling(1024, 1 / 2), 0.5

    def enough(part: float, within: float = degrees) -> int:
        n = 1
        while axis_angle(truth.T @ wobbling(n, part))[1] > np.deg2rad(within):
            n *= 2
        return n

    begin, middle = enough(0), enough(1 / 2)
    hints = {
        "You have the two the wrong way round.": when(
            [middle, begin], "Which of the two errors falls faster?"
        ),
        "The second number is not the smallest.": when(
            [begin, begin], "Try fewer steps with the velocity in the middle."
        ),
        "The first number is not enough.": when(
            [middle, middle],
            "Does your velocity at the beginning differ from the one in the middle?",
        ),
        "Is your bound in radians?": when(
            [enough(0, np.rad2deg(degrees)), enough(1 / 2, np.rad2deg(degrees))],
            "The angle of axis_angle is in radians, and the bound is half a degree.",
        ),
        "The first number is too small: there the error is still beyond the bound.": when(
            [begin / 2, middle], "Double it once more."
        ),
        "The second number is too small: there the error is still beyond the bound.": when(
            [begin, middle / 2], "Double it once more."
        ),
        "With so many steps both are still beyond the bound.": when(
            [begin / 2, middle / 2],
            "Double the steps until the error is at most 0.5°, and print it each time.",
        ),
        "Measure the error at the end, for 1, 2, 4, 8 ... steps, against very many.": otherwise(
            "The error is the angle of truth.T @ found, in degrees."
        ),
    }
    yield Part([begin, middle], hints, within=0)


@exercise(
    "A.6", "two speeds in degrees a second", fields={"camera": "°/s", "about its sight": "°/s"}
)
def following_an_aeroplane() -> Iterator[Part]:
    """Most of the turning keeps the picture upright."""
    t, dt = np.arange(-1000, 1001) / 50, 0.02
    sights = np.stack([80 * t, 0 * t + 60, 0 * t + 400], axis=-1)
    cameras = look_at(sights, [0, 0, 1])
    rates = np.rad2deg(angular_velocity(cameras, dt))
    directions = cameras[:, :, 2]
    strides = np.rad2deg(np.linalg.norm(np.diff(directions, axis=0), axis=-1)) / dt
    spins = np.sum(rates * directions[:-1], axis=-1)
    right = np.array([np.linalg.norm(rates, axis=-1).max(), np.abs(spins).max()])
    hints = {
        **in_radians(np.deg2rad(right)),
        "You have the two the wrong way round.": when(
            right[::-1], "A part of a velocity is not longer than the whole."
        ),
        "These are the angles of one step.": when(right * dt, "A step takes 20 milliseconds."),
        "Your first speed is that of the line of sight alone.": when(
            [strides.max(), right[1]],
            "The camera also turns about its line of sight. Take the velocity of the orientation.",
        ),
        "Your second speed is that of the line of sight itself.": when(
            [right[0], strides.max()],
            "You need the part of the angular velocity that lies along the line of sight.",
        ),
        "A speed has no sign.": when([right[0], -right[1]], "Give the largest magnitude."),
        "Your second speed is the one about the vertical.": when(
            [right[0], np.abs(rates[:, 2]).max()],
            "Which column of the camera is its line of sight? Take the part of the velocity along"
            " it.",
        ),
        "One of the speeds is different.": otherwise(
            "Make an orientation of each position by look_at, ask for the angular velocities, and"
            " take their part along the line of sight."
        ),
    }
    yield Part(right, hints, within=0.1)
