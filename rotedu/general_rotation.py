"""Section 4: principal rotations, the one rotation that replaces three, and other transforms.

All matrices are 4x4 and act on homogeneous coordinates: a point is the column (r_u, r_v, r_w, 1).
`compose` multiplies matrices into one, and `rotedu.ordinary_rotation.transform` applies it.
"""

from __future__ import annotations

from functools import reduce
from typing import Any

import numpy as np
import numpy.typing as npt

from rotedu._arguments import (
    MATRIX,
    HomogeneousMatrix,
    Matrix3,
    NotZero,
    Number,
    OneOrThree,
    Rotation,
    RotationOrPose,
    Unit3,
    Vector,
    Vector3,
    checked,
    prepared,
    rounding,
)
from rotedu._vectors import Array, axis_and_length, length, product, times, transpose
from rotedu.arcs import angle_between, refuse_antipodal, smallest_turn
from rotedu.quaternions import Quaternion, joined, parts

__all__ = [
    "axis_angle_from_euler_angles",
    "compose",
    "euler_angles",
    "homogeneous",
    "matrix_from_euler_angles",
    "perspective",
    "quaternion_from_euler_angles",
    "reflection",
    "rotation_u",
    "rotation_v",
    "rotation_w",
    "scaling",
    "shearing",
    "swing_twist",
    "translation",
]


@checked
def rotation_u(angle: Number) -> HomogeneousMatrix:
    """Return the principal rotation about the U axis, which turns V towards W.

    Parameters
    ----------
    angle : array_like, shape (...)
        Angle in radians.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    References
    ----------
    Cheng et al. (2023), Section 4, first matrix

    Examples
    --------
    >>> print(rotation_u(np.pi / 2).round(15) + 0.0)
    [[ 1.  0.  0.  0.]
     [ 0.  0. -1.  0.]
     [ 0.  1.  0.  0.]
     [ 0.  0.  0.  1.]]
    """
    cos, sin = np.cos(angle), np.sin(angle)
    return from_rows([1, 0, 0, 0], [0, cos, -sin, 0], [0, sin, cos, 0])


@checked
def rotation_v(angle: Number) -> HomogeneousMatrix:
    """Return the principal rotation about the V axis, which turns W towards U.

    Parameters
    ----------
    angle : array_like, shape (...)
        Angle in radians.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    References
    ----------
    Cheng et al. (2023), Section 4, second matrix

    Examples
    --------
    >>> print(rotation_v(np.pi / 2).round(15) + 0.0)
    [[ 0.  0.  1.  0.]
     [ 0.  1.  0.  0.]
     [-1.  0.  0.  0.]
     [ 0.  0.  0.  1.]]
    """
    cos, sin = np.cos(angle), np.sin(angle)
    return from_rows([cos, 0, sin, 0], [0, 1, 0, 0], [-sin, 0, cos, 0])


@checked
def rotation_w(angle: Number) -> HomogeneousMatrix:
    """Return the principal rotation about the W axis, which turns U towards V.

    Parameters
    ----------
    angle : array_like, shape (...)
        Angle in radians.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    References
    ----------
    Cheng et al. (2023), Section 4, third matrix

    Examples
    --------
    >>> print(rotation_w(np.pi / 2).round(15) + 0.0)
    [[ 0. -1.  0.  0.]
     [ 1.  0.  0.  0.]
     [ 0.  0.  1.  0.]
     [ 0.  0.  0.  1.]]
    """
    cos, sin = np.cos(angle), np.sin(angle)
    return from_rows([cos, -sin, 0, 0], [sin, cos, 0, 0], [0, 0, 1, 0])


@checked
def matrix_from_euler_angles(
    u: Number,
    v: Number,
    w: Number,
) -> HomogeneousMatrix:
    """Return the matrix that rotates about U, then V, then W: (4-1), multiplied out in (4-2).

    Parameters
    ----------
    u, v, w : array_like, shape (...)
        Angles in radians about the three axes, which stay fixed.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        ``rotation_w(w) @ rotation_v(v) @ rotation_u(u)``.

    Notes
    -----
    Another order gives another rotation. Where cos(v) = 0, only the sum or the difference of the
    other two angles matters, and one degree of freedom is lost (gimbal lock).

    Examples
    --------
    >>> turn = np.pi / 2
    >>> print(matrix_from_euler_angles(turn, 0, turn).round(15)[:3, :3] + 0.0)
    [[0. 0. 1.]
     [1. 0. 0.]
     [0. 1. 0.]]
    """
    cu, cv, cw = np.cos(u), np.cos(v), np.cos(w)
    su, sv, sw = np.sin(u), np.sin(v), np.sin(w)
    return from_rows(
        [cv * cw, su * sv * cw - cu * sw, cu * sv * cw + su * sw, 0],
        [cv * sw, su * sv * sw + cu * cw, cu * sv * sw - su * cw, 0],
        [-sv, su * cv, cu * cv, 0],
    )


