"""Scene of page D: a turn past half a turn, and its one name in a ball."""

import pyvista

from rotedu.colors import AXIS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Slider
from rotedu.scenes.looks import Ball, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import LITTLE, add_sphere, new_scene
from rotedu.scenes.shapes import teaspoon

__all__ = ["one_name"]


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
    plotter = new_scene((2.2, -9, 2.6), (0.1, 0, 0), view_angle=15, size=LITTLE)
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
    read_out(plotter, "q", "*w*, *x*", 2, where="picture")
    describe(
        plotter,
        f"A spoon, turned by {state['inputs']['angle']:.0f} degrees about its length. Beside it, a"
        " see-through ball, in which a green point lies on the axis as far out as the angle is"
        " large. Up to half a turn it goes out on one side; beyond, it comes in on the other.",
    )
    return plotter
