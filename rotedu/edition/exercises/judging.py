"""How answers are judged: the register of exercises, and what their checks share.

A check yields parts: what is right and which mistakes are usual, each a value or a function that
tests a property. With each mistake stands its hint, in two stages.
"""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from rotedu._vectors import Array
from rotedu.edition.exercises.answers import plain
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion

__all__ = [
    "EXERCISES",
    "NOT_THE_TRUTH",
    "RADIANS",
    "SCALAR_LAST",
    "YOUR_RADIANS",
    "Exercise",
    "Mistake",
    "Part",
    "Verdict",
    "Wrong",
    "along_equator",
    "as_array",
    "as_rotation",
    "check",
    "close",
    "degrees_for_radians",
    "exercise",
    "numbers",
    "on_equator",
    "parts",
    "radians_for_degrees",
    "same_rotation",
    "same_turn",
    "unit",
    "without_full_turns",
    "word",
]

WITHIN = 1e-6
# How many full turns may be too many in an angle; answers.js says so, too.
TURNS = 1000
# How many letters a verdict quotes.
LONGEST = 200


class Wrong(NamedTuple):
    """Two stages of a hint. Neither gives the answer away."""

    first: str
    second: str


# Hints for an angle in radians where degrees are asked for.
RADIANS = Wrong("Are these radians?", "The exercise asks for degrees.")
YOUR_RADIANS = Wrong("Your angle is in radians.", "A full turn has 360 degrees.")
SCALAR_LAST = Wrong("Does your scalar part come last?", "In this book it comes first.")
# A hint for what went into a simulated measurement.
NOT_THE_TRUTH = Wrong(
    "This is the truth, exactly. Nobody who measures knows it.",
    "The cell knows it only to make the data. Find your answer from the data alone.",
)


class Mistake(NamedTuple):
    """A usual mistake.

    Attributes
    ----------
    result : array_like or callable
        What it leads to, or a function that tells whether an answer shows it.
    first, second : str
        Two stages of a hint, as in `Wrong`.
    example : object
        An answer to the exercise that shows it; needed if the result is a function. A test
        demands this hint for it.
    """

    result: Any
    first: str
    second: str
    example: Any = None


class Part:
    """One step of a check: what is right, which mistakes are usual, and otherwise.

    Parameters
    ----------
    right : array_like or callable
        The right numbers, or a function that tells whether what was read is right; a tuple becomes
        several arguments.
    *mistakes : Mistake
        Usual mistakes. The first that fits gives the hint.
    otherwise : Wrong
        The hint for all other answers.
    item : int or slice, optional
        Which item of what was read is judged; everything if it is not given.
    within : float
        The largest difference allowed in any number.
    period : float, optional
        Numbers that differ by a multiple of it count as the same, as angles do by full turns.
    either_sign : bool
        Whether opposite numbers count as the same, as those of quaternions do.
    example : object
        An answer to the exercise that earns `otherwise`; needed if a function is among the rest.
    """

    def __init__(
        self,
        right: Any,
        *mistakes: Mistake,
        otherwise: Wrong,
        item: int | slice | None = None,
        within: float = WITHIN,
        period: float | None = None,
        either_sign: bool = False,
        example: Any = None,
    ) -> None:
        self.right = right
        self.mistakes = mistakes
        self.otherwise = otherwise
        self.item = item
        self.within = within
        self.period = period
        self.either_sign = either_sign
        self.example = example

    def judge(self, given: Any) -> Wrong | Mistake | None:
        """Return None if an item is right, else the first mistake it fits, or `otherwise`."""
        if self.fits(given, self.right):
            return None
        return next((m for m in self.mistakes if self.fits(given, m.result)), self.otherwise)

    def fits(self, given: Any, result: Any) -> bool:
        """Tell whether an answer is a result, or has the property that a function tests."""
        if callable(result):
            return bool(result(*given) if isinstance(given, tuple) else result(given))
        wanted = np.asarray(result, np.float64)
        return self.near(given - wanted) or (self.either_sign and self.near(given + wanted))

    def near(self, off: Array) -> bool:
        """Tell whether differences are small, but for full periods."""
        if self.period is not None:
            # Any huge number would be a number of full turns, up to rounding.
            off = off - self.period * np.round(off / self.period).clip(-TURNS, TURNS)
        return bool((np.abs(off) <= self.within).all())


