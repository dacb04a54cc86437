"""The cases by which Node compares the mathematics of the models with rotedu's.

Every run writes others; `rotations.test.mjs` reads them. Set ROTATIONS_SEED to the seed in the
message of a failure to repeat them.
"""

import os
import secrets
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from node import run_cases
from oracles.averages import singular_values
from spheres import Array, random_units, with_inner_control_points

from rotedu.arcs import angle_between, arc_axis, nlerp, rotation_between, slerp
from rotedu.closed_curve import closed_curve, de_casteljau, de_casteljau_levels
from rotedu.control_points import bisect, control_points, double
from rotedu.errors import DegenerateError
from rotedu.general_rotation import euler_angles, matrix_from_euler_angles
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix, transform
from rotedu.orientation_curves import closed_rotation_curve, periodic_spline, squad
from rotedu.orientations import nearest_rotation, slerp_rotations
from rotedu.quaternions import Quaternion
from rotedu.rigid_motion import blend_dual_quaternions, blend_matrices

SEED = int(os.environ.get("ROTATIONS_SEED") or secrets.randbits(32))
DIMENSIONS = (2, 3, 4, 7)
TRIES = 8

pytestmark = pytest.mark.filterwarnings("ignore:.*are almost")


def of_components(q: Any) -> Quaternion:
    return Quaternion(q[0], q[1:])


def euler_matrix(u: float, v: float, w: float) -> Array:
    return matrix_from_euler_angles(u, v, w)[:3, :3]


def with_last_row(poses: Any) -> Array:
    return np.concatenate([poses, np.tile([[[0, 0, 0, 1]]], (len(poses), 1, 1))], axis=1)


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
    "deCasteljau": lambda control, places: [de_casteljau(control, u) for u in places],
    "closedCurve": closed_curve,
    "squad": squad,
    "periodicSpline": periodic_spline,
    "cross": np.cross,
    "arcAxis": arc_axis,
    "rotate": rotate,
    "rotationMatrix": rotation_matrix,
    "transform": transform,
    "axisAngle": lambda m: dict(zip(("axis", "angle"), axis_angle(m), strict=True)),
    "turnBetween": lambda a, b: dict(zip(("axis", "angle"), axis_angle(a.T @ b), strict=True)),
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
    "rotationBetween": rotation_between,
    "blendMatrices": lambda m, *given: blend_matrices(with_last_row(m), *given)[:3],
    "blendDualQuaternions": lambda m, w: blend_dual_quaternions(with_last_row(m), w)[:3],
    "rotateByQuaternion": lambda q, point: of_components(q).rotate(point),
}
# Where moving the arguments a little may move the result a lot.
SENSITIVE = "slerp nlerp bisect arcAxis rotationBetween deCasteljau deCasteljauLevels"
SENSITIVE += " controlPoints closedCurve squad closedRotationCurve nearestRotation"


@dataclass
class Case:
    """A call, the difference allowed, and which function of its result counts."""

    name: str
    args: list[Any]
    allowed: float = 1e-12
    seen: str = ""


def calls(names: str, *several: list[Any]) -> Iterator[Case]:
    """Call each function with each list of arguments."""
    return (Case(name, args) for name in names.split() for args in several)


# What is drawn at random.


def of_any_length(rng: np.random.Generator, points: Any) -> Array:
    points = np.array(points)
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
        yield of_any_length(rng, [p, partner(rng, p, gap)])


def polygons(rng: np.random.Generator, d: int) -> Iterator[Array]:
    """Closed polygons: any, turning right back, with close or opposite or repeated neighbours."""
    for gap in gaps(rng):
        p, q, *rest = random_units(rng.integers(3, 9), d, rng=rng)
        yield of_any_length(rng, [p, q, *rest])
        yield of_any_length(rng, [p, q, partner(rng, double(p, q), gap), *rest])
        yield of_any_length(rng, [p, q, partner(rng, p, gap), *rest])
        yield of_any_length(rng, [p, partner(rng, p, gap), *rest])
        yield np.array([p, p, *rest])


def rotation_matrices(rng: np.random.Generator) -> Iterator[tuple[Array, float]]:
    """Rotation matrices, exact, worn or rounded, by ordinary, tiny and almost straight angles."""
    for angle in (*gaps(rng), np.pi - 10 ** rng.uniform(-11, -7), np.pi):
        worn = 1 + 1e-9 * rng.normal(size=(3, 3))
        yield rotation_matrix(rng.normal(size=3), angle), angle
        yield rotation_matrix(rng.normal(size=3), angle) * worn, angle
    angle = rng.uniform(0.1, 3)
    yield rotation_matrix(rng.normal(size=3), angle).round(rng.integers(4, 8)), angle


# The cases.


