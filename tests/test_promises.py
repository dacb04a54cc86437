"""What other libraries promise of rotations, in their tests and docstrings, asked of rotedu.

Each case asks SciPy, pytransform3d, splines or numpy-quaternion itself, or has the numbers of one
of its tests. Its id names the library and its test or function. The code is ours, and so is random
input. SciPy's quaternions have their scalar moved to the front, its fixed axes x, y and z are U, V
and W, and its degrees become radians.
"""

from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np
import pytest
from pytransform3d import rotations as pr
from scipy.interpolate import CubicSpline
from scipy.spatial import geometric_slerp
from scipy.spatial.transform import Rotation, RotationSpline, Slerp
from spheres import E1, E3, Array, close
from splines import quaternion as sq

from rotedu.arcs import angle_between, slerp
from rotedu.averages import angular_distance as distance
from rotedu.averages import mean_rotation as mean
from rotedu.closed_curve import de_casteljau
from rotedu.five_numbers import matrix_from_two_columns as columns
from rotedu.general_rotation import compose, euler_angles, rotation_u, rotation_v, rotation_w
from rotedu.general_rotation import quaternion_from_euler_angles as from_euler
from rotedu.motion import angular_velocity, integrate
from rotedu.motion import matrix_from_rotation_vector as exp
from rotedu.motion import rotation_vector as log
from rotedu.orientation_curves import closed_rotation_curve as curve
from rotedu.orientation_curves import periodic_spline, squad
from rotedu.orientations import nearest_rotation, slerp_rotations
from rotedu.quaternions import Quaternion


def case(name: str, *values: Any) -> Any:
    return pytest.param(*values, id=name)


def of(components: Any) -> Quaternion:
    """One quaternion or many from components, scalar first."""
    w, v = np.split(np.asarray(components), [1], axis=-1)
    return Quaternion(w[..., 0], v)


def back(matrix: Any) -> Array:
    return Quaternion.from_matrix(matrix).components


def unit(v: Any) -> Array:
    return np.asarray(v / np.linalg.norm(v, axis=-1, keepdims=True))


def wxyz(quaternions: Any) -> Array:
    return np.array([q.wxyz for q in quaternions])


def turn(axes: str, *degrees: float) -> Array:
    """Turn about fixed axes, x y z, or about axes that turn along, X Y Z, as SciPy writes it."""
    principal = {"x": rotation_u, "y": rotation_v, "z": rotation_w}
    turns = [principal[a](np.radians(d)) for a, d in zip(axes.lower(), degrees, strict=True)]
    return compose(*(turns if axes.isupper() else turns[::-1]))[:3, :3]


def power(matrix: Any, t: Any) -> Array:
    return slerp_rotations(ONE, matrix, t)


ONE, RNG, T = np.eye(3), np.random.default_rng(7), np.linspace(-0.5, 1.5, 9)
P, Q, S = (Rotation.random(10, rng=np.random.default_rng(seed)) for seed in (1, 2, 3))
PM, QM, SM = P.as_matrix(), Q.as_matrix(), S.as_matrix()
SINGLE, DOUBLE = PM.astype(np.float32), PM.astype(np.float32).astype(float)
ROUNDED = np.concatenate([PM.round(4), PM.round(5), PM.round(6), PM.round(7)])
WORN, RATES = PM + RNG.normal(scale=0.2, size=PM.shape), RNG.normal(size=(6, 3))
EULER, BEYOND = RNG.uniform(-1, 1, (1000, 3)) * np.pi * [1, 1 / 2, 1], [0.3, 2, -0.4]
TURNED = Rotation.from_euler("ZYX", EULER[:, ::-1]).as_matrix()
SCALES, ONES = np.linspace(0, np.pi / 2, 100)[:, None, None], np.ones((10, 3))
VECTORS, FAR = [[0, 0, 0], [1, -1, 2], [-3e-4, 3.5e-4, 7.5e-5]], [[1, 1e-9, 0], [-1, 1e-9, 0]]
UV, HARDLY = ([1, 2, 3], [3, -1, 1]), ([1, 0, 0, 0], [1, 1e-12, 0, 0])
A, B = [1, 2, 3, 4], [5, 6, 7, 8]
# Quaternions whose neighbours, also the last and the first, have a positive product.
KEYS = unit(np.random.default_rng(5).normal([2, 0, 0, 0], 0.7, size=(5, 4)))
K = Rotation.from_quat(KEYS, scalar_first=True)
KM, TIMES = K.as_matrix(), np.array([0, 0.5, 0.25, 1, 1.5, 2, 2.75, 3, 3.25, 3.6])
FROM, TO = KM[TIMES.astype(int)], KM[TIMES.astype(int) + 1]
TWO = Rotation.from_euler("xyz", [[0, 0, 0], [10, -20, 30]], degrees=True)
FOUR = np.radians([[-5, 3, -12, -15], [10, 5, 10, 20], [27, 38, 25, 11]])
FOUR_M = Rotation.from_euler("xyz", FOUR.T).as_matrix()
WAVE, THIRD = np.cos(np.arange(10)[:, None] * 2 * np.pi / 9), [[0, 0, 1], [1, 0, 0], [0, 1, 0]]

