"""The outputs of the figures of page 5 III, by rotedu, numpy and SciPy."""

from itertools import pairwise
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation
from spheres import segments

from rotedu.arcs import angle_between, arc_axis
from rotedu.closed_curve import closed_curve, de_casteljau, de_casteljau_levels

STEP = 3e-4
LEG = 24
SEEN = ("door", "clock", "window", "desk")


def motion(control: Any, u: Any) -> Any:
    before, here, after = (de_casteljau(control, np.add(u, x)) for x in (-STEP, 0, STEP))
    velocity = (after - before) / (2 * STEP)
    acceleration = (after - 2 * here + before) / STEP**2
    sideways = np.sum(np.cross(here, velocity) * acceleration, axis=-1)
    return here, velocity, sideways / np.maximum(np.linalg.norm(velocity, axis=-1), STEP) ** 3


def closed_curve_by_hand(points: Any, u: float, fraction: float) -> dict[str, Any]:
    control = segments(points, fraction)
    n = len(control)
    segment = min(int(n * u), n - 1)
    _, velocity_here, curvature_here = motion(control[segment], n * u - segment)
    # Refuses a curve that could go two ways.
    closed_curve(points, 1, fraction)
    _, velocity, curvature = motion(control[:, np.newaxis], np.linspace(0, 1, round(96 / n) + 1))
    speed = np.degrees(np.linalg.norm(velocity, axis=-1))
    jump = np.linalg.norm(velocity[:, 0] - np.roll(velocity[:, -1], 1, axis=0), axis=-1)
    jumps = abs(curvature[:, 0] - np.roll(curvature[:, -1], 1))
    return {
        "speed": np.degrees(np.linalg.norm(velocity_here)),
        "curvature": curvature_here,
        "velocity_jump": np.degrees(jump.max()),
        "curvature_jump": jumps[int(n * u + 1 / 2) % n],
        "speed_range": [speed.min(), speed.max()],
        "curvature_jumps": jumps,
    }


def arcs_of_arcs(control: Any, u: float) -> dict[str, Any]:
    (start, *_), *levels = de_casteljau_levels(control, u)
    return {
        f"way_{j}": np.degrees(angle_between(start, first))
        for j, (first, *_) in enumerate(levels, start=1)
    }


def camera_by_hand(u: float, targets: Any, path: str, roll: str) -> dict[str, Any]:
    p = np.divide(targets, np.linalg.norm(targets, axis=1, keepdims=True))
    legs = {"curve": segments(p), "arcs": np.stack([p, np.roll(p, -1, axis=0)], axis=1)}
    ways: dict[str, Any] = {
        "arcs": [de_casteljau(arc, 0) for arc in legs["arcs"]],
        "curve": closed_curve(p, LEG),
    }
    leg = min(int(len(p) * u), len(p) - 1)
    ahead, velocity, _ = motion(legs[path][leg], len(p) * u - leg)
    upright = np.cross(ahead, arc_axis([0, 0, 1], ahead))
    rolled, spin = (
        0.0,
        ahead[2] * np.cross(ahead, velocity)[2] / max(ahead[:2] @ ahead[:2], STEP**2),
    )
    if roll == "carried along":
        way, spin = ways[path], 0.0
        up = np.cross(p[0], arc_axis([0, 0, 1], p[0]))
        for q, r in pairwise([*way[: min(int(len(way) * u), len(way) - 1) + 1], ahead]):
            # Of the length of the angle; numpy's sinc of x / pi is sin(x) / x.
            turn = np.cross(q, r) / np.sinc(angle_between(q, r) / np.pi)
            up = Rotation.from_rotvec(turn).apply(up)
        rolled = np.arctan2(np.cross(upright, up) @ ahead, upright @ up)
    ends = motion(legs[path][:, np.newaxis], [0, 1])[1]
    arriving, leaving = np.roll(ends[:, 1], 1, axis=0), ends[:, 0]
    across = np.linalg.norm(np.cross(arriving, leaving), axis=1)
    bends = np.degrees(np.arctan2(across, np.sum(arriving * leaving, axis=1)))
    return {
        "rolled": np.degrees(rolled),
        "spin": np.degrees(spin),
        "speed": np.degrees(np.linalg.norm(velocity)),
        "bends": ", ".join(f"{name} {x:.0f}°" for name, x in zip(SEEN, bends, strict=True)),
    }
