"""The figures of the book in three dimensions: one function each, returning a pyvista scene.

A colour means the same thing in every picture and formula. Blue, orange and green are those
of the colour-blind-safe set of Okabe and Ito, the purple is a darker shade of theirs; all stand
out on white as well as on black, so a scene needs no background of its own. `VECTOR` is what is
turned, `AXIS` what it is turned about, `RESULT` what comes of it, `CROSS` what is perpendicular
to both, `NEUTRAL` everything that only helps to see.

Each scene shows itself: ``figure_1().show()``.
"""

from collections.abc import Sequence

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.book_backend import describe
from rotedu.general_rotation import (
    perspective,
    rotation_v,
    scaling,
    shearing,
    single_rotation,
    translation,
)
from rotedu.ordinary_rotation import rotate, rotation_matrix, transform

VECTOR = "#0072b2"
AXIS = "#d55e00"
RESULT = "#009e73"
CROSS = "#b65f92"
NEUTRAL = "#7d858d"

SIZE = (720, 480)
ORIGIN = np.zeros(3)


def new_scene(eye: ArrayLike, target: ArrayLike, view_angle: float = 24.0) -> pyvista.Plotter:
    """Open an empty scene, the W axis pointing up.

    Parameters
    ----------
    eye, target : array_like, shape (3,)
        Where the camera stands and what it looks at.
    view_angle : float
        Height of the field of view in degrees.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    plotter = pyvista.Plotter(window_size=list(SIZE))
    plotter.enable_anti_aliasing("ssaa")
    plotter.camera_position = (tuple(np.asarray(eye)), tuple(np.asarray(target)), (0, 0, 1))
    plotter.camera.view_angle = view_angle
    return plotter


def add_line(
    plotter: pyvista.Plotter, points: ArrayLike, color: str, radius: float = 0.008
) -> None:
    """Add a round line through points, shape (n, 3)."""
    line = pyvista.lines_from_points(np.asarray(points, float))
    add_thin(plotter, line.tube(radius=radius, n_sides=12), color)


def add_arrow(
    plotter: pyvista.Plotter, start: ArrayLike, end: ArrayLike, color: str, radius: float = 0.016
) -> None:
    """Add an arrow; its head has the same size whatever its length."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    length = float(np.linalg.norm(end - start))
    arrow = pyvista.Arrow(
        start=tuple(start),
        direction=tuple(end - start),
        scale=length,
        shaft_radius=radius / length,
        tip_radius=3 * radius / length,
        tip_length=min(9 * radius / length, 0.8),
        tip_resolution=24,
        shaft_resolution=16,
    )
    add_thin(plotter, arrow, color)


def add_point(plotter: pyvista.Plotter, point: ArrayLike, color: str, radius: float = 0.03) -> None:
    """Add a point, drawn as a small ball."""
    ball = pyvista.Sphere(
        radius=radius, center=tuple(np.asarray(point)), theta_resolution=16, phi_resolution=12
    )
    add_thin(plotter, ball, color)


def add_thin(plotter: pyvista.Plotter, mesh: pyvista.PolyData, color: str) -> None:
    """Add a part so thin that it must not hide the labels behind it."""
    plotter.add_mesh(mesh, color=color, smooth_shading=True, split_sharp_edges=True, pickable=False)


def add_label(plotter: pyvista.Plotter, point: ArrayLike, text: str, color: str = "black") -> None:
    """Write a text, or a formula between dollar signs, centred at a point."""
    plotter.add_point_labels(
        np.reshape(np.asarray(point, float), (1, 3)),
        [text],
        # pyvista would name it by a memory address, which the next label may get again.
        name=f"label {len(plotter.actors)}",
        text_color=color,
        font_size=20,
        shape=None,
        show_points=False,
        always_visible=True,
        justification_horizontal="center",
        justification_vertical="center",
    )


def add_coordinate_axes(plotter: pyvista.Plotter, length: float) -> None:
    """Add the right-handed axes U, V, W and their origin O."""
    for direction, name in zip(np.eye(3), "UVW", strict=True):
        add_arrow(plotter, ORIGIN, length * direction, NEUTRAL, radius=0.006)
        add_label(plotter, (length + 0.07) * direction, f"${name}$")