def in_any_dimension(rng: np.random.Generator, d: int) -> Iterator[Case]:
    s, t = rng.uniform(-1, 2, 2)
    v, w = rng.normal(size=(2, d))
    yield Case("dot", [v, w])
    yield Case("length", [v])
    yield Case("combine", [s, v, t, w])
    yield Case("unit", [v * 10 ** rng.uniform(-300, 300)])
    for p, q in pairs(rng, d):
        yield from calls("angleBetween double bisect", [p, q])
        yield from calls("slerp nlerp", [p, q, t])
        # Nothing excuses a point that leaves the sphere.
        yield Case("slerp", [p, q, t], seen="length")
        control = np.array([p, q, *random_units(rng.integers(0, 4), d, rng=rng)])
        within = rng.uniform(0, 1)
        yield from calls("deCasteljauLevels", [control, s], [control, within])
        yield Case("deCasteljau", [control, [s, within]])
    points = random_units(3, d, rng=rng)
    yield from calls("controlPoints closedCurve", [points])
    yield from calls("controlPoints", [points, 0], [points, 1])
    for points in polygons(rng, d):
        fraction, samples = rng.uniform(0.2, 0.5), int(rng.integers(1, 9))
        yield Case("controlPoints", [points, fraction])
        yield Case("closedCurve", [points, samples, fraction])
        yield Case("squad", [points, samples])
        yield Case("periodicSpline", [points / abs(points).max(), samples])


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
    yield from calls("arcAxis rotationBetween", *map(list, pairs(rng, 3)))
    turns = rotation_matrix(rng.normal(size=(3, 3)), rng.uniform(0, 1.4, 3))
    poses = np.concatenate([turns, rng.normal(size=(3, 3, 1))], axis=2)
    shares = rng.uniform(0, 1, 3)
    yield from calls("blendMatrices blendDualQuaternions", [poses, shares], [poses[:2], [1, 0]])
    yield Case("blendMatrices", [poses, shares, True])
    yield from calls("axisAngle", *([scale * np.eye(3)] for scale in (1, 1 + 1.4e-8, 1 + 4.9e-4)))
    # What rounding leaves of a component does not choose between the axes of half a turn.
    yield Case("axisAngle", [[[-1, -1e-17, 0], [-1e-17, 1, 0], [0, 0, -1]]])
    for m, angle in rotation_matrices(rng):
        # The axis of a tiny turn is uncertain.
        yield Case("axisAngle", [m], allowed=1e-12 / np.sin(min(angle, np.pi / 2)))
        yield Case("quaternionFromMatrix", [m])
        yield Case("slerpRotations", [a := rotation_matrix(axis, t), a @ m, t])
    start = rotation_matrix(axis, angle)
    yield from calls("turnBetween", *([start, start @ rotation_matrix(v, t)] for t in (0.01, 1, 3)))
    for scale in (0.3, 1):
        sizes = scale * rng.normal(size=rng.integers(3, 9))
        given = rotation_matrix(rng.normal(size=(len(sizes), 3)), sizes)
        fraction, samples = rng.uniform(0.2, 0.5), int(rng.integers(1, 9))
        yield from calls("closedRotationCurve", [given], [given, samples, fraction])
    yield Case("closedRotationCurve", [np.stack([m, m, m]), 3])
    for m in (a, b, -a, 1e-200 * a, rotation_matrix(v, angle), np.diag([3, 2, -1])):
        yield from calls("nearestRotation singularValues", [m])
    for v in (rng.uniform(-1.5, 1.5), *np.pi / 2 * np.array([1, -1, 1 - 1e-9, 1e-6 - 1])):
        u, w = rng.uniform(-3, 3, 2)
        yield Case("matrixFromEulerAngles", [u, v, w])
        yield Case("eulerAngles", [m := euler_matrix(u, v, w)], seen="matrixFromEulerAngles")
        # Near gimbal lock rounding changes two of the angles; there, w is 0.
        if np.cos(v) < 1e-15 or abs(v) < 1.5:
            yield Case("eulerAngles", [m])
    p, q = rng.normal(size=(2, 4))
    yield Case("quaternionFromAxisAngle", [axis, angle])
    yield Case("quaternionProduct", [p, q])
    yield from calls("conjugate quaternionMatrix", [q])
    yield Case("rotateByQuaternion", [q, v * axis])


