"""An answer may be anything: it gets a calm verdict, is not changed, and starts nothing endless."""

import asyncio
import itertools
import sys
import tracemalloc
from collections.abc import Callable, Iterator
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from rotedu.cost import OperationCount
from rotedu.edition.exercises import check
from rotedu.edition.exercises.answers import COMPLEX, plain
from rotedu.edition.exercises.judging import EXERCISES
from rotedu.quaternions import Quaternion

ATTRIBUTES = ["__class__", "__array_interface__", "components", "dtype", "shape", "size"]
METHODS = ["__array__", "__bool__", "__call__", "__complex__", "__eq__", "__float__", "__format__"]
METHODS += ["__getattribute__", "__getitem__", "__hash__", "__index__", "__iter__", "__len__"]
METHODS += ["__repr__", "__str__"]


def with_hooks(
    act: Callable[..., Any], base: type = object, hooks: list[str] = METHODS + ATTRIBUTES
) -> Any:
    """An object of a class whose every hook does the same."""
    names = {name: property(act) if name in ATTRIBUTES else act for name in hooks}
    return type("Hostile", (base,), names)()


def raises(*_: Any) -> Any:
    raise RuntimeError("no")


def leaves(*_: Any) -> Any:
    sys.exit("bye")


def prints(*_: Any) -> float:
    print("printed")
    print("printed", file=sys.stderr)
    return 0.0


def unspeakable(*_: Any) -> Any:
    raise with_hooks(raises, RuntimeError, ["__str__", "__repr__"])


def says_much(*_: Any) -> Any:
    raise ValueError("no\n" * 10**6)


def cancels(*_: Any) -> Any:
    raise asyncio.CancelledError


def forever() -> Any:
    return forever()


def recurses(*_: Any) -> Any:
    # Python 3.13.5 itself overlooks a recursion that passes by an argument with a star.
    return forever()


def inside_itself(kind: type = list) -> Any:
    answer: list[Any] = []
    answer += [kind([answer])] * 3
    return answer


def array_inside_itself() -> Any:
    answer = np.empty(3, object)
    answer[:] = [answer] * 3
    return answer


def nested(width: int, depth: int) -> Any:
    """Lists that hold one list many times: small in memory, and endless to walk through."""
    answer: Any = [1.0] * width
    for _ in range(depth):
        answer = [answer] * width
    return answer


def endless(started: list[str]) -> Iterator[float]:
    started.append("started")
    while True:
        yield 0.0


def without_end() -> Any:
    return with_hooks(lambda self: itertools.count(), hooks=["__iter__"])


STARTED: list[str] = []
HOSTILE: dict[str, Any] = {
    "complex": 1j,
    "a number with nothing imaginary": [1 + 0j, 0, 0],
    "numpy's complex": np.complex128(1),
    "a complex object": np.array([1, np.complex64(1), 2], object),
    "a list in itself": inside_itself(),
    "a tuple in a list in itself": inside_itself(tuple),
    "an array in itself": array_inside_itself(),
    "one list many times": nested(1000, 10),
    "lists in lists": nested(1, 100_000),
    "ten million items": [0.0] * 10**7,
    "a hundred million numbers": np.zeros(10**8),
    "one number seen many times": np.broadcast_to(1.0, (10**6, 10**6)),
    "large arrays, many times": [np.zeros((1000, 3))] * 10**6,
    "a range": range(10**12),
    "a range without a length": range(10**30),
    "a count": itertools.count(),
    "an iterator": iter(int, 1),
    "a generator": endless(STARTED),
    "a generator in a pair": (endless(STARTED), endless(STARTED)),
    "a class without end": without_end(),
    "a class without end, in a list": [without_end()] * 3,
    "a file": sys.stdout,
    "a long text": "0" * 10**6,
    "long texts": ["word" * 10**6] * 4,
    "an integer": 10**5000,
    "integers": [10**5000] * 3,
    "not a number": [np.nan] * 3,
    "infinity": (np.inf, -np.inf, 0),
    "a masked number": np.ma.masked,
    "a masked array": np.ma.masked_greater([1.0, 2.0, 3.0], 2),
    "masked objects": np.ma.array([1, 2, None], mask=[0, 0, 1], dtype=object),
    "a record": np.zeros(3, "f8, i4"),
    "moments": np.array(["2020", "2021", "2022"], "M8[Y]"),
    "bytes": b"0123",
    "a view of memory": memoryview(np.zeros(3)),
    "a set": {1.0, 2.0, 3.0},
    "words": ["<b>", "\0", "\ud800"],
    "a class": float,
    "a module": np,
    "a symbol": sympy.Symbol("x"),
    "an imaginary symbol": [sympy.I] * 3,
    "what raises": with_hooks(raises),
    "a list that raises": with_hooks(raises, list),
    "what leaves": with_hooks(leaves),
    "a float that leaves": with_hooks(leaves, hooks=["__float__"]),
    "nonsense": with_hooks(lambda *_: "nonsense"),
    "a length of nonsense": with_hooks(lambda *_: -1, list, ["__len__", "__getitem__"]),
    "an array of nonsense": with_hooks(lambda *_: "nonsense", hooks=["__array__"]),
    "an array of itself": with_hooks(lambda self: self, hooks=["__array__"]),
    "a table": with_hooks(lambda self: np.zeros(10**8), hooks=["__array__", "__len__"]),
    "a false array": with_hooks(lambda self: np.ndarray, hooks=["__class__"]),
    "a false list": with_hooks(lambda self: list, hooks=["__class__"]),
    "a function of nothing": lambda: 1,
    "a function that raises": raises,
    "a function that leaves": leaves,
    "a function that cancels": cancels,
    "a function that prints": prints,
    "a function that recurses": recurses,
    "a function that says much": says_much,
    "a function that cannot be told": unspeakable,
    "a function that returns much": lambda *_: np.zeros(10**8),
    "a function that returns itself": with_hooks(lambda self, *_: self, hooks=["__call__"]),
    "a function that returns what raises": lambda *_: with_hooks(raises),
    "a function that returns a complex": lambda *_: np.complex128(1),
    "functions": [leaves] * 3,
}
# A word, a matrix, parts of parts, a list of any length, and a function.
OF_EACH_KIND = ["1.4", "2.3", "3.1", "3.3", "4.7", "5.11", "5.17"]


