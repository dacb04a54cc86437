"""The room of pages 5 I to 5 IV: what a camera in its middle looks at, and the camera."""

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import arc_axis
from rotedu.scenes.shapes import ORIGIN, merged

CAMERA_TARGETS = ((1.0, 0.0, -0.2), (0.3, 1.0, 0.2), (0.2, 0.3, 1.0), (0.3, -0.9, 0.3))
"""Directions from a camera to a door, a clock, a window and a desk, in this order."""


def facing(direction: ArrayLike, origin: ArrayLike = ORIGIN) -> NDArray[np.float64]:
    """Return the upright pose, shape (4, 4), whose first axis has this direction."""
    ahead = np.asarray(direction, float) / np.linalg.norm(direction)
    left = arc_axis([0, 0, 1], ahead)
    pose = np.eye(4)
    pose[:3] = np.column_stack([ahead, left, np.cross(ahead, left), origin])
    return pose


def camera(direction: ArrayLike, size: float = 0.3) -> pyvista.PolyData:
    """Model a camera at the origin, upright: a box whose lens points in a direction."""
    body = pyvista.Box(bounds=(-0.7, 0.2, -0.35, 0.35, -0.3, 0.3)).triangulate()
    lens = pyvista.Cone(
        center=(0.35, 0, 0), direction=(-1, 0, 0), height=0.7, radius=0.32, resolution=24
    ).triangulate()
    model = merged(body, lens)
    model.points *= size
    model.transform(facing(direction), inplace=True)
    return model


def boxes(*bounds: tuple[float, ...]) -> pyvista.PolyData:
    """Put boxes together, each of which reaches so far left, right, down and up, and is thin."""
    parts = [pyvista.Box(bounds=(-0.012, 0.012, *sides)) for sides in bounds]
    return merged(*(part.triangulate() for part in parts))


def door() -> pyvista.PolyData:
    """Model a door: a frame, a leaf and a knob."""
    leaf = boxes((-0.075, 0.075, -0.17, 0.15))
    frame = boxes(
        (-0.1, -0.085, -0.17, 0.175), (0.085, 0.1, -0.17, 0.175), (-0.1, 0.1, 0.16, 0.175)
    )
    knob = pyvista.Sphere(radius=0.018, center=(-0.02, 0.055, -0.02), theta_resolution=12)
    return merged(leaf, frame, knob)


def clock() -> pyvista.PolyData:
    """Model a clock at ten past twelve: a rim, strokes for the hours and two hands."""
    angles = np.linspace(0, 2 * np.pi, 49)
    circle = 0.15 * np.column_stack([0 * angles, -np.sin(angles), np.cos(angles)])
    rim = pyvista.lines_from_points(circle).tube(radius=0.013, n_sides=10)
    stroke = boxes((-0.005, 0.005, 0.115, 0.135))
    hours = [stroke.rotate_x(30 * k) for k in range(12)]
    hands = [boxes((-0.009, 0.009, -0.02, 0.08)), boxes((-0.006, 0.006, -0.02, 0.12)).rotate_x(60)]
    return merged(rim, *hours, *hands)


def window() -> pyvista.PolyData:
    """Model a window: a frame with a cross."""
    upright = [(y - 0.009, y + 0.009, -0.15, 0.15) for y in (-0.12, 0, 0.12)]
    level = [(-0.129, 0.129, z - 0.009, z + 0.009) for z in (-0.15, 0.03, 0.15)]
    return boxes(*upright, *level)


def desk() -> pyvista.PolyData:
    """Model a desk with a lamp."""
    top = pyvista.Box(bounds=(-0.06, 0.06, -0.16, 0.16, -0.02, 0.0)).triangulate()
    legs = boxes((-0.15, -0.13, -0.14, -0.02), (0.13, 0.15, -0.14, -0.02))
    lamp = boxes((0.075, 0.085, 0, 0.1), (0.02, 0.09, 0.09, 0.105))
    return merged(top, legs, lamp)


THINGS = {"door": door, "clock": clock, "window": window, "desk": desk}
"""What the camera sees, in its order, each about the origin and seen along the first axis."""
CAMERA_SEES = tuple(THINGS)