def without_answer(rng: np.random.Generator) -> Iterator[Case]:
    """Calls that both sides refuse, because of their geometry."""
    p, r = random_units(2, 3, rng=rng)
    q = partner(rng, p, np.pi / 2)
    m = rotation_matrix(r, rng.uniform(-3, 3))
    for opposite in (-p, partner(rng, p, np.pi - 1e-9)):
        yield from calls("slerp nlerp", [p, opposite, 0.5])
        yield from calls("bisect arcAxis rotationBetween", [p, opposite])
    yield Case("arcAxis", [p, 3 * p])
    half = np.stack([np.eye(3, 4), np.eye(3, 4) * [[1], [-1], [-1]]])
    yield Case("blendDualQuaternions", [half, [1, 1]])
    yield Case("blendMatrices", [half, [1, 1], True])
    yield Case("slerpRotations", [m, m @ rotation_matrix(p, np.pi), 0.5])
    for control, u in ([r, q, p, -p], 0.5), ([p, q, q], -1):
        yield Case("deCasteljauLevels", [control, u])
        yield Case("deCasteljau", [control, [u]])
    back = [p, q, -double(p, q), r], [p, partner(rng, p, rng.uniform(1.7, 3)), p, r]
    yield from calls("controlPoints", *([points] for points in back))
    for start in range(4):
        for points in (*back, with_inner_control_points(0) @ m.T):
            yield Case("closedCurve", [np.roll(points, start, axis=0), 2])
        yield Case("squad", [np.roll([q, p, -p, r], start, axis=0)])
        for degrees in ([0, 120, 130, 10], [0, 170, 0, 170]):
            x = np.radians(np.roll(degrees, start))
            yield Case("squad", [np.stack([np.cos(x), np.sin(x)], axis=-1), 2])
        for angles in ([0, np.pi, 1, 2], [0, np.pi - 1e-9, 0, 0.1]):
            given = m @ rotation_matrix(p, np.roll(angles, start))
            yield Case("closedRotationCurve", [given, 2])
    flat = (0, 0, 0), (1, 0, 0), (-1, -1, -1), (3, 1, -1), (1, 1e-9, 0), (3, 1, 1e-9 - 1)
    for singular in flat:
        yield Case("nearestRotation", [m @ np.diag(singular) @ rotation_matrix(q, 1)])


def without_direction(rng: np.random.Generator) -> Iterator[Case]:
    """Calls that both sides refuse: a direction of length 0 or infinity, or no rotation."""
    p, q = random_units(2, 3, rng=rng)
    m = rotation_matrix(p, 1)
    for bad in (np.zeros(3), np.array([np.inf, 1, 0]), np.array([0, np.nan, 1])):
        yield from calls("slerp nlerp", [p, bad, 0.5], [bad, p, 0.5])
        yield from calls("angleBetween arcAxis bisect double", [p, bad], [bad, p])
        yield Case("deCasteljauLevels", [[p, bad], 0.5])
        yield Case("deCasteljau", [[p, bad], [0.5]])
        yield from calls("controlPoints closedCurve squad", [[p, q, bad]])
        yield from calls("rotationMatrix quaternionFromAxisAngle", [bad, 1])
        yield Case("unit", [bad])
        yield Case("rotate", [p, bad, 1])
        yield Case("quaternionMatrix", [[0, *bad]])
        yield Case("rotateByQuaternion", [[0, *bad], p])
    for bad in ((1 + 5.1e-4) * m, -m, np.nan * m, np.zeros((3, 3))):
        yield from calls("axisAngle eulerAngles quaternionFromMatrix", [bad])
        yield from calls("slerpRotations", [m, bad, 0.5], [bad, m, 0.5])
        yield Case("closedRotationCurve", [[m, bad, m]])


def numbers(value: Any) -> Array:
    """All numbers of a result."""
    parts = value.values() if isinstance(value, dict) else value
    return np.concatenate([np.ravel(part) for part in parts])


def condition(case: Case, value: Any) -> float:
    """How many times as far as the arguments the result moves, if it moves farther."""
    rng, step = np.random.default_rng(1), 1e-10

    def moved(x: Any) -> Any:
        return x if isinstance(x, int) else x * (1 + step * rng.normal(size=np.shape(x)))

    try:
        others = [PYTHON[case.name](*map(moved, case.args)) for _ in range(3)]
    except DegenerateError:
        return 1.0
    found = [np.abs(numbers(other) - numbers(value)).max() / step for other in others]
    return float(max(1, *found))


def in_python(case: Case) -> dict[str, Any]:
    """What Python answers: a value, with the difference allowed, or a refusal."""
    try:
        value = PYTHON[case.name](*case.args)
    except DegenerateError as error:
        return {"error": "DegenerateError", "message": str(error)}
    except ValueError:
        # The words differ: here they speak of arrays.
        return {"error": "RangeError"}
    allowed = case.allowed
    if case.seen:
        value = PYTHON[case.seen](*([value] if case.seen == "length" else value))
    elif case.name in SENSITIVE.split():
        allowed *= condition(case, value)
    return {"value": value, "seen": case.seen, "allowed": allowed}


def answered(cases: Iterable[Case]) -> list[dict[str, Any]]:
    return [{"name": case.name, "args": case.args} | in_python(case) for case in cases]


def test_node_computes_and_refuses_what_python_does() -> None:
    rng = np.random.default_rng(SEED)
    computed: list[dict[str, Any]] = []
    for _ in range(TRIES):
        for d in DIMENSIONS:
            computed += answered(in_any_dimension(rng, d))
        computed += answered(in_three_dimensions(rng))
    degenerate, bad = answered(without_answer(rng)), answered(without_direction(rng))
    assert {case["name"] for case in computed if "value" in case} == set(PYTHON)
    assert {case.get("error") for case in degenerate} == {"DegenerateError"}
    assert {case.get("error") for case in bad} == {"RangeError"}
    run_cases("rotations", {"seed": SEED, "cases": computed + degenerate + bad})
