"""Measure turning points and drawing curves, side by side with other packages.

``make bench`` runs this. The result of a test is its time divided by its number of points. Within a
group, the tests have the names of the rows in the table of Chapter 6.
"""

import math
import subprocess
import sys
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import quaternion
import splines.quaternion
from pytransform3d import transformations
from scipy.spatial.transform import Rotation, RotationSpline
from threadpoolctl import threadpool_limits

from rotedu.closed_curve import closed_curve
from rotedu.ordinary_rotation import rotate, rotation_matrix, transform
from rotedu.orientation_curves import closed_rotation_curve
from rotedu.quaternions import Quaternion

AXIS, ANGLE = np.array([1.0, 2.0, 2.0]) / 3, 1.0
MATRIX = rotation_matrix(AXIS, ANGLE)
SIZES = (10**3, 10**4, 10**6, 10**7)


@pytest.fixture
def measure(benchmark: Any) -> Callable[..., None]:
    """Time a function that works on a number of points, in one thread."""

    def run(group: str, points: int, function: Callable[[], object], rounds: int = 0) -> None:
        benchmark.group = group
        benchmark.extra_info["points"] = points
        with threadpool_limits(1):
            if rounds:
                benchmark.pedantic(function, rounds=rounds)
            else:
                benchmark(function)

    return run


def turning(points: np.ndarray) -> dict[str, Callable[[], object]]:
    """Return ways to turn points: the limit, other packages, rotedu."""
    out = np.empty_like(points)
    transposed = np.ascontiguousarray(MATRIX.T)
    rotation = Rotation.from_matrix(MATRIX)
    q = quaternion.from_rotation_matrix(MATRIX)
    homogeneous = np.eye(4)
    homogeneous[:3, :3] = MATRIX
    with_ones = np.insert(points, 3, 1, axis=-1)
    return {
        "copy": lambda: np.copyto(out, points),
        "points @ M.T": lambda: points @ MATRIX.T,
        "np.matmul, out=": lambda: np.matmul(points, transposed, out=out),
        "scipy, Rotation.apply": lambda: rotation.apply(points),
        "numpy-quaternion, rotate_vectors": lambda: quaternion.rotate_vectors(q, points),
        "pytransform3d, transform": lambda: transformations.transform(
            homogeneous, with_ones, strict_check=False
        ),
        "rotate, Rodrigues' formula": lambda: rotate(points, AXIS, ANGLE),
        "transform": lambda: transform(MATRIX, points),
    }


@pytest.mark.parametrize("way", turning(np.zeros((1, 3))))
@pytest.mark.parametrize("n", SIZES)
def test_turning(measure: Callable[..., None], n: int, way: str) -> None:
    points = np.random.default_rng(n).normal(size=(n, 3))
    measure(f"turning, {n} points, one", n, turning(points)[way])


@pytest.mark.parametrize("way", ["matrix @ point", "scipy, Rotation.apply", "transform"])
def test_one_point(measure: Callable[..., None], way: str) -> None:
    point, rotation = np.array([1.0, 2.0, 3.0]), Rotation.from_matrix(MATRIX)
    ways = {
        "matrix @ point": lambda: MATRIX @ point,
        "scipy, Rotation.apply": lambda: rotation.apply(point),
        "transform": lambda: transform(MATRIX, point),
    }
    measure("one point", 1, ways[way])


def plain_matrix(m: list[list[float]], x: float, y: float, z: float) -> tuple[float, ...]:
    """Do (3-2), with 9 multiplications and 6 additions."""
    (a, b, c), (d, e, f), (g, h, i) = m
    return a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z


def plain_quaternion(q: list[float], x: float, y: float, z: float) -> tuple[float, ...]:
    """Do r + 2 v x (v x r + w r): 18 multiplications and 12 additions.

    Three of the multiplications are doublings, done as additions.
    """
    w, a, b, c = q
    u = b * z - c * y + w * x
    v = c * x - a * z + w * y
    t = a * y - b * x + w * z
    u, v, t = u + u, v + v, t + t
    return x + b * t - c * v, y + c * u - a * t, z + a * v - b * u


@pytest.mark.parametrize("way", ["matrix", "quaternion"])
def test_plain_python(measure: Callable[..., None], way: str) -> None:
    m, q = MATRIX.tolist(), quaternion.from_rotation_matrix(MATRIX).components.tolist()
    points = np.random.default_rng(0).normal(size=(1000, 3)).tolist()
    ways = {
        "matrix": lambda: [plain_matrix(m, *point) for point in points],
        "quaternion": lambda: [plain_quaternion(q, *point) for point in points],
    }
    measure("plain Python", 1000, ways[way])


def test_plain_python_turns_points() -> None:
    m, q = MATRIX.tolist(), quaternion.from_rotation_matrix(MATRIX).components.tolist()
    assert np.allclose(plain_matrix(m, 1, 2, 3), plain_quaternion(q, 1, 2, 3), atol=1e-14, rtol=0)


def on_the_sphere(n: int, dimension: int = 3) -> np.ndarray:
    """Return points of a wavy closed loop."""
    u = np.linspace(0, 2 * np.pi, n, endpoint=False)
    loop = np.stack([np.cos(u), np.sin(u), np.sin(3 * u) / 3, np.cos(2 * u) / 4], axis=-1)
    return loop[:, :dimension] / np.linalg.norm(loop[:, :dimension], axis=-1, keepdims=True)