@dataclass(frozen=True)
class Exercise:
    """An exercise of the book.

    Attributes
    ----------
    number : str
        The number it has in the book.
    expects : str
        The form of an answer, to complete the sentence "Expected ...".
    because : str
        A sentence that a right answer earns; may be empty.
    state : callable
        Function that yields the parts by which an answer is judged.
    read : callable, optional
        Function that makes of an answer what is judged. It may raise anything if the answer does
        not have the expected form. If there is none, an answer has the shape of the right one.
    fields : mapping of str to str
        Names and units of numbers for which the page has a form; it knows values, not functions.
    """

    number: str
    expects: str
    because: str
    state: Callable[[], Iterable[Part]]
    read: Callable[[Any], Any] | None = None
    fields: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """What an answer is judged by, step by step."""
        return tuple(self.state())

    def judge(self, answer: Any) -> Wrong | Mistake | None:
        """Return None if a plain answer is right, else what is wrong at the first step."""
        read = (self.read or numbers(*np.shape(self.parts[0].right)))(answer)
        for part in self.parts:
            if wrong := part.judge(read if part.item is None else read[part.item]):
                return wrong
        return None


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
    number: str,
    *,
    expects: str,
    because: str = "",
    read: Callable[[Any], Any] | None = None,
    fields: Mapping[str, str] | None = None,
) -> Callable[[Callable[[], Iterable[Part]]], Callable[[], Iterable[Part]]]:
    """Register the function below as the check of an exercise.

    Parameters
    ----------
    number, expects, because, read, fields : str, callable, mapping
        As in `Exercise`. `numbers`, `word` and `parts` make readers.

    Returns
    -------
    callable
        A decorator that returns its function unchanged. The function yields one `Part` or several;
        each is judged only if those before it are right.
    """

    def register(state: Callable[[], Iterable[Part]]) -> Callable[[], Iterable[Part]]:
        if number in EXERCISES:
            raise ValueError(f"exercise {number} has two checks")
        EXERCISES[number] = Exercise(number, expects, because, state, read, fields or {})
        return state

    return register


def check(number: str, answer: Any, hint: int = 1) -> Verdict:
    """Check the answer to an exercise.

    Parameters
    ----------
    number : str
        The number of the exercise, such as "3.1".
    answer : object
        Your answer; ``...`` means that there is none yet. It is not changed, and what a function
        among the answers prints is not shown.
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
    wrong: Wrong | Mistake | None
    try:
        with quiet():
            given = plain(answer)
            if holds(given, lambda item: item is ...):
                return Verdict(number, None, "not answered yet.")
            wrong = asked.judge(given)
    except KeyboardInterrupt:
        # Only this comes from outside: a function among the answers may never return.
        raise
    except BaseException as error:
        form = f"Expected {asked.expects}."
        infinite = isinstance(error, FloatingPointError)
        wrong = Wrong(
            "Some numbers are not finite. " * infinite + form,
            f"{form} Python says: {said_by(error)}",
        )
    if wrong is None:
        return Verdict(number, True, f"right. {asked.because}".rstrip())
    if hint == 1:
        more = f'For more: check("{number}", answer, hint=2)'
        return Verdict(number, False, f"not yet. {wrong.first}\n{more}")
    return Verdict(number, False, f"not yet. {wrong.second}")


@contextmanager
def quiet() -> Iterator[None]:
    """Show nothing that is printed, and no warning."""
    with (
        open(os.devnull, "w", encoding="utf-8", errors="replace") as nowhere,
        redirect_stdout(nowhere),
        redirect_stderr(nowhere),
        np.errstate(all="ignore"),
    ):
        yield


def said_by(error: BaseException) -> str:
    """Return the beginning of what an error says, or its name."""
    try:
        text = str(error)
    except Exception:
        text = ""
    return " ".join((text or type(error).__name__)[:LONGEST].split())


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


def close(a: npt.ArrayLike, b: npt.ArrayLike, within: float = WITHIN) -> bool:
    """Tell whether arrays have one shape and differ nowhere by more than a bound."""
    a, b = np.asarray(a, np.float64), np.asarray(b, np.float64)
    return a.shape == b.shape and bool((np.abs(a - b) <= within).all())


def unit(vector: npt.ArrayLike, within: float = 1e-3) -> bool:
    """Tell whether a vector has length 1."""
    return close(np.linalg.norm(vector), 1, within)


def same_rotation(a: Any, b: Any, within: float = WITHIN) -> bool:
    """Tell whether two rotations, each in any form of `as_rotation`, are the same."""
    return close(as_rotation(a), as_rotation(b), within)


def same_turn(turn: Any, rotation: Any, within: float) -> bool:
    """Tell whether a pair of an axis and an angle in degrees makes a rotation."""
    axis, degrees = turn
    return same_rotation((axis, np.deg2rad(degrees)), rotation, within)


def degrees_for_radians(answer: npt.ArrayLike, right: npt.ArrayLike, within: float = 0.1) -> bool:
    """Tell whether an angle that should be in radians is right in degrees."""
    return close(answer, np.rad2deg(right), within)


def radians_for_degrees(answer: npt.ArrayLike, right: npt.ArrayLike, within: float = 0.01) -> bool:
    """Tell whether an angle that should be in degrees is right in radians."""
    return close(answer, np.deg2rad(right), within)


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
