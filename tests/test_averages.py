"""Averages: against scipy, eigenvectors of quaternions, sympy, and their own laws."""

from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation
from spheres import E1, E2, E3, Array, close, random_units
from symbolic import matrix, symbolic, vanishes

from rotedu.averages import (
    angular_distance,
    chordal_distance,
    matrix_from_two_columns,
    mean_rotation,
)
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion

RNG = np.random.default_rng(2904)
R1, R2 = (Rotation.random(300, rng=RNG) for _ in range(2))
HALF_TURNS = np.array([np.diag(d) for d in [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]])
LENGTHS = arrays(float, 3, elements=st.floats(-3, 3))


def by_quaternions(q: Array, weights: Array) -> Array:
    """Find Markley's mean: the eigenvector of the largest eigenvalue, as a matrix."""
    return Rotation.from_quat(np.linalg.eigh((weights * q.T) @ q)[1][:, -1]).as_matrix()


class TestDistances:
    def test_against_scipy(self) -> None:
        angle = (R1.inv() * R2).magnitude()
        close(angular_distance(R1.as_matrix(), R2.as_matrix()), angle)
        chord = np.linalg.norm(R1.as_matrix() - R2.as_matrix(), axis=(1, 2))
        close(chordal_distance(R1.as_matrix(), R2.as_matrix()), chord)

    def test_angle_and_chord(self) -> None:
        theta = sp.symbols("theta", positive=True)
        n = sp.Matrix([2, 3, 6]) / 7
        turn = rotation_matrix(symbolic(*n), symbolic(theta))
        difference = matrix(turn - np.eye(3).astype(int))
        assert vanishes(difference.norm() ** 2 - 8 * sp.sin(theta / 2) ** 2)

        r1, r2 = R1.as_matrix(), R2.as_matrix()
        close(chordal_distance(r1, r2), 2 * np.sqrt(2) * np.sin(angular_distance(r1, r2) / 2))

    def test_angle_and_chord_of_quaternions_whose_signs_agree(self) -> None:
        p, q = R1.as_quat(), R2.as_quat()
        chord = np.minimum(np.linalg.norm(p - q, axis=1), np.linalg.norm(p + q, axis=1))
        angle = angular_distance(R1.as_matrix(), R2.as_matrix())
        close(chord, 2 * np.sin(angle / 4))
        close(angle, 2 * np.arccos(np.abs(np.sum(p * q, axis=1))), 1e-7)

    @pytest.mark.parametrize("angle", [0, 1e-12, 1e-5, 1, np.pi - 1e-9, np.pi])
    def test_of_any_size(self, angle: float) -> None:
        r = R1.as_matrix()
        turned = r @ rotation_matrix(random_units(300, 3, rng=RNG), angle)
        close(angular_distance(r, turned), angle, 2e-15)

    def test_are_metrics_that_no_frame_changes(self) -> None:
        a, b, c = (m.as_matrix()[:100] for m in (R1, R2, R2 * R1))
        for distance in (angular_distance, chordal_distance):
            close(distance(a, b), distance(b, a))
            close(distance(a, a), 0, 2e-15)
            assert (distance(a, c) <= distance(a, b) + distance(b, c) + 1e-14).all()
            close(distance(c @ a @ b, c @ b @ b), distance(a, b), 1e-13)

    def test_every_pair_by_broadcasting(self) -> None:
        r = R1[:4].as_matrix()
        close(angular_distance(r[:, np.newaxis], r)[1, 3], angular_distance(r[1], r[3]), 0)