def orientations(n: int) -> Rotation:
    """Return orientations of a closed motion."""
    u = np.linspace(0, 2 * np.pi, n, endpoint=False)
    return Rotation.from_rotvec(np.stack([np.cos(u), np.sin(2 * u), np.sin(u)], axis=-1))


def papers_loop(points: np.ndarray, samples: int) -> list[list[float]]:
    """Draw the curve by the corrected pseudocode of Section 5, in plain Python."""

    def dot(p: list[float], q: list[float]) -> float:
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]

    def slerp(p: list[float], q: list[float], t: float) -> list[float]:
        theta = math.acos(min(1.0, dot(p, q)))
        if theta == 0:
            return p
        sine = math.sin(theta)
        a, b = math.sin((1 - t) * theta) / sine, math.sin(t * theta) / sine
        return [a * p[0] + b * q[0], a * p[1] + b * q[1], a * p[2] + b * q[2]]

    def double(p: list[float], q: list[float]) -> list[float]:
        c = 2 * dot(p, q)
        return [c * q[0] - p[0], c * q[1] - p[1], c * q[2] - p[2]]

    p = points.tolist()
    n = len(p)
    a = [slerp(p[i], slerp(double(p[i - 1], p[i]), p[(i + 1) % n], 0.5), 0.5) for i in range(n)]
    b = [double(a[i], p[i]) for i in range(n)]
    curve = []
    for i in range(n):
        following = (i + 1) % n
        for j in range(samples):
            level = [p[i], a[i], b[following], p[following]]
            while len(level) > 1:
                level = [slerp(*pair, j / samples) for pair in pairwise(level)]
            curve.append(level[0])
    return curve


def test_the_loop_draws_the_curve() -> None:
    points = on_the_sphere(7)
    assert np.allclose(papers_loop(points, 9), closed_curve(points, 9), atol=1e-12, rtol=0)


def curves(n: int) -> dict[str, Callable[[], object]]:
    """Return ways to draw a closed curve of n segments with 100 samples each."""
    points, turns = on_the_sphere(n), orientations(n)
    matrices, t = turns.as_matrix(), np.arange(100 * n) / 100
    closed = Rotation.concatenate([turns, turns[:1]])
    units = [splines.quaternion.UnitQuaternion.from_unit_xyzw(q) for q in turns.as_quat()]
    q = turns.as_quat(canonical=True, scalar_first=True)
    return {
        "the paper's loop": lambda: papers_loop(points, 100),
        "splines, CatmullRom": lambda: splines.quaternion.CatmullRom(
            units, endconditions="closed"
        ).evaluate(t),
        "scipy, RotationSpline and apply": lambda: RotationSpline(np.arange(n + 1), closed)(
            t
        ).apply([1, 0, 0]),
        "scipy, RotationSpline": lambda: RotationSpline(np.arange(n + 1), closed)(t),
        "closed_rotation_curve": lambda: closed_rotation_curve(matrices, 100),
        "closed_curve of quaternions": lambda: closed_curve(q, 100),
        "closed_curve of quaternions, as matrices": lambda: matrices_of(closed_curve(q, 100)),
        "closed_curve": lambda: closed_curve(points, 100),
    }


def matrices_of(q: np.ndarray) -> np.ndarray:
    """Return the matrices of quaternions."""
    return Quaternion(q[..., 0], q[..., 1:]).matrix()


def test_curves_of_orientations_are_one() -> None:
    """Check that quaternions and matrices draw the same curve."""
    drawn = curves(500)
    by_matrices = drawn["closed_rotation_curve"]()
    by_quaternions = drawn["closed_curve of quaternions, as matrices"]()
    assert np.allclose(by_matrices, by_quaternions, atol=1e-12, rtol=0)


@pytest.mark.parametrize("way", curves(4))
def test_curves(measure: Callable[..., None], way: str) -> None:
    rounds = {"the paper's loop": 3, "splines, CatmullRom": 2}.get(way, 0)
    measure("closed curve, 500 segments", 50_000, curves(500)[way], rounds)


@pytest.mark.parametrize("n", [4, 50_000])
def test_curves_of_other_sizes(measure: Callable[..., None], n: int) -> None:
    points = on_the_sphere(n)
    measure(f"closed curve, {n} segments", 100 * n, lambda: closed_curve(points, 100))


def test_import(benchmark: Any) -> None:
    """Measure the milliseconds that rotedu's mathematics adds to the import of NumPy."""
    modules = "rotedu.quaternions, rotedu.general_rotation, rotedu.orientations, rotedu.cost"
    command = [sys.executable, "-X", "importtime", "-c", f"import numpy; import {modules}"]
    added = []
    for _ in range(5):
        report = subprocess.run(command, capture_output=True, text=True, check=True).stderr
        rows = [line.removeprefix("import time:").split("|") for line in report.splitlines()[1:]]
        numpy = next(i for i, row in enumerate(rows) if row[2].strip() == "numpy")
        added.append(sum(int(microseconds) for microseconds, *_ in rows[numpy + 1 :]) / 1000)
    benchmark.group = "import"
    benchmark.extra_info["milliseconds"] = min(added)
    benchmark.pedantic(lambda: None, rounds=1)
