"""Points, colours and meshes that scenes are made of."""

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.colors import RESULT, VECTOR
from rotedu.figures.light import INSIDE
from rotedu.ordinary_rotation import rotate

__all__ = ["teaspoon"]

ORIGIN = np.zeros(3)
U, V, W = np.eye(3)
JUST_INSIDE = 0.99
"""Radius of a surface along the unit sphere: two surfaces in one place would show stripes."""


def normalised(vectors: ArrayLike) -> NDArray[np.float64]:
    """Scale points or quaternions, shape (..., k), to length 1."""
    return np.asarray(np.divide(vectors, np.linalg.norm(vectors, axis=-1, keepdims=True)))


def turning(
    point: ArrayLike, axis: ArrayLike, angle: float, steps: int = 48
) -> NDArray[np.float64]:
    """Sample the path of a turned point, shape (steps + 1, 3)."""
    return rotate(point, axis, np.linspace(0, angle, steps + 1))


def fan(points: ArrayLike) -> pyvista.PolyData:
    """Fill the region between a point and a rim, one after the other, shape (1 + n, 3)."""
    second = np.arange(1, len(np.asarray(points)) - 1)
    triangles = np.column_stack([np.zeros_like(second), second, second + 1])
    return triangle_mesh(points, triangles)


def lathe(profile: ArrayLike) -> pyvista.PolyData:
    """Turn a profile, distances from the W axis and heights, shape (n, 2), into a surface."""
    line = pyvista.MultipleLines(np.insert(np.asarray(profile, float), 1, 0, axis=1))
    surface: pyvista.PolyData = line.extrude_rotate(resolution=48, capping=False)
    return surface


def triangle_mesh(points: ArrayLike, triangles: ArrayLike) -> pyvista.PolyData:
    """Make a mesh from points, shape (n, 3), and triples of their indices, shape (m, 3)."""
    corners = np.asarray(triangles)
    faces = np.insert(corners, 0, 3, axis=1).ravel()
    return pyvista.PolyData(np.asarray(points), faces=faces)


def merged(*parts: pyvista.PolyData) -> pyvista.PolyData:
    """Make one thing of several."""
    whole: pyvista.PolyData = pyvista.merge(parts)
    return whole


def surface(points: ArrayLike, rows: int = 2) -> pyvista.PolyData:
    """Fill a surface between so many lines of points, one after the other, shape (n, 3)."""
    i = np.arange(len(np.asarray(points))).reshape(rows, -1)
    p, q, r, s = (k.ravel() for k in (i[:-1, :-1], i[:-1, 1:], i[1:, :-1], i[1:, 1:]))
    return triangle_mesh(points, np.hstack([(p, q, r), (q, s, r)]).T)


def stripes(sides: ArrayLike) -> pyvista.PolyData:
    """Span four surfaces across three lines each, one after the other, shape (12 n, 3)."""
    lines = np.reshape(sides, (4, 3, -1, 3))
    pairs = np.stack([lines[:, :2], lines[:, 1:]], axis=2).reshape(8, -1, 3)
    return merged(*(surface(pair) for pair in pairs))


def teaspoon(stations: int = 121, around: int = 40) -> pyvista.PolyData:
    """Model a teaspoon as a closed surface of ``stations * around`` vertices.

    Every cross-section is a flat closed ring. It is as wide as the outline of the spoon and as
    thick as the metal, and its middle sinks by the depth of the bowl.

    Parameters
    ----------
    stations : int
        Number of cross-sections from the end of the handle to the tip of the bowl.
    around : int
        Number of vertices in each cross-section.

    Returns
    -------
    pyvista.PolyData
        A triangle mesh about 2 units long, along the U axis, with the bowl open upwards. Its
        points say whether they are ``inside``.
    """
    # Cross-sections are close together at both ends and at the neck, where the outline turns.
    even = np.linspace(0, 1, 2001)
    crowd = np.arccos(1 - 2 * even) / np.pi + 0.5 * np.tanh((even - 0.66) / 0.09)
    s = np.interp(np.linspace(crowd[0], crowd[-1], stations), crowd, even)[:, np.newaxis]
    bowl = np.clip((s - 0.55) / 0.45, 0, 1)
    neck = np.clip((s - 0.48) / 0.30, 0, 1)
    ends = np.clip(np.minimum(s / 0.03, (1 - s) / 0.004), 0, 1)
    rounding = np.sqrt(ends * (2 - ends))
    # The handle ends within the bowl, and both outlines meet without a corner.
    handle = (0.035 + 0.055 * np.exp(-((s / 0.14) ** 2))) * (1 - bowl**2)
    shoulder = np.clip(2 * bowl, 0, 1)
    egg = np.sqrt(bowl * (1 - bowl)) * (0.62 - 0.2 * bowl) * shoulder**2 * (3 - 2 * shoulder)
    width = rounding * np.hypot(handle, egg)
    depth = 0.6 * rounding * egg * np.sin(np.pi * bowl**0.6)
    lift = 0.16 * np.sin(np.pi * np.clip(s / 0.62, 0, 1)) ** (1 + neck) + 0.05 * (1 - s)

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
    spoon = triangle_mesh(points, triangles)
    spoon.point_data[INSIDE] = (np.clip(3 * bowl, 0, 1) * np.clip(4 * np.sin(phi), 0, 1)).ravel()
    return spoon


def shade(t: float) -> NDArray[np.float64]:
    """Mix a colour between `VECTOR` (0) and `RESULT` (1)."""
    first, last = (np.array(pyvista.Color(color).float_rgb) for color in (VECTOR, RESULT))
    return np.asarray((1 - t) * first + t * last)
