"""Scenes of page C: an arm and its skin, and the smallest turn from a direction to another."""

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.arcs import rotation_between
from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR, WRONG
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Choice, Handles, Slider
from rotedu.general_rotation import compose, rotation_w, swing_twist, translation
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix, transform
from rotedu.rigid_motion import screw_motion, straight_motion
from rotedu.scenes.looks import UNTOUCHED, Arrow, Ball, Lines, Look, Mesh, Text, draw, spoon_in
from rotedu.scenes.parts import LITTLE, add_label, add_line, add_sphere, new_scene, sphere_scene
from rotedu.scenes.shapes import ORIGIN, fan, normalised, stripes, teaspoon, turning

__all__ = [
    "SHOULDER",
    "SHOULDER_LIMIT",
    "from_a_to_b",
    "screw_and_straight",
    "swing_held_back",
    "the_arm",
    "the_wrist",
    "trackball_loop",
]

ELBOW, WRIST = 1.7, 3.0
BANDS = (0.45, 0.45)
"""How far from elbow and wrist two bones move the skin."""
PROFILE = np.array(
    [
        # Along the arm, half as wide, half as thick.
        (0.0, 0.02, 0.02),
        (0.05, 0.2, 0.2),
        (0.2, 0.3, 0.3),
        (0.8, 0.34, 0.34),
        (1.7, 0.28, 0.28),
        (2.2, 0.29, 0.29),
        (3.0, 0.22, 0.22),
        (3.45, 0.25, 0.18),
        (3.8, 0.34, 0.15),
        (4.2, 0.27, 0.12),
        (4.36, 0.15, 0.08),
        (4.4, 0.02, 0.02),
    ]
)
STATIONS = np.unique([*np.linspace(0, 4.4, 61).round(3), 0.02, WRIST, 4.385])


def radii() -> NDArray[np.float64]:
    """Smooth the profile at the stations, shape (n, 2): each is a mean of places near it."""
    near = np.clip(STATIONS + np.linspace(-0.2, 0.2, 9)[:, np.newaxis], 0, 4.4)
    means = [np.interp(near, PROFILE[:, 0], PROFILE[:, k]).mean(axis=0) for k in (1, 2)]
    smooth = np.stack(means, axis=1).round(4)
    smooth[[0, -1]] = PROFILE[0, 1:]
    return smooth


ARM = {
    "rings": np.column_stack([STATIONS, radii()]).tolist(),
    "elbow": ELBOW,
    "wrist": WRIST,
    "bands": BANDS,
}
SHOULDER = rotation_matrix([1, 2, -2], np.deg2rad(100))
"""Where an upper arm is asked to go, along U at rest."""
SHOULDER_LIMIT = 60
"""How far it can swing, in degrees."""
# Skin is dull.
SKIN = UNTOUCHED | {"specular": 0.03}
PALE = "#8fc1e3"
SKINS = ("matrices, averaged", "the same, repaired", "dual quaternions")
LOOKS: dict[str, Look] = {
    "one half": Mesh(stripes, VECTOR, SKIN),
    "other half": Mesh(stripes, PALE, SKIN),
    "way": Lines(RESULT, 0.02),
    "vertex": Ball(RESULT, 0.07),
    "or here": Ball(RESULT, 0.07),
}


@explorable(
    small=True,
    answer={"twist": 170},
    constants=ARM,
    twist=Slider(0, 360, "the hand is turned by, °", step=1, plays=8, start=0),
)
def the_wrist(state: State) -> pyvista.Plotter:
    """Draw a forearm with a hand that turns, and its skin by averaged matrices.

    Parameters
    ----------
    twist : float
        How far the hand is turned about the forearm, in degrees.
    """
    plotter = new_scene((3.3, -6, 2.2), (3.3, 0, 0), view_angle=10.5, size=LITTLE, swing=20)
    draw(plotter, state, LOOKS)
    add_label(plotter, [2.45, 0, -0.42], "forearm")
    add_label(plotter, [3.95, 0, -0.42], "hand")
    read_out(plotter, "wrist", "wrist as thick as", 0, "%", where="picture")
    describe(
        plotter,
        f"A striped forearm with a hand, turned by {state['inputs']['twist']:.0f} degrees. Between"
        f" them the skin is twisted, and {state['outputs']['wrist']:.0f} per cent as thick as"
        " before.",
    )
    return plotter


