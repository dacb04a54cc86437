"""Scenes of Chapter 3: a turned vector and a turned mesh."""

import numpy as np
import pyvista

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Handles, Slider
from rotedu.ordinary_rotation import rotate, rotation_matrix, transform
from rotedu.scenes.looks import Arrow, Ball, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import (
    LITTLE,
    NARROW,
    add_arrow,
    add_axis,
    add_label,
    add_line,
    add_shadow,
    new_scene,
)
from rotedu.scenes.shapes import ORIGIN, fan, normalised, teaspoon, turning

__all__ = ["every_point", "figure_1", "figure_1_by_hand", "rotated_mesh"]

VECTOR_BY_HAND, AXIS_BY_HAND = (0.7, 0.7, 0.4), (0.5, -0.3, 1.05)
"""Where the circle fills the picture, and no arrow hides another."""
INKS = (VECTOR, AXIS, CROSS)
"""Colours of the terms of (3-1)."""
LOOKS: dict[str, Look] = {
    "circle": Lines(NEUTRAL, 0.005),
    "sector": Mesh(fan, NEUTRAL, {"opacity": 0.5, "lighting": False, "pickable": False}),
    "spokes": Lines(NEUTRAL, 0.004),
    "centre": Ball(NEUTRAL, 0.022),
    "height": Lines(NEUTRAL, 0.012),
    "n": Arrow(AXIS, 0.006),
    "r": Arrow(VECTOR, 0.007),
    "turned": Arrow(RESULT, 0.012),
    **{f"term {i}": Arrow(ink, 0.02) for i, ink in enumerate(INKS, 1)},
    "other": Lines(VECTOR, 0.003),
    "other start": Ball(VECTOR, 0.024),
    "other end": Ball(RESULT, 0.024),
    **{f"other term {i}": Arrow(ink, 0.008) for i, ink in enumerate(INKS, 1)},
}
TEXTS = {
    r"\hat n": Text(AXIS),
    r"\vec r": Text(VECTOR),
    r"\vec r_2": Text(VECTOR),
    r"*\prime}": Text(RESULT),
    "*": Text(),
}


LINE = normalised((0.25, 0.3, 1))
# The tip, the end of the handle and the widest places of the bowl.
SEEN = [(0.98, 0, 0.06), (-1, 0, 0.16), (0.45, 0.33, 0.02), (0.45, -0.33, 0.02)]


@explorable(
    small=True,
    answer={"theta": 60},
    constants={"axis": LINE.tolist(), "points": SEEN},
    theta=Slider(0, 360, "angle *θ*, °", step=1, plays=6, start=0),
)
def every_point(state: State) -> pyvista.Plotter:
    """Draw a spoon that turns about an axis, and the circles of some of its points.

    Parameters
    ----------
    theta : float
        The rotation angle in degrees.
    """
    plotter = new_scene((3.2, -3.6, 2.6), (0, 0, 0.06), view_angle=18, size=LITTLE, swing=20)
    looks: dict[str, Look] = {
        "circles": Lines(NEUTRAL, 0.006),
        "spoon": Mesh(teaspoon(stations=61, around=20), VECTOR, {"smooth_shading": True}),
        "point": Ball(RESULT, 0.05),
    }
    draw(plotter, state, looks)
    add_axis(plotter, LINE, r"$\hat n$", length=0.8)
    add_shadow(plotter, "spoon", ORIGIN, 1, 0.5)
    describe(
        plotter,
        f"A spoon, turned by {state['inputs']['theta']:.0f} degrees about an upright axis. Four of"
        " its points lie on grey circles about the axis, on which they stay.",
    )
    return plotter


