"""Figures that answer the hand: a model computes what is where, a function draws it.

The model is a function of JavaScript in the file beside the module, with the name of the function
in camel case. It is the only place where places and numbers are computed; the function says what
there is, what it looks like and what it is called.
"""

import base64
import functools
import inspect
import io
import json
import re
from collections.abc import Callable, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pyvista

from rotedu.figures.backend import book_figure, still_picture
from rotedu.figures.inputs import Input
from rotedu.figures.model import NO_NODE, Model, RefusedError, can_ask, start_of
from rotedu.figures.state import State, record_of

Scene = Callable[..., pyvista.Plotter]


def explorable(
    tries: Mapping[str, Mapping[str, Any]] | None = None,
    constants: Mapping[str, Any] | None = None,
    small: bool = False,
    answer: Mapping[str, Any] | None = None,
    **inputs: Input,
) -> Callable[[Callable[[State], pyvista.Plotter]], Scene]:
    """Make a scene of a function that draws the states of a model.

    Parameters
    ----------
    tries : mapping, optional
        What to try, in a few words each, and the values of the inputs that show it; all others are
        as at the start.
    constants : mapping, optional
        Colours and texts that the model cannot know, as JSON holds them.
    small : bool
        Whether it is a small figure: low, with one control and one number, and without a name.
    answer : mapping, optional
        The values of inputs that paper shows, where no hand can answer what the figure asks.
    **inputs
        What the hand can change.

    Returns
    -------
    callable
        A decorator. What it returns takes values of the inputs, by name, and draws their state.
    """

    def declare(draw: Callable[[State], pyvista.Plotter]) -> Scene:
        model = Model(
            Path(draw.__code__.co_filename).with_suffix(".js"),
            re.sub("_(.)", lambda letter: letter[1].upper(), draw.__name__),
            constants or {},
        )

        @functools.wraps(draw)
        def scene(**values: Any) -> pyvista.Plotter:
            state = Explorable(scene).state(**values)
            plotter = draw(state)
            refuse_what_is_not_shown(draw.__name__, state, plotter)
            return plotter

        kind = inspect.Parameter.KEYWORD_ONLY
        vars(scene).update(
            inputs=inputs,
            model=model,
            tries=tries or {},
            small=small,
            answer=answer or {},
            __signature__=inspect.Signature(
                [
                    inspect.Parameter(name, kind, default=shown_start(i.start))
                    for name, i in inputs.items()
                ]
            ),
        )
        return scene

    return declare


def shown_start(start: Any) -> Any:
    """Return what a signature shows: points and poses would fill the page of a reference."""
    return start if isinstance(start, (float, int, str)) else ...


def refuse_what_is_not_shown(name: str, state: State, plotter: pyvista.Plotter) -> None:
    """Refuse a scene that leaves out what its model computes, or a grip of no input."""
    recorded = record_of(plotter)
    for kind, shown in (
        ("parts", recorded.parts),
        ("labels", recorded.labels),
        ("outputs", recorded.outputs),
        ("charts", recorded.charts),
        ("grips", state["inputs"]),
    ):
        if missing := state.get(kind, {}).keys() - shown.keys():
            raise ValueError(f"{name}: the scene has no {kind} for {sorted(missing)} of its model")


def explore(scene: Scene) -> "Explorable":
    """Show a scene with controls for its inputs.

    Parameters
    ----------
    scene : callable
        What `explorable` has made.

    Returns
    -------
    Explorable
        The figure. Each input is an attribute, which follows what the reader does and can be set.

    Raises
    ------
    ValueError
        If the scene is not an explorable.

    Examples
    --------
    >>> from rotedu import scenes
    >>> figure = explore(scenes.spinning_by_hand)
    >>> figure.h
    0.1
    >>> figure.h = 0.02
    """
    if not hasattr(scene, "inputs"):
        name = getattr(scene, "__name__", repr(scene))
        raise ValueError(f"scene: expected one that `explorable` has made, got {name}")
    return Explorable(scene)


