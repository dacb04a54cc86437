"""De Casteljau's construction and the closed curve, against `splines` and their own laws."""

import math
import warnings
from itertools import pairwise, product
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from spheres import (
    CURVES,
    E1,
    E2,
    E3,
    FRACTIONS,
    HERE,
    LENGTHS_AND_DTYPES,
    RNG,
    UNEQUAL_GAPS,
    UNEVEN,
    Array,
    bezier,
    close,
    great_circle,
    on_the_sphere,
    random_units,
    segments,
    turning,
    where,
)
from splines.quaternion import DeCasteljau, UnitQuaternion

from rotedu.arcs import angle_between, slerp
from rotedu.closed_curve import closed_curve, de_casteljau, de_casteljau_levels
from rotedu.control_points import (
    control_points,
    double,
)
from rotedu.errors import DegenerateError

# The warnings about unstable curves have tests of their own.
pytestmark = pytest.mark.filterwarnings("ignore:.* are almost .*:UserWarning")

coordinates = st.floats(-1, 1, allow_subnormal=False)
units = (
    arrays(float, 3, elements=coordinates)
    .filter(lambda v: bool(np.linalg.norm(v) > 1e-3))
    .map(lambda v: v / np.linalg.norm(v))
)
parts = st.floats(0, 1)


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

    def test_ends(self) -> None:
        control = random_units(200, 4, 3)
        close(de_casteljau(control, 0), control[:, 0], 2e-15)
        close(de_casteljau(control, 1), control[:, -1], 2e-15)

    def test_one_curve_at_many_parameters_and_many_curves_at_one(self) -> None:
        control, u = random_units(6, 4, 3), np.linspace(0, 1, 9)
        points = de_casteljau(control[:, None], u)
        assert points.shape == (6, 9, 3)
        close(points[2, 3], de_casteljau(control[2], u[3]), 1e-15)
        close(points[:, 3], de_casteljau(control, u[3]), 1e-15)
        close(points[2], de_casteljau(control[2], u), 1e-15)
        levels = de_casteljau_levels(control[:, None], u)
        assert [level.shape for level in levels] == [(6, 9, m, 3) for m in (4, 3, 2, 1)]
        assert de_casteljau(control, np.empty((0, 1))).shape == (0, 6, 3)

    def test_equal_control_points(self) -> None:
        close(de_casteljau([HERE] * 4, np.linspace(0, 1, 5)), [HERE] * 5, 1e-15)
        control = great_circle(np.array([0, 45, 45, 90]))
        close(where(de_casteljau(control, 0.5)), 45, 1e-13)

    def test_on_a_great_circle_it_is_the_polynomial(self) -> None:
        at, u = np.array([0.0, 20, 100, 70]), np.linspace(0, 1, 21)
        bernstein = [(1 - u) ** 3, 3 * u * (1 - u) ** 2, 3 * u**2 * (1 - u), u**3]
        close(where(de_casteljau(great_circle(at), u)), at @ bernstein, 1e-12)

    def test_arcs_between_points_of_arcs_are_no_longer(self) -> None:
        p, q, r = random_units(3, 20000, 3)
        u = RNG.uniform(0, 1, 20000)
        inner = angle_between(slerp(p, q, u), slerp(q, r, u))
        bound = (1 - u) * angle_between(p, q) + u * angle_between(q, r)
        assert (inner <= bound + 1e-14).all()

    def test_antipodal_control_points(self) -> None:
        with pytest.raises(DegenerateError, match=r"^control\[1\] and control\[2\] are antipodal"):
            de_casteljau([E1, E2, -E2, E3], 0.5)
        with pytest.raises(DegenerateError, match=r"control\[1\] at index \(2,\) are antipodal"):
            de_casteljau([[E1, E2], [E1, E2], [E1, -E1]], 0.5)

    def test_antipodal_points_of_a_level_beyond_the_ends(self) -> None:
        control = great_circle(np.array([0, 90, 90]))
        match = r"^points of level 1\[0\] and points of level 1\[1\] are antipodal"
        with pytest.raises(DegenerateError, match=match):
            de_casteljau(control, -1)


