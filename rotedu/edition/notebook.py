"""Helpers for notebooks: show code, make a table, name a line of a chart, state a check."""

import ast
import inspect
import json
import re
import textwrap
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt


class Statement(str):
    """A text that a notebook shows without quotation marks."""

    def __repr__(self) -> str:
        return str(self)


class Source(Statement):
    """The source of a function, shown as highlighted code."""

    def _repr_markdown_(self) -> str:
        return f"```python\n{self}\n```"


class Table:
    """A table in Markdown, shown as a table.

    Parameters
    ----------
    header : sequence of str
        Titles of the columns.
    rows : iterable of sequences of str
        The cells, without vertical bars, which separate columns.

    Examples
    --------
    >>> Table(["a", "b"], [["1", "2"]])
    | a | b |
    | --- | --- |
    | 1 | 2 |
    """

    def __init__(self, header: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
        lines = [header, ["---"] * len(header), *rows]
        self.markdown = "\n".join(f"| {' | '.join(line)} |" for line in lines)

    def __repr__(self) -> str:
        return self.markdown

    def _repr_markdown_(self) -> str:
        return self.markdown


def linked(text: str) -> str:
    """Link the numbers of equations and errata in a text."""
    text = re.sub(r"\((\d-\d+)\)", r"[(\1)](#eq-\1)", text)
    return re.sub(r"\bE\d+[bc]?\b", lambda n: f"[{n[0]}](#erratum-{n[0].lower()})", text)


def source(function: Callable[..., Any]) -> Source:
    """Show the code of a function as it stands in its module, without the docstring.

    Parameters
    ----------
    function : callable
        A function of the package.

    Raises
    ------
    ValueError
        If it was not defined by ``def``.

    Returns
    -------
    Source
        Shown by a notebook as code; since the notebook's outputs are compared when it is
        tested, a page cannot show code that the package no longer has.

    Examples
    --------
    >>> from rotedu.ordinary_rotation import rotation_matrix
    >>> print(repr(source(rotation_matrix)).splitlines()[1])
    def rotation_matrix(axis: Unit3, angle: Number) -> Rotation:
    """
    code = textwrap.dedent(inspect.getsource(function))
    first = ast.parse(code).body[0]
    if not isinstance(first, ast.FunctionDef):
        raise ValueError(f"function: expected one defined by `def`, got {function!r}")
    lines = code.splitlines()
    if ast.get_docstring(first) is not None:
        docstring = first.body[0]
        del lines[docstring.lineno - 1 : docstring.end_lineno]
    return Source("\n".join(lines))


# Where a name stands beside its point: the distance in points, and the part of it that is near.
SIDES = {
    "left": {"xytext": (-5, 0), "ha": "right", "va": "center"},
    "right": {"xytext": (5, 0), "ha": "left", "va": "center"},
    "above": {"xytext": (0, 5), "ha": "center", "va": "bottom"},
    "below": {"xytext": (0, -5), "ha": "center", "va": "top"},
    "above left": {"xytext": (-2, 4), "ha": "right", "va": "bottom"},
    "below right": {"xytext": (2, -4), "ha": "left", "va": "top"},
}


def named(lines: Sequence[Any], text: str, side: str = "right", at: int = -1, **style: str) -> None:
    """Write the name of a line beside it, in its colour, instead of a legend.

    Parameters
    ----------
    lines : sequence with one line
        What the ``plot`` of Matplotlib returns.
    text : str
        The name.
    side : str
        Where: left, right, above or below; above left or below right of a line that rises.
    at : int
        Beside which of the points of the line; without it, the last one.
    **style : str
        More about the letters, as Matplotlib names it.

    Examples
    --------
    ``named(panel.plot(points, counts), "matrix", "above")``
    """
    (line,) = lines
    line.axes.annotate(
        text,
        line.get_xydata()[at],
        textcoords="offset points",
        color=line.get_color(),
        **SIDES[side] | style,
    )


def agree(found: npt.ArrayLike, expected: npt.ArrayLike, within: float) -> Statement:
    """State that two arrays agree, or fail.

    The statement gives a bound, not the difference itself, whose last digits depend on the machine.

    Parameters
    ----------
    found, expected : array_like
        Arrays of one shape.
    within : float
        The largest difference allowed in any entry.

    Returns
    -------
    Statement
        How many numbers were compared and the bound.

    Raises
    ------
    ValueError
        If the shapes differ.
    AssertionError
        If an entry differs by more than the bound; the message says by how much.

    Examples
    --------
    >>> agree([1.0, 2.0], [1.0, 2.0 + 1e-16], within=1e-15)
    2 numbers agree within 1e-15
    """
    found, expected = np.asarray(found, float), np.asarray(expected, float)
    if found.shape != expected.shape:
        raise ValueError(
            f"found and expected must have one shape; got {found.shape} and {expected.shape}"
        )
    residual = np.abs(found - expected).max(initial=0)
    # A comparison that NaN fails, too.
    if not residual <= within:
        raise AssertionError(f"expected a residual of at most {within:.0e}, got {residual:.1e}")
    return Statement(f"{found.size:,} numbers agree within {within:.0e}")


def stored_benchmark() -> dict[str, Any]:
    """Read what ``benchmarks/run.py --store`` last wrote.

    Returns
    -------
    dict
        ``date``, ``machine``, ``versions``, ``nanoseconds a point`` by group and name,
        ``operations`` and ``ratios``.

    Examples
    --------
    >>> stored_benchmark()["nanoseconds a point"]["one point"].keys()
    dict_keys(['matrix @ point', 'scipy, Rotation.apply', 'transform'])
    """
    results = Path(__file__).with_name("benchmark.json").read_text(encoding="utf-8")
    found: dict[str, Any] = json.loads(results)
    return found
