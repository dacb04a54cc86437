"""Section 5: arcs on the unit sphere, and the closed curve that is made of them.

The notation is that of the equations: p and q are unit vectors, theta is the angle between them,
and t is the part of the way from p to q. Only the forms with an axis, ``..._by_rotation``, need
three dimensions; all others are right in any number. Of unit vectors with four components, taken
for quaternions, `closed_curve` makes their spline of rotations.

The construction of the curve asks two things of the space it runs in: arcs, and Double. It is
written once, for such a `_Space`, of which there are two: the sphere, and the rotation matrices.

Inside, the components of vectors are on the first axis, not on the last, so that a number for each
vector, such as t or theta, broadcasts against vectors as it is, and numpy adds long rows.
"""

import operator
import warnings
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, SupportsIndex

import numpy as np
import numpy.typing as npt

from rotedu._arguments import Array, arrays, length, place, require_rotation, unit
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import axis_angle, rotation_matrix, transform

__all__ = [
    "angle_between",
    "arc_axis",
    "bisect",
    "bisect_by_rotation",
    "closed_curve",
    "closed_rotation_curve",
    "control_points",
    "de_casteljau",
    "de_casteljau_levels",
    "double",
    "double_by_rotation",
    "slerp",
    "slerp_by_rotation",
    "slerp_rotations",
]

# Numbers of a curve computed together: few enough for the cache, enough to keep numpy busy.
BLOCK = 24 * 1024
# Cosine of an angle so near pi that the sine has lost digits.
NEAR_PI = -0.8

Arc = Callable[[Array, Array, Any], Array]


def angle_between(p: npt.ArrayLike, q: npt.ArrayLike) -> Array:
    """Angle between two vectors, right to the last digits from 0 to pi.

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Vectors of any length but zero.

    Returns
    -------
    ndarray, shape (...)
        Angles in radians, from 0 to pi.

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape, or is zero.

    Notes
    -----
    ``2 * arctan2(abs(q - p), abs(q + p))`` of the unit vectors. The arc cosine of p . q would lose
    half of the digits near 0 and pi, the arc sine of the cross product near pi / 2.

    References
    ----------
    Cheng et al. (2023), Section 5: theta in (5-2) to (5-15)

    Examples
    --------
    >>> print(f"{angle_between([1, 0, 0], [1, 1e-9, 0]):.3e}")
    1.000e-09
    """
    p, q = arrays(p=(p, ("d",)), q=(q, ("d",)))
    p, q = unit("p", p), unit("q", q)
    return np.asarray(2 * np.arctan2(length(q - p), length(q + p)))


def arc_axis(p: npt.ArrayLike, q: npt.ArrayLike) -> Array:
    """Axis about which the arc from p to q turns: the unit vector along p x q (5-1).

    Parameters
    ----------
    p, q : array_like, shape (..., 3)
        Unit vectors.

    Returns
    -------
    ndarray, shape (..., 3)
        Unit vectors. If the angle falls short of 0 or pi by x, rounding of the points turns the
        axis by about 1e-16 / x.

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
    wrong order, which turns the axis round (erratum E2): the arc runs from the reflected point to
    P_{i+1}, and so must the product.

    p x q is computed as half of (p + q) x (q - p), whose factors are at right angles, so that
    nothing cancels.

    References
    ----------
    Cheng et al. (2023), Eqs. (5-1), (5-6), (5-9), (5-12), (5-15)

    Examples
    --------
    >>> print(arc_axis([1, 0, 0], [0, 1, 0]) + 0.0)
    [0. 0. 1.]
    """
    p, q, _ = _arguments(0, 3, p=p, q=q)
    coincident = _length(q - p) <= 4 * _eps(p)
    if np.any(coincident):
        raise DegenerateError(f"p and q coincide: any axis would do{place(coincident)}")
    _require_unique_arc(SPHERE, p, q, "p and q")
    return _components_last(_axis(p, q))


