"""Scenes of page 5 II: the construction, and the misprints (5-9) and (5-13)."""

from itertools import pairwise
from typing import Any

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import arc_axis, slerp
from rotedu.closed_curve import closed_curve, de_casteljau
from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR, WRONG
from rotedu.control_points import bisect, double
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Handles, Slider, Switch
from rotedu.scenes.arcs import CAMERA_SEES, CAMERA_TARGETS
from rotedu.scenes.looks import Arrow, Ball, Lines, Look, Text, draw
from rotedu.scenes.parts import (
    LITTLE,
    add_angle,
    add_arc,
    add_axis,
    add_label,
    add_line,
    add_point,
    add_sphere,
    new_scene,
    sphere_scene,
)
from rotedu.scenes.shapes import U, W, normalised

__all__ = [
    "NEIGHBOURS",
    "arrow_at_the_clock",
    "control_points_by_hand",
    "figure_3",
    "figure_4",
    "figure_5",
    "figure_6",
    "figure_7",
    "reversed_axis",
]

# The points of figures 3 to 7 are 60 degrees apart, then 90, so no bisected angle equals the angle
# that its name would mean without the bar.
NEIGHBOURS = ((1.0, 0.0, 0.0), (0.5, 0.75**0.5, 0.0), (0.0, 0.0, 1.0))


BEFORE, HERE, AFTER = "$P_{i-1}$", "$P_i$", "$P_{i+1}$"
REFLECTED, MIDDLE = r"$\bar P_{i-1}$", r"$\bar P_i$"
A, B = "$a_i$", "$b_i$"
NAMES = (BEFORE, HERE, AFTER, REFLECTED, MIDDLE, A, B)
# From the camera of the other figures, the plane of P_i, a_i and b_i would be seen edge on.
SIDE, LOW = (-1.35, 5.5, 0.9), (0, 0, -0.14)
COLORS = dict(zip(NAMES, (VECTOR, VECTOR, VECTOR, CROSS, CROSS, RESULT, RESULT), strict=True))


def neighbours(points: ArrayLike = NEIGHBOURS) -> dict[str, NDArray[np.float64]]:
    """Construct the auxiliary points and control points of the middle of three points, by name."""
    before, here, after = normalised(points)
    reflected = double(before, here)
    middle = bisect(reflected, after)
    a = bisect(here, middle)
    found = (before, here, after, reflected, middle, a, double(a, here))
    return dict(zip(NAMES, found, strict=True))


def open_neighbours(
    shown: dict[str, tuple[float, float]],
    eye: ArrayLike = (1.5, 4.75, 2.9),
    target: ArrayLike = (0, 0, 0.06),
) -> tuple[pyvista.Plotter, dict[str, NDArray[np.float64]]]:
    """Open a scene of the construction with some of its points, and names shifted right and up."""
    found = neighbours()
    plotter = sphere_scene(eye, target)
    back = np.subtract(eye, target)
    right = normalised(np.cross((0, 0, 1), back))
    up = np.cross(normalised(back), right)
    for name, (across, above) in shown.items():
        add_point(plotter, found[name], COLORS[name])
        place = 1.03 * found[name] + across * right + above * up
        add_label(plotter, place, name, COLORS[name])
    return plotter, found


def figure_3() -> pyvista.Plotter:
    """Draw Fig. 3: from three points to the two control points of the middle one."""
    shifts = (-0.13, 0.05), (0, -0.13), (0, 0.13), (0.15, 0.02), (0.12, 0.06), (0.13, 0), (0, -0.13)
    plotter, p = open_neighbours(dict(zip(NAMES, shifts, strict=True)))
    for start, end in ((BEFORE, HERE), (HERE, AFTER)):
        add_arc(plotter, p[start], p[end], VECTOR)
    for start, end in ((HERE, REFLECTED), (REFLECTED, AFTER), (A, MIDDLE)):
        add_arc(plotter, p[start], p[end], CROSS)
    for start, end in ((B, HERE), (HERE, A)):
        add_arc(plotter, p[start], p[end], RESULT, radius=0.014)
    describe(
        plotter,
        "A unit sphere with three given points P_{i-1}, P_i and P_{i+1}. The arc from P_{i-1} to"
        " P_i continues by its own length to an auxiliary point. Midway between this point and"
        " P_{i+1} lies a second auxiliary point. Midway between P_i and the second one lies the"
        " control point a_i. The arc from a_i to P_i continues by its own length to the control"
        " point b_i.",
    )
    return plotter


