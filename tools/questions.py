"""Write questions for an examination, with new numbers, and their answers.

A seed repeats a draw. Whoever knows it can write the answers, so the sheet does not name it. What
a question's function says first is the way to the answer, for the key.
"""

import functools
import operator
import secrets
import sys
from collections.abc import Iterable
from pathlib import Path
from random import Random
from typing import NamedTuple, SupportsFloat

import numpy as np
from notebook_language import ROOT

from rotedu import general_rotation as general
from rotedu.arcs import nlerp, slerp
from rotedu.averages import mean_rotation
from rotedu.closed_curve import de_casteljau
from rotedu.control_points import bisect, double
from rotedu.cost import count
from rotedu.edition.exercises.answers import along_equator, on_equator
from rotedu.five_numbers import matrix_from_two_columns
from rotedu.motion import matrix_from_rotation_vector, rotation_vector
from rotedu.ordinary_rotation import axis_angle, rotation_matrix, transform
from rotedu.orientations import slerp_rotations
from rotedu.quaternions import Quaternion

FOLDER = ROOT / "class" / "questions"
ABOUT = {"U": general.rotation_u, "V": general.rotation_v, "W": general.rotation_w}
SMALL = [-3, -2, -1, 1, 2, 3]
SHEET = """\
# Questions

The axes U, V and W are right-handed, turns are counterclockwise seen from the tip of the axis, \
and quaternions put the scalar first. Give angles in degrees. A calculator will do.
"""
KEY = """\
# Answers

For the questions with the seed {seed}. Whoever knows the seed can write the answers, too.
"""


class Question(NamedTuple):
    """A question about a chapter or page, and its answer."""

    place: str
    minutes: int
    text: str
    answer: str


def number(x: SupportsFloat, digits: int = 0) -> str:
    """Write a number, without a sign if it is rounded to zero."""
    return f"{round(float(x), digits) + 0.0:.{digits}f}".replace("-", "−")


def row(numbers: Iterable[float], digits: int = 0) -> str:
    """Write a vector."""
    return f"({', '.join(number(x, digits) for x in numbers)})"


def four(q: Iterable[float], digits: int = 0) -> str:
    """Write a quaternion."""
    w, *v = q
    return f"[{number(w, digits)}, {row(v, digits)}]"


def whole_matrix(draw: Random) -> tuple[int, np.ndarray]:
    """Draw a rotation matrix: its common denominator and its numerators."""
    while True:
        w, *v = (draw.choice(SMALL) for _ in range(4))
        n = w * w + sum(x * x for x in v)
        numerators = (n * Quaternion(w, v).matrix()).round().astype(int)
        if n < 30 and np.gcd.reduce([n, *numerators.flat]) == 1:
            return n, numerators


def missing_column(draw: Random) -> Question:
    """Each column is the next one × the one after it, where the first follows the third."""
    n, matrix = whole_matrix(draw)
    missing = draw.randrange(3)
    one, two = (missing + 1) % 3, (missing + 2) % 3
    column = n * matrix_from_two_columns(matrix[:, one], matrix[:, two])[:, 2]
    names = "first", "second", "third"
    text = (
        f"The {names[one]} column of a rotation matrix is {row(matrix[:, one])}/{n}, "
        f"the {names[two]} is {row(matrix[:, two])}/{n}. What is the {names[missing]}?"
    )
    return Question("Chapter 1", 4, text, f"{row(column)}/{n}")


def product(draw: Random) -> Question:
    """Check that the norms multiply. In $qp$ only the cross product would change its sign."""
    p, q = ([draw.choice(SMALL) for _ in range(4)] for _ in "pq")
    pq = Quaternion(p[0], p[1:]) * Quaternion(q[0], q[1:])
    text = f"Multiply $p$ = {four(p)} by $q$ = {four(q)}: what is $pq$?"
    return Question("Chapter 2", 5, text, four(pq.components))


def followed(draw: Random) -> Question:
    r"""Take $\cos\frac\theta2$ and $\sin\frac\theta2$ of the whole angle, then the other signs."""
    # The scalar is negative at the end.
    angle = 720 * draw.choice([1, 2]) + 360 + draw.choice([-1, 1]) * draw.randrange(20, 170, 10)
    end = Quaternion.from_axis_angle([0, 0, 1], np.radians(angle)).components
    text = (
        f"A shaft turns steadily by {angle}° about W. Its quaternion begins as 1 and does not "
        "jump. What is it at the end? And what does a program write that always makes the scalar "
        "positive? Use three decimals."
    )
    return Question("Chapter 2", 4, text, f"{four(end, 3)}; {four(-end, 3)}")


