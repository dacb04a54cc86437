"""Scenes of Chapter 5, closed curve: de Casteljau's arcs, the curve of Figure 8, a camera."""

from itertools import pairwise

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import slerp
from rotedu.closed_curve import closed_curve, de_casteljau, de_casteljau_levels
from rotedu.colors import CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.control_points import control_points
from rotedu.figures import Handles, Slider, describe, draw_chart, explorable, read_out
from rotedu.scenes.arcs import CAMERA_SEES, CAMERA_TARGETS
from rotedu.scenes.parts import (
    ORIGIN,
    add_arc,
    add_label,
    add_line,
    add_lines,
    add_point,
    add_sphere,
    new_scene,
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
    p = np.asarray(points, float)
    p = p / np.linalg.norm(p, axis=1, keepdims=True)
    a, b = control_points(p, fraction)
    curve = closed_curve(p, 30, fraction)

    plotter = new_scene(eye=(4.28, 2.42, 2.51), target=(0, 0, 0))
    add_sphere(plotter)
    add_line(plotter, [*curve, curve[0]], RESULT, radius=0.013)
    polygon = np.stack([b, p, a], axis=1).reshape(-1, 3)
    before, after = np.roll(polygon, 1, axis=0), np.roll(polygon, -1, axis=0)
    for start, end in zip(polygon, after, strict=True):
        add_arc(plotter, start, end, CROSS)

    # Labels go on the outer side of the corners; the polygon has no corner at P_i.
    outwards = 0.35 * (polygon - polygon.mean(axis=0)) + polygon - (before + after) / 2
    outwards /= np.linalg.norm(outwards, axis=1, keepdims=True)
    corners = (("b", RESULT, 0.024), ("P", VECTOR, 0.036), ("a", RESULT, 0.024))
    for i, (point, outward) in enumerate(zip(polygon, outwards, strict=True)):
        letter, color, radius = corners[i % 3]
        add_point(plotter, point, color, radius)
        add_label(plotter, point + 0.15 * outward, f"${letter}_{i // 3}$", color)
    describe(
        plotter,
        f"A see-through sphere with a smooth closed green curve through {len(p)} blue points P."
        " Each point has two small green control points beside it, b before it and a after it."
        " Thin purple arcs join all of them in the order P0, a0, b1, P1, a1 and so on. They follow"
        " the curve and touch it at the points P.",
    )
    return plotter


MOST = 8
"""Number of points that `closed_curve_by_hand` can show."""
STEP = 1e-4
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


@explorable(
    model="closedCurve",
    points=Handles([f"P{k}" for k in range(MOST)], least=3, most=MOST),
    u=Slider(0, 1, "once round, u", plays=10),
    fraction=Slider(0.2, 0.5, "fraction of a", step=0.005),
)
def closed_curve_by_hand(
    points: ArrayLike = FIGURE_8, u: float = 0.1, fraction: float = 1 / 2
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
    p = np.asarray(points, float)
    p = p / np.linalg.norm(p, axis=1, keepdims=True)
    n = len(p)
    a, b = control_points(p, fraction)
    control = np.stack([p, a, np.roll(b, -1, axis=0), np.roll(p, -1, axis=0)], axis=1)
    segment = min(int(u * n), n - 1)
    within = u * n - segment
    levels = de_casteljau_levels(control[segment], within)
    t = np.linspace(0, 1, 13)

    plotter = new_scene(eye=(4.28, 2.42, 2.51), target=(0, 0, 0))
    add_sphere(plotter)
    curve = closed_curve(p, 40, fraction)
    add_line(plotter, [*curve, curve[0]], RESULT, radius=0.013, name="curve")
    polygon = np.stack([b, p, a], axis=1).reshape(-1, 3)
    before, after = np.roll(polygon, 1, axis=0), np.roll(polygon, -1, axis=0)
    add_arcs(plotter, polygon, after, CROSS, name="polygon")
    starts, ends = (np.concatenate([level[cut] for level in levels[1:3]]) for cut in PIECES)
    add_arcs(plotter, starts, ends, NEUTRAL, name="levels")
    for j, level in enumerate(levels[1:3], start=1):
        for k, point in enumerate(level):
            add_point(plotter, point, NEUTRAL, 0.018, name=f"Q {j} {j + k}")
    add_point(plotter, levels[3][0], RESULT, 0.034, name="C")

    outwards = 0.35 * (polygon - polygon.mean(axis=0)) + polygon - (before + after) / 2
    outwards /= np.linalg.norm(outwards, axis=1, keepdims=True)
    corners = (("b", RESULT, 0.022), ("P", VECTOR, 0.036), ("a", RESULT, 0.022))
    for i in range(3 * MOST):
        letter, color, radius = corners[i % 3]
        used = i < 3 * n
        point = polygon[i] if used else ORIGIN
        name = f"{letter}_{i // 3}"
        add_point(plotter, point, color, radius, name=name).visibility = used
        place = point + 0.15 * outwards[i] if used else None
        add_label(plotter, place, f"${name}$", color, name=name)

    velocity, curvature = motion(control[:, np.newaxis], t)
    speed = np.degrees(np.linalg.norm(velocity, axis=-1))
    arriving, leaving = np.roll(velocity[:, -1], 1, axis=0), velocity[:, 0]
    velocity_here, curvature_here = motion(control[segment], within)
    read_out(plotter, "speed", np.degrees(np.linalg.norm(velocity_here)), "speed", 1, "°/s")
    read_out(plotter, "curvature", curvature_here, "curvature", 2)
    jump = np.degrees(np.linalg.norm(leaving - arriving, axis=-1)).max()
    read_out(plotter, "velocity_jump", jump, "velocity jumps at the points by at most", 1, "°/s")
    jump = abs(curvature[:, 0] - np.roll(curvature[:, -1], 1)).max()
    read_out(plotter, "curvature_jump", jump, "curvature by up to", 2)
    for name, values, top, text in (
        ("speeds", speed, (0.0, 250.0), "speed, degrees a second"),
        ("curvatures", curvature, (-6.0, 6.0), "curvature: positive to the left"),
    ):
        draw_chart(
            plotter,
            name,
            {"curve": values.ravel()},
            over="u",
            x=(0, 1),
            y=top,
            label=text,
            colors={"curve": RESULT},
        )
    describe(
        plotter,
        f"A see-through sphere with a closed green curve through {n} blue points P that can be"
        " dragged. Purple arcs join them and their control points, a and b. Grey arcs and points"
        " show how one point of the curve is found from four control points.",
    )
    return plotter


def add_arcs(
    plotter: pyvista.Plotter, starts: ArrayLike, ends: ArrayLike, color: str, name: str
) -> None:
    """Add arcs of the unit sphere from each of some points to another, as one part."""
    t = np.linspace(0, 1, 13)
    pairs = zip(np.asarray(starts), np.asarray(ends), strict=True)
    add_lines(plotter, [slerp(p, q, t) for p, q in pairs], color, radius=0.006, name=name)


# Far apart, so that the arcs of the different levels are easy to distinguish.
ARCS = ((1.0, 0.0, -0.2), (0.6, -0.2, 0.7), (0.1, 0.6, 0.8), (0.4, 0.9, -0.2))


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
    plotter = new_scene(eye=(4.28, 2.42, 2.51), target=(0, 0, 0))
    add_sphere(plotter)
    add_line(plotter, de_casteljau(control, np.linspace(0, 1, 41)), RESULT, radius=0.012)
    middle = levels[0].mean(axis=0)
    colors = (VECTOR, CROSS, NEUTRAL, RESULT)
    for j, (level, color) in enumerate(zip(levels, colors, strict=True)):
        for start, end in pairwise(level):
            add_arc(plotter, start, end, color, radius=0.008)
        for k, point in enumerate(level):
            add_point(plotter, point, color, radius=0.035 if color == RESULT else 0.024)
            outwards = (point - middle) / np.linalg.norm(point - middle)
            place = point + (-0.13 if color == RESULT else 0.13) * outwards
            ink = "black" if color == NEUTRAL else color
            add_label(plotter, place, f"$Q_{{{j},{j + k}}}$", ink)
    describe(
        plotter,
        f"A see-through sphere with a green curve and the construction of its point for u = {u:g}."
        " Three blue arcs join four blue points, Q00 to Q03. On each blue arc lies a purple point,"
        " Q11 to Q13, and two purple arcs join these. On each purple arc lies a grey point, Q22 and"
        " Q23. The grey arc between these two meets the curve at the green point Q33.",
    )
    return plotter


def camera_curve(fraction: float = 1 / 2) -> pyvista.Plotter:
    """Draw where a camera looks between four targets: along arcs, and along the curve.

    Parameters
    ----------
    fraction : float
        As for `rotedu.control_points.control_points`.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    targets = np.asarray(CAMERA_TARGETS)
    targets = targets / np.linalg.norm(targets, axis=1, keepdims=True)
    curve = closed_curve(targets, 30, fraction)

    plotter = new_scene(eye=(5.1, -0.3, 2.3), target=(0, 0, 0.02))
    add_sphere(plotter)
    add_point(plotter, ORIGIN, NEUTRAL)
    add_label(plotter, (0, -0.1, 0.13), "camera")
    for start, end in zip(targets, np.roll(targets, -1, axis=0), strict=True):
        add_arc(plotter, start, end, CROSS)
        add_line(plotter, [ORIGIN, start], NEUTRAL, radius=0.003)
    add_line(plotter, [*curve, curve[0]], RESULT, radius=0.014)
    places = ((0, 0, -0.14), (0, 0.16, -0.1), (0, 0, 0.15), (0, -0.16, -0.1))
    for name, target, place in zip(CAMERA_SEES, targets, places, strict=True):
        add_point(plotter, target, VECTOR, 0.036)
        add_label(plotter, target + place, name, VECTOR)
    describe(
        plotter,
        "A see-through sphere with a camera at its centre. Grey lines lead to four blue points on"
        " the sphere: a door, a clock, a window and a desk. Thin purple arcs join them in this"
        " order and back to the door, with a corner at each point. A thick green curve runs"
        " through the same points without a corner and swings out beyond the arcs.",
    )
    return plotter
