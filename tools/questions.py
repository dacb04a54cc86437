"""Write twenty questions for an examination, with new numbers, and their answers.

A seed repeats a draw. Whoever knows it can write the answers, so the sheet does not name it.
"""

import argparse
import functools
import operator
import secrets
from collections.abc import Iterable
from pathlib import Path
from random import Random
from typing import NamedTuple

import numpy as np
from notebook_language import ROOT

from rotedu.arcs import angle_between, arc_axis, nlerp, slerp
from rotedu.averages import (
    angular_distance,
    chordal_distance,
    matrix_from_two_columns,
    mean_rotation,
)
from rotedu.closed_curve import de_casteljau
from rotedu.control_points import bisect, double
from rotedu.cost import count
from rotedu.general_rotation import (
    compose,
    euler_angles,
    matrix_from_euler_angles,
    reflection,
    rotation_u,
    rotation_v,
    rotation_w,
    scaling,
    translation,
)
from rotedu.motion import (
    matrix_from_rotation_vector,
    matrix_steps,
    quaternion_steps,
    rotation_vector,
)
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix, transform
from rotedu.orientations import slerp_rotations
from rotedu.quaternions import Quaternion

FOLDER = ROOT / "class" / "questions"

ABOUT = {"U": rotation_u, "V": rotation_v, "W": rotation_w}
# Vectors of whole numbers whose lengths are whole numbers, too.
WHOLE = [(1, 2, 2), (2, 3, 6), (0, 3, 4)]

SHEET = """\
# Questions

The axes U, V and W are right-handed, turns are counterclockwise seen from the tip of the axis, \
and quaternions put the scalar first. Give angles in degrees. A calculator will do.
"""
KEY = """\
# Answers

For the questions with the seed {seed}. Do not hand the seed out, since the answers can be written \
with it.
"""


class Question(NamedTuple):
    """A question about a chapter or page, with its answer and the way to it."""

    place: str
    minutes: int
    text: str
    answer: str
    way: str


def number(x: float, digits: int = 0) -> str:
    """Write a number, without a sign if it is rounded to zero."""
    return f"{round(float(x), digits) + 0.0:.{digits}f}".replace("-", "−")


def row(numbers: Iterable[float], digits: int = 0) -> str:
    """Write a vector."""
    return f"({', '.join(number(x, digits) for x in numbers)})"


def four(q: Iterable[float], digits: int = 0) -> str:
    """Write a quaternion."""
    w, *v = q
    return f"[{number(w, digits)}, {row(v, digits)}]"


def on_equator(degrees: float) -> np.ndarray:
    """Return the point on the equator at a longitude."""
    return np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees)), 0])


def longitude(point: np.ndarray) -> float:
    """Return the longitude of a point, in degrees."""
    return np.degrees(np.arctan2(point[1], point[0]))


def turn_about_w(matrix: np.ndarray) -> float:
    """Return the angle, in degrees, of a rotation about W."""
    return longitude(matrix[:, 0])


def whole_vector(draw: Random) -> list[int]:
    """Draw a vector of whole numbers whose length is a whole number."""
    return [draw.choice([-1, 1]) * x for x in draw.sample(draw.choice(WHOLE), 3)]


def whole_matrix(draw: Random) -> tuple[int, np.ndarray]:
    """Draw a rotation matrix: its common denominator and its numerators."""
    while True:
        w, *v = (draw.choice([-3, -2, -1, 1, 2, 3]) for _ in range(4))
        n = w * w + sum(x * x for x in v)
        numerators = (n * Quaternion(w, v).matrix()).round().astype(int)
        if n < 30 and np.gcd.reduce([n, *numerators.flat]) == 1:
            return n, numerators


def missing_column(draw: Random) -> Question:
    """Ask for the column that is missing."""
    n, matrix = whole_matrix(draw)
    missing = draw.randrange(3)
    (one, a), (two, b), (wanted, _) = (
        (("first", "second", "third")[i % 3], matrix[:, i % 3])
        for i in (missing + 1, missing + 2, missing)
    )
    column = n * matrix_from_two_columns(a, b)[:, 2]
    return Question(
        "Chapter 1",
        4,
        f"The {one} column of a rotation matrix is {row(a)}/{n}, the {two} is {row(b)}/{n}. "
        f"What is the {wanted}?",
        f"{row(column)}/{n}",
        f"The {one} column × the {two}, in this order.",
    )


