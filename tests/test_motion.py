"""Page A: rotation vectors, angular velocity, three integrators and cameras.

Against scipy, sympy and their own laws.
"""

from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.integrate import solve_ivp
from scipy.linalg import expm, logm
from scipy.spatial.transform import Rotation, RotationSpline
from spheres import E1, E2, E3, Array, close, random_units

from rotedu.errors import DegenerateError
from rotedu.motion import (
    angular_velocity,
    integrate,
    look_at,
    matrix_from_rotation_vector,
    matrix_steps,
    quaternion_steps,
    rotation_vector,
)
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion

RNG = np.random.default_rng(29)
AXES = np.vstack([np.eye(3), -np.eye(3), [[0.6, 0.8, 0], [0, -0.6, 0.8]], random_units(300, 3)])
SIZES = [0, 1e-300, 1e-12, 1e-8, 1e-4, 0.5, np.pi / 2, 3, np.pi - 1e-4, np.pi - 1e-9]
ALL = Rotation.random(300, rng=RNG).as_matrix()
FACTORIALS = ((0, 1), (1, 1), (2, 2), (3, 6), (4, 24))
vectors = arrays(float, 3, elements=st.floats(-20, 20))


def crossed(v: Any) -> Array:
    """The matrix of the cross product, written down once more."""
    x, y, z = np.asarray(v)
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def spinning(n: int, seconds: float = 2, middle: bool = False) -> tuple[Array, float]:
    """Velocities of a body that wobbles, at the beginning or in the middle of n steps."""
    dt = seconds / n
    return wobble((np.arange(n) + middle / 2) * dt), dt


def wobble(t: Any) -> Array:
    return np.stack([np.cos(3 * t), np.sin(2 * t) + 1, 2 * np.cos(t)], axis=-1)


def followed(start: Array, seconds: float) -> Array:
    """Where the wobbling body gets, by an integrator that knows nothing of rotations."""

    def rate(t: float, entries: Array) -> Array:
        return np.ravel(crossed(wobble(t)) @ entries.reshape(3, 3))

    solution = solve_ivp(rate, (0, seconds), start.ravel(), "DOP853", rtol=1e-13, atol=1e-13)
    return np.asarray(solution.y[:, -1].reshape(3, 3))


class TestExponential:
    def test_against_the_matrix_exponential(self) -> None:
        for v in RNG.normal(scale=3, size=(50, 3)):
            close(matrix_from_rotation_vector(v), expm(crossed(v)), 1e-13)

    @pytest.mark.parametrize("size", [*SIZES, np.pi, 5, 2 * np.pi, 100])
    def test_against_scipy(self, size: float) -> None:
        found = matrix_from_rotation_vector(size * AXES)
        close(found, Rotation.from_rotvec(size * AXES).as_matrix(), 2e-15 * max(size, 7))

    def test_power_series_collapses(self) -> None:
        """[n]^3 = -[n], and so the series is Rodrigues' formula; the derivative is [n] times it."""
        x, y, t = sp.symbols("x y t", real=True)
        k = sp.Matrix(crossed([x, y, sp.sqrt(1 - x**2 - y**2)]))
        assert (k**3 + k).expand() == sp.zeros(3)
        rodrigues = sp.eye(3) + sp.sin(t) * k + (1 - sp.cos(t)) * k * k
        assert (rodrigues.diff(t) - k * rodrigues).expand() == sp.zeros(3)

    def test_zero_turns_nothing(self) -> None:
        close(matrix_from_rotation_vector([0, 0, 0]), np.eye(3), 0)

    @given(vectors, vectors)
    def test_turning_the_vector_is_a_change_of_frame(self, v: Array, w: Array) -> None:
        b = matrix_from_rotation_vector(w)
        close(matrix_from_rotation_vector(b @ v), b @ matrix_from_rotation_vector(v) @ b.T, 1e-13)


