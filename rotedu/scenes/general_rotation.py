"""Scenes of Chapter 4: three rotations, the one that replaces them, and transforms."""

from collections.abc import Sequence

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import describe
from rotedu.general_rotation import (
    axis_angle_from_euler_angles,
    perspective,
    rotation_v,
    scaling,
    shearing,
    translation,
)
from rotedu.ordinary_rotation import rotate, rotation_matrix, transform
from rotedu.scenes.parts import (
    ORIGIN,
    add_arrow,
    add_coordinate_axes,
    add_label,
    add_line,
    add_point,
    add_sphere,
    add_thin,
    new_scene,
    shade,
    teaspoon,
    turning,
)


def two_rows() -> tuple[pyvista.Plotter, NDArray[np.float64]]:
    """Open a scene for two rows of four teaspoons; return it and their places, (2, 4, 3)."""
    back = np.array([0.49, -0.77, 0.42])
    right = np.cross((0, 0, 1), back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    across = np.array([-3.35, -1.2, 0.95, 2.9])
    down = np.array([1.35, -1.4])
    target = 0.03 * right + 0.2 * up
    plotter = new_scene(eye=28.6 * back + target, target=target, view_angle=11.7)
    return plotter, down[:, np.newaxis, np.newaxis] * up + across[:, np.newaxis] * right


def add_turned_spoon(
    plotter: pyvista.Plotter, matrix: ArrayLike, place: ArrayLike, color: object
) -> None:
    """Add a small teaspoon, turned by a matrix and put at a place."""
    spoon = teaspoon(stations=41, around=16)
    spoon.points = transform(matrix, spoon.points) + np.asarray(place)
    plotter.add_mesh(spoon, color=color, smooth_shading=True)


def add_turn(
    plotter: pyvista.Plotter, center: ArrayLike, axis: ArrayLike, angle: float, radius: float = 0.36
) -> None:
    """Add a bent arrow on the side of the eye that shows an angle about an axis."""
    n = np.asarray(axis, float)
    view = np.subtract(plotter.camera.position, center)
    spoke = view - (view @ n) * n
    spoke *= radius / np.linalg.norm(spoke)
    path = np.asarray(center) + rotate(spoke, n, np.linspace(-angle / 2, angle / 2, 25))
    neck = -max(2, round(24 * 0.16 / (radius * abs(angle)))) - 1
    add_line(plotter, path[: neck + 1], NEUTRAL, radius=0.018)
    head = pyvista.Cone(
        center=(path[neck] + path[-1]) / 2,
        direction=path[-1] - path[neck],
        height=float(np.linalg.norm(path[-1] - path[neck])),
        radius=0.065,
        resolution=24,
    )
    add_thin(plotter, head, NEUTRAL)


def add_steps(
    plotter: pyvista.Plotter,
    row: ArrayLike,
    turns: Sequence[tuple[str, ArrayLike, float]],
) -> None:
    """Show a teaspoon being turned step by step, along a row of places.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The scene.
    row : array_like, shape (n + 1, 3)
        Where to show the spoon: before the first turn, and after each turn.
    turns : sequence of (str, array_like, float)
        Name, axis and angle in radians of each turn. The axes are fixed in space.
    """
    start, *after = np.asarray(row, float)
    so_far = np.eye(3)
    add_turned_spoon(plotter, so_far, start, VECTOR)
    for k, (place, (name, direction, angle)) in enumerate(zip(after, turns, strict=True), 1):
        n = np.asarray(direction, float)
        so_far = rotation_matrix(n, angle) @ so_far
        add_turned_spoon(plotter, so_far, place, shade(k / len(turns)))
        add_arrow(plotter, place - 1.05 * n, place + 1.15 * n, AXIS, radius=0.022)
        add_label(plotter, place + 1.4 * n, f"${name}$", AXIS)
        add_turn(plotter, place - 0.7 * n, n, angle)


def principal_orders(
    angles: ArrayLike = (np.pi / 2, np.pi / 2, np.pi / 2),
) -> pyvista.Plotter:
    """Draw the three principal rotations in two orders: U, V, W as in (4-1), and W, V, U.

    Parameters
    ----------
    angles : array_like, shape (3,)
        The angles about U, V and W in radians.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    turns = list(zip("UVW", np.eye(3), np.asarray(angles, float), strict=True))
    plotter, rows = two_rows()
    for row, order in zip(rows, (turns, turns[::-1]), strict=True):
        add_steps(plotter, row, order)
    degrees = np.rad2deg([angle for _, _, angle in turns]).round().astype(int)
    describe(
        plotter,
        f"Two rows of four teaspoons. In the upper row the spoon is turned about U by {degrees[0]}"
        f" degrees, then about V by {degrees[1]}, then about W by {degrees[2]}. In the lower row"
        " the same turns are made in the opposite order. The last spoons of the rows point in"
        " different directions.",
    )
    return plotter


def fixed_and_carried(
    angles: ArrayLike = (5 * np.pi / 12, -np.pi / 4, np.pi / 3),
) -> pyvista.Plotter:
    """Draw two readings of (4-1): about fixed axes, and about axes that the spoon carries along.

    Parameters
    ----------
    angles : array_like, shape (3,)
        The angles about U, V and W in radians.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    turns = list(zip("UVW", np.eye(3), np.asarray(angles, float), strict=True))
    names = ("W", r"V^{\,\prime}", r"U^{\,\prime\prime}")
    carried, so_far = [], np.eye(3)
    for name, (_, axis, angle) in zip(names, turns[::-1], strict=True):
        carried.append((name, so_far @ axis, angle))
        so_far = so_far @ rotation_matrix(axis, angle)
    plotter, rows = two_rows()
    for row, order in zip(rows, (turns, carried), strict=True):
        add_steps(plotter, row, order)
    describe(
        plotter,
        "Two rows of four teaspoons. In the upper row the spoon is turned about the fixed axes U,"
        " V and W. In the lower row it is turned about W, then about its own axis V', which has"
        " moved along, then about its own axis U''. The last spoons of both rows have the same"
        " orientation.",
    )
    return plotter


def one_for_three(
    angles: ArrayLike = (5 * np.pi / 12, np.pi / 3, 11 * np.pi / 18),
    vector: ArrayLike = (0.77, 0.26, 0.59),
) -> pyvista.Plotter:
    """Draw the path of a point under three principal rotations and under the one rotation (4-7).

    Parameters
    ----------
    angles : array_like, shape (3,)
        The angles about U, V and W in radians.
    vector : array_like, shape (3,)
        The vector r; it is normalised.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    theta = np.asarray(angles, float)
    start = here = np.asarray(vector, float) / np.linalg.norm(vector)
    a, angle = axis_angle_from_euler_angles(*theta)

    plotter = new_scene(eye=(5.5, 2.3, 1.7), target=(0.0, 0.1, 0.17))
    add_sphere(plotter)
    add_coordinate_axes(plotter, 1.3)
    for name, axis, part in zip("uvw", np.eye(3), theta, strict=True):
        path = turning(here, axis, part)
        add_line(plotter, path, CROSS, radius=0.012)
        add_label(plotter, 1.13 * path[len(path) // 2], rf"$\theta_{name}$", CROSS)
        here = path[-1]
        add_point(plotter, here, CROSS, radius=0.025)
    add_line(plotter, turning(start, a, float(angle)), RESULT, radius=0.018)
    add_arrow(plotter, ORIGIN, 1.35 * a, AXIS)
    add_label(plotter, 1.45 * a, r"$\hat a$", AXIS)
    for point, name, color in (
        (start, r"$\vec r$", VECTOR),
        (here, r"$\vec r^{\,\prime}$", RESULT),
    ):
        add_arrow(plotter, ORIGIN, point, color)
        add_label(plotter, 1.16 * point, name, color)
    describe(
        plotter,
        "A see-through sphere. Three purple arcs, around the U, the V and the W axis, lead from the"
        " tip of r to the tip of r'. One green arc, part of a circle around the axis a, leads there"
        " directly.",
    )
    return plotter


def gimbals(
    theta_v: ArrayLike = (np.pi / 7, np.pi / 2), theta_w: float = np.deg2rad(-15)
) -> pyvista.Plotter:
    """Draw a teaspoon in two rings, each turning within the next, for several angles about V.

    Parameters
    ----------
    theta_v : array_like, shape (n,)
        The angles about V in radians. At a quarter turn the rings lie in one plane.
    theta_w : float
        The angle about W in radians.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    pitches = np.atleast_1d(np.asarray(theta_v, float))
    right = np.array([0.8, 0.6, 0.0])
    plotter = new_scene(eye=(13.2, -17.6, 7.2), target=(-0.05, -0.04, 0), view_angle=10.8)
    outer, inner = 1.3, 1.08
    across = 3.5 * (np.arange(len(pitches)) - (len(pitches) - 1) / 2)
    for place, pitch in zip(across[:, np.newaxis] * right, pitches, strict=True):
        frame = rotation_matrix((0, 0, 1), theta_w)
        ring = frame @ rotation_matrix((0, 1, 0), pitch)
        w, v, u = np.array([0, 0, 1]), frame[:, 1], ring[:, 0]
        for radius, side, color in ((outer, w, NEUTRAL), (inner, u, CROSS)):
            hoop = pyvista.ParametricTorus(radius, 0.045, u_res=97, v_res=13)
            hoop.points = hoop.points @ np.array([v, side, np.cross(v, side)]) + place
            add_thin(plotter, hoop, color)
        for axis, first, last in ((w, outer, 1.6), (v, inner, outer + 0.25), (u, 0.95, inner)):
            for sign in (1, -1):
                ends = place + sign * np.outer((first, last), axis)
                add_line(plotter, ends, AXIS, radius=0.03)
        add_turned_spoon(plotter, 0.95 * ring, place, RESULT)
        for axis, far, name in (
            (w, 1.8, "W"),
            (v, 1.8, r"V^{\,\prime}"),
            # Outside both rings if it points along W.
            (u, 1.8 if abs(w @ u) > 0.9 else 1.52, r"U^{\,\prime\prime}"),
        ):
            add_label(plotter, place + far * axis, f"${name}$", AXIS)
    describe(
        plotter,
        "A teaspoon spins on an axis in a ring. The ring turns on an axis in a larger ring, which"
        " turns about a vertical axis W. On the left the three axes point in different directions."
        " On the right the inner ring has turned until the axis of the spoon is vertical, too: both"
        " rings lie in one plane.",
    )
    return plotter


def stages(steps: Sequence[ArrayLike] | None = None) -> pyvista.Plotter:
    """Draw a teaspoon going through five transforms, and its perspective picture.

    Parameters
    ----------
    steps : sequence of array_like, shape (4, 4), optional
        Scaling, shear, rotation, translation and perspective, in the order of their
        application.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    if steps is None:
        steps = [
            scaling((0.8, 1.5, 1.5)),
            shearing(uv=0.8),
            rotation_v(np.deg2rad(-50)),
            translation((0, 0, -1)),
            perspective(2.6),
        ]
    eye = np.array([0, 0, -1 / np.asarray(steps[-1], float)[3, 2]])
    back = np.array([0.42, -0.8, 0.43])
    right = np.cross((0, 0, 1), back) / np.linalg.norm(back[:2])
    up = np.cross(back, right)
    plotter = new_scene(eye=26 * back, target=ORIGIN, view_angle=13.6)
    spots = [x * right + y * up for y in (1.75, -1.15) for x in (-3.35, -1.0)]
    spots += [2.6 * right - 0.3 * up] * 2

    spoon = teaspoon(stations=41, around=16)
    box = np.array(spoon.bounds).reshape(3, 2)
    corners = np.stack(np.meshgrid(*box, indexing="ij"), axis=-1).reshape(-1, 3)
    names = ("start", "scale", "shear", "rotate", "translate", "perspective")
    done = np.eye(4)
    for k, (name, step, spot) in enumerate(zip(names, [np.eye(4), *steps], spots, strict=True)):
        done = np.asarray(step) @ done
        flat = (1, 1, name != "perspective")
        moved = spoon.copy()
        moved.points = transform(done, spoon.points) * flat + spot
        plotter.add_mesh(moved, color=shade(k / len(steps)), smooth_shading=True)
        edges = transform(done, corners) * flat + spot
        for i in range(8):
            for j in (i ^ 1, i ^ 2, i ^ 4):
                if i < j:
                    add_line(plotter, edges[[i, j]], NEUTRAL, radius=0.008)
        if name == "translate":
            for corner in edges:
                add_line(plotter, [corner, eye + spot], NEUTRAL, radius=0.004)
        if name == "perspective":
            below = 1.15 * right + 0.62 * up
        else:
            below = (((edges - spot) @ up).min() - 0.3) * up
        add_label(plotter, spot + below, name)
    plane = pyvista.Plane(center=spots[-1], i_size=2.6, j_size=2.6, i_resolution=1, j_resolution=1)
    plotter.add_mesh(plane, color=NEUTRAL, opacity=0.25, lighting=False, pickable=False)
    add_point(plotter, eye + spots[-1], AXIS, radius=0.06)
    add_label(plotter, eye + spots[-1] + 0.3 * right, "eye", AXIS)
    describe(
        plotter,
        "A teaspoon in its box at six stages. The first four: at the start, scaled, sheared and"
        " rotated. Then it lies below a see-through plane, with lines of sight from an eye above"
        " the plane to the corners of the box. Last comes a flat green picture, where these lines"
        " pass through the plane.",
    )
    return plotter
