"""Section 5: (5-1) to (5-15) and the closed curve, against sympy, scipy, splines, their laws."""

import math
import warnings
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial import geometric_slerp
from scipy.spatial.transform import Rotation, Slerp
from splines.quaternion import DeCasteljau, UnitQuaternion
from symbolic import matrix, symbolic, vanishes

from rotedu import interpolation
from rotedu.arcs import angle_between, arc_axis, slerp, slerp_by_rotation
from rotedu.closed_curve import closed_curve, de_casteljau, de_casteljau_levels
from rotedu.control_points import (
    bisect,
    bisect_by_rotation,
    control_points,
    double,
    double_by_rotation,
)
from rotedu.cost import OperationCount, count
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix
from rotedu.orientations import closed_rotation_curve, slerp_rotations
from rotedu.quaternions import Quaternion

Array = np.ndarray[Any, Any]

RNG = np.random.default_rng(515)
E1, E2, E3 = np.eye(3)
# At 60 and 90 degrees, where a bar lost from a theta is noticed; the octant would hide it.
BEFORE, HERE, AFTER = E1, np.array([0.5, 0.75**0.5, 0]), E3
FRACTIONS = [1 / 2, 1 / 3]

# Warnings of curves that are unstable are tested where they are due.
pytestmark = pytest.mark.filterwarnings("ignore:.* are almost .*:UserWarning")


def random_units(*shape: int, rng: np.random.Generator = RNG) -> Array:
    vectors = rng.normal(size=shape)
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def great_circle(degrees: Any) -> Array:
    """Points at these angles in a plane that is not one of the axes'."""
    angle = np.radians(degrees)[..., None]
    m = rotation_matrix([1, 2, 3], 0.8)
    return np.asarray(np.cos(angle) * m[0] + np.sin(angle) * m[1])


def where(points: Array) -> Array:
    """Tell the angles of such points, in degrees, from -180 to 180."""
    m = rotation_matrix([1, 2, 3], 0.8)
    close(points @ m[2], 0, 1e-12)
    return np.asarray(np.degrees(np.arctan2(points @ m[1], points @ m[0])))


def close(actual: Any, desired: Any, atol: float = 1e-14) -> None:
    np.testing.assert_allclose(actual, desired, rtol=0, atol=atol)


def on_the_sphere(points: Array, atol: float = 1e-15) -> None:
    close(np.linalg.norm(points, axis=-1), 1, atol)


PAIRS = random_units(2, 500, 3)
# Gaps from 12.8 to 164 degrees in many directions.
UNEVEN = great_circle(np.array([0, 12.8, 90, 210, 260])) + 0.4 * np.outer([0, 1, 0, -1, 2], E3)
UNEVEN /= np.linalg.norm(UNEVEN, axis=-1, keepdims=True)
DATA = {
    "octahedron square": great_circle(np.arange(4) * 90),
    "hexagon": great_circle(np.arange(6) * 60),
    "uneven": UNEVEN,
    "obtuse": np.array([[1, 0, 0], [-0.8, 0.6, 0], [0.1, -0.7, 0.7], [-0.5, -0.5, -0.7]]),
    "three": np.eye(3),
    "random": random_units(40, 3),
    "on the circle": random_units(6, 2),
    "in four dimensions": random_units(30, 4),
    "in seven dimensions": random_units(12, 7),
}
CURVES = [
    pytest.param(
        points / np.linalg.norm(points, axis=-1, keepdims=True), fraction, id=f"{name}-{k}"
    )
    for name, points in DATA.items()
    for k, fraction in zip("23", FRACTIONS, strict=True)
]

# Lengths of arcs: where a sine or cosine loses digits, and on both sides of `NEAR_PI`, 2.4981.
LENGTHS = [1e-16, 1e-9, 1e-8, 3e-8, 1e-7, 1e-4, 0.1, 1, 2, 2.498, 2.4982, 2.6, 3, np.pi - 1e-2]
LENGTHS_AND_DTYPES = [
    *((length, np.float64) for length in [*LENGTHS, np.pi - 1e-4, np.pi - 1e-7]),
    *((length, np.float32) for length in LENGTHS),
]
# Gaps between three points of a circle.
UNEQUAL_GAPS = [(*gaps, 2 * np.pi - sum(gaps)) for gaps in [(1, 2.5), (2.6, 2.6), (2.4, 3)]]

coordinates = st.floats(-1, 1, allow_subnormal=False)
units = (
    arrays(float, 3, elements=coordinates)
    .filter(lambda v: bool(np.linalg.norm(v) > 1e-3))
    .map(lambda v: v / np.linalg.norm(v))
)
parts = st.floats(0, 1)
repeatable = settings(derandomize=True, deadline=None, database=None)


def segments(points: Array, fraction: float) -> list[Array]:
    """Control points of each segment, put together by hand."""
    a, b = control_points(points, fraction)
    n = len(points)
    return [np.array([points[i - 1], a[i - 1], b[i % n], points[i % n]]) for i in range(1, n + 1)]


def bezier(points: Array, fraction: float, u: Array) -> Array:
    """Do the same with straight lines: points of the segments, of shape (n, samples, d)."""
    before, after = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
    handle = fraction * (after - before) / 2
    control = points, points + handle, after - np.roll(handle, -1, axis=0), after
    weights = (1 - u) ** 3, 3 * u * (1 - u) ** 2, 3 * u**2 * (1 - u), u**3
    return np.asarray(sum(np.multiply.outer(w, c) for w, c in zip(weights, control, strict=True)))


def turning(gaps: tuple[float, ...], fraction: float, u: Array) -> Array:
    """Angles along the curve through three points of a circle with these gaps between them."""
    at = np.cumsum([0.0, *gaps])
    # The last is the first again.
    handle = fraction * (np.roll(gaps, 1) + gaps)[[0, 1, 2, 0]] / 2
    control = np.array([at[:-1], (at + handle)[:-1], (at - handle)[1:], at[1:]])
    weights = np.array([(1 - u) ** 3, 3 * u * (1 - u) ** 2, 3 * u**2 * (1 - u), u**3])
    return (control.T @ weights).ravel()


class TestProofs:
    """The code itself, run on symbols: two points h to either side of the first axis."""

    h, t = sp.symbols("h t", positive=True)
    c, s = sp.symbols("c s", positive=True)
    p, q = symbolic(c, -s, 0), symbolic(c, s, 0)

    def back(self, result: Any) -> sp.Matrix:
        """In terms of h; atan2 of its sine and cosine is h itself."""
        angle = {sp.atan2(2 * self.s, 2 * self.c): self.h, sp.atan2(self.s, self.c): self.h}
        found = matrix(result).subs(angle).applyfunc(sp.simplify).subs(self.c**2 + self.s**2, 1)
        return found.subs({self.c: sp.cos(self.h), self.s: sp.sin(self.h)})

    def of_5_2(self, t: Any) -> sp.Matrix:
        theta = 2 * self.h
        first, second = sp.sin((1 - t) * theta), sp.sin(t * theta)
        return (first * self.back(self.p) + second * self.back(self.q)) / sp.sin(theta)

    @pytest.mark.equation("5-2")
    def test_arc_is_5_2(self) -> None:
        assert vanishes(self.back(slerp(self.p, self.q, symbolic(self.t))) - self.of_5_2(self.t))
        assert not vanishes(self.back(slerp(self.p, self.q, symbolic(self.t))) - self.of_5_2(0))

    @pytest.mark.equation("5-3")
    def test_arc_by_rotation_is_5_2(self) -> None:
        rotated = slerp_by_rotation(self.p, self.q, symbolic(self.t))
        assert vanishes(self.back(rotated) - self.of_5_2(self.t))

    def test_double_is_twice_the_arc(self) -> None:
        assert vanishes(self.back(double(self.p, self.q)) - self.of_5_2(2))
        assert vanishes(self.back(double_by_rotation(self.p, self.q)) - self.of_5_2(2))

    def test_bisect_is_half_the_arc(self) -> None:
        half = self.of_5_2(sp.Rational(1, 2))
        assert vanishes(self.back(bisect(self.p, self.q)) - half)
        assert vanishes(self.back(bisect_by_rotation(self.p, self.q)) - half)

    def test_double_in_any_dimension(self) -> None:
        p, q = sp.Matrix(sp.symbols("p:4")), sp.Matrix(sp.symbols("q:4"))
        expected = 2 * p.dot(q) * q - p
        found = sp.Matrix(double(np.array(p)[:, 0], np.array(q)[:, 0]))
        assert (found - expected).expand() == sp.zeros(4, 1)

    def test_double_of_quaternions_is_q_conjugate_p_q(self) -> None:
        w1, x1, y1, z1, w2, x2, y2, z2 = sp.symbols("w1 x1 y1 z1 w2 x2 y2 z2")
        p, q = Quaternion(w1, [x1, y1, z1]), Quaternion(w2, [x2, y2, z2])
        difference = (q * p.conjugate() * q).components - double(p.components, q.components)
        law = w2**2 + x2**2 + y2**2 + z2**2 - 1
        assert all(sp.reduced(sp.expand(x), [law], w2)[1] == 0 for x in difference)


