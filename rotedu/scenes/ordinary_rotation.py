"""Scenes of Chapter 3: a turned vector and a turned mesh."""

import numpy as np
import pyvista
from numpy.typing import ArrayLike

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import describe
from rotedu.ordinary_rotation import rotate, rotation_matrix, transform
from rotedu.scenes.parts import (
    ORIGIN,
    add_arrow,
    add_coordinate_axes,
    add_label,
    add_line,
    add_point,
    fan,
    new_scene,
    teaspoon,
    turning,
)


def figure_1(
    vector: ArrayLike = (1.0, -0.35, 0.75),
    axis: ArrayLike = (-0.15, 0.1, 1.0),
    angle: float = np.deg2rad(75),
) -> pyvista.Plotter:
    """Draw Fig. 1: a vector turned about an axis, and the three terms of (3-1).

    Parameters
    ----------
    vector : array_like, shape (3,)
        The vector r.
    axis : array_like, shape (3,)
        The rotation axis n; it is normalised.
    angle : float
        The rotation angle in radians.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    r = np.asarray(vector, float)
    n = np.asarray(axis, float) / np.linalg.norm(axis)
    center = (r @ n) * n
    turned = rotate(r, n, angle)
    spoke = r - center

    plotter = new_scene(eye=(4.45, 2.1, 2.35), target=(0.0, 0.05, 0.42))
    add_coordinate_axes(plotter, 1.1)
    add_label(plotter, (0, 0.09, -0.07), "$O$")

    add_line(plotter, turning(r, n, 2 * np.pi, 80), NEUTRAL, radius=0.005)
    sector = center + turning(0.42 * spoke, n, angle)
    plotter.add_mesh(
        fan(center, sector), color=NEUTRAL, opacity=0.5, lighting=False, pickable=False
    )
    for tip in (r, turned):
        add_line(plotter, [center, tip], NEUTRAL, radius=0.004)
    add_point(plotter, center, NEUTRAL, radius=0.022)
    add_label(plotter, center + rotate(0.6 * spoke, n, 0.43 * angle), r"$\theta$")
    add_label(plotter, center - 0.14 * spoke, r"$\vec r_\parallel$")
    add_label(plotter, center + 0.72 * spoke + 0.09 * n, r"$\vec r_\perp$")

    add_arrow(plotter, ORIGIN, 1.2 * n, AXIS)
    add_arrow(plotter, ORIGIN, r, VECTOR)
    add_arrow(plotter, ORIGIN, turned, RESULT)
    add_label(plotter, 1.29 * n, r"$\hat n$", AXIS)
    for tip, name, color in ((r, r"$\vec r$", VECTOR), (turned, r"$\vec r^{\,\prime}$", RESULT)):
        add_label(plotter, tip + 0.2 * (tip - center) - 0.05 * n, name, color)

    first = np.cos(angle) * r
    second = first + (1 - np.cos(angle)) * (r @ n) * n
    add_line(plotter, [ORIGIN, first], VECTOR, radius=0.026)
    add_line(plotter, [first, second], AXIS, radius=0.018)
    add_arrow(plotter, second, turned, CROSS, radius=0.012)
    for corner, color in ((first, VECTOR), (second, AXIS)):
        add_point(plotter, corner, color)

    describe(
        plotter,
        f"A vector r and its copy r', turned by {np.rad2deg(angle):.0f} degrees about the axis n."
        " The tips of both lie on a circle around the axis. A path of three straight pieces leads"
        " from the origin to the tip of r': one piece along r, one parallel to n, and an arrow"
        " perpendicular to both.",
    )
    return plotter


def rotated_mesh(
    mesh: pyvista.PolyData | None = None,
    axis: ArrayLike = (0.2, 0.35, 1.0),
    angle: float = np.deg2rad(110),
) -> pyvista.Plotter:
    """Draw a mesh before and after one matrix has turned all its vertices by (3-2).

    Parameters
    ----------
    mesh : pyvista.PolyData, optional
        The mesh. The default is a `teaspoon`.
    axis : array_like, shape (3,)
        The rotation axis; it is normalised.
    angle : float
        The rotation angle in radians.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    before = teaspoon() if mesh is None else mesh
    after = before.copy()
    after.points = transform(rotation_matrix(axis, angle), before.points)
    n = np.asarray(axis, float) / np.linalg.norm(axis)

    plotter = new_scene(eye=(1.3, -2.8, 3.35), target=(0, 0, 0.1))
    plotter.add_mesh(before, color=VECTOR, smooth_shading=True)
    plotter.add_mesh(after, color=RESULT, smooth_shading=True)
    add_arrow(plotter, -0.7 * n, 0.9 * n, AXIS)
    add_label(plotter, n, r"$\hat n$", AXIS)
    far = before.points[np.argmax(np.linalg.norm(np.cross(before.points, n), axis=1))]
    path = turning(far, n, angle)
    add_line(plotter, path, NEUTRAL, radius=0.006)
    add_label(plotter, 1.06 * path[len(path) // 2], r"$\theta$")
    describe(
        plotter,
        f"A mesh of {before.n_points} vertices in blue, and in green the same mesh turned by"
        f" {np.rad2deg(angle):.0f} degrees about an axis n. An arc shows the path of one vertex.",
    )
    return plotter
