"""Section 5, in parts."""

from rotedu.interpolation import (
    bisect,
    bisect_by_rotation,
    control_points,
    double,
    double_by_rotation,
)

__all__ = [
    "bisect",
    "bisect_by_rotation",
    "control_points",
    "double",
    "double_by_rotation",
]
