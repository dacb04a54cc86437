"""Scenes of Chapter 4: three rotations, the one that replaces them, and transforms."""

from collections.abc import Sequence
from itertools import permutations

import numpy as np
import pyvista
from numpy.typing import ArrayLike

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import State, describe, draw_chart, explorable, read_out
from rotedu.figures.inputs import Choice, Poses, Slider
from rotedu.general_rotation import (
    axis_angle_from_euler_angles,
    compose,
    perspective,
    rotation_u,
    rotation_v,
    rotation_w,
    scaling,
    shearing,
    translation,
)
from rotedu.ordinary_rotation import transform
from rotedu.scenes.looks import Arrow, Ball, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import (
    HEAD,
    LITTLE,
    add_arrow,
    add_axis,
    add_coordinate_axes,
    add_label,
    add_line,
    add_point,
    add_sphere,
    new_scene,
    sphere_scene,
)
from rotedu.scenes.shapes import ORIGIN, U, W, normalised, shade, teaspoon, turning

__all__ = [
    "euler_angles_by_hand",
    "one_degree",
    "one_for_three",
    "same_three_numbers",
    "stages",
    "three_turns_by_hand",
]

ORDERS = [" ".join(f"*{letter}*" for letter in order) for order in permutations("UVW")]
FIXED, CARRIED = AXES = ["fixed", "carried along"]


@explorable(
    constants={"factors": {"U": "M(u)", "V": "M(v)", "W": "M(w)"}, "carried": CARRIED},
    tries={
        "*W* *V* *U*, axes carried along": {"axes": CARRIED},
        "turns of 10°": {"u": 10, "v": 10, "w": 10},
        "half turns": {"u": 180, "v": 180, "w": 180},
    },
    u=Slider(-180, 180, "*u*, about *U*, °", step=1, row=False, start=90),
    v=Slider(-180, 180, "*v*, about *V*, °", step=1, row=False, start=90),
    w=Slider(-180, 180, "*w*, about *W*, °", step=1, row=False, start=90),
    order=Choice("order of the lower row", ORDERS, start="W V U"),
    axes=Choice("its axes", AXES, start=FIXED),
)
def three_turns_by_hand(state: State) -> pyvista.Plotter:
    """Draw the three principal rotations twice: U, V, W as in (4-1), and in any order.

    Parameters
    ----------
    u, v, w : float
        Angles about U, V and W in degrees.
    order : str
        The order of the lower row.
    axes : str
        Whether the lower row turns about fixed axes or about axes that the spoon carries along.
    """
    back = np.array([0.49, -0.77, 0.42])
    right = normalised(np.cross(W, back))
    target = -0.05 * right + 0.08 * np.cross(back, right)
    plotter = new_scene(eye=28.6 * back + target, target=target, view_angle=11.2, swing=20)
    spoon = teaspoon(61, 20)
    for row in ("upper", "lower"):
        for k in range(4):
            looks: dict[str, Look] = {
                f"{row} {k}": Mesh(spoon, shade(k / 3)),
                f"{row} axis {k}": Arrow(AXIS, 0.022),
                f"{row} turn {k}": Lines(NEUTRAL, 0.018),
                f"{row} turn {k}, head": Arrow(NEUTRAL, 0.02, HEAD),
            }
            draw(plotter, state, looks)
    for letter in "UVW":
        # In the lower row an axis has a name for each number of turns that have carried it.
        carried = {f"{letter} {primes}": Text(AXIS, prime(letter, primes)) for primes in range(3)}
        draw(plotter, state, {}, {letter: Text(AXIS), **carried})
    read_out(plotter, "apart", "last spoons apart by", 0, "°", where="picture")
    for row in ("upper", "lower"):
        read_out(plotter, row, f"{row} row", where="picture")
    order, axes = state["inputs"]["order"], state["inputs"]["axes"]
    describe(
        plotter,
        "Two rows of four teaspoons, each turned once more than the one to its left, about an axis"
        f" with a bent arrow. In the upper row the axes are U, then V, then W; in the lower row"
        f" {order.replace(' ', ', then ')}, {axes}. The last spoons of the rows are"
        f" {state['outputs']['apart']:.0f} degrees apart.",
    )
    return plotter


