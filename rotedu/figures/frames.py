"""What a scene shows, as data: where its parts and labels are, and what is read off.

A part that can move is placed under a name when it is added to the scene. Two scenes with the same
names then differ by a *frame*, which the viewer applies to the first without drawing it anew:

- a ball is ``at`` a point, an arrow goes ``from`` one point ``to`` another, lines follow ``paths``,
  and any other part has a ``matrix`` or ``points``;
- a part may have another ``color`` and may be ``hidden``; a label has a position, or none;
- a grip says where an input can be grabbed: a number along a ``path``, or none for now, perhaps by
  a ``body`` that turns with it, bodies of a ``size`` ``at`` points, and points after a ``turn``;
- a view says from where a second picture beside the scene sees it;
- an output is a number, a text or rows of numbers; a chart has a curve, or none for now,
  for each of its names.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pyvista
from numpy.typing import ArrayLike

from rotedu.figures.gltf import part_names, surface_of

# Digits after the point in frames: a thousandth of a pixel of the poster.
DIGITS = 6
# What a frame holds as a whole, not by property.
WHOLE = ("labels", "grips", "charts", "views")
# What an output says that is false or true.
LAMP = ("no", "yes")


@dataclass(frozen=True)
class Output:
    """A number, a text or a matrix beside a figure."""

    value: Any
    label: str
    digits: int = 2
    unit: str = ""
    loud: str = "no"
    where: str = "panel"
    color: str = ""


@dataclass(frozen=True)
class Chart:
    """Curves over one of the inputs of a figure, and a mark at the value of this input."""

    x: tuple[float, float]
    y: tuple[float, float]
    curves: Mapping[str, ArrayLike | None]
    label: str
    over: str
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
class Shown:
    """What has been recorded about a scene; ``seen_in`` names the view of some labels."""

    parts: dict[str, dict[str, Any]] = field(default_factory=dict)
    labels: dict[str, list[float] | None] = field(default_factory=dict)
    grips: dict[str, dict[str, Any]] = field(default_factory=dict)
    outputs: dict[str, Output] = field(default_factory=dict)
    charts: dict[str, Chart] = field(default_factory=dict)
    views: dict[str, View] = field(default_factory=dict)
    seen_in: dict[str, str] = field(default_factory=dict)
    swing: float = 0
    stack: dict[str, Any] = field(default_factory=dict)


def shown(plotter: pyvista.Plotter) -> Shown:
    """Return what has been recorded about a scene."""
    if not hasattr(plotter, "shown"):
        pyvista.set_new_attribute(plotter, "shown", Shown())
    recorded: Shown = plotter.shown
    return recorded


def new_name(taken: Mapping[str, Any], name: str) -> str:
    """Return a name, followed by a number if the scene has another part with this name."""
    new, number = name, 1
    while new in taken:
        number += 1
        new = f"{name} {number}"
    return new


def place_part(plotter: pyvista.Plotter, name: str, **place: Any) -> str:
    """Record where a part is; return the name for its actor.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The scene.
    name : str
        Name of the part; if taken, it gets a number.
    **place
        One of ``at`` (a point), ``from`` and ``to`` (two points), ``paths`` (a list of arrays of
        points), and what the viewer needs to draw the part anew: its ``radius``.

    Returns
    -------
    str
        The name.
    """
    parts = shown(plotter).parts
    name = new_name(parts, name)
    parts[name] = place
    return name


def place_label(
    plotter: pyvista.Plotter, name: str, position: ArrayLike | None, view: str = ""
) -> str:
    """Record where a label is, or that it is absent, and the only view that shows it.

    Returns
    -------
    str
        The name for its actor.
    """
    recorded = shown(plotter)
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
    plotter : pyvista.Plotter
        The scene.
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
    shown(plotter).views[name] = View(place, size, alt, without)


def place_grip(plotter: pyvista.Plotter, name: str, **place: Any) -> None:
    """Record where an input can be grabbed.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The scene.
    name : str
        The input: a `Slider`, `Poses` or `Handles`.
    **place
        For a number its ``path``, shape (n, 3), along which it goes evenly from its lower to its
        upper bound, or None while it cannot be grabbed. A path that ends where it begins has no
        end. If it is a circle about whose axis something turns with the number, a line on this
        thing, ``body``, of shape (m, 3), is grabbed in its place. For poses the ``size`` of their
        bodies and where they are, ``at``, one point or several. For points that are given in the
        frame of a turned body its rotation matrix, ``turn``.
    """
    shown(plotter).grips[name] = {
        key: None if value is None else np.asarray(value, float) for key, value in place.items()
    }


def read_out(
    plotter: pyvista.Plotter,
    name: str,
    value: Any,
    label: str,
    digits: int = 2,
    unit: str = "",
    loud: str = "no",
    where: str = "panel",
    color: str = "",
) -> None:
    """Show a number, a text or a matrix beside a scene.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The scene.
    name : str
        Name of the output, which is its name in the page, too.
    value : float, str or array_like
        The value. A boolean becomes a lamp: *yes* or *no*.
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
    if isinstance(value, (bool, np.bool_)):
        value = LAMP[bool(value)]
    elif not isinstance(value, str):
        value = np.asarray(value, float).tolist()
    shown(plotter).outputs[name] = Output(value, label, digits, unit, loud, where, color)