class TestMean:
    def test_against_scipy(self) -> None:
        for n in range(1, 60):
            some, weights = R1[:n], RNG.uniform(0.1, 1, n)
            close(mean_rotation(some.as_matrix()), some.mean().as_matrix(), 1e-13)
            found = mean_rotation(some.as_matrix(), weights)
            close(found, some.mean(weights).as_matrix(), 1e-13)

    @given(arrays(float, (5, 3), elements=st.floats(-3, 3)), arrays(float, 5), st.data())
    def test_is_the_mean_of_quaternions_of_any_signs(
        self, vectors: Array, weights: Array, data: st.DataObject
    ) -> None:
        weights = np.abs(np.nan_to_num(weights, posinf=1, neginf=1)) % 7
        assume(weights.max() > 0.1)
        rotations = Rotation.from_rotvec(vectors)
        signs = np.array(data.draw(st.lists(st.sampled_from([-1, 1]), min_size=5, max_size=5)))
        q = signs[:, None] * rotations.as_quat()
        values = np.linalg.eigvalsh((weights * q.T) @ q) / weights.sum()
        assume(values[3] - values[2] > 1e-3)
        found = mean_rotation(rotations.as_matrix(), weights)
        close(found, by_quaternions(q, weights), 1e-12)

    def test_both_maximise_the_same_sum(self) -> None:
        p, q = sp.symbols("p:4"), sp.symbols("q:4")

        def turn(q: Any) -> sp.Matrix:
            w, v = q[0], sp.Matrix(q[1:])
            across = sp.Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
            return (w**2 - v.dot(v)) * sp.eye(3) + 2 * v * v.T + 2 * w * across

        def dot(p: Any, q: Any) -> Any:
            return sum(a * b for a, b in zip(p, q, strict=True))

        trace = (turn(p).T * turn(q)).trace()
        assert sp.expand(trace - 4 * dot(p, q) ** 2 + dot(p, p) * dot(q, q)) == 0

        w, *v = RNG.normal(size=4)
        unit = np.array([w, *v]) / np.linalg.norm([w, *v])
        numbers = np.array(turn(list(unit)), float)
        close(numbers, Quaternion(w, v).matrix())

    def test_no_rotation_has_a_smaller_sum_of_squared_chords(self) -> None:
        rotations, weights = R1[:7].as_matrix(), np.arange(1.0, 8)

        def cost(vector: Array) -> float:
            here = Rotation.from_rotvec(vector).as_matrix()
            return float(weights @ chordal_distance(rotations, here) ** 2)

        found = mean_rotation(rotations, weights)
        least = min(
            (minimize(cost, start, tol=1e-12) for start in R2[:8].as_rotvec()), key=lambda m: m.fun
        )
        close(cost(Rotation.from_matrix(found).as_rotvec()), least.fun, 1e-9)
        close(Rotation.from_rotvec(least.x).as_matrix(), found, 1e-5)

    def test_of_two_is_halfway(self) -> None:
        for r1, r2 in zip(R1[:50], R2[:50], strict=True):
            half = r1 * Rotation.from_rotvec((r1.inv() * r2).as_rotvec() / 2)
            found = mean_rotation([r1.as_matrix(), r2.as_matrix()])
            close(found, half.as_matrix(), 1e-12)

    def test_turns_with_the_rotations(self) -> None:
        r, a, b = R1[:9].as_matrix(), R2[0].as_matrix(), R2[1].as_matrix()
        close(mean_rotation(a @ r @ b), a @ mean_rotation(r) @ b)
        close(mean_rotation(r.swapaxes(1, 2)), mean_rotation(r).T)

    def test_of_equal_rotations_is_that_rotation(self) -> None:
        r = R1.as_matrix()[:, np.newaxis]
        close(mean_rotation(np.repeat(r, 3, axis=1)), r[:, 0], 3e-15)
        close(mean_rotation(r), r[:, 0], 3e-15)

    def test_only_ratios_of_weights_matter(self) -> None:
        r = R1[:3].as_matrix()
        expected = mean_rotation(np.concatenate([r, r[:1]]))
        for scale in (1, 1e-300, 8e307):
            close(mean_rotation(r, scale * np.array([2, 1, 1.0])), expected)
        close(mean_rotation(r, [0, 0, 2]), r[2], 3e-15)

    def test_broadcasts(self) -> None:
        r = R1[:12].as_matrix().reshape(4, 3, 3, 3)
        weights = RNG.uniform(0.1, 1, (4, 3))
        several, one_set = mean_rotation(r, weights), mean_rotation(r, weights[0])
        of_one_set = mean_rotation(r[0], weights)
        assert several.shape == one_set.shape == of_one_set.shape == (4, 3, 3)
        for i in range(4):
            close(several[i], mean_rotation(r[i], weights[i]), 1e-15)
            close(one_set[i], mean_rotation(r[i], weights[0]), 1e-15)
            close(of_one_set[i], mean_rotation(r[0], weights[i]), 1e-15)

    def test_keeps_single_precision(self) -> None:
        r = R1[:9].as_matrix()
        found = mean_rotation(r.astype(np.float32))
        assert found.dtype == np.float32
        close(found, mean_rotation(r), 1e-6)
        assert angular_distance(*r[:2].astype(np.float32)).dtype == np.float32

    @pytest.mark.parametrize(
        "rotations",
        [
            HALF_TURNS[:2],
            HALF_TURNS,
            HALF_TURNS[1:],
            rotation_matrix(E3, np.arange(3) * 2 * np.pi / 3),
            rotation_matrix([1, 2, 2], np.arange(5) * 2 * np.pi / 5),
        ],
        ids=["half a turn apart", "all half turns", "without none", "thirds", "fifths"],
    )
    def test_several_means(self, rotations: Array) -> None:
        with pytest.raises(DegenerateError, match=r"^rotations have several means$"):
            mean_rotation(rotations)
        # Rounding must not make one of them up.
        for r1, r2 in zip(R1[:50].as_matrix(), R2[:50].as_matrix(), strict=True):
            with pytest.raises(DegenerateError):
                mean_rotation(r1 @ rotations @ r2)
        with pytest.raises(
            DegenerateError, match=r"^rotations at index \(1,\) have several means$"
        ):
            mean_rotation([rotations[:1].repeat(len(rotations), axis=0), rotations])

    def test_that_there_are_several_is_judged_by_shares(self) -> None:
        many = np.tile(HALF_TURNS[:2], (500, 1, 1))
        with pytest.raises(DegenerateError):
            mean_rotation(many, 1 + 1e-6 * (np.arange(1000) == 0))

    def test_nearly_several_means(self) -> None:
        rotations = rotation_matrix(E3, [0, np.pi - 1e-5])
        close(mean_rotation(rotations), rotation_matrix(E3, np.pi / 2 - 5e-6), 1e-10)
        mean_rotation(HALF_TURNS[:2], [1, 1 + 1e-6])
        # Weights decide between two that are half a turn apart.
        close(mean_rotation(HALF_TURNS[:2], [2, 1]), np.eye(3), 1e-15)

    def test_thirds_of_a_turn_without_a_common_axis_have_one(self) -> None:
        q = np.array(
            [[1, 0, 0, 0], [1 / 2, 3**0.5 / 2, 0, 0], [1 / 2, 3**0.5 / 6, (2 / 3) ** 0.5, 0]]
        )
        rotations = Quaternion(q[:, 0], q[:, 1:]).matrix()
        apart = angular_distance(rotations, np.roll(rotations, 1, axis=0))
        close(apart, 2 * np.pi / 3)
        close(mean_rotation(rotations), by_quaternions(np.roll(q, -1, axis=1), np.ones(3)))


