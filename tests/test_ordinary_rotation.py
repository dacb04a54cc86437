"""Section 3: (3-1), (3-2), (3-3) and the inverse, against sympy, scipy and their own laws."""

from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from spheres import AXES, POINTS, UNITS, Array, close, vectors
from symbolic import matrix, symbolic

from rotedu.cost import OperationCount, count
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import (
    axis_angle,
    rotate,
    rotation_matrix,
    sixteen_products,
    transform,
)

RNG = np.random.default_rng(31)
ALL_ANGLES = [0, 1e-300, 1e-12, 1e-9, 1e-8, 1e-4, 0.5, np.pi / 2, 2 * np.pi / 3, 3]
ALL_ANGLES += [np.pi - 1e-4, np.pi - 1e-8, np.pi - 1e-9, np.pi]


def oracle(axis: Array, angle: Any) -> Array:
    angle = np.asarray(angle)
    return Rotation.from_rotvec(axis * angle[..., None]).as_matrix()


class TestAgainstScipy:
    @pytest.mark.parametrize("angle", [*ALL_ANGLES, -1.0, 7.0, -np.pi])
    def test_any_axis(self, angle: float) -> None:
        close(rotation_matrix(AXES, angle), oracle(AXES, angle))
        close(rotate(POINTS, AXES, angle), Rotation.from_rotvec(angle * AXES).apply(POINTS))

    @given(vectors(100), UNITS, st.floats(-10, 10), st.floats(-300, 300))
    def test_any_rotation(self, r: Array, n: Array, a: float, exponent: float) -> None:
        scaled = n * 10.0**exponent
        close(rotation_matrix(scaled, a), oracle(n, a), 1e-13)
        close(rotate(r, scaled, a), oracle(n, a) @ r, 1e-11)
        close(transform(rotation_matrix(n, a), r), rotate(r, n, a), 1e-12)

    @pytest.mark.parametrize("scale", [5e-324, 1e-320, 1e-160, 1e160, 1.7e308])
    def test_length_of_the_axis_neither_overflows_nor_underflows(self, scale: float) -> None:
        close(rotate([1, 0, 0], scale * np.ones(3), 2 * np.pi / 3), [0, 1, 0])
        close(rotation_matrix(scale * np.ones(3), 1.0), rotation_matrix([1, 1, 1], 1.0), 0)

    @pytest.mark.parametrize("angle", [1e-300, 1e-12, 1e-9, 1e-8])
    def test_small_turns_are_not_lost(self, angle: float) -> None:
        # To first order the point moves by angle * (n x r); 1 - cos is of second order.
        moved = rotate([0, 1, 0], [0, 0, 1], angle)
        assert moved[0] == pytest.approx(-angle, rel=1e-15)
        assert rotation_matrix([0, 0, 1], angle)[1, 0] == pytest.approx(angle, rel=1e-15)


class TestAxisAngle:
    @pytest.mark.parametrize("angle", [a for a in ALL_ANGLES if 0 < a < np.pi])
    def test_come_back(self, angle: float) -> None:
        axis, found = axis_angle(rotation_matrix(AXES, angle))
        close(axis, AXES, 2e-15)
        np.testing.assert_allclose(found, angle, rtol=1e-14 if angle < 1e-3 else 0, atol=2e-15)

    def test_no_rotation_has_the_documented_axis(self) -> None:
        axis, angle = axis_angle(rotation_matrix(AXES, 0))
        assert (angle == 0).all()
        assert (axis == [1, 0, 0]).all()

    def test_at_a_half_turn_the_first_component_is_positive(self) -> None:
        lead = np.array([n[np.flatnonzero(n)[0]] for n in AXES])
        axis, angle = axis_angle(rotation_matrix(AXES, np.pi))
        close(axis, AXES * np.sign(lead)[:, None], 2e-15)
        assert (angle == np.pi).all()

    def test_exact_half_turns(self) -> None:
        axes, angles = axis_angle([*map(np.diag, 2 * np.eye(3) - 1), -np.eye(3)[[0, 2, 1]]])
        close(axes, [*np.eye(3), [0, 0.5**0.5, -(0.5**0.5)]], 1e-15)
        assert (angles == np.pi).all()