class TestAngle:
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_in_any_dimension(self, d: int) -> None:
        p, q = random_units(2, 300, d)
        cosine = np.clip(np.sum(p * q, axis=-1), -1, 1)
        close(np.cos(angle_between(p, q)), cosine)

    @pytest.mark.parametrize("theta", [0, 1e-300, 1e-200, 1e-15, 1e-9, 1e-8, 1e-7, 1e-3, 1, 3])
    def test_small_angles_keep_their_digits(self, theta: float) -> None:
        found = angle_between(E1, [np.cos(theta), np.sin(theta), 0])
        np.testing.assert_allclose(found, theta, rtol=1e-15)

    @pytest.mark.parametrize("rest", [0, 1e-12, 1e-8, 1e-3])
    def test_near_pi(self, rest: float) -> None:
        close(angle_between(E1, [-np.cos(rest), np.sin(rest), 0]), np.pi - rest, 5e-16)

    def test_length_does_not_matter(self) -> None:
        p, q = PAIRS
        close(angle_between(7 * p, 1e-200 * q), angle_between(p, q))


class TestAxis:
    @pytest.mark.equation("5-1")
    def test_is_perpendicular_and_right_handed(self) -> None:
        p, q = PAIRS
        axis = arc_axis(p, q)
        on_the_sphere(axis)
        close(np.sum(axis * p, axis=-1), 0, 1e-13)
        close(np.sum(axis * q, axis=-1), 0, 1e-13)
        close(np.cross(p, q), np.sin(angle_between(p, q))[:, None] * axis)

    @pytest.mark.parametrize("theta", [1e-12, 1e-8, 1e-3, np.pi - 1e-3, np.pi - 1e-7])
    def test_near_the_ends(self, theta: float) -> None:
        close(arc_axis(E1, [np.cos(theta), np.sin(theta), 0]), E3, 1e-15)
        p = HERE
        q = rotate(p, arc_axis(p, [1, 2, 3]), theta)
        # The points are rounded to 1e-16.
        close(arc_axis(p, q), arc_axis(p, [1, 2, 3]), 4e-16 / np.sin(theta))


class TestArc:
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_against_scipy(self, d: int) -> None:
        t = np.linspace(0, 1, 11)
        for p, q in random_units(50, 2, d):
            close(slerp(p, q, t), geometric_slerp(p, q, t))

    def test_both_forms_agree(self) -> None:
        p, q = PAIRS
        for t in [0, 0.1, 0.5, 0.8, 1, 1.7, -0.6]:
            close(slerp_by_rotation(p, q, t), slerp(p, q, t), 1e-13)

    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_on_the_sphere_from_end_to_end(self, d: int) -> None:
        p, q = random_units(2, 2000, d)
        on_the_sphere(slerp(p, q, RNG.uniform(0, 1, 2000)))
        close(slerp(p, q, 0), p, 1e-15)
        close(slerp(p, q, 1), q, 1e-15)

    def test_at_constant_speed(self) -> None:
        p, q = PAIRS
        t = RNG.uniform(0, 1, 500)
        close(angle_between(p, slerp(p, q, t)), t * angle_between(p, q))
        close(angle_between(slerp(p, q, t), q), (1 - t) * angle_between(p, q))

    def test_as_printed_where_that_is_possible(self) -> None:
        for p, q in PAIRS.swapaxes(0, 1)[:50]:
            theta = math.acos(p @ q)
            if 0.1 < theta < 3:
                printed = (math.sin(0.7 * theta) * p + math.sin(0.3 * theta) * q) / math.sin(theta)
                close(slerp(p, q, 0.3), printed)

    @pytest.mark.parametrize("theta", [1e-300, 1e-12, 1e-9, 1e-8, 1e-7, 1e-4])
    def test_nearly_coincident(self, theta: float) -> None:
        q = [np.cos(theta), np.sin(theta), 0]
        for form in [slerp, slerp_by_rotation]:
            found = form(E1, q, [0.25, 0.5])
            np.testing.assert_allclose(
                found[:, 1], np.sin([theta / 4, theta / 2]), rtol=1e-14, atol=1e-160
            )
            close(found[:, 0], 1, theta**2)

    def test_coincident(self) -> None:
        p = PAIRS[0]
        for t in [0, 0.3, 1, 5]:
            close(slerp(p, p, t), p, 5e-16)
            close(slerp_by_rotation(p, p, t), p, 5e-16)

    @pytest.mark.parametrize("rest", [1e-2, 1e-4, 1e-6, 1e-7])
    def test_nearly_antipodal(self, rest: float) -> None:
        # The two points determine their plane to 1e-16 / rest, the sphere and the ends to 1e-16.
        p, side = PAIRS[0], np.cross(*PAIRS)
        side /= np.linalg.norm(side, axis=-1, keepdims=True)
        q = -np.cos(rest) * p + np.sin(rest) * side
        t = np.linspace(0, 1, 9)[:, None]
        turn = (t * (np.pi - rest))[..., None]
        for form in [slerp, slerp_by_rotation]:
            found = form(p, q, t)
            close(found, np.cos(turn) * p + np.sin(turn) * side, 1e-15 / rest)
            on_the_sphere(found)
            close(found[0], p, 1e-15)
            close(found[-1], q, 1e-15)
        half = (np.pi - rest) / 2
        close(bisect(p, q), np.cos(half) * p + np.sin(half) * side, 1e-15 / rest)
        in_a_plane_that_is_exact = [np.cos(np.pi - rest), np.sin(rest), 0]
        close(
            slerp(E1, in_a_plane_that_is_exact, 0.5), [np.sin(rest / 2), np.cos(rest / 2), 0], 1e-15
        )

    @pytest.mark.parametrize(
        "form", [slerp, slerp_by_rotation, bisect, bisect_by_rotation, arc_axis]
    )
    @pytest.mark.parametrize("rest", [0, 1e-16, 1e-12, 1e-9])
    def test_antipodal(self, form: Any, rest: float) -> None:
        t = [0.5] if form in (slerp, slerp_by_rotation) else []
        q = [-np.cos(rest), np.sin(rest), 0]
        with pytest.raises(DegenerateError, match=r"^p and q are antipodal: no unique arc joins"):
            form(E1, q, *t)
        with pytest.raises(DegenerateError, match=r"^p and q at index \(1,\) are antipodal"):
            form(E1, [E2, q, q], *t)
        if rest == 0:
            for p in PAIRS[0]:
                with pytest.raises(DegenerateError):
                    form(p, -p, *t)
                with pytest.raises(DegenerateError):
                    form(p, -3 * p, *t)

    def test_axis_of_coincident_points(self) -> None:
        for p in PAIRS[0]:
            with pytest.raises(DegenerateError, match=r"^p and q coincide: any axis would do$"):
                arc_axis(p, 3 * p)
        with pytest.raises(DegenerateError, match=r"^p and q coincide: .* at index \(1,\)$"):
            arc_axis([E1, E2], E2)

    def test_beyond_the_ends_the_circle_goes_on(self) -> None:
        close(where(slerp(great_circle(10), great_circle(50), [-1, 2, 4])), [-30, 90, 170], 1e-12)

    def test_half_the_way_from_the_identity_by_300_degrees_is_the_short_way(self) -> None:
        q = Quaternion.from_axis_angle(E3, [0, np.radians(300)]).components
        longer = slerp(q[0], q[1], 0.5)
        _, angle = Quaternion(longer[0], longer[1:]).axis_angle()
        close(np.degrees(angle), 150, 1e-12)
        shorter = slerp(q[0], -q[1], 0.5)
        axis, angle = Quaternion(shorter[0], shorter[1:]).axis_angle()
        close(axis * np.degrees(angle), [0, 0, -30], 1e-12)
        m = slerp_rotations(np.eye(3), rotation_matrix(E3, np.radians(300)), 0.5)
        close(m, rotation_matrix(E3, np.radians(-30)))


