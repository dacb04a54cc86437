"""Wrong answers to the exercises of Chapter 4, with words of the hints."""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

U, V, W = np.eye(3)
DEGREES = np.array([(10, 20, 30), (10, 160, 30), (40, 90, 10)])
ANGLES = np.deg2rad(DEGREES)


def turned(axes: str, angles: Any) -> np.ndarray:
    """Make a 4 x 4 matrix; small letters of axes stay fixed."""
    matrix = np.eye(4)
    matrix[:3, :3] = Rotation.from_euler(axes, angles).as_matrix()
    return matrix


LEFT, STRETCH, RIGHT = np.linalg.svd([[1, 0.8, 0], [0, 1, 0], [0, 0, 1]])
LEFT, STRETCH, RIGHT = -LEFT, np.diag(STRETCH), -RIGHT

TRIANGLES = np.random.default_rng(0).uniform(-1, 1, size=(20, 3, 3))
NEAR_LAST = np.argsort(TRIANGLES[:, :, 2].mean(axis=1))
PROJECTION = np.eye(4) - np.outer([0, 0, 0, 1], [0, 0, 0.5, 0])
TILT = turned("xyz", [0.3, 0.5, 0.7])

WRONG: dict[str, list[tuple[Any, str]]] = {
    "4.1": [(-U, "W first"), (-W, "clockwise"), (U, "elsewhere")],
    "4.2": [
        (([12, 4, 6], [2, 4, 6]), "before"),
        (([7, 4, 6], [7, 4, 6]), "as a point"),
        (([2, 4, 6], [7, 4, 6]), "exchanged"),
        (([6, 2, 3], [2, 4, 6]), "point goes elsewhere"),
        (([7, 4, 6], [1, 2, 3]), "direction goes elsewhere"),
    ],
    "4.3": [
        (("WVU", W, 180), "about U first"),
        (("UWV", W, 180), "another order"),
        (("UVW", W, np.pi), "radians"),
        (("UVW", W, 360), "nothing"),
        (("UVW", U + V, 180), "half turns"),
    ],
    "4.4": [
        (turned("xyz", [0.4, 0.7, -1.1]), "way there"),
        (turned("xyz", [-0.4, -0.7, 1.1]), "signs are changed"),
        (turned("zyx", [-1.1, 0.7, 0.4]), "order is reversed"),
        (np.eye(4), "unit matrix"),
    ],
    "4.5": [
        (DEGREES, "in degrees"),
        (ANGLES[:, ::-1], "W, V, U"),
        ([*ANGLES[:2], [0, np.pi / 2, 0]], "gimbal lock"),
        (np.deg2rad([(10, 20, 30), (10, 20, 30), (40, 90, 10)]), "second triple"),
        (-ANGLES, "first triple"),
        (
            [Rotation.from_euler("xyz", angles).inv().as_euler("xyz") for angles in ANGLES],
            "transposed",
        ),
    ],
    "4.6": [
        ((LEFT, STRETCH, RIGHT.T), "transposed"),
        ((-LEFT, STRETCH, -RIGHT), "left mirrors"),
        ((np.eye(3), STRETCH, np.eye(3)), "not the shear"),
        ((LEFT, LEFT, RIGHT), "along the axes"),
        ((2 * LEFT, STRETCH / 2, RIGHT), "orthogonal"),
        ((RIGHT, STRETCH, LEFT), "order"),
    ],
    "4.7": [
        ((TILT, TRIANGLES, NEAR_LAST), "no perspective"),
        ((TILT @ PROJECTION, TRIANGLES, NEAR_LAST), "moved into place"),
        ((np.linalg.inv(PROJECTION) @ TILT, TRIANGLES, NEAR_LAST), "far things look larger"),
        ((PROJECTION @ TILT, TRIANGLES, NEAR_LAST[::-1]), "near triangles first"),
        ((PROJECTION @ TILT, TRIANGLES, np.arange(20)), "not sorted"),
        ((PROJECTION @ TILT, TRIANGLES, np.zeros(20)), "each triangle once"),
    ],
}