class TestSixteenProducts:
    @pytest.mark.parametrize("angle", ALL_ANGLES)
    def test_are_those_of_the_quaternion(self, angle: float) -> None:
        q = np.column_stack([np.full(len(AXES), np.cos(angle / 2)), np.sin(angle / 2) * AXES])
        close(sixteen_products(oracle(AXES, angle)), 4 * q[:, :, None] * q[:, None])

    def test_row_worked_in_chapter_3(self) -> None:
        """By hand from four decimals, where the textbook's row is almost lost."""
        exact = rotation_matrix([2, 6, 9], np.radians(179.9))
        m = exact.round(4)
        last = 1 - m[0, 0] - m[1, 1] + m[2, 2]
        row = [m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], last]
        close(row, [0.0029, 0.5951, 1.7851, 2.6777], 1e-12)
        close(row, sixteen_products(exact)[3], 2e-4)


class TestTransform:
    matrix = rotation_matrix([1, 2, 3], 0.4)
    affine = np.vstack([np.column_stack([matrix, [1, 2, 3]]), [0, 0, 0, 1]])
    projective = np.vstack([affine[:3], [0.1, 0.2, 0.3, 4]])

    def homogeneous(self, matrix: Array, points: Array) -> Array:
        result = np.einsum("...ij,...j->...i", matrix, np.insert(points, 3, 1, axis=-1))
        return np.asarray(result[..., :3] / result[..., 3:])

    @pytest.mark.parametrize("shape", [(3,), (7, 3), (2, 5, 3), (0, 3)])
    def test_one_matrix_for_all_points(self, shape: tuple[int, ...]) -> None:
        r = RNG.normal(size=shape)
        close(transform(self.matrix, r), np.einsum("ij,...j->...i", self.matrix, r))
        for m in (self.affine, self.projective, -3 * self.affine):
            close(transform(m, r), self.homogeneous(m, r))

    def test_stacks(self) -> None:
        r = RNG.normal(size=(5, 3))
        for matrices in [
            rotation_matrix(AXES[8:13], 1.0),
            np.stack([self.affine, self.projective] * 2 + [self.affine]),
            np.stack([self.affine] * 5),
        ]:
            every = np.stack([transform(m, r) for m in matrices])
            close(transform(matrices[:, None], r), every)
            close(transform(matrices, r), every[np.arange(5), np.arange(5)])
            close(transform(matrices, r[0]), every[:, 0])

    def test_points_at_infinity_are_named(self) -> None:
        camera = np.eye(4)[[0, 1, 2, 2]]
        for m, points, message in [
            (camera, [1, 2, 0], r"^matrix sends 1 of 1 points to infinity$"),
            (camera, [[[1, 2, 3], [1, 2, 1]], [[1, 2, 0], [0, 0, 0]]], r"2 of 4 .* \(1, 0\)$"),
            (np.stack([np.eye(4), camera]), [1, 2, 0], r"1 of 2 points .* at index \(1,\)$"),
        ]:
            with pytest.raises(DegenerateError, match=message):
                transform(m, points)

    def test_however_many_points_lie_in_memory(self) -> None:
        many = RNG.normal(size=(2001, 2, 3))
        for points in [many[1:], np.asfortranarray(many), many[::-1, 1, ::-1]]:
            close(transform(self.matrix, points), points @ self.matrix.T)
            for m in (self.affine, self.projective):
                moved = self.homogeneous(m, points)
                close(transform(m, points), moved)
                close(transform(m.astype("f4"), points.astype("f4")), moved, 2e-5)

    def test_an_affine_matrix_costs_no_division(self) -> None:
        assert count(transform, self.affine, [1, 2, 3]) == OperationCount(9, 9)
        assert count(transform, self.projective, [1, 2, 3]) == OperationCount(12, 12, divisions=3)


