"""Scenes of page 5 I: a camera, an arc and its axis, and slerp beside nlerp."""

from collections.abc import Sequence

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import angle_between, arc_axis, nlerp, slerp
from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.errors import DegenerateError
from rotedu.figures import (
    Choice,
    Handles,
    Slider,
    Switch,
    describe,
    draw_chart,
    explorable,
    place_part,
    read_out,
)
from rotedu.quaternions import Quaternion
from rotedu.scenes.parts import (
    ORIGIN,
    add_angle,
    add_arc,
    add_arrow,
    add_axis,
    add_label,
    add_line,
    add_lines,
    add_point,
    add_sphere,
    new_scene,
    teaspoon,
    turning,
)

CAMERA_TARGETS = ((1.0, 0.0, -0.2), (0.3, 1.0, 0.2), (0.2, 0.3, 1.0), (0.3, -0.9, 0.3))
"""Directions from a camera to a door, a clock, a window and a desk, in this order."""
CAMERA_SEES = ("door", "clock", "window", "desk")


def camera(direction: ArrayLike, size: float = 0.3) -> pyvista.PolyData:
    """Model a camera at the origin: a box whose lens points in a direction that is not vertical."""
    ahead = np.asarray(direction, float) / np.linalg.norm(direction)
    left = arc_axis([0, 0, 1], ahead)
    body = pyvista.Box(bounds=(-0.7, 0.2, -0.35, 0.35, -0.3, 0.3)).triangulate()
    lens = pyvista.Cone(
        center=(0.35, 0, 0), direction=(-1, 0, 0), height=0.7, radius=0.32, resolution=24
    ).triangulate()
    upright = np.eye(4)
    upright[:3, :3] = size * np.column_stack([ahead, left, np.cross(ahead, left)])
    model: pyvista.PolyData = pyvista.merge([body, lens])
    model.transform(upright, inplace=True)
    return model


def camera_arcs(
    targets: ArrayLike = CAMERA_TARGETS, names: Sequence[str] = CAMERA_SEES
) -> pyvista.Plotter:
    """Draw a camera, the directions in which it looks in turn, and the arcs between them.

    Parameters
    ----------
    targets : array_like, shape (n, 3)
        The directions; they are normalised. The path is closed.
    names : sequence of str
        What the camera sees in each direction.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    points = np.asarray(targets, float) / np.linalg.norm(targets, axis=-1, keepdims=True)

    plotter = new_scene(eye=(4.3, -1.9, 3.2), target=(0, 0, 0.06))
    add_sphere(plotter)
    plotter.add_mesh(camera(points[0]), color=NEUTRAL, pickable=False)
    for point, after, name in zip(points, np.roll(points, -1, axis=0), names, strict=True):
        add_line(plotter, [ORIGIN, point], NEUTRAL, radius=0.004)
        add_arc(plotter, point, after, RESULT, radius=0.014)
        tail, tip = slerp(point, after, [0.5, 0.6])
        add_arrow(plotter, tail, tip, RESULT)
        add_point(plotter, point, VECTOR, radius=0.035)
        add_label(plotter, 1.2 * point, name, VECTOR)
    describe(
        plotter,
        "A see-through unit sphere with a camera at its centre. Thin lines lead from the camera to"
        f" {len(points)} points of the sphere: {', '.join(names)}. Arcs of great circles join them"
        " in this order and lead back to the first. At each point the path has a corner.",
    )
    return plotter


def add_right_angle(
    plotter: pyvista.Plotter, first: ArrayLike, second: ArrayLike, size: float = 0.13
) -> None:
    """Mark that two directions at the origin are perpendicular."""
    side, other = size * np.asarray(first, float), size * np.asarray(second, float)
    add_line(plotter, [side, side + other, other], NEUTRAL, radius=0.005)


def figure_2(
    v1: ArrayLike = (0.85, -0.45, -0.2), v2: ArrayLike = (0.15, 0.98, -0.1), t: float = 0.3
) -> pyvista.Plotter:
    """Draw Fig. 2: two unit vectors, the axis perpendicular to both, and the arc between them.

    Parameters
    ----------
    v1, v2 : array_like, shape (3,)
        The ends of the arc; they are normalised.
    t : float
        Fraction of the arc at which to show a point.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    first, second = (np.asarray(v, float) / np.linalg.norm(v) for v in (v1, v2))
    n, point = arc_axis(first, second), slerp(first, second, t)
    angle = float(np.degrees(angle_between(first, second)))

    plotter = new_scene(eye=(4.5, 2.3, 2.9), target=(0, 0, 0.16))
    add_sphere(plotter)
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


