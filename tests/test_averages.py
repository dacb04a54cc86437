"""Averages: against scipy, eigenvectors of quaternions, sympy, and their own laws."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation
from spheres import E1, E3, Array, close, random_units, refuses

from rotedu.averages import angular_distance, chordal_distance, mean_rotation
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion

RNG = np.random.default_rng(2904)
R1, R2 = (Rotation.random(300, rng=RNG) for _ in range(2))
M1, M2 = R1.as_matrix(), R2.as_matrix()
HALF_TURNS = np.array([np.diag(d) for d in [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]])


def by_quaternions(q: Array, weights: Array) -> Array:
    """Find Markley's mean: the eigenvector of the largest eigenvalue, as a matrix."""
    return Rotation.from_quat(np.linalg.eigh((weights * q.T) @ q)[1][:, -1]).as_matrix()


class TestDistances:
    def test_against_scipy_and_quaternions_whose_signs_agree(self) -> None:
        angle, chord = angular_distance(M1, M2), chordal_distance(M1, M2)
        close(angle, (R1.inv() * R2).magnitude())
        close(chord, np.linalg.norm(M1 - M2, axis=(1, 2)))
        close(chord, 2 * np.sqrt(2) * np.sin(angle / 2))
        p, q = R1.as_quat(), R2.as_quat()
        of_quaternions = np.linalg.norm([p - q, p + q], axis=-1).min(axis=0)
        close(of_quaternions, 2 * np.sin(angle / 4))
        cosine = np.abs(np.sum(p * q, axis=1))
        close(angle, 2 * np.arccos(cosine), 1e-7)
        # So matrices and quaternions have the same mean: it maximises the same sum.
        close(np.sum(M1 * M2, axis=(1, 2)), 4 * cosine**2 - 1)

    @pytest.mark.parametrize("angle", [0, 1e-12, 1e-5, 1, np.pi - 1e-9, np.pi])
    def test_of_any_size(self, angle: float) -> None:
        turned = M1 @ rotation_matrix(random_units(300, 3, rng=RNG), angle)
        close(angular_distance(M1, turned), angle, 2e-15)


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

    @pytest.mark.parametrize("scale", [1, 1e-300, 8e307])
    def test_only_ratios_of_weights_matter(self, scale: float) -> None:
        expected = mean_rotation(M1[[0, 1, 2, 0]])
        close(mean_rotation(M1[:3], scale * np.array([2, 1, 1.0])), expected)
        close(mean_rotation(M1[:3], [0, 0, scale]), M1[2], 3e-15)

    @pytest.mark.parametrize(
        "rotations",
        [
            HALF_TURNS[:2],
            HALF_TURNS,
            rotation_matrix(E3, np.arange(3) * 2 * np.pi / 3),
            rotation_matrix([1, 2, 2], np.arange(5) * 2 * np.pi / 5),
        ],
        ids=["half a turn apart", "all half turns", "thirds", "fifths"],
    )
    def test_several_means(self, rotations: Array) -> None:
        refuses("rotations have several means", mean_rotation, rotations)
        # Rounding must not make one of them up.
        for r1, r2 in zip(M1[:50], M2[:50], strict=True):
            refuses("rotations have several means", mean_rotation, r1 @ rotations @ r2)
        same = rotations[:1].repeat(len(rotations), axis=0)
        message = "rotations at index (1,) have several means"
        refuses(message, mean_rotation, [same, rotations])

    def test_that_there_are_several_is_judged_by_shares(self) -> None:
        many = np.tile(1.0 * HALF_TURNS[:2], (500, 1, 1))
        refuses("rotations have", mean_rotation, many, 1 + 1e-6 * (np.arange(1000) == 0))
        many[0] = rotation_matrix(E1, 1e-6)
        refuses("rotations have", mean_rotation, many)

    def test_nearly_several_means(self) -> None:
        rotations = rotation_matrix(E3, [0, np.pi - 1e-5])
        close(mean_rotation(rotations), rotation_matrix(E3, np.pi / 2 - 5e-6), 1e-10)
        mean_rotation(HALF_TURNS[:2], [1, 1 + 1e-6])
        # Weights decide between two that are half a turn apart.
        close(mean_rotation(HALF_TURNS[:2], [2, 1]), np.eye(3), 1e-15)

    def test_thirds_of_a_turn_without_a_common_axis_have_one(self) -> None:
        rows = [1, 0, 0, 0], [1 / 2, 3**0.5 / 2, 0, 0], [1 / 2, 3**0.5 / 6, (2 / 3) ** 0.5, 0]
        q = np.array(rows)
        rotations = Quaternion(q[:, 0], q[:, 1:]).matrix()
        apart = angular_distance(rotations, np.roll(rotations, 1, axis=0))
        close(apart, 2 * np.pi / 3)
        close(mean_rotation(rotations), by_quaternions(np.roll(q, -1, axis=1), np.ones(3)))


class TestSumsOfQuaternions:
    """What page B says of the third way to average."""

    def test_are_as_far_from_the_truth_as_both_means(self) -> None:
        scattered = Rotation.from_rotvec(RNG.normal(scale=np.radians(40) / 3**0.5, size=(40000, 3)))
        q, m = scattered.as_quat().reshape(-1, 10, 4), scattered.as_matrix().reshape(-1, 10, 3, 3)
        by_angle = by_chord = mean_rotation(m)
        for _ in range(8):
            seen = (by_angle[:, np.newaxis].swapaxes(-1, -2) @ m).reshape(-1, 3, 3)
            step = Rotation.from_matrix(seen).as_rotvec().reshape(-1, 10, 3).mean(axis=1)
            by_angle = by_angle @ Rotation.from_rotvec(step).as_matrix()
        signs = np.where(q @ q[:, :1].swapaxes(1, 2) < 0, -1, 1), RNG.choice([-1, 1], (4000, 10, 1))
        sums = (Rotation.from_quat((sign * q).sum(axis=1)) for sign in signs)
        means = Rotation.from_matrix(by_chord), Rotation.from_matrix(by_angle), *sums, scattered
        *truth, at_random, single = (np.degrees(np.median(mean.magnitude())) for mean in means)
        assert np.ptp(truth) < 0.01 * min(truth)
        assert at_random > single + 5

    def test_may_be_right_though_signs_cannot_agree_in_pairs(self) -> None:
        turns = Rotation.from_rotvec(np.outer(np.radians([-100, 0, 100]), E3))
        q = turns.as_quat(canonical=True)
        assert q[0] @ q[2] < 0 < q[0] @ q[1]
        close(mean_rotation(turns.as_matrix()), Rotation.from_quat(q.sum(0)).as_matrix())

    def test_mean_matrices_of_ten_random_rotations_often_reflect(self) -> None:
        random = Rotation.random(20000, rng=RNG).as_matrix().reshape(2000, 10, 3, 3)
        assert 0.25 < np.mean(np.linalg.det(random.mean(axis=1)) < 0) < 0.32
