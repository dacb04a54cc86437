"""The cases by which Node compares the mathematics of the models with rotedu's.

Every run writes others; `rotations.test.mjs` reads them. Set ROTATIONS_SEED to the seed in the
message of a failure to repeat them.
"""

import os
import secrets
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from node import run_cases
from oracles.averages import singular_values
from spheres import random_units

from rotedu.arcs import angle_between, arc_axis, nlerp, slerp
from rotedu.closed_curve import closed_curve, de_casteljau, de_casteljau_levels
from rotedu.control_points import bisect, control_points, double
from rotedu.errors import DegenerateError
from rotedu.general_rotation import euler_angles, matrix_from_euler_angles
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix, transform
from rotedu.orientations import (
    closed_rotation_curve,
    nearest_rotation,
    one_turn,
    periodic_spline,
    slerp_rotations,
    squad,
)
from rotedu.quaternions import Quaternion

Array = np.ndarray[Any, Any]

SEED = int(os.environ.get("ROTATIONS_SEED") or secrets.randbits(32))
DIMENSIONS = (2, 3, 4, 7)
TRIES = 8

pytestmark = pytest.mark.filterwarnings("ignore:.*are almost")


def of_components(q: Any) -> Quaternion:
    return Quaternion(q[0], q[1:])


def euler_matrix(u: float, v: float, w: float) -> Array:
    return matrix_from_euler_angles(u, v, w)[:3, :3]


PYTHON: dict[str, Callable[..., Any]] = {
    "dot": np.dot,
    "length": np.linalg.norm,
    "combine": lambda s, a, t, b: s * np.array(a) + t * np.array(b),
    "unit": lambda v: slerp(v, v, 0),
    "angleBetween": angle_between,
    "slerp": slerp,
    "nlerp": nlerp,
    "double": double,
    "bisect": bisect,
    "controlPoints": lambda *given: dict(zip("ab", control_points(*given), strict=True)),
    "deCasteljauLevels": de_casteljau_levels,
    "deCasteljau": de_casteljau,
    "closedCurve": closed_curve,
    "squad": squad,
    "periodicSpline": periodic_spline,
    "cross": np.cross,
    "arcAxis": arc_axis,
    "rotate": rotate,
    "rotationMatrix": rotation_matrix,
    "transform": transform,
    "axisAngle": lambda m: dict(zip(("axis", "angle"), axis_angle(m), strict=True)),
    "product": np.matmul,
    "transpose": np.transpose,
    "slerpRotations": slerp_rotations,
    "closedRotationCurve": closed_rotation_curve,
    "nearestRotation": nearest_rotation,
    "singularValues": singular_values,
    "matrixFromEulerAngles": euler_matrix,
    "eulerAngles": euler_angles,
    "quaternionFromAxisAngle": lambda *given: Quaternion.from_axis_angle(*given).components,
    "quaternionProduct": lambda p, q: (of_components(p) * of_components(q)).components,
    "conjugate": lambda q: of_components(q).conjugate().components,
    "quaternionMatrix": lambda q: of_components(q).matrix(),
    "quaternionFromMatrix": lambda m: Quaternion.from_matrix(m).components,
    "rotateByQuaternion": lambda q, point: of_components(q).rotate(point),
}


@dataclass
class Case:
    """A call, the angles of the arcs it takes, and which function of its result counts."""

    name: str
    args: list[Any]
    angles: Any = 0.0
    seen: str = ""


def allowed(angles: Any) -> float:
    """The difference allowed: 1e-12 times the condition of the widest arc.

    Moving the ends of an arc by e moves the arc by e / sin(pi - theta) if theta is near pi.
    """
    return float(1e-12 / np.sin(min(np.pi - np.max(angles), np.pi / 2)))


# What is drawn at random.


def of_any_length(rng: np.random.Generator, points: Array) -> Array:
    return points * 10 ** rng.uniform(-3, 3, (*points.shape[:-1], 1))


def partner(rng: np.random.Generator, p: Array, theta: float) -> Array:
    """A unit vector at this angle from p."""
    other = rng.normal(size=p.shape)
    other -= other @ p * p
    return np.cos(theta) * p + np.sin(theta) * other / np.linalg.norm(other)


