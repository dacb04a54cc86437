"""The outputs of the figure of page D, by SciPy."""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation


def one_name(angle: float) -> dict[str, Any]:
    """The first two numbers, the first of which is not negative."""
    x, _, _, w = Rotation.from_rotvec([np.radians(angle), 0, 0]).as_quat()
    sign = np.sign(w) if abs(w) > 1e-12 else np.sign(x)
    return {"q": [sign * w, sign * x]}
