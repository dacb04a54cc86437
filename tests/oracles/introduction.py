"""The outputs of the figures of page 1, by SciPy."""

import numpy as np
from scipy.spatial.transform import Rotation


def the_roll(roll: float) -> dict[str, float]:
    return {"off": np.degrees(Rotation.from_euler("x", roll, degrees=True).magnitude())}
