"""Scenes of page 5 V: a gate, and a teaspoon on closed curves of orientations."""

import numpy as np
import pyvista

from rotedu.colors import CROSS, MATRIX, NEUTRAL, QUATERNION, RESULT, VECTOR
from rotedu.figures import State, describe, draw_chart, explorable, read_out
from rotedu.figures.inputs import Choice, Poses, Slider
from rotedu.quaternions import Quaternion
from rotedu.scenes.looks import Ball, Lines, Look, Mesh, Text, draw, spoon_in
from rotedu.scenes.parts import LITTLE, ROUND, add_line, add_sphere, new_scene
from rotedu.scenes.shapes import U, V, W, turning

__all__ = ["animate", "routes_by_hand", "the_swing", "two_middles"]

PLACES = (0, 100, 10, -60)
"""Where the gate of page 5 V is, in degrees, a second after another."""


@explorable(
    tries={
        "at 100°": {"t": 0.25},
        "where the other is farthest": {"t": 0.2},
        "at −60°": {"t": 0.75},
    },
    answer={"t": 0.2},
    constants={"places": PLACES},
    t=Slider(0, 1, "time, once round", step=0.0125, plays=8, start=0),
)
def the_swing(state: State) -> pyvista.Plotter:
    """Draw a gate that swings through four places, on two curves.

    Parameters
    ----------
    t : float
        The time, from 0 to 1.
    """
    plotter = new_scene((0, -3.4, 6.4), (0.1, -0.06, 0), view_angle=26, size=(600, 400))
    add_line(plotter, [[0, 0, -0.1], [0, 0, 0.6]], NEUTRAL, 0.06, "post")
    gate = pyvista.Box((0.08, 1.2, -0.02, 0.02, 0, 0.4))
    looks: dict[str, Look] = {
        "place *": Lines(VECTOR, 0.012),
        "shortest, way": Lines(CROSS, 0.012),
        "route, way": Lines(RESULT, 0.012),
        "shortest, gate": Mesh(gate, CROSS),
        "route, gate": Mesh(gate, RESULT),
    }
    names = {f"place {k}": f"{degrees}°".replace("-", "−") for k, degrees in enumerate(PLACES)}
    draw(plotter, state, looks, {place: Text(VECTOR, name) for place, name in names.items()})
    read_out(plotter, "route", "along the route", 0, "°", where="picture", color=RESULT)
    read_out(plotter, "shortest", "by shorter arcs", 0, "°", where="picture", color=CROSS)
    draw_angles(plotter, "t", (-90, 150), "turned, −90° to 150°")
    describe(
        plotter,
        "A gate on a post, seen from above, with four marked places: at 0, 100, 10 and minus 60"
        " degrees. A green gate and a purple one swing through all four. The tip of the green one"
        " stays between minus 60 and 100 degrees, that of the purple one swings out to 127.",
    )
    return plotter


def draw_angles(plotter: pyvista.Plotter, over: str, y: tuple[float, float], label: str) -> None:
    """Chart angles along both curves through four orientations."""
    draw_chart(
        plotter,
        "angles",
        over=over,
        x=(0, 1),
        y=y,
        label=label,
        colors={"route": RESULT, "shortest": CROSS, "marks": VECTOR},
        marks=["*R₀*", "*R₁*", "*R₂*", "*R₃*"],
        dashed=["shortest"],
    )


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
        "remembered": Ball(RESULT, 0.075),
        "shorter": Ball(CROSS, 0.075),
        "*": Ball(VECTOR, 0.06),
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
        "a swing to 100°": {"poses": about_v(0, 100, 10, -60)},
        "once right round": {"poses": about_v(0, 90, 180, 270)},
        "turns about many axes": {"poses": ROUTE, "u": 0.3625},
    },
    answer={"poses": ROUTE, "u": 0.3625},
    constants={"signs": ["cannot agree", "can agree"]},
    poses=Poses([f"spoon {k}" for k in range(4)], start=about_v(0, 90, 10, -60)),
    u=Slider(0, 1, "once round, *u*", step=0.0125, plays=10, start=0.1625),
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
        "route *": spoon_in(RESULT),
        "shortest": Lines(CROSS, 0.01),
        "shortest *": spoon_in(CROSS),
        "*": spoon_in(VECTOR),
    }
    draw(plotter, state, looks, {"R_*": Text(VECTOR)})
    for output, text in (
        ("turn", "widest turn from Double on"),
        ("apart", "curves apart by up to"),
        ("signs", "signs"),
    ):
        read_out(plotter, output, text, 1, "°", where="picture")
    draw_angles(plotter, "u", (0, 180), "turned from *R₀*, degrees")
    describe(
        plotter,
        "Four blue teaspoons, R0 to R3, stand round a see-through ball and can be turned. On the"
        " ball, spoons in the same poses lie on a closed curve of orientations: blue ones at the"
        " given poses, green ones in between, and a larger one on its way. A purple line with"
        " purple spoons, by the shortest way between matrices, swings out where the longest turn"
        " is more than half a turn.",
    )
    return plotter


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
WIDE = {"squad": 0.01, "the paper's": 0.02, "spline of M": 0.02}
JUMPY = ("squad", "the paper's")
"""Those whose velocity does not jump, but whose acceleration does."""
CHOICES = {
    "slerp and the paper's": ["slerp", "the paper's"],
    "squad and the paper's": ["squad", "the paper's"],
    "both splines": ["spline of q", "spline of M"],
    "all five": list(FILMS),
}
MIDDLE, FILMED = (0, 0, -0.3), 1.25
"""Where the ball is, and its radius; a spoon's tip is on it."""


