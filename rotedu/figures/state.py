"""What a scene shows, as data: where its parts and labels are, and what is read off.

The model of an explorable computes a *state* from its inputs. The scene is drawn from the state at
the start, and the viewer moves its parts to others without drawing them anew:

- a ball is ``at`` a point, an arrow goes ``from`` one point ``to`` another, lines follow ``paths``,
  and any other part has a ``matrix`` or ``points``;
- a part may have another ``color`` and may be ``hidden``; a label has a position, or none;
- a grip says where an input can be grabbed. A number goes evenly along its ``path`` from its lower
  to its upper bound, or cannot be grabbed for now (None); a path that ends where it begins has no
  end, and one that goes round and round says in how many ``laps``. If it is a circle about whose
  axis something turns with the number, a line on this thing, its ``body``, is grabbed in its place.
  Poses have bodies of a ``size`` ``at`` a point or several. Points given in the frame of a turned
  body have its rotation matrix, ``turn``. What the hand ``holds`` are parts, by name, one for each
  point or pose;
- a view says from where a second picture beside the scene sees it;
- an output is a number, a text or rows of numbers; a chart has a curve, or none for now,
  for each of its names. A curve is heights evenly spread, or such heights for pieces of equal
  width, with a gap where the height jumps from one to the next.

Here stands what the model does not know: how an output is written, what a chart is called.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pyvista
from numpy.typing import ArrayLike

State = dict[str, Any]


@dataclass(frozen=True)
class Output:
    """How a number, a text or a matrix beside a figure is written."""

    label: str
    digits: int = 2
    unit: str = ""
    loud: str = "no"
    where: str = "panel"
    color: str = ""


@dataclass(frozen=True)
class Chart:
    """Curves over one of the inputs of a figure, and a mark at the value of this input."""

    label: str
    over: str
    x: tuple[float, float]
    y: tuple[float, float]
    colors: Mapping[str, str] = field(default_factory=dict)
    marks: Sequence[str] = ()
    dashed: Sequence[str] = ()
    ticks: Mapping[float, str] = field(default_factory=dict)


@dataclass(frozen=True)
class View:
    """A second picture of a scene: from where it is seen, and what is not in it."""

    place: Mapping[str, Any]
    size: tuple[int, int]
    alt: str
    without: Sequence[str]


@dataclass
class Record:
    """What has been recorded about a scene; ``seen_in`` names the view of some labels."""

    parts: dict[str, dict[str, Any]] = field(default_factory=dict)
    labels: dict[str, list[float] | None] = field(default_factory=dict)
    outputs: dict[str, Output] = field(default_factory=dict)
    charts: dict[str, Chart] = field(default_factory=dict)
    views: dict[str, View] = field(default_factory=dict)
    seen_in: dict[str, str] = field(default_factory=dict)
    swing: float = 0
    stack: dict[str, Any] = field(default_factory=dict)


def record_of(plotter: pyvista.Plotter) -> Record:
    """Return what has been recorded about a scene."""
    if not hasattr(plotter, "record"):
        pyvista.set_new_attribute(plotter, "record", Record())
    recorded: Record = plotter.record
    return recorded


def new_name(taken: Mapping[str, Any], name: str) -> str:
    """Return a name, followed by a number if the scene has another part with this name."""
    new, number = name, 1
    while new in taken:
        number += 1
        new = f"{name} {number}"
    return new


def place_part(plotter: pyvista.Plotter, name: str, **place: Any) -> str:
    """Record where a part is; return the name for its actor, with a number if it is taken.

    Parameters
    ----------
    name : str
        Name of the part.
    **place
        One of ``at`` (a point), ``from`` and ``to`` (two points), ``paths`` (a list of arrays of
        points), and what the viewer needs to draw the part anew: its ``radius``.
    """
    parts = record_of(plotter).parts
    name = new_name(parts, name)
    parts[name] = place
    return name


def place_label(
    plotter: pyvista.Plotter, name: str, position: ArrayLike | None, view: str = ""
) -> str:
    """Record where a label is, or is not, in which view alone; return the name for its actor."""
    recorded = record_of(plotter)
    name = new_name(recorded.labels, name)
    recorded.labels[name] = None if position is None else np.asarray(position, float).tolist()
    if view:
        recorded.seen_in[name] = view
    return name


def add_view(
    plotter: pyvista.Plotter,
    name: str,
    *,
    eye: ArrayLike,
    target: ArrayLike,
    up: ArrayLike,
    angle: float,
    size: tuple[int, int],
    alt: str,
    without: Sequence[str] = (),
) -> None:
    """Show a second picture beside a scene.

    Parameters
    ----------
    name : str
        Name of the view.
    eye, target, up : array_like, shape (3,)
        Where the picture is taken, the point in its middle, and the direction of its upper side.
    angle : float
        Height of the field of view in degrees.
    size : tuple of int
        Width and height of the picture in pixels.
    alt : str
        What the picture shows.
    without : sequence of str
        Parts that are not in the picture.
    """
    place = {"eye": eye, "target": target, "up": up, "angle": angle}
    record_of(plotter).views[name] = View(place, size, alt, without)


def read_out(
    plotter: pyvista.Plotter,
    name: str,
    label: str,
    digits: int = 2,
    unit: str = "",
    loud: str = "no",
    where: str = "panel",
    color: str = "",
) -> None:
    """Show an output of the model beside a scene: a number, a text or a matrix.

    Parameters
    ----------
    name : str
        Name of the output, which is its name in the page, too.
    label : str
        What it is, in a word or two.
    digits : int
        Digits after the point.
    unit : str
        What follows the number, such as ``°``.
    loud : str
        The value that a reader should not miss; it is written in bold.
    where : str
        ``picture``: large, at the lower edge of the picture, for what matters; ``panel``: with the
        controls; ``folded``: under *More numbers*.
    color : str
        Colour of the label: that of what the number belongs to.
    """
    record_of(plotter).outputs[name] = Output(label, digits, unit, loud, where, color)


def draw_chart(
    plotter: pyvista.Plotter,
    name: str,
    *,
    over: str,
    x: tuple[float, float],
    y: tuple[float, float],
    label: str,
    colors: Mapping[str, str] | None = None,
    marks: Sequence[str] = (),
    dashed: Sequence[str] = (),
    ticks: Mapping[float, str] | None = None,
) -> None:
    """Show a chart of the model beside a scene, while it has a curve.

    Parameters
    ----------
    name : str
        Name of the chart.
    over : str
        The input along the chart; a mark shows its value.
    x, y : tuple of float
        The range of each axis. Where a curve lies beyond, an arrow says so.
    label : str
        What the chart shows.
    colors : mapping of str to str, optional
        Colour of each curve, and of the ``marks``.
    marks : sequence of str
        What stands where each piece begins; there may be more names than pieces.
    dashed : sequence of str
        Curves that let what is below them show through.
    ticks : mapping of float to str, optional
        Heights that have a hairline, and what stands beside it; else round numbers.
    """
    chart = Chart(label, over, x, y, colors or {}, marks, dashed, ticks or {})
    record_of(plotter).charts[name] = chart


def limit_turning(plotter: pyvista.Plotter, degrees: float) -> None:
    """Let the reader turn a scene by only so many degrees: parts in a row then stay apart."""
    record_of(plotter).swing = degrees


def stack_on_phone(
    plotter: pyvista.Plotter, *parts: tuple[float, float, float, float, float]
) -> None:
    """Show parts of a wide picture one above the other where there is no room for it.

    Parameters
    ----------
    *parts
        From above: left, top, width and height in pixels of the picture, beyond whose border there
        may be more to see, and the width of the part as a share of that of the stack. What is in a
        part moves beside that of no other.
    """
    size = (*plotter.window_size, *plotter.window_size)
    heights = [share * height / width for _, _, width, height, share in parts]
    rows, above = [], 0.0
    for (*part, share), height in zip(parts, heights, strict=True):
        to = ((1 - share) / 2, above / sum(heights), share, height / sum(heights))
        rows.append({"from": np.divide(part, size).tolist(), "to": list(to)})
        above += height
    record_of(plotter).stack = {"rows": rows, "aspect": 1 / sum(heights)}


def in_stack(stack: Mapping[str, Any], left: float, top: float) -> tuple[float, float]:
    """Return where a place of the picture is in its stack, both as shares of their sizes."""

    def beyond(row: Mapping[str, list[float]]) -> float:
        """Return how far to the side of a row the place is."""
        x, _, width, _ = row["from"]
        return max(x - left, left - x - width)

    row = min(stack["rows"], key=beyond)
    (x, y, width, height), to = row["from"], row["to"]
    return to[0] + (left - x) / width * to[2], to[1] + (top - y) / height * to[3]
