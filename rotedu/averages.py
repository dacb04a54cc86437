"""Beyond the paper, page B: how far rotations are apart, their mean, and two columns for a matrix.

To average measurements, or to learn orientations from data, matrices and quaternions have to answer
new questions: how far two rotations are apart, and which numbers stand for them without a jump.
"""

import numpy as np

from rotedu._arguments import Number, Rotation, Rotations, Unit3, Weights, checked, place, rounding
from rotedu._vectors import Array, cross, dot, length, product, transpose, unit
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import axis_angle
from rotedu.orientations import nearest_rotation

__all__ = ["angular_distance", "chordal_distance", "matrix_from_two_columns", "mean_rotation"]


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
        `angular_distance` is along rotations, this is straight, through matrices that are none.

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
        How much each of them counts: numbers that are not negative, nor all zero. Only their
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


@checked
def matrix_from_two_columns(a: Unit3, b: Unit3) -> Rotation:
    """Make the rotation matrix whose first column is along a, and whose second is towards b.

    Parameters
    ----------
    a, b : array_like, shape (..., 3)
        Vectors that are not parallel; their lengths do not matter. With the first two columns of a
        rotation matrix, that matrix comes back.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Rotation matrices. The columns are the direction of a, that of the part of b perpendicular
        to a, and their cross product.

    Raises
    ------
    rotedu.errors.DegenerateError
        If a and b are parallel (to half of the digits).

    Notes
    -----
    This is the method of Gram and Schmidt. What is along a is taken away from b twice: if the two
    are almost parallel, rounding leaves some of it, and the columns would not be perpendicular.

    References
    ----------
    Zhou, Barnes, Lu, Yang and Li (2019), "On the continuity of rotation representations in neural
    networks", CVPR 2019, 5738-5746

    Examples
    --------
    >>> print(matrix_from_two_columns([0, 2, 0], [1, 7, 0]) + 0.0)
    [[ 0.  1.  0.]
     [ 1.  0.  0.]
     [ 0.  0. -1.]]
    """
    refuse_parallel(a, b)
    across = b - dot(a, b) * a
    second = unit(across - dot(a, across) * a)
    return np.stack(np.broadcast_arrays(a, second, cross(a, second)), axis=1)


def refuse_parallel(a: Array, b: Array) -> None:
    """Refuse unit vectors that are parallel, to half of the digits."""
    parallel = length(cross(a, b)) <= rounding(a) ** 0.5
    if np.any(parallel):
        raise DegenerateError(f"a and b{place(parallel)} are parallel: no unique second column")


def refuse_several(mean: Array) -> None:
    """Refuse a mean matrix to which several rotations are nearest, to half of the digits."""
    matrix = np.moveaxis(mean, (0, 1), (-2, -1))
    s = np.linalg.svd(matrix, compute_uv=False)
    # Nothing is relative to s here: of a matrix that should be zero, rounding errors are left.
    several = s[..., 1] + np.sign(np.linalg.det(matrix)) * s[..., 2] <= rounding(mean) ** 0.5
    if np.any(several):
        raise DegenerateError(f"rotations{place(several)} have several means")
