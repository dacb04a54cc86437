"""Section 3: rotation about an axis, as a formula and as a matrix.

The notation follows the equations: r is the vector, n the unit axis, theta the angle.
"""

from __future__ import annotations

import numpy as np

from rotedu._arguments import Matrix, Number, Rotation, Unit3, Vector3, checked, place, rounding
from rotedu._vectors import Array, axis_and_length, cross, dot, times
from rotedu.errors import DegenerateError

__all__ = ["axis_angle", "rotate", "rotation_matrix", "sixteen_products", "transform"]


@checked
def rotate(points: Vector3, axis: Unit3, angle: Number) -> Vector3:
    """Rotate points about an axis through the origin by Rodrigues' formula (3-1), second line.

    Parameters
    ----------
    points : array_like, shape (..., 3)
        Points or vectors to rotate.
    axis : array_like, shape (..., 3)
        Direction of the axis; any length but zero.
    angle : array_like, shape (...)
        Angle in radians, anticlockwise as seen from the tip of the axis.

    Returns
    -------
    ndarray, shape (..., 3)
        The rotated points. The leading axes of the three arguments broadcast. For many points and
        one rotation, `rotation_matrix` and `transform` are cheaper.

    Examples
    --------
    A quarter turn about W takes U to V:

    >>> rotate([1, 0, 0], axis=[0, 0, 1], angle=np.pi / 2).round(15)
    array([0., 1., 0.])
    """
    r, n, cos, sin = points, axis, np.cos(angle), np.sin(angle)
    return cos * r + (1 - cos) * dot(r, n) * n + sin * cross(n, r)


@checked
def rotation_matrix(axis: Unit3, angle: Number) -> Rotation:
    """Return the matrix of a rotation about an axis, entry by entry as in (3-3).

    Parameters
    ----------
    axis : array_like, shape (..., 3)
        Direction of the axis; any length but zero.
    angle : array_like, shape (...)
        Angle in radians, anticlockwise as seen from the tip of the axis.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Orthogonal matrices with determinant 1, which multiply column vectors.

    Notes
    -----
    The code computes ``1 - cos(theta)`` once and shares nothing else, so it needs exactly as many
    operations as the paper states; `rotedu.cost.count` counts them. For angles below about 1e-8
    the difference rounds to 0, an error smaller than the rounding of the diagonal.

    Examples
    --------
    A third of a turn about the diagonal takes U to V, V to W and W to U:

    >>> rotation_matrix([1, 1, 1], 2 * np.pi / 3).round(15) + 0.0
    array([[0., 0., 1.],
           [1., 0., 0.],
           [0., 1., 0.]])
    """
    nu, nv, nw = axis
    cos, sin = np.cos(angle), np.sin(angle)
    k = 1 - cos
    rows = [
        [cos + k * nu * nu, k * nu * nv - sin * nw, k * nu * nw + sin * nv],
        [k * nu * nv + sin * nw, cos + k * nv * nv, k * nv * nw - sin * nu],
        [k * nu * nw - sin * nv, k * nv * nw + sin * nu, cos + k * nw * nw],
    ]
    return np.array(rows)


