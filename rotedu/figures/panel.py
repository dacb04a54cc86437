"""What stands below a figure that answers the hand: controls, numbers and charts, as HTML.

The page and the notebook show the same HTML. The viewer finds everything in it by name.
"""

import itertools
from collections.abc import Iterable, Mapping
from html import escape
from typing import Any
from urllib.parse import urlencode

import numpy as np
from numpy.typing import NDArray

from rotedu.figures.frames import Chart, Output, Shown
from rotedu.figures.inputs import Input, written

WIDTH, HEIGHT = 320, 128
# The arrow where a curve leaves its chart: half its width, and its length.
ARROW = (4, 7)
ROUNDING = 1e-9
# So many curves have their names beside their ends, as far apart as this share of the height; more
# have them above.
NAMED, LINE = 3, 0.13


def panel(
    name: str,
    inputs: Mapping[str, Input],
    start: Mapping[str, Any],
    seen: Shown,
    tries: Mapping[str, Mapping[str, Any]],
) -> str:
    """Write the panel of a figure, switched off until the figure is live.

    Parameters
    ----------
    name : str
        Name of the figure.
    inputs, start : mapping
        What the hand can change, and its values at the start.
    seen : Shown
        What is shown: outputs and charts, with their values at the start.
    tries : mapping
        What to try, and the inputs that show it.

    Returns
    -------
    str
        HTML.
    """
    controls = "".join(kind.controls(key, start[key]) for key, kind in inputs.items())
    rows = {where: "" for where in ("picture", "panel", "folded")}
    for key, output in seen.outputs.items():
        rows[output.where] += _output(key, output)
    drawn = "".join(
        _chart(key, chart, start[chart.over], getattr(inputs.get(chart.over), "label", ""))
        for key, chart in seen.charts.items()
    )
    chips = "".join(
        f'<a class="try" href="#explore-{name}?{escape(address(values))}">{written(words)}</a>'
        for words, values in tries.items()
    )
    more = '<details class="explorable-more"><summary>More numbers</summary>{}</details>'
    return (
        '<p class="explorable-status" role="status"></p>'
        '<form class="explorable-panel" autocomplete="off"><fieldset disabled>'
        f'<legend class="explorable-legend">Controls of the figure</legend>'
        f"{_box('numbers', rows['picture'])}{_box('tries', chips and f'<span>Try</span>{chips}')}"
        f'<div class="explorable-controls">{controls.replace("{id}", name)}</div>'
        f"{_box('outputs', rows['panel'])}"
        f'<div class="explorable-charts">{drawn}</div>'
        f"{more.format(_box('outputs', rows['folded'])) if rows['folded'] else ''}"
        '<div class="explorable-buttons explorable-whole">'
        '<button type="button" data-action="reset">Reset</button>'
        '<button type="button" name="copy" data-action="link">Copy link</button></div>'
        "</fieldset></form>"
    )


def address(values: Mapping[str, Any]) -> str:
    """Write values of inputs as the viewer does for the address of a page."""

    def text(value: Any) -> str:
        if isinstance(value, list):
            return (" " if isinstance(value[0], list) else ",").join(map(text, value))
        if isinstance(value, bool):
            return str(value).lower()
        return value if isinstance(value, str) else f"{round(value, 5) + 0.0:.10g}"

    return urlencode({name: text(value) for name, value in values.items()})


def _box(kind: str, content: str) -> str:
    return f'<div class="explorable-{kind}">{content}</div>' if content else ""


def text_of(output: Output) -> str:
    """Write the value of an output as the viewer does."""
    value = output.value
    if isinstance(value, str):
        return value
    rows = [
        [f"{_plain(x, output.digits):.{output.digits}f}" for x in row]
        for row in np.atleast_2d(np.asarray(value, float))
    ]
    # The columns of a matrix are of one width; other numbers are a list.
    width, between = (max(len(x) for row in rows for x in row), " ") if rows[1:] else (0, ", ")
    lines = [between.join(x.rjust(width) for x in row) for row in rows]
    return "\n".join(lines).replace("-", "\N{MINUS SIGN}") + output.unit


