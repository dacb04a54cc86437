"""Scenes of Chapter 5, orientations: an arrow and a teaspoon carried along a curve."""

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.closed_curve import closed_curve
from rotedu.colors import CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.control_points import control_points
from rotedu.figures import describe
from rotedu.ordinary_rotation import rotation_matrix, transform
from rotedu.orientations import closed_rotation_curve
from rotedu.scenes.parts import (
    ORIGIN,
    add_arc,
    add_arrow,
    add_label,
    add_line,
    add_sphere,
    fan,
    new_scene,
    teaspoon,
    turning,
)


def carried_around(steps: int = 3, size: float = 0.33) -> pyvista.Plotter:
    """Draw an arrow carried around the octant by the rotations of the arcs (5-3).

    Parameters
    ----------
    steps : int
        Arrows on each of the three arcs.
    size : float
        Their length.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    plotter = new_scene(eye=(4.2, 2.65, 3.05), target=ORIGIN)
    add_sphere(plotter)
    carried = np.eye(3)
    for start, end in zip(np.eye(3), np.roll(np.eye(3), -1, axis=0), strict=True):
        add_arc(plotter, start, end, NEUTRAL, radius=0.009)
        axis = np.cross(start, end)
        for t in np.arange(steps) / steps:
            at, ahead, _ = (rotation_matrix(axis, t * np.pi / 2) @ carried).T
            first = t == 0 and start[0] == 1
            add_arrow(plotter, at, at + size * ahead, VECTOR if first else NEUTRAL, radius=0.013)
        carried = rotation_matrix(axis, np.pi / 2) @ carried
    at, ahead, _ = carried.T
    add_arrow(plotter, at, at + size * ahead, RESULT, radius=0.013)
    sector = at + turning(0.7 * size * np.eye(3)[1], at, np.pi / 2)
    plotter.add_mesh(fan(at, sector), color=NEUTRAL, opacity=0.35, lighting=False, pickable=False)
    add_label(plotter, at + np.array([0, 0.16, 0.14]), r"$90^\circ$")
    for name, place in zip("123", ((1, -0.1, -0.08), (0, 1, -0.13), (0, -0.04, 1.12)), strict=True):
        add_label(plotter, place, f"$e_{name}$")
    describe(
        plotter,
        "A see-through sphere with a triangle of three quarter circles from e1 to e2, to e3 and"
        " back to e1. A blue arrow at e1 points to e2. Grey arrows show it on its way: along the"
        " first side, standing off the second side to the outside, along the third. The"
        " green arrow that arrives at e1 points to e3, at 90 degrees to the blue one.",
    )
    return plotter


def carried_mesh(
    rotations: ArrayLike | None = None,
    between: int = 3,
    mesh: pyvista.PolyData | None = None,
) -> pyvista.Plotter:
    """Draw a mesh carried along a closed curve of orientations.

    Parameters
    ----------
    rotations : array_like, shape (n, 3, 3), optional
        The orientations given, at least 3.
    between : int
        How many interpolated ones to draw between two of them.
    mesh : pyvista.PolyData, optional
        The mesh, centred at the origin; a `teaspoon` if none is given. It stands at the point
        (0, 0, 1), and turns with it about the origin.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    r = np.asarray(four_orientations() if rotations is None else rotations, float)
    model = teaspoon(stations=27, around=10) if mesh is None else mesh.copy()
    model.points = 0.3 * model.points + np.array([0, 0, 1], model.points.dtype)

    plotter = new_scene(eye=(4.28, 2.42, 2.51), target=(0, 0, 0))
    add_sphere(plotter)
    for k, turn in enumerate(closed_rotation_curve(r, between + 1)):
        turned = model.copy()
        turned.points = transform(turn, model.points)
        color = RESULT if k % (between + 1) else VECTOR
        plotter.add_mesh(turned, color=color, smooth_shading=True)
    for path, color in (
        (closed_rotation_curve(r, 30)[:, :, 2], RESULT),
        (closed_curve(r[:, :, 2], 30), CROSS),
    ):
        add_line(plotter, [*path, path[0]], color, radius=0.007)
    for k, place in enumerate(r[:, :, 2]):
        add_label(plotter, 1.33 * place, f"$R_{k}$", VECTOR)
    describe(
        plotter,
        f"Teaspoons on a see-through sphere: {len(r)} blue ones, and {between} green ones between"
        " each two, which turn gradually from one to the next. A green line joins the centres of"
        " all. A purple line through the centres of the blue ones runs elsewhere in between.",
    )
    return plotter


def four_orientations() -> NDArray[np.float64]:
    """Make the orientations of `carried_mesh`, shape (4, 3, 3)."""
    p = np.array(((1.0, -0.1, 0.2), (0.8, 0.6, -0.2), (0.3, 0.8, 0.5), (0.4, 0.2, 0.9)))
    p /= np.linalg.norm(p, axis=1, keepdims=True)
    side = np.cross(p, control_points(p)[0])
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    frames = np.stack([np.cross(side, p), side, p], axis=-1)
    return frames @ rotation_matrix([0, 0, 1], np.radians([0, 90, 30, -60]))
