"""What other libraries promise of rotations, in their tests and docstrings, asked of rotedu.

Each case has the input and the expected result of a case of SciPy, pytransform3d, splines or
numpy-quaternion, or asks the library itself. Its id names the library and its test or function. The
code is ours, and so is random input. SciPy's quaternions have their scalar moved to the front, its
fixed axes x, y and z are U, V and W, and its degrees become radians.
"""

from collections.abc import Callable
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest
from pytransform3d import rotations as pr
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, RotationSpline, Slerp
from spheres import E1, E3, Array, close
from splines import quaternion as sq

from rotedu.arcs import angle_between, slerp
from rotedu.averages import angular_distance as distance
from rotedu.averages import matrix_from_two_columns as columns
from rotedu.averages import mean_rotation as mean
from rotedu.closed_curve import de_casteljau
from rotedu.general_rotation import compose, euler_angles, rotation_u, rotation_v, rotation_w
from rotedu.general_rotation import quaternion_from_euler_angles as from_euler
from rotedu.motion import angular_velocity, integrate
from rotedu.motion import matrix_from_rotation_vector as exp
from rotedu.motion import rotation_vector as log
from rotedu.ordinary_rotation import axis_angle, transform
from rotedu.orientations import closed_rotation_curve as curve
from rotedu.orientations import nearest_rotation, periodic_spline, slerp_rotations, squad
from rotedu.quaternions import Quaternion


def case(name: str, *values: Any) -> Any:
    return pytest.param(*values, id=name)


def table(text: str) -> list[Any]:
    """Read cases: a name, then columns of numbers between bars; a line may begin with a bar."""
    rows = [line.split("|") for line in text.replace("\n    |", "|").strip().splitlines()]
    columns = [[[float(Fraction(x)) for x in c.split()] for c in row[1:]] for row in rows]
    arrays = [[np.array(c[0] if len(c) == 1 else c) for c in row] for row in columns]
    return [case(row[0].strip(), *found) for row, found in zip(rows, arrays, strict=True)]


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
ZERO, FLAT, MIRROR = [0, 0, 0, 0], np.diag([0, 1, 1]), np.diag([-1, 1, 1])
# What the libraries answer
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


@pytest.mark.parametrize(
    ("components", "entries", "atol"),
    table("""
    scipy test_as_matrix_single_nd_quaternion: about z | 1 0 0 1 | 0 -1 0  1 0 0  0 0 1 | 1e-15
    scipy test_as_matrix_from_square_input: about y | 1 0 1 0 | 0 0 1  0 1 0  -1 0 0 | 1e-15
    scipy test_as_matrix_from_generic_input: of any length
    | 4 1 2 3 | 2/15 -2/3 11/15  14/15 1/3 2/15  -1/3 2/3 2/3 | 1e-15
    scipy as_matrix: half a turn | 0 1 1 0 | 0 1 0  1 0 0  0 0 -1 | 1e-15
    scipy test_from_single_nd_matrix: a third | 1 1 1 1 | 0 0 1  1 0 0  0 1 0 | 1e-15
    scipy test_as_matrix_from_square_input: nothing | 1 0 0 0 | 1 0 0  0 1 0  0 0 1 | 0
    scipy test_from_matrix_calculation: printed to seven decimals | 1 1 1 6
    | -.8974359 -.2564103 .3589744  .3589744 -.8974359 .2564103  .2564103 .3589744 .8974359 | 5e-8
    """),
)
def test_quaternion_and_matrix(components: Array, entries: Array, atol: float) -> None:
    close(of(components).matrix().ravel(), entries, atol)
    close(back(entries.reshape(3, 3)), unit(components), atol)


@pytest.mark.parametrize("angle", [1e-8, 1, 3, np.pi - 1e-8, np.pi])
@pytest.mark.parametrize("axis", [[3, -1, 2], [1, 3, 2], [1, -2, 3]], ids="xyz")
def test_pytransform3d_from_matrix_in_each_branch(axis: Any, angle: float) -> None:
    matrix = pr.matrix_from_axis_angle([*axis, angle])
    close(back(matrix), pr.quaternion_from_matrix(matrix), 1e-15)
    close(np.hstack(axis_angle(matrix)), pr.axis_angle_from_matrix(matrix), 1e-8)


