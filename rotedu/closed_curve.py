"""Section 5, page 5 III: de Casteljau's arcs of arcs, and the closed curve made of them.

Antipodal points, to half of the digits, are refused with a `DegenerateError`, because many arcs
join them.
"""

import warnings
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from rotedu._arguments import ClosedPoints, Control, Count, Fraction, Number, Vector, checked, named
from rotedu._vectors import Array
from rotedu.arcs import angle_between, refuse_antipodal, slerp
from rotedu.control_points import control_points

__all__ = ["closed_curve", "de_casteljau", "de_casteljau_levels"]

# Samples computed together: few enough for the cache, enough to keep NumPy busy.
BLOCK = 8000


@checked
def de_casteljau(control: Control, u: Number) -> Vector:
    """Evaluate a Bezier curve on the unit sphere by arcs of arcs.

    Parameters
    ----------
    control : array_like, shape (..., m + 1, d)
        Control points of a curve of degree m, unit vectors of any dimension.
    u : array_like, shape (...)
        Parameter: 0 gives the first control point, 1 the last. Beyond them the curve goes on.

    Returns
    -------
    ndarray, shape (..., d)
        Unit vectors.

    Raises
    ------
    rotedu.errors.DegenerateError
        If an arc has antipodal ends. For u from 0 to 1 this can happen only between two control
        points, because no later arc is longer than the longest of theirs.

    References
    ----------
    Cheng et al. (2023), Section 5, pseudocode

    Examples
    --------
    >>> de_casteljau([[1, 0, 0], [0, 1, 0], [0, 0, 1]], 1 / 2).round(3)
    array([0.408, 0.816, 0.408])
    """
    (point,) = de_casteljau_levels(control, u)[-1]
    return point


@checked
def de_casteljau_levels(control: Control, u: Number) -> list[Control]:
    """Return all points of de Casteljau's construction, level by level.

    Parameters
    ----------
    control, u : array_like, shapes (..., m + 1, d) and (...)
        Control points and parameter, as for `de_casteljau`, with its error.

    Returns
    -------
    list of ndarray, shapes (..., m + 1, d), (..., m, d) ... (..., 1, d)
        The control points, then the points on the arcs between them, and so on down to the point
        of the curve.

    References
    ----------
    Cheng et al. (2023), Section 5, pseudocode: Q[j][k], with errata E4, E4b and E4c mended

    Examples
    --------
    >>> for level in de_casteljau_levels([[1, 0], [1, 1], [0, 1]], 1 / 2):
    ...     print(np.degrees(np.arctan2(level[:, 1], level[:, 0])).round(3))
    [ 0. 45. 90.]
    [22.5 67.5]
    [45.]
    """
    levels = [list(np.broadcast_arrays(*control, u)[:-1])]
    while len(level := levels[-1]) > 1:
        name = f"points of level {len(levels) - 1}" if len(levels) > 1 else "control"
        for j, (p, q) in enumerate(pairwise(level)):
            refuse_antipodal(angle_between(p, q), f"{name}[{j}] and {name}[{j + 1}]")
        levels.append([slerp(p, q, u) for p, q in pairwise(level)])
    return [np.stack(level) for level in levels]


@checked
def closed_curve(points: ClosedPoints, samples: Count = 100, fraction: Fraction = 1 / 2) -> Vector:
    """Draw a closed composite cubic Bezier curve through points of the unit sphere.

    Parameters
    ----------
    points : array_like, shape (..., n, d)
        At least 3 unit vectors P_0 ... P_{n-1} of any dimension, the first not repeated at the end.
    samples : int
        Number of points on each segment, at u = 0, 1/samples, 2/samples ...
    fraction : float
        As for `rotedu.control_points.control_points`.

    Returns
    -------
    ndarray, shape (..., n * samples, d)
        Unit vectors, starting with P_0 = C_1(0). To within rounding, every ``samples``-th one is a
        given point. The first point is not repeated at the end.

    Raises
    ------
    rotedu.errors.DegenerateError
        As for `rotedu.control_points.control_points`, and if the two inner control points of a
        segment are antipodal.

    Warns
    -----
    UserWarning
        If two such control points are within a degree of antipodal. A small change in the data can
        then move the curve to the other side.

    Notes
    -----
    Segment C_i has the control points P_{i-1}, a_{i-1}, b_i, P_i. The curve is C1, with a
    derivative at P_i of 3 times the tangent vector from P_i to a_i. In general it is neither C2
    nor G2.

    References
    ----------
    Cheng et al. (2023), Section 5, Fig. 8

    Examples
    --------
    >>> curve = closed_curve([[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], samples=2)
    >>> print(np.degrees(np.arctan2(curve[:, 1], curve[:, 0])).round(9) % 360)
    [  0.  45.  90. 135. 180. 225. 270. 315.]
    """
    a, b = control_points(points, fraction)
    next_point, next_b = np.roll(points, -1, axis=-1), np.roll(b, -1, axis=-1)
    pair = "control points a and b between {i} and {j}"
    theta = angle_between(a, next_b)
    refuse_antipodal(theta, pair, "points")
    warn_of_two_ways(theta, pair, "points", "antipodal")
    return sampled(arcs_of_arcs, [points, a, next_b, next_point], samples)


def arcs_of_arcs(level: list[Array], u: Array) -> Array:
    """Evaluate curves by de Casteljau's construction, given their control points."""
    while len(level) > 1:
        level = [slerp(p, q, u) for p, q in pairwise(level)]
    return level[0]


def sampled(
    curve: Callable[[list[Array], Array], Array], parts: list[Array], samples: int
) -> Array:
    """Sample the n segments of a closed curve at u = 0, 1/samples, 2/samples ...

    The parts, of shape (..., n) with components first, are what determines a segment, such as its
    control points: the first parts of all segments, then their second ones, and so on. A value of
    `curve`, which evaluates segments given their parts, has the shape of a first part. The result,
    of shape (..., n * samples), has the samples of one segment after the other.
    """
    first, *_ = parts
    u = np.arange(samples, dtype=first.dtype) / samples
    values = np.empty((*first.shape, samples), first.dtype)
    at_once = max(1, BLOCK // samples)
    for start in range(0, values.shape[-2], at_once):
        segments = slice(start, start + at_once)
        values[..., segments, :] = curve([p[..., segments, np.newaxis] for p in parts], u)
    return values.reshape(*first.shape[:-1], first.shape[-1] * samples)


def warn_of_two_ways(theta: Array, pair: str, sequence: str, apart: str) -> None:
    """Warn of an angle within a degree of pi."""
    nearly = theta >= np.radians(179)
    if np.any(nearly):
        text = f"{named(pair, nearly, sequence)} are almost {apart}"
        warnings.warn(
            f"{text}: a small change in the data moves the curve a lot", UserWarning, stacklevel=4
        )
