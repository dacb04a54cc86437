"""Section 4: (4-1) to (4-7) and the other transforms, against sympy and scipy."""

from functools import reduce
from itertools import permutations
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from scipy.spatial.transform import Rotation
from spheres import E1, E2, E3, Array, close, random_units, refuses, vectors
from symbolic import matrix, symbolic

from rotedu.cost import OperationCount, count
from rotedu.general_rotation import (
    axis_angle_from_euler_angles,
    compose,
    euler_angles,
    homogeneous,
    matrix_from_euler_angles,
    perspective,
    quaternion_from_euler_angles,
    reflection,
    rotation_u,
    rotation_v,
    rotation_w,
    scaling,
    shearing,
    swing_twist,
    translation,
)
from rotedu.ordinary_rotation import rotation_matrix, transform
from rotedu.quaternions import Quaternion

RNG = np.random.default_rng(47)
EULER = RNG.uniform(-2 * np.pi, 2 * np.pi, size=(2000, 3))
POINTS = RNG.normal(size=(50, 3))
PRINCIPAL = {rotation_u: E1, rotation_v: E2, rotation_w: E3}


def test_product_against_scipy() -> None:
    product = matrix_from_euler_angles(*EULER.T)
    close(product[:, :3, :3], Rotation.from_euler("xyz", EULER).as_matrix(), 2e-15)
    close(product, homogeneous(product[:, :3, :3]), 0)


class TestSingleRotation:
    def test_is_the_product(self) -> None:
        axis, angle = axis_angle_from_euler_angles(*EULER.T)
        close(homogeneous(rotation_matrix(axis, angle)), matrix_from_euler_angles(*EULER.T), 2e-15)
        close(np.linalg.norm(axis, axis=-1), 1, 1e-15)
        assert (angle >= 0).all()
        assert (angle <= 2 * np.pi).all()
        assert (angle > np.pi).sum() > 500

    @pytest.mark.equation("4-5")
    def test_the_sine_alone_would_not_do(self) -> None:
        angles = np.radians([300, 40, 20])
        _, angle = axis_angle_from_euler_angles(*angles)
        close(np.degrees(angle), 281.02, 0.005)
        sine = np.linalg.norm(quaternion_from_euler_angles(*angles).v)
        close(np.degrees(2 * np.arcsin(sine)), 78.98, 0.005)

    @pytest.mark.equation("4-3")
    @pytest.mark.parametrize(
        "turns", [(0, 0, 0), (1, 1, 1), (-1, 1, 1), (2, 0, 0), (0, -2, 4), (3, 1, -5)]
    )
    def test_identity(self, turns: Any) -> None:
        for angles in np.pi * np.array(turns), np.pi * np.array(turns, np.float32):
            axis, angle = axis_angle_from_euler_angles(*angles)
            close(axis, [1, 0, 0], 0)
            assert angle in (0, np.asarray(2 * np.pi, angles.dtype))

    def test_identity_among_others(self) -> None:
        axis, angle = axis_angle_from_euler_angles([0, np.pi, 0], [0, np.pi, 1], [0, np.pi, 0])
        close(axis, [[1, 0, 0], [1, 0, 0], [0, 1, 0]], 0)
        close(angle, [0, 0, 1], 1e-15)

    @pytest.mark.parametrize("size", [1e-300, 1e-20, 1e-8, 1e-4, np.pi])
    def test_small_angles_and_half_turns_keep_their_digits(self, size: float) -> None:
        for axis in np.eye(3):
            found, angle = axis_angle_from_euler_angles(*size * axis)
            close(found, axis, 0 if size < 1 else 1e-15)
            assert angle == pytest.approx(size, rel=1e-15)
        if size < 1:
            axis, angle = axis_angle_from_euler_angles(size, 2 * size, -2 * size)
            close(axis, np.array([1, 2, -2]) / 3, 2 * size + 1e-15)
            assert angle == pytest.approx(3 * size, rel=size + 1e-15)


