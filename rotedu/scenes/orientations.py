"""Scenes of page 5 IV: an arrow and a teaspoon carried along a curve."""

from math import isqrt

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.arcs import nlerp, slerp
from rotedu.colors import AXIS, CROSS, MATRIX, NEUTRAL, QUATERNION, RESULT, VECTOR
from rotedu.figures import State, describe, draw_chart, explorable, read_out
from rotedu.figures.inputs import Handles, Poses, Slider
from rotedu.general_rotation import matrix_from_euler_angles
from rotedu.ordinary_rotation import transform
from rotedu.orientations import slerp_rotations
from rotedu.quaternions import Quaternion
from rotedu.scenes.looks import Arrow, Ball, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import (
    LITTLE,
    add_label,
    add_line,
    add_point,
    add_sphere,
    add_thin,
    new_scene,
    sphere_scene,
)
from rotedu.scenes.shapes import JUST_INSIDE, U, V, W, fan, teaspoon, triangle_mesh, turning

__all__ = [
    "TWO_ORIENTATIONS",
    "animate",
    "carried_around_by_hand",
    "four_ways_between",
    "routes_by_hand",
    "two_middles",
]

TWO_ORIENTATIONS = ((0, 0, 0), (150, -60, 150))
"""Angles about U, V and W, in degrees, of the orientations of `four_ways_between`."""


LOW, HIGH = 80, 120


@explorable(
    small=True,
    answer={"swing": 100},
    constants={"low": LOW, "high": HIGH},
    swing=Slider(LOW, HIGH, "the gate swings to, °", step=1, plays=5, start=LOW),
)
def two_middles(state: State) -> pyvista.Plotter:
    """Draw the two middles between where a swinging gate would go on to and where it goes.

    Parameters
    ----------
    swing : float
        How far the gate has swung, in degrees.
    """
    plotter = new_scene((0, -1.6, 6), (0, 0.04, 0), view_angle=23.5, size=LITTLE)
    add_line(plotter, turning((1, 0, 0), (0, 0, 1), 2 * np.pi, 60), NEUTRAL, 0.004, "circle")
    looks: dict[str, Look] = {
        "swung": Lines(VECTOR, 0.012),
        "whole way": Lines(RESULT, 0.012),
        "shorter way": Lines(CROSS, 0.012),
        "remembered": Ball(RESULT, 0.06),
        "shorter": Ball(CROSS, 0.06),
        "*": Ball(VECTOR, 0.05),
    }
    texts = {
        "on": Text(VECTOR, "goes on"),
        "remembered": Text(RESULT),
        "shorter": Text(CROSS),
        "*": Text(VECTOR, "{}"),
    }
    draw(plotter, state, looks, texts)
    read_out(plotter, "apart", "middles apart", 0, "°", where="picture")
    swing = state["inputs"]["swing"]
    describe(
        plotter,
        f"A circle. A gate has swung from 0 to {swing:g} degrees; by as far again it would come to"
        f" {2 * swing:g}. Its next place is at 10 degrees. The middle of the way round lies at"
        f" {swing + 5:g} degrees, that of the shorter way"
        + (" on the other side of the circle." if swing > 95 else " in the same place."),
    )
    return plotter


# Out and back, almost; a face of a tetrahedron, a quarter of the sphere, or so little less that no
# rounding makes -180 degrees of 180; a larger triangle; one whose corners run clockwise.
NARROW = ((1, 0, 0.3), (0, 1, 0.3), (1, 1, 0.45))
REVERSING = ((1, 1, -0.9999), (-0.9999, 1, 1), (1, -0.9999, 1))
LARGE = ((1, 1, -1.3), (-1.3, 1, 1), (1, -1.3, 1))
CLOCKWISE = ((1, 0, 0), (0, 0, 1), (0, 1, 0))