def diagonal(draw: Random) -> Question:
    """Ask what the diagonal tells."""
    n, matrix = whole_matrix(draw)
    axis, angle = axis_angle(matrix / n)
    entries = ", ".join(f"{number(x)}/{n}" for x in matrix.diagonal())
    return Question(
        "Chapter 1",
        6,
        f"The diagonal of a rotation matrix is {entries}. By what angle does it turn, and how "
        "large, apart from their signs, are the components of its axis of length one?",
        f"{number(np.degrees(angle), 1)}°; {row(abs(axis), 2)}",
        r"The trace is $1+2\cos\theta$; an entry is $\cos\theta+(1-\cos\theta)\,n_i^2$.",
    )


def product(draw: Random) -> Question:
    """Ask for a product of quaternions."""
    p, q = ([draw.choice([-3, -2, -1, 1, 2, 3]) for _ in range(4)] for _ in "pq")
    pq = Quaternion(p[0], p[1:]) * Quaternion(q[0], q[1:])
    return Question(
        "Chapter 2",
        5,
        f"Multiply $p$ = {four(p)} by $q$ = {four(q)}: what is $pq$?",
        four([pq.w, *pq.v]),
        "The norms multiply; with the factors exchanged, only the cross product changes its sign.",
    )


def two_mirrors(draw: Random) -> Question:
    """Ask what two mirrors do."""
    first = draw.randrange(5, 90, 5)
    second = first + draw.choice([-1, 1]) * draw.randrange(15, 85, 5)
    mirrors = [reflection(on_equator(angle)) for angle in (first, second)]
    there, back = (turn_about_w(compose(*order)) for order in (mirrors[::-1], mirrors))
    return Question(
        "Chapter 2",
        4,
        "Two mirrors contain the W axis. Their normals are at right angles to W, at the angles "
        f"{number(first)}° and {number(second)}°, counted from U towards V. "
        "A body is reflected in the former, then in the latter. "
        "By what angle about W has it turned? And in the opposite order?",
        f"{number(there)}°; {number(back)}°",
        "Twice the angle from the one normal to the other.",
    )


def followed(draw: Random) -> Question:
    """Ask for a quaternion that was followed through full turns."""
    # The scalar is negative at the end.
    angle = 720 * draw.choice([1, 2]) + 360 + draw.choice([-1, 1]) * draw.randrange(20, 170, 10)
    q = Quaternion.from_axis_angle([0, 0, 1], np.radians(angle))
    end = np.array([q.w, *q.v])
    return Question(
        "Chapter 2",
        4,
        f"A shaft turns steadily by {angle}° about W. Its quaternion begins as "
        "1 and does not jump. What is it at the end? And what does a program write that "
        "always makes the scalar positive? Use three decimals.",
        f"{four(end, 3)}; {four(-end, 3)}",
        r"$\cos\frac\theta2$ and $\sin\frac\theta2$ of the whole angle; then the opposite signs."
        "",
    )


def turned_point(draw: Random) -> Question:
    """Ask where a point goes."""
    # With these numbers, the point is not on the axis.
    axis, point = whole_vector(draw), draw.sample(range(1, 6), 3)
    angle = draw.choice([-120, -90, -60, 60, 90, 120])
    return Question(
        "Chapter 3",
        7,
        f"Turn the point {row(point)} by {number(angle)}° about the axis {row(axis)}. "
        "Use two decimals.",
        row(rotate(point, axis, np.radians(angle)), 2),
        "Rodrigues' formula, with an axis of length one. The distance from the origin stays.",
    )


def axis_and_angle(draw: Random) -> Question:
    """Ask for axis and angle of a matrix."""
    n, matrix = whole_matrix(draw)
    axis, angle = axis_angle(matrix / n)
    rows = r" \\ ".join(" & ".join(str(x) for x in line) for line in matrix)
    return Question(
        "Chapter 3",
        6,
        "About which axis, of length one, and by what angle from 0° to 180° does "
        rf"$\frac{{1}}{{{n}}}\begin{{pmatrix}} {rows} \end{{pmatrix}}$ turn?",
        f"{number(np.degrees(angle), 1)}° about {row(axis, 2)}",
        r"The trace gives the angle, $M-M^{\mathsf T}$ the axis and its sign.",
    )


