"""The outputs of the figures of page 1, by SciPy."""

import numpy as np
from scipy.spatial.transform import Rotation


def the_roll(roll: float) -> dict[str, float]:
    return {"off": np.degrees(Rotation.from_euler("x", roll, degrees=True).magnitude())}


def on_the_way(share: float) -> dict[str, float]:
    turn = Rotation.from_matrix([[0.36, -0.48, -0.8], [0.8, 0.6, 0], [0.48, -0.64, 0.6]])
    missed = Rotation.from_euler("xyz", share * turn.as_euler("xyz"))
    right = Rotation.from_rotvec(share * turn.as_rotvec())
    return {"off": np.degrees((right.inv() * missed).magnitude())}


def once_round(turned: float) -> dict[str, object]:
    half = np.radians(turned) / 2
    return {"numbers": [np.cos(half), 0, 0, np.sin(half)]}
