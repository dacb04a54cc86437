"""Scene of page B: three orientations, and their mean by matrices and by quaternions."""

import numpy as np
import pyvista

from rotedu.colors import MATRIX, QUATERNION, VECTOR
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Poses, Switch
from rotedu.quaternions import Quaternion
from rotedu.scenes.looks import Ball, Look, Text, draw, spoon_in
from rotedu.scenes.parts import add_sphere, new_scene
from rotedu.scenes.shapes import U, V, W

__all__ = ["mean_by_hand"]

GIVEN = ((0.31, -0.59, -0.39, -0.64), (0.62, -0.21, -0.27, -0.71), (0.69, -0.61, 0, -0.38))
SPREAD = ((-0.06, 0.16, 0.92, -0.36), (-0.28, 0.68, -0.37, -0.57), (0.47, 0.15, 0.31, -0.81))
"""Here no choice of signs lets each pair agree."""
FACING = Quaternion.from_axis_angle(U, np.pi / 2)
THIRDS = (Quaternion.from_axis_angle(V, np.radians([-120, 0, 120])) * FACING).components.tolist()
INKS = {"matrices": MATRIX, "quaternions": QUATERNION}


@explorable(
    tries={
        "give *q₃* the other sign": {"flip": True},
        "no choice of signs helps": {"poses": SPREAD},
        "thirds of a whole turn": {"poses": THIRDS},
    },
    answer={"flip": True},
    constants={"no_mean": "not unique"},
    poses=Poses([f"spoon {k}" for k in (1, 2, 3)], start=GIVEN),
    flip=Switch("−*q₃* in place of *q₃*, the same orientation", start=False),
)
def mean_by_hand(state: State) -> pyvista.Plotter:
    """Draw the mean of three orientations by their matrices and by their quaternions.

    Parameters
    ----------
    poses : array_like, shape (3, 4)
        The orientations as quaternions; they are normalised, but their signs count.
    flip : bool
        Whether the third quaternion is replaced by its opposite.
    """
    # From far away, so that spoons in the same pose look the same wherever they are.
    middle = -0.73 * U
    stack = (0, 66, 303, 332, 0.56), (295, 29, 425, 422, 1)
    plotter = new_scene(middle - 32 * V + 6 * W, middle, view_angle=4.18, swing=20, stack=stack)
    add_sphere(plotter)
    looks: dict[str, Look] = {}
    for k in (1, 2, 3):
        looks[f"R_{k}"] = spoon_in(VECTOR)
        looks[f"R_{k} in the ball"] = spoon_in(VECTOR, opacity=0.18)
        looks[f"tip {k}"] = Ball(VECTOR)
    draw(plotter, state, looks, {"?q_?": Text(VECTOR)})
    read_out(plotter, "apart", "means apart", 1, "°", where="picture")
    for name, ink in INKS.items():
        looks = {name: spoon_in(ink), f"tip by {name}": Ball(ink, 0.04)}
        draw(plotter, state, looks, {name: Text(ink, "by {}")})
        label = f"{name}: from the spoons"
        read_out(plotter, f"by_{name}", label, 0, "°", where="picture", color=ink)
    read_out(plotter, "singular", "singular values of the mean matrix", 3, where="folded")
    describe(
        plotter,
        "Three blue teaspoons in a row can be turned. Below them, in a see-through ball, pale"
        " spoons in the same poses cross at the middle, and two more show their mean. The ochre"
        " one, by matrices, lies among the pale ones."
        + (
            " The violet one, by quaternions with the sign of the third changed, points elsewhere."
            if state["inputs"]["flip"]
            else ""
        ),
    )
    return plotter
