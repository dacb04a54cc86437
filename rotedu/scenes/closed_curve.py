"""Scenes of page 5 III: de Casteljau's arcs, the curve of Figure 8, a camera."""

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.closed_curve import closed_curve
from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.control_points import control_points
from rotedu.figures import State, add_view, describe, draw_chart, explorable, read_out
from rotedu.figures.inputs import Choice, Handles, Slider
from rotedu.ordinary_rotation import rotate
from rotedu.scenes.looks import Arrow, Ball, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import (
    add_arc,
    add_label,
    add_line,
    add_point,
    add_sphere,
    new_scene,
    sphere_scene,
)
from rotedu.scenes.room import CAMERA_SEES, CAMERA_TARGETS, THINGS, camera
from rotedu.scenes.shapes import JUST_INSIDE, normalised, turning

__all__ = ["ARCS", "FIGURE_8", "arcs_of_arcs", "camera_by_hand", "closed_curve_by_hand", "figure_8"]

# Uneven gaps, one of them beyond 90 degrees, and all points on the side of the camera.
FIGURE_8 = ((0.8, -0.4, 0.4), (0.5, 0.8, -0.4), (0.6, 0.7, 0.4), (0.1, 0.4, 0.9))


def figure_8() -> pyvista.Plotter:
    """Draw Fig. 8: a closed curve on the sphere, its points and its control points."""
    p = normalised(FIGURE_8)
    a, b = control_points(p)
    curve = closed_curve(p, 30)

    plotter = sphere_scene(eye=(4.28, 2.42, 2.51))
    add_line(plotter, [*curve, curve[0]], RESULT, radius=0.013)
    polygon = np.stack([b, p, a], axis=1).reshape(-1, 3)
    for start, end in zip(polygon, np.roll(polygon, -1, axis=0), strict=True):
        add_arc(plotter, start, end, CROSS)

    corners = (("b", RESULT, 0.024), ("P", VECTOR, 0.036), ("a", RESULT, 0.024))
    for i, (point, place) in enumerate(zip(polygon, beside(polygon), strict=True)):
        letter, color, radius = corners[i % 3]
        add_point(plotter, point, color, radius)
        add_label(plotter, place, f"${letter}_{i // 3}$", color)
    describe(
        plotter,
        f"A see-through sphere with a smooth closed green curve through {len(p)} blue points P."
        " Each point has two small green control points beside it, b before it and a after it."
        " Thin purple arcs join all of them in the order P0, a0, b1, P1, a1 and so on. They follow"
        " the curve and touch it at the points P.",
    )
    return plotter


