"""Beyond the paper, page A: rotations in motion.

A rotation vector is an axis times an angle, and an angular velocity is one for each second. Two
frames matter: omega has its components in the fixed frame, Omega = R^T omega has those of the same
vector in the body's frame, which the columns of R span. So R' = [omega] R = R [Omega], where
[omega] is the matrix of the cross product with omega.
"""

import numpy as np

from rotedu._arguments import (
    Matrices,
    Matrix3,
    Motion,
    Quaternions,
    Rotation,
    Step,
    Unit3,
    Unit4,
    Vector3,
    Vectors,
    checked,
    place,
    rounding,
)
from rotedu._vectors import Array, axis_and_length, cross, dot, product, transpose
from rotedu.arcs import angle_between, arc_axis
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import axis_angle, rotation_matrix
from rotedu.orientations import refuse_half_turn

__all__ = [
    "angular_velocity",
    "integrate",
    "look_at",
    "matrix_from_rotation_vector",
    "matrix_steps",
    "quaternion_steps",
    "rotation_vector",
]


@checked
def matrix_from_rotation_vector(v: Vector3) -> Rotation:
    """Turn about the direction of a vector by its length in radians: the exponential map.

    Parameters
    ----------
    v : array_like, shape (..., 3)
        Rotation vectors, of any length; the zero vector turns nothing.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Rotation matrices, the matrix exponentials of [v], where [v] r = v x r. The inverse is
        `rotation_vector`, for vectors no longer than pi.

    References
    ----------
    Grassia (1998), "Practical parameterization of rotations using the exponential map", Journal of
    Graphics Tools 3(3), 29-48. Cheng et al. (2023), Eq. (3-3), for the matrix.

    Examples
    --------
    >>> print(matrix_from_rotation_vector([0, 0, np.pi / 2]).round(15) + 0.0)
    [[ 0. -1.  0.]
     [ 1.  0.  0.]
     [ 0.  0.  1.]]
    """
    return rotation_matrix(*axis_and_length(v))


@checked
def rotation_vector(matrix: Rotation) -> Vector3:
    """Return the axis of a rotation times its angle: the logarithm of the matrix.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        Rotation matrices.

    Returns
    -------
    ndarray, shape (..., 3)
        The shortest rotation vectors, no longer than pi. At a half turn, to within rounding, v and
        -v are the same rotation, and the result has a positive first nonzero component.

    References
    ----------
    Grassia (1998), as for `matrix_from_rotation_vector`

    Examples
    --------
    >>> print(rotation_vector([[0, -1, 0], [1, 0, 0], [0, 0, 1]]).round(6))
    [0.       0.       1.570796]
    """
    axis, theta = axis_angle(matrix)
    v: Vector3 = theta * axis
    return v


@checked
def angular_velocity(rotations: Motion, dt: Step) -> Vector3:
    """Return the angular velocities, in the fixed frame, that lead from each rotation to the next.

    Parameters
    ----------
    rotations : array_like, shape (..., n, 3, 3)
        At least 2 rotation matrices R_0 ... R_{n-1}, the orientations of a body at equal intervals.
    dt : float
        The time from one to the next, not zero.

    Returns
    -------
    ndarray, shape (..., n - 1, 3)
        One velocity for each interval, in radians per unit of time: Log(R_{k+1} R_k^T) / dt. A
        body that turns with these velocities, each constant for its interval, passes through all
        the given orientations, as `integrate` follows them. In the body's frame they are
        R_k^T omega_k.

    Raises
    ------
    rotedu.errors.DegenerateError
        If two neighbours are half a turn apart (to within rounding), because the turn could go
        either way. The message says which.

    Notes
    -----
    Each turn is taken to be the shorter one. If the velocity changes during an interval, the result
    differs from the velocity in its middle by an error of order dt^2.

    References
    ----------
    Iserles, Munthe-Kaas, Norsett and Zanna (2000), "Lie-group methods", Acta Numerica 9, 215-365

    Examples
    --------
    A wheel that turns by 30 degrees in each tenth of a second:

    >>> wheel = rotation_matrix([0, 0, 1], np.radians([0, 30, 60, 90]))
    >>> print(np.degrees(angular_velocity(wheel, dt=0.1)).round(9) + 0.0)
    [[  0.   0. 300.]
     [  0.   0. 300.]
     [  0.   0. 300.]]
    """
    before, after = rotations[..., :-1], rotations[..., 1:]
    axis, theta = axis_angle(product(after, transpose(before)))
    refuse_half_turn(theta, "{i} and the next", "rotations")
    omega: Vector3 = theta * axis / dt
    return omega


