"""What the parts and labels of a state look like, and how a scene gets them."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from typing import Any, TypeVar

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.figures.state import State, place_part
from rotedu.quaternions import Quaternion
from rotedu.scenes.parts import TIP, add_arrow, add_label, add_lines, add_point, add_thin
from rotedu.scenes.shapes import ORIGIN, W, merged, teaspoon

UNTOUCHED = {"smooth_shading": True, "pickable": False}
"""Style of a mesh that is seen as smooth, and that no pointer finds."""


@dataclass(frozen=True)
class Ball:
    """A part that a state places ``at`` a point: a small ball."""

    color: str
    radius: float = 0.03

    def add(self, plotter: pyvista.Plotter, name: str, place: State) -> pyvista.Actor:
        """Add the part to a scene. While it is hidden, it may have no place, and is anywhere."""
        return add_point(plotter, place.get("at", ORIGIN), self.color, self.radius, name)


@dataclass(frozen=True)
class Arrow:
    """A part that a state leads ``from`` a point ``to`` another; its head takes a share at most."""

    color: str
    radius: float = 0.016
    tip: float = TIP

    def add(self, plotter: pyvista.Plotter, name: str, place: State) -> pyvista.Actor:
        """Add the part to a scene, as `Ball` does."""
        ends = place.get("from", ORIGIN), place.get("to", W)
        return add_arrow(plotter, *ends, self.color, self.radius, name, self.tip)


@dataclass(frozen=True)
class Lines:
    """A part that follows the ``paths`` of a state: round lines."""

    color: str
    radius: float = 0.008
    opacity: float = 1.0

    def add(self, plotter: pyvista.Plotter, name: str, place: State) -> pyvista.Actor:
        """Add the part to a scene, as `Ball` does."""
        paths = place.get("paths", [[ORIGIN, W]])
        actor = add_lines(plotter, paths, self.color, self.radius, name)
        actor.prop.opacity = self.opacity
        return actor


@dataclass(frozen=True)
class Mesh:
    """A mesh, moved by the ``matrix`` of a state, or a function that makes one of its ``points``.

    ``style`` has arguments of pyvista's ``add_mesh``; without any, the mesh is a thin part.
    """

    shape: pyvista.PolyData | Callable[[Any], pyvista.PolyData]
    color: str | NDArray[np.float64]
    style: Mapping[str, Any] = field(default_factory=dict)

    def add(self, plotter: pyvista.Plotter, name: str, place: State) -> pyvista.Actor:
        """Add the part to a scene, as `Ball` does."""
        moves = {key: place[key] for key in ("matrix", "points") if key in place}
        name = place_part(plotter, name, **moves)
        mesh = self.shape(place["points"]) if callable(self.shape) else self.shape
        if self.style:
            actor = plotter.add_mesh(mesh, color=self.color, name=name, **self.style)
        else:
            actor = add_thin(plotter, mesh, self.color, name)
        if "matrix" in place:
            actor.user_matrix = np.reshape(place["matrix"], (4, 4)).T
        return actor


@dataclass(frozen=True)
class Heap:
    """Equal meshes in many places, of which a state shows a ``count``, all moved by its ``matrix``.

    The places are points, shape (n, 3), and unit quaternions, shape (n, 4).
    """

    shape: pyvista.PolyData
    places: tuple[NDArray[np.float64], NDArray[np.float64]]
    color: str

    def add(self, plotter: pyvista.Plotter, name: str, place: State) -> pyvista.Actor:
        """Add the part to a scene, as `Ball` does."""
        mesh = heaped(self.shape, self.places, place["count"])
        name = place_part(plotter, name, heap=(self.shape, self.places), **place)
        actor = add_thin(plotter, mesh, self.color, name)
        actor.user_matrix = np.reshape(place["matrix"], (4, 4)).T
        return actor


def spoon_in(color: str, opacity: float = 1.0) -> Mesh:
    """Return what a small spoon looks like that no pointer finds."""
    return Mesh(teaspoon(stations=61, around=20), color, UNTOUCHED | {"opacity": opacity})


def heaped(
    shape: pyvista.PolyData, places: tuple[NDArray[np.float64], NDArray[np.float64]], count: int
) -> pyvista.PolyData:
    """Put a mesh into the first of many places."""
    copies = []
    for point, (w, *v) in zip(*(place[:count] for place in places), strict=True):
        copies.append(shape.copy())
        copies[-1].points = Quaternion(w, v).rotate(shape.points) + point
    return merged(*copies)


@dataclass(frozen=True)
class Text:
    """A label that a state places; ``{}`` in its text stands for its name."""

    color: str = "black"
    text: str = "${}$"
    view: str = ""

    def add(self, plotter: pyvista.Plotter, name: str, place: ArrayLike | None) -> None:
        """Add the label to a scene; None if it is absent."""
        add_label(plotter, place, self.text.replace("{}", name), self.color, name, self.view)


Look = Ball | Arrow | Lines | Mesh | Heap
T = TypeVar("T")


def draw(
    plotter: pyvista.Plotter,
    state: State,
    looks: Mapping[str, Look],
    texts: Mapping[str, Text] | None = None,
) -> None:
    """Add parts and labels of a state to a scene.

    Parameters
    ----------
    state : dict
        What the model of an explorable has computed.
    looks, texts : mapping
        What parts and labels look like, by name or by a pattern of names such as ``P_*``; the
        first that fits counts. Parts are added in this order, and others not at all.
    """
    for name, look in fitting(looks, state["parts"]):
        place = state["parts"][name]
        actor = look.add(plotter, name, place)
        actor.visibility = not place.get("hidden", False)
        if "color" in place:
            actor.prop.color = place["color"]
    for name, text in fitting(texts or {}, state.get("labels", {})):
        text.add(plotter, name, state["labels"][name])


def fitting(looks: Mapping[str, T], names: Iterable[str]) -> list[tuple[str, T]]:
    """Return names, in the order of the patterns of looks, each with the first look that fits."""
    names, found = list(names), dict[str, T]()
    for pattern, look in looks.items():
        for name in names:
            if name not in found and fnmatchcase(name, pattern):
                found[name] = look
    return list(found.items())
