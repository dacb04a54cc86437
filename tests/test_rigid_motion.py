"""Rigid motions: against SciPy, pytransform3d, sympy and matrix logarithms, and their own laws."""

from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from pytransform3d import transformations as pt
from scipy.linalg import expm, logm
from scipy.spatial.transform import RigidTransform, Rotation
from spheres import Array, close, random_units, refuses

from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import transform
from rotedu.quaternions import Quaternion
from rotedu.rigid_motion import (
    DualQuaternion,
    blend_dual_quaternions,
    blend_matrices,
    screw,
    screw_motion,
    straight_motion,
)

RNG = np.random.default_rng(1873)
N = 300


def poses(n: int = N, largest: float = np.pi) -> Array:
    """Random poses, turned by up to an angle."""
    vectors = random_units(n, 3, rng=RNG) * RNG.uniform(0, largest, (n, 1))
    steps = RNG.normal(size=(n, 3))
    return np.asarray(
        RigidTransform.from_components(steps, Rotation.from_rotvec(vectors)).as_matrix()
    )


A, B = poses(), poses()
ONE = np.eye(4)


def about(degrees: float, step: Any = (0, 0, 0)) -> Array:
    """A turn about W, and a step."""
    turn = Rotation.from_euler("z", degrees, degrees=True)
    return np.asarray(RigidTransform.from_components(step, turn).as_matrix())


def numbers(d: DualQuaternion) -> Array:
    return np.concatenate([d.real.components, d.dual.components], axis=-1)


class TestDualQuaternion:
    def test_against_scipy_and_pytransform3d(self) -> None:
        found = numbers(DualQuaternion.from_matrix(A))
        other = RigidTransform.from_matrix(A).as_dual_quat(scalar_first=True)
        close(found * np.sign(found[:, :1] * other[:, :1]), other, 1e-14)
        for m, d in zip(A, found, strict=True):
            close(pt.transform_from_dual_quaternion(d), m, 1e-14)

    def test_a_product_is_the_product_of_the_matrices(self) -> None:
        p, q = DualQuaternion.from_matrix(A), DualQuaternion.from_matrix(B)
        close((p * q).matrix(), A @ B, 1e-14)
        close((p.conjugate() * p).matrix(), np.broadcast_to(ONE, A.shape), 1e-14)
        for one in (p, p * q):
            size, rest = one.norm()
            close(size, 1)
            close(rest, 0, 2e-15)

    def test_the_rule_by_symbols(self) -> None:
        """The product of the 4x4 matrices, from the rule with eps^2 = 0."""
        eps, a, b = sp.Symbol("eps"), sp.symbols("a:8"), sp.symbols("b:8")
        p, q = (sp.Quaternion(*np.add(s[:4], np.multiply(eps, s[4:]))) for s in (a, b))
        expected = [sp.expand(component) for component in (p * q).args[:4]]
        x, y = (DualQuaternion(Quaternion(s[0], s[1:4]), Quaternion(s[4], s[5:])) for s in (a, b))
        for k, part in enumerate(((x * y).real, (x * y).dual)):
            for component, whole in zip(part.components, expected, strict=True):
                assert sp.expand(component - whole.coeff(eps, k)) == 0

    def test_any_length_is_the_same_motion(self) -> None:
        d = DualQuaternion.from_matrix(A)
        longer = DualQuaternion(-3 * d.real, -3 * d.dual + 0.7 * d.real)
        close(longer.matrix(), A, 1e-13)
        close(longer.norm(), [np.full(N, 3), np.full(N, -0.7)], 1e-13)
        assert (d == d).all()
        assert not (d == longer).any()
        assert list(d != longer) == [True] * N
        assert not (d != d).any()

    def test_parts_are_quaternions_and_not_zero(self) -> None:
        q, zero = Quaternion(1, [0, 0, 0]), Quaternion(0, [0, 0, 0])
        with pytest.raises(ValueError, match=r"^dual must be a Quaternion; got 0"):
            DualQuaternion(q, 0)  # type: ignore[arg-type]
        refuses("the zero quaternion has no inverse", DualQuaternion(zero, q).matrix)
        assert DualQuaternion(zero, q).norm() == (0, 0)
        for size in (1e-200, 1e200):
            assert DualQuaternion(size * q, size * q).norm() == (size, size)
        several = (Quaternion(np.ones(n), np.ones((n, 3))) for n in (2, 3))
        with pytest.raises(ValueError, match=r"^real and dual must broadcast .*\(2,\) and \(3,\)"):
            DualQuaternion(*several)
        with pytest.raises(TypeError):
            DualQuaternion(q, q) * 2  # type: ignore[operator]


