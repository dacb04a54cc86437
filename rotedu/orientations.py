"""Section 5, fourth part: orientations, interpolated with matrices alone.

A point of the sphere says where a camera looks, not how it is turned about its line of sight. The
curve of Section 5 is made of points; here the same construction runs on rotation matrices.
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
)
from rotedu._vectors import Array, product, rounding, transpose
from rotedu.arcs import refuse_two_ways
from rotedu.closed_curve import sampled, warn_of_two_ways
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import axis_angle, rotation_matrix

__all__ = ["closed_rotation_curve", "nearest_rotation", "slerp_rotations"]


@checked
def slerp_rotations(r1: Rotation, r2: Rotation, t: Number) -> Rotation:
    """Orientation on the shortest way from one to another: R1 Exp(t Log(R1^T R2)).

    Parameters
    ----------
    r1, r2 : array_like, shape (..., 3, 3)
        Rotation matrices.
    t : array_like, shape (...)
        Part of the way: 0 is R1, 1 is R2; outside, the turning goes on.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Rotation matrices.

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape or is no rotation.
    rotedu.errors.DegenerateError
        If R1 and R2 are half a turn apart (to within rounding): then there are two ways.

    Notes
    -----
    R1^T R2 is the turn from R1 to R2; its axis and angle are its logarithm, a part of that angle
    about the same axis the exponential (3-3). This is slerp of quaternions, of which the two signs
    are gone: the way is always the shorter one. The paper promises this and does not give it:
    points on the sphere, which its Section 5 interpolates, are not orientations.

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
    """Draw a closed curve through orientations, as `closed_curve`, with matrices alone.

    Parameters
    ----------
    rotations : array_like, shape (..., n, 3, 3)
        Rotation matrices, at least 3, the first not repeated at the end.
    samples : int
        Orientations for each segment, at u = 0, 1/samples, 2/samples ...
    fraction : float
        As for `rotedu.control_points.control_points`.

    Returns
    -------
    ndarray, shape (..., n * samples, 3, 3)
        Rotation matrices, from the first one given on.

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape or is out of range, or if a matrix is no
        rotation.
    rotedu.errors.DegenerateError
        If two orientations to be joined by an arc are half a turn apart (to within rounding). The
        message names them.

    Warns
    -----
    UserWarning
        If the inner control points of a segment are within a degree of that.

    Notes
    -----
    The construction is that of the points, with `slerp_rotations` for arcs and, for
    Double(R1, R2), R2 R1^T R2. It has no signs to choose: a body that turns right round and comes
    back to where it was is as good as any other data.

    As long as no two orientations that it joins by an arc are more than half a turn apart, this is
    the curve of `rotedu.closed_curve.closed_curve` for quaternions whose signs agree all the way
    round. Beyond that the two differ, or this one does not exist. A quaternion tells a turn by 190
    degrees from one by -170; a matrix does not, and goes the shorter way. About one axis that
    happens where successive turns differ by more than 180 degrees (quaternions: 360).

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
    """Rotation matrix that differs least from a given matrix.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        Any matrices, such as rotations that rounding or averaging has worn.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        The rotations R for which the sum of the squared entries of R - M is least.

    Raises
    ------
    ValueError
        If the matrix is not finite or has the wrong shape.
    rotedu.errors.DegenerateError
        If several rotations are equally near (to half of the digits): if M flattens space to a
        line or a point, or if it reflects and stretches least in more than one direction, as -I.

    Notes
    -----
    With the singular values s1 >= s2 >= s3 of M = U S V^T, the answer is U V^T, or, where that
    reflects, U diag(1, 1, -1) V^T. It is unique as long as s2 + s3 > 0, s3 with a minus sign where
    M reflects.

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
    """Go on from R2 for as far as from R1 to R2: R2 R1^T R2."""
    return product(product(r2, transpose(r1)), r2)


def angle_of_turn(r1: Array, r2: Array) -> Array:
    """Angle of the turn from R1 to R2."""
    _, theta = axis_angle(product(transpose(r1), r2))
    return theta


def refuse_half_turn(theta: Array, pair: str = "r1 and r2", sequence: str = "") -> None:
    """Refuse a turn by pi, to within rounding, between the orientations that `pair` names."""
    refuse_two_ways(theta, 64 * rounding(theta), pair, sequence, APART)
