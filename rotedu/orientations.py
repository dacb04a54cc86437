"""Section 5, in parts."""

from rotedu.interpolation import closed_rotation_curve, slerp_rotations

__all__ = [
    "closed_rotation_curve",
    "slerp_rotations",
]