def beside(polygon: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return a place beside each corner of a closed polygon on the sphere, for its label.

    It is on the outer side of the corner. Where the polygon has no corner, as at P_i, it is on the
    side away from the middle of all.
    """
    before, after = np.roll(polygon, 1, axis=0), np.roll(polygon, -1, axis=0)
    outwards = 0.35 * (polygon - polygon.mean(axis=0)) + polygon - (before + after) / 2
    sideways = np.cross(polygon, after - before)
    sideways *= np.where(np.sum(sideways * outwards, axis=1, keepdims=True) < 0, -1, 1)
    places: NDArray[np.float64] = 1.1 * polygon + 0.16 * normalised(sideways)
    return places


MOST = 8
"""Number of points that `closed_curve_by_hand` can show."""
# Four points evenly spread over a great circle, and those of Figure 8 with two of them near.
RING = rotate((0.86, 0, -0.51), (0.51, 0, 0.86), np.arange(4) * np.pi / 2).round(3).tolist()
NEAR = (FIGURE_8[0], (0.608, 0.769, 0.197), *FIGURE_8[2:])


@explorable(
    tries={
        "once round": {"u": 1},
        "two points close together": {"points": NEAR, "u": 1},
        "points on a great circle": {"points": RING, "u": 1},
        "the same, a third of the way": {"points": RING, "u": 1, "fraction": 1 / 3},
    },
    answer={"u": 1},
    constants={"most": MOST},
    points=Handles([f"P{k}" for k in range(MOST)], least=3, most=MOST, start=FIGURE_8),
    u=Slider(0, 1, "once round, *u*", plays=10, start=0.12),
    fraction=Slider(0.2, 0.5, "how far *aᵢ* goes", step=0.005, start=1 / 2),
)
def closed_curve_by_hand(state: State) -> pyvista.Plotter:
    """Draw Fig. 8 with its curvature as a comb, up to one place, and its speed.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        From 3 to 8 points P_0 ... P_{n-1}; they are normalised.
    u : float
        Place on the whole curve, from 0 to 1. Each segment takes the same share.
    fraction : float
        How far ``a_i`` goes from ``P_i`` towards the midpoint. The paper takes 1/2.
    """
    plotter = sphere_scene(eye=(4.28, 2.42, 2.51))
    looks: dict[str, Look] = {
        "curve": Lines(RESULT, 0.015),
        "polygon": Lines(CROSS, 0.004),
        "comb": Lines(RESULT, 0.004),
        "tips": Lines(RESULT, 0.004),
        "C": Ball(RESULT, 0.034),
    }
    corners = {"b": Ball(RESULT, 0.022), "P": Ball(VECTOR, 0.036), "a": Ball(RESULT, 0.022)}
    named = {f"{name}_{k}": ball for k in range(MOST) for name, ball in corners.items()}
    texts = {name: Text(ball.color) for name, ball in named.items()}
    draw(plotter, state, looks | named, texts)

    for where, name, text, digits, unit in (
        ("picture", "curvature_jump", "curvature jumps, at the nearest *P*, by", 2, ""),
        ("folded", "velocity_jump", "velocity jumps by", 1, "°/s"),
        ("folded", "speed_range", "speed from, to", 0, "°/s"),
        ("folded", "speed", "speed here", 0, "°/s"),
        ("folded", "curvature", "curvature here (great circle: 0)", 2, ""),
        ("folded", "curvature_jumps", "jumps of curvature at *P₀*, *P₁*, …", 2, ""),
    ):
        read_out(plotter, name, text, digits, unit, where=where)
    for name, heights, text in (
        ("speeds", (0, 150), "speed, degrees a second"),
        ("curvatures", (-6, 6), "curvature, positive to the left (beyond ±6 not shown)"),
    ):
        draw_chart(
            plotter,
            name,
            over="u",
            x=(0, 1),
            y=heights,
            label=text,
            colors={"curve": RESULT, "marks": VECTOR},
            marks=[f"*P{chr(ord('₀') + k)}*" for k in range(MOST)],
        )
    describe(
        plotter,
        "A see-through sphere with a closed green curve through"
        f" {len(state['inputs']['points'])} blue points P that can be dragged. Purple arcs join"
        " them and their control points, a and b. Hairs stand on the curve up to a place on it, as"
        " long as the curve is curved there, on its outer side; at the points P their length"
        " jumps.",
    )
    return plotter


# Far apart, so that the arcs of the different levels are easy to distinguish.
ARCS = ((1.0, 0.0, -0.2), (0.6, -0.2, 0.7), (0.1, 0.6, 0.8), (0.4, 0.9, -0.2))


@explorable(
    tries={
        "close to the start": {"u": 0.05},
        "even closer": {"u": 0.01},
        "half of every arc": {"u": 0.5},
    },
    control=Handles([f"Q0,{k}" for k in range(4)], start=ARCS),
    u=Slider(0, 1, "*u*", plays=8, start=0.4),
)
def arcs_of_arcs(state: State) -> pyvista.Plotter:
    """Draw de Casteljau's construction on the sphere: the arcs of all levels for one u.

    Parameters
    ----------
    control : array_like, shape (4, 3)
        Control points; they are normalised.
    u : float
        The parameter, from 0 to 1.
    """
    plotter = sphere_scene(eye=(4.28, 2.42, 2.51))
    looks: dict[str, Look] = {"curve": Lines(RESULT, 0.014)}
    texts = {}
    for j, color in enumerate((VECTOR, CROSS, NEUTRAL, RESULT)):
        looks[f"level {j}"] = Lines(color)
        looks[f"Q {j} *"] = Ball(color, 0.03 if j else 0.036)
        texts[f"Q_{{{j},*"] = Text("black" if color == NEUTRAL else color)
    draw(plotter, state, looks, texts)
    for j, text in enumerate(("from *Q₀,₀* to *Q₁,₁*", "to *Q₂,₂*", "to *Q₃,₃*"), start=1):
        read_out(plotter, f"way_{j}", text, 1, "°", where="picture")
    describe(
        plotter,
        "A see-through sphere with a green curve and the construction of its point for"
        f" u = {state['inputs']['u']:g}."
        " Three blue arcs join four blue points, Q00 to Q03. On each blue arc lies a purple point,"
        " Q11 to Q13, and two purple arcs join these. On each purple arc lies a grey point, Q22 and"
        " Q23. The grey arc between these two meets the curve at the green point Q33.",
    )
    return plotter


HORIZONS = 5
# The view of who rides on the camera.
RIDE = "ride"


@explorable(
    tries={
        "the corner at the clock": {"u": 0.25},
        "once round along the curve": {"path": "curve", "u": 1.0},
        "who turns it past the window?": {"path": "curve", "roll": "kept upright", "u": 0.542},
    },
    answer={"u": 0.9},
    constants={"seen": CAMERA_SEES},
    u=Slider(0, 1, "once round, *u*", plays=12, start=0.12),
    targets=Handles(CAMERA_SEES, start=CAMERA_TARGETS),
    path=Choice("path", ["arcs", "curve"], start="arcs"),
    roll=Choice("camera", ["kept upright", "carried along"], start="carried along"),
)
def camera_by_hand(state: State) -> pyvista.Plotter:
    """Draw a camera that looks from target to target and back to the first, and what it sees.

    Parameters
    ----------
    u : float
        Place on the way round, from 0 to 1.
    targets : array_like, shape (4, 3)
        The directions to door, clock, window and desk; they are normalised.
    path : str
        On ``arcs``, or on the closed ``curve``. Each of the four legs takes a second.
    roll : str
        ``kept upright`` keeps the sides of the picture vertical. ``carried along`` starts upright
        at the door; from there on, nothing turns the camera about its line of sight.
    """
    plotter = new_scene((5.1, -0.3, 2.3), (0, 0, 0.02), view_angle=26.5, size=(480, 480))
    add_sphere(plotter)
    add_horizon(plotter)
    looks: dict[str, Look] = {
        "arcs": Lines(CROSS, 0.014),
        "other arcs": Lines(CROSS, 0.004),
        "curve": Lines(RESULT, 0.014),
        "other curve": Lines(RESULT, 0.004),
        **{name: Mesh(thing(), VECTOR, {"pickable": False}) for name, thing in THINGS.items()},
        "camera": Mesh(camera([1, 0, 0]), NEUTRAL, {"pickable": False}),
        "upright": Lines(NEUTRAL),
        "upright up": Arrow(NEUTRAL, 0.011),
        "picture": Lines(AXIS, 0.01),
        "edges": Lines(AXIS, 0.004),
        "up": Arrow(AXIS),
    }
    seen = {f"{name} seen": Text(VECTOR, name, RIDE) for name in CAMERA_SEES}
    draw(plotter, state, looks, seen | {"up": Text(AXIS, "{}"), "*": Text(VECTOR, "{}")})
    add_view(
        plotter,
        RIDE,
        **state["views"][RIDE],
        size=(480, 320),
        alt="What the camera sees: the path ahead, the targets, and the horizon, which tilts.",
        without=("camera", "edges", "other arcs", "other curve"),
    )

    read_out(plotter, "rolled", "turned against upright", 0, "°", where="picture")
    read_out(plotter, "spin", "spin about line of sight", 0, "°/s", where="picture")
    read_out(plotter, "speed", "speed", 0, "°/s", where="folded")
    read_out(plotter, "bends", "bends", where="folded")
    for name, y, text, colors in (
        ("speeds", (0, 150), "speed, degrees a second", {"arcs": CROSS, "curve": RESULT}),
        ("spins", (-600, 600), "spin of an upright camera, °/s", {"spin": AXIS}),
    ):
        draw_chart(
            plotter,
            name,
            over="u",
            x=(0, 1),
            y=y,
            label=text,
            colors=colors | {"marks": VECTOR},
            marks=CAMERA_SEES,
        )
    describe(
        plotter,
        "A see-through sphere with a camera at its centre, a horizon and a darker lower half."
        " Purple arcs join a blue door, a clock, a window and a desk, with a corner at each."
        " A green curve runs through the same points without a corner. The path that"
        " the camera does not take is thin. An orange frame"
        " on the sphere shows the picture that the camera takes and which side of it is up; a grey"
        " frame shows how an upright camera would hold it.",
    )
    return plotter


def add_horizon(plotter: pyvista.Plotter) -> None:
    """Add a darker lower half and a horizon, with names for a rider."""
    ground = pyvista.Sphere(start_phi=90, theta_resolution=48, phi_resolution=16)
    ground.points *= JUST_INSIDE / np.linalg.norm(ground.points, axis=1, keepdims=True)
    plotter.add_mesh(ground, color=NEUTRAL, opacity=0.37, smooth_shading=True, pickable=False)
    horizon = turning((1, 0, 0), (0, 0, 1), 2 * np.pi)
    add_line(plotter, horizon, NEUTRAL, radius=0.005, name="horizon")
    for k in range(HORIZONS):
        # Beside the frame at the start and at all targets.
        azimuth = 2 * np.pi * (k + 3 / 4) / HORIZONS
        place = 0.98 * np.array([np.cos(azimuth), np.sin(azimuth), 0.06])
        add_label(plotter, place, "horizon", name=f"horizon {k}", view=RIDE)
    add_label(plotter, (-0.1, -0.25, 0.95), "straight up", view=RIDE)
