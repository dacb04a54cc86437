"""Scene of page A: a spoon that spins, followed in three ways."""

import numpy as np
import pyvista

from rotedu.colors import AXIS, MATRIX, NEUTRAL, QUATERNION, RESULT, WRONG
from rotedu.figures import State, describe, draw_chart, explorable, read_out
from rotedu.figures.inputs import Handles, Slider, Switch
from rotedu.scenes.looks import Arrow, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import LITTLE, add_label, add_line, new_scene
from rotedu.scenes.shapes import U, W, normalised, teaspoon

__all__ = ["spinning_by_hand", "the_drone"]

SECONDS = 1.5
EDGE = 0.85
EYE = 30 * np.array([0.3, -0.88, 0.36])
ACROSS = normalised(np.cross(W, EYE))
MIDDLE = 2.33 * ACROSS - 0.04 * np.cross(EYE, ACROSS) / np.linalg.norm(EYE)
INKS = {"exponential": RESULT, "Euler, matrix": MATRIX, "Euler, quaternion": QUATERNION}
IN_SPACE = (-0.15, 0.17, 0.97)
IN_BODY = (-0.73, -0.53, 0.43)


@explorable(
    answer={"t": SECONDS},
    tries={
        "a fine step": {"t": SECONDS, "h": 0.02},
        "repaired after every step": {"t": SECONDS, "repair": True},
        "both arrows alike": {"t": SECONDS, "body": IN_SPACE},
        "the opposite arrow": {"t": SECONDS, "body": tuple(-x for x in IN_SPACE)},
    },
    constants={"seconds": SECONDS, "edge": EDGE, "longest": "edge ", "aside": "° off"},
    space=Handles("arrow fixed in space", reach=0.85, through=True, start=IN_SPACE),
    body=Handles("arrow fixed in the body", reach=0.85, through=True, start=IN_BODY),
    h=Slider(0.01, 0.1, "step in seconds", step=0.01, start=0.1),
    t=Slider(0, SECONDS, "time in seconds", step=0.01, stride="h", plays=6, start=0),
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
        "Three teaspoons in wire boxes turn for the same time by two velocities, which two orange"
        " arrows show: one is fixed in space, one turns with the spoon. By the exponential, in"
        " green, the box stays a cube. By Euler's step on the matrix, in ochre, it goes askew and"
        " becomes much too large, and by Euler's step on the quaternion, in violet, it stays a"
        " cube, but grows. Lines follow the spoons' tips, outwards in ochre and violet.",
    )
    return plotter


def drone() -> pyvista.PolyData:
    """Model a drone: two crossed arms with a ring at each end, and a body that is longer ahead."""
    arms = [pyvista.Box((-0.75, 0.75, -0.05, 0.05, -0.03, 0.03)).rotate_z(z) for z in (45, 135)]
    ends = np.array([[x, y, 0.06] for x in (-0.53, 0.53) for y in (-0.53, 0.53)])
    ring = pyvista.Disc(inner=0.2, outer=0.34, normal=(0, 0, 1), c_res=20)
    rings = [ring.translate(end) for end in ends]
    body = pyvista.Box((-0.3, 0.5, -0.17, 0.17, -0.1, 0.14))
    solid = pyvista.merge([*arms, *rings, body]).extract_surface(algorithm=None).triangulate()
    model: pyvista.PolyData = solid.clean()
    return model


@explorable(
    small=True,
    answer={"time": 2},
    time=Slider(0, 2, "time in seconds", step=0.01, plays=6, start=0),
)
def the_drone(state: State) -> pyvista.Plotter:
    """Draw a drone that yaws, then rolls, and what a log read in the wrong frame makes of it.

    Parameters
    ----------
    time : float
        In seconds: in the first a quarter turn about the vertical, then one about the nose.
    """
    plotter = new_scene((3.6, -3.4, 2.3), (0, 0.1, 0.05), view_angle=26, size=LITTLE)
    flat = {"smooth_shading": False, "pickable": False}
    looks: dict[str, Look] = {
        "drone": Mesh(drone(), RESULT, flat),
        "nose": Arrow(RESULT, 0.02),
        "logged": Mesh(drone(), WRONG, flat | {"opacity": 0.35}),
        "logged nose": Arrow(WRONG, 0.012),
    }
    draw(plotter, state, looks)
    add_line(plotter, [0.5 * U, 1.5 * U], NEUTRAL)
    add_label(plotter, 1.62 * U, "$U$")
    read_out(plotter, "apart", "the program is off by", 1, "°", where="picture")
    describe(
        plotter,
        "A green drone with an arrow from its nose, and a red one, see-through: where it is by a"
        f" log that is read in the wrong frame. After {state['inputs']['time']:.1f} of two seconds"
        f" they are {state['outputs']['apart']:.0f} degrees apart.",
    )
    return plotter
