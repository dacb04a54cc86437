"""Scenes of the title page and of Chapter 1."""

import numpy as np
import pyvista

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Slider
from rotedu.ordinary_rotation import rotation_matrix, transform
from rotedu.scenes.looks import Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import (
    LITTLE,
    NARROW,
    add_arrow,
    add_coordinate_axes,
    add_label,
    add_line,
    add_point,
    new_scene,
)
from rotedu.scenes.shapes import ORIGIN, U, teaspoon, turning

__all__ = ["four_descriptions", "the_roll"]


def four_descriptions() -> pyvista.Plotter:
    """Draw a turned teaspoon with its axis and angle, its three angles, and its own axes."""
    n, angle = np.array([-1, -2, 2]) / 3, 2 * np.arctan2(3, 4)
    matrix = rotation_matrix(n, angle)
    theta_u = np.arctan2(matrix[2, 1], matrix[2, 2])
    theta_v = -np.arcsin(matrix[2, 0])
    theta_w = np.arctan2(matrix[1, 0], matrix[0, 0])
    # From the origin along U, with its bowl open upwards.
    before = teaspoon(stations=81, around=28)
    before.points = (before.points + np.array([1, 0, -0.08])) / 2
    after = before.copy()
    after.points = transform(matrix, before.points)

    plotter = new_scene((4.28, -1.84, 2.6), (0.06, 0.0, 0.31), view_angle=20.5, size=NARROW)
    plotter.add_mesh(before, color=VECTOR, smooth_shading=True)
    plotter.add_mesh(after, color=RESULT, smooth_shading=True)
    add_coordinate_axes(plotter, 1.1)
    for column, name in zip(matrix.T, "UVW", strict=True):
        add_arrow(plotter, ORIGIN, 1.1 * column, RESULT, radius=0.006)
        add_label(plotter, 1.2 * column, f"${name}'$", RESULT)
    add_arrow(plotter, ORIGIN, 1.1 * n, AXIS)
    add_label(plotter, 1.2 * n, r"$\hat n$", AXIS)

    tip = np.array([1.0, 0, 0])
    path = turning(tip, n, angle)
    add_line(plotter, path, AXIS, radius=0.011)
    add_label(plotter, 1.1 * path[len(path) // 2], r"$\theta$", AXIS)
    # The first turn is about the spoon's own axis; it is drawn as a small circle ahead of the tip.
    roll = turning((1.08, 0, 0.16), (1, 0, 0), theta_u)
    raised = turning(tip, (0, 1, 0), theta_v)
    swung = turning(raised[-1], (0, 0, 1), theta_w)
    add_label(plotter, (1.08, 0.23, 0.15), r"$\theta_u$", CROSS)
    add_label(plotter, raised[len(raised) // 2] + (0, 0.09, 0.02), r"$\theta_v$", CROSS)
    add_label(plotter, swung[len(swung) // 3] - (0, 0, 0.09), r"$\theta_w$", CROSS)
    for part in (roll, raised, swung):
        add_line(plotter, part, CROSS, radius=0.011)
    describe(
        plotter,
        "A blue teaspoon points along the U axis. A turn by"
        f" {np.rad2deg(angle):.0f} degrees about an axis n takes it to a green one. An arc around n"
        " leads from tip to tip, and so do three arcs around U, V and W. Three thin green arrows"
        " show the axes U, V and W after the turn.",
    )
    return plotter


@explorable(
    small=True,
    answer={"roll": 120},
    # At the widest place of the bowl.
    constants={"side": (0.45, 0.42, 0)},
    roll=Slider(0, 360, "roll, °", step=1, plays=6, start=0),
)
def the_roll(state: State) -> pyvista.Plotter:
    """Draw a spoon whose tip is where it should be, but which rolls about its length.

    Parameters
    ----------
    roll : float
        How far it has rolled, in degrees.
    """
    plotter = new_scene((3.2, -4.6, 2.6), (0.05, 0, 0), view_angle=12.5, size=LITTLE)
    spoon = teaspoon(stations=61, around=20)
    # Wider, and its tip stays on the axis.
    spoon.points = spoon.points * [1, 1.25, 1.25]
    solid = {"smooth_shading": True, "pickable": False}
    looks: dict[str, Look] = {
        "path": Lines(NEUTRAL, 0.004),
        "spoon": Mesh(spoon, RESULT, solid),
    }
    wanted = {"color": VECTOR, "opacity": 0.25}
    plotter.add_mesh(spoon.copy(), name="wanted", **solid, **wanted)  # type: ignore[arg-type]
    draw(plotter, state, looks, {"tip": Text(VECTOR, "{}")})
    add_line(plotter, [-1.25 * U, 1.35 * U], AXIS, 0.006)
    add_point(plotter, 1.02 * U, VECTOR, 0.045)
    read_out(plotter, "off", "off by", 0, "°", where="picture")
    describe(
        plotter,
        "A pale spoon as it should lie, and a green one in the same place, whose tip is at the same"
        f" point, but which has rolled about its length by {state['inputs']['roll']:.0f} degrees.",
    )
    return plotter
