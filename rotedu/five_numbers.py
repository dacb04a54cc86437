"""Beyond the paper, page D: how few numbers stand for a rotation without a break.

Two columns of a matrix are six numbers, and nothing jumps from a matrix to them and back. They lie
on a sphere, and a map of this sphere takes five.
"""

import numpy as np

from rotedu._arguments import Five, Rotation, Unit3, Vector, checked, place, rounding
from rotedu._vectors import Array, axis_and_length, cross, dot, length, safe_length, unit
from rotedu.errors import DegenerateError

__all__ = ["five_numbers", "matrix_from_five_numbers", "matrix_from_two_columns"]

RADIUS = 2**0.5
"""Radius of the sphere of two columns of length 1."""


@checked
def five_numbers(rotation: Rotation) -> Vector:
    """Return five numbers that change continuously with a rotation.

    Parameters
    ----------
    rotation : array_like, shape (..., 3, 3)
        Rotation matrices.

    Returns
    -------
    ndarray, shape (..., 5)
        The first two columns, a and b, on a map: (a_2, a_3, b_1, b_2, b_3) / (sqrt(2) - a_1).

    Notes
    -----
    The six entries of a and b lie on a sphere of radius sqrt(2). The map is its stereographic
    projection from the point (sqrt(2), 0, 0, 0, 0, 0), to which no rotation belongs, because a_1 is
    never more than 1. So the denominator is at least 0.41, and nothing jumps.

    References
    ----------
    Stuelpnagel (1964), "On the parametrization of the three-dimensional rotation group", SIAM
    Review 6, 422-430; Zhou et al. (2019), as for `matrix_from_two_columns`

    Examples
    --------
    >>> print(five_numbers(np.eye(3)).round(4))
    [0.     0.     0.     2.4142 0.    ]
    """
    a, b = rotation[:, 0], rotation[:, 1]
    return np.concatenate([a[1:], b]) / (RADIUS - a[0])


@checked
def matrix_from_five_numbers(numbers: Five) -> Rotation:
    """Return the rotation of five numbers, even of those that belong to no rotation exactly.

    Parameters
    ----------
    numbers : array_like, shape (..., 5)
        Numbers as `five_numbers` returns them, or others.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Rotation matrices, made from the two columns as `matrix_from_two_columns` does.

    Raises
    ------
    rotedu.errors.DegenerateError
        If the two columns are parallel (to half of the digits), or one of them is zero.

    Notes
    -----
    The column a is along (abs(x)^2 - 1, 2 x_1, 2 x_2), and b along (x_3, x_4, x_5). Large numbers
    are scaled, so that no square overflows.

    Examples
    --------
    >>> print(matrix_from_five_numbers([0, 0, 0, 2.4142, 0]).round(3) + 0.0)
    [[1. 0. 0.]
     [0. 1. 0.]
     [0. 0. 1.]]
    """
    share = 1 / np.maximum(1, safe_length(numbers))
    x = share * numbers
    a, size = axis_and_length(np.stack([dot(x, x) - share**2, *(2 * share * x[:2])]))
    b, other = axis_and_length(x[2:])
    # A zero vector is parallel to all.
    refuse_parallel(a, np.where((size == 0) | (other == 0), a, b), "the two columns of numbers")
    return matrix_from_two_columns(a, b)


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


def refuse_parallel(a: Array, b: Array, columns: str = "a and b") -> None:
    """Refuse unit vectors that are parallel, to half of the digits."""
    parallel = length(cross(a, b)) <= rounding(a) ** 0.5
    if np.any(parallel):
        raise DegenerateError(f"{columns}{place(parallel)} are parallel: no unique second column")