def one_step(
    shown: dict[str, tuple[float, float]],
    arcs: tuple[str, ...],
    color: str,
    names: tuple[str, str],
    place: float = 0.64,
    length: float = 1.3,
    **camera: ArrayLike,
) -> pyvista.Plotter:
    """Draw arcs one after the other, and the names of their angle and of their axis."""
    plotter, p = open_neighbours(shown, **camera)
    for start, end in pairwise(arcs):
        add_arc(plotter, p[start], p[end], color, radius=0.012)
        add_angle(plotter, p[start], p[end], names[0], place=place)
    add_axis(plotter, arc_axis(p[arcs[0]], p[arcs[1]]), names[1], length)
    return plotter


def figure_4() -> pyvista.Plotter:
    """Draw Fig. 4: the axis of (5-6), and the arc doubled by (5-4) or (5-5)."""
    shown = {BEFORE: (-0.13, 0.05), HERE: (0, -0.13), REFLECTED: (0.15, 0.02)}
    arcs, names = (BEFORE, HERE, REFLECTED), (r"$\theta_{i-1}$", r"$\hat v_{i-1}$")
    plotter = one_step(shown, arcs, CROSS, names, 1.22, 1.15, target=(0, 0, 0.17))
    describe(
        plotter,
        "A unit sphere. An arc from P_{i-1} to P_i continues by its own length to P_{i-1} with a"
        " bar. Both halves span the same angle theta_{i-1} at the centre. An axis is perpendicular"
        " to the plane of the arc.",
    )
    return plotter


def figure_5() -> pyvista.Plotter:
    """Draw Fig. 5: the axis of (5-9), corrected, and the arc bisected by (5-7) or (5-8)."""
    shown = {AFTER: (0, 0.13), REFLECTED: (0.15, 0.02), MIDDLE: (0.12, 0.06)}
    names = r"$\bar\theta_{i-1}$", r"$\hat{\bar v}_{i-1}$"
    plotter = one_step(shown, (REFLECTED, AFTER), CROSS, names)
    describe(
        plotter,
        "A unit sphere. An arc leads from P_{i-1} with a bar up to P_{i+1}; its midpoint is P_i"
        " with a bar. The angle of the arc at the centre is theta_{i-1} with a bar. An axis is"
        " perpendicular to its plane.",
    )
    return plotter


def figure_6() -> pyvista.Plotter:
    """Draw Fig. 6: the axis of (5-12), and the arc bisected by (5-10) or (5-11)."""
    shown = {HERE: (-0.12, 0.0), MIDDLE: (0.12, 0.06), A: (-0.08, 0.09)}
    names = r"$\bar\theta_i$", r"$\hat{\bar v}_i$"
    plotter = one_step(shown, (MIDDLE, HERE), RESULT, names, eye=SIDE, target=LOW)
    describe(
        plotter,
        "A unit sphere. An arc leads from P_i with a bar to P_i; its midpoint is the control point"
        " a_i. The angle of the arc at the centre is theta_i with a bar. An axis is perpendicular"
        " to its plane.",
    )
    return plotter


def figure_7() -> pyvista.Plotter:
    """Draw Fig. 7: the axis of (5-15), and the arc doubled by (5-13) or (5-14)."""
    shown = {HERE: (-0.12, 0.0), A: (0.1, 0.08), B: (-0.06, -0.12)}
    names = r"$\tilde\theta_i$", r"$\hat{\tilde v}_i$"
    plotter = one_step(shown, (A, HERE, B), RESULT, names, 1.22, eye=SIDE, target=LOW)
    describe(
        plotter,
        "A unit sphere. An arc from a_i to P_i continues by its own length to b_i. Both halves span"
        " the same angle theta_i with a tilde at the centre. An axis is perpendicular to their"
        " plane.",
    )
    return plotter


CORNER = 82


