"""Arcs, (5-1) to (5-3): against sympy, scipy and their own laws."""

from typing import Any

import numpy as np
import pytest
from scipy.spatial import geometric_slerp
from scipy.spatial.transform import Rotation
from spheres import E1, E2, E3, HERE, PAIRS, TwoPoints, close, on_the_sphere, random_units, refuses
from symbolic import symbolic, vanishes

from rotedu.arcs import angle_between, arc_axis, nlerp, rotation_between, slerp, slerp_by_rotation
from rotedu.control_points import bisect, bisect_by_rotation
from rotedu.ordinary_rotation import rotate


class TestAngle:
    @pytest.mark.parametrize("rest", [0, 1e-150, 1e-12, 1e-8, 1e-3, 1])
    def test_keeps_its_digits_near_0_and_pi(self, rest: float) -> None:
        found = angle_between(E1, [np.cos(rest), np.sin(rest), 0])
        np.testing.assert_allclose(found, rest, rtol=1e-15)
        close(angle_between(E1, [-np.cos(rest), np.sin(rest), 0]), np.pi - rest, 5e-16)


class TestAxis:
    @pytest.mark.equation("5-1")
    def test_is_perpendicular_and_right_handed(self) -> None:
        p, q = PAIRS
        axis = arc_axis(p, q)
        on_the_sphere(axis)
        close([np.sum(axis * p, axis=-1), np.sum(axis * q, axis=-1)], 0, 1e-13)
        close(np.cross(p, q), np.sin(angle_between(p, q))[:, None] * axis)

    @pytest.mark.parametrize("theta", [1e-12, 1e-8, 1e-3, np.pi - 1e-3, np.pi - 1e-7])
    def test_near_the_ends(self, theta: float) -> None:
        close(arc_axis(E1, [np.cos(theta), np.sin(theta), 0]), E3, 1e-15)
        axis = arc_axis(HERE, [1, 2, 3])
        # The points themselves are rounded to 1e-16.
        close(arc_axis(HERE, rotate(HERE, axis, theta)), axis, 4e-16 / np.sin(theta))

    def test_of_points_that_coincide_up_to_rounding(self) -> None:
        eps = np.finfo(float).eps
        for p in PAIRS[0]:
            refuses("p and q coincide: any axis would do", arc_axis, p, 3 * p)
        refuses("p and q coincide", arc_axis, E1, [1, 4 * eps, 0])
        close(arc_axis(E1, [1, 4.5 * eps, 0]), E3, 0)
        message = "p and q coincide: any axis would do at index (1,)"
        refuses(message, arc_axis, [E1, E2], E2)


