"""Page A: rotation vectors, angular velocity, three integrators and cameras.

Against scipy, sympy and their own laws.
"""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.spatial.transform import Rotation, RotationSpline
from spheres import AXES, E1, E2, E3, Array, close, random_units, refuses, vectors

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
SIZES = [0, 1e-300, 1e-12, 1e-8, 1e-4, 0.5, np.pi / 2, 3, np.pi - 1e-4, np.pi - 1e-9]
ALL = Rotation.random(300, rng=RNG).as_matrix()
START = ALL[7]


def crossed(v: Any) -> Array:
    """The matrix of the cross product, written down once more."""
    x, y, z = np.asarray(v)
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def spinning(n: int, known: str = "at the beginning") -> tuple[Array, float]:
    """Velocities for n steps of a body that wobbles for two seconds."""
    t, dt = np.linspace(0, 2, n + 1, retstep=True)
    velocities = {
        "at the beginning": wobble(t[:-1]),
        "in the middle": wobble(t[:-1] + dt / 2),
        "by the mean of both ends": (wobble(t[:-1]) + wobble(t[1:])) / 2,
    }
    return velocities[known], dt


def wobble(t: Any) -> Array:
    return np.stack([np.cos(3 * t), np.sin(2 * t) + 1, 2 * np.cos(t)], axis=-1)


def followed() -> Array:
    """Where the wobbling body gets, by an integrator that knows nothing of rotations."""

    def rate(t: float, entries: Array) -> Array:
        return np.ravel(crossed(wobble(t)) @ entries.reshape(3, 3))

    solution = solve_ivp(rate, (0, 2), START.ravel(), "DOP853", rtol=1e-13, atol=1e-13)
    return np.asarray(solution.y[:, -1].reshape(3, 3))


class TestExponential:
    @pytest.mark.parametrize("size", [*SIZES, np.pi, 5, 2 * np.pi, 100])
    def test_against_scipy(self, size: float) -> None:
        found = matrix_from_rotation_vector(size * AXES)
        close(found, Rotation.from_rotvec(size * AXES).as_matrix(), 2e-15 * max(size, 7))


class TestLogarithm:
    @pytest.mark.parametrize("size", SIZES)
    def test_undoes_the_exponential(self, size: float) -> None:
        close(rotation_vector(matrix_from_rotation_vector(size * AXES)), size * AXES, 1e-14)

    @given(vectors(20))
    def test_is_the_shortest(self, v: Array) -> None:
        found = rotation_vector(matrix_from_rotation_vector(v))
        size = np.linalg.norm(v)
        close(np.linalg.norm(found), abs((size + np.pi) % (2 * np.pi) - np.pi), 1e-13)
        close(matrix_from_rotation_vector(found), matrix_from_rotation_vector(v), 1e-13)


class TestAngularVelocity:
    def test_undoes_integration(self) -> None:
        velocities, dt = spinning(40)
        turns = integrate(ALL[0], velocities, dt)
        assert turns.shape == (41, 3, 3)
        close(angular_velocity(turns, dt), velocities, 1e-12)
        close(integrate(turns[0], angular_velocity(turns, dt), dt), turns, 1e-13)
        close(integrate(turns[-1], velocities[::-1], -dt), turns[::-1], 1e-13)
        for steps in (integrate, matrix_steps):
            close(steps(ALL[0], velocities[:0], dt), ALL[:1], 1e-15)

    def test_against_scipy_s_spline_of_rotations(self) -> None:
        """Its rates are in the body's frame: R^T omega."""
        spline = RotationSpline(np.arange(6), Rotation.from_matrix(ALL[:6]))
        for dt, within in ((1e-3, 1e-4), (1e-4, 1e-6)):
            t = np.arange(0.5, 4.5, 0.25)
            pairs = np.stack([spline(t - dt / 2).as_matrix(), spline(t + dt / 2).as_matrix()], 1)
            fixed = angular_velocity(pairs, dt)[:, 0]
            body = np.einsum("kij,ki->kj", spline(t).as_matrix(), fixed)
            close(body, spline(t, 1), within)

    def test_half_turns_are_refused(self) -> None:
        half = [np.eye(3), rotation_matrix(E1, 1), np.diag([1, -1, -1]) @ rotation_matrix(E1, 1)]
        message = "rotations[1] and the next are half a turn apart"
        refuses(message, angular_velocity, half, 1)
        refuses("rotations[1, 1] and the next", angular_velocity, [[np.eye(3)] * 3, half], 1)


