"""The leanest formulas that we know for what people do with rotations, notation by notation.

`rotedu.edition.ledger` counts them, by one rule for all:

- a rotation stays in its notation, and what it is known to be is used: the third column of a
  rotation matrix is the cross product of the other two;
- what is needed twice is computed once, and what depends neither on the point nor on the place on
  an arc is prepared, and counted apart; an arc is measured from where it begins;
- the formula with the fewest multiplications, additions and divisions in all counts, of those that
  keep nearly all digits for rotations taken at random; roots and functions are named beside.

Arguments are arrays of numbers or of the counting scalars of `rotedu.cost`: matrices (3, 3),
quaternions (4,), turns (4,), which are an axis of length 1 and an angle, rotation vectors (3,) and
points (3,). Nothing is checked. Where a turn vanishes, or two rotations are half a turn apart, the
functions of the package have an answer or refuse; these formulas do not.
"""

from typing import Any

import numpy as np

from rotedu._vectors import Array, length

# Matrices.


def with_third(first: Array, second: Array) -> Array:
    """Make a rotation matrix of its first two columns."""
    return np.stack([first, second, np.cross(first, second)], axis=1)


def compose_matrices(a: Array, b: Array) -> Array:
    """Multiply two rotation matrices."""
    return with_third(a @ b[:, 0], a @ b[:, 1])


def matrix_between(a: Array, b: Array, t: Any) -> Array:
    """Go from one matrix towards another: a M_R(t theta, n), with n and theta from a^T b."""
    m = compose_matrices(a.T, b)
    axis = np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]])
    square = np.dot(axis, axis)
    sine = np.sqrt(square)
    turn = t * np.arctan2(sine, m[0, 0] + m[1, 1] + m[2, 2] - 1)
    cos = np.cos(turn)
    first, second = first_columns(
        axis, cos, (1 - cos) / square * axis[:2], np.sin(turn) / sine * axis
    )
    return with_third(a @ first, a @ second)


def matrix_on_arc(a: Array, b: Array, c: Array, theta: Any, t: Any) -> Array:
    """Take a sample of an arc, prepared as A + cos(t theta) B + sin(t theta) C."""
    turn = t * theta
    cos, sin = np.cos(turn), np.sin(turn)
    return with_third(*(a[:, k] + cos * b[:, k] + sin * c[:, k] for k in (0, 1)))


def repair_columns(matrix: Array) -> Array:
    """Straighten a matrix by the method of Gram and Schmidt."""
    first, second, _ = matrix.T
    first, third = unit(first), unit(np.cross(first, second))
    return np.stack([first, np.cross(third, first), third], axis=1)


def repair_evenly(matrix: Array) -> Array:
    """Take a step of Newton's method towards the nearest rotation, M (3 I - M^T M) / 2."""
    u, v, w = matrix.T
    uu, vv, ww = (0.5 * np.dot(x, x) for x in (u, v, w))
    uv, uw, vw = (-0.5 * np.dot(x, y) for x, y in ((u, v), (u, w), (v, w)))
    step = [[1.5 - uu, uv, uw], [uv, 1.5 - vv, vw], [uw, vw, 1.5 - ww]]
    return np.asarray(matrix @ np.array(step))


# Quaternions.


def unit(q: Array) -> Array:
    """Divide by the length."""
    return np.asarray(q / length(q))