def gaps(rng: np.random.Generator) -> tuple[float, ...]:
    """Angles of three kinds: ordinary, tiny, almost pi."""
    return rng.uniform(0.1, 3), 10 ** rng.uniform(-9, -3), np.pi - 10 ** rng.uniform(-6, -3)


def pairs(rng: np.random.Generator, d: int) -> Iterator[Array]:
    for gap in gaps(rng):
        p = random_units(d, rng=rng)
        yield of_any_length(rng, np.array([p, partner(rng, p, gap)]))


def polygons(rng: np.random.Generator, d: int) -> Iterator[Array]:
    """Closed polygons: any, turning right back, with close or opposite or repeated neighbours."""
    for gap in gaps(rng):
        p, q, *rest = random_units(rng.integers(3, 9), d, rng=rng)
        yield of_any_length(rng, np.array([p, q, *rest]))
        yield of_any_length(rng, np.array([p, q, partner(rng, double(p, q), gap), *rest]))
        yield of_any_length(rng, np.array([p, q, partner(rng, p, gap), *rest]))
        yield of_any_length(rng, np.array([p, partner(rng, p, gap), *rest]))
        yield np.array([p, p, *rest])


def rotation_matrices(rng: np.random.Generator) -> Iterator[tuple[Array, float]]:
    """Rotation matrices, exact, worn or rounded, by ordinary, tiny and almost straight angles."""
    for angle in (*gaps(rng), np.pi - 10 ** rng.uniform(-11, -7), np.pi):
        worn = 1 + 1e-9 * rng.normal(size=(3, 3))
        yield rotation_matrix(rng.normal(size=3), angle), angle
        yield rotation_matrix(rng.normal(size=3), angle) * worn, angle
    angle = rng.uniform(0.1, 3)
    yield rotation_matrix(rng.normal(size=3), angle).round(rng.integers(4, 8)), angle


def arcs_of_closed_curve(points: Array, fraction: float) -> list[Array]:
    """The angles of all arcs between points, reflected points and control points."""
    before, after = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
    reflected = double(before, points)
    middle = bisect(reflected, after)
    a, b = control_points(points, fraction)
    ends = (reflected, after), (points, middle), (a, np.roll(b, -1, axis=0))
    return [angle_between(p, q) for p, q in ends]


def arcs_of_squad(points: Array) -> list[Any]:
    """The angles of all arcs between neighbours and between the points s."""
    q = points / np.linalg.norm(points, axis=-1, keepdims=True)
    before, after = np.roll(q, 1, axis=0), np.roll(q, -1, axis=0)
    tangent = -sum(log(q, other) for other in (after, before)) / 4
    size = np.linalg.norm(tangent, axis=-1, keepdims=True)
    s = np.cos(size) * q + np.sinc(size / np.pi) * tangent
    return [angle_between(p, np.roll(p, -1, axis=0)) for p in (q, s)]


def log(p: Array, q: Array) -> Array:
    """The tangent vectors that lead from p to q."""
    angle = angle_between(p, q)[:, np.newaxis]
    return np.asarray((q - np.cos(angle) * p) / np.sinc(angle / np.pi))


def halves_of_turns(rotations: Array) -> Array:
    """Half of each turn from Double(R_{i-1}, R_i) to R_{i+1}."""
    axis, angle = axis_angle(rotations.swapaxes(-1, -2) @ np.roll(rotations, -1, axis=0))
    turn = (angle[:, np.newaxis] * axis).T
    return np.asarray(np.linalg.norm(one_turn(-np.roll(turn, 1, axis=-1), turn), axis=0) / 2)


def arcs_of_levels(control: Array, u: float) -> list[float]:
    levels = de_casteljau_levels(control, u)[:-1]
    return [angle_between(p, q) for level in levels for p, q in pairwise(level)]


# The cases.