class TestIntegrators:
    @staticmethod
    def by_quaternions(velocities: Array, dt: float) -> Array:
        q = quaternion_steps(Quaternion.from_matrix(START).components, velocities, dt)[-1]
        w, *v = q / np.linalg.norm(q)
        return Quaternion(w, v).matrix()

    @pytest.mark.parametrize(
        ("steps", "known", "order"),
        [
            (by_quaternions, "at the beginning", 1),
            (lambda v, dt: matrix_steps(START, v, dt)[-1], "at the beginning", 1),
            (lambda v, dt: integrate(START, v, dt)[-1], "at the beginning", 1),
            (lambda v, dt: integrate(START, v, dt)[-1], "in the middle", 2),
            (lambda v, dt: integrate(START, v, dt)[-1], "by the mean of both ends", 2),
        ],
    )
    def test_all_converge_at_their_order(self, steps: Any, known: str, order: int) -> None:
        ends = [steps(*spinning(n, known)) for n in (200, 400, 800)]
        errors = np.linalg.norm(np.subtract(ends, followed()), axis=(1, 2))
        close(errors[:-1] / errors[1:], 2**order, 0.15 * order)

    def test_a_constant_velocity_is_followed_exactly(self) -> None:
        omega, seconds = np.array([0.3, -1.2, 0.7]), 10.0
        for n in (1, 7, 1000):
            turns = integrate(START, np.tile(omega, (n, 1)), seconds / n)
            close(turns[-1], expm(seconds * crossed(omega)) @ START, 2e-13)
            close(turns.swapaxes(-1, -2) @ turns, np.broadcast_to(np.eye(3), turns.shape), 1e-13)

    @given(vectors(20), st.floats(1e-3, 1))
    def test_what_an_euler_step_does(self, omega: Array, dt: float) -> None:
        m = matrix_steps(START, [omega], dt)[1]
        close(m, (np.eye(3) + dt * crossed(omega)) @ START, 1e-12)
        size = dt * np.linalg.norm(omega)
        stretched = np.sqrt(1 + size**2)
        close(np.linalg.svd(m)[1], [stretched, stretched, 1], 1e-10)
        start = Quaternion.from_matrix(START)
        q = quaternion_steps(start.components, [omega], dt)[1]
        close(q, (start + dt / 2 * (Quaternion(0, omega) * start)).components, 1e-14)
        close(np.linalg.norm(q), np.sqrt(1 + size**2 / 4), 1e-12)

    @given(vectors(20), st.floats(1e-3, 1))
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
        series, angle = [1 / 24, 1 / 6, 1 / 2, 1, 1], np.radians(10)
        whole, half = (angle - n * np.angle(np.polyval(series, 1j * angle / n)) for n in (1, 2))
        close(whole / half, 16, 0.2)


class TestLookAt:
    def test_against_scipy(self) -> None:
        """The rotation that takes W to the direction and V as near to `up` as it can."""
        directions, ups = random_units(2, 50, 3, rng=np.random.default_rng(4))
        for direction, up, found in zip(directions, ups, look_at(directions, 3 * ups), strict=True):
            oracle, _ = Rotation.align_vectors([direction, up], [E3, E2], weights=[np.inf, 1])
            close(found, oracle.as_matrix(), 1e-12)
            close(found[:, 2], direction, 1e-15)

    @pytest.mark.parametrize("lean", [1e-7, 1e-4, np.pi - 1e-7])
    def test_nearly_straight_up_is_still_a_rotation(self, lean: float) -> None:
        m = look_at([np.sin(lean), 0, np.cos(lean)], E3)
        close(m.T @ m, np.eye(3), 1e-15)
        close(m[:, 0], E2, 1e-8)

    def test_straight_up_or_down(self) -> None:
        for sign in (1, -1):
            message = "direction and up are parallel: no edge of the picture is fixed"
            refuses(message, look_at, [0, 0, 5 * sign], E3)
            message = "direction and up at index (1,) are parallel"
            refuses(message, look_at, [E1, [1e-9, 0, sign]], E3)
