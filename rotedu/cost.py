"""Operation counts, found by running the code.

`count` calls a function on scalars that record every operation done with them. Nothing is
estimated, since the counted code is the same that otherwise runs on floating-point arrays.
"""

import operator
from collections import Counter
from collections.abc import Callable
from dataclasses import astuple, dataclass
from numbers import Real
from typing import Any

import numpy as np

__all__ = ["OperationCount", "count"]


@dataclass(frozen=True)
class OperationCount:
    """Numbers of arithmetic operations, which can be added and multiplied by integers.

    Attributes
    ----------
    multiplications, additions, divisions, square_roots : int
        A subtraction counts as an addition. Sign changes and comparisons are free.
    trigonometric : int
        Calls of sine, cosine, tangent and their inverses.

    Examples
    --------
    >>> build, apply = OperationCount(24, 10), OperationCount(9, 6)
    >>> total = build + 100 * apply
    >>> total.multiplications, total.additions
    (924, 610)
    """

    multiplications: int = 0
    additions: int = 0
    divisions: int = 0
    square_roots: int = 0
    trigonometric: int = 0

    def __add__(self, other: "OperationCount") -> "OperationCount":
        return OperationCount(*map(operator.add, astuple(self), astuple(other)))

    def __mul__(self, times: int) -> "OperationCount":
        return OperationCount(*(times * number for number in astuple(self)))

    __rmul__ = __mul__


def count(function: Callable[..., object], *args: Any) -> OperationCount:
    """Count the operations that ``function(*args)`` does with the numbers in `args`.

    Parameters
    ----------
    function : callable
        Function of numbers and arrays, written with operators and NumPy.
    *args : float or array_like
        Its arguments. Numbers, and the numbers in arrays, are replaced by counting scalars of the
        same value; lists and tuples become arrays. What needs a plain number, such as an exponent,
        is a constant of the function.

    Returns
    -------
    OperationCount
        Operations on the numbers of `args` and on everything computed from them. Operations on
        other numbers alone, such as constants of the function, are not counted.

    Raises
    ------
    TypeError
        If the function needs an operation that cannot be counted, such as ``math.cos``.

    Notes
    -----
    Functions of this package do not normalise unit vectors of counting scalars, so the cost of
    normalising an axis is not part of the cost of the formula.

    References
    ----------
    Cheng et al. (2023), Section 3, which gives 24 multiplications and 10 additions for (3-3), and
    9 and 6 for (3-2).

    Examples
    --------
    >>> from rotedu.ordinary_rotation import rotation_matrix
    >>> count(rotation_matrix, [0, 0, 1], 0.5)  # doctest: +NORMALIZE_WHITESPACE
    OperationCount(multiplications=24, additions=10, divisions=0, square_roots=0,
                   trigonometric=2)
    """
    tally: Counter[str] = Counter()

    def counting(value: object) -> object:
        if isinstance(value, CountingScalar):
            return CountingScalar(value, tally)
        if isinstance(value, Real) and not isinstance(value, bool):
            return CountingScalar(np.float64(float(value)), tally)
        return value

    function(*map(np.frompyfunc(counting, 1, 1), args))
    return OperationCount(**tally)


def _binary(kind: str, operation: Callable[[Any, Any], Any]) -> Any:
    """Make a counted operator and its reflection."""

    def forward(self: "CountingScalar", other: Any) -> Any:
        # Leave it to the array, which calls this operator again for each of its elements.
        if not isinstance(other, Real | CountingScalar):
            return NotImplemented
        return self.counted(kind, operation(self.value, self.bare(other)))

    def reflected(self: "CountingScalar", other: Any) -> Any:
        if not isinstance(other, Real):
            return NotImplemented
        return self.counted(kind, operation(other, self.value))

    return forward, reflected


def _unary(kind: str, operation: Callable[[Any], Any]) -> Any:
    return lambda self: self.counted(kind, operation(self.value))


def _free(operation: Callable[..., Any]) -> Any:
    return lambda self: CountingScalar(operation(self.value), self.tally)


def _comparison(operation: Callable[[Any, Any], bool]) -> Any:
    return lambda self, other: operation(self.value, self.bare(other))


class CountingScalar:
    """A number that records every operation done with it in a tally.

    NumPy calls the methods ``cos``, ``sqrt`` and so on of the elements of an object array. The
    value may be a counting scalar of another tally, so that counts can be nested. Nothing is
    converted to float, because operations on a float would go uncounted.
    """

    __slots__ = ("tally", "value")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, value: Any, tally: Counter[str]) -> None:
        self.value, self.tally = value, tally

    def __repr__(self) -> str:
        return f"CountingScalar({self.value!r})"

    def __bool__(self) -> bool:
        return bool(self.value)

    def counted(self, kind: str, value: Any) -> "CountingScalar":
        """Record an operation in the tally and wrap its result."""
        self.tally[kind] += 1
        return CountingScalar(value, self.tally)

    def bare(self, other: Any) -> Any:
        """Unwrap the other operand if it counts for the same tally."""
        same = isinstance(other, CountingScalar) and other.tally is self.tally
        return other.value if same else other

    def __pow__(self, exponent: int) -> "CountingScalar":
        """Multiply out; only positive integer powers can be counted."""
        if not isinstance(exponent, int) or exponent < 1:
            return NotImplemented
        return self if exponent == 1 else self ** (exponent - 1) * self

    __add__, __radd__ = _binary("additions", operator.add)
    __sub__, __rsub__ = _binary("additions", operator.sub)
    __mul__, __rmul__ = _binary("multiplications", operator.mul)
    __truediv__, __rtruediv__ = _binary("divisions", operator.truediv)
    arctan2, _ = _binary("trigonometric", np.arctan2)

    __neg__, __pos__, __abs__ = _free(operator.neg), _free(operator.pos), _free(operator.abs)
    conjugate = _free(operator.pos)

    __lt__, __le__ = _comparison(operator.lt), _comparison(operator.le)
    __gt__, __ge__ = _comparison(operator.gt), _comparison(operator.ge)
    __eq__, __ne__ = _comparison(operator.eq), _comparison(operator.ne)

    sqrt = _unary("square_roots", np.sqrt)
    cos, arccos = _unary("trigonometric", np.cos), _unary("trigonometric", np.arccos)
    sin, arcsin = _unary("trigonometric", np.sin), _unary("trigonometric", np.arcsin)
    tan, arctan = _unary("trigonometric", np.tan), _unary("trigonometric", np.arctan)
