"""Figures that answer the hand: a function that draws a scene, and what of it can be changed.

A figure with sliders alone needs no code for the page: its frames are computed here, for a page in
advance and for a notebook when they are wanted. A figure with handles names a model, a function of
the viewer that computes the same frames from the same inputs while a point is dragged.
"""

import base64
import inspect
import io
import itertools
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any, TypeVar

import numpy as np
import pyvista

from rotedu.figures.backend import book_figure, still_picture
from rotedu.figures.frames import WHOLE, differences, frame_of, only, shown
from rotedu.figures.inputs import Input, Slider
from rotedu.figures.panel import panel

# Frames of a page for one slider, and for each of two.
FRAMES = {1: 73, 2: 11}
Scene = Callable[..., pyvista.Plotter]
Function = TypeVar("Function", bound=Scene)


def explorable(
    model: str = "",
    constants: Mapping[str, Any] | None = None,
    tries: Mapping[str, Mapping[str, Any]] | None = None,
    **inputs: Input,
) -> Callable[[Function], Function]:
    """Declare what the hand can change in the scene of a function.

    Parameters
    ----------
    model : str
        Name of the viewer's model that computes the same frames. Without one, the frames come from
        the function itself.
    constants : mapping, optional
        Colours and texts that the model cannot know, as JSON holds them. The model gets them with
        the inputs.
    tries : mapping, optional
        What to try, in a few words each, and the values of the inputs that show it; all others are
        as at the start.
    **inputs
        What can be changed: arguments of the function.

    Returns
    -------
    callable
        A decorator, which leaves the function as it is.
    """

    def declare(function: Function) -> Function:
        vars(function).update(
            inputs=inputs, model=model, constants=constants or {}, tries=tries or {}
        )
        return function

    return declare


def explore(function: Scene, **sliders: Slider | tuple[float, float]) -> "Exploration":
    """Show the scene of a function with controls for its arguments.

    Parameters
    ----------
    function : callable
        Returns a scene for any values of the arguments to be changed. All scenes have the same
        parts and labels, by name; points, colours, matrices and places may differ.
    **sliders
        Arguments to be changed by a slider: the bounds, or a `Slider`. By default, the inputs that
        the function has declared by `explorable`.

    Returns
    -------
    Exploration
        The figure. Each input is an attribute, which follows what the reader does and can be set.

    Raises
    ------
    ValueError
        If there is nothing to change, if an argument has a name that every figure has, such as
        ``start``, or if the scenes differ in more than places and colours.

    Examples
    --------
    >>> from rotedu import scenes
    >>> figure = explore(scenes.figure_2, t=(0, 1))
    >>> figure.t
    0.3
    >>> figure.t = 0.5
    """
    inputs = dict(getattr(function, "inputs", {}))
    for name, bounds in sliders.items():
        inputs[name] = bounds if isinstance(bounds, Slider) else Slider(*bounds)
    if not getattr(function, "model", ""):
        inputs = {name: on_grid(kind, len(inputs)) for name, kind in inputs.items()}
    if not inputs:
        raise ValueError(f"{function.__name__}: expected at least one input, got none")
    return Exploration(function, inputs)


def on_grid(kind: Input, sliders: int) -> Input:
    """Let a slider without a step of its own go from one frame of a page to the next."""
    if isinstance(kind, Slider) and not kind.step and sliders in FRAMES:
        return replace(kind, step=(kind.high - kind.low) / (FRAMES[sliders] - 1))
    return kind


