"""Scenes of page 5 I: a camera, an arc and its axis, and slerp beside nlerp."""

import numpy as np
import pyvista
from numpy.typing import ArrayLike

from rotedu.arcs import angle_between, arc_axis, slerp
from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import State, describe, draw_chart, explorable, read_out
from rotedu.figures.inputs import Handles, Slider, Switch
from rotedu.scenes.looks import Arrow, Ball, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import (
    HEAD,
    LITTLE,
    add_angle,
    add_arc,
    add_arrow,
    add_axis,
    add_label,
    add_line,
    add_point,
    add_sphere,
    new_scene,
    sphere_scene,
)
from rotedu.scenes.room import CAMERA_SEES, CAMERA_TARGETS, THINGS, camera, facing
from rotedu.scenes.shapes import ORIGIN, W, normalised, teaspoon, turning

__all__ = [
    "CAMERA_SEES",
    "CAMERA_TARGETS",
    "camera_arcs",
    "figure_2",
    "slerp_by_hand",
    "the_detour",
]

DOWN = 80


@explorable(
    small=True,
    answer={"aside": 0},
    constants={"down": DOWN},
    aside=Slider(-90, 90, "aside, in the middle, °", step=1, start=55),
)
def the_detour(state: State) -> pyvista.Plotter:
    """Draw a path from the North Pole that bulges to a side of the meridian, or does not.

    Parameters
    ----------
    aside : float
        How far it is from the meridian in the middle, in degrees of longitude.
    """
    plotter = new_scene((4.6, 0.0, 2.9), (0, 0, 0.06), view_angle=26.5, size=LITTLE)
    add_sphere(plotter)
    looks: dict[str, Look] = {
        "meridian": Lines(NEUTRAL, 0.008),
        "path": Lines(RESULT, 0.014),
        "middle": Ball(RESULT, 0.04),
    }
    draw(plotter, state, looks)
    low = np.deg2rad(DOWN)
    for point, name in ((W, r"\hat v_1"), (np.array([np.sin(low), 0, np.cos(low)]), r"\hat v_2")):
        add_point(plotter, point, VECTOR, 0.04)
        add_label(plotter, 1.16 * point, f"${name}$", VECTOR)
    read_out(plotter, "length", "length of the path", 1, "°", where="picture")
    describe(
        plotter,
        "A ball with two points, one at its pole, and the meridian from this to the other. A green"
        f" path between the two is {state['inputs']['aside']:g} degrees aside in its middle, and"
        f" {state['outputs']['length']:.0f} degrees long; along the meridian it would be {DOWN}.",
    )
    return plotter


def camera_arcs() -> pyvista.Plotter:
    """Draw a camera, the directions in which it looks in turn, and the arcs between them."""
    points = normalised(CAMERA_TARGETS)

    plotter = sphere_scene(eye=(4.31, -1.87, 3.2), target=(0.01, 0.03, 0.06))
    plotter.add_mesh(camera(points[0]), color=NEUTRAL, pickable=False)
    for point, after, name in zip(points, np.roll(points, -1, axis=0), CAMERA_SEES, strict=True):
        add_line(plotter, [ORIGIN, point], NEUTRAL, radius=0.004)
        add_arc(plotter, point, after, RESULT, radius=0.014)
        tail, tip = slerp(point, after, [0.5, 0.6])
        add_arrow(plotter, tail, tip, RESULT, tip=HEAD)
        thing = THINGS[name]().transform(facing(point, point), inplace=False)
        plotter.add_mesh(thing, color=VECTOR, pickable=False)
        add_label(plotter, 1.24 * point, name, VECTOR)
    describe(
        plotter,
        "A see-through unit sphere with a camera at its centre. Thin lines lead from the camera to"
        f" {len(points)} points of the sphere: {', '.join(CAMERA_SEES)}. Arcs of great circles join"
        " them in this order and lead back to the first. At each point the path has a corner.",
    )
    return plotter


def add_right_angle(
    plotter: pyvista.Plotter, first: ArrayLike, second: ArrayLike, size: float = 0.13
) -> None:
    """Mark that two directions at the origin are perpendicular."""
    side, other = size * np.asarray(first, float), size * np.asarray(second, float)
    add_line(plotter, [side, side + other, other], NEUTRAL, radius=0.005)


def figure_2() -> pyvista.Plotter:
    """Draw Fig. 2: two unit vectors, the axis perpendicular to both, and the arc between them."""
    first, second = normalised(((0.85, -0.45, -0.2), (0.15, 0.98, -0.1)))
    t = 0.3
    n, point = arc_axis(first, second), slerp(first, second, t)
    angle = float(np.degrees(angle_between(first, second)))

    plotter = sphere_scene(eye=(4.5, 2.3, 2.9), target=(0, 0, 0.16))
    add_line(plotter, turning(first, n, 2 * np.pi, 96), NEUTRAL, radius=0.004)
    add_angle(plotter, first, second, r"$\theta$", size=0.4)
    add_axis(plotter, n, r"$\hat v$")
    for end, text in ((first, r"$\hat v_1$"), (second, r"$\hat v_2$")):
        add_right_angle(plotter, n, end)
        add_arrow(plotter, ORIGIN, end, VECTOR)
        add_label(plotter, 1.13 * end, text, VECTOR)
    add_arc(plotter, first, second, RESULT, radius=0.014)
    add_line(plotter, [ORIGIN, point], RESULT, radius=0.006)
    add_point(plotter, point, RESULT, radius=0.035)
    add_label(plotter, 1.16 * point, r"$\hat v(t)$", RESULT)
    describe(
        plotter,
        f"A see-through unit sphere. Two arrows v1 and v2, {angle:.0f} degrees apart, lead from its"
        " centre to its surface. A third arrow, the axis v, is perpendicular to both. An arc of a"
        f" great circle joins v1 and v2. A point v(t) lies {t:.0%} of the way along this arc.",
    )
    return plotter