class TestSlerpHasAMatrix:
    """Erratum E7: for quaternions, a 4x4 rotation matrix; for any vectors, a plane rotation."""

    def test_left_multiplication(self) -> None:
        for p, q in random_units(100, 2, 4):
            turn = Quaternion(q[0], q[1:]) * Quaternion(p[0], p[1:]).conjugate()
            axis, angle = turn.axis_angle()
            part = Quaternion.from_axis_angle(axis, 0.3 * angle)
            left = np.column_stack([(part * Quaternion(w, v)).components for w, *v in np.eye(4)])
            close(left.T @ left, np.eye(4))
            close(left @ p, slerp(p, q, 0.3), 1e-13)


class TestDouble:
    @pytest.mark.equation("5-4")
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_reflects(self, d: int) -> None:
        p, q = random_units(2, 500, d)
        reflected = double(p, q)
        on_the_sphere(reflected, 3e-15)
        close(angle_between(q, reflected), angle_between(p, q))
        close(double(reflected, q), p)
        close(reflected, slerp(p, q, 2), 1e-13)

    def test_both_forms_agree(self) -> None:
        close(double_by_rotation(*PAIRS), double(*PAIRS), 3e-15)

    def test_no_case_is_without_an_answer(self) -> None:
        p = PAIRS[0]
        for form in [double, double_by_rotation]:
            close(form(p, p), p, 1e-15)
            close(form(p, -p), p, 1e-15)
        for rest in [1e-15, 1e-12, 1e-8]:
            q = [-np.cos(rest), np.sin(rest), 0]
            close(double_by_rotation(E1, q), double(E1, q), 1e-15)

    def test_120_degrees_double_to_240_which_are_120_apart(self) -> None:
        p, q = great_circle(np.array([0, 120]))
        close(where(double(p, q)), -120, 1e-12)
        close(np.degrees(angle_between(p, double(p, q))), 120, 1e-12)


class TestBisect:
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_halves(self, d: int) -> None:
        p, q = random_units(2, 500, d)
        middle = bisect(p, q)
        on_the_sphere(middle)
        close(angle_between(p, middle), angle_between(p, q) / 2)
        close(angle_between(middle, q), angle_between(p, q) / 2)
        close(middle, slerp(p, q, 0.5), 1e-15)
        close(middle, bisect(q, p), 1e-15)

    def test_both_forms_agree(self) -> None:
        close(bisect_by_rotation(*PAIRS), bisect(*PAIRS), 1e-13)

    def test_coincident(self) -> None:
        p = PAIRS[0]
        close(bisect(p, p), p, 3e-16)
        close(bisect_by_rotation(p, p), p, 3e-16)


class TestSteps:
    """The steps from three points to a_i and b_i, on data that hide no lost bar."""

    before, here, after = BEFORE, HERE, AFTER
    reflected = double(before, here)
    middle = bisect(reflected, after)
    a = bisect(here, middle)
    b = double(a, here)

    @pytest.mark.equation("5-5", "5-6")
    def test_5_4_and_5_5(self) -> None:
        close(self.reflected, [-0.5, 0.75**0.5, 0])
        close(double_by_rotation(self.before, self.here), self.reflected)

    @pytest.mark.equation("5-8")
    def test_5_7_to_5_9(self) -> None:
        close(self.middle, (self.reflected + self.after) / 2**0.5)
        close(bisect_by_rotation(self.reflected, self.after), self.middle)

    @pytest.mark.equation("5-9")
    def test_5_9_as_printed_turns_away_from_the_next_point(self) -> None:
        gap = angle_between(self.reflected, self.after)
        printed = arc_axis(self.after, self.reflected)
        missed = rotate(self.reflected, printed, gap / 2)
        close(angle_between(missed, self.middle), gap)
        corrected = rotate(self.reflected, arc_axis(self.reflected, self.after), gap / 2)
        close(corrected, self.middle)
        octant = rotate(-E1, arc_axis(E3, -E1), np.pi / 4)
        close(octant, [-(0.5**0.5), 0, -(0.5**0.5)])
        close(bisect(-E1, E3), [-(0.5**0.5), 0, 0.5**0.5])

    @pytest.mark.equation("5-11", "5-12")
    def test_5_10_to_5_12(self) -> None:
        close(self.a, bisect(self.middle, self.here))
        close(bisect_by_rotation(self.middle, self.here), self.a)
        close(angle_between(self.here, self.a), angle_between(self.here, self.middle) / 2)

    @pytest.mark.equation("5-13", "5-14", "5-15")
    def test_5_13_to_5_15(self) -> None:
        close(double_by_rotation(self.a, self.here), self.b)
        close(arc_axis(self.a, self.here), arc_axis(self.middle, self.here))
        close(2 * angle_between(self.a, self.here), angle_between(self.middle, self.here))
        close(angle_between(self.b, self.here), angle_between(self.here, self.a))

    def test_5_13_as_printed_goes_back_to_the_middle(self) -> None:
        close(2 * np.cos(angle_between(self.a, self.here)) * self.a - self.here, self.middle)

    @pytest.mark.equation("5-7", "5-10")
    def test_bars_that_are_lost_would_be_noticed(self) -> None:
        gap, bar = (
            angle_between(self.before, self.here),
            angle_between(self.reflected, self.after),
        )
        literal = np.sin(bar / 2) / np.sin(gap) * (self.after + self.reflected)
        close(np.linalg.norm(literal), 1.1547, 1e-4)
        next_gap, bar = angle_between(self.here, self.after), angle_between(self.middle, self.here)
        literal = np.sin(bar / 2) / np.sin(next_gap) * (self.here + self.middle)
        close(np.linalg.norm(literal), 0.9354, 1e-4)

    def test_control_points_do_the_same(self) -> None:
        a, b = control_points([self.before, self.here, self.after])
        close(a[1], self.a)
        close(b[1], self.b)

    def test_octant(self) -> None:
        a, b = control_points(np.eye(3))
        close(a[1], [-0.5, 0.5**0.5, 0.5])
        close(b[1], [0.5, 0.5**0.5, -0.5])


