"""Scenes of Chapter 5, arcs: a camera and its targets; two points, their arc and its axis."""

from collections.abc import Sequence

import numpy as np
import pyvista
from numpy.typing import ArrayLike

from rotedu.arcs import angle_between, arc_axis, slerp
from rotedu.colors import NEUTRAL, RESULT, VECTOR
from rotedu.figures import describe
from rotedu.scenes.parts import (
    ORIGIN,
    add_angle,
    add_arc,
    add_arrow,
    add_axis,
    add_label,
    add_line,
    add_point,
    add_sphere,
    new_scene,
    turning,
)

CAMERA_TARGETS = ((1.0, 0.0, -0.2), (0.3, 1.0, 0.2), (0.2, 0.3, 1.0), (0.3, -0.9, 0.3))
"""Directions from a camera to a door, a clock, a window and a desk, in this order."""
CAMERA_SEES = ("door", "clock", "window", "desk")


def camera(direction: ArrayLike, size: float = 0.3) -> pyvista.PolyData:
    """Model a camera at the origin: a box whose lens points in a direction that is not vertical."""
    ahead = np.asarray(direction, float) / np.linalg.norm(direction)
    left = arc_axis([0, 0, 1], ahead)
    body = pyvista.Box(bounds=(-0.7, 0.2, -0.35, 0.35, -0.3, 0.3)).triangulate()
    lens = pyvista.Cone(
        center=(0.35, 0, 0), direction=(-1, 0, 0), height=0.7, radius=0.32, resolution=24
    ).triangulate()
    upright = np.eye(4)
    upright[:3, :3] = size * np.column_stack([ahead, left, np.cross(ahead, left)])
    model: pyvista.PolyData = pyvista.merge([body, lens])
    model.transform(upright, inplace=True)
    return model


def camera_arcs(
    targets: ArrayLike = CAMERA_TARGETS, names: Sequence[str] = CAMERA_SEES
) -> pyvista.Plotter:
    """Draw a camera, the directions in which it looks in turn, and the arcs between them.

    Parameters
    ----------
    targets : array_like, shape (n, 3)
        The directions; they are normalised. The path is closed.
    names : sequence of str
        What the camera sees in each direction.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    points = np.asarray(targets, float) / np.linalg.norm(targets, axis=-1, keepdims=True)

    plotter = new_scene(eye=(4.3, -1.9, 3.2), target=(0, 0, 0.06))
    add_sphere(plotter)
    plotter.add_mesh(camera(points[0]), color=NEUTRAL, pickable=False)
    for point, after, name in zip(points, np.roll(points, -1, axis=0), names, strict=True):
        add_line(plotter, [ORIGIN, point], NEUTRAL, radius=0.004)
        add_arc(plotter, point, after, RESULT, radius=0.014)
        tail, tip = slerp(point, after, [0.5, 0.6])
        add_arrow(plotter, tail, tip, RESULT)
        add_point(plotter, point, VECTOR, radius=0.035)
        add_label(plotter, 1.2 * point, name, VECTOR)
    describe(
        plotter,
        "A see-through unit sphere with a camera at its centre. Thin lines lead from the camera to"
        f" {len(points)} points of the sphere: {', '.join(names)}. Arcs of great circles join them"
        " in this order and lead back to the first. At each point the path has a corner.",
    )
    return plotter


def add_right_angle(
    plotter: pyvista.Plotter, first: ArrayLike, second: ArrayLike, size: float = 0.13
) -> None:
    """Mark that two directions at the origin are perpendicular."""
    side, other = size * np.asarray(first, float), size * np.asarray(second, float)
    add_line(plotter, [side, side + other, other], NEUTRAL, radius=0.005)


def figure_2(
    v1: ArrayLike = (0.85, -0.45, -0.2), v2: ArrayLike = (0.15, 0.98, -0.1), t: float = 0.3
) -> pyvista.Plotter:
    """Draw Fig. 2: two unit vectors, the axis perpendicular to both, and the arc between them.

    Parameters
    ----------
    v1, v2 : array_like, shape (3,)
        The ends of the arc; they are normalised.
    t : float
        Fraction of the arc at which to show a point.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    first, second = (np.asarray(v, float) / np.linalg.norm(v) for v in (v1, v2))
    n, point = arc_axis(first, second), slerp(first, second, t)
    angle = float(np.degrees(angle_between(first, second)))

    plotter = new_scene(eye=(4.5, 2.3, 2.9), target=(0, 0, 0.16))
    add_sphere(plotter)
    add_line(plotter, turning(first, n, 2 * np.pi, 96), NEUTRAL, radius=0.004)
    add_angle(plotter, first, second, r"$\theta$", size=0.4)
    add_axis(plotter, n, r"$\hat v$")
    for end, text in ((first, r"$\hat v_1$"), (second, r"$\hat v_2$")):
        add_right_angle(plotter, n, end)
        add_arrow(plotter, ORIGIN, end, VECTOR)
        add_label(plotter, 1.13 * end, text, VECTOR)
    add_arc(plotter, first, second, RESULT, radius=0.014)
    add_line(plotter, [ORIGIN, point], RESULT, radius=0.006)
    add_point(plotter, point, RESULT, radius=0.035)
    add_label(plotter, 1.16 * point, r"$\hat v(t)$", RESULT)
    describe(
        plotter,
        f"A see-through unit sphere. Two arrows v1 and v2, {angle:.0f} degrees apart, lead from its"
        " centre to its surface. A third arrow, the axis v, is perpendicular to both. An arc of a"
        f" great circle joins v1 and v2. A point v(t) lies {t:.0%} of the way along this arc.",
    )
    return plotter
