"""The outputs of the figure of page 5 I, by rotedu and numpy."""

from typing import Any

import numpy as np

from rotedu.arcs import angle_between
from rotedu.errors import DegenerateError

SAME = 1e-6


def the_detour(aside: float) -> dict[str, float]:
    t = np.linspace(0, 1, 61)
    down, east = np.radians(80) * t, np.radians(aside) * np.sin(np.pi * t)
    path = np.array([np.sin(down) * np.cos(east), np.sin(down) * np.sin(east), np.cos(down)]).T
    return {
        "length": np.degrees(2 * np.arcsin(np.linalg.norm(np.diff(path, axis=0), axis=1) / 2)).sum()
    }


def slerp_by_hand(p: Any, q: Any, t: float, flip: bool) -> dict[str, Any]:
    first, last = (np.divide(v, np.linalg.norm(v)) for v in (p, q))
    last = -last if flip else last
    theta = angle_between(first, last)
    if theta > np.pi - SAME:
        raise DegenerateError("the ends are antipodal: no unique arc joins them")
    # numpy's sinc of x / pi is sin(x) / x, with its limit 1 at 0.
    start, end = (x * np.sinc(x * theta / np.pi) / np.sinc(theta / np.pi) for x in (1 - t, t))
    chord = (1 - t) * first + t * last
    return {
        "angle": np.degrees(theta),
        "way": 2 * np.degrees(theta),
        "speed": np.sinc(theta / np.pi) / (chord @ chord),
        "start_weight": start,
        "end_weight": end,
        "weights_sum": start + end,
    }
