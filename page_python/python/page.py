"""Runs the cells of a page: one namespace, text as output, errors cut to the reader's own lines.

`run` is all that page_python/worker.js calls.
"""

import builtins
import ctypes
import functools
import importlib
import io
import json
import linecache
import re
import sys
import time
import traceback
import types
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from typing import Any

import absent
import numpy as np
from absent import Absent, NotInPage
from pyodide.code import eval_code

absent.announce()
# Python 3.12 counts calls within C by themselves, up to 10,000: more than a browser's stack holds.
# This is c_recursion_remaining of its thread.
ctypes.c_int.from_address(ctypes.pythonapi.PyThreadState_Get() + 24).value = 1000
# Nobody compiles Fortran here, but ``from numpy import *`` asks for it.
np.f2py = None
# What draws; the figures of the page are there already.
for name, functions in {
    "announce": ["announce_backend"],
    "backend": ["book_figure", "describe", "still_picture"],
    "gltf": ["part_names", "surface_of"],
}.items():
    module = sys.modules[f"rotedu.figures.{name}"] = types.ModuleType(name)
    vars(module).update(dict.fromkeys(functions, lambda *_, **__: None))

import pyvista

from rotedu import scenes
from rotedu.edition import exercises

# The package has a function with the name of this module.
explorable = importlib.import_module("rotedu.figures.explorable")

# How many characters a cell may show.
MOST = 100_000
# How deep calls may go; a cell that has set more could end Python with the next.
DEEPEST = 1000
# Seconds between two messages while a cell prints.
PAUSE = 0.1
# Commands of notebooks: those that say how pictures are drawn, and all others.
IDLE = re.compile(r"^%(config|matplotlib)\b.*$", re.MULTILINE)
COMMAND = re.compile(r"^[%!]\S*", re.MULTILINE)
NAMESPACE: dict[str, Any] = {"__name__": "__main__"}
# What each figure of the page shows, by its name; what a cell has changed of it; and its verdicts.
FIGURES: dict[str, dict[str, Any]] = {}
CHANGED: dict[str, dict[str, Any]] = {}
VERDICTS: list[exercises.Verdict] = []


class PageFigure(explorable.Explorable):
    """A figure of the page: what the hand has set is in it, and what Python sets is shown there."""

    def __init__(self, scene: Callable[..., Any]) -> None:
        super().__init__(scene)
        if self.title not in FIGURES:
            raise NotInPage(f"A figure of scenes.{scene.__name__}")
        vars(self)["values"] = FIGURES[self.title]
        for name, value in self.start.items():
            self.values.setdefault(name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, value)
        CHANGED.setdefault(self.title, {})[name] = self.values[name]


def undrawn(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a scene that leaves drawing to the page."""

    @functools.wraps(function)
    def scene(*_: Any, **__: Any) -> pyvista.Plotter:
        return pyvista.Plotter()

    return scene


def noted(check: Callable[..., exercises.Verdict]) -> Callable[..., exercises.Verdict]:
    """Return a check whose verdicts the page hears."""

    @functools.wraps(check)
    def noting(*arguments: Any, **options: Any) -> exercises.Verdict:
        VERDICTS.append(check(*arguments, **options))
        return VERDICTS[-1]

    return noting


for name in scenes.__all__:
    function = getattr(scenes, name)
    if getattr(function, "__annotations__", {}).get("return") is pyvista.Plotter:
        setattr(scenes, name, undrawn(function))
explorable.Explorable = PageFigure
exercises.check = noted(exercises.check)
builtins.input = Absent("input()")


class Printed(io.TextIOBase):
    """What a cell prints: shown meanwhile, and cut where it becomes too long."""

    def __init__(self, tell: Callable[[str], Any]) -> None:
        self.tell, self.told = tell, time.monotonic()
        self.text, self.room = [""], MOST

    def write(self, text: str) -> int:
        """Keep a text."""
        if self.room > 0:
            self.text.append(text[: self.room])
            if (now := time.monotonic()) > self.told + PAUSE:
                self.told = now
                self.tell(str(self))
        self.room -= len(text)
        return len(text)

    def __str__(self) -> str:
        return "".join(self.text) + "\n(cut here: it is longer)" * (self.room < 0)


def cut(text: str) -> str:
    """Return as much of a text as a page shows."""
    return text if len(text) <= MOST else f"{text[:MOST]}\n(cut here: it is longer)"


def shown(value: Any) -> tuple[str, str]:
    """Return the text of a value, and what it is: text, markdown or nothing to show."""
    if value is None or isinstance(value, pyvista.Plotter | PageFigure):
        return "", ""
    if hasattr(value, "_repr_markdown_"):
        return cut(value._repr_markdown_()), "markdown"
    return cut(repr(value)), "text"


def told(error: BaseException) -> str:
    """Return an error with the reader's own lines alone."""
    report = traceback.TracebackException.from_exception(error)
    own = [frame for frame in report.stack if frame.filename.startswith("Cell ")]
    report.stack = traceback.StackSummary.from_list(own)
    report.__cause__ = report.__context__ = None
    return cut("".join(report.format()))


def charts_of(name: str) -> list[str]:
    """Return the charts that a cell has drawn, as SVG; none stays for the next one."""
    charts = sys.modules.get("charts")
    return charts.taken(name.replace(" ", "-")) if charts else []


def run_cell(code: str, name: str) -> dict[str, Any]:
    """Run a cell; return its value as text, what this is, and an error if there is one."""
    done = {"value": "", "kind": "", "error": "", "charts": []}
    try:
        linecache.cache[name] = (len(code), None, code.splitlines(keepends=True), name)
        code = IDLE.sub("", code)
        if command := COMMAND.search(code):
            raise NotInPage(command[0])
        value = eval_code(code, NAMESPACE, filename=name)
        done["value"], done["kind"] = shown(value)
        done["charts"] = charts_of(name)
    except BaseException as error:
        if charts := sys.modules.get("charts"):
            charts.drop()
        done["kind"], done["error"] = type(error).__name__, told(error)
    return done


def run(code: str, name: str, figures: str, tell: Callable[[str], Any]) -> str:
    """Run a cell of the page.

    Parameters
    ----------
    code, name : str
        The cell, and what errors call it: ``Cell 12``.
    figures : str
        JSON: what each figure of the page shows, by name; nothing yet if nobody has touched it.
    tell : callable
        Takes the whole text printed so far.

    Returns
    -------
    str
        JSON: ``out``, ``value``, ``kind`` and ``error`` as text, ``charts`` as SVG, ``changed``
        with the inputs of figures that the cell has set, and ``verdict``, the last of its checks.
    """
    for figure, values in json.loads(figures).items():
        FIGURES.setdefault(figure, {}).update(values)
    CHANGED.clear()
    VERDICTS.clear()
    sys.setrecursionlimit(DEEPEST)
    out = Printed(tell)
    with redirect_stdout(out), redirect_stderr(out):
        done = run_cell(code, name)
    verdict = vars(VERDICTS[-1]) if VERDICTS else None
    return json.dumps(done | {"out": str(out), "changed": CHANGED, "verdict": verdict})


def start() -> None:
    """Forget all names, styles and figures."""
    absent.STYLES.clear()
    FIGURES.clear()
    NAMESPACE.clear()
    NAMESPACE["__name__"] = "__main__"
