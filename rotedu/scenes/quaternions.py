"""Scenes of Chapter 2: two mirrors and the two quaternions of a rotation."""

from typing import NamedTuple

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import nlerp, slerp
from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.figures import Choice, Poses, Slider, describe, explorable, limit_turning, read_out
from rotedu.figures.frames import LAMP, place_grip, place_part, stack_on_phone
from rotedu.general_rotation import (
    euler_angles,
    homogeneous,
    quaternion_from_euler_angles,
    translation,
)
from rotedu.ordinary_rotation import rotate, rotation_matrix
from rotedu.quaternions import Quaternion
from rotedu.scenes.parts import (
    ORIGIN,
    add_arrow,
    add_label,
    add_line,
    add_lines,
    add_point,
    add_sphere,
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
U = np.array([1.0, 0.0, 0.0])
# The ribbon reaches from a bar down to a spoon about the middle of shells that turn.
SPOON, BAR, WIDTH, STEM = 0.42, 1.26, 0.11, 0.06
# Half the length of the spoon, and the radius of the ring about it.
REACH, RING = 0.4, 0.6
# Spoon and ball lie side by side: the camera looks at the point between.
EYE = 9 * np.array([4.4, 2.6, 2.4]) / np.linalg.norm([4.4, 2.6, 2.4])
ACROSS = np.array([-2.6, 4.4, 0.0]) / np.hypot(2.6, 4.4)
HOME = -2.35 * ACROSS
MIDDLE = -1.13 * ACROSS + [0, 0, 0.1]
# The other side of the ribbon: a light `VECTOR`.
PALE = "#8fc1e3"
ON_ITS_WAY = "on its way"
# A spoon that is turned by hand: its place and half its length.
TABLE = -2.2 * ACROSS
LENGTH = 0.75
WAYS = (
    "by hand",
    "half turns U, V, W",
    "half turns U, W, V",
    "full turn",
    "home by slerp",
    "home by nlerp",
    "home by Euler angles",
)
STEPS_OF_WAY = 120
WOBBLE = 0.3
# A smaller share of a whole turn has no axis to show.
SHOWN_TURN = 0.01
# What the figure begins with: the spoon on the last of three half turns, and a way home.
UNDER_WAY = tuple(Quaternion.from_axis_angle([0, 1, 0], 1.55 * np.pi).components.tolist())
LEFT = tuple(Quaternion.from_axis_angle([0.1, 1, -0.15], np.deg2rad(140)).components.tolist())
# A vector part without a direction, and a step of a path that is a jump through the skin.
NO_AXIS, JUMP = 1e-6, 0.35
# From this share of a whole turn on, a quaternion is on the skin.
ON_SKIN = 0.97
TINY = 1e-12
# Radii of the circles of the angle between the mirrors and of the letters.
INNER, OUTER = 0.55, 1.05


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
    tries={
        "both mirrors, 60° on": {"both": 60},
        "mirrors at right angles": {"second": 90},
        "mirrors in one plane": {"second": 180},
    },
    # What comes later lies on top, where a hand could mean either.
    both=Slider(0, 360, "both mirrors, °", step=1, row=False),
    first=Slider(0, 360, "mirror 1, °", step=1, row=False),
    second=Slider(0, 360, "mirror 2, °", step=1, row=False),
    letter=Slider(-180, 180, "blue letter, °", step=1, row=False),
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

    # The shorter way, as mirrors are grabbed and led round.
    between = 180 - (180 - second + first) % 360
    angles = (first + both, second + both)
    m1, m2 = (Quaternion(0, out(angle + 90)) for angle in angles)
    start = rotation_matrix(W, np.deg2rad(letter))
    once = m1 * Quaternion(0, start.T) * m1
    twice = m2 * once * m2

    plotter = new_scene(
        eye=(-4.55, -2.65, 5.8), target=(-0.06, -0.04, 0), view_angle=20.45, size=(600, 456)
    )
    add_arrow(plotter, -0.15 * W, 0.3 * W, AXIS)
    add_label(plotter, -0.42 * W, r"$\hat n$", AXIS)
    for radius in (INNER, OUTER):
        ring = add_line(plotter, turning(out(0, radius), W, 2 * np.pi), NEUTRAL, 0.004, name="ring")
        ring.prop.opacity = 0.4
    stem = np.stack([out(letter, OUTER + far) for far in (-0.24, 0.24)])
    place_grip(plotter, "letter", path=turning(out(-180, OUTER), W, 2 * np.pi), body=stem)
    aside = out(first + between / 2 + 130, INNER)
    place_grip(plotter, "both", path=turning(aside, W, 2 * np.pi))
    add_label(plotter, out(first + both + between / 2 + 130, INNER + 0.28), "both")
    # The second mirror is longer: both show where they coincide.
    for name, angle, m, k, size in zip(
        ("first", "second"), angles, (m1, m2), (1, 2), (1.4, 1.65), strict=True
    ):
        foot, top = out(angle, size), 0.3 * W
        edge = np.stack([ORIGIN, foot, foot + top, top])
        sheet = triangle_mesh(edge, [[0, 1, 2], [0, 2, 3]])
        part = place_part(plotter, f"mirror {k}", points=edge)
        plotter.add_mesh(
            sheet, color=NEUTRAL, opacity=0.45, lighting=False, pickable=False, name=part
        )
        middle = out(both, size) + top / 2
        place_grip(
            plotter, name, path=turning(middle, W, 2 * np.pi), body=[top / 2, foot + top / 2]
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
        mesh.points = rotate(mesh.points, W, -np.pi / 2) + out(0, OUTER)
        matrix = homogeneous(images.T)
        name = place_part(plotter, name, matrix=matrix.T.ravel())
        actor = plotter.add_mesh(mesh, color=color, opacity=opacity, lighting=False, name=name)
        actor.user_matrix = matrix

    for begin, angle, radius, text, color, name in (
        (angles[0], between, INNER, r"$\theta/2$", NEUTRAL, "half"),
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

    for name, angle, label in (
        ("between", between, "from mirror 1 to mirror 2"),
        ("turned", 2 * between, "from blue to green letter"),
    ):
        read_out(plotter, name, angle, label, 0, "°", where="picture")
    read_out(plotter, "q", -(m2 * m1).components, "q = −m₂m₁ (w x y z)", 2)
    read_out(plotter, "home", is_back(2 * between, 360), "green letter on blue letter", loud="yes")
    describe(
        plotter,
        f"Two upright mirrors meet at an axis n, {abs(between):.0f} degrees apart. A blue letter F"
        " lies beside them. Its image in the first mirror is purple, in mirror writing. The image"
        " of this image in the second mirror is green and reads as an F again:"
        f" it is the blue one, turned by {abs(2 * between):.0f} degrees.",
    )
    return plotter


@explorable(
    model="grabTheSpoon",
    constants={
        "lamp": LAMP,
        "inks": [pyvista.Color(ink).float_rgb for ink in (CROSS, RESULT)],
    },
    tries={
        "half turns about U, V, W": {"way": "half turns U, V, W", "along": 1},
        "about U, W, V": {"way": "half turns U, W, V", "along": 1},
        "a wobbling full turn": {"way": "full turn", "along": 1},
        "home by Euler angles": {"way": "home by Euler angles", "along": 1},
    },
    spoon=Poses("the spoon"),
    way=Choice("The spoon turns", list(WAYS)),
    along=Slider(0, 1, "along the way", step=0.01, stride=1 / 6, plays=9),
    left=Poses("where the way home begins"),
)
def grab_the_spoon(
    spoon: ArrayLike = UNDER_WAY,
    way: str = "half turns U, W, V",
    along: float = 0.85,
    left: ArrayLike = LEFT,
) -> pyvista.Plotter:
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

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    going = way != "by hand"
    times = np.append(np.arange(0, along * STEPS_OF_WAY - TINY) / STEPS_OF_WAY, along)
    w, *v = np.asarray(spoon, float)
    gone = on_way(way, left, times) if going else Quaternion([w], [v])
    axes, shares = turns_of(gone)
    axis, share = axes[-1], float(shares[-1])
    q = gone.components[-1]
    matrix = rotation_matrix(axis, 2 * np.pi * share)
    turned = SHOWN_TURN < share < 1 - SHOWN_TURN

    between = -1.02 * ACROSS
    plotter = new_scene(between + EYE, between, view_angle=14.78, size=(720, 368))
    limit_turning(plotter, 20)
    stack_on_phone(plotter, (8, 22, 320, 326, 0.66), (318, 18, 410, 332, 1))
    # The letters leave room for the name of an axis along theirs.
    for direction, aside, letter in zip(np.eye(3), [-W, -W, ACROSS], "UVW", strict=True):
        add_arrow(plotter, TABLE, TABLE + 0.9 * direction, NEUTRAL, 0.006, f"axis {letter}")
        add_label(plotter, TABLE + 0.88 * direction + 0.13 * aside, f"${letter}$")
    body = teaspoon(stations=61, around=20)
    body.points = LENGTH * (body.points - [0, 0, 0.05])
    resting = body.translate(TABLE)
    plotter.add_mesh(resting, color=NEUTRAL, opacity=0.25, smooth_shading=True, pickable=False)
    pose = translation(TABLE) @ homogeneous(matrix)
    name = place_part(plotter, "spoon", matrix=pose.T.ravel())
    plotter.add_mesh(body, color=VECTOR, smooth_shading=True, name=name).user_matrix = pose
    place_grip(plotter, "spoon", at=TABLE, size=0.85)

    foot, tip = TABLE - 0.8 * axis, TABLE + 0.92 * axis
    add_arrow(plotter, foot, tip, AXIS, 0.012, "axis").visibility = turned
    add_label(plotter, TABLE + 1.03 * axis if turned else None, r"$\hat n$", AXIS, name="axis")
    arc = TABLE + turning(LENGTH * U, axis, 2 * np.pi * (share if turned else 0.5))
    add_line(plotter, arc, RESULT, 0.012, "turn").visibility = turned

    point, opposite = share * axis, (share - 1) * axis
    add_line(plotter, [-axis, axis], AXIS, 0.007, "axis in the ball").visibility = turned
    here, there = (np.multiply(axes, (shares - less)[:, np.newaxis]) for less in (0, 1))
    for name, path, color, radius in (
        ("way", here, RESULT, 0.018),
        ("opposite way", there, CROSS, 0.009),
        ("trail", here, RESULT, 0.018),
        ("opposite trail", there, CROSS, 0.009),
    ):
        runs = pieces(path) if going and "way" in name else []
        add_lines(plotter, runs or [[ORIGIN, W]], color, radius, name).visibility = bool(runs)
    for name, place, color, size in (("q", point, RESULT, 0.055), ("-q", opposite, CROSS, 0.04)):
        add_point(plotter, place, color, size, name=name)
        add_label(plotter, beside(place), f"${name}$", color, name=name)
    halfway = pyvista.Sphere(radius=0.5, theta_resolution=32, phi_resolution=21)
    plotter.add_mesh(halfway, color=NEUTRAL, opacity=0.1, smooth_shading=True, pickable=False)
    color = RESULT if share > 0.5 else CROSS
    add_ball_of_turns(plotter, color).visibility = max(share, 1 - share) > ON_SKIN

    read_out(plotter, "q", q, "q (w x y z)", 2, where="picture")
    read_out(plotter, "angle", 360 * share, "angle", 0, "°", where="picture")
    home = max(share, 1 - share) > 1 - BACK / 360
    read_out(plotter, "home", home, "spoon is as at the start", loud="yes")
    describe(
        plotter,
        "A spoon, which can be turned, and pale the same spoon as it lay at the start."
        f" One turn by {360 * share:.0f} degrees about an axis n leads from the pale one to the"
        " other. Beside them, a see-through ball with 1 in its middle and one of half turns."
        " On a line in the direction of n lie q, as far from the middle as the angle is large, and"
        " the opposite quaternion on the other side."
        + (" A green and a purple line show the ways of both." if going else ""),
    )
    return plotter


@explorable(
    model="doubleCover",
    constants={"lamp": LAMP, "on_its_way": ON_ITS_WAY},
    tries={f"{n} turn{'s' * (n > 1)}": {"turns": n, "passed": 0} for n in (1, 2, 3, 4)},
    turns=Slider(0, 4, "turns of the spoon", step=0.05, stride=1, plays=16),
    passed=Slider(0, 2, "ribbon passed round it, times", step=0.02, stride=0.5, plays=12),
)
def double_cover_by_hand(turns: float = 2, passed: float = 0.44) -> pyvista.Plotter:
    """Draw a spoon that has turned on a ribbon, and how the ribbon is passed round it.

    From its bar to the spoon the ribbon is a path of rotations, which is drawn in a ball as well.
    While nothing is on its way, a band about the spoon shows its two quaternions: q lies
    cos(theta / 2) up from a ring and sin(theta / 2) out, -q opposite.

    Parameters
    ----------
    turns : float
        How often the spoon has turned, from 0 to 4.
    passed : float
        How often the ribbon has been passed round the spoon, up to `passes`.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    passed = min(passed, passes(turns))
    hangs = float(passed).is_integer()
    angle = 2 * np.pi * turns
    q = Quaternion.from_axis_angle(W, angle)
    matrix = rotation_matrix(W, angle)

    plotter = new_scene(MIDDLE + EYE, MIDDLE, view_angle=16.05, size=(720, 400))
    limit_turning(plotter, 20)
    stack_on_phone(plotter, (5, 4, 335, 382, 0.6), (336, 48, 407, 332, 1))
    bar = HOME + BAR * W
    add_line(plotter, [bar - 2.5 * WIDTH * U, bar + 2.5 * WIDTH * U], NEUTRAL, 0.025)
    spoon = teaspoon(stations=41, around=16)
    spoon.points = REACH * (spoon.points - [0, 0, 0.05])
    pose = translation(HOME) @ homogeneous(matrix)
    name = place_part(plotter, "spoon", matrix=pose.T.ravel())
    plotter.add_mesh(spoon, color=VECTOR, smooth_shading=True, name=name).user_matrix = pose
    edges = [side_of_ribbon(turns, passed, width) for width in (-WIDTH, 0, WIDTH)]
    for name, between, color in (("one", edges[:2], VECTOR), ("other", edges[1:], PALE)):
        half = strip(*between)
        name = place_part(plotter, f"{name} half", points=half.points)
        plotter.add_mesh(half, color=color, smooth_shading=True, pickable=False, name=name)
    add_lines(plotter, [edges[0][::2], edges[2][::2]], NEUTRAL, 0.006, name="borders")
    place_grip(plotter, "turns", path=once_for_each_turn())
    place_grip(plotter, "passed", path=way_of_ribbon(turns))

    rounds = np.linspace(0, 2 * np.pi, 97)
    band = [HOME + RING * on_band(rounds, side) for side in (1.0, 0.0, -1.0)]
    name = place_part(plotter, "band")
    plotter.add_mesh(
        sheet(band), color=NEUTRAL, opacity=0.5, smooth_shading=True, pickable=False, name=name
    ).visibility = hangs
    way = HOME + RING * on_band(np.linspace(0, angle or 0.1, 97), 1)
    ends = {side: HOME + RING * on_band(angle, side) for side in (1.0, -1.0)}
    for name, points, color, radius, drawn in (
        ("ring", band[1][::2], VECTOR, 0.007, hangs),
        ("way", way, RESULT, 0.014, hangs and turns > 0),
        ("stick", list(ends.values()), NEUTRAL, 0.009, hangs),
    ):
        add_line(plotter, points, color, radius, name).visibility = drawn
    for side, color, text in ((1.0, RESULT, "q"), (-1.0, CROSS, "-q")):
        add_point(plotter, ends[side], color, 0.04, name=text).visibility = hangs
        place = HOME + RING * on_band(angle, 1.6 * side) if hangs else None
        add_label(plotter, place, f"${text}$", color, name=text)

    axes, shares = turns_of(along_ribbon(turns, passed, np.linspace(0, 1, 161)))
    path = axes * shares[:, np.newaxis]
    runs = pieces(path)
    add_lines(plotter, runs or [[ORIGIN, W]], RESULT, 0.016, "path").visibility = bool(runs)
    add_point(plotter, path[-1], RESULT, 0.05, name="end")
    add_label(plotter, beside(path[-1]), "$q$", RESULT, name="end")
    add_ball_of_turns(plotter, RESULT).visibility = bool(shares[-1] > ON_SKIN)

    twists = turns - 2 * passed if hangs else ON_ITS_WAY
    read_out(plotter, "twists", twists, "twists of the ribbon", 2, where="picture")
    read_out(plotter, "spoon_back", is_back(360 * turns, 360), "spoon is back", loud="yes")
    read_out(plotter, "q_back", is_back(360 * turns, 720), "q is back", loud="yes")
    read_out(plotter, "q", q.components, "q (w x y z)", 2)
    read_out(plotter, "matrix", matrix, "matrix", 2, where="folded")
    describe(
        plotter,
        "A spoon hangs on a ribbon from a fixed bar, which is blue on one side of its middle"
        f" and pale on the other. The spoon has turned {turns:g} times, and the ribbon"
        + (f" has {twists:g} twists." if hangs else " is on its way round below the spoon.")
        + " Beside it, a see-through ball. A green path leads in it from the middle, 1, to q: the"
        " rotations of the ribbon from the bar to the spoon."
        + (
            " A band with half a twist lies about the spoon, with q on its edge and -q opposite."
            if hangs
            else ""
        ),
    )
    return plotter


def passes(turns: float) -> int:
    """Return how often a ribbon must be passed round the spoon to lose all twists but one."""
    return 1 if turns <= 2 else 2


def along_ribbon(turns: float, passed: float, s: ArrayLike) -> Quaternion:
    """Return the rotations of the ribbon on its way from the bar to the spoon.

    Parameters
    ----------
    turns : float
        How often the spoon has turned.
    passed : float
        How often the ribbon has been passed round the spoon, up to `passes`.
    s : array_like, shape (n,)
        Fractions of the way, which goes at constant speed.

    Returns
    -------
    Quaternion
        The rotations.
    """
    arc = moving_arc(turns, passed)
    gone = np.multiply(s, arc.length + np.pi * arc.staying)
    turned = np.minimum(gone, arc.length) / max(arc.radius, TINY)
    w, along, aside = rotate([1, 0, 0], arc.axis, turned).T
    moved = Quaternion(w, np.outer(along, W) + np.outer(aside, arc.side))
    stayed = Quaternion.from_axis_angle(W, 2 * np.maximum(gone - arc.length, 0))
    turned_on: Quaternion = stayed * moved
    return turned_on


class Arc(NamedTuple):
    """An arc of unit quaternions: a part of a circle about an axis.

    The axis has coordinates along 1, W and a direction to the side. The quaternion of so many
    turns about W, which stay as they are, follows the arc.
    """

    axis: NDArray[np.float64]
    radius: float
    length: float
    side: NDArray[np.float64]
    staying: float


def moving_arc(turns: float, passed: float) -> Arc:
    """Return the arc to which the ribbon is a path, beside turns that stay next to the spoon.

    Its ends are held: 1 at the bar, a quaternion about W at the other end. Two turns are a great
    circle from 1 to 1, which shrinks to a point. Fewer are an arc of it, which goes over to the
    other arc between its ends, with two turns less. On the way the circle is that through the ends
    and the middle of the arc, which moves evenly from one side to the other.
    """
    done = min(np.floor(passed), passes(turns) - 1)
    left, tau = turns - 2 * done, passed - done
    moving, staying = min(left, 2.0), max(left - 2.0, 0.0)
    half = np.pi * moving / 2
    rise, out = np.cos(np.pi * tau) - np.cos(half), np.sin(np.pi * tau)
    tilt = np.arctan2(out, rise)
    axis = np.array([-np.sin(tilt) * np.cos(half), -np.sin(tilt) * np.sin(half), np.cos(tilt)])
    radius = float(np.hypot(axis[1], axis[2]))
    length = radius * 4 * np.arctan2(np.hypot(rise, out), np.sin(half))
    return Arc(axis, radius, length, rotate(ACROSS, W, np.pi / 6 * (2 - moving)), staying)


def side_of_ribbon(turns: float, passed: float, width: float) -> NDArray[np.float64]:
    """Place a line of the ribbon, which is so far from its middle, from spoon to bar.

    Shells about the spoon turn as the ribbon does. So it crosses neither itself nor the spoon.
    """
    r = np.linspace(STEM, BAR, 201)
    x = np.clip((r - SPOON) / (BAR - SPOON), 0, 1)
    q = along_ribbon(turns, passed, 1 - x * x * (3 - 2 * x))
    line: NDArray[np.float64] = HOME + q.rotate(width * U + np.outer(r, W))
    return line


def way_of_ribbon(turns: float) -> NDArray[np.float64]:
    """Return where the middle of what moves is, for all values of `passed`.

    At the end the way goes on to the bar: a path that ended where it begins would have no end.
    """

    def middle(passed: float) -> NDArray[np.float64]:
        """Return where the middle of the moving part is."""
        arc = moving_arc(turns, passed)
        s = arc.length / (arc.length + np.pi * arc.staying) / 2 if arc.staying else 0.5
        # The inverse of the smooth step by which a shell's radius gives its place on the way.
        x = 0.5 - np.sin(np.arcsin(2 * s - 1) / 3)
        q = along_ribbon(turns, passed, [s])
        point: NDArray[np.float64] = HOME + q.rotate((SPOON + x * (BAR - SPOON)) * W)[0]
        return point

    most = passes(turns)
    places: list[NDArray[np.float64]] = [
        middle(min(passed, most)) + max(passed - most, 0) * (HOME + BAR * W - middle(most))
        for passed in np.linspace(0, 2, 97)
    ]
    return np.array(places)


def once_for_each_turn() -> NDArray[np.float64]:
    """Return the way of the tip of the spoon, which opens a little: four turns have two ends."""
    angles = np.linspace(0, 8 * np.pi, 97)
    radii = REACH * np.linspace(1, 1.01, 97)[:, np.newaxis]
    way: NDArray[np.float64] = HOME + radii * rotate(U, W, angles)
    return way


def on_way(way: str, left: ArrayLike, times: ArrayLike) -> Quaternion:
    """Return the quaternions of the spoon on a way.

    Parameters
    ----------
    way : str
        One of `WAYS`, but by hand.
    left : array_like, shape (4,)
        The quaternion with which a way home begins.
    times : array_like, shape (n,)
        From 0 to 1.

    Returns
    -------
    Quaternion
        The quaternions, without a jump; a way home leads to 1 or -1.
    """
    t = np.asarray(times, float)
    start = np.asarray(left, float)
    if way.startswith("half turns"):
        first, second, third = (np.eye(3)["UVW".index(letter)] for letter in way[-7::3])
        angles = np.pi * np.clip(3 * t[:, np.newaxis] - [0, 1, 2], 0, 1)
        turned: Quaternion = (
            Quaternion.from_axis_angle(third, angles[:, 2])
            * Quaternion.from_axis_angle(second, angles[:, 1])
            * Quaternion.from_axis_angle(first, angles[:, 0])
        )
        return turned
    if way == "full turn":
        sway = WOBBLE * np.stack([np.sin(4 * np.pi * t), np.sin(6 * np.pi * t)], axis=-1)
        axis = np.column_stack([sway, np.ones_like(t)])
        whole: Quaternion = Quaternion.from_axis_angle(axis, 2 * np.pi * t)
        return whole
    if way == "home by Euler angles":
        angles_left = np.stack(euler_angles(Quaternion(start[0], start[1:]).matrix()))
        u, v, w = np.multiply.outer(angles_left, 1 - t)
        path = quaternion_from_euler_angles(u, v, w)
        sign = np.sign(quaternion_from_euler_angles(*angles_left).components @ start)
        signed: Quaternion = sign * path
        return signed
    to = np.array([1.0 if start[0] >= 0 else -1.0, 0, 0, 0])
    between = {"home by slerp": slerp, "home by nlerp": nlerp}[way](start, to, t)
    return Quaternion(between[:, 0], between[:, 1:])


def add_ball_of_turns(plotter: pyvista.Plotter, color: str) -> pyvista.Actor:
    """Add the ball of all unit quaternions around what is in it, and return its skin.

    A quaternion lies in the direction of its axis, as far from the middle as its angle is large: 1
    is the middle, half turns are half way, and -1, a whole turn about any axis, is the skin.
    """
    add_point(plotter, ORIGIN, NEUTRAL, 0.035, name="one")
    add_label(plotter, -0.16 * W, "$1$", name="one")
    ball = pyvista.Sphere(radius=0.985, theta_resolution=32, phi_resolution=21)
    name = place_part(plotter, "skin")
    skin = plotter.add_mesh(
        ball, color=color, opacity=0.16, smooth_shading=True, pickable=False, name=name
    )
    # What is inside does not stand behind the glass.
    add_sphere(plotter)
    return skin


def beside(point: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return where the name of a point of the ball is: where the glass does not hide it."""
    place: NDArray[np.float64] = 0.9 * point + 0.1 * ACROSS + 0.12 * W
    return place


def turns_of(path: Quaternion) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return axes and angles of unit quaternions, as shares of a whole turn.

    Parameters
    ----------
    path : Quaternion
        Quaternions one after the other: at 1 and -1, where any axis would do, the axis is that of
        the one before, and at the beginning that of the first one after.

    Returns
    -------
    axes : ndarray, shape (n, 3)
        Unit vectors.
    shares : ndarray, shape (n,)
        From 0 for the quaternion 1 over 1/2 for half a turn to 1 for -1. The opposite quaternion
        has the same axis and a share that is less by 1.
    """
    sizes = np.linalg.norm(path.v, axis=-1)
    known = np.flatnonzero(sizes > NO_AXIS)
    if not known.size:
        return np.tile(W, (len(sizes), 1)), np.arctan2(sizes, path.w) / np.pi
    last = np.searchsorted(known, np.arange(len(sizes)), side="right") - 1
    from_ = known[np.maximum(last, 0)]
    return path.v[from_] / sizes[from_, np.newaxis], np.arctan2(sizes, path.w) / np.pi


def pieces(path: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Cut a path where it jumps through the skin of the ball; leave out what has no length."""
    steps = np.linalg.norm(np.diff(path, axis=0), axis=-1)
    parts = np.split(path, np.flatnonzero(steps > JUMP) + 1)
    return [part for part in parts if np.ptp(part, axis=0).max() > NO_AXIS]


def strip(one: NDArray[np.float64], other: NDArray[np.float64]) -> pyvista.PolyData:
    """Span a surface between two lines, shape (n, 3) each."""
    k = np.arange(len(one) - 1)
    n = len(one)
    triangles = np.vstack(
        [np.column_stack([k, k + 1, n + k]), np.column_stack([k + 1, n + k + 1, n + k])]
    )
    return triangle_mesh(np.vstack([one, other]), triangles)


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
