"""How answers are judged: the register of exercises, and what a check consists of.

A check yields parts: what is right, a value or a function that tests a property, and the hints that
other answers earn. With each hint stands the mistake that earns it, and a second stage.
"""

import io
from collections.abc import Callable, Iterable, Mapping
from contextlib import redirect_stdout
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from rotedu._vectors import Array
from rotedu.edition.exercises.answers import WITHIN, holds, numbers, plain

# How many full turns may be too many in an angle; answers.js says so, too.
TURNS = 1000
# How many letters of an error a verdict quotes.
LONGEST = 200

Hint = tuple[str, str]
"""Two stages. Neither gives the answer away."""

State = Callable[[], Iterable["Part"]]
"""What yields the parts of a check."""


class Mistake(NamedTuple):
    """What earns a hint, and the second stage of this hint.

    The result is what a usual mistake leads to, or a function that tells whether an answer shows
    it. A function needs an example, an answer for which a test demands this hint. A hint that two
    mistakes earn has two results.
    """

    result: Any
    second: str
    example: Any = None
    also: Any = None

    @property
    def results(self) -> list[Any]:
        """All that leads to the hint."""
        return [self.result] if self.also is None else [self.result, self.also]


when = Mistake


def anything(*_: Any) -> bool:
    """Tell that an answer is one."""
    return True


def otherwise(second: str, example: Any = None) -> Mistake:
    """Return what earns the last hint of a part: all other answers.

    The example is needed if a function is among the rest of the part.
    """
    return Mistake(anything, second, example)


def usual(first: str, second: str) -> Callable[..., dict[str, Mistake]]:
    """Return a function that makes a hint of a mistake which several exercises know."""
    return lambda result=anything, example=None: {first: Mistake(result, second, example)}


in_radians = usual("Are these radians?", "The exercise asks for degrees.")
angle_in_radians = usual("Your angle is in radians.", "A full turn has 360 degrees.")
scalar_last = usual("Does your scalar part come last?", "In this book it comes first.")
# What went into a simulated measurement.
the_truth = usual(
    "This is the truth, exactly. Nobody who measures knows it.",
    "The cell knows it only to make the data. Find your answer from the data alone.",
)


@dataclass(frozen=True)
class Part:
    """One step of a check.

    Attributes
    ----------
    right : array_like or callable, optional
        The right numbers, or a function that tells whether what was read is right; a tuple becomes
        several arguments. Without it, all is right that earns no hint.
    hints : mapping of str to Mistake
        For each hint, by its first stage, `when` it is given. The first that fits counts; the last
        is for all answers `otherwise`.
    item : int or slice, optional
        Which item of what was read is judged; everything if it is not given.
    within, period, either_sign : float, optional float, bool
        Numbers count as the same if they differ by no more than this; by a multiple of the period,
        as angles do by full turns; or by their sign, as quaternions do.
    """

    right: Any
    hints: Mapping[str, Mistake]
    item: int | slice | None = None
    within: float = WITHIN
    period: float | None = None
    either_sign: bool = False

    def judge(self, given: Any) -> Hint | None:
        """Return None if an item is right, else the first hint that it earns."""
        if self.right is not None and self.fits(given, self.right):
            return None
        earned = (
            (first, mistake.second)
            for first, mistake in self.hints.items()
            if any(self.fits(given, result) for result in mistake.results)
        )
        return next(earned, None)

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
    state : callable
        Function that yields the parts; each is judged only if those before it are right.
    expects, because : str
        How "Expected ..." goes on, the form of an answer; a sentence that a right answer earns.
    read : callable, optional
        Function that makes of a plain answer what is judged. It may raise anything if the answer
        does not have the expected form. If there is none, an answer is a number for each field, or
        has the shape of the right one.
    fields : mapping of str to str
        Names and units of numbers for which the page has a form; it knows values, not functions.
    """

    number: str
    state: State
    expects: str
    because: str = ""
    read: Callable[[Any], Any] | None = None
    fields: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """What an answer is judged by, step by step."""
        return tuple(self.state())

    def judge(self, answer: Any) -> Hint | None:
        """Return None if a plain answer is right, else the hint of the first step that is not."""
        shape = (len(self.fields),) if len(self.fields) > 1 else np.shape(self.parts[0].right)
        read = (self.read or numbers(*shape))(answer)
        for part in self.parts:
            if hint := part.judge(read if part.item is None else read[part.item]):
                return hint
        return None


@dataclass(frozen=True, repr=False)
class Verdict:
    """What a check says about an answer.

    It is shown as the number of the exercise and a text; `right` is None without an answer.
    """

    number: str
    right: bool | None
    text: str

    def __repr__(self) -> str:
        return f"{self.number}: {self.text}"


EXERCISES: dict[str, Exercise] = {}


def exercise(number: str, expects: str, **more: Any) -> Callable[[State], State]:
    """Register the function below as the check of an exercise; all else is as in `Exercise`.

    Its docstring, if there is one, is the sentence that a right answer earns.
    """

    def register(state: State) -> State:
        if number in EXERCISES:
            raise ValueError(f"exercise {number} has two checks")
        EXERCISES[number] = Exercise(number, state, expects, state.__doc__ or "", **more)
        return state

    return register


def check(number: str, answer: Any, hint: int = 1) -> Verdict:
    """Check the answer to an exercise.

    Parameters
    ----------
    number : str
        The number of the exercise, such as "3.2".
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
    >>> check("3.2", ...)
    3.2: not answered yet.
    """
    if number not in EXERCISES:
        raise ValueError(f'no exercise has the number {number!r}; write it as in "3.2"')
    asked = EXERCISES[number]
    try:
        with redirect_stdout(io.StringIO()), np.errstate(all="ignore"):
            given = plain(answer)
            if holds(given, lambda item: item is ...):
                return Verdict(number, None, "not answered yet.")
            wrong = asked.judge(given)
    except (Exception, SystemExit) as error:
        form = f"Expected {asked.expects}."
        infinite = "Some numbers are not finite. " * isinstance(error, FloatingPointError)
        said = " ".join(str(error)[:LONGEST].split()) or type(error).__name__
        wrong = infinite + form, f"{form} Python says: {said}"
    if wrong is None:
        return Verdict(number, True, f"right. {asked.because}".rstrip())
    first, second = wrong
    if hint == 1:
        more = f'For more: check("{number}", answer, hint=2)'
        return Verdict(number, False, f"not yet. {first}\n{more}")
    return Verdict(number, False, f"not yet. {second}")
