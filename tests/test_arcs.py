"""Arcs, (5-1) to (5-3): against sympy, scipy and their own laws."""

import math
from typing import Any

import numpy as np
import pytest
from scipy.spatial import geometric_slerp
from spheres import (
    E1,
    E2,
    E3,
    HERE,
    PAIRS,
    RNG,
    TwoPoints,
    close,
    great_circle,
    on_the_sphere,
    random_units,
    where,
)
from symbolic import symbolic, vanishes

from rotedu.arcs import angle_between, arc_axis, nlerp, slerp, slerp_by_rotation
from rotedu.control_points import (
    bisect,
    bisect_by_rotation,
)
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import rotate, rotation_matrix
from rotedu.orientations import slerp_rotations
from rotedu.quaternions import Quaternion


class TestAngle:
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_in_any_dimension(self, d: int) -> None:
        p, q = random_units(2, 300, d)
        cosine = np.clip(np.sum(p * q, axis=-1), -1, 1)
        close(np.cos(angle_between(p, q)), cosine)

    @pytest.mark.parametrize("theta", [0, 1e-150, 1e-15, 1e-9, 1e-8, 1e-7, 1e-3, 1, 3])
    def test_small_angles_keep_their_digits(self, theta: float) -> None:
        found = angle_between(E1, [np.cos(theta), np.sin(theta), 0])
        np.testing.assert_allclose(found, theta, rtol=1e-15)

    @pytest.mark.parametrize("rest", [0, 1e-12, 1e-8, 1e-3])
    def test_near_pi(self, rest: float) -> None:
        close(angle_between(E1, [-np.cos(rest), np.sin(rest), 0]), np.pi - rest, 5e-16)

    def test_length_does_not_matter(self) -> None:
        p, q = PAIRS
        close(angle_between(7 * p, 1e-200 * q), angle_between(p, q))


class TestAxis:
    @pytest.mark.equation("5-1")
    def test_is_perpendicular_and_right_handed(self) -> None:
        p, q = PAIRS
        axis = arc_axis(p, q)
        on_the_sphere(axis)
        close(np.sum(axis * p, axis=-1), 0, 1e-13)
        close(np.sum(axis * q, axis=-1), 0, 1e-13)
        close(np.cross(p, q), np.sin(angle_between(p, q))[:, None] * axis)

    @pytest.mark.parametrize("theta", [1e-12, 1e-8, 1e-3, np.pi - 1e-3, np.pi - 1e-7])
    def test_near_the_ends(self, theta: float) -> None:
        close(arc_axis(E1, [np.cos(theta), np.sin(theta), 0]), E3, 1e-15)
        p = HERE
        q = rotate(p, arc_axis(p, [1, 2, 3]), theta)
        # The points themselves are rounded to 1e-16.
        close(arc_axis(p, q), arc_axis(p, [1, 2, 3]), 4e-16 / np.sin(theta))


