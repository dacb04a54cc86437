"""Scene of page A: a spoon that spins, followed in three ways."""

import numpy as np
import pyvista

from rotedu.colors import AXIS, MATRIX, NEUTRAL, QUATERNION, RESULT
from rotedu.figures import State, describe, draw_chart, explorable, read_out
from rotedu.figures.inputs import Handles, Slider, Switch
from rotedu.scenes.looks import Arrow, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import new_scene
from rotedu.scenes.shapes import teaspoon

__all__ = ["spinning_by_hand"]

SECONDS = 1.5
EDGE = 0.85
EYE = 30 * np.array([0.3, -0.88, 0.36])
ACROSS = np.cross([0, 0, 1], EYE) / np.linalg.norm(EYE[:2])
MIDDLE = 2.33 * ACROSS - 0.04 * np.cross(EYE, ACROSS) / np.linalg.norm(EYE)
INKS = {"exponential": RESULT, "Euler, matrix": MATRIX, "Euler, quaternion": QUATERNION}
IN_SPACE = (-0.15, 0.17, 0.97)
IN_BODY = (-0.73, -0.53, 0.43)


@explorable(
    tries={
        "a fine step": {"h": 0.02},
        "repaired after every step": {"repair": True},
        "both arrows alike": {"body": IN_SPACE},
        "the opposite arrow": {"body": tuple(-x for x in IN_SPACE)},
    },
    constants={"seconds": SECONDS, "edge": EDGE, "longest": "edge up to ", "aside": "° wrong"},
    space=Handles("arrow fixed in space", reach=0.85, through=True, start=IN_SPACE),
    body=Handles("arrow fixed in the body", reach=0.85, through=True, start=IN_BODY),
    h=Slider(0.01, 0.1, "step in seconds", step=0.01, start=0.1),
    t=Slider(0, SECONDS, "time in seconds", step=0.01, stride="h", plays=6, start=SECONDS),
    repair=Switch("repair after every step: nearest rotation, quaternion of norm 1", start=False),
)
def spinning_by_hand(state: State) -> pyvista.Plotter:
    """Draw a spoon that turns by two velocities at once, as three integrators see it.

    One velocity is fixed in space, the other in the body: R' = [omega] R + R [Omega].

    Parameters
    ----------
    space, body : array_like, shape (3,)
        The axes of the velocities, in the fixed frame and in the body's; they are normalised.
        About each the spoon turns by 90 degrees a second.
    h : float
        The step in seconds.
    t : float
        The time, from 0 to 1.5 seconds.
    repair : bool
        Whether the matrix is replaced by the nearest rotation, and the quaternion by one of norm 1,
        after every step.
    """
    # From far away, so that what is drawn in three places looks the same.
    stack = (0, 22, 262, 270, 0.74), (253, 6, 467, 286, 1)
    plotter = new_scene(
        MIDDLE + EYE, MIDDLE, view_angle=5.885, size=(720, 292), swing=20, stack=stack
    )
    spoon = teaspoon(stations=61, around=20)
    spoon.points = EDGE / 2 * spoon.points
    arrows = {name: Arrow(AXIS, 0.02) for name in ("space", "body")}
    draw(plotter, state, arrows, dict.fromkeys(arrows, Text(AXIS, "{}")))
    for name, ink in INKS.items():
        looks: dict[str, Look] = {
            f"exact, {name}": Lines(NEUTRAL, 0.007),
            f"box, {name}": Lines(ink, 0.012),
            name: Mesh(spoon, ink),
            f"way, {name}": Lines(ink, 0.014),
        }
        draw(plotter, state, looks, {name: Text(ink, "{}")})
        read_out(plotter, name, name, where="picture", color=ink)
    for chart, y, text in (
        ("longest", (1, 2.5), "longest edge"),
        ("off", (0, 20), "degrees wrong"),
    ):
        draw_chart(plotter, chart, over="t", x=(0, SECONDS), y=y, label=text, colors=INKS)
    describe(
        plotter,
        "Three teaspoons in wire boxes have turned for the same time by two velocities, which two"
        " orange arrows show: one is fixed in space, one turns with the spoon. By the exponential,"
        " in green, the box is still a cube. By Euler's step on the matrix, in ochre, it is askew"
        " and much too large, and by Euler's step on the quaternion, in violet, a cube, but too"
        " large. Lines show the ways of the spoons' tips, which lead outwards in ochre and violet.",
    )
    return plotter
