"""Scenes of page D: a turn past half a turn in a ball, and a thread that is pulled tight."""

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Poses, Slider
from rotedu.quaternions import Quaternion
from rotedu.scenes.looks import Ball, Lines, Look, Mesh, Text, draw, spoon_in
from rotedu.scenes.parts import LITTLE, add_shadow, add_sphere, new_scene
from rotedu.scenes.shapes import teaspoon

__all__ = ["one_name", "pull_the_thread"]

TABLE = (-2.5, 0, 0)
KEPT = 40


def wobbling(turns: float) -> NDArray[np.float64]:
    """Return places of a thread, shape (40, 4), of a spoon that wobbles as it turns."""
    t = np.linspace(0, turns, KEPT)
    axes = np.stack(
        [0.9 * np.cos(1.3 * t), 0.9 * np.sin(2.4 * t) + 0.4, 0.6 + 0.4 * np.cos(5 * t)], axis=-1
    )
    q: NDArray[np.float64] = Quaternion.from_axis_angle(axes, 2 * np.pi * t).components
    return q


def left_by(turns: float, pulled: float = 0) -> dict[str, object]:
    """Return what the hand has set after so many turns."""
    thread = wobbling(turns).tolist()
    return {"thread": thread, "spoon": thread[-1], "pulled": pulled}


@explorable(
    small=True,
    answer={"angle": 200},
    angle=Slider(0, 360, "turned about U, °", step=1, plays=8, start=150),
)
def one_name(state: State) -> pyvista.Plotter:
    """Draw a spoon that turns about U, and where the one name of its turn lies in a ball.

    Parameters
    ----------
    angle : float
        The angle in degrees.
    """
    plotter = new_scene((2.2, -9, 2.48), (0.1, 0, -0.12), view_angle=16.5, size=LITTLE)
    add_sphere(plotter, (1.3, 0, 0))
    spoon = Mesh(teaspoon(stations=61, around=20), VECTOR, {"smooth_shading": True})
    looks: dict[str, Look] = {
        "spoon": spoon,
        "axis": Lines(AXIS, 0.008),
        "gone": Lines(RESULT, 0.016),
        "name": Ball(RESULT, 0.07),
        "middle": Ball(NEUTRAL, 0.04),
    }
    draw(plotter, state, looks, {"name": Text(RESULT)})
    read_out(plotter, "q", "turned; *w*, *x*", where="picture")
    describe(
        plotter,
        f"A spoon, turned by {state['inputs']['angle']:.0f} degrees about its length. Beside it, a"
        " see-through ball, in which a green point lies on the axis as far out as the angle is"
        " large. Up to half a turn it goes out on one side; beyond, it comes in on the other.",
    )
    return plotter


@explorable(
    tries={
        "home, once through the skin": left_by(1),
        "pulled tight": left_by(1, pulled=1),
        "home, twice through the skin": left_by(2),
        "and pulled tight": left_by(2, pulled=1),
    },
    spoon=Poses("the spoon", start=tuple(wobbling(0.2)[-1])),
    thread=Poses([f"place {k}" for k in range(1, KEPT + 1)], start=tuple(wobbling(0.2))),
    pulled=Slider(0, 1, "pull the thread", step=0.01, stride=0.25, plays=6, start=0),
)
def pull_the_thread(state: State) -> pyvista.Plotter:
    """Draw a spoon and the thread that its turns have left in the ball of turns.

    Parameters
    ----------
    spoon : array_like, shape (4,)
        The quaternion of the spoon, turned by hand.
    thread : array_like, shape (40, 4)
        Where the spoon has been; the last place is repeated.
    pulled : float
        How far the thread is pulled tight, from 0 to 1.
    """
    stack = (372, 20, 330, 340, 1), (20, 60, 330, 250, 0.6)
    plotter = new_scene(
        (0.4, -9, 3), (-1.25, 0, -0.05), view_angle=17.5, size=(720, 380), swing=20, stack=stack
    )
    looks: dict[str, Look] = {
        "at the start": spoon_in(NEUTRAL, 0.25),
        "spoon": spoon_in(VECTOR),
        "even": Lines(RESULT, 0.022),
        "odd": Lines(CROSS, 0.022),
        "middle": Ball(NEUTRAL, 0.035),
        "even end": Ball(RESULT, 0.06),
        "odd end": Ball(CROSS, 0.06),
    }
    add_sphere(plotter)
    draw(plotter, state, looks, {"middle": Text(text="no turn")})
    add_shadow(plotter, "spoon", TABLE, 1, 0.9)
    read_out(plotter, "crossings", "through the skin", 0, where="picture")
    read_out(plotter, "degrees", "length of the thread", 0, "°", where="picture")
    read_out(plotter, "verdict", "the thread")
    read_out(plotter, "home", "spoon is home", loud="yes")
    describe(
        plotter,
        "A blue spoon, which can be turned, and pale the same spoon as it lay at the start. Beside"
        " them, a see-through ball whose skin is half a turn. A thread leads from its middle to"
        " the turn of the spoon. Each time that it goes through the skin, it comes in again at the"
        " opposite point; where it has done so an odd number of times, it is purple, else green."
        f" So far: {state['outputs']['crossings']}.",
    )
    return plotter
