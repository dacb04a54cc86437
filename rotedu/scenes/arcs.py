"""Scenes of page 5 I: a camera, an arc and its axis, and slerp beside nlerp."""

from collections.abc import Sequence

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import angle_between, arc_axis, nlerp, slerp
from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.errors import DegenerateError
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
    stack_on_phone,
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
    normalised,
    sphere_scene,
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
    points = normalised(targets)

    plotter = sphere_scene(eye=(4.3, -1.9, 3.2), target=(0, 0, 0.06))
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


ANTIPODAL = "the ends are antipodal: no unique arc joins them"
# From the middle of the sphere to that of the spoons, to the right of the picture.
BESIDE = np.array([2.3, 0, 0])
LOOK_AT = np.array([1.02, 0, 0])
EYE = LOOK_AT + 9.8 * np.array([0, -np.cos(np.radians(20)), np.sin(np.radians(20))])
# Spoons closer than this, in radians, share one name.
CLOSE = np.radians(25)


@explorable(
    model="slerp",
    constants={"antipodal": ANTIPODAL},
    tries={
        "nlerp hurries in the middle": {"t": 0.5},
        "flip the sign of the end": {"flip": True, "t": 0.5},
        "just before the opposite point": {"q": (0.951, 0.038, -0.356), "t": 0.5},
        "just past it": {"q": (0.951, 0.244, -0.194), "t": 0.5},
    },
    p=Handles("p"),
    q=Handles("q"),
    t=Slider(0, 1, "fraction t", plays=5),
    flip=Switch("flip the sign of the end"),
)
def slerp_by_hand(
    p: ArrayLike = (-0.951, -0.141, 0.275),
    q: ArrayLike = (0.789, -0.263, -0.555),
    t: float = 0.2,
    flip: bool = False,
) -> pyvista.Plotter:
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

    Returns
    -------
    pyvista.Plotter
        The scene.

    Raises
    ------
    rotedu.errors.DegenerateError
        If the ends are opposite.
    """
    start, other = (np.asarray(v, float) / np.linalg.norm(v) for v in (p, q))
    end = -other if flip else other
    theta = float(angle_between(start, end))
    if theta > np.pi - SAME:
        raise DegenerateError(ANTIPODAL)
    axis = axis_across(start, other)
    held = np.column_stack([start, np.cross(axis, start), axis])
    times = np.linspace(0, 1, 61)
    arc = slerp(start, end, times)
    here, there = slerp(start, end, t), nlerp(start, end, t)
    tenths = nlerp(start, end, np.arange(1, 10) / 10)

    def turned(point: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return where the quaternion of a point takes the spoon."""
        by = Quaternion(point @ start, np.cross(start, point)).matrix()
        return np.asarray(by @ held)

    plotter = new_scene(eye=EYE, target=LOOK_AT, view_angle=16, size=(720, 400))
    limit_turning(plotter, 20)
    stack_on_phone(plotter, (10, 34, 374, 330, 1), (358, 52, 370, 296, 0.75))
    add_sphere(plotter)
    add_line(plotter, arc, RESULT, radius=0.014, name="arc")
    place_grip(plotter, "t", path=arc)
    add_lines(plotter, [[ORIGIN, x] for x in tenths], CROSS, radius=0.003, name="tenths")
    add_line(plotter, [start, end], CROSS, radius=0.006, name="chord")
    for name, point, color, radius in (
        ("p", start, VECTOR, 0.036),
        ("q", other, NEUTRAL, 0.028),
        ("end", end, VECTOR, 0.036),
        ("slerp", here, RESULT, 0.044),
        # Smaller: where both are in one place, it lies within the other.
        ("nlerp", there, CROSS, 0.038),
    ):
        add_point(plotter, point, color, radius, name=name)

    circle = turning(start, axis, 2 * np.pi, 96)
    add_line(plotter, BESIDE + circle, NEUTRAL, radius=0.004, name="circle")
    tips = np.array([turned(x)[:, 0] for x in arc])
    add_line(plotter, BESIDE + tips, RESULT, radius=0.014, name="sweep")
    add_arrow(plotter, BESIDE, BESIDE + 0.5 * axis, AXIS, name="axis")
    for name, point, color, size in (
        ("spoon at the start", start, VECTOR, 1),
        ("spoon at the end", end, VECTOR, 1),
        ("spoon by slerp", here, RESULT, 1),
        # Smaller, to be seen in front of the one by slerp.
        ("spoon by nlerp", there, CROSS, 0.75),
    ):
        add_hand(plotter, turned(point), color, name, size)

    def beyond(point: NDArray[np.float64], distance: float) -> NDArray[np.float64]:
        """Return the place of an end's label, on the great circle where the arc is not."""
        ahead = np.cross(axis, point)
        return 1.06 * point + distance * (-ahead if flip else ahead)

    last = tips[-1]
    for name, text, place, color in (
        ("p", "$p$", beyond(start, -0.17), VECTOR),
        ("q", "$q$", beyond(other, 0.17), VECTOR),
        ("-q", "$-q$", beyond(end, 0.17) if flip else None, VECTOR),
        ("slerp", "slerp", 0.8 * here + 0.1 * axis, RESULT),
        ("nlerp", "nlerp", 1.15 * there - 0.15 * axis, CROSS),
        ("start", "start", BESIDE + 1.2 * start, VECTOR),
        (
            "end of turn",
            "end",
            BESIDE + 1.2 * last if angle_between(start, last) > CLOSE else None,
            VECTOR,
        ),
    ):
        add_label(plotter, place, text, color, name=name)

    angle = np.degrees(theta)
    start_weight, end_weight = weights(theta, np.array(t))
    for name, value, text, digits, unit, where in (
        ("angle", angle, "arc", 1, "°", "picture"),
        ("way", 2 * angle, "spoon turns by", 1, "°", "picture"),
        ("speed", speed_of_nlerp(theta, np.array(t)), "nlerp's speed (slerp: 1)", 2, "", "picture"),
        ("start_weight", start_weight, "weight of the start", 2, "", "folded"),
        ("end_weight", end_weight, "weight of the end", 2, "", "folded"),
        ("weights_sum", start_weight + end_weight, "sum of the weights", 2, "", "folded"),
    ):
        read_out(plotter, name, value, text, digits, unit, where=where)
    draw_chart(
        plotter,
        "weights",
        dict(zip(("start", "end"), weights(theta, times), strict=True)),
        over="t",
        x=(0, 1),
        y=(0, 4),
        label="weights of the ends (above 4 not shown)",
        colors={"start": VECTOR, "end": NEUTRAL},
    )
    draw_chart(
        plotter,
        "speeds",
        {"slerp": np.ones_like(times), "nlerp": speed_of_nlerp(theta, times)},
        over="t",
        x=(0, 1),
        y=(0, 4),
        label="speed (above 4 not shown)",
        colors={"slerp": RESULT, "nlerp": CROSS},
    )
    describe(
        plotter,
        f"Left, a see-through sphere with an arc of {angle:.0f} degrees from a point p to a point"
        f" {'minus q' if flip else 'q'}. A green point, slerp, and a purple point, nlerp, travel"
        f" along it, here at {t:.0%} of the time. Thin rays show that equal steps of nlerp are"
        " short near the ends of the arc and long in its middle. Right, spoons point outwards from"
        f" one place like the hands of a clock: blue ones at the start and, {2 * angle:.0f} degrees"
        " on, at the end; a green one that slerp turns, and a purple one that nlerp turns.",
    )
    return plotter


def axis_across(p: NDArray[np.float64], q: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the axis of the arc from p to q or, if they lie on one line, some axis across it."""
    if np.linalg.norm(np.cross(p, q)) > SAME:
        return arc_axis(p, q)
    return arc_axis(p, np.eye(3)[np.argmin(abs(p))])


def add_hand(
    plotter: pyvista.Plotter, rotation: NDArray[np.float64], color: str, name: str, size: float
) -> None:
    """Add a spoon that points outwards like the hand of a clock."""
    spoon = teaspoon(stations=41, around=12)
    spoon.points = 0.44 * size * spoon.points + np.array([0.56, 0, 0], spoon.points.dtype)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, BESIDE
    name = place_part(plotter, name, matrix=matrix.T.ravel())
    plotter.add_mesh(spoon, color=color, smooth_shading=True, name=name).user_matrix = matrix
