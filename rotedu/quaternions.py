"""Section 2: quaternions and the rotations they represent.

The notation follows the equations: a quaternion q = [w, v] has a scalar part w and a vector part
v. The quaternions form a space of four dimensions, and those of norm 1 form its unit sphere S^3.
The paper calls the space S^3 and the sphere S^2, one dimension too few in each case (erratum E1).

Where a quaternion stands for a rotation, one whose norm is not 1 is normalised first, and zero is
refused.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from typing import Any, ClassVar, TypeVar, cast

import numpy as np
import numpy.typing as npt

from rotedu import ordinary_rotation
from rotedu._arguments import (
    MATRIX,
    NUMBER,
    UNIT,
    VECTOR,
    VECTOR3,
    Number,
    Unit3,
    Vector,
    Vector3,
    checked,
    kept,
    place,
    prepared,
)
from rotedu._vectors import Array, axis_and_length, cross, dot, safe_length
from rotedu.errors import DegenerateError

__all__ = ["Quaternion", "rotate_about_u"]

Result = TypeVar("Result")


def of_quaternions(
    operation: Callable[[Quaternion, Quaternion], Result],
) -> Callable[[Quaternion, Any], Result]:
    """Let an operation accept a real number w as the quaternion [w, 0], as the paper does."""

    @wraps(operation)
    def widened(self: Quaternion, other: Any) -> Result:
        if isinstance(other, Quaternion):
            given = {"left": (self.components, VECTOR), "right": (other.components, VECTOR)}
            left, right = prepared(given).values()
        elif hasattr(other, "__truediv__"):
            given = {"quaternion": (self.components, VECTOR), "scalar": (other, NUMBER)}
            left, w = prepared(given).values()
            right = np.stack(np.broadcast_arrays(w, 0, 0, 0), dtype=left.dtype)
        else:
            return cast(Result, NotImplemented)
        return operation(_of(left), _of(right))

    return widened


@dataclass(frozen=True, slots=True)
class Quaternion:
    """Quaternion q = [w, v], or an array of quaternions (2-1).

    Parameters
    ----------
    w : array_like, shape (...)
        Scalar parts.
    v : array_like, shape (..., 3)
        Vector parts. Their leading axes broadcast against `w`.

    Attributes
    ----------
    w : ndarray, shape (...)
        Scalar parts, read-only like the other attributes.
    v : ndarray, shape (..., 3)
        Vector parts.
    components : ndarray, shape (..., 4)
        All components, scalar first: ``[w, x, y, z]``.

    Notes
    -----
    ``+``, ``-``, ``*`` and ``/`` follow (2-2), (2-3) and (2-5). Either operand may be a real
    number, which stands for the quaternion [w, 0]. Arrays broadcast over the leading axes.
    ``p == q`` compares quaternion by quaternion and has shape (...). ``p / q`` divides from the
    right and raises `rotedu.errors.DegenerateError` if q is zero.

    Examples
    --------
    The products of the units do not commute, and the product of all three is -1:

    >>> i, j, k = (Quaternion(0, unit) for unit in np.eye(3))
    >>> print(i * j == k, j * i == -k, i * j * k == -1)
    True True True

    Division undoes multiplication from the right, not from the left:

    >>> print((i * j) / j == i, (i * j) / i == j)
    True False
    """

    components: Array
    __array_ufunc__: ClassVar[None] = None

    def __init__(self, w: npt.ArrayLike, v: npt.ArrayLike) -> None:
        scalar, vector = prepared({"w": (w, NUMBER), "v": (v, VECTOR3)}).values()
        object.__setattr__(self, "components", joined(scalar, vector).components)

    @classmethod
    @checked
    def from_axis_angle(cls, axis: Unit3, angle: Number) -> Any:
        """Make the unit quaternion [cos(angle / 2), sin(angle / 2) axis] of a rotation.

        Parameters
        ----------
        axis : array_like, shape (..., 3)
            Direction of the axis; any length but zero.
        angle : array_like, shape (...)
            Angle in radians. One more full turn changes the sign of the quaternion.

        Returns
        -------
        Quaternion, shape (...)

        References
        ----------
        Cheng et al. (2023), Section 2.2 (for the U axis)

        Examples
        --------
        A full turn brings every point back, but it takes the quaternion from 1 to -1. Only the
        second full turn brings the quaternion back:

        >>> Quaternion.from_axis_angle([0, 0, 1], [0, 2 * np.pi, 4 * np.pi]).w
        array([ 1., -1.,  1.])
        """
        return joined(np.cos(angle / 2), np.sin(angle / 2) * axis)

    @classmethod
    def from_matrix(cls, matrix: npt.ArrayLike) -> Quaternion:
        """Make the unit quaternion of a rotation matrix, choosing the sign for which w >= 0.

        Parameters
        ----------
        matrix : array_like, shape (..., 3, 3)
            Rotation matrices.

        Returns
        -------
        Quaternion, shape (...)
            At a half turn, where w is 0 to within rounding, the first nonzero component of v is
            positive.

        Examples
        --------
        >>> q = Quaternion.from_matrix([[0, 0, 1], [1, 0, 0], [0, 1, 0]])
        >>> print(q.components.round(12))
        [0.5 0.5 0.5 0.5]
        """
        return cls.from_axis_angle(*ordinary_rotation.axis_angle(matrix))

    @property
    def w(self) -> Array:
        """Scalar parts, shape (...)."""
        return np.asarray(self.components[..., 0])

    @property
    def v(self) -> Array:
        """Vector parts, shape (..., 3)."""
        return np.asarray(self.components[..., 1:])

    @of_quaternions
    def __add__(self, other: Quaternion) -> Quaternion:
        """Add component by component (2-2)."""
        (w1, v1), (w2, v2) = parts(self, other)
        return joined(w1 + w2, v1 + v2)

    @of_quaternions
    def __sub__(self, other: Quaternion) -> Quaternion:
        """Subtract component by component (2-2)."""
        (w1, v1), (w2, v2) = parts(self, other)
        return joined(w1 - w2, v1 - v2)

    @of_quaternions
    def __mul__(self, other: Quaternion) -> Quaternion:
        """Multiply by Hamilton's rule (2-3)."""
        (w1, v1), (w2, v2) = parts(self, other)
        return joined(w1 * w2 - dot(v1, v2), w1 * v2 + w2 * v1 + cross(v1, v2))

    @of_quaternions
    def __truediv__(self, other: Quaternion) -> Quaternion:
        """Divide from the right, q1 q2^-1 (2-5)."""
        return self * other.inverse()

    def __neg__(self) -> Quaternion:
        ((w, v),) = parts(self)
        return joined(-w, -v)

    # Only real numbers get here as left operands, and they commute with every quaternion.
    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, other: object) -> Quaternion:
        return -self + other

    def __rtruediv__(self, other: object) -> Quaternion:
        return self.inverse() * other

    @of_quaternions
    def __eq__(self, other: Quaternion) -> Any:
        """Tell for each quaternion whether all four components are equal."""
        return (self.components == other.components).astype(bool).all(axis=-1)

    @of_quaternions
    def __ne__(self, other: Quaternion) -> Any:
        """Tell for each quaternion whether any component differs."""
        return ~(self == other)

    def __repr__(self) -> str:
        w = np.array2string(self.w, separator=", ", prefix="Quaternion(")
        indent = "Quaternion(" if self.w.ndim else f"Quaternion({w}, "
        v = np.array2string(self.v, separator=", ", prefix=indent)
        return f"Quaternion({w}," + (f"\n{' ' * 11}" if self.w.ndim else " ") + f"{v})"

    def conjugate(self) -> Quaternion:
        """Return the conjugate q* = [w, -v].

        Returns
        -------
        Quaternion, shape (...)

        Examples
        --------
        >>> Quaternion(1, [2, 3, 4]).conjugate()
        Quaternion(1., [-2., -3., -4.])
        """
        ((w, v),) = parts(self)
        return joined(w, -v)

    def norm(self) -> Array:
        """Return the norm abs(q), the square root of q q*.

        Returns
        -------
        ndarray, shape (...)

        Examples
        --------
        >>> print(Quaternion(1, [1, 1, 1]).norm())
        2.0
        """
        return np.asarray(safe_length(np.moveaxis(self.components, -1, 0)))

    def inverse(self) -> Quaternion:
        """Return the inverse q* / abs(q)^2 (2-4).

        Returns
        -------
        Quaternion, shape (...)

        Raises
        ------
        rotedu.errors.DegenerateError
            If a quaternion is zero.

        Examples
        --------
        >>> Quaternion(0, [0, 2, 0]).inverse()
        Quaternion(0., [-0. , -0.5, -0. ])
        """
        norm = self.norm()
        refuse_zero(norm)
        ((w, v),) = parts(self.conjugate())
        # Divide twice, because the square of the norm could overflow or underflow.
        return joined(w / norm / norm, v / norm / norm)

    def axis_angle(self) -> tuple[Array, Array]:
        """Return the axis and angle of the rotation, the inverse of `from_axis_angle`.

        Returns
        -------
        axis : ndarray, shape (..., 3)
            Unit vectors. Where v = 0, any axis would do, and the axis is (1, 0, 0).
        angle : ndarray, shape (...)
            Angles in radians, from 0 to 2 pi. The sign of q matters: if q turns about n by an
            angle, then -q turns about -n by the rest of a full turn. Both are the same rotation.

        Notes
        -----
        The angle is ``2 * arctan2(abs(v), w)``, because ``2 * arccos(w)`` would lose half of the
        digits of a small angle.

        Examples
        --------
        >>> q = Quaternion.from_axis_angle([0, 0, 1], np.pi / 2)
        >>> for axis, angle in [q.axis_angle(), (-q).axis_angle()]:
        ...     print(axis, np.degrees(angle).round(12))
        [0. 0. 1.] 90.0
        [-0. -0. -1.] 270.0
        """
        w, x, y, z = unit_components(self)
        axis, sine = axis_and_length(np.stack([x, y, z]))
        return np.moveaxis(axis, 0, -1), np.asarray(2 * np.arctan2(sine, w), self.components.dtype)

    def rotate(self, points: npt.ArrayLike) -> Array:
        """Rotate points about any axis by q [0, r] q* (2-6).

        Parameters
        ----------
        points : array_like, shape (..., 3)
            Points or vectors to rotate. Their leading axes broadcast against those of the
            quaternions. To turn n points by each of k quaternions, give the quaternions the
            shape (k, 1). For many points and one rotation, `matrix` is cheaper.

        Returns
        -------
        ndarray, shape (..., 3)

        Notes
        -----
        For a unit quaternion the product is [0, r + 2 w v x r + 2 v x (v x r)].

        Examples
        --------
        >>> q = Quaternion.from_axis_angle([0, 0, 1], np.pi / 2)
        >>> q.rotate([1, 0, 0]).round(15)
        array([0., 1., 0.])
        >>> (-q).rotate([1, 0, 0]).round(15)
        array([0., 1., 0.])
        """
        given = {"quaternion": (self.components, UNIT), "points": (points, VECTOR3)}
        q, r = prepared(given).values()
        w, v = q[0], q[1:]
        twice = 2 * cross(v, r)
        return np.moveaxis(r + w * twice + cross(v, twice), 0, -1)

    def matrix(self) -> Array:
        """Return the matrix of the rotation, the same as (3-3), for q as for -q.

        Returns
        -------
        ndarray, shape (..., 3, 3)

        Examples
        --------
        >>> Quaternion(1, [1, 1, 1]).matrix()
        array([[0., 0., 1.],
               [1., 0., 0.],
               [0., 1., 0.]])
        """
        w, x, y, z = unit_components(self)
        x2, y2, z2 = x + x, y + y, z + z
        xx, yy, zz, xy, xz, yz = x * x2, y * y2, z * z2, x * y2, x * z2, y * z2
        wx, wy, wz = w * x2, w * y2, w * z2
        rows = [
            [1 - (yy + zz), xy - wz, xz + wy],
            [xy + wz, 1 - (xx + zz), yz - wx],
            [xz - wy, yz + wx, 1 - (xx + yy)],
        ]
        # In NumPy 1 a single float32 times a Python number is a float64.
        return np.asarray(MATRIX.outside(rows), self.components.dtype)