@explorable(
    small=True,
    answer={"aim": 38},
    constants={"targets": CAMERA_TARGETS, "corner": CORNER},
    aim=Slider(0, CORNER, "aims, from straight on, °", step=1, plays=5, start=0),
)
def arrow_at_the_clock(state: State) -> pyvista.Plotter:
    """Draw a curve from the door to the window that passes the clock in a chosen direction.

    Parameters
    ----------
    aim : float
        The direction, in degrees: 0 for straight on, 82 for straight at the window.
    """
    plotter = new_scene((2.9, 5.2, 2.5), (0.15, 0.1, 0.12), view_angle=22.6, size=LITTLE)
    add_sphere(plotter)
    looks: dict[str, Look] = {
        "arcs": Lines(VECTOR, 0.004),
        "dial": Lines(NEUTRAL, 0.004),
        "curve": Lines(RESULT, 0.012),
        "arrow": Arrow(AXIS, 0.014),
        "*": Ball(VECTOR, 0.03),
    }
    draw(plotter, state, looks, {"*": Text(VECTOR, "{}")})
    before, after = state["outputs"]["bends"]
    read_out(plotter, "bends", "bends before and after", 0, "°", where="picture")
    describe(
        plotter,
        "A ball with three points, door, clock and window, and the arcs between them, which make a"
        f" corner of {CORNER} degrees at the clock. A green curve passes the clock in the direction"
        f" of an arrow, {state['inputs']['aim']:g} degrees from straight on. It bends by"
        f" {before:.0f} degrees before the clock and by {after:.0f} after it.",
    )
    return plotter


STEPS = (
    "0 three given points",
    "1 Double: go on",
    "2 Bisect: aim between",
    "3 Bisect: halfway back",
    "4 Double: go beyond",
)
NOT_YET = "–"
# By the number of tests that say no.
VERDICTS = ("all say yes", "one says no", "two say no", "three say no", "all say no")
INKS = {"cross": CROSS, "result": RESULT, "wrong": WRONG}
# Two points of the equator and one 90 degrees after them, off the poles: its nearest point of the
# equator is half way from P_{i-1} to the place where a_i jumps.
AHEAD = (*NEIGHBOURS[:2], (0.3, -0.3 / 3**0.5, 0.94))
GIVEN: dict[str, Look] = {
    "circle": Lines(NEUTRAL, 0.004),
    "given": Lines(VECTOR, 0.006),
    **dict.fromkeys((BEFORE, HERE, AFTER), Ball(VECTOR, 0.036)),
    "halved": Lines(CROSS, 0.006),
    "opposite": Ball(NEUTRAL),
}


def on_equator(degrees: float) -> tuple[float, float, float]:
    """Return a point of the equator, where the first two points of `AHEAD` lie at 0° and 60°."""
    return (round(np.cos(np.radians(degrees)), 6), round(np.sin(np.radians(degrees)), 6), 0.0)


def ahead(degrees: float, one_circle: bool = True) -> dict[str, Any]:
    """Return inputs that show all steps, with the third point on the equator."""
    return {
        "points": (*NEIGHBOURS[:2], on_equator(degrees)),
        "step": 4,
        "one_circle": one_circle,
    }