def _plain(x: float, digits: int) -> float:
    """Round a number, without a minus sign before zero."""
    return round(x, digits) + 0.0


def _output(name: str, output: Output) -> str:
    loud = ' class="explorable-loud"' if output.value == output.loud else ""
    color = f' style="color: {output.color}"' if output.color else ""
    matrix = " explorable-matrix" if np.ndim(_numbers(output.value)) == 2 else ""
    return (
        f'<label class="explorable-output{matrix}"><span{color}>{written(output.label)}</span>'
        # The status line below speaks; numbers that change with the hand are silent.
        f' <output name="{name}" aria-live="off" data-digits="{output.digits}"'
        f' data-unit="{output.unit}" data-loud="{output.loud}"{loud}>'
        f"{escape(text_of(output))}</output></label>"
    )


def _numbers(value: Any) -> Any:
    return 0 if isinstance(value, str) else value


def _chart(name: str, chart: Chart, value: float, along: str) -> str:
    curves = "".join(
        f'<path data-curve="{escape(curve)}" d="{path_of(heights, chart.y)}"'
        f' style="color: {chart.colors.get(curve, "inherit")}"{_dashed(curve, chart)}/>'
        for curve, heights in chart.curves.items()
    )
    at = (value - chart.x[0]) / (chart.x[1] - chart.x[0]) * WIDTH
    hidden = " hidden" if all(heights is None for heights in chart.curves.values()) else ""
    keys = "".join(
        f'<span style="color: {chart.colors.get(curve, "inherit")}"{_dashed(curve, chart)}>'
        f"{escape(curve)}</span>"
        for curve in chart.curves
        if len(chart.curves) > NAMED
    )
    beside = name_tops(chart) if 1 < len(chart.curves) <= NAMED else {}
    names = "".join(
        f'<span data-name="{escape(curve)}" style="color: {chart.colors.get(curve, "inherit")};'
        f' top: {100 * (top or 0):.0f}%"{" hidden" if top is None else ""}>{escape(curve)}</span>'
        for curve, top in beside.items()
    )
    ticks = chart.ticks or {y: _tick(y) for y in round_heights(*chart.y)}
    depths = [(chart.y[1] - y) / (chart.y[1] - chart.y[0]) for y in ticks]
    lines = "".join(
        f'<line data-tick="{y:g}" x2="{WIDTH}" y1="{HEIGHT * at:.1f}" y2="{HEIGHT * at:.1f}"/>'
        for y, at in zip(ticks, depths, strict=True)
    )
    numbers = "".join(
        f'<span style="top: {100 * at:.1f}%">{text}</span>'
        for text, at in zip(ticks.values(), depths, strict=True)
    )
    ink = chart.colors.get("marks", "inherit")
    pieces = max(len(np.atleast_2d(np.array(curve))) for curve in chart.curves.values())
    marks = "".join(
        f"<span{'' if i < pieces else ' hidden'}>{written(text)}</span>"
        for i, text in enumerate(chart.marks)
    )
    return (
        f'<figure class="explorable-chart" data-chart="{name}" data-over="{chart.over}"'
        f' data-x="{chart.x[0]:g} {chart.x[1]:g}" data-y="{chart.y[0]:g} {chart.y[1]:g}"{hidden}'
        f' style="--digits: {max(map(len, ticks.values()))};'
        f' --letters: {max(map(len, beside), default=0)}">'
        f"<figcaption>{written(chart.label)} {keys}</figcaption>"
        f'<div class="explorable-plot">'
        f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" preserveAspectRatio="none" role="img"'
        f' aria-label="{escape(chart.label)}">{lines}{curves}'
        # A line, and a knob at its foot.
        f'<line data-mark="" x1="{at:.1f}" x2="{at:.1f}" y1="0" y2="{HEIGHT}"/>'
        f'<line data-mark="" x1="{at:.1f}" x2="{at:.1f}" y1="{HEIGHT}" y2="{HEIGHT}"/></svg>'
        f'<div class="explorable-ticks">{numbers}</div><div class="explorable-names">{names}</div>'
        f'<div class="explorable-marks" style="color: {ink}">{marks}</div></div>'
        f'<div class="explorable-axis"><span>{_tick(chart.x[0])}</span>'
        f"<span>{written(along or chart.over)}</span><span>{_tick(chart.x[1])}</span></div>"
        "</figure>"
    )


