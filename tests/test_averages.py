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

    def test_is_continuous_where_quaternions_with_a_rule_for_the_sign_jump(self) -> None:
        before, after = rotation_matrix(E3, np.radians([179.9, 180.1]))
        close(angular_distance(before, after), np.radians(0.2), 1e-12)
        p, q = (Quaternion.from_matrix(m).components for m in (before, after))
        assert np.linalg.norm(before[:, :2] - after[:, :2]) < 0.005
        assert np.linalg.norm(p - q) > 1.99
        assert min(np.linalg.norm(p - q), np.linalg.norm(p + q)) < 0.002