def axis_and_angle(draw: Random) -> Question:
    r"""Read the angle off the trace, and the axis with its sign off $M-M^{\mathsf T}$."""
    n, matrix = whole_matrix(draw)
    axis, angle = axis_angle(matrix / n)
    rows = r" \\ ".join(" & ".join(str(x) for x in line) for line in matrix)
    text = (
        "About which axis, of length one, and by what angle from 0° to 180° does "
        rf"$\frac{{1}}{{{n}}}\begin{{pmatrix}} {rows} \end{{pmatrix}}$ turn?"
    )
    return Question("Chapter 3", 6, text, f"{number(np.degrees(angle), 1)}° about {row(axis, 2)}")


def order_of_turns(draw: Random) -> Question:
    """Read the product from right to left, then from left to right."""
    point = draw.sample(range(1, 6), 3)
    turns = [(axis, draw.choice([-90, 90])) for axis in draw.sample("UVW", 3)]
    matrices = [ABOUT[axis](np.radians(angle)) for axis, angle in turns]
    ends = [transform(general.compose(*order), point) for order in (matrices[::-1], matrices)]
    told = ", then ".join(f"by {number(angle)}° about {axis}" for axis, angle in turns)
    text = (
        f"A body is turned {told}. Where does its point {row(point)} end if the axes stay "
        "where they are? And if the body carries its axes along?"
    )
    return Question("Chapter 4", 6, text, "; ".join(row(end) for end in ends))


def locked(draw: Random) -> Question:
    """At the lock only $u-w$ matters if $v$ is positive, and $u+w$ if it is negative."""
    u, w = draw.sample([*range(-80, 0, 5), *range(5, 85, 5)], 2)
    v = draw.choice([-90, 90])
    same, _, _ = general.euler_angles(general.matrix_from_euler_angles(*np.radians([u, v, w])))
    text = (
        "A body is turned about the fixed axes U, V, W, in this order, by "
        f"$u$ = {number(u)}°, $v$ = {number(v)}° and $w$ = {number(w)}°. "
        "Which $u$ gives the same orientation with the same $v$, but with no turn about W?"
    )
    return Question("Chapter 4", 3, text, f"{number(np.degrees(same))}°")


def two_ways_between(draw: Random) -> Question:
    r"""Slerp: $t\theta$. Nlerp: $\tan\varphi=t\sin\theta/(1-t+t\cos\theta)$."""
    angle, t = draw.randrange(60, 160, 10), draw.choice([0.2, 0.25, 0.3, 0.4])
    ends = on_equator([0, angle])
    answer = "; ".join(f"{number(along_equator(way(*ends, t)), 1)}°" for way in (slerp, nlerp))
    text = f"Two unit vectors are {angle}° apart. How far does slerp lead for $t$ = {t}, and nlerp?"
    return Question("page 5 I", 5, text, answer)


def control_points(draw: Random) -> Question:
    """Take a quarter of both gaps together, after the point and before it."""
    here = draw.randrange(0, 40, 10)
    back, on = draw.sample(range(10, 101, 10), 2)
    last, this, following = on_equator([here - back, here, here + on])
    reflected = double(last, this)
    a = bisect(this, bisect(reflected, following))
    text = (
        "Three points in a row of a closed curve lie on the equator, at "
        f"{number(here - back)}°, {here}° and {here + on}°. Where is the first of them when it is "
        "reflected in the second? And where are the control points $a$ after and $b$ before the "
        "second, with the fraction one half?"
    )
    found = along_equator([reflected, a, double(a, this)])
    return Question("page 5 II", 5, text, "; ".join(f"{number(angle, 1)}°" for angle in found))


def arcs_of_arcs(draw: Random) -> Question:
    """On one great circle, arcs divide angles: three arcs, then two, then one."""
    u = draw.choice([0.25, 0.5, 0.75])
    places = np.cumsum([0, *(draw.randrange(8, 60, 4) for _ in range(3))])
    point = de_casteljau(on_equator(places), u)
    text = (
        "The four control points of a piece lie on the equator, at "
        f"{', '.join(f'{angle}°' for angle in places)}. Where is the curve at $u$ = {u}?"
    )
    return Question("page 5 III", 5, text, f"{number(along_equator(point) % 360, 2)}°")