def round_heights(low: float, high: float) -> list[float]:
    """Return heights for the hairlines of a chart, both ends among them.

    Parameters
    ----------
    low, high : float
        The ends.

    Returns
    -------
    list of float
        Five or four in even steps, if these have one digit that is not zero; else the ends.

    Examples
    --------
    >>> round_heights(0, 150)
    [0.0, 50.0, 100.0, 150.0]
    >>> round_heights(-6, 6)
    [-6.0, -3.0, 0.0, 3.0, 6.0]
    """
    for steps in (4, 3):
        step = (high - low) / steps
        if step == float(f"{step:.0e}"):
            return [low + k * step for k in range(steps + 1)]
    return [low, high]


def name_tops(chart: Chart) -> dict[str, float | None]:
    """Return how far down the names of curves stand: beside their ends, but apart.

    Parameters
    ----------
    chart : Chart
        The chart.

    Returns
    -------
    dict
        For each curve a share of the height, or None while there is no such curve.

    Examples
    --------
    >>> flat = Chart((0, 1), (0, 1), {"p": [1, 0], "q": [0, 0], "r": None}, "", "t")
    >>> name_tops(flat)
    {'p': 0.87, 'q': 1.0, 'r': None}
    """
    low, high = chart.y
    ends = {
        curve: round(float(np.clip((high - np.ravel(heights)[-1]) / (high - low), 0, 1)), 2)
        for curve, heights in chart.curves.items()
        if heights is not None
    }
    tops: dict[str, float | None] = dict.fromkeys(chart.curves)
    above = -LINE
    for k, curve in enumerate(sorted(ends, key=ends.__getitem__)):
        room_below = LINE * (len(ends) - 1 - k)
        above = min(max(ends[curve], above + LINE), 1 - room_below)
        tops[curve] = round(above, 2)
    return tops


def _tick(y: float) -> str:
    return f"{y:g}".replace("-", "\N{MINUS SIGN}")


def _dashed(curve: str, chart: Chart) -> str:
    return " data-dashed" if curve in chart.dashed else ""


def path_of(heights: Any, y: tuple[float, float]) -> str:
    """Write a curve, in one or more pieces, as an SVG path, with arrows where it is cut off."""
    if heights is None:
        return ""
    pieces = np.atleast_2d((np.asarray(heights, float) - y[0]) / (y[1] - y[0]))
    xs = np.linspace(0, 1, pieces.shape[1])
    return "".join(
        _line(zip((i + xs) * WIDTH / len(pieces), np.clip(piece, -0.05, 1.05), strict=True))
        + "".join(
            _arrow((i + k / (len(piece) - 1)) * WIDTH / len(pieces), edge)
            for k, edge in _cut_off(piece)
        )
        for i, piece in enumerate(pieces)
    )


def _line(points: Iterable[tuple[float, float]]) -> str:
    return "M" + " ".join(f"{x:.1f},{HEIGHT * (1 - share):.1f}" for x, share in points)


def _cut_off(piece: NDArray[np.float64]) -> list[tuple[float, int]]:
    """Return the middle of each stretch where a curve is beyond its chart, and the edge, 1 or 0."""
    sides = np.subtract(piece > 1 + ROUNDING, piece < -ROUNDING, dtype=int)
    found = []
    for side, stretch in itertools.groupby(range(len(piece)), sides.__getitem__):
        indices = list(stretch)
        if side:
            found.append(((indices[0] + indices[-1]) / 2, int(side > 0)))
    return found


def _arrow(x: float, edge: int) -> str:
    half, long = ARROW[0], ARROW[1] / HEIGHT
    back = edge - long if edge else long
    return _line([(x - half, back), (x, edge), (x + half, back)])