class TestScrew:
    def test_there_and_back(self) -> None:
        axis, point, angle, slide = screw(A)
        turn = Rotation.from_rotvec(angle[:, np.newaxis] * axis)
        back = turn.apply(-point) + point + slide[:, np.newaxis] * axis
        close(turn.as_matrix(), A[:, :3, :3], 1e-14)
        close(back, A[:, :3, 3], 1e-9)
        close(np.sum(point * axis, axis=1), 0, 1e-9)
        assert ((angle >= 0) & (angle <= np.pi)).all()

    def test_against_pytransform3d(self) -> None:
        for m, *found in zip(A, *screw(A), strict=True):
            axis, point, angle, slide = found
            q, s, h, theta = pt.screw_parameters_from_dual_quaternion(
                numbers(DualQuaternion.from_matrix(m))
            )
            close(theta, angle, 1e-10)
            close(s, axis, 1e-8)
            close(h * theta, slide, 1e-8)
            close(np.cross(q - point, axis), 0, 1e-6)

    def test_a_mere_step_a_half_turn_and_nothing(self) -> None:
        for motion, expected in [
            (about(0, (0, -3, 4)), ([0, -0.6, 0.8], [0, 0, 0], 0, 5)),
            (about(180, (2, 0, -1)), ([0, 0, 1], [1, 0, 0], np.pi, -1)),
        ]:
            for found, wanted in zip(screw(motion), expected, strict=True):
                close(found, wanted, 1e-15)
        refuses("matrix moves nothing: every line is an axis", screw, ONE)
        refuses("matrix at index (1,) moves nothing", screw, [A[0], ONE])


class TestMotions:
    @pytest.mark.parametrize("motion", [screw_motion, straight_motion])
    def test_leads_from_one_to_the_other(self, motion: Any) -> None:
        close(motion(A, B, 0), A, 1e-14)
        close(motion(A, B, 1), B, 1e-13)
        close(motion(A, B, 0.3), motion(B, A, 0.7), 1e-12)
        close(motion(A[0], B[0], [0, 1]), [A[0], B[0]], 1e-14)
        with pytest.raises(DegenerateError, match="are half a turn apart"):
            motion(ONE, about(180, (1, 2, 3)), 0.5)

    def test_is_the_exponential_of_a_part_of_the_logarithm(self) -> None:
        for a, b, t in zip(A[:100], B[:100], RNG.uniform(-1, 2, 100), strict=True):
            log = np.real(logm(np.linalg.solve(a, b)))
            close(screw_motion(a, b, t), a @ expm(t * log), 1e-10)

    @pytest.mark.parametrize("angle", [0, 1e-12, 1e-8, 1e-4])
    def test_small_turns_keep_their_digits(self, angle: float) -> None:
        """Of a step by sqrt(2) that turns a little, the middle is off its chord by angle / 8."""
        found = screw_motion(ONE, about(np.degrees(angle), (1, 1, 3)), 0.5)
        sagitta = np.sqrt(2) / 2 * np.tan(angle / 4)
        close(found[:3, 3], [0.5 + sagitta / np.sqrt(2), 0.5 - sagitta / np.sqrt(2), 1.5])

    def test_straight_is_straight(self) -> None:
        t = np.linspace(0, 1, 7)[:, np.newaxis]
        steps = straight_motion(A, B, t)[..., :3, 3]
        close(steps, (1 - t[..., np.newaxis]) * A[:, :3, 3] + t[..., np.newaxis] * B[:, :3, 3])
        turned = Rotation.from_matrix(A[:, :3, :3]).inv() * Rotation.from_matrix(B[:, :3, :3])
        third = straight_motion(A, B, 1 / 3)[:, :3, :3]
        close(third, A[:, :3, :3] @ Rotation.from_rotvec(turned.as_rotvec() / 3).as_matrix(), 1e-13)


