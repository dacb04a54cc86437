"""Checks of the exercises of page C."""

from collections.abc import Callable, Iterator

import numpy as np

from rotedu._vectors import Array
from rotedu.arcs import rotation_between
from rotedu.edition.exercises.answers import as_rotation, outcomes, plain
from rotedu.edition.exercises.judging import Part, exercise, in_radians, otherwise, when
from rotedu.general_rotation import swing_twist
from rotedu.ordinary_rotation import axis_angle, rotation_matrix
from rotedu.quaternions import Quaternion

RNG = np.random.default_rng(1873)
PARTS = [tuple(Quaternion(w, v) for w, *v in RNG.integers(-3, 4, (4, 4))) for _ in range(3)]
SHOULDER = rotation_matrix([1, 2, -2], np.deg2rad(130))
LIMIT = np.deg2rad(60)


@exercise(
    "C.1",
    "four numbers",
    fields={"step first: U": "", "step first: V": "", "turn first: U": "", "turn first: V": ""},
)
def a_step_and_a_turn() -> Iterator[Part]:
    """A turn carries along what has been stepped before; a step after it is not turned."""
    hints = {
        "The two orders have changed places.": when(
            [2, 0, 0, 2], "Which of the two moves the origin before it turns?"
        ),
        "Your turn goes the other way round.": when(
            [0, -2, 2, 0], "A positive turn about W takes U to V."
        ),
        "Both orders give you the same.": when(
            [0, 2, 0, 2],
            "Lay a coin on the axis. Which of the two orders moves it round?",
            also=[2, 0, 2, 0],
        ),
        "Not yet.": otherwise("Follow the origin with a finger: where is it after the first move?"),
    }
    yield Part(np.array([0.0, 2, 2, 0]), hints)


@exercise("C.2", "three numbers", fields={"point: U": "", "point: V": "", "slide": ""})
def a_corkscrew() -> Iterator[Part]:
    """The line stands where the turn takes back what the step across it does."""
    root = 3**0.5
    hints = {
        "Your point is on the wrong side.": when(
            [1, -root, -1], "Turn your point by 60° and add the step: is it back?"
        ),
        "A factor of one half, or half of the formula, is missing.": when(
            [2, 2 * root, -1],
            "The origin, your point and the middle between it and its image make a right-angled"
            " triangle: one side is half the step.",
            also=[1, 0, -1],
        ),
        "You took the tangent for the cotangent.": when(
            [1, 1 / root, -1], "A small turn has its axis far away. Is yours?"
        ),
        "Look at your slide.": when(
            [1, root, 1],
            "It is the part of the step along the axis, with its sign.",
            also=[1, root, 5**0.5],
        ),
        "Find the point that comes home.": otherwise(
            "Seen from above: which point is taken by a turn of 60° to 2 less along U?"
        ),
    }
    yield Part(np.array([1, root, -1]), hints, within=5e-3)


@exercise("C.3", "a function of four quaternions that returns two", read=outcomes(PARTS))
def the_product() -> Iterator[Part]:
    """One product of two parts, and of the other part two, added."""

    def rows(product: Callable[..., list[Quaternion]]) -> Array:
        return outcomes(PARTS)(plain(product))

    hints = {
        "You multiply in the other order.": when(
            rows(lambda p, c, q, d: [q * p, q * c + d * p]),
            "The left factor is p + εc, and stays on the left.",
        ),
        "You keep what ε² = 0 takes away.": when(
            rows(lambda p, c, q, d: [p * q, p * d + c * q + c * d]),
            "The product of the two dual parts has a factor of ε².",
        ),
        "In the dual part your factors have changed places.": when(
            rows(lambda p, c, q, d: [p * q, d * p + q * c]),
            "Quaternions do not commute: p stays to the left of d.",
        ),
        "You multiply part by part.": when(
            rows(lambda p, c, q, d: [p * q, c * d]),
            "Multiply out (p + εc)(q + εd): how many terms have one ε?",
        ),
        "Not the product.": otherwise("Multiply out (p + εc)(q + εd), and sort by ε."),
    }
    yield Part(rows(lambda p, c, q, d: [p * q, p * d + c * q]), hints)


