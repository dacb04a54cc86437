"""The outputs of the figures of Chapter 4, by rotedu and SciPy."""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from rotedu.quaternions import Quaternion

NO_WAY = "no unique path: start and end are half a turn apart"


def three_turns_by_hand(u: float, v: float, w: float, order: str, axes: str) -> dict[str, Any]:
    angles = {"U": u, "V": v, "W": w}

    def turned(letters: str, carried: bool) -> tuple[Any, str]:
        # SciPy turns about x, y, z, and about axes carried along in capitals.
        names = letters.translate(str.maketrans("UVW", "XYZ" if carried else "xyz"))
        end = Rotation.from_euler(names, [angles[letter] for letter in letters], degrees=True)
        written = letters if carried else letters[::-1]
        return end, " ".join(f"M({letter.lower()})" for letter in written)

    first, upper = turned("UVW", carried=False)
    second, lower = turned(order.replace(" ", ""), axes == "carried along")
    apart = np.degrees((first.inv() * second).magnitude())
    return {"apart": apart, "upper": upper, "lower": lower}


def one_degree(tilt: float) -> dict[str, float]:
    tipped = Rotation.from_euler("x", tilt, degrees=True) * Rotation.from_euler("y", np.pi / 2)
    return {"outer": tipped.as_euler("xyz", degrees=True)[2] if tilt else 0}


def euler_angles_by_hand(u: float, v: float, w: float, spoon: Any, t: float) -> dict[str, Any]:
    angles = np.array([u, v, w])

    def pose(angles: Any) -> Any:
        return Rotation.from_euler("xyz", angles, degrees=True)

    def degrees_between(start: Any, end: Any) -> Any:
        return np.degrees((start.inv() * end).magnitude())

    end = pose(angles)
    way = pose(np.multiply.outer(np.linspace(0, 1, 33), angles))
    by_slerp = np.degrees(end.magnitude())
    ahead, back, other = pose(angles + np.array([(1, 0, 0), (-1, 0, 0), (0, 0, 1)]))
    q = Quaternion.from_matrix(end.as_matrix()).components
    return {
        "rings": angles,
        "by_angles": degrees_between(way[:-1], way[1:]).sum(),
        "by_slerp": by_slerp if by_slerp < 180 - 1e-9 else NO_WAY,
        "apart": min(degrees_between(ahead, other), degrees_between(back, other)),
        "matrix": end.as_matrix(),
        "q": q if q @ spoon >= 0 else -q,
    }
