"""Beyond the paper, page B: how far rotations are apart, and their mean.

When measurements are averaged, matrices and quaternions have to answer a new question: how far two
rotations are apart.
"""

import numpy as np

from rotedu._arguments import Number, Rotation, Rotations, Weights, checked, place, rounding
from rotedu._vectors import Array, product, transpose
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import axis_angle
from rotedu.orientations import nearest_rotation

__all__ = ["angular_distance", "chordal_distance", "mean_rotation"]


@checked
def angular_distance(r1: Rotation, r2: Rotation) -> Number:
    """Return the angle of the turn that leads from one orientation to another.

    Parameters
    ----------
    r1, r2 : array_like, shape (..., 3, 3)
        Rotation matrices.

    Returns
    -------
    ndarray, shape (...)
        Angles in radians, from 0 to pi.

    Notes
    -----
    With unit quaternions it is ``2 arccos abs(q1 . q2)``. Nothing depends on the frame: for any
    rotations A and B, the distance of A R1 B and A R2 B is that of R1 and R2.

    References
    ----------
    Huynh (2009), "Metrics for 3D rotations: comparison and analysis", Journal of Mathematical
    Imaging and Vision 35, 155-164

    Examples
    --------
    >>> from rotedu.ordinary_rotation import rotation_matrix
    >>> tenth, third = rotation_matrix([1, 2, 2], np.radians([36, 120]))
    >>> print(np.degrees(angular_distance(tenth, third)).round(9))
    84.0
    """
    _, angle = axis_angle(product(transpose(r1), r2))
    return angle


@checked
def chordal_distance(r1: Rotation, r2: Rotation) -> Number:
    """Return the length of the difference of two rotation matrices: its Frobenius norm.

    Parameters
    ----------
    r1, r2 : array_like, shape (..., 3, 3)
        Rotation matrices.

    Returns
    -------
    ndarray, shape (...)
        The square root of the sum of the squared entries of R1 - R2, from 0 to 2 sqrt(2). While
        `angular_distance` is along rotations, this is straight, through other matrices.

    Notes
    -----
    Rotations that differ by an angle theta have the distance ``2 sqrt(2) sin(theta / 2)``.

    References
    ----------
    Huynh (2009), as for `angular_distance`

    Examples
    --------
    >>> print(chordal_distance(np.eye(3), np.diag([1, -1, -1])).round(12))
    2.828427124746
    """
    difference = r1 - r2
    return np.sqrt(np.sum(difference * difference, axis=(0, 1)))


@checked
def mean_rotation(rotations: Rotations, weights: Weights = None) -> Rotation:
    """Return the mean of rotations: the rotation nearest to the mean of their matrices.

    Parameters
    ----------
    rotations : array_like, shape (..., n, 3, 3)
        At least one rotation matrix.
    weights : array_like, shape (..., n), optional
        How much each of them counts: numbers that are not negative and not all zero. Only their
        ratios matter. Without them, all rotations count the same.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        The rotations for which the weighted sum of squared chordal distances is least.

    Raises
    ------
    rotedu.errors.DegenerateError
        If several rotations have the least sum (to half of the digits), as for two that are half
        a turn apart.

    Notes
    -----
    It is Markley's mean of the unit quaternions, the eigenvector of the largest eigenvalue of the
    sum of q q^T, since ``trace(R(p)^T R(q)) = 4 (p . q)^2 - 1``: both maximise the same sum. Three
    singular values take the place of four eigenvalues, and no quaternion has to be made.

    References
    ----------
    Moakher (2002), "Means and averaging in the group of rotations", SIAM Journal on Matrix Analysis
    and Applications 24, 1-16;
    Markley, Cheng, Crassidis and Oshman (2007), "Averaging quaternions", Journal of Guidance,
    Control, and Dynamics 30, 1193-1197

    Examples
    --------
    >>> from rotedu.ordinary_rotation import rotation_matrix
    >>> rotations = rotation_matrix([0, 0, 1], np.radians([170, 190]))
    >>> axis, angle = axis_angle(mean_rotation(rotations))
    >>> print(axis, np.degrees(angle).round(9))
    [0. 0. 1.] 180.0
    """
    if weights is None:
        weights = np.ones(rotations.shape[-1]) / rotations.shape[-1]
    mean = np.sum(weights * rotations, axis=-1)
    refuse_several(mean)
    return nearest_rotation(mean)


def refuse_several(mean: Array) -> None:
    """Refuse a mean matrix to which several rotations are nearest, to half of the digits."""
    matrix = np.moveaxis(mean, (0, 1), (-2, -1))
    s = np.linalg.svd(matrix, compute_uv=False)
    # Nothing is relative to s here: of a matrix that should be zero, rounding errors are left.
    several = s[..., 1] + np.sign(np.linalg.det(matrix)) * s[..., 2] <= rounding(mean) ** 0.5
    if np.any(several):
        raise DegenerateError(f"rotations{place(several)} have several means")