@pytest.mark.parametrize(
    ("components", "expected"),
    table("""
    scipy test_quat_canonical: w < 0 | -1 0 0 0 | 1 0 0 0
    scipy test_quat_canonical: w = 0 and x < 0 | 0 -1 0 0 | 0 1 0 0
    scipy test_quat_canonical: w = x = 0 and y < 0 | 0 0 -1 0 | 0 0 1 0
    scipy test_quat_canonical: w = x = y = 0 and z < 0 | 0 0 0 -1 | 0 0 0 1
    scipy as_quat: w = 0 and x not the largest | 0 -1 3 2 | 0 1 -3 -2
    scipy test_quat_canonical: w > 0 and y < 0 | .9 0 -.1 0 | .9 0 -.1 0
    scipy test_quat_double_to_canonical_single_cover: all < 0 | -1 -1 -1 -1 | 1 1 1 1
    """),
)
def test_which_of_two_quaternions(components: Array, expected: Array) -> None:
    close(back(of(components).matrix()), unit(expected), 1e-15)


@pytest.mark.parametrize(
    ("v", "components", "atol"),
    table("""
    scipy test_from_nd_single_rotvec: about x | 1 0 0 | .8775826 .4794255 0 0 | 1e-7
    scipy test_from_generic_rotvec: almost half a turn
    | 1 2 2 | .0707372 .3324983 .6649967 .6649967 | 1e-7
    scipy test_from_generic_rotvec: any | 1 -1 .5 | .7316889 .4544258 -.4544258 .2272129 | 1e-7
    scipy test_from_rotvec_small_angle: halves
    | 2.8867513e-4 -2.8867513e-4 2.8867513e-4 | 1 1.4433757e-4 -1.4433757e-4 1.4433757e-4 | 4e-8
    scipy test_from_rotvec_small_angle: not so small
    | .2 .3 .4 | .9639685 .09879603932153465 .14819405898230198 .19759207864306931 | 3e-8
    scipy test_as_rotvec_single_nd_input: any
    | .5772381 1.1544763 -1.7317144 | .47140452 .23570226 .47140452 -.70710678 | 1e-7
    numpy-quaternion as_rotation_vector: of any length
    | 2.0238041798256954 -1.0119020899128477 .5059510449564238 | .4 .8 -.4 .2 | 1e-15
    """),
)
def test_vector_and_quaternion(v: Array, components: Array, atol: float) -> None:
    close(Quaternion.from_axis_angle(v, np.linalg.norm(v)).components, components, atol)
    close(back(exp(v)), components, atol)
    close(log(of(components).matrix()), v, 3 * atol)


@pytest.mark.parametrize("turning_along", [False, True], ids=["fixed", "turning along"])
@pytest.mark.parametrize("axes", [f"{a}{b}{c}" for a, b, c in product(*["xyz"] * 3) if a != b != c])
def test_scipy_from_euler_in_each_order(axes: str, turning_along: bool) -> None:
    order = axes.upper() if turning_along else axes
    expected = Rotation.from_euler(order, [30, 60, 45], degrees=True).as_matrix()
    close(turn(order, 30, 60, 45), expected, 1e-15)


@pytest.mark.parametrize("degrees", [(45, 90, 35), (35, -90, 20), (35, 90, 25), (25, -90, 15)])
def test_scipy_as_euler_degenerate_asymmetric_axes(degrees: Any) -> None:
    locked = Rotation.from_euler("xyz", degrees, degrees=True)
    found = euler_angles(locked.as_matrix())
    close(from_euler(*found).matrix(), locked.as_matrix(), 1e-12)
    # The third angle is set to zero.
    close(found, locked.as_euler("xyz", suppress_warnings=True), 1e-12)


@pytest.mark.parametrize(
    ("p", "q", "t", "expected", "atol"),
    table("""
    scipy test_straightforward_examples: circle
    | 1 0 | 0 1 | 1/3 2/3 | .8660254037844386 .5  .5 .8660254037844386 | 5e-16
    scipy test_straightforward_examples: sphere
    | 1 0 0 | 0 1 0 | 1/3 2/3 | .8660254037844386 .5 0  .5 .8660254037844386 0 | 5e-16
    scipy test_straightforward_examples: five dimensions
    | 1 0 0 0 0 | 0 1 0 0 0 | 1/3 | .8660254037844386 .5 0 0 0 | 5e-16
    scipy test_scalar_t | 1 0 | 0 1 | .5 | .7071067811865476 .7071067811865476 | 5e-16
    scipy test_degenerate_input: p = q | 1 0 0 | 1 0 0 | 0 1/4 1 | 1 0 0  1 0 0  1 0 0 | 0
    scipy test_degenerate_input: no t | 0 1 | 1 0 | | | 0
    scipy test_extrapolation_basic: twice a quarter | 0 1 | 1 0 | 2 | 0 -1 | 3e-16
    scipy test_extrapolation_basic: in the order of t
    | 0 1 0 | 1 1 0 | 7 6 4 | -.7071067811865476 .7071067811865476 0  -1 0 0  0 -1 0 | 1e-15
    scipy test_extrapolation_basic: back | 0 1 | 1 1 | -20/3 | .8660254037844386 .5 | 2e-15
    numpy-quaternion slerp: a quarter of two radians about z
    | 1 0 0 0 | .5403023058681398 0 0 .8414709848078965 | .25
    | .9689124217106447 0 0 .24740395925452294 | 5e-16
    """),
)
def test_slerp(p: Array, q: Array, t: Array, expected: Array, atol: float) -> None:
    close(slerp(p, q, t).ravel(), expected, atol)


