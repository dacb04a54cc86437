"""Scenes of Chapter 2: two mirrors and the two quaternions of a rotation."""

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import Slider, describe, explorable, read_out
from rotedu.figures.frames import LAMP, place_grip, place_part
from rotedu.general_rotation import homogeneous
from rotedu.ordinary_rotation import rotate, rotation_matrix
from rotedu.quaternions import Quaternion
from rotedu.scenes.parts import (
    ORIGIN,
    add_arrow,
    add_label,
    add_line,
    add_point,
    new_scene,
    teaspoon,
    triangle_mesh,
    turning,
)

W = np.array([0.0, 0.0, 1.0])
# An arc of fewer degrees has no room for the head of its arrow.
SMALLEST_ARC = 8.0
# What is within this many degrees of its start is back.
BACK = 0.5
# Length of the ribbon.
RIBBON = 1.1


def letter_f(size: float = 0.5, thickness: float = 0.07, border: float = 0.0) -> pyvista.PolyData:
    """Model the letter F, which is not its own mirror image, lying in the plane of U and V.

    Parameters
    ----------
    size : float
        Height of the letter, along V.
    thickness : float
        Extent of the letter along W.
    border : float
        Width by which the letter grows on all sides.

    Returns
    -------
    pyvista.PolyData
        A triangle mesh with its middle at the origin.
    """
    bars = [(-0.32, -0.12, -0.5, 0.5), (-0.12, 0.36, 0.3, 0.5), (-0.12, 0.22, -0.1, 0.1)]
    grow = border / size * np.array([-1, 1, -1, 1])
    half = thickness / size / 2
    boxes = [pyvista.Box((*(bar + grow), -half, half)) for bar in bars]
    solid = pyvista.merge(boxes).extract_surface(algorithm=None).triangulate()
    letter: pyvista.PolyData = solid.scale(size)
    return letter