@explorable(
    tries={
        "there and back": {"corners": NARROW, "t": 1},
        "the arrow comes back reversed": {"corners": REVERSING, "t": 1},
        "an even larger triangle": {"corners": LARGE, "t": 1},
        "clockwise": {"corners": CLOCKWISE, "t": 1},
    },
    answer={"t": 1},
    constants={"just_inside": JUST_INSIDE},
    corners=Handles(["A", "B", "C"], start=((1, 0, 0), (0, 1, 0), (0, 0, 1))),
    t=Slider(0, 1, "once round, *t*", plays=8, start=0),
)
def carried_around_by_hand(state: State) -> pyvista.Plotter:
    """Draw an arrow carried around a triangle by the rotations of the arcs (5-3).

    Parameters
    ----------
    corners : array_like, shape (3, 3)
        The corners of the triangle; they are normalised.
    t : float
        How far the arrow has come, from 0 to 1. Each side takes a third.
    """
    plotter = sphere_scene(eye=(2.93, 3.26, 3.82))
    filled = {"opacity": 0.3, "lighting": False, "pickable": False}
    looks: dict[str, Look] = {
        "inside": Mesh(lambda points: surface(points, isqrt(len(points))), RESULT, filled),
        "sides": Lines(NEUTRAL, 0.005),
        "way": Lines(RESULT, 0.012),
        "swept": Mesh(lambda points: surface(points, 2), AXIS, filled),
        "station 0": Arrow(VECTOR, 0.013),
        "station *": Arrow(NEUTRAL, 0.013),
        "arrow": Arrow(RESULT, 0.015),
        "sector": Mesh(lambda points: fan(points[0], points[1:]), AXIS, filled | {"opacity": 0.6}),
        "[ABC]": Ball(NEUTRAL),
    }
    draw(plotter, state, looks, {"twist": Text(AXIS, "{}"), "[ABC]": Text()})
    for output, text, digits in (
        ("twist", "twist, once round", 1),
        ("area", "area inside", 1),
        ("difference", "area − twist", 0),
    ):
        read_out(plotter, output, text, digits, "°", where="picture")
    describe(
        plotter,
        "A see-through sphere with a triangle ABC, whose corners can be dragged. A blue arrow"
        " at A points to B. A green arrow is carried along the three sides, always at the same"
        " angle to the side, and leaves grey arrows and an orange ribbon on its way. Back at A it"
        " is turned against the blue one; the sector between the two is filled in orange, and the"
        " triangle in green.",
    )
    return plotter


def surface(points: list[list[float]], rows: int) -> pyvista.PolyData:
    """Fill a surface between so many lines of points, all points in one array, shape (n, 3)."""
    i = np.arange(len(points)).reshape(rows, -1)
    p, q, r, s = (k.ravel() for k in (i[:-1, :-1], i[:-1, 1:], i[1:, :-1], i[1:, 1:]))
    return triangle_mesh(points, np.hstack([(p, q, r), (q, s, r)]).T)


def about_v(*degrees: float) -> list[list[float]]:
    """Return quaternions of a body that points outwards like the hand of a clock, seen along V."""
    turns = Quaternion.from_axis_angle(V, np.radians(degrees))
    lean = Quaternion.from_axis_angle(U, np.radians(55))
    upwards = Quaternion.from_axis_angle(W, np.radians(90))
    rounded: list[list[float]] = (turns * lean * upwards).components.round(4).tolist()
    return rounded


ROUTE = (
    (0.3, -0.11, -0.61, 0.72),
    (0.42, 0.53, -0.25, 0.69),
    (-0.18, -0.04, -0.88, 0.44),
    (0.1, -0.1, -0.86, 0.48),
)


@explorable(
    tries={
        "a swing to 90°": {"poses": about_v(0, 90, 10, -60), "u": 0.1625},
        "a swing to 100°": {"poses": about_v(0, 100, 10, -60), "u": 0.1625},
        "once right round": {"poses": about_v(0, 90, 180, 270), "u": 0.1625},
    },
    constants={"signs": ["cannot agree", "can agree"]},
    poses=Poses([f"spoon {k}" for k in range(4)], start=ROUTE),
    u=Slider(0, 1, "once round, *u*", step=0.0125, plays=10, start=0.3625),
)
def routes_by_hand(state: State) -> pyvista.Plotter:
    """Draw a closed curve of orientations along its route, and by shortest ways of matrices.

    Parameters
    ----------
    poses : array_like, shape (4, 4)
        Four poses as quaternions; they are normalised. The signs do not count.
    u : float
        Place on the whole curve, from 0 to 1.
    """
    eye, target = 0.06 * W - 16 * V, 0.06 * W
    plotter = new_scene(eye, target, view_angle=14.25, size=(400, 620), swing=25)
    add_sphere(plotter)
    # Where both are the same, the route is seen.
    looks: dict[str, Look] = {
        "route": Lines(RESULT, 0.014),
        "route *": spoon(RESULT),
        "shortest": Lines(CROSS, 0.01),
        "shortest *": spoon(CROSS),
        "*": spoon(VECTOR),
    }
    draw(plotter, state, looks, {"R_*": Text(VECTOR)})
    for output, text in (
        ("turn", "from Double by up to"),
        ("apart", "routes apart by up to"),
        ("signs", "signs"),
    ):
        read_out(plotter, output, text, 1, "°", where="picture")
    draw_chart(
        plotter,
        "angles",
        over="u",
        x=(0, 1),
        y=(0, 180),
        label="turned from *R₀*, degrees",
        colors={"route": RESULT, "shortest": CROSS, "marks": VECTOR},
        marks=["*R₀*", "*R₁*", "*R₂*", "*R₃*"],
        dashed=["shortest"],
    )
    describe(
        plotter,
        "Four blue teaspoons, R0 to R3, stand round a see-through ball and can be turned. On the"
        " ball, spoons in the same poses lie on a closed curve of orientations: blue ones at the"
        " given poses, green ones in between, and a larger one on its way. A purple line with"
        " purple spoons, by the shortest way between matrices, swings out where the longest turn"
        " is more than half a turn.",
    )
    return plotter


