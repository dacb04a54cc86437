"""Numbers with which numpy can compute and sympy can prove identities."""

import operator
from typing import Any

import numpy as np
import sympy as sp


def _operator(operation: Any) -> Any:
    def apply(self: "Symbolic", other: Any) -> Any:
        if isinstance(other, np.ndarray):
            return NotImplemented
        return Symbolic(operation(self.value, sp.nsimplify(bare(other))))

    def reflected(self: "Symbolic", other: Any) -> Any:
        return Symbolic(operation(sp.nsimplify(other), self.value))

    return apply, reflected


def _comparison(operation: Any) -> Any:
    return lambda self, other: bool(operation(self.value, bare(other)))


def _function(function: Any) -> Any:
    return lambda self: Symbolic(function(self.value))


class Symbolic:
    """A sympy expression with the methods that numpy looks for in the elements of an array."""

    __hash__ = None  # type: ignore[assignment]

    def __init__(self, value: Any) -> None:
        self.value = sp.sympify(value)

    __add__, __radd__ = _operator(operator.add)
    __sub__, __rsub__ = _operator(operator.sub)
    __mul__, __rmul__ = _operator(operator.mul)
    __truediv__, __rtruediv__ = _operator(operator.truediv)
    __eq__, __ne__ = _comparison(operator.eq), _comparison(operator.ne)
    __le__, __lt__ = _comparison(operator.le), _comparison(operator.lt)

    def __neg__(self) -> "Symbolic":
        return Symbolic(-self.value)

    cos, sin, tan, sqrt = map(_function, (sp.cos, sp.sin, sp.tan, sp.sqrt))

    def arctan2(self, other: Any) -> "Symbolic":
        return Symbolic(sp.atan2(self.value, bare(other)))


def bare(value: Any) -> Any:
    return value.value if isinstance(value, Symbolic) else value


def symbolic(*values: Any) -> Any:
    """Wrap expressions: one as it is, several as an array."""
    wrapped = [Symbolic(value) for value in values]
    return wrapped[0] if len(wrapped) == 1 else np.array(wrapped)


def matrix(array: Any) -> sp.Matrix:
    """Turn the results of a computation back into sympy expressions."""
    array = np.asarray(array)
    return sp.Matrix(np.frompyfunc(bare, 1, 1)(array if array.ndim else array[None]))


def vanishes(difference: Any) -> bool:
    """Whether expressions with sines and cosines are identically zero."""
    entries = difference if isinstance(difference, sp.MatrixBase) else [difference]
    return all(sp.expand(sp.expand_trig(x).rewrite(sp.exp)).simplify() == 0 for x in entries)
