"""Scenes of Chapter 2: two mirrors and the two quaternions of a rotation."""

import numpy as np
import pyvista

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Choice, Poses, Slider
from rotedu.ordinary_rotation import rotate
from rotedu.quaternions import Quaternion
from rotedu.scenes.looks import UNTOUCHED, Arrow, Ball, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import (
    HEAD,
    LITTLE,
    add_arrow,
    add_label,
    add_point,
    add_shadow,
    add_sphere,
    new_scene,
)
from rotedu.scenes.shapes import ORIGIN, U, W, fan, lathe, normalised, stripes, surface, teaspoon

__all__ = [
    "grab_the_spoon",
    "half_the_work",
    "letter_f",
    "mirrors_in_the_plane",
    "plate_and_arm",
    "the_ribbon",
    "two_mirrors_by_hand",
]

# Radius of the circle of the letters.
OUTER = 1.05
# Spoon and ball lie side by side: the camera looks at the point between.
EYE = 9 * np.array([4.4, 2.6, 2.4]) / np.linalg.norm([4.4, 2.6, 2.4])
ACROSS = normalised((-2.6, 4.4, 0))
# Half the length of the spoon that is turned by hand, and of those on the ribbon and on the plate.
LENGTH, REACH = 0.75, 0.46
# Radius of the plate, and length of the arm.
PLATE, ARM_LENGTH = 0.54, 1.92
# Where the first is turned, and how far below it its shadow lies.
TABLE = -2.2 * ACROSS
BELOW = 0.82
WAYS = (
    "by hand",
    "half turns *U*, *V*, *W*",
    "half turns *U*, *W*, *V*",
    "full turn",
    "home by slerp",
    "home by nlerp",
    "home by Euler angles",
)
# What the figure begins with: the spoon on the last of three half turns, and a way home.
UNDER_WAY = tuple(Quaternion.from_axis_angle([0, 1, 0], 1.55 * np.pi).components.tolist())
LEFT = tuple(Quaternion.from_axis_angle([0.1, 1, -0.15], np.deg2rad(140)).components.tolist())
# The other side of the ribbon: a light `VECTOR`.
PALE = "#8fc1e3"
CHINA = "#d3d7dc"
SOLID = {"smooth_shading": True}


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
    tries={
        "both mirrors, 60° on": {"both": 60},
        "mirrors at right angles": {"second": 90},
        "mirrors in one plane": {"second": 180},
    },
    constants={"outer": OUTER},
    # What comes later lies on top, where a hand could mean either.
    both=Slider(0, 360, "both mirrors, °", step=1, row=False, start=0),
    first=Slider(0, 360, "mirror 1, °", step=1, row=False, start=0),
    second=Slider(0, 360, "mirror 2, °", step=1, row=False, start=60),
    letter=Slider(-180, 180, "blue letter, °", step=1, row=False, start=-30),
)
def two_mirrors_by_hand(state: State) -> pyvista.Plotter:
    """Draw a letter mirrored twice, which turns by twice the angle between the mirrors.

    Parameters
    ----------
    both : float
        Angle in degrees by which both mirrors turn further.
    first, second : float
        Angle in degrees of each mirror about the W axis, from the U axis.
    letter : float
        Angle in degrees of the letter.
    """
    eye, target = (-4.55, -2.65, 5.8), (-0.06, -0.04, 0)
    plotter = new_scene(eye, target, view_angle=20.45, size=(600, 456))
    add_arrow(plotter, -0.15 * W, 0.3 * W, AXIS)
    add_label(plotter, -0.42 * W, r"$\hat n$", AXIS)
    draw(plotter, state, {"ring*": Lines(NEUTRAL, 0.004, 0.4)}, {"both": Text(text="both")})
    pale = {"opacity": 0.45, "lighting": False, "pickable": False}
    for k in (1, 2):
        looks: dict[str, Look] = {
            f"mirror {k}": Mesh(fan, NEUTRAL, pale),
            f"edge {k}": Lines(NEUTRAL, 0.004),
            f"m {k}": Arrow(NEUTRAL, 0.01),
        }
        draw(plotter, state, looks, {f"m {k}": Text(text=rf"$\hat m_{k}$")})
    add_letters(plotter, state)
    read_out(plotter, "between", "from mirror 1 to mirror 2", 0, "°", where="picture")
    read_out(plotter, "turned", "from blue to green letter", 0, "°", where="picture")
    read_out(plotter, "q", "*q* = −*m₂m₁* (*w* *x* *y* *z*)")
    read_out(plotter, "home", "green letter on blue letter", loud="yes")
    between = abs(state["outputs"]["between"])
    describe(
        plotter,
        f"Two upright mirrors meet at an axis n, {between:.0f} degrees apart. A blue letter F"
        " lies beside them. Its image in the first mirror is purple, in mirror writing. The image"
        " of this image in the second mirror is green and reads as an F again:"
        f" it is the blue one, turned by {2 * between:.0f} degrees.",
    )
    return plotter


