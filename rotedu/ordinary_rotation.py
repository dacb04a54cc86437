"""Section 3: rotation about an axis, as a formula and as a matrix.

The notation is that of the equations: r is the vector, n the unit axis, theta the angle.
"""

import math
from reprlib import repr as shortened
from typing import Any

import numpy as np
import numpy.typing as npt

from rotedu._arguments import (
    Array,
    arrays,
    normalised,
    place,
    require_finite,
    require_rotation,
    shaped,
    unit,
)
from rotedu.errors import DegenerateError

__all__ = ["axis_angle", "rotate", "rotation_matrix", "transform"]

DOUBLE = np.dtype(np.float64)
# Numbers that are best checked before they are used; more are checked afterwards.
FEW = 3 * 1000
# Points multiplied at a time: few enough for the cache, and enough for several threads.
BLOCK = 400_000
# Points that stay in the cache until they are copied to where they belong.
CACHED = 16_000


def rotate(points: npt.ArrayLike, axis: npt.ArrayLike, angle: npt.ArrayLike) -> Array:
    """Rotate points about an axis through the origin: Rodrigues' formula (3-1), second line.

    Parameters
    ----------
    points : array_like, shape (..., 3)
        The points, or vectors, to rotate.
    axis : array_like, shape (..., 3)
        Direction of the axis, of any length but zero.
    angle : array_like, shape (...)
        Angle in radians, counterclockwise seen from the tip of the axis.

    Returns
    -------
    ndarray, shape (..., 3)
        The rotated points; the leading axes of the three arguments are broadcast.

    Raises
    ------
    ValueError
        If an argument is not finite or has the wrong shape, or if an axis is zero.

    See Also
    --------
    rotation_matrix, transform : cheaper for many points and one rotation.

    References
    ----------
    Cheng et al. (2023), Eq. (3-1)

    Examples
    --------
    A quarter turn about W takes U to V:

    >>> rotate([1, 0, 0], axis=[0, 0, 1], angle=np.pi / 2).round(15)
    array([0., 1., 0.])

    One point, three angles:

    >>> rotate([1, 0, 0], axis=[0, 0, 1], angle=[0, np.pi / 6, np.pi / 2]).round(3)
    array([[1.   , 0.   , 0.   ],
           [0.866, 0.5  , 0.   ],
           [0.   , 1.   , 0.   ]])
    """
    r, n, theta = arrays(points=(points, (3,)), axis=(axis, (3,)), angle=(angle, ()))
    n, theta = unit("axis", n), theta[..., np.newaxis]
    cos, sin = np.cos(theta), np.sin(theta)
    rotated: Array = cos * r + (1 - cos) * _dot(r, n) * n + sin * np.cross(n, r)
    return rotated


def rotation_matrix(axis: npt.ArrayLike, angle: npt.ArrayLike) -> Array:
    """Matrix of the rotation about an axis through the origin, entry by entry as in (3-3).

    Parameters
    ----------
    axis : array_like, shape (..., 3)
        Direction of the axis, of any length but zero.
    angle : array_like, shape (...)
        Angle in radians, counterclockwise seen from the tip of the axis.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Orthogonal matrices of determinant 1, to be multiplied with column vectors.

    Raises
    ------
    ValueError
        If an argument is not finite or has the wrong shape, or if an axis is zero.

    See Also
    --------
    axis_angle : the way back.
    transform : the matrix applied to points.

    Notes
    -----
    ``1 - cos(theta)`` is computed once and nothing else is shared: the code costs what the paper
    says its matrix costs, as `rotedu.cost.count` shows. For angles below about 1e-8 it rounds to
    0, an error smaller than the rounding of the diagonal.

    References
    ----------
    Cheng et al. (2023), Eq. (3-3)

    Examples
    --------
    A third of a turn about the diagonal takes U to V, V to W and W to U:

    >>> rotation_matrix([1, 1, 1], 2 * np.pi / 3).round(15) + 0.0
    array([[0., 0., 1.],
           [1., 0., 0.],
           [0., 1., 0.]])

    Degrees mistaken for radians are no error, but another rotation:

    >>> rotation_matrix([0, 0, 1], 90)[:, 0].round(3)
    array([-0.448,  0.894,  0.   ])
    """
    n, theta = arrays(axis=(axis, (3,)), angle=(angle, ()))
    nu, nv, nw = np.moveaxis(unit("axis", n), -1, 0)
    cos, sin = np.cos(theta), np.sin(theta)
    k = 1 - cos
    matrix = np.array(
        [
            [cos + k * nu * nu, k * nu * nv - sin * nw, k * nu * nw + sin * nv],
            [k * nu * nv + sin * nw, cos + k * nv * nv, k * nv * nw - sin * nu],
            [k * nu * nw - sin * nv, k * nv * nw + sin * nu, cos + k * nw * nw],
        ]
    )
    return np.moveaxis(matrix, (0, 1), (-2, -1))