class TestLogarithm:
    @pytest.mark.parametrize("size", SIZES)
    def test_undoes_the_exponential(self, size: float) -> None:
        close(rotation_vector(matrix_from_rotation_vector(size * AXES)), size * AXES, 1e-14)

    def test_against_scipy(self) -> None:
        close(rotation_vector(ALL), Rotation.from_matrix(ALL).as_rotvec(), 1e-13)
        for m, v in zip(ALL[:10], rotation_vector(ALL[:10]), strict=True):
            close(crossed(v), logm(m).real, 1e-10)

    def test_half_turns(self) -> None:
        for axis in AXES:
            v = rotation_vector(rotation_matrix(axis, np.pi))
            first = axis[np.abs(axis) > 1e-12][0]
            close(v, np.pi * np.sign(first) * axis, 1e-13)
            close(matrix_from_rotation_vector(v), matrix_from_rotation_vector(-v), 2e-15)

    @given(vectors)
    def test_is_the_shortest(self, v: Array) -> None:
        found = rotation_vector(matrix_from_rotation_vector(v))
        size = np.linalg.norm(v)
        close(np.linalg.norm(found), abs((size + np.pi) % (2 * np.pi) - np.pi), 1e-13)
        close(matrix_from_rotation_vector(found), matrix_from_rotation_vector(v), 1e-13)

    def test_single_precision_and_stacks(self) -> None:
        v = (2 * AXES.reshape(2, -1, 3)).astype(np.float32)
        m = matrix_from_rotation_vector(v)
        assert m.dtype == np.float32
        assert m.shape == (2, 154, 3, 3)
        assert rotation_vector(m).dtype == np.float32
        close(rotation_vector(m), v, 2e-6)


class TestAngularVelocity:
    def test_undoes_integration(self) -> None:
        velocities, dt = spinning(40)
        turns = integrate(ALL[0], velocities, dt)
        assert turns.shape == (41, 3, 3)
        close(angular_velocity(turns, dt), velocities, 1e-12)
        close(integrate(turns[0], angular_velocity(turns, dt), dt), turns, 1e-13)

    def test_against_scipy_s_spline_of_rotations(self) -> None:
        """Its rates are in the body's frame: R^T omega."""
        spline = RotationSpline(np.arange(6), Rotation.from_matrix(ALL[:6]))
        for dt, within in ((1e-3, 1e-4), (1e-4, 1e-6)):
            t = np.arange(0.5, 4.5, 0.25)
            pairs = np.stack([spline(t - dt / 2).as_matrix(), spline(t + dt / 2).as_matrix()], 1)
            fixed = angular_velocity(pairs, dt)[:, 0]
            body = np.einsum("kij,ki->kj", spline(t).as_matrix(), fixed)
            close(body, spline(t, 1), within)

    def test_is_right_to_second_order_in_the_middle(self) -> None:
        errors = []
        for n in (50, 100):
            velocities, dt = spinning(50 * n, middle=True)
            found = angular_velocity(integrate(np.eye(3), velocities, dt)[::50], 50 * dt)
            errors.append(np.abs(found - spinning(n, middle=True)[0]).max())
        assert 3.5 < errors[0] / errors[1] < 4.5

    def test_stacks(self) -> None:
        turns = ALL[:24].reshape(2, 3, 4, 3, 3)
        found = angular_velocity(turns, 0.5)
        assert found.shape == (2, 3, 3, 3)
        close(found[1, 2], angular_velocity(turns[1, 2], 0.5), 1e-14)

    def test_refusals(self) -> None:
        half = [np.eye(3), rotation_matrix(E1, 1), np.diag([1, -1, -1]) @ rotation_matrix(E1, 1)]
        match = r"^rotations\[1\] and the next are half a turn apart"
        with pytest.raises(DegenerateError, match=match):
            angular_velocity(half, 1)
        with pytest.raises(DegenerateError, match=r"^rotations\[1, 1\] and the next"):
            angular_velocity([[np.eye(3)] * 3, half], 1)
        with pytest.raises(ValueError, match=r"^rotations must number at least 2; got 1$"):
            angular_velocity([np.eye(3)], 1)
        with pytest.raises(ValueError, match=r"^dt must not be zero; got 0$"):
            angular_velocity(half, 0)
        with pytest.raises(ValueError, match=r"^dt must be one number; got shape \(2,\)$"):
            angular_velocity(half, [1, 1])