def order_of_turns(draw: Random) -> Question:
    """Ask what the order of turns does."""
    point = draw.sample(range(1, 6), 3)
    turns = [(axis, draw.choice([-90, 90])) for axis in draw.sample("UVW", 3)]
    matrices = [ABOUT[axis](np.radians(angle)) for axis, angle in turns]
    fixed, carried = (transform(compose(*order), point) for order in (matrices[::-1], matrices))
    told = ", then ".join(f"by {number(angle)}° about {axis}" for axis, angle in turns)
    return Question(
        "Chapter 4",
        6,
        f"A body is turned {told}. Where does its point {row(point)} end if the axes stay "
        "where they are? And if the body carries its axes along?",
        f"{row(fixed)}; {row(carried)}",
        "Read the product from right to left, then from left to right.",
    )


def locked(draw: Random) -> Question:
    """Ask for other angles at gimbal lock."""
    u, w = draw.sample([*range(-80, 0, 5), *range(5, 85, 5)], 2)
    v = draw.choice([-90, 90])
    same, _, _ = euler_angles(matrix_from_euler_angles(*np.radians([u, v, w])))
    return Question(
        "Chapter 4",
        3,
        "A body is turned about the fixed axes U, V, W, in this order, by "
        f"$u$ = {number(u)}°, $v$ = {number(v)}° and $w$ = {number(w)}°. "
        "Which $u$ gives the same orientation with the same $v$, but with no turn about W?",
        f"{number(np.degrees(same))}°",
        "At the lock only $u-w$ matters if $v$ is positive, and $u+w$ if it is negative.",
    )


def points_and_directions(draw: Random) -> Question:
    """Ask for a point and for a direction."""
    factor, angle = draw.choice([2, 3, 4]), draw.choice([-90, 90])
    move, given = ([draw.choice([-3, -2, -1, 1, 2, 3]) for _ in range(3)] for _ in "md")
    matrix = compose(translation(move), rotation_w(np.radians(angle)), scaling(factor))
    point, direction = (matrix @ [*given, last] for last in (1, 0))
    return Question(
        "Chapter 4",
        4,
        f"A matrix makes everything {factor} times as large, then turns it by {number(angle)}° "
        f"about W, then moves it by {row(move)}. Where does it take the point {row(given)}, "
        f"and where the direction {row(given)}?",
        f"{row(point[:3])}; {row(direction[:3])}",
        "A direction does not move: its fourth coordinate is 0.",
    )


def two_ways_between(draw: Random) -> Question:
    """Ask how slerp and nlerp differ."""
    angle, t = draw.randrange(60, 160, 10), draw.choice([0.2, 0.25, 0.3, 0.4])
    ends = on_equator(0), on_equator(angle)
    exact, straight = (longitude(way(*ends, t)) for way in (slerp, nlerp))
    return Question(
        "page 5 I",
        5,
        f"Two unit vectors are {angle}° apart. How far from the former, in degrees, do slerp and "
        f"nlerp lead for $t$ = {t}?",
        f"{number(exact, 1)}°; {number(straight, 1)}°",
        r"Slerp: $t\theta$. Nlerp: $\tan\varphi=t\sin\theta/(1-t+t\cos\theta)$.",
    )


def control_points(draw: Random) -> Question:
    """Ask for control points on a great circle."""
    here = draw.randrange(0, 40, 10)
    before, after = (here + gap for gap in draw.sample(range(-100, -10, 10), 2))
    after = 2 * here - after
    last, this, following = (on_equator(angle) for angle in (before, here, after))
    reflected = double(last, this)
    a = bisect(this, bisect(reflected, following))
    found = (reflected, a, double(a, this))
    return Question(
        "page 5 II",
        5,
        f"Three points in a row of a closed curve lie on the equator, at {number(before)}°, "
        f"{number(here)}° and {number(after)}°. Where is the first of them when it is reflected "
        "in the second? And where are the control points $a$ after and $b$ before the second, "
        "with the fraction one half?",
        "; ".join(f"{number(longitude(point), 1)}°" for point in found),
        "A quarter of both gaps together, after the point and before it.",
    )


