"""Scene of page A: a spoon that spins, followed in three ways."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.averages import angular_distance
from rotedu.colors import AXIS, MATRIX, NEUTRAL, QUATERNION, RESULT
from rotedu.figures import (
    Handles,
    Slider,
    Switch,
    describe,
    draw_chart,
    explorable,
    limit_turning,
    place_grip,
    place_part,
    read_out,
)
from rotedu.figures.frames import stack_on_phone
from rotedu.general_rotation import homogeneous, translation
from rotedu.motion import matrix_from_rotation_vector
from rotedu.orientations import nearest_rotation
from rotedu.quaternions import Quaternion
from rotedu.scenes.parts import (
    CUBE,
    ORIGIN,
    add_arrow,
    add_label,
    add_line,
    add_lines,
    add_thin,
    new_scene,
    normalised,
    teaspoon,
)

SPEED = np.pi / 2
"""Of each of the two velocities, in radians a second."""
SECONDS = 1.5
COARSEST = 0.1
EDGE = 0.85
ARROW = 0.85
INKS = {"exponential": RESULT, "Euler, matrix": MATRIX, "Euler, quaternion": QUATERNION}
EYE = 30 * np.array([0.3, -0.88, 0.36])
ACROSS = np.cross([0, 0, 1], EYE) / np.linalg.norm(EYE[:2])
UPWARDS = np.cross(EYE, ACROSS) / np.linalg.norm(EYE)
PLACES = np.outer([0, 2.72, 5.07], ACROSS)
MIDDLE = 2.33 * ACROSS - 0.04 * UPWARDS
ASLANT = 0.6
"""Angle from an arrow to its name in the picture, so that names of arrows that are alike part."""
TIP = np.array([EDGE / 2, 0, 0])
SAMPLES = 61
"""Of a curve in a chart."""
PIECE = 0.025
"""The longest piece of a path, in seconds."""
ROUNDING = 1e-6
W = np.array([0.0, 0.0, 1.0])
IN_SPACE = (-0.15, 0.17, 0.97)
IN_BODY = (-0.73, -0.53, 0.43)
LONGEST, ASIDE = "edge up to ", "° wrong"


@explorable(
    model="spinning",
    constants={"longest": LONGEST, "aside": ASIDE},
    tries={
        "a fine step": {"h": 0.02},
        "repaired after every step": {"repair": True},
        "both arrows alike": {"body": IN_SPACE},
        "the opposite arrow": {"body": tuple(-x for x in IN_SPACE)},
    },
    space=Handles("arrow fixed in space", reach=ARROW, through=True),
    body=Handles("arrow fixed in the body", reach=ARROW, through=True),
    h=Slider(0.01, COARSEST, "step in seconds", step=0.01),
    t=Slider(0, SECONDS, "time in seconds", step=0.01, stride="h", plays=6),
    repair=Switch("repair after every step: nearest rotation, quaternion of norm 1"),
)
def spinning_by_hand(
    space: ArrayLike = IN_SPACE,
    body: ArrayLike = IN_BODY,
    h: float = 0.1,
    t: float = SECONDS,
    repair: bool = False,
) -> pyvista.Plotter:
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

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    omega, own = SPEED * normalised(space), SPEED * normalised(body)
    times = np.linspace(0, SECONDS, SAMPLES)
    exact = turned(omega, times) @ turned(own, times)
    right = turned(omega, t) @ turned(own, t)
    spoon = teaspoon(stations=41, around=14)
    spoon.points = EDGE / 2 * spoon.points

    # From far away, so that what is drawn in three places looks the same.
    plotter = new_scene(MIDDLE + EYE, MIDDLE, view_angle=5.885, size=(720, 292))
    limit_turning(plotter, 20)
    stack_on_phone(plotter, (0, 22, 262, 270, 0.74), (253, 6, 467, 286, 1))
    for name, vector, side in (("space", omega, 1), ("body", right @ own, -1)):
        tip = ARROW / SPEED * vector
        add_arrow(plotter, ORIGIN, tip, AXIS, 0.02, name=name)
        add_label(plotter, tip + beside(tip, side), name, AXIS)
    place_grip(plotter, "body", turn=turned(omega, t))

    ways = integrators(omega, own, h, repair)
    longest, off = {}, {}
    for (name, way), place in zip(ways.items(), PLACES, strict=True):
        ink, now = INKS[name], way(t)
        for part, edges, color, radius in (
            ("exact", right, NEUTRAL, 0.007),
            ("box", now, ink, 0.012),
        ):
            box = list(place + EDGE * CUBE @ edges.T)
            add_lines(plotter, box, color, radius, f"{part}, {name}")
        pose = translation(place) @ homogeneous(now)
        part = place_part(plotter, name, matrix=pose.T.ravel())
        add_thin(plotter, spoon, ink, part).user_matrix = pose
        path = [place + way(moment) @ TIP for moment in moments(h, t)]
        add_line(plotter, path, ink, 0.014, f"way, {name}")
        add_label(plotter, place - 1.5 * W, name, ink, name=name)

        drawn = np.array([*map(way, times), now])
        longest[name] = np.linalg.norm(drawn, axis=1).max(axis=1)
        turn = nearest_rotation(drawn)
        off[name] = np.degrees(angular_distance(turn, [*exact, right]))
        told = f"{LONGEST}{longest[name][-1]:.2f}, {off[name][-1]:.0f}{ASIDE}"
        read_out(plotter, name, told, name, where="picture", color=ink)
    for chart, curves, y, text in (
        ("longest", longest, (1, 2.5), "longest edge"),
        ("off", off, (0, 20), "degrees wrong"),
    ):
        draw_chart(
            plotter,
            chart,
            {name: heights[:-1] for name, heights in curves.items()},
            over="t",
            x=(0, SECONDS),
            y=y,
            label=text,
            colors=INKS,
        )
    describe(
        plotter,
        "Three teaspoons in wire boxes have turned for the same time by two velocities, which two"
        " orange arrows show: one is fixed in space, one turns with the spoon. By the exponential,"
        " in green, the box is still a cube. By Euler's step on the matrix, in ochre, it is askew"
        " and much too large, and by Euler's step on the quaternion, in violet, a cube, but too"
        " large. Lines show the ways of the spoons' tips, which lead outwards in ochre and violet.",
    )
    return plotter


def beside(tip: NDArray[np.float64], side: int) -> NDArray[np.float64]:
    """Return the way from the tip of an arrow to its name, clear of the ring around the tip."""
    angle = np.arctan2(tip @ UPWARDS, tip @ ACROSS) + side * ASLANT
    way: NDArray[np.float64] = 0.42 * np.cos(angle) * ACROSS + 0.3 * np.sin(angle) * UPWARDS
    return way


def turned(omega: NDArray[np.float64], t: ArrayLike) -> NDArray[np.float64]:
    """Return what a constant velocity, shape (3,), makes of no rotation in times, shape (...)."""
    return matrix_from_rotation_vector(np.multiply.outer(t, omega))


def integrators(
    omega: NDArray[np.float64], own: NDArray[np.float64], h: float, repair: bool
) -> dict[str, Callable[[float], NDArray[np.float64]]]:
    """Return what each method of `INKS` makes of the body at a time, shape (3, 3).

    Parameters
    ----------
    omega, own : ndarray, shape (3,)
        The velocities in the fixed and in the body's frame, in radians a second.
    h : float
        The step in seconds. What is left of it at the end is a shorter step.
    repair : bool
        Whether Euler's steps are repaired.

    Returns
    -------
    dict
        Functions of the time.
    """

    def exponential(r: Any, h: float) -> Any:
        return turned(omega, h) @ r @ turned(own, h)

    def matrix(m: Any, h: float) -> Any:
        m = m + h * (np.cross(omega, m, axisb=0, axisc=0) + np.cross(m, own))
        return nearest_rotation(m) if repair else m

    def quaternion(q: Any, h: float) -> Any:
        q = q + h / 2 * (Quaternion(0, omega) * q + q * Quaternion(0, own))
        return q / q.norm() if repair else q

    one = Quaternion(1, ORIGIN)
    return {
        "exponential": steps(exponential, np.eye(3), h, lambda r: r),
        "Euler, matrix": steps(matrix, np.eye(3), h, lambda m: m),
        "Euler, quaternion": steps(quaternion, one, h, lambda q: q.norm() ** 2 * q.matrix()),
    }


def steps(
    step: Callable[[Any, float], Any], start: Any, h: float, drawn: Callable[[Any], Any]
) -> Callable[[float], NDArray[np.float64]]:
    """Return the matrix that draws a body at a time, after whole steps and the rest of one."""
    states = [start]
    while len(states) <= SECONDS / h:
        states.append(step(states[-1], h))

    def at(t: float) -> NDArray[np.float64]:
        whole = min(int(t / h), len(states) - 1)
        matrix: NDArray[np.float64] = drawn(step(states[whole], t - whole * h))
        return matrix

    return at


def moments(h: float, t: float) -> list[float]:
    """Divide a time into steps, and these into pieces that are short enough for a path."""
    pieces = int(np.ceil(h / PIECE))
    whole = max(1, int(np.ceil(t * pieces / h - ROUNDING)))
    return [k * h / pieces for k in range(whole)] + [max(t, ROUNDING)]