def turning(
    point: ArrayLike, axis: ArrayLike, angle: float, steps: int = 48
) -> NDArray[np.float64]:
    """Sample the path of a point that is turned, shape (steps + 1, 3)."""
    return rotate(point, axis, np.linspace(0, angle, steps + 1))


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

    plotter = new_scene(eye=(4.45, 0.8, 2.76), target=(0.1, 0.03, 0.43))
    add_coordinate_axes(plotter, 1.1)
    add_label(plotter, (0, -0.05, -0.09), "$O$")

    add_line(plotter, turning(r, n, 2 * np.pi, 96), NEUTRAL, radius=0.005)
    sector = center + turning(0.42 * spoke, n, angle)
    plotter.add_mesh(
        fan(center, sector), color=NEUTRAL, opacity=0.35, lighting=False, pickable=False
    )
    for tip in (r, turned):
        add_line(plotter, [center, tip], NEUTRAL, radius=0.004)
    middle = center + rotate(0.27 * spoke, n, angle / 2)
    add_label(plotter, middle, r"$\theta$")

    add_arrow(plotter, ORIGIN, 1.2 * n, AXIS)
    add_arrow(plotter, ORIGIN, r, VECTOR)
    add_arrow(plotter, ORIGIN, turned, RESULT)
    add_label(plotter, 1.29 * n, r"$\hat n$", AXIS)
    add_label(plotter, 1.13 * r, r"$\vec r$", VECTOR)
    add_label(plotter, 1.13 * turned, r"$\vec r^{\,\prime}$", RESULT)

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
        " from the origin to the tip of r': a piece of r, a piece parallel to n, and an arrow"
        " perpendicular to both.",
    )
    return plotter


def fan(center: ArrayLike, rim: ArrayLike) -> pyvista.PolyData:
    """Fill the region between a point, shape (3,), and a rim, shape (n, 3), by triangles."""
    points = np.vstack([center, rim])
    second = np.arange(1, len(points) - 1)
    triangles = np.column_stack([np.zeros_like(second), second, second + 1])
    return triangle_mesh(points, triangles)


def triangle_mesh(points: ArrayLike, triangles: ArrayLike) -> pyvista.PolyData:
    """Make a mesh of points, shape (n, 3), and of triples of their indices, shape (m, 3)."""
    corners = np.asarray(triangles)
    faces = np.insert(corners, 0, 3, axis=1).ravel()
    return pyvista.PolyData(np.asarray(points), faces=faces)


def teaspoon(stations: int = 121, around: int = 40) -> pyvista.PolyData:
    """Model a teaspoon as a closed surface of ``stations * around`` vertices.

    Every cross-section is a flat closed ring: as wide as the outline of the spoon, sunk in
    the middle by the depth of the bowl, as thick as the metal.

    Parameters
    ----------
    stations : int
        Number of cross-sections from the end of the handle to the tip of the bowl.
    around : int
        Vertices in each of them.

    Returns
    -------
    pyvista.PolyData
        A triangle mesh, about 2 units long, along the U axis, the bowl open upwards.
    """
    # Close together at both ends, where the outline turns.
    s = (1 - np.cos(np.linspace(0, np.pi, stations)))[:, np.newaxis] / 2
    bowl = np.clip((s - 0.62) / 0.38, 0, 1)
    ends = np.clip(np.minimum(s / 0.03, (1 - s) / 0.004), 0, 1)
    rounding = np.sqrt(ends * (2 - ends))
    handle = (0.035 + 0.055 * np.exp(-((s / 0.14) ** 2))) * (1 - bowl)
    egg = np.sqrt(bowl * (1 - bowl)) * (0.55 - 0.175 * bowl)
    width = rounding * (handle + egg)
    depth = 0.62 * width * np.sin(np.pi * np.sqrt(bowl))
    lift = 0.16 * np.sin(np.pi * np.clip(s / 0.62, 0, 1)) + 0.05 * (1 - s)

    phi = np.linspace(0, 2 * np.pi, around, endpoint=False)
    u = np.broadcast_to(2 * s - 1, (stations, around))
    v = width * np.cos(phi)
    w = lift - depth * np.sin(phi) ** 2 + 0.022 * rounding * np.sin(phi)
    points = np.stack([u, v, w], axis=-1).reshape(-1, 3)

    ring = np.arange(stations * around).reshape(stations, around)
    after = np.roll(ring, -1, axis=1)
    corners = (
        (ring[:-1], ring[1:], after[1:]),
        (ring[:-1], after[1:], after[:-1]),
    )
    triangles = np.vstack([np.stack(three, axis=-1).reshape(-1, 3) for three in corners])
    return triangle_mesh(points, triangles)


