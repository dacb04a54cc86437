"""Orientations: against scipy, quaternions and their own laws."""

from itertools import product
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.linalg import expm, logm
from scipy.spatial.transform import Rotation, Slerp
from spheres import (
    E3,
    FRACTIONS,
    RNG,
    Array,
    bezier,
    close,
    random_units,
    refuses,
)

from rotedu.closed_curve import closed_curve
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.orientation_curves import closed_rotation_curve, one_turn, periodic_spline, squad
from rotedu.orientations import nearest_rotation, slerp_rotations

# The warnings about unstable curves have tests of their own.
pytestmark = pytest.mark.filterwarnings("ignore:.* are almost .*:UserWarning")

R1, R2 = (Rotation.random(300, rng=RNG).as_matrix() for _ in range(2))
ONE, HALF_TURN = np.eye(3), np.diag([1.0, -1, -1])


class TestSlerp:
    def test_against_scipy(self) -> None:
        t = [0, 0.2, 0.7, 1]
        for r1, r2 in zip(R1[:50], R2[:50], strict=True):
            oracle = Slerp([0, 1], Rotation.from_matrix([r1, r2]))(t).as_matrix()
            close(slerp_rotations(r1, r2, t), oracle, 1e-13)

    def test_laws(self) -> None:
        close(slerp_rotations(R1, R2, 0), R1, 1e-15)
        close(slerp_rotations(R1, R2, 1), R2, 4e-15)
        close(slerp_rotations(R1, R2, 2), R2 @ R1.swapaxes(-1, -2) @ R2, 1e-13)
        close(slerp_rotations(R1, R1, 0.3), R1, 3e-15)

    @pytest.mark.parametrize("rest", [1e-2, 1e-6, 1e-9, 1e-12])
    def test_nearly_half_a_turn(self, rest: float) -> None:
        r1, axis = R1[0], np.array([2, 3, 6]) / 7
        r2 = r1 @ rotation_matrix(axis, np.pi - rest)
        expected = r1 @ rotation_matrix(axis, (np.pi - rest) / 4)
        close(slerp_rotations(r1, r2, 0.25), expected)

    def test_half_a_turn(self) -> None:
        apart = "r1 and r2 are half a turn apart: no unique arc joins them"
        turned = R1 @ rotation_matrix(random_units(300, 3), np.pi)
        almost = rotation_matrix([1, 2, 2], np.pi - 5e-15)
        for r1, r2 in [(ONE, HALF_TURN), (ONE, almost), *zip(R1, turned, strict=True)]:
            refuses(apart, slerp_rotations, r1, r2, 0.5)
        message = "r1 and r2 at index (1,) are half a turn apart"
        refuses(message, slerp_rotations, ONE, [ONE, HALF_TURN], 0.5)


