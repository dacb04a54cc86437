"""Section 5, fourth part: orientations, interpolated with matrices alone.

A point of the sphere says where a camera looks, but not how it is turned about its line of sight.
The curve of Section 5 consists of points; here the same construction runs on rotation matrices.
"""

from __future__ import annotations

import numpy as np

from rotedu._arguments import (
    ClosedRotations,
    Count,
    Fraction,
    Matrix3,
    Number,
    Rotation,
    checked,
    place,
    rounding,
)
from rotedu._vectors import Array, product, transpose
from rotedu.arcs import refuse_two_ways
from rotedu.closed_curve import sampled, warn_of_two_ways
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import axis_angle, rotation_matrix

__all__ = ["closed_rotation_curve", "nearest_rotation", "slerp_rotations"]


@checked
def slerp_rotations(r1: Rotation, r2: Rotation, t: Number) -> Rotation:
    """Return an orientation on the shortest turn from R1 to R2: R1 Exp(t Log(R1^T R2)).

    Parameters
    ----------
    r1, r2 : array_like, shape (..., 3, 3)
        Rotation matrices.
    t : array_like, shape (...)
        Fraction of the turn: 0 gives R1, 1 gives R2. Beyond them the turn goes on.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Rotation matrices.

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape or is not a rotation.
    rotedu.errors.DegenerateError
        If R1 and R2 are half a turn apart (to within rounding), because two turns are shortest.

    Notes
    -----
    R1^T R2 is the turn from R1 to R2, and its axis and angle are its logarithm. The exponential
    (3-3) of the same axis and a fraction of the angle is part of that turn. The result is slerp of
    quaternions without the choice of sign: the turn is always the shorter one. The paper claims
    this but gives no formula; its Section 5 interpolates points on the sphere, which are not
    orientations.

    References
    ----------
    Cheng et al. (2023), abstract and Section 6, for the claim

    Examples
    --------
    >>> turns = slerp_rotations(np.eye(3), rotation_matrix([1, 1, 1], np.pi / 2), [0, 1 / 3, 1])
    >>> axis, angle = axis_angle(turns)
    >>> print(axis[1].round(3), np.degrees(angle).round(9))
    [0.577 0.577 0.577] [ 0. 30. 90.]
    """
    axis, theta = axis_angle(product(transpose(r1), r2))
    refuse_half_turn(theta)
    return product(r1, rotation_matrix(axis, t * theta))


@checked
def closed_rotation_curve(
    rotations: ClosedRotations, samples: Count = 100, fraction: Fraction = 1 / 2
) -> Rotation:
    """Draw a closed curve through orientations with matrices alone.

    Parameters
    ----------
    rotations : array_like, shape (..., n, 3, 3)
        At least 3 rotation matrices. Do not repeat the first one at the end.
    samples : int
        Number of orientations on each segment, at u = 0, 1/samples, 2/samples ...
    fraction : float
        As for `rotedu.control_points.control_points`.

    Returns
    -------
    ndarray, shape (..., n * samples, 3, 3)
        Rotation matrices, starting with the first given one.

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape or is out of range, or if a matrix is
        not a rotation.
    rotedu.errors.DegenerateError
        If two orientations to be joined by an arc are half a turn apart (to within rounding). The
        message names them.

    Warns
    -----
    UserWarning
        If the inner control points of a segment are within a degree of half a turn apart.

    Notes
    -----
    The construction is the same as for points, with `slerp_rotations` for the arcs and
    Double(R1, R2) = R2 R1^T R2. It has no signs to choose, so a body may turn right round and come
    back to where it was.

    Compare this curve with `rotedu.closed_curve.closed_curve` for quaternions whose signs agree all
    the way round. The two are the same as long as no arc of the quaternions turns by more than half
    a turn. Otherwise they differ, or this one does not exist. A quaternion distinguishes a turn
    by 190 degrees from a turn by -170 degrees; a matrix does not, and takes the shorter one. For
    turns about one axis this happens where successive turns differ by more than 180 degrees (for
    quaternions, 360).

    Examples
    --------
    >>> quarter_turns = rotation_matrix([0, 0, 1], np.arange(4) * np.pi / 2)
    >>> axis, angle = axis_angle(closed_rotation_curve(quarter_turns, samples=2, fraction=1 / 3))
    >>> print(np.degrees(angle).round(9), axis[5] + 0.0)
    [  0.  45.  90. 135. 180. 135.  90.  45.] [ 0.  0. -1.]
    """
    before, after = np.roll(rotations, 1, axis=-1), np.roll(rotations, -1, axis=-1)
    reflected = double_rotations(before, rotations)
    refuse_half_turn(angle_of_turn(reflected, after), "Double({h}, {i}) and {j}", "rotations")
    middle = slerp_rotations(reflected, after, 1 / 2)
    refuse_half_turn(
        angle_of_turn(rotations, middle), "{i} and Bisect(Double({h}, {i}), {j})", "rotations"
    )
    a = slerp_rotations(rotations, middle, fraction)
    next_b = np.roll(double_rotations(a, rotations), -1, axis=-1)
    handles = "control points a and b between {i} and {j}"
    theta = angle_of_turn(a, next_b)
    refuse_half_turn(theta, handles, "rotations")
    warn_of_two_ways(theta, handles, "rotations", APART)
    return sampled(slerp_rotations, [rotations, a, next_b, after], samples)


