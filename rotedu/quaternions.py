"""Section 2: quaternions, and the rotations they make.

The notation is that of the equations: a quaternion q = [w, v] is a scalar w and a vector v. All of
them make a space of four dimensions; those of norm 1 are the unit sphere S^3 in it. (The paper
writes S^3 for the space and S^2 for the sphere, one dimension too few each: erratum E1.)
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
    NUMBER,
    UNIT,
    VECTOR,
    VECTOR3,
    Number,
    Unit3,
    Vector,
    Vector3,
    checked,
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
    """Let an operation take a real number w for the quaternion [w, 0], as the paper does."""

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
    """Quaternions q = [w, v], one or an array of them (2-1).

    Parameters
    ----------
    w : array_like, shape (...)
        Scalar parts.
    v : array_like, shape (..., 3)
        Vector parts; the leading axes broadcast against those of `w`.

    Attributes
    ----------
    w : ndarray, shape (...)
    v : ndarray, shape (..., 3)
    components : ndarray, shape (..., 4)
        Scalar first: ``[w, x, y, z]``. All three are read-only.

    Raises
    ------
    ValueError
        If an argument is not finite or has the wrong shape.

    Notes
    -----
    ``+ - * /`` follow (2-2), (2-3) and (2-5), between quaternions and with real numbers, a number
    w being the quaternion [w, 0]; arrays broadcast over the leading axes. ``p == q`` compares
    quaternion by quaternion and has shape (...). ``p / q`` is division from the right.

    References
    ----------
    Cheng et al. (2023), Eqs. (2-1) to (2-6)

    Examples
    --------
    The products of the units do not commute, and all three together are -1:

    >>> i, j, k = (Quaternion(0, unit) for unit in np.eye(3))
    >>> i * j == k, j * i == -k, i * j * k == -1
    (np.True_, np.True_, np.True_)

    Division undoes multiplication from the right, not from the left:

    >>> (i * j) / j == i, (i * j) / i == j
    (np.True_, np.False_)
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
            Direction of the axis, of any length but zero.
        angle : array_like, shape (...)
            Angle in radians. A full turn more changes the sign of the quaternion.

        Returns
        -------
        Quaternion, shape (...)

        Raises
        ------
        ValueError
            If an argument is not finite or has the wrong shape, or if an axis is zero.

        References
        ----------
        Cheng et al. (2023), Section 2.2, for the U axis

        Examples
        --------
        Two turns make one quaternion round trip; one turn is rotation enough, yet gives -1:

        >>> Quaternion.from_axis_angle([0, 0, 1], [0, 2 * np.pi, 4 * np.pi]).w
        array([ 1., -1.,  1.])
        """
        return joined(np.cos(angle / 2), np.sin(angle / 2) * axis)

    @classmethod
    def from_matrix(cls, matrix: npt.ArrayLike) -> Quaternion:
        """Make the unit quaternion of a rotation matrix: of the two, the one with w >= 0.

        Parameters
        ----------
        matrix : array_like, shape (..., 3, 3)
            Rotation matrices.

        Returns
        -------
        Quaternion, shape (...)
            At a half turn, where w = 0, the first component of v other than zero is positive.

        Raises
        ------
        ValueError
            If the matrix is not finite, has the wrong shape, or is not a rotation.

        See Also
        --------
        rotedu.ordinary_rotation.axis_angle : does the work.
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
        """Sum, component by component (2-2)."""
        (w1, v1), (w2, v2) = parts(self, other)
        return joined(w1 + w2, v1 + v2)

    @of_quaternions
    def __sub__(self, other: Quaternion) -> Quaternion:
        """Difference, component by component (2-2)."""
        (w1, v1), (w2, v2) = parts(self, other)
        return joined(w1 - w2, v1 - v2)

    @of_quaternions
    def __mul__(self, other: Quaternion) -> Quaternion:
        """Hamilton's product (2-3)."""
        (w1, v1), (w2, v2) = parts(self, other)
        return joined(w1 * w2 - dot(v1, v2), w1 * v2 + w2 * v1 + cross(v1, v2))

    @of_quaternions
    def __truediv__(self, other: Quaternion) -> Quaternion:
        """Division from the right, q1 q2^-1 (2-5)."""
        return self * other.inverse()

    def __neg__(self) -> Quaternion:
        ((w, v),) = parts(self)
        return joined(-w, -v)

    # The only left operand that comes here is a real number, which commutes with everything.
    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, other: object) -> Quaternion:
        return -self + other

    def __rtruediv__(self, other: object) -> Quaternion:
        return self.inverse() * other

    @of_quaternions
    def __eq__(self, other: Quaternion) -> Any:
        """Whether all four components are equal, quaternion by quaternion."""
        return (self.components == other.components).astype(bool).all(axis=-1)

    @of_quaternions
    def __ne__(self, other: Quaternion) -> Any:
        """Whether any component differs, quaternion by quaternion."""
        return ~(self == other)

    def __repr__(self) -> str:
        w = np.array2string(self.w, separator=", ", prefix="Quaternion(")
        indent = "Quaternion(" if self.w.ndim else f"Quaternion({w}, "
        v = np.array2string(self.v, separator=", ", prefix=indent)
        return f"Quaternion({w}," + (f"\n{' ' * 11}" if self.w.ndim else " ") + f"{v})"

    def conjugate(self) -> Quaternion:
        """Conjugate q* = [w, -v].

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
        """Norm abs(q), the root of q q*.

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
        """Inverse q* / abs(q)^2 (2-4).

        Returns
        -------
        Quaternion, shape (...)

        Raises
        ------
        rotedu.errors.DegenerateError
            If a quaternion is zero.

        References
        ----------
        Cheng et al. (2023), Eq. (2-4)

        Examples
        --------
        >>> Quaternion(0, [0, 2, 0]).inverse()
        Quaternion(0., [-0. , -0.5, -0. ])
        """
        norm = self.norm()
        refuse_zero(norm)
        ((w, v),) = parts(self.conjugate())
        # Divided twice: the square of the norm could overflow or underflow.
        return joined(w / norm / norm, v / norm / norm)

    def axis_angle(self) -> tuple[Array, Array]:
        """Axis and angle of the rotation: the inverse of `from_axis_angle`.

        Returns
        -------
        axis : ndarray, shape (..., 3)
            Unit vectors; (1, 0, 0) where q is 1 or -1 times a positive number, since any axis
            would do.
        angle : ndarray, shape (...)
            Angles in radians, from 0 to 2 pi. The sign matters: q turns about
            n by an angle, -q about -n by the rest of a full turn, and both come to the same.

        Raises
        ------
        ValueError
            If a quaternion is zero.

        Notes
        -----
        The angle is ``2 * arctan2(abs(v), w)``; ``2 * arccos(w)`` would lose half of the digits
        of a small angle. Quaternions that are not unit are normalised.

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
        return np.moveaxis(axis, 0, -1), np.asarray(2 * np.arctan2(sine, w))

    def rotate(self, points: npt.ArrayLike) -> Array:
        """Rotate points: the vector part of q [0, r] q*, for any axis (2-6).

        Parameters
        ----------
        points : array_like, shape (..., 3)
            The points, or vectors, to rotate. Their leading axes broadcast against those of the
            quaternions: to turn n points by each of k quaternions, give these shape (k, 1).

        Returns
        -------
        ndarray, shape (..., 3)

        Raises
        ------
        ValueError
            If `points` is not finite or has the wrong shape, or if a quaternion is zero.

        See Also
        --------
        matrix : cheaper for many points and one rotation.
        rotate_about_u : what the paper derives.

        Notes
        -----
        Quaternions that are not unit are normalised, which is to say that q [0, r] q^-1 is
        computed. Multiplied out it is r + 2 w v x r + 2 v x (v x r).

        References
        ----------
        Cheng et al. (2023), Eq. (2-6)

        Examples
        --------
        >>> q = Quaternion.from_axis_angle([0, 0, 1], np.pi / 2)
        >>> q.rotate([1, 0, 0]).round(15)
        array([0., 1., 0.])
        >>> (-q).rotate([1, 0, 0]).round(15)
        array([0., 1., 0.])
        """
        (w, v), r = unit_parts_and(self, points)
        twice = 2 * cross(v, r)
        return np.moveaxis(r + w * twice + cross(v, twice), 0, -1)

    def matrix(self) -> Array:
        """Matrix of the rotation, the same as (3-3).

        Returns
        -------
        ndarray, shape (..., 3, 3)

        Raises
        ------
        ValueError
            If a quaternion is zero.

        See Also
        --------
        from_matrix : the way back.

        Notes
        -----
        Quaternions that are not unit are normalised; q and -q have the same matrix.

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
        matrix = np.array(
            [
                [1 - (yy + zz), xy - wz, xz + wy],
                [xy + wz, 1 - (xx + zz), yz - wx],
                [xz - wy, yz + wx, 1 - (xx + yy)],
            ]
        )
        return np.moveaxis(matrix, (0, 1), (-2, -1))


