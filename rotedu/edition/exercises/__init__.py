"""The exercises of the book: `check` judges an answer. A module for each page with exercises."""

from rotedu.edition.exercises import (
    arcs,
    averages,
    closed_curve,
    conclusions,
    control_points,
    five_numbers,
    general_rotation,
    introduction,
    motion,
    ordinary_rotation,
    orientation_curves,
    orientations,
    quaternions,
    rigid_motion,
)
from rotedu.edition.exercises.judging import Verdict, check

__all__ = [
    "Verdict",
    "arcs",
    "averages",
    "check",
    "closed_curve",
    "conclusions",
    "control_points",
    "five_numbers",
    "general_rotation",
    "introduction",
    "motion",
    "ordinary_rotation",
    "orientation_curves",
    "orientations",
    "quaternions",
    "rigid_motion",
]
