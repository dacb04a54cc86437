"""Section 5, first part: arcs on the unit sphere, (5-1) to (5-3).

The notation is that of the equations: p and q are unit vectors, theta is the angle between them,
and t is the part of the way from p to q. Only the forms with an axis need three dimensions; all
others work in any number. On unit vectors with four components, read as quaternions, `slerp` is
the one that computer graphics knows.
"""

from __future__ import annotations

import numpy as np

from rotedu._arguments import Number, Unit, Unit3, Vector, checked, named, place
from rotedu._vectors import Array, cross, dot, length, rounding, unit
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import rotation_matrix, transform

__all__ = ["angle_between", "arc_axis", "nlerp", "slerp", "slerp_by_rotation"]


@checked
def angle_between(p: Unit, q: Unit) -> Number:
    """Angle between two vectors.

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Vectors of any length but zero.

    Returns
    -------
    ndarray, shape (...)
        Angles in radians, from 0 to pi, each with an error of about 1e-16.

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape, or is zero.

    Notes
    -----
    The arc cosine of p . q would lose half of the digits near 0 and pi, the arc sine of the cross
    product near pi / 2.

    References
    ----------
    Cheng et al. (2023), Section 5: theta in (5-2) to (5-15)

    Examples
    --------
    >>> print(f"{angle_between([1, 0, 0], [1, 1e-9, 0]):.3e}")
    1.000e-09
    """
    return 2 * np.arctan2(length(q - p), length(q + p))


@checked
def arc_axis(p: Unit3, q: Unit3) -> Vector:
    """Axis about which the arc from p to q turns: the unit vector along p x q (5-1).

    Parameters
    ----------
    p, q : array_like, shape (..., 3)
        Unit vectors.

    Returns
    -------
    ndarray, shape (..., 3)
        Unit vectors. If the angle is within x of 0 or pi, rounding of the points tilts the axis by
        about 1e-16 / x.

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape, or is zero.
    rotedu.errors.DegenerateError
        If p and q coincide (to within rounding) or are antipodal (to half of the digits): then
        many axes would do.

    Notes
    -----
    This is (5-1), (5-6), (5-9), (5-12) and (5-15). In (5-9) the paper has the operands in the
    wrong order, which reverses the axis (erratum E2): the arc runs from the reflected point to
    P_{i+1}, and so must the product.

    References
    ----------
    Cheng et al. (2023), Eqs. (5-1), (5-6), (5-9), (5-12), (5-15)

    Examples
    --------
    >>> print(arc_axis([1, 0, 0], [0, 1, 0]) + 0.0)
    [0. 0. 1.]
    """
    refuse_coincident(p, q)
    refuse_antipodal(angle_between(p, q))
    # This product is twice p x q. Its factors are at right angles, so that nothing cancels.
    return unit(cross(p + q, q - p))


@checked
def slerp(p: Unit, q: Unit, t: Number) -> Vector:
    """Point of the shortest arc from p to q (5-2).

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Unit vectors of any dimension.
    t : array_like, shape (...)
        Part of the way: 0 is p, 1 is q; outside, the great circle goes on.

    Returns
    -------
    ndarray, shape (..., d)
        Unit vectors. If the angle is within x of pi, moving an end by e moves the arc by up to
        e / x; the computation itself adds no more than rounding.

    Raises
    ------
    ValueError
        If an argument is not finite or has the wrong shape, or if p or q is zero.
    rotedu.errors.DegenerateError
        If p and q are antipodal (to half of the digits).

    See Also
    --------
    slerp_by_rotation : the same in the other form (5-3).
    nlerp : along the chord instead.

    Notes
    -----
    As printed, (5-2) divides by sin(theta): 0/0 where p = q, and off the sphere near pi. From the
    midpoint of the arc, m, the way leads along the direction of the chord, c. These two are at
    right angles, so nothing cancels in ``cos((t - 1/2) theta) m + sin((t - 1/2) theta) c``. Cosine
    and sine come from the tangent h of half their angle, which NumPy finds ten times as fast.

    The formula is slerp. The paper says that slerp can have no form with a matrix like (5-3)
    (erratum E7); for points of the sphere (5-3) is one.

    Of two unit quaternions, p and q, the arc turns the short way if p . q is positive. If it is
    negative, take -q, which is the same rotation.

    References
    ----------
    Cheng et al. (2023), Eq. (5-2)

    Examples
    --------
    >>> slerp([1, 0, 0], [0, 1, 0], [0, 1 / 3, 1]).round(3)
    array([[1.   , 0.   , 0.   ],
           [0.866, 0.5  , 0.   ],
           [0.   , 1.   , 0.   ]])
    >>> slerp([1, 0, 0], [-1, 0, 0], 1 / 2)
    Traceback (most recent call last):
        ...
    rotedu.errors.DegenerateError: p and q are antipodal: no unique arc joins them
    """
    chord, middle = q - p, p + q
    # Near pi the middle is short; this keeps it at right angles to the chord in spite of rounding.
    middle = middle - dot(middle, chord) / 4 * chord
    across, along = length(chord), length(middle)
    half = np.arctan2(across, along)
    refuse_antipodal(2 * half)
    h = np.tan((t - 1 / 2) * half)
    square = h * h
    cos, sin = (1 - square) / (1 + square), 2 * h / (1 + square)
    return cos / along * middle + sin / np.where(across == 0, 1, across) * chord


