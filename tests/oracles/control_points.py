"""The outputs of the figures of page 5 II, by rotedu."""

from math import ceil
from typing import Any

import numpy as np

from rotedu.arcs import angle_between, arc_axis, slerp
from rotedu.closed_curve import de_casteljau
from rotedu.control_points import bisect, control_points, double
from rotedu.ordinary_rotation import rotate
from rotedu.scenes.arcs import CAMERA_TARGETS
from rotedu.scenes.control_points import NOT_YET, STEPS, VERDICTS

SAME = 1e-6


def control_points_by_hand(
    points: Any, step: float, printed_axis: bool, printed_double: bool, one_circle: bool
) -> dict[str, Any]:
    before, here, after = np.divide(points, np.linalg.norm(points, axis=1, keepdims=True))
    if one_circle:
        axis = arc_axis(before, here)
        after = np.cross(arc_axis(axis, after), axis)
    # Arcs that are drawn have to exist.
    for q in (before, after):
        slerp(q, here, 0)
    reflected = double(before, here)
    middle = slerp(reflected, after, -0.5) if printed_axis else bisect(reflected, after)
    a = bisect(middle, here)
    b = double(here, a) if printed_double else double(a, here)
    span = angle_between(reflected, after)
    halves = [angle_between(middle, q) for q in (reflected, after)]
    normals = np.cross(b, here), np.cross(here, a)
    errors = {
        "midway": np.ptp([*halves, span / 2]),
        "on_circle": abs(np.linalg.det([a, b, here])),
        "equally_far": abs(angle_between(here, a) - angle_between(here, b)),
        "no_corner": -np.dot(*normals),
    }
    passed = {name: bool(error < SAME) for name, error in errors.items()}
    return {
        "now": STEPS[ceil(step)],
        "tests": VERDICTS[list(passed.values()).count(False)] if step == 4 else "",
        "to_jump": 180 - np.degrees(span) if one_circle and step >= 1 else "",
        **{
            name: ("no", "yes")[right] if step >= (2 if name == "midway" else 4) else NOT_YET
            for name, right in passed.items()
        },
    }


def arrow_at_the_clock(aim: float) -> dict[str, list[float]]:
    """The bends, from the corners of a polygon on each half of the curve."""
    p = np.divide(CAMERA_TARGETS, np.linalg.norm(CAMERA_TARGETS, axis=1, keepdims=True))
    door, clock, window, _ = p
    a, b = control_points(p)
    ahead = rotate(clock, arc_axis(door, clock), angle_between(clock, a[1]))
    tip = rotate(ahead, clock, np.radians(aim))
    halves = [door, a[0], double(tip, clock), clock], [clock, tip, b[2], window]
    return {"bends": [bend(np.array(half)) for half in halves]}


def bend(control: Any) -> float:
    """The sum of the angles between the sides of a polygon on a Bezier curve, in degrees."""
    points = de_casteljau(control, np.linspace(0, 1, 401))
    normals = np.cross(points[:-1], points[1:])
    return float(np.degrees(angle_between(normals[:-1], normals[1:]).sum()))
