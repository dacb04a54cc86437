"""Scenes of Chapter 3: a turned vector and a turned mesh."""

from collections.abc import Sequence

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import Handles, Slider, describe, explorable, read_out
from rotedu.figures.frames import place_grip, place_part
from rotedu.ordinary_rotation import rotate, rotation_matrix, transform
from rotedu.scenes.parts import (
    NARROW,
    ORIGIN,
    SIZE,
    add_arrow,
    add_label,
    add_line,
    add_lines,
    add_point,
    fan,
    new_scene,
    teaspoon,
    turning,
)

VECTOR_1, AXIS_1 = (1.0, -0.3, 0.75), (-0.15, 0.1, 1.0)
"""The vector and the axis of Fig. 1."""
VECTOR_BY_HAND, AXIS_BY_HAND = (0.8, -0.6, 0.4), (0.4, 0.2, 1.2)
"""Those of the figure that answers the hand, where the circle lies all round the origin."""
# A shorter piece is not drawn.
HAIR = 1e-6


def figure_1(
    vector: ArrayLike = VECTOR_1, axis: ArrayLike = AXIS_1, angle: float = np.deg2rad(75)
) -> pyvista.Plotter:
    """Draw Fig. 1: a vector turned about an axis, and the three terms of (3-1).

    Parameters
    ----------
    vector : array_like, shape (3,)
        The vector r.
    axis : array_like, shape (3,)
        The rotation axis n; it is normalised.
    angle : float
        The rotation angle in radians.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    n = np.asarray(axis, float) / np.linalg.norm(axis)
    plotter = turned_vector(np.asarray(vector, float), n, angle)
    describe(
        plotter,
        f"A vector r and its copy r', turned by {np.rad2deg(angle):.0f} degrees about the axis n."
        " The tips of both lie on a circle around the axis. Three arrows, head to tail, lead"
        " from the origin to the tip of r': one along r, one parallel to n, and one"
        " perpendicular to both.",
    )
    return plotter


# Height of what Figure 1 looks at, its field of view, and its size; as drawn in the paper, and with
# room for any axis and any vector of that length.
AS_DRAWN, ALL_ROUND = (0.48, 21.5, SIZE), (0.01, 24.8, (600, 504))

# To the right in the picture, clear of the ring around a tip.
ASIDE = np.array([-0.03, 0.13, 0])


def turned_vector(
    r: NDArray[np.float64],
    n: NDArray[np.float64],
    angle: float,
    room: tuple[float, float, tuple[int, int]] = AS_DRAWN,
) -> pyvista.Plotter:
    """Draw a vector turned about a unit vector, and the terms of (3-1)."""
    height, view_angle, size = room
    center = (r @ n) * n
    turned = rotate(r, n, angle)
    spoke = r - center

    plotter = new_scene((4.5, 0.95, height + 2.42), (0.0, 0.03, height), view_angle, size)
    add_label(plotter, (0, 0.13, -0.1), "$O$")

    add_line(plotter, turning(r, n, 2 * np.pi, 80), NEUTRAL, radius=0.005, name="circle")
    sector = fan(center, center + turning(0.42 * spoke, n, angle))
    name = place_part(plotter, "sector", points=sector.points)
    plotter.add_mesh(sector, color=NEUTRAL, opacity=0.5, lighting=False, pickable=False, name=name)
    spokes = [np.stack([center, tip]) for tip in (r, turned)]
    add_lines(plotter, spokes, NEUTRAL, radius=0.004, name="spokes")
    add_point(plotter, center, NEUTRAL, radius=0.022, name="centre")
    add_line(plotter, [ORIGIN, center], NEUTRAL, radius=0.012, name="height")
    add_label(plotter, center + rotate(0.28 * spoke, n, 0.5 * angle), r"$\theta$")
    add_label(plotter, 0.4 * center - 0.16 * spoke, r"$\vec r_\parallel$")
    add_label(plotter, center + 0.72 * spoke + 0.09 * n, r"$\vec r_\perp$")

    add_arrow(plotter, ORIGIN, 1.1 * n, AXIS, radius=0.006, name="n")
    add_arrow(plotter, ORIGIN, r, VECTOR, radius=0.007, name="r")
    add_arrow(plotter, ORIGIN, turned, RESULT, radius=0.012, name="turned")
    add_label(plotter, 1.1 * n + ASIDE, r"$\hat n$", AXIS)
    name_tips(plotter, [r, turned], center, n, (-0.12, 0.12))
    add_terms(plotter, terms(r, n, angle), radius=0.02, name="term")
    return plotter


def name_tips(
    plotter: pyvista.Plotter,
    tips: Sequence[NDArray[np.float64]],
    center: NDArray[np.float64],
    n: NDArray[np.float64],
    lifts: tuple[float, float],
    index: str = "",
) -> None:
    """Name a vector and the turned one beside their tips, each at a height above the circle."""
    names = (rf"\vec r{index}", rf"\vec r{index}^{{\,\prime}}")
    for tip, text, color, up in zip(tips, names, (VECTOR, RESULT), lifts, strict=True):
        add_label(plotter, tip + 0.17 * (tip - center) + up * n, f"${text}$", color)


def terms(r: NDArray[np.float64], n: NDArray[np.float64], angle: float) -> NDArray[np.float64]:
    """Return the three terms of (3-1), shape (3, 3)."""
    cos, sin = np.cos(angle), np.sin(angle)
    return np.stack([cos * r, (1 - cos) * (r @ n) * n, sin * np.cross(n, r)])


def add_terms(
    plotter: pyvista.Plotter, three: NDArray[np.float64], radius: float, name: str
) -> None:
    """Add three terms as arrows head to tail, without those that vanish."""
    start = ORIGIN
    for i, (term, color) in enumerate(zip(three, (VECTOR, AXIS, CROSS), strict=True), start=1):
        seen = bool(np.linalg.norm(term) > HAIR)
        end = start + (term if seen else HAIR)
        arrow = add_arrow(plotter, start, end, color, radius, name=f"{name} {i}")
        arrow.visibility = seen
        start = start + term


@explorable(
    model="figure1",
    tries={
        "θ = 90°": {"theta": 90},
        "θ = 180°": {"theta": 180},
        "r₂ opposite r": {"around": 180},
    },
    vector=Handles("r", length=0),
    axis=Handles("n", reach=1.1),
    theta=Slider(0, 360, "angle θ, °", step=1, plays=8),
    around=Slider(0, 360, "r₂ ahead of r by, °", step=1, row=False),
)
def figure_1_by_hand(
    vector: ArrayLike = VECTOR_BY_HAND,
    axis: ArrayLike = AXIS_BY_HAND,
    theta: float = 60,
    around: float = 120,
) -> pyvista.Plotter:
    """Draw Fig. 1 with a second vector, whose tip starts elsewhere on the same circle.

    Parameters
    ----------
    vector : array_like, shape (3,)
        The vector r.
    axis : array_like, shape (3,)
        The rotation axis n; it is normalised.
    theta : float
        The rotation angle in degrees.
    around : float
        Where the second vector starts: degrees about the axis, counted from r.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    r = np.asarray(vector, float)
    n = np.asarray(axis, float) / np.linalg.norm(axis)
    angle = np.radians(theta)
    other = rotate(r, n, np.radians(around))
    here, there = (terms(start, n, angle) for start in (r, other))

    plotter = turned_vector(r, n, angle, ALL_ROUND)
    circle = turning(r, n, 2 * np.pi, 80)
    place_grip(plotter, "theta", path=circle, body=[ORIGIN, rotate(r, n, angle)])
    place_grip(plotter, "around", path=circle, body=[ORIGIN, other])
    # What stays as it is shines, but only while the hand moves.
    halo = add_lines(plotter, [[ORIGIN, n]], AXIS, radius=0.06, name="halo")
    halo.prop.opacity, halo.visibility = 0.45, False
    add_line(plotter, [ORIGIN, other], VECTOR, radius=0.003, name="other")
    add_point(plotter, other, VECTOR, radius=0.024, name="other start")
    end = rotate(other, n, angle)
    add_point(plotter, end, RESULT, radius=0.024, name="other end")
    name_tips(plotter, [other, end], (r @ n) * n, n, (0.0, 0.25), index="_2")
    add_terms(plotter, there, radius=0.008, name="other term")

    cos, sin = np.cos(angle), np.sin(angle)
    factors = (cos, (1 - cos) * (r @ n), sin)
    apart = np.linalg.norm(there - here, axis=1)
    for name, vector, (color, ink), factor, length in zip(
        ("first", "along", "across"),
        ("r", "n̂", "n̂ × r"),
        (("blue", VECTOR), ("orange", AXIS), ("purple", CROSS)),
        factors,
        apart,
        strict=True,
    ):
        read_out(plotter, name, factor, f"{vector} times", where="picture", color=ink)
        read_out(plotter, f"{name}_apart", length, f"{color} arrows differ by")
    read_out(plotter, "matrix", rotation_matrix(n, angle), "matrix (3-3)", where="folded")
    describe(
        plotter,
        "A vector r turned about the axis n becomes r', and its tip stays on a circle around the"
        " axis. Three arrows, head to tail, lead from the origin to the tip of r': a blue one"
        " along r, an orange one parallel to n, and a purple one perpendicular to both. Three"
        " thinner arrows do the same for a vector that starts elsewhere on the circle. Both orange"
        " arrows have the same length and direction.",
    )
    return plotter


