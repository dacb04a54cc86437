"""Section 5, in parts."""

from rotedu.interpolation import closed_curve, de_casteljau, de_casteljau_levels

__all__ = [
    "closed_curve",
    "de_casteljau",
    "de_casteljau_levels",
]