class TestEulerAngles:
    def test_any_rotation_comes_back(self) -> None:
        rests, turns = (1e-15, 1e-14, 1e-12, 1e-8, 1e-4), np.linspace(-3, 3, 13)
        near_gimbal_lock = [(0.7, np.pi / 2 - rest, w) for rest in rests for w in turns]
        turned = matrix_from_euler_angles(*np.concatenate([EULER, near_gimbal_lock]).T)
        u, v, w = euler_angles(turned)
        close(matrix_from_euler_angles(u, v, w), turned, 3e-15)
        assert (np.abs(v) <= np.pi / 2).all()
        close(euler_angles(turned[:, :3, :3]), (u, v, w), 0)

    @pytest.mark.parametrize("sign", [1, -1])
    @pytest.mark.parametrize("rest", [0, 1e-17, 1e-16])
    def test_gimbal_lock(self, sign: int, rest: float) -> None:
        locked = matrix_from_euler_angles(0.7, sign * (np.pi / 2 - rest), 0.4)
        u, v, w = euler_angles(locked)
        assert w == 0
        close([u, v], [0.7 - sign * 0.4, sign * np.pi / 2], 1e-15)
        close(matrix_from_euler_angles(u, v, w), locked, 1e-15)

    def test_one_that_is_locked_among_others(self) -> None:
        u, v, w = euler_angles(matrix_from_euler_angles([0.1, 0.3], [0.2, np.pi / 2], [0.3, 0.1]))
        close([u, v, w], [[0.1, 0.2], [0.2, np.pi / 2], [0.3, 0]], 1e-15)


class TestTransforms:
    @given(vectors(10), vectors(10))
    def test_translation(self, v: Array, r: Array) -> None:
        close(transform(translation(v), r), r + v, 0)
        close(translation(v) @ [*r, 0], [*r, 0], 0)

    def test_scaling(self) -> None:
        close(transform(scaling(3), POINTS), 3 * POINTS, 0)
        close(transform(scaling([1, -2, 0]), POINTS), POINTS * [1, -2, 0], 0)

    def test_shearing(self) -> None:
        for row, column in permutations(range(3), 2):
            expected = np.eye(4)
            expected[row, column] = 2.5
            close(shearing(**{"uvw"[row] + "uvw"[column]: 2.5}), expected, 0)
        both = shearing(uv=[1, 2, 3], wu=np.ones((2, 1)))
        assert both.shape == (2, 3, 4, 4)
        close(both[1, 2] @ [1, 10, 100, 1], [31, 10, 101, 1], 0)

    @given(vectors(10).filter(lambda n: bool(np.linalg.norm(n) > 1e-3)), vectors(10))
    def test_reflection(self, normal: Array, r: Array) -> None:
        n = normal / np.linalg.norm(normal)
        close(transform(reflection(normal), r), r - 2 * (r @ n) * n, 1e-13)
        close(reflection(-1e5 * normal), reflection(normal), 1e-15)

    def test_perspective_is_the_ray_from_the_eye(self) -> None:
        points, eye = POINTS - [0, 0, 3], np.array([0, 0, 2.5])
        picture = transform(perspective(2.5), points)
        # Where the line from the eye to the point meets w = 0.
        part = eye[2] / (eye[2] - points[:, 2:])
        close(picture[:, :2], (eye + part * (points - eye))[:, :2])
        by_depth = np.argsort(points[:, 2])
        assert (np.diff(picture[by_depth, 2]) > 0).all()
        close(transform(perspective(4), [1, 2, 0]), [1, 2, 0], 0)

    @pytest.mark.equation("4-7")
    def test_homogeneous(self) -> None:
        m = RNG.normal(size=(5, 3, 3))
        h = homogeneous(m)
        close(h[:, :3, :3], m, 0)
        close(h[:, 3], [[0, 0, 0, 1]] * 5, 0)
        close(h[:, :3, 3], 0, 0)