class TestControlPoints:
    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_as_written(self, points: Array, fraction: float) -> None:
        a, b = control_points(points, fraction)
        for i, (before, here) in enumerate(pairwise([points[-1], *points])):
            middle = bisect(double(before, here), points[(i + 1) % len(points)])
            close(a[i], slerp(here, middle, fraction))
            close(b[i], double(a[i], here))
        if fraction == 1 / 2:
            close(a, bisect(points, slerp(points, a, 2)), 1e-13)
        on_the_sphere(a, 1e-15)
        on_the_sphere(b, 3e-15)

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_reversal_exchanges_them(self, points: Array, fraction: float) -> None:
        a, b = control_points(points, fraction)
        reversed_a, reversed_b = control_points(points[::-1], fraction)
        close(reversed_a[::-1], b, 1e-13)
        close(reversed_b[::-1], a, 1e-13)

    @pytest.mark.parametrize("n", [3, 4, 5, 6, 7, 8, 12, 100])
    def test_equally_spaced_on_a_great_circle(self, n: int) -> None:
        at = 360 / n * np.arange(n)
        for fraction in FRACTIONS:
            a, b = control_points(great_circle(at), fraction)
            close(a, great_circle(at + fraction * 360 / n))
            close(b, great_circle(at - fraction * 360 / n))

    @pytest.mark.parametrize(
        "gaps", [(20, 50), (100, 10), (90, 90), (179, 1), (120, 179), (179, 179)]
    )
    def test_on_a_great_circle_the_gaps_are_averaged(self, gaps: tuple[float, float]) -> None:
        before, after = gaps
        a, b = control_points(great_circle(np.array([-before, 0, after])))
        close(where(a[1]), (before + after) / 4, 1e-11)
        close(where(b[1]), -(before + after) / 4, 1e-11)

    def test_gaps_that_differ_by_more_than_180_degrees_flip(self) -> None:
        at = np.array([-150, 0, -40])
        close(where(control_points(great_circle(at))[0][1]), -62.5, 1e-11)
        at = np.array([-130, 0, -40])
        close(where(control_points(great_circle(at))[0][1]), 22.5, 1e-11)

    def test_repeated_points(self) -> None:
        a, b = control_points([E1, E1, E2, E3])
        # Neighbours P, P, Q: Double is P, Bisect is half the way to Q.
        close(a[1], slerp(E1, E2, 0.25))
        close(a[0], slerp(E1, double(E3, E1), 0.25))
        close(control_points([E1, E1, E1])[0], [E1] * 3)
        on_the_sphere(b)

    @pytest.mark.parametrize("gap", [1e-9, 1, 30, 60, 89, 89.9])
    def test_out_and_back_below_90_degrees_stops(self, gap: float) -> None:
        points = great_circle(np.array([0, gap, 0, -gap]))
        a, b = control_points(points)
        close(a[1], points[1], 1e-12)
        close(b[1], points[1], 1e-12)

    @pytest.mark.parametrize(
        ("gap", "pair"),
        [
            (90, r"Double\(points\[0\], points\[1\]\) and points\[2\]"),
            (
                90 + 1e-6,
                r"points\[1\] and Bisect\(Double\(points\[0\], points\[1\]\), points\[2\]\)",
            ),
            (120, r"points\[1\] and Bisect\(Double\(points\[0\], points\[1\]\), points\[2\]\)"),
            (179, r"points\[1\] and Bisect\(Double\(points\[0\], points\[1\]\), points\[2\]\)"),
        ],
    )
    def test_out_and_back_from_90_degrees_on(self, gap: float, pair: str) -> None:
        out, turn = great_circle(np.array([0, gap]))
        points = [out, turn, out, bisect(out, rotation_matrix([1, 2, 3], 0.8)[2])]
        for f in [control_points, closed_curve]:
            with pytest.raises(DegenerateError, match=f"^{pair} are antipodal: no unique arc"):
                f(points)

    def test_next_point_opposite_to_the_reflected_one(self) -> None:
        points = [BEFORE, HERE, -double(BEFORE, HERE), E3]
        with pytest.raises(
            DegenerateError, match=r"^Double\(points\[0\], points\[1\]\) and points\[2\]"
        ):
            control_points(points)
        with pytest.raises(
            DegenerateError, match=r"^Double\(points\[1, 0\], points\[1, 1\]\) and poi"
        ):
            control_points([UNEVEN[:4], points])
        with pytest.raises(
            DegenerateError, match=r"^Double\(points\[3\], points\[0\]\) and points\[1\]"
        ):
            control_points(np.roll(points, -1, axis=0))

    def test_antipodal_neighbours_need_no_arc_between_them(self) -> None:
        a, _ = control_points([E1, -E1, E2])
        close(a[1], bisect(-E1, bisect(E1, E2)))
        curve = closed_curve([E1, -E1, E2], 50)
        on_the_sphere(curve)

    def test_points_need_not_be_unit(self) -> None:
        a, b = control_points(UNEVEN * [[1], [2], [3], [1e-200], [1e5]])
        close(a, control_points(UNEVEN)[0])
        close(b, control_points(UNEVEN)[1])

    def test_stacks(self) -> None:
        points = random_units(2, 3, 5, 3)
        a, b = control_points(points)
        assert a.shape == b.shape == (2, 3, 5, 3)
        close(a[1, 2], control_points(points[1, 2])[0], 1e-15)
        close(b[0, 1], control_points(points[0, 1])[1], 1e-15)


class TestDeCasteljau:
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_levels_are_arcs_of_the_level_before(self, d: int) -> None:
        control = random_units(5, d)
        levels = de_casteljau_levels(control, 0.3)
        assert [level.shape for level in levels] == [(m, d) for m in (5, 4, 3, 2, 1)]
        close(levels[0], control, 1e-15)
        for level, following in pairwise(levels):
            close(following, slerp(level[:-1], level[1:], 0.3))
        close(de_casteljau(control, 0.3), levels[-1][0], 0)

    def test_degrees_0_and_1(self) -> None:
        close(de_casteljau([HERE], [0.1, 0.9]), [HERE, HERE], 1e-15)
        close(de_casteljau([E1, HERE], 0.3), slerp(E1, HERE, 0.3), 0)

    def test_ends(self) -> None:
        control = random_units(200, 4, 3)
        close(de_casteljau(control, 0), control[:, 0], 1e-15)
        close(de_casteljau(control, 1), control[:, -1], 1e-15)

    def test_one_curve_at_many_parameters_and_many_curves_at_one(self) -> None:
        control, u = random_units(6, 4, 3), np.linspace(0, 1, 9)
        points = de_casteljau(control[:, None], u)
        assert points.shape == (6, 9, 3)
        close(points[2, 3], de_casteljau(control[2], u[3]), 1e-15)
        close(points[:, 3], de_casteljau(control, u[3]), 1e-15)
        close(points[2], de_casteljau(control[2], u), 1e-15)
        levels = de_casteljau_levels(control[:, None], u)
        assert [level.shape for level in levels] == [(6, 9, m, 3) for m in (4, 3, 2, 1)]
        assert de_casteljau(control, np.empty((0, 1))).shape == (0, 6, 3)

    def test_equal_control_points(self) -> None:
        close(de_casteljau([HERE] * 4, np.linspace(0, 1, 5)), [HERE] * 5, 1e-15)
        control = great_circle(np.array([0, 45, 45, 90]))
        close(where(de_casteljau(control, 0.5)), 45, 1e-13)

    def test_on_a_great_circle_it_is_the_polynomial(self) -> None:
        at, u = np.array([0.0, 20, 100, 70]), np.linspace(0, 1, 21)
        bernstein = [(1 - u) ** 3, 3 * u * (1 - u) ** 2, 3 * u**2 * (1 - u), u**3]
        close(where(de_casteljau(great_circle(at), u)), at @ bernstein, 1e-12)

    def test_arcs_between_points_of_arcs_are_no_longer(self) -> None:
        p, q, r = random_units(3, 20000, 3)
        u = RNG.uniform(0, 1, 20000)
        inner = angle_between(slerp(p, q, u), slerp(q, r, u))
        bound = (1 - u) * angle_between(p, q) + u * angle_between(q, r)
        assert (inner <= bound + 1e-14).all()

    def test_antipodal_control_points(self) -> None:
        with pytest.raises(DegenerateError, match=r"^control\[1\] and control\[2\] are antipodal"):
            de_casteljau([E1, E2, -E2, E3], 0.5)
        with pytest.raises(DegenerateError, match=r"control\[1\] at index \(2,\) are antipodal"):
            de_casteljau([[E1, E2], [E1, E2], [E1, -E1]], 0.5)

    def test_antipodal_points_of_a_level_beyond_the_ends(self) -> None:
        control = great_circle(np.array([0, 90, 90]))
        match = r"^points of level 1\[0\] and points of level 1\[1\] are antipodal"
        with pytest.raises(DegenerateError, match=match):
            de_casteljau(control, -1)


