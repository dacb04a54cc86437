"""The figures of the book in three dimensions: one function each, returning a pyvista scene.

A colour means the same thing in every picture and formula. Blue, orange and green are those
of the colour-blind-safe set of Okabe and Ito, the purple is a darker shade of theirs; all stand
out on white as well as on black, so a scene needs no background of its own. `VECTOR` is what is
turned, `AXIS` what it is turned about, `RESULT` what comes of it, `CROSS` what is perpendicular
to both, `NEUTRAL` everything that only helps to see.

Each scene shows itself: ``figure_1().show()``.
"""

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.book_backend import describe
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
    first, last = (np.array(pyvista.Color(color).float_rgb) for color in (VECTOR, RESULT))
    for t in np.linspace(0, 1, steps):
        turned = spoon.copy()
        turned.points = transform(rotation_matrix(n, t * angle), spoon.points)
        plotter.add_mesh(turned, color=(1 - t) * first + t * last, smooth_shading=True)
    add_arrow(plotter, -0.75 * n, 1.0 * n, AXIS)
    add_label(plotter, 1.1 * n, r"$\hat n$", AXIS)
    describe(
        plotter,
        f"A teaspoon in {steps} positions, fanned out around an axis n, the first blue,"
        " the last green.",
    )
    return plotter


def add_sphere(plotter: pyvista.Plotter, radius: float = 1.0, opacity: float = 0.18) -> None:
    """Add a see-through sphere around the origin; it hides the labels behind it."""
    ball = pyvista.Sphere(radius=radius, theta_resolution=60, phi_resolution=36)
    plotter.add_mesh(ball, color=NEUTRAL, opacity=opacity, smooth_shading=True)


def two_curves(
    points: ArrayLike, right: ArrayLike, wrong: ArrayLike, difference: str
) -> pyvista.Plotter:
    """Draw the right curve through points of the sphere, and one that an error makes of it.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Points of the unit sphere that both curves pass through.
    right, wrong : array_like, shape (m, 3)
        Points of the closed curves, in their order.
    difference : str
        A sentence for those who cannot see it: what the wrong curve does.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    p, right, wrong = (np.asarray(x, float) for x in (points, right, wrong))
    centre = p.mean(axis=0)
    plotter = new_scene(eye=5.2 * centre / np.linalg.norm(centre), target=(0, 0, 0))
    add_sphere(plotter)
    for curve, color, radius in ((right, RESULT, 0.014), (wrong, NEUTRAL, 0.012)):
        add_line(plotter, [*curve, curve[0]], color, radius)
    for i, point in enumerate(p):
        add_point(plotter, point, VECTOR, 0.036)
        away = point - centre
        place = 1.02 * point + 0.14 * away / np.linalg.norm(away)
        add_label(plotter, place, f"$P_{i}$", VECTOR)
    describe(
        plotter,
        f"A see-through sphere with {len(p)} blue points and two closed curves through all of"
        f" them. The green one is smooth and even. {difference}",
    )
    return plotter