def in_calm_words(number: str, answer: Any) -> str:
    """Return the second verdict, which has some words on what came."""
    first, second = (check(number, answer, hint) for hint in (1, 2))
    assert first.right is second.right is not True
    assert max(len(str(first)), len(str(second))) < 500
    return second.text


@pytest.mark.parametrize("number", EXERCISES)
def test_a_hostile_answer_gets_a_calm_verdict(
    number: str, capfd: pytest.CaptureFixture[str], recwarn: pytest.WarningsRecorder
) -> None:
    for name, answer in HOSTILE.items():
        text = in_calm_words(number, answer)
        # A rule that prints may be a rule.
        if (number, name) != ("5.11", "a function that prints"):
            assert f"Expected {EXERCISES[number].expects}. Python says: " in text, name
    assert STARTED == []
    assert capfd.readouterr() == ("", "")
    assert not recwarn.list


def built(plan: Any) -> Any:
    """Make an answer of names of hostile ones, and of pairs of a function and plans."""
    if isinstance(plan, tuple):
        make, items = plan
        return make([built(item) for item in items])
    return HOSTILE.get(plan, plan)


@given(
    st.recursive(
        st.sampled_from(sorted(HOSTILE)) | st.floats() | st.text() | st.just(...),
        lambda items: st.tuples(
            st.sampled_from([list, tuple, iter, enumerate, lambda some: lambda *_: some]),
            st.lists(items),
        ),
        max_leaves=8,
    ).map(built)
)
def test_a_mixture_of_all_gets_a_calm_verdict(answer: Any) -> None:
    for number in OF_EACH_KIND:
        in_calm_words(number, answer)


@pytest.mark.parametrize("number", OF_EACH_KIND)
def test_too_much_is_refused_by_its_size(number: str) -> None:
    tracemalloc.start()
    for answer in (np.broadcast_to(1.0, 10**8), range(10**12), nested(1000, 10), [[0.0]] * 10**6):
        before, _ = tracemalloc.get_traced_memory()
        tracemalloc.reset_peak()
        check(number, answer)
        _, peak = tracemalloc.get_traced_memory()
        assert peak - before < 50_000_000
    tracemalloc.stop()


def test_an_interrupted_check_ends() -> None:
    def interrupted(*_: float) -> float:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        check("5.11", interrupted)


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
            (np.ma.array([1, 2]), [1, 2]),
            (np.ones(2).view(type("Hostile", (np.ndarray,), {"__array__": raises})), [1, 1]),
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
        assert COMPLEX in check("3.1", np.linalg.eigvals(np.eye(3)[[1, 2, 0]]), hint=2).text