class TestClosedCurve:
    # Where a sine or cosine loses digits.
    LENGTHS = 1e-16, 1e-9, 1e-8, 3e-8, 1e-7, 1e-4, 0.1, 1, 2, 3, np.pi - 1e-2

    @pytest.mark.parametrize(
        ("theta", "dtype"),
        [*product(LENGTHS, ["f4", "f8"]), (np.pi - 1e-4, "f8"), (np.pi - 1e-7, "f8")],
    )
    def test_with_turns_of_any_size(self, theta: float, dtype: str) -> None:
        # Fraction 0 makes the angles in the first segment 3 u^2 - 2 u^3 times theta.
        u, axes = np.arange(20) / 20, random_units(20, 3, rng=np.random.default_rng(20))
        for start, axis in zip(R1[:20], axes, strict=True):
            turn = theta * np.array([0, 1, 0.6])
            rotations = start @ Rotation.from_rotvec(turn[:, None] * axis).as_matrix()
            rotations[2] = rotations[2] @ rotation_matrix(np.roll(axis, 1), 0.7)
            found = closed_rotation_curve(rotations.astype(dtype), 20, 0)
            assert found.dtype == dtype
            part = theta * (3 * u**2 - 2 * u**3)
            expected = start @ Rotation.from_rotvec(part[:, None] * axis).as_matrix()
            close(found[:20], expected, {"f4": 3e-6, "f8": 1e-14}[dtype])

    @pytest.mark.parametrize(
        ("size", "dtype", "rounding"),
        [(size, np.float64, 1e-14) for size in (1e-100, 1e-16, 1e-12, 1e-9)]
        + [(size, np.float32, 4e-6) for size in (1e-15, 1e-7)],
    )
    def test_of_tiny_turns_is_the_one_of_their_axes(
        self, size: float, dtype: Any, rounding: float
    ) -> None:
        turns, u = np.random.default_rng(7).normal(size=(7, 3)), np.arange(10) / 10
        rotations = np.tile(ONE, (7, 1, 1))
        rotations[:, [2, 0, 1], [1, 2, 0]] = size * turns
        rotations[:, [1, 2, 0], [2, 0, 1]] = -size * turns
        curve = closed_rotation_curve(rotations.astype(dtype), 10).reshape(7, 10, 3, 3)
        found = (curve - curve.swapaxes(-1, -2))[..., [2, 0, 1], [1, 2, 0]] / (2 * size)
        close(found, bezier(turns, 1 / 2, u).swapaxes(0, 1), rounding)

    @staticmethod
    def follows_quaternions_whose_signs_agree(vectors: Array, fraction: float) -> None:
        """The first round of theirs, if they close after two."""
        rotations = Rotation.from_rotvec(vectors)
        q = rotations.as_quat(canonical=True, scalar_first=True)
        for i in range(1, len(q)):
            q[i] *= np.sign(q[i] @ q[i - 1])
        given = q if q[-1] @ q[0] > 0 else np.concatenate([q, -q])
        curve = closed_curve(given, 5, fraction)[: len(q) * 5]
        expected = Rotation.from_quat(curve, scalar_first=True).as_matrix()
        found = closed_rotation_curve(rotations.as_matrix(), 5, fraction)
        close(found, expected, 1e-12)
        close(found[::5], rotations.as_matrix(), 1e-15)

    @pytest.mark.parametrize("fraction", [0.2, *FRACTIONS, 1])
    @pytest.mark.parametrize("scale", [0.1, 0.35, 0.5, 0.8, 1.2, 1.5])
    def test_follows_the_route_of_quaternions(self, scale: float, fraction: float) -> None:
        for vectors in np.random.default_rng(2).normal(scale=scale, size=(40, 5, 3)):
            self.follows_quaternions_whose_signs_agree(vectors, fraction)
        for swing_or_round in [0, 100, 0, -100], [0, 72, 144, 216, 288]:
            vectors = np.outer(np.radians(swing_or_round), E3)
            self.follows_quaternions_whose_signs_agree(vectors, fraction)

    @pytest.mark.slow
    def test_no_random_loop_is_refused_or_leaves_the_route(self) -> None:
        rng = np.random.default_rng()
        for scale in rng.uniform(0.1, 1.5, 5000):
            vectors = rng.normal(scale=scale, size=(rng.integers(3, 9), 3))
            self.follows_quaternions_whose_signs_agree(vectors, 0.5)

    def test_degenerate(self) -> None:
        message = "rotations[0] and rotations[1] are half a turn apart"
        refuses(message, closed_rotation_curve, [ONE, HALF_TURN, ONE])
        message = "Double(rotations[0], rotations[1]) and rotations[2] are a whole turn apart"
        forth = rotation_matrix(E3, [0, np.pi - 1e-9, 0, 0.1])
        refuses(message, closed_rotation_curve, forth)
        for dtype, rounding in [(np.float64, 1e-14), (np.float32, 2e-6)]:
            same = np.stack([R1[0]] * 3).astype(dtype)
            close(closed_rotation_curve(same, 5), [same[0]] * 15, rounding)
        stops = rotation_matrix(E3, [0, 0.5, 0, -0.5])
        close(closed_rotation_curve(stops, 5)[::5], stops, 1e-15)