@explorable(
    tries={
        "a door handle": {"skin": SKINS[0], "twist": 170, "bend": 20},
        "repaired, and the elbow bent": {"skin": SKINS[1], "twist": 170, "bend": 80},
        "an elbow that bulges": {"skin": SKINS[2], "twist": 0, "bend": 120},
        "past half a turn": {"skin": SKINS[2], "twist": 200, "bend": 20},
    },
    constants=ARM,
    skin=Choice("The skin by", SKINS, start=SKINS[0]),
    twist=Slider(0, 360, "hand turned by, °", step=1, stride=10, plays=8, start=0),
    bend=Slider(0, 140, "elbow bent by, °", step=1, stride=10, start=20),
)
def the_arm(state: State) -> pyvista.Plotter:
    """Draw an arm of three bones, whose skin is moved by averages of their poses.

    Parameters
    ----------
    skin : str
        How the poses of two bones are averaged: one of `SKINS`.
    twist, bend : float
        How far the hand is turned and the elbow bent, in degrees.
    """
    plotter = new_scene((2.1, -13, 3.4), (2.15, 0, 1.25), view_angle=17, size=(720, 440))
    texts = {"bend": Text(NEUTRAL, "elbow"), "or here": Text(RESULT, "or here")}
    draw(plotter, state, LOOKS, texts)
    read_out(plotter, "wrist", "wrist as thick as", 0, "%", where="picture")
    read_out(plotter, "stretch", "skin stretched up to", 0, "%", where="picture")
    read_out(plotter, "volume", "of its volume at rest, the arm has", 1, "%")
    describe(
        plotter,
        f"A striped arm, its elbow bent by {state['inputs']['bend']:.0f} degrees and its hand"
        f" turned by {state['inputs']['twist']:.0f}. By {state['inputs']['skin']}, the wrist is"
        f" {state['outputs']['wrist']:.0f} per cent as thick as at rest. A green point of the"
        " skin, on the wrist, has left its path.",
    )
    return plotter


@explorable(
    tries={
        "a quarter turn": {"a": [0.8, 0.6, 0], "b": [0.48, -0.64, 0.6]},
        "almost opposite": {"a": [0.8, 0.6, 0], "b": [-0.74, -0.68, 0.1]},
        "from the other side": {"a": [0.8, 0.6, 0], "b": [-0.74, -0.68, -0.1]},
    },
    constants={"beside": [2.3, 0, 0]},
    a=Handles("a", start=(0.8, 0.58, 0.15)),
    b=Handles("b", start=(-0.3, -0.6, 0.74)),
)
def from_a_to_b(state: State) -> pyvista.Plotter:
    """Draw the smallest turn from a direction to another, and what it does to a spoon.

    Parameters
    ----------
    a, b : array_like, shape (3,)
        The directions.
    """
    stack = (55, 15, 348, 370, 1), (385, 70, 300, 260, 0.6)
    plotter = new_scene(
        (1, -9, 3), (1, 0, 0), view_angle=18, size=(720, 400), swing=30, stack=stack
    )
    looks: dict[str, Look] = {
        "arc": Lines(RESULT, 0.014),
        "axis": Arrow(AXIS),
        "a": Arrow(VECTOR),
        "b": Arrow(RESULT),
        "tip a": Ball(VECTOR, 0.05),
        "tip b": Ball(RESULT, 0.05),
        "opposite": Ball(NEUTRAL, 0.035),
        "spoon before": spoon_in(NEUTRAL, 0.35),
        "spoon after": spoon_in(VECTOR),
    }
    texts = {
        "a": Text(VECTOR, r"$\hat a$"),
        "b": Text(RESULT, r"$\hat b$"),
        "v": Text(AXIS, r"$\hat v$"),
        "opposite": Text(NEUTRAL, r"$-\hat a$"),
    }
    add_sphere(plotter)
    draw(plotter, state, looks, texts)
    read_out(plotter, "angle", "turned by", 1, "°", where="picture")
    read_out(plotter, "share", "1/(1 + *c*)", 2)
    describe(
        plotter,
        "A see-through ball with a blue arrow a and a green arrow b, the arc between their tips,"
        f" and the axis of the smallest turn from a to b, by {state['outputs']['angle']:.0f}"
        " degrees. A grey point lies opposite to a. Beside the ball, a grey spoon that points"
        " along a, and the same, turned, along b.",
    )
    return plotter