@checked
def quaternion_from_euler_angles(
    u: Number,
    v: Number,
    w: Number,
) -> Quaternion:
    """Return the quaternion of three principal rotations, given by (4-4) and (4-6).

    Parameters
    ----------
    u, v, w : array_like, shape (...)
        Angles in radians, as for `matrix_from_euler_angles`.

    Returns
    -------
    Quaternion, shape (...)
        The unit quaternion [delta, (alpha, beta, gamma)], the product of the quaternions of the
        principal rotations about W, V and U.

    Examples
    --------
    >>> print(quaternion_from_euler_angles(0, 0, 2 * np.pi / 3).components.round(3))
    [0.5   0.    0.    0.866]
    """
    u, v, w = u / 2, v / 2, w / 2
    cu, cv, cw = np.cos(u), np.cos(v), np.cos(w)
    su, sv, sw = np.sin(u), np.sin(v), np.sin(w)
    alpha = su * cv * cw - cu * sv * sw
    beta = cu * sv * cw + su * cv * sw
    gamma = cu * cv * sw - su * sv * cw
    delta = cu * cv * cw + su * sv * sw
    return joined(delta, np.stack([alpha, beta, gamma]))


@checked
def axis_angle_from_euler_angles(u: Number, v: Number, w: Number) -> tuple[Vector, Number]:
    """Return the axis and angle of the one rotation that replaces three, (4-3) to (4-6).

    Parameters
    ----------
    u, v, w : array_like, shape (...)
        Angles in radians, as for `matrix_from_euler_angles`.

    Returns
    -------
    axis : ndarray, shape (..., 3)
        Unit vectors. Where nothing turns, any axis would do, and the axis is (1, 0, 0).
    angle : ndarray, shape (...)
        Angles in radians, from 0 to 2 pi.

    Notes
    -----
    (4-5) gives the sine of half the angle and (4-6) its cosine. Both are needed, since the sine
    alone does not distinguish an angle from the rest of a full turn. (4-3) is 0/0 where nothing
    turns; a rotation smaller than the rounding of the three angles counts as none.

    Examples
    --------
    >>> axis, angle = axis_angle_from_euler_angles(np.pi / 2, 0, np.pi / 2)
    >>> print(axis.round(3), np.degrees(angle).round(3))
    [0.577 0.577 0.577] 120.0
    """
    ((delta, vector),) = parts(quaternion_from_euler_angles(u, v, w))
    # A turn smaller than the rounding of the given angles counts as none. Objects are not rounded.
    eps = rounding(delta)
    rounded = eps and eps * (abs(u) + abs(v) + abs(w)) / 2
    axis, sine = axis_and_length(vector, negligible=rounded)
    return axis, 2 * np.arctan2(np.where(sine <= rounded, 0, sine), delta)


@checked
def euler_angles(matrix: RotationOrPose) -> tuple[Number, Number, Number]:
    """Return the angles about U, V and W, the inverse of `matrix_from_euler_angles`.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3) or (..., 4, 4)
        Rotation matrices. A 4x4 matrix may contain neither a translation nor a perspective.

    Returns
    -------
    u, v, w : ndarray, shape (...)
        Angles in radians: v from -pi/2 to pi/2, the others from -pi to pi. At gimbal lock v is
        -pi/2 or pi/2, and only one combination of u and w matters; then w is 0.

    Notes
    -----
    The first column of (4-2) gives v and w. The code then undoes the turn about W before it reads
    off u, which therefore keeps its digits near gimbal lock, where w is lost to rounding.

    References
    ----------
    Cheng et al. (2023), Eq. (4-2), solved for the angles; the paper has no such formula.

    Examples
    --------
    >>> u, v, w = euler_angles(matrix_from_euler_angles(0.1, 0.2, 0.3))
    >>> print(u.round(12), v.round(12), w.round(12))
    0.1 0.2 0.3
    """
    (m11, m12, m13), (m21, m22, m23), (m31, _, _) = matrix
    cv = length(np.stack([m11, m21]))
    locked = cv <= 4 * rounding(matrix)
    w = np.where(locked, 0, np.arctan2(m21, m11))
    cw, sw = np.cos(w), np.sin(w)
    u = np.arctan2(sw * m13 - cw * m23, cw * m22 - sw * m12)
    return u, np.arctan2(-m31, cv), w


