"""Section 4: principal rotations, the one rotation that replaces three, and what else goes along.

All matrices are 4x4, for homogeneous coordinates: a point is (r_u, r_v, r_w, 1)^t. Every matrix
takes a place in one product, `compose`, and `rotedu.ordinary_rotation.transform` applies that.
"""

from functools import reduce
from typing import Any

import numpy as np
import numpy.typing as npt

from rotedu._arguments import Array, arrays, length, place, unit

__all__ = [
    "axis_angle_from_euler_angles",
    "compose",
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
    "translation",
]


def rotation_u(angle: npt.ArrayLike) -> Array:
    """Principal rotation about the U axis, which turns V towards W.

    Parameters
    ----------
    angle : array_like, shape (...)
        Angle in radians.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Raises
    ------
    ValueError
        If the angle is not finite.

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
    (theta,) = arrays(angle=(angle, ()))
    cos, sin = np.cos(theta), np.sin(theta)
    return _matrix([1, 0, 0, 0], [0, cos, -sin, 0], [0, sin, cos, 0])


def rotation_v(angle: npt.ArrayLike) -> Array:
    """Principal rotation about the V axis, which turns W towards U.

    Parameters
    ----------
    angle : array_like, shape (...)
        Angle in radians.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Raises
    ------
    ValueError
        If the angle is not finite.

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
    (theta,) = arrays(angle=(angle, ()))
    cos, sin = np.cos(theta), np.sin(theta)
    return _matrix([cos, 0, sin, 0], [0, 1, 0, 0], [-sin, 0, cos, 0])


