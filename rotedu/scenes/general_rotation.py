"""Scenes of Chapter 4: three rotations, the one that replaces them, and transforms."""

from collections.abc import Sequence
from itertools import zip_longest

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.errors import DegenerateError
from rotedu.figures import (
    Choice,
    Poses,
    Slider,
    describe,
    draw_chart,
    explorable,
    limit_turning,
    read_out,
    stack_on_phone,
)
from rotedu.figures.frames import place_grip, place_part
from rotedu.general_rotation import (
    axis_angle_from_euler_angles,
    matrix_from_euler_angles,
    perspective,
    rotation_v,
    scaling,
    shearing,
    translation,
)
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix, transform
from rotedu.orientations import slerp_rotations
from rotedu.quaternions import Quaternion
from rotedu.scenes.parts import (
    ORIGIN,
    add_arrow,
    add_coordinate_axes,
    add_label,
    add_line,
    add_lines,
    add_point,
    add_sphere,
    add_thin,
    new_scene,
    shade,
    sphere_scene,
    teaspoon,
    turning,
)

BACK = np.array([0.49, -0.77, 0.42])
"""The direction out of the picture of `three_turns_by_hand`."""
DIAL = 0.45
"""Radius of the bent arrows of `three_turns_by_hand`."""
# A shorter bent arrow has no room for its head, and a shorter direction has no length of 1.
SMALLEST_ARC = 12.0
SHORT = 0.05
ORDERS = ["U V W", "U W V", "V U W", "V W U", "W U V", "W V U"]
FIXED, CARRIED = AXES = ["fixed", "carried along"]