def add_letters(plotter: pyvista.Plotter, state: State) -> None:
    """Add a letter, its image and the image of its image, with both angles."""
    # Where letters coincide, each shows: blue as a border, and purple lets through what is below.
    for name, color, thickness, border, opacity in (
        ("letter", VECTOR, 0.01, 0.02, 1.0),
        ("image", CROSS, 0.03, 0.0, 0.5),
        ("image of the image", RESULT, 0.02, 0.0, 1.0),
    ):
        mesh = letter_f(0.48, thickness, border)
        mesh.points = rotate(mesh.points, W, -np.pi / 2) + OUTER * U
        draw(plotter, state, {name: Mesh(mesh, color, {"opacity": opacity, "lighting": False})})
    for name, color, text in (("half", NEUTRAL, r"$\theta/2$"), ("whole", RESULT, r"$\theta$")):
        arc: dict[str, Look] = {name: Lines(color), f"{name}, head": Arrow(color, 0.01, HEAD)}
        draw(plotter, state, arc, {name: Text(text=text)})


@explorable(
    small=True,
    answer={"between": 20},
    constants={"outer": OUTER},
    between=Slider(0, 60, "between them, °", step=1, plays=5, start=0),
)
def mirrors_in_the_plane(state: State) -> pyvista.Plotter:
    """Draw two mirrors seen along the line in which they meet, and a letter mirrored twice.

    Parameters
    ----------
    between : float
        Angle in degrees from mirror 1 to mirror 2.
    """
    plotter = new_scene((0.3, -2.2, 9), (0.3, 0.13, 0), view_angle=18, size=LITTLE)
    draw(plotter, state, {"ring*": Lines(NEUTRAL, 0.004, 0.4)})
    for k in (1, 2):
        mirror: dict[str, Look] = {
            f"mirror {k}": Mesh(fan, NEUTRAL, {"pickable": False}),
            f"edge {k}": Lines(NEUTRAL, 0.012),
        }
        draw(plotter, state, mirror)
    add_letters(plotter, state)
    read_out(plotter, "turned", "from blue to green", 0, "°", where="picture")
    describe(
        plotter,
        f"Two mirrors seen edge on, {state['inputs']['between']:.0f} degrees apart. A blue letter"
        " F, 30 degrees from the first, has a purple image in it, in mirror writing, whose image in"
        f" the second is green: the F turned by {state['outputs']['turned']:.0f} degrees.",
    )
    return plotter


HALF, ALONG = 40, 0.8
"""Half the angle of the turn of Picture 2-b, in degrees, and the part of r along the axis."""


@explorable(
    tries={"the first product": {"done": 1}, "both": {"done": 2}},
    answer={"done": 2},
    constants={"half": np.deg2rad(HALF), "along": ALONG},
    done=Slider(0, 2, "products done", stride=1, plays=6, start=0),
)
def half_the_work(state: State) -> pyvista.Plotter:
    """Draw what each product of q r q* does to the parts of r across and along the axis.

    Parameters
    ----------
    done : float
        How many of the two products are done. Between, the factor is a power of q.
    """
    plotter = new_scene((0, -9, 0), (0, 0, 0.08), view_angle=15.5, size=(720, 330))
    inks = {"start": VECTOR, "between": CROSS, "now": RESULT}
    for name, x, across, up in (
        ("across", -1.3, "V", "W"),
        ("along", 1.3, "U", r"\text{scalar part}"),
    ):
        middle = np.array([x, 0, 0])
        for end, text in ((middle + U, across), (middle + 0.95 * W, up)):
            add_arrow(plotter, middle - 0.9 * (end - middle), end, NEUTRAL, radius=0.004)
            add_label(plotter, end + 0.16 * (end - middle), f"${text}$")
        looks: dict[str, Look] = {
            **{f"{name}: {when}": Arrow(ink, 0.018) for when, ink in inks.items()},
            f"{name}: first": Lines(CROSS, 0.012),
            f"{name}: second": Lines(RESULT, 0.012),
        }
        draw(plotter, state, looks)
    read_out(plotter, "scalar", "scalar part", 2, where="picture")
    describe(
        plotter,
        "Two dials. Left, the part of a blue vector r across the axis turns, in the plane of V and"
        " W, by 40 degrees with the first product and by 40 more with the second. Right, the part"
        " along U turns by 40 degrees away from the scalar part with the first product, and back"
        " with the second.",
    )
    return plotter


