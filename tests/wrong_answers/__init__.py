"""Usual wrong answers to the exercises, with words of the hints: a module for each page."""

from typing import Any

from wrong_answers import (
    arcs,
    closed_curve,
    conclusions,
    control_points,
    general_rotation,
    introduction,
    ordinary_rotation,
    orientations,
    quaternions,
)

WRONG: dict[str, list[tuple[Any, str]]] = {
    number: answers
    for page in (
        introduction,
        quaternions,
        ordinary_rotation,
        general_rotation,
        arcs,
        control_points,
        closed_curve,
        orientations,
        conclusions,
    )
    for number, answers in page.WRONG.items()
}