def arcs_of_arcs(draw: Random) -> Question:
    """Ask for a point of the curve on a great circle."""
    u = draw.choice([0.25, 0.5, 0.75])
    places = np.cumsum([0, *(draw.randrange(8, 60, 4) for _ in range(3))])
    point = de_casteljau([on_equator(angle) for angle in places], u)
    told = ", ".join(f"{angle}°" for angle in places)
    return Question(
        "page 5 III",
        5,
        f"The four control points of a piece lie on the equator, at {told}. Where is the curve "
        f"at $u$ = {u}?",
        f"{number(longitude(point) % 360, 2)}°",
        "On one great circle, arcs divide angles: three arcs, then two, then one.",
    )


def carried_round(draw: Random) -> Question:
    """Ask how a platform comes back from a triangle."""
    angles = [0, 0, 0]
    while not 190 <= sum(angles) <= 330:
        angles = [draw.randrange(60, 120, 5) for _ in range(3)]
    a, b, c = np.radians(angles)
    # The law of cosines for the sides that meet at the first corner, which is the pole.
    sides = (
        np.arccos((np.cos(other) + np.cos(a) * np.cos(own)) / (np.sin(a) * np.sin(own)))
        for other, own in ((c, b), (b, c))
    )
    corners = [
        np.array([0, 0, 1]),
        *(
            np.array([np.sin(s) * np.cos(way), np.sin(s) * np.sin(way), np.cos(s)])
            for s, way in zip(sides, (0, a), strict=True)
        ),
    ]
    legs = [
        rotation_matrix(arc_axis(p, q), angle_between(p, q))
        for p, q in zip(corners, [*corners[1:], corners[0]], strict=True)
    ]
    turned = turn_about_w(compose(*legs[::-1]))
    return Question(
        "page 5 IV",
        3,
        "A level platform is carried along great circles round a triangle with the angles "
        f"{', '.join(f'{angle}°' for angle in angles)}, counterclockwise as seen from above, and "
        "never turned about its vertical. By what angle has it turned when it is back?",
        f"{number(turned)}°, counterclockwise",
        "By the area of the triangle: the sum of its angles less half a turn.",
    )


def two_arcs(draw: Random) -> Question:
    """Ask for the long way and the short."""
    # With these numbers, no answer is half a turn.
    start = draw.randrange(12, 50, 10)
    end, t = start + draw.randrange(200, 300, 20), draw.choice([0.25, 0.5, 0.75])
    half = np.radians([start, end]) / 2
    w, z = slerp(*np.stack([np.cos(half), np.sin(half)], axis=-1), t)
    long = 2 * np.degrees(np.arctan2(z, w))
    turns = (rotation_w(np.radians(angle))[:3, :3] for angle in (start, end))
    short = turn_about_w(slerp_rotations(*turns, t))
    return Question(
        "page 5 IV",
        5,
        f"A body is turned about W, by {start}° at the start and by {end}° at the end. "
        "Its quaternions are those of these angles, with their signs. "
        f"By what angle is it turned at $t$ = {t}, according to slerp of the quaternions, and "
        "according to the shortest turn from the one matrix to the other? Give angles from "
        "−180° to 180°.",
        f"{number((long + 180) % 360 - 180, 1)}°; {number(short, 1)}°",
        "The quaternions, as they stand, take the long way.",
    )


def operations(draw: Random) -> Question:
    """Ask for the number of operations."""
    rotations, points = draw.randrange(3, 8), draw.randrange(10, 60, 5)
    matrices, cloud = np.stack([np.eye(3)] * rotations), np.ones((points, 3))
    first = count(lambda m, p: transform(functools.reduce(operator.matmul, m), p), matrices, cloud)
    single = count(
        lambda m, p: functools.reduce(lambda q, a: transform(a, q), m, p), matrices, cloud
    )
    told = [f"{cost.multiplications} and {cost.additions}" for cost in (first, single)]
    return Question(
        "Chapter 6",
        4,
        f"{points} points are to be turned by {rotations} rotations in a row, given as matrices. "
        "How many multiplications and how many additions does that take if you multiply the "
        "matrices first? And if you turn the points by one matrix after the other?",
        "; ".join(told),
        "A product takes 27 and 18, a point 9 and 6.",
    )


def shortest_vector(draw: Random) -> Question:
    """Ask for the shortest rotation vector."""
    axis = np.array(whole_vector(draw))
    vector = axis * round(draw.uniform(3.6, 5.9) / np.linalg.norm(axis), 1)
    return Question(
        "page A",
        5,
        f"The rotation vector {row(vector, 1)}, in radians, turns by more than half a turn. "
        "What is the shortest rotation vector of the same rotation? Use two decimals.",
        row(rotation_vector(matrix_from_rotation_vector(vector)), 2),
        "Shorten it by a full turn, through zero: the length less 2π, along the same line.",
    )