class TestCompose:
    steps = (
        scaling([1, 2, 0.5]),
        shearing(uw=0.3),
        rotation_matrix([1, 2, 3], 0.7),
        reflection([1, 1, 0]),
        translation([0.5, -1, -4]),
        perspective(5),
    )

    def test_one_matrix_for_six(self) -> None:
        one_by_one = POINTS
        for step in self.steps:
            one_by_one = transform(step, one_by_one)
        close(transform(compose(*reversed(self.steps)), POINTS), one_by_one)

    def test_none_and_one(self) -> None:
        close(compose(), np.eye(4), 0)
        m = RNG.normal(size=(4, 4))
        single = compose(m)
        close(single, m, 0)
        single[:] = 0
        assert m.any()
        close(compose(np.eye(3)), np.eye(4), 0)
        assert compose(np.eye(3, dtype="f4"), np.eye(4, dtype="f4")).dtype == np.float32

    def test_refuses_what_does_not_fit(self) -> None:
        shapes = r"\(..., 3, 3\) or \(..., 4, 4\); got shape \(2, 2\)"
        with pytest.raises(ValueError, match=rf"^matrices\[1\] must have shape {shapes}"):
            compose(np.eye(4), np.eye(2))
        with pytest.raises(ValueError, match=r"^matrices\[0\] and matrices\[1\] must broadcast"):
            compose(np.ones((2, 4, 4)), np.ones((3, 3, 3)))

    def test_broadcasting(self) -> None:
        turns = rotation_matrix(E3, np.arange(5))
        moves = translation(np.ones((2, 1, 3)))
        product = compose(moves, turns)
        assert product.shape == (2, 5, 4, 4)
        close(product[1, 3], moves[1, 0] @ homogeneous(turns[3]))


def test_counts_of_the_audit() -> None:
    angles = 0.1, 0.2, 0.3
    matrix = OperationCount(16, 4, trigonometric=6)
    assert count(matrix_from_euler_angles, *angles) == matrix
    sums = OperationCount(16, 4, divisions=3, trigonometric=6)
    assert count(quaternion_from_euler_angles, *angles) == sums
    assert count(compose, *RNG.normal(size=(2, 4, 4))) == OperationCount(64, 48)
    single = OperationCount(20, 6, divisions=6, square_roots=1, trigonometric=7)
    assert count(axis_angle_from_euler_angles, *angles) == single


class TestProofs:
    """The same code, run on symbols."""

    angles = sp.symbols("u v w", real=True)

    @pytest.mark.parametrize(("principal", "axis"), PRINCIPAL.items())
    def test_each_principal_rotation_is_3_3_about_its_axis(self, principal: Any, axis: Any) -> None:
        angle = symbolic(self.angles[0])
        turn = rotation_matrix(symbolic(*map(int, axis)), angle)
        assert (matrix(principal(angle)) - matrix(homogeneous(turn))).expand() == sp.zeros(4, 4)

    @pytest.mark.equation("4-1", "4-2")
    def test_4_2_is_4_1_multiplied_out(self) -> None:
        u, v, w = map(symbolic, self.angles)
        factors = matrix(rotation_w(w)), matrix(rotation_v(v)), matrix(rotation_u(u))
        orders = (reduce(sp.Matrix.multiply, order) for order in permutations(factors))
        by_entries = matrix(matrix_from_euler_angles(u, v, w))
        zero = [(by_entries - product).expand() == sp.zeros(4, 4) for product in orders]
        assert zero == [True] + 5 * [False]

    @pytest.mark.equation("4-4", "4-6")
    def test_4_4_and_4_6_are_the_product_of_three_quaternions(self) -> None:
        u, v, w = map(symbolic, self.angles)
        qu, qv, qw = (
            Quaternion.from_axis_angle(symbolic(*map(int, axis)), theta)
            for axis, theta in zip(np.eye(3), (u, v, w), strict=True)
        )
        sums = matrix(quaternion_from_euler_angles(u, v, w).components)
        assert (matrix((qw * qv * qu).components) - sums).expand() == sp.zeros(4, 1)
        assert (matrix((qu * qv * qw).components) - sums).expand() != sp.zeros(4, 1)


class TestSwingAndTwist:
    turns = Rotation.random(500, rng=RNG)
    axes = random_units(500, 3, rng=RNG)

    def test_against_the_quaternion_whose_other_components_are_dropped(self) -> None:
        q = self.turns.as_quat(scalar_first=True)
        along = np.sum(q[:, 1:] * self.axes, axis=1, keepdims=True) * self.axes
        twist = Rotation.from_quat(np.concatenate([q[:, :1], along], axis=1), scalar_first=True)
        found = swing_twist(self.turns.as_matrix(), self.axes)
        close(found[1], twist.as_matrix(), 1e-12)
        close(found[0], (self.turns * twist.inv()).as_matrix(), 1e-12)

    def test_half_a_turn_of_the_axis(self) -> None:
        message = "axis and what it is turned to are antipodal"
        refuses(message, swing_twist, np.diag([-1, -1, 1]), E1)
        swing, twist = swing_twist(np.diag([-1, -1, 1]), E3)
        close(swing, np.eye(3))
        close(twist, np.diag([-1, -1, 1]))
