"""De Casteljau's construction and the closed curve, against `splines` and their own laws."""

import warnings
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from spheres import (
    CURVES,
    E1,
    E2,
    E3,
    FRACTIONS,
    HERE,
    RNG,
    UNEVEN,
    UNITS,
    Array,
    bezier,
    close,
    great_circle,
    on_the_sphere,
    random_units,
    refuses,
    segments,
    with_inner_control_points,
)
from splines.quaternion import DeCasteljau, UnitQuaternion

from rotedu.arcs import angle_between, slerp
from rotedu.closed_curve import closed_curve, de_casteljau, de_casteljau_levels
from rotedu.control_points import control_points
from rotedu.errors import DegenerateError

# The warnings about unstable curves have tests of their own.
pytestmark = pytest.mark.filterwarnings("ignore:.* are almost .*:UserWarning")


class TestDeCasteljau:
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_levels_are_arcs_of_the_level_before(self, d: int) -> None:
        control = random_units(5, d)
        levels = de_casteljau_levels(control, 0.3)
        assert [level.shape for level in levels] == [(m, d) for m in (5, 4, 3, 2, 1)]
        close(levels[0], control, 1e-15)
        for level, following in pairwise(levels):
            close(following, slerp(level[:-1], level[1:], 0.3))
        close(de_casteljau(control, 0.3), levels[-1][0], 0)

    def test_degrees_0_and_1(self) -> None:
        close(de_casteljau([HERE], [0.1, 0.9]), [HERE, HERE], 1e-15)
        close(de_casteljau([E1, HERE], 0.3), slerp(E1, HERE, 0.3), 0)

    def test_arcs_between_points_of_arcs_are_no_longer(self) -> None:
        p, q, r = random_units(3, 20000, 3)
        u = RNG.uniform(0, 1, 20000)
        inner = angle_between(slerp(p, q, u), slerp(q, r, u))
        bound = (1 - u) * angle_between(p, q) + u * angle_between(q, r)
        assert (inner <= bound + 1e-14).all()

    def test_antipodal_points(self) -> None:
        message = "control[1] and control[2] are antipodal"
        refuses(message, de_casteljau, [E1, E2, -E2, E3], 0.5)
        message = "control[0] and control[1] at index (2,) are antipodal"
        refuses(message, de_casteljau, [[E1, E2], [E1, E2], [E1, -E1]], 0.5)
        # Beyond the ends this happens to later levels, too.
        message = "points of level 1[0] and points of level 1[1] are antipodal"
        refuses(message, de_casteljau, great_circle(np.array([0, 90, 90])), -1)


class TestClosedCurve:
    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_is_de_casteljau_on_each_segment(self, points: Array, fraction: float) -> None:
        curve = closed_curve(points, 10, fraction)
        on_the_sphere(curve)
        close(curve[::10], points, 1e-15)
        u = np.arange(10) / 10
        by_hand = [de_casteljau(c, u) for c in segments(points, fraction)]
        close(curve, np.concatenate(by_hand), 1e-13)

    @pytest.mark.parametrize("fraction", FRACTIONS)
    def test_is_that_of_splines(self, fraction: float) -> None:
        points = random_units(6, 4)
        control = [
            [UnitQuaternion.from_unit_xyzw(np.roll(q, -1)) for q in part]
            for part in segments(points, fraction)
        ]
        curve = DeCasteljau(control).evaluate(np.arange(60) / 10)
        close(closed_curve(points, 10, fraction), [[q.scalar, *q.vector] for q in curve], 1e-12)

    @pytest.mark.parametrize(
        ("size", "dtype", "rounding"),
        [(size, np.float64, 1e-14) for size in (1e-100, 1e-16, 1e-12, 1e-9, 1e-8)]
        + [(size, np.float32, 4e-6) for size in (1e-15, 1e-7, 1e-4)],
    )
    @pytest.mark.parametrize("fraction", FRACTIONS)
    def test_curve_of_nearly_coincident_points_is_the_one_in_the_plane(
        self, size: float, dtype: Any, rounding: float, fraction: float
    ) -> None:
        flat, u = np.random.default_rng(7).normal(size=(7, 2)), np.arange(10) / 10
        points = np.insert(size * flat, 2, 1, axis=1).astype(dtype)
        curve = closed_curve(points, 10, fraction).reshape(7, 10, 3)
        close(curve[..., :2] / size, bezier(flat, fraction, u).swapaxes(0, 1), rounding)

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_is_c1_at_the_points(self, points: Array, fraction: float) -> None:
        h = 1e-3

        def derivative(control: Array, u: float) -> Array:
            # Beyond its ends a segment goes on smoothly.
            steps = h * np.array([-2, -1, 1, 2])
            return np.array([1, -8, 8, -1]) / (12 * h) @ de_casteljau(control, u + steps)

        a, _ = control_points(points, fraction)
        parts = segments(points, fraction)
        for here, handle, left, right in zip(points, a, np.roll(parts, 1, 0), parts, strict=True):
            along = handle - (handle @ here) * here
            speed = 3 * angle_between(here, handle) / (np.linalg.norm(along) or 1)
            close(derivative(left, 1), speed * along, 1e-7)
            close(derivative(right, 0), speed * along, 1e-7)

    @given(st.lists(UNITS, min_size=3, max_size=6))
    def test_random_points(self, points: list[Array]) -> None:
        try:
            curve = closed_curve(points, 10)
        except DegenerateError:
            assume(False)
        on_the_sphere(curve, 3e-15)
        close(curve[::10], points, 3e-15)

    def test_blocks_make_no_difference(self, monkeypatch: pytest.MonkeyPatch) -> None:
        points = random_units(50, 3)
        close(closed_curve(points, 1), points, 1e-15)
        whole = closed_curve(points, 10)
        for block in [1, 70, 130, 10**6]:
            monkeypatch.setattr("rotedu.closed_curve.BLOCK", block)
            close(closed_curve(points, np.int64(10)), whole, 1e-15)


class TestInnerControlPoints:
    PAIR = "control points a and b between points[0] and points[1] are "

    def test_can_be_antipodal(self) -> None:
        points = with_inner_control_points(0)
        a, b = control_points(points)
        close([a[0], b[1]], [E1, -E1])
        refuses(f"{self.PAIR}antipodal: no unique arc joins them", closed_curve, points)
        message = "control points a and b between points[3] and points[0] are antipodal"
        refuses(message, closed_curve, np.roll(points, -1, axis=0))

    @pytest.mark.parametrize("rest", [1e-6, 1e-3, np.radians(0.99)])
    def test_are_warned_of_where_nearly_antipodal(self, rest: float) -> None:
        points = with_inner_control_points(rest)
        with pytest.warns(UserWarning, match="almost antipodal: a small change") as caught:
            curve = closed_curve(points)
        assert str(caught[0].message).startswith(self.PAIR)
        assert caught[0].filename == __file__
        close(curve[::100], points, 1e-15)
        u = np.arange(100) / 100
        by_hand = np.concatenate([de_casteljau(c, u) for c in segments(points, 1 / 2)])
        # `de_casteljau` rounds the control points once more.
        close(curve, by_hand, 4e-15 / rest)
        # Beyond the limit the curve changes sides.
        with pytest.warns(UserWarning, match="almost"):
            other = closed_curve(with_inner_control_points(-rest))
        assert angle_between(curve[50], other[50]) > 2

    def test_others_are_not(self) -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            closed_curve(with_inner_control_points(np.radians(1.01)))
            closed_curve(UNEVEN)