def matrices_of(q: Array) -> Array:
    """Matrices of quaternions of any length, the scalar part first."""
    return Rotation.from_quat(q, scalar_first=True).as_matrix()


class TestMatricesAndQuaternionsKnowTheSame:
    Q = RNG.normal(size=(2000, 5, 4))
    Q /= np.linalg.norm(Q, axis=-1, keepdims=True)
    A = Q.swapaxes(1, 2) @ Q / 5
    MEAN = np.reshape(matrices_of(Q.reshape(-1, 4)), (2000, 5, 3, 3)).mean(axis=1)

    def test_each_is_linear_in_the_other(self) -> None:
        """4 A/n - 1 is Davenport's matrix of the mean matrix."""
        m, traces = self.MEAN, np.trace(self.MEAN, axis1=1, axis2=2)
        skew = np.stack([m[:, k - 1, k - 2] - m[:, k - 2, k - 1] for k in range(3)], axis=1)
        davenport = np.empty((2000, 4, 4))
        davenport[:, 0, 0] = traces
        davenport[:, 0, 1:] = davenport[:, 1:, 0] = skew
        davenport[:, 1:, 1:] = m + m.swapaxes(1, 2) - traces[:, None, None] * np.eye(3)
        close(4 * self.A - np.eye(4), davenport, 1e-13)

    def test_eigenvalues_follow_from_singular_values(self) -> None:
        s1, s2, s3 = np.linalg.svd(self.MEAN, compute_uv=False).T
        signs = np.sign(np.linalg.det(self.MEAN))
        assert set(signs) == {-1, 1}
        s3 = signs * s3
        expected = 1 + np.array([-s1 - s2 + s3, -s1 + s2 - s3, s1 - s2 - s3, s1 + s2 + s3])
        close(4 * np.linalg.eigvalsh(self.A), expected.T, 1e-13)


