"""An answer may be anything that Python knows: it gets a calm verdict and is not changed."""

from decimal import Decimal
from fractions import Fraction
from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest
import sympy

from rotedu.cost import OperationCount
from rotedu.edition.exercises import check
from rotedu.edition.exercises.answers import COMPLEX, plain
from rotedu.edition.exercises.judging import EXERCISES
from rotedu.quaternions import Quaternion

ODD: dict[str, Any] = {
    "lists in lists": 1.0,
    "an integer": 10**5000,
    "infinity": (np.inf, -np.inf, 0),
    "a record": np.zeros(3, "f8, i4"),
    "an iterator": iter([1.0, 2.0, 3.0]),
    "words": ["<b>", "\0", "\ud800"],
    "a long text": "0" * 10**6,
    "a class": float,
    "a symbol": sympy.Symbol("x"),
    "a function of nothing": lambda: 1,
    "a function that raises": Mock(side_effect=RuntimeError("no\n" * 10**6)),
    "a function that exits": Mock(side_effect=SystemExit),
    "a function that prints": lambda *_: print("printed") or 0.0,
    "a function that returns a complex": lambda *_: np.complex128(1),
}
for _ in range(2000):
    ODD["lists in lists"] = [ODD["lists in lists"]]
# A word, a matrix, parts of parts, a list of any length, and a function.
OF_EACH_KIND = ["1.4", "2.4", "3.2", "3.4", "4.8", "5.14", "5.22"]


@pytest.mark.parametrize("number", OF_EACH_KIND)
@pytest.mark.parametrize("name", ODD)
def test_an_odd_answer_gets_a_calm_verdict(
    number: str, name: str, capfd: pytest.CaptureFixture[str], recwarn: pytest.WarningsRecorder
) -> None:
    first, second = (check(number, ODD[name], hint) for hint in (1, 2))
    assert first.right is second.right is not True
    assert max(len(str(first)), len(str(second))) < 500
    # A rule that prints may be a rule.
    if (number, name) != ("5.14", "a function that prints"):
        assert f"Expected {EXERCISES[number].expects}. Python says: " in second.text
    assert capfd.readouterr() == ("", "")
    assert not recwarn.list


def test_an_interrupted_check_ends() -> None:
    with pytest.raises(KeyboardInterrupt):
        check("5.14", Mock(side_effect=KeyboardInterrupt))


class TestPlain:
    @pytest.mark.parametrize(
        ("answer", "expected"),
        [
            (..., ...),
            (None, None),
            (np.True_, True),
            (np.str_("word"), "word"),
            (10**20, 1e20),
            (Fraction(1, 4), 0.25),
            (Decimal("0.25"), 0.25),
            (sympy.sqrt(4) / 8, 0.25),
            (np.float32(0.25), 0.25),
            ((1, [2, (3,)]), [1, [2, [3]]]),
            (range(3), [0, 1, 2]),
            (np.array(["a", 1], object), ["a", 1]),
            (sympy.Matrix([[1, 2]]), [[1, 2]]),
            (Quaternion(1, [2, 3, 4]), [1, 2, 3, 4]),
            (OperationCount(5, 6, 7), [5, 6]),
        ],
    )
    def test_reads_what_a_reader_may_mean(self, answer: Any, expected: Any) -> None:
        data = plain(answer)
        assert (data.tolist() if isinstance(data, np.ndarray) else data) == expected

    def test_copies_arrays(self) -> None:
        answer = np.ones(3)
        data = plain([answer])
        data[0][:] = 2
        assert (answer == 1).all()

    def test_reads_what_a_function_returns(self) -> None:
        assert plain(lambda x: (x, Fraction(1, 4)))(2) == [2, 0.25]
        with pytest.raises(ValueError, match="complex"):
            plain(lambda: 1j)()

    def test_says_how_a_complex_number_becomes_real(self) -> None:
        for answer in ([1 + 0j, 0, 0], np.ones(3, np.complex64), np.array([1, 0j, 0], object)):
            assert COMPLEX in check("3.2", answer, hint=2).text
