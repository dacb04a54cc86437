"""The figures of the book in three dimensions: one function each, returning a pyvista scene.

A colour means the same thing in every picture and formula. Blue, orange and green are those
of the colour-blind-safe set of Okabe and Ito, the purple is a darker shade of theirs; all stand
out on white as well as on black, so a scene needs no background of its own. `VECTOR` is what is
turned, `AXIS` what it is turned about, `RESULT` what comes of it, `CROSS` what is perpendicular
to both, `NEUTRAL` everything that only helps to see.

Each scene shows itself: ``figure_1().show()``.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import angle_between, arc_axis, slerp
from rotedu.closed_curve import closed_curve, de_casteljau, de_casteljau_levels
from rotedu.control_points import bisect, control_points, double
from rotedu.figures.backend import describe
from rotedu.general_rotation import (
    axis_angle_from_euler_angles,
    perspective,
    rotation_v,
    scaling,
    shearing,
    translation,
)
from rotedu.ordinary_rotation import rotate, rotation_matrix, transform
from rotedu.orientations import closed_rotation_curve
from rotedu.quaternions import Quaternion

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
    line = pyvista.MultipleLines(np.asarray(points, float))
    add_thin(plotter, line.tube(radius=radius, n_sides=8), color)


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
        tip_resolution=20,
        shaft_resolution=12,
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
    plotter = new_scene(eye=(2.35, -3.02, 2.46), target=(0.02, 0.0, 0.2))
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


def letter_f(size: float = 0.5, thickness: float = 0.07) -> pyvista.PolyData:
    """Model the letter F, which is not its own mirror image, lying in the plane of U and V.

    Parameters
    ----------
    size : float
        Its height, along V.
    thickness : float
        Its extent along W.

    Returns
    -------
    pyvista.PolyData
        A triangle mesh with its middle at the origin.
    """
    bars = [(-0.32, -0.12, -0.5, 0.5), (-0.12, 0.36, 0.3, 0.5), (-0.12, 0.22, -0.1, 0.1)]
    half = thickness / size / 2
    boxes = [pyvista.Box((*bar, -half, half)) for bar in bars]
    solid = pyvista.merge(boxes).extract_surface(algorithm=None).triangulate()
    letter: pyvista.PolyData = solid.scale(size)
    return letter


def two_mirrors(between: float = np.deg2rad(50), at: float = np.deg2rad(-25)) -> pyvista.Plotter:
    """Draw a letter that is mirrored twice: it turns by twice the angle between the mirrors.

    Parameters
    ----------
    between : float
        Angle in radians from the first mirror to the second.
    at : float
        Angle in radians from the first mirror to the letter.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """

    def out(angle: float, radius: float = 1.0, height: float = 0.0) -> NDArray[np.float64]:
        """Go out from the axis in a direction, counted from the first mirror."""
        azimuth = angle + (np.pi - between) / 2
        return np.array([radius * np.cos(azimuth), radius * np.sin(azimuth), height])

    n = np.eye(3)[2]
    plotter = new_scene(eye=(0.35, -2.6, 3.9), target=(0.0, 0.74, 0.05), view_angle=22)
    add_arrow(plotter, -0.15 * n, 0.6 * n, AXIS)
    add_label(plotter, (-0.16, 0, 0.35), r"$\hat n$", AXIS)

    for angle, name in ((0.0, "1"), (between, "2")):
        foot, corner = out(angle, 1.6), out(angle, 1.6, 0.45)
        frame = [ORIGIN, foot, corner, out(angle, 0.0, 0.45)]
        mirror = triangle_mesh(frame, [[0, 1, 2], [0, 2, 3]])
        plotter.add_mesh(mirror, color=NEUTRAL, opacity=0.45, lighting=False, pickable=False)
        add_line(plotter, frame, NEUTRAL, radius=0.006)
        m = rotate(out(angle), n, np.pi / 2)
        add_arrow(plotter, corner, corner + 0.3 * m, CROSS, radius=0.01)
        add_label(plotter, corner + 0.4 * m, rf"$\hat m_{name}$", CROSS)

    upright = letter_f()
    upright.points = rotate(upright.points, n, at - between / 2) + out(at, 1.1)
    mirrored = upright.reflect(rotate(out(0.0), n, np.pi / 2))
    turned = mirrored.reflect(rotate(out(between), n, np.pi / 2))
    for mesh, color in ((upright, VECTOR), (mirrored, CROSS), (turned, RESULT)):
        plotter.add_mesh(mesh, color=color)

    for begin, angle, radius, text in (
        (0.0, between, 0.5, r"$\theta/2$"),
        (at, 2 * between, 1.5, r"$\theta$"),
    ):
        arc = turning(out(begin, radius), n, angle, steps=36)
        add_line(plotter, arc[:-1], NEUTRAL, radius=0.008)
        head = arc[-1] - 0.1 * rotate(out(begin + angle), n, np.pi / 2)
        add_arrow(plotter, head, arc[-1], NEUTRAL, radius=0.01)
        add_label(plotter, out(begin + angle / 2, radius + 0.15), text)
    describe(
        plotter,
        f"Two upright mirrors meet at an axis n, {np.rad2deg(between):.0f} degrees apart. A blue"
        " letter F lies in front of the first. Its mirror image, purple and in mirror writing, lies"
        " between the mirrors. The mirror image of that in the second mirror is green and reads"
        f" as an F again: it is the blue one, turned by {2 * np.rad2deg(between):.0f} degrees.",
    )
    return plotter


def double_cover(angle: float = np.deg2rad(100), width: float = 0.4) -> pyvista.Plotter:
    """Draw the quaternions [w, s n] of all rotations about one axis: a band with one edge.

    At the place on the ring to which a rotation takes the vector r, its two quaternions stand
    w = cos(theta / 2) up and s = sin(theta / 2) out: q on one edge, -q on the other.

    Parameters
    ----------
    angle : float
        Angle in radians of the rotation that is shown.
    width : float
        Half the width of the band, for a ring of radius 1.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """

    def ring(theta: NDArray[np.float64], side: float) -> NDArray[np.float64]:
        """Points of the edges (side 1 and -1) and of the ring between them (side 0)."""
        w, s = side * width * np.cos(theta / 2), side * width * np.sin(theta / 2)
        return np.stack([(1 + s) * np.cos(theta), (1 + s) * np.sin(theta), w], axis=-1)

    n = np.eye(3)[2]
    theta = np.linspace(0, 2 * np.pi, 97)
    q, core, minus_q = (ring(theta, side) for side in (1.0, 0.0, -1.0))

    plotter = new_scene(eye=(3.5, 2.3, 3.3), target=(0.0, 0.06, 0.03))
    band = pyvista.StructuredGrid(*np.moveaxis(np.stack([q, core, minus_q]), -1, 0))
    surface = band.extract_surface(algorithm=None)
    plotter.add_mesh(surface, color=NEUTRAL, opacity=0.5, smooth_shading=True, pickable=False)
    add_line(plotter, core, NEUTRAL, radius=0.006)
    add_line(plotter, q, RESULT, radius=0.018)
    add_line(plotter, minus_q, CROSS, radius=0.018)

    add_arrow(plotter, -0.3 * n, 0.85 * n, AXIS)
    add_label(plotter, 0.96 * n, r"$\hat n$", AXIS)
    here = np.array(angle)
    add_arrow(plotter, ORIGIN, ring(np.array(0.0), 0), VECTOR)
    add_arrow(plotter, ORIGIN, ring(here, 0), RESULT)
    sector = turning((0.3, 0, 0), n, angle)
    fill = fan(ORIGIN, sector)
    plotter.add_mesh(fill, color=NEUTRAL, opacity=0.35, lighting=False, pickable=False)
    add_label(plotter, 1.3 * sector[len(sector) // 2], r"$\theta$")
    lift = 0.12 * n
    add_label(plotter, 0.6 * ring(np.array(0.0), 0) + lift, r"$\vec r$", VECTOR)
    add_label(plotter, 0.45 * ring(here, 0) + lift, r"$\vec r^{\,\prime}$", RESULT)
    add_line(plotter, [ring(here, -1), ring(here, 1)], NEUTRAL, radius=0.008)
    for place, side, color, text in (
        (np.array(0.0), 1.0, RESULT, "$1$"),
        (np.array(0.0), -1.0, CROSS, "$-1$"),
        (here, 1.0, RESULT, "$q$"),
        (here, -1.0, CROSS, "$-q$"),
    ):
        add_point(plotter, ring(place, side), color, radius=0.04)
        add_label(plotter, ring(place, 1.5 * side), text, color)
    describe(
        plotter,
        "A ring around an axis n. An arrow r points to it, and a second arrow, turned by"
        f" {np.rad2deg(angle):.0f} degrees. Along the ring runs a band that makes half a twist on"
        " its way round. Where it begins, its edges are marked 1, above, and -1, below; at the"
        " turned arrow q and -q. The green edge that leaves from 1 arrives at -1 after one round,"
        " where the purple edge goes on, and comes back to 1 after the second.",
    )
    return plotter


# Uneven gaps, one of them beyond 90 degrees, and on the side of the camera.
FIGURE_8 = ((0.8, -0.4, 0.4), (0.5, 0.8, -0.4), (0.6, 0.7, 0.4), (0.1, 0.4, 0.9))


def add_sphere(plotter: pyvista.Plotter, opacity: float = 0.18) -> None:
    """Add the unit sphere, see-through; it hides the labels behind it."""
    ball = pyvista.Sphere(radius=1.0, theta_resolution=48, phi_resolution=32)
    plotter.add_mesh(ball, color=NEUTRAL, opacity=opacity, smooth_shading=True)


def add_arc(
    plotter: pyvista.Plotter, start: ArrayLike, end: ArrayLike, color: str, radius: float = 0.006
) -> None:
    """Add the shortest arc of the unit sphere from one point to another."""
    add_line(plotter, slerp(start, end, np.linspace(0, 1, 17)), color, radius)


def figure_8(points: ArrayLike = FIGURE_8, fraction: float = 1 / 2) -> pyvista.Plotter:
    """Draw Fig. 8: a closed curve on the sphere, its points and its control points.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        The points P_0 ... P_{n-1}, at least 3; they are normalised.
    fraction : float
        How far ``a_i`` goes from ``P_i`` towards the midpoint; 1/2 is the paper's.

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

    # Labels stand on the outer side of the corners; the polygon has none at P_i.
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
        " Next to each point stand two small green control points, a after it and b before it."
        " Thin purple arcs join them all in the order P0, a0, b1, P1, a1 and so on; they follow the"
        " curve and touch it at the points P.",
    )
    return plotter