class TestBlends:
    bones = poses(5 * N, np.pi / 2).reshape(N, 5, 4, 4)
    weights = RNG.uniform(0.1, 1, (N, 5))

    def test_one_bone_is_itself(self) -> None:
        for blend in (blend_matrices, blend_dual_quaternions):
            close(blend(self.bones, [0, 0, 1, 0, 0]), self.bones[:, 2], 1e-14)
            close(blend(A[:, np.newaxis], [7]), A, 1e-14)

    def test_the_mean_and_its_nearest_rotation(self) -> None:
        shares = self.weights / self.weights.sum(axis=1, keepdims=True)
        mean = np.einsum("...n,...nij->...ij", shares, self.bones)
        close(blend_matrices(self.bones, self.weights), mean)
        repaired = blend_matrices(self.bones, self.weights, repair=True)
        u, _, vt = np.linalg.svd(mean[:, :3, :3])
        close(repaired[:, :3, :3], u @ vt, 1e-13)
        close(repaired[:, :3, 3], mean[:, :3, 3])

    def test_two_of_equal_weight_meet_on_their_screw(self) -> None:
        both = np.stack([A, B], axis=1)
        close(blend_dual_quaternions(both, [1, 1]), screw_motion(A, B, 0.5), 1e-10)

    def test_two_follow_their_screw_at_an_uneven_speed(self) -> None:
        """Turned about the screw's axis, a blend of two is within 8.15 degrees of the even one."""
        a, b = ONE, about(179, (0, 0, 5))
        t = np.linspace(0, 1, 201)
        blends = blend_dual_quaternions(np.stack([a, b]), np.stack([1 - t, t], axis=1))
        turned = np.degrees(np.arctan2(blends[:, 1, 0], blends[:, 0, 0]))
        assert 8 < np.abs(turned - 179 * t).max() < 8.15
        close(blends[:, :2, 3], 0)

    def test_against_scipy_s_dual_quaternions(self) -> None:
        """With turns of up to 90 degrees from a common one, signs agree whoever is first."""
        bones = A[:, np.newaxis] @ self.bones
        poses = RigidTransform.from_matrix(bones.reshape(-1, 4, 4))
        d = poses.as_dual_quat(scalar_first=True).reshape(N, 5, 8)
        d *= np.sign(np.sum(d[:, :1, :4] * d[..., :4], axis=-1, keepdims=True))
        total = np.einsum("kn,kni->ki", self.weights, d)
        expected = RigidTransform.from_dual_quat(total, scalar_first=True).as_matrix()
        close(blend_dual_quaternions(bones, self.weights), expected, 1e-13)

    def test_of_a_wrist(self) -> None:
        """Between 0 and 170 degrees, averaged matrices leave cos 85 degrees of the radius."""
        twist = np.stack([ONE, about(170)])
        point = transform(blend_matrices(twist, [1, 1]), [1, 0, 0])
        close(np.linalg.norm(point), np.cos(np.radians(85)))
        for kept in (
            blend_matrices(twist, [1, 1], repair=True),
            blend_dual_quaternions(twist, [1, 1]),
        ):
            close(kept, about(85), 1e-15)

    def test_half_a_turn_apart(self) -> None:
        opposite = np.stack([ONE, about(180)])
        message = "matrices at index (1,) are half a turn from"
        refuses(message, blend_dual_quaternions, opposite, [1, 1])
        close(blend_dual_quaternions(opposite, [1, 0]), ONE)
        refuses("m1 and m2 are half a turn apart", straight_motion, *opposite, 0.5)
        with pytest.raises(ValueError, match=r"^matrix has several nearest rotations"):
            blend_matrices(opposite, [1, 1], True)

    @given(st.floats(0, np.pi), st.floats(0, 1))
    def test_are_never_nan(self, angle: float, share: float) -> None:
        assume(angle < 3.14 and 0 < share < 1)
        both = np.stack([ONE, about(np.degrees(angle), (1, 0, 0))])
        for found in (
            blend_dual_quaternions(both, [share, 1 - share]),
            blend_matrices(both, [share, 1 - share], repair=True),
        ):
            assert np.isfinite(found).all()
