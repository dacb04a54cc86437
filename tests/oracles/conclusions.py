"""The outputs of the figure of Chapter 6, by rotedu and NumPy."""

from typing import Any

import numpy as np

from rotedu.ordinary_rotation import axis_angle
from rotedu.orientations import nearest_rotation
from rotedu.scenes.conclusions import worn_rotations


def two_digits(value: float) -> str:
    digits = max(0, 1 - int(np.floor(np.log10(value)))) if value > 1e-8 else 0
    # A tie goes up, whatever its last bits are.
    return f"{value + 10.0 ** -(digits + 6):.{digits}f}"


def worn_spoons_by_hand(
    turns: float, precision: str, repair: bool, magnified: bool
) -> dict[str, Any]:
    larger = {"2 decimals": 1, "3 decimals": 10, "16 bits": 10, "32 bits": 100_000}
    outputs: dict[str, Any] = {"times": larger[precision] if magnified else 1}
    kept = worn_rotations(round(turns), precision)
    for name, worn in zip(("matrix", "quaternion"), kept, strict=True):
        nearest = nearest_rotation(worn)
        edges = np.linalg.norm(nearest if repair else worn, axis=0)
        degrees, percent = np.degrees(axis_angle(nearest)[1]), 100 * np.abs(edges - 1).max()
        off = f"{two_digits(degrees)}°" if repair else f"{two_digits(percent)} % in length"
        outputs |= {f"{name}_off": off, f"{name}_edges": edges}
    return outputs