def rotation_w(angle: npt.ArrayLike) -> Array:
    """Principal rotation about the W axis, which turns U towards V.

    Parameters
    ----------
    angle : array_like, shape (...)
        Angle in radians.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Raises
    ------
    ValueError
        If the angle is not finite.

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
    (theta,) = arrays(angle=(angle, ()))
    cos, sin = np.cos(theta), np.sin(theta)
    return _matrix([cos, -sin, 0, 0], [sin, cos, 0, 0], [0, 0, 1, 0])


def matrix_from_euler_angles(
    theta_u: npt.ArrayLike, theta_v: npt.ArrayLike, theta_w: npt.ArrayLike
) -> Array:
    """Rotate about U first, then about V, then about W, all fixed: (4-1), multiplied out (4-2).

    Parameters
    ----------
    theta_u, theta_v, theta_w : array_like, shape (...)
        Angles in radians about the three axes, which stay where they are.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        ``rotation_w(theta_w) @ rotation_v(theta_v) @ rotation_u(theta_u)``.

    Raises
    ------
    ValueError
        If an angle is not finite, or if the three do not broadcast.

    Notes
    -----
    Other orders are other rotations. Where cos(theta_v) = 0 only the sum or the difference of the
    other two angles matters: one degree of freedom is lost (gimbal lock).

    References
    ----------
    Cheng et al. (2023), Eqs. (4-1) and (4-2)

    Examples
    --------
    >>> turn = np.pi / 2
    >>> print(matrix_from_euler_angles(turn, 0, turn).round(15)[:3, :3] + 0.0)
    [[0. 0. 1.]
     [1. 0. 0.]
     [0. 1. 0.]]

    Gimbal lock:

    >>> a, b = matrix_from_euler_angles(0.3, turn, 0.1), matrix_from_euler_angles(0.7, turn, 0.5)
    >>> np.allclose(a, b, rtol=0, atol=1e-15)
    True
    """
    angles = arrays(theta_u=(theta_u, ()), theta_v=(theta_v, ()), theta_w=(theta_w, ()))
    (cu, su), (cv, sv), (cw, sw) = ((np.cos(theta), np.sin(theta)) for theta in angles)
    return _matrix(
        [cv * cw, su * sv * cw - cu * sw, cu * sv * cw + su * sw, 0],
        [cv * sw, su * sv * sw + cu * cw, cu * sv * sw - su * cw, 0],
        [-sv, su * cv, cu * cv, 0],
    )


def quaternion_from_euler_angles(
    theta_u: npt.ArrayLike, theta_v: npt.ArrayLike, theta_w: npt.ArrayLike
) -> tuple[Array, Array, Array, Array]:
    """Evaluate alpha, beta, gamma (4-4) and the cosine of half the angle (4-6).

    They are the quaternion of the rotation: with q_u, q_v, q_w the quaternions of the principal
    rotations, q_w q_v q_u = [delta, (alpha, beta, gamma)].

    Parameters
    ----------
    theta_u, theta_v, theta_w : array_like, shape (...)
        Angles in radians, as for `matrix_from_euler_angles`.

    Returns
    -------
    alpha, beta, gamma, delta : ndarray, shape (...)
        The squares of the four add up to 1.

    Raises
    ------
    ValueError
        If an angle is not finite, or if the three do not broadcast.

    References
    ----------
    Cheng et al. (2023), Eqs. (4-4) and (4-6)

    Examples
    --------
    >>> print(np.array(quaternion_from_euler_angles(0, 0, 2 * np.pi / 3)).round(3))
    [0.    0.    0.866 0.5  ]
    """
    angles = arrays(theta_u=(theta_u, ()), theta_v=(theta_v, ()), theta_w=(theta_w, ()))
    halves = [theta / 2 for theta in angles]
    (cu, su), (cv, sv), (cw, sw) = ((np.cos(half), np.sin(half)) for half in halves)
    alpha = su * cv * cw - cu * sv * sw
    beta = cu * sv * cw + su * cv * sw
    gamma = cu * cv * sw - su * sv * cw
    delta = cu * cv * cw + su * sv * sw
    return alpha, beta, gamma, delta


def axis_angle_from_euler_angles(
    theta_u: npt.ArrayLike, theta_v: npt.ArrayLike, theta_w: npt.ArrayLike
) -> tuple[Array, Array]:
    """Axis and angle of the one rotation that three principal rotations come to, (4-3) to (4-6).

    Parameters
    ----------
    theta_u, theta_v, theta_w : array_like, shape (...)
        Angles in radians, as for `matrix_from_euler_angles`.

    Returns
    -------
    axis : ndarray, shape (..., 3)
        Unit vectors; (1, 0, 0) where nothing turns, because any axis would do.
    angle : ndarray, shape (...)
        Angles in radians, from 0 to 2 pi.

    Raises
    ------
    ValueError
        If an angle is not finite, or if the three do not broadcast.

    See Also
    --------
    rotedu.ordinary_rotation.rotation_matrix : with `homogeneous`, the matrix (4-7).
    rotedu.ordinary_rotation.axis_angle : starts from a matrix.

    Notes
    -----
    (4-5) gives the sine of half the angle, (4-6) its cosine; both are needed, since the sine alone
    cannot tell an angle from the rest of a full turn. (4-3) is 0/0 where nothing turns. There, a
    rotation smaller than the rounding of the three angles themselves counts as none.

    References
    ----------
    Cheng et al. (2023), Eqs. (4-3) to (4-6)

    Examples
    --------
    >>> axis, angle = axis_angle_from_euler_angles(np.pi / 2, 0, np.pi / 2)
    >>> print(axis.round(3), np.degrees(angle).round(3))
    [0.577 0.577 0.577] 120.0

    Three half turns leave everything in place:

    >>> axis, angle = axis_angle_from_euler_angles(np.pi, np.pi, np.pi)
    >>> print(axis, angle)
    [1. 0. 0.] 0.0
    """
    angles = arrays(theta_u=(theta_u, ()), theta_v=(theta_v, ()), theta_w=(theta_w, ()))
    *vector, cosine = quaternion_from_euler_angles(*angles)
    a = np.stack(vector, axis=-1)
    sine = length(a)
    unturned = sine <= _rounding(angles)
    a = a / np.where(unturned, 1, sine)[..., np.newaxis]
    a[unturned] = 1, 0, 0
    return a, np.asarray(2 * np.arctan2(np.where(unturned, 0, sine), cosine))


def homogeneous(matrix: npt.ArrayLike) -> Array:
    """Write a 3x3 matrix as a 4x4 matrix; of a rotation matrix (3-3) it makes (4-7).

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        Matrices for points with three coordinates.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Raises
    ------
    ValueError
        If the matrix is not finite or has the wrong shape.

    Notes
    -----
    A point has the fourth coordinate 1, a direction 0, so that no translation moves it. The paper
    gives the axis of (4-7) a fourth coordinate 1; as a direction it is (a_u, a_v, a_w, 0)
    (erratum E8).

    References
    ----------
    Cheng et al. (2023), Eq. (4-7)

    Examples
    --------
    >>> print(homogeneous([[0, -1, 0], [1, 0, 0], [0, 0, 1]]))
    [[ 0. -1.  0.  0.]
     [ 1.  0.  0.  0.]
     [ 0.  0.  1.  0.]
     [ 0.  0.  0.  1.]]
    """
    (m,) = arrays(matrix=(matrix, (3, 3)))
    return _matrix(*([*row, 0] for row in np.moveaxis(m, (-2, -1), (0, 1))))


def translation(v: npt.ArrayLike) -> Array:
    """Move points by a vector.

    Parameters
    ----------
    v : array_like, shape (..., 3)
        The vector.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Raises
    ------
    ValueError
        If the vector is not finite or has the wrong shape.

    Examples
    --------
    The point (0, 0, 1) moves, the direction (0, 0, 1) does not:

    >>> print(translation([5, 0, 0]) @ [0, 0, 1, 1], translation([5, 0, 0]) @ [0, 0, 1, 0])
    [5. 0. 1. 1.] [0. 0. 1. 0.]
    """
    (vector,) = arrays(v=(v, (3,)))
    u, v, w = np.moveaxis(vector, -1, 0)
    return _matrix([1, 0, 0, u], [0, 1, 0, v], [0, 0, 1, w])


def scaling(s: npt.ArrayLike) -> Array:
    """Stretch or shrink along the axes, leaving the origin in place.

    Parameters
    ----------
    s : array_like, shape () or (..., 3)
        One factor for all three axes, or a factor for each. Negative factors reflect, 0 flattens.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Raises
    ------
    ValueError
        If a factor is not finite, or if `s` has the wrong shape.

    Examples
    --------
    >>> print(scaling([1, 2, 3]) @ [1, 1, 1, 1], scaling(2) @ [1, 1, 1, 1])
    [1. 2. 3. 1.] [2. 2. 2. 1.]
    """
    if np.ndim(s) == 0:
        (factor,) = arrays(s=(s, ()))
        factors = np.broadcast_to(factor, 3)
    else:
        (factors,) = arrays(s=(s, (3,)))
    u, v, w = np.moveaxis(factors, -1, 0)
    return _matrix([u, 0, 0, 0], [0, v, 0, 0], [0, 0, w, 0])


def shearing(
    *,
    uv: npt.ArrayLike = 0,
    uw: npt.ArrayLike = 0,
    vu: npt.ArrayLike = 0,
    vw: npt.ArrayLike = 0,
    wu: npt.ArrayLike = 0,
    wv: npt.ArrayLike = 0,
) -> Array:
    """Add to each coordinate multiples of the other two.

    Parameters
    ----------
    uv, uw, vu, vw, wu, wv : array_like, shape (...), optional
        Entries of the matrix, named by row and column: `uv` times the second coordinate is added
        to the first.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Raises
    ------
    ValueError
        If an argument is not finite, or if they do not broadcast.

    Examples
    --------
    A pile of cards leans towards U, by half of its height along W:

    >>> print(shearing(uw=0.5) @ [0, 0, 10, 1])
    [ 5.  0. 10.  1.]
    """
    given = {"uv": uv, "uw": uw, "vu": vu, "vw": vw, "wu": wu, "wv": wv}
    uv, uw, vu, vw, wu, wv = arrays(**{name: (value, ()) for name, value in given.items()})
    return _matrix([1, uv, uw, 0], [vu, 1, vw, 0], [wu, wv, 1, 0])


def reflection(normal: npt.ArrayLike) -> Array:
    """Reflect points in a plane through the origin.

    Parameters
    ----------
    normal : array_like, shape (..., 3)
        Normal of the plane, of any length but zero.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        Of determinant -1: no rotation does this, and no unit quaternion by q r q*.

    Raises
    ------
    ValueError
        If the normal is not finite, has the wrong shape, or is zero.

    Examples
    --------
    >>> print(reflection([0, 0, 1]) @ [1, 2, 3, 1])
    [ 1.  2. -3.  1.]
    """
    (n,) = arrays(normal=(normal, (3,)))
    nu, nv, nw = np.moveaxis(unit("normal", n), -1, 0)
    return _matrix(
        [1 - 2 * nu * nu, -2 * nu * nv, -2 * nu * nw, 0],
        [-2 * nv * nu, 1 - 2 * nv * nv, -2 * nv * nw, 0],
        [-2 * nw * nu, -2 * nw * nv, 1 - 2 * nw * nw, 0],
    )


def perspective(distance: npt.ArrayLike) -> Array:
    """Show points as an eye on the W axis sees them in the plane w = 0.

    Parameters
    ----------
    distance : array_like, shape (...)
        Where on the W axis the eye is. Points of the plane stay where they are.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        The third coordinate is kept, as depth: what was behind is still behind. Without it, and
        after the division by the fourth, the first two are the picture.

    Raises
    ------
    ValueError
        If the distance is not finite or is zero.

    See Also
    --------
    rotedu.ordinary_rotation.transform : does the division, and refuses points at the eye's depth.

    Notes
    -----
    This is the one transform here that leaves a fourth coordinate other than 1. It can go into
    one matrix with all the others; the division cannot.

    Examples
    --------
    From a distance of 4, what is 4 behind the plane looks half as large:

    >>> print(perspective(4) @ [1, 1, -4, 1])
    [ 1.  1. -4.  2.]
    """
    (d,) = arrays(distance=(distance, ()))
    if d.dtype != object and (d == 0).any():
        raise ValueError(f"distance must not be zero; got 0{place(d == 0)}")
    return _matrix([1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, -1 / d, 1])


def compose(*matrices: npt.ArrayLike) -> Array:
    """Multiply matrices into one: ``compose(a, b, c)`` does c first, then b, then a.

    Parameters
    ----------
    *matrices : array_like, shape (..., 4, 4) or (..., 3, 3)
        As written in an equation, the last one next to the point. Those with three rows are made
        `homogeneous`; the leading axes broadcast.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        The identity, if no matrix is given.

    Raises
    ------
    ValueError
        If a matrix is not finite or has the wrong shape.

    References
    ----------
    Cheng et al. (2023), Section 3, last paragraph; Eq. (4-1)

    Examples
    --------
    A point that is doubled, then moved, is not one that is moved, then doubled:

    >>> print(compose(translation([1, 0, 0]), scaling(2)) @ [1, 1, 1, 1])
    [3. 2. 2. 1.]
    >>> print(compose(scaling(2), translation([1, 0, 0])) @ [1, 1, 1, 1])
    [4. 2. 2. 1.]
    """
    if not matrices:
        return np.eye(4)
    given = {f"matrices[{i}]": (matrix, (3, 3), (4, 4)) for i, matrix in enumerate(matrices)}
    factors = [m if m.shape[-1] == 4 else homogeneous(m) for m in arrays(**given)]
    product: Array = reduce(np.matmul, factors)
    return product.copy() if len(matrices) == 1 else product


def _matrix(*rows: list[Any]) -> Array:
    """Make 4x4 matrices of entries that broadcast; a fourth row not given is (0, 0, 0, 1)."""
    entries = [entry for row in (*rows, [0, 0, 0, 1])[:4] for entry in row]
    varying = [np.asarray(entry) for entry in entries if not isinstance(entry, int)]
    leading = np.broadcast_shapes(*(entry.shape for entry in varying))
    matrix = np.empty((*leading, 16), np.result_type(*varying))
    for i, entry in enumerate(entries):
        matrix[..., i] = entry
    return matrix.reshape(*leading, 4, 4)


def _rounding(angles: list[Array]) -> Any:
    """How far half the rotation may be off because the angles are rounded."""
    if any(theta.dtype == object for theta in angles):
        return 0
    return sum(np.abs(theta) / 2 * np.finfo(theta.dtype).eps for theta in angles)