def prime(letter: str, primes: int) -> str:
    """Write the name of an axis that some turns have carried along."""
    marks = primes * r"\prime"
    return rf"${letter}^{{\,{marks}}}$" if marks else f"${letter}$"


def one_for_three() -> pyvista.Plotter:
    """Draw the path of a point under three principal rotations and under the one rotation (4-7)."""
    theta = np.array([5 / 12, 1 / 3, 11 / 18]) * np.pi
    start = here = normalised((0.77, 0.26, 0.59))
    a, angle = axis_angle_from_euler_angles(*theta)

    plotter = sphere_scene(eye=(5.5, 2.3, 1.7), target=(0.0, 0.0, 0.12))
    add_coordinate_axes(plotter, 1.12)
    for name, axis, part in zip("uvw", np.eye(3), theta, strict=True):
        path = turning(here, axis, part)
        add_line(plotter, path, CROSS, radius=0.012)
        add_label(plotter, 1.13 * path[len(path) // 2], rf"$\theta_{name}$", CROSS)
        here = path[-1]
        add_point(plotter, here, CROSS, radius=0.025)
    add_line(plotter, turning(start, a, float(angle)), RESULT, radius=0.018)
    add_axis(plotter, a, r"$\hat a$", length=1.2)
    for point, name, color in (
        (start, r"$\vec r$", VECTOR),
        (here, r"$\vec r^{\,\prime}$", RESULT),
    ):
        add_arrow(plotter, ORIGIN, point, color)
        add_label(plotter, 1.16 * point, name, color)
    describe(
        plotter,
        "A see-through sphere. Three purple arcs, around the U, the V and the W axis, lead from the"
        " tip of r to the tip of r'. One green arc, part of a circle around the axis a, leads there"
        " directly.",
    )
    return plotter


WAYS = (("angles", "three angles", CROSS), ("slerp", "one turn", RESULT))
# From what is seen to the eye, and to the right in the picture.
BACK = np.array([0.48, -0.74, 0.47])
RIGHT = normalised(np.cross(W, BACK))


def draw_gimbals(plotter: pyvista.Plotter, state: State) -> None:
    """Draw a spoon in three rings, each turning within the next."""
    held: dict[str, Look] = {
        "held": Mesh(teaspoon(61, 20), CROSS),
        "ring *": Lines(NEUTRAL, 0.034),
        "axis *": Lines(AXIS, 0.026),
    }
    axes = {"W": "$W$", "V": r"$V^{\,\prime}$", "U": r"$U^{\,\prime\prime}$"}
    draw(plotter, state, held, {name: Text(AXIS, text) for name, text in axes.items()})


@explorable(
    small=True,
    answer={"tilt": 1},
    tilt=Slider(-1, 1, "the spoon is tipped by, °", step=0.05, start=0),
)
def one_degree(state: State) -> pyvista.Plotter:
    """Draw a spoon in locked rings, which swing far round to follow a little tilt.

    Parameters
    ----------
    tilt : float
        By how much the spoon is tipped, in degrees, about the direction in which no ring turns.
    """
    target = 2.6 * RIGHT + (0, 0, 0.05)
    plotter = new_scene(24 * BACK + target, target, view_angle=8.2, size=LITTLE)
    draw_gimbals(plotter, state)
    read_out(plotter, "outer", "outer ring", 0, "°", where="picture")
    describe(
        plotter,
        "A teaspoon is held by three rings, one in the other, the middle one at 90 degrees. The"
        f" spoon is tipped by {state['inputs']['tilt']:g} degrees; the outer ring has turned by"
        f" {state['outputs']['outer']:.0f}.",
    )
    return plotter


@explorable(
    constants={"noWay": "no unique path: start and end are half a turn apart"},
    tries={
        "the spoon 1° aside": {"u": 0, "v": 89, "w": 0},
        "*v* = 30°": {"v": 30},
        "the longest way": {"u": 173, "v": -61, "w": 175},
    },
    u=Slider(-180, 180, "*u*, about *U*″, °", step=1, row=False, start=90),
    v=Slider(-180, 180, "*v*, about *V*′, °", step=1, row=False, start=90),
    w=Slider(-180, 180, "*w*, about *W*, °", step=1, row=False, start=90),
    spoon=Poses("the spoon", start=(np.sqrt(1 / 2), 0, np.sqrt(1 / 2), 0)),
    t=Slider(0, 1, "part of the way, *t*", plays=6, start=0.5),
)
def euler_angles_by_hand(state: State) -> pyvista.Plotter:
    """Draw a spoon in the rings of its Euler angles, and two ways to turn to its pose.

    Parameters
    ----------
    u, v, w : float
        Angles of the pose about U, V and W in degrees. Where `v` is 90 or -90, the rings lock.
    spoon : array_like, shape (4,)
        A quaternion of the pose, as the hand has turned the spoon. Only its sign counts here,
        because the angles say the rest.
    t : float
        Part of the way from the start to the pose, from 0 to 1.
    """
    target = 1.37 * RIGHT
    stack = (-18, 92, 366, 322, 1), (335, 44, 406, 412, 0.65)
    plotter = new_scene(
        eye=24 * BACK + target, target=target, view_angle=8.05, swing=20, stack=stack
    )
    draw_gimbals(plotter, state)
    spoon = teaspoon(61, 20)
    draw(plotter, state, {f"{way} spoon": Mesh(spoon, ink) for way, _, ink in WAYS})
    # What turns as a whole has come before the ball, behind which only lines are pale.
    add_sphere(plotter)
    add_point(plotter, U, VECTOR, 0.05)
    for way, text, ink in WAYS:
        looks: dict[str, Look] = {f"{way} path": Lines(ink, 0.017), f"{way} tip": Ball(ink, 0.055)}
        draw(plotter, state, looks, {text: Text(ink, "{}")})

    read_out(plotter, "rings", "*u*, *v*, *w*", 0, "°", where="picture")
    read_out(plotter, "by_angles", "three angles turn by", 0, "°", where="picture")
    read_out(plotter, "by_slerp", "one turn by", 0, "°", where="picture")
    read_out(plotter, "apart", "1° of *w* does what 1° of *u* does, to within", 2, "°")
    read_out(plotter, "matrix", "matrix of the three angles", where="folded")
    read_out(plotter, "q", "quaternion (*w* *x* *y* *z*)", where="folded")
    draw_chart(
        plotter,
        "speeds",
        over="t",
        x=(0, 1),
        y=(0, 200),
        label="speed, degrees for a step of 1 in *t* (above 200 not shown)",
        colors={text: ink for _, text, ink in WAYS},
    )
    describe(
        plotter,
        "A teaspoon is held by three rings, one in the other, which turn about axes"
        " W, V' and U''. Beside it, inside a glass ball, two spoons are on their way from a level"
        " start to the same pose, one by its three angles and one by a single turn. Lines on the"
        " ball show the paths of their tips, which part and meet again.",
    )
    return plotter


def same_three_numbers() -> pyvista.Plotter:
    """Draw a spoon turned by 90, 0, 90 degrees in the orders of two programs, and not at all."""
    about_x, about_z = rotation_u(np.pi / 2), rotation_w(np.pi / 2)
    plotter = new_scene((9, -9, 5.2), (0, 0, -0.05), view_angle=14.5, size=(720, 300))
    for aside, turn, color, name in (
        (-2.2, np.eye(4), NEUTRAL, "at rest"),
        (0, compose(about_z, about_x), VECTOR, "Blender"),
        (2.2, compose(about_x, about_z), RESULT, "Godot"),
    ):
        middle = aside * normalised((1, 1, 0))
        for letter, axis in zip("XYZ", np.eye(3), strict=True):
            add_arrow(plotter, middle, middle + 1.15 * axis, NEUTRAL, radius=0.008)
            add_label(plotter, middle + 1.27 * axis, f"${letter}$")
        spoon = teaspoon(stations=61, around=20)
        spoon.points = transform(turn, spoon.points) + middle
        plotter.add_mesh(spoon, color=color, smooth_shading=True)
        add_label(plotter, middle - (0, 0, 1.35), name, color)
    describe(
        plotter,
        "Three spoons, each at the origin of axes X, Y and Z, of which Z points up. The grey one"
        " lies along X with its bowl up. The blue one, Blender's, lies along Y on its side, with"
        " its bowl towards X. The green one, Godot's, stands upright, with its bowl away from Y.",
    )
    return plotter


def stages(steps: Sequence[ArrayLike] | None = None) -> pyvista.Plotter:
    """Draw a teaspoon going through five transforms, and its perspective picture.

    Parameters
    ----------
    steps : sequence of array_like, shape (4, 4), optional
        Scaling, shear, rotation, translation and perspective, in the order of their
        application.
    """
    if steps is None:
        steps = [
            scaling((0.8, 1.5, 1.5)),
            shearing(uv=0.8),
            rotation_v(np.deg2rad(-50)),
            translation((0, 0, -1)),
            perspective(2.6),
        ]
    eye = np.array([0, 0, -1 / np.asarray(steps[-1], float)[3, 2]])
    back = np.array([0.42, -0.8, 0.43])
    right = normalised(np.cross(W, back))
    up = np.cross(back, right)
    plotter = new_scene(eye=26 * back, target=ORIGIN, view_angle=13.6)
    spots = [x * right + y * up for y in (1.75, -1.15) for x in (-3.35, -1.0)]
    spots += [2.6 * right - 0.3 * up] * 2

    spoon = teaspoon(stations=61, around=20)
    box = np.array(spoon.bounds).reshape(3, 2)
    corners = np.stack(np.meshgrid(*box, indexing="ij"), axis=-1).reshape(-1, 3)
    names = ("start", "scale", "shear", "rotate", "translate", "perspective")
    done = np.eye(4)
    for k, (name, step, spot) in enumerate(zip(names, [np.eye(4), *steps], spots, strict=True)):
        done = np.asarray(step) @ done
        flat = (1, 1, name != "perspective")
        moved = spoon.copy()
        moved.points = transform(done, spoon.points) * flat + spot
        plotter.add_mesh(moved, color=shade(k / len(steps)), smooth_shading=True)
        edges = transform(done, corners) * flat + spot
        for i in range(8):
            for j in (i ^ 1, i ^ 2, i ^ 4):
                if i < j:
                    add_line(plotter, edges[[i, j]], NEUTRAL, radius=0.008)
        if name == "translate":
            for corner in edges:
                add_line(plotter, [corner, eye + spot], NEUTRAL, radius=0.004)
        if name == "perspective":
            below = 1.15 * right + 0.62 * up
        else:
            below = (((edges - spot) @ up).min() - 0.3) * up
        add_label(plotter, spot + below, name)
    plane = pyvista.Plane(center=spots[-1], i_size=2.6, j_size=2.6, i_resolution=1, j_resolution=1)
    plotter.add_mesh(plane, color=NEUTRAL, opacity=0.25, lighting=False, pickable=False)
    add_point(plotter, eye + spots[-1], AXIS, radius=0.06)
    add_label(plotter, eye + spots[-1] + 0.3 * right, "eye", AXIS)
    describe(
        plotter,
        "A teaspoon in its box at six stages. The first four: at the start, scaled, sheared and"
        " rotated. Then it lies below a see-through plane, with lines of sight from an eye above"
        " the plane to the corners of the box. Last comes a flat green picture, where these lines"
        " pass through the plane.",
    )
    return plotter