@explorable(
    model="twoMirrors",
    constants={"lamp": LAMP},
    first=Slider(0, 180, "mirror 1, °", step=1),
    second=Slider(0, 180, "mirror 2, °", step=1),
    # At these strides no letter lies on another, nor in a mirror.
    both=Slider(0, 360, "turn both by, °", step=1, stride=60, plays=12),
    letter=Slider(-180, 180, "blue letter, °", step=1),
)
def two_mirrors_by_hand(
    first: float = 0, second: float = 60, both: float = 0, letter: float = -30
) -> pyvista.Plotter:
    """Draw a letter mirrored twice, which turns by twice the angle between the mirrors.

    Parameters
    ----------
    first, second : float
        Angle in degrees of each mirror about the W axis, from the U axis.
    both : float
        Angle in degrees by which both mirrors turn further.
    letter : float
        Angle in degrees of the letter.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """

    def out(angle: float, radius: float = 1.0) -> NDArray[np.float64]:
        """Return a point off the axis."""
        return rotate([radius, 0, 0], W, np.deg2rad(angle))

    between = second - first
    angles = (first + both, second + both)
    m1, m2 = (Quaternion(0, out(angle + 90)) for angle in angles)
    start = rotation_matrix(W, np.deg2rad(letter))
    once = m1 * Quaternion(0, start.T) * m1
    twice = m2 * once * m2

    plotter = new_scene(eye=(-3.6, -2.1, 6.1), target=(0, 0, 0.05), view_angle=25)
    add_arrow(plotter, -0.15 * W, 0.5 * W, AXIS)
    add_label(plotter, -0.42 * W, r"$\hat n$", AXIS)
    circle = turning(out(-180, 1.05), W, 2 * np.pi)
    ring = add_line(plotter, circle, NEUTRAL, 0.004, name="ring")
    ring.prop.opacity = 0.4
    place_grip(plotter, "letter", path=circle)
    # The second mirror is longer: both show where they coincide.
    for angle, m, k, size in zip(angles, (m1, m2), (1, 2), (1.4, 1.65), strict=True):
        foot, top = out(angle, size), 0.3 * W
        edge = np.stack([ORIGIN, foot, foot + top, top])
        sheet = triangle_mesh(edge, [[0, 1, 2], [0, 2, 3]])
        name = place_part(plotter, f"mirror {k}", points=edge)
        plotter.add_mesh(
            sheet, color=NEUTRAL, opacity=0.45, lighting=False, pickable=False, name=name
        )
        # A mirror acts as if it went on beyond the axis.
        add_line(plotter, [-foot, *edge], NEUTRAL, radius=0.004, name=f"edge {k}")
        add_arrow(plotter, foot + top, foot + top + 0.3 * m.v, NEUTRAL, 0.01, name=f"m {k}")
        add_label(plotter, foot + top + 0.42 * m.v, rf"$\hat m_{k}$", name=f"m {k}")

    # Where letters coincide, each shows: blue as a border, and purple lets through what is below.
    for name, images, color, thickness, border, opacity in (
        ("letter", start.T, VECTOR, 0.01, 0.02, 1.0),
        ("image", once.v, CROSS, 0.03, 0.0, 0.5),
        ("image of the image", twice.v, RESULT, 0.02, 0.0, 1.0),
    ):
        mesh = letter_f(0.48, thickness, border)
        mesh.points = rotate(mesh.points, W, -np.pi / 2) + out(0, 1.05)
        matrix = homogeneous(images.T)
        name = place_part(plotter, name, matrix=matrix.T.ravel())
        actor = plotter.add_mesh(mesh, color=color, opacity=opacity, lighting=False, name=name)
        actor.user_matrix = matrix

    for begin, angle, radius, text, color, name in (
        (angles[0], between, 0.45, r"$\theta/2$", NEUTRAL, "half"),
        (letter, 2 * between, 1.5, r"$\theta$", RESULT, "whole"),
    ):
        drawn = abs(angle) >= SMALLEST_ARC
        shown = angle if drawn else SMALLEST_ARC
        arc = turning(out(begin, radius), W, np.deg2rad(shown), steps=60)
        ahead = np.sign(shown) * out(begin + shown + 90)
        add_line(plotter, arc, color, radius=0.008, name=name).visibility = drawn
        head = add_arrow(plotter, arc[-1] - 0.1 * ahead, arc[-1], color, 0.01, f"{name}, head")
        head.visibility = drawn
        place = out(begin + angle / 2, radius + 0.16) if drawn else None
        add_label(plotter, place, text, name=name)

    read_out(plotter, "between", between, "from mirror 1 to mirror 2", 0, "°")
    read_out(plotter, "turned", 2 * between, "from blue to green letter", 0, "°")
    read_out(plotter, "home", is_back(2 * between, 360), "green letter on blue letter", loud="yes")
    read_out(plotter, "q", -(m2 * m1).components, "q = −m₂m₁ (w x y z)", 2)
    describe(
        plotter,
        f"Two upright mirrors meet at an axis n, {abs(between):.0f} degrees apart. A blue letter F"
        " lies beside them. Its image in the first mirror is purple, in mirror writing. The image"
        " of this image in the second mirror is green and reads as an F again:"
        f" it is the blue one, turned by {abs(2 * between):.0f} degrees.",
    )
    return plotter


FRAME = 10.0
"""Degrees from one frame of `double_cover_by_hand` to the next."""