class Explorable:
    """A figure that answers the hand; its inputs are attributes."""

    def __init__(self, scene: Any) -> None:
        start = {name: kind.value(name, kind.start) for name, kind in scene.inputs.items()}
        # These are not inputs, so they go past __setattr__.
        vars(self).update(
            scene=scene,
            title=scene.__name__.replace("_", "-"),
            inputs=scene.inputs,
            start=start,
            values=dict(start),
            widgets=[],
        )
        own = sorted(name for name in super().__dir__() if not name.startswith("_"))
        for name in scene.inputs.keys() & own:
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
        self.values.update(self.checked({name: value}))
        for widget in self.widgets:
            widget.values = dict(self.values)

    def __repr__(self) -> str:
        return f"<figure: {self.scene.__name__}, {', '.join(self.inputs)}>"

    def checked(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Check values of inputs, by name."""
        for name in values.keys() - self.inputs.keys():
            raise TypeError(f"{name}: expected one of {', '.join(self.inputs)}")
        return {name: self.inputs[name].value(name, value) for name, value in values.items()}

    def state(self, **values: Any) -> State:
        """Compute what the model says for the present values of the inputs, or for others.

        Raises
        ------
        RefusedError
            If the model refuses the values.
        RuntimeError
            If there is no Node, and this is not how the figure starts.
        """
        wanted = self.values | self.checked(values)
        state: State
        if can_ask(self.scene.model.file):
            [state] = self.scene.model.states([wanted])
        elif wanted == self.start:
            state = start_of(self.title)
        else:
            raise RuntimeError(NO_NODE.format(self.title))
        if "refused" in state:
            raise RefusedError(state["refused"])
        return state | {"inputs": wanted | state.get("inputs", {})}

    def draw(self, **values: Any) -> pyvista.Plotter:
        """Draw the scene for the present values of the inputs, or for others."""
        plotter: pyvista.Plotter = self.scene(**self.values | values)
        return plotter

    def spec(self, plotter: pyvista.Plotter) -> dict[str, Any]:
        """Describe the figure to the viewer, which writes its panel and moves its parts."""
        recorded = record_of(plotter)
        return {
            "name": self.title,
            "inputs": {name: kind.spec() for name, kind in self.inputs.items()},
            "start": self.start,
            "model": self.scene.model.name,
            "constants": self.scene.model.constants,
            "outputs": [{"name": name} | asdict(o) for name, o in recorded.outputs.items()],
            "charts": [
                {"name": name} | asdict(c) | {"ticks": list(c.ticks.items())}
                for name, c in recorded.charts.items()
            ],
            "tries": [[words, self.checked(v)] for words, v in self.scene.tries.items()],
            "small": self.scene.small,
        }

    def widget(self) -> Any:
        """Make the figure for a notebook, joined to the values of the inputs."""
        # Loaded only where it is wanted, because anywidget may be missing.
        from rotedu.figures.widget import figure_of

        plotter = self.draw(**self.start)
        made = figure_of(plotter, spec=self.spec(plotter), values=dict(self.values))
        made.observe(self._follow, "values")
        self.widgets.append(made)
        return made

    def _follow(self, change: dict[str, Any]) -> None:
        """Take the values that the hand has set."""
        self.values.update(self.checked(change["new"]))

    def _ipython_display_(self) -> None:
        if pyvista.global_theme.jupyter_backend != "widget":
            # IPython then asks for the formats below.
            raise NotImplementedError
        self.widget()._ipython_display_()

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> Any:
        plotter = self.draw()
        if pyvista.global_theme.jupyter_backend == "book":
            figure = book_figure(plotter)
            # On a page it starts as it is now. Of all but a text a notebook sorts the keys.
            figure.scene["spec"] = json.dumps(self.spec(plotter) | {"start": self.values})
            if self.scene.answer:
                answer = book_figure(self.draw(**self.scene.answer))
                figure.scene["answer"] = answer.content() | {"gltf": ""}
            return figure._repr_mimebundle_()
        picture = io.BytesIO()
        still_picture(plotter).save(picture, "PNG")
        return {
            "text/plain": repr(self),
            "image/png": base64.b64encode(picture.getvalue()).decode(),
        }