def one_sided(curve: Array, samples: int) -> tuple[Array, Array]:
    """Velocity and acceleration of each segment at its start and end, shape (n, 2, d)."""
    pieces = np.concatenate([curve, curve[:1]])[
        np.add.outer(np.arange(0, len(curve), samples), np.arange(samples + 1))
    ]
    ends = np.stack([pieces[:, :4], pieces[:, :-5:-1]], axis=1)
    velocity = np.einsum("k,nekd->ned", [-11 / 6, 3, -3 / 2, 1 / 3], ends) * samples
    acceleration = np.einsum("k,nekd->ned", [2, -5, 4, -1], ends) * samples**2
    return velocity * np.array([[1], [-1]]), acceleration


def jumps(ends: Array) -> Array:
    """How much a quantity changes from the end of each segment to the start of the next."""
    return np.linalg.norm(ends[:, 0] - np.roll(ends[:, 1], 1, axis=0), axis=-1)


class TestSquad:
    # Complex matrices that multiply as 1, i, j and k do, and tell q from -q.
    UNITS = np.array([[[1, 0], [0, 1]], [[1j, 0], [0, -1j]], [[0, 1], [-1, 0]], [[0, 1j], [1j, 0]]])

    @pytest.mark.slow
    def test_is_that_of_shoemake_with_exponentials_and_logarithms_of_scipy(self) -> None:
        def arc(p: Array, q: Array, t: float) -> Array:
            return np.asarray(p @ expm(t * logm(p.conj().T @ q)))

        for q in random_units(4, 5, 4, rng=np.random.default_rng(5)):
            here = np.tensordot(q, self.UNITS, axes=1)
            s = [
                p @ expm(-(logm(p.conj().T @ here[i - 4]) + logm(p.conj().T @ here[i - 1])) / 4)
                for i, p in enumerate(here)
            ]
            expected = [
                arc(arc(here[i], here[i - 4], u), arc(s[i], s[i - 4], u), 2 * u * (1 - u))
                for i in range(5)
                for u in np.arange(3) / 3
            ]
            close(np.tensordot(squad(q, 3), self.UNITS, axes=1), expected, 1e-12)

    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_laws(self, d: int) -> None:
        points = random_units(7, d, rng=np.random.default_rng(d))
        curve = squad(points, 10)
        close(np.linalg.norm(curve, axis=-1), 1, 1e-15)
        close(curve[::10], points, 1e-15)
        turn = np.linalg.qr(RNG.normal(size=(d, d)))[0]
        close(squad(points @ turn, 10), curve @ turn, 1e-12)
        back = squad(np.roll(points[::-1], 1, axis=0), 10)
        close(np.roll(back[::-1], 1, axis=0), curve, 1e-12)
        close(squad(points[[0, 0, 0]], 5), np.broadcast_to(points[0], (15, d)), 1e-15)

    def test_is_c1_but_not_c2(self) -> None:
        points = random_units(6, 4, rng=np.random.default_rng(8))
        velocity, acceleration = one_sided(squad(points, 2000), 2000)
        close(jumps(velocity), 0, 1e-4)
        assert np.linalg.norm(velocity, axis=-1).min() > 0.1
        assert jumps(acceleration).min() > 1

    @pytest.mark.parametrize("fraction", FRACTIONS)
    def test_its_acceleration_usually_jumps_more_than_that_of_the_paper_s_curve(
        self, fraction: float
    ) -> None:
        more = []
        for vectors in np.random.default_rng(10).normal(scale=0.5, size=(40, 5, 3)):
            q = Rotation.from_rotvec(vectors).as_quat(canonical=True, scalar_first=True)
            curves = squad(q, 100), closed_curve(q, 100, fraction)
            of_squad, of_paper = (jumps(one_sided(curve, 100)[1]).max() for curve in curves)
            more.append(of_squad > of_paper)
        assert np.mean(more) > 0.9

    def test_a_point_moves_four_segments(self) -> None:
        points = random_units(8, 4, rng=np.random.default_rng(9))
        moved = np.array([points[1], *points[1:]])
        apart = np.linalg.norm(squad(points, 5) - squad(moved, 5), axis=-1).reshape(8, 5)
        close(apart[2:6], 0, 1e-15)
        assert apart[[0, 1, 6, 7], 1:].min() > 1e-3

    def test_degenerate(self) -> None:
        p, q, r, _ = np.eye(4)
        apart = "are antipodal: no unique arc joins them"
        refuses(f"quaternions[1] and quaternions[2] {apart}", squad, [p, q, -q, r])
        # In a plane, at angles that send s to opposite ends, and the two arcs to opposite sides.
        for degrees, what in [
            ([0, 120, 130, 10], "points s of quaternions[0] and quaternions[1]"),
            ([0, 170, 0, 170], "points of the arcs from q and s"),
        ]:
            points = np.stack([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))], axis=-1)
            refuses(f"{what} {apart}", squad, points, 2)


