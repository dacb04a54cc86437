"""The counts of the paper, found by running the code."""

import math
from typing import Any

import numpy as np
import pytest

from rotedu.cost import OperationCount, count
from rotedu.ordinary_rotation import rotate, rotation_matrix, transform

AXIS, ANGLE, POINT = np.array([2.0, 3.0, 6.0]) / 7, 0.7, np.array([1.0, -2.0, 3.0])
MATRIX = rotation_matrix(AXIS, ANGLE)


def matrix_and_points(points: Any, axis: Any, angle: Any) -> Any:
    return transform(rotation_matrix(axis, angle), points)


@pytest.mark.parametrize(
    ("function", "args", "expected"),
    [
        (rotation_matrix, (AXIS, ANGLE), OperationCount(24, 10, trigonometric=2)),
        (transform, (MATRIX, POINT), OperationCount(9, 6)),
        (matrix_and_points, ([POINT] * 100, AXIS, ANGLE), OperationCount(924, 610, 0, 0, 2)),
        # The second line of (3-1).
        (rotate, (POINT, AXIS, ANGLE), OperationCount(19, 12, trigonometric=2)),
        # Each point of a stack pays for its matrix.
        (transform, ([MATRIX] * 5, [POINT] * 5), 5 * OperationCount(9, 6)),
    ],
)
def test_counts_of_the_paper_and_of_the_audit(
    function: Any, args: Any, expected: OperationCount
) -> None:
    assert count(function, *args) == expected


def test_the_fourth_line_of_2_6_takes_19_and_7() -> None:
    """As printed: each term has a factor of its own; the two of the scalar part cancel."""

    def fourth_line(c: Any, s: Any, r: Any) -> Any:
        u, v, w = r
        first, second, third, fourth, fifth = c * c, c * s, s * s, c * s, s * s
        return (
            -s * c * u,
            c * s * u,
            first * u + third * u,
            first * v + second * -w - fourth * w - fifth * v,
            first * w + second * v - fourth * -v - fifth * w,
        )

    c, s = np.cos(ANGLE / 2), np.sin(ANGLE / 2)
    one, other, *turned = fourth_line(c, s, POINT)
    assert one + other == 0
    np.testing.assert_allclose(turned, rotate(POINT, [1, 0, 0], ANGLE), rtol=1e-14)
    assert count(fourth_line, c, s, POINT) == OperationCount(19, 7)


OPERATIONS: list[tuple[str, list[Any]]] = [
    (
        "multiplications",
        [lambda x: 2 * x, lambda x: x * np.float64(2), lambda x: np.float64(2) * x],
    ),
    ("additions", [lambda x: x - 1, lambda x: 1 - x, lambda x: x + x, lambda x: 1 + x]),
    ("divisions", [lambda x: 1 / x, lambda x: x / 2]),
    ("square_roots", [np.sqrt]),
    ("trigonometric", [np.sin, np.cos, np.tan, np.arcsin, np.arccos, np.arctan]),
    ("trigonometric", [lambda x: np.arctan2(x, 2)]),
]
FREE = (
    lambda x: [-x, +x, abs(x), x < 1, x <= x, x > 0, x >= 0, x == 1],
    lambda x: 3 * 4 + math.cos(1),
    lambda x: x**1,
)


class TestWhatIsCounted:
    @pytest.mark.parametrize(("kind", "functions"), OPERATIONS)
    def test_one_operation(self, kind: str, functions: Any) -> None:
        for function in functions:
            assert count(function, 0.25) == OperationCount(**{kind: 1})

    def test_powers_are_products_and_what_is_free_is_not_counted(self) -> None:
        assert count(lambda x: x**3, 0.25) == OperationCount(multiplications=2)
        for function in FREE:
            assert count(function, 0.25) == OperationCount(0, 0, 0, 0, 0)

    @pytest.mark.parametrize("values", [[1.0, 2, 3], (1, 2, 3), np.array([1, 2, 3], np.float32)])
    def test_reductions_start_from_their_first_term(self, values: Any) -> None:
        assert count(np.sum, values) == OperationCount(additions=2)
        assert count(np.vdot, values, values) == OperationCount(3, 2)
        assert count(np.matmul, np.eye(3), values) == OperationCount(9, 6)
        assert count(np.cross, values, values) == OperationCount(6, 3)

    @pytest.mark.parametrize("other", [None, "text", True, len])
    def test_other_arguments_are_passed_on(self, other: object) -> None:
        seen: list[object] = []
        assert count(lambda x, y: seen.append(y), 1.0, other) == OperationCount()
        assert seen == [other]

    @pytest.mark.parametrize(
        "function",
        [
            math.cos,
            float,
            np.exp,
            lambda x: x**0.5,
            lambda x: x**0,
            lambda x: x * [1, 2],
            lambda x: [1, 2] * x,
        ],
    )
    def test_nothing_escapes_the_count(self, function: Any) -> None:
        with pytest.raises(TypeError):
            count(function, 0.5)


class TestComputedWhileCounted:
    def test_powers_are_those_of_the_floats(self) -> None:
        found: list[Any] = []
        count(lambda x: found.extend(x**n for n in (1, 2, 3, 4)), 3.0)
        assert [power.value for power in found] == [3, 9, 27, 81]

    def test_branches_are_taken_by_value(self) -> None:
        for value, divisions in [(4.0, 1), (2.0, 0), (0.0, 0)]:
            counted = count(lambda x: 1 / x if x and x != 2 else 0, value)
            assert counted == OperationCount(divisions=divisions)


class TestIndependence:
    def test_nested_counts_each_see_their_own(self) -> None:
        inner = []

        def outer(x: Any) -> Any:
            inner.append(count(lambda y: y * y + 1, x))
            return x * x

        # The inner function works on the outer one's numbers, so the outer tally has everything.
        assert count(outer, 3.0) == OperationCount(2, 1)
        assert inner == [OperationCount(1, 1)]

    def test_a_number_of_an_outer_count_is_charged_to_the_outer_count_too(self) -> None:
        inner = []
        total = count(lambda x: inner.append(count(lambda y: y * x, 2.0)), 3.0)
        assert inner == [OperationCount(1)]
        assert total == OperationCount(1)

    def test_arguments_are_not_changed(self) -> None:
        points = POINT.copy()
        count(lambda p: p.__setitem__(0, p[1] * 2), points)
        np.testing.assert_array_equal(points, POINT)


def test_sums_and_multiples_of_counts() -> None:
    small, large = OperationCount(1, 2, 3, 4, 5), OperationCount(10, 20, 30, 40, 50)
    assert small + large == OperationCount(11, 22, 33, 44, 55)
    assert 3 * small == small * 3 == OperationCount(3, 6, 9, 12, 15)


def test_counting_scalars_show_their_value() -> None:
    shown: list[str] = []
    count(lambda x: shown.append(repr(x + 1)), 1.5)
    assert shown == [f"CountingScalar({np.float64(2.5)!r})"]