class TestClosedCurve:
    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_on_the_sphere_through_the_points(self, points: Array, fraction: float) -> None:
        curve = closed_curve(points, 100, fraction)
        assert curve.shape == (100 * len(points), points.shape[1])
        on_the_sphere(curve)
        close(curve[::100], points, 1e-15)

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_is_de_casteljau_on_each_segment(self, points: Array, fraction: float) -> None:
        u = np.arange(10) / 10
        by_hand = np.concatenate([de_casteljau(c, u) for c in segments(points, fraction)])
        close(closed_curve(points, 10, fraction), by_hand, 1e-13)

    @pytest.mark.parametrize("d", [2, 3, 4])
    @pytest.mark.parametrize(("theta", "dtype"), LENGTHS_AND_DTYPES)
    def test_arcs_of_any_length(self, theta: float, dtype: Any, d: int) -> None:
        # Control points P, P, Q, Q, which fraction 0 makes: u is followed by 3 u^2 - 2 u^3.
        single = dtype == np.float32
        u, rng = np.arange(20) / 20, np.random.default_rng(d)
        for _ in range(10):
            p, x, *others = np.linalg.qr(rng.normal(size=(d, d)))[0].T
            q = np.cos(theta) * p + np.sin(theta) * x
            between = p + q + (others[0] if others else x / 2)
            points = np.array([p, q, between / np.linalg.norm(between)], dtype)
            found = closed_curve(points, 20, 0)
            assert found.dtype == dtype
            on_the_sphere(found, 2e-6 if single else 4e-15)
            turn = (theta * (3 * u**2 - 2 * u**3))[:, None]
            # The points are rounded, which matters more, the nearer to pi.
            rounding = (1e-6 if single else 2e-15) / min(1, np.pi - theta)
            close(found[:20], np.cos(turn) * p + np.sin(turn) * x, rounding)

    @pytest.mark.parametrize("size", [1e-16, 1e-12, 1e-9, 1e-8, 1e-7, 1e-5, 1e-3, 0.1, 0.5])
    @pytest.mark.parametrize("fraction", FRACTIONS)
    def test_is_de_casteljau_for_near_neighbours(self, size: float, fraction: float) -> None:
        u, rng = np.arange(10) / 10, np.random.default_rng(10)
        for d in (3, 4):
            points = HERE if d == 3 else [0.1, 0.7, -0.1, 0.7]
            points = points + size * random_units(6, d, rng=rng)
            points /= np.linalg.norm(points, axis=-1, keepdims=True)
            by_hand = np.concatenate([de_casteljau(c, u) for c in segments(points, fraction)])
            close(closed_curve(points, 10, fraction), by_hand)
            single = points.astype(np.float32)
            by_hand = np.concatenate(
                [de_casteljau(c.astype(float), u) for c in segments(single, fraction)]
            )
            close(closed_curve(single, 10, np.float32(fraction)), by_hand, 1e-6)

    @pytest.mark.parametrize(
        ("size", "dtype", "rounding"),
        [(size, np.float64, 1e-14) for size in (1e-100, 1e-16, 1e-12, 1e-9, 1e-8)]
        + [(size, np.float32, 4e-6) for size in (1e-15, 1e-7, 1e-4)],
    )
    @pytest.mark.parametrize("fraction", FRACTIONS)
    def test_curve_of_nearly_coincident_points_is_the_one_in_the_plane(
        self, size: float, dtype: Any, rounding: float, fraction: float
    ) -> None:
        flat, u = np.random.default_rng(7).normal(size=(7, 2)), np.arange(10) / 10
        points = np.insert(size * flat, 2, 1, axis=1).astype(dtype)
        curve = closed_curve(points, 10, fraction).reshape(7, 10, 3)
        close(curve[..., :2] / size, bezier(flat, fraction, u).swapaxes(0, 1), rounding)

    @pytest.mark.parametrize("gaps", UNEQUAL_GAPS)
    @pytest.mark.parametrize("fraction", [0.2, 1 / 2, 1])
    def test_on_a_great_circle(self, gaps: tuple[float, ...], fraction: float) -> None:
        points = great_circle(np.degrees(np.cumsum([0, *gaps[:2]])))
        turn = np.degrees(turning(gaps, fraction, np.arange(20) / 20))
        close(closed_curve(points, 20, fraction), great_circle(turn))

    @pytest.mark.parametrize("rest", [1e-6, 1e-3, 0.016, 0.1, 0.6, 0.643, 0.644, 0.7, 1])
    def test_inner_control_points_of_any_distance(self, rest: float) -> None:
        points, u = self.with_inner_control_points(rest), np.arange(50) / 50
        by_hand = np.concatenate([de_casteljau(c, u) for c in segments(points, 1 / 2)])
        # `de_casteljau` rounds the control points once more.
        close(closed_curve(points, 50), by_hand, 1e-15 / min(1, rest / 4))

    def test_is_the_loop_of_the_paper_corrected(self) -> None:
        curve = []
        for control in segments(UNEVEN, 1 / 2):
            for step in range(20):
                u, row = step / 20, list(control)
                while len(row) > 1:
                    next_row = []
                    for p, q in pairwise(row):
                        theta = math.acos(max(-1, min(1, sum(p * q))))
                        first, second = math.sin((1 - u) * theta), math.sin(u * theta)
                        next_row.append((first * p + second * q) / math.sin(theta))
                    row = next_row
                curve.append(row[0])
        close(closed_curve(UNEVEN, 20), curve)

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_is_c1_at_the_points(self, points: Array, fraction: float) -> None:
        h = 1e-3

        def derivative(control: Array, u: float) -> Array:
            # Beyond its ends a segment goes on smoothly.
            steps = h * np.array([-2, -1, 1, 2])
            return np.array([1, -8, 8, -1]) / (12 * h) @ de_casteljau(control, u + steps)

        a, _ = control_points(points, fraction)
        parts = segments(points, fraction)
        for i, (left, right) in enumerate(zip(parts, [*parts[1:], parts[0]], strict=True), 1):
            here, handle = points[i % len(points)], a[i % len(points)]
            along = handle - (handle @ here) * here
            length = np.linalg.norm(along)
            speed = 3 * angle_between(here, handle) / (length or 1)
            close(derivative(left, 1), speed * along, 1e-7)
            close(derivative(right, 0), speed * along, 1e-7)

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_turned_points_give_the_turned_curve(self, points: Array, fraction: float) -> None:
        d = points.shape[1]
        turn = np.linalg.qr(np.random.default_rng(d).normal(size=(d, d)))[0]
        close(
            closed_curve(points @ turn, 8, fraction),
            closed_curve(points, 8, fraction) @ turn,
            1e-12,
        )

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_reversed_points_give_the_reversed_curve(self, points: Array, fraction: float) -> None:
        there = closed_curve(points, 8, fraction)
        back = closed_curve(np.roll(points[::-1], 1, axis=0), 8, fraction)
        close(np.roll(back[::-1], 1, axis=0), there, 1e-12)

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_starting_elsewhere_gives_the_same_curve(self, points: Array, fraction: float) -> None:
        later = closed_curve(np.roll(points, -1, axis=0), 8, fraction)
        close(np.roll(later, 8, axis=0), closed_curve(points, 8, fraction), 0)

    @pytest.mark.parametrize("n", [3, 4, 5, 6, 8, 12])
    def test_equally_spaced_on_a_great_circle(self, n: int) -> None:
        at, u, gap = 360 / n * np.arange(n), np.arange(20) / 20, 360 / n
        even = closed_curve(great_circle(at), 20, 1 / 3)
        close(even, great_circle((at[:, None] + u * gap).ravel()))
        # With 1/2 the speed goes from 1.5 gaps a segment to 0.75 and back.
        position = gap * (1.5 * u * (1 - u) ** 2 + 1.5 * u**2 * (1 - u) + u**3)
        close(closed_curve(great_circle(at), 20), great_circle((at[:, None] + position).ravel()))

    @repeatable
    @given(st.lists(units, min_size=3, max_size=6))
    def test_random_points(self, points: list[Array]) -> None:
        try:
            curve = closed_curve(points, 10)
        except DegenerateError:
            assume(False)
        on_the_sphere(curve)
        close(curve[::10], points, 1e-15)

    @pytest.mark.parametrize("samples", [1, 2, 7, 10000])
    def test_samples(self, samples: int) -> None:
        curve = closed_curve(UNEVEN, samples)
        assert curve.shape == (5 * samples, 3)
        close(curve[::samples], UNEVEN, 1e-15)
        close(closed_curve(UNEVEN, np.int64(samples)), curve, 0)

    def test_blocks_make_no_difference(self, monkeypatch: pytest.MonkeyPatch) -> None:
        points = random_units(50, 3)
        whole = closed_curve(points, 10)
        for block in [1, 70, 130, 10**6]:
            monkeypatch.setattr(interpolation, "BLOCK", block)
            close(closed_curve(points, 10), whole, 1e-15)

    def test_stacks(self) -> None:
        points = random_units(2, 3, 5, 4)
        curves = closed_curve(points, 6)
        assert curves.shape == (2, 3, 30, 4)
        for i in np.ndindex(2, 3):
            close(curves[i], closed_curve(points[i], 6), 1e-15)
        assert closed_curve(np.ones((0, 5, 3)), 6).shape == (0, 30, 3)

    def test_the_points_are_left_alone(self) -> None:
        points = UNEVEN.copy()
        closed_curve(points)[:] = 0
        control_points(points)[0][:] = 0
        slerp(points, points, 0)[:] = 0
        close(points, UNEVEN, 0)

    @staticmethod
    def with_inner_control_points(rest: float) -> Array:
        """Points for which a_0 and b_1 are this short of antipodal: half a turn exchanges them."""
        half_turn = np.array([-1, -1, 1])
        a0 = np.array([np.cos(rest / 2), 0, np.sin(rest / 2)])
        p0 = np.array([0.4, 0.8, 0.2**0.5])
        p1 = half_turn * p0
        p3 = double(double(p1, double(p0, a0)), p0)
        return np.array([p0, p1, half_turn * p3, p3])

    def test_inner_control_points_can_be_antipodal(self) -> None:
        points = self.with_inner_control_points(0)
        a, b = control_points(points)
        close(a[0], E1)
        close(b[1], -E1)
        which = r"control points a and b between points\[0\] and points\[1\]"
        with pytest.raises(
            DegenerateError, match=f"^{which} are antipodal: no unique arc joins them$"
        ):
            closed_curve(points)
        which = r"control points a and b between points\[3\] and points\[0\]"
        with pytest.raises(DegenerateError, match=f"^{which} are antipodal"):
            closed_curve(np.roll(points, -1, axis=0))

    @pytest.mark.parametrize("rest", [1e-6, 1e-3, np.radians(0.99)])
    def test_nearly_antipodal_inner_control_points_are_warned_of(self, rest: float) -> None:
        points = self.with_inner_control_points(rest)
        which = r"control points a and b between points\[0\] and points\[1\]"
        with pytest.warns(UserWarning, match=f"^{which} are almost antipodal: data") as caught:
            curve = closed_curve(points)
        assert caught[0].filename == __file__
        on_the_sphere(curve)
        close(curve[::100], points, 1e-15)
        # Across the line the curve changes sides.
        with pytest.warns(UserWarning, match="almost"):
            other = closed_curve(self.with_inner_control_points(-rest))
        assert angle_between(curve[50], other[50]) > 2

    def test_others_are_not(self) -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            closed_curve(self.with_inner_control_points(np.radians(1.01)))
            closed_curve(UNEVEN)