def rotated_mesh(
    mesh: pyvista.PolyData | None = None,
    axis: ArrayLike = (0.2, 0.35, 1.0),
    angle: float = np.deg2rad(110),
) -> pyvista.Plotter:
    """Draw a mesh before and after one matrix has turned all its vertices by (3-2).

    Parameters
    ----------
    mesh : pyvista.PolyData, optional
        The mesh. The default is a `teaspoon`.
    axis : array_like, shape (3,)
        The rotation axis; it is normalised.
    angle : float
        The rotation angle in radians.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    before = teaspoon() if mesh is None else mesh
    after = before.copy()
    after.points = transform(rotation_matrix(axis, angle), before.points)
    n = np.asarray(axis, float) / np.linalg.norm(axis)

    plotter = new_scene(eye=(1.3, -2.8, 3.35), target=(0, 0, 0.1), size=NARROW)
    plotter.add_mesh(before, color=VECTOR, smooth_shading=True)
    plotter.add_mesh(after, color=RESULT, smooth_shading=True)
    add_arrow(plotter, -0.7 * n, 0.9 * n, AXIS)
    add_label(plotter, n, r"$\hat n$", AXIS)
    far = before.points[np.argmax(np.linalg.norm(np.cross(before.points, n), axis=1))]
    path = turning(far, n, angle)
    add_line(plotter, path, NEUTRAL, radius=0.006)
    add_label(plotter, 1.06 * path[len(path) // 2], r"$\theta$")
    describe(
        plotter,
        f"A mesh of {before.n_points} vertices in blue, and in green the same mesh turned by"
        f" {np.rad2deg(angle):.0f} degrees about an axis n. An arc shows the path of one vertex.",
    )
    return plotter
