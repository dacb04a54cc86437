"""Section 3: (3-1), (3-2), (3-3) and the inverse, against sympy, scipy and their own laws."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation
from spheres import Array, close, random_units

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
SMALL = [0, 1e-300, 1e-12, 1e-9, 1e-8, 1e-4]
NEAR_PI = [np.pi - 1e-4, np.pi - 1e-8, np.pi - 1e-9]
ALL_ANGLES = [*SMALL, 0.5, np.pi / 2, 2 * np.pi / 3, 3, *NEAR_PI, np.pi]
HALF_TURN = np.diag([1.0, -1, -1])


AXES = np.vstack([np.eye(3), -np.eye(3), [[0.6, 0.8, 0], [0, -0.6, 0.8]], random_units(500, 3)])
POINTS = RNG.normal(size=(len(AXES), 3))


def oracle(axis: Array, angle: Any) -> Array:
    angle = np.asarray(angle)
    return Rotation.from_rotvec(axis * angle[..., None]).as_matrix()


components = st.floats(-1, 1, allow_subnormal=False)
axes = (
    arrays(float, 3, elements=components)
    .filter(lambda v: bool(np.linalg.norm(v) > 1e-3))
    .map(lambda v: v / np.linalg.norm(v))
)
angles = st.floats(-10, 10)
points = arrays(float, 3, elements=st.floats(-100, 100))


class TestAgainstScipy:
    @pytest.mark.parametrize("angle", [*ALL_ANGLES, -1.0, 7.0, -np.pi])
    def test_matrix(self, angle: float) -> None:
        close(rotation_matrix(AXES, angle), oracle(AXES, angle))

    @pytest.mark.parametrize("angle", [*ALL_ANGLES, -1.0, 7.0, -np.pi])
    def test_rotate(self, angle: float) -> None:
        close(rotate(POINTS, AXES, angle), Rotation.from_rotvec(angle * AXES).apply(POINTS))

    def test_quarter_turns_follow_the_right_hand(self) -> None:
        u, v, w = np.eye(3)
        for axis, start, end in [(u, v, w), (v, w, u), (w, u, v)]:
            close(rotate(start, axis, np.pi / 2), end)
            close(rotation_matrix(axis, np.pi / 2) @ start, end)

    @pytest.mark.parametrize("angle", [1e-300, 1e-12, 1e-9, 1e-8])
    def test_small_turns_are_not_lost(self, angle: float) -> None:
        # To first order the point moves by angle * (n x r); 1 - cos is of second order.
        moved = rotate([0, 1, 0], [0, 0, 1], angle)
        assert moved[0] == pytest.approx(-angle, rel=1e-15)
        assert rotation_matrix([0, 0, 1], angle)[1, 0] == pytest.approx(angle, rel=1e-15)


class TestAnyRotation:
    @given(points, axes, angles)
    def test_against_scipy(self, r: Array, n: Array, a: float) -> None:
        close(rotation_matrix(n, a), oracle(n, a))
        close(rotate(r, n, a), oracle(n, a) @ r, 1e-12)
        close(transform(rotation_matrix(n, a), r), rotate(r, n, a), 1e-12)

    @given(points, axes, angles, st.floats(-300, 300))
    def test_length_of_the_axis_does_not_matter(
        self, r: Array, n: Array, a: float, exponent: float
    ) -> None:
        scaled = n * 10.0**exponent
        close(rotate(r, scaled, a), rotate(r, n, a), 1e-11)
        close(rotation_matrix(scaled, a), rotation_matrix(n, a), 1e-13)

    @given(axes, st.floats(0, np.pi, allow_subnormal=False))
    def test_axis_and_angle_come_back_as_the_same_matrix(self, n: Array, a: float) -> None:
        m = rotation_matrix(n, a)
        axis, angle = axis_angle(m)
        close(rotation_matrix(axis, angle), m, 2e-15)
        close(np.linalg.norm(axis), 1, 1e-15)
        assert 0 <= angle <= np.pi
        close(angle, a, 1e-12)


class TestAxisAngle:
    @pytest.mark.parametrize("angle", ALL_ANGLES)
    def test_angle_comes_back(self, angle: float) -> None:
        close(axis_angle(rotation_matrix(AXES, angle))[1], angle, 2e-15)

    @pytest.mark.parametrize("angle", [a for a in ALL_ANGLES if 0 < a < np.pi])
    def test_axis_comes_back(self, angle: float) -> None:
        close(axis_angle(rotation_matrix(AXES, angle))[0], AXES, 2e-15)

    @pytest.mark.parametrize("angle", SMALL[1:])
    def test_small_angles_keep_their_digits(self, angle: float) -> None:
        found = axis_angle(rotation_matrix(AXES, angle))[1]
        np.testing.assert_allclose(found, angle, rtol=1e-14)

    def test_a_sweep_towards_both_ends(self) -> None:
        steps = np.geomspace(1e-14, 1, 500)
        sweep = np.concatenate([steps, np.pi - steps])
        axis, angle = axis_angle(rotation_matrix(AXES[8], sweep))
        close(angle, sweep, 2e-15)
        close(axis, np.broadcast_to(AXES[8], (1000, 3)), 2e-15)

    def test_no_rotation_has_the_documented_axis(self) -> None:
        axis, angle = axis_angle(rotation_matrix(AXES, 0))
        assert (angle == 0).all()
        assert (axis == [1, 0, 0]).all()

    def test_at_a_half_turn_the_first_component_is_positive(self) -> None:
        lead = np.array([n[np.flatnonzero(n)[0]] for n in AXES])
        expected = AXES * np.sign(lead)[:, None]
        axis, angle = axis_angle(rotation_matrix(AXES, np.pi))
        close(axis, expected, 2e-15)
        assert (angle == np.pi).all()

    @pytest.mark.parametrize(
        ("matrix", "expected"),
        [
            (HALF_TURN, [1, 0, 0]),
            (np.diag([-1, 1, -1]), [0, 1, 0]),
            (np.diag([-1, -1, 1]), [0, 0, 1]),
            ([[-1, 0, 0], [0, 0, -1], [0, -1, 0]], [0, 0.5**0.5, -(0.5**0.5)]),
        ],
    )
    def test_exact_half_turns(self, matrix: Any, expected: list[float]) -> None:
        axis, angle = axis_angle(matrix)
        close(axis, expected, 1e-15)
        assert angle == np.pi

    def test_against_scipy(self) -> None:
        rotations = Rotation.random(500, rng=RNG)
        axis, angle = axis_angle(rotations.as_matrix())
        close(axis * angle[:, None], rotations.as_rotvec(), 1e-13)

    def test_each_of_the_four_branches(self) -> None:
        # Near a half turn about U, V, W that diagonal entry is the largest; else the trace.
        for axis, angle in [*((n, 3.0) for n in np.eye(3)), (np.ones(3) / 3**0.5, 0.3)]:
            found = axis_angle(rotation_matrix(axis, angle))
            close(found[0], axis)
            close(found[1], angle)

    def test_shapes(self) -> None:
        axis, angle = axis_angle(rotation_matrix(AXES[:6].reshape(2, 3, 3), 0.3))
        assert axis.shape == (2, 3, 3)
        assert angle.shape == (2, 3)
        axis, angle = axis_angle(np.eye(3))
        assert axis.shape == (3,)
        assert np.shape(angle) == ()
        axis, angle = axis_angle(np.empty((0, 3, 3)))
        assert axis.shape == (0, 3)
        assert angle.shape == (0,)

    def test_integers_are_a_matrix_too(self) -> None:
        close(axis_angle([[0, -1, 0], [1, 0, 0], [0, 0, 1]])[1], np.pi / 2)


class TestSixteenProducts:
    @pytest.mark.parametrize("angle", ALL_ANGLES)
    def test_are_those_of_the_quaternion(self, angle: float) -> None:
        q = np.column_stack([np.full(len(AXES), np.cos(angle / 2)), np.sin(angle / 2) * AXES])
        close(
            sixteen_products(oracle(AXES, np.full(len(AXES), angle))),
            4 * q[:, :, None] * q[:, None],
        )

    def test_against_scipy(self) -> None:
        rotations = Rotation.random(500, rng=RNG)
        q = rotations.as_quat(scalar_first=True)
        close(sixteen_products(rotations.as_matrix()), 4 * q[:, :, None] * q[:, None])

    def test_the_largest_diagonal_entry_is_at_least_one(self) -> None:
        table = sixteen_products(Rotation.random(500, rng=RNG).as_matrix())
        largest = np.diagonal(table, axis1=-2, axis2=-1).max(axis=-1)
        assert (largest >= 1).all()

    def test_shapes(self) -> None:
        matrices = rotation_matrix(AXES[:6].reshape(2, 3, 3), 0.3)
        table = sixteen_products(matrices)
        assert table.shape == (2, 3, 4, 4)
        close(table[1, 2], sixteen_products(matrices[1, 2]), 0)
        assert sixteen_products(np.empty((0, 3, 3))).shape == (0, 4, 4)

    def test_a_rounded_matrix_is_taken_to_the_nearest_rotation(self) -> None:
        matrices = rotation_matrix(AXES, 3.0)
        table = sixteen_products(matrices.round(8))
        close(table, sixteen_products(matrices), 1e-7)
        # All rows belong to one quaternion, so they are parallel.
        close(table[:, 0, 0] * table[:, 3, 3], table[:, 0, 3] ** 2, 1e-13)

    def test_row_worked_in_chapter_3(self) -> None:
        """By hand from four decimals, where the textbook's row is almost lost."""
        matrix = rotation_matrix([2, 6, 9], np.radians(179.9)).round(4)
        (_, _, uw), (_, _, vw), (wu, wv, _) = matrix
        row = [
            matrix[1, 0] - matrix[0, 1],
            uw + wu,
            vw + wv,
            1 + np.dot([-1, -1, 1], np.diag(matrix)),
        ]
        close(row, [0.0029, 0.5951, 1.7851, 2.6777], 1e-12)
        exact = sixteen_products(rotation_matrix([2, 6, 9], np.radians(179.9)))[3]
        close(row, exact, 2e-4)


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
        close(transform(self.affine, r), self.homogeneous(self.affine, r))
        close(transform(self.projective, r), self.homogeneous(self.projective, r))

    def test_stacks(self) -> None:
        matrices, r = rotation_matrix(AXES[8:13], 1.0), RNG.normal(size=(5, 3))
        each = np.stack([m @ p for m, p in zip(matrices, r, strict=True)])
        close(transform(matrices, r), each)
        close(transform(matrices, r[0]), np.stack([m @ r[0] for m in matrices]))
        every = np.stack([[m @ p for p in r] for m in matrices])
        close(transform(matrices[:, None], r), every)

    def test_stack_of_affine_and_projective_matrices(self) -> None:
        matrices, r = np.stack([self.affine, self.projective]), RNG.normal(size=(6, 1, 3))
        close(transform(matrices, r), self.homogeneous(matrices, r))
        close(transform(matrices[:, None], r[:, 0]), self.homogeneous(matrices[:, None], r[:, 0]))
        affine = np.stack([self.affine, self.affine])
        close(transform(affine, r), self.homogeneous(affine, r))

    def test_translation_moves_points(self) -> None:
        close(transform(self.affine, [0, 0, 0]), [1, 2, 3], 0)

    def test_a_multiple_of_a_projective_matrix_is_the_same(self) -> None:
        close(transform(-3 * self.affine, POINTS), transform(self.affine, POINTS), 1e-13)

    def test_points_at_infinity_are_named(self) -> None:
        camera = np.eye(4)[[0, 1, 2, 2]]
        with pytest.raises(DegenerateError, match=r"^matrix sends 1 of 1 points to infinity$"):
            transform(camera, [1, 2, 0])
        with pytest.raises(DegenerateError, match=r"2 of 4 points .* at index \(1, 0\)"):
            transform(camera, [[[1, 2, 3], [1, 2, 1]], [[1, 2, 0], [0, 0, 0]]])
        with pytest.raises(DegenerateError, match=r"1 of 2 points .* at index \(1,\)"):
            transform(np.stack([np.eye(4), camera]), [1, 2, 0])

    def test_result_shares_no_memory_with_the_points(self) -> None:
        r = POINTS.copy()
        transform(np.eye(3), r)[:] = 0
        transform(np.eye(4), r)[:] = 0
        rotate(r, [0, 0, 1], 0)[:] = 0
        close(r, POINTS, 0)


