"""Section 2: quaternions, and the rotations they make.

The notation is that of the equations: a quaternion q = [w, v] is a scalar w and a vector v. All of
them make a space of four dimensions; those of norm 1 are the unit sphere S^3 in it. (The paper
writes S^3 for the space and S^2 for the sphere, one dimension too few each: erratum E1.)
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from typing import Any, ClassVar, TypeVar, cast

import numpy as np
import numpy.typing as npt

from rotedu import ordinary_rotation
from rotedu._arguments import Array, arrays, length, normalised, place, unit
from rotedu.errors import DegenerateError

__all__ = ["Quaternion", "rotate_about_u"]

Result = TypeVar("Result")


def _with_scalars(
    operation: Callable[["Quaternion", "Quaternion"], Result],
) -> Callable[["Quaternion", Any], Result]:
    """Let an operation take a real number w for the quaternion [w, 0], as the paper does."""

    @wraps(operation)
    def widened(self: "Quaternion", other: Any) -> Result:
        if isinstance(other, Quaternion):
            left, right = arrays(left=(self.components, (4,)), right=(other.components, (4,)))
        elif hasattr(other, "__truediv__"):
            left, w = arrays(quaternion=(self.components, (4,)), scalar=(other, ()))
            right = _joined(w, np.zeros(3, w.dtype))
        else:
            return cast(Result, NotImplemented)
        return operation(Quaternion._of(left), Quaternion._of(right))

    return widened


@dataclass(frozen=True, slots=True, init=False, eq=False, repr=False)
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
        scalar, vector = arrays(w=(w, ()), v=(v, (3,)))
        object.__setattr__(self, "components", _read_only(_joined(scalar, vector)))

    @classmethod
    def _of(cls, components: Array) -> "Quaternion":
        """Wrap the result of a computation."""
        self = object.__new__(cls)
        object.__setattr__(self, "components", _read_only(components))
        return self

    @classmethod
    def from_axis_angle(cls, axis: npt.ArrayLike, angle: npt.ArrayLike) -> "Quaternion":
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
        n, theta = arrays(axis=(axis, (3,)), angle=(angle, ()))
        half = theta[..., np.newaxis] / 2
        return cls._of(_joined(np.cos(half)[..., 0], np.sin(half) * unit("axis", n)))

    @classmethod
    def from_matrix(cls, matrix: npt.ArrayLike) -> "Quaternion":
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

    @_with_scalars
    def __add__(self, other: "Quaternion") -> "Quaternion":
        """Sum, component by component (2-2)."""
        return Quaternion._of(self.components + other.components)

    @_with_scalars
    def __sub__(self, other: "Quaternion") -> "Quaternion":
        """Difference, component by component (2-2)."""
        return Quaternion._of(self.components - other.components)

    @_with_scalars
    def __mul__(self, other: "Quaternion") -> "Quaternion":
        """Hamilton's product (2-3)."""
        (w1, v1), (w2, v2) = _parts(self), _parts(other)
        scalar = w1 * w2 - _dot(v1, v2)
        vector = w1 * v2 + w2 * v1 + np.cross(v1, v2)
        return Quaternion._of(_joined(scalar[..., 0], vector))

    def __truediv__(self, other: Any) -> "Quaternion":
        """Division from the right, q1 q2^-1 (2-5)."""
        if isinstance(other, Quaternion):
            return self * other.inverse()
        if not hasattr(other, "__truediv__"):
            return NotImplemented
        q, w = arrays(quaternion=(self.components, (4,)), scalar=(other, ()))
        _refuse_zero(w == 0)
        return Quaternion._of(q / w[..., np.newaxis])

    def __neg__(self) -> "Quaternion":
        return Quaternion._of(-self.components)

    # The only left operand that comes here is a real number, which commutes with everything.
    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, other: object) -> "Quaternion":
        return -self + other

    def __rtruediv__(self, other: object) -> "Quaternion":
        return self.inverse() * other

    @_with_scalars
    def __eq__(self, other: "Quaternion") -> Any:
        """Whether all four components are equal, quaternion by quaternion."""
        return (self.components == other.components).astype(bool).all(axis=-1)

    @_with_scalars
    def __ne__(self, other: "Quaternion") -> Any:
        """Whether any component differs, quaternion by quaternion."""
        return ~(self == other)

    def __repr__(self) -> str:
        w = np.array2string(self.w, separator=", ", prefix="Quaternion(")
        indent = "Quaternion(" if self.w.ndim else f"Quaternion({w}, "
        v = np.array2string(self.v, separator=", ", prefix=indent)
        return f"Quaternion({w}," + (f"\n{' ' * 11}" if self.w.ndim else " ") + f"{v})"

    def conjugate(self) -> "Quaternion":
        """Conjugate q* = [w, -v].

        Returns
        -------
        Quaternion, shape (...)

        Examples
        --------
        >>> Quaternion(1, [2, 3, 4]).conjugate()
        Quaternion(1., [-2., -3., -4.])
        """
        return Quaternion._of(_joined(self.w, -self.v))

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
        return length(self.components)

    def inverse(self) -> "Quaternion":
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
        q = self.components
        if q.dtype == object:
            return Quaternion._of(self.conjugate().components / _dot(q, q))
        _refuse_zero((q == 0).all(axis=-1))
        # The square of the norm could overflow or underflow.
        size = np.abs(q).max(axis=-1, keepdims=True)
        q = q / size
        return Quaternion._of(Quaternion._of(q).conjugate().components / _dot(q, q) / size)

    def axis_angle(self) -> tuple[Array, Array]:
        """Axis and angle of the rotation: the inverse of `from_axis_angle`.

        Returns
        -------
        axis : ndarray, shape (..., 3)
            Unit vectors; (1, 0, 0) where q is 1 or -1 times a positive number, since any axis
            would do.
        angle : ndarray, shape (...)
            Angles in radians, from 0 to 2 pi. Each quaternion is taken at its word: q turns about
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
        w, v = self._unit_parts()
        unturned = (v == 0).all(axis=-1, keepdims=True)
        axis = normalised(np.where(unturned, np.eye(3, dtype=int)[0], v).astype(v.dtype))
        return axis, np.asarray(2 * np.arctan2(_dot(axis, v), w)[..., 0])

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
        _, r = arrays(quaternion=(self.components, (4,)), points=(points, (3,)))
        w, v = self._unit_parts()
        twice = 2 * np.cross(v, r)
        rotated: Array = r + w * twice + np.cross(v, twice)
        return rotated

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
        w, v = self._unit_parts()
        (x, y, z), (x2, y2, z2) = (np.moveaxis(part, -1, 0) for part in (v, v + v))
        w = w[..., 0]
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

    def _unit_parts(self) -> tuple[Array, Array]:
        return _parts(Quaternion._of(unit("quaternion", self.components)))


def rotate_about_u(points: npt.ArrayLike, angle: npt.ArrayLike) -> Array:
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
    r, theta = arrays(points=(points, (3,)), angle=(angle, ()))
    ru, rv, rw = np.moveaxis(r, -1, 0)
    cos, sin = np.cos(theta), np.sin(theta)
    along, *across = np.broadcast_arrays(ru, cos * rv - sin * rw, cos * rw + sin * rv)
    return np.stack([along, *across], axis=-1)


def _joined(w: Array, v: Array) -> Array:
    """Make components from parts whose leading axes broadcast."""
    leading = np.broadcast_shapes(np.shape(w), v.shape[:-1])
    components = np.empty((*leading, 4), np.result_type(w, v))
    components[..., 0], components[..., 1:] = w, v
    return components


def _parts(q: Quaternion) -> tuple[Array, Array]:
    """Scalar and vector parts as arrays that broadcast against each other."""
    return q.components[..., :1], q.components[..., 1:]


def _read_only(array: Array) -> Array:
    array.flags.writeable = False
    return array


def _refuse_zero(zero: Array) -> None:
    if np.any(zero):
        raise DegenerateError(f"the zero quaternion has no inverse{_at(zero)}")


def _at(mask: Array) -> str:
    where = place(mask)
    return f"; found{where}" if where else ""


def _dot(a: Array, b: Array) -> Array:
    """Dot products, as an array that broadcasts against the vectors."""
    return np.asarray((a * b).sum(axis=-1, keepdims=True))