def lost_by_steps(draw: Random) -> Question:
    """Ask what Euler's method loses."""
    step, steps = draw.randrange(4, 21, 2) / 100, draw.randrange(10, 60, 5)
    velocities = np.tile([0, 0, step], (steps, 1))
    matrix = matrix_steps(np.eye(3), velocities, 1)[-1]
    q = quaternion_steps([1, 0, 0, 0], velocities, 1)[-1]
    factors = np.linalg.norm(matrix[:, 0]), np.linalg.norm(q)
    return Question(
        "page A",
        5,
        f"Euler's method takes {steps} steps with $h\\omega$ = {step} about a fixed axis. By which "
        "factor does the matrix stretch what is at right angles to the axis, and by which factor "
        "does the norm of the quaternion grow? Use three decimals.",
        "; ".join(number(factor, 3) for factor in factors),
        r"$\sqrt{1+(h\omega)^2}$ for each step, and the same with half of $h\omega$.",
    )


def apart(draw: Random) -> Question:
    """Ask how far apart two orientations are."""
    (one, u), (two, v) = zip(draw.sample("UVW", 2), draw.sample(range(30, 160, 10), 2), strict=True)
    turns = [ABOUT[axis](np.radians(angle))[:3, :3] for axis, angle in ((one, u), (two, v))]
    return Question(
        "page B",
        6,
        f"One body is turned by {u}° about {one}, another by {v}° about {two}. By what angle are "
        "they apart, and how long is the chord between their matrices? "
        "Use one decimal for the angle and two for the chord.",
        f"{number(np.degrees(angular_distance(*turns)), 1)}°; "
        f"{number(chordal_distance(*turns), 2)}",
        "The cosines of the half angles multiply, as the axes are at right angles; the chord is "
        r"$2\sqrt2\sin\frac\theta2$.",
    )


def mean(draw: Random) -> Question:
    """Ask for a mean."""
    angles = [draw.randrange(0, 60, 10), draw.randrange(60, 100, 10), draw.randrange(110, 160, 10)]
    turns = [rotation_w(np.radians(angle))[:3, :3] for angle in angles]
    told = ", ".join(f"{angle}°" for angle in angles)
    return Question(
        "page B",
        4,
        f"Three bodies are turned about W, by {told}. By what angle is their mean by chord turned? "
        "Use one decimal.",
        f"{number(turn_about_w(mean_rotation(turns)), 1)}°",
        "Add the three images of U; their sum points where the mean sends U.",
    )


QUESTIONS = [
    missing_column,
    diagonal,
    product,
    two_mirrors,
    followed,
    turned_point,
    axis_and_angle,
    order_of_turns,
    locked,
    points_and_directions,
    two_ways_between,
    control_points,
    arcs_of_arcs,
    carried_round,
    two_arcs,
    operations,
    shortest_vector,
    lost_by_steps,
    apart,
    mean,
]


def drawn(seed: int) -> dict[str, Question]:
    """Return all questions with the numbers of a seed, by the names of their functions."""
    return {ask.__name__: ask(Random(f"{seed} {ask.__name__}")) for ask in QUESTIONS}


def write(seed: int, folder: Path) -> None:
    """Write the questions for the class, and the answers for the teacher."""
    sheet, key = [SHEET], [KEY.format(seed=seed)]
    for i, question in enumerate(drawn(seed).values(), start=1):
        minutes, answer = f"{question.minutes} minutes", f"{question.answer}  \n*{question.way}*"
        sheet.append(f"**{i}** ({question.place}, {minutes}). {question.text}\n")
        key.append(f"**{i}** ({question.place}, {minutes}). {answer}\n")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "questions.md").write_text("\n".join(sheet), encoding="utf-8")
    (folder / "answers.md").write_text("\n".join(key), encoding="utf-8")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument(
        "seed",
        nargs="?",
        type=int,
        default=secrets.randbelow(10**9),
        help="a whole number that repeats a draw (default: a new one)",
    )
    seed = parser.parse_args().seed
    write(seed, FOLDER / str(seed))
    print(f"Twenty questions and their answers are here: class/questions/{seed}")