def slerp(p: npt.ArrayLike, q: npt.ArrayLike, t: npt.ArrayLike) -> Array:
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
        Unit vectors. If the angle falls short of pi by x, moving an end by e moves the arc by up
        to e / x; the computation itself adds no more than rounding.

    Raises
    ------
    ValueError
        If an argument is not finite or has the wrong shape, or if p or q is zero.
    rotedu.errors.DegenerateError
        If p and q are antipodal (to half of the digits).

    See Also
    --------
    slerp_by_rotation : the same in the other form (5-3).

    Notes
    -----
    As printed, (5-2) divides by sin(theta): 0/0 where p = q, and off the sphere near pi. With m
    the midpoint of the arc and c the direction of the chord from p to q, which are at right
    angles, the same point is ``cos((t - 1/2) theta) m + sin((t - 1/2) theta) c``, where nothing
    cancels.

    The formula is slerp. The paper says that slerp can have no form with a matrix (erratum E7);
    (5-3) is one.

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
    p, q, t = _arguments(t, p=p, q=q)
    _require_unique_arc(SPHERE, p, q, "p and q")
    return _components_last(_arc(p, q, t))


def slerp_by_rotation(p: npt.ArrayLike, q: npt.ArrayLike, t: npt.ArrayLike) -> Array:
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
    arc : the same in the other form (5-2), about 2.7 times as cheap, in any dimension.

    References
    ----------
    Cheng et al. (2023), Eq. (5-3); its matrix is that of (4-7), not (3-3) (erratum E9)

    Examples
    --------
    >>> slerp_by_rotation([1, 0, 0], [0, 1, 0], 1 / 3).round(3)
    array([0.866, 0.5  , 0.   ])
    """
    p, q, t = _arguments(t, 3, p=p, q=q)
    _require_unique_arc(SPHERE, p, q, "p and q")
    return _arc_by_rotation(p, q, t)


def double(p: npt.ArrayLike, q: npt.ArrayLike) -> Array:
    """Reflect p in q: go on from q for as long as from p to q (5-4), (5-13).

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Unit vectors of any dimension.

    Returns
    -------
    ndarray, shape (..., d)
        Unit vectors: 2 cos(theta) q - p. There is no case without an answer.

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape, or is zero.

    Notes
    -----
    In (5-13) the paper has the operands exchanged, and so computes Double(P_i, a_i), which is the
    point it started from (erratum E3). Its text, and (5-14), have Double(a_i, P_i), as here.

    From p to its reflection it is 2 theta along the great circle; beyond 90 degrees that is not
    the angle between the two (erratum E11).

    References
    ----------
    Cheng et al. (2023), Eqs. (5-4), (5-13)

    Examples
    --------
    >>> double([1, 0, 0], [0.6, 0.8, 0])
    array([-0.28,  0.96,  0.  ])
    """
    p, q, _ = _arguments(p=p, q=q)
    return _components_last(_double(p, q))


def double_by_rotation(p: npt.ArrayLike, q: npt.ArrayLike) -> Array:
    """Reflect p in q: rotate it by 2 theta about the axis from p to q (5-5), (5-14).

    Parameters
    ----------
    p, q : array_like, shape (..., 3)
        Unit vectors.

    Returns
    -------
    ndarray, shape (..., 3)
        Unit vectors; p, where q is p or -p, though there is no axis (5-6).

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape, or is zero.

    See Also
    --------
    double : the same in the other form, in any dimension.

    References
    ----------
    Cheng et al. (2023), Eqs. (5-5) with (5-6), (5-14) with (5-15)

    Examples
    --------
    >>> double_by_rotation([1, 0, 0], [0.6, 0.8, 0]).round(15)
    array([-0.28,  0.96,  0.  ])
    """
    p, q, _ = _arguments(0, 3, p=p, q=q)
    return _arc_by_rotation(p, q, 2)


def bisect(p: npt.ArrayLike, q: npt.ArrayLike) -> Array:
    """Midpoint of the shortest arc from p to q (5-7), (5-10).

    Parameters
    ----------
    p, q : array_like, shape (..., d)
        Unit vectors of any dimension.

    Returns
    -------
    ndarray, shape (..., d)
        Unit vectors: (p + q) / abs(p + q).

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape, or is zero.
    rotedu.errors.DegenerateError
        If p and q are antipodal (to half of the digits).

    Notes
    -----
    The factor of the paper, sin(theta / 2) / sin(theta), is 1 / abs(p + q), and is 0/0 where
    p = q: for equally spaced points of a great circle, always. (As extracted from the paper the
    denominators lack the bar that makes the angle the one between these two points.)

    References
    ----------
    Cheng et al. (2023), Eqs. (5-7), (5-10)

    Examples
    --------
    >>> bisect([1, 0, 0], [0, 1, 0]).round(3)
    array([0.707, 0.707, 0.   ])
    """
    p, q, _ = _arguments(p=p, q=q)
    _require_unique_arc(SPHERE, p, q, "p and q")
    return _components_last(_bisect(p, q))


def bisect_by_rotation(p: npt.ArrayLike, q: npt.ArrayLike) -> Array:
    """Midpoint of the shortest arc: p, rotated by theta / 2 about the axis (5-8), (5-11).

    Parameters
    ----------
    p, q : array_like, shape (..., 3)
        Unit vectors.

    Returns
    -------
    ndarray, shape (..., 3)
        Unit vectors; p, where p = q, though there is no axis (5-9).

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape, or is zero.
    rotedu.errors.DegenerateError
        If p and q are antipodal (to half of the digits).

    See Also
    --------
    bisect : the same in the other form, in any dimension.

    Notes
    -----
    With the axis of (5-9) as the paper has it, (5-8) turns away from P_{i+1} (erratum E2): see
    `arc_axis`.

    References
    ----------
    Cheng et al. (2023), Eqs. (5-8) with (5-9), (5-11) with (5-12)

    Examples
    --------
    >>> bisect_by_rotation([1, 0, 0], [0, 1, 0]).round(3)
    array([0.707, 0.707, 0.   ])
    """
    p, q, _ = _arguments(0, 3, p=p, q=q)
    _require_unique_arc(SPHERE, p, q, "p and q")
    return _arc_by_rotation(p, q, 0.5)


def control_points(points: npt.ArrayLike, fraction: float = 1 / 2) -> tuple[Array, Array]:
    """Control points a_i after, and b_i before, each point of a closed curve.

    Parameters
    ----------
    points : array_like, shape (..., n, d)
        Unit vectors P_0 ... P_{n-1} of any dimension, at least 3, the first not repeated at the
        end (erratum E12): P_n is P_0.
    fraction : float
        How far a_i goes, from 0 to 1, from P_i towards the midpoint: 1/2 is the paper's, which
        bisects; 1/3 is Shoemake's, as quoted by Geier (2021).

    Returns
    -------
    a, b : ndarray, shape (..., n, d)
        a_i = Bisect(P_i, Bisect(Double(P_{i-1}, P_i), P_{i+1})) if the fraction is 1/2, and
        b_i = Double(a_i, P_i).

    Raises
    ------
    ValueError
        If an argument is not finite, has the wrong shape or is out of range, or if a point is
        zero.
    rotedu.errors.DegenerateError
        If two points to be bisected are antipodal (to half of the digits): if P_{i+1} is opposite
        to Double(P_{i-1}, P_i), or if the points go out and back, P_{i+1} = P_{i-1}, and are 90
        degrees or more apart. The message names them.

    Notes
    -----
    Points equally spaced on a great circle, where the printed formulas are 0/0, repeated points,
    and gaps beyond 90 degrees are no exceptions. Where the points go out and back by less than 90
    degrees, a_i = b_i = P_i: the curve stops there.

    Bisect goes the shorter way. On a great circle, with the gaps g_1 and g_2 before and after P_i,
    a_i is at (g_1 + g_2) / 4 from P_i unless abs(g_1 - g_2) > 180 degrees; there it jumps to the
    other side. Near such a jump, data that move a little move a_i a lot.

    References
    ----------
    Cheng et al. (2023), Eqs. (5-4) to (5-15); Geier (2021) for 1/3

    Examples
    --------
    >>> a, b = control_points([[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]])
    >>> print(a[0].round(3), b[0].round(3))
    [0.707 0.707 0.   ] [ 0.707 -0.707  0.   ]
    """
    p, part = _points_and_fraction(points, fraction)
    a, b = _control_points(SPHERE, "points", p, part)
    return _components_last(a), _components_last(b)


def de_casteljau(control: npt.ArrayLike, u: npt.ArrayLike) -> Array:
    """Point of a Bezier curve on the unit sphere, by arcs of arcs.

    Parameters
    ----------
    control : array_like, shape (..., m + 1, d)
        Control points of a curve of degree m, unit vectors of any dimension.
    u : array_like, shape (...)
        Parameter: 0 is the first control point, 1 the last; outside, the curve goes on.

    Returns
    -------
    ndarray, shape (..., d)
        Unit vectors.

    Raises
    ------
    ValueError
        If an argument is not finite or has the wrong shape, or if a control point is zero.
    rotedu.errors.DegenerateError
        If an arc has antipodal ends (to half of the digits). For u from 0 to 1 it can only be an
        arc between control points: the arcs between points on them are no longer than the longest.

    See Also
    --------
    de_casteljau_levels : all points of the construction.

    Notes
    -----
    The pseudocode of the paper computes each level from itself, which is not there yet, instead of
    from the one before (erratum E4), gives the sine of an angle beyond 90 degrees a minus sign
    (E4b), and never computes the angle (E4c).

    References
    ----------
    Cheng et al. (2023), Section 5, pseudocode

    Examples
    --------
    >>> de_casteljau([[1, 0, 0], [0, 1, 0], [0, 0, 1]], 1 / 2).round(3)
    array([0.408, 0.816, 0.408])
    """
    return np.ascontiguousarray(de_casteljau_levels(control, u)[-1][..., 0, :])


def de_casteljau_levels(control: npt.ArrayLike, u: npt.ArrayLike) -> list[Array]:
    """All points of de Casteljau's construction, level by level.

    Parameters
    ----------
    control : array_like, shape (..., m + 1, d)
        Control points of a curve of degree m, unit vectors of any dimension.
    u : array_like, shape (...)
        Parameter.

    Returns
    -------
    list of ndarray, shapes (..., m + 1, d), (..., m, d) ... (..., 1, d)
        The control points, then the points on the arcs between those, and so on to the point of
        the curve.

    Raises
    ------
    ValueError, rotedu.errors.DegenerateError
        As `de_casteljau`.

    References
    ----------
    Cheng et al. (2023), Section 5, pseudocode: Q[j][k]

    Examples
    --------
    >>> for level in de_casteljau_levels([[1, 0], [1, 1], [0, 1]], 1 / 2):
    ...     print(np.degrees(np.arctan2(level[:, 1], level[:, 0])).round(3))
    [ 0. 45. 90.]
    [22.5 67.5]
    [45.]
    """
    control, u = arrays(control=(control, ("m", "d")), u=(u, ()))
    if not control.shape[-2]:
        raise ValueError("control must have one point at least; got none")
    control = unit("control", control)
    axes = max(control.ndim - 2, u.ndim)
    points = np.stack([_components_first(p, axes) for p in np.moveaxis(control, -2, 0)], axis=1)
    shape = np.broadcast_shapes(points.shape[2:], u.shape)

    levels = []
    for k, level in enumerate(_levels(_arc, points, u)):
        name = f"points of level {k}" if k else "control"
        for j in range(level.shape[1] - 1):
            ends = f"{name}[{j}] and {name}[{j + 1}]"
            _require_unique_arc(SPHERE, level[:, j], level[:, j + 1], ends)
        full = np.broadcast_to(level, (*level.shape[:2], *shape))
        levels.append(np.ascontiguousarray(np.moveaxis(full, (1, 0), (-2, -1))))
    return levels


def closed_curve(
    points: npt.ArrayLike, samples: SupportsIndex = 100, fraction: float = 1 / 2
) -> Array:
    """Draw a closed composite cubic Bezier curve through points of the unit sphere.

    Parameters
    ----------
    points : array_like, shape (..., n, d)
        Unit vectors P_0 ... P_{n-1} of any dimension, at least 3, the first not repeated at the
        end (erratum E12).
    samples : int
        Points for each segment, at u = 0, 1/samples, 2/samples ...
    fraction : float
        As for `control_points`.

    Returns
    -------
    ndarray, shape (..., n * samples, d)
        Unit vectors, from P_0 = C_1(0) on. Each ``samples``-th is one of the given points, to
        1e-15; the next would be the first again.

    Raises
    ------
    ValueError, rotedu.errors.DegenerateError
        As `control_points`; also if the two inner control points of a segment are antipodal.

    Warns
    -----
    UserWarning
        If they are within a degree of that: then the curve changes sides when the data move a
        little.

    Notes
    -----
    Segment C_i has the control points P_{i-1}, a_{i-1}, b_i, P_i. The curve is C1, and C'(P_i) is
    3 times the tangent vector from P_i to a_i; it is neither C2 nor, in general, G2.

    References
    ----------
    Cheng et al. (2023), Section 5, Fig. 8

    Examples
    --------
    >>> curve = closed_curve([[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], samples=2)
    >>> print(np.degrees(np.arctan2(curve[:, 1], curve[:, 0])).round(9) % 360)
    [  0.  45.  90. 135. 180. 225. 270. 315.]
    """
    p, part = _points_and_fraction(points, fraction)
    k = _count("samples", samples)
    control = np.stack(_segments(SPHERE, "points", p, part), axis=1)
    dimension, *leading, n = p.shape
    flat = control.reshape(dimension, 4, -1)
    return _bezier(_inner_arc, flat, k).reshape(*leading, n * k, dimension)


def slerp_rotations(r1: npt.ArrayLike, r2: npt.ArrayLike, t: npt.ArrayLike) -> Array:
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
    r1, r2, t = arrays(r1=(r1, (3, 3)), r2=(r2, (3, 3)), t=(t, ()))
    require_rotation("r1", r1)
    require_rotation("r2", r2)
    _require_unique_arc(ROTATIONS, r1, r2, "r1 and r2")
    return _rotation_arc(r1, r2, t)


def closed_rotation_curve(
    rotations: npt.ArrayLike, samples: SupportsIndex = 100, fraction: float = 1 / 2
) -> Array:
    """Draw a closed curve through orientations, as `closed_curve`, with matrices alone.

    Parameters
    ----------
    rotations : array_like, shape (..., n, 3, 3)
        Rotation matrices, at least 3, the first not repeated at the end.
    samples : int
        Orientations for each segment, at u = 0, 1/samples, 2/samples ...
    fraction : float
        As for `control_points`.

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
    The construction is that of the points, with `slerp_rotations` for arcs and, for Double(R1, R2),
    R2 R1^T R2. Where `closed_curve` of quaternions depends on their signs, and needs signs that
    agree all the way round, this has none: a body that turns right round and comes back to where
    it was is as good as any other data.

    Examples
    --------
    >>> quarter_turns = rotation_matrix([0, 0, 1], np.arange(4) * np.pi / 2)
    >>> axis, angle = axis_angle(closed_rotation_curve(quarter_turns, samples=2, fraction=1 / 3))
    >>> print(np.degrees(angle).round(9), axis[5] + 0.0)
    [  0.  45.  90. 135. 180. 135.  90.  45.] [ 0.  0. -1.]
    """
    r, part = arrays(rotations=(rotations, ("n", 3, 3)), fraction=(fraction, ()))
    require_rotation("rotations", r)
    _require_closed("rotations", r.shape[-3], part)
    k = _count("samples", samples)
    control = np.stack(_segments(ROTATIONS, "rotations", r, part))
    *leading, n = r.shape[:-2]
    flat = control.reshape(4, -1, 9).transpose(2, 0, 1)
    return _bezier(_inner_rotation_arc, flat, k).reshape(*leading, n * k, 3, 3)


class _Space(NamedTuple):
    """Where the construction of the curve can run: what Double, Bisect and arcs are there."""

    double: Callable[[Array, Array], Array]
    bisect: Callable[[Array, Array], Array]
    arc: Arc
    cosine: Callable[[Array, Array], Array]
    angle: Callable[[Array, Array], Array]
    # Ends at an angle of pi, to within this function of eps, have no unique arc; they are "apart".
    tolerance: Callable[[float], float]
    apart: str
    # On which axis of an array P_0 ... P_{n-1} follow each other.
    axis: int


def _control_points(space: _Space, name: str, here: Array, fraction: Any) -> tuple[Array, Array]:
    """a_i and b_i of all P_i at once, (5-4) to (5-15)."""
    before, after = (_shifted(space, here, by) for by in (-1, 1))
    reflected = space.double(before, here)
    _require_unique_arc(space, reflected, after, "Double({h}, {i}) and {j}", name)
    middle = space.bisect(reflected, after)
    _require_unique_arc(space, here, middle, "{i} and Bisect(Double({h}, {i}), {j})", name)
    a = space.arc(here, middle, fraction)
    return a, space.double(a, here)


def _segments(space: _Space, name: str, here: Array, fraction: Any) -> tuple[Array, ...]:
    """Control points of all segments at once: P_{i-1}, a_{i-1}, b_i, P_i."""
    a, b = _control_points(space, name, here, fraction)
    next_b, after = (_shifted(space, x, 1) for x in (b, here))
    which = "control points a and b between {i} and {j}"
    _require_unique_arc(space, a, next_b, which, name, warn=True)
    return here, a, next_b, after


def _shifted(space: _Space, sequence: Array, by: int) -> Array:
    """Put the next, or the previous, in the place of each, round the closed sequence."""
    n = sequence.shape[space.axis]
    return np.asarray(sequence.take(np.arange(by, n + by), space.axis, mode="wrap"))


def _levels(arc: Arc, points: Array, u: Array) -> Iterator[Array]:
    """Levels of de Casteljau's construction, from the control points to the one point.

    The points of a level follow each other on axis 1.
    """
    yield points
    while points.shape[1] > 1:
        points = arc(points[:, :-1], points[:, 1:], u)
        yield points


def _bezier(arc: Arc, control: Array, samples: int) -> Array:
    """Evaluate segments at u = 0, 1/samples, 2/samples ..., some segments at a time."""
    components, _, n = control.shape
    u = (np.arange(samples) / samples).astype(control.dtype)
    curve = np.empty((n, samples, components), control.dtype)
    step = max(1, BLOCK // (samples * components))
    for start in range(0, n, step):
        segments = slice(start, start + step)
        *_, points = _levels(arc, control[:, :, segments, np.newaxis], u)
        curve[segments] = points[:, 0].transpose(1, 2, 0)
    return curve


def _arc(p: Array, q: Array, t: Any) -> Array:
    """(5-2), in terms of the midpoint of the arc and the direction of its chord."""
    chord, middle = q - p, _sum(p, q)
    sine, cosine = _length(chord), _length(middle)
    theta = 2 * np.arctan2(sine, cosine)
    turn = (t - 1 / 2) * theta
    point: Array = np.cos(turn) / cosine * middle + np.sin(turn) / _or_one(sine) * chord
    return point


def _inner_arc(p: Array, q: Array, t: Any) -> Array:
    """(5-2) as it is printed, for t from 0 to 1: right to the last digits but near pi.

    A cosine below 1 keeps numbers from 0/0; at such an angle, 1e-8, the weights are 1 - t and t.
    The weight of p, sin((1 - t) theta) / sin(theta), is found from the one of q.
    """
    cosine = _dot(p, q)
    if cosine.dtype != object:
        cosine = np.minimum(cosine, 1 - _eps(p))
    if cosine.min() < NEAR_PI:
        return _arc(p, q, t)
    sin, cos = _sin_cos(t * np.arccos(cosine))
    weight = sin / np.sqrt((1 - cosine) * (1 + cosine))
    point: Array = (cos - cosine * weight) * p + weight * q
    return point


def _double(p: Array, q: Array) -> Array:
    """(5-4), (5-13)."""
    reflected: Array = 2 * _dot(p, q) * q - p
    return reflected


def _bisect(p: Array, q: Array) -> Array:
    """(5-7), (5-10)."""
    middle = _sum(p, q)
    return np.asarray(middle / _length(middle))


def _sum(p: Array, q: Array) -> Array:
    """Add p and q so that the sum is perpendicular to q - p, as it is if they have one length.

    After rounding they differ in length by 1e-16, and near pi, where p + q is short, this would
    turn it a lot.
    """
    total, chord = p + q, q - p
    corrected: Array = total - _dot(total, chord) / 4 * chord
    return corrected


def _angle(p: Array, q: Array) -> Array:
    return np.asarray(2 * np.arctan2(_length(q - p), _length(q + p)))


def _axis(p: Array, q: Array) -> Array:
    """Find the unit vector along p x q, or one at right angles to p where that vanishes."""
    axis = np.cross(q + p, q - p, axis=0)
    lost = _length(axis) <= 8 * _eps(p)
    if np.any(lost):
        shortest = np.argmin(np.abs(p), axis=0)
        other = np.cross(p, np.moveaxis(np.eye(3)[shortest], -1, 0), axis=0)
        axis = np.where(lost, other.astype(p.dtype), axis)
    return np.asarray(axis / _length(axis))


def _arc_by_rotation(p: Array, q: Array, t: Any) -> Array:
    axis, theta = _components_last(_axis(p, q)), _angle(p, q)
    return transform(rotation_matrix(axis, t * theta), _components_last(p))


def _rotation_arc(r1: Array, r2: Array, t: Any) -> Array:
    """R1 Exp(t Log(R1^T R2))."""
    axis, angle = axis_angle(r1.mT @ r2)
    turned: Array = r1 @ rotation_matrix(axis, t * angle)
    return turned


def _inner_rotation_arc(r1: Array, r2: Array, t: Any) -> Array:
    """Exp(t Log(R2 R1^T)) R1 for t from 0 to 1, by (3-1) for the columns of R1.

    The skew part of R2 R1^T is the axis times the sine of the angle; near pi that says little.
    """
    r1, r2 = (r.reshape(3, 3, *r.shape[1:]) for r in (r1, r2))
    turn = np.einsum("ij...,kj...->ik...", r2, r1)
    cosine = (turn[0, 0] + turn[1, 1] + turn[2, 2] - 1) / 2
    if cosine.min() < NEAR_PI:
        first, last = (np.moveaxis(r, (0, 1), (-2, -1)) for r in (r1, r2))
        turned = np.moveaxis(_rotation_arc(first, last, t), (-2, -1), (0, 1))
        return turned.reshape(9, *turned.shape[2:])
    skew = [turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]
    axis = np.stack(skew) / 2
    sine = _length(axis)
    if sine.dtype != object:
        sine = np.maximum(sine, 1e-30)
    sin, cos = _sin_cos(t * np.arctan2(sine, cosine))
    across = _cross(axis, r1)
    inward = _cross(axis, across)
    turned = r1 + sin / sine * across + (1 - cos) / sine / sine * inward
    return turned.reshape(9, *turned.shape[2:])


def _rotation_double(r1: Array, r2: Array) -> Array:
    """R2 R1^T R2."""
    reflected: Array = r2 @ r1.mT @ r2
    return reflected


def _rotation_bisect(r1: Array, r2: Array) -> Array:
    return _rotation_arc(r1, r2, 0.5)


def _rotation_cosine(r1: Array, r2: Array) -> Array:
    """Cosine of the angle from one to the other, from the trace of R1^T R2."""
    return np.asarray(((r1 * r2).sum(axis=(-2, -1)) - 1) / 2)


def _rotation_angle(r1: Array, r2: Array) -> Array:
    return axis_angle(r1.mT @ r2)[1]


def _require_unique_arc(
    space: _Space, p: Array, q: Array, pair: str, name: str = "", warn: bool = False
) -> None:
    """Refuse ends with more than one shortest arc between them; `pair` says which they are.

    In it, {h}, {i} and {j} stand for three neighbours in the sequence `name`.
    """
    if p.dtype == object or q.dtype == object:
        return
    if space.cosine(p, q).min(initial=1) > NEAR_PI:
        return
    missing = np.pi - space.angle(p, q)
    ambiguous = missing <= space.tolerance(_eps(missing))
    if np.any(ambiguous):
        which = _which(pair, name, ambiguous)
        raise DegenerateError(f"{which} are {space.apart}: no unique arc joins them")
    unstable = missing < np.radians(1)
    if warn and np.any(unstable):
        which = _which(pair, name, unstable)
        text = f"{which} are almost {space.apart}: data that move a little move the curve a lot"
        warnings.warn(text, UserWarning, stacklevel=4)


def _which(pair: str, name: str, mask: Array) -> str:
    """Say which pair it is, by the first place where a mask is true."""
    if not name:
        return pair + place(mask)
    *leading, i = (int(k) for k in np.argwhere(mask)[0])
    n = mask.shape[-1]
    places = [", ".join(map(str, [*leading, k % n])) for k in (i - 1, i, i + 1)]
    return pair.format(
        **{letter: f"{name}[{at}]" for letter, at in zip("hij", places, strict=True)}
    )


def _arguments(t: Any = 0, dimension: int | str = "d", **points: Any) -> list[Array]:
    """Make unit vectors, components first, with axes enough to broadcast, and the parameter."""
    shapes = {name: (value, (dimension,)) for name, value in points.items()}
    *vectors, t = arrays(**shapes, t=(t, ()))
    axes = max(t.ndim, *(vector.ndim - 1 for vector in vectors))
    units = [unit(name, vector) for name, vector in zip(points, vectors, strict=True)]
    return [*(_components_first(vector, axes) for vector in units), t]


def _points_and_fraction(points: npt.ArrayLike, fraction: Any) -> tuple[Array, Array]:
    p, fraction = arrays(points=(points, ("n", "d")), fraction=(fraction, ()))
    _require_closed("points", p.shape[-2], fraction)
    return np.moveaxis(unit("points", p), -1, 0), fraction


def _require_closed(name: str, n: int, fraction: Array) -> None:
    if n < 3:
        raise ValueError(f"{name} must be at least 3 to make a closed curve; got {n}")
    if fraction.ndim or not 0 <= fraction <= 1:
        raise ValueError(f"fraction must be one number from 0 to 1; got {fraction}")


def _count(name: str, value: SupportsIndex) -> int:
    try:
        count = operator.index(value)
    except TypeError:
        count = 0
    if count < 1:
        raise ValueError(f"{name} must be a positive integer; got {value!r}")
    return count


def _components_first(vectors: Array, axes: int) -> Array:
    padded = vectors.reshape((1,) * (axes + 1 - vectors.ndim) + vectors.shape)
    return np.moveaxis(padded, -1, 0)


def _components_last(vectors: Array) -> Array:
    return np.ascontiguousarray(np.moveaxis(vectors, 0, -1))


def _dot(p: Array, q: Array) -> Array:
    return np.asarray(np.add.reduce(p * q))


def _cross(p: Array, q: Array) -> Array:
    (u1, v1, w1), (u2, v2, w2) = p, q
    return np.stack([v1 * w2 - w1 * v2, w1 * u2 - u1 * w2, u1 * v2 - v1 * u2])


def _length(vectors: Array) -> Array:
    return np.asarray(np.sqrt(_dot(vectors, vectors)))


def _sin_cos(angle: Array) -> tuple[Array, Array]:
    """Sine and cosine by one tangent; numpy takes several of these at a time, sines one by one."""
    tan = np.tan(angle / 2)
    twice = 2 / (1 + tan * tan)
    return tan * twice, twice - 1


def _or_one(divisor: Array) -> Array:
    return np.where(divisor == 0, 1, divisor)


def _eps(numbers: Array) -> float:
    """Relative rounding of the numbers; none, if they are objects."""
    return 0.0 if numbers.dtype == object else float(np.finfo(numbers.dtype).eps)


SPHERE = _Space(_double, _bisect, _arc, _dot, _angle, np.sqrt, "antipodal", axis=-1)
ROTATIONS = _Space(
    _rotation_double,
    _rotation_bisect,
    _rotation_arc,
    _rotation_cosine,
    _rotation_angle,
    lambda eps: 64 * eps,
    "half a turn apart",
    axis=-3,
)
