"""Scenes of page C: an arm and its skin, and the smallest turn from a direction to another."""

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.colors import AXIS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Choice, Handles, Slider
from rotedu.scenes.looks import Arrow, Ball, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import LITTLE, add_sphere, new_scene
from rotedu.scenes.shapes import stripes, teaspoon

__all__ = ["from_a_to_b", "the_arm", "the_wrist"]

ELBOW, WRIST = 1.7, 3.0
BANDS = (0.45, 0.45)
"""How far from elbow and wrist two bones move the skin."""
PROFILE = np.array(
    [
        # Along the arm, half as wide, half as thick.
        (0.0, 0.02, 0.02),
        (0.05, 0.2, 0.2),
        (0.2, 0.3, 0.3),
        (0.8, 0.34, 0.34),
        (1.7, 0.28, 0.28),
        (2.2, 0.29, 0.29),
        (3.0, 0.22, 0.22),
        (3.45, 0.25, 0.18),
        (3.8, 0.34, 0.15),
        (4.2, 0.27, 0.12),
        (4.36, 0.15, 0.08),
        (4.4, 0.02, 0.02),
    ]
)
STATIONS = np.unique([*np.linspace(0, 4.4, 61).round(3), 0.02, WRIST, 4.385])


def radii() -> NDArray[np.float64]:
    """Smooth the profile at the stations, shape (n, 2): each is a mean of places near it."""
    near = np.clip(STATIONS + np.linspace(-0.2, 0.2, 9)[:, np.newaxis], 0, 4.4)
    means = [np.interp(near, PROFILE[:, 0], PROFILE[:, k]).mean(axis=0) for k in (1, 2)]
    smooth = np.stack(means, axis=1).round(4)
    smooth[[0, -1]] = PROFILE[0, 1:]
    return smooth


ARM = {
    "rings": np.column_stack([STATIONS, radii()]).tolist(),
    "elbow": ELBOW,
    "wrist": WRIST,
    "bands": BANDS,
    "half": "half a turn apart: the average could go either way",
}
SKIN = {"smooth_shading": True, "pickable": False}
PALE = "#8fc1e3"
SKINS = ("matrices, averaged", "the same, repaired", "dual quaternions")
LOOKS: dict[str, Look] = {
    "one half": Mesh(stripes, VECTOR, SKIN),
    "other half": Mesh(stripes, PALE, SKIN),
    "way": Lines(RESULT, 0.02),
    "vertex": Ball(RESULT, 0.07),
}


@explorable(
    small=True,
    answer={"twist": 170},
    constants=ARM,
    twist=Slider(0, 360, "the hand is turned by, °", step=1, plays=8, start=0),
)
def the_wrist(state: State) -> pyvista.Plotter:
    """Draw a forearm with a hand that turns, and its skin by averaged matrices.

    Parameters
    ----------
    twist : float
        How far the hand is turned about the forearm, in degrees.
    """
    plotter = new_scene((3.3, -6, 2.2), (3.3, 0, 0), view_angle=10.5, size=LITTLE)
    draw(plotter, state, LOOKS)
    read_out(plotter, "wrist", "wrist as thick as", 0, "%", where="picture")
    describe(
        plotter,
        f"A striped forearm with a hand, turned by {state['inputs']['twist']:.0f} degrees. Between"
        f" them the skin is twisted, and {state['outputs']['wrist']:.0f} per cent as thick as"
        " before.",
    )
    return plotter


@explorable(
    tries={
        "a door handle": {"skin": SKINS[0], "twist": 170, "bend": 20},
        "the same, repaired": {"skin": SKINS[1], "twist": 170, "bend": 80},
        "an elbow that bulges": {"skin": SKINS[2], "twist": 0, "bend": 120},
        "past half a turn": {"skin": SKINS[2], "twist": 200, "bend": 20},
    },
    constants=ARM,
    skin=Choice("The skin by", SKINS, start=SKINS[0]),
    twist=Slider(0, 360, "hand turned by, °", step=1, stride=10, plays=8, start=0),
    bend=Slider(0, 140, "elbow bent by, °", step=1, stride=10, start=20),
)
def the_arm(state: State) -> pyvista.Plotter:
    """Draw an arm of three bones, whose skin is moved by averages of their poses.

    Parameters
    ----------
    skin : str
        How the poses of two bones are averaged: one of `SKINS`.
    twist, bend : float
        How far the hand is turned and the elbow bent, in degrees.
    """
    plotter = new_scene((2.1, -13, 3.4), (2.15, 0, 1.1), view_angle=15.5, size=(720, 440))
    draw(plotter, state, LOOKS, {"bend": Text(NEUTRAL, "elbow")})
    read_out(plotter, "wrist", "wrist as thick as", 0, "%", where="picture")
    read_out(plotter, "volume", "skin encloses", 1, "%")
    describe(
        plotter,
        f"A striped arm, its elbow bent by {state['inputs']['bend']:.0f} degrees and its hand"
        f" turned by {state['inputs']['twist']:.0f}. By {state['inputs']['skin']}, the wrist is"
        f" {state['outputs']['wrist']:.0f} per cent as thick as at rest. A green point of the"
        " skin, on the wrist, has left its path.",
    )
    return plotter


@explorable(
    tries={
        "a quarter turn": {"a": [1, 0, 0], "b": [0, 1, 0]},
        "almost opposite": {"a": [1, 0, 0], "b": [-0.99, 0.1, 0.1]},
        "from the other side": {"a": [1, 0, 0], "b": [-0.99, 0.1, -0.1]},
    },
    constants={"beside": [2.3, 0, 0]},
    a=Handles("a", start=(0.832, -0.49, 0.26)),
    b=Handles("b", start=(0.2, 0.84, 0.505)),
)
def from_a_to_b(state: State) -> pyvista.Plotter:
    """Draw the smallest turn from a direction to another, and what it does to a spoon.

    Parameters
    ----------
    a, b : array_like, shape (3,)
        The directions.
    """
    stack = (44, 10, 370, 380, 1), (385, 60, 300, 280, 0.8)
    plotter = new_scene((1, -9, 3), (1, 0, 0), view_angle=18, size=(720, 400), stack=stack)
    spoon = teaspoon(stations=61, around=20)
    looks: dict[str, Look] = {
        "arc": Lines(RESULT, 0.014),
        "axis": Arrow(AXIS),
        "a": Arrow(VECTOR),
        "b": Arrow(RESULT),
        "tip a": Ball(VECTOR, 0.05),
        "tip b": Ball(RESULT, 0.05),
        "spoon before": Mesh(spoon, NEUTRAL, SKIN | {"opacity": 0.35}),
        "spoon after": Mesh(spoon, VECTOR, SKIN),
    }
    texts = {
        "a": Text(VECTOR, r"$\hat a$"),
        "b": Text(RESULT, r"$\hat b$"),
        "v": Text(AXIS, r"$\hat v$"),
    }
    add_sphere(plotter)
    draw(plotter, state, looks, texts)
    read_out(plotter, "angle", "turned by", 1, "°", where="picture")
    read_out(plotter, "share", "1/(1 + *c*)", 2)
    describe(
        plotter,
        "A see-through ball with a blue arrow a and a green arrow b, the arc between their tips,"
        f" and the axis of the smallest turn from a to b, by {state['outputs']['angle']:.0f}"
        " degrees. Beside it, a grey spoon that points along a, and the same, turned, along b.",
    )
    return plotter
