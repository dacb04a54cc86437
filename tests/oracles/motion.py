"""The outputs of the figures of page A, by rotedu and SciPy."""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from rotedu.averages import angular_distance
from rotedu.orientations import nearest_rotation
from rotedu.quaternions import Quaternion

SPEED = np.pi / 2


def spinning_bodies(space: Any, body: Any, h: float, t: float, repair: bool) -> dict[str, Any]:
    """The matrices that draw the body by each method."""
    omega, own = (SPEED * np.divide(axis, np.linalg.norm(axis)) for axis in (space, body))

    m, q = np.eye(3), Quaternion(1, np.zeros(3))
    for step in [h] * int(t / h) + [t - int(t / h) * h]:
        m = m + step * (np.cross(omega, m, axisb=0, axisc=0) + np.cross(m, own))
        q = q + step / 2 * (Quaternion(0, omega) * q + q * Quaternion(0, own))
        m, q = (nearest_rotation(m), q / q.norm()) if repair else (m, q)
    exact = Rotation.from_rotvec(t * omega) * Rotation.from_rotvec(t * own)
    return {
        "exponential": exact.as_matrix(),
        "Euler, matrix": m,
        "Euler, quaternion": q.norm() ** 2 * q.matrix(),
    }


def spinning_by_hand(**inputs: Any) -> dict[str, Any]:
    drawn = spinning_bodies(**inputs)
    exact = drawn["exponential"]
    return {
        name: f"edge {np.linalg.norm(now, axis=0).max():.2f},"
        f" {np.degrees(angular_distance(nearest_rotation(now), exact)):.0f}° off"
        for name, now in drawn.items()
    }


def the_drone(time: float) -> dict[str, float]:
    angles = 90 * np.clip([time, time - 1], 0, 1)
    yaw, roll = (
        Rotation.from_euler(*turn, degrees=True) for turn in zip("zx", angles, strict=True)
    )
    return {"apart": np.degrees(((yaw * roll).inv() * (roll * yaw)).magnitude())}
