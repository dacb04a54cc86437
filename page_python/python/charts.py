"""Draws the charts of a cell as the notebook does, for a page: the backend of its Matplotlib."""

import io
from typing import Any

from matplotlib import pyplot
from matplotlib.backends.backend_svg import FigureCanvas, FigureManager

from rotedu.edition.drawing import inlined

__all__ = ["FigureCanvas", "FigureManager", "show", "taken"]
DRAWN: list[str] = []
# How many signs all charts of a cell may have: a page with more stands still.
MOST = 4_000_000


def show(*_: Any, **__: Any) -> None:
    """Draw what is to be shown, and close it."""
    for number in pyplot.get_fignums():
        file = io.StringIO()
        with pyplot.rc_context({"svg.fonttype": "none"}):
            pyplot.figure(number).savefig(file, format="svg", bbox_inches="tight")
        DRAWN.append(file.getvalue())
    pyplot.close("all")


def taken(name: str) -> list[str]:
    """Return what has been drawn, as elements of a page whose ids begin with a name."""
    try:
        show()
        if (size := sum(map(len, DRAWN))) > MOST:
            raise ValueError(
                f"charts of {size / 1e6:.1f} MB would stop the page, which takes {MOST / 1e6:.0f};"
                " draw fewer points, or pass rasterized=True"
            )
        return [inlined(drawing, f"{name}-{i}") for i, drawing in enumerate(DRAWN)]
    finally:
        drop()


def drop() -> None:
    """Forget what has been drawn, and what could be."""
    pyplot.close("all")
    DRAWN.clear()