class TestManyPoints:
    points = RNG.normal(size=(220_001, 2, 3))
    matrices = (
        TestTransform.matrix,
        TestTransform.affine,
        TestTransform.projective,
        rotation_matrix([0, 0, 1], 1.0),
    )

    def laid_out(self, points: Array) -> Iterator[Array]:
        yield points
        yield points[1:].reshape(-1, 3)
        yield np.ascontiguousarray(points[:, 0])
        yield np.asfortranarray(points[:, 0])
        yield points[::2, 0]
        yield np.asfortranarray(points)
        yield points[::-1, 1, ::-1]

    @pytest.mark.parametrize("matrix", matrices)
    def test_however_they_lie_in_memory(self, matrix: Array) -> None:
        for points in self.laid_out(self.points):
            few = np.concatenate([transform(matrix, part) for part in np.array_split(points, 300)])
            close(transform(matrix, points), few, 1e-14)
            single = transform(matrix.astype("f4"), points.astype("f4"))
            assert single.dtype == np.float32
            close(single, few, 2e-5)

    @pytest.mark.parametrize("matrix", matrices)
    def test_one_that_is_not_finite_is_found(self, matrix: Array) -> None:
        for value, coordinate in product([np.nan, np.inf, -np.inf], [0, 1, 2]):
            points = self.points.copy()
            points[100_000, 1, coordinate] = value
            wrong = rf"must be finite in float64; got {value} at index \(100000, 1, {coordinate}\)"
            with pytest.raises(ValueError, match=f"^points {wrong}"):
                transform(matrix, points)

    def test_one_that_is_sent_to_infinity_is_found(self) -> None:
        points = self.points.copy()
        points[100_000, 1, 2] = 0
        with pytest.raises(DegenerateError, match=r"1 of 440002 points .* index \(100000, 1\)"):
            transform(np.eye(4)[[0, 1, 2, 2]], points)

    def test_large_numbers_are_no_infinities(self) -> None:
        close(transform(np.eye(3), 1e200 * self.points), 1e200 * self.points, 0)

    def test_images_beyond_all_numbers_are_warned_of(self) -> None:
        points = np.full((2001, 3), 1e308)
        with pytest.warns(RuntimeWarning, match="overflow"):
            assert (transform(2 * np.ones((3, 3)), points) == np.inf).all()

    def test_a_stack_of_matrices(self) -> None:
        matrices = rotation_matrix(AXES[8:11], 1.0)[:, None]
        points = np.ascontiguousarray(self.points[:5000, 0])
        expected = np.stack([points @ m[0].T for m in matrices])
        close(transform(matrices, points), expected)

    def test_objects(self) -> None:
        points, matrix = self.points[:1001, 0], TestTransform.matrix
        expected = OperationCount(9 * 1001, 6 * 1001)
        assert count(lambda r: transform(matrix, r), points) == expected
        assert count(lambda m: transform(m, points), matrix) == expected

    def test_an_affine_matrix_costs_no_division(self) -> None:
        affine, projective = TestTransform.affine, TestTransform.projective
        assert count(transform, affine, [1, 2, 3]) == OperationCount(9, 9)
        assert count(transform, projective, [1, 2, 3]) == OperationCount(12, 12, divisions=3)

    def test_other_numbers(self) -> None:
        for dtype in (">f8", "f2", "i4"):
            points = (100 * self.points[:2001, 0]).astype(dtype)
            close(transform(TestTransform.matrix, points), points @ TestTransform.matrix.T, 1e-12)
            assert transform(np.eye(3, dtype=dtype), points).dtype == np.float64


