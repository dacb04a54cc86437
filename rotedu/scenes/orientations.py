"""Scenes of page 5 IV: an arrow and a teaspoon carried along a curve."""

from itertools import pairwise

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import angle_between, arc_axis, nlerp, slerp
from rotedu.colors import AXIS, CROSS, MATRIX, NEUTRAL, QUATERNION, RESULT, VECTOR
from rotedu.control_points import double
from rotedu.figures import (
    Handles,
    Poses,
    Slider,
    describe,
    draw_chart,
    explorable,
    limit_turning,
    place_grip,
    place_part,
    read_out,
)
from rotedu.general_rotation import (
    homogeneous,
    matrix_from_euler_angles,
    scaling,
    translation,
)
from rotedu.ordinary_rotation import axis_angle, rotation_matrix, transform
from rotedu.orientations import (
    closed_rotation_curve,
    nearest_rotation,
    periodic_spline,
    slerp_rotations,
    squad,
)
from rotedu.quaternions import Quaternion
from rotedu.scenes.parts import (
    JUST_INSIDE,
    add_arrow,
    add_label,
    add_line,
    add_lines,
    add_point,
    add_sphere,
    add_thin,
    fan,
    new_scene,
    normalised,
    sphere_scene,
    teaspoon,
    triangle_mesh,
    turning,
)

TWO_ORIENTATIONS = ((0, 0, 0), (150, -60, 150))
"""Angles about U, V and W, in degrees, of the orientations of `four_ways_between`."""


U, V, W = np.eye(3)
STATIONS = 9
"""Number of arrows that `carried_around_by_hand` leaves on the way."""
SIZE = 0.33
STEPS = 60
"""Number of steps in which it draws what the arrow has swept."""
LEAST = 0.001
# Out and back, almost; a face of a tetrahedron, a quarter of the sphere, or so little less that no
# rounding makes -180 degrees of 180; a larger triangle; one whose corners run clockwise.
NARROW = ((1, 0, 0.3), (0, 1, 0.3), (1, 1, 0.45))
REVERSING = ((1, 1, -0.9999), (-0.9999, 1, 1), (1, -0.9999, 1))
LARGE = ((1, 1, -1.3), (-1.3, 1, 1), (1, -1.3, 1))
CLOCKWISE = ((1, 0, 0), (0, 0, 1), (0, 1, 0))


