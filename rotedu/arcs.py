"""Section 5, page 5 I: arcs on the unit sphere, (5-1) to (5-3).

The notation follows the equations: p and q are unit vectors, theta is the angle between them, and
t is the fraction of the arc from p to q. Only the forms with an axis need three dimensions; the
others work in any number of dimensions. For unit vectors with four components, read as quaternions,
`slerp` is the slerp of computer graphics.

Antipodal points, to half of the digits, are refused with a `DegenerateError`, because many arcs
join them.
"""

import numpy as np

from rotedu._arguments import (
    Number,
    Rotation,
    Unit,
    Unit3,
    Vector,
    checked,
    named,
    place,
    rounding,
)
from rotedu._vectors import Array, cross, dot, length, product, unit
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import rotation_matrix, transform

__all__ = ["angle_between", "arc_axis", "nlerp", "rotation_between", "slerp", "slerp_by_rotation"]


@checked
def angle_between(p: Unit, q: Unit) -> Number:
    """Return the angle between two vectors.

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Vectors of any length but zero.

    Returns
    -------
    ndarray, shape (...)
        Angles in radians, from 0 to pi. In float64 the error stays below 1e-15.

    Notes
    -----
    The arc cosine of p . q would lose half of the digits near 0 and pi, and the arc sine of
    abs(p x q) would lose them near pi / 2.

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
    """Return the axis of the arc from p to q, the unit vector along p x q (5-1).

    Parameters
    ----------
    p, q : array_like, shape (..., 3)
        Unit vectors.

    Returns
    -------
    ndarray, shape (..., 3)
        Unit vectors. If the angle is within x of 0 or pi, the rounding of the points tilts the
        axis by about 1e-16 / x.

    Raises
    ------
    rotedu.errors.DegenerateError
        If p and q coincide (to within rounding) or are antipodal, because many axes would do.

    References
    ----------
    Cheng et al. (2023), Eqs. (5-1), (5-6), (5-9) with its operands exchanged (erratum E2), (5-12),
    (5-15)

    Examples
    --------
    >>> print(arc_axis([1, 0, 0], [0, 1, 0]) + 0.0)
    [0. 0. 1.]
    """
    refuse_coincident(p, q)
    refuse_antipodal(angle_between(p, q))
    # Twice p x q, but of factors at right angles, so that nothing cancels.
    return unit(cross(p + q, q - p))


@checked
def slerp(p: Unit, q: Unit, t: Number) -> Vector:
    """Return a point of the shortest arc from p to q (5-2).

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Unit vectors of any dimension.
    t : array_like, shape (...)
        Fraction of the arc: 0 gives p, 1 gives q. Beyond them the point follows the great circle.

    Returns
    -------
    ndarray, shape (..., d)
        Unit vectors. If the angle is within x of pi, moving an end by e moves the arc by up to
        e / x. The computation itself adds only rounding.

    Notes
    -----
    As printed, (5-2) divides by sin(theta), so it is 0/0 where p = q and leaves the sphere near pi.
    The code combines m, the midpoint of the arc, with c, the direction of the chord:
    ``cos((t - 1/2) theta) m + sin((t - 1/2) theta) c``. Since m and c are perpendicular, nothing
    cancels.

    If p and q are unit quaternions, the arc is the shorter turn as long as p . q is positive; if it
    is negative, use -q, which is the same rotation.

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
    # Near pi, where the chord is 2, rounding tilts the short middle; undo it.
    middle = middle - dot(middle, chord) / 4 * chord
    across, along = length(chord), length(middle)
    theta = 2 * np.arctan2(across, along)
    refuse_antipodal(theta)
    m, c = middle / along, chord / np.where(across == 0, 1, across)
    alpha = (t - 1 / 2) * theta
    return np.cos(alpha) * m + np.sin(alpha) * c