BENDS = np.deg2rad([40, 90, 120, 170])


@exercise("C.4", "a function of an angle", read=outcomes([(bend,) for bend in BENDS]))
def a_torn_elbow() -> Iterator[Part]:
    """The mean of the steps fits the middle of a chord, and the turn goes to the arc."""
    bend = BENDS[:, np.newaxis]
    off = 1 - np.cos(bend / 2)
    hints = {
        "You took the whole angle.": when(
            1 - np.cos(bend), "By what angle does the mean of the two turn?"
        ),
        "That is what is left, not what is off.": when(
            np.cos(bend / 2), "How long is the mean of e and Me, and where should it end?"
        ),
        "That is how far the elbow would go without any step.": when(
            2 * np.sin(bend / 4), "Half of the step e − Me is there, too. Add it."
        ),
        "That is half of the chord.": when(
            np.sin(bend / 2), "The elbow is off along the bisector, not along the chord."
        ),
        "Not yet.": otherwise(
            "Where does the turn by half the angle take the elbow, and what does half the step add?"
        ),
    }
    yield Part(off, hints)


@exercise("C.5", "two angles in degrees", fields={"signs agree": "°", "one sign changed": "°"})
def a_wrong_sign() -> Iterator[Part]:
    """Between 0° and 100° lies 50°, or on the other side −130°."""
    hints = {
        **in_radians(np.deg2rad([50, -130])),
        "The second is half of what it should be.": when(
            [50, -65], "A quaternion holds half the angle.", also=[50, 115]
        ),
        "The second sign turns nothing by itself: but in the sum?": when(
            [50, 50], "Add the four numbers of both, and look at the angle of the sum."
        ),
        "The second has the right size, and the wrong sense.": when(
            [50, 130], "Half of 260° the other way round: what sign has it?"
        ),
        "Take the sum of the two quaternions.": otherwise(
            "For turns about one axis a quaternion is a point of a circle, at half the angle."
        ),
    }
    yield Part(np.array([50.0, -130]), hints, within=0.1, period=360)


@exercise("C.6", "a rotation matrix", read=as_rotation)
def opposite_directions() -> Iterator[Part]:
    """Half a turn takes every direction across its axis to the opposite one."""
    axis = [1, 2, 3]
    hints = {
        "This turns about the given axis itself.": when(
            rotation_matrix(axis, np.pi), "Where does it take W? Only the part across W helps."
        ),
        "This is a mirror.": when(
            np.diag([1, 1, -1]),
            "Its determinant is −1. What turns W over, and not the spoon?",
            also=-np.eye(3),
        ),
        "W is there, but by another turn.": when(
            lambda m: np.allclose(m[:, 2], [0, 0, -1], atol=2e-3),
            "The axis is the part of (1, 2, 3) across W.",
            example=np.diag([1, -1, -1]),
        ),
        "W is not turned to −W.": otherwise(
            "Half a turn about n is 2 n nᵀ − I, for n of length 1.", example=np.eye(3)
        ),
    }
    yield Part(rotation_between([0, 0, 1], [0, 0, -1], axis), hints, within=2e-3)


@exercise("C.7", "a rotation matrix", read=as_rotation)
def a_shoulder_with_a_limit() -> Iterator[Part]:
    """The swing is held back, and the twist stays what it was."""
    swing, twist = swing_twist(SHOULDER, [1, 0, 0])
    axis, angle = axis_angle(swing)
    held = rotation_matrix(axis, min(angle, LIMIT))
    whole, most = axis_angle(SHOULDER)
    hints = {
        "You held back the whole turn.": when(
            rotation_matrix(whole, min(most, LIMIT)), "Only the swing has a limit."
        ),
        "The twist is gone.": when(held, "The arm may twist as it likes. Multiply by the twist."),
        "Your order is the other one.": when(
            twist @ held, "The twist comes first, that is, on the right."
        ),
        "Nothing is held back.": when(
            SHOULDER, "How far does this rotation take U? The limit is 60°."
        ),
        "Split, hold back the swing, multiply.": otherwise(
            "`axis_angle` of the swing gives the angle that must not exceed 60°."
        ),
    }
    yield Part(held @ twist, hints, within=2e-3)
