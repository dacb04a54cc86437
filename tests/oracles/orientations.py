"""The outputs of the figures of page 5 IV, by rotedu and SciPy."""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from rotedu.arcs import angle_between, arc_axis
from rotedu.ordinary_rotation import axis_angle, rotation_matrix


def two_pictures(roll: float) -> dict[str, Any]:
    turn = Rotation.from_rotvec([0, 0, roll], degrees=True)
    return {"between": np.degrees(turn.magnitude())}


def carried_around_by_hand(corners: Any, t: float) -> dict[str, Any]:
    p = np.divide(corners, np.linalg.norm(corners, axis=1, keepdims=True))
    sides = list(zip(p, np.roll(p, -1, axis=0), strict=True))
    axes = np.array([arc_axis(*side) for side in sides])
    first, second, third = rotation_matrix(axes, [angle_between(*side) for side in sides])
    axis, angle = axis_angle(third @ second @ first)
    twist = np.degrees(angle) * np.sign(axis @ p[0])
    # The angles inside, less 180 degrees.
    area = 360 - np.degrees(angle_between(axes, np.roll(axes, 1, axis=0))).sum()
    area *= np.sign(np.linalg.det(p))
    known = {"twist": twist, "difference": area - twist}
    return {"area": area, **(known if t == 1 else dict.fromkeys(known, ""))}