@explorable(
    model="carriedAround",
    tries={
        "there and back": {"corners": NARROW},
        "the arrow comes back reversed": {"corners": REVERSING},
        "an even larger triangle": {"corners": LARGE},
        "clockwise": {"corners": CLOCKWISE},
    },
    corners=Handles(["A", "B", "C"]),
    t=Slider(0, 1, "once round, t", plays=8),
)
def carried_around_by_hand(
    corners: ArrayLike = ((1, 0, 0), (0, 1, 0), (0, 0, 1)), t: float = 1
) -> pyvista.Plotter:
    """Draw an arrow carried around a triangle by the rotations of the arcs (5-3).

    Parameters
    ----------
    corners : array_like, shape (3, 3)
        The corners of the triangle; they are normalised.
    t : float
        How far the arrow has come, from 0 to 1. Each side takes a third.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    p = normalised(corners)
    after = np.roll(p, -1, axis=0)
    axes, angles = arc_axis(p, after), angle_between(p, after)
    start, ahead = p[0], np.cross(axes[0], p[0])

    def carried(t: float) -> NDArray[np.float64]:
        """Return where the arrow begins, and its direction, shape (2, 3)."""
        turns = rotation_matrix(axes, angles * np.clip(3 * t - np.arange(3), 0, 1))
        return transform(turns[2] @ turns[1] @ turns[0], [start, ahead])

    back = carried(1)[1]
    twist = np.arctan2(np.linalg.det([start, ahead, back]), ahead @ back)
    nearness = 1 + np.sum(p * after)
    area = 2 * np.arctan2(np.linalg.det(p), nearness)

    plotter = sphere_scene(eye=(2.93, 3.26, 3.82))
    inside = spherical_triangle(p)
    name = place_part(plotter, "inside", points=inside.points)
    plotter.add_mesh(inside, color=RESULT, opacity=0.3, lighting=False, pickable=False, name=name)
    s = np.linspace(0, 1, 25)
    sides = [slerp(here, there, s) for here, there in zip(p, after, strict=True)]
    add_lines(plotter, sides, NEUTRAL, radius=0.005, name="sides")
    round_once = np.linspace(0, 1, STEPS + 1)
    so_far = np.array([carried(x) for x in max(t, LEAST) * round_once])
    add_line(plotter, so_far[:, 0], RESULT, radius=0.012, name="way")
    swept = ribbon(so_far[:, 0], so_far[:, 0] + SIZE * so_far[:, 1])
    name = place_part(plotter, "swept", points=swept.points)
    plotter.add_mesh(swept, color=AXIS, opacity=0.3, lighting=False, pickable=False, name=name)
    # The arrow is grabbed by its tip, away from the rings of the corners.
    place_grip(plotter, "t", path=[at + SIZE * way for at, way in map(carried, round_once)])
    for k in range(STATIONS):
        at, way = carried(k / STATIONS)
        # The first is longer, so that the green arrow does not hide it.
        color, size = (NEUTRAL, SIZE) if k else (VECTOR, 1.4 * SIZE)
        arrow = add_arrow(plotter, at, at + size * way, color, radius=0.013, name=f"station {k}")
        arrow.visibility = k <= t * STATIONS
    at, way = carried(t)
    add_arrow(plotter, at, at + SIZE * way, RESULT, radius=0.015, name="arrow")

    rim = turning(0.7 * SIZE * ahead, start, twist)
    sector = fan(start, start + rim)
    name = place_part(plotter, "sector", points=sector.points)
    plotter.add_mesh(
        sector, color=AXIS, opacity=0.6, lighting=False, pickable=False, name=name
    ).visibility = t == 1
    # Beyond the tips of both arrows, and outside the sphere when they are seen edge on.
    place = 1.12 * start + 2.6 * rim[len(rim) // 2]
    add_label(plotter, place if t == 1 else None, "twist", AXIS)
    for letter, point, others in zip("ABC", p, p.sum(axis=0) - p, strict=True):
        outwards = 2 * point - others
        place = point + 0.18 * outwards / np.linalg.norm(outwards)
        add_point(plotter, point, NEUTRAL, radius=0.03, name=letter)
        add_label(plotter, place, f"${letter}$", name=letter)
    for output, angle, text, digits in (
        ("twist", twist, "twist, once round", 1),
        ("area", area, "area inside", 1),
        ("difference", area - twist, "area − twist", 0),
    ):
        read_out(plotter, output, np.degrees(angle), text, digits, "°", where="picture")
    describe(
        plotter,
        "A see-through sphere with a triangle ABC, whose corners can be dragged. A blue arrow"
        " at A points to B. A green arrow is carried along the three sides, always at the same"
        " angle to the side, and leaves grey arrows and an orange ribbon on its way. Back at A it"
        " is turned against the blue one; the sector between the two is filled in orange, and the"
        " triangle in green.",
    )
    return plotter


def ribbon(side: NDArray[np.float64], other: NDArray[np.float64]) -> pyvista.PolyData:
    """Fill what lies between two lines of as many points, shape (n, 3) each."""
    i = np.arange(len(side) - 1)
    j = i + len(side)
    triangles = np.concatenate([np.stack(c, axis=-1) for c in ((i, i + 1, j), (i + 1, j + 1, j))])
    return triangle_mesh(np.concatenate([side, other]), triangles)


def spherical_triangle(corners: NDArray[np.float64], steps: int = 12) -> pyvista.PolyData:
    """Fill a triangle along the unit sphere, by arcs from its first corner to the opposite side."""
    p, q, r = corners
    s = np.linspace(0, 1, steps + 1)
    points = JUST_INSIDE * slerp(p, slerp(q, r, s)[:, np.newaxis], s)
    i = np.arange(len(s) ** 2).reshape(len(s), -1)
    squares = np.stack([i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]], axis=-1).reshape(-1, 4)
    return triangle_mesh(
        points.reshape(-1, 3), np.concatenate([squares[:, [0, 1, 2]], squares[:, [0, 2, 3]]])
    )


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
SAMPLES = 20
PLACES = np.array([(-0.8, 0, 1.42), (0.8, 0, 1.42), (0.8, 0, -1.42), (-0.8, 0, -1.42)])
"""Where the given poses are turned, round the ball."""
MOUNTED = 0.28
SAME = 1e-6
SIGNS = ("cannot agree", "can agree")


@explorable(
    model="routes",
    constants={"signs": SIGNS},
    tries={
        "a swing to 90°": {"poses": about_v(0, 90, 10, -60), "u": 0.1625},
        "a swing to 100°": {"poses": about_v(0, 100, 10, -60), "u": 0.1625},
        "once right round": {"poses": about_v(0, 90, 180, 270), "u": 0.1625},
    },
    poses=Poses([f"spoon {k}" for k in range(4)]),
    u=Slider(0, 1, "once round, u", step=0.0125, plays=10),
)
def routes_by_hand(poses: ArrayLike = ROUTE, u: float = 0.3625) -> pyvista.Plotter:
    """Draw a closed curve of orientations along its route, and by shortest ways of matrices.

    Parameters
    ----------
    poses : array_like, shape (4, 4)
        Four poses as quaternions; they are normalised. The signs do not count.
    u : float
        Place on the whole curve, from 0 to 1.

    Returns
    -------
    pyvista.Plotter
        The scene.

    Raises
    ------
    rotedu.errors.DegenerateError
        If two turns are equally short.
    """
    q = normalised(poses)
    given = matrices(q)
    ways = {
        "route": closed_rotation_curve(given, SAMPLES),
        "shortest": shortest_way(given, np.arange(SAMPLES) / SAMPLES),
    }
    colors = {"route": RESULT, "shortest": CROSS}
    count = len(given) * SAMPLES
    here = round(count * u) % count
    _, apart = axis_angle(ways["route"].swapaxes(1, 2) @ ways["shortest"])

    plotter = new_scene(eye=0.06 * W - 16 * V, target=0.06 * W, view_angle=14.25, size=(400, 620))
    limit_turning(plotter, 25)
    add_sphere(plotter)
    # Where both are the same, the route is seen.
    for (name, way), radius in zip(ways.items(), (0.014, 0.01), strict=True):
        middles = [*way[:, :, 2], way[0, :, 2]]
        add_line(plotter, middles, colors[name], radius, name=name)
        if name == "route":
            place_grip(plotter, "u", path=middles)
        ghosts = {f"{name} {k}": (k, 0.5) for k in range(0, count, 5) if k % SAMPLES}
        for spoon, (k, size) in (ghosts | {f"{name} now": (here, 1.2)}).items():
            mounted = add_mounted(plotter, way[k], size * MOUNTED, colors[name], spoon)
            mounted.visibility = name == "route" or bool(apart[k] > SAME)
    for k, turn in enumerate(given):
        add_mounted(plotter, turn, MOUNTED, VECTOR, f"mounted {k}")
        add_spoon(plotter, turn, PLACES[k], 0.5, VECTOR, f"R_{k}")
        add_label(plotter, PLACES[k] * (1.46, 1, 0.7), f"$R_{k}$", VECTOR)
    place_grip(plotter, "poses", at=PLACES, size=0.5)

    turn = max(turns_from_double(q))
    agree = int(np.prod(np.sum(q * np.roll(q, -1, axis=0), axis=1)) > 0)
    for output, value, text in (
        ("turn", np.degrees(turn), "from Double by up to"),
        ("apart", np.degrees(apart.max()), "routes apart by up to"),
        ("signs", SIGNS[agree], "signs"),
    ):
        read_out(plotter, output, value, text, 1, "°", where="picture")
    from_start = {
        name: np.degrees(axis_angle(given[0].T @ way)[1]).reshape(-1, SAMPLES)
        for name, way in ways.items()
    }
    draw_chart(
        plotter,
        "angles",
        {
            name: np.column_stack([angle, np.roll(angle[:, 0], -1)])
            for name, angle in from_start.items()
        },
        over="u",
        x=(0, 1),
        y=(0, 180),
        label="turned from R₀, degrees",
        colors=colors | {"marks": VECTOR},
        marks=["R₀", "R₁", "R₂", "R₃"],
        dashed=["shortest"],
    )
    describe(
        plotter,
        "Four blue teaspoons, R0 to R3, stand round a see-through ball and can be turned. On the"
        " ball, spoons in the same poses lie on a closed curve of orientations: blue ones at the"
        " given poses, green ones in between, and a larger one on its way. A purple line with"
        " purple spoons, by the shortest way between matrices, swings out where the longest turn"
        " is more than half a turn.",
    )
    return plotter


def add_mounted(
    plotter: pyvista.Plotter, rotation: NDArray[np.float64], size: float, color: str, name: str
) -> pyvista.Actor:
    """Add a spoon that stands on the ball where its W axis leads out."""
    return add_spoon(plotter, rotation, rotation[:, 2], size, color, name)


def shortest_way(given: NDArray[np.float64], u: NDArray[np.float64]) -> NDArray[np.float64]:
    """Draw the curve of Section 5 with the shortest way between two matrices as its arc."""
    before, after = np.roll(given, 1, axis=0), np.roll(given, -1, axis=0)
    doubled = given @ before.swapaxes(1, 2) @ given
    a = slerp_rotations(given, slerp_rotations(doubled, after, 1 / 2), 1 / 2)
    b = given @ a.swapaxes(1, 2) @ given
    level = [r[:, np.newaxis] for r in (given, a, np.roll(b, -1, axis=0), after)]
    while len(level) > 1:
        level = [slerp_rotations(r, s, u) for r, s in pairwise(level)]
    return level[0].reshape(-1, 3, 3)


def turns_from_double(q: NDArray[np.float64]) -> list[float]:
    """Return how far it is, along the route, from Double of two poses to the next, in radians."""
    turns = []
    for before, here, after in zip(np.roll(q, 1, axis=0), q, np.roll(q, -1, axis=0), strict=True):
        doubled = double(np.sign(before @ here) * before, here)
        turns.append(2 * float(angle_between(doubled, np.sign(after @ here) * after)))
    return turns


def four_ways_between(
    first: ArrayLike = TWO_ORIENTATIONS[0], second: ArrayLike = TWO_ORIENTATIONS[1], beads: int = 8
) -> pyvista.Plotter:
    """Draw the path of a spoon's tip between two orientations for several interpolations.

    Parameters
    ----------
    first, second : array_like, shape (3,)
        The orientations, as angles about U, V and W in degrees. The Euler angles are interpolated
        as they are given.
    beads : int
        Number of equal time steps, after each of which slerp and nlerp are compared.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    angles = np.deg2rad(np.array([first, second], float))
    r1, r2 = matrix_from_euler_angles(*angles.T)[:, :3, :3]
    q1, q2 = (Quaternion.from_matrix(r).components for r in (r1, r2))
    q2 = q2 if q1 @ q2 > 0 else -q2

    def tips(q: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return where quaternions take the tip of the spoon, (1, 0, 0)."""
        return Quaternion(q[:, 0], q[:, 1:]).rotate([1, 0, 0])

    t = np.linspace(0, 1, 97)
    euler = matrix_from_euler_angles(*(angles[0] + t[:, np.newaxis] * (angles[1] - angles[0])).T)
    short, long = slerp_rotations(r1, r2, t)[:, :, 0], tips(slerp(q1, -q2, t))

    plotter = sphere_scene(eye=(1.15, 3.3, 4.3), target=(0, 0, 0.05))
    for turn, name in ((r1, "$R_1$"), (r2, "$R_2$")):
        spoon = teaspoon(stations=41, around=12)
        spoon.points = transform(turn, spoon.points)
        plotter.add_mesh(spoon, color=VECTOR, smooth_shading=True)
        add_label(plotter, 1.15 * turn[:, 0], name, VECTOR)
    add_line(plotter, short, RESULT, radius=0.011)
    add_dashes(plotter, euler[:, :3, 0], CROSS, dash=4, gap=2)
    add_dashes(plotter, long, NEUTRAL, dash=1, gap=1, radius=0.013)
    between = np.linspace(0, 1, beads + 1)[1:-1]
    for place in tips(slerp(q1, q2, between)):
        add_point(plotter, place, RESULT, radius=0.03)
    uneven = tips(nlerp(q1, q2, between))
    for place in uneven:
        # Slightly outside the sphere, so that a ball at the same place does not hide it.
        bounds = np.repeat(1.02 * place, 2) + 0.02 * np.array([-1, 1, -1, 1, -1, 1])
        add_thin(plotter, pyvista.Box(bounds), CROSS)
    for place, size, name, color in (
        (short[46], 1.27, "slerp, matrices", RESULT),
        (uneven[1], 1.17, "nlerp", CROSS),
        (euler[40, :3, 0], 1.22, "Euler angles", CROSS),
        (long[48], 1.2, "slerp, the long way", NEUTRAL),
    ):
        add_label(plotter, size * place, name, color)
    describe(
        plotter,
        "Two blue teaspoons, R1 and R2, cross at the centre of a see-through sphere that their tips"
        " touch. A green line leads from tip to tip the short way, with balls at equal times and"
        " small purple cubes near them: behind in the first half, ahead in the second. A broken"
        " purple line, for the Euler angles, swings out to the other side. A dotted grey line goes"
        " the long way, close to the lower rim of the sphere.",
    )
    return plotter


def add_dashes(
    plotter: pyvista.Plotter,
    path: NDArray[np.float64],
    color: str,
    dash: int,
    gap: int,
    radius: float = 0.009,
) -> None:
    """Add a broken line: draw `dash` steps of a path, leave out `gap` steps, and so on."""
    starts = range(0, len(path) - dash, dash + gap)
    dashes = [pyvista.MultipleLines(path[start : start + dash + 1]) for start in starts]
    tubes = [line.tube(radius=radius, n_sides=8, capping=True) for line in dashes]
    add_thin(plotter, pyvista.merge(tubes), color)


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
PICTURES = 24
"""Pictures of a film a second. Each second leads from one pose to the next."""
FILMS = {
    "slerp": NEUTRAL,
    "squad": QUATERNION,
    "spline of q": QUATERNION,
    "the paper's": MATRIX,
    "spline of M": MATRIX,
}
"""The curves of `animate`, and their colours."""
JUMPY = ("squad", "the paper's")
"""Those whose velocity does not jump, but whose acceleration does."""
ROW, RAIL, SHELF = 1.12 * W, 0.42 * W, -0.96 * W
"""Where the given poses, the line of time and the films are, below the buttons of a phone."""
TICK = 0.07 * W
FILMED = 0.63
"""The radius of a ball around a film; on its line, a spoon has as much room as there is."""


@explorable(
    model="animate",
    tries={
        "small turns": {"poses": SMALL},
        "one sign changed": {"poses": FLIPPED},
        "two poses alike": {"poses": ALIKE, "t": 0.62},
        "handles of one third": {"fraction": 1 / 3},
    },
    poses=Poses([f"spoon {k}" for k in range(MOST_POSES)], least=4, most=MOST_POSES),
    t=Slider(0, 1, "time, once round", plays=6),
    fraction=Slider(0.2, 0.5, "handles of the paper's curve", step=0.005, row=False),
)
def animate(poses: ArrayLike = POSES, t: float = 0.885, fraction: float = 1 / 2) -> pyvista.Plotter:
    """Draw five films of a spoon that go through the same poses at the same times.

    Parameters
    ----------
    poses : array_like, shape (n, 4)
        From 4 to 6 poses as quaternions; they are normalised. The last leads to the first.
    t : float
        The time, from 0 to 1. A film shows the picture next to it.
    fraction : float
        As for `rotedu.control_points.control_points`, for the paper's curve.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    q = normalised(poses)
    n = len(q)
    films = films_through(q, fraction)

    # From far away, so that spoons in the same pose look the same wherever they are.
    plotter = new_scene(eye=-32 * V + 0.1 * W, target=0.1 * W, view_angle=8)
    limit_turning(plotter, 15)
    add_timeline(plotter, q)
    picture = int(np.floor(n * PICTURES * t + 1 / 2)) % (n * PICTURES)
    for x, (name, film) in zip(np.linspace(-2.64, 2.64, len(films)), films.items(), strict=True):
        middle = SHELF + x * U
        add_sphere(plotter, middle, FILMED, around=24)
        tips = middle + FILMED * film[:, :, 0]
        add_line(plotter, [*tips, tips[0]], FILMS[name], 0.013, name=f"{name}, tip")
        add_spoon(plotter, film[picture], middle, FILMED, FILMS[name], name)
        add_label(plotter, middle - 0.84 * W, name, FILMS[name])

    steps = {name: film_steps(film) for name, film in films.items()}
    motions = {name: film_motion(step) for name, step in steps.items()}
    sizes = [
        {name: np.linalg.norm(motion[k], axis=-1) for name, motion in motions.items()}
        for k in range(2)
    ]
    for chart, heights, top, text in zip(
        ("speeds", "accelerations"),
        sizes,
        (400.0, 2000.0),
        ("speed up to 400°/s", "acceleration up to 2000°/s²"),
        strict=True,
    ):
        draw_chart(
            plotter,
            chart,
            heights,
            over="t",
            x=(0, 1),
            y=(0, top),
            label=text,
            colors=FILMS | {"marks": VECTOR},
            marks=[f"R{chr(ord('₀') + k)}" for k in range(MOST_POSES)],
            dashed=JUMPY,
        )
    fastest = [np.linalg.norm(step, axis=-1).max() for step in steps.values()]
    now = [speed[divmod(picture, PICTURES)] for speed in sizes[0].values()]
    corner = jump(motions["slerp"][0])
    jumps = [jump(motions[name][1]) for name in JUMPY]
    for where, name, value, text, unit in (
        ("picture", "speed", now, "speed, left to right", "°/s"),
        ("picture", "fastest", fastest, "fastest", "°/s"),
        ("folded", "corner", corner, "velocity of slerp jumps by", "°/s"),
        ("folded", "jumps", jumps, f"acceleration of {' and '.join(JUMPY)} jumps by", "°/s²"),
    ):
        read_out(plotter, name, value, text, digits=0, unit=unit, where=where)
    describe(
        plotter,
        f"{n} blue teaspoons, R0 to R{n - 1}, stand in a row above a line of time, which ends with"
        " the first again. Below, five glass balls in a row hold a spoon each, at the same moment"
        " of five films. A line on each ball is the way of the spoon's tip: it has corners for"
        " slerp, in grey; it is smooth for squad and for the spline of quaternions, in violet, and"
        " for the paper's curve, in ochre; for the spline of matrices, in ochre, too, it swings"
        " round where the others go straight.",
    )
    return plotter


def add_timeline(plotter: pyvista.Plotter, q: NDArray[np.float64]) -> None:
    """Add a line of time, and above it a spoon for each pose and, at its end, the first again."""
    n = len(q)
    size = 2.2 / n
    stops = np.linspace(-2.75 * U, 2.75 * U, n + 1)
    rail = stops[[0, -1]] + RAIL
    add_line(plotter, rail, NEUTRAL, 0.012, name="rail")
    place_grip(plotter, "t", path=rail)
    ticks = [[stop + RAIL - TICK, stop + RAIL + TICK] for stop in stops]
    add_lines(plotter, ticks, NEUTRAL, 0.012, name="ticks")
    place_grip(plotter, "poses", at=stops[:-1] + ROW, size=size)
    given = matrices(q)
    for k in range(MOST_POSES):
        used, i = k < n, min(k, n - 1)
        actor = add_spoon(plotter, given[i], stops[i] + ROW, size, VECTOR, f"R_{k}")
        actor.visibility = used
        place = stops[i] + RAIL - 4 * TICK if used else None
        add_label(plotter, place, f"$R_{k}$", VECTOR, name=f"R_{k}")
    add_spoon(plotter, given[0], stops[-1] + ROW, size, VECTOR, "again").prop.opacity = 0.3
    add_label(plotter, stops[-1] + RAIL - 4 * TICK, "$R_0$", VECTOR, name="again")


def add_spoon(
    plotter: pyvista.Plotter,
    rotation: NDArray[np.float64],
    middle: NDArray[np.float64],
    size: float,
    color: str,
    name: str,
) -> pyvista.Actor:
    """Add a turned spoon about a point, so many times half as long as a `teaspoon`."""
    matrix = translation(middle) @ scaling(size) @ homogeneous(rotation)
    name = place_part(plotter, name, matrix=matrix.T.ravel())
    mesh = teaspoon(stations=27, around=10)
    actor = plotter.add_mesh(mesh, color=color, smooth_shading=True, pickable=False, name=name)
    actor.user_matrix = matrix
    return actor


def films_through(q: NDArray[np.float64], fraction: float) -> dict[str, NDArray[np.float64]]:
    """Make the films of `FILMS`, shape (n * PICTURES, 3, 3), from quaternions, shape (n, 4)."""
    given = matrices(q)
    arcs = slerp(
        q[:, np.newaxis], np.roll(q, -1, axis=0)[:, np.newaxis], np.arange(PICTURES) / PICTURES
    )
    entries = periodic_spline(given.reshape(-1, 9), PICTURES).reshape(-1, 3, 3)
    films = (
        matrices(arcs.reshape(-1, 4)),
        matrices(squad(q, PICTURES)),
        matrices(periodic_spline(q, PICTURES)),
        closed_rotation_curve(given, PICTURES, fraction),
        nearest_rotation(entries),
    )
    return dict(zip(FILMS, films, strict=True))


def matrices(q: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the rotation matrices of quaternions, shape (n, 4)."""
    return Quaternion(q[:, 0], q[:, 1:]).matrix()


def film_steps(film: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the turns from picture to picture, in degrees a second, shape (n, PICTURES, 3)."""
    axis, angle = axis_angle(film.swapaxes(-1, -2) @ np.roll(film, -1, axis=0))
    turns = PICTURES * np.degrees(angle[:, np.newaxis] * axis)
    return np.asarray(turns.reshape(-1, PICTURES, 3))


def film_motion(steps: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return velocity and acceleration at the pictures from pose to pose, both ends included.

    Parameters
    ----------
    steps : ndarray, shape (n, PICTURES, 3)
        Turns from picture to picture, in degrees a second.

    Returns
    -------
    velocity, acceleration : ndarray, shape (n, PICTURES + 1, 3)
        As the body sees them. At a pose, the segments before and after it have their own.
    """
    steps = np.moveaxis(steps, 1, 0)
    steps = np.stack([beyond(*steps[:4]), *steps, beyond(*steps[:-5:-1])], axis=1)
    return (steps[:, :-1] + steps[:, 1:]) / 2, PICTURES * np.diff(steps, axis=1)


def beyond(
    first: NDArray[np.float64],
    second: NDArray[np.float64],
    third: NDArray[np.float64],
    fourth: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Return the value before four others on the cubic through them."""
    return 4 * first - 6 * second + 4 * third - fourth


def jump(motion: NDArray[np.float64]) -> float:
    """Return the largest jump of a motion, shape (n, m, 3), from one segment to the next."""
    change = motion[:, 0] - np.roll(motion[:, -1], 1, axis=0)
    return float(np.linalg.norm(change, axis=-1).max())