def draw_chart(
    plotter: pyvista.Plotter,
    name: str,
    curves: Mapping[str, ArrayLike | None],
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
    """Show a chart beside a scene, while it has a curve.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The scene.
    name : str
        Name of the chart.
    curves : mapping of str to array_like
        The heights of each curve at places evenly spread over `x`: shape (m,), or (n, m) for n
        pieces of equal width, with a gap where the height jumps from one to the next. A curve that
        does not exist for now is None.
    over : str
        The input along the chart; a mark shows its value.
    x, y : tuple of float
        The range of each axis, the same in all frames. Where a curve lies beyond, an arrow says so.
    label : str
        What the chart shows.
    colors : mapping of str to str, optional
        Colour of each curve, and of the ``marks``.
    marks : sequence of str
        What stands where each piece begins; there may be more names than pieces.
    dashed : sequence of str
        Curves that let see what is below them.
    ticks : mapping of float to str, optional
        Heights that have a hairline, and what stands beside it; else round numbers.
    """
    heights = {curve: rounded(h) for curve, h in curves.items()}
    chart = Chart(x, y, heights, label, over, colors or {}, marks, dashed, ticks or {})
    shown(plotter).charts[name] = chart


def limit_turning(plotter: pyvista.Plotter, degrees: float) -> None:
    """Let the reader turn a scene by so many degrees only: parts in a row then stay apart."""
    shown(plotter).swing = degrees


def stack_on_phone(
    plotter: pyvista.Plotter, *parts: tuple[float, float, float, float, float]
) -> None:
    """Show parts of a wide picture one above the other where there is no room for it.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The scene.
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
    shown(plotter).stack = {"rows": rows, "aspect": 1 / sum(heights)}


def in_stack(stack: Mapping[str, Any], left: float, top: float) -> tuple[float, float]:
    """Return where a place of the picture is in its stack, both as shares of their sizes."""

    def beyond(row: Mapping[str, list[float]]) -> float:
        """Return how far to the side of a row the place is."""
        x, _, width, _ = row["from"]
        return max(x - left, left - x - width)

    row = min(stack["rows"], key=beyond)
    (x, y, width, height), to = row["from"], row["to"]
    return to[0] + (left - x) / width * to[2], to[1] + (top - y) / height * to[3]


def frame_of(plotter: pyvista.Plotter) -> dict[str, Any]:
    """Describe a scene as a frame.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The scene.

    Returns
    -------
    dict
        ``parts``, ``labels``, ``grips``, ``outputs``, ``charts`` and ``views``, each by name.
    """
    recorded = shown(plotter)
    parts = {name: _part(plotter, name, actor) for name, actor in part_names(plotter)}
    return {
        "parts": parts,
        "labels": {name: rounded(position) for name, position in recorded.labels.items()},
        "grips": {
            name: {key: rounded(value) for key, value in place.items()}
            for name, place in recorded.grips.items()
        },
        "outputs": {name: output.value for name, output in recorded.outputs.items()},
        "charts": {name: chart.curves for name, chart in recorded.charts.items()},
        "views": {
            name: {key: rounded(value) for key, value in view.place.items()}
            for name, view in recorded.views.items()
        },
    }


def _part(plotter: pyvista.Plotter, name: str, actor: pyvista.Actor) -> dict[str, Any]:
    """Describe one part."""
    place = shown(plotter).parts.get(name)
    if place is not None:
        part = {key: rounded(value) for key, value in place.items() if key != "radius"}
    else:
        part = {
            "matrix": rounded(pyvista.array_from_vtkmatrix(actor.GetMatrix()).T.ravel()),
            "points": surface_of(actor).points,
        }
    return part | {"color": list(actor.prop.color.float_rgb), "hidden": not actor.visibility}


def rounded(value: Any) -> Any:
    """Round all numbers of a place, which may be nested."""
    if value is None:
        return None
    if isinstance(value, Sequence) and value and isinstance(value[0], np.ndarray):
        return [rounded(part) for part in value]
    return (np.round(np.asarray(value, float), DIGITS) + 0.0).tolist()


def differences(base: dict[str, Any], frame: dict[str, Any]) -> set[tuple[str, ...]]:
    """Tell what differs between two frames of a scene.

    Parameters
    ----------
    base, frame : dict
        The frames.

    Returns
    -------
    set of tuple of str
        ``("parts", name, property)``, or ``("labels", name)`` and so for each kind in `WHOLE`.

    Raises
    ------
    ValueError
        If a part or a label is missing or new, or if the points of a part have another number.
    """
    for kind in frame:
        if odd := base[kind].keys() ^ frame[kind].keys():
            raise ValueError(
                f"scene: expected the same {kind} for all inputs,"
                f" got {', '.join(sorted(odd))} for some only"
            )
    found: set[tuple[str, ...]] = set()
    for name, part in frame["parts"].items():
        before = base["parts"][name]
        if len(before.get("points", ())) != len(part.get("points", ())):
            raise ValueError(
                f"part {name!r}: expected the same number of points for all inputs,"
                f" got {len(before['points'])} and {len(part['points'])}"
            )
        found |= {
            ("parts", name, key)
            for key, value in part.items()
            if not _equal(value, before.get(key))
        }
    for kind in WHOLE:
        found |= {(kind, name) for name in frame[kind] if frame[kind][name] != base[kind][name]}
    return found


def _equal(value: Any, other: Any) -> bool:
    return np.array_equal(value, other) if isinstance(value, np.ndarray) else value == other


def only(frame: dict[str, Any], varying: set[tuple[str, ...]]) -> dict[str, Any]:
    """Keep of a frame what varies, and all outputs; the result holds no arrays."""
    kept: dict[str, Any] = {"parts": {}, "outputs": frame["outputs"]} | {kind: {} for kind in WHOLE}
    for kind, name, *keys in sorted(varying):
        if kind == "parts":
            for key in keys:
                value = frame[kind][name][key]
                value = rounded(value) if isinstance(value, np.ndarray) else value
                kept[kind].setdefault(name, {})[key] = value
        else:
            kept[kind][name] = frame[kind][name]
    return kept