class TestSumsOfQuaternions:
    """What page B says of the third way to average."""

    def test_are_near_both_means_and_as_far_from_the_truth(self) -> None:
        found = []
        for vectors in RNG.normal(scale=np.radians(40) / 3**0.5, size=(200, 10, 3)):
            scattered = Rotation.from_rotvec(vectors)
            q = scattered.as_quat()
            agreeing = np.where(q @ q[:1].T < 0, -q, q).sum(axis=0)
            by_chord, by_angle = scattered.mean(), scattered.mean()
            for _ in range(20):
                by_angle *= Rotation.from_rotvec((by_angle.inv() * scattered).as_rotvec().mean(0))
            by_sum = Rotation.from_quat(agreeing)
            at_random = Rotation.from_quat(RNG.choice([-1, 1], 10) @ q)
            means = (by_sum, by_chord, by_angle)
            found.append(
                [(by_angle.inv() * mean).magnitude() for mean in means[:2]]
                + [mean.magnitude() for mean in (*means, at_random, scattered[0])]
            )
        sum_off, chord_off, *truth, at_random, single = np.degrees(np.median(found, axis=0))
        assert 3 < chord_off / sum_off < 6
        assert np.ptp(truth) < 0.1 < chord_off < min(truth)
        assert at_random > single + 5

    def test_may_be_right_though_signs_cannot_agree_in_pairs(self) -> None:
        turns = Rotation.from_rotvec(np.outer(np.radians([-100, 0, 100]), E3))
        q = turns.as_quat(canonical=True)
        assert q[0] @ q[2] < 0 < q[0] @ q[1]
        close(mean_rotation(turns.as_matrix()), Rotation.from_quat(q.sum(0)).as_matrix())

    def test_mean_matrices_of_ten_random_rotations_often_reflect(self) -> None:
        random = Rotation.random(20000, rng=RNG).as_matrix().reshape(2000, 10, 3, 3)
        assert 0.25 < np.mean(np.linalg.det(random.mean(axis=1)) < 0) < 0.32


class TestTwoColumns:
    @given(LENGTHS, LENGTHS)
    def test_against_qr_and_in_what_it_says(self, a: Array, b: Array) -> None:
        across = np.linalg.norm(np.cross(a, b))
        assume(across > 1e-3 * np.linalg.norm(a) * np.linalg.norm(b) > 1e-9)
        found = matrix_from_two_columns(a, b)
        close(found.T @ found, np.eye(3), 1e-12)
        close(found[:, 2], np.cross(a, b) / across, 1e-12)
        close(found[:, 0], a / np.linalg.norm(a))
        q, r = np.linalg.qr(np.stack([a, b], axis=1))
        close(found[:, :2], q * np.sign(np.diag(r)), 1e-12)

    def test_gives_back_a_rotation(self) -> None:
        r = R1.as_matrix()
        close(matrix_from_two_columns(r[..., 0], r[..., 1]), r)
        close(matrix_from_two_columns(3 * r[..., 0], r[..., 1] / 7 - 5 * r[..., 0]), r, 1e-12)

    def test_exactly(self) -> None:
        first = sp.Matrix([3, 4, 0]) / 5
        second = sp.Matrix([-4, 3, 12]) / 13
        b = sp.Rational(5, 13) * first + sp.Rational(12, 13) * second
        found = matrix(matrix_from_two_columns(symbolic(*first), symbolic(*b)))
        assert found == sp.Matrix.hstack(first, second, first.cross(second))

    @pytest.mark.parametrize("b", [E1, -E1, [1, 1e-9, 0]])
    def test_parallel(self, b: Any) -> None:
        with pytest.raises(DegenerateError, match=r"^a and b are parallel: no unique second"):
            matrix_from_two_columns(2 * E1, b)
        with pytest.raises(DegenerateError, match=r"^a and b at index \(1,\) are parallel"):
            matrix_from_two_columns(E1, [E2, b])

    def test_nearly_parallel(self) -> None:
        close(matrix_from_two_columns(E1, [1, 1e-6, 0]), np.eye(3), 1e-9)

    @pytest.mark.parametrize(("kind", "apart"), [(np.float64, 1e-6), (np.float32, 3e-3)])
    def test_stays_a_rotation_where_they_are_nearly_parallel(self, kind: Any, apart: float) -> None:
        a = RNG.normal(size=(300, 3))
        b = a + apart * np.linalg.norm(a, axis=1, keepdims=True) * random_units(300, 3, rng=RNG)
        across = np.linalg.norm(np.cross(a, b), axis=1) / np.linalg.norm(a, axis=1) ** 2
        clear = across > apart / 2
        found = matrix_from_two_columns(a[clear].astype(kind), b[clear].astype(kind))
        close(found.swapaxes(1, 2) @ found - np.eye(3), 0, 10 * np.finfo(kind).eps)

    def test_is_continuous_where_quaternions_with_a_rule_for_the_sign_jump(self) -> None:
        before, after = rotation_matrix(E3, np.radians([179.9, 180.1]))
        close(angular_distance(before, after), np.radians(0.2), 1e-12)
        p, q = (Quaternion.from_matrix(m).components for m in (before, after))
        assert np.linalg.norm(before[:, :2] - after[:, :2]) < 0.005
        assert np.linalg.norm(p - q) > 1.99
        assert min(np.linalg.norm(p - q), np.linalg.norm(p + q)) < 0.002