def spoon(color: str, opacity: float = 1.0) -> Mesh:
    """Return what a small spoon looks like."""
    style = {"smooth_shading": True, "pickable": False, "opacity": opacity}
    return Mesh(teaspoon(stations=61, around=20), color, style)


def four_ways_between() -> pyvista.Plotter:
    """Draw the path of a spoon's tip between two orientations for several interpolations."""
    angles = np.deg2rad(TWO_ORIENTATIONS)
    r1, r2 = matrix_from_euler_angles(*angles.T)[:, :3, :3]
    q1, q2 = (Quaternion.from_matrix(r).components for r in (r1, r2))
    q2 = q2 if q1 @ q2 > 0 else -q2

    def tips(q: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return where quaternions take the tip of the spoon, (1, 0, 0)."""
        return Quaternion(q[:, 0], q[:, 1:]).rotate([1, 0, 0])

    t = np.linspace(0, 1, 97)
    euler = matrix_from_euler_angles(*(angles[0] + t[:, np.newaxis] * (angles[1] - angles[0])).T)
    short, long = slerp_rotations(r1, r2, t)[:, :, 0], tips(slerp(q1, -q2, t))

    plotter = sphere_scene(eye=(1.15, 3.3, 4.3), target=(0, 0, 0.05))
    for turn, name in ((r1, "$R_1$"), (r2, "$R_2$")):
        spoon = teaspoon(stations=61, around=20)
        spoon.points = transform(turn, spoon.points)
        plotter.add_mesh(spoon, color=VECTOR, smooth_shading=True)
        add_label(plotter, 1.15 * turn[:, 0], name, VECTOR)
    add_line(plotter, short, RESULT, radius=0.011)
    add_dashes(plotter, euler[:, :3, 0], CROSS, dash=4, gap=2)
    add_dashes(plotter, long, NEUTRAL, dash=1, gap=1, radius=0.013)
    between = np.arange(1, 8) / 8
    for place in tips(slerp(q1, q2, between)):
        add_point(plotter, place, RESULT, radius=0.03)
    uneven = tips(nlerp(q1, q2, between))
    for place in uneven:
        # Slightly outside the sphere, so that a ball at the same place does not hide it.
        bounds = np.repeat(1.02 * place, 2) + 0.02 * np.array([-1, 1, -1, 1, -1, 1])
        add_thin(plotter, pyvista.Box(bounds), CROSS)
    for place, size, name, color in (
        (short[46], 1.27, "slerp, matrices", RESULT),
        (uneven[1], 1.17, "nlerp", CROSS),
        (euler[40, :3, 0], 1.22, "Euler angles", CROSS),
        (long[48], 1.2, "slerp, the long way", NEUTRAL),
    ):
        add_label(plotter, size * place, name, color)
    describe(
        plotter,
        "Two blue teaspoons, R1 and R2, cross at the centre of a see-through sphere that their tips"
        " touch. A green line leads from tip to tip the short way, with balls at equal times and"
        " small purple cubes near them: behind in the first half, ahead in the second. A broken"
        " purple line, for the Euler angles, swings out to the other side. A dotted grey line goes"
        " the long way, close to the lower rim of the sphere.",
    )
    return plotter


def add_dashes(
    plotter: pyvista.Plotter,
    path: NDArray[np.float64],
    color: str,
    dash: int,
    gap: int,
    radius: float = 0.009,
) -> None:
    """Add a broken line: draw `dash` steps of a path, leave out `gap` steps, and so on."""
    starts = range(0, len(path) - dash, dash + gap)
    dashes = [pyvista.MultipleLines(path[start : start + dash + 1]) for start in starts]
    tubes = [line.tube(radius=radius, n_sides=8, capping=True) for line in dashes]
    add_thin(plotter, pyvista.merge(tubes), color)


POSES = (
    (0.6, 0.71, -0.19, -0.32),
    (0.67, 0.2, -0.58, -0.41),
    (0.17, 0.9, -0.3, -0.24),
    (0.96, 0.17, -0.06, -0.22),
    (0.86, -0.45, -0.13, -0.2),
)
"""Quaternions whose signs agree. From the last to the first is the widest turn, 147 degrees."""
SMALL = tuple((w + 2, x + 1, y - 1, z - 1) for w, x, y, z in POSES)
FLIPPED = (*POSES[:2], (-0.17, -0.9, 0.3, 0.24), *POSES[3:])
ALIKE = (*POSES[:4], (0.96, 0.12, -0.08, -0.22))
MOST_POSES = 6
FILMS = {
    "slerp": NEUTRAL,
    "squad": QUATERNION,
    "spline of q": QUATERNION,
    "the paper's": MATRIX,
    "spline of M": MATRIX,
}
"""The curves of `animate`, and their colours."""
JUMPY = ("squad", "the paper's")
"""Those whose velocity does not jump, but whose acceleration does."""
MIDDLES = [(x, 0, -0.96) for x in (-2.64, -1.32, 0, 1.32, 2.64)]
"""Where the films are, below the buttons of a phone."""
FILMED = 0.63
"""The radius of a ball around a film; on its line, a spoon has as much room as there is."""


@explorable(
    tries={
        "small turns": {"poses": SMALL},
        "one sign changed": {"poses": FLIPPED},
        "two poses alike": {"poses": ALIKE, "t": 0.62},
        "handles of one third": {"fraction": 1 / 3},
    },
    constants={"most": MOST_POSES, "jumpy": JUMPY, "middles": MIDDLES, "radius": FILMED},
    poses=Poses([f"spoon {k}" for k in range(MOST_POSES)], least=4, most=MOST_POSES, start=POSES),
    t=Slider(0, 1, "time, once round", plays=6, start=0.885),
    fraction=Slider(0.2, 0.5, "handles of the paper's curve", step=0.005, row=False, start=1 / 2),
)
def animate(state: State) -> pyvista.Plotter:
    """Draw five films of a spoon that go through the same poses at the same times.

    Parameters
    ----------
    poses : array_like, shape (n, 4)
        From 4 to 6 poses as quaternions; they are normalised. The last leads to the first.
    t : float
        The time, from 0 to 1. A film shows the picture next to it.
    fraction : float
        As for `rotedu.control_points.control_points`, for the paper's curve.
    """
    # From far away, so that spoons in the same pose look the same wherever they are.
    plotter = new_scene(eye=-32 * V + 0.1 * W, target=0.1 * W, view_angle=8, swing=15)
    timeline: dict[str, Look] = {
        "rail": Lines(NEUTRAL, 0.012),
        "ticks": Lines(NEUTRAL, 0.012),
        "R_*": spoon(VECTOR),
        "again": spoon(VECTOR, opacity=0.3),
    }
    draw(plotter, state, timeline, {"R_*": Text(VECTOR), "again": Text(VECTOR, "$R_0$")})
    for middle, (name, ink) in zip(MIDDLES, FILMS.items(), strict=True):
        add_sphere(plotter, middle, FILMED, around=24)
        film: dict[str, Look] = {f"{name}, tip": Lines(ink, 0.013), name: spoon(ink)}
        draw(plotter, state, film, {name: Text(ink, "{}")})

    for chart, top, text in (
        ("speeds", 400.0, "speed up to 400°/s"),
        ("accelerations", 2000.0, "acceleration up to 2000°/s²"),
    ):
        draw_chart(
            plotter,
            chart,
            over="t",
            x=(0, 1),
            y=(0, top),
            label=text,
            colors=FILMS | {"marks": VECTOR},
            marks=[f"*R{chr(ord('₀') + k)}*" for k in range(MOST_POSES)],
            dashed=JUMPY,
        )
    for where, output, text, unit in (
        ("picture", "speed", "speed, left to right", "°/s"),
        ("picture", "fastest", "fastest", "°/s"),
        ("folded", "corner", "velocity of slerp jumps by", "°/s"),
        ("folded", "jumps", f"acceleration of {' and '.join(JUMPY)} jumps by", "°/s²"),
    ):
        read_out(plotter, output, text, digits=0, unit=unit, where=where)
    n = len(state["inputs"]["poses"])
    describe(
        plotter,
        f"{n} blue teaspoons, R0 to R{n - 1}, stand in a row above a line of time, which ends with"
        " the first again. Below, five glass balls in a row hold a spoon each, at the same moment"
        " of five films. A line on each ball is the way of the spoon's tip: it has corners for"
        " slerp, in grey; it is smooth for squad and for the spline of quaternions, in violet, and"
        " for the paper's curve, in ochre; for the spline of matrices, in ochre, too, it swings"
        " round where the others go straight.",
    )
    return plotter