def in_any_dimension(rng: np.random.Generator, d: int) -> Iterator[Case]:
    s, t = rng.uniform(-1, 2, 2)
    v, w = rng.normal(size=(2, d))
    yield Case("dot", [v, w])
    yield Case("length", [v])
    yield Case("combine", [s, v, t, w])
    yield Case("unit", [v * 10 ** rng.uniform(-300, 300)])
    for p, q in pairs(rng, d):
        theta = angle_between(p, q)
        yield Case("angleBetween", [p, q])
        yield Case("slerp", [p, q, t], theta)
        # No condition excuses a point that leaves the sphere.
        yield Case("slerp", [p, q, t], seen="length")
        yield Case("nlerp", [p, q, t], theta)
        yield Case("double", [p, q])
        yield Case("bisect", [p, q], theta)
        control = np.array([p, q, *random_units(rng.integers(0, 4), d, rng=rng)])
        for u in (s, rng.uniform(0, 1)):
            angles = arcs_of_levels(control, u)
            yield Case("deCasteljauLevels", [control, u], angles)
            yield Case("deCasteljau", [control, u], angles)
    points = random_units(3, d, rng=rng)
    for name in ("controlPoints", "closedCurve"):
        yield Case(name, [points], arcs_of_closed_curve(points, 0.5))
    for fraction in (0, 1):
        yield Case("controlPoints", [points, fraction], arcs_of_closed_curve(points, fraction))
    for points in polygons(rng, d):
        fraction = rng.uniform(0.2, 0.5)
        try:
            angles = arcs_of_closed_curve(points, fraction)
        except DegenerateError:
            angles = [0.0]
        yield Case("controlPoints", [points, fraction], angles)
        yield Case("closedCurve", [points, int(rng.integers(1, 9)), fraction], angles)
        yield Case("squad", [points, int(rng.integers(1, 9))], arcs_of_squad(points))
        yield Case("periodicSpline", [points / abs(points).max(), int(rng.integers(1, 9))])


def in_three_dimensions(rng: np.random.Generator) -> Iterator[Case]:
    v, w, axis = rng.normal(size=(3, 3))
    a, b = rng.normal(size=(2, 3, 3))
    angle, t = rng.uniform(-7, 7), rng.uniform(-1, 2)
    yield Case("cross", [v, w])
    yield Case("rotate", [v, axis, angle])
    yield Case("rotationMatrix", [axis, angle])
    yield Case("transform", [a, v])
    yield Case("product", [a, b])
    yield Case("transpose", [a])
    for p, q in pairs(rng, 3):
        theta = angle_between(p, q)
        yield Case("arcAxis", [p, q], max(theta, np.pi - theta))
    for scale in (1, 1 + 1.4e-8, 1 + 4.9e-4):
        yield Case("axisAngle", [scale * np.eye(3)])
    # What rounding leaves of a component does not choose between the axes of half a turn.
    yield Case("axisAngle", [[[-1, -1e-17, 0], [-1e-17, 1, 0], [0, 0, -1]]])
    for m, angle in rotation_matrices(rng):
        yield Case("axisAngle", [m], np.pi - angle)
        yield Case("quaternionFromMatrix", [m])
        yield Case("slerpRotations", [a := rotation_matrix(axis, t), a @ m, t])
    for scale in (0.3, 1):
        sizes = scale * rng.normal(size=rng.integers(3, 9))
        given = rotation_matrix(rng.normal(size=(len(sizes), 3)), sizes)
        fraction, samples = rng.uniform(0.2, 0.5), int(rng.integers(1, 9))
        angles = halves_of_turns(given)
        yield Case("closedRotationCurve", [given, samples, fraction], angles)
    yield Case("closedRotationCurve", [np.stack([m, m, m]), 3])
    for m in (a, b, -a, 1e-200 * a, rotation_matrix(v, angle), np.diag([3, 2, -1])):
        large, middle, small = np.linalg.svd(m)[1]
        gap = (middle + np.sign(np.linalg.det(m / large)) * small) / large
        yield Case("nearestRotation", [m], np.pi - np.arcsin(min(1, gap)))
        yield Case("singularValues", [m])
    for v in (rng.uniform(-1.5, 1.5), *np.pi / 2 * np.array([1, -1, 1 - 1e-9, 1e-6 - 1])):
        u, w = rng.uniform(-3, 3, 2)
        yield Case("matrixFromEulerAngles", [u, v, w])
        yield Case("eulerAngles", [m := euler_matrix(u, v, w)], seen="matrixFromEulerAngles")
        # Near gimbal lock rounding changes two of the angles; there, w is 0.
        if np.cos(v) < 1e-15 or abs(v) < 1.5:
            yield Case("eulerAngles", [m])


