"""Section 5, page 5 II: Double, Bisect and the control points, (5-4) to (5-15).

Each step has two forms: a sum of vectors in any dimension, and a rotation in three dimensions.
Antipodal points, to half of the digits, have no midpoint and are refused with a `DegenerateError`.
"""

import numpy as np

from rotedu._arguments import ClosedPoints, Fraction, Unit, Unit3, Vector, checked
from rotedu._vectors import dot, unit
from rotedu.arcs import angle_between, refuse_antipodal, slerp, turn_between
from rotedu.ordinary_rotation import rotation_matrix, transform

__all__ = ["bisect", "bisect_by_rotation", "control_points", "double", "double_by_rotation"]


@checked
def double(p: Unit, q: Unit) -> Vector:
    """Reflect p in q: continue beyond q by the arc from p to q (5-4), (5-13).

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Unit vectors of any dimension.

    Returns
    -------
    ndarray, shape (..., d)
        Unit vectors, 2 cos(theta) q - p. Every pair of points has an answer.

    References
    ----------
    Cheng et al. (2023), Eqs. (5-4), (5-13) with its operands exchanged (erratum E3)

    Examples
    --------
    >>> double([1, 0, 0], [0.6, 0.8, 0])
    array([-0.28,  0.96,  0.  ])
    """
    return 2 * dot(p, q) * q - p


@checked
def double_by_rotation(p: Unit3, q: Unit3) -> Vector:
    """Reflect p in q: rotate it by 2 theta about the axis from p to q (5-5), (5-14).

    Parameters
    ----------
    p, q : array_like, shape (..., 3)
        Unit vectors.

    Returns
    -------
    ndarray, shape (..., 3)
        Unit vectors. Where q is p or -p there is no axis (5-6), and the result is p.

    References
    ----------
    Cheng et al. (2023), Eqs. (5-5) with (5-6), (5-14) with (5-15)

    Examples
    --------
    >>> double_by_rotation([1, 0, 0], [0.6, 0.8, 0]).round(15)
    array([-0.28,  0.96,  0.  ])
    """
    axis, theta = turn_between(p, q)
    return transform(rotation_matrix(axis, 2 * theta), p)


@checked
def bisect(p: Unit, q: Unit) -> Vector:
    """Return the midpoint of the shortest arc from p to q (5-7), (5-10).

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Unit vectors of any dimension.

    Returns
    -------
    ndarray, shape (..., d)
        Unit vectors, (p + q) / abs(p + q).

    Notes
    -----
    The paper's factor, sin(theta / 2) / sin(theta), equals 1 / abs(p + q). It is 0/0 where p = q,
    which always happens for equally spaced points of a great circle.

    Examples
    --------
    >>> bisect([1, 0, 0], [0, 1, 0]).round(3)
    array([0.707, 0.707, 0.   ])
    """
    refuse_antipodal(angle_between(p, q))
    return unit(p + q)


@checked
def bisect_by_rotation(p: Unit3, q: Unit3) -> Vector:
    """Return the midpoint of an arc: p, rotated by theta / 2 about the axis (5-8), (5-11).

    Parameters
    ----------
    p, q : array_like, shape (..., 3)
        Unit vectors.

    Returns
    -------
    ndarray, shape (..., 3)
        Unit vectors. Where p = q there is no axis (5-9), and the result is p.

    References
    ----------
    Cheng et al. (2023), Eqs. (5-8) with (5-9), its axis reversed (erratum E2), (5-11) with (5-12)

    Examples
    --------
    >>> bisect_by_rotation([1, 0, 0], [0, 1, 0]).round(3)
    array([0.707, 0.707, 0.   ])
    """
    axis, theta = turn_between(p, q)
    refuse_antipodal(theta)
    return transform(rotation_matrix(axis, theta / 2), p)


@checked
def control_points(points: ClosedPoints, fraction: Fraction = 1 / 2) -> tuple[Vector, Vector]:
    """Return the control points a_i after and b_i before each point of a closed curve.

    Parameters
    ----------
    points : array_like, shape (..., n, d)
        At least 3 unit vectors P_0 ... P_{n-1} of any dimension. P_n is P_0; do not repeat the
        first point at the end (erratum E12).
    fraction : float
        How far a_i goes from P_i towards the midpoint, from 0 to 1. The paper bisects, which is
        1/2; Shoemake takes 1/3, as quoted by Geier (2021).

    Returns
    -------
    a, b : ndarray, shape (..., n, d)
        For the fraction 1/2, a_i = Bisect(P_i, Bisect(Double(P_{i-1}, P_i), P_{i+1})). For every
        fraction, b_i = Double(a_i, P_i).

    Raises
    ------
    rotedu.errors.DegenerateError
        If two points to be bisected are antipodal. This happens if P_{i+1} is opposite to
        Double(P_{i-1}, P_i), or if the points go out and back, P_{i+1} = P_{i-1}, and are 90
        degrees or more apart. The message names the points.

    Notes
    -----
    Where the points go out and back by less than 90 degrees, a_i = b_i = P_i, and the curve stops
    there for a moment. Bisect takes the shorter arc: on a great circle, with the gaps g_1 and g_2
    before and after P_i, a_i lies (g_1 + g_2) / 4 beyond P_i, unless abs(g_1 - g_2) > 180 degrees,
    where it jumps to the other side. Near such a jump, a small change in the data moves a_i a lot.

    References
    ----------
    Cheng et al. (2023), Eqs. (5-4) to (5-15); Geier (2021) for the fraction 1/3

    Examples
    --------
    >>> a, b = control_points([[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]])
    >>> print(a[0].round(3), b[0].round(3))
    [0.707 0.707 0.   ] [ 0.707 -0.707  0.   ]
    """
    before, after = np.roll(points, 1, axis=-1), np.roll(points, -1, axis=-1)
    reflected = double(before, points)
    refuse_antipodal(angle_between(reflected, after), "Double({h}, {i}) and {j}", "points")
    middle = bisect(reflected, after)
    refuse_antipodal(
        angle_between(points, middle), "{i} and Bisect(Double({h}, {i}), {j})", "points"
    )
    a = slerp(points, middle, fraction)
    return a, double(a, points)
