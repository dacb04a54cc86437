"""The questions for an examination: their answers are found again from what students read."""

import re
from collections.abc import Callable
from pathlib import Path
from random import Random

import numpy as np
import pytest
from questions import QUESTIONS, Question, drawn, write
from scipy.spatial.transform import Rotation, Slerp
from sympy import Quaternion

NUMBER = re.compile(r"−?\d+(?:\.\d+)?")


def numbers(text: str) -> list[float]:
    return [float(found.replace("−", "-")) for found in NUMBER.findall(text.replace("-", "−"))]


def turns(text: str) -> list[tuple[str, float]]:
    """The axes and angles of "30° about U"."""
    return [(axis, *numbers(angle)) for angle, axis in re.findall(r"(−?\d+)° about ([UVW])", text)]


def missing_column(text: str) -> list[float]:
    *a, n, a1, a2, a3, _ = numbers(text)
    places = [
        ("first", "second", "third").index(w) for w in re.findall(r"first|second|third", text)
    ]
    matrix = np.zeros((3, 3))
    matrix[:, places[:2]] = np.transpose([a, [a1, a2, a3]]) / n
    matrix[:, places[2]] = np.cross(*matrix[:, places[:2]].T)
    return [*(matrix[:, places[2]] * np.linalg.det(matrix) * n), n]


def product(text: str) -> list[float]:
    given = [int(x) for x in numbers(text)]
    pq = Quaternion(*given[:4]) * Quaternion(*given[4:])
    return [float(x) for x in (pq.a, pq.b, pq.c, pq.d)]


def followed(text: str) -> list[float]:
    half = np.radians(numbers(text)[0] / 2)
    q = np.array([np.cos(half), 0, 0, np.sin(half)])
    assert q[0] < 0
    return [*q, *-q]


def axis_and_angle(text: str) -> list[float]:
    *_, one, n = numbers(text.split(r"\begin")[0])
    assert one == 1
    matrix = np.reshape(numbers(text.split("pmatrix")[1]), (3, 3)) / n
    vector = Rotation.from_matrix(matrix).as_rotvec()
    angle = np.linalg.norm(vector)
    return [np.degrees(angle), *(vector / angle)]


def order_of_turns(text: str) -> list[float]:
    axes, angles = zip(*turns(text), strict=True)
    letters = "".join(axes).translate(str.maketrans("UVW", "XYZ"))
    point = numbers(text)[-3:]
    ways = [Rotation.from_euler(way, angles, degrees=True) for way in (letters.lower(), letters)]
    ends = [way.apply(point) for way in ways]
    assert not np.allclose(*ends)
    return [*np.ravel(ends)]


def locked(text: str) -> list[float]:
    u, v, w = numbers(text)
    turned = Rotation.from_euler("xyz", [u, v, w], degrees=True)
    at_lock = Rotation.from_euler("y", v, degrees=True)
    return [(at_lock.inv() * turned).as_rotvec(degrees=True)[0]]


def two_ways_between(text: str) -> list[float]:
    angle, t = numbers(text)
    return [t * angle, np.degrees(np.angle(1 - t + t * np.exp(1j * np.radians(angle))))]


def control_points(text: str) -> list[float]:
    before, here, after = numbers(text)
    quarter = (after - before) / 4
    return [2 * here - before, here + quarter, here - quarter]


def arcs_of_arcs(text: str) -> list[float]:
    """By Bernstein's polynomials."""
    a, b, c, d, u = numbers(text)
    v = 1 - u
    return [a * v**3 + 3 * b * u * v**2 + 3 * c * u**2 * v + d * u**3]


def two_arcs(text: str) -> list[float]:
    start, end, t, *_ = numbers(text)
    ends = Rotation.from_euler("z", [[start], [end]], degrees=True)
    long = start + t * (end - start)
    return [long - 360 * (long > 180), Slerp([0, 1], ends)(t).as_euler("xyz", degrees=True)[2]]


def operations(text: str) -> list[float]:
    n, k = numbers(text)
    return [27 * (k - 1) + 9 * n, 18 * (k - 1) + 6 * n, 9 * k * n, 6 * k * n]


def shortest_vector(text: str) -> list[float]:
    vector = numbers(text)
    assert np.pi < np.linalg.norm(vector) < 2 * np.pi
    return [*Rotation.from_rotvec(vector).as_rotvec()]


def mean(text: str) -> list[float]:
    turned = Rotation.from_euler("z", np.reshape(numbers(text), (-1, 1)), degrees=True)
    return [turned.mean().as_euler("xyz", degrees=True)[2]]


def test_there_are_questions_about_every_chapter() -> None:
    places = {question.place.split()[1] for question in drawn(1)}
    assert places == {*"123456", "A", "B"}
    assert {question.minutes for question in drawn(1)} == {3, 4, 5, 6}


@pytest.mark.parametrize("ask", QUESTIONS, ids=lambda ask: ask.__name__)
def test_an_answer_is_found_again(ask: Callable[[Random], Question]) -> None:
    oracle = globals()[ask.__name__]
    for seed in range(60):
        question = ask(Random(seed))
        given = [found.partition(".")[2] for found in NUMBER.findall(question.answer)]
        last = [0.5 / 10 ** len(decimals) for decimals in given]
        expected = oracle(question.text)
        assert len(expected) == len(last), seed
        off = abs(np.subtract(numbers(question.answer), expected))
        assert (off <= np.add(last, 1e-9)).all(), (seed, question.text, question.answer)


def test_a_seed_repeats_its_bytes_and_another_changes_every_question(tmp_path: Path) -> None:
    for folder, seed in (("one", 1), ("again", 1), ("two", 2)):
        write(seed, tmp_path / folder)
    for file in ("questions.md", "answers.md"):
        one, again, two = (tmp_path / name / file for name in ("one", "again", "two"))
        assert one.read_bytes() == again.read_bytes() != two.read_bytes()
    assert not {question.text for question in drawn(1)} & {question.text for question in drawn(2)}


def test_the_sheet_gives_away_neither_seed_nor_answer(tmp_path: Path) -> None:
    write(987654321, tmp_path)
    sheet, key = ((tmp_path / f"{name}.md").read_text("utf-8") for name in ("questions", "answers"))
    assert "987654321" in key
    assert "987654321" not in sheet
    for ask, question in zip(QUESTIONS, drawn(987654321), strict=True):
        assert question.text in sheet
        for secret in (question.answer, ask.__doc__):
            assert secret in key
            assert secret not in sheet
