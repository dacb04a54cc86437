"""Scenes of page 5 IV: an arrow carried round, and four ways between two orientations."""

from math import isqrt

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.arcs import nlerp, slerp
from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Handles, Slider
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
    add_thin,
    new_scene,
    sphere_scene,
)
from rotedu.scenes.room import camera, clock
from rotedu.scenes.shapes import JUST_INSIDE, fan, surface, teaspoon

__all__ = ["TWO_ORIENTATIONS", "carried_around_by_hand", "four_ways_between", "two_pictures"]

TWO_ORIENTATIONS = ((0, 0, 0), (150, -60, 150))
"""Angles about U, V and W, in degrees, of the orientations of `four_ways_between`."""


SIDES = -1, 1
PICTURES, CAMERAS = ([[0, -0.8 * side, height] for side in SIDES] for height in (0.42, -0.75))


@explorable(
    small=True,
    answer={"roll": 90},
    constants={"pictures": PICTURES, "cameras": CAMERAS},
    roll=Slider(0, 360, "roll of the second camera, °", step=1, plays=6, start=0),
)
def two_pictures(state: State) -> pyvista.Plotter:
    """Draw what two cameras see that look at the same clock, and the cameras, from behind.

    Parameters
    ----------
    roll : float
        How far the second is turned about its line of sight, in degrees.
    """
    plotter = new_scene((-9, 0, 0.3), (0, 0, -0.08), view_angle=14.6, size=LITTLE)
    corners = np.array([[0, 0.66, 0.5], [0, -0.66, 0.5], [0, -0.66, -0.5], [0, 0.66, -0.5]])
    for picture in PICTURES:
        add_line(plotter, np.vstack([corners, corners[:1]]) + picture, NEUTRAL, 0.012)
    looks: dict[str, Look] = {
        "clock *": Mesh(clock(), VECTOR, {"pickable": False}),
        "camera *": Mesh(camera([1, 0, 0], 0.5), NEUTRAL, {"pickable": False}),
        "up *": Arrow(AXIS, 0.03),
    }
    draw(plotter, state, looks, {"*": Text(text="{}")})
    read_out(plotter, "between", "between the orientations", 0, "°", where="picture")
    describe(
        plotter,
        "Two frames side by side, each with a clock, and below each the camera that takes this"
        " picture, seen from behind. The first is upright, the second has rolled by"
        f" {state['inputs']['roll']:.0f} degrees, and its clock has turned the other way.",
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
        "swept": Mesh(surface, AXIS, filled),
        "station 0": Arrow(VECTOR, 0.013),
        "station *": Arrow(NEUTRAL, 0.013),
        "arrow": Arrow(RESULT, 0.015),
        "sector": Mesh(fan, AXIS, filled | {"opacity": 0.6}),
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
