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
from rotedu.interpolation import (
    angle_between,
    arc,
    arc_axis,
    bisect,
    closed_curve,
    de_casteljau,
    double,
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


# The points of figures 3 to 7: 60 degrees apart, then 90, so that no angle that is bisected
# equals the one that its name without the bar stands for.
NEIGHBOURS = ((1.0, 0.0, 0.0), (0.5, 0.75**0.5, 0.0), (0.0, 0.0, 1.0))


def add_sphere(plotter: pyvista.Plotter, radius: float = 1.0, opacity: float = 0.18) -> None:
    """Add a see-through sphere around the origin; it hides the labels behind it."""
    ball = pyvista.Sphere(radius=radius, theta_resolution=60, phi_resolution=36)
    plotter.add_mesh(ball, color=NEUTRAL, opacity=opacity, smooth_shading=True)


def add_arc(
    plotter: pyvista.Plotter, start: ArrayLike, end: ArrayLike, color: str, radius: float = 0.006
) -> None:
    """Add the shortest arc of the unit sphere between two of its points."""
    add_line(plotter, arc(start, end, np.linspace(0, 1, 21)), color, radius)


def add_angle(
    plotter: pyvista.Plotter,
    start: ArrayLike,
    end: ArrayLike,
    text: str,
    size: float = 0.45,
    place: float = 0.64,
) -> None:
    """Mark and name the angle at the origin between two directions."""
    rim = size * arc(start, end, np.linspace(0, 1, 25))
    plotter.add_mesh(fan(ORIGIN, rim), color=NEUTRAL, opacity=0.35, lighting=False, pickable=False)
    for direction in (start, end):
        add_line(plotter, [ORIGIN, np.asarray(direction, float)], NEUTRAL, radius=0.004)
    add_label(plotter, place * rim[len(rim) // 2], text)


def add_right_angle(
    plotter: pyvista.Plotter, first: ArrayLike, second: ArrayLike, size: float = 0.13
) -> None:
    """Mark that two directions at the origin are perpendicular."""
    side, other = size * np.asarray(first, float), size * np.asarray(second, float)
    add_line(plotter, [side, side + other, other], NEUTRAL, radius=0.005)


def add_axis(plotter: pyvista.Plotter, axis: ArrayLike, text: str, length: float = 1.3) -> None:
    """Add the arrow of a rotation axis and its name."""
    axis = np.asarray(axis, float)
    add_arrow(plotter, ORIGIN, length * axis, AXIS)
    add_label(plotter, (length + 0.1) * axis, text, AXIS)


def add_named_point(
    plotter: pyvista.Plotter,
    point: ArrayLike,
    text: str,
    color: str,
    shift: tuple[float, float] = (0.0, 0.12),
) -> None:
    """Add a point and its name, shifted to the right and up as the camera sees it."""
    camera = plotter.camera
    back = np.subtract(camera.position, camera.focal_point)
    right = np.cross((0, 0, 1), back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right) / np.linalg.norm(back)
    place = 1.03 * np.asarray(point, float) + shift[0] * right + shift[1] * up
    add_point(plotter, point, color)
    add_label(plotter, place, text, color)


def figure_2(
    v1: ArrayLike = (0.85, -0.45, -0.2), v2: ArrayLike = (0.15, 0.98, -0.1), t: float = 0.3
) -> pyvista.Plotter:
    """Draw Fig. 2: two unit vectors, the axis perpendicular to both, and the arc between them.

    Parameters
    ----------
    v1, v2 : array_like, shape (3,)
        The ends of the arc; they are normalised.
    t : float
        Part of the way at which a point of the arc is shown.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    first, second = (np.asarray(v, float) / np.linalg.norm(v) for v in (v1, v2))
    n, point = arc_axis(first, second), arc(first, second, t)
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
        " centre to its surface, a third, the axis v, stands at right angles to both. An arc of the"
        f" great circle joins v1 and v2; a point v(t) on it has gone {t:.0%} of the way.",
    )
    return plotter


def neighbours(points: ArrayLike) -> dict[str, NDArray[np.float64]]:
    """Construct the control points of a point and its two neighbours, by name.

    Parameters
    ----------
    points : array_like, shape (3, 3)
        P_{i-1}, P_i and P_{i+1}; they are normalised.

    Returns
    -------
    dict
        The three points, the two auxiliary points and the two control points; the names are the
        labels of figures 3 to 7.
    """
    before, here, after = np.asarray(points, float) / np.linalg.norm(points, axis=1, keepdims=True)
    reflected = double(before, here)
    middle = bisect(reflected, after)
    a = bisect(here, middle)
    found = (before, here, after, reflected, middle, a, double(a, here))
    return dict(zip(NAMES, found, strict=True))


BEFORE, HERE, AFTER = "$P_{i-1}$", "$P_i$", "$P_{i+1}$"
REFLECTED, MIDDLE = r"$\bar P_{i-1}$", r"$\bar P_i$"
A, B = "$a_i$", "$b_i$"
NAMES = (BEFORE, HERE, AFTER, REFLECTED, MIDDLE, A, B)
# The plane of P_i, a_i and b_i would be seen edge on from where the others are drawn.
SIDE = (-1.35, 5.5, 0.9)
COLORS = dict(zip(NAMES, (VECTOR, VECTOR, VECTOR, CROSS, CROSS, RESULT, RESULT), strict=True))


def open_neighbours(
    points: ArrayLike,
    shown: dict[str, tuple[float, float]],
    eye: ArrayLike = (1.5, 4.75, 2.9),
    target: ArrayLike = (0, 0, 0.06),
) -> tuple[pyvista.Plotter, dict[str, NDArray[np.float64]]]:
    """Open a scene of the construction with some of its points, their names shifted."""
    found = neighbours(points)
    plotter = new_scene(eye, target)
    add_sphere(plotter)
    for name, shift in shown.items():
        add_named_point(plotter, found[name], name, COLORS[name], shift)
    return plotter, found


def figure_3(points: ArrayLike = NEIGHBOURS) -> pyvista.Plotter:
    """Draw Fig. 3: from three points to the two control points of the middle one.

    Parameters
    ----------
    points : array_like, shape (3, 3)
        P_{i-1}, P_i and P_{i+1}; they are normalised.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    shifts = (
        (-0.13, 0.05),
        (0.0, -0.13),
        (0, 0.13),
        (0.15, 0.02),
        (0.12, 0.06),
        (0.13, 0),
        (0, -0.13),
    )
    plotter, p = open_neighbours(points, dict(zip(NAMES, shifts, strict=True)))
    for start, end in ((BEFORE, HERE), (HERE, AFTER)):
        add_arc(plotter, p[start], p[end], VECTOR)
    for start, end in ((HERE, REFLECTED), (REFLECTED, AFTER), (A, MIDDLE)):
        add_arc(plotter, p[start], p[end], CROSS)
    for start, end in ((B, HERE), (HERE, A)):
        add_arc(plotter, p[start], p[end], RESULT, radius=0.014)
    describe(
        plotter,
        "A unit sphere with three given points P_{i-1}, P_i and P_{i+1}. The arc from P_{i-1} to"
        " P_i goes on, as long again, to an auxiliary point. Midway from there to P_{i+1} lies a"
        " second one, and midway from P_i to that the control point a_i. The arc from a_i to P_i"
        " goes on, as long again, to the control point b_i.",
    )
    return plotter


def figure_4(points: ArrayLike = NEIGHBOURS) -> pyvista.Plotter:
    """Draw Fig. 4: the axis of (5-6), and the arc doubled by (5-4) or (5-5).

    Parameters
    ----------
    points : array_like, shape (3, 3)
        P_{i-1}, P_i and P_{i+1}; they are normalised.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    plotter, p = open_neighbours(
        points,
        {BEFORE: (-0.13, 0.05), HERE: (0, -0.13), REFLECTED: (0.15, 0.02)},
        target=(0, 0, 0.23),
    )
    for start, end in ((BEFORE, HERE), (HERE, REFLECTED)):
        add_arc(plotter, p[start], p[end], CROSS, radius=0.012)
        add_angle(plotter, p[start], p[end], r"$\theta_{i-1}$", place=1.22)
    add_axis(plotter, arc_axis(p[BEFORE], p[HERE]), r"$\hat v_{i-1}$")
    describe(
        plotter,
        "A unit sphere. An arc from P_{i-1} to P_i goes on, as long again, to P_{i-1} with a bar."
        " Both halves span the same angle theta_{i-1} at the centre. An axis stands at right angles"
        " to the plane of the arc.",
    )
    return plotter


def figure_5(points: ArrayLike = NEIGHBOURS) -> pyvista.Plotter:
    """Draw Fig. 5: the axis of (5-9), corrected, and the arc bisected by (5-7) or (5-8).

    Parameters
    ----------
    points : array_like, shape (3, 3)
        P_{i-1}, P_i and P_{i+1}; they are normalised.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    plotter, p = open_neighbours(
        points, {AFTER: (0, 0.13), REFLECTED: (0.15, 0.02), MIDDLE: (0.12, 0.06)}
    )
    add_arc(plotter, p[REFLECTED], p[AFTER], CROSS, radius=0.012)
    add_angle(plotter, p[REFLECTED], p[AFTER], r"$\bar\theta_{i-1}$")
    add_axis(plotter, arc_axis(p[REFLECTED], p[AFTER]), r"$\hat{\bar v}_{i-1}$")
    describe(
        plotter,
        "A unit sphere. An arc leads from P_{i-1} with a bar up to P_{i+1}; its midpoint is P_i"
        " with a bar. The angle of the arc at the centre is theta_{i-1} with a bar. An axis stands"
        " at right angles to its plane.",
    )
    return plotter


def figure_6(points: ArrayLike = NEIGHBOURS) -> pyvista.Plotter:
    """Draw Fig. 6: the axis of (5-12), and the arc bisected by (5-10) or (5-11).

    Parameters
    ----------
    points : array_like, shape (3, 3)
        P_{i-1}, P_i and P_{i+1}; they are normalised.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    plotter, p = open_neighbours(
        points,
        {HERE: (-0.12, 0.0), MIDDLE: (0.12, 0.06), A: (-0.08, 0.09)},
        eye=SIDE,
        target=(0.0, 0.0, -0.14),
    )
    add_arc(plotter, p[MIDDLE], p[HERE], RESULT, radius=0.012)
    add_angle(plotter, p[MIDDLE], p[HERE], r"$\bar\theta_i$")
    add_axis(plotter, arc_axis(p[MIDDLE], p[HERE]), r"$\hat{\bar v}_i$")
    describe(
        plotter,
        "A unit sphere. An arc leads from P_i with a bar to P_i; its midpoint is the control point"
        " a_i. The angle of the arc at the centre is theta_i with a bar. An axis stands at right"
        " angles to its plane.",
    )
    return plotter


def figure_7(points: ArrayLike = NEIGHBOURS) -> pyvista.Plotter:
    """Draw Fig. 7: the axis of (5-15), and the arc doubled by (5-13) or (5-14).

    Parameters
    ----------
    points : array_like, shape (3, 3)
        P_{i-1}, P_i and P_{i+1}; they are normalised.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    plotter, p = open_neighbours(
        points,
        {HERE: (-0.12, 0.0), A: (0.1, 0.08), B: (-0.06, -0.12)},
        eye=SIDE,
        target=(0.0, 0.0, -0.14),
    )
    for start, end in ((A, HERE), (HERE, B)):
        add_arc(plotter, p[start], p[end], RESULT, radius=0.012)
        add_angle(plotter, p[start], p[end], r"$\tilde\theta_i$", place=1.22)
    add_axis(plotter, arc_axis(p[A], p[HERE]), r"$\hat{\tilde v}_i$")
    describe(
        plotter,
        "A unit sphere. An arc from a_i to P_i goes on, as long again, to b_i. Both halves span the"
        " same angle theta_i with a tilde at the centre. An axis stands at right angles to their"
        " plane.",
    )
    return plotter


# Four points with four different gaps, all of them seen from one side.
LOOP = ((1.0, -0.45, 0.0), (0.7, 0.6, -0.35), (0.1, 0.8, 0.5), (0.6, -0.05, 0.95))


def astray(points: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Compute all a_i and b_i of unit vectors with the axis of (5-9) as printed."""
    reflected = double(np.roll(points, 1, axis=0), points)
    # About the reversed axis, half of the angle leads away from the next point.
    a = bisect(points, arc(reflected, np.roll(points, -1, axis=0), -0.5))
    return a, double(a, points)


def reversed_axis(points: ArrayLike = LOOP, samples: int = 24) -> pyvista.Plotter:
    """Draw what the axis of (5-9) as printed does to a closed curve.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        The points P_0 ... P_{n-1}; they are normalised.
    samples : int
        Points drawn for each segment.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    p = np.asarray(points, float) / np.linalg.norm(points, axis=1, keepdims=True)
    a, b = astray(p)
    after = np.roll(p, -1, axis=0)
    control = np.stack([p, a, np.roll(b, -1, axis=0), after], axis=1)
    printed = de_casteljau(control[:, np.newaxis], np.arange(samples) / samples)

    plotter = new_scene(eye=(4.75, 2.3, 2.05), target=(0.35, 0.16, 0.1))
    add_sphere(plotter)
    for curve, color in ((closed_curve(p, samples), RESULT), (printed, CROSS)):
        closed = curve.reshape(-1, 3)
        add_line(plotter, [*closed, closed[0]], color, radius=0.01)
    outward = p - p.mean(axis=0)
    for k, (point, direction) in enumerate(zip(p, outward, strict=True)):
        add_point(plotter, point, VECTOR)
        place = point + 0.17 * direction / np.linalg.norm(direction)
        add_label(plotter, place, f"$P_{k}$", VECTOR)
    describe(
        plotter,
        f"A unit sphere with {len(p)} points and two closed curves through all of them. Both look"
        " smooth. The purple one leaves the points in other directions and makes detours.",
    )
    return plotter