@explorable(
    model="threeTurns",
    constants={"factors": {"U": "M(u)", "V": "M(v)", "W": "M(w)"}, "carried": CARRIED},
    tries={
        "W V U, axes carried along": {"axes": CARRIED},
        "turns of 10°": {"u": 10, "v": 10, "w": 10},
        "half turns": {"u": 180, "v": 180, "w": 180},
    },
    u=Slider(-180, 180, "u, about U, °", step=1, row=False),
    v=Slider(-180, 180, "v, about V, °", step=1, row=False),
    w=Slider(-180, 180, "w, about W, °", step=1, row=False),
    order=Choice("order of the lower row", ORDERS),
    axes=Choice("its axes", AXES),
)
def three_turns_by_hand(
    u: float = 90, v: float = 90, w: float = 90, order: str = "W V U", axes: str = FIXED
) -> pyvista.Plotter:
    """Draw the three principal rotations twice: U, V, W as in (4-1), and in any order.

    Parameters
    ----------
    u, v, w : float
        Angles about U, V and W in degrees.
    order : str
        The order of the lower row.
    axes : str
        Whether the lower row turns about fixed axes or about axes that the spoon carries along.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    angles = dict(zip("UVW", np.radians([u, v, w]), strict=True))
    right = np.cross((0, 0, 1), BACK)
    right /= np.linalg.norm(right)
    up = np.cross(BACK, right)
    target = -0.05 * right + 0.08 * up
    plotter = new_scene(eye=28.6 * BACK + target, target=target, view_angle=11.2)
    limit_turning(plotter, 20)
    ends, products = [], []
    for row, height, letters, carried in (
        ("upper", 1.3, "UVW", False),
        ("lower", -1.4, order.replace(" ", ""), axes == CARRIED),
    ):
        places = np.outer([-3.4, -1.35, 0.7, 2.6], right) + height * up
        so_far = np.eye(3)
        add_moved(plotter, f"{row} 0", teaspoon(41, 16), so_far, places[0], VECTOR)
        for k, (letter, place) in enumerate(zip(letters, places[1:], strict=True), 1):
            own = np.eye(3)["UVW".index(letter)]
            n = so_far @ own if carried else own
            so_far = rotation_matrix(n, angles[letter]) @ so_far
            add_moved(plotter, f"{row} {k}", teaspoon(41, 16), so_far, place, shade(k / 3))
            ends_of_axis = place - 1.05 * n, place + 1.15 * n
            add_arrow(plotter, *ends_of_axis, AXIS, radius=0.022, name=f"{row} axis {k}")
            dial = add_dial(plotter, place - 0.7 * n, n, angles[letter], f"{row} turn {k}")
            if row == "upper":
                add_label(plotter, place + 1.4 * n, f"${letter}$", AXIS, name=letter)
                # The dial or the spoon, from end to end.
                body = np.vstack([dial, place + np.outer([-1, 1], so_far[:, 0])])
                place_grip(plotter, letter.lower(), path=dial, body=body)
            # Of the names of an axis, one for each number of turns that have carried it, one shows.
            for primes in range(3 if row == "lower" else 0):
                shown = place + 1.4 * n if primes == carried * (k - 1) else None
                name = f"{letter} {primes}"
                add_label(plotter, shown, prime(letter, primes), AXIS, name=name)
        ends.append(so_far)
        products.append(letters if carried else letters[::-1])

    apart = degrees_between(ends[0], ends[1])
    read_out(plotter, "apart", apart, "last spoons apart by", 0, "°", where="picture")
    for row, letters in zip(("upper", "lower"), products, strict=True):
        factors = " ".join(f"M({letter.lower()})" for letter in letters)
        read_out(plotter, row, factors, f"{row} row", where="picture")
    describe(
        plotter,
        "Two rows of four teaspoons, each turned once more than the one to its left, about an axis"
        f" with a bent arrow. In the upper row the axes are U, then V, then W; in the lower row"
        f" {order.replace(' ', ', then ')}, {axes}. The last spoons of the rows are"
        f" {apart:.0f} degrees apart.",
    )
    return plotter


def prime(letter: str, primes: int) -> str:
    """Write the name of an axis that some turns have carried along."""
    marks = primes * r"\prime"
    return rf"${letter}^{{\,{marks}}}$" if marks else f"${letter}$"


def add_dial(
    plotter: pyvista.Plotter,
    center: NDArray[np.float64],
    n: NDArray[np.float64],
    angle: float,
    name: str,
) -> NDArray[np.float64]:
    """Add a bent arrow on the side of the eye that shows an angle about an axis.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The scene.
    center : ndarray, shape (3,)
        The middle of the dial, on the axis.
    n : ndarray, shape (3,)
        The axis, a unit vector.
    angle : float
        The angle in radians.
    name : str
        Name of the arrow.

    Returns
    -------
    ndarray, shape (73, 3)
        The whole dial, from -180 to 180 degrees.
    """
    view = BACK - (BACK @ n) * n
    # A quarter turn lies in the middle of what the eye sees.
    zero = rotate(DIAL * view / max(float(np.linalg.norm(view)), SHORT), n, -np.pi / 4)
    drawn = bool(abs(np.rad2deg(angle)) >= SMALLEST_ARC)
    arc = center + turning(zero, n, angle if drawn else 1.0, steps=24)
    line = add_line(plotter, arc, NEUTRAL, radius=0.018, name=name)
    ahead = np.sign(angle or 1) * np.cross(n, arc[-1] - center) / DIAL
    head = add_arrow(plotter, arc[-1] - 0.15 * ahead, arc[-1], NEUTRAL, 0.02, f"{name}, head")
    line.visibility = head.visibility = drawn
    return center + turning(rotate(zero, n, -np.pi), n, 2 * np.pi, steps=72)


def one_for_three(
    angles: ArrayLike = (5 * np.pi / 12, np.pi / 3, 11 * np.pi / 18),
    vector: ArrayLike = (0.77, 0.26, 0.59),
) -> pyvista.Plotter:
    """Draw the path of a point under three principal rotations and under the one rotation (4-7).

    Parameters
    ----------
    angles : array_like, shape (3,)
        The angles about U, V and W in radians.
    vector : array_like, shape (3,)
        The vector r; it is normalised.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    theta = np.asarray(angles, float)
    start = here = np.asarray(vector, float) / np.linalg.norm(vector)
    a, angle = axis_angle_from_euler_angles(*theta)

    plotter = sphere_scene(eye=(5.5, 2.3, 1.7), target=(0.0, 0.0, 0.12))
    add_coordinate_axes(plotter, 1.12)
    for name, axis, part in zip("uvw", np.eye(3), theta, strict=True):
        path = turning(here, axis, part)
        add_line(plotter, path, CROSS, radius=0.012)
        add_label(plotter, 1.13 * path[len(path) // 2], rf"$\theta_{name}$", CROSS)
        here = path[-1]
        add_point(plotter, here, CROSS, radius=0.025)
    add_line(plotter, turning(start, a, float(angle)), RESULT, radius=0.018)
    add_arrow(plotter, ORIGIN, 1.2 * a, AXIS)
    add_label(plotter, 1.3 * a, r"$\hat a$", AXIS)
    for point, name, color in (
        (start, r"$\vec r$", VECTOR),
        (here, r"$\vec r^{\,\prime}$", RESULT),
    ):
        add_arrow(plotter, ORIGIN, point, color)
        add_label(plotter, 1.16 * point, name, color)
    describe(
        plotter,
        "A see-through sphere. Three purple arcs, around the U, the V and the W axis, lead from the"
        " tip of r to the tip of r'. One green arc, part of a circle around the axis a, leads there"
        " directly.",
    )
    return plotter


RINGS = {"u": 0.67, "v": 0.885, "w": 1.1}
"""Radii of the rings of `euler_angles_by_hand`; each turns with its angle within the next."""
SPOON = 0.58
"""Half the length of the spoon within the rings."""
# Spoons of two sizes: where they lie alike, one is seen.
SIZES = (0.9, 0.97)
STEP = 1e-4
NO_WAY = "no unique path: start and end are half a turn apart"
DOWNWARDS = (np.sqrt(1 / 2), 0, np.sqrt(1 / 2), 0)


@explorable(
    model="eulerAngles",
    constants={"noWay": NO_WAY},
    tries={
        "the spoon 1° aside": {"u": 0, "v": 89, "w": 0},
        "v = 30°": {"v": 30},
        "the longest way": {"u": 173, "v": -61, "w": 175},
    },
    u=Slider(-180, 180, "u, about U″, °", step=1, row=False),
    v=Slider(-180, 180, "v, about V′, °", step=1, row=False),
    w=Slider(-180, 180, "w, about W, °", step=1, row=False),
    spoon=Poses("the spoon"),
    t=Slider(0, 1, "part of the way, t", plays=6),
)
def euler_angles_by_hand(
    u: float = 90, v: float = 90, w: float = 90, spoon: ArrayLike = DOWNWARDS, t: float = 0.5
) -> pyvista.Plotter:
    """Draw a spoon in the rings of its Euler angles, and two ways to turn to its pose.

    Parameters
    ----------
    u, v, w : float
        Angles of the pose about U, V and W in degrees. Where `v` is 90 or -90, the rings lock.
    spoon : array_like, shape (4,)
        A quaternion of the pose, as the hand has turned the spoon. Only its sign counts here,
        because the angles say the rest.
    t : float
        Part of the way from the start to the pose, from 0 to 1.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    angles = np.array([u, v, w], float)
    end = pose(angles)
    back = np.array([0.48, -0.74, 0.47])
    right = np.cross((0, 0, 1), back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    plotter = new_scene(eye=24 * back + 1.37 * right, target=1.37 * right, view_angle=8.05)
    limit_turning(plotter, 20)
    stack_on_phone(plotter, (-18, 92, 366, 322, 1), (335, 44, 406, 412, 0.65))

    place = 2.6 * right
    add_gimbals(plotter, angles, place, right, back)
    place_grip(plotter, "spoon", at=place, size=SPOON)
    names, colors, texts = ("angles", "slerp"), (CROSS, RESULT), ("three angles", "one turn")
    steps = np.linspace(0, 1, 33)
    # For each way the pose at t, the path, and what comes just before and after its places.
    times = np.concatenate([[t], steps, steps - STEP, steps + STEP])
    here, ways, before, after = np.split(two_ways(angles, times), (1, 34, 67), axis=1)
    unique = len(ways) == len(names)
    for name, turn, color, size in zip(names, here[[0, -1], 0], colors, SIZES, strict=True):
        body = add_moved(plotter, f"{name} spoon", teaspoon(41, 16), size * turn, ORIGIN, color)
        body.visibility = unique or name == "angles"
    # What turns as a whole has come before the ball, behind which only lines are pale.
    add_sphere(plotter)
    add_point(plotter, pose(np.zeros(3))[:, 0], VECTOR, 0.05)
    for k, (name, color, text, side) in enumerate(
        zip(names, colors, texts, (-0.5, 0.6), strict=True)
    ):
        exists = unique or k == 0
        path, turn = (ways[k], here[k, 0]) if exists else (ways[0], here[0, 0])
        for part in (
            add_line(plotter, path[:, :, 0], color, 0.017, name=f"{name} path"),
            add_point(plotter, turn[:, 0], color, 0.055, name=f"{name} tip"),
        ):
            part.visibility = exists
        add_label(plotter, side * right - 1.14 * up, text, color)

    read_out(plotter, "rings", angles, "u, v, w", 0, "°", where="picture")
    turned = degrees_between(ways[0, :-1], ways[0, 1:]).sum()
    read_out(plotter, "by_angles", turned, "three angles turn by", 0, "°", where="picture")
    by_slerp = degrees_between(np.eye(3), end) if unique else NO_WAY
    read_out(plotter, "by_slerp", by_slerp, "one turn by", 0, "°", where="picture")
    nearby = pose(angles + np.array([(1, 0, 0), (-1, 0, 0), (0, 0, 1)]))
    apart = degrees_between(nearby[:2], nearby[2]).min()
    read_out(plotter, "apart", apart, "1° of w does what 1° of u does, to within", 2, "°")
    read_out(plotter, "matrix", end, "matrix of the three angles", where="folded")
    q = Quaternion.from_matrix(end).components
    q = q if q @ np.asarray(spoon, float) >= 0 else -q
    read_out(plotter, "q", q, "quaternion (w x y z)", where="folded")
    draw_chart(
        plotter,
        "speeds",
        dict(zip_longest(texts, degrees_between(before, after) / (2 * STEP))),
        over="t",
        x=(0, 1),
        y=(0, 200),
        label="speed, degrees for a step of 1 in t",
        colors=dict(zip(texts, colors, strict=True)),
    )
    describe(
        plotter,
        "A teaspoon is held by three rings, one in the other, which turn about axes"
        " W, V' and U''. Beside it, inside a glass ball, two spoons are on their way from a level"
        " start to the same pose, one by its three angles and one by a single turn. Lines on the"
        " ball show the paths of their tips, which part and meet again.",
    )
    return plotter


def pose(angles: ArrayLike) -> NDArray[np.float64]:
    """Return 3x3 matrices from angles about U, V and W in degrees, shape (..., 3)."""
    u, v, w = np.moveaxis(np.deg2rad(angles), -1, 0)
    return np.asarray(matrix_from_euler_angles(u, v, w)[..., :3, :3])


def two_ways(angles: NDArray[np.float64], t: ArrayLike) -> NDArray[np.float64]:
    """Turn from the start to a pose by its three angles and by slerp.

    Parameters
    ----------
    angles : ndarray, shape (3,)
        Angles of the pose about U, V and W in degrees.
    t : array_like, shape (n,)
        Parts of the way.

    Returns
    -------
    ndarray, shape (2, n, 3, 3)
        The orientations on each of the ways; only the first, shape (1, n, 3, 3), if the pose is
        half a turn away, where slerp has two shortest ways.
    """
    end = pose(angles)
    by_angles = pose(np.multiply.outer(t, angles))
    try:
        by_slerp = slerp_rotations(np.eye(3), end, t)
    except DegenerateError:
        return by_angles[np.newaxis]
    return np.stack([by_angles, by_slerp])


def degrees_between(before: NDArray[np.float64], after: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the angles by which some orientations are turned to others."""
    return np.asarray(np.degrees(axis_angle(before.swapaxes(-1, -2) @ after)[1]))


def add_moved(
    plotter: pyvista.Plotter,
    name: str,
    mesh: pyvista.PolyData,
    turn: NDArray[np.float64],
    place: NDArray[np.float64],
    color: str | NDArray[np.float64],
) -> pyvista.Actor:
    """Add a mesh, turned or scaled by a 3x3 matrix and put at a place."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn, place
    name = place_part(plotter, name, matrix=matrix.T.ravel())
    actor = add_thin(plotter, mesh, color, name)
    actor.user_matrix = matrix
    return actor


def add_gimbals(
    plotter: pyvista.Plotter,
    angles: NDArray[np.float64],
    place: NDArray[np.float64],
    right: NDArray[np.float64],
    back: NDArray[np.float64],
) -> None:
    """Add a spoon in three rings, each turning within the next, for Euler angles in degrees.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The scene.
    angles : ndarray, shape (3,)
        Angles about U, V and W in degrees.
    place : ndarray, shape (3,)
        The centre.
    right : ndarray, shape (3,)
        The direction to the right in the picture, which keeps the names of U'' and W apart.
    back : ndarray, shape (3,)
        The direction out of the picture. The name of U'' lies within it, outside the rings.
    """
    _, v, w = angles
    add_moved(plotter, "held", teaspoon(41, 16), SPOON * pose(angles), place, CROSS)
    # The pose of each ring, and the axis beside its own about which it does not turn.
    poses = {"u": pose(angles), "v": pose([0, v, w]), "w": pose([0, 0, w])}
    round_about = np.linspace(0, 2 * np.pi, 49)
    cos, sin, none = np.cos(round_about), np.sin(round_about), np.zeros(49)
    flat = {"u": (cos, sin, none), "v": (cos, sin, none), "w": (none, cos, sin)}
    # Far from each other in most poses.
    grabbed = {"u": (1, 1, 0), "v": (-1, 1, 0), "w": (0, -1, -1)}
    whole = np.linspace(-180, 180, 73)
    for k, (name, radius) in enumerate(RINGS.items()):
        ring = radius * np.stack(flat[name], axis=-1)
        body = place + transform(poses[name], ring)
        add_line(plotter, body, NEUTRAL, 0.034, name=f"ring {name}")
        others = np.where(np.arange(3) > k, angles, 0)
        corner = radius * np.array(grabbed[name]) / np.sqrt(2)
        path = place + pose(others + np.outer(whole, np.eye(3)[k])) @ corner
        place_grip(plotter, name, path=path, body=body)
    axes = {"W": np.array([0, 0, 1]), "V": poses["w"][:, 1], "U": poses["v"][:, 0]}
    for (name, axis), first, last in zip(
        axes.items(),
        (RINGS["w"], RINGS["v"], RINGS["u"]),
        (1.3, RINGS["w"] + 0.15, RINGS["v"]),
        strict=True,
    ):
        ends = [place + sign * np.outer((first, last), axis) for sign in (1, -1)]
        add_lines(plotter, ends, AXIS, radius=0.026, name=f"axis {name}")
    seen = axes["U"] - (axes["U"] @ back) * back
    beside = seen / max(float(np.linalg.norm(seen)), SHORT)
    for name, direction, aside, text in (
        ("W", axes["W"], 0.1, "$W$"),
        ("V", axes["V"], 0, r"$V^{\,\prime}$"),
        ("U", beside, -0.2, r"$U^{\,\prime\prime}$"),
    ):
        add_label(plotter, place + 1.42 * direction + aside * right, text, AXIS, name=name)


def stages(steps: Sequence[ArrayLike] | None = None) -> pyvista.Plotter:
    """Draw a teaspoon going through five transforms, and its perspective picture.

    Parameters
    ----------
    steps : sequence of array_like, shape (4, 4), optional
        Scaling, shear, rotation, translation and perspective, in the order of their
        application.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    if steps is None:
        steps = [
            scaling((0.8, 1.5, 1.5)),
            shearing(uv=0.8),
            rotation_v(np.deg2rad(-50)),
            translation((0, 0, -1)),
            perspective(2.6),
        ]
    eye = np.array([0, 0, -1 / np.asarray(steps[-1], float)[3, 2]])
    back = np.array([0.42, -0.8, 0.43])
    right = np.cross((0, 0, 1), back) / np.linalg.norm(back[:2])
    up = np.cross(back, right)
    plotter = new_scene(eye=26 * back, target=ORIGIN, view_angle=13.6)
    spots = [x * right + y * up for y in (1.75, -1.15) for x in (-3.35, -1.0)]
    spots += [2.6 * right - 0.3 * up] * 2

    spoon = teaspoon(stations=41, around=16)
    box = np.array(spoon.bounds).reshape(3, 2)
    corners = np.stack(np.meshgrid(*box, indexing="ij"), axis=-1).reshape(-1, 3)
    names = ("start", "scale", "shear", "rotate", "translate", "perspective")
    done = np.eye(4)
    for k, (name, step, spot) in enumerate(zip(names, [np.eye(4), *steps], spots, strict=True)):
        done = np.asarray(step) @ done
        flat = (1, 1, name != "perspective")
        moved = spoon.copy()
        moved.points = transform(done, spoon.points) * flat + spot
        plotter.add_mesh(moved, color=shade(k / len(steps)), smooth_shading=True)
        edges = transform(done, corners) * flat + spot
        for i in range(8):
            for j in (i ^ 1, i ^ 2, i ^ 4):
                if i < j:
                    add_line(plotter, edges[[i, j]], NEUTRAL, radius=0.008)
        if name == "translate":
            for corner in edges:
                add_line(plotter, [corner, eye + spot], NEUTRAL, radius=0.004)
        if name == "perspective":
            below = 1.15 * right + 0.62 * up
        else:
            below = (((edges - spot) @ up).min() - 0.3) * up
        add_label(plotter, spot + below, name)
    plane = pyvista.Plane(center=spots[-1], i_size=2.6, j_size=2.6, i_resolution=1, j_resolution=1)
    plotter.add_mesh(plane, color=NEUTRAL, opacity=0.25, lighting=False, pickable=False)
    add_point(plotter, eye + spots[-1], AXIS, radius=0.06)
    add_label(plotter, eye + spots[-1] + 0.3 * right, "eye", AXIS)
    describe(
        plotter,
        "A teaspoon in its box at six stages. The first four: at the start, scaled, sheared and"
        " rotated. Then it lies below a see-through plane, with lines of sight from an eye above"
        " the plane to the corners of the box. Last comes a flat green picture, where these lines"
        " pass through the plane.",
    )
    return plotter