class TestShapes:
    @pytest.mark.parametrize(
        ("r", "n", "a", "expected"),
        [
            ((3,), (3,), (), (3,)),
            ((7, 3), (3,), (), (7, 3)),
            ((3,), (7, 3), (), (7, 3)),
            ((3,), (3,), (7,), (7, 3)),
            ((7, 3), (7, 3), (7,), (7, 3)),
            ((5, 1, 3), (7, 3), (), (5, 7, 3)),
            ((7, 3), (2, 1, 1, 3), (5, 1), (2, 5, 7, 3)),
            ((0, 3), (3,), (), (0, 3)),
        ],
    )
    def test_broadcasting_is_a_loop(self, r: Any, n: Any, a: Any, expected: Any) -> None:
        r, n, a = RNG.normal(size=r), RNG.normal(size=n), RNG.normal(size=a)
        moved = rotate(r, n, a)
        assert moved.shape == expected
        assert rotation_matrix(n, a).shape == (*np.broadcast_shapes(n.shape[:-1], a.shape), 3, 3)
        r, n, a = (np.broadcast_to(r, expected), np.broadcast_to(n, expected), a[..., None])
        a = np.broadcast_to(a, expected)[..., 0]
        for i in np.ndindex(expected[:-1]):
            close(moved[i], rotate(r[i], n[i], a[i]), 1e-15)
            close(moved[i], rotation_matrix(n[i], a[i]) @ r[i])

    def test_sequences_integers_and_views_are_accepted(self) -> None:
        expected = rotate(np.array([1.0, 2, 3]), np.array([0.0, 0, 1]), 2.0)
        close(rotate([1, 2, 3], (0, 0, 1), 2), expected, 0)
        close(rotate(np.array([1, 2, 3], np.int8), (0, 0, Fraction(1, 3)), 2), expected, 0)
        close(rotate([1, 2, 3], [0, 0, 10**30], 2), expected, 0)
        view = np.array([[3, 0, 2, 0, 1.0]] * 4).T[::-2].T
        assert not view.flags.c_contiguous
        close(rotate(view, [0, 0, 1], 2), np.tile(expected, (4, 1)), 0)
        matrix = np.asfortranarray(rotation_matrix([0, 0, 1], 2))
        close(transform(matrix, view), np.tile(expected, (4, 1)))