def with_quaternions(rng: np.random.Generator) -> Iterator[Case]:
    p, q = rng.normal(size=(2, 4))
    yield Case("quaternionFromAxisAngle", [rng.normal(size=3), rng.uniform(-7, 7)])
    yield Case("quaternionProduct", [p, q])
    yield Case("conjugate", [q])
    yield Case("quaternionMatrix", [q])
    yield Case("rotateByQuaternion", [q, rng.normal(size=3)])


def opposite_handles() -> Array:
    """Points for which a_0 and b_1 are opposite: half a turn exchanges them."""
    half_turn = np.array([-1, -1, 1])
    p0 = np.array([0.4, 0.8, 0.2**0.5])
    p1 = half_turn * p0
    p3 = double(double(p1, double(p0, np.array([1, 0, 0]))), p0)
    return np.array([p0, p1, half_turn * p3, p3])


def without_answer(rng: np.random.Generator) -> Iterator[Case]:
    """Calls that both sides refuse, because of their geometry."""
    p, r = random_units(2, 3, rng=rng)
    q = partner(rng, p, np.pi / 2)
    m, half = rotation_matrix(r, rng.uniform(-3, 3)), 0.5
    for opposite in (-p, partner(rng, p, np.pi - 1e-9)):
        for name in ("slerp", "nlerp"):
            yield Case(name, [p, opposite, half])
        for name in ("bisect", "arcAxis"):
            yield Case(name, [p, opposite])
    yield Case("arcAxis", [p, 3 * p])
    yield Case("slerpRotations", [m, m @ rotation_matrix(p, np.pi), half])
    for name in ("deCasteljau", "deCasteljauLevels"):
        yield Case(name, [[r, q, p, -p], half])
        yield Case(name, [[p, q, q], -1])
    far = partner(rng, p, rng.uniform(1.7, 3))
    for start in range(4):
        for points in ([p, q, -double(p, q), r], [p, far, p, r], opposite_handles() @ m.T):
            yield Case("closedCurve", [np.roll(points, start, axis=0), 2])
    for points in ([p, q, -double(p, q), r], [p, far, p, r]):
        yield Case("controlPoints", [points])
    for start in range(4):
        yield Case("squad", [np.roll([q, p, -p, r], start, axis=0)])
        for degrees in ([0, 120, 130, 10], [0, 170, 0, 170]):
            x = np.radians(np.roll(degrees, start))
            yield Case("squad", [np.stack([np.cos(x), np.sin(x)], axis=-1), 2])
        for angles in ([0, np.pi, 1, 2], [0, np.pi - 1e-9, 0, 0.1]):
            given = m @ rotation_matrix(p, np.roll(angles, start))
            yield Case("closedRotationCurve", [given, 2])
    flat = (np.zeros((3, 3)), np.diag([1, 0, 0]), -np.eye(3), np.diag([3, 1, -1]))
    for bad in (*flat, np.diag([1, 1e-9, 0]), np.diag([3, 1, 1e-9 - 1])):
        yield Case("nearestRotation", [m @ bad @ rotation_matrix(q, 1)])