@checked
def nearest_rotation(matrix: Matrix3) -> Rotation:
    """Return the rotation matrix that differs least from a given matrix.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        Any matrices, such as rotations spoilt by rounding or averaging.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        The rotations R that minimise the sum of the squared entries of R - M.

    Raises
    ------
    ValueError
        If the matrix is not finite or has the wrong shape.
    rotedu.errors.DegenerateError
        If several rotations are equally near (to half of the digits). This happens if M flattens
        space to a line or a point, or if M reflects and its smallest singular value is repeated,
        as for -I.

    Notes
    -----
    Let s1 >= s2 >= s3 be the singular values of M = U S V^T. The answer is U V^T or, if that
    reflects, U diag(1, 1, -1) V^T. It is unique if s2 + s3 > 0, or s2 - s3 > 0 if M reflects.

    References
    ----------
    Kabsch (1978), "A discussion of the solution for the best rotation to relate two sets of
    vectors", Acta Crystallographica A34, 827-828

    Examples
    --------
    >>> worn = rotation_matrix([0, 0, 1], np.pi / 2) + 0.01 * np.eye(3)
    >>> print(nearest_rotation(worn).round(3))
    [[ 0.01 -1.    0.  ]
     [ 1.    0.01  0.  ]
     [ 0.    0.    1.  ]]
    """
    u, s, vt = np.linalg.svd(np.moveaxis(matrix, (0, 1), (-2, -1)))
    u[..., :, 2] *= (sign := np.sign(np.linalg.det(u @ vt)))[..., np.newaxis]
    several = s[..., 1] + sign * s[..., 2] <= rounding(s) ** 0.5 * s[..., 0]
    if np.any(several):
        raise DegenerateError(f"matrix{place(several)} has several nearest rotations")
    return np.moveaxis(u @ vt, (-2, -1), (0, 1))


APART = "half a turn apart"


def double_rotations(r1: Array, r2: Array) -> Array:
    """Continue beyond R2 by the turn from R1 to R2: R2 R1^T R2."""
    return product(product(r2, transpose(r1)), r2)


def angle_of_turn(r1: Array, r2: Array) -> Array:
    """Return the angle of the turn from R1 to R2."""
    _, theta = axis_angle(product(transpose(r1), r2))
    return theta


def refuse_half_turn(theta: Array, pair: str = "r1 and r2", sequence: str = "") -> None:
    """Refuse a turn by pi, to within rounding, between the orientations that `pair` names."""
    refuse_two_ways(theta, 64 * rounding(theta), pair, sequence, APART)
