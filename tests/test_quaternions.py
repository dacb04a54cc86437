"""Section 2: (2-1) to (2-6), against sympy, scipy and their own laws."""

import copy
import operator
import pickle
from dataclasses import FrozenInstanceError
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.spatial.transform import Rotation
from spheres import AXES, E1, POINTS, close
from symbolic import matrix, symbolic, vanishes

from rotedu.cost import OperationCount, count
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion, rotate_about_u

ANGLES = [0, 1e-300, 1e-12, 1e-8, 1e-4, 0.5, np.pi / 2, 3, np.pi - 1e-8, np.pi]
ONE, I, J, K = (Quaternion(w, v) for w, *v in np.eye(4))  # noqa: E741


def quaternion(components: Any) -> Quaternion:
    return Quaternion(components[..., 0], components[..., 1:])


class TestAlgebra:
    @pytest.mark.equation("2-1")
    def test_parts(self) -> None:
        q = Quaternion(1, [2, 4, 10])
        assert q.w == 1
        close(q.v, [2, 4, 10], 0)
        close(q.components, [1, 2, 4, 10], 0)
        close(q.conjugate(), [1, -2, -4, -10], 0)
        close(q.norm(), 11, 0)

    @pytest.mark.equation("2-2")
    def test_sums_are_componentwise(self) -> None:
        p, q = Quaternion(1, [2, 3, 4]), Quaternion(10, [30, 20, 50])
        close(p + q, [11, 32, 23, 54], 0)
        close(p - q, [-9, -28, -17, -46], 0)
        close(-p, [-1, -2, -3, -4], 0)

    def test_real_numbers_are_quaternions_without_vector(self) -> None:
        q, two = Quaternion(1, [2, 3, 4]), Quaternion(2, [0, 0, 0])
        for operation in [operator.add, operator.sub, operator.mul, operator.truediv]:
            for number in [2, np.float64(2), np.int8(2), np.array(2), np.array([2, 2])]:
                for found, expected in [
                    (operation(q, number), operation(q, two)),
                    (operation(number, q), operation(two, q)),
                ]:
                    close(found, np.broadcast_to(expected.components, (*np.shape(number), 4)), 0)

    @pytest.mark.equation("2-5")
    def test_division_is_from_the_right(self) -> None:
        assert (I * J) / J == I
        assert (I * J) / I == -J
        close(2 / Quaternion(0, [0, 4, 0]), [0, 0, -0.5, 0], 0)
        w = np.arange(1.0, 100)
        close(Quaternion(w, np.outer(w, [1, 2, 3])) / w, [[1, 1, 2, 3]] * 99, 5e-16)

    @pytest.mark.parametrize("size", [5e-324, 1e-200, 1e-160, 1, 1e160, 1e200])
    def test_extreme_sizes(self, size: float) -> None:
        q = Quaternion(size, [size, size, size])
        assert q.norm() == 2 * size
        if size > 1e-300:
            close(q.inverse() * q, ONE)
        close(q.rotate([1, 0, 0]), [0, 1, 0])
        close(q.matrix(), [[0, 0, 1], [1, 0, 0], [0, 1, 0]])
        close(q.axis_angle()[1], 2 * np.pi / 3)


