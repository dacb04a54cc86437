"""Whatever a reader answers becomes plain data here, before anything judges it.

Only lists, tuples, ranges and arrays are looked into, and never beyond a bound; nothing else is
iterated, so nothing endless is started.
"""

from typing import Any

import numpy as np

from rotedu._vectors import Array
from rotedu.cost import OperationCount
from rotedu.quaternions import Quaternion

__all__ = ["plain"]

# How many numbers an answer may have; the triangles of Exercise 4.7 have 36 000.
ROOM = 1_000_000
LONGEST_WORD = 100
COMPLEX = "some numbers are complex. If only rounding made them so, take their real parts."


def plain(answer: Any, room: int = ROOM) -> Any:
    """Return an answer as None, ``...``, numbers, words, arrays, functions and lists of these.

    Parameters
    ----------
    answer : object
        Anything; it is not changed. A quaternion is read as its four numbers, an operation count
        as its multiplications and additions. What a function returns will be made plain, too.
    room : int
        How many numbers it may have. Items share the room of their list, and each has at most half
        of it, so that a list which contains itself comes to an end.

    Returns
    -------
    object

    Raises
    ------
    Exception
        If it is too large, or anything else. Attributes of an object may raise what they like.
    """
    if room < 1:
        raise ValueError("there are too many numbers, or lists in lists.")
    # An object can lie about its class, but not about its type.
    kind = type(answer)
    if answer is None or answer is ... or kind is bool:
        return answer
    if issubclass(kind, np.bool_):
        return bool(answer)
    if issubclass(kind, str):
        return word_of(str.__str__(answer))
    if issubclass(kind, complex):
        raise ValueError(COMPLEX)
    if issubclass(kind, Quaternion):
        return plain(answer.components, room)
    if issubclass(kind, OperationCount):
        return plain((answer.multiplications, answer.additions), room)
    for sequence in (list, tuple, range):
        if issubclass(kind, sequence):
            share = room // max(2, sequence.__len__(answer))
            return [plain(item, share) for item in sequence.__iter__(answer)]
    if issubclass(kind, np.ndarray):
        return numbers_of(answer, room)
    if hasattr(kind, "__array__"):
        return plain(answer.__array__(), room // 2)
    if hasattr(kind, "__float__") or hasattr(kind, "__index__"):
        return float(answer)
    if callable(answer):
        return lambda *arguments: plain(answer(*arguments))
    raise TypeError(f"a {kind.__name__} is not a number, word, list or array. Make a list of it.")


def word_of(text: str) -> str:
    """Return a text that is short enough for a word."""
    if len(text) > LONGEST_WORD:
        raise ValueError(f"a text of {len(text)} letters is too long for a word.")
    return text


def numbers_of(given: Array, room: int) -> Any:
    """Return a copy of an array of numbers, or a list of what else an array has."""
    array = np.asarray(given)
    if array.size > room:
        raise ValueError(f"the array has {array.size} numbers, which are too many.")
    if np.ma.is_masked(given):
        raise ValueError("some numbers are masked.")
    if array.dtype.kind == "c":
        raise ValueError(COMPLEX)
    if array.dtype.kind in "OUb":
        return plain(array.tolist(), room // 2)
    if array.dtype.kind not in "iuf":
        raise ValueError(f"an array of {array.dtype} holds no numbers.")
    return array.astype(np.float64)