@checked
def swing_twist(matrix: Rotation, axis: Unit3) -> tuple[Rotation, Rotation]:
    """Split a rotation into a twist about an axis and a swing of this axis after it.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        Rotation matrices.
    axis : array_like, shape (..., 3)
        Unit vectors, such as the direction of an upper arm.

    Returns
    -------
    swing, twist : ndarray, shape (..., 3, 3)
        Rotation matrices with the product ``swing @ twist``. The twist is about the axis; the swing
        is the smallest rotation that takes the axis to where the matrix takes it.

    Raises
    ------
    rotedu.errors.DegenerateError
        If the axis is turned to its opposite (to half of the digits), because many swings do that.

    References
    ----------
    Dobrowolski (2015), "Swing-twist decomposition in Clifford algebra", arXiv:1506.05481

    Examples
    --------
    >>> swing, twist = swing_twist(matrix_from_euler_angles(0, 0.5, 0.25)[:3, :3], [0, 0, 1])
    >>> print(np.arctan2(twist[1, 0], twist[0, 0]).round(12), np.arccos(swing[2, 2]).round(12))
    0.25 0.5
    """
    swung = times(matrix, axis)
    refuse_antipodal(angle_between(axis, swung), "axis and what it is turned to")
    swing = smallest_turn(axis, swung)
    return swing, product(transpose(swing), matrix)


@checked
def homogeneous(matrix: Matrix3) -> HomogeneousMatrix:
    """Extend a 3x3 matrix to a 4x4 matrix, which turns (3-3) into (4-7).

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        Matrices for points with three coordinates.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    References
    ----------
    Cheng et al. (2023), Eq. (4-7), whose axis is a direction (erratum E8)

    Examples
    --------
    >>> print(homogeneous([[0, -1, 0], [1, 0, 0], [0, 0, 1]]))
    [[ 0. -1.  0.  0.]
     [ 1.  0.  0.  0.]
     [ 0.  0.  1.  0.]
     [ 0.  0.  0.  1.]]
    """
    return embedded(matrix)


@checked
def translation(v: Vector3) -> HomogeneousMatrix:
    """Return the matrix that moves points by a vector.

    Parameters
    ----------
    v : array_like, shape (..., 3)
        Displacement.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Examples
    --------
    The point (0, 0, 1) moves; the direction (0, 0, 1) does not:

    >>> print(translation([5, 0, 0]) @ [0, 0, 1, 1], translation([5, 0, 0]) @ [0, 0, 1, 0])
    [5. 0. 1. 1.] [0. 0. 1. 0.]
    """
    u, v, w = v
    return from_rows([1, 0, 0, u], [0, 1, 0, v], [0, 0, 1, w])


@checked
def scaling(s: OneOrThree) -> HomogeneousMatrix:
    """Return the matrix that stretches or shrinks along the axes.

    Parameters
    ----------
    s : array_like, shape () or (..., 3)
        One factor for all three axes, or one for each. A negative factor reflects, 0 flattens.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Examples
    --------
    >>> print(scaling([1, 2, 3]) @ [1, 1, 1, 1], scaling(2) @ [1, 1, 1, 1])
    [1. 2. 3. 1.] [2. 2. 2. 1.]
    """
    u, v, w = (s, s, s) if s.ndim == 0 else np.moveaxis(s, -1, 0)
    return from_rows([u, 0, 0, 0], [0, v, 0, 0], [0, 0, w, 0])