@checked
def slerp_by_rotation(p: Unit3, q: Unit3, t: Number) -> Vector:
    """Return a point of the shortest arc: p, rotated by t theta about the axis (5-3).

    Parameters
    ----------
    p, q : array_like, shape (..., 3)
        Unit vectors.
    t : array_like, shape (...)
        Fraction of the arc, as for `slerp`, which gives the same point with fewer operations.

    Returns
    -------
    ndarray, shape (..., 3)
        Unit vectors. Where p = q there is no axis (5-1), and the result is p.

    References
    ----------
    Cheng et al. (2023), Eq. (5-3), whose matrix is (4-7), not (3-3) (erratum E9)

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
    """Return a point of the chord from p to q, projected: normalised linear interpolation.

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Unit vectors of any dimension.
    t : array_like, shape (...)
        Fraction of the chord: 0 gives p, 1 gives q. Beyond them the line goes on, and the result
        loses as many digits as t has.

    Returns
    -------
    ndarray, shape (..., d)
        Unit vectors on the great circle of `slerp`, which moves at constant speed. At t = 0, 1/2
        and 1 both agree. Here the speed is greatest in the middle, so `nlerp` is behind before
        t = 1/2 and ahead after it.

    Examples
    --------
    A quarter of the chord covers less than a quarter of the arc:

    >>> point = nlerp([1, 0, 0], [0, 1, 0], 1 / 4)
    >>> print(np.degrees(angle_between([1, 0, 0], point)).round(1), "of 22.5 degrees")
    18.4 of 22.5 degrees
    """
    refuse_antipodal(angle_between(p, q))
    return unit((1 - t) * p + t * q)


@checked
def rotation_between(a: Unit3, b: Unit3, axis: Unit3 = None) -> Rotation:  # type: ignore[assignment]
    """Return the smallest rotation that takes a direction to another.

    Parameters
    ----------
    a, b : array_like, shape (..., 3)
        Unit vectors.
    axis : array_like, shape (..., 3), optional
        What to turn about where a and b are opposite (to half of the digits): the part of it that
        is across a.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Rotation matrices R, with R a = b and no turn about b besides.

    Raises
    ------
    rotedu.errors.DegenerateError
        If a and b are opposite and no axis is given, or one that is along a.

    Notes
    -----
    With v = a x b and c = a . b it is ``c I + [v] + v v^T / (1 + c)``. No angle is needed, and
    ``abs(a + b)^2 / 2`` in place of 1 + c keeps its digits near opposite directions.

    References
    ----------
    Möller and Hughes (1999), "Efficiently building a matrix to rotate one vector to another",
    Journal of Graphics Tools 4(4), 1-4

    Examples
    --------
    >>> print(rotation_between([1, 0, 0], [0, 1, 0]))
    [[ 0. -1.  0.]
     [ 1.  0.  0.]
     [ 0.  0.  1.]]
    >>> print(rotation_between([1, 0, 0], [-1, 0, 0], axis=[5, 0, 1]) + 0.0)
    [[-1.  0.  0.]
     [ 0. -1.  0.]
     [ 0.  0.  1.]]
    """
    opposite = angle_between(a, b) >= np.pi - rounding(a) ** 0.5
    if axis is None:
        refuse_antipodal(angle_between(a, b), "a and b")
        return smallest_turn(a, b)
    across = axis - dot(axis, a) * a
    along = opposite & (length(across) <= rounding(a) ** 0.5)
    if np.any(along):
        raise DegenerateError(f"axis{place(along)} is along a: it leaves open how to turn to -a")
    n = unit(across)
    half_turn = 2 * n[:, np.newaxis] * n - identity(n)
    turn = smallest_turn(np.where(opposite, -a, a), b)
    return np.where(opposite, product(turn, half_turn), turn)


def smallest_turn(a: Array, b: Array) -> Array:
    """Return the smallest rotation that takes a to b, which are not opposite."""
    chord, middle = b - a, a + b
    # As in `slerp`: near pi rounding tilts the short middle.
    middle = middle - dot(middle, chord) / 4 * chord
    vu, vv, vw = v = cross(middle, chord) / 2
    skew = np.stack(np.broadcast_arrays(0 * vu, -vw, vv, vw, 0 * vu, -vu, -vv, vu, 0 * vu))
    cos = 1 - dot(chord, chord) / 2
    symmetric = v[:, np.newaxis] * v / (dot(middle, middle) / 2)
    return cos * identity(v) + skew.reshape(symmetric.shape) + symmetric


def identity(v: Array) -> Array:
    """Return the identity matrix, with as many axes as vectors v have."""
    return np.eye(3, dtype=v.dtype).reshape(3, 3, *(1,) * (v.ndim - 1))


def turn_between(p: Array, q: Array) -> tuple[Array, Array]:
    """Return the axis (5-1) and the angle of the turn from p to q.

    Where p x q vanishes, the axis is zero, and the turn leaves p in place, as it should.
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
    """Refuse an angle of pi, because the turn could go either way."""
    if tolerance and (ambiguous := theta >= np.pi - tolerance).any():
        ends = named(pair, ambiguous, sequence)
        raise DegenerateError(f"{ends} are {apart}: no unique arc joins them")