# Far apart, so that the arcs of all levels can be told from each other.
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
        " Four blue points, Q00 to Q03, are joined by three blue arcs. On each of these sits a"
        " purple point, Q11 to Q13; two purple arcs join them. On each of those sits a grey point,"
        " Q22 and Q23. The grey arc between them meets the curve at the green point Q33.",
    )
    return plotter


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
    r = np.asarray(orientations() if rotations is None else rotations, float)
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


def orientations() -> NDArray[np.float64]:
    """Make the orientations of `carried_mesh`, shape (4, 3, 3)."""
    p = np.array(((1.0, -0.1, 0.2), (0.8, 0.6, -0.2), (0.3, 0.8, 0.5), (0.4, 0.2, 0.9)))
    p /= np.linalg.norm(p, axis=1, keepdims=True)
    side = np.cross(p, control_points(p)[0])
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    frames = np.stack([np.cross(side, p), side, p], axis=-1)
    return frames @ rotation_matrix([0, 0, 1], np.radians([0, 90, 30, -60]))


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
            # Outside both rings if it points along W.
            (u, 1.8 if abs(w @ u) > 0.9 else 1.52, r"U^{\,\prime\prime}"),
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


# The points of figures 3 to 7: 60 degrees apart, then 90, so that no angle that is bisected
# equals the one that its name without the bar stands for.
NEIGHBOURS = ((1.0, 0.0, 0.0), (0.5, 0.75**0.5, 0.0), (0.0, 0.0, 1.0))


