"""Wrong answers to the exercises of Chapter 5, Arcs, each with a word of the hint meant for it."""

from typing import Any

import numpy as np

from rotedu.arcs import nlerp, slerp

AXIS, POINT = [0.783, -0.206, -0.587], [0.622, 0.277, 0.732]
EARLY = slerp([0.48, 0.8, 0.36], [0.6, 0, 0.8], 0.3)
STATIONS = np.array([[1, 0, 0], [0, 1, 0], [0, 0.6, 0.8], [-0.8, 0, 0.6]])
TIMES = np.linspace(0, 3, 1000)
LEG = np.minimum(TIMES.astype(int), 2)
ON_LEG = STATIONS[LEG], STATIONS[LEG + 1], TIMES - LEG

WRONG: dict[str, list[tuple[Any, str]]] = {
    "5.1": [
        ([15, 120, -60], "first point"),
        ([17.5, 140, -70], "second point"),
        ([25, 70, 10], "stop"),
        (np.radians([25, 130, -50]), "radians"),
        ([30, 130, -50], "How long"),
    ],
    "5.2": [
        ((np.negative(AXIS), POINT, POINT), "leads away"),
        ((np.multiply(AXIS, 0.8176), POINT, POINT), "length 1"),
        ((POINT, AXIS, AXIS), "The axis"),
        ((AXIS, EARLY, EARLY), "is t?"),
        ((AXIS, POINT, AXIS), "One of the points"),
    ],
    "5.3": [
        ((8388, 67.2), "through the Earth"),
        ((524_592, 67.2), "radians"),
        ((8319, 67.2), "west"),
        ((14_463, 67.2), "changed places"),
        ((67.2, 9156), "the latitude"),
        ((9000, 67.2), "length 1"),
        ((9156, 50), "on the way"),
        ((9156, np.radians(67.2)), "in radians"),
        ((9156, 22.8), "pole"),
        ((9156, 60), "not yet"),
    ],
    "5.4": [
        ((1, 0.92, 3), "long way"),
        ((-1, 0.46, 3), "between the quaternions"),
        ((-1, 0.016, 3), "in radians"),
        ((-1, 4.07, 3), "Where on the way"),
        ((-1, 0.92, 2), "not quite enough"),
        ((-1, 0.92, 10), "number of parts"),
    ],
    "5.5": [
        (STATIONS[LEG] + ON_LEG[2][:, np.newaxis] * (ON_LEG[1] - ON_LEG[0]), "length 1"),
        (slerp(*ON_LEG)[::-1], "begin"),
        (slerp(*ON_LEG), "same time"),
        (nlerp(*ON_LEG), "not equal"),
    ],
}