@checked
def integrate(rotation: Rotation, velocities: Vectors, dt: Step) -> Matrices:
    """Follow angular velocities in the fixed frame by exponentials: R_{k+1} = Exp(dt omega_k) R_k.

    Parameters
    ----------
    rotation : array_like, shape (..., 3, 3)
        The orientation to begin with, R_0.
    velocities : array_like, shape (..., n, 3)
        Angular velocities in the fixed frame, in radians per unit of time, each of which holds for
        one step.
    dt : float
        The time that a step takes, not zero; negative to go back.

    Returns
    -------
    ndarray, shape (..., n + 1, 3, 3)
        The orientations, beginning with R_0. The inverse is `angular_velocity`, as long as
        no step turns by pi or more.

    Notes
    -----
    The result is exact if the velocity is constant during each step. If it changes, the error after
    a given time is of order dt with the velocity at the beginning of each step and of order dt^2
    with the velocity in its middle. Rotations stay rotations, up to rounding. Velocities in the
    body's frame act from the right, R_{k+1} = R_k Exp(dt Omega_k).

    References
    ----------
    Iserles et al. (2000), as for `angular_velocity`

    Examples
    --------
    A quarter turn about W in ten steps, then ten steps of rest:

    >>> velocities = np.zeros((20, 3))
    >>> velocities[:10, 2] = np.pi / 2
    >>> print(integrate(np.eye(3), velocities, dt=0.1)[-1].round(15) + 0.0)
    [[ 0. -1.  0.]
     [ 1.  0.  0.]
     [ 0.  0.  1.]]
    """
    found = [rotation]
    for omega in velocities:
        turn = matrix_from_rotation_vector(dt * omega)
        rotation = product(turn, rotation)
        found.append(rotation)
    return np.stack(np.broadcast_arrays(*found))


@checked
def matrix_steps(matrix: Matrix3, velocities: Vectors, dt: Step) -> Matrices:
    """Follow angular velocities by Euler's method on the nine entries: M + dt [omega] M.

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        The matrix to begin with, a rotation or what Euler's method has made of one.
    velocities, dt : array_like, shape (..., n, 3), and float
        Angular velocities in the fixed frame and the time of a step, as for `integrate`.

    Returns
    -------
    ndarray, shape (..., n + 1, 3, 3)
        Matrices that are no longer rotations, beginning with the given one;
        `rotedu.orientations.nearest_rotation` repairs them.

    Notes
    -----
    A step keeps what lies along omega and makes what is at right angles to it longer by the factor
    sqrt(1 + (dt omega)^2). In steady turning about one axis each step turns by arctan(dt omega)
    instead of dt omega.

    Examples
    --------
    >>> print(matrix_steps(np.eye(3), [[0, 0, 1], [0, 0, 1]], dt=0.1)[-1].round(3))
    [[ 0.99 -0.2   0.  ]
     [ 0.2   0.99  0.  ]
     [ 0.    0.    1.  ]]
    """
    found = [matrix]
    for omega in velocities:
        matrix = matrix + cross(dt * omega, matrix)
        found.append(matrix)
    return np.stack(np.broadcast_arrays(*found))


@checked
def quaternion_steps(q: Unit4, velocities: Vectors, dt: Step) -> Quaternions:
    """Follow angular velocities by Euler's method on a quaternion: q + dt/2 [0, omega] q.

    Parameters
    ----------
    q : array_like, shape (..., 4)
        The unit quaternion to begin with, scalar first; any length but zero.
    velocities, dt : array_like, shape (..., n, 3), and float
        Angular velocities in the fixed frame and the time of a step, as for `integrate`.

    Returns
    -------
    ndarray, shape (..., n + 1, 4)
        Quaternions, longer with each step, beginning with the given one at norm 1.

    Notes
    -----
    A step is at right angles to q, whatever omega is, so it multiplies the norm by
    sqrt(1 + (dt omega / 2)^2) and has no other fault that dividing by the norm would repair. In
    steady turning about one axis each step turns by 2 arctan(dt omega / 2) instead of dt omega.

    Examples
    --------
    >>> print(quaternion_steps([1, 0, 0, 0], [[0, 0, 1], [0, 0, 1]], dt=0.1)[-1].round(4))
    [0.9975 0.     0.     0.1   ]
    """
    found = [q]
    for omega in velocities:
        half, w, v = dt / 2 * omega, q[0], q[1:]
        q = q + np.stack([-dot(half, v), *(w * half + cross(half, v))])
        found.append(q)
    return np.stack(np.broadcast_arrays(*found))


@checked
def look_at(direction: Unit3, up: Unit3) -> Rotation:
    """Return the upright orientation of a camera that looks in a direction.

    Parameters
    ----------
    direction : array_like, shape (..., 3)
        Where the camera looks; any length but zero.
    up : array_like, shape (..., 3)
        Which way is up in the scene; any length but zero, at any angle but 0 and pi to the
        direction.

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Rotation matrices whose columns are the camera's left, top and line of sight, as on page
        5 IV. The left is level, that is, at right angles to `up`.

    Raises
    ------
    rotedu.errors.DegenerateError
        If the camera looks straight up or down (to half of the digits), because then every edge of
        the picture is level.

    Notes
    -----
    The matrix takes the camera's coordinates to those of the scene; what is often called the view
    matrix is its transpose.

    Examples
    --------
    A camera at the origin looks along U and sees W at the top:

    >>> print(look_at([1, 0, 0], up=[0, 0, 1]).round(3) + 0.0)
    [[0. 0. 1.]
     [1. 0. 0.]
     [0. 1. 0.]]
    """
    refuse_no_level(angle_between(up, direction))
    left = arc_axis(up, direction)
    columns = np.broadcast_arrays(left, cross(direction, left), direction)
    return np.stack(columns, axis=1)


def refuse_no_level(angle: Array) -> None:
    """Refuse a line of sight along the vertical, because it fixes no edge of the picture."""
    along = np.minimum(angle, np.pi - angle) <= rounding(angle) ** 0.5
    if np.any(along):
        raise DegenerateError(
            f"direction and up{place(along)} are parallel: no edge of the picture is fixed"
        )
