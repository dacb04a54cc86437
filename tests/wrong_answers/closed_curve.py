"""Wrong answers to the exercises of Chapter 5, Closed curve, each with a word of its hint."""

from typing import Any

import numpy as np

from rotedu.closed_curve import de_casteljau
from rotedu.control_points import control_points, double

WIDE = np.array([[0.9, 0.3, 0.3], [0.3, 0.9, 0.3], [-0.3, 0.9, -0.3], [-0.9, 0.3, 0.3]])
WIDE /= np.linalg.norm(WIDE, axis=1, keepdims=True)
CORNERS = np.array([[0.8, -0.4, 0.4], [0.5, 0.8, -0.4], [0.6, 0.7, 0.4], [0.1, 0.4, 0.9]])
CORNERS /= np.linalg.norm(CORNERS, axis=1, keepdims=True)


def arc(p: Any, q: Any, t: float) -> Any:
    """(5-2) as printed."""
    theta = np.arccos((p * q).sum(axis=-1, keepdims=True))
    return (np.sin((1 - t) * theta) * p + np.sin(t * theta) * q) / np.sin(theta)


def upwards(row: Any) -> Any:
    """The loop in one row, with k running upwards."""
    row = row.copy()
    for j in range(1, 4):
        for k in range(j, 4):
            row[k] = arc(row[k - 1], row[k], 0.4)
    return row[3]


def straight(points: Any) -> Any:
    """De Casteljau's construction with straight lines."""
    while len(points) > 1:
        points = 0.6 * points[:-1] + 0.4 * points[1:]
    return points[0]


BEYOND = double(np.roll(CORNERS, 1, axis=0), CORNERS)
MIDDLE = arc(BEYOND, np.roll(CORNERS, -1, axis=0), -0.5)
ASTRAY = arc(CORNERS, MIDDLE, 0.5)
CORRECT, _ = control_points(CORNERS)

WRONG: dict[str, list[tuple[Any, str]]] = {
    "5.12": [
        ((20, 10, 90), "faster"),
        ((30, 60, 90), "wrong way round"),
        ((80, 80, 90), "mean speed"),
        (np.radians([60, 30, 90]), "radians"),
        ((60, 70, 90), "speeds are not right"),
        ((60, 30, 70), "turn back"),
        ((60, 30, 110), "too fast"),
        ((60, 30, 100), "the angle is not yet"),
    ],
    "5.13": [
        ((3, 10), "first level"),
        ((4, 11), "count the control points"),
        ((10, 66), "included"),
        ((6, 45), "ten control points"),
        ((6, 20), "in proportion"),
        ((7, 55), "Picture 5-d"),
    ],
    "5.14": [
        (upwards(WIDE), "new level"),
        (de_casteljau(WIDE, 0.6), "other end"),
        (straight(WIDE), "not on the sphere"),
        (WIDE[1], "at this u"),
    ],
    "5.15": [
        ((CORRECT, 0), "correct a_i"),
        ((double(ASTRAY, CORNERS), 0), "b_i that belong"),
        ((MIDDLE, 0), "step two"),
        ((CORNERS, 0), "the error of the paper"),
        ((ASTRAY, 1), "Which check"),
        ((ASTRAY, 3), "number of checks"),
    ],
    "5.16": [
        ((0.614, False), "upside down"),
        ((1.858, False), "a median by a median"),
        ((2.5, False), "1.14"),
        ((1.63, True), "really best"),
        ((1.63, "yes"), "really best"),
    ],
}