class TestIntegrators:
    START = ALL[7]

    def errors(self, steps: Any, middle: bool = False) -> Array:
        true = followed(self.START, 2)
        off = []
        for n in (200, 400, 800):
            velocities, dt = spinning(n, middle=middle)
            off.append(np.linalg.norm(steps(velocities, dt) - true))
        return np.asarray(off)

    def by_quaternions(self, velocities: Array, dt: float) -> Array:
        q = quaternion_steps(Quaternion.from_matrix(self.START).components, velocities, dt)[-1]
        w, *v = q / np.linalg.norm(q)
        return Quaternion(w, v).matrix()

    def test_all_converge_at_their_order(self) -> None:
        """Against scipy; the exponential gains an order if the velocity is that of the middle."""
        orders = {
            "exponential": (self.errors(lambda v, dt: integrate(self.START, v, dt)[-1]), 1),
            "matrix": (self.errors(lambda v, dt: matrix_steps(self.START, v, dt)[-1]), 1),
            "quaternion": (self.errors(self.by_quaternions), 1),
            "middle": (self.errors(lambda v, dt: integrate(self.START, v, dt)[-1], True), 2),
        }
        for name, (errors, order) in orders.items():
            close(errors[:-1] / errors[1:], 2**order, 0.15 * order, name)

    def test_a_constant_velocity_is_followed_exactly(self) -> None:
        omega, seconds = np.array([0.3, -1.2, 0.7]), 10.0
        for n in (1, 7, 1000):
            turns = integrate(self.START, np.tile(omega, (n, 1)), seconds / n)
            close(turns[-1], expm(seconds * crossed(omega)) @ self.START, 2e-13)
            close(turns.swapaxes(-1, -2) @ turns, np.broadcast_to(np.eye(3), turns.shape), 1e-13)

    @given(vectors, st.floats(1e-3, 1))
    def test_what_an_euler_step_does(self, omega: Array, dt: float) -> None:
        m = matrix_steps(self.START, [omega], dt)[1]
        close(m, (np.eye(3) + dt * crossed(omega)) @ self.START, 1e-12)
        size = dt * np.linalg.norm(omega)
        stretched = np.sqrt(1 + size**2)
        close(np.linalg.svd(m)[1], [stretched, stretched, 1], 1e-10)
        q = quaternion_steps([1, 0, 0, 0], [omega], dt)[1]
        close(q, [1, *(dt / 2 * omega)], 1e-14)
        close(np.linalg.norm(q), np.sqrt(1 + size**2 / 4), 1e-12)

    def test_quaternion_step_by_quaternions(self) -> None:
        velocities, dt = spinning(30)
        q = Quaternion.from_matrix(self.START)
        found = quaternion_steps(q.components, velocities, dt)
        assert found.shape == (31, 4)
        for omega, components in zip(velocities, found[1:], strict=True):
            q = q + dt / 2 * (Quaternion(0, omega) * q)
            close(components, q.components, 1e-13)

    @given(vectors, st.floats(1e-3, 1))
    def test_cayley_does_for_a_matrix_what_dividing_does_for_a_quaternion(
        self, omega: Array, dt: float
    ) -> None:
        k, size = dt * crossed(omega), dt * np.linalg.norm(omega)
        cayley = np.eye(3) + 4 / (4 + size**2) * (k + k @ k / 2)
        close(cayley, np.linalg.solve(np.eye(3) - k / 2, np.eye(3) + k / 2), 1e-12)
        w, *v = quaternion_steps([1, 0, 0, 0], [omega], dt)[1]
        close(cayley, Quaternion(w, v).matrix(), 1e-12)

    def test_at_order_4_the_half_angle_makes_a_sixteenth(self) -> None:
        """Runge and Kutta's step for y' = i y turns by the argument of a polynomial."""
        angle = np.radians(10)
        short = [
            angle - factor * np.angle(sum((1j * angle / factor) ** k / f for k, f in FACTORIALS))
            for factor in (1, 2)
        ]
        close(short[0] / short[1], 16, 0.2)

    def test_the_mean_of_two_neighbours_is_worse_than_the_middle(self) -> None:
        true = followed(np.eye(3), 2)
        t, dt = np.linspace(0, 2, 81, retstep=True)
        means = (wobble(t)[1:] + wobble(t)[:-1]) / 2
        by_means, by_middles = (
            rotation_vector(true.T @ integrate(np.eye(3), velocities, dt)[-1])
            for velocities in (means, wobble(t[:-1] + dt / 2))
        )
        ratio = np.linalg.norm(by_means) / np.linalg.norm(by_middles)
        assert 4.5 < ratio < 5.5

    def test_the_rates(self) -> None:
        """R' = [omega] R makes q' = omega q / 2, and in the body's frame q' = q Omega / 2."""
        q, omega = sp.symbols("q:4"), sp.symbols("u v w")
        # (2-6) for any q, times its squared norm, which these rates keep.
        r = sp.Quaternion(*q).to_rotation_matrix(homogeneous=False) * sum(c**2 for c in q)
        r = r.applyfunc(sp.cancel)
        k = sp.Matrix(crossed(omega))
        half, spin = sp.Quaternion(*q) / 2, sp.Quaternion(0, *omega)
        for rate, wanted in ((spin * half, k * r), (half * spin, r * k)):
            found = sum(
                (r.diff(c) * change for c, change in zip(q, rate.args[:4], strict=True)), 0 * r
            )
            assert (found - wanted).expand() == sp.zeros(3)

    def test_the_body_s_frame(self) -> None:
        """Velocities in the body's frame act from the right, or backwards on the transpose."""
        body, dt = spinning(25)
        r = self.START
        for turn in matrix_from_rotation_vector(dt * body):
            r = r @ turn
        close(integrate(self.START.T, -body, dt)[-1].T, r, 1e-13)

    def test_back_and_forth(self) -> None:
        velocities, dt = spinning(25)
        there = integrate(self.START, velocities, dt)
        close(integrate(there[-1], velocities[::-1], -dt)[::-1], there, 1e-13)

    def test_stacks_and_no_steps(self) -> None:
        velocities = RNG.normal(size=(2, 4, 5, 3))
        start = ALL[:4]
        found = integrate(start, velocities, 0.1)
        assert found.shape == matrix_steps(start, velocities, 0.1).shape == (2, 4, 6, 3, 3)
        close(found[1, 2], integrate(start[2], velocities[1, 2], 0.1), 1e-15)
        q = Quaternion.from_matrix(start).components
        assert quaternion_steps(q, velocities, 0.1).shape == (2, 4, 6, 4)
        assert integrate(np.eye(3), np.empty((0, 3)), 1).shape == (1, 3, 3)
        assert integrate(np.eye(3, dtype=np.float32), [[0, 0, 1]], 0.1).dtype == np.float32