class TestRotation:
    @pytest.mark.parametrize("angle", [*ANGLES, -1.0, 7.0])
    def test_any_axis_against_scipy(self, angle: float) -> None:
        q = Quaternion.from_axis_angle(3 * AXES, angle)
        oracle = Rotation.from_rotvec(angle * AXES)
        for factor in [1, -1, -1e5]:
            close((factor * q).rotate(POINTS), oracle.apply(POINTS), 2e-14)
            close((factor * q).matrix(), oracle.as_matrix())

    @pytest.mark.parametrize("angle", [a for a in ANGLES if a] + [4.0, 2 * np.pi - 1e-8])
    def test_axis_and_angle_come_back(self, angle: float) -> None:
        q = Quaternion.from_axis_angle(AXES, angle)
        axis, found = q.axis_angle()
        np.testing.assert_allclose(found, angle, rtol=3e-15)
        close(axis, AXES, 1e-15 if angle < 6 else 1e-7)
        axis, found = (-q).axis_angle()
        close(found, 2 * np.pi - angle)
        close(axis, -AXES, 1e-15 if angle < 6 else 1e-7)

    def test_no_rotation_has_the_documented_axis(self) -> None:
        axis, angle = Quaternion([1, -1, 1e-5, -7, 1], [[0, 0, 0]] * 4 + [[0, 1, 0]]).axis_angle()
        close(axis, [[1, 0, 0]] * 4 + [[0, 1, 0]], 0)
        close(angle, [0, 2 * np.pi, 0, 2 * np.pi, np.pi / 2], 0)

    @pytest.mark.parametrize("angle", ANGLES)
    def test_from_matrix(self, angle: float) -> None:
        matrices = rotation_matrix(AXES, angle)
        q = Quaternion.from_matrix(matrices)
        close(q.matrix(), matrices, 3e-15)
        close(q.norm(), 1, 1e-15)
        assert (q.w >= 0).all()
        close(np.abs((q * Quaternion.from_axis_angle(AXES, angle).conjugate()).w), 1, 1e-15)


class TestArray:
    def test_shapes_broadcast(self) -> None:
        q = Quaternion([[1], [2]], np.ones((5, 3)))
        axis, angle = q.axis_angle()
        assert q.w.shape == q.norm().shape == angle.shape == (np.arange(5) * q).w.shape == (2, 5)
        assert q.v.shape == axis.shape == (2, 5, 3)
        assert (q * Quaternion(np.ones((3, 1, 1)), E1)).components.shape == (3, 2, 5, 4)
        assert Quaternion(0, np.ones((0, 3))).norm().shape == (0,)
        q = Quaternion.from_axis_angle(AXES[:4], 1.0)
        every = quaternion(q.components[:, None]).rotate(POINTS[:7])
        close(every, np.einsum("kij,nj->kni", q.matrix(), POINTS[:7]))

    def test_comparison_is_quaternion_by_quaternion(self) -> None:
        q = Quaternion([1, 2, 1], [[0, 0, 0], [0, 0, 0], [0, 1, 0]])
        assert (q == 1).tolist() == [True, False, False]
        assert (q != 1).tolist() == [False, True, True]
        assert (q == q).all()
        assert q != "text"
        assert (I == None) is False  # noqa: E711
        assert (I != None) is True  # noqa: E711

    def test_immutable(self) -> None:
        w, v = np.ones(2), np.ones((2, 3))
        q = Quaternion(w, v)
        w[:], v[:] = 7, 7
        for result in [q.rotate([1, 2, 3]), q.matrix(), *q.axis_angle()]:
            result[...] = 0
        assert (q == Quaternion(1, [1, 1, 1])).all()
        with pytest.raises(FrozenInstanceError):
            q.components = v  # type: ignore[misc]
        for part in [q.w, q.v, q.components, (q * q).components, (q + 1).v, q.inverse().w]:
            with pytest.raises(ValueError, match="read-only"):
                part[...] = 0
        with pytest.raises((AttributeError, TypeError)):
            q.name = "q"  # type: ignore[attr-defined]
        with pytest.raises(TypeError, match="unhashable"):
            hash(q)

    def test_copies_and_repr(self) -> None:
        assert repr(Quaternion(1, [0, -2.5, 3])) == "Quaternion(1., [ 0. , -2.5,  3. ])"
        two = Quaternion([1, 2], np.ones((2, 3)))
        assert repr(two).splitlines() == [
            "Quaternion([1., 2.],",
            "           [[1., 1., 1.],",
            "            [1., 1., 1.]])",
        ]
        twins = copy.copy(two), copy.deepcopy(two), pickle.loads(pickle.dumps(two)), eval(repr(two))
        assert all((twin == two).all() for twin in twins)

    def test_single_precision(self) -> None:
        q = Quaternion(np.float32(1), np.ones(3, np.float32))
        numbers = q, q * q, 2 * q + 1.5, 1 / q / 2, q * 0 + 1
        found = *(x.components for x in numbers), q.norm(), q.matrix(), *q.axis_angle()
        assert {np.asarray(x).dtype for x in found} == {np.dtype(np.float32)}
        found = (q * np.float64(2)).components, (q * ONE).components, q.rotate(AXES)
        assert {x.dtype for x in found} == {np.dtype(np.float64)}