class TestSinglePrecision:
    r, n = POINTS[:9].astype(np.float32), AXES[-9:].astype(np.float32)

    def test_is_kept(self) -> None:
        a = np.float32(0.3)
        m = rotation_matrix(self.n, a)
        homogeneous = np.eye(4, dtype=np.float32)[[0, 1, 2, 2]]
        found = [
            m,
            rotate(self.r, self.n, a),
            rotate(self.r, [0, 0, 1], 0.3),
            rotate(self.r, np.array([0, 0, 1]), 1),
            rotation_matrix(self.n[0], 1),
            transform(m, self.r),
            transform(m[0], [1, 2, 3]),
            transform(homogeneous, self.r),
            *axis_angle(m),
            sixteen_products(m),
            *axis_angle(np.eye(3, dtype=np.float32)),
        ]
        assert {x.dtype for x in found} == {np.dtype(np.float32)}

    def test_gives_way_to_double(self) -> None:
        found = [
            rotate(self.r, self.n, np.float64(0.3)),
            rotate(self.r, np.array([0, 0, 1.0]), 0.3),
            transform(np.eye(3), self.r),
            rotate([1, 2, 3], [0, 0, 1], 0),
            rotate(self.r, self.n, np.longdouble(1)),
            rotation_matrix(np.array([0, 0, 1], np.float16), 0),
        ]
        assert {x.dtype for x in found} == {np.dtype(np.float64)}

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
        for scale in [1e-38, 1e38]:
            close(rotate(np.eye(3, dtype=np.float32), [0, scale, 0], 0), np.eye(3), 0)
        with pytest.raises(ValueError, match="axis must be finite in float32; got inf"):
            rotate(self.r, [0, 0, 1e200], 0.3)
        with pytest.raises(ValueError, match="axis must not be the zero vector"):
            rotate(self.r, [0, 0, 1e-200], 0.3)


