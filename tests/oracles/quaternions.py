"""The outputs of the figures of Chapter 2, by rotedu and SciPy."""

from typing import Any

import numpy as np

from rotedu.arcs import nlerp, slerp
from rotedu.general_rotation import euler_angles, quaternion_from_euler_angles
from rotedu.quaternions import Quaternion

W = [0, 0, 1]


def is_back(degrees: float, lap: float) -> str:
    return "yes" if (abs(degrees) + 0.5) % lap < 1 else "no"


def two_mirrors_by_hand(both: float, first: float, second: float, letter: float) -> dict[str, Any]:
    m1, m2 = np.radians([first + both, second + both])
    normals = [Quaternion(0, [-np.sin(m), np.cos(m), 0]) for m in (m1, m2)]
    between = 180 - (180 - second + first) % 360
    return {
        "between": between,
        "turned": 2 * between,
        "q": -(normals[1] * normals[0]).components,
        "home": is_back(2 * between, 360),
    }


def mirrors_in_the_plane(between: float) -> dict[str, Any]:
    return {"turned": 2 * between}


def half_the_work(done: float) -> dict[str, Any]:
    left, right = np.radians(40) * np.clip([done, done - 1], 0, 1)
    powers = [Quaternion(np.cos(half), [np.sin(half), 0, 0]) for half in (left, right)]
    return {"scalar": (powers[0] * Quaternion(0, [0.8, 1, 0]) * powers[1].conjugate()).w}


def grab_the_spoon(spoon: Any, way: str, along: float, left: Any) -> dict[str, Any]:
    q = np.asarray(spoon if way == "by hand" else on_way(way, along, left))
    angle = float(np.degrees(Quaternion(q[0], q[1:]).axis_angle()[1]))
    return {"q": q, "angle": angle, "home": is_back(angle, 360)}


def on_way(way: str, along: float, left: Any) -> Any:
    if way.startswith("half turns"):
        q = Quaternion(1, [0, 0, 0])
        for k, letter in enumerate(way[-7::3]):
            axis = np.eye(3)["UVW".index(letter)]
            q = Quaternion.from_axis_angle(axis, np.pi * np.clip(3 * along - k, 0, 1)) * q
        return q.components
    if way == "full turn":
        sway = 0.3 * np.sin(np.pi * along * np.array([4, 6]))
        return Quaternion.from_axis_angle([*sway, 1], 2 * np.pi * along).components
    if way == "home by Euler angles":
        angles = np.array(euler_angles(Quaternion(left[0], left[1:]).matrix()))
        start, now = (quaternion_from_euler_angles(*(s * angles)) for s in (1, 1 - along))
        return np.sign(start.components @ left) * now.components
    home = [1 if left[0] >= 0 else -1, 0, 0, 0]
    return {"home by slerp": slerp, "home by nlerp": nlerp}[way](left, home, along)


def the_ribbon(done: float) -> dict[str, Any]:
    turns, passed = min(done, 2), max(done - 2, 0)
    return {"twists": "on its way" if 0 < passed < 1 else turns - 2 * passed}


def plate_and_arm(turns: float) -> dict[str, Any]:
    return {
        "angle": 360 * turns,
        "q": Quaternion.from_axis_angle(W, 2 * np.pi * turns).components,
        "spoon_back": is_back(360 * turns, 360),
        "arm_straight": is_back(360 * turns, 720),
    }