@explorable(theta=Slider(0, 720, "turned by θ, °", step=FRAME, stride=90, plays=12))
def double_cover_by_hand(theta: float = 360) -> pyvista.Plotter:
    """Draw a spoon that turns on a ribbon, and its quaternion on the edge of a band.

    The spoon points to a place on a ring. There q lies cos(theta / 2) up and sin(theta / 2) out,
    on one edge of the band; -q lies opposite, on the other edge.

    Parameters
    ----------
    theta : float
        Angle in degrees by which the spoon has turned, from 0 to 720.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    angle = np.deg2rad(theta)
    q = Quaternion.from_axis_angle(W, angle)
    matrix = rotation_matrix(W, angle)

    plotter = new_scene(eye=(3.45, 2.25, 3.75), target=(0.0, 0.04, 0.11))
    rounds = np.linspace(0, 2 * np.pi, 97)
    edges = [on_band(rounds, side) for side in (1.0, 0.0, -1.0)]
    plotter.add_mesh(sheet(edges), color=NEUTRAL, opacity=0.5, smooth_shading=True, pickable=False)
    for edge, color, radius in zip(
        edges, (NEUTRAL, VECTOR, NEUTRAL), (0.005, 0.009, 0.005), strict=True
    ):
        add_line(plotter, edge, color, radius)
    # Not before the first frame after the start has the way a length.
    way = np.deg2rad(np.arange(0, max(theta, FRAME) + FRAME / 4, FRAME / 2))
    add_line(plotter, on_band(way, 1), RESULT, radius=0.018, name="way").visibility = theta >= FRAME

    # The axis leaves out the ribbon.
    add_line(plotter, [-0.25 * W, ORIGIN], AXIS, radius=0.007)
    add_arrow(plotter, RIBBON * W, (RIBBON + 0.2) * W, AXIS, radius=0.007)
    add_label(plotter, [0, 0.1, RIBBON + 0.2], r"$\hat n$", AXIS)
    spoon = teaspoon(stations=61, around=20)
    spoon.points = 0.3 * (spoon.points - [-1, 0, 0.05])
    actor = plotter.add_mesh(spoon, color=VECTOR, smooth_shading=True, name="spoon")
    actor.user_matrix = homogeneous(matrix)
    add_line(plotter, [[0, -0.2, RIBBON], [0, 0.2, RIBBON]], NEUTRAL, radius=0.02)
    down = np.linspace(1, 0, 49)
    middle = np.outer(RIBBON * down, W)
    for name, side, opacity in (("left", 0.08, 1.0), ("right", -0.08, 0.35)):
        border = middle + rotate([0, side, 0], W, (1 - down) * angle)
        plotter.add_mesh(
            sheet([middle, border]),
            color=VECTOR,
            opacity=opacity,
            lighting=False,
            pickable=False,
            name=f"ribbon, {name}",
        )

    ends = {side: on_band(angle, side) for side in (1.0, -1.0)}
    add_line(plotter, list(ends.values()), NEUTRAL, radius=0.014, name="stick")
    ahead = 0.2 * np.cross(W, on_band(angle, 0))
    add_point(plotter, on_band(angle, 0), VECTOR, radius=0.035, name="rotation")
    for side, color, text, start in ((1.0, RESULT, "q", "1"), (-1.0, CROSS, "-q", "-1")):
        add_point(plotter, ends[side], color, radius=0.045, name=text)
        add_label(plotter, on_band(angle, 1.3 * side) + ahead, f"${text}$", color, name=text)
        add_point(plotter, on_band(0, side), NEUTRAL, radius=0.03)
        add_line(plotter, [on_band(0, side), on_band(0, 1.35 * side)], NEUTRAL, radius=0.007)
        add_label(plotter, on_band(0, 1.7 * side), f"${start}$")

    read_out(plotter, "spoon_back", is_back(theta, 360), "spoon is back", loud="yes")
    read_out(plotter, "q_back", is_back(theta, 720), "q is back", loud="yes")
    read_out(plotter, "twists", theta / 360, "twists of the ribbon", 2)
    read_out(plotter, "half", theta / 2, "θ/2", 0, "°")
    read_out(plotter, "q", q.components, "q (w x y z)", 2)
    read_out(plotter, "matrix", matrix, "matrix", 2)
    describe(
        plotter,
        "A spoon hangs on a ribbon that runs up along an axis n to a fixed bar. It points to a ring"
        " about the axis. A band runs along the ring and makes half a twist in one round."
        f" The spoon has turned by {theta:.0f} degrees, and the ribbon is twisted by as much."
        " A green line on the edge of the band leads from 1 to q, beside the tip of the spoon; -q"
        " is on the opposite edge.",
    )
    return plotter


def on_band(theta: ArrayLike, side: float) -> NDArray[np.float64]:
    """Return where the quaternion (side 1) or its opposite (side -1) of a turn is on the band.

    Parameters
    ----------
    theta : array_like, shape (...)
        Angle in radians of the turn about the W axis.
    side : float
        Fraction of the way from the ring to q.

    Returns
    -------
    ndarray, shape (..., 3)
        The points. The ring has radius 1, and the band is 0.66 wide.
    """
    w, s = 0.33 * side * np.cos(np.divide(theta, 2)), 0.33 * side * np.sin(np.divide(theta, 2))
    return np.stack([(1 + s) * np.cos(theta), (1 + s) * np.sin(theta), w], axis=-1)


def sheet(lines: ArrayLike) -> pyvista.PolyData:
    """Span a surface between neighbouring lines, shape (k, n, 3)."""
    grid = pyvista.StructuredGrid(*np.moveaxis(np.asarray(lines), -1, 0))
    surface: pyvista.PolyData = grid.extract_surface(algorithm=None)
    return surface


def is_back(angle: float, lap: float) -> bool:
    """Tell whether a turn, in degrees, ends where it began: after whole laps."""
    return (abs(angle) + BACK) % lap < 2 * BACK