class Exploration:
    """A figure that answers the hand; its inputs are attributes.

    Parameters
    ----------
    function : callable
        Draws the scene.
    inputs : dict
        What can be changed.
    start : dict, optional
        Values of the inputs to start from, in place of the function's defaults.
    """

    def __init__(
        self, function: Scene, inputs: dict[str, Input], start: dict[str, Any] | None = None
    ) -> None:
        defaults = inspect.signature(function).parameters
        given = start or {name: defaults[name].default for name in inputs}
        start = {name: kind.value(name, given[name]) for name, kind in inputs.items()}
        # These are no inputs, so they go past __setattr__.
        vars(self).update(
            function=function,
            model=getattr(function, "model", ""),
            title=function.__name__.replace("_", "-"),
            inputs=inputs,
            start=start,
            values=dict(start),
            varying=set(),
            widgets=[],
        )
        own = sorted(name for name in super().__dir__() if not name.startswith("_"))
        for name in inputs:
            if name in own:
                raise ValueError(f"{name}: expected a name other than {', '.join(own)}, got {name}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.inputs]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self.inputs:
            raise AttributeError(f"{name}: expected one of {', '.join(self.inputs)}")
        value = self.values[name]
        return np.array(value) if isinstance(value, list) else value

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in self.inputs:
            raise AttributeError(f"{name}: expected one of {', '.join(self.inputs)}")
        self.values[name] = self.inputs[name].value(name, value)
        for widget in self.widgets:
            widget.values = dict(self.values)

    def __repr__(self) -> str:
        return f"<figure: {self.function.__name__}, {', '.join(self.inputs)}>"

    def draw(self, **values: Any) -> pyvista.Plotter:
        """Draw the scene for the present values of the inputs, or for others."""
        plotter: pyvista.Plotter = self.function(**self.values | values)
        return plotter

    def frame(self, **values: Any) -> dict[str, Any]:
        """Compute what has changed since the start, for the present values or for others."""
        frame = frame_of(self.draw(**values))
        self.varying.update(differences(self.base, frame))
        return only(frame, self.varying)

    @cached_property
    def base(self) -> dict[str, Any]:
        """The frame of the scene at the start."""
        return frame_of(self.draw(**self.start))

    def spec(self, plotter: pyvista.Plotter) -> dict[str, Any]:
        """Describe the figure to the viewer.

        Parameters
        ----------
        plotter : pyvista.Plotter
            The scene at the start.

        Returns
        -------
        dict
            What JSON can hold: the ``name``, the ``inputs`` and their values at the ``start``, the
            ``model`` with its ``constants``, and the ``frame`` that it must reproduce. Without a
            model, ``grid`` lists each input with its number of frames; `frames` computes them, the
            last input changing first.
        """
        recorded = shown(plotter)
        moving: set[tuple[str, ...]] = {
            ("parts", name, key)
            for name, place in recorded.parts.items()
            for key in (*place, "color", "hidden")
            if key != "radius"
        }
        base = frame_of(plotter)
        moving |= {(kind, name) for kind in WHOLE for name in base[kind]}
        count = FRAMES.get(len(self.inputs), 0)
        only_slides = count and all(kind.kind == "number" for kind in self.inputs.values())
        if not (self.model or only_slides):
            raise ValueError(
                f"{self.function.__name__}: expected a model or at most two sliders,"
                f" got {', '.join(self.inputs)}"
            )
        return {
            "name": self.title,
            "inputs": {
                name: {"kind": kind.kind} | kind.spec() for name, kind in self.inputs.items()
            },
            "start": self.start,
            "model": self.model,
            "constants": getattr(self.function, "constants", {}),
            "frame": only(base, moving),
            # A list, because a notebook sorts the keys of its JSON.
            "grid": [] if self.model else [[name, count] for name in self.inputs],
        }

    def frames(self) -> list[dict[str, Any]]:
        """Compute the frames of a page, for values evenly spread over the sliders."""
        axes = [
            np.linspace(kind.low, kind.high, FRAMES[len(self.inputs)]).tolist()
            for kind in self.inputs.values()
            if isinstance(kind, Slider)
        ]
        drawn = [
            frame_of(self.draw(**dict(zip(self.inputs, point, strict=True))))
            for point in itertools.product(*axes)
        ]
        self.varying.update(*(differences(self.base, frame) for frame in drawn))
        return [only(frame, self.varying) for frame in drawn]

    def panel(self, plotter: pyvista.Plotter) -> str:
        """Write the controls, numbers and charts below the figure."""
        recorded = shown(plotter)
        tries = {
            words: {name: self.inputs[name].value(name, value) for name, value in values.items()}
            for words, values in getattr(self.function, "tries", {}).items()
        }
        return panel(self.title, self.inputs, self.start, recorded, tries)

    def widget(self) -> Any:
        """Make the figure for a notebook, joined to the values of the inputs."""
        # Loaded only where it is wanted, because anywidget may be missing.
        from rotedu.figures.widget import figure

        plotter = self.draw(**self.start)
        spec = self.spec(plotter) | {"panel": self.panel(plotter)}
        made = figure(plotter, spec=spec, values=dict(self.values))
        made.observe(self._follow, "values")
        made.on_msg(self._answer)
        self.widgets.append(made)
        return made

    def _follow(self, change: dict[str, Any]) -> None:
        """Take the values that the hand has set."""
        for name, value in change["new"].items():
            self.values[name] = self.inputs[name].value(name, value)

    def _answer(self, widget: Any, question: dict[str, Any], buffers: Any) -> None:
        """Compute the frame that a figure without a model asks for."""
        if "frame" in question:
            try:
                widget.send({"frame": self.frame(**question["frame"])})
            except ValueError as error:
                widget.send({"refused": str(error)})

    def _ipython_display_(self) -> None:
        if pyvista.global_theme.jupyter_backend != "widget":
            # IPython then asks for the formats below.
            raise NotImplementedError
        self.widget()._ipython_display_()

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> Any:
        plotter = self.draw()
        if pyvista.global_theme.jupyter_backend == "book":
            # On a page it starts as it is now.
            here = Exploration(self.function, self.inputs, self.values)
            figure = book_figure(plotter)
            spec = here.spec(plotter) | {"panel": here.panel(plotter)}
            if not self.model:
                spec["frames"] = here.frames()
            figure.scene["spec"] = spec
            return figure._repr_mimebundle_()
        picture = io.BytesIO()
        still_picture(plotter).save(picture, "PNG")
        return {
            "text/plain": repr(self),
            "image/png": base64.b64encode(picture.getvalue()).decode(),
        }
