"""Beyond Section 5, page 5 V: closed curves of orientations.

The construction of Section 5 consists of points. Here it runs on the turns between rotation
matrices. Two other curves through orientations stand beside it for comparison.
"""

from itertools import pairwise

import numpy as np

from rotedu._arguments import (
    ClosedPoints,
    ClosedRotations,
    ClosedValues,
    Count,
    Fraction,
    Rotation,
    Vector,
    checked,
    rounding,
)
from rotedu._vectors import Array, axis_and_length, cross, dot, length, product, transpose, unit
from rotedu.arcs import angle_between, refuse_antipodal, refuse_two_ways, slerp
from rotedu.closed_curve import sampled, warn_of_two_ways
from rotedu.ordinary_rotation import axis_angle, rotation_matrix
from rotedu.orientations import refuse_half_turn

__all__ = ["closed_rotation_curve", "periodic_spline", "squad"]


@checked
def closed_rotation_curve(
    rotations: ClosedRotations,
    samples: Count = 100,
    fraction: Fraction = 1 / 2,
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
    Joining two matrices directly, as `rotedu.orientations.slerp_rotations` does, would lead to
    another curve wherever the route by which they were reached exceeds half a turn, as in a swing
    to 100 degrees and back.

    As rotations these are the orientations of `rotedu.closed_curve.closed_curve` for quaternions
    whose signs agree. Where they cannot agree all the way round, as when a body turns right round
    once, the quaternions close after two rounds, q followed by -q, of which this is the first.

    References
    ----------
    Cheng et al. (2023), Section 5 for the construction, Eqs. (4-3) to (4-6) for the half-angle rule

    Examples
    --------
    >>> quarter_turns = rotation_matrix([0, 0, 1], np.arange(4) * np.pi / 2)
    >>> axis, angle = axis_angle(closed_rotation_curve(quarter_turns, samples=2, fraction=1 / 3))
    >>> print(np.degrees(angle).round(9), axis[5] + 0.0)
    [  0.  45.  90. 135. 180. 135.  90.  45.] [ 0.  0. -1.]
    """
    after = np.roll(rotations, -1, axis=-1)
    axis, theta = axis_angle(product(transpose(rotations), after))
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
def squad(quaternions: ClosedPoints, samples: Count = 100) -> Vector:
    """Draw Shoemake's closed curve through quaternions by three arcs for each point.

    Parameters
    ----------
    quaternions : array_like, shape (..., n, d)
        At least 3 unit vectors q_0 ... q_{n-1} of any dimension; with four components, quaternions.
        The signs count: each is reached from the one before by the arc of `rotedu.arcs.slerp`. Do
        not repeat the first one at the end.
    samples : int
        Number of points on each segment, as for `closed_rotation_curve`.

    Returns
    -------
    ndarray, shape (..., n * samples, d)
        Unit vectors, starting with the first given one.

    Raises
    ------
    rotedu.errors.DegenerateError
        If an arc has antipodal ends (to half of the digits).

    Notes
    -----
    The curve follows the arc from q_i to q_{i+1}, and is drawn by 2u(1 - u) towards the arc from
    s_i to s_{i+1}. For quaternions,

        s_i = q_i exp(-(log(q_i* q_{i+1}) + log(q_i* q_{i-1})) / 4).

    Here q_i log(q_i* p) is written as the tangent vector that leads from q_i to p, for which no
    quaternion is needed. The curve is C1: its derivative at q_i is half the tangent vector that
    leads to q_{i+1} minus half the one that leads to q_{i-1}. In general it is not C2, as
    `periodic_spline` is.

    References
    ----------
    Shoemake (1987), "Quaternion calculus and fast animation", SIGGRAPH course notes 10, 101-121,
    as Dam et al. (1998), "Quaternions, interpolation and animation", give it

    Examples
    --------
    >>> quarter_turns = np.radians(np.arange(8) * 45)
    >>> q = np.stack([np.cos(quarter_turns), *np.zeros((2, 8)), np.sin(quarter_turns)], axis=-1)
    >>> w, x, y, z = squad(q, samples=2).T
    >>> print(np.degrees(2 * np.arctan2(z, w))[:5].round(9) + 0.0)
    [  0.  45.  90. 135. 180.]
    """
    q, before, after = quaternions, np.roll(quaternions, 1, -1), np.roll(quaternions, -1, -1)
    refuse_antipodal(angle_between(q, after), "{i} and {j}", "quaternions")
    s = onward(q, -(towards(q, after) + towards(q, before)) / 4)
    next_s = np.roll(s, -1, axis=-1)
    refuse_antipodal(angle_between(s, next_s), "points s of {i} and {j}", "quaternions")
    return sampled(arc_towards_arc, [q, s, next_s, after], samples)


@checked
def periodic_spline(values: ClosedValues, samples: Count = 100) -> Vector:
    """Draw the closed cubic curve through values that has no jump of acceleration.

    Parameters
    ----------
    values : array_like, shape (..., n, d)
        At least 3 points of any dimension, also the entries of quaternions or matrices in a row.
        Do not repeat the first one at the end.
    samples : int
        Number of points on each segment, as for `closed_rotation_curve`.

    Returns
    -------
    ndarray, shape (..., n * samples, d)
        Points, starting with the first given one. Those between unit quaternions are not quite of
        norm 1, and those between rotation matrices are not rotations: divide by the norm, or take
        the `rotedu.orientations.nearest_rotation`.

    Notes
    -----
    The rates of change r_i at the given values follow from the requirement that the second
    derivatives agree there: ``r_{i-1} + 4 r_i + r_{i+1} = 3 (v_{i+1} - v_{i-1})``, cyclically. So
    each value moves the whole curve, not only the four segments around it.

    References
    ----------
    Ahlberg, Nilson and Walsh (1967), "The Theory of Splines and Their Applications", Chapter II

    Examples
    --------
    Through four points of a circle:

    >>> square = [[1, 0], [0, 1], [-1, 0], [0, -1]]
    >>> print(periodic_spline(square, samples=2)[:3])
    [[1.     0.    ]
     [0.6875 0.6875]
     [0.     1.    ]]
    """
    after = np.roll(values, -1, axis=-1)
    change = (after - np.roll(values, 1, axis=-1))[..., np.newaxis]
    one = np.eye(values.shape[-1])
    cyclic = np.roll(one, -1, axis=0) + 4 * one + np.roll(one, 1, axis=0)
    rates = np.linalg.solve(cyclic, 3 * change)[..., 0]
    next_rates = np.roll(rates, -1, axis=-1)
    return sampled(cubic, [values, rates, next_rates, after], samples)


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


def towards(p: Array, q: Array) -> Array:
    """Return the tangent vector at p, as long as the arc, that leads to q: the logarithm."""
    return angle_between(p, q) * unit(q - dot(p, q) * p)


def onward(p: Array, tangent: Array) -> Array:
    """Go from p along the arc that begins with a tangent vector, as far as it is long."""
    return np.cos(length(tangent)) * p + np.sin(length(tangent)) * unit(tangent)


def arc_towards_arc(parts: list[Array], u: Array) -> Array:
    """Follow one arc, drawn towards another; both are given by their ends, as q, s, s, q."""
    q, s, next_s, next_q = parts
    on_arc, aim = slerp(q, next_q, u), slerp(s, next_s, u)
    refuse_antipodal(angle_between(on_arc, aim).max(initial=0), "points of the arcs from q and s")
    return slerp(on_arc, aim, 2 * u * (1 - u))


def cubic(parts: list[Array], u: Array) -> Array:
    """Evaluate cubic curves, given values and rates of change at both ends: Hermite's form."""
    value, rate, next_rate, next_value = parts
    begin = (1 - u) ** 2 * ((1 + 2 * u) * value + u * rate)
    end = u**2 * ((3 - 2 * u) * next_value - (1 - u) * next_rate)
    return begin + end


def refuse_whole_turn(turn: Array, pair: str) -> None:
    """Refuse a turn by 2 pi, to half of the digits, between the orientations that `pair` names."""
    half = length(turn) / 2
    refuse_two_ways(half, rounding(turn) ** 0.5, pair, "rotations", "a whole turn apart")
