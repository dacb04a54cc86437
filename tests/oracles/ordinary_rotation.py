"""The outputs of the figures of Chapter 3, by rotedu."""

from typing import Any

import numpy as np

from rotedu.ordinary_rotation import rotate, rotation_matrix


def every_point(theta: float) -> dict[str, Any]:
    return {}


def figure_1_by_hand(
    vector: Any, axis: Any, theta: float, around: float, **_: Any
) -> dict[str, Any]:
    n = np.divide(axis, np.linalg.norm(axis))
    cos, sin = np.cos(np.radians(theta)), np.sin(np.radians(theta))
    r, other = vector, rotate(vector, n, np.radians(around))
    # The terms are linear in r, so their differences are those of the difference.
    apart = other - r
    terms = [cos * apart, (1 - cos) * (apart @ n) * n, sin * np.cross(n, apart)]
    names = ("first", "along", "across")
    return {
        **dict(zip(names, (cos, (1 - cos) * (r @ n), sin), strict=True)),
        **{f"{name}_apart": np.linalg.norm(t) for name, t in zip(names, terms, strict=True)},
        "matrix": rotation_matrix(n, np.radians(theta)),
    }