def screw_and_straight() -> pyvista.Plotter:
    """Draw two motions of a spoon from pose to pose: on a screw, and with a straight step."""
    start = translation([-1.1, 0, -0.75])
    end = compose(rotation_w(np.deg2rad(150)), translation([-1.1, 0, 0.75]))
    plotter = new_scene((2.4, -5.2, 6.4), (0, -0.3, 0.25), view_angle=19, size=(720, 440))
    add_line(plotter, [[0, 0, -1.25], [0, 0, 1.25]], AXIS, radius=0.012)
    add_label(plotter, [0, 0, 1.4], "axis of the screw", AXIS)
    t = np.linspace(0, 1, 97)
    for motion, color, name, place in (
        (screw_motion, RESULT, "screw", [-1.05, -0.9, -0.4]),
        (straight_motion, CROSS, "straight", [-0.45, 0.6, 0.2]),
    ):
        path = motion(start, end, t)[:, :3, 3]
        add_line(plotter, path, color, radius=0.014)
        add_label(plotter, place, name, color)
        for k, pose in enumerate(motion(start, end, np.linspace(0, 1, 5))):
            spoon = teaspoon(stations=41, around=16)
            spoon.points = transform(pose, 0.5 * spoon.points)
            plotter.add_mesh(spoon, color=VECTOR if k in (0, 4) else color, smooth_shading=True)
    describe(
        plotter,
        "Two blue teaspoons, one below on the left, one above on the right. Between them three"
        " green ones on a green helix about an upright orange line, and three purple ones whose"
        " middles lie on a straight purple line, which passes close to the orange one.",
    )
    return plotter


def swing_held_back() -> pyvista.Plotter:
    """Draw the cone in which an upper arm may swing, an arm beyond it, and the same held back."""
    swing, twist = swing_twist(SHOULDER, [1, 0, 0])
    axis, angle = axis_angle(swing)
    limit = np.deg2rad(SHOULDER_LIMIT)
    held = rotation_matrix(axis, limit)

    plotter = new_scene((2.4, -6, 2.6), (0.4, 0, -0.12), view_angle=21)
    rim = turning([np.cos(limit), np.sin(limit), 0], [1, 0, 0], 2 * np.pi, 72)
    plotter.add_mesh(fan([ORIGIN, *rim]), color=NEUTRAL, opacity=0.25, pickable=False)
    add_line(plotter, rim, NEUTRAL, radius=0.008)
    for turn, color, text, aside in (
        (np.eye(3), NEUTRAL, "at rest", [0.1, 0, -0.08]),
        (SHOULDER, WRONG, "asked for", [-0.1, 0, 0]),
        (held @ twist, RESULT, "held back", [0.16, 0, 0]),
    ):
        spoon = teaspoon(stations=61, around=20)
        spoon.points = transform(turn, 0.5 * spoon.points + [0.5, 0, 0])
        plotter.add_mesh(spoon, color=color, smooth_shading=True)
        add_label(plotter, 1.16 * turn[:, 0] + aside, text, color)
    path = turning([1, 0, 0], axis, angle, 48)
    add_line(plotter, path, AXIS, radius=0.012)
    add_label(plotter, 1.14 * path[12], "swing", AXIS)
    describe(
        plotter,
        f"A wide cone about a horizontal line, {SHOULDER_LIMIT} degrees to each side, with its tip"
        " at a shoulder. A grey spoon, for the arm at rest, lies in its middle; a red one points"
        " out of it. An orange arc leads from the tip of the grey spoon to that of the red one;"
        " where it meets the rim, a green spoon ends, turned about its own length as the red one"
        " is.",
    )
    return plotter


def trackball_loop() -> pyvista.Plotter:
    """Draw a ball that a finger has rolled once round a circle, and how it is turned by that."""
    eye = (2.6, -3.6, 2.2)
    ahead = normalised(eye)
    start = rotate(ahead, [0, 0, 1], np.deg2rad(30))
    loop = turning(start, ahead, 2 * np.pi, 90)
    left = np.eye(3)
    for turn in rotation_between(loop[:-1], loop[1:]):
        left = turn @ left
    plotter = sphere_scene(eye)
    plotter.add_mesh(fan([ahead, *loop]), color=RESULT, opacity=0.3, lighting=False, pickable=False)
    add_line(plotter, 1.005 * loop, RESULT, radius=0.016)
    add_label(plotter, 1.14 * loop[10], "finger", RESULT)
    for turn, color, opacity in ((np.eye(3), NEUTRAL, 0.4), (left, VECTOR, 1.0)):
        spoon = teaspoon(stations=61, around=20)
        spoon.points = transform(turn, 0.9 * spoon.points)
        plotter.add_mesh(spoon, color=color, smooth_shading=True, opacity=opacity)
    describe(
        plotter,
        "A see-through ball with a green circle on its front, which a finger has followed once."
        " In the ball a grey teaspoon, as it lay before, and a blue one, turned by about 48 degrees"
        " against it.",
    )
    return plotter