@checked
def rotate_about_u(points: Vector3, angle: Number) -> Vector:
    """Rotate points about the U axis: what q [0, r] q* comes to (2-6), last line.

    Parameters
    ----------
    points : array_like, shape (..., 3)
        The points, or vectors, to rotate.
    angle : array_like, shape (...)
        Angle in radians, counterclockwise seen from the tip of the U axis.

    Returns
    -------
    ndarray, shape (..., 3)

    Raises
    ------
    ValueError
        If an argument is not finite or has the wrong shape.

    Notes
    -----
    The last line lacks a comma and has the angle about V in one place; it is computed here as the
    line before it demands, with one angle and three components.

    References
    ----------
    Cheng et al. (2023), Eq. (2-6)

    Examples
    --------
    >>> rotate_about_u([5, 0, 1], np.pi / 2).round(15)
    array([ 5., -1.,  0.])
    """
    ru, rv, rw = points
    cos, sin = np.cos(angle), np.sin(angle)
    rotated = np.broadcast_arrays(ru, cos * rv - sin * rw, cos * rw + sin * rv)
    return np.stack(rotated)


def parts(*quaternions: Quaternion) -> list[tuple[Array, Array]]:
    """Scalar and vector parts, components first, with enough axes to broadcast."""
    axes = max(q.w.ndim for q in quaternions)
    components = [VECTOR.inside(q.components, axes) for q in quaternions]
    return [(q[0], q[1:]) for q in components]