def figure_1() -> pyvista.Plotter:
    """Draw Fig. 1: a vector turned about an axis, and the three terms of (3-1)."""
    r, n, angle = np.array([1, -0.3, 0.75]), normalised((-0.15, 0.1, 1)), np.deg2rad(75)
    turned = rotate(r, n, angle)
    center = (r @ n) * n
    spoke = r - center
    cos, sin = np.cos(angle), np.sin(angle)
    joints = np.cumsum([ORIGIN, cos * r, (1 - cos) * center, sin * np.cross(n, r)], axis=0)
    parts = {
        "circle": {"paths": [turning(r, n, 2 * np.pi, 80)]},
        "sector": {"points": np.vstack([center, center + turning(0.42 * spoke, n, angle)])},
        "spokes": {"paths": [[center, r], [center, turned]]},
        "centre": {"at": center},
        "height": {"paths": [[ORIGIN, center]]},
        "n": {"from": ORIGIN, "to": 1.1 * n},
        "r": {"from": ORIGIN, "to": r},
        "turned": {"from": ORIGIN, "to": turned},
        **{f"term {i}": {"from": joints[i - 1], "to": joints[i]} for i in (1, 2, 3)},
    }
    labels = {
        "O": (0, 0.13, -0.1),
        r"\theta": center + rotate(0.28 * spoke, n, 0.5 * angle),
        r"\vec r_\parallel": 0.4 * center - 0.16 * spoke,
        r"\vec r_\perp": center + 0.72 * spoke + 0.09 * n,
        # To the right in the picture.
        r"\hat n": 1.1 * n + (-0.03, 0.13, 0),
        r"\vec r": r + 0.17 * (r - center) - 0.12 * n,
        r"\vec r^{\,\prime}": turned + 0.17 * (turned - center) + 0.12 * n,
    }

    plotter = new_scene((4.5, 0.95, 2.9), (0, 0.03, 0.48), view_angle=21.5)
    draw(plotter, {"parts": parts, "labels": labels}, LOOKS, TEXTS)
    describe(
        plotter,
        f"A vector r and its copy r', turned by {np.rad2deg(angle):.0f} degrees about the axis n."
        " The tips of both lie on a circle around the axis. Three arrows, head to tail, lead"
        " from the origin to the tip of r': one along r, one parallel to n, and one"
        " perpendicular to both.",
    )
    return plotter


@explorable(
    tries={
        "all three arrows": {"drawn": 3},
        "*θ* = 90°": {"theta": 90, "drawn": 3},
        "*θ* = 180°": {"theta": 180, "drawn": 3},
        "another vector to the circle": {"around": 130, "drawn": 3},
    },
    answer={"drawn": 3},
    vector=Handles("r", length=0, start=VECTOR_BY_HAND),
    axis=Handles("n", reach=1.1, start=AXIS_BY_HAND),
    drawn=Slider(0, 3, "arrows drawn", step=0.01, stride=1, plays=6, start=0),
    theta=Slider(0, 360, "angle *θ*, °", step=1, plays=8, start=60),
    around=Slider(0, 360, "*r₂* ahead of *r* by, °", step=1, start=0),
)
def figure_1_by_hand(state: State) -> pyvista.Plotter:
    """Draw Fig. 1 arrow by arrow, and for a second vector to the same circle.

    Parameters
    ----------
    vector : array_like, shape (3,)
        The vector r.
    axis : array_like, shape (3,)
        The rotation axis n; it is normalised.
    drawn : float
        How many of the three terms are drawn.
    theta : float
        The rotation angle in degrees.
    around : float
        Where the second vector starts: degrees about the axis, counted from r;
        after none or a whole turn there is no second vector.
    """
    # There is room for any axis, and for any vector of the same length.
    plotter = new_scene((4.5, 0.95, 2.52), (0, 0.03, 0.1), view_angle=25.5, size=(600, 504))
    draw(plotter, state, LOOKS, TEXTS)
    for name, vector, color, ink in (
        ("first", "*r*", "blue", VECTOR),
        ("along", "*n̂*", "orange", AXIS),
        ("across", "*n̂* × *r*", "purple", CROSS),
    ):
        read_out(plotter, name, f"{vector} times", where="picture", color=ink)
        read_out(plotter, f"{name}_apart", f"{color} arrows differ by", where="folded")
    read_out(plotter, "matrix", "matrix (3-3)", where="folded")
    describe(
        plotter,
        "A vector r turned about the axis n becomes r', and its tip stays on a circle around the"
        " axis. Up to three arrows, head to tail, lead from the origin to the tip of r': a blue one"
        " along r, an orange one parallel to n, and a purple one perpendicular to both. Thinner"
        " arrows do the same for a second vector to the circle, where there is one.",
    )
    return plotter


def rotated_mesh() -> pyvista.Plotter:
    """Draw a teaspoon before and after one matrix has turned all its vertices by (3-2)."""
    n, angle = normalised((0.2, 0.35, 1)), np.deg2rad(110)
    before = teaspoon()
    after = before.copy()
    after.points = transform(rotation_matrix(n, angle), before.points)

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