@pytest.mark.parametrize("d", [2, 3, 5, 9])
def test_scipy_include_ends(d: int) -> None:
    p, q = unit(np.random.default_rng(123).normal(size=(2, d)))
    close(slerp(p, q, [0, 1]), [p, q], 1e-15)


# The last two are those of test_handle_antipodes.
@pytest.mark.parametrize("k", [*np.logspace(-7, -1, 7), 6.1086524e-4, 9.5993109e-4])
def test_scipy_numerical_stability_pi(k: float) -> None:
    far = [np.cos(np.pi - k), np.sin(np.pi - k), 0, 0]
    points = slerp([1, 0, 0, 0], far, np.linspace(0, 1, 100))
    close(np.linalg.norm(points, axis=-1), 1, 4e-15)
    close(points[[0, -1]], [[1, 0, 0, 0], far], 4e-15)


def test_scipy_apply_shapes_and_multiplication_nd() -> None:
    many = [(), (1,), (2,), (1, 2), (4, 2), (1, 4, 2), (5, 4, 2), (6, 5, 4, 2)]
    for a, b in product(many, [(), (1,), (2,), (1, 2), (5, 1, 2)]):
        q, p = of(RNG.normal(size=(*a, 4))), of(RNG.normal(size=(*b, 4)))
        assert q.rotate(p.v).shape == transform(q.matrix(), p.v).shape
        assert q.rotate(p.v).shape == (*np.broadcast_shapes(a, b), 3)
        assert (q * p).w.shape == np.broadcast_shapes(a, b)


@pytest.mark.parametrize(
    ("p", "q", "expected"),
    table("""
    scipy test_quat_double_cover: back by three quarters | -1 1 0 0 | -1 -1 0 0 | 2 0 0 0
    scipy test_quat_double_cover: three quarters | 0 2 0 0 | 1 1 0 0 | -2 2 0 0
    scipy test_quat_double_cover: round | 1 1 0 0 | -1 1 0 0 | -2 0 0 0
    scipy test_quat_double_cover: inverse | 1 1 0 0 | 1 -1 0 0 | 2 0 0 0
    scipy test_quat_double_cover: round in inverses | 1 -1 0 0 | -1 -1 0 0 | -2 0 0 0
    scipy __mul__: the right one first | 1 0 0 1 | 1 1 0 0 | 1 1 1 1
    scipy __mul__: two | 1 0 0 1 | .92387953 .38268343 0 0 | .92387953 .38268343 .38268343 .92387953
    pytransform3d concatenate_quaternions: of any length | 1 2 3 4 | 5 6 7 8 | -60 12 30 24
    """),
)
def test_product(p: Array, q: Array, expected: Array) -> None:
    close((of(p) * of(q)).components, expected, 1e-15)
    close(of(p).matrix() @ of(q).matrix(), of(expected).matrix(), 1e-8)


@pytest.mark.parametrize(
    ("components", "point", "expected", "atol"),
    table("""
    scipy test_apply_single_rotation_single_point | 1 0 0 1 | 1 2 3 | -2 1 3 | 1e-15
    scipy test_apply_single_rotation_single_point: inverse | 1 0 0 -1 | 1 2 3 | 2 -1 3 | 1e-15
    scipy test_apply_multiple_rotations_single_point | 1 1 0 0 | 1 2 3 | 1 -3 2 | 3e-15
    scipy test_apply_multiple_rotations_multiple_points | 1 1 0 0 | 4 5 6 | 4 -6 5 | 4e-15
    scipy Rotation: an eighth | .92387953 0 .38268343 0 | 1 2 3 | 2.82842712 2 1.41421356 | 3e-8
    scipy Rotation: any | .72331741 .39190384 .36042341 .43967974 | 1 2 3
    | 2.24452282 .78093109 2.89002836 | 3e-8
    """),
)
def test_apply(components: Array, point: Array, expected: Array, atol: float) -> None:
    close(of(components).rotate(point), expected, atol)
    close(transform(of(components).matrix(), point), expected, atol)