@checked
def shearing(
    *,
    uv: Number = 0,
    uw: Number = 0,
    vu: Number = 0,
    vw: Number = 0,
    wu: Number = 0,
    wv: Number = 0,
) -> HomogeneousMatrix:
    """Return the matrix that adds to each coordinate multiples of the other two.

    Parameters
    ----------
    uv, uw, vu, vw, wu, wv : array_like, shape (...), optional
        Entries of the matrix, named by row and column. For example, `uv` times the second
        coordinate is added to the first.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Examples
    --------
    A pile of cards leans towards U by half of its height along W:

    >>> print(shearing(uw=0.5) @ [0, 0, 10, 1])
    [ 5.  0. 10.  1.]
    """
    return from_rows([1, uv, uw, 0], [vu, 1, vw, 0], [wu, wv, 1, 0])


@checked
def reflection(normal: Unit3) -> HomogeneousMatrix:
    """Return the matrix that reflects points in a plane through the origin.

    Parameters
    ----------
    normal : array_like, shape (..., 3)
        Normal of the plane; any length but zero.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        Matrices with determinant -1. No rotation does this, and no unit quaternion q by q r q*.

    Examples
    --------
    >>> print(reflection([0, 0, 1]) @ [1, 2, 3, 1])
    [ 1.  2. -3.  1.]
    """
    u, v, w = normal
    return from_rows(
        [1 - 2 * u * u, -2 * u * v, -2 * u * w, 0],
        [-2 * v * u, 1 - 2 * v * v, -2 * v * w, 0],
        [-2 * w * u, -2 * w * v, 1 - 2 * w * w, 0],
    )


@checked
def perspective(distance: NotZero) -> HomogeneousMatrix:
    """Return the matrix that shows points as an eye on the W axis sees them in the plane w = 0.

    Parameters
    ----------
    distance : array_like, shape (...)
        Position of the eye on the W axis. Points in the plane stay in place.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        After the division by the fourth coordinate, the first two coordinates are the picture and
        the third is a depth, which keeps the order from front to back.

    Notes
    -----
    Of the transforms in this module, only this one gives a fourth coordinate other than 1. The
    division is left to `rotedu.ordinary_rotation.transform`, which refuses points whose
    fourth coordinate is zero; at the depth of the eye rounding may leave a tiny one.

    Examples
    --------
    Seen from a distance of 4, an object 4 behind the plane looks half as large:

    >>> print(perspective(4) @ [1, 1, -4, 1])
    [ 1.  1. -4.  2.]
    """
    return from_rows([1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, -1 / distance, 1])


def compose(*matrices: npt.ArrayLike) -> Array:
    """Multiply matrices into one; ``compose(a, b, c)`` applies c first, then b, then a.

    Parameters
    ----------
    *matrices : array_like, shape (..., 4, 4) or (..., 3, 3)
        The factors in the order of the equation, the last one next to the point. `homogeneous`
        extends 3x3 matrices. The leading axes broadcast.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        The product; the identity if there are no matrices.

    References
    ----------
    Cheng et al. (2023), Section 3, last paragraph; Eq. (4-1)

    Examples
    --------
    Scaling a point and then moving it differs from moving it and then scaling it:

    >>> print(compose(translation([1, 0, 0]), scaling(2)) @ [1, 1, 1, 1])
    [3. 2. 2. 1.]
    >>> print(compose(scaling(2), translation([1, 0, 0])) @ [1, 1, 1, 1])
    [4. 2. 2. 1.]
    """
    if not matrices:
        return np.eye(4)
    given = {f"matrices[{i}]": (matrix, MATRIX) for i, matrix in enumerate(matrices)}
    factors = [m if len(m) == 4 else embedded(m) for m in prepared(given).values()]
    return np.moveaxis(reduce(product, factors), (0, 1), (-2, -1)).copy()


def from_rows(*rows: list[Any]) -> Array:
    """Make 4x4 matrices from entries that broadcast; a missing fourth row is (0, 0, 0, 1)."""
    entries = [entry for row in (*rows, [0, 0, 0, 1])[:4] for entry in row]
    dtype = np.result_type(*(np.asarray(e) for e in entries if not isinstance(e, int)))
    matrix = np.stack(np.broadcast_arrays(*entries), dtype=dtype)
    return matrix.reshape(4, 4, *matrix.shape[1:])


def embedded(matrix: Array) -> Array:
    """Extend a 3x3 matrix to a 4x4 matrix, components first."""
    return from_rows(*([*row, 0] for row in matrix))
