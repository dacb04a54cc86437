"""Double, Bisect and the control points, (5-4) to (5-15): against sympy and their own laws."""

from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from spheres import (
    AFTER,
    BEFORE,
    CURVES,
    E1,
    E2,
    E3,
    FRACTIONS,
    HERE,
    PAIRS,
    UNEVEN,
    Array,
    TwoPoints,
    close,
    great_circle,
    on_the_sphere,
    random_units,
    refuses,
    where,
)
from symbolic import vanishes

from rotedu.arcs import angle_between, arc_axis, slerp
from rotedu.closed_curve import closed_curve
from rotedu.control_points import (
    bisect,
    bisect_by_rotation,
    control_points,
    double,
    double_by_rotation,
)
from rotedu.ordinary_rotation import rotate, rotation_matrix
from rotedu.quaternions import Quaternion

# The warnings about unstable curves have tests of their own.
pytestmark = pytest.mark.filterwarnings("ignore:.* are almost .*:UserWarning")


class TestDouble:
    @pytest.mark.equation("5-4")
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_reflects(self, d: int) -> None:
        p, q = random_units(2, 500, d)
        reflected = double(p, q)
        on_the_sphere(reflected, 3e-15)
        close(angle_between(q, reflected), angle_between(p, q))
        close(double(reflected, q), p)
        close(reflected, slerp(p, q, 2), 1e-13)

    def test_both_forms_agree_and_always_have_an_answer(self) -> None:
        p = PAIRS[0]
        for form in [double, double_by_rotation]:
            close([form(p, p), form(p, -p)], [p, p], 1e-15)
        close(double_by_rotation(*PAIRS), double(*PAIRS), 3e-15)
        for rest in [1e-15, 1e-12, 1e-8]:
            q = [-np.cos(rest), np.sin(rest), 0]
            close(double_by_rotation(E1, q), double(E1, q), 1e-15)


class TestBisect:
    @pytest.mark.parametrize("d", [2, 3, 4, 7])
    def test_halves(self, d: int) -> None:
        p, q = random_units(2, 500, d)
        middle = bisect(p, q)
        on_the_sphere(middle)
        close(middle, bisect(q, p), 1e-15)
        # The rounding of the points matters more if they are nearly antipodal.
        rounding = 1e-14 / np.minimum(1, np.pi - angle_between(p, q))
        assert (angle_between(middle, slerp(p, q, 0.5)) < rounding).all()

    def test_both_forms_agree(self) -> None:
        close(bisect_by_rotation(*PAIRS), bisect(*PAIRS), 1e-13)
        for form in (bisect, bisect_by_rotation):
            close(form(PAIRS[0], PAIRS[0]), PAIRS[0], 3e-16)


class TestSteps:
    """The steps from three points to a_i and b_i, with data that reveal a lost bar."""

    before, here, after = BEFORE, HERE, AFTER
    reflected = double(before, here)
    middle = bisect(reflected, after)
    a = bisect(here, middle)
    b = double(a, here)

    @pytest.mark.equation("5-5", "5-6", "5-8", "5-11", "5-12", "5-13", "5-14", "5-15")
    def test_each_is_a_rotation_about_the_arc_s_axis(self) -> None:
        for form, p, q, part, expected in [
            (double_by_rotation, self.before, self.here, 2, self.reflected),
            (bisect_by_rotation, self.reflected, self.after, 1 / 2, self.middle),
            (bisect_by_rotation, self.middle, self.here, 1 / 2, self.a),
            (double_by_rotation, self.a, self.here, 2, self.b),
        ]:
            close(form(p, q), expected)
            close(rotate(p, arc_axis(p, q), part * angle_between(p, q)), expected)

    @pytest.mark.equation("5-9")
    def test_5_9_as_printed_turns_away_from_the_next_point(self) -> None:
        gap = angle_between(self.reflected, self.after)
        missed = rotate(self.reflected, arc_axis(self.after, self.reflected), gap / 2)
        close(angle_between(missed, self.middle), gap)

    def test_5_13_as_printed_goes_back_to_the_middle(self) -> None:
        close(2 * np.cos(angle_between(self.a, self.here)) * self.a - self.here, self.middle)

    @pytest.mark.equation("5-7", "5-10")
    def test_bars_that_are_lost_would_be_noticed(self) -> None:
        def literal(p: Array, q: Array, bar: tuple[Array, Array]) -> Array:
            return np.sin(angle_between(p, q) / 2) / np.sin(angle_between(*bar)) * (p + q)

        first = literal(self.reflected, self.after, (self.before, self.here))
        second = literal(self.middle, self.here, (self.here, self.after))
        close([np.linalg.norm(first), np.linalg.norm(second)], [1.1547, 0.9354], 1e-4)

    def test_control_points_do_the_same(self) -> None:
        a, b = control_points([self.before, self.here, self.after])
        close([a[1], b[1]], [self.a, self.b])
        a, b = control_points(np.eye(3))
        close([a[1], b[1]], [[-0.5, 0.5**0.5, 0.5], [0.5, 0.5**0.5, -0.5]])