def joined(w: Array, v: Array) -> Quaternion:
    """Make a quaternion of its parts, components first."""
    return _of(np.stack(np.broadcast_arrays(w, *v)))


def refuse_zero(norm: Array) -> None:
    """Refuse a norm of zero, by which nothing can be divided."""
    if np.any(norm == 0):
        zero = place(norm == 0)
        found = f"; found{zero}" if zero else ""
        raise DegenerateError(f"the zero quaternion has no inverse{found}")


def unit_components(q: Quaternion) -> Array:
    """Components of the quaternion of norm 1, components first."""
    return prepared({"quaternion": (q.components, UNIT)})["quaternion"]


def unit_parts_and(q: Quaternion, points: npt.ArrayLike) -> tuple[tuple[Array, Array], Array]:
    """Parts of the quaternion of norm 1, and points, with enough axes to broadcast."""
    given = {"quaternion": (q.components, UNIT), "points": (points, VECTOR3)}
    unit, r = prepared(given).values()
    return (unit[0], unit[1:]), r


def _of(components: Array) -> Quaternion:
    """Wrap the result of a computation, components first."""
    q = object.__new__(Quaternion)
    last = np.moveaxis(np.asarray(components), 0, -1)
    last.flags.writeable = False
    object.__setattr__(q, "components", last)
    return q