def two_arcs(draw: Random) -> Question:
    """Follow the quaternions as they stand: they take the long way."""
    # With these numbers, no answer is half a turn.
    start = draw.randrange(12, 50, 10)
    end, t = start + draw.randrange(200, 300, 20), draw.choice([0.25, 0.5, 0.75])
    long = 2 * along_equator(slerp(on_equator(start / 2), on_equator(end / 2), t))
    turns = rotation_matrix([0, 0, 1], np.radians([start, end]))
    short = along_equator(slerp_rotations(*turns, t)[:, 0])
    text = (
        f"A body is turned about W, by {start}° at the start and by {end}° at the end. Its "
        "quaternions are those of these angles, with their signs. By what angle is it turned at "
        f"$t$ = {t}, according to slerp of the quaternions, and according to the shortest turn "
        "from the one matrix to the other? Give angles from −180° to 180°."
    )
    answer = f"{number((long + 180) % 360 - 180, 1)}°; {number(short, 1)}°"
    return Question("page 5 IV", 5, text, answer)


def operations(draw: Random) -> Question:
    """Count 27 and 18 for a product, 9 and 6 for a point."""
    rotations, points = draw.randrange(3, 8), draw.randrange(10, 60, 5)
    matrices, cloud = np.stack([np.eye(3)] * rotations), np.ones((points, 3))
    costs = (
        count(lambda m, p: transform(functools.reduce(operator.matmul, m), p), matrices, cloud),
        count(lambda m, p: functools.reduce(lambda q, a: transform(a, q), m, p), matrices, cloud),
    )
    text = (
        f"{points} points are to be turned by {rotations} rotations in a row, given as matrices. "
        "How many multiplications and how many additions does that take if you multiply the "
        "matrices first? And if you turn the points by one matrix after the other?"
    )
    answer = "; ".join(f"{cost.multiplications} and {cost.additions}" for cost in costs)
    return Question("Chapter 6", 4, text, answer)


def shortest_vector(draw: Random) -> Question:
    """Shorten it by a full turn, through zero: the length less 2π, along the same line."""
    # Whole numbers with a whole length.
    numbers = draw.sample(draw.choice([(1, 2, 2), (2, 3, 6), (0, 3, 4)]), 3)
    axis = np.array([draw.choice([-1, 1]) * x for x in numbers])
    vector = axis * round(draw.uniform(3.6, 5.9) / np.linalg.norm(axis), 1)
    text = (
        f"The rotation vector {row(vector, 1)}, in radians, turns by more than half a turn. "
        "What is the shortest rotation vector of the same rotation? Use two decimals."
    )
    return Question("page A", 5, text, row(rotation_vector(matrix_from_rotation_vector(vector)), 2))


def mean(draw: Random) -> Question:
    """Add the three images of U; their sum points where the mean sends U."""
    angles = [draw.randrange(0, 60, 10), draw.randrange(60, 100, 10), draw.randrange(110, 160, 10)]
    turns = rotation_matrix([0, 0, 1], np.radians(angles))
    told = ", ".join(f"{angle}°" for angle in angles)
    text = f"Bodies are turned about W, by {told}. By what angle is their mean by chord turned?"
    answer = f"{number(along_equator(mean_rotation(turns)[:, 0]), 1)}°"
    return Question("page B", 4, f"{text} Use one decimal.", answer)


QUESTIONS = [
    missing_column,
    product,
    followed,
    axis_and_angle,
    order_of_turns,
    locked,
    two_ways_between,
    control_points,
    arcs_of_arcs,
    two_arcs,
    operations,
    shortest_vector,
    mean,
]


def drawn(seed: int) -> list[Question]:
    """Return all questions with the numbers of a seed."""
    return [ask(Random(f"{seed} {ask.__name__}")) for ask in QUESTIONS]


def write(seed: int, folder: Path) -> None:
    """Write the questions for the class, and the answers for the teacher."""
    sheet, key = [SHEET], [KEY.format(seed=seed)]
    for i, (ask, question) in enumerate(zip(QUESTIONS, drawn(seed), strict=True), 1):
        head = f"**{i}** ({question.place}, {question.minutes} minutes)."
        sheet.append(f"{head} {question.text}\n")
        key.append(f"{head} {question.answer}  \n*{ask.__doc__}*\n")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "questions.md").write_text("\n".join(sheet), encoding="utf-8")
    (folder / "answers.md").write_text("\n".join(key), encoding="utf-8")


if __name__ == "__main__":
    seed = int(sys.argv[1]) if sys.argv[1:] else secrets.randbelow(10**9)
    write(seed, FOLDER / str(seed))
    print(f"The questions and their answers are here: class/questions/{seed}")
