"""How answers are judged: the register of exercises, and what their checks share.

A check is a pure function of the answer. It returns None if the answer is right, or hints in two
stages. It tests properties, so that every right form of an answer passes.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from rotedu._vectors import Array
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion

__all__ = [
    "EXERCISES",
    "RADIANS",
    "Exercise",
    "Numbers",
    "Verdict",
    "Wrong",
    "along_equator",
    "as_array",
    "as_number",
    "as_parts",
    "as_quaternion",
    "as_rotation",
    "as_word",
    "check",
    "close",
    "degrees_for_radians",
    "exercise",
    "judged",
    "numeric",
    "on_equator",
    "radians_for_degrees",
    "same_rotation",
    "up_to_sign",
    "without_full_turns",
]

WITHIN = 1e-6


class Wrong(NamedTuple):
    """Two stages of a hint. Neither gives the answer away."""

    first: str
    second: str


RADIANS = Wrong("Are these radians?", "The exercise asks for degrees.")
"""The hint for an angle in radians where degrees are asked for."""


@dataclass(frozen=True)
class Exercise:
    """An exercise of the book.

    Attributes
    ----------
    number : str
        The number it has in the book.
    expects : str
        The form of an answer.
    because : str
        A sentence that a right answer earns; may be empty.
    judge : callable
        Function of the answer that returns None if it is right. It may raise anything if the
        answer does not have the expected form.
    fields : mapping of str to str
        If the answer is a few numbers, their names and units; else empty.
    parts : callable
        What the numbers are judged by, part by part, in the order of the fields.
    """

    number: str
    expects: str
    because: str
    judge: Callable[[Any], Wrong | None]
    fields: Mapping[str, str] = field(default_factory=dict)
    parts: Callable[[], Iterable["Numbers"]] = tuple


@dataclass(frozen=True, repr=False)
class Verdict:
    """What a check says about an answer.

    Attributes
    ----------
    number : str
        The number of the exercise.
    right : bool or None
        Whether the answer is right; None if there is no answer yet.
    text : str
        The verdict in words.
    """

    number: str
    right: bool | None
    text: str

    def __repr__(self) -> str:
        return f"{self.number}: {self.text}"


EXERCISES: dict[str, Exercise] = {}


def exercise(
    number: str, *, expects: str, because: str = ""
) -> Callable[[Callable[[Any], Wrong | None]], Callable[[Any], Wrong | None]]:
    """Register the function below as the check of an exercise.

    Parameters
    ----------
    number : str
        The number of the exercise in the book.
    expects : str
        The form of an answer, to complete the sentence "Expected ...".
    because : str
        A sentence that a right answer earns.

    Returns
    -------
    callable
        A decorator that returns its function unchanged.
    """

    def register(judge: Callable[[Any], Wrong | None]) -> Callable[[Any], Wrong | None]:
        add(Exercise(number, expects, because, judge))
        return judge

    return register


class Numbers:
    """One or more numbers that are judged together: an answer, or a part of it.

    The same declaration judges the answer in Python and in the page.

    Parameters
    ----------
    right : array_like
        The right numbers, or a row for each right answer if there are several.
    *mistakes : pairs of array_like and Wrong
        The results of usual mistakes, each with the hint meant for it.
    otherwise : Wrong
        The hint for all other answers.
    within : float
        The largest difference allowed in any number.
    period : float, optional
        Numbers that differ by a multiple of it count as the same, as angles do by full turns.
    """

    def __init__(
        self,
        right: npt.ArrayLike,
        *mistakes: tuple[npt.ArrayLike, Wrong],
        otherwise: Wrong,
        within: float = WITHIN,
        period: float | None = None,
    ) -> None:
        self.right = rows(right)
        self.mistakes = [(rows(result), wrong) for result, wrong in mistakes]
        self.otherwise = otherwise
        self.within = within
        self.period = period

    def judge(self, given: Array) -> Wrong | None:
        """Return None if the numbers are right, else the hint for the first mistake they fit."""
        if self.fits(given, self.right):
            return None
        hints = (wrong for result, wrong in self.mistakes if self.fits(given, result))
        return next(hints, self.otherwise)

    def fits(self, given: Array, result: Array) -> bool:
        """Tell whether the numbers are those of any row of a result."""
        off = given - result
        if self.period is not None:
            off = off - self.period * np.round(off / self.period)
        return bool((np.abs(off) <= self.within).all(axis=1).any())


def rows(numbers: npt.ArrayLike) -> Array:
    """Return a number, or a row of numbers, as an array of rows."""
    return np.atleast_2d(np.asarray(numbers, np.float64))


def numeric(
    number: str,
    *,
    fields: Mapping[str, str],
    expects: str,
    because: str = "",
    read: Callable[[Any], Any] = np.asarray,
) -> Callable[[Callable[[], Iterable[Numbers]]], Callable[[], Iterable[Numbers]]]:
    """Register an exercise whose answer is a few numbers. The page can check it, too.

    Parameters
    ----------
    number, expects, because : str
        As for `exercise`.
    fields : mapping of str to str
        The names of the numbers, each with its unit.
    read : callable
        Function that makes numbers of an answer in another form.

    Returns
    -------
    callable
        A decorator that returns its function unchanged. The function yields `Numbers`, in the
        order of the fields; a part is judged only if those before it are right.
    """

    def register(parts: Callable[[], Iterable[Numbers]]) -> Callable[[], Iterable[Numbers]]:
        def judge(answer: Any) -> Wrong | None:
            shape = [len(fields)] if len(fields) > 1 else []
            left = np.atleast_1d(as_array(read(answer), shape))
            for part in parts():
                given, left = np.split(left, [part.right.shape[1]])
                if wrong := part.judge(given):
                    return wrong
            return None

        add(Exercise(number, expects, because, judge, fields, parts))
        return parts

    return register


def add(asked: Exercise) -> None:
    """Put an exercise into the register."""
    if asked.number in EXERCISES:
        raise ValueError(f"exercise {asked.number} has two checks")
    EXERCISES[asked.number] = asked


def check(number: str, answer: Any, hint: int = 1) -> Verdict:
    """Check the answer to an exercise.

    Parameters
    ----------
    number : str
        The number of the exercise, such as "3.1".
    answer : object
        Your answer; ``...`` means that there is none yet.
    hint : int
        1 for a first hint, 2 for a second one.

    Returns
    -------
    Verdict
        Whether the answer is right, and a hint if it is not.

    Raises
    ------
    ValueError
        If no exercise has this number. No answer makes a check fail.

    Examples
    --------
    >>> check("3.1", ...)
    3.1: not answered yet.
    """
    if number not in EXERCISES:
        raise ValueError(f'no exercise has the number {number!r}; write it as in "3.1"')
    asked = EXERCISES[number]
    if unanswered(answer):
        return Verdict(number, None, "not answered yet.")
    try:
        with np.errstate(all="ignore"):
            wrong = asked.judge(answer)
    except Exception as error:
        # An answer may be anything, and a function among the answers may raise anything.
        form = f"Expected {asked.expects}."
        wrong = Wrong(form, f"{form} Python says: {error}")
    if wrong is None:
        return Verdict(number, True, f"right. {asked.because}".rstrip())
    if hint == 1:
        more = f'For more: check("{number}", answer, hint=2)'
        return Verdict(number, False, f"not yet. {wrong.first}\n{more}")
    return Verdict(number, False, f"not yet. {wrong.second}")


def unanswered(answer: Any) -> bool:
    """Tell whether an answer, or a part of it, is still ``...``."""
    if isinstance(answer, (tuple, list)):
        return any(map(unanswered, answer))
    return answer is ...


def as_array(answer: Any, shape: Sequence[int | None]) -> Array:
    """Return an answer as finite numbers of a given shape; None stands for any length."""
    array = np.asarray(answer, dtype=np.float64)
    if len(array.shape) != len(shape) or any(
        wanted not in (None, length) for wanted, length in zip(shape, array.shape, strict=True)
    ):
        raise ValueError(f"the shape is {array.shape}.")
    if not np.isfinite(array).all():
        raise ValueError("not all numbers are finite.")
    return array


def as_number(answer: Any) -> float:
    """Return an answer as a finite number."""
    return float(as_array(answer, ()))


def as_parts(answer: Any, number: int) -> tuple[Any, ...]:
    """Return the parts of an answer, such as an axis and an angle."""
    # The letters of a word are no parts.
    parts = (answer,) if isinstance(answer, str) else tuple(answer)
    if len(parts) != number:
        raise ValueError(f"the number of parts is {len(parts)}.")
    return parts


def as_word(answer: Any, words: Sequence[str]) -> str:
    """Return an answer as one of several words."""
    word = str(answer).strip().casefold()
    if word not in words:
        raise ValueError(f"the word is {word!r}.")
    return word


def as_quaternion(answer: Any) -> Array:
    """Return a `Quaternion` or four numbers, scalar first, as four numbers."""
    return as_array(getattr(answer, "components", answer), (4,))


def as_rotation(answer: Any) -> Array:
    """Return a rotation as a matrix of shape (3, 3).

    It may be a `Quaternion`, four numbers with the scalar first, an axis and an angle in radians,
    or a matrix of shape (3, 3) or (4, 4). Whether a matrix is a rotation is not checked.
    """
    if isinstance(answer, (tuple, list)) and len(answer) == 2:
        axis, angle = answer
        return rotation_matrix(as_array(axis, (3,)), as_number(angle))
    shape = np.shape(getattr(answer, "components", answer))
    if shape == (4,):
        w, *v = as_quaternion(answer)
        return Quaternion(w, v).matrix()
    if shape == (4, 4):
        return as_array(answer, shape)[:3, :3]
    return as_array(answer, (3, 3))


def close(a: npt.ArrayLike, b: npt.ArrayLike, within: float = WITHIN) -> bool:
    """Tell whether arrays have one shape and differ nowhere by more than a bound."""
    a, b = np.asarray(a, np.float64), np.asarray(b, np.float64)
    return a.shape == b.shape and bool((np.abs(a - b) <= within).all())


def up_to_sign(a: npt.ArrayLike, b: npt.ArrayLike, within: float = WITHIN) -> bool:
    """Tell whether arrays are equal or opposite."""
    return close(a, b, within) or close(a, np.negative(b), within)


def same_rotation(a: Any, b: Any, within: float = WITHIN) -> bool:
    """Tell whether two rotations, each in any form of `as_rotation`, are the same."""
    return close(as_rotation(a), as_rotation(b), within)


def degrees_for_radians(answer: npt.ArrayLike, right: npt.ArrayLike, within: float = 0.1) -> bool:
    """Tell whether an angle that should be in radians is right in degrees."""
    return close(answer, np.rad2deg(right), within)


def radians_for_degrees(answer: npt.ArrayLike, right: npt.ArrayLike, within: float = 0.01) -> bool:
    """Tell whether an angle that should be in degrees is right in radians."""
    return close(answer, np.deg2rad(right), within)


def judged(
    answer: npt.ArrayLike,
    right: npt.ArrayLike,
    *mistakes: tuple[npt.ArrayLike, Wrong],
    otherwise: Wrong,
    within: float = WITHIN,
) -> Wrong | None:
    """Compare an answer with the right one, then with what usual mistakes lead to.

    Parameters
    ----------
    answer, right : array_like
        Arrays of one shape.
    *mistakes : pairs of array_like and Wrong
        The results of usual mistakes, each with the hint meant for it.
    otherwise : Wrong
        The hint for all other answers.
    within : float
        The largest difference allowed in any entry.

    Returns
    -------
    Wrong or None
        None if the answer is right.
    """
    if close(answer, right, within):
        return None
    return next((wrong for result, wrong in mistakes if close(answer, result, within)), otherwise)


def on_equator(degrees: npt.ArrayLike) -> Array:
    """Return the points of the equator at given angles."""
    angle = np.deg2rad(degrees)
    return np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)


def along_equator(points: npt.ArrayLike) -> Array:
    """Return the angles of points of the equator, in degrees from -180 to 180."""
    x, y, _ = np.moveaxis(np.asarray(points, np.float64), -1, 0)
    angles: Array = np.rad2deg(np.arctan2(y, x))
    return angles


def without_full_turns(degrees: npt.ArrayLike) -> Array:
    """Return angles that differ by full turns as one angle, from -180 to 180."""
    angles: Array = (np.asarray(degrees, np.float64) + 180) % 360 - 180
    return angles
