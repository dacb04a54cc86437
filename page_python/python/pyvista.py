"""Stands in for pyvista: it draws nothing, and a mesh keeps its points and triangles."""

from typing import Any

import numpy as np
from absent import Absent


class Plotter:
    """A scene, which the page shows already."""

    def show(self) -> None:
        """Leave the picture on the page as it is."""

    def __getattr__(self, name: str) -> Absent:
        if name.startswith("__"):
            raise AttributeError(name)
        return Absent("pyvista")


class PolyData:
    """A mesh of triangles."""

    def __init__(self, points: Any, faces: Any) -> None:
        self.points, self.faces = np.array(points), np.array(faces)
        self.point_data: dict[str, Any] = {}

    @property
    def regular_faces(self) -> Any:
        """The corners of each triangle, shape (n, 3)."""
        return self.faces.reshape(-1, 4)[:, 1:]

    @property
    def n_points(self) -> int:
        """The number of points."""
        return len(self.points)


class Color:
    """A colour, of which scenes ask for numbers from 0 to 1."""

    def __init__(self, hexadecimal: str) -> None:
        self.float_rgb = tuple(byte / 255 for byte in bytes.fromhex(hexadecimal.lstrip("#")))


def __getattr__(name: str) -> Absent:
    """Return something for annotations, such as ``pyvista.Actor``, that nobody can call."""
    return Absent("pyvista").__getattr__(name)