class TestOrientations:
    R1, R2 = (Rotation.random(300, rng=RNG).as_matrix() for _ in range(2))
    ROUND = rotation_matrix([1, 2, 2], np.arange(5) * 2 * np.pi / 5)

    @staticmethod
    def gentle(n: int) -> tuple[Quaternion, Array]:
        """Orientations that turn by less than a quarter, as quaternions whose signs agree."""
        axes, sizes = random_units(n, 3), RNG.uniform(0.1, 0.5, n)
        q = Quaternion.from_axis_angle(E3, 0.3) * Quaternion.from_axis_angle(axes, sizes)
        return q, q.matrix()

    def test_against_scipy(self) -> None:
        t = [0, 0.2, 0.7, 1]
        for r1, r2 in zip(self.R1[:50], self.R2[:50], strict=True):
            oracle = Slerp([0, 1], Rotation.from_matrix([r1, r2]))(t).as_matrix()
            close(slerp_rotations(r1, r2, t), oracle, 1e-13)

    def test_laws(self) -> None:
        t = RNG.uniform(0, 1, 300)
        turns = slerp_rotations(self.R1, self.R2, t)
        close(turns.mT @ turns, np.broadcast_to(np.eye(3), turns.shape))
        close(np.linalg.det(turns), 1)
        whole = axis_angle(self.R1.mT @ self.R2)[1]
        close(axis_angle(self.R1.mT @ turns)[1], t * whole, 1e-13)
        close(slerp_rotations(self.R2, self.R1, 1 - t), turns, 1e-13)
        close(slerp_rotations(self.R1, self.R2, 0), self.R1, 1e-15)
        close(slerp_rotations(self.R1, self.R2, 1), self.R2, 4e-15)
        twice = self.R2 @ self.R1.mT @ self.R2
        close(slerp_rotations(self.R1, self.R2, 2), twice, 1e-13)

    def test_is_slerp_of_quaternions(self) -> None:
        p, q = Quaternion.from_matrix(self.R1), Quaternion.from_matrix(self.R2)
        sign = np.sign(np.sum(p.components * q.components, axis=-1))
        components = slerp(p.components, sign[:, None] * q.components, 0.3)
        by_quaternions = Quaternion(components[:, 0], components[:, 1:]).matrix()
        close(slerp_rotations(self.R1, self.R2, 0.3), by_quaternions, 1e-13)

    @pytest.mark.parametrize("rest", [1e-2, 1e-6, 1e-9, 1e-12])
    def test_nearly_half_a_turn(self, rest: float) -> None:
        r1, axis = self.R1[0], np.array([2, 3, 6]) / 7
        r2 = r1 @ rotation_matrix(axis, np.pi - rest)
        expected = r1 @ rotation_matrix(axis, (np.pi - rest) / 4)
        close(slerp_rotations(r1, r2, 0.25), expected)

    def test_half_a_turn(self) -> None:
        with pytest.raises(DegenerateError, match=r"^r1 and r2 are half a turn apart: no unique"):
            slerp_rotations(np.eye(3), np.diag([1, -1, -1]), 0.5)
        turned = self.R1 @ rotation_matrix(random_units(300, 3), np.pi)
        for r1, r2 in zip(self.R1, turned, strict=True):
            with pytest.raises(DegenerateError):
                slerp_rotations(r1, r2, 0.5)
        with pytest.raises(DegenerateError):
            slerp_rotations(np.eye(3), rotation_matrix([1, 2, 2], np.pi - 5e-15), 0.5)
        with pytest.raises(DegenerateError, match=r"^r1 and r2 at index \(1,\) are half a turn"):
            slerp_rotations(np.eye(3), [np.eye(3), np.diag([-1, -1, 1])], 0.5)

    def test_no_turn(self) -> None:
        close(slerp_rotations(self.R1, self.R1, 0.3), self.R1, 3e-15)

    @pytest.mark.parametrize(("theta", "dtype"), LENGTHS_AND_DTYPES)
    def test_closed_curve_with_turns_of_any_size(self, theta: float, dtype: Any) -> None:
        # As for points: the turns of the first segment are of 3 u^2 - 2 u^3 times theta.
        u, axes = np.arange(20) / 20, random_units(20, 3, rng=np.random.default_rng(20))
        for start, axis in zip(self.R1[:20], axes, strict=True):
            turn = theta * np.array([0, 1, 0.6])
            rotations = start @ Rotation.from_rotvec(turn[:, None] * axis).as_matrix()
            rotations[2] = rotations[2] @ rotation_matrix(np.roll(axis, 1), 0.7)
            found = closed_rotation_curve(rotations.astype(dtype), 20, 0)
            assert found.dtype == dtype
            part = theta * (3 * u**2 - 2 * u**3)
            expected = start @ Rotation.from_rotvec(part[:, None] * axis).as_matrix()
            close(found[:20], expected, 3e-6 if dtype == np.float32 else 1e-14)

    @pytest.mark.parametrize("gaps", UNEQUAL_GAPS)
    @pytest.mark.parametrize("fraction", [0.2, 1 / 2, 1])
    def test_closed_curve_about_one_axis(self, gaps: tuple[float, ...], fraction: float) -> None:
        # With 1 an arc at the start, and so one of each level, is longer than 2.5.
        start, axis = self.R1[0], [2, 3, 6]
        rotations = rotation_matrix(axis, np.cumsum([0, *gaps[:2]])) @ start
        turn = turning(gaps, fraction, np.arange(20) / 20)
        found = closed_rotation_curve(rotations, 20, fraction)
        close(found, rotation_matrix(axis, turn) @ start)

    @pytest.mark.parametrize("fraction", FRACTIONS)
    def test_closed_curve_is_made_of_rotation_arcs(self, fraction: float) -> None:
        u = np.arange(10) / 10
        longest = []
        for seed in range(12):
            here = Rotation.random(6, rng=np.random.default_rng(seed)).as_matrix()
            before, after = np.roll(here, 1, axis=0), np.roll(here, -1, axis=0)
            middle = slerp_rotations(here @ before.mT @ here, after, 0.5)
            a = slerp_rotations(here, middle, fraction)
            b = here @ a.mT @ here
            row = [here, a, np.roll(b, -1, axis=0), after]
            longest += [axis_angle(p.mT @ q)[1] for p, q in pairwise(row)]
            row = [control[:, None] for control in row]
            while len(row) > 1:
                row = [slerp_rotations(p, q, u) for p, q in pairwise(row)]
            close(closed_rotation_curve(here, 10, fraction), row[0].reshape(60, 3, 3), 1e-13)
        assert np.max(longest) > 3

    @pytest.mark.parametrize(
        ("size", "dtype", "rounding"),
        [(size, np.float64, 1e-14) for size in (1e-100, 1e-16, 1e-12, 1e-9)]
        + [(size, np.float32, 4e-6) for size in (1e-15, 1e-7)],
    )
    def test_closed_curve_of_tiny_turns_is_the_one_of_their_axes(
        self, size: float, dtype: Any, rounding: float
    ) -> None:
        turns, u = np.random.default_rng(7).normal(size=(7, 3)), np.arange(10) / 10
        x, y, z = size * turns.T
        rotations = np.empty((7, 3, 3), dtype)
        rotations[:] = np.eye(3)
        rotations[:, [2, 0, 1], [1, 2, 0]] = np.stack([x, y, z], axis=1)
        rotations[:, [1, 2, 0], [2, 0, 1]] = -np.stack([x, y, z], axis=1)
        curve = closed_rotation_curve(rotations, 10).reshape(7, 10, 3, 3)
        found = (curve - curve.mT)[..., [2, 0, 1], [1, 2, 0]] / (2 * size)
        close(found, bezier(turns, 1 / 2, u).swapaxes(0, 1), rounding)

    def test_closed_curve_of_equal_orientations(self) -> None:
        for dtype, rounding in [(np.float64, 1e-14), (np.float32, 2e-6)]:
            same = np.stack([self.R1[0]] * 4).astype(dtype)
            close(closed_rotation_curve(same, 5), [same[0]] * 20, rounding)

    @pytest.mark.parametrize("fraction", FRACTIONS)
    def test_closed_curve_is_that_of_quaternions_whose_signs_agree(self, fraction: float) -> None:
        q, matrices = self.gentle(20)
        components = closed_curve(q.components, 10, fraction)
        expected = Quaternion(components[:, 0], components[:, 1:]).matrix()
        close(closed_rotation_curve(matrices, 10, fraction), expected, 1e-13)

    def test_laws_of_the_closed_curve(self) -> None:
        _, matrices = self.gentle(7)
        curve = closed_rotation_curve(matrices, 20)
        assert curve.shape == (140, 3, 3)
        close(curve[::20], matrices, 1e-15)
        close(curve.mT @ curve, np.broadcast_to(np.eye(3), curve.shape))
        turn = self.R1[0]
        close(closed_rotation_curve(turn @ matrices, 20), turn @ curve, 1e-13)
        close(closed_rotation_curve(matrices @ turn, 20), curve @ turn, 1e-13)
        back = closed_rotation_curve(np.roll(matrices[::-1], 1, axis=0), 20)
        close(np.roll(back[::-1], 1, axis=0), curve, 1e-13)

    def test_is_c1(self) -> None:
        _, matrices = self.gentle(5)
        curve = closed_rotation_curve(matrices, 4000)
        left = (curve[4000::4000] - curve[3999:-1:4000]) * 4000
        right = (curve[4001::4000] - curve[4000::4000]) * 4000
        close(left, right, 0.01)
        assert np.abs(left).max() > 0.3

    def test_turning_right_round(self) -> None:
        # Five quaternions whose signs agree end at the opposite of the first.
        curve = closed_rotation_curve(self.ROUND, 10, 1 / 3)
        close(curve, rotation_matrix([1, 2, 2], np.arange(50) * 2 * np.pi / 50))
        half = closed_rotation_curve(self.ROUND, 10)
        steps = axis_angle(half.mT @ np.roll(half, -1, axis=0))[1]
        close(steps.sum(), 2 * np.pi)

    def test_quaternions_need_agreeing_signs_where_matrices_do_not(self) -> None:
        q = Quaternion.from_axis_angle([1, 2, 2], np.arange(5) * 2 * np.pi / 5)
        match = r"^Double\(points\[4\], points\[0\]\) and points\[1\] are antipodal"
        with pytest.raises(DegenerateError, match=match):
            closed_curve(q.components)

    def test_a_point_carried_along_is_not_the_curve_of_the_points(self) -> None:
        # Twist about the pointing vector is lost on the sphere.
        twisted = rotation_matrix(E3, [0, 0.5, 1.0])
        close(closed_curve(twisted[:, :, 2], 10), [E3] * 30, 1e-15)
        assert np.abs(closed_rotation_curve(twisted, 10) - np.eye(3)).max() > 0.8

    def test_degenerate(self) -> None:
        half = np.diag([1.0, -1, -1])
        match = (
            r"^Double\(rotations\[2\], rotations\[0\]\) and rotations\[1\] are half a turn apart"
        )
        with pytest.raises(DegenerateError, match=match):
            closed_rotation_curve([np.eye(3), half, np.eye(3)])
        same = closed_rotation_curve([np.eye(3)] * 3, 5)
        close(same, [np.eye(3)] * 15, 1e-15)
        stops = rotation_matrix(E3, [0, 0.5, 0, -0.5])
        close(closed_rotation_curve(stops, 5)[::5], stops, 1e-15)

    def test_stacks(self) -> None:
        matrices = np.stack([self.gentle(5)[1] for _ in range(6)]).reshape(2, 3, 5, 3, 3)
        curves = closed_rotation_curve(matrices, 4)
        assert curves.shape == (2, 3, 20, 3, 3)
        close(curves[1, 2], closed_rotation_curve(matrices[1, 2], 4), 1e-15)
        assert closed_rotation_curve(np.empty((0, 5, 3, 3)), 4).shape == (0, 20, 3, 3)


