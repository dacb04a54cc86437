"""Section 5, in parts."""

from rotedu.interpolation import angle_between, arc_axis, slerp, slerp_by_rotation

__all__ = [
    "angle_between",
    "arc_axis",
    "slerp",
    "slerp_by_rotation",
]
