"""The outputs of the figures of page 5 V, by rotedu and SciPy."""

from itertools import pairwise
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from rotedu.arcs import slerp
from rotedu.averages import angular_distance
from rotedu.orientation_curves import closed_rotation_curve, squad
from rotedu.orientations import nearest_rotation, slerp_rotations
from rotedu.quaternions import Quaternion

SAMPLES = 20
PICTURES = 24


def routes_by_hand(poses: Any, u: float) -> dict[str, Any]:
    q = np.divide(poses, np.linalg.norm(poses, axis=1, keepdims=True))
    r, after = matrices(q), matrices(np.roll(q, -1, axis=0))
    route = closed_rotation_curve(r, SAMPLES)
    doubled = r @ np.roll(r, 1, axis=0).swapaxes(1, 2) @ r
    a = slerp_rotations(r, slerp_rotations(doubled, after, 1 / 2), 1 / 2)
    b = r @ a.swapaxes(1, 2) @ r
    level = [m[:, np.newaxis] for m in (r, a, np.roll(b, -1, axis=0), after)]
    while len(level) > 1:
        level = [slerp_rotations(m, n, np.arange(SAMPLES) / SAMPLES) for m, n in pairwise(level)]

    to_here = Quaternion.from_matrix(np.roll(r, 1, axis=0).swapaxes(1, 2) @ r)
    to_next = Quaternion.from_matrix(r.swapaxes(1, 2) @ after)
    w, *v = (to_here.conjugate() * to_next).components.T
    products = np.sum(q * np.roll(q, -1, axis=0), axis=1)
    return {
        "turn": np.degrees(2 * np.arctan2(np.linalg.norm(v, axis=0), w).max()),
        "apart": np.degrees(angular_distance(route, level[0].reshape(-1, 3, 3)).max()),
        "signs": "can agree" if products.prod() > 0 else "cannot agree",
    }


CHOSEN = {
    "slerp and the paper's": [0, 3],
    "squad and the paper's": [1, 3],
    "both splines": [2, 4],
    "all five": [0, 1, 2, 3, 4],
}


def animate(poses: Any, t: float, films: str, fraction: float) -> dict[str, Any]:
    q = np.divide(poses, np.linalg.norm(poses, axis=1, keepdims=True))
    r, sides = matrices(q), zip(q, np.roll(q, -1, axis=0), strict=True)
    moments = np.arange(len(q) * PICTURES) / PICTURES
    all_films = (
        matrices([slerp(*side, u) for side in sides for u in moments[:PICTURES]]),
        matrices(squad(q, PICTURES)),
        matrices(closed_spline(q)(moments)),
        closed_rotation_curve(r, PICTURES, fraction),
        nearest_rotation(closed_spline(r)(moments)),
    )
    steps, velocity, acceleration = map(np.array, zip(*map(motion, all_films), strict=True))
    now = divmod(int(len(moments) * t + 1 / 2) % len(moments), PICTURES)
    changes = (x[:, :, 0] - np.roll(x[:, :, -1], 1, axis=1) for x in (velocity, acceleration))
    corners, jumps = (np.linalg.norm(change, axis=-1).max(axis=1) for change in changes)
    return {
        "fastest": np.linalg.norm(steps, axis=-1).max(axis=(1, 2))[CHOSEN[films]],
        "speed": np.linalg.norm(velocity[:, *now], axis=-1)[CHOSEN[films]],
        "corner": corners[0],
        "jumps": jumps[[1, 3]],
    }


def motion(film: Any) -> tuple[Any, Any, Any]:
    turns = Rotation.from_matrix(film.swapaxes(1, 2) @ np.roll(film, -1, axis=0))
    steps = PICTURES * np.degrees(turns.as_rotvec()).reshape(-1, PICTURES, 3)
    # At both ends of a segment, the cubic through four steps goes on.
    before, beyond = (
        CubicSpline(range(4), s[:, :4], axis=1)([-1]) for s in (steps, steps[:, ::-1])
    )
    longer = np.concatenate([before, steps, beyond], axis=1)
    return steps, (longer[:, 1:] + longer[:, :-1]) / 2, PICTURES * np.diff(longer, axis=1)


def matrices(q: Any) -> Any:
    return Rotation.from_quat(q, scalar_first=True).as_matrix()


def closed_spline(values: Any) -> CubicSpline:
    return CubicSpline(range(len(values) + 1), [*values, values[0]], bc_type="periodic")


def two_middles(swing: float) -> dict[str, float]:
    """The angle between the middles of both turns from 10 degrees to twice the swing."""
    next_place, on = (Rotation.from_euler("z", angle, degrees=True) for angle in (10, 2 * swing))
    # A rotation vector is that of the shorter turn.
    shorter = next_place * Rotation.from_rotvec((next_place.inv() * on).as_rotvec() / 2)
    remembered = Rotation.from_euler("z", (10 + 2 * swing) / 2, degrees=True)
    apart = np.degrees((shorter.inv() * remembered).magnitude())
    # At 95 degrees both turns are equally long.
    return {"apart": 0 if swing == 95 else apart}


def the_swing(t: float) -> dict[str, Any]:
    """Cubic curves through angles, by arcs that are the whole way or the shorter way round."""
    places = np.array([0.0, 100, 10, -60])

    def turned(way: Any) -> float:
        def between(a: Any, b: Any, u: Any) -> Any:
            return a + u * way(b - a)

        before, after = np.roll(places, 1), np.roll(places, -1)
        a = between(places, between(places + way(places - before), after, 0.5), 0.5)
        b = places - way(a - places)
        level = [x[:, np.newaxis] for x in (places, a, np.roll(b, -1), after)]
        while len(level) > 1:
            level = [between(p, q, np.arange(SAMPLES) / SAMPLES) for p, q in pairwise(level)]
        angles = np.unwrap(level[0].ravel(), period=360)
        return float(angles[round(len(angles) * t) % len(angles)])

    return {
        "route": turned(lambda angle: angle),
        "shortest": turned(lambda angle: (angle + 180) % 360 - 180),
    }