LOOK_AT = np.array([1.02, 0, 0])
EYE = LOOK_AT + 9.8 * np.array([0, -np.cos(np.radians(20)), np.sin(np.radians(20))])


@explorable(
    tries={
        "nlerp hurries in the middle": {"t": 0.5},
        "flip the sign of the end": {"flip": True, "t": 0.5},
        "just before the opposite point": {"q": (0.951, 0.038, -0.356), "t": 0.5},
        "just past it": {"q": (0.951, 0.244, -0.194), "t": 0.5},
    },
    constants={"antipodal": "the ends are antipodal: no unique arc joins them"},
    p=Handles("p", start=(-0.951, -0.141, 0.275)),
    q=Handles("q", start=(0.789, -0.263, -0.555)),
    t=Slider(0, 1, "fraction *t*", plays=5, start=0.2),
    flip=Switch("flip the sign of the end", start=False),
)
def slerp_by_hand(state: State) -> pyvista.Plotter:
    """Draw slerp and nlerp between two points, and what both do to a spoon.

    To the points of the arc belong quaternions as far apart: that of a point v is v p*, with both
    read as [0, v]. So the spoon turns by twice the arc's angle, about the arc's axis.

    Parameters
    ----------
    p, q : array_like, shape (3,)
        The points; they are normalised. At the start, the spoon points to p.
    t : float
        Fraction of the way, from 0 to 1.
    flip : bool
        Whether the end is -q instead of q: the opposite point, but the same orientation.
    """
    stack = (10, 34, 374, 330, 1), (358, 52, 370, 296, 0.75)
    plotter = new_scene(
        eye=EYE, target=LOOK_AT, view_angle=16, size=(720, 400), swing=20, stack=stack
    )
    add_sphere(plotter)
    looks: dict[str, Look] = {
        "arc": Lines(RESULT, 0.014),
        "tenths": Lines(CROSS, 0.003),
        "chord": Lines(CROSS, 0.006),
        "p": Ball(VECTOR, 0.036),
        "q": Ball(NEUTRAL, 0.028),
        "end": Ball(VECTOR, 0.036),
        "slerp": Ball(RESULT, 0.044),
        # Smaller: where both are in one place, it lies within the other.
        "nlerp": Ball(CROSS, 0.038),
        "circle": Lines(NEUTRAL, 0.004),
        "sweep": Lines(RESULT, 0.014),
        "axis": Arrow(AXIS),
        "spoon at *": hand(VECTOR),
        "spoon by slerp": hand(RESULT),
        # Smaller, to be seen in front of the one by slerp.
        "spoon by nlerp": hand(CROSS, 0.75),
    }
    texts = {
        "slerp": Text(RESULT, "slerp"),
        "nlerp": Text(CROSS, "nlerp"),
        "start": Text(VECTOR, "start"),
        "end of turn": Text(VECTOR, "end"),
        "*": Text(VECTOR),
    }
    draw(plotter, state, looks, texts)

    for name, text, digits, unit, where in (
        ("angle", "arc", 1, "°", "picture"),
        ("way", "spoon turns by", 1, "°", "picture"),
        ("speed", "nlerp's speed (slerp: 1)", 2, "", "picture"),
        ("start_weight", "weight of the start", 2, "", "folded"),
        ("end_weight", "weight of the end", 2, "", "folded"),
        ("weights_sum", "sum of the weights", 2, "", "folded"),
    ):
        read_out(plotter, name, text, digits, unit, where=where)
    for name, text, colors in (
        ("weights", "weights of the ends", {"start": VECTOR, "end": NEUTRAL}),
        ("speeds", "speed", {"slerp": RESULT, "nlerp": CROSS}),
    ):
        label = f"{text} (above 4 not shown)"
        draw_chart(plotter, name, over="t", x=(0, 1), y=(0, 4), label=label, colors=colors)
    inputs, outputs = state["inputs"], state["outputs"]
    describe(
        plotter,
        f"Left, a see-through sphere with an arc of {outputs['angle']:.0f} degrees from a point p"
        f" to a point {'minus q' if inputs['flip'] else 'q'}. A green point, slerp, and a purple"
        f" point, nlerp, travel along it, here at {inputs['t']:.0%} of the time. Thin rays show"
        " that equal steps of nlerp are short near the ends of the arc and long in its middle."
        " Right, spoons point outwards from one place like the hands of a clock: blue ones at the"
        f" start and, {outputs['way']:.0f} degrees on, at the end; a green one that slerp turns,"
        " and a purple one that nlerp turns.",
    )
    return plotter


def hand(color: str, size: float = 1) -> Mesh:
    """Return the look of a spoon that points outwards like the hand of a clock."""
    spoon = teaspoon(stations=61, around=20)
    spoon.points = 0.44 * size * spoon.points + np.array([0.56, 0, 0], spoon.points.dtype)
    return Mesh(spoon, color, {"smooth_shading": True})
