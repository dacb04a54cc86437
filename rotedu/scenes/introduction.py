"""Scenes of the title page and of Chapter 1."""

import numpy as np
import pyvista

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Slider
from rotedu.ordinary_rotation import rotate, rotation_matrix, transform
from rotedu.scenes.looks import UNTOUCHED, Arrow, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import (
    LITTLE,
    NARROW,
    add_arrow,
    add_coordinate_axes,
    add_label,
    add_line,
    add_point,
    add_shadow,
    new_scene,
)
from rotedu.scenes.shapes import ORIGIN, U, W, teaspoon, turning

__all__ = ["four_descriptions", "on_the_way", "once_round", "the_roll"]

AXIS_HERE, ANGLE_HERE = np.array([-1, -2, 2]) / 3, 2 * np.arctan2(3, 4)
"""The turn of this chapter's spoon."""
ANGLES_HERE = np.arctan2(-0.64, 0.6), -np.arcsin(0.48), np.arctan2(0.8, 0.36)
"""The same about U, then V, then W."""


def four_descriptions() -> pyvista.Plotter:
    """Draw a turned teaspoon with its axis and angle, its three angles, and its own axes."""
    n, angle = AXIS_HERE, ANGLE_HERE
    theta_u, theta_v, theta_w = ANGLES_HERE
    matrix = rotation_matrix(n, angle)
    before = held_at_its_end(stations=81, around=28)
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
    plotter = new_scene((3.2, -4.6, 2.6), (0.05, 0, 0), view_angle=12.5, size=LITTLE, swing=20)
    spoon = teaspoon(stations=61, around=20)
    # Wider, and its tip stays on the axis.
    spoon.points = spoon.points * [1, 1.25, 1.25]
    looks: dict[str, Look] = {
        "path": Lines(NEUTRAL, 0.004),
        "spoon": Mesh(spoon, RESULT, UNTOUCHED),
    }
    add_pale(plotter, spoon.copy())
    draw(plotter, state, looks, {"tip": Text(VECTOR, "{}")})
    add_line(plotter, [-1.25 * U, 1.35 * U], AXIS, 0.006)
    add_point(plotter, 1.02 * U, VECTOR, 0.045)
    add_shadow(plotter, "spoon", ORIGIN, 1, 0.45)
    read_out(plotter, "off", "off by", 0, "°", where="picture")
    describe(
        plotter,
        "A pale spoon as it should lie, and a green one in the same place, whose tip is at the same"
        f" point, but which has rolled about its length by {state['inputs']['roll']:.0f} degrees.",
    )
    return plotter


def held_at_its_end(stations: int = 61, around: int = 20) -> pyvista.PolyData:
    """Return a teaspoon from the origin along U, with its bowl open upwards."""
    spoon = teaspoon(stations, around)
    spoon.points = (spoon.points + np.array([1, 0, -0.08])) / 2
    return spoon


def add_pale(plotter: pyvista.Plotter, spoon: pyvista.PolyData) -> None:
    """Add a spoon where it lay, or should lie."""
    Mesh(spoon, VECTOR, UNTOUCHED | {"opacity": 0.25}).add(plotter, "pale", {})


@explorable(
    small=True,
    answer={"share": 1 / 3},
    constants={
        "axis": AXIS_HERE.tolist(),
        "angle": float(ANGLE_HERE),
        "angles": [float(angle) for angle in ANGLES_HERE],
    },
    share=Slider(0, 1, "share of the way", plays=6, start=0),
)
def on_the_way(state: State) -> pyvista.Plotter:
    """Draw three spoons on their way from one orientation to another.

    Parameters
    ----------
    share : float
        Of the way; of one angle, of each of three angles, and between two matrices.
    """
    plotter = new_scene((4.28, -1.84, 2.6), (0.35, 0.3, 0.17), view_angle=15, size=LITTLE)
    inks = {"mechanic": RESULT, "pilot": CROSS, "draughtsman": NEUTRAL}
    looks: dict[str, Look] = {}
    for name, ink in inks.items():
        looks[name] = Mesh(held_at_its_end(), ink, UNTOUCHED)
        looks[f"{name}'s path"] = Lines(ink, 0.008)
    draw(plotter, state, looks)
    add_label(plotter, (0.7, -0.46, -0.05), "your friend's")
    add_label(plotter, 1.14 * rotate(U, AXIS_HERE, ANGLE_HERE), "yours")
    read_out(plotter, "off", "pilot's spoon off by", 1, "°", where="picture")
    describe(
        plotter,
        f"Three spoons, {state['inputs']['share']:.0%} of the way from where they lay to where they"
        " are to lie. The tip of the green one, turned about one axis, runs on an arc; that of the"
        " purple one, turned by three angles, leaves it; the grey one, between two matrices, gets"
        " thinner and shorter, and its tip runs straight.",
    )
    return plotter


@explorable(
    small=True,
    answer={"turned": 360},
    turned=Slider(0, 720, "turned, °", step=1, plays=10, start=0),
)
def once_round(state: State) -> pyvista.Plotter:
    """Draw a level spoon that turns about W, with the axis of the shorter turn.

    Parameters
    ----------
    turned : float
        How far it has been turned, in degrees.
    """
    plotter = new_scene((2.6, -3.4, 2.2), (0, 0, 0.03), view_angle=18.5, size=LITTLE)
    looks: dict[str, Look] = {
        "spoon": Mesh(held_at_its_end(), RESULT, UNTOUCHED),
        "axis": Arrow(AXIS, 0.02),
    }
    add_pale(plotter, held_at_its_end())
    draw(plotter, state, looks)
    add_label(plotter, 0.72 * W, "$W$")
    read_out(plotter, "numbers", "the programmer's numbers", 2, where="picture")
    describe(
        plotter,
        "A pale spoon where it lay, and a green one turned about the vertical by"
        f" {state['inputs']['turned']:.0f} degrees. An orange arrow is the axis of the shorter turn"
        " that leads there: it points up or down.",
    )
    return plotter