@explorable(
    tries={
        "small turns": {"poses": SMALL, "films": "both splines"},
        "wide turns": {"films": "both splines"},
        "one sign changed": {"poses": FLIPPED},
        "two poses alike": {"poses": ALIKE, "t": 0.62, "films": "all five"},
    },
    constants={"choices": CHOICES, "jumpy": JUMPY, "most": MOST_POSES, "radius": FILMED},
    poses=Poses([f"spoon {k}" for k in range(MOST_POSES)], least=4, most=MOST_POSES, start=POSES),
    t=Slider(0, 1, "time, once round", plays=6, start=0),
    films=Choice("paths", tuple(CHOICES), start="slerp and the paper's"),
    fraction=Slider(0.2, 0.5, "how far *aᵢ* goes", step=0.005, row=False, start=1 / 2),
)
def animate(state: State) -> pyvista.Plotter:
    """Draw films of a spoon that go through the same poses at the same times, on one ball.

    Parameters
    ----------
    poses : array_like, shape (n, 4)
        From 4 to 6 poses as quaternions; they are normalised. The last leads to the first.
    t : float
        The time, from 0 to 1. A film shows the picture next to it.
    films : str
        One of `CHOICES`: which films are shown.
    fraction : float
        As for `rotedu.control_points.control_points`, for the paper's curve.
    """
    # From far away, so that spoons in the same pose look the same wherever they are.
    plotter = new_scene(-32 * V + 0.4 * W, 0.4 * W, view_angle=8, size=ROUND, swing=15)
    timeline: dict[str, Look] = {
        "rail": Lines(NEUTRAL, 0.012),
        "ticks": Lines(NEUTRAL, 0.012),
        "R_*": spoon_in(VECTOR),
        "again": spoon_in(VECTOR, opacity=0.3),
    }
    draw(plotter, state, timeline, {"R_*": Text(VECTOR), "again": Text(VECTOR, "$R_0$")})
    add_sphere(plotter, MIDDLE, FILMED)
    for name, ink in FILMS.items():
        film: dict[str, Look] = {
            f"{name}, tip": Lines(ink, WIDE.get(name, 0.014)),
            name: spoon_in(ink),
        }
        draw(plotter, state, film)

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
        ("picture", "fastest", "fastest, in the order of the films", "°/s"),
        ("folded", "speed", "speeds now, in this order", "°/s"),
        ("folded", "corner", "velocity of slerp jumps by", "°/s"),
        ("folded", "jumps", f"acceleration of {' and '.join(JUMPY)} jumps by", "°/s²"),
    ):
        read_out(plotter, output, text, digits=0, unit=unit, where=where)
    n = len(state["inputs"]["poses"])
    describe(
        plotter,
        f"{n} blue teaspoons, R0 to R{n - 1}, stand in a row above a line of time, which ends with"
        " the first again. Below, a see-through ball holds a spoon for each of the chosen films, at"
        " the same moment. A line on the ball is the way of its tip: with corners for slerp, in"
        " grey, smooth for squad and the spline of quaternions, in violet, and for the paper's"
        " curve, in ochre; the spline of matrices, in ochre, too, swings round where the others go"
        " straight.",
    )
    return plotter