@checked
def rotate_about_u(points: Vector3, angle: Number) -> Vector:
    """Rotate points about the U axis by the last line of (2-6).

    Parameters
    ----------
    points : array_like, shape (..., 3)
        Points or vectors to rotate.
    angle : array_like, shape (...)
        Angle in radians, anticlockwise as seen from the tip of the U axis.

    Returns
    -------
    ndarray, shape (..., 3)

    References
    ----------
    Cheng et al. (2023), Eq. (2-6), its last line with the commas and the angle of the line before

    Examples
    --------
    >>> rotate_about_u([5, 0, 1], np.pi / 2).round(15)
    array([ 5., -1.,  0.])
    """
    ru, rv, rw = points
    cos, sin = np.cos(angle), np.sin(angle)
    return stacked(ru, cos * rv - sin * rw, cos * rw + sin * rv)


def parts(*quaternions: Quaternion) -> list[tuple[Array, Array]]:
    """Return scalar and vector parts, components first, with enough axes to broadcast."""
    axes = max(q.w.ndim for q in quaternions)
    components = [VECTOR.inside(q.components, axes) for q in quaternions]
    return [(q[0], q[1:]) for q in components]


def stacked(*components: Array) -> Array:
    """Stack components, as many for one as for another."""
    return np.stack(np.broadcast_arrays(*components))


def joined(w: Array, v: Array) -> Quaternion:
    """Make a quaternion from its parts, components first."""
    return _of(kept(stacked(w, *v)))


def refuse_zero(norm: Array) -> None:
    """Refuse a norm of zero, because nothing can be divided by it."""
    if np.any(norm == 0):
        zero = place(norm == 0)
        found = f"; found{zero}" if zero else ""
        raise DegenerateError(f"the zero quaternion has no inverse{found}")


def unit_components(q: Quaternion) -> Array:
    """Return the components of the normalised quaternion, on the first axis."""
    return prepared({"quaternion": (q.components, UNIT)})["quaternion"]


def _of(components: Array) -> Quaternion:
    """Wrap the result of a computation, components first."""
    q = object.__new__(Quaternion)
    last = np.moveaxis(np.asarray(components), 0, -1)
    last.flags.writeable = False
    object.__setattr__(q, "components", last)
    return q