FIVE = unit(RNG.normal(size=(2, 5)))
LOCKED = Rotation.from_euler("xyz", [[45, 90, 35], [35, -90, 20]], degrees=True).as_matrix()
# What the libraries answer
ALIGNED, _ = Rotation.align_vectors(QM[0].T, QM[1].T)
# The third angle is set to zero.
LOCKED_ANGLES = Rotation.from_matrix(LOCKED).as_euler("xyz", suppress_warnings=True)
NEAREST, DOUBLED = (Rotation.from_matrix(m).as_matrix() for m in (ROUNDED, DOUBLE))
POLAR = [pr.robust_polar_decomposition(m, 200) for m in WORN]
COLUMNS, NORMED = pr.matrix_from_two_vectors(*UV), pr.norm_euler(BEYOND, 0, 1, 2)
TWICE = [Rotation.from_rotvec([0 * E1, t * E1, t * E1]).mean().as_matrix() for t in SCALES.flat]
POWERS = [np.linalg.matrix_power(PM[0], n) for n in (-5, -2, 5)]
DISTANCES = [pr.quaternion_dist(KEYS[0], -q) for q in KEYS]
BETWEEN = [pr.angle_between_vectors(E1, v) for v in FAR]
SLERPS = Slerp(range(5), K)(TIMES).as_matrix()
TM, SPLINE = TWO.as_matrix(), RotationSpline([0, 10], TWO)
PART, HARDLY_PART = pr.matrix_slerp(PM[0], QM[0], 0.3), pr.quaternion_slerp(*HARDLY, 0.3)
PERIODIC = CubicSpline(range(10), WAVE, bc_type="periodic")(np.arange(45) / 5)
UNITS = [sq.UnitQuaternion.from_unit_xyzw((x, y, z, w)) for w, x, y, z in KEYS]
PIECES = wxyz(sq.PiecewiseSlerp(UNITS, closed=True).evaluate(np.arange(5) + 0.3))
SQUAD = wxyz(sq.Squad(UNITS).evaluate(np.arange(20) / 4))
BEZIER = wxyz(sq.DeCasteljau([UNITS[:4]]).evaluate(T[2:7]))
GRADIENT, STEPS = pr.quaternion_gradient(KEYS, 0.1)[0], (RATES[1:] + RATES[:-1]) / 2
INTEGRATED = [pr.matrix_from_quaternion(q) for q in pr.quaternion_integrate(RATES, dt=0.1)]


@pytest.mark.parametrize("turning_along", [False, True], ids=["fixed", "turning along"])
@pytest.mark.parametrize("axes", [f"{a}{b}{c}" for a, b, c in product(*["xyz"] * 3) if a != b != c])
def test_scipy_from_euler_in_each_order(axes: str, turning_along: bool) -> None:
    order = axes.upper() if turning_along else axes
    expected = Rotation.from_euler(order, [30, 60, 45], degrees=True).as_matrix()
    close(turn(order, 30, 60, 45), expected, 1e-15)