@explorable(
    constants={
        "inks": {name: pyvista.Color(ink).float_rgb for name, ink in INKS.items()},
        "notYet": NOT_YET,
        "steps": STEPS,
        "verdicts": VERDICTS,
    },
    tries={
        "all four steps": {"step": 4},
        "the next point straight ahead": ahead(120, one_circle=False),
        "before the jump": ahead(295),
        "behind it": ahead(305),
    },
    answer={"step": 4},
    points=Handles(("P before", "P", "P after"), start=AHEAD),
    step=Slider(0, 4, "steps taken", step=1, stride=1, plays=8, start=0),
    printed_axis=Switch("step 2 with its misprint", start=False),
    printed_double=Switch("step 4 with its misprint", start=False),
    one_circle=Switch("keep *Pᵢ₊₁* on the great circle of the others", start=False),
)
def control_points_by_hand(state: State) -> pyvista.Plotter:
    """Draw the four steps to the control points, with either misprint, and test the result.

    Parameters
    ----------
    points : array_like, shape (3, 3)
        P_{i-1}, P_i and P_{i+1}; they are normalised.
    step : float
        How many of the steps are taken, from 0 to 4. A part of a step goes part of its way.
    printed_axis : bool
        Whether the second step turns about the axis of (5-9) as printed.
    printed_double : bool
        Whether the fourth step takes (5-13) as printed.
    one_circle : bool
        Whether P_{i+1} moves to the nearest point of the great circle through the other two.
    """
    plotter = sphere_scene(eye=(4.86, -0.2, 3.0), target=(0, 0, 0.06))
    texts = {"opposite": Text(text=r"$\mathrm{here}\ a_i\ \mathrm{jumps}$"), "P*": Text(VECTOR)}
    draw(plotter, state, GIVEN, texts)
    for name, color in (("way of a", RESULT), ("way of P", VECTOR)):
        # Nothing has moved yet, and a tube needs a length.
        add_line(plotter, [U, W], color, 0.006, name).visibility = False
    for k, name in enumerate((REFLECTED, MIDDLE, A, B)):
        ink, label = COLORS[name], name.strip("$")
        looks: dict[str, Look] = {
            f"path {k}": Lines(ink, 0.008 + 0.002 * k),
            name: Ball(ink),
        }
        # A state colours no label, so a point that a misprint spoils has another one.
        draw(plotter, state, looks, {label: Text(ink), f"{label} spoiled": Text(WRONG, name)})

    read_out(plotter, "now", "step", where="picture")
    read_out(plotter, "to_jump", "from *Pᵢ₊₁* to the jump", 0, "°", where="picture")
    for name, label in (
        ("tests", "four tests"),
        ("midway", "*P̄ᵢ* halfway from *P̄ᵢ₋₁* to *Pᵢ₊₁*"),
        ("on_circle", "*bᵢ*, *Pᵢ*, *aᵢ* on a great circle"),
        ("equally_far", "*aᵢ*, *bᵢ* equally far from *Pᵢ*"),
        ("no_corner", "straight on at *Pᵢ*"),
    ):
        read_out(plotter, name, label, where="folded")
    steps = (
        " A purple path leads straight on beyond P_i by as far again,",
        " another from there halfway to P_{i+1}.",
        " A green path comes halfway back to P_i: there is the control point a_i.",
        " The last one goes on to b_i, on the other side of P_i.",
    )
    describe(
        plotter,
        "A see-through sphere with three blue points P_{i-1}, P_i and P_{i+1}, joined by arcs,"
        " that can be dragged." + "".join(steps[: round(state["inputs"]["step"])]),
    )
    return plotter


def astray(points: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Compute all a_i and b_i of unit vectors with the axis of (5-9) as printed."""
    reflected = double(np.roll(points, 1, axis=0), points)
    # About the reversed axis, half of the angle turns away from the next point.
    a = bisect(points, slerp(reflected, np.roll(points, -1, axis=0), -0.5))
    return a, double(a, points)


def reversed_axis() -> pyvista.Plotter:
    """Draw what the axis of (5-9) as printed does to a closed curve."""
    samples = 24
    p = normalised(CAMERA_TARGETS)
    a, b = astray(p)
    after = np.roll(p, -1, axis=0)
    control = np.stack([p, a, np.roll(b, -1, axis=0), after], axis=1)
    printed = de_casteljau(control[:, np.newaxis], np.arange(samples) / samples)

    plotter = sphere_scene(eye=(4.6, 1.2, 2.6))
    curves = np.stack([closed_curve(p, samples).reshape(-1, 3), printed.reshape(-1, 3)])
    # Named where they are far from each other, in view; a colour would tell which is wrong.
    widest = samples // 2
    for name, curve, other in zip("AB", curves, curves[::-1], strict=True):
        add_line(plotter, [*curve, curve[0]], NEUTRAL, radius=0.01)
        away = curve[widest] - other[widest]
        add_label(plotter, curve[widest] + 0.12 * away / np.linalg.norm(away), f"${name}$")
    outward = p - p.mean(axis=0)
    for point, direction, name in zip(p, outward, CAMERA_SEES, strict=True):
        add_point(plotter, point, VECTOR)
        add_label(plotter, point + 0.17 * direction / np.linalg.norm(direction), name, VECTOR)
    describe(
        plotter,
        f"A unit sphere with {len(p)} points and two closed curves, A and B, through all of them."
        " Both look smooth, pass the points in different directions and swing out to different"
        " sides.",
    )
    return plotter
