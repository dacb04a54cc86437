"""What the tests of explorables share: the figures, other inputs, and what they compute."""

import functools
import importlib
import json
import os
import re
import secrets
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from bs4 import BeautifulSoup

from rotedu import scenes
from rotedu.errors import DegenerateError
from rotedu.figures import Choice, Handles, Poses, Slider, Switch
from rotedu.figures.explorable import Explorable
from rotedu.figures.model import run_node
from rotedu.figures.pages import WRITE_PANELS
from rotedu.figures.state import State
from rotedu.ordinary_rotation import rotate

EXPLORABLES = {name: f for name, f in vars(scenes).items() if hasattr(f, "inputs")}
# Set EXPLORE_SEED to the seed in a failure's message to repeat random inputs.
SEED = int(os.environ.get("EXPLORE_SEED") or secrets.randbits(32))


def expected(name: str, inputs: dict[str, Any]) -> dict[str, Any]:
    """The outputs of a figure by the function of its name in `oracles`, or how this refuses."""
    module = EXPLORABLES[name].__module__.replace("rotedu.scenes", "oracles")
    function: Callable[..., dict[str, Any]] = getattr(importlib.import_module(module), name)
    try:
        return function(**inputs)
    except DegenerateError as error:
        # A model computes one case after the other, so it has no index to tell.
        return {"refused": re.sub(r" at index \([\d, ]*\)", "", str(error))}


def states(name: str, cases: Sequence[dict[str, Any]]) -> list[State]:
    """The states of a figure, computed at once; each case changes some inputs of the start."""
    figure = Explorable(EXPLORABLES[name])
    return figure.scene.model.states([figure.start | figure.checked(case) for case in cases])


def turn_of(state: State, part: str) -> np.ndarray:
    """The matrix that turns a part."""
    return np.reshape(state["parts"][part]["matrix"], (4, 4)).T[:3, :3]


def outputs(name: str, **inputs: Any) -> dict[str, Any]:
    """The outputs of a figure."""
    [state] = states(name, [inputs])
    return state["outputs"]


def panels(cases: Sequence[tuple[str, dict[str, Any]]]) -> list[BeautifulSoup]:
    """The panels of figures for some inputs, as a page has them, written at once."""
    wanted = [
        spec(name) | {"start": spec(name)["start"] | Explorable(EXPLORABLES[name]).checked(case)}
        for name, case in cases
    ]
    written = json.loads(run_node(json.dumps(wanted), WRITE_PANELS))
    return [BeautifulSoup(html, "html.parser") for html in written]


@functools.cache
def spec(name: str) -> dict[str, Any]:
    """What the viewer is told of a figure."""
    figure = Explorable(EXPLORABLES[name])
    plotter = figure.draw()
    plotter.close()
    return figure.spec(plotter)


def moved_input(rng: np.random.Generator, kind: Any, start: Any) -> Any:
    """Another value for an input: anything but for points, which turn by up to 40 degrees."""
    if isinstance(kind, Slider):
        return float(rng.uniform(kind.low, kind.high))
    if isinstance(kind, Handles):
        points = np.array(start)
        axes = rng.normal(size=points.shape)
        return rotate(points, axes, rng.uniform(0, 0.7, points.shape[:-1])).tolist()
    if isinstance(kind, Poses):
        poses = np.array(start) + rng.normal(scale=0.3, size=np.shape(start))
        return (poses / np.linalg.norm(poses, axis=-1, keepdims=True)).tolist()
    if isinstance(kind, Switch):
        return bool(rng.integers(2))
    assert isinstance(kind, Choice)
    return str(rng.choice(kind.options))


def moved(rng: np.random.Generator, name: str) -> dict[str, Any]:
    """Other values for all inputs of a figure."""
    figure = Explorable(EXPLORABLES[name])
    return {key: moved_input(rng, kind, figure.start[key]) for key, kind in figure.inputs.items()}