def transform(matrix: npt.ArrayLike, points: npt.ArrayLike, out: Array | None = None) -> Array:
    """Multiply points, as column vectors, by a matrix (3-2).

    A 4x4 matrix acts on homogeneous coordinates: the point gets the fourth coordinate 1, and the
    result is divided by its fourth coordinate unless the last row of the matrix, (0, 0, 0, 1),
    makes that 1 again.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3) or (..., 4, 4)
        One matrix for all points, or a stack whose leading axes broadcast against those of the
        points. To apply each of k matrices to each of n points, give shape (k, 1, 3, 3).
    points : array_like, shape (..., 3)
        The points.
    out : ndarray, shape (..., 3), optional
        Where to put the result, of its shape and dtype; it may be `points` itself. After an error
        it may be filled in part. A new array is made otherwise, which takes time of its own if
        there are millions of points.

    Returns
    -------
    ndarray, shape (..., 3)
        The transformed points: `out`, if it is given.

    Raises
    ------
    ValueError
        If an argument is not finite or has the wrong shape or dtype.
    rotedu.errors.DegenerateError
        If the perspective divide would be by zero, that is, if a point is sent to infinity.

    References
    ----------
    Cheng et al. (2023), Eq. (3-2); with 4x4 matrices, Eq. (4-7)

    Examples
    --------
    >>> quarter_turn = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    >>> transform(quarter_turn, [[1, 0, 0], [0, 1, 5]])
    array([[ 0.,  1.,  0.],
           [-1.,  0.,  5.]])

    Projection from the origin onto the plane w = 1 keeps only the direction:

    >>> projection = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 0]]
    >>> transform(projection, [[2, 4, 2], [3, 6, 3]])
    array([[1., 2., 1.],
           [1., 2., 1.]])
    >>> transform(projection, [[2, 4, 2], [2, 4, 0]])
    Traceback (most recent call last):
        ...
    rotedu.errors.DegenerateError: matrix sends 1 of 2 points to infinity at index (1,)
    """
    m, r = _matrix_and_points(matrix, points)
    require_finite("matrix", m)
    if out is not None:
        _require_like_result(out, m, r)
    homogeneous = m.shape[-1] == 4
    projective = homogeneous and not (m[..., 3, :] == (0, 0, 0, 1)).all()
    linear = m[..., : 3 + projective, :3] if homogeneous else m
    if r.size <= FEW or m.ndim > 2 or "O" in (m.dtype.char, r.dtype.char):
        require_finite("points", r)
        moved = _multiply(linear, r)
    else:
        moved = _multiply_many(linear, r, None if projective else out)
    if homogeneous:
        moved += m[..., : linear.shape[-2], 3]
    if projective:
        moved = _perspective_divide(moved)
    if out is None:
        return moved
    if not np.may_share_memory(out, moved):
        out[...] = moved
    return out