class TestExtremeAxes:
    @pytest.mark.parametrize("scale", [5e-324, 1e-320, 1e-200, 1e-160, 1e160, 1e200, 1.7e308])
    def test_length_neither_overflows_nor_underflows(self, scale: float) -> None:
        diagonal = scale * np.ones(3)
        close(rotate([1, 0, 0], diagonal, 2 * np.pi / 3), [0, 1, 0])
        close(rotation_matrix(diagonal, 1.0), rotation_matrix([1, 1, 1], 1.0), 0)


class TestRefusals:
    @pytest.mark.parametrize("shape", [(), (0,), (2,), (4,), (3, 4), (3, 1)])
    def test_not_vectors(self, shape: tuple[int, ...]) -> None:
        for name, f in {
            "points": lambda x: rotate(x, [0, 0, 1], 1),
            "axis": lambda x: rotate([1, 2, 3], x, 1),
        }.items():
            with pytest.raises(ValueError) as caught:  # noqa: PT011
                f(np.ones(shape))
            assert str(caught.value) == f"{name} must have shape (..., 3); got shape {shape}"
        with pytest.raises(ValueError) as caught:  # noqa: PT011
            rotation_matrix(np.ones(shape), 1)
        assert str(caught.value) == f"axis must have shape (..., 3); got shape {shape}"

    @pytest.mark.parametrize("shape", [(), (3,), (3, 4), (4, 3), (2, 2), (3, 3, 4), (5, 5)])
    def test_not_matrices(self, shape: tuple[int, ...]) -> None:
        with pytest.raises(ValueError) as caught:  # noqa: PT011
            transform(np.ones(shape), [1, 2, 3])
        with pytest.raises(ValueError, match=r"^matrix must have shape"):
            transform(np.ones(shape), np.ones((5, 3)))
        wanted = "(..., 3, 3) or (..., 4, 4)"
        assert str(caught.value) == f"matrix must have shape {wanted}; got shape {shape}"
        with pytest.raises(ValueError, match=r"^matrix must have shape \(..., 3, 3\); got shape"):
            axis_angle(np.ones(shape))
        with pytest.raises(ValueError, match=r"^matrix must have shape \(..., 3, 3\); got shape"):
            sixteen_products(np.ones(shape))

    def test_axis_angle_takes_no_homogeneous_matrix(self) -> None:
        with pytest.raises(ValueError, match=r"got shape \(4, 4\)"):
            axis_angle(np.eye(4))

    def test_points_of_transform(self) -> None:
        for n in (3, 4):
            with pytest.raises(
                ValueError, match=r"^points must have shape \(..., 3\); got .*\(2, 4\)"
            ):
                transform(np.eye(n), np.ones((2, 4)))
        with pytest.raises(ValueError, match=r"^points must have shape \(..., 3\); got .*\(\)"):
            transform(np.eye(3), np.float64(1))

    def test_zero_axis(self) -> None:
        with pytest.raises(ValueError, match=r"^axis must not be the zero vector; got zeros$"):
            rotate([1, 2, 3], [0, 0, 0.0], 1)
        with pytest.raises(ValueError, match=r"^axis must not be .* at index \(1,\)$"):
            rotation_matrix([[0, 0, 1], [0, 0, 0], [0, 0, 0]], 1)

    def test_shapes_that_do_not_broadcast(self) -> None:
        with pytest.raises(ValueError, match=r"^points and axis and angle must broadcast over"):
            rotate(np.ones((4, 3)), np.ones((5, 3)), 1)
        with pytest.raises(ValueError, match=r"^axis and angle must .* got \(4, 3\) and \(3,\)$"):
            rotation_matrix(np.ones((4, 3)), [1, 2, 3])
        with pytest.raises(ValueError, match=r"^matrix and points must broadcast"):
            transform(np.ones((4, 3, 3)), np.ones((5, 3)))

    def test_objects_are_not_exempt_from_the_check_of_shapes(self) -> None:
        with pytest.raises(ValueError, match=r"^axis must have shape \(..., 3\); got shape \(2,\)"):
            rotate([1, 2, 3], sp.symbols("x y"), 1)

    @pytest.mark.parametrize(
        ("matrix", "message"),
        [
            (2 * np.eye(3), r"differs by 3\.0e\+00; .*nearest_rotation"),
            (np.zeros((3, 3)), r"differs by 1\.0e\+00; "),
            (np.full((3, 3), 1e200), r"differs by inf; "),
            (
                rotation_matrix([0, 0, 1], 1) * 1.001,
                r"may differ .* by 1e-03, but differs by 2\.0e-03; ",
            ),
            (-np.eye(3), r"determinant is -1, so it reflects$"),
            (-HALF_TURN, r"determinant is -1, so it reflects$"),
            ([np.eye(3), -np.eye(3)], r"determinant is -1, so it reflects at index \(1,\)$"),
            ([np.eye(3), 3 * np.eye(3)], r"differs by 8\.0e\+00 at index \(1,\); "),
        ],
    )
    def test_not_a_rotation(self, matrix: Any, message: str) -> None:
        for f in (axis_angle, sixteen_products):
            with pytest.raises(ValueError, match=f"^matrix must be a rotation: .*{message}"):
                f(matrix)


