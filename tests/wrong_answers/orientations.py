"""Wrong answers to the exercises of Chapter 5, Points and orientations, with words of the hints."""

from typing import Any

import numpy as np

R1 = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
R2 = np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0]])
FLIGHTS = np.array([[3.7, 1.01, 1.0], [3.1, 1.02, 1.4], [24.2, 1.18, 3.9], [4.7, 1.01, 1.0]])


def with_column(index: int, column: Any) -> Any:
    """The right table, but for one column."""
    table = FLIGHTS.copy()
    table[:, index] = column
    return table


WRONG: dict[str, list[tuple[Any, str]]] = {
    "5.17": [
        (R2 @ R1.T, "on the left"),
        (R2.T @ R1, "from the second to the first"),
        (R1 @ R2, "undo none"),
        (R1 @ R2.T, "the second turn in place"),
        (np.eye(3), "is not R2"),
    ],
    "5.18": [
        ([150, 150, 150], "change of sign"),
        ([-30, -30, -30], "change of sign"),
        ([-30, 150, -30], "wrong way round"),
        ([150, -30, 150], "third way"),
        ([75, -15, -15], "in the quaternions"),
        (np.radians([150, -30, -30]), "radians"),
        ([120, 60, 60], "half of the turn"),
    ],
    "5.19": [
        (np.radians(40), "radians"),
        (220, "sum of the angles"),
        (0, "about its vertical"),
        (90, "an eighth"),
        (20, "three angles"),
    ],
    "5.20": [
        ((30, 2), "need not be"),
        ((2, 0), "not refused"),
        ((0, 0), "raise an error"),
        ((15, 0), "all 32"),
        ((31, 1), "Run through"),
    ],
    "5.21": [
        (with_column(0, np.radians(FLIGHTS[:, 0])), "radians"),
        (with_column(0, 0), "does roll"),
        (with_column(0, [3.1, 24.2, 4.7, 3.7]), "wrong sight"),
        (with_column(0, 10), "first column"),
        (with_column(1, [1.0, 0.98, 0.637, 0.998]), "line of sight alone"),
        (with_column(1, 1 / np.array([1.006, 1.02, 1.179, 1.01])), "second column is upside"),
        (with_column(1, 2), "second column is not"),
        (with_column(2, 1), "does not turn evenly"),
        (with_column(2, 1 / FLIGHTS[:, 2]), "third column is upside"),
        (with_column(2, 2), "third column is not"),
    ],
}
