"""Scenes of Chapter 4: three rotations, the one that replaces them, and transforms."""

from collections.abc import Sequence
from itertools import zip_longest

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import nlerp
from rotedu.colors import AXIS, CROSS, NEUTRAL, RESULT, VECTOR
from rotedu.errors import DegenerateError
from rotedu.figures import Slider, describe, draw_chart, explorable, limit_turning, read_out
from rotedu.figures.frames import place_part
from rotedu.general_rotation import (
    axis_angle_from_euler_angles,
    euler_angles,
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
    add_thin,
    new_scene,
    shade,
    sphere_scene,
    teaspoon,
    turning,
)


def two_rows() -> tuple[pyvista.Plotter, NDArray[np.float64]]:
    """Open a scene for two rows of four teaspoons; return it and their places, (2, 4, 3)."""
    back = np.array([0.49, -0.77, 0.42])
    right = np.cross((0, 0, 1), back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    across = np.array([-3.35, -1.2, 0.95, 2.9])
    down = np.array([1.35, -1.4])
    target = 0.03 * right + 0.2 * up
    plotter = new_scene(eye=28.6 * back + target, target=target, view_angle=11.7)
    return plotter, down[:, np.newaxis, np.newaxis] * up + across[:, np.newaxis] * right


def add_turned_spoon(
    plotter: pyvista.Plotter, matrix: ArrayLike, place: ArrayLike, color: object
) -> None:
    """Add a small teaspoon, turned by a matrix and put at a place."""
    spoon = teaspoon(stations=41, around=16)
    spoon.points = transform(matrix, spoon.points) + np.asarray(place)
    plotter.add_mesh(spoon, color=color, smooth_shading=True)


def add_turn(
    plotter: pyvista.Plotter, center: ArrayLike, axis: ArrayLike, angle: float, radius: float = 0.36
) -> None:
    """Add a bent arrow on the side of the eye that shows an angle about an axis."""
    n = np.asarray(axis, float)
    view = np.subtract(plotter.camera.position, center)
    spoke = view - (view @ n) * n
    spoke *= radius / np.linalg.norm(spoke)
    path = np.asarray(center) + rotate(spoke, n, np.linspace(-angle / 2, angle / 2, 25))
    neck = -max(2, round(24 * 0.16 / (radius * abs(angle)))) - 1
    add_line(plotter, path[: neck + 1], NEUTRAL, radius=0.018)
    head = pyvista.Cone(
        center=(path[neck] + path[-1]) / 2,
        direction=path[-1] - path[neck],
        height=float(np.linalg.norm(path[-1] - path[neck])),
        radius=0.065,
        resolution=24,
    )
    add_thin(plotter, head, NEUTRAL)


def add_steps(
    plotter: pyvista.Plotter,
    row: ArrayLike,
    turns: Sequence[tuple[str, ArrayLike, float]],
) -> None:
    """Show a teaspoon being turned step by step, along a row of places.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The scene.
    row : array_like, shape (n + 1, 3)
        Where to show the spoon: before the first turn, and after each turn.
    turns : sequence of (str, array_like, float)
        Name, axis and angle in radians of each turn. The axes are fixed in space.
    """
    start, *after = np.asarray(row, float)
    so_far = np.eye(3)
    add_turned_spoon(plotter, so_far, start, VECTOR)
    for k, (place, (name, direction, angle)) in enumerate(zip(after, turns, strict=True), 1):
        n = np.asarray(direction, float)
        so_far = rotation_matrix(n, angle) @ so_far
        add_turned_spoon(plotter, so_far, place, shade(k / len(turns)))
        add_arrow(plotter, place - 1.05 * n, place + 1.15 * n, AXIS, radius=0.022)
        add_label(plotter, place + 1.4 * n, f"${name}$", AXIS)
        add_turn(plotter, place - 0.7 * n, n, angle)


def principal_orders(
    angles: ArrayLike = (np.pi / 2, np.pi / 2, np.pi / 2),
) -> pyvista.Plotter:
    """Draw the three principal rotations in two orders: U, V, W as in (4-1), and W, V, U.

    Parameters
    ----------
    angles : array_like, shape (3,)
        The angles about U, V and W in radians.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    turns = list(zip("UVW", np.eye(3), np.asarray(angles, float), strict=True))
    plotter, rows = two_rows()
    for row, order in zip(rows, (turns, turns[::-1]), strict=True):
        add_steps(plotter, row, order)
    degrees = np.rad2deg([angle for _, _, angle in turns]).round().astype(int)
    describe(
        plotter,
        f"Two rows of four teaspoons. In the upper row the spoon is turned about U by {degrees[0]}"
        f" degrees, then about V by {degrees[1]}, then about W by {degrees[2]}. In the lower row"
        " the same turns are made in the opposite order. The last spoons of the rows point in"
        " different directions.",
    )
    return plotter


def fixed_and_carried(
    angles: ArrayLike = (5 * np.pi / 12, -np.pi / 4, np.pi / 3),
) -> pyvista.Plotter:
    """Draw two readings of (4-1): about fixed axes, and about axes that the spoon carries along.

    Parameters
    ----------
    angles : array_like, shape (3,)
        The angles about U, V and W in radians.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    turns = list(zip("UVW", np.eye(3), np.asarray(angles, float), strict=True))
    names = ("W", r"V^{\,\prime}", r"U^{\,\prime\prime}")
    carried, so_far = [], np.eye(3)
    for name, (_, axis, angle) in zip(names, turns[::-1], strict=True):
        carried.append((name, so_far @ axis, angle))
        so_far = so_far @ rotation_matrix(axis, angle)
    plotter, rows = two_rows()
    for row, order in zip(rows, (turns, carried), strict=True):
        add_steps(plotter, row, order)
    describe(
        plotter,
        "Two rows of four teaspoons. In the upper row the spoon is turned about the fixed axes U,"
        " V and W. In the lower row it is turned about W, then about its own axis V', which has"
        " moved along, then about its own axis U''. The last spoons of both rows have the same"
        " orientation.",
    )
    return plotter


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


SPOON = 0.8
"""Half the length of the spoons of `euler_angles_by_hand`."""
STEP = 1e-4
# A shorter direction has no length of 1 in the picture.
SHORT = 0.05
NO_WAY = "no unique path: start and end are half a turn apart"


@explorable(
    model="eulerAngles",
    constants={"noWay": NO_WAY},
    u=Slider(-180, 180, "final u, about U″", step=1),
    v=Slider(-180, 180, "final v, about V′", step=1),
    w=Slider(-180, 180, "final w, about W", step=1),
    tilt=Slider(-10, 10, "then tilt it sideways by", step=1),
    t=Slider(0, 1, "part of the way, t", plays=6),
)
def euler_angles_by_hand(
    u: float = 90, v: float = 90, w: float = 90, tilt: float = 0, t: float = 1
) -> pyvista.Plotter:
    """Draw three ways to turn to a pose, and the gimbals of its Euler angles.

    Parameters
    ----------
    u, v, w : float
        Angles of the pose about U, V and W in degrees. Where `v` is 90 or -90, the gimbals lock.
    tilt : float
        Degrees by which the pose is then tilted about the axis that is perpendicular to W and V'.
    t : float
        Part of the way from the start to the pose, from 0 to 1.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    set_by_hand = np.array([u, v, w], float)
    level = pose(set_by_hand)
    sideways = pose([0, 0, w])[:, 0]
    tilted = rotation_matrix(sideways, np.deg2rad(tilt)) @ level
    # What was not tilted keeps its angles, even where others lead to the same pose.
    angles = nearest_angles(tilted, set_by_hand) if tilt else set_by_hand
    now = t * angles
    back = np.array([0.48, -0.74, 0.47])
    right = np.cross((0, 0, 1), back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    plotter = new_scene(eye=23.1 * back, target=ORIGIN, view_angle=10)
    limit_turning(plotter, 35)
    places = (1.3 * right - 0.05 * up, 1.13 * up - 1.75 * right, -0.87 * up - 1.75 * right)
    names, colors = ("angles", "slerp", "nlerp"), (CROSS, RESULT, NEUTRAL)

    steps = np.linspace(0, 1, 33)
    # For each way the pose at t, the path, and what comes just before and after its places.
    times = np.concatenate([[t], steps, steps - STEP, steps + STEP])
    here, ways, before, after = np.split(three_ways(angles, times), (1, 34, 67), axis=1)
    unique = len(ways) == len(names)
    for k, (name, color, place) in enumerate(zip(names, colors, places, strict=True)):
        exists = unique or k == 0
        path, turn = (ways[k], here[k, 0]) if exists else (ways[0], here[0, 0])
        if name != "angles":
            ball = pyvista.Sphere(
                radius=SPOON, center=tuple(place), theta_resolution=48, phi_resolution=32
            )
            plotter.add_mesh(ball, color=NEUTRAL, opacity=0.18, smooth_shading=True)
        add_point(plotter, place + SPOON * path[0, :, 0], VECTOR, 0.035, name=f"{name} start")
        for part in (
            add_moved(plotter, f"{name} spoon", teaspoon(41, 16), SPOON * turn, place, color),
            add_line(plotter, place + SPOON * path[:, :, 0], color, 0.014, name=f"{name} path"),
            add_point(plotter, place + SPOON * turn[:, 0], color, 0.045, name=f"{name} tip"),
        ):
            part.visibility = exists
    texts = ("three angles", "one turn", "one turn, uneven")
    below = (1.75, 0.95, 0.95)
    for text, color, place, far in zip(texts, (CROSS, RESULT, "black"), places, below, strict=True):
        add_label(plotter, place - far * up, text, color)
    add_gimbals(plotter, now, places[0], right, back)

    farthest = abs(angles - set_by_hand).max()
    read_out(plotter, "ring_change", farthest, "the tilt turns a ring by up to", 1, "°")
    change = abs(tilted - level).max()
    read_out(plotter, "entry_change", change, "it changes a matrix entry by up to", 3)
    read_out(plotter, "rings", angles, "the rings end at u, v, w", 1, "°")
    read_out(plotter, "matrix", here[0, 0], "matrix of the three angles")
    path = pose(np.multiply.outer(t * steps, angles))
    turned = degrees_between(path[:-1], path[1:]).sum()
    read_out(plotter, "by_angles", turned, "three angles turn the spoon through", 0, "°")
    by_slerp = degrees_between(np.eye(3), here[1, 0]) if unique else NO_WAY
    read_out(plotter, "by_slerp", by_slerp, "one turn takes it through", 0, "°")
    nearby = pose(now + np.array([(1, 0, 0), (-1, 0, 0), (0, 0, 1)]))
    apart = degrees_between(nearby[:2], nearby[2]).min()
    read_out(plotter, "apart", apart, "1° of w does what 1° of u does, to within", 2, "°")
    draw_chart(
        plotter,
        "speeds",
        dict(zip_longest(texts, degrees_between(before, after) / (2 * STEP))),
        over="t",
        x=(0, 1),
        y=(0, 200),
        label="speed, degrees for a step of 1 in t",
        colors=dict(zip(texts, colors, strict=True)),
        dashed=texts[2:],
    )
    describe(
        plotter,
        "Three teaspoons on their way from a level start to the same pose. The one on the right is"
        " held by two rings, which turn about axes W, V' and U''. The two on the left turn freely"
        " inside see-through spheres. Lines show the paths of their tips: the same arc in both"
        " spheres, and another line in the rings.",
    )
    return plotter


def pose(angles: ArrayLike) -> NDArray[np.float64]:
    """Return 3x3 matrices from angles about U, V and W in degrees, shape (..., 3)."""
    u, v, w = np.moveaxis(np.deg2rad(angles), -1, 0)
    return np.asarray(matrix_from_euler_angles(u, v, w)[..., :3, :3])


def three_ways(angles: NDArray[np.float64], t: ArrayLike) -> NDArray[np.float64]:
    """Turn from the start to a pose by its three angles, by slerp and by nlerp.

    Parameters
    ----------
    angles : ndarray, shape (3,)
        Angles of the pose about U, V and W in degrees.
    t : array_like, shape (n,)
        Parts of the way.

    Returns
    -------
    ndarray, shape (3, n, 3, 3)
        The orientations on each of the ways; only the first, shape (1, n, 3, 3), if the pose is
        half a turn away, where slerp and nlerp have two shortest ways.
    """
    end = pose(angles)
    by_angles = pose(np.multiply.outer(t, angles))
    try:
        by_slerp = slerp_rotations(np.eye(3), end, t)
    except DegenerateError:
        return by_angles[np.newaxis]
    q = nlerp([1, 0, 0, 0], Quaternion.from_matrix(end).components, t)
    return np.stack([by_angles, by_slerp, Quaternion(q[:, 0], q[:, 1:]).matrix()])


def degrees_between(before: NDArray[np.float64], after: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the angles by which some orientations are turned to others."""
    return np.asarray(np.degrees(axis_angle(before.swapaxes(-1, -2) @ after)[1]))


def nearest_angles(matrix: NDArray[np.float64], angles: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the Euler angles of a matrix that are nearest to given ones, in degrees."""
    u, v, w = np.degrees(euler_angles(matrix))
    triples = np.array([(u, v, w), (u + 180, 180 - v, w + 180)])
    changes = (triples - angles + 180) % 360 - 180
    return np.asarray(angles + changes[abs(changes).max(axis=1).argmin()])


def add_moved(
    plotter: pyvista.Plotter,
    name: str,
    mesh: pyvista.PolyData,
    turn: NDArray[np.float64],
    place: NDArray[np.float64],
    color: str,
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
    """Add two rings, each turning within the next, for Euler angles in degrees.

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
    u = pose(angles)[:, 0]
    v = pose(angles * (0, 0, 1))[:, 1]
    w = np.array([0, 0, 1])
    for name, radius, side in (("outer ring", 1.1, w), ("inner ring", 0.92, u)):
        hoop = pyvista.ParametricTorus(radius, 0.038, u_res=97, v_res=13)
        turn = np.column_stack([v, side, np.cross(v, side)])
        add_moved(plotter, name, hoop, turn, place, NEUTRAL)
    for name, axis, first, last in (("W", w, 1.1, 1.36), ("V", v, 0.92, 1.31), ("U", u, 0.8, 0.92)):
        ends = [place + sign * np.outer((first, last), axis) for sign in (1, -1)]
        add_lines(plotter, ends, AXIS, radius=0.026, name=f"axis {name}")
    seen = u - (u @ back) * back
    beside = seen / max(float(np.linalg.norm(seen)), SHORT)
    for name, direction, aside, text in (
        ("W", w, 0.1, "$W$"),
        ("V", v, 0, r"$V^{\,\prime}$"),
        ("U", beside, -0.2, r"$U^{\,\prime\prime}$"),
    ):
        add_label(plotter, place + 1.48 * direction + aside * right, text, AXIS, name=name)


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