@pytest.mark.parametrize(
    ("function", "expected"),
    [
        (lambda q: quaternion(q) * quaternion(q), OperationCount(16, 12)),
        (lambda q: quaternion(q) + quaternion(q), OperationCount(0, 4)),
        (lambda q: quaternion(q).rotate(q[1:]), OperationCount(18, 12)),
        (lambda q: quaternion(q).matrix(), OperationCount(9, 15)),
        (lambda q: quaternion(q).inverse(), OperationCount(4, 3, divisions=8, square_roots=1)),
        (lambda q: rotate_about_u(q[1:], q[0]), OperationCount(4, 2, trigonometric=2)),
    ],
)
def test_counts_of_the_audit(function: Any, expected: OperationCount) -> None:
    assert count(function, np.array([0.5, 0.5, 0.5, 0.5])) == expected


class TestRefusals:
    q, pair = Quaternion(1, [2, 3, 4]), Quaternion([1, 2], E1)
    zero, one_zero = Quaternion(0, [0, 0, 0]), Quaternion([1, 0], [[0, 0, 0], [0, 0, 0]])

    @pytest.mark.parametrize("name", ["add", "sub", "mul", "truediv"])
    @pytest.mark.parametrize("other", ["text", None, [1, 2], {}])
    def test_operands_that_are_not_numbers(self, name: str, other: Any) -> None:
        for operands in (self.q, other), (other, self.q):
            with pytest.raises(TypeError):
                getattr(operator, name)(*operands)

    def test_numpy_does_not_take_them_apart(self) -> None:
        with pytest.raises(TypeError):
            np.add(np.ones(3), self.q)

    @pytest.mark.parametrize(
        ("refused", "message"),
        [
            (lambda q, pair: q * np.nan, "scalar must be finite in float64; got nan$"),
            (
                lambda q, pair: Quaternion([1, 2], np.ones((3, 3))),
                "w and v must broadcast over their leading axes",
            ),
            (
                lambda q, pair: pair * Quaternion([1, 2, 3], E1),
                r"left and right must broadcast .* \(2, 4\) and \(3",
            ),
            (lambda q, pair: pair.rotate(np.ones((3, 3))), "quaternion and points must broadcast"),
        ],
    )
    def test_bad_arguments(self, refused: Any, message: str) -> None:
        with pytest.raises(ValueError, match=f"^{message}"):
            refused(self.q, self.pair)

    def test_zero(self) -> None:
        zero, one_zero = self.zero, self.one_zero
        for call in [zero.inverse, lambda: ONE / zero, lambda: ONE / 0, lambda: 1 / zero]:
            with pytest.raises(DegenerateError, match=r"^the zero quaternion has no inverse$"):
                call()
        for call in [one_zero.inverse, lambda: ONE / one_zero, lambda: ONE / np.array([1, 0])]:
            with pytest.raises(DegenerateError, match=r"no inverse; found at index \(1,\)$"):
                call()
        for call in [zero.matrix, zero.axis_angle, lambda: zero.rotate([1, 2, 3])]:
            with pytest.raises(ValueError, match=r"^quaternion must not be the zero vector"):
                call()