@pytest.mark.parametrize(
    ("v", "t", "expected"),
    table("""
    scipy __pow__: twice | 1 0 0 | 2 | 2 0 0
    scipy __pow__: half | 1 0 0 | .5 | .5 0 0
    scipy __pow__: to the other side | 0 0 2.0943951023931953 | 2 | 0 0 -2.0943951023931953
    scipy test_pow: small angle | 1e-12 0 0 | 3 | 3e-12 0 0
    scipy test_pow: not at all | .3 .4 .5 | 0 | 0 0 0
    scipy inv | 0 0 1.0471975511965976 | -1 | 0 0 -1.0471975511965976
    scipy test_slerp_call_scalar_time | 1.3962634015954636 0 0 | .25 | .3490658503988659 0 0
    """),
)
def test_power(v: Array, t: float, expected: Array) -> None:
    np.testing.assert_allclose(log(power(exp(v), t)), expected, rtol=3e-15, atol=0)


@pytest.mark.parametrize(
    ("a", "b", "entries"),
    table("""
    scipy test_align_vectors_no_rotation | 1 2 3 4 5 6 | 1 2 3 4 5 6 | 1 0 0  0 1 0  0 0 1
    scipy test_align_vectors_rssd_sensitivity
    | 0 1 0 0 1 1 0 1 1 | 1 0 0 1 1.1 0 1 .9 0 | 0 0 1  1 0 0  0 1 0
    scipy test_align_vectors_align_constrain | 0 1 0 0 1 1 | 1 0 0 1 1 0 | 0 0 1  1 0 0  0 1 0
    """),
)
def test_align(a: Array, b: Array, entries: Array) -> None:
    close(nearest_rotation(a.reshape(-1, 3).T @ b.reshape(-1, 3)).ravel(), entries, 1e-14)


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
    case("scipy test_past_180_degree_rotation", lambda: log(turn("x", 270)), -np.pi / 2 * E1),
    case("splines axis", lambda: of(-KEYS).axis_angle()[0], [(-q).axis for q in UNITS]),
    case("splines angle", lambda: of(-KEYS).axis_angle()[1], [(-q).angle for q in UNITS]),
    case("scipy test_as_euler_asymmetric_axes", lambda: euler_angles(TURNED), EULER.T),
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


@pytest.mark.parametrize(
    ("refused", "message"),
    [
        case("scipy test_from_quat_wrong_shape", lambda: of(np.zeros((1, 5))), "shape"),
        case("scipy test_zero_norms_from_quat", lambda: of([[0, 3, 4, 0], ZERO]).matrix(), "zero"),
        case("scipy test_malformed_1d_from_rotvec", lambda: exp([1, 2]), "shape"),
        case("scipy test_from_matrix_non_positive_determinant", lambda: back(MIRROR), "reflects"),
        case("scipy test_from_matrix_non_positive_determinant", lambda: back(FLAT), "identity"),
        case("scipy test_apply_input_validation", lambda: of(KEYS).rotate([1, 1]), "shape"),
        case("scipy test_multiplication_errors", lambda: of(KEYS) * of(KEYS[:2]), "broadcast"),
        case("scipy test_mean_input_validation: sign", lambda: mean(PM[:2], [1, -1]), "negative"),
        case("scipy test_mean_input_validation: shape", lambda: mean(PM[:3], [1, 1]), "shape"),
        case("scipy test_input_dim_mismatch", lambda: slerp(np.ones(7), np.ones(3), 0.5), "shape"),
        case("scipy test_unit_sphere_enforcement", lambda: slerp([1, 0], [0, 0], 0.5), "zero"),
        case("scipy test_0_sphere_handling", lambda: slerp([-17.7], [165.9], 0.5), "antipodal"),
        case("scipy test_t_values_conversion", lambda: slerp(E1, E3, "15, 5, 7"), "numbers"),
        case("scipy test_handle_antipodes", lambda: slerp(E3, -E3, 0.5), "antipodal"),
        case("scipy test_error_handling", lambda: curve(PM[:1]), "at least"),
        case("pytransform3d check_matrix: shape", lambda: back(np.ones((3, 4))), "shape"),
        case("pytransform3d check_matrix: size", lambda: back(2 * ONE), "identity"),
        case("pytransform3d check_matrix: NaN", lambda: back(np.nan * ONE), "finite"),
        case("pytransform3d matrix_from_two_vectors", lambda: columns(0 * E1, E3), "zero"),
        case("pytransform3d matrix_from_two_vectors", lambda: columns(E1, -2 * E1), "parallel"),
        case("splines _check_quaternions", lambda: squad(KEYS[:1]), "at least"),
        case("numpy-quaternion as_rotation_matrix", lambda: of(ZERO).matrix(), "zero"),
    ],
)
def test_refused(refused: Callable[[], Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        refused()