def rotated_mesh(
    mesh: pyvista.PolyData | None = None,
    axis: ArrayLike = (0.2, 0.35, 1.0),
    angle: float = np.deg2rad(110),
) -> pyvista.Plotter:
    """Draw a mesh before and after one matrix has turned all its vertices by (3-2).

    Parameters
    ----------
    mesh : pyvista.PolyData, optional
        The mesh; a `teaspoon` if none is given.
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

    plotter = new_scene(eye=(2.3, -2.8, 2.16), target=(-0.1, -0.02, 0.1))
    plotter.add_mesh(before, color=VECTOR, smooth_shading=True)
    plotter.add_mesh(after, color=RESULT, smooth_shading=True)
    add_arrow(plotter, -0.7 * n, 0.9 * n, AXIS)
    add_label(plotter, n, r"$\hat n$", AXIS)
    far = before.points[np.argmax(np.linalg.norm(np.cross(before.points, n), axis=1))]
    path = turning(far, n, angle)
    add_line(plotter, path, NEUTRAL, radius=0.006)
    add_label(plotter, 1.12 * path[len(path) // 2], r"$\theta$")
    describe(
        plotter,
        f"A mesh of {before.n_points} vertices in blue, and in green the same mesh turned by"
        f" {np.rad2deg(angle):.0f} degrees about an axis n. An arc shows the path of one vertex.",
    )
    return plotter


def turning_spoon(steps: int = 5, angle: float = np.deg2rad(288)) -> pyvista.Plotter:
    """Draw a teaspoon on its way around an axis: the picture of the title page.

    Parameters
    ----------
    steps : int
        Number of spoons, at least 2.
    angle : float
        Angle in radians between the first and the last.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    n = np.array([0.1, 0.3, 1.0]) / np.linalg.norm([0.1, 0.3, 1.0])
    plotter = new_scene(eye=(2.2, -2.82, 2.3), target=(0.02, 0.0, 0.12))
    spoon = teaspoon(stations=61, around=24)
    for t in np.linspace(0, 1, steps):
        turned = spoon.copy()
        turned.points = transform(rotation_matrix(n, t * angle), spoon.points)
        plotter.add_mesh(turned, color=shade(t), smooth_shading=True)
    add_arrow(plotter, -0.75 * n, 1.0 * n, AXIS)
    add_label(plotter, 1.1 * n, r"$\hat n$", AXIS)
    describe(
        plotter,
        f"A teaspoon in {steps} positions, fanned out around an axis n, the first blue,"
        " the last green.",
    )
    return plotter


def add_sphere(plotter: pyvista.Plotter, opacity: float = 0.18) -> None:
    """Add the unit sphere, see-through; it hides the labels behind it."""
    ball = pyvista.Sphere(radius=1.0, theta_resolution=60, phi_resolution=40)
    plotter.add_mesh(ball, color=NEUTRAL, opacity=opacity, smooth_shading=True)


def two_rows() -> tuple[pyvista.Plotter, NDArray[np.float64]]:
    """Open a scene with places for two rows of four teaspoons, shape (2, 4, 3)."""
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
    """Add a small teaspoon, moved by a matrix and put at a place."""
    spoon = teaspoon(stations=41, around=16)
    spoon.points = transform(matrix, spoon.points) + np.asarray(place)
    plotter.add_mesh(spoon, color=color, smooth_shading=True)


def shade(t: float) -> NDArray[np.float64]:
    """Mix a colour on the way from `VECTOR` (0) to `RESULT` (1)."""
    first, last = (np.array(pyvista.Color(color).float_rgb) for color in (VECTOR, RESULT))
    return np.asarray((1 - t) * first + t * last)


def add_turn(
    plotter: pyvista.Plotter, center: ArrayLike, axis: ArrayLike, angle: float, radius: float = 0.36
) -> None:
    """Add a bent arrow that shows an angle about an axis, on the side of the eye."""
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
        Where the spoon is shown: before the first turn and after each.
    turns : sequence of (str, array_like, float)
        Name, axis and angle in radians of each turn. The axes are directions in space.
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
    """Draw (4-1) read in two ways: about fixed axes, and about axes that the spoon carries along.

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
        " moved along, then about its own axis U''. The last spoons of both rows stand alike.",
    )
    return plotter


def one_for_three(
    angles: ArrayLike = (5 * np.pi / 12, np.pi / 3, 11 * np.pi / 18),
    vector: ArrayLike = (0.77, 0.26, 0.59),
) -> pyvista.Plotter:
    """Draw the way of a point under three principal rotations, and the one rotation (4-7).

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
    a, angle = single_rotation(*theta)

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
        " at once.",
    )
    return plotter


def gimbals(
    theta_v: ArrayLike = (np.pi / 7, np.pi / 2), theta_w: float = np.deg2rad(-15)
) -> pyvista.Plotter:
    """Draw a teaspoon in two rings, each turning in the next, for several angles about V.

    Parameters
    ----------
    theta_v : array_like, shape (n,)
        The angles about V in radians; at a quarter turn the rings lie in one plane.
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
            (u, 1.8, r"U^{\,\prime\prime}"),
        ):
            add_label(plotter, place + far * axis, f"${name}$", AXIS)
    describe(
        plotter,
        "A teaspoon spins on an axis in a ring, the ring turns on an axis in a larger ring, and"
        " that turns about a vertical axis W. On the left the three axes point in different"
        " directions. On the right the inner ring is turned until its axis is vertical, too: both"
        " rings lie in one plane.",
    )
    return plotter


def stages(steps: Sequence[ArrayLike] | None = None) -> pyvista.Plotter:
    """Draw a teaspoon going through five transforms, and its perspective picture.

    Parameters
    ----------
    steps : sequence of array_like, shape (4, 4), optional
        Scaling, shear, rotation, translation and perspective, in the
        order in which they are done.

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
        "A teaspoon in its box at six stages: at the start, scaled, sheared and rotated; moved"
        " below a see-through plane, with lines of sight from an eye above the plane to the corners"
        " of the box; and as a flat green picture where these lines pass through the plane.",
    )
    return plotter