class TestProofs:
    """The same code, run on symbols."""

    (w1, x1, y1, z1), (w2, x2, y2, z2) = sp.symbols("w1 x1 y1 z1"), sp.symbols("w2 x2 y2 z2")
    r = sp.symbols("r_u r_v r_w")
    p, q = Quaternion(w1, [x1, y1, z1]), Quaternion(w2, [x2, y2, z2])

    def same(self, left: Quaternion, right: Quaternion, law: Any = 0) -> bool:
        """Whether two expressions are equal if the law is zero."""
        differences = [sp.expand(x) for x in left.components - right.components]
        return all((sp.reduced(x, [law])[1] if law else x) == 0 for x in differences)

    @pytest.mark.equation("2-3")
    def test_product_is_the_one_of_2_3(self) -> None:
        v1, v2 = sp.Matrix([self.x1, self.y1, self.z1]), sp.Matrix([self.x2, self.y2, self.z2])
        scalar = self.w1 * self.w2 - v1.dot(v2)
        vector = self.w1 * v2 + self.w2 * v1 + v1.cross(v2)
        assert self.same(self.p * self.q, Quaternion(scalar, list(vector)))

    def test_products_are_associative_do_not_commute_and_multiply_norms(self) -> None:
        p, q, r = self.p, self.q, Quaternion(sp.Symbol("w3"), sp.symbols("x3 y3 z3"))
        assert self.same((p * q) * r, p * (q * r))
        assert self.same(p * q - q * p, Quaternion(0, 2 * np.cross(p.v, q.v)))
        of_p, of_q, of_both = ((x * x.conjugate()).w.item() for x in (p, q, p * q))
        assert sp.expand(of_p - sum(x * x for x in p.components)) == 0
        assert sp.expand(of_both - of_p * of_q) == 0

    @pytest.mark.equation("2-4")
    def test_inverse_on_both_sides_and_division_on_the_right(self) -> None:
        p, q = (
            Quaternion(symbolic(w), symbolic(*v))
            for w, *v in (self.p.components, self.q.components)
        )

        def simplified(q: Quaternion) -> list[Any]:
            return list(matrix(q.components).applyfunc(sp.simplify))

        assert simplified(q * q.inverse()) == simplified(q.inverse() * q) == [1, 0, 0, 0]
        assert simplified((p * q) / q - p) == [0, 0, 0, 0]

    def test_rotate_is_q_r_conjugate(self) -> None:
        unit = sum(x * x for x in self.q.components) - 1
        product = self.q * Quaternion(0, self.r) * self.q.conjugate()
        assert self.same(product, Quaternion(0, self.q.rotate(self.r)), unit)

    def test_matrix_does_the_same(self) -> None:
        rotated = sp.Matrix(self.q.matrix()) * sp.Matrix(self.r)
        assert (rotated - sp.Matrix(self.q.rotate(self.r))).expand() == sp.zeros(3, 1)

    @pytest.mark.equation("2-6")
    def test_last_line_of_2_6(self) -> None:
        theta = symbolic(sp.Symbol("theta", real=True))
        r = symbolic(*self.r)
        q = Quaternion.from_axis_angle([1, 0, 0], theta)
        product = q * Quaternion(0 * theta, r) * q.conjugate()
        assert vanishes(matrix(product.w))
        assert vanishes(matrix(product.v) - matrix(rotate_about_u(r, theta)))
        assert not vanishes(matrix(product.v) - matrix(r))

    @pytest.mark.equation("2-6")
    def test_the_other_lines_of_2_6(self) -> None:
        half = sp.Symbol("theta", real=True) / 2
        c, s = sp.cos(half), sp.sin(half)
        ru, rv, rw = self.r
        r, u, a = map(np.array, (self.r, [1, 0, 0], [0, -rw, rv]))
        first, last = Quaternion(c, s * u), Quaternion(c, -s * u)
        lines = [
            first * Quaternion(0, r) * last,
            Quaternion(-s * ru, c * r + s * np.cross(u, r)) * last,
            Quaternion(-s * ru, c * r + s * a) * last,
            Quaternion(
                -s * c * ru + c * s * ru,
                c**2 * r
                + c * s * a
                + s**2 * ru * u
                - c * s * np.cross(r, u)
                - s**2 * np.cross(a, u),
            ),
            Quaternion(0, c**2 * r + 2 * c * s * a + s**2 * np.array([ru, -rv, -rw])),
        ]
        for line in lines[1:]:
            assert vanishes(matrix((line - lines[0]).components))
        assert not vanishes(matrix((lines[0] - Quaternion(0, r)).components))