class TestArc:
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_against_scipy(self, d: int) -> None:
        t = np.linspace(0, 1, 11)
        for p, q in random_units(50, 2, d):
            found = slerp(p, q, t)
            close(found, geometric_slerp(p, q, t))
            on_the_sphere(found)
            close(found[[0, -1]], [p, q], 1e-15)

    def test_both_forms_agree(self) -> None:
        p, q = PAIRS
        for t in [0, 0.1, 0.5, 0.8, 1, 1.7, -0.6]:
            close(slerp_by_rotation(p, q, t), slerp(p, q, t), 1e-13)

    @pytest.mark.parametrize("form", [slerp, slerp_by_rotation])
    @pytest.mark.parametrize("theta", [1e-300, 1e-12, 1e-8, 1e-4])
    def test_nearly_coincident(self, theta: float, form: Any) -> None:
        found = form(E1, [np.cos(theta), np.sin(theta), 0], [0.25, 0.5])
        sines = np.sin([theta / 4, theta / 2])
        np.testing.assert_allclose(found[:, 1], sines, rtol=1e-14, atol=1e-160)
        close(found[:, 0], 1, theta**2)

    @pytest.mark.parametrize("form", [slerp, slerp_by_rotation, nlerp])
    @pytest.mark.parametrize("t", [0, 0.3, 1, 5])
    def test_coincident(self, t: float, form: Any) -> None:
        close(form(PAIRS[0], PAIRS[0], t), PAIRS[0], 5e-16)

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
            close(found[[0, -1]], [p, q], 1e-15)
        close(bisect(p, q), np.sin(rest / 2) * p + np.cos(rest / 2) * side, 1e-15 / rest)
        in_a_plane_that_is_exact = [-np.cos(rest), np.sin(rest), 0]
        middle = [np.sin(rest / 2), np.cos(rest / 2), 0]
        close(slerp(E1, in_a_plane_that_is_exact, 0.5), middle, 1e-15)

    @pytest.mark.parametrize(
        ("form", "t"),
        [(form, [0.5]) for form in (slerp, slerp_by_rotation, nlerp)]
        + [(form, []) for form in (bisect, bisect_by_rotation, arc_axis)],
    )
    def test_antipodal(self, form: Any, t: list[float]) -> None:
        for rest in [0, 1e-12, 1e-9]:
            q = [-np.cos(rest), np.sin(rest), 0]
            refuses("p and q are antipodal: no unique arc joins them", form, E1, q, *t)
            refuses("p and q at index (1,) are antipodal", form, E1, [E2, q, q], *t)
        for p in PAIRS[0]:
            refuses("p and q are antipodal", form, p, -3 * p, *t)

    def test_nlerp_is_ahead_or_behind_by_the_angle_of_its_chord(self) -> None:
        # Seen from the centre, the point t of the chord has this angle to the midpoint of the arc.
        for d in [2, 3, 4, 7]:
            p, q = random_units(2, 500, d)
            theta = angle_between(p, q)
            for t in [-1, 0, 0.1, 0.25, 0.5, 0.8, 1, 3]:
                part = 0.5 + np.arctan((2 * t - 1) * np.tan(theta / 2)) / theta
                found = nlerp(p, q, t)
                close(found, slerp(p, q, part), 1e-12)
                on_the_sphere(found)


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


class TestFromOneDirectionToAnother:
    def test_is_the_turn_about_the_arc_s_axis(self) -> None:
        a, b = PAIRS
        found = rotation_between(a, b)
        axis, angle = arc_axis(a, b), angle_between(a, b)
        close(found, Rotation.from_rotvec(angle[:, None] * axis).as_matrix(), 1e-13)
        close(np.einsum("nij,nj->ni", found, a), b, 1e-15)
        close(rotation_between(a, b, axis=E1), found, 0)

    @pytest.mark.parametrize("rest", [1e-12, 1e-7, 1e-6, 1e-3, 1])
    def test_stays_a_rotation_near_0_and_pi(self, rest: float) -> None:
        start = random_units(300, 3)
        across = np.cross(start, random_units(300, 3))
        across /= np.linalg.norm(across, axis=1, keepdims=True)
        for sign in (1, -1):
            if sign < 0 and rest < 1e-7:
                continue
            end = sign * np.cos(rest) * start + np.sin(rest) * across
            found = rotation_between(start, end)
            close(found.swapaxes(1, 2) @ found, np.broadcast_to(np.eye(3), found.shape), 3e-15)
            close(np.einsum("nij,nj->ni", found, start), end, 2e-15)

    def test_opposite_directions_need_an_axis(self) -> None:
        close(rotation_between(E1, -E1, axis=[3, 0, 4]), np.diag([-1, -1, 1]))
        almost = [-1, 1e-9, 2e-9]
        found = rotation_between(E1, almost, axis=E3)
        close(found @ E1, almost, 1e-16)
        close(found, np.diag([-1, -1, 1]), 4e-9)
        refuses("a and b are antipodal", rotation_between, E1, -E1)
        refuses("a and b at index (1,) are antipodal", rotation_between, E1, [E2, -E1])
        refuses("axis is along a: it leaves open", rotation_between, E1, -E1, E1)
        refuses("axis at index (1,) is along a", rotation_between, E1, [E2, -E1], E1)
