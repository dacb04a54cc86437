"""Scenes of page 5 III: de Casteljau's arcs, the curve of Figure 8, a camera."""

from collections.abc import Mapping
from itertools import pairwise

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import angle_between, arc_axis, slerp
from rotedu.closed_curve import closed_curve, de_casteljau, de_casteljau_levels
from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.control_points import bisect, control_points, double
from rotedu.figures import (
    Choice,
    Handles,
    Slider,
    add_view,
    describe,
    draw_chart,
    explorable,
    place_grip,
    place_part,
    read_out,
)
from rotedu.ordinary_rotation import rotate
from rotedu.scenes.arcs import CAMERA_SEES, CAMERA_TARGETS, camera
from rotedu.scenes.parts import (
    JUST_INSIDE,
    ORIGIN,
    add_arc,
    add_arrow,
    add_label,
    add_line,
    add_lines,
    add_point,
    add_sphere,
    new_scene,
    normalised,
    sphere_scene,
    turning,
)

# Uneven gaps, one of them beyond 90 degrees, and all points on the side of the camera.
FIGURE_8 = ((0.8, -0.4, 0.4), (0.5, 0.8, -0.4), (0.6, 0.7, 0.4), (0.1, 0.4, 0.9))


def figure_8(points: ArrayLike = FIGURE_8, fraction: float = 1 / 2) -> pyvista.Plotter:
    """Draw Fig. 8: a closed curve on the sphere, its points and its control points.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        At least 3 points P_0 ... P_{n-1}; they are normalised.
    fraction : float
        How far ``a_i`` goes from ``P_i`` towards the midpoint. The paper takes 1/2.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    p = normalised(points)
    a, b = control_points(p, fraction)
    curve = closed_curve(p, 30, fraction)

    plotter = sphere_scene(eye=(4.28, 2.42, 2.51))
    add_line(plotter, [*curve, curve[0]], RESULT, radius=0.013)
    polygon = np.stack([b, p, a], axis=1).reshape(-1, 3)
    for start, end in zip(polygon, np.roll(polygon, -1, axis=0), strict=True):
        add_arc(plotter, start, end, CROSS)

    corners = (("b", RESULT, 0.024), ("P", VECTOR, 0.036), ("a", RESULT, 0.024))
    for i, (point, place) in enumerate(zip(polygon, beside(polygon), strict=True)):
        letter, color, radius = corners[i % 3]
        add_point(plotter, point, color, radius)
        add_label(plotter, place, f"${letter}_{i // 3}$", color)
    describe(
        plotter,
        f"A see-through sphere with a smooth closed green curve through {len(p)} blue points P."
        " Each point has two small green control points beside it, b before it and a after it."
        " Thin purple arcs join all of them in the order P0, a0, b1, P1, a1 and so on. They follow"
        " the curve and touch it at the points P.",
    )
    return plotter


def beside(polygon: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return a place beside each corner of a closed polygon on the sphere, for its label.

    It is on the outer side of the corner. Where the polygon has no corner, as at P_i, it is on the
    side away from the middle of all.
    """
    before, after = np.roll(polygon, 1, axis=0), np.roll(polygon, -1, axis=0)
    outwards = 0.35 * (polygon - polygon.mean(axis=0)) + polygon - (before + after) / 2
    sideways = np.cross(polygon, after - before)
    sideways *= np.where(np.sum(sideways * outwards, axis=1, keepdims=True) < 0, -1, 1)
    sideways /= np.linalg.norm(sideways, axis=1, keepdims=True)
    places: NDArray[np.float64] = 1.1 * polygon + 0.16 * sideways
    return places


MOST = 8
"""Number of points that `closed_curve_by_hand` can show."""
# With more points than this, the names of control points have no room.
NAMED = 5
STEP = 3e-4
# Of a row of points, all but the last and all but the first: the ends of the arcs between them.
PIECES = (slice(None, -1), slice(1, None))


