"""The outputs of the figure of page B, by rotedu and SciPy."""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

UNCLEAR = 1e-3
SMALLEST = 1e-9
NO_MEAN = "not unique"


def mean_by_hand(poses: Any, flip: bool) -> dict[str, Any]:
    q = np.divide(poses, np.linalg.norm(poses, axis=1, keepdims=True))
    q[2] *= -1 if flip else 1
    given, total = Rotation.from_quat(q, scalar_first=True), q.sum(axis=0)
    singular = singular_values(given.as_matrix().mean(axis=0))
    clear = {
        "matrices": singular[1:].sum() > UNCLEAR,
        "quaternions": np.linalg.norm(total) > SMALLEST,
    }
    means = {
        "matrices": given.mean,
        "quaternions": lambda: Rotation.from_quat(total, scalar_first=True),
    }
    outputs: dict[str, Any] = {"singular": singular, "apart": NO_MEAN}
    for name, mean in means.items():
        outputs[f"by_{name}"] = apart(given, mean()) if clear[name] else NO_MEAN
    if all(clear.values()):
        outputs["apart"] = apart(means["matrices"](), means["quaternions"]())
    return outputs


def apart(first: Rotation, second: Rotation) -> Any:
    return np.degrees((first.inv() * second).magnitude())


def singular_values(matrix: Any) -> Any:
    """Return the singular values from the largest down, the last with the determinant's sign."""
    _, values, _ = np.linalg.svd(matrix)
    return values * [1, 1, np.sign(np.linalg.det(matrix))]