class TestControlPoints:
    @pytest.mark.parametrize(("points", "fraction"), CURVES)
    def test_as_written_and_backwards(self, points: Array, fraction: float) -> None:
        a, b = control_points(points, fraction)
        for i, (before, here) in enumerate(pairwise([points[-1], *points])):
            middle = bisect(double(before, here), points[(i + 1) % len(points)])
            close(a[i], slerp(here, middle, fraction))
            close(b[i], double(a[i], here))
        on_the_sphere(a, 1e-15)
        on_the_sphere(b, 3e-15)
        backwards = control_points(points[::-1], fraction)
        close(np.flip(backwards, axis=(0, 1)), [a, b], 1e-13)

    @pytest.mark.parametrize("n", [3, 4, 5, 8, 100])
    def test_equally_spaced_on_a_great_circle(self, n: int) -> None:
        at = 360 / n * np.arange(n)
        for fraction in FRACTIONS:
            a, b = control_points(great_circle(at), fraction)
            close(a, great_circle(at + fraction * 360 / n))
            close(b, great_circle(at - fraction * 360 / n))

    @pytest.mark.parametrize(
        ("before", "after", "onward"),
        [(g, h, (g + h) / 4) for g, h in [(20, 50), (90, 90), (179, 1), (120, 179), (179, 179)]]
        # Gaps that differ by more than 180 degrees lead to the other side.
        + [(150, -40, -62.5), (130, -40, 22.5)],
    )
    def test_on_a_great_circle_the_gaps_are_averaged(
        self, before: float, after: float, onward: float
    ) -> None:
        a, b = control_points(great_circle(np.array([-before, 0, after])))
        close([where(a)[1], where(b)[1]], [onward, -onward], 1e-11)

    def test_repeated_points(self) -> None:
        a, b = control_points([E1, E1, E2, E3])
        # For neighbours P, P, Q, Double gives P, and Bisect gives the point halfway to Q.
        close(a[1], slerp(E1, E2, 0.25))
        close(a[0], slerp(E1, double(E3, E1), 0.25))
        close(control_points([E1, E1, E1])[0], [E1] * 3)
        on_the_sphere(b)

    @pytest.mark.parametrize("gap", [1e-9, 1, 60, 89.9])
    def test_out_and_back_below_90_degrees_stops(self, gap: float) -> None:
        points = great_circle(np.array([0, gap, 0, -gap]))
        a, b = control_points(points)
        close([a[1], b[1]], [points[1], points[1]], 1e-12)

    @pytest.mark.parametrize("gap", [90, 90 + 1e-6, 120, 179])
    def test_out_and_back_from_90_degrees_on(self, gap: float) -> None:
        out, turn = great_circle(np.array([0, gap]))
        points = [out, turn, out, bisect(out, rotation_matrix([1, 2, 3], 0.8)[2])]
        pair = "points[1] and Bisect(Double(points[0], points[1]), points[2])"
        if gap == 90:
            pair = "Double(points[0], points[1]) and points[2]"
        for f in [control_points, closed_curve]:
            refuses(f"{pair} are antipodal: no unique arc joins them", f, points)

    def test_next_point_opposite_to_the_reflected_one(self) -> None:
        points = [BEFORE, HERE, -double(BEFORE, HERE), E3]
        for names, given in [
            ("Double(points[0], points[1]) and points[2]", points),
            ("Double(points[1, 0], points[1, 1]) and points[1, 2]", [UNEVEN[:4], points]),
            ("Double(points[3], points[0]) and points[1]", np.roll(points, -1, axis=0)),
        ]:
            refuses(f"{names} are antipodal", control_points, given)

    def test_antipodal_neighbours_need_no_arc_between_them(self) -> None:
        a, _ = control_points([E1, -E1, E2])
        close(a[1], bisect(-E1, bisect(E1, E2)))
        on_the_sphere(closed_curve([E1, -E1, E2], 50))


class TestProofs(TwoPoints):
    """The same code, run on symbols."""

    def test_double_is_twice_and_bisect_half_the_arc(self) -> None:
        for form in (double, double_by_rotation):
            assert vanishes(self.back(form(self.p, self.q)) - self.of_5_2(2))
        for form in (bisect, bisect_by_rotation):
            assert vanishes(self.back(form(self.p, self.q)) - self.of_5_2(sp.Rational(1, 2)))

    def test_double_of_quaternions_is_q_conjugate_p_q(self) -> None:
        p, q = (Quaternion(w, v) for w, *v in (sp.symbols("w x y z"), sp.symbols("a b c d")))
        difference = (q * p.conjugate() * q).components - double(p.components, q.components)
        law = sum(x * x for x in q.components) - 1
        assert all(sp.reduced(sp.expand(x), [law])[1] == 0 for x in difference)