@explorable(
    tries={
        "half turns about *U*, *V*, *W*": {"way": "half turns U, V, W", "along": 1},
        "about *U*, *W*, *V*": {"way": "half turns U, W, V", "along": 1},
        "a wobbling full turn": {"way": "full turn", "along": 1},
        "home by Euler angles": {"way": "home by Euler angles", "along": 1},
    },
    constants={
        "inks": [pyvista.Color(ink).float_rgb for ink in (CROSS, RESULT)],
        "length": LENGTH,
    },
    spoon=Poses("the spoon", start=UNDER_WAY),
    way=Choice("The spoon turns", WAYS, start="half turns U, W, V"),
    along=Slider(0, 1, "along the way", step=0.01, stride=1 / 6, plays=9, start=0.85),
    left=Poses("where the way home begins", start=LEFT),
)
def grab_the_spoon(state: State) -> pyvista.Plotter:
    """Draw a spoon that is turned by hand, and its two quaternions in the ball of turns.

    Parameters
    ----------
    spoon : array_like, shape (4,)
        The quaternion of the spoon, turned by hand.
    way : str
        One of `WAYS`, on which the spoon turns otherwise.
    along : float
        How far it has come on its way, from 0 to 1.
    left : array_like, shape (4,)
        The quaternion with which a way home begins.
    """
    between = -1.02 * ACROSS
    stack = (-2, 22, 340, 326, 0.7), (340, 18, 366, 332, 0.89)
    plotter = new_scene(
        between + EYE, between, view_angle=14.78, size=(720, 368), swing=20, stack=stack
    )
    spoon = teaspoon(stations=61, around=20)
    spoon.points = LENGTH * (spoon.points - [0, 0, 0.05])
    looks: dict[str, Look] = {
        "axis [UVW]": Arrow(NEUTRAL, 0.006),
        "at the start": Mesh(spoon, NEUTRAL, UNTOUCHED | {"opacity": 0.25}),
        "spoon": Mesh(spoon, VECTOR, SOLID),
        "axis": Arrow(AXIS, 0.012),
        "turn": Lines(RESULT, 0.012),
        "axis in the ball": Lines(AXIS, 0.007),
        "way": Lines(RESULT, 0.018),
        "opposite way": Lines(CROSS, 0.009),
    }
    draw(plotter, state, looks, {"[UVW]": Text(), "axis": Text(AXIS, r"$\hat n$")})
    add_shadow(plotter, "spoon", TABLE, LENGTH, BELOW)
    # The viewer draws the ways of what the hand moves.
    for name, look in (("trail", looks["way"]), ("opposite trail", looks["opposite way"])):
        look.add(plotter, name, {}).visibility = False
    ends = {"q": Ball(RESULT, 0.055), "-q": Ball(CROSS, 0.04)}
    draw(plotter, state, ends, {name: Text(end.color) for name, end in ends.items()})
    halfway = pyvista.Sphere(radius=0.5, theta_resolution=32, phi_resolution=21)
    plotter.add_mesh(halfway, color=NEUTRAL, opacity=0.1, smooth_shading=True, pickable=False)
    add_ball_of_turns(plotter, state)

    read_out(plotter, "q", "*q* (*w* *x* *y* *z*)", where="picture")
    read_out(plotter, "angle", "angle", 0, "°", where="picture")
    read_out(plotter, "home", "spoon is as at the start", loud="yes")
    describe(
        plotter,
        "A spoon, which can be turned, and pale the same spoon as it lay at the start."
        f" One turn by {state['outputs']['angle']:.0f} degrees about an axis n leads from the pale"
        " one to the other. Beside them, a see-through ball with 1 in its middle and one of half"
        " turns. On a line in the direction of n lie q, as far from the middle as the angle is"
        " large, and the opposite quaternion on the other side."
        + (
            " A green and a purple line show the ways of both."
            if state["inputs"]["way"] != "by hand"
            else ""
        ),
    )
    return plotter