AGREEMENTS = [
    case("scipy test_matrix_calculation_pipeline", lambda: of(back(PM)).matrix(), PM),
    case("scipy from_matrix: decimals", lambda: of(back(ROUNDED)).matrix(), NEAREST),
    case("scipy from_matrix: once single", lambda: of(back(DOUBLE)).matrix(), DOUBLED),
    case("scipy test_from_matrix_ortho_output: float32", lambda: of(back(SINGLE)).matrix(), PM),
    case("pytransform3d robust_polar_decomposition", lambda: nearest_rotation(WORN), POLAR),
    case("pytransform3d matrix_from_two_vectors", lambda: columns(*UV), COLUMNS),
    case("scipy test_inv", lambda: of(KEYS).inverse().matrix() @ KM, [ONE] * 5),
    case("scipy __mul__", lambda: compose(PM, QM, SM)[:, :3, :3], (P * (Q * S)).as_matrix()),
    case("numpy-quaternion division", lambda: 87 * (of(A) / of(B)).components, [35, 4, 0, 8]),
    case("scipy test_as_rotvec_degrees", lambda: np.degrees(log(THIRD)), [120 / 3**0.5] * 3),
    case("scipy test_rotvec_calc_pipeline", lambda: log(exp(VECTORS)), VECTORS),
    case("scipy test_from_rotvec", lambda: exp(VECTORS), Rotation.from_rotvec(VECTORS).as_matrix()),
    case("scipy test_past_180_degree_rotation", lambda: log(turn("x", 270)), -np.pi / 2 * E1),
    case("splines axis", lambda: of(-KEYS).axis_angle()[0], [(-q).axis for q in UNITS]),
    case("splines angle", lambda: of(-KEYS).axis_angle()[1], [(-q).angle for q in UNITS]),
    case("scipy test_as_euler_asymmetric_axes", lambda: euler_angles(TURNED), EULER.T),
    case("scipy test_as_euler_degenerate", lambda: euler_angles(LOCKED), LOCKED_ANGLES.T),
    case("scipy test_from_euler_rotation_order", lambda: from_euler(*EULER.T).matrix(), TURNED),
    case("pytransform3d norm_euler", lambda: euler_angles(from_euler(*BEYOND).matrix()), NORMED),
    case("scipy test_approx_equal", lambda: distance(PM, QM), (P * Q.inv()).magnitude()),
    case("scipy test_approx_equal_single_rotation", lambda: distance(ONE, exp(1e-9 * E3)), 1e-9),
    case("pytransform3d quaternion_dist", lambda: distance(KM[0], KM), DISTANCES),
    case("pytransform3d angle_between_vectors", lambda: angle_between(E1, FAR), BETWEEN),
    case("scipy test_mean", lambda: mean(exp(SCALES * [*ONE, *-ONE])), [ONE] * 100),
    case("scipy test_weighted_mean", lambda: mean(exp(SCALES * [0 * E1, E1]), [1, 2]), TWICE),
    case("scipy mean: weights", lambda: mean(PM, range(10)), P.mean(range(10)).as_matrix()),
    case("scipy mean: signs", lambda: mean(of([*KEYS, *-KEYS]).matrix()), K.mean().as_matrix()),
    case("scipy mean: equal ones", lambda: mean([PM[0]] * 3), P[[0] * 3].mean().as_matrix()),
    case("scipy concatenate: mean", lambda: log(mean(exp([E3, 2 * E3]))), 1.5 * E3),
    case("scipy test_pow", lambda: power(PM[0], T), [(P[0] ** t).as_matrix() for t in T]),
    case("scipy test_pow: as products", lambda: power(PM[0], [-5, -2, 5]), POWERS),
    case("scipy test_slerp", lambda: slerp_rotations(FROM, TO, TIMES % 1), SLERPS),
    case("pytransform3d matrix_slerp", lambda: slerp_rotations(PM[0], QM[0], 0.3), PART),
    case("pytransform3d quaternion_slerp", lambda: slerp(*HARDLY, 0.3), HARDLY_PART),
    case("scipy geometric_slerp", lambda: slerp(*FIVE, T), geometric_slerp(*FIVE, T)),
    case("scipy test_extrapolation_basic", lambda: slerp([0, 1], [1, 0], 2), [0, -1]),
    case("scipy align_vectors", lambda: nearest_rotation(QM[0] @ QM[1].T), ALIGNED.as_matrix()),
    case("splines slerp", lambda: slerp(*KEYS[:2], T), wxyz(sq.slerp(*UNITS[:2], T))),
    case("splines PiecewiseSlerp", lambda: slerp(KEYS, np.roll(KEYS, -1, 0), 0.3), PIECES),
    case("splines Squad", lambda: squad(KEYS, 4), SQUAD),
    case("splines DeCasteljau", lambda: de_casteljau(KEYS[:4], T[2:7]), BEZIER),
    case("scipy test_spline_2_rotations", lambda: power(TM[1], 1.2), SPLINE(12).as_matrix()),
    case("scipy test_spline_2_rotations: rate", lambda: angular_velocity(TM, 10), SPLINE([5], 1)),
    case("scipy test_constant_attitude", lambda: log(curve(exp(ONES), 1)), ONES),
    case("scipy test_spline_properties", lambda: euler_angles(curve(FOUR_M, 9)[::9]), FOUR),
    case("scipy test_periodic_eval", lambda: periodic_spline(WAVE[:9], 5), PERIODIC),
    case("pytransform3d quaternion_gradient", lambda: angular_velocity(KM, 0.1)[0], GRADIENT),
    case("pytransform3d quaternion_integrate", lambda: integrate(ONE, STEPS, 0.1), INTEGRATED),
]


@pytest.mark.parametrize(("ours", "theirs"), AGREEMENTS)
def test_agreement(ours: Callable[[], Any], theirs: Any) -> None:
    found = np.asarray(ours())
    close(found, theirs, 1e-6 if found.dtype == np.float32 else 1e-13)