class TestAgainstSplines:
    def test_closed_curve_of_quaternions(self) -> None:
        points = random_units(6, 4)
        for fraction in FRACTIONS:
            control = [
                [UnitQuaternion.from_unit_xyzw(np.roll(q, -1)) for q in part]
                for part in segments(points, fraction)
            ]
            curve = DeCasteljau(control).evaluate(np.arange(60) / 10)
            expected = [[q.scalar, *q.vector] for q in curve]
            close(closed_curve(points, 10, fraction), expected, 1e-12)


class TestCounts:
    def test_of_the_code(self) -> None:
        assert count(double, E1, HERE) == OperationCount(7, 5)
        plain, turned = count(slerp, E1, HERE, 0.3), count(slerp_by_rotation, E1, HERE, 0.3)
        assert plain.multiplications < turned.multiplications
        assert plain.additions < turned.additions

    def test_everything_can_be_counted(self) -> None:
        for f in [angle_between, arc_axis, bisect, bisect_by_rotation, double_by_rotation]:
            assert count(f, E1, HERE).multiplications > 0
        curve = count(lambda points: closed_curve(points, 2), UNEVEN)
        assert curve.trigonometric >= 5 * 2 * 6
        turns = rotation_matrix([1, 2, 2], np.arange(3))
        assert count(lambda r: closed_rotation_curve(r, 2), turns).multiplications > 0

    def test_out_and_back_costs_as_much_as_other_ways(self) -> None:
        """There a_i is P_i: angles are zero, and arrays of floats are clipped."""
        out_and_back = np.array([E1, UNEVEN[1], E1, UNEVEN[2]]) * (1 + 1e-15)
        with np.errstate(invalid="ignore"):
            found = count(lambda p: closed_curve(p, 2), out_and_back)
        assert found == count(lambda p: closed_curve(p, 2), UNEVEN[:4])
        here, turned = (rotation_matrix([1, 2, 2], k * np.arange(4)) for k in (0, 1))
        with np.errstate(invalid="ignore"):
            found = count(lambda r: closed_rotation_curve(r, 2), here)
        assert found == count(lambda r: closed_rotation_curve(r, 2), turned)

    def test_results_are_those_of_the_floats(self) -> None:
        results: list[Any] = []
        count(lambda points: results.append(closed_curve(points, 3)), UNEVEN)
        found = np.vectorize(lambda scalar: scalar.value, otypes=[float])(results[0])
        close(found, closed_curve(UNEVEN, 3), 1e-15)


class TestShapes:
    @pytest.mark.parametrize(
        ("p", "q", "t", "expected"),
        [
            ((3,), (3,), (), (3,)),
            ((7, 3), (3,), (), (7, 3)),
            ((3,), (7, 3), (), (7, 3)),
            ((3,), (3,), (7,), (7, 3)),
            ((5, 1, 3), (7, 3), (), (5, 7, 3)),
            ((7, 3), (2, 1, 1, 3), (5, 1), (2, 5, 7, 3)),
            ((3, 3), (3,), (3, 1), (3, 3, 3)),
            ((0, 3), (3,), (), (0, 3)),
        ],
    )
    def test_broadcasting_is_a_loop(self, p: Any, q: Any, t: Any, expected: Any) -> None:
        p, q, t = RNG.normal(size=p), RNG.normal(size=q), RNG.uniform(size=t)
        pairs = np.broadcast_shapes(p.shape, q.shape)
        for f in [slerp, slerp_by_rotation]:
            assert f(p, q, t).shape == expected
        for f in [double, double_by_rotation, bisect, bisect_by_rotation, arc_axis]:
            assert f(p, q).shape == pairs
        assert angle_between(p, q).shape == pairs[:-1]
        results = slerp(p, q, t), slerp_by_rotation(p, q, t)
        p, q = np.broadcast_to(p, expected), np.broadcast_to(q, expected)
        t = np.broadcast_to(t, expected[:-1])
        for i in np.ndindex(expected[:-1]):
            for f, found in zip([slerp, slerp_by_rotation], results, strict=True):
                close(found[i], f(p[i], q[i], t[i]), 1e-15)

    def test_sequences_and_integers(self) -> None:
        close(slerp((1, 0, 0), np.array([0, 5, 0]), 1), E2, 1e-15)
        close(closed_curve(np.eye(3, dtype=int), 5), closed_curve(np.eye(3), 5), 0)


