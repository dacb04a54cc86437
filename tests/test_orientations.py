"""Orientations: against scipy, quaternions and their own laws."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.linalg import expm, logm
from scipy.spatial.transform import Rotation, Slerp
from spheres import (
    E3,
    FRACTIONS,
    LENGTHS_AND_DTYPES,
    RNG,
    UNEQUAL_GAPS,
    Array,
    bezier,
    close,
    random_units,
    turning,
)

from rotedu.arcs import slerp
from rotedu.closed_curve import closed_curve
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import axis_angle, rotation_matrix
from rotedu.orientations import (
    closed_rotation_curve,
    nearest_rotation,
    one_turn,
    periodic_spline,
    slerp_rotations,
    squad,
)
from rotedu.quaternions import Quaternion

# The warnings about unstable curves have tests of their own.
pytestmark = pytest.mark.filterwarnings("ignore:.* are almost .*:UserWarning")


class TestOrientations:
    R1, R2 = (Rotation.random(300, rng=RNG).as_matrix() for _ in range(2))
    ROUND = rotation_matrix([1, 2, 2], np.arange(5) * 2 * np.pi / 5)

    @staticmethod
    def gentle(n: int) -> tuple[Quaternion, Array]:
        """Orientations that turn by less than a quarter, as quaternions whose signs agree."""
        rng = np.random.default_rng(n)
        axes, sizes = random_units(n, 3, rng=rng), rng.uniform(0.1, 0.5, n)
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
        close(turns.swapaxes(-1, -2) @ turns, np.broadcast_to(np.eye(3), turns.shape))
        close(np.linalg.det(turns), 1)
        whole = axis_angle(self.R1.swapaxes(-1, -2) @ self.R2)[1]
        close(axis_angle(self.R1.swapaxes(-1, -2) @ turns)[1], t * whole, 1e-13)
        close(slerp_rotations(self.R2, self.R1, 1 - t), turns, 1e-13)
        close(slerp_rotations(self.R1, self.R2, 0), self.R1, 1e-15)
        close(slerp_rotations(self.R1, self.R2, 1), self.R2, 4e-15)
        twice = self.R2 @ self.R1.swapaxes(-1, -2) @ self.R2
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
        # As for points, the angles in the first segment are 3 u^2 - 2 u^3 times theta.
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
        # With 1, one of the first arcs is longer than 2.5, and so is one of each level.
        start, axis = self.R1[0], [2, 3, 6]
        rotations = rotation_matrix(axis, np.cumsum([0, *gaps[:2]])) @ start
        turn = turning(gaps, fraction, np.arange(20) / 20)
        found = closed_rotation_curve(rotations, 20, fraction)
        close(found, rotation_matrix(axis, turn) @ start)

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
        found = (curve - curve.swapaxes(-1, -2))[..., [2, 0, 1], [1, 2, 0]] / (2 * size)
        close(found, bezier(turns, 1 / 2, u).swapaxes(0, 1), rounding)

    def test_closed_curve_of_equal_orientations(self) -> None:
        for dtype, rounding in [(np.float64, 1e-14), (np.float32, 2e-6)]:
            same = np.stack([self.R1[0]] * 4).astype(dtype)
            close(closed_rotation_curve(same, 5), [same[0]] * 20, rounding)

    @pytest.mark.parametrize("fraction", FRACTIONS)
    def test_closed_curve_of_small_turns_is_that_of_quaternions_whose_signs_agree(
        self, fraction: float
    ) -> None:
        q, matrices = self.gentle(20)
        components = closed_curve(q.components, 10, fraction)
        expected = Quaternion(components[:, 0], components[:, 1:]).matrix()
        close(closed_rotation_curve(matrices, 10, fraction), expected, 1e-13)

    @pytest.mark.parametrize("fraction", FRACTIONS)
    def test_closed_curve_is_that_of_products_and_powers_of_scipy(self, fraction: float) -> None:
        def arc(p: Rotation, q: Rotation, t: float) -> Rotation:
            return p * Rotation.from_rotvec(t * (p.inv() * q).as_rotvec())

        def a_of(i: int) -> Rotation:
            middle = arc(here[i] * here[i - 1].inv() * here[i], here[(i + 1) % 5], 0.5)
            return arc(here[i], middle, fraction)

        vectors = np.random.default_rng(4).normal(scale=0.35, size=(5, 3))
        here = list(Rotation.from_rotvec(vectors))
        expected = []
        for i, j in ((i, (i + 1) % 5) for i in range(5)):
            control = [here[i], a_of(i), here[j] * a_of(j).inv() * here[j], here[j]]
            for u in np.arange(8) / 8:
                row = control
                while len(row) > 1:
                    row = [arc(p, q, u) for p, q in pairwise(row)]
                expected.append(row[0].as_matrix())
        matrices = Rotation.from_rotvec(vectors).as_matrix()
        close(closed_rotation_curve(matrices, 8, fraction), np.array(expected), 1e-13)

    @staticmethod
    def on_a_circle(at: Any, fraction: float, samples: int) -> Array:
        """Do the same with angles in degrees, half of which is an arc of quaternions."""

        def arc(p: Array, q: Array, t: Any) -> Array:
            # Of the ways from p to q that differ by two turns, take the shorter one.
            return p + t * ((q - p + 360) % 720 - 360)

        here = np.array(at, dtype=float)
        middle = arc(2 * here - np.roll(here, 1), np.roll(here, -1), 0.5)
        a = arc(here, middle, fraction)
        row = [here, a, np.roll(2 * here - a, -1), np.roll(here, -1)]
        row, u = [control[:, None] for control in row], np.arange(samples) / samples
        while len(row) > 1:
            row = [arc(p, q, u) for p, q in pairwise(row)]
        return np.asarray(row[0]).ravel()

    @pytest.mark.parametrize("fraction", FRACTIONS)
    @pytest.mark.parametrize(
        "at", [(0, 100, 10, -60), (0, 60, 10, -60), (0, 150, 100, 20, -70), (0, 100, 0, -100)]
    )
    def test_about_one_axis_it_does_sums_on_a_circle_of_720_degrees(
        self, at: tuple[float, ...], fraction: float
    ) -> None:
        curve = closed_rotation_curve(rotation_matrix([2, 3, 6], np.radians(at)), 20, fraction)
        angles = np.radians(self.on_a_circle(at, fraction, 20))
        close(curve, rotation_matrix([2, 3, 6], angles), 1e-13)

    def test_a_swing_keeps_to_its_ends(self) -> None:
        swing = rotation_matrix(E3, np.radians([0, 100, 10, -60]))
        x, y, _ = closed_rotation_curve(swing, 100)[:, :, 0].T
        angle = np.degrees(np.unwrap(np.arctan2(y, x)))
        close([angle.min(), angle.max()], [-60, 100], 0.2)

    @staticmethod
    def of_quaternions(rotations: Rotation, samples: int, fraction: float) -> Array:
        """The curve of quaternions whose signs agree: the first round, if they close after two."""
        q = rotations.as_quat(canonical=True, scalar_first=True)
        for i in range(1, len(q)):
            q[i] *= np.sign(q[i] @ q[i - 1])
        given = q if q[-1] @ q[0] > 0 else np.concatenate([q, -q])
        curve = closed_curve(given, samples, fraction)[: len(q) * samples]
        return np.asarray(Rotation.from_quat(curve, scalar_first=True).as_matrix())

    @pytest.mark.parametrize("fraction", FRACTIONS)
    @pytest.mark.parametrize("scale", [0.1, 0.35, 0.5, 0.8, 1.2, 1.5])
    def test_follows_the_route_of_quaternions_whose_signs_agree(
        self, scale: float, fraction: float
    ) -> None:
        for vectors in np.random.default_rng(2).normal(scale=scale, size=(40, 5, 3)):
            rotations = Rotation.from_rotvec(vectors)
            expected = self.of_quaternions(rotations, 5, fraction)
            close(closed_rotation_curve(rotations.as_matrix(), 5, fraction), expected, 1e-12)

    @pytest.mark.slow
    def test_no_random_loop_is_refused_or_leaves_the_route(self) -> None:
        rng = np.random.default_rng()
        for scale in rng.uniform(0.1, 1.5, 5000):
            n = rng.integers(3, 9)
            rotations = Rotation.from_rotvec(rng.normal(scale=scale, size=(n, 3)))
            expected = self.of_quaternions(rotations, 5, 0.5)
            close(closed_rotation_curve(rotations.as_matrix(), 5, 0.5), expected, 1e-12)

    def test_laws_of_the_closed_curve(self) -> None:
        _, matrices = self.gentle(7)
        assert closed_rotation_curve(matrices).shape == (700, 3, 3)
        curve = closed_rotation_curve(matrices, 20)
        assert curve.shape == (140, 3, 3)
        close(curve[::20], matrices, 1e-15)
        close(curve.swapaxes(-1, -2) @ curve, np.broadcast_to(np.eye(3), curve.shape))
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
        steps = axis_angle(half.swapaxes(-1, -2) @ np.roll(half, -1, axis=0))[1]
        close(steps.sum(), 2 * np.pi)

    def test_quaternions_need_agreeing_signs_where_matrices_do_not(self) -> None:
        q = Quaternion.from_axis_angle([1, 2, 2], np.arange(5) * 2 * np.pi / 5)
        match = r"^Double\(points\[4\], points\[0\]\) and points\[1\] are antipodal"
        with pytest.raises(DegenerateError, match=match):
            closed_curve(q.components)

    def test_a_point_carried_along_is_not_the_curve_of_the_points(self) -> None:
        # On the sphere, the twist about the pointing vector is lost.
        twisted = rotation_matrix(E3, [0, 0.5, 1.0])
        close(closed_curve(twisted[:, :, 2], 10), [E3] * 30, 1e-15)
        assert np.abs(closed_rotation_curve(twisted, 10) - np.eye(3)).max() > 0.8

    def test_degenerate(self) -> None:
        half = np.diag([1.0, -1, -1])
        match = r"^rotations\[0\] and rotations\[1\] are half a turn apart"
        with pytest.raises(DegenerateError, match=match):
            closed_rotation_curve([np.eye(3), half, np.eye(3)])
        forth = rotation_matrix(E3, [0, np.pi - 1e-9, 0, 0.1])
        match = r"^Double\(rotations\[0\], rotations\[1\]\) and rotations\[2\] are a whole turn"
        with pytest.raises(DegenerateError, match=match):
            closed_rotation_curve(forth)
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
        close(squad(-points, 10), -curve, 1e-15)
        close(squad(points[[0, 0, 0]], 5), np.broadcast_to(points[0], (15, d)), 1e-15)

    def test_even_steps_about_one_axis_are_followed_evenly(self) -> None:
        steps = np.radians(np.arange(0, 360, 60))
        u = np.radians(np.arange(0, 360, 10))
        circle = squad(np.stack([np.cos(steps), np.sin(steps)], axis=-1), 6)
        close(circle, np.stack([np.cos(u), np.sin(u)], axis=-1))

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
        moved = points.copy()
        moved[0] = points[1]
        apart = np.linalg.norm(squad(points, 5) - squad(moved, 5), axis=-1).reshape(8, 5)
        close(apart[2:6], 0, 1e-15)
        assert apart[[0, 1, 6, 7], 1:].min() > 1e-3

    def test_degenerate(self) -> None:
        p, q, r, _ = np.eye(4)
        match = r"^quaternions\[1\] and quaternions\[2\] are antipodal: no unique arc joins them$"
        with pytest.raises(DegenerateError, match=match):
            squad([p, q, -q, r])
        # In a plane, at angles that send s to opposite ends, and the two arcs to opposite sides.
        for degrees, what in (
            ([0, 120, 130, 10], r"points s of quaternions\[0\] and quaternions\[1\]"),
            ([0, 170, 0, 170], "points of the arcs from q and s"),
        ):
            points = np.stack([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))], axis=-1)
            with pytest.raises(DegenerateError, match=f"^{what} are antipodal"):
                squad(points, 2)

    def test_stacks(self) -> None:
        points = random_units(2, 3, 5, 4)
        curves = squad(points, 4)
        assert curves.shape == (2, 3, 20, 4)
        close(curves[1, 2], squad(points[1, 2], 4), 1e-15)
        assert squad(np.empty((0, 5, 4)), 4).shape == (0, 20, 4)


class TestPeriodicSpline:
    @pytest.mark.parametrize("n", [3, 4, 5, 12, 101])
    @pytest.mark.parametrize("d", [1, 4, 9])
    def test_against_scipy(self, n: int, d: int) -> None:
        values = np.random.default_rng(n).normal(size=(n, d))
        oracle = CubicSpline(np.arange(n + 1), [*values, values[0]], bc_type="periodic")
        close(periodic_spline(values, 7), oracle(np.arange(7 * n) / 7), 1e-13)

    def test_is_c2(self) -> None:
        values = np.random.default_rng(1).normal(size=(5, 3))
        velocity, acceleration = one_sided(periodic_spline(values, 1000), 1000)
        close(jumps(velocity), 0, 1e-8)
        close(jumps(acceleration), 0, 1e-4)
        assert np.linalg.norm(acceleration, axis=-1).min() > 1

    def test_laws(self) -> None:
        rng = np.random.default_rng(2)
        values, other, m = rng.normal(size=(6, 4)), rng.normal(size=(6, 4)), rng.normal(size=(4, 4))
        curve = periodic_spline(values, 9)
        close(curve[::9], values, 1e-15)
        close(periodic_spline(values + 2 * other, 9), curve + 2 * periodic_spline(other, 9))
        close(periodic_spline(values @ m, 9), curve @ m)
        close(periodic_spline(np.roll(values, 1, axis=0), 9), np.roll(curve, 9, axis=0))
        close(periodic_spline(np.ones((3, 1)), 4), np.ones((12, 1)), 1e-15)

    def test_stacks(self) -> None:
        values = np.random.default_rng(3).normal(size=(2, 3, 5, 4))
        curves = periodic_spline(values, 4)
        assert curves.shape == (2, 3, 20, 4)
        close(curves[1, 2], periodic_spline(values[1, 2], 4), 1e-15)
        assert periodic_spline(np.empty((0, 5, 4)), 4).shape == (0, 20, 4)
        single = values.astype(np.float32)
        assert periodic_spline(single, 4).dtype == np.float32
        close(periodic_spline(single, 4), curves, 2e-6)

    def test_turning_all_quaternions_turns_the_normalised_curve(self) -> None:
        q, turn = random_units(5, 4), Quaternion(*np.split(random_units(4), [1]))
        turned = turn * Quaternion(q[:, 0], q[:, 1:])
        curve = periodic_spline(q, 6)
        expected = turn.matrix() @ Quaternion(curve[:, 0], curve[:, 1:]).matrix()
        found = periodic_spline(turned.components, 6)
        close(Quaternion(found[:, 0], found[:, 1:]).matrix(), expected)


class TestOneTurn:
    """The half-angle rule, which finds one turn for two."""

    def test_whoever_follows_the_matrices_needs_no_half_angles(self) -> None:
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
    R = Rotation.random(300, rng=np.random.default_rng(11)).as_matrix()

    def test_of_a_rotation_is_itself(self) -> None:
        close(nearest_rotation(self.R), self.R, 3e-15)

    def test_against_scipy(self) -> None:
        noisy = self.R + np.random.default_rng(12).normal(scale=0.3, size=self.R.shape)
        # The rotation that takes the axes to the columns of M, as well as it can.
        for m in noisy:
            oracle, _ = Rotation.align_vectors(m.T, np.eye(3))
            close(nearest_rotation(m), oracle.as_matrix(), 1e-12)

    def test_no_other_rotation_is_nearer(self) -> None:
        rng = np.random.default_rng(13)
        for m in rng.normal(size=(50, 3, 3)):
            nearest = nearest_rotation(m)
            close(nearest.T @ nearest, np.eye(3))
            close(np.linalg.det(nearest), 1)
            others = np.concatenate(
                [
                    self.R,
                    nearest
                    @ Rotation.from_rotvec(rng.normal(scale=0.01, size=(50, 3))).as_matrix(),
                ]
            )
            distance = np.linalg.norm(nearest - m)
            assert (np.linalg.norm(others - m, axis=(1, 2)) > distance).all()

    def test_commutes_with_rotations_and_ignores_size(self) -> None:
        m = np.random.default_rng(14).normal(size=(3, 3))
        close(nearest_rotation(self.R @ m), self.R @ nearest_rotation(m), 1e-13)
        close(nearest_rotation(1e200 * m), nearest_rotation(m), 1e-15)

    def test_that_it_flattens_is_judged_by_its_size(self) -> None:
        with pytest.raises(DegenerateError):
            nearest_rotation(np.diag([100, 1e-7, 1e-7]))
        close(nearest_rotation(np.diag([1, 1e-6, 1e-6])), np.eye(3), 1e-15)

    def test_of_a_reflection_that_stretches(self) -> None:
        close(nearest_rotation(np.diag([3, 2, -1])), np.eye(3), 1e-15)

    @pytest.mark.parametrize(
        "m", [np.zeros((3, 3)), np.diag([1, 0, 0]), -np.eye(3), np.diag([3, 1, -1])]
    )
    def test_several_are_equally_near(self, m: Array) -> None:
        with pytest.raises(DegenerateError, match=r"^matrix has several nearest rotations$"):
            nearest_rotation(m)
        with pytest.raises(DegenerateError, match=r"^matrix at index \(1,\) has several"):
            nearest_rotation([np.eye(3), m])