def axis_angle(matrix: npt.ArrayLike) -> tuple[Array, Array]:
    """Axis and angle of a rotation matrix: the inverse of `rotation_matrix`.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        Rotation matrices.

    Returns
    -------
    axis : ndarray, shape (..., 3)
        Unit vectors. Where the matrix leaves everything in place any axis would do: it is
        (1, 0, 0). At a half turn, to within rounding, n and -n both serve: it is the one whose
        first component other than zero is positive.
    angle : ndarray, shape (...)
        Angles in radians, from 0 to pi.

    Raises
    ------
    ValueError
        If the matrix is not finite, has the wrong shape, is not orthogonal (to half of the digits
        of its dtype), or is orthogonal but reflects; the message says how far off it is.

    Notes
    -----
    With q the unit quaternion of the rotation, the sixteen numbers 4 q q^T are sums of entries of
    the matrix. Each row is a multiple of q; Shepperd's method takes the one with the largest
    diagonal entry, which is at least 1, so that no digits are lost. The textbook's
    ``arccos((trace - 1) / 2)`` loses half of them near 0 and pi, and dividing the skew part by
    ``2 sin(theta)`` loses the axis near pi.

    References
    ----------
    Shepperd (1978), "Quaternion from rotation matrix", J. Guidance and Control 1(3), 223-224.
    Cheng et al. (2023) have no such formula; (4-3) to (4-6) start from three angles instead.

    Examples
    --------
    >>> axis, angle = axis_angle(rotation_matrix([2, 0, 0], np.pi - 1e-9))
    >>> print(axis, f"{np.pi - angle:.3e}")
    [1. 0. 0.] 1.000e-09
    """
    (m,) = arrays(matrix=(matrix, (3, 3)))
    require_rotation("matrix", m)

    q = _quaternion_multiple(m)
    w, v = q[..., :1], q[..., 1:]
    unturned = (v == 0).all(axis=-1, keepdims=True)
    # There q = (w, 0, 0, 0), so that its first three numbers point along (1, 0, 0).
    axis = normalised(np.where(unturned, q[..., :3], v))
    length = _dot(axis, v)

    rounding = 4 * float(np.finfo(np.float64 if m.dtype == object else m.dtype).eps)
    half_turn = np.abs(w) <= rounding * length
    first = np.argmax(np.abs(axis) > rounding, axis=-1, keepdims=True)
    sign = np.where(half_turn, np.take_along_axis(axis, first, axis=-1), w)
    angle = 2 * np.arctan2(length, np.where(half_turn, 0, np.abs(w)))
    return np.where(sign < 0, -axis, axis), angle[..., 0]


def _quaternion_multiple(m: Array) -> Array:
    """Row of 4 q q^T with the largest diagonal entry, q being the unit quaternion of m."""
    u, v, w = 0, 1, 2
    diagonal = np.diagonal(m, axis1=-2, axis2=-1)
    trace = diagonal.sum(axis=-1, keepdims=True)
    outer = np.empty((*m.shape[:-2], 4, 4), m.dtype)
    outer[..., 1:, 1:] = m + m.mT
    outer[..., 0, 1:] = m[..., [w, u, v], [v, w, u]] - m[..., [v, w, u], [w, u, v]]
    outer[..., 1:, 0] = outer[..., 0, 1:]
    squares = np.concatenate([1 + trace, 1 - trace + 2 * diagonal], axis=-1)
    outer[..., range(4), range(4)] = squares
    largest = np.argmax(squares, axis=-1)
    return np.take_along_axis(outer, largest[..., None, None], axis=-2)[..., 0, :]


def _dot(a: Array, b: Array) -> Array:
    """Dot products, as an array that broadcasts against the vectors."""
    return np.asarray((a * b).sum(axis=-1, keepdims=True))


def _matrix_and_points(matrix: Any, points: Any) -> list[Array]:
    """Do as `shaped`, but at once if they are arrays of float64 of the most usual shapes."""
    if (
        type(matrix) is type(points) is np.ndarray
        and matrix.dtype is points.dtype is DOUBLE
        and matrix.shape == (3, 3)
        and points.shape[-1:] == (3,)
    ):
        return [matrix, points]
    return shaped(matrix=(matrix, (3, 3), (4, 4)), points=(points, (3,)))