class TestArc:
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_against_scipy(self, d: int) -> None:
        t = np.linspace(0, 1, 11)
        for p, q in random_units(50, 2, d):
            close(slerp(p, q, t), geometric_slerp(p, q, t))

    def test_both_forms_agree(self) -> None:
        p, q = PAIRS
        for t in [0, 0.1, 0.5, 0.8, 1, 1.7, -0.6]:
            close(slerp_by_rotation(p, q, t), slerp(p, q, t), 1e-13)

    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_on_the_sphere_from_end_to_end(self, d: int) -> None:
        p, q = random_units(2, 2000, d)
        on_the_sphere(slerp(p, q, RNG.uniform(0, 1, 2000)))
        close(slerp(p, q, 0), p, 1e-15)
        close(slerp(p, q, 1), q, 1e-15)

    def test_at_constant_speed(self) -> None:
        p, q = PAIRS
        t = RNG.uniform(0, 1, 500)
        close(angle_between(p, slerp(p, q, t)), t * angle_between(p, q))
        close(angle_between(slerp(p, q, t), q), (1 - t) * angle_between(p, q))

    def test_as_printed_where_that_is_possible(self) -> None:
        for p, q in PAIRS.swapaxes(0, 1)[:50]:
            theta = math.acos(p @ q)
            if 0.1 < theta < 3:
                printed = (math.sin(0.7 * theta) * p + math.sin(0.3 * theta) * q) / math.sin(theta)
                close(slerp(p, q, 0.3), printed)

    @pytest.mark.parametrize("theta", [1e-300, 1e-12, 1e-9, 1e-8, 1e-7, 1e-4])
    def test_nearly_coincident(self, theta: float) -> None:
        q = [np.cos(theta), np.sin(theta), 0]
        for form in [slerp, slerp_by_rotation]:
            found = form(E1, q, [0.25, 0.5])
            np.testing.assert_allclose(
                found[:, 1], np.sin([theta / 4, theta / 2]), rtol=1e-14, atol=1e-160
            )
            close(found[:, 0], 1, theta**2)

    def test_coincident(self) -> None:
        p = PAIRS[0]
        for t in [0, 0.3, 1, 5]:
            close(slerp(p, p, t), p, 5e-16)
            close(slerp_by_rotation(p, p, t), p, 5e-16)

    @pytest.mark.parametrize("rest", [1e-2, 1e-4, 1e-6, 1e-7])
    def test_nearly_antipodal(self, rest: float) -> None:
        # The two points determine their plane to 1e-16 / rest, the sphere and the ends to 1e-16.
        p, side = PAIRS[0], np.cross(*PAIRS)
        side /= np.linalg.norm(side, axis=-1, keepdims=True)
        q = -np.cos(rest) * p + np.sin(rest) * side
        t = np.linspace(0, 1, 9)[:, None]
        turn = (t * (np.pi - rest))[..., None]
        for form in [slerp, slerp_by_rotation]:
            found = form(p, q, t)
            close(found, np.cos(turn) * p + np.sin(turn) * side, 1e-15 / rest)
            on_the_sphere(found)
            close(found[0], p, 1e-15)
            close(found[-1], q, 1e-15)
        half = (np.pi - rest) / 2
        close(bisect(p, q), np.cos(half) * p + np.sin(half) * side, 1e-15 / rest)
        in_a_plane_that_is_exact = [np.cos(np.pi - rest), np.sin(rest), 0]
        close(
            slerp(E1, in_a_plane_that_is_exact, 0.5), [np.sin(rest / 2), np.cos(rest / 2), 0], 1e-15
        )

    @pytest.mark.parametrize(
        "form", [slerp, slerp_by_rotation, nlerp, bisect, bisect_by_rotation, arc_axis]
    )
    @pytest.mark.parametrize("rest", [0, 1e-16, 1e-12, 1e-9])
    def test_antipodal(self, form: Any, rest: float) -> None:
        t = [0.5] if form in (slerp, slerp_by_rotation, nlerp) else []
        q = [-np.cos(rest), np.sin(rest), 0]
        with pytest.raises(DegenerateError, match=r"^p and q are antipodal: no unique arc joins"):
            form(E1, q, *t)
        with pytest.raises(DegenerateError, match=r"^p and q at index \(1,\) are antipodal"):
            form(E1, [E2, q, q], *t)
        if rest == 0:
            for p in PAIRS[0]:
                with pytest.raises(DegenerateError):
                    form(p, -p, *t)
                with pytest.raises(DegenerateError):
                    form(p, -3 * p, *t)

    def test_axis_of_coincident_points(self) -> None:
        for p in PAIRS[0]:
            with pytest.raises(DegenerateError, match=r"^p and q coincide: any axis would do$"):
                arc_axis(p, 3 * p)
        with pytest.raises(DegenerateError, match=r"^p and q coincide: .* at index \(1,\)$"):
            arc_axis([E1, E2], E2)

    def test_points_coincide_up_to_rounding(self) -> None:
        eps = np.finfo(float).eps
        with pytest.raises(DegenerateError, match=r"^p and q coincide"):
            arc_axis(E1, [1, 4 * eps, 0])
        close(arc_axis(E1, [1, 4.5 * eps, 0]), E3, 0)

    def test_beyond_the_ends_the_circle_goes_on(self) -> None:
        close(where(slerp(great_circle(10), great_circle(50), [-1, 2, 4])), [-30, 90, 170], 1e-12)

    def test_half_the_way_from_the_identity_by_300_degrees_is_the_short_way(self) -> None:
        q = Quaternion.from_axis_angle(E3, [0, np.radians(300)]).components
        longer = slerp(q[0], q[1], 0.5)
        _, angle = Quaternion(longer[0], longer[1:]).axis_angle()
        close(np.degrees(angle), 150, 1e-12)
        shorter = slerp(q[0], -q[1], 0.5)
        axis, angle = Quaternion(shorter[0], shorter[1:]).axis_angle()
        close(axis * np.degrees(angle), [0, 0, -30], 1e-12)
        m = slerp_rotations(np.eye(3), rotation_matrix(E3, np.radians(300)), 0.5)
        close(m, rotation_matrix(E3, np.radians(-30)))

    def test_the_sign_of_a_quaternion_decides_which_way_round(self) -> None:
        p, q = random_units(2, 500, 4)
        negative = np.sum(p * q, axis=-1) < 0
        assert 100 < negative.sum() < 400
        step = Quaternion(q[:, 0], q[:, 1:]) * Quaternion(p[:, 0], p[:, 1:]).conjugate()
        _, angle = step.axis_angle()
        close(angle, 2 * angle_between(p, q))
        assert np.array_equal(angle > np.pi, negative)
        shorter = np.where(negative[:, None], -q, q)
        trace = np.trace(step.matrix(), axis1=-2, axis2=-1)
        close(np.cos(2 * angle_between(p, shorter)), (trace - 1) / 2)
        assert np.all(2 * angle_between(p, shorter) <= np.pi)


