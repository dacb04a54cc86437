"""Beyond the paper, page C: a turn and a step together, as a matrix, a screw or a dual quaternion.

A rigid motion, or pose, is a 4x4 matrix: a rotation R in its first three rows and columns, a step s
in its fourth column. It turns first, and then steps.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from rotedu._arguments import (
    HomogeneousMatrix,
    Number,
    Pose,
    Poses,
    Vector,
    Weights,
    checked,
    place,
    require_broadcasting,
    rounding,
)
from rotedu._vectors import Array, axis_and_length, cross, dot, length, product, times, transpose
from rotedu.errors import DegenerateError
from rotedu.general_rotation import from_rows
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix
from rotedu.orientations import nearest_rotation, refuse_half_turn
from rotedu.quaternions import Quaternion, joined

__all__ = [
    "DualQuaternion",
    "blend_dual_quaternions",
    "blend_matrices",
    "screw",
    "screw_motion",
    "straight_motion",
]


@dataclass(frozen=True, eq=False)
class DualQuaternion:
    """Dual quaternion, real + eps dual with eps^2 = 0, or an array of them.

    Parameters
    ----------
    real, dual : Quaternion, shape (...)
        The two parts; their shapes broadcast.

    Raises
    ------
    ValueError
        If a part is not a `rotedu.quaternions.Quaternion`, or the shapes do not broadcast.

    Notes
    -----
    A rotation q, followed by a step s, is ``q + eps [0, s] q / 2``. A product of two is the motion
    of the right factor, followed by that of the left one.

    References
    ----------
    Clifford (1873), "Preliminary sketch of biquaternions", Proceedings of the London Mathematical
    Society 4, 381-395; Kavan, Collins, Zara and O'Sullivan (2008), "Geometric skinning with
    approximate dual quaternion blending", ACM Transactions on Graphics 27(4), 105

    Examples
    --------
    A step along U, then a quarter turn about W, which takes the step along:

    >>> from rotedu.general_rotation import homogeneous, translation
    >>> turn, step = homogeneous(rotation_matrix([0, 0, 1], np.pi / 2)), translation([1, 0, 0])
    >>> both = DualQuaternion.from_matrix(turn) * DualQuaternion.from_matrix(step)
    >>> print(both.matrix()[:3, 3].round(12))
    [0. 1. 0.]
    """

    real: Quaternion
    dual: Quaternion

    def __post_init__(self) -> None:
        for name in ("real", "dual"):
            if not isinstance(getattr(self, name), Quaternion):
                raise ValueError(f"{name} must be a Quaternion; got {getattr(self, name)!r}")
        parts = {"real": self.real.w, "dual": self.dual.w}
        require_broadcasting([part.shape for part in parts.values()], parts)

    @classmethod
    @checked
    def from_matrix(cls, matrix: Pose) -> Any:
        """Make the unit dual quaternion of a rigid motion, with a real part of w >= 0.

        Parameters
        ----------
        matrix : array_like, shape (..., 4, 4)
            Rigid motions.

        Returns
        -------
        DualQuaternion, shape (...)

        Examples
        --------
        >>> print(DualQuaternion.from_matrix([[1, 0, 0, 6], [0, 1, 0, 0], [0, 0, 1, 0],
        ...                                   [0, 0, 0, 1]]).dual)
        Quaternion(0., [3., 0., 0.])
        """
        turn, step = matrix[:3, :3], matrix[:3, 3]
        real = Quaternion.from_matrix(turn)
        return cls(real, joined(np.zeros_like(step[0]), step / 2) * real)

    def matrix(self) -> Array:
        """Return the rigid motion, also of a dual quaternion that is not of length 1.

        Returns
        -------
        ndarray, shape (..., 4, 4)
            The rotation is that of the real part q, the step the vector part of 2 d q* / abs(q)^2,
            where d is the dual part.

        Raises
        ------
        rotedu.errors.DegenerateError
            If the real part is zero.

        Examples
        --------
        >>> twice = DualQuaternion(Quaternion(2, [0, 0, 0]), Quaternion(0, [3, 0, 0]))
        >>> print(twice.matrix()[:3, 3])
        [3. 0. 0.]
        """
        step = 2 * (self.dual / self.real).v
        turn = self.real.matrix()
        shape = np.broadcast_shapes(turn.shape[:-2], step.shape[:-1])
        pose = np.zeros((*shape, 4, 4), np.result_type(turn, step))
        pose[..., :3, :3], pose[..., :3, 3], pose[..., 3, 3] = turn, step, 1
        return pose

    def __mul__(self, other: DualQuaternion) -> DualQuaternion:
        """Multiply, with eps^2 = 0."""
        if not isinstance(other, DualQuaternion):
            return NotImplemented
        dual = self.real * other.dual + self.dual * other.real
        return DualQuaternion(self.real * other.real, dual)

    def __eq__(self, other: object) -> Any:
        """Tell for each dual quaternion whether all eight components are equal."""
        if not isinstance(other, DualQuaternion):
            return NotImplemented
        return (self.real == other.real) & (self.dual == other.dual)

    def __ne__(self, other: object) -> Any:
        """Tell for each dual quaternion whether any component differs."""
        return np.logical_not(self == other)

    __hash__ = None  # type: ignore[assignment]

    def conjugate(self) -> DualQuaternion:
        """Conjugate both parts, which undoes a motion if the dual quaternion has length 1.

        Returns
        -------
        DualQuaternion, shape (...)

        Examples
        --------
        >>> step = DualQuaternion(Quaternion(1, [0, 0, 0]), Quaternion(0, [3, 0, 0]))
        >>> print((step.conjugate() * step).matrix()[:3, 3])
        [0. 0. 0.]
        """
        return DualQuaternion(self.real.conjugate(), self.dual.conjugate())

    def norm(self) -> tuple[Array, Array]:
        """Return the norm, a dual number; of a rigid motion it is 1 + eps 0.

        Returns
        -------
        real, dual : ndarray, shape (...)
            abs(q) and q . d / abs(q), where d is the dual part; the second is 0 where q is.

        Examples
        --------
        >>> print(*DualQuaternion(Quaternion(2, [0, 0, 0]), Quaternion(5, [3, 0, 0])).norm())
        2.0 5.0
        """
        size = self.real.norm()
        direction = self.real.components / np.where(size == 0, 1, size)[..., np.newaxis]
        return size, np.sum(direction * self.dual.components, axis=-1)


@checked
def screw(matrix: Pose) -> tuple[Vector, Vector, Number, Number]:
    """Return the screw of a rigid motion: the turn about a line, and the slide along it.

    Parameters
    ----------
    matrix : array_like, shape (..., 4, 4)
        Rigid motions.

    Returns
    -------
    axis : ndarray, shape (..., 3)
        The line's direction, a unit vector; for a turn by pi as `axis_angle` chooses it.
    point : ndarray, shape (..., 3)
        The point of the line that is nearest to the origin.
    angle : ndarray, shape (...)
        Angles in radians, from 0 to pi.
    slide : ndarray, shape (...)
        How far it moves along the axis; negative if against it. A mere step has its own direction
        as axis, the origin as point, the angle 0 and its length as slide.

    Raises
    ------
    rotedu.errors.DegenerateError
        If nothing moves, because every line would do.

    Notes
    -----
    With p, the part of the step s across the axis n, the point is ``(p + cot(theta / 2) n x p) /
    2``. If the angle is x, the rounding of the matrix moves the point by about 1e-16 / x^2 of p.

    References
    ----------
    Chasles (1830), "Note sur les propriétés générales du système de deux corps semblables
    entr'eux", Bulletin des Sciences Mathématiques 14, 321-326

    Examples
    --------
    Half a turn about a line through (1, 0, 0) along W, and a slide by 5:

    >>> half_turn = [[-1, 0, 0, 2], [0, -1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]
    >>> axis, point, angle, slide = screw(half_turn)
    >>> print(axis, point.round(12) + 0.0, np.degrees(angle), slide)
    [0. 0. 1.] [1. 0. 0.] 180.0 5.0
    """
    turn, step = matrix[:3, :3], matrix[:3, 3]
    axis, angle = axis_angle(turn)
    direction, far = axis_and_length(step)
    straight = angle <= 4 * rounding(turn)
    if np.any(still := straight & (far == 0)):
        raise DegenerateError(f"matrix{place(still)} moves nothing: every line is an axis")
    axis, angle = np.where(straight, direction, axis), np.where(straight, 0, angle)
    slide = dot(axis, step)
    across = step - slide * axis
    cot = 1 / np.tan(np.where(straight, np.pi, angle) / 2)
    point = np.where(straight, 0, across + cot * cross(axis, across)) / 2
    return axis, point, angle, slide


@checked
def screw_motion(m1: Pose, m2: Pose, t: Number) -> HomogeneousMatrix:
    """Return a pose on the screw from M1 to M2 (ScLERP), which turns and slides evenly.

    Parameters
    ----------
    m1, m2 : array_like, shape (..., 4, 4)
        Rigid motions.
    t : array_like, shape (...)
        Fraction of the screw: 0 gives M1, 1 gives M2. Beyond them the screw goes on.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Raises
    ------
    rotedu.errors.DegenerateError
        If M1 and M2 are half a turn apart (to within rounding), because two screws are shortest.

    Notes
    -----
    Let n, theta and s be the axis, the angle and the step of M1^-1 M2, and p the part of s across
    n. After a fraction t of the turn, the step along n is a fraction t of the whole, and the step
    across is a chord of the same circle: p, turned back by (1 - t) theta / 2 and scaled by the
    ratio of the chords, sin(t theta / 2) / sin(theta / 2). So no line far away enters, and small
    angles lose no digits.

    References
    ----------
    Kavan et al. (2008), as for `DualQuaternion`

    Examples
    --------
    >>> a, b = np.eye(4), [[-0.6, -0.8, 0, 2], [0.8, -0.6, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]
    >>> print(screw_motion(a, b, 1 / 2).round(6)[:3, 3])
    [ 1.       -0.618034  2.5     ]
    """
    relative = product(transpose(m1[:3, :3]), m2[:3, :3])
    step = times(transpose(m1[:3, :3]), m2[:3, 3] - m1[:3, 3])
    axis, theta = axis_angle(relative)
    refuse_half_turn(theta, "m1 and m2")
    along = dot(axis, step) * axis
    half = np.sin(theta / 2)
    chords = np.where(half == 0, t, np.sin(t * theta / 2) / np.where(half == 0, 1, half))
    moved = t * along + chords * rotate(step - along, axis, (t - 1) * theta / 2)
    turned = product(m1[:3, :3], rotation_matrix(axis, t * theta))
    return pose(turned, m1[:3, 3] + times(m1[:3, :3], moved))


@checked
def straight_motion(m1: Pose, m2: Pose, t: Number) -> HomogeneousMatrix:
    """Return a pose between M1 and M2 whose origin goes straight while it turns by slerp.

    Parameters
    ----------
    m1, m2 : array_like, shape (..., 4, 4)
        Rigid motions.
    t : array_like, shape (...)
        Fraction of the path: 0 gives M1, 1 gives M2. Beyond them it goes on.

    Returns
    -------
    ndarray, shape (..., 4, 4)

    Raises
    ------
    rotedu.errors.DegenerateError
        If M1 and M2 are half a turn apart (to within rounding), as for `screw_motion`.

    Examples
    --------
    >>> a, b = np.eye(4), [[-0.6, -0.8, 0, 2], [0.8, -0.6, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]
    >>> print(straight_motion(a, b, 1 / 2).round(6)[:3, 3])
    [1.  0.  2.5]
    """
    axis, theta = axis_angle(product(transpose(m1[:3, :3]), m2[:3, :3]))
    refuse_half_turn(theta, "m1 and m2")
    turned = product(m1[:3, :3], rotation_matrix(axis, t * theta))
    return pose(turned, (1 - t) * m1[:3, 3] + t * m2[:3, 3])


@checked
def blend_matrices(matrices: Poses, weights: Weights, repair: bool = False) -> HomogeneousMatrix:
    """Average poses entry by entry: linear blend skinning, of a vertex that several bones move.

    Parameters
    ----------
    matrices : array_like, shape (..., n, 4, 4)
        Rigid motions, those of the bones.
    weights : array_like, shape (..., n)
        How much each of them counts: numbers that are not negative and not all zero.
    repair : bool, optional
        Whether to replace the mean of the rotations with the nearest rotation.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        The means. Without repair they squeeze space wherever the rotations differ.

    Raises
    ------
    rotedu.errors.DegenerateError
        If `repair` is true and several rotations are nearest to the mean of the matrices, as for
        two that are half a turn apart.

    References
    ----------
    Magnenat-Thalmann, Laperrière and Thalmann (1988), "Joint-dependent local deformations for hand
    animation and object grasping", Proceedings of Graphics Interface '88, 26-33

    Examples
    --------
    Two poses half a turn about W apart flatten what lies between them to a line:

    >>> print(blend_matrices([np.eye(4), np.diag([-1, -1, 1, 1])], [1, 1]).diagonal())
    [0. 0. 1. 1.]
    """
    mean = np.sum(weights * matrices, axis=-1)
    return pose(nearest_rotation(mean[:3, :3]), mean[:3, 3]) if repair else mean


@checked
def blend_dual_quaternions(matrices: Poses, weights: Weights) -> HomogeneousMatrix:
    """Average poses as dual quaternions, whose sum is scaled to length 1.

    Parameters
    ----------
    matrices : array_like, shape (..., n, 4, 4)
        Rigid motions, those of the bones.
    weights : array_like, shape (..., n)
        How much each of them counts: numbers that are not negative and not all zero.

    Returns
    -------
    ndarray, shape (..., 4, 4)
        Rigid motions, whatever the weights.

    Raises
    ------
    rotedu.errors.DegenerateError
        If a pose is half a turn away from the first pose of the largest weight (to within
        rounding), because its sign is that which agrees with this pose.

    References
    ----------
    Kavan et al. (2008), as for `DualQuaternion`

    Examples
    --------
    >>> quarter = [[0, -1, 0, 2], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    >>> print(blend_dual_quaternions([np.eye(4), quarter], [1, 1]).round(4)[:3, 3])
    [ 1.     -0.4142  0.    ]
    """
    dual = DualQuaternion.from_matrix(matrices)
    shape = np.broadcast_shapes(weights.shape, dual.real.w.shape)
    weights = np.broadcast_to(weights, shape)
    q, d = (
        np.broadcast_to(np.moveaxis(part.components, -1, 0), (4, *shape))
        for part in (dual.real, dual.dual)
    )
    leader = np.argmax(weights, axis=-1)[..., np.newaxis]
    agreement = dot(q, np.take_along_axis(q, leader[np.newaxis], axis=-1))
    apart = (np.abs(agreement) <= 32 * rounding(q)) & (weights > 0)
    if apart.any():
        raise DegenerateError(
            f"matrices{place(apart)} are half a turn from those of the largest weight:"
            " no unique sign"
        )
    share = weights * np.where(agreement < 0, -1, 1)
    real, far = (np.sum(share * part, axis=-1) for part in (q, d))
    size = length(real)
    w, *v = real / size
    blended = DualQuaternion(joined(w, np.stack(v)), joined(far[0] / size, far[1:] / size))
    return np.moveaxis(blended.matrix(), (-2, -1), (0, 1))


def pose(turn: Array, step: Array) -> Array:
    """Put a rotation and a step into one matrix, components first."""
    return from_rows(*([*row, move] for row, move in zip(turn, step, strict=True)))