class TestPeriodicSpline:
    @pytest.mark.parametrize("n", [3, 4, 5, 12, 101])
    @pytest.mark.parametrize("d", [1, 4, 9])
    def test_against_scipy(self, n: int, d: int) -> None:
        values = np.random.default_rng(n).normal(size=(n, d))
        oracle = CubicSpline(np.arange(n + 1), [*values, values[0]], bc_type="periodic")
        found = periodic_spline(values, 7)
        close(found, oracle(np.arange(7 * n) / 7), 1e-13)
        close(found[::7], values, 1e-15)


def test_whoever_follows_the_matrices_needs_no_half_angles() -> None:
    """`one_turn` finds one turn for two."""
    v, w = np.random.default_rng(15).normal(scale=1.2, size=(2, 500, 3))
    found, steps = v, np.linspace(0, 1, 400)
    for s in steps[1:]:
        after = Rotation.from_rotvec(v) * Rotation.from_rotvec(s * w)
        short = after.as_rotvec()
        whole = 2 * np.pi * short / np.linalg.norm(short, axis=1, keepdims=True)
        known = np.stack([short + k * whole for k in (-1, 0, 1)])
        nearest = np.linalg.norm(known - found, axis=2).argmin(axis=0)
        found = known[nearest, np.arange(500)]
    assert (np.linalg.norm(found, axis=1) > np.pi).sum() > 50
    close(found, one_turn(v.T, w.T).T, 1e-11)


class TestNearestRotation:
    def test_against_scipy(self) -> None:
        rng = np.random.default_rng(12)
        for m in [*R1 + rng.normal(scale=0.3, size=R1.shape), *rng.normal(size=R1.shape)]:
            # The rotation that takes the axes to the columns of M, as well as it can.
            oracle, _ = Rotation.align_vectors(m.T, ONE)
            close(nearest_rotation(m), oracle.as_matrix(), 1e-12)

    def test_ignores_size_and_leaves_rotations(self) -> None:
        close(nearest_rotation(1e200 * R2), nearest_rotation(R2), 1e-15)
        close(nearest_rotation(R1), R1, 3e-15)

    @pytest.mark.parametrize(
        "singular", [(0, 0, 0), (1, 0, 0), (-1, -1, -1), (3, 1, -1), (100, 1e-7, 1e-7)]
    )
    def test_several_are_equally_near(self, singular: tuple[float, ...]) -> None:
        m = np.diag(singular)
        refuses("matrix has several nearest rotations", nearest_rotation, m)
        message = "matrix at index (1,) has several nearest rotations"
        refuses(message, nearest_rotation, [ONE, m])

    @pytest.mark.parametrize("singular", [(1, 1e-6, 1e-6), (3, 2, -1)])
    def test_one_is_nearest(self, singular: tuple[float, ...]) -> None:
        close(nearest_rotation(np.diag(singular)), ONE, 1e-15)