def add_angle(
    plotter: pyvista.Plotter,
    start: ArrayLike,
    end: ArrayLike,
    text: str,
    size: float = 0.45,
    place: float = 0.64,
) -> None:
    """Mark and name the angle at the origin between two directions."""
    rim = size * slerp(start, end, np.linspace(0, 1, 25))
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
    a = bisect(points, slerp(reflected, np.roll(points, -1, axis=0), -0.5))
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

    plotter = new_scene(eye=(4.6, 2.25, 2.05), target=ORIGIN, view_angle=25.5)
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


def pointing_spoon(stations: int = 81, around: int = 28) -> pyvista.PolyData:
    """Model a teaspoon that points from the origin along U, 1 unit long, its bowl open upwards."""
    spoon = teaspoon(stations, around)
    spoon.points = (spoon.points + np.array([1, 0, -0.08])) / 2
    return spoon


def four_descriptions(
    axis: ArrayLike = (-1 / 3, -2 / 3, 2 / 3), angle: float = 2 * np.arctan2(3, 4)
) -> pyvista.Plotter:
    """Draw a turned teaspoon with its axis and angle, its three angles, and its own axes.

    Parameters
    ----------
    axis : array_like, shape (3,)
        The rotation axis n; it is normalised.
    angle : float
        The rotation angle in radians.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    n = np.asarray(axis, float) / np.linalg.norm(axis)
    matrix = rotation_matrix(n, angle)
    theta_u = np.arctan2(matrix[2, 1], matrix[2, 2])
    theta_v = -np.arcsin(matrix[2, 0])
    theta_w = np.arctan2(matrix[1, 0], matrix[0, 0])
    before = pointing_spoon()
    after = before.copy()
    after.points = transform(matrix, before.points)

    plotter = new_scene(eye=(4.28, -1.84, 2.6), target=(0.06, 0.0, 0.31), view_angle=20.5)
    plotter.add_mesh(before, color=VECTOR, smooth_shading=True)
    plotter.add_mesh(after, color=RESULT, smooth_shading=True)
    add_coordinate_axes(plotter, 1.1)
    for column, name in zip(matrix.T, "UVW", strict=True):
        add_arrow(plotter, ORIGIN, 1.1 * column, RESULT, radius=0.006)
        add_label(plotter, 1.2 * column, f"${name}'$", RESULT)
    add_arrow(plotter, ORIGIN, 1.1 * n, AXIS)
    add_label(plotter, 1.2 * n, r"$\hat n$", AXIS)

    tip = np.array([1.0, 0, 0])
    path = turning(tip, n, angle)
    add_line(plotter, path, AXIS, radius=0.011)
    add_label(plotter, 1.1 * path[len(path) // 2], r"$\theta$", AXIS)
    # The first of the three turns the spoon about itself: drawn on a small circle ahead of it.
    roll = turning((1.08, 0, 0.16), (1, 0, 0), theta_u)
    raised = turning(tip, (0, 1, 0), theta_v)
    swung = turning(raised[-1], (0, 0, 1), theta_w)
    add_label(plotter, (1.08, 0.23, 0.15), r"$\theta_u$", CROSS)
    add_label(plotter, raised[len(raised) // 2] + (0, 0.09, 0.02), r"$\theta_v$", CROSS)
    add_label(plotter, swung[len(swung) // 3] - (0, 0, 0.09), r"$\theta_w$", CROSS)
    for part in (roll, raised, swung):
        add_line(plotter, part, CROSS, radius=0.011)
    describe(
        plotter,
        "A blue teaspoon points along the U axis; turned by"
        f" {np.rad2deg(angle):.0f} degrees about an axis n it becomes a green one. An arc around n"
        " leads from tip to tip, and so do three arcs around U, V and W. Three thin green arrows"
        " show where the axes U, V and W have gone.",
    )
    return plotter


def worn_rotations(
    turns: int = 1000, decimals: int = 2, seed: int = 3
) -> list[NDArray[np.float64]]:
    """Multiply random rotations that should lead back to the start, and round every product.

    Parameters
    ----------
    turns : int
        How many of them; one more undoes them all.
    decimals : int
        To how many decimals every number is rounded after every turn.
    seed : int
        Seed of the random rotations.

    Returns
    -------
    list of ndarray, shape (3, 3)
        What is left of the identity: the product of the matrices, and the matrix by which the
        product q of the quaternions takes r to q [0, r] q*. Neither is repaired.

    Examples
    --------
    >>> for kept in worn_rotations(turns=10, decimals=12):
    ...     print(np.abs(kept - np.eye(3)).max() < 1e-10)
    True
    True
    """
    factors = np.random.default_rng(seed).normal(size=(turns, 4))
    factors /= np.linalg.norm(factors, axis=1, keepdims=True)
    exact, rounded, matrix = Quaternion(1, ORIGIN), Quaternion(1, ORIGIN), np.eye(3)
    for w, *v in factors:
        exact = Quaternion(w, v) * exact
    last = exact.conjugate().components
    for w, *v in (*factors, last):
        step = Quaternion(w, v)
        matrix = np.round(step.matrix() @ matrix, decimals)
        w, *v = np.round((step * rounded).components, decimals)
        rounded = Quaternion(w, v)
    return [matrix, rounded.norm() ** 2 * rounded.matrix()]


def worn_spoons(turns: int = 1000) -> pyvista.Plotter:
    """Draw what coarse rounding does to a product of matrices, and to one of quaternions.

    Parameters
    ----------
    turns : int
        Number of random rotations, after which one more leads back to the start.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    corners = np.array(list(np.ndindex(2, 2, 2))) - 0.5
    edges = [(p, q) for p in corners for q in corners if (q - p).sum() == (q != p).sum() == 1]
    spoon = teaspoon(stations=81, around=28)
    spoon.points = spoon.points / 2

    plotter = new_scene(eye=(3.0, -7.4, 3.6), target=(0.04, 0, -0.1), view_angle=15.2)
    across = np.array([0.93, 0.36, 0]) * 0.88
    for side, matrix, name in zip(
        (-1, 1), worn_rotations(turns), ("matrices", "quaternions"), strict=True
    ):
        place = side * across
        for which, color, radius in ((np.eye(3), VECTOR, 0.005), (matrix, RESULT, 0.009)):
            for p, q in edges:
                add_line(plotter, [place + which @ p, place + which @ q], color, radius)
            turned = spoon.copy()
            turned.points = transform(which, spoon.points) + place
            plotter.add_mesh(turned, color=color, smooth_shading=True, pickable=False)
        add_label(plotter, place - np.array([0, 0, 1]), name)
    describe(
        plotter,
        "Two teaspoons, each in a wire box, both drawn twice: blue at the start, green after"
        f" {turns} turns that should lead back there. On the left, where matrices were multiplied,"
        " the green box is askew and its spoon bent with it. On the right, where quaternions were,"
        " the box is still a cube, but larger, and turned further away from the blue one.",
    )
    return plotter


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
