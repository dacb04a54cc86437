"""Section 5, page 5 IV: orientations, interpolated as turns about axes.

A point of the sphere says where a camera looks, but not how it is turned about its line of sight.
While the curve of Section 5 consists of points, here the same construction runs on the turns
between rotation matrices.
"""

from __future__ import annotations

from itertools import pairwise

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
from rotedu._vectors import Array, axis_and_length, cross, dot, length, product, transpose
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
    quaternions without the choice of sign: the turn is always the shorter one. The longer one, by
    an angle of theta - 2 pi about the same axis, has to be asked for as such. The paper claims
    that ordinary rotation interpolates orientations, too, but gives no formula: its Section 5
    interpolates points on the sphere, which are not orientations.

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
    """Draw a closed curve through orientations with matrices, axes and angles.

    Parameters
    ----------
    rotations : array_like, shape (..., n, 3, 3)
        At least 3 rotation matrices. Do not repeat the first one at the end. Each is reached from
        the one before by the shorter turn.
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
        If two neighbours are half a turn apart (to within rounding), because two turns are
        shortest, or if the route from Double(R_{i-1}, R_i) to R_{i+1} is a whole turn (to half of
        the digits), because its axis is lost. The message names them.

    Warns
    -----
    UserWarning
        If two neighbours are within a degree of half a turn apart. A small change in the data can
        then reverse the turn between them, and so the route.

    Notes
    -----
    The construction is the same as for points, but its arcs are turns, each kept as its axis times
    its angle, from 0 to 360 degrees, and turns in succession become one turn by the half-angle
    rule. The matrices fix the turns between neighbours; everything else follows from these.
    Joining two matrices directly, as `slerp_rotations` does, would take the shorter way instead of
    the route by which they were reached, and another curve wherever that route exceeds half a
    turn.

    As rotations these are the orientations of `rotedu.closed_curve.closed_curve` for quaternions
    whose signs agree. Where the signs cannot agree all the way round, as when a body turns right
    round once, the quaternions close after two rounds, q followed by -q, of which this is the
    first.

    References
    ----------
    Cheng et al. (2023), Section 5 for the construction, Eqs. (4-3) to (4-6) for the half-angle rule

    Examples
    --------
    >>> quarter_turns = rotation_matrix([0, 0, 1], np.arange(4) * np.pi / 2)
    >>> axis, angle = axis_angle(closed_rotation_curve(quarter_turns, samples=2, fraction=1 / 3))
    >>> print(np.degrees(angle).round(9), axis[5] + 0.0)
    [  0.  45.  90. 135. 180. 135.  90.  45.] [ 0.  0. -1.]

    A swing to 100 degrees and back to -100. Double leads to 200, and back from there to 0 is more
    than half a turn. Along that route 100 is the end of the swing.

    >>> swing = rotation_matrix([0, 0, 1], np.radians([0, 100, 0, -100]))
    >>> curve = closed_rotation_curve(swing, samples=2)
    >>> print(np.degrees(np.arctan2(curve[:, 1, 0], curve[:, 0, 0])).round(9) + 0.0)
    [   0.     68.75  100.     68.75    0.    -68.75 -100.    -68.75]
    """
    axis, theta = axis_angle(product(transpose(rotations), np.roll(rotations, -1, axis=-1)))
    refuse_half_turn(theta, "{i} and {j}", "rotations")
    warn_of_two_ways(theta, "{i} and {j}", "rotations", "half a turn apart")
    to_next = theta * axis
    to_here = np.roll(to_next, 1, axis=-1)
    from_double = one_turn(-to_here, to_next)
    refuse_whole_turn(from_double, "Double({h}, {i}) and {j}")
    to_a = fraction * one_turn(to_here, from_double / 2)
    from_next_b = np.roll(to_a, -1, axis=-1)
    between = one_turn(one_turn(-to_a, to_next), -from_next_b)
    return sampled(follow, [rotations, to_a, between, from_next_b], samples)


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


def one_turn(v: Array, w: Array) -> Array:
    """Replace two turns, v and then w about the turned axes, by one: (4-3) to (4-6) for any axes.

    Each is an axis times an angle. With the half angles a and b about the axes n and m, the half
    angle of the one turn has the cosine cos a cos b - sin a sin b n . m, and its axis is that of
    sin a cos b n + cos a sin b m + sin a sin b n x m. It is the product of two unit quaternions in
    other letters, without a choice of sign.
    """
    (n, a), (m, b) = axis_and_length(v / 2), axis_and_length(w / 2)
    cos_a, sin_a, cos_b, sin_b = np.cos(a), np.sin(a), np.cos(b), np.sin(b)
    cos = cos_a * cos_b - sin_a * sin_b * dot(n, m)
    axis, sin = axis_and_length(sin_a * cos_b * n + cos_a * sin_b * m + sin_a * sin_b * cross(n, m))
    return 2 * np.arctan2(sin, cos) * axis


def follow(parts: list[Array], u: Array) -> Array:
    """Go by arcs of arcs from the start of a route, a matrix, along its turns."""
    start, *route = parts
    turn = u * route[0]
    while len(route) > 1:
        route = [one_turn((1 - u) * v, u * w) for v, w in pairwise(route)]
        turn = one_turn(turn, u * route[0])
    return product(start, rotation_matrix(*axis_and_length(turn)))


def refuse_half_turn(theta: Array, pair: str = "r1 and r2", sequence: str = "") -> None:
    """Refuse a turn by pi, to within rounding, between the orientations that `pair` names."""
    refuse_two_ways(theta, 64 * rounding(theta), pair, sequence, "half a turn apart")


def refuse_whole_turn(turn: Array, pair: str) -> None:
    """Refuse a turn by 2 pi, to half of the digits, between the orientations that `pair` names."""
    half = length(turn) / 2
    refuse_two_ways(half, rounding(turn) ** 0.5, pair, "rotations", "a whole turn apart")
