"""How an answer is read: whatever a reader gives becomes plain numbers, words or functions.

Also what several checks ask of numbers: whether they are close, a unit vector, the same rotation.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from rotedu._vectors import Array
from rotedu.cost import OperationCount
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion

WITHIN = 1e-6
COMPLEX = "some numbers are complex. If only rounding made them so, take their real parts."


def plain(answer: Any) -> Any:
    """Return an answer as None, ``...``, numbers, words, arrays, functions and lists of these.

    A quaternion is read as its four numbers, an operation count as its multiplications and
    additions. Arrays are copied, and what a function returns will be made plain, too.
    """
    if answer is None or answer is ... or isinstance(answer, (bool, str)):
        return answer
    if isinstance(answer, Quaternion):
        return plain(answer.components)
    if isinstance(answer, OperationCount):
        return plain([answer.multiplications, answer.additions])
    if isinstance(answer, (list, tuple, range)):
        return [plain(item) for item in answer]
    if callable(answer):
        return lambda *arguments: plain(answer(*arguments))
    array = np.asarray(answer)
    if array.dtype.kind == "c":
        raise ValueError(COMPLEX)
    if array.ndim == 0:
        return bool(answer) if array.dtype.kind == "b" else float(answer)
    if array.dtype.kind in "OUb":
        return plain(array.tolist())
    return array.astype(np.float64)


def holds(answer: Any, test: Callable[[Any], bool]) -> bool:
    """Tell whether a plain answer, or a part of it, passes a test."""
    if isinstance(answer, list):
        return any(holds(item, test) for item in answer)
    return test(answer)


def as_array(answer: Any, shape: Sequence[int | None]) -> Array:
    """Return an answer as finite numbers of a given shape; None stands for any length."""
    if holds(answer, lambda item: item is None or isinstance(item, (bool, str))):
        raise ValueError("words, True, False and None are not numbers.")
    array = np.asarray(answer, dtype=np.float64)
    if len(array.shape) != len(shape) or any(
        wanted not in (None, length) for wanted, length in zip(shape, array.shape, strict=True)
    ):
        raise ValueError(f"the shape is {array.shape}.")
    if not np.isfinite(array).all():
        raise FloatingPointError("not all numbers are finite.")
    return array


def as_rotation(answer: Any) -> Array:
    """Return a rotation as a matrix of shape (3, 3).

    It may be a `Quaternion`, four numbers with the scalar first, an axis and an angle in radians,
    or a matrix of shape (3, 3) or (4, 4). Whether a matrix is a rotation is not checked; four
    numbers must have norm 1.
    """
    if isinstance(answer, (tuple, list)) and len(answer) == 2:
        axis, angle = answer
        return rotation_matrix(as_array(axis, (3,)), as_array(angle, ()))
    answer = getattr(answer, "components", answer)
    shape = np.shape(answer)
    if shape == (4,):
        w, *v = as_array(answer, shape)
        if not unit([w, *v], 1e-2):
            raise ValueError("the quaternion does not have norm 1.")
        return Quaternion(w, v).matrix()
    if shape == (4, 4):
        matrix = as_array(answer, shape)
        if not close((matrix[3], matrix[:, 3]), 2 * [[0, 0, 0, 1]]):
            raise ValueError("the matrix does more than turn.")
        return matrix[:3, :3]
    return as_array(answer, (3, 3))


def numbers(*shape: int | None) -> Callable[[Any], Array]:
    """Return a reader of numbers of a given shape; of a single number if there is no shape."""
    return partial(as_array, shape=shape)


def word(*words: str) -> Callable[[Any], str]:
    """Return a reader of one of several words."""

    def read(answer: Any) -> str:
        given = str(answer).strip().casefold()
        if given not in words:
            raise ValueError(f"the word is {given!r}.")
        return given

    return read


def parts(*readers: Callable[[Any], Any]) -> Callable[[Any], tuple[Any, ...]]:
    """Return a reader of several parts, such as an axis and an angle, by a reader for each."""

    def read(answer: Any) -> tuple[Any, ...]:
        # The letters of a word are no parts.
        given = (answer,) if isinstance(answer, str) else tuple(answer)
        if len(given) != len(readers):
            raise ValueError(f"the number of parts is {len(given)}, not {len(readers)}.")
        return tuple(reader(part) for reader, part in zip(readers, given, strict=True))

    return read


def outcomes(cases: Sequence[tuple[Any, ...]]) -> Callable[[Any], Array]:
    """Return a reader of what a function makes of cases, shape (n, k): its numbers in a row."""

    def read(function: Any) -> Array:
        found = [function(*case) for case in cases]
        return np.array([np.hstack([as_row(part) for part in listed(one)]) for one in found])

    return read


def as_row(numbers: Any) -> Array:
    """Return finite numbers, one or some in a row."""
    return as_array(numbers, (None,) * np.ndim(numbers))


def listed(answer: Any) -> list[Any]:
    """Return the parts of what a function returns, or all of it as the only one."""
    return answer if isinstance(answer, list) else [answer]


def close(a: npt.ArrayLike, b: npt.ArrayLike, within: float = WITHIN) -> bool:
    """Tell whether arrays have one shape and differ nowhere by more than a bound."""
    a, b = np.asarray(a, np.float64), np.asarray(b, np.float64)
    return a.shape == b.shape and bool((np.abs(a - b) <= within).all())


def unit(vector: npt.ArrayLike, within: float = 1e-3) -> bool:
    """Tell whether a vector has length 1."""
    return close(np.linalg.norm(vector), 1, within)


def normalised(vectors: npt.ArrayLike) -> Array:
    """Return vectors scaled to length 1."""
    array = np.asarray(vectors, np.float64)
    return np.asarray(array / np.linalg.norm(array, axis=-1, keepdims=True))


def same_rotation(a: Any, b: Any, within: float) -> bool:
    """Tell whether two rotations, each in any form of `as_rotation`, are the same."""
    return close(as_rotation(a), as_rotation(b), within)


def same_turn(turn: Any, rotation: Any, within: float) -> bool:
    """Tell whether a pair of an axis and an angle in degrees makes a rotation."""
    axis, degrees = turn
    return same_rotation((axis, np.deg2rad(degrees)), rotation, within)


def radians_for_degrees(answer: npt.ArrayLike, right: npt.ArrayLike) -> bool:
    """Tell whether an angle that should be in degrees is right in radians."""
    return close(answer, np.deg2rad(right), 0.01)


def on_equator(degrees: npt.ArrayLike) -> Array:
    """Return the points of the equator at given angles."""
    angle = np.deg2rad(degrees)
    return np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)


def along_equator(points: npt.ArrayLike) -> Array:
    """Return the angles of points of the equator, in degrees from -180 to 180."""
    x, y, _ = np.moveaxis(np.asarray(points, np.float64), -1, 0)
    angles: Array = np.rad2deg(np.arctan2(y, x))
    return angles
