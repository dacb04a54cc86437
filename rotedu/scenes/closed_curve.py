"""Scenes of Chapter 5, closed curve: de Casteljau's arcs, the curve of Figure 8, a camera."""

from itertools import pairwise

import numpy as np
import pyvista
from numpy.typing import ArrayLike

from rotedu.closed_curve import closed_curve, de_casteljau, de_casteljau_levels
from rotedu.colors import CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.control_points import control_points
from rotedu.figures import describe
from rotedu.scenes.arcs import CAMERA_SEES, CAMERA_TARGETS
from rotedu.scenes.parts import (
    ORIGIN,
    add_arc,
    add_label,
    add_line,
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