class TestSinglePrecision:
    points = UNEVEN.astype(np.float32)

    def test_is_kept(self) -> None:
        p, q = self.points[:2]
        found = [
            angle_between(p, q),
            arc_axis(p, q),
            slerp(p, q, 0.3),
            slerp(p, [1, 2, 3], np.float32(0.3)),
            slerp_by_rotation(p, q, 0.3),
            slerp_by_rotation(p, p, 0.3),
            double(p, q),
            double_by_rotation(p, q),
            bisect(p, q),
            bisect_by_rotation(p, q),
            *control_points(self.points),
            de_casteljau(self.points, 0.3),
            *de_casteljau_levels(self.points, [0.3, 0.4]),
            closed_curve(self.points),
            slerp_rotations(np.eye(3, dtype=np.float32), np.eye(3, dtype=np.float32), 0.3),
            closed_rotation_curve(rotation_matrix(E3, [0, 1, 2]).astype(np.float32)),
        ]
        assert {x.dtype for x in found} == {np.dtype(np.float32)}
        assert slerp(p, q, np.float64(0.3)).dtype == slerp(p, E1, 0.3).dtype == np.float64

    def test_is_right_to_its_digits(self) -> None:
        close(closed_curve(self.points), closed_curve(UNEVEN), 2e-6)
        on_the_sphere(closed_curve(self.points), 5e-7)
        close(control_points(self.points)[0], control_points(UNEVEN)[0], 2e-6)
        matrices = TestOrientations.ROUND
        single = closed_rotation_curve(matrices.astype(np.float32), 5)
        close(single, closed_rotation_curve(matrices, 5), 3e-6)

    def test_antipodal_to_half_of_its_digits(self) -> None:
        p, q = np.float32([[1, 0, 0], [-1, 1e-4, 0]])
        with pytest.raises(DegenerateError):
            slerp(p, q, 0.5)
        slerp(p.astype(float), q, 0.5)


POINTS_OF = [
    (f, name)
    for f in [angle_between, arc_axis, double, double_by_rotation, bisect, bisect_by_rotation]
    for name in ("p", "q")
]
GOOD: dict[Any, dict[str, Any]] = {f: {"p": E1, "q": E2} for f, _ in POINTS_OF}
GOOD |= {f: {"p": E1, "q": E2, "t": 0.5} for f in (slerp, slerp_by_rotation)}
GOOD |= {control_points: {"points": np.eye(3), "fraction": 0.5}}
GOOD |= {closed_curve: {"points": np.eye(3), "fraction": 0.5}}
GOOD |= {f: {"control": np.eye(3), "u": 0.5} for f in (de_casteljau, de_casteljau_levels)}
GOOD |= {slerp_rotations: {"r1": np.eye(3), "r2": np.eye(3), "t": 0.5}}
GOOD |= {closed_rotation_curve: {"rotations": np.stack([np.eye(3)] * 3), "fraction": 0.5}}
ARGUMENTS = [(f, name) for f, arguments in GOOD.items() for name in arguments]
VECTORS = [(f, name) for f, name in ARGUMENTS if name in ("p", "q", "points", "control")]


class TestRefusals:
    def test_everything_public_is_tested_here(self) -> None:
        assert {f.__name__ for f in GOOD} == set(interpolation.__all__)

    @pytest.mark.parametrize(("f", "name"), ARGUMENTS)
    def test_not_finite_and_not_numbers(self, f: Any, name: str) -> None:
        for bad in [np.nan, np.inf]:
            value = np.array(GOOD[f][name], float)
            value[(-1,) * value.ndim] = bad
            with pytest.raises(ValueError, match=f"^{name} must be finite in float64; got {bad}"):
                f(**GOOD[f] | {name: value})
        for text in ["text", [None, None, 1j], True]:
            with pytest.raises(ValueError, match=f"^{name} must be an array of real numbers"):
                f(**GOOD[f] | {name: text})

    @pytest.mark.parametrize(("f", "name"), VECTORS)
    def test_zero_vectors(self, f: Any, name: str) -> None:
        value = np.array(GOOD[f][name], float)
        value[..., :] = 0
        with pytest.raises(ValueError, match=f"^{name} must not be the zero vector; got zeros"):
            f(**GOOD[f] | {name: value})

    def test_no_dimension(self) -> None:
        with pytest.raises(ValueError, match=r"^points must not be the zero vector"):
            closed_curve(np.empty((3, 0)))

    @pytest.mark.parametrize("f", [angle_between, slerp, double, bisect])
    def test_different_dimensions(self, f: Any) -> None:
        match = r"^q must have shape \(..., 3\); got shape \(2,\)$"
        with pytest.raises(ValueError, match=match):
            f(**GOOD[f] | {"q": [1, 0]})
        with pytest.raises(ValueError, match=r"^p must have shape \(..., d\); got shape \(\)$"):
            f(**GOOD[f] | {"p": 1})

    @pytest.mark.parametrize(
        "f", [arc_axis, slerp_by_rotation, double_by_rotation, bisect_by_rotation]
    )
    def test_axes_need_three_dimensions(self, f: Any) -> None:
        with pytest.raises(ValueError, match=r"^p must have shape \(..., 3\); got shape \(4,\)$"):
            f(**GOOD[f] | {"p": [1, 0, 0, 0], "q": [0, 1, 0, 0]})

    def test_shapes_that_do_not_broadcast(self) -> None:
        with pytest.raises(ValueError, match=r"^p and q and t must broadcast over"):
            slerp(PAIRS[0, :4], PAIRS[1, :5], 0.5)
        with pytest.raises(ValueError, match=r"^control and u must broadcast over"):
            de_casteljau(random_units(5, 4, 3), [0.1, 0.2])

    @pytest.mark.parametrize("n", [0, 1, 2])
    def test_fewer_than_three_points(self, n: int) -> None:
        match = f"must be at least 3 to make a closed curve; got {n}$"
        for f in [control_points, closed_curve]:
            with pytest.raises(ValueError, match=f"^points {match}"):
                f(np.eye(3)[:n])
        with pytest.raises(ValueError, match=f"^rotations {match}"):
            closed_rotation_curve(np.stack([np.eye(3)] * 3)[:n])

    @pytest.mark.parametrize("f", [control_points, closed_curve])
    def test_not_a_sequence_of_points(self, f: Any) -> None:
        with pytest.raises(
            ValueError, match=r"^points must have shape \(..., n, d\); got .*\(3,\)$"
        ):
            f(E1)

    def test_not_a_sequence_of_matrices(self) -> None:
        with pytest.raises(ValueError, match=r"^rotations must have shape \(..., n, 3, 3\); got"):
            closed_rotation_curve(np.eye(3))
        with pytest.raises(ValueError, match=r"^r1 must have shape \(..., 3, 3\); got"):
            slerp_rotations(np.eye(4), np.eye(3), 0)

    def test_not_rotations(self) -> None:
        with pytest.raises(ValueError, match=r"^r1 must be a rotation: "):
            slerp_rotations(2 * np.eye(3), np.eye(3), 0)
        with pytest.raises(ValueError, match=r"^r2 must be a rotation: .* it reflects$"):
            slerp_rotations(np.eye(3), -np.eye(3), 0)
        with pytest.raises(ValueError, match=r"^rotations must be a rotation: .* at index \(1,\)$"):
            closed_rotation_curve([np.eye(3), 2 * np.eye(3), np.eye(3)])

    @pytest.mark.parametrize("samples", [0, -1, 2.0, 2.5, "2", None, [2]])
    def test_samples(self, samples: Any) -> None:
        matrices = np.stack([np.eye(3)] * 3)
        for f, data in [(closed_curve, np.eye(3)), (closed_rotation_curve, matrices)]:
            with pytest.raises(ValueError) as caught:  # noqa: PT011
                f(data, samples)
            assert str(caught.value) == f"samples must be a positive integer; got {samples!r}"

    @pytest.mark.parametrize("fraction", [-0.1, 1.5, [0.5, 0.5]])
    def test_fraction(self, fraction: Any) -> None:
        matrices = np.stack([np.eye(3)] * 3)
        for f, data in [
            (control_points, np.eye(3)),
            (closed_curve, np.eye(3)),
            (closed_rotation_curve, matrices),
        ]:
            with pytest.raises(ValueError, match=r"^fraction must be one number from 0 to 1; got"):
                f(data, fraction=fraction)

    def test_no_control_points(self) -> None:
        with pytest.raises(ValueError, match=r"^control must have one point at least; got none$"):
            de_casteljau(np.empty((0, 3)), 0.5)