class TestLookAt:
    def test_against_scipy(self) -> None:
        """The rotation that takes W to the direction and V as near to `up` as it can."""
        directions, ups = random_units(2, 50, 3, rng=np.random.default_rng(4))
        for direction, up, found in zip(directions, ups, look_at(directions, 3 * ups), strict=True):
            oracle, _ = Rotation.align_vectors([direction, up], [E3, E2], weights=[np.inf, 1])
            close(found, oracle.as_matrix(), 1e-12)

    def test_laws(self) -> None:
        directions, ups = random_units(2, 500, 3)
        m = look_at(directions, ups)
        close(m.swapaxes(-1, -2) @ m, np.broadcast_to(np.eye(3), m.shape), 1e-14)
        close(np.linalg.det(m), 1, 1e-14)
        close(m[..., 2], directions, 1e-15)
        close(np.sum(m[..., 0] * ups, axis=-1), 0, 1e-14)
        assert (np.sum(m[..., 1] * ups, axis=-1) > 0).all()
        close(look_at(E1, E3), [[0, 0, 1], [1, 0, 0], [0, 1, 0]], 0)

    @pytest.mark.parametrize("lean", [1e-7, 1e-4, np.pi - 1e-7])
    def test_nearly_straight_up_is_still_a_rotation(self, lean: float) -> None:
        m = look_at([np.sin(lean), 0, np.cos(lean)], E3)
        close(m.T @ m, np.eye(3), 1e-15)
        close(m[:, 0], E2, 1e-8)

    @pytest.mark.parametrize("sign", [1, -1])
    def test_straight_up_or_down(self, sign: int) -> None:
        match = r"^direction and up are parallel: no edge of the picture is fixed$"
        with pytest.raises(DegenerateError, match=match):
            look_at([0, 0, 5 * sign], E3)
        with pytest.raises(
            DegenerateError, match=r"^direction and up at index \(1,\) are parallel"
        ):
            look_at([E1, [1e-9, 0, sign]], E3)

    def test_stacks_and_single_precision(self) -> None:
        assert look_at(random_units(4, 1, 3), random_units(5, 3)).shape == (4, 5, 3, 3)
        assert look_at(E1.astype(np.float32), [0, 0, 1]).dtype == np.float32