@checked
def slerp_by_rotation(p: Unit3, q: Unit3, t: Number) -> Vector:
    """Point of the shortest arc from p to q: p, rotated by t theta about the axis (5-3).

    Parameters
    ----------
    p, q : array_like, shape (..., 3)
        Unit vectors.
    t : array_like, shape (...)
        Part of the way: 0 is p, 1 is q; outside, the great circle goes on.

    Returns
    -------
    ndarray, shape (..., 3)
        Unit vectors; p, where p = q, though there is no axis (5-1).

    Raises
    ------
    ValueError
        If an argument is not finite or has the wrong shape, or if p or q is zero.
    rotedu.errors.DegenerateError
        If p and q are antipodal (to half of the digits).

    See Also
    --------
    slerp : the same in the other form (5-2), with fewer operations, in any dimension.

    References
    ----------
    Cheng et al. (2023), Eq. (5-3); its matrix is that of (4-7), not (3-3) (erratum E9)

    Examples
    --------
    >>> slerp_by_rotation([1, 0, 0], [0, 1, 0], 1 / 3).round(3)
    array([0.866, 0.5  , 0.   ])
    """
    axis, theta = turn_between(p, q)
    refuse_antipodal(theta)
    return transform(rotation_matrix(axis, t * theta), p)


@checked
def nlerp(p: Unit, q: Unit, t: Number) -> Vector:
    """Point of the chord from p to q, pulled back to the sphere.

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Unit vectors of any dimension.
    t : array_like, shape (...)
        Part of the chord: 0 is p, 1 is q; outside, its line goes on, and on the sphere the points
        approach those of its direction.

    Returns
    -------
    ndarray, shape (..., d)
        Unit vectors on the arc of `slerp`. At t = 0, 1/2 and 1 they are its points; between these
        they are ahead or behind, since the speed is greatest in the middle.

    Raises
    ------
    ValueError
        If an argument is not finite or has the wrong shape, or if p or q is zero.
    rotedu.errors.DegenerateError
        If p and q are antipodal (to half of the digits).

    See Also
    --------
    slerp : at constant speed.

    Notes
    -----
    The paper does not have it; computer graphics calls it normalised linear interpolation.

    Examples
    --------
    A quarter of the way along the chord is less than a quarter of the arc:

    >>> point = nlerp([1, 0, 0], [0, 1, 0], 1 / 4)
    >>> print(np.degrees(angle_between([1, 0, 0], point)).round(1), "of 22.5 degrees")
    18.4 of 22.5 degrees
    """
    refuse_antipodal(angle_between(p, q))
    return unit((1 - t) * p + t * q)


def turn_between(p: Array, q: Array) -> tuple[Array, Array]:
    """Axis (5-1) and angle of the turn from p to q.

    Where p x q vanishes, the axis is zero; then the turn leaves p where it is, as it should.
    """
    return unit(cross(p + q, q - p)), angle_between(p, q)


def refuse_coincident(p: Array, q: Array) -> None:
    """Refuse points that are equal to within rounding."""
    coincident = length(q - p) <= 4 * rounding(p)
    if np.any(coincident):
        raise DegenerateError(f"p and q coincide: any axis would do{place(coincident)}")


def refuse_antipodal(theta: Array, pair: str = "p and q", sequence: str = "") -> None:
    """Refuse an angle of pi, to half of the digits, between the points that `pair` names."""
    refuse_two_ways(theta, rounding(theta) ** 0.5, pair, sequence, "antipodal")


def refuse_two_ways(theta: Array, tolerance: float, pair: str, sequence: str, apart: str) -> None:
    """Refuse an angle of pi, which can be turned either way."""
    if tolerance and (ambiguous := theta >= np.pi - tolerance).any():
        ends = named(pair, ambiguous, sequence)
        raise DegenerateError(f"{ends} are {apart}: no unique arc joins them")
