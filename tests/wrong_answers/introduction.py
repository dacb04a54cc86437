"""Wrong answers to the exercises of Chapter 1, with words of the hints."""

from typing import Any

import numpy as np

TURN = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0]])
THIRD = np.array([-0.8, 0, 0.6])
CORNER = np.array([[0.36, -0.48, 0.8], [0.8, 0.6, 0], [-0.48, 0.64, 0.6]])
MIRRORED = CORNER @ np.diag([1, 1, -1])
COMPLETED = CORNER * [[1, 1, -1], [1, 1, -1], [-1, -1, 1]]
ROWS = np.arange(9).reshape(3, 3)

WRONG: dict[str, list[tuple[Any, str]]] = {
    "1.1": [
        (TURN.T, "the other way"),
        (np.eye(3), "leaves every axis"),
        (-TURN, "Some axis"),
    ],
    "1.2": [
        (([0, 0, -1], 53.13, "same"), "half the angle"),
        (([0, 0, -1], 1.8546, "same"), "radians"),
        (([0, 0, 1], 106.26, "same"), "opposite sense"),
        (([0, 0, -0.8], 106.26, "same"), "length 1"),
        (([0, 0, -1], 120, "same"), "do not make"),
        (([0, 0, -1], 106.26, "inverse"), "second quaternion"),
    ],
    "1.3": [
        ((-THIRD, (6, 3), CORNER), "mirrors"),
        (([1, 0, 0], (6, 3), CORNER), "does not complete"),
        ((THIRD, (9, 6), CORNER), "counts"),
        ((THIRD, (6, 3), np.eye(3)), "another corner"),
        ((THIRD, (6, 3), MIRRORED), "not a rotation"),
        ((THIRD, (6, 3), COMPLETED), "have completed"),
    ],
    "1.4": [
        (ROWS, "missing"),
        ([*ROWS, *ROWS.T, [0, 4, 8]], "can be free"),
        (ROWS + 1, "too large"),
    ],
}
