"""Wrong answers to the exercises of Chapter 3, with words of the hints."""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

N = np.ones(3) / 3**0.5
W = [0, 0, 1]
SPIN = np.cos(90), np.sin(90)
SECRET = np.random.default_rng(12)
AXIS = SECRET.normal(size=3)
AXIS /= np.linalg.norm(AXIS)
ANGLE = SECRET.uniform(0, np.pi)
# A turn by 90 degrees about the axis of Exercise 3.5.
QUARTER = Rotation.from_rotvec(np.pi / 2 * np.array([0, 0.6, 0.8])).as_matrix()
TOO_LONG = 1.001 * np.array([0, 0.6, 0.8])
BENT = np.outer(TOO_LONG, TOO_LONG) + np.cross(TOO_LONG, np.eye(3)).T

WRONG: dict[str, list[tuple[Any, str]]] = {
    "3.1": [
        ([2, -1, 3], "clockwise"),
        ([SPIN[0] - 2 * SPIN[1], SPIN[1] + 2 * SPIN[0], 3], "radians"),
        ([-1, -2, 3], "half turn"),
        ([1, -3, 2], "about U"),
        ([3, 2, -1], "about V"),
        ([2, 1, 3], "elsewhere"),
    ],
    "3.2": [
        ((-N, 60), "inverse"),
        ((N, np.pi / 3), "radians"),
        (([1, 1, 1], 60), "length 1"),
        ((N, 48.19), "three times"),
        ((N, 30), "angle is not"),
        (([1, 0, 0], 60), "axis is not"),
    ],
    "3.3": [
        (("negative", "negative"), "mirrors"),
        (("transpose", "same"), "does change"),
        (("identity", "transpose"), "still turns"),
    ],
    "3.4": [
        ((([1, 1, 0], 180), ([1, 1, -1], 120)), "half turns make another"),
        (((W, 180), ([1, 1, 1], 120)), "V came before U"),
        (((W, 180), ([-1, -1, 1], 120)), "backwards"),
        (((W, 180), ([1, 1, -1], 180)), "another angle"),
        (((W, np.pi), ([1, 1, -1], 2 * np.pi / 3)), "radians"),
        (((W, 180), ([1, 0, -1], 120)), "quarter turns make another"),
    ],
    "3.5": [
        (0.001, "error of the axis"),
        (0, "scaled"),
        (np.abs(BENT - QUARTER).max(), "right one"),
        (np.abs(BENT - np.eye(3)).max(), "with the identity"),
        (0.5, "another size"),
    ],
    "3.6": [
        ((AXIS, -ANGLE), "back"),
        ((AXIS, np.rad2deg(ANGLE)), "degrees"),
        ((2 * AXIS, ANGLE), "length 1"),
        ((AXIS, ANGLE + 0.1), "arrive"),
    ],
}
