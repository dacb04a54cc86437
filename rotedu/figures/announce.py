"""Which of the pyvista backends a notebook gets: ``book``, ``still`` or ``widget``."""

import importlib.util
from typing import Any

import pyvista
from IPython import get_ipython

from rotedu.figures.backend import book_figure, still_picture


def announce_backend() -> None:
    """Register the backend that pyvista is set to use, if it is one of ours.

    Where none is set, notebooks get figures that turn, or still pictures if nobody is there to turn
    a figure. To find a backend by name, pyvista would load all that are installed.
    """
    name = pyvista.global_theme.jupyter_backend
    shell = get_ipython()
    if name is None and hasattr(shell, "kernel"):
        # A program that runs a notebook, such as nbconvert, says that it cannot answer questions.
        request = shell.kernel.get_parent().get("content", {})
        alone = request.get("allow_stdin") is False
        name = "still" if alone or not importlib.util.find_spec("anywidget") else "widget"
    handlers: dict[str, Any] = {"book": book_figure, "still": still_picture}
    if name == "widget":
        # Loaded only where it is wanted, because anywidget may be missing.
        from rotedu.figures.widget import figure

        handlers[name] = figure
    if name is not None and name in handlers:
        pyvista.register_jupyter_backend(name, handlers[name], override=True)
        pyvista.set_jupyter_backend(name)
