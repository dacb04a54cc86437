"""Wrong answers to the exercises of Chapter 5, Control points, each with a word of its hint."""

from typing import Any

import numpy as np

from rotedu.arcs import angle_between
from rotedu.control_points import control_points
from rotedu.ordinary_rotation import rotate

RING = np.array([[1, -0.45, 0], [0.7, 0.6, -0.35], [0.1, 0.8, 0.5], [0.6, -0.05, 0.95]])
START, GOAL = np.array([-0.28, 0.96, 0]), np.array([0, 0.6, 0.8])
PRINTED = np.cross(GOAL, START)
HALF = angle_between(START, GOAL) / 2
MIDDLE = (START + GOAL) / np.linalg.norm(START + GOAL)
AS_PRINTED = rotate(START, PRINTED, HALF)


def astray(points: Any) -> tuple[Any, Any]:
    """Control points whose midpoints of step two are turned the wrong way, by (5-2) at t = -1/2."""
    points = points / np.linalg.norm(points, axis=1, keepdims=True)
    before, after = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
    beyond = 2 * (before * points).sum(axis=1, keepdims=True) * points - before
    theta = np.arccos((beyond * after).sum(axis=1, keepdims=True))
    wrong = (np.sin(1.5 * theta) * beyond - np.sin(theta / 2) * after) / np.sin(theta)
    a = (points + wrong) / np.linalg.norm(points + wrong, axis=1, keepdims=True)
    return a, 2 * (a * points).sum(axis=1, keepdims=True) * points - a


def degrees(p: Any, q: Any) -> Any:
    """Angles between vectors, in degrees."""
    return np.degrees(angle_between(p, q))


A, B = astray(RING)
BACK_A, BACK_B = astray(RING[::-1])

WRONG: dict[str, list[tuple[Any, str]]] = {
    "5.6": [
        ([1 / 3, 2 / 3, -2 / 3], "mirror image"),
        ([-1 / 3, -2 / 3, -2 / 3], "opposite"),
        ([4 / 9, 8 / 9, -1 / 9], "the pole in the point"),
        ([0, 0, 1], "halfway"),
    ],
    "5.7": [
        ([0.64, 0.48, 0], "not on the sphere"),
        ([1.28, 0.96, 0], "not on the sphere"),
        ([-0.8, -0.6, 0], "other side"),
        ([-0.6, 0.8, 0], "chord"),
        ([0.6, 0.8, 0], "the same distance"),
    ],
    "5.8": [
        (np.radians([60, 80, 40, -40, 35]), "radians"),
        ([120, 110, 55, -55, 35], "first"),
        ([60, 160, 40, -40, 35], "second"),
        ([60, 80, 80, -40, 35], "third"),
        ([60, 80, 40, 80, 35], "fourth"),
        ([60, 80, 40, -40, 70], "step two"),
        ([60, 80, 40, -40, 20], "difference"),
        ([60, 80, 40, -40, 40], "the rule"),
    ],
    "5.9": [
        ([0, 0, 0, 0], "as printed"),
        (np.radians([75, 63, 77, 50]), "radians"),
        (degrees(A, BACK_B), "different points"),
        (degrees(A, BACK_A[::-1]), "a_i with a_i"),
        (degrees(A, control_points(RING)[0]), "correct a_i"),
        (degrees(A, B), "one list"),
        ([60, 60, 60, 60], "made with"),
    ],
    "5.10": [
        ((AS_PRINTED, MIDDLE), "as printed"),
        ((rotate(GOAL, PRINTED, -HALF), MIDDLE), "first colleague does not change"),
        ((START, MIDDLE), "whole angle"),
        (([1, 0, 0], MIDDLE), "of the first"),
        ((MIDDLE, AS_PRINTED), "as printed"),
        ((MIDDLE, rotate(GOAL, PRINTED, -HALF)), "still turns"),
        ((MIDDLE, GOAL), "whole angle"),
        ((MIDDLE, [1, 0, 0]), "of the second"),
    ],
    "5.11": [
        (lambda before, after: (before + after) / 4, "never jumps"),
        (
            lambda before, after: (before + after) / 4 + 180 * (abs(before - after) > 180),
            "too far",
        ),
        (
            lambda before, after: (before + after) / 4 - 90 * (abs(before - after) > 180),
            "same side",
        ),
        (
            lambda before, after: (
                (before + after) / 4 + 90 * np.sign(before + after) * (abs(before - after) > 180)
            ),
            "wrong side",
        ),
        (lambda before, after: (before + after) / 2, "not even"),
        (
            lambda before, after: (before + after) / 4 if abs(before - after) < 180 else 0,
            "but not beyond",
        ),
    ],
}