class TestProofs:
    """The same code, run on symbols, so the results hold for all axes and angles."""

    class Angle(sp.Symbol):
        """An angle with the methods that numpy calls for the cosine and sine of an object."""

        def cos(self) -> Any:
            return sp.cos(self)

        def sin(self) -> Any:
            return sp.sin(self)

    n = sp.symbols("n_u n_v n_w", real=True)
    r = sp.symbols("r_u r_v r_w", real=True)
    theta = Angle("theta", real=True)

    def is_zero(self, expression: Any) -> bool:
        """Whether an expression vanishes modulo |n| = 1 and cos^2 + sin^2 = 1."""
        c, s = sp.symbols("c s")
        polynomial = sp.expand(expression.subs({sp.cos(self.theta): c, sp.sin(self.theta): s}))
        laws = [sum(x**2 for x in self.n) - 1, c**2 + s**2 - 1]
        return bool(sp.reduced(polynomial, laws, self.n[0], s)[1] == 0)

    def matrix(self) -> sp.Matrix:
        return sp.Matrix(rotation_matrix(self.n, self.theta))

    @pytest.mark.equation("3-3")
    def test_matrix_times_vector_is_rodrigues_formula(self) -> None:
        difference = self.matrix() * sp.Matrix(self.r) - sp.Matrix(
            rotate(self.r, self.n, self.theta)
        )
        assert difference.expand() == sp.zeros(3, 1)

    @pytest.mark.equation("3-2")
    def test_transform_is_the_matrix_product(self) -> None:
        m = sp.Matrix(3, 3, sp.symbols("m:9"))
        product = sp.Matrix(transform(m, self.r))
        assert (product - m * sp.Matrix(self.r)).expand() == sp.zeros(3, 1)

    def test_matrix_is_orthogonal(self) -> None:
        m = self.matrix()
        assert all(self.is_zero(entry) for entry in m.T * m - sp.eye(3))

    def test_determinant_is_one(self) -> None:
        assert self.is_zero(self.matrix().det() - 1)

    def test_axis_stays(self) -> None:
        moved = rotate(self.n, self.n, self.theta)
        assert all(self.is_zero(x - y) for x, y in zip(moved, self.n, strict=True))

    def test_trace_and_skew_part_give_angle_and_axis(self) -> None:
        m = self.matrix()
        assert self.is_zero(m.trace() - 1 - 2 * sp.cos(self.theta))
        skew = [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]
        sin = sp.sin(self.theta)
        assert all(self.is_zero(x - 2 * sin * y) for x, y in zip(skew, self.n, strict=True))

    def test_sixteen_products_are_those_of_half_the_angle(self) -> None:
        c, s = sp.symbols("c s")
        half = {sp.cos(self.theta): c**2 - s**2, sp.sin(self.theta): 2 * s * c}
        table = sp.Matrix(4, 4, sixteen_products(self.matrix()).ravel()).subs(half)
        q = sp.Matrix([c, *(s * x for x in self.n)])
        laws = [sum(x**2 for x in self.n) - 1, c**2 + s**2 - 1]
        for difference in table - 4 * q * q.T:
            assert sp.reduced(sp.expand(difference), laws, self.n[0], s)[1] == 0

    @pytest.mark.equation("3-1")
    def test_the_first_line_of_3_1_is_the_second(self) -> None:
        r, n = sp.Matrix(self.r), sp.Matrix(self.n)
        along = r.dot(n) * n
        cos, sin = sp.cos(self.theta), sp.sin(self.theta)
        first = along + cos * (r - along) + sin * n.cross(r)
        assert (first - sp.Matrix(rotate(self.r, self.n, self.theta))).expand() == sp.zeros(3, 1)

    def test_not_everything_is_zero(self) -> None:
        assert not self.is_zero(self.matrix()[0, 1])
        assert not self.is_zero(self.matrix().det() + 1)