def with_bad_numbers(rng: np.random.Generator) -> Iterator[Case]:
    """Calls that both sides refuse, because of their numbers."""
    p, q, r = random_units(3, 3, rng=rng)
    m = rotation_matrix(p, 1)
    no_directions = np.zeros(3), np.array([0, np.nan, 1]), np.array([np.inf, 1, 0])
    no_numbers = np.nan, -np.inf
    no_rotations = (1 + 5.1e-4) * m, -m, np.nan * m, np.zeros((3, 3))
    for bad in no_directions:
        for name, rest in (("slerp", [0.5]), ("nlerp", [0.5])):
            yield Case(name, [p, bad, *rest])
            yield Case(name, [bad, p, *rest])
        for name in ("angleBetween", "arcAxis", "bisect", "double"):
            yield Case(name, [p, bad])
            yield Case(name, [bad, p])
        for name in ("deCasteljau", "deCasteljauLevels"):
            yield Case(name, [[p, bad], 0.5])
        yield Case("unit", [bad])
        yield Case("controlPoints", [[p, q, bad]])
        yield Case("closedCurve", [[p, q, bad]])
        yield Case("squad", [[p, q, bad]])
        yield Case("rotate", [p, bad, 1])
        yield Case("rotationMatrix", [bad, 1])
        yield Case("quaternionFromAxisAngle", [bad, 1])
        yield Case("quaternionMatrix", [[0, *bad]])
        yield Case("rotateByQuaternion", [[0, *bad], p])
    for bad in no_directions[1:]:
        yield Case("rotate", [bad, p, 1])
        yield Case("transform", [m, bad])
        yield Case("periodicSpline", [[p, q, bad]])
        yield Case("nearestRotation", [[p, q, bad]])
        yield Case("rotateByQuaternion", [[1, *p], bad])
        yield Case("conjugate", [[1, *bad]])
        yield Case("quaternionProduct", [[1, *p], [1, *bad]])
    for bad in no_numbers:
        yield Case("slerp", [p, q, bad])
        yield Case("nlerp", [p, q, bad])
        yield Case("rotate", [p, q, bad])
        yield Case("rotationMatrix", [p, bad])
        yield Case("quaternionFromAxisAngle", [p, bad])
        yield Case("matrixFromEulerAngles", [0, bad, 0])
        yield Case("deCasteljau", [[p, q], bad])
        yield Case("slerpRotations", [m, m, bad])
    for bad in no_rotations:
        for name in ("axisAngle", "eulerAngles", "quaternionFromMatrix"):
            yield Case(name, [bad])
        yield Case("slerpRotations", [m, bad, 0.5])
        yield Case("slerpRotations", [bad, m, 0.5])
        yield Case("closedRotationCurve", [[m, bad, m]])
    for fraction in (-0.1, 1.1, np.nan):
        yield Case("controlPoints", [[p, q, r], fraction])
        yield Case("closedCurve", [[p, q, r], 2, fraction])
        yield Case("closedRotationCurve", [[m, m, m], 2, fraction])
    for samples in (0, -1, 1.5):
        for name in ("closedCurve", "squad", "periodicSpline"):
            yield Case(name, [[p, q, r], samples])
        yield Case("closedRotationCurve", [[m, m, m], samples])
    yield Case("closedRotationCurve", [[m, m]])
    for name in ("closedCurve", "squad", "periodicSpline"):
        yield Case(name, [[p, q]])
    yield Case("controlPoints", [[p, q]])
    yield Case("deCasteljau", [np.empty((0, 3)), 0.5])
    yield Case("slerp", [p, p[:2], 0.5])


def in_python(case: Case) -> dict[str, Any]:
    """What Python answers: a value, with the difference allowed, or a refusal."""
    try:
        value = PYTHON[case.name](*case.args)
    except DegenerateError as error:
        return {"error": "DegenerateError", "message": str(error)}
    except ValueError:
        # The words differ: here they speak of arrays.
        return {"error": "RangeError"}
    if case.seen == "length":
        value = np.linalg.norm(value)
    elif case.seen:
        value = PYTHON[case.seen](*value)
    return {"value": value, "seen": case.seen, "allowed": allowed(case.angles)}


def answered(cases: Iterable[Case]) -> list[dict[str, Any]]:
    return [{"name": case.name, "args": case.args} | in_python(case) for case in cases]


def test_node_computes_and_refuses_what_python_does() -> None:
    rng = np.random.default_rng(SEED)
    computed: list[dict[str, Any]] = []
    for _ in range(TRIES):
        for d in DIMENSIONS:
            computed += answered(in_any_dimension(rng, d))
        computed += answered([*in_three_dimensions(rng), *with_quaternions(rng)])
    degenerate, bad = answered(without_answer(rng)), answered(with_bad_numbers(rng))
    assert {case["name"] for case in computed if "value" in case} == set(PYTHON)
    assert {case.get("error") for case in degenerate} == {"DegenerateError"}
    assert {case.get("error") for case in bad} == {"RangeError"}
    run_cases("rotations", {"seed": SEED, "cases": computed + degenerate + bad})