def motion(
    control: NDArray[np.float64], u: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return velocity and geodesic curvature of Bezier curves on the sphere, by differences.

    Parameters
    ----------
    control : ndarray, shape (..., 4, 3)
        Control points, unit vectors.
    u : array_like, shape (...)
        Parameters.

    Returns
    -------
    velocity : ndarray, shape (..., 3)
        Radians for a step of 1 in u.
    curvature : ndarray, shape (...)
        Radians turned for each radian travelled: positive to the left, 0 on a great circle, 0 where
        the curve stands still.
    """
    before, here, after = (de_casteljau(control, np.add(u, x)) for x in (-STEP, 0, STEP))
    velocity = (after - before) / (2 * STEP)
    acceleration = (after - 2 * here + before) / STEP**2
    sideways = np.sum(np.cross(here, velocity) * acceleration, axis=-1)
    return velocity, sideways / np.maximum(np.linalg.norm(velocity, axis=-1), STEP) ** 3


# Four points evenly spread over a great circle, and those of Figure 8 with two of them near.
RING = rotate((0.86, 0, -0.51), (0.51, 0, 0.86), np.arange(4) * np.pi / 2).round(3).tolist()
NEAR = (FIGURE_8[0], (0.608, 0.769, 0.197), *FIGURE_8[2:])


@explorable(
    model="closedCurve",
    tries={
        "where the curvature jumps most": {"u": 0.75},
        "two points close together": {"points": NEAR, "u": 0.32},
        "points on a great circle": {"points": RING},
        "the same, a third of the way": {"points": RING, "fraction": 1 / 3},
    },
    points=Handles([f"P{k}" for k in range(MOST)], least=3, most=MOST),
    u=Slider(0, 1, "once round, u", plays=10),
    fraction=Slider(0.2, 0.5, "how far aᵢ goes", step=0.005),
)
def closed_curve_by_hand(
    points: ArrayLike = FIGURE_8, u: float = 0.34, fraction: float = 1 / 2
) -> pyvista.Plotter:
    """Draw Fig. 8 with de Casteljau's construction of one point, speed and curvature.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        From 3 to 8 points P_0 ... P_{n-1}; they are normalised.
    u : float
        Place on the whole curve, from 0 to 1. Each segment takes the same share.
    fraction : float
        How far ``a_i`` goes from ``P_i`` towards the midpoint. The paper takes 1/2.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    p = normalised(points)
    n = len(p)
    a, b = control_points(p, fraction)
    control = np.stack([p, a, np.roll(b, -1, axis=0), np.roll(p, -1, axis=0)], axis=1)
    segment = min(int(u * n), n - 1)
    within = u * n - segment
    levels = de_casteljau_levels(control[segment], within)
    t = np.linspace(0, 1, 25)

    plotter = sphere_scene(eye=(4.28, 2.42, 2.51))
    curve = closed_curve(p, 40, fraction)
    add_line(plotter, [*curve, curve[0]], RESULT, radius=0.015, name="curve")
    place_grip(plotter, "u", path=[*curve, curve[0]])
    polygon = np.stack([b, p, a], axis=1).reshape(-1, 3)
    add_arcs(plotter, [*b, *p], [*p, *a], CROSS, "handles", radius=0.013)
    add_arcs(plotter, a, control[:, 2], CROSS, "polygon")
    starts, ends = (np.concatenate([level[cut] for level in levels[1:3]]) for cut in PIECES)
    add_arcs(plotter, starts, ends, NEUTRAL, name="levels")
    for j, level in enumerate(levels[1:3], start=1):
        for k, point in enumerate(level):
            add_point(plotter, point, NEUTRAL, 0.018, name=f"Q {j} {j + k}")
    add_point(plotter, levels[3][0], RESULT, 0.034, name="C")

    places = beside(polygon)
    corners = (("b", RESULT, 0.022), ("P", VECTOR, 0.036), ("a", RESULT, 0.022))
    for i in range(3 * MOST):
        letter, color, radius = corners[i % 3]
        used = i < 3 * n
        point = polygon[i] if used else ORIGIN
        name = f"{letter}_{i // 3}"
        add_point(plotter, point, color, radius, name=name).visibility = used
        named = used and (letter == "P" or n <= NAMED)
        add_label(plotter, places[i] if named else None, f"${name}$", color, name=name)

    velocity, curvature = motion(control[:, np.newaxis], t)
    speed = np.degrees(np.linalg.norm(velocity, axis=-1))
    arriving, leaving = np.roll(velocity[:, -1], 1, axis=0), velocity[:, 0]
    velocity_here, curvature_here = motion(control[segment], within)
    jump = np.degrees(np.linalg.norm(leaving - arriving, axis=-1)).max()
    jumps = abs(curvature[:, 0] - np.roll(curvature[:, -1], 1))
    nearest = int(n * u + 1 / 2) % n
    speed_here = np.degrees(np.linalg.norm(velocity_here))
    for where, name, value, text, digits, unit in (
        ("picture", "velocity_jump", jump, "velocity jumps by", 1, "°/s"),
        ("picture", "curvature_jump", jumps[nearest], "curvature, at the nearest P, by", 2, ""),
        ("picture", "speed_range", [speed.min(), speed.max()], "speed from, to", 0, "°/s"),
        ("folded", "speed", speed_here, "speed here", 0, "°/s"),
        ("folded", "curvature", curvature_here, "curvature here (great circle: 0)", 2, ""),
        ("folded", "curvature_jumps", jumps, "jumps of curvature at P₀, P₁, …", 2, ""),
    ):
        read_out(plotter, name, value, text, digits, unit, where=where)
    for name, values, top, text in (
        ("speeds", speed, (0.0, 150.0), "speed, degrees a second"),
        (
            "curvatures",
            curvature,
            (-6.0, 6.0),
            "curvature, positive to the left (beyond ±6 not shown)",
        ),
    ):
        draw_chart(
            plotter,
            name,
            {"curve": values},
            over="u",
            x=(0, 1),
            y=top,
            label=text,
            colors={"curve": RESULT, "marks": VECTOR},
            marks=[f"P{chr(ord('₀') + k)}" for k in range(MOST)],
        )
    describe(
        plotter,
        f"A see-through sphere with a closed green curve through {n} blue points P that can be"
        " dragged. Purple arcs join them and their control points, a and b. Grey arcs and points"
        " show how one point of the curve is found from four control points.",
    )
    return plotter


def add_arcs(
    plotter: pyvista.Plotter,
    starts: ArrayLike,
    ends: ArrayLike,
    color: str,
    name: str,
    radius: float = 0.006,
) -> None:
    """Add arcs of the unit sphere from each of some points to another, as one part."""
    t = np.linspace(0, 1, 13)
    pairs = zip(np.asarray(starts), np.asarray(ends), strict=True)
    add_lines(plotter, [slerp(p, q, t) for p, q in pairs], color, radius, name)


# Far apart, so that the arcs of the different levels are easy to distinguish.
ARCS = ((1.0, 0.0, -0.2), (0.6, -0.2, 0.7), (0.1, 0.6, 0.8), (0.4, 0.9, -0.2))


# Names this close together would cover each other.
CROWDED = 0.19


@explorable(
    model="arcsOfArcs",
    tries={
        "close to the start": {"u": 0.05},
        "even closer": {"u": 0.01},
        "half of every arc": {"u": 0.5},
    },
    control=Handles([f"Q0,{k}" for k in range(4)]),
    u=Slider(0, 1, "u", plays=8),
)
def arcs_of_arcs(control: ArrayLike = ARCS, u: float = 0.4) -> pyvista.Plotter:
    """Draw de Casteljau's construction on the sphere: the arcs of all levels for one u.

    Parameters
    ----------
    control : array_like, shape (4, 3)
        Control points; they are normalised.
    u : float
        The parameter, from 0 to 1.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    levels = de_casteljau_levels(control, u)
    curve = de_casteljau(control, np.linspace(0, 1, 61))
    plotter = sphere_scene(eye=(4.28, 2.42, 2.51))
    add_line(plotter, curve, RESULT, radius=0.014, name="curve")
    place_grip(plotter, "u", path=curve)
    colors = (VECTOR, CROSS, NEUTRAL, RESULT)
    for j, (level, color) in enumerate(zip(levels, colors, strict=True)):
        if len(level) > 1:
            add_arcs(plotter, level[:-1], level[1:], color, f"level {j}", radius=0.008)
        for k, point in enumerate(level, start=j):
            add_point(plotter, point, color, 0.03 if j else 0.036, name=f"Q {j} {k}")
    for (j, k), place in names_of_levels(levels).items():
        ink = "black" if colors[j] == NEUTRAL else colors[j]
        add_label(plotter, place, f"$Q_{{{j},{k}}}$", ink)
    for j, text in enumerate(("from Q₀,₀ to Q₁,₁", "to Q₂,₂", "to Q₃,₃"), start=1):
        way = np.degrees(angle_between(levels[0][0], levels[j][0]))
        read_out(plotter, f"way_{j}", way, text, 1, "°", where="picture")
    describe(
        plotter,
        f"A see-through sphere with a green curve and the construction of its point for u = {u:g}."
        " Three blue arcs join four blue points, Q00 to Q03. On each blue arc lies a purple point,"
        " Q11 to Q13, and two purple arcs join these. On each purple arc lies a grey point, Q22 and"
        " Q23. The grey arc between these two meets the curve at the green point Q33.",
    )
    return plotter


def names_of_levels(
    levels: list[NDArray[np.float64]],
) -> dict[tuple[int, int], NDArray[np.float64] | None]:
    """Place the names of the points of all levels, and none where there is no room for it."""
    middle = levels[0].mean(axis=0)
    places: dict[tuple[int, int], NDArray[np.float64] | None] = {}
    # Given points and the result come first.
    for j in (0, 3, 2, 1):
        for k, point in enumerate(levels[j], start=j):
            away = point - middle
            away *= (-0.13 if j == 3 else 0.13) / max(float(np.linalg.norm(away)), STEP)
            taken = [other for other in places.values() if other is not None]
            gaps = [np.linalg.norm(point + away - other) for other in taken]
            places[j, k] = point + away if min(gaps, default=1) > CROWDED else None
    return places


LEG = 24
HORIZONS = 6
WIDTH, HEIGHT = 0.21, 0.14
# The view of who rides on the camera.
RIDE = "ride"
ANGLE = 56.0


@explorable(
    model="camera",
    constants={"seen": CAMERA_SEES},
    tries={
        "the corner at the clock": {"u": 0.25},
        "once round along the curve": {"path": "curve", "u": 1.0},
        "who turns it past the window?": {"path": "curve", "roll": "kept upright", "u": 0.54},
    },
    u=Slider(0, 1, "once round, u", plays=12),
    targets=Handles(CAMERA_SEES),
    path=Choice("path", ["arcs", "curve"]),
    roll=Choice("camera", ["kept upright", "carried along"]),
)
def camera_by_hand(
    u: float = 0.9,
    targets: ArrayLike = CAMERA_TARGETS,
    path: str = "arcs",
    roll: str = "carried along",
) -> pyvista.Plotter:
    """Draw a camera that looks from target to target and back to the first, and what it sees.

    Parameters
    ----------
    u : float
        Place on the way round, from 0 to 1.
    targets : array_like, shape (4, 3)
        The directions to door, clock, window and desk; they are normalised.
    path : str
        On ``arcs``, or on the closed ``curve``. Each of the four legs takes a second.
    roll : str
        ``kept upright`` keeps the sides of the picture vertical. ``carried along`` starts upright
        at the door; from there on, nothing turns the camera about its line of sight.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    p = normalised(targets)
    legs = legs_between(p)
    ways = {
        "arcs": de_casteljau(legs["arcs"][:, np.newaxis], np.arange(LEG) / LEG).reshape(-1, 3),
        "curve": closed_curve(p, LEG),
    }
    leg = min(int(len(p) * u), len(p) - 1)
    taken, within = legs[path][leg], len(p) * u - leg
    ahead = de_casteljau(taken, within)
    vertical = up = upright(ahead)
    if roll == "carried along":
        up = carried(upright(p[0]), [*ways[path][: samples_until(u)], ahead])

    plotter = new_scene((5.1, -0.3, 2.3), (0, 0, 0.02), view_angle=26.5, size=(480, 480))
    add_sphere(plotter)
    add_horizon(plotter)
    add_paths(plotter, ways, path)
    add_targets(plotter, p)
    add_camera(plotter, ahead, up, vertical)
    place_grip(plotter, "u", path=[*ways[path], ways[path][0]])
    add_view(
        plotter,
        RIDE,
        eye=ORIGIN,
        target=ahead,
        up=up,
        angle=ANGLE,
        size=(480, 320),
        alt="What the camera sees: the path ahead, the targets, and the horizon, which tilts.",
        without=("camera", "edges", "other arcs", "other curve"),
    )

    velocity = motion(taken, within)[0]
    rolled = np.arctan2(np.cross(vertical, up) @ ahead, vertical @ up)
    spin = spin_of_upright(ahead, velocity) if roll == "kept upright" else 0
    speed = np.linalg.norm(velocity)
    for where, name, value, text, unit in (
        ("picture", "rolled", rolled, "turned against upright", "°"),
        ("picture", "spin", spin, "spin about line of sight", "°/s"),
        ("folded", "speed", speed, "speed", "°/s"),
    ):
        read_out(plotter, name, np.degrees(value), text, 0, unit, where=where)
    show_motion(plotter, legs, path)
    describe(
        plotter,
        "A see-through sphere with a camera at its centre, a horizon and a darker lower half."
        " Purple arcs join four blue points, a door, a clock, a window and a desk, with a corner at"
        " each point. A green curve runs through the same points without a corner. The path that"
        " the camera does not take is thin. An orange frame"
        " on the sphere shows the picture that the camera takes and which side of it is up; a grey"
        " frame shows how an upright camera would hold it.",
    )
    return plotter


Paths = Mapping[str, NDArray[np.float64]]


def legs_between(p: NDArray[np.float64]) -> Paths:
    """Return control points from target to target, for both paths: shapes (n, 2, 3), (n, 4, 3)."""
    after = np.roll(p, -1, axis=0)
    a, b = control_points(p)
    curves = np.stack([p, a, np.roll(b, -1, axis=0), after], axis=1)
    return {"arcs": np.stack([p, after], axis=1), "curve": curves}


def samples_until(u: float) -> int:
    """Return how many samples of the way round lie before a place on it."""
    samples = LEG * len(CAMERA_SEES)
    return min(int(samples * u), samples - 1) + 1


def add_horizon(plotter: pyvista.Plotter) -> None:
    """Add a darker lower half and a horizon, with names for a rider."""
    ground = pyvista.Sphere(start_phi=90, theta_resolution=48, phi_resolution=16)
    ground.points *= JUST_INSIDE / np.linalg.norm(ground.points, axis=1, keepdims=True)
    plotter.add_mesh(ground, color=NEUTRAL, opacity=0.35, smooth_shading=True, pickable=False)
    horizon = turning((1, 0, 0), (0, 0, 1), 2 * np.pi)
    add_line(plotter, horizon, NEUTRAL, radius=0.005, name="horizon")
    for k in range(HORIZONS):
        # Halfway between two meridians.
        azimuth = 2 * np.pi * (k + 3 / 4) / HORIZONS
        place = 0.98 * np.array([np.cos(azimuth), np.sin(azimuth), 0.14])
        add_label(plotter, place, "horizon", name=f"horizon {k}", view=RIDE)
    add_label(plotter, (0.06, 0, 0.98), "straight up", view=RIDE)


def add_paths(plotter: pyvista.Plotter, ways: Paths, path: str) -> None:
    """Add the path that the camera takes, and the other one, thin."""
    for name, color in (("arcs", CROSS), ("curve", RESULT)):
        way = [*ways[name], ways[name][0]]
        add_line(plotter, way, color, 0.014, name=name).visibility = name == path
        other = add_line(plotter, way, color, 0.004, name=f"other {name}")
        other.visibility = name != path


def add_targets(plotter: pyvista.Plotter, p: NDArray[np.float64]) -> None:
    """Add the targets; their names stay clear of the path and of the upper side of the picture."""
    away = p - p.mean(axis=0)
    away -= np.sum(away * p, axis=1, keepdims=True) * p
    away /= np.maximum(np.linalg.norm(away, axis=1, keepdims=True), STEP)
    places = 1.1 * p + 0.15 * (away + np.cross(p, away))
    # Seen from the centre, they are close by.
    for name, target, place, near in zip(CAMERA_SEES, p, places, p + 0.08 * away, strict=True):
        add_point(plotter, target, VECTOR, 0.036, name=name)
        add_label(plotter, place, name, VECTOR)
        add_label(plotter, near, name, VECTOR, f"{name} seen", RIDE)


def add_camera(
    plotter: pyvista.Plotter,
    ahead: NDArray[np.float64],
    up: NDArray[np.float64],
    vertical: NDArray[np.float64],
) -> None:
    """Add a camera and the middle of its picture, upright and as it is."""
    pose = np.eye(4)
    pose[:3, :3] = np.column_stack([ahead, np.cross(up, ahead), up])
    name = place_part(plotter, "camera", matrix=pose.T.ravel())
    body = camera([1, 0, 0])
    level, corners = picture(ahead, vertical), picture(ahead, up)
    level_top, top = (ahead + HEIGHT * side for side in (vertical, up))
    edges = [[ORIGIN, corner] for corner in corners]
    plotter.add_mesh(body, color=NEUTRAL, pickable=False, user_matrix=pose, name=name)
    add_line(plotter, [*level, level[0]], NEUTRAL, 0.008, "upright")
    add_arrow(plotter, level_top, level_top + 0.16 * vertical, NEUTRAL, 0.011, "upright up")
    add_line(plotter, [*corners, corners[0]], AXIS, 0.01, "picture")
    add_lines(plotter, edges, AXIS, 0.004, "edges")
    add_arrow(plotter, top, top + 0.28 * up, AXIS, name="up")
    add_label(plotter, top + 0.36 * up, "up", AXIS)


def show_motion(plotter: pyvista.Plotter, legs: Paths, path: str) -> None:
    """Show the bends of a path, the speed on both, and the spin of an upright camera."""
    t = np.linspace(0, 1, LEG // 2 + 1)
    velocities = {name: motion(control[:, np.newaxis], t)[0] for name, control in legs.items()}
    velocity = velocities[path]
    spins = spin_of_upright(de_casteljau(legs[path][:, np.newaxis], t), velocity)
    bends = zip(CAMERA_SEES, np.degrees(bends_between(velocity)), strict=True)
    told = ", ".join(f"{name} {bend:.0f}°" for name, bend in bends)
    read_out(plotter, "bends", told, "bends", where="folded")
    draw_chart(
        plotter,
        "speeds",
        {name: np.degrees(np.linalg.norm(v, axis=-1)) for name, v in velocities.items()},
        over="u",
        x=(0, 1),
        y=(0, 150),
        label="speed, degrees a second",
        colors={"arcs": CROSS, "curve": RESULT, "marks": VECTOR},
        marks=CAMERA_SEES,
    )
    draw_chart(
        plotter,
        "spins",
        {"spin": np.degrees(spins)},
        over="u",
        x=(0, 1),
        y=(-600, 600),
        label="spin of an upright camera, °/s",
        colors={"spin": AXIS, "marks": VECTOR},
        marks=CAMERA_SEES,
    )


def bends_between(velocity: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the angle by which a closed path bends at the start of each leg, from its velocities.

    Parameters
    ----------
    velocity : ndarray, shape (n, m, 3)
        Velocities along each leg, the first and the last at its ends.

    Returns
    -------
    ndarray, shape (n,)
        Angles in radians; where the path stands still, 0.
    """
    arriving, leaving = np.roll(velocity[:, -1], 1, axis=0), velocity[:, 0]
    across = np.linalg.norm(np.cross(arriving, leaving), axis=1)
    return np.asarray(np.arctan2(across, np.sum(arriving * leaving, axis=1)))


def picture(ahead: NDArray[np.float64], up: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Return the corners of what a camera at the origin sees, where it meets the unit sphere."""
    left = np.cross(up, ahead)
    signs = ((1, 1), (1, -1), (-1, -1), (-1, 1))
    return [ahead + x * WIDTH * left + y * HEIGHT * up for x, y in signs]


def upright(ahead: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the upward direction of the picture of an upright camera."""
    return np.cross(ahead, arc_axis([0, 0, 1], ahead))


def spin_of_upright(
    ahead: NDArray[np.float64], velocity: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return how fast an upright camera turns about its line of sight: by its turn about W."""
    (x, y, z), (dx, dy, _) = np.moveaxis(ahead, -1, 0), np.moveaxis(velocity, -1, 0)
    spin: NDArray[np.float64] = z * (x * dy - y * dx) / np.maximum(x**2 + y**2, STEP**2)
    return spin


def carried(up: NDArray[np.float64], way: ArrayLike) -> NDArray[np.float64]:
    """Carry a direction along a path on the sphere, by the rotation of each short arc.

    Two half turns, about the start and about the middle of an arc, make up its rotation. Unlike an
    axis, they also exist where the path stands still.
    """
    for p, q in pairwise(np.asarray(way)):
        up = double(double(up, p), bisect(p, q))
    return up