@checked
def transform(matrix: Matrix, points: Vector3) -> Vector3:
    """Multiply points, as column vectors, by a matrix (3-2).

    A 4x4 matrix acts on homogeneous coordinates: each point gets the fourth coordinate 1, and the
    result is divided by its fourth coordinate. A last row of (0, 0, 0, 1) makes that coordinate 1
    again and saves the division.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3) or (..., 4, 4)
        One matrix for all points, or a stack whose leading axes broadcast against those of the
        points. To apply each of k matrices to each of n points, give the stack the shape
        (k, 1, 3, 3).
    points : array_like, shape (..., 3)
        Points to transform.

    Returns
    -------
    ndarray, shape (..., 3)

    Raises
    ------
    rotedu.errors.DegenerateError
        If the fourth coordinate of a result is zero, that is, if a point goes to infinity.

    References
    ----------
    Cheng et al. (2023), Eq. (3-2), and Eq. (4-7) for 4x4 matrices

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
    if len(matrix) == 3:
        return times(matrix, points)
    affine = (np.moveaxis(matrix[3], 0, -1) == (0, 0, 0, 1)).all()
    rows = matrix[:3] if affine else matrix
    moved = times(rows[:, :3], points) + rows[:, 3]
    if affine:
        return moved
    refuse_infinite(moved[3])
    return moved[:3] / moved[3]


@checked
def sixteen_products(matrix: Rotation) -> Matrix:
    """Return the products 4 q_i q_j of a rotation's quaternion, given its matrix.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        Rotation matrices.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        The matrices 4 q q^T, where q = (q_0, ..., q_3) is the unit quaternion of the rotation:
        the cosine of half the angle, then the axis times the sine of half the angle. q and -q
        have the same products.

    References
    ----------
    Shepperd (1978), "Quaternion from rotation matrix", J. Guidance and Control 1(3), 223-224.

    Examples
    --------
    A quarter turn about W has q = (1, 0, 0, 1) / sqrt(2):

    >>> sixteen_products([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    array([[2., 0., 0., 2.],
           [0., 0., 0., 0.],
           [0., 0., 0., 0.],
           [2., 0., 0., 2.]])
    """
    (uu, uv, uw), (vu, vv, vw), (wu, wv, ww) = matrix
    return np.array(
        [
            [1 + uu + vv + ww, wv - vw, uw - wu, vu - uv],
            [wv - vw, 1 + uu - vv - ww, uv + vu, uw + wu],
            [uw - wu, uv + vu, 1 - uu + vv - ww, vw + wv],
            [vu - uv, uw + wu, vw + wv, 1 - uu - vv + ww],
        ]
    )


@checked
def axis_angle(matrix: Rotation) -> tuple[Vector3, Number]:
    """Return the axis and angle of a rotation matrix, the inverse of `rotation_matrix`.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        Rotation matrices.

    Returns
    -------
    axis : ndarray, shape (..., 3)
        Unit vectors. For the identity any axis would do, and the result is (1, 0, 0). At a half
        turn, to within rounding, both n and -n would do, and the result is the one whose first
        nonzero component is positive.
    angle : ndarray, shape (...)
        Angles in radians, from 0 to pi.

    Notes
    -----
    Each row of `sixteen_products` is a multiple of the rotation's unit quaternion. Shepperd's
    method takes the row with the largest diagonal entry, which is at least 1, so no digits are
    lost. The textbook formula ``arccos((trace - 1) / 2)`` loses half of them near 0 and pi, and
    dividing the skew-symmetric part by ``2 sin(theta)`` loses the axis near pi.

    References
    ----------
    Shepperd (1978), as for `sixteen_products`

    Examples
    --------
    >>> axis, angle = axis_angle(rotation_matrix([2, 0, 0], np.pi - 1e-9))
    >>> print(axis, f"{np.pi - angle:.3e}")
    [1. 0. 0.] 1.000e-09
    """
    table = sixteen_products(matrix)
    largest = np.argmax(np.diagonal(table), axis=-1)
    w, x, y, z = np.choose(largest, table)
    axis, sine = axis_and_length(np.stack([x, y, z]))

    # Take q or -q so that w > 0 or, at a half turn, the axis begins above 0.
    tiny = 4 * rounding(matrix)
    first = np.choose(np.argmax(np.abs(axis) > tiny, axis=0), axis)
    half_turn = np.abs(w) <= tiny * sine
    sign = np.where(half_turn, first, w)
    angle = 2 * np.arctan2(sine, np.where(half_turn, 0, np.abs(w)))
    return np.where(sign < 0, -axis, axis), angle


def refuse_infinite(w: Array) -> None:
    """Refuse a fourth coordinate of zero, because nothing can be divided by it."""
    infinite = np.asarray(w == 0)
    if infinite.any():
        raise DegenerateError(
            f"matrix sends {infinite.sum()} of {infinite.size} points to infinity{place(infinite)}"
        )