class TestSinglePrecision:
    @pytest.mark.parametrize("angle", [0, 1e-30, 1e-6, 0.5, 2.5, np.pi - 1e-3, np.pi])
    def test_is_right_to_its_digits(self, angle: float) -> None:
        n = AXES.astype(np.float32)
        m = rotation_matrix(n, angle)
        close(m, oracle(AXES, angle), 1e-6)
        close(rotate(POINTS.astype(np.float32), n, angle), rotate(POINTS, AXES, angle), 3e-6)
        axis, found = axis_angle(m)
        close(found, angle, 1e-6)
        close(rotation_matrix(axis, found), m, 1e-6)

    def test_extreme_axes(self) -> None:
        r = np.eye(3, dtype=np.float32)
        for scale in [1e-38, 1e38]:
            close(rotate(r, [0, scale, 0], 0), r, 0)
        with pytest.raises(ValueError, match="axis must be finite in float32; got inf"):
            rotate(r, [0, 0, 1e200], 0.3)
        with pytest.raises(ValueError, match="axis must not be the zero vector"):
            rotate(r, [0, 0, 1e-200], 0.3)


class TestProofs:
    """The same code, run on symbols, so the results hold for all axes and angles."""

    n = sp.symbols("n_u n_v n_w", real=True)
    r = sp.symbols("r_u r_v r_w", real=True)
    theta = sp.Symbol("theta", real=True)
    given = symbolic(*n), symbolic(theta)
    rodrigues = matrix(rotate(symbolic(*r), *given))
    by_entries = matrix(rotation_matrix(*given))

    def is_zero(self, expression: Any) -> bool:
        """Whether an expression vanishes modulo |n| = 1 and cos^2 + sin^2 = 1."""
        c, s = sp.symbols("c s")
        polynomial = sp.expand(expression.subs({sp.cos(self.theta): c, sp.sin(self.theta): s}))
        laws = [sum(x**2 for x in self.n) - 1, c**2 + s**2 - 1]
        return bool(sp.reduced(polynomial, laws, self.n[0], s)[1] == 0)

    @pytest.mark.equation("3-3")
    def test_matrix_times_vector_is_rodrigues_formula(self) -> None:
        assert (self.by_entries * sp.Matrix(self.r) - self.rodrigues).expand() == sp.zeros(3, 1)

    @pytest.mark.equation("3-2")
    def test_transform_is_the_matrix_product(self) -> None:
        m = sp.Matrix(3, 3, sp.symbols("m:9"))
        product = sp.Matrix(transform(m, self.r))
        assert (product - m * sp.Matrix(self.r)).expand() == sp.zeros(3, 1)

    def test_matrix_is_a_rotation_by_the_angle_about_the_axis(self) -> None:
        m, n = self.by_entries, sp.Matrix(self.n)
        skew = sp.Matrix([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]])
        for zero in [
            *(m.T * m - sp.eye(3)),
            m.det() - 1,
            *(m * n - n),
            m.trace() - 1 - 2 * sp.cos(self.theta),
            *(skew - 2 * sp.sin(self.theta) * n),
        ]:
            assert self.is_zero(zero)
        assert not self.is_zero(m[0, 1])

    @pytest.mark.equation("3-1")
    def test_the_first_line_of_3_1_is_the_second(self) -> None:
        r, n = sp.Matrix(self.r), sp.Matrix(self.n)
        along = r.dot(n) * n
        cos, sin = sp.cos(self.theta), sp.sin(self.theta)
        first = along + cos * (r - along) + sin * n.cross(r)
        assert (first - self.rodrigues).expand() == sp.zeros(3, 1)