def _require_like_result(out: Array, m: Array, r: Array) -> None:
    """Refuse an array that cannot hold the result of `transform`."""
    shape = (*np.broadcast_shapes(m.shape[:-2], r.shape[:-1]), 3)
    dtype = np.result_type(m, r)
    if not isinstance(out, np.ndarray) or (out.shape, out.dtype) != (shape, dtype):
        got = f"{out.dtype} {out.shape}" if isinstance(out, np.ndarray) else shortened(out)
        raise ValueError(f"out must be an array of {dtype} and shape {shape}; got {got}")


def _perspective_divide(moved: Array) -> Array:
    """Divide the first three homogeneous coordinates by the fourth."""
    infinite = moved[..., 3] == 0
    if infinite.any():
        raise DegenerateError(
            f"matrix sends {infinite.sum()} of {infinite.size} points to infinity{place(infinite)}"
        )
    return np.asarray(moved[..., :3] / moved[..., 3:])


def _multiply(matrix: Array, points: Array) -> Array:
    """Matrix times column vector, for all points.

    One matrix for many points is multiplied by these as columns. So each coordinate of the result
    is contiguous, not each point; scipy does the same. It is the fastest way, and for what follows
    as well.
    """
    if matrix.ndim > 2:
        return np.asarray((matrix @ points[..., np.newaxis])[..., 0])
    if points.ndim == 1:
        return np.asarray(matrix @ points)
    if points.ndim > 2:
        return _multiply(matrix, points.reshape(-1, 3)).reshape(*points.shape[:-1], len(matrix))
    moved: Array = np.asfortranarray(matrix).dot(points.T).T
    return moved


def _multiply_many(matrix: Array, points: Array, out: Array | None) -> Array:
    """Do as `_multiply`, block by block, and check each block while it is in the cache.

    What is not finite shows in the images, unless a zero in the matrix hides it. Points that are
    replaced by their images are checked before.
    """
    if out is points:
        require_finite("points", points)
    elif out is not None and np.may_share_memory(out, points):
        points = points.copy()
    r = points.reshape(-1, 3)
    with np.errstate(invalid="ignore", over="ignore"):
        if out is not None and out.flags.c_contiguous:
            moved, squares = out, _fill_rows(out.reshape(-1, 3), matrix, r)
        else:
            columns = np.empty((len(matrix), len(r)), np.result_type(matrix, r))
            squares = _fill_columns(columns, matrix, r)
            moved = columns.T.reshape(*points.shape[:-1], len(matrix))
    if out is not points and not (matrix[0].all() and math.isfinite(squares)):
        require_finite("points", points)
    return moved


def _fill_columns(columns: Array, matrix: Array, points: Array) -> float:
    """Put the images of the points into columns; return the squares of the first row, summed."""
    m, squares = np.asfortranarray(matrix), 0.0
    for start in range(0, len(points), BLOCK):
        r = points[start : start + BLOCK]
        if not points.flags.forc:
            r = np.ascontiguousarray(r)
        images = np.matmul(m, r.T, out=columns[:, start : start + BLOCK])
        squares += float(np.vdot(images[0], images[0]))
    return squares


def _fill_rows(rows: Array, matrix: Array, points: Array) -> float:
    """Put the images of the points into rows; return the squares of all their coordinates, summed.

    They pass through the cache: memory that is only copied to need not be read before.
    """
    m, squares = np.ascontiguousarray(matrix.T), 0.0
    cached = np.empty((min(CACHED, len(points)), 3), rows.dtype)
    for start in range(0, len(points), CACHED):
        r = np.ascontiguousarray(points[start : start + CACHED])
        images = np.matmul(r, m, out=cached[: len(r)])
        rows[start : start + CACHED] = images
        squares += float(np.vdot(images, images))
    return squares