class TestClosedCurve:
    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_on_the_sphere_through_the_points(self, points: Array, fraction: float) -> None:
        curve = closed_curve(points, 100, fraction)
        assert curve.shape == (100 * len(points), points.shape[1])
        on_the_sphere(curve)
        close(curve[::100], points, 1e-15)

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_is_de_casteljau_on_each_segment(self, points: Array, fraction: float) -> None:
        u = np.arange(10) / 10
        by_hand = np.concatenate([de_casteljau(c, u) for c in segments(points, fraction)])
        close(closed_curve(points, 10, fraction), by_hand, 1e-13)

    def test_arcs_of_any_length(self) -> None:
        # Fraction 0 gives the control points P, P, Q, Q, and the angle follows 3 u^2 - 2 u^3.
        u, rng = np.arange(20) / 20, np.random.default_rng(5)
        for case in product(LENGTHS_AND_DTYPES, [2, 3, 4], range(10)):
            (theta, dtype), d, _ = case
            single = dtype == np.float32
            p, x, *others = np.linalg.qr(rng.normal(size=(d, d)))[0].T
            q = np.cos(theta) * p + np.sin(theta) * x
            between = p + q + (others[0] if others else x / 2)
            points = np.array([p, q, between / np.linalg.norm(between)], dtype)
            found = closed_curve(points, 20, 0)
            assert found.dtype == dtype, case
            on_the_sphere(found, 2e-6 if single else 4e-15, case)
            turn = (theta * (3 * u**2 - 2 * u**3))[:, None]
            # The rounding of the points matters more near pi.
            rounding = (1e-6 if single else 2e-15) / min(1, np.pi - theta)
            close(found[:20], np.cos(turn) * p + np.sin(turn) * x, rounding, case)

    @pytest.mark.parametrize("size", [1e-16, 1e-12, 1e-9, 1e-8, 1e-7, 1e-5, 1e-3, 0.1, 0.5])
    @pytest.mark.parametrize("fraction", FRACTIONS)
    def test_is_de_casteljau_for_near_neighbours(self, size: float, fraction: float) -> None:
        u, rng = np.arange(10) / 10, np.random.default_rng(10)
        for d in (3, 4):
            points = HERE if d == 3 else [0.1, 0.7, -0.1, 0.7]
            points = points + size * random_units(6, d, rng=rng)
            points /= np.linalg.norm(points, axis=-1, keepdims=True)
            by_hand = np.concatenate([de_casteljau(c, u) for c in segments(points, fraction)])
            close(closed_curve(points, 10, fraction), by_hand)
            single = points.astype(np.float32)
            by_hand = np.concatenate(
                [de_casteljau(c.astype(float), u) for c in segments(single, fraction)]
            )
            close(closed_curve(single, 10, np.float32(fraction)), by_hand, 1e-6)

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

    @pytest.mark.parametrize("gaps", UNEQUAL_GAPS)
    @pytest.mark.parametrize("fraction", [0.2, 1 / 2, 1])
    def test_on_a_great_circle(self, gaps: tuple[float, ...], fraction: float) -> None:
        points = great_circle(np.degrees(np.cumsum([0, *gaps[:2]])))
        turn = np.degrees(turning(gaps, fraction, np.arange(20) / 20))
        close(closed_curve(points, 20, fraction), great_circle(turn))

    @pytest.mark.parametrize("rest", [1e-6, 1e-3, 0.016, 0.1, 0.6, 0.643, 0.644, 0.7, 1])
    def test_inner_control_points_of_any_distance(self, rest: float) -> None:
        points, u = self.with_inner_control_points(rest), np.arange(50) / 50
        by_hand = np.concatenate([de_casteljau(c, u) for c in segments(points, 1 / 2)])
        # `de_casteljau` rounds the control points once more.
        close(closed_curve(points, 50), by_hand, 1e-15 / min(1, rest / 4))

    def test_is_the_loop_of_the_paper_corrected(self) -> None:
        curve = []
        for control in segments(UNEVEN, 1 / 2):
            for step in range(20):
                u, row = step / 20, list(control)
                while len(row) > 1:
                    next_row = []
                    for p, q in pairwise(row):
                        theta = math.acos(max(-1, min(1, sum(p * q))))
                        first, second = math.sin((1 - u) * theta), math.sin(u * theta)
                        next_row.append((first * p + second * q) / math.sin(theta))
                    row = next_row
                curve.append(row[0])
        close(closed_curve(UNEVEN, 20), curve)

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_is_c1_at_the_points(self, points: Array, fraction: float) -> None:
        h = 1e-3

        def derivative(control: Array, u: float) -> Array:
            # Beyond its ends a segment goes on smoothly.
            steps = h * np.array([-2, -1, 1, 2])
            return np.array([1, -8, 8, -1]) / (12 * h) @ de_casteljau(control, u + steps)

        a, _ = control_points(points, fraction)
        parts = segments(points, fraction)
        for i, (left, right) in enumerate(zip(parts, [*parts[1:], parts[0]], strict=True), 1):
            here, handle = points[i % len(points)], a[i % len(points)]
            along = handle - (handle @ here) * here
            length = np.linalg.norm(along)
            speed = 3 * angle_between(here, handle) / (length or 1)
            close(derivative(left, 1), speed * along, 1e-7)
            close(derivative(right, 0), speed * along, 1e-7)

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_turned_points_give_the_turned_curve(self, points: Array, fraction: float) -> None:
        d = points.shape[1]
        turn = np.linalg.qr(np.random.default_rng(d).normal(size=(d, d)))[0]
        close(
            closed_curve(points @ turn, 8, fraction),
            closed_curve(points, 8, fraction) @ turn,
            1e-12,
        )

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_reversed_points_give_the_reversed_curve(self, points: Array, fraction: float) -> None:
        there = closed_curve(points, 8, fraction)
        back = closed_curve(np.roll(points[::-1], 1, axis=0), 8, fraction)
        close(np.roll(back[::-1], 1, axis=0), there, 1e-12)

    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_starting_elsewhere_gives_the_same_curve(self, points: Array, fraction: float) -> None:
        later = closed_curve(np.roll(points, -1, axis=0), 8, fraction)
        close(np.roll(later, 8, axis=0), closed_curve(points, 8, fraction), 0)

    @pytest.mark.parametrize("n", [3, 4, 5, 6, 8, 12])
    def test_equally_spaced_on_a_great_circle(self, n: int) -> None:
        at, u, gap = 360 / n * np.arange(n), np.arange(20) / 20, 360 / n
        even = closed_curve(great_circle(at), 20, 1 / 3)
        close(even, great_circle((at[:, None] + u * gap).ravel()))
        # With 1/2 the speed goes from 1.5 gaps a segment to 0.75 and back.
        position = gap * (1.5 * u * (1 - u) ** 2 + 1.5 * u**2 * (1 - u) + u**3)
        close(closed_curve(great_circle(at), 20), great_circle((at[:, None] + position).ravel()))

    @given(st.lists(units, min_size=3, max_size=6))
    def test_random_points(self, points: list[Array]) -> None:
        try:
            curve = closed_curve(points, 10)
        except DegenerateError:
            assume(False)
        on_the_sphere(curve, 3e-15)
        close(curve[::10], points, 3e-15)

    @pytest.mark.parametrize("samples", [1, 2, 7, 10000])
    def test_samples(self, samples: int) -> None:
        curve = closed_curve(UNEVEN, samples)
        assert curve.shape == (5 * samples, 3)
        close(curve[::samples], UNEVEN, 1e-15)
        close(closed_curve(UNEVEN, np.int64(samples)), curve, 0)

    def test_blocks_make_no_difference(self, monkeypatch: pytest.MonkeyPatch) -> None:
        points = random_units(50, 3)
        whole = closed_curve(points, 10)
        for block in [1, 70, 130, 10**6]:
            monkeypatch.setattr("rotedu.closed_curve.BLOCK", block)
            close(closed_curve(points, 10), whole, 1e-15)

    def test_stacks(self) -> None:
        points = random_units(2, 3, 5, 4)
        curves = closed_curve(points, 6)
        assert curves.shape == (2, 3, 30, 4)
        for i in np.ndindex(2, 3):
            close(curves[i], closed_curve(points[i], 6), 1e-15)
        assert closed_curve(np.ones((0, 5, 3)), 6).shape == (0, 30, 3)

    def test_the_points_are_left_alone(self) -> None:
        points = UNEVEN.copy()
        closed_curve(points)[:] = 0
        control_points(points)[0][:] = 0
        slerp(points, points, 0)[:] = 0
        close(points, UNEVEN, 0)

    @staticmethod
    def with_inner_control_points(rest: float) -> Array:
        """Points for which a_0 and b_1 are this short of antipodal: half a turn exchanges them."""
        half_turn = np.array([-1, -1, 1])
        a0 = np.array([np.cos(rest / 2), 0, np.sin(rest / 2)])
        p0 = np.array([0.4, 0.8, 0.2**0.5])
        p1 = half_turn * p0
        p3 = double(double(p1, double(p0, a0)), p0)
        return np.array([p0, p1, half_turn * p3, p3])

    def test_inner_control_points_can_be_antipodal(self) -> None:
        points = self.with_inner_control_points(0)
        a, b = control_points(points)
        close(a[0], E1)
        close(b[1], -E1)
        which = r"control points a and b between points\[0\] and points\[1\]"
        with pytest.raises(
            DegenerateError, match=f"^{which} are antipodal: no unique arc joins them$"
        ):
            closed_curve(points)
        which = r"control points a and b between points\[3\] and points\[0\]"
        with pytest.raises(DegenerateError, match=f"^{which} are antipodal"):
            closed_curve(np.roll(points, -1, axis=0))

    @pytest.mark.parametrize("rest", [1e-6, 1e-3, np.radians(0.99)])
    def test_nearly_antipodal_inner_control_points_are_warned_of(self, rest: float) -> None:
        points = self.with_inner_control_points(rest)
        which = r"control points a and b between points\[0\] and points\[1\]"
        with pytest.warns(
            UserWarning, match=f"^{which} are almost antipodal: a small change"
        ) as caught:
            curve = closed_curve(points)
        assert caught[0].filename == __file__
        on_the_sphere(curve)
        close(curve[::100], points, 1e-15)
        # Beyond the limit the curve changes sides.
        with pytest.warns(UserWarning, match="almost"):
            other = closed_curve(self.with_inner_control_points(-rest))
        assert angle_between(curve[50], other[50]) > 2

    def test_others_are_not(self) -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            closed_curve(self.with_inner_control_points(np.radians(1.01)))
            closed_curve(UNEVEN)


class TestAgainstSplines:
    def test_closed_curve_of_quaternions(self) -> None:
        points = random_units(6, 4)
        for fraction in FRACTIONS:
            control = [
                [UnitQuaternion.from_unit_xyzw(np.roll(q, -1)) for q in part]
                for part in segments(points, fraction)
            ]
            curve = DeCasteljau(control).evaluate(np.arange(60) / 10)
            expected = [[q.scalar, *q.vector] for q in curve]
            close(closed_curve(points, 10, fraction), expected, 1e-12)
