"""Scenes of Chapter 2: two mirrors and the two quaternions of a rotation."""

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import describe
from rotedu.ordinary_rotation import rotate
from rotedu.scenes.parts import (
    ORIGIN,
    add_arrow,
    add_label,
    add_line,
    add_point,
    fan,
    new_scene,
    triangle_mesh,
    turning,
)


def letter_f(size: float = 0.5, thickness: float = 0.07) -> pyvista.PolyData:
    """Model the letter F, which is not its own mirror image, lying in the plane of U and V.

    Parameters
    ----------
    size : float
        Height of the letter, along V.
    thickness : float
        Extent of the letter along W.

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
    """Draw a letter mirrored twice, which turns by twice the angle between the mirrors.

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
        """Return a point off the axis; the angle counts from the first mirror."""
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
        " between the mirrors. Its own image in the second mirror is green and reads"
        f" as an F again: it is the blue one, turned by {2 * np.rad2deg(between):.0f} degrees.",
    )
    return plotter


def double_cover(angle: float = np.deg2rad(100), width: float = 0.4) -> pyvista.Plotter:
    """Draw the quaternions [w, s n] of all rotations about one axis: a band with one edge.

    A rotation takes the vector r to a place on the ring. There q lies w = cos(theta / 2) up and
    s = sin(theta / 2) out, on one edge of the band; -q lies opposite, on the other edge.

    Parameters
    ----------
    angle : float
        Angle in radians of the rotation to show.
    width : float
        Half the width of the band, for a ring of radius 1.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """

    def ring(theta: NDArray[np.float64], side: float) -> NDArray[np.float64]:
        """Return points of an edge (side 1 or -1) or of the ring between the edges (side 0)."""
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
        "A ring around an axis n. Two arrows point to the ring: r, and r turned by"
        f" {np.rad2deg(angle):.0f} degrees. A band runs along the ring and makes half a twist in"
        " one round. At r its edges are marked 1, above, and -1, below; at the turned arrow they"
        " are marked q and -q. The green edge leaves 1 and arrives at -1 after one round. There the"
        " purple edge takes over and comes back to 1 after a second round.",
    )
    return plotter