# Below this angle the sines are their angles to the last digit, but never 0/0.
TINY = 1e-9
# Angles in radians, and sines, that look like zero.
SAME = 1e-6


def weights(theta: float, t: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Return the factors of both ends in (5-2); where the ends coincide, their limits 1 - t and t.

    Parameters
    ----------
    theta : float
        Angle between the ends.
    t : ndarray, shape (...)
        Fractions of the arc.

    Returns
    -------
    list of ndarray, shape (...)
        The factors of the start and of the end.
    """
    size = max(theta, TINY)
    return [np.sin(share * size) / np.sin(size) for share in (1 - t, t)]


def speed_of_nlerp(theta: float, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how fast nlerp moves, as a multiple of slerp's constant speed.

    Parameters
    ----------
    theta : float
        Angle between the ends.
    t : ndarray, shape (...)
        Fractions of the chord.

    Returns
    -------
    ndarray, shape (...)
        The derivative of the angle travelled, divided by `theta`.
    """
    size = max(theta, TINY)
    squared_distance_from_centre = 1 - 2 * t * (1 - t) * (1 - np.cos(size))
    speed: NDArray[np.float64] = np.sin(size) / (size * squared_distance_from_centre)
    return speed


ANTIPODAL = "the quaternions 1 and −1 are antipodal: no unique arc joins them"


@explorable(
    model="slerp",
    constants={"antipodal": ANTIPODAL},
    p=Handles("p"),
    q=Handles("q (orientations: sets the axis)"),
    t=Slider(0, 1, "fraction t", plays=5),
    what=Choice("between", ["directions", "orientations"]),
    turn=Slider(0, 360, "turn (orientations only)", step=1),
    flip=Switch("flip the sign of the end"),
)
def slerp_by_hand(
    p: ArrayLike = (0.72, -0.65, -0.12),
    q: ArrayLike = (-0.30, 0.94, 0.12),
    t: float = 0.2,
    what: str = "directions",
    turn: float = 150.0,
    flip: bool = False,
) -> pyvista.Plotter:
    """Draw slerp and nlerp between two directions, or between two orientations of a spoon.

    Parameters
    ----------
    p, q : array_like, shape (3,)
        The directions; they are normalised. The spoon's tip starts at p, and the axis of its turn
        is that of the arc from p to q (5-1).
    t : float
        Fraction of the way, from 0 to 1.
    what : str
        ``"directions"`` or ``"orientations"``.
    turn : float
        Angle of the spoon's turn in degrees. Directions do not use it.
    flip : bool
        Whether the end is -q instead of q: the opposite direction, but the same orientation.

    Returns
    -------
    pyvista.Plotter
        The scene.

    Raises
    ------
    rotedu.errors.DegenerateError
        If no unique arc joins the ends.
    """
    start, other = (np.asarray(v, float) / np.linalg.norm(v) for v in (p, q))
    spoons = what == "orientations"
    up = np.eye(3)[2]
    joined = spoons or np.linalg.norm(np.cross(start, other)) > SAME
    axis = arc_axis(start, other) if joined else up
    turns = Quaternion.from_axis_angle(axis, np.radians([0, turn])).components
    first, last = turns if spoons else (start, other)
    last = -last if flip else last
    theta = float(angle_between(first, last))
    if spoons and theta > np.pi - SAME:
        raise DegenerateError(ANTIPODAL)
    times = np.linspace(0, 1, 61)

    def tip(end: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return where an end takes the tip of the spoon; a direction is its own tip."""
        return Quaternion(end[..., 0], end[..., 1:]).rotate(start) if spoons else end

    def beyond(point: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the place of an end's label."""
        return 1.1 * point + 0.14 * axis

    end, here, there = tip(last), tip(slerp(first, last, t)), tip(nlerp(first, last, t))
    tenths = tip(nlerp(first, last, np.arange(1, 10) / 10))

    plotter = new_scene(eye=(4.3, 2.3, 2.6), target=(0, 0, 0.08))
    add_sphere(plotter)
    add_line(plotter, tip(slerp(first, last, times)), RESULT, radius=0.012, name="arc")
    add_lines(plotter, [[ORIGIN, x] for x in tenths], CROSS, radius=0.003, name="tenths")
    add_line(plotter, [start, end], CROSS, radius=0.006, name="chord").visibility = not spoons
    circle = turning(start, axis, 2 * np.pi, 96)
    add_line(plotter, circle, NEUTRAL, radius=0.004, name="circle").visibility = spoons
    arrow = add_arrow(plotter, ORIGIN, 1.1 * axis, AXIS, name="axis")
    arrow.visibility = spoons
    for name, point, color, radius in (
        ("p", start, VECTOR, 0.034),
        ("q", other, NEUTRAL, 0.026),
        ("end", end, VECTOR, 0.034),
        ("slerp", here, RESULT, 0.04),
        ("nlerp", there, CROSS, 0.04),
    ):
        add_point(plotter, point, color, radius, name=name)
    held = np.column_stack([start, np.cross(axis, start), axis])
    for name, turned, color in (
        ("spoon at the start", first, VECTOR),
        ("spoon at the end", last, VECTOR),
        ("spoon", slerp(first, last, t), RESULT),
    ):
        matrix = np.eye(4)
        if spoons:
            matrix[:3, :3] = Quaternion(turned[0], turned[1:]).matrix() @ held
        name = place_part(plotter, name, matrix=matrix.T.ravel())
        mesh = teaspoon(stations=41, around=12)
        spoon = plotter.add_mesh(mesh, color=color, smooth_shading=True, name=name)
        spoon.user_matrix, spoon.visibility = matrix, spoons

    for name, text, place, color in (
        ("p", "$p$", None if spoons else beyond(start), VECTOR),
        ("1", "$1$", beyond(start) + 0.12 * axis if spoons else None, VECTOR),
        ("q", "$q$", beyond(end if spoons else other) if not (spoons and flip) else None, VECTOR),
        ("-q", "$-q$", beyond(end) if flip else None, VECTOR),
        ("axis", "axis", 1.2 * axis if spoons else None, AXIS),
        ("held", "sets the axis", 1.1 * other - 0.14 * axis if spoons else None, "black"),
        ("slerp", "slerp", 0.8 * here + 0.1 * axis, RESULT),
        ("nlerp", "nlerp", 1.15 * there - 0.15 * axis, CROSS),
    ):
        add_label(plotter, place, text, color, name=name)

    angle = np.degrees(theta)
    way = 2 * angle if spoons else angle
    start_weight, end_weight = weights(theta, np.array(t))
    read_out(plotter, "angle", angle, "θ between the ends (quaternions: half the turn)", 1, "°")
    read_out(plotter, "way", way, "slerp turns by", 1, "°")
    read_out(plotter, "start_weight", start_weight, "weight of the start", 2)
    read_out(plotter, "end_weight", end_weight, "weight of the end", 2)
    read_out(plotter, "weights_sum", start_weight + end_weight, "sum of the weights", 2)
    read_out(plotter, "speed", speed_of_nlerp(theta, np.array(t)), "speed of nlerp (slerp: 1)", 2)
    draw_chart(
        plotter,
        "weights",
        dict(zip(("start", "end"), weights(theta, times), strict=True)),
        over="t",
        x=(0, 1),
        y=(0, 4),
        label="weights (cut off at 4)",
        colors={"start": VECTOR, "end": NEUTRAL},
    )
    draw_chart(
        plotter,
        "speeds",
        {"slerp": np.ones_like(times), "nlerp": speed_of_nlerp(theta, times)},
        over="t",
        x=(0, 1),
        y=(0, 4),
        label="speed (cut off at 4)",
        colors={"slerp": RESULT, "nlerp": CROSS},
    )
    spoons_say = " Blue spoons show the start and the end, a green one slerp." if spoons else ""
    describe(
        plotter,
        f"A see-through sphere with an arc of {way:.0f} degrees that starts at a blue point p; p"
        " and a second point q can be dragged. A green point, slerp, and a purple point, nlerp,"
        f" travel along it, here at {t:.0%} of the time. Thin rays show that equal steps of"
        f" nlerp are short near the ends of the arc and long in its middle.{spoons_say}",
    )
    return plotter