class TestNlerp:
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_on_the_arc_and_at_its_ends_and_middle(self, d: int) -> None:
        p, q = random_units(2, 500, d)
        on_the_sphere(nlerp(p, q, RNG.uniform(0, 1, 500)))
        for t, expected in [(0, p), (1, q), (0.5, slerp(p, q, 0.5))]:
            close(nlerp(p, q, t), expected, 1e-12)

    def test_where_it_is_on_the_arc(self) -> None:
        # Seen from the centre, the point t of the chord has this angle to the midpoint of the arc.
        p, q = PAIRS
        for t in [-1, 0.1, 0.25, 0.8, 3]:
            theta = angle_between(p, q)
            part = 0.5 + np.arctan((2 * t - 1) * np.tan(theta / 2)) / theta
            close(nlerp(p, q, t), slerp(p, q, part), 1e-12)

    def test_hurries_in_the_middle(self) -> None:
        t = np.linspace(0, 1, 101)
        steps = angle_between(*(nlerp(E1, E2, part) for part in (t[:-1], t[1:])))
        assert steps.argmax() in (49, 50)
        close(steps.max() / steps.min(), 2, 0.05)

    def test_coincident(self) -> None:
        for t in [0, 0.3, 1, 5]:
            close(nlerp(PAIRS[0], PAIRS[0], t), PAIRS[0], 5e-16)


class TestSlerpHasAMatrix:
    """Erratum E7: for quaternions, a 4x4 rotation matrix; for any vectors, a plane rotation."""

    def test_left_multiplication(self) -> None:
        for p, q in random_units(100, 2, 4):
            turn = Quaternion(q[0], q[1:]) * Quaternion(p[0], p[1:]).conjugate()
            axis, angle = turn.axis_angle()
            part = Quaternion.from_axis_angle(axis, 0.3 * angle)
            left = np.column_stack([(part * Quaternion(w, v)).components for w, *v in np.eye(4)])
            close(left.T @ left, np.eye(4))
            close(left @ p, slerp(p, q, 0.3), 1e-13)


class TestProofs(TwoPoints):
    """The same code, run on symbols."""

    @pytest.mark.equation("5-2")
    def test_slerp_is_5_2(self) -> None:
        assert vanishes(self.back(slerp(self.p, self.q, symbolic(self.t))) - self.of_5_2(self.t))
        assert not vanishes(self.back(slerp(self.p, self.q, symbolic(self.t))) - self.of_5_2(0))

    @pytest.mark.equation("5-3")
    def test_slerp_by_rotation_is_5_2(self) -> None:
        rotated = slerp_by_rotation(self.p, self.q, symbolic(self.t))
        assert vanishes(self.back(rotated) - self.of_5_2(self.t))
