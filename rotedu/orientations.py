"""Section 5, page 5 IV: orientations, interpolated as turns about axes.

A point of the sphere says where a camera looks, but not how it is turned about its line of sight.
An arc between two orientations is a turn, which leads from one matrix to the other.
"""

import numpy as np

from rotedu._arguments import Matrix3, Number, Rotation, checked, place, rounding
from rotedu._vectors import Array, product, transpose
from rotedu.arcs import refuse_two_ways
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import axis_angle, rotation_matrix

__all__ = [
    "nearest_rotation",
    "slerp_rotations",
]


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
    rotedu.errors.DegenerateError
        If R1 and R2 are half a turn apart (to within rounding), because two turns are shortest.

    Notes
    -----
    R1^T R2 is the turn from R1 to R2, and its axis and angle are its logarithm. The result is slerp
    of quaternions without the choice of sign: the turn is always the shorter one.

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
    rotedu.errors.DegenerateError
        If several rotations are equally near (to half of the digits): if M flattens space to a
        line or a point, or if it reflects and its smallest singular value is repeated, as for -I.

    Notes
    -----
    With M = U S V^T, the answer is U V^T or, if that reflects, U diag(1, 1, -1) V^T.

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


def refuse_half_turn(theta: Array, pair: str = "r1 and r2", sequence: str = "") -> None:
    """Refuse a turn by pi, to within rounding, between the orientations that `pair` names."""
    refuse_two_ways(theta, 64 * rounding(theta), pair, sequence, "half a turn apart")