def compose_quaternions(p: Array, q: Array) -> Array:
    """Multiply two quaternions, (2-3)."""
    w = p[0] * q[0] - np.dot(p[1:], q[1:])
    return np.array([w, *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def turn_by_quaternion(q: Array, point: Array) -> Array:
    """Turn a point: r + w (2 v x r) + v x (2 v x r)."""
    across = np.cross(2 * q[1:], point)
    return np.asarray(point + q[0] * across + np.cross(q[1:], across))


def prepare_quaternion(q: Array) -> tuple[Array, Array]:
    """Prepare a quaternion for `turn_prepared`."""
    w, v = q[0], q[1:]
    return 1 / w * v, (w + w) * v


def turn_prepared(tangent: Array, sine: Array, point: Array) -> Array:
    """Turn one of many points: r + sin(theta) n x (r + tan(theta / 2) n x r)."""
    return np.asarray(point + np.cross(sine, point + np.cross(tangent, point)))


def matrix_of_quaternion(q: Array) -> Array:
    """Make a matrix of a quaternion."""
    (w, x, y, z), (tx, ty, tz) = q, q[1:] + q[1:]
    return matrix_of_products(
        (tx * x, ty * y, tz * z), (ty * z, tx * z, tx * y), (tx * w, ty * w, tz * w)
    )


def matrix_of_products(squares: Any, mixed: Any, by_w: Any) -> Array:
    """Arrange twice the products of the components of a quaternion."""
    (xx, yy, zz), (yz, xz, xy), (wx, wy, wz) = squares, mixed, by_w
    rest = 1 - zz
    return np.array(
        [
            [rest - yy, xy - wz, xz + wy],
            [xy + wz, rest - xx, yz - wx],
            [xz - wy, yz + wx, 1 - xx - yy],
        ]
    )


def quaternion_between(p: Array, q: Array, t: Any) -> Array:
    """Go from one quaternion, or direction, towards another by slerp, (5-2)."""
    first, second = shares_of_arc(np.dot(p, q), t)
    return np.asarray(first * p + second * q)


def shares_of_arc(cos: Any, t: Any) -> tuple[Any, Any]:
    """Find what each end of an arc contributes, from the cosine of its angle."""
    sin = np.sqrt(1 - cos * cos)
    turn = t * np.arctan2(sin, cos)
    share = np.sin(turn) / sin
    return np.cos(turn) - cos * share, share


def quaternion_on_arc(p: Array, across: Array, theta: Any, t: Any) -> Array:
    """Take a sample of an arc, prepared as p and a quaternion at right angles to it."""
    turn = t * theta
    return np.asarray(np.cos(turn) * p + np.sin(turn) * across)


def matrix_on_arc_of_quaternions(p: Array, across: Array, theta: Any, t: Any) -> Array:
    """Take the sample as a matrix: p and `across`, prepared sqrt(2) long, spare the doublings."""
    w, x, y, z = quaternion_on_arc(p, across, theta, t)
    return matrix_of_products((x * x, y * y, z * z), (y * z, x * z, x * y), (w * x, w * y, w * z))


# Axis and angle, by the half-angle rule, (4-3) to (4-6).


def whole(half: Array, sin: Any) -> Array:
    """Go back from half angles, or a multiple of their cosine and sine, to an axis and an angle."""
    return np.array([*(half[1:] / sin), 2 * np.arctan2(sin, half[0])])


def sine_of_unit(half: Array) -> Any:
    """Find the sine of half angles, if they are no multiple."""
    return np.sqrt(1 - half[0] * half[0])


def compose_turns(a: Array, b: Array) -> Array:
    """Replace two turns by one of up to 360 degrees; halves are divided by their cosines.

    Where just one of the two is beyond half a turn, it is the other name of the turn that comes
    out. Telling so takes a comparison, which is not counted.
    """
    v, w = (np.tan(0.5 * turn[3]) * turn[:3] for turn in (a, b))
    vector = v + w + np.cross(v, w)
    return whole(np.array([1 - np.dot(v, w), *vector]), length(vector))


def turn_about_axis(turn: Array, point: Array) -> Array:
    """Turn a point by (3-1)."""
    n, cos, sin = turn[:3], np.cos(turn[3]), np.sin(turn[3])
    along = (1 - cos) * np.dot(n, point)
    return np.asarray(cos * point + along * n + sin * np.cross(n, point))


def prepare_axis(turn: Array) -> tuple[Array, Array]:
    """Prepare an axis and an angle for `turn_prepared`."""
    n, theta = turn[:3], turn[3]
    return np.tan(0.5 * theta) * n, np.sin(theta) * n


def matrix_of_turn(turn: Array) -> Array:
    """Build (3-3)."""
    n, cos, sin = turn[:3], np.cos(turn[3]), np.sin(turn[3])
    return matrix_of_parts(n, cos, (1 - cos) * n[:2], sin * n)


def matrix_of_parts(n: Array, cos: Any, along: Array, spin: Array) -> Array:
    """Arrange the entries of (3-3); the last one follows from those that n has used up."""
    (nu, nv, nw), (ku, kv), (su, sv, sw) = n, along, spin
    uu, vv, uv, uw, vw = ku * nu, kv * nv, ku * nv, ku * nw, kv * nw
    return np.array(
        [
            [cos + uu, uv - sw, uw + sv],
            [uv + sw, cos + vv, vw - su],
            [uw - sv, vw + su, 1 - (uu + vv)],
        ]
    )


def first_columns(n: Array, cos: Any, along: Array, spin: Array) -> tuple[Array, Array]:
    """Arrange the first two columns of (3-3)."""
    (nu, nv, nw), (ku, kv), (su, sv, sw) = n, along, spin
    uv, uw, vw = ku * nv, ku * nw, kv * nw
    return np.array([cos + ku * nu, uv + sw, uw - sv]), np.array([uv - sw, cos + kv * nv, vw + su])


def turn_between(a: Array, b: Array, t: Any) -> Array:
    """Go from one turn towards another: slerp in the letters of (4-3) to (4-6)."""
    (n, half), (m, other) = ((turn[:3], 0.5 * turn[3]) for turn in (a, b))
    (c, s), (d, r) = (np.cos(half), np.sin(half)), (np.cos(other), np.sin(other))
    first, second = shares_of_arc(c * d + s * r * np.dot(n, m), t)
    half = np.array([first * c + second * d, *(first * s * n + second * r * m)])
    return whole(half, sine_of_unit(half))


def turn_on_arc(p: Array, across: Array, theta: Any, t: Any) -> Array:
    """Take a sample of an arc, prepared in the letters of (4-3) to (4-6)."""
    half = quaternion_on_arc(p, across, theta, t)
    return whole(half, sine_of_unit(half))


# Rotation vectors: the axis times the angle.


def vector_whole(half: Array, sin: Any) -> Array:
    """Go back from half angles, or a multiple of their cosine and sine, to a rotation vector."""
    return np.asarray(2 * np.arctan2(sin, half[0]) / sin * half[1:])


def compose_vectors(v: Array, w: Array) -> Array:
    """Replace two turns by one of up to 360 degrees; halves are divided by their cosines.

    Where just one of the two is beyond half a turn, it is the other name of the turn that comes
    out. Telling so takes a comparison, which is not counted.
    """
    v, w = (np.tan(0.5 * theta) / theta * u for u, theta in ((v, length(v)), (w, length(w))))
    vector = v + w + np.cross(v, w)
    return vector_whole(np.array([1 - np.dot(v, w), *vector]), length(vector))


def turn_by_vector(v: Array, point: Array) -> Array:
    """Turn a point by (3-1), with the axis times the angle."""
    cos, along, spin = shares(v)
    share = along * np.dot(v, point)
    return np.asarray(cos * point + share * v + spin * np.cross(v, point))


def shares(v: Array) -> tuple[Any, Any, Any]:
    """Find cos theta, (1 - cos theta) / theta^2 and sin theta / theta."""
    square = np.dot(v, v)
    theta = np.sqrt(square)
    cos = np.cos(theta)
    return cos, (1 - cos) / square, np.sin(theta) / theta


def prepare_vector(v: Array) -> tuple[Array, Array]:
    """Prepare a rotation vector for `turn_prepared`."""
    theta = length(v)
    return np.tan(0.5 * theta) / theta * v, np.sin(theta) / theta * v


def matrix_of_vector(v: Array) -> Array:
    """Build (3-3) from a rotation vector."""
    cos, along, spin = shares(v)
    return matrix_of_parts(v, cos, along * v[:2], spin * v)


def vector_between(v: Array, w: Array, t: Any) -> Array:
    """Go from one rotation vector towards another."""
    (c, s), (d, r) = map(half_of_vector, (v, w))
    first, second = shares_of_arc(c * d + s * r * np.dot(v, w), t)
    half = np.array([first * c + second * d, *(first * s * v + second * r * w)])
    return vector_whole(half, sine_of_unit(half))


def half_of_vector(v: Array) -> tuple[Any, Any]:
    """Find the cosine of half the angle, and its sine over the angle."""
    theta = length(v)
    half = 0.5 * theta
    return np.cos(half), np.sin(half) / theta


def vector_on_arc(p: Array, across: Array, theta: Any, t: Any) -> Array:
    """Take a sample of an arc, prepared in the letters of (4-3) to (4-6)."""
    half = quaternion_on_arc(p, across, theta, t)
    return vector_whole(half, sine_of_unit(half))


# Three angles, two columns, and five numbers of a map.


def matrix_of_angles(u: Any, v: Any, w: Any) -> Array:
    """Compute (4-2)."""
    (su, sv, sw), (cu, cv, cw) = np.sin([u, v, w]), np.cos([u, v, w])
    both, only = su * sv, cu * sv
    return np.array(
        [
            [cv * cw, both * cw - cu * sw, only * cw + su * sw],
            [cv * sw, both * sw + cu * cw, only * sw - su * cw],
            [-sv, su * cv, cu * cv],
        ]
    )


def compose_angles(a: Array, b: Array) -> Array:
    """Replace two triples by one: the outer angles add to those of the matrix between them."""
    sin, cos = np.sin([a[0], a[1], b[1], b[2]]), np.cos([a[0], a[1], b[1], b[2]])
    (su, sv, sy, sz), (cu, cv, cy, cz) = sin, cos
    x, y, both = cz * cy, sz * cy, su * sz
    share = su * y - cu * sy
    m11, m21, m31 = cv * x + sv * share, cu * y + su * sy, cv * share - sv * x
    m32, m33 = sv * sz + cv * (su * cz), cv * (both * sy + cu * cy) - sv * (cz * sy)
    return np.array([np.arctan2(m32, m33) + b[0], -np.arcsin(m31), np.arctan2(m21, m11) + a[2]])


def turn_by_two_columns(a: Array, b: Array) -> Array:
    """Turn a point, or the first two columns of another matrix."""
    return np.asarray(with_third(*a.T) @ b)


def repair_two_columns(a: Array) -> Array:
    """Straighten two columns by the method of Gram and Schmidt."""
    first = unit(a[:, 0])
    return np.stack([first, unit(a[:, 1] - np.dot(first, a[:, 1]) * first)], axis=1)


def five_of_columns(a: Array) -> Array:
    """Map two columns, of length sqrt(2) together, to five numbers."""
    return np.asarray(1 / (np.sqrt(2) - a[0, 0]) * np.array([a[1, 0], a[2, 0], *a[:, 1]]))


def columns_of_five(x: Array) -> Array:
    """Find the point of the map."""
    share = np.sqrt(8) / (np.dot(x, x) + 1)
    return np.stack([np.array([np.sqrt(2) - share, *(share * x[:2])]), share * x[2:]], axis=1)


def compose_five(x: Array, y: Array) -> Array:
    """Replace two rotations by one."""
    return five_of_columns(turn_by_two_columns(columns_of_five(x), columns_of_five(y)))


def turn_by_five(x: Array, point: Array) -> Array:
    """Turn a point."""
    return turn_by_two_columns(columns_of_five(x), point)


def repair_five(x: Array) -> Array:
    """Straighten the two columns."""
    return five_of_columns(repair_two_columns(columns_of_five(x)))


# Rigid motions: dual quaternions are two quaternions, poses are three rows of four.


def compose_dual_quaternions(a: Array, b: Array) -> Array:
    """Multiply two dual quaternions, shape (2, 4), with eps^2 = 0."""
    (p, c), (q, d) = a, b
    real = compose_quaternions(p, q)
    return np.stack([real, compose_quaternions(p, d) + compose_quaternions(c, q)])


def move_by_dual_quaternion(a: Array, point: Array) -> Array:
    """Move a point, by twice what moves it aside."""
    return np.asarray(point + 2 * moved_aside(a, point))


def moved_aside(a: Array, point: Array) -> Array:
    """Find w u + v x u - d_0 v, where u = v x r + d, and [d_0, d] is the dual part."""
    w, v, d0, d = a[0, 0], a[0, 1:], a[1, 0], a[1, 1:]
    u = np.cross(v, point) + d
    return np.asarray(w * u + np.cross(v, u) - d0 * v)


def compose_with_steps(p: Array, s: Array, q: Array, t: Array) -> tuple[Array, Array]:
    """Replace a quaternion q and a step t, and then p and s, by one of each."""
    return compose_quaternions(p, q), move_by_quaternion_and_step(p, s, t)


def move_by_quaternion_and_step(q: Array, step: Array, point: Array) -> Array:
    """Turn a point, and move it on."""
    return np.asarray(turn_by_quaternion(q, point) + step)


def compose_poses(a: Array, b: Array) -> Array:
    """Multiply two rigid motions."""
    return np.concatenate(
        [compose_matrices(a[:, :3], b[:, :3]), move_by_pose(a, b[:, 3])[:, np.newaxis]], axis=1
    )


def move_by_pose(pose: Array, point: Array) -> Array:
    """Move a point by three rows of a 4x4 matrix."""
    return np.asarray(pose[:, :3] @ point + pose[:, 3])


def skin_by_poses(bones: Array, weights: Array, point: Array) -> Array:
    """Move a vertex by the mean of bones' matrices: to the mean of where each moves it."""
    return np.asarray(weights @ np.stack([move_by_pose(bone, point) for bone in bones]))


def skin_by_dual_quaternions(bones: Array, ratios: Array, point: Array) -> Array:
    """Move a vertex by the mean of bones' dual quaternions, which may have any signs.

    Since the mean is divided by its length, each further weight is told as a multiple of the first.
    """
    first, *others = bones
    signed = [
        ratio if np.dot(first[0], other[0]) > 0 else -ratio
        for ratio, other in zip(ratios, others, strict=True)
    ]
    mean = first + (np.array(signed) @ np.reshape(others, (-1, 8))).reshape(2, 4)
    return np.asarray(point + 2 / np.dot(mean[0], mean[0]) * moved_aside(mean, point))