@explorable(
    small=True,
    answer={"done": 2.4},
    done=Slider(0, 3, "two turns, and the ribbon round", step=0.02, stride=1, plays=9, start=0),
)
def the_ribbon(state: State) -> pyvista.Plotter:
    """Draw a spoon that has turned on a ribbon, up to twice, and the ribbon passed round it.

    Parameters
    ----------
    done : float
        How often the spoon has turned, up to 2; beyond, how far the ribbon has come round it.
    """
    plotter = new_scene((4.6, 2.7, 3.0), (0, 0, 0.24), view_angle=25, size=LITTLE)
    looks: dict[str, Look] = {
        "bar": Lines(NEUTRAL, 0.025),
        "spoon": Mesh(little_spoon(), VECTOR, SOLID),
        "one half": Mesh(surface, VECTOR, UNTOUCHED),
        "other half": Mesh(surface, PALE, UNTOUCHED),
        "borders": Lines(NEUTRAL, 0.006),
    }
    draw(plotter, state, looks, {"spoon": Text()})
    read_out(plotter, "twists", "twists of the ribbon", 2, where="picture")
    twists = state["outputs"]["twists"]
    describe(
        plotter,
        "A spoon hangs on a ribbon from a fixed bar, blue on one side of its middle and pale on"
        f" the other. The spoon has turned {min(state['inputs']['done'], 2):g} times, and the"
        " ribbon "
        + (
            "is on its way round below the spoon."
            if isinstance(twists, str)
            else f"has {twists:g} twists."
        ),
    )
    return plotter


@explorable(
    tries={
        "one turn": {"turns": 1},
        "one and a half": {"turns": 1.5},
        "two turns": {"turns": 2},
    },
    answer={"turns": 0.62},
    constants={"plate": PLATE, "reach": ARM_LENGTH},
    turns=Slider(0, 2, "turns of the plate", step=0.01, stride=0.25, plays=12, start=0),
)
def plate_and_arm(state: State) -> pyvista.Plotter:
    """Draw a plate with a spoon on it, turned on a hand at the end of a striped arm.

    The turns of the arm, from the shoulder to the plate, are a path in the ball of turns.

    Parameters
    ----------
    turns : float
        How often the plate has turned about the upright, from 0 to 2.
    """
    middle = -1.71 * ACROSS + [0, 0, 0.06]
    stack = (2, 30, 440, 342, 1), (444, 74, 263, 266, 0.8)
    plotter = new_scene(middle + EYE, middle, view_angle=20, size=(720, 400), swing=20, stack=stack)
    spoon = little_spoon()
    spoon.points = 1.05 * spoon.points + [0, 0, 0.24]
    looks: dict[str, Look] = {
        "one half": Mesh(stripes, VECTOR, UNTOUCHED),
        "other half": Mesh(stripes, PALE, UNTOUCHED),
        "shoulder": Ball(NEUTRAL, 0.13),
        "plate": Mesh(round_plate(PLATE), CHINA, SOLID),
        "spoon": Mesh(spoon, VECTOR, UNTOUCHED),
        "path": Lines(RESULT, 0.016),
        "end": Ball(RESULT, 0.05),
    }
    draw(plotter, state, looks, {"end": Text(RESULT, "$q$")})
    add_ball_of_turns(plotter, state)
    read_out(plotter, "angle", "turned by", 0, "°", where="picture")
    read_out(plotter, "q", "*q* (*w* *x* *y* *z*)")
    read_out(plotter, "spoon_back", "spoon is back", loud="yes")
    read_out(plotter, "arm_straight", "arm is straight", loud="yes")
    describe(
        plotter,
        "A spoon lies on a plate, at the end of an arm with blue and pale stripes. The plate has"
        f" turned by {state['outputs']['angle']:.0f} degrees about the upright, and the arm follows"
        " it: straight at first, below the plate in the first turn, over it in the second. Beside"
        " them, a see-through ball in which a green path, the turns along the arm, leads from the"
        " middle, 1, to q.",
    )
    return plotter


def little_spoon() -> pyvista.PolyData:
    """Model a teaspoon of few points, as long as the plate is wide."""
    spoon = teaspoon(stations=61, around=20)
    spoon.points = REACH * (spoon.points - [0, 0, 0.05])
    return spoon


def round_plate(radius: float) -> pyvista.PolyData:
    """Model a plate with a raised rim, whose bottom is a little above the origin."""
    up = [0.11, 0.11, 0.16, 0.19, 0.2, 0.14, 0.14]
    out = radius * np.array([0, 0.62, 0.95, 1, 0.96, 0.6, 0])
    return lathe(np.column_stack([out, up]))


def add_ball_of_turns(plotter: pyvista.Plotter, state: State) -> None:
    """Add the ball of all unit quaternions around what is in it.

    A quaternion lies in the direction of its axis, as far from the middle as its angle is large: 1
    is the middle, half turns are half way, and -1, a whole turn about any axis, is the skin.
    """
    add_point(plotter, ORIGIN, NEUTRAL, 0.035, name="one")
    add_label(plotter, -0.16 * W, "$1$", name="one")
    ball = pyvista.Sphere(radius=0.985, theta_resolution=32, phi_resolution=21)
    draw(plotter, state, {"skin": Mesh(ball, RESULT, UNTOUCHED | {"opacity": 0.16})})
    # What is inside does not stand behind the glass.
    add_sphere(plotter)
