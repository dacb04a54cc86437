"""Every exercise checks its answer: it knows the right ones, the usual wrong ones, and nonsense."""

import re
from functools import cache
from pathlib import Path
from typing import Any

import matplotlib
import nbformat
import numpy as np
import pytest
from matplotlib import pyplot

from rotedu.edition.exercises import check
from rotedu.edition.exercises.judging import EXERCISES, Mistake, Part, Wrong, exercise

ROOT = Path(__file__).parents[1]
IN_ORDER = re.findall(r"file: (book/0\d-[\w-]+)", (ROOT / "_toc.yml").read_text("utf-8"))
PAGES = [ROOT / f"{name}.ipynb" for name in IN_ORDER]
HEADING = re.compile(r"^\*\*Exercise ([\d.]+)\*\* \([^)]*?(\d+) minutes\)", re.MULTILINE)
GARBAGE = [None, "x", np.nan, (None, None), np.full((2, 5), 7.0), object(), {}, [], [[1], [2, 3]]]
GARBAGE.append(GARBAGE)


def text_of(page: Path) -> str:
    cells = nbformat.read(page, as_version=4).cells
    return "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")


def cells_of(page: Path) -> dict[str, list[Any]]:
    """Return the code cells of each exercise of a page: starter cells and solution."""
    numbers: list[str] = []
    cells: dict[str, list[Any]] = {}
    for cell in nbformat.read(page, as_version=4).cells:
        if cell.cell_type == "markdown":
            numbers += [number for number, _ in HEADING.findall(cell.source)]
        elif numbers:
            cells.setdefault(numbers[-1], []).append(cell)
    return cells


IN_BOOK = {number: (page, cells) for page in PAGES for number, cells in cells_of(page).items()}


@cache
def answers(number: str) -> tuple[Any, Any]:
    """Run an exercise alone, after the imports of its page; return the answers before and after."""
    page, (*starters, solution) = IN_BOOK[number]
    cells = nbformat.read(page, as_version=4).cells
    imports = next(cell.source for cell in cells if cell.cell_type == "code")
    lines = [line for line in imports.splitlines() if not line.startswith("%")]
    names: dict[str, Any] = {}
    with matplotlib.rc_context():
        exec("\n".join([*lines, *(cell.source for cell in starters)]), names)
        before = names.get("answer")
        exec(solution.source, names)
        pyplot.close("all")
    return before, names.get("answer")


def printed(cell: Any) -> str:
    return "".join(
        output.get("text", output.get("data", {}).get("text/plain", "")) for output in cell.outputs
    )


def test_every_exercise_of_the_book_has_a_check() -> None:
    assert set(EXERCISES) == set(IN_BOOK)
    assert len(IN_BOOK) >= 45


def test_exercises_are_numbered_in_the_order_of_the_pages() -> None:
    found = [number for page in PAGES for number, _ in HEADING.findall(text_of(page))]
    chapters = [int(number.partition(".")[0]) for number in found]
    expected = [f"{c}.{chapters[: i + 1].count(c)}" for i, c in enumerate(chapters)]
    assert found == expected
    assert chapters == sorted(chapters)


@pytest.mark.parametrize("page", [page for page in PAGES], ids=lambda page: page.stem)
def test_a_page_begins_with_two_drills(page: Path) -> None:
    minutes = [int(minutes) for _, minutes in HEADING.findall(text_of(page))]
    assert max(minutes[:2]) <= 5


@pytest.mark.parametrize("number", IN_BOOK)
class TestInTheBook:
    def test_an_exercise_stands_on_its_own(self, number: str) -> None:
        """It needs the imports of its page and nothing that another cell has made."""
        answers(number)
        solution = IN_BOOK[number][1][-1].source
        assert solution.startswith(f"# Solution of Exercise {number}\n")

    def test_the_starter_is_unanswered_and_the_solution_right(self, number: str) -> None:
        before, after = answers(number)
        assert check(number, before).right is None
        assert check(number, after).right is True

    def test_the_page_shows_both_verdicts(self, number: str) -> None:
        *_, starter, solution = IN_BOOK[number][1]
        for cell, verdict in ((starter, "not answered yet."), (solution, "right.")):
            assert cell.source.splitlines()[-1] == f'check("{number}", answer)'
            assert f"{number}: {verdict}" in printed(cell)


@pytest.mark.parametrize("number", EXERCISES)
class TestCheck:
    @pytest.mark.parametrize("answer", [..., (..., ...), (1.0, ...), [[...]]])
    def test_knows_that_there_is_no_answer(self, number: str, answer: Any) -> None:
        verdict = check(number, answer)
        assert verdict.right is None
        assert str(verdict) == f"{number}: not answered yet."

    @pytest.mark.parametrize("answer", GARBAGE, ids=repr)
    @pytest.mark.parametrize("hint", [1, 2])
    def test_says_what_it_expects(self, number: str, answer: Any, hint: int) -> None:
        verdict = check(number, answer, hint)
        assert verdict.right is False
        assert EXERCISES[number].expects in verdict.text

    def test_each_mistake_and_all_else_get_their_own_hints(self, number: str) -> None:
        asked = EXERCISES[number]
        hints = set()
        for part in asked.parts:
            for result, *hint, example in part.mistakes:
                wrong = asked.judge(example) if callable(result) else part.judge(result)
                assert wrong is not None
                assert [wrong.first, wrong.second] == hint
            far = 1.37 * np.array(part.right, float) + 0.79 if part.example is None else None
            other = asked.judge(part.example) if far is None else part.judge(far)
            assert other is part.otherwise
            hints.update((wrong.first, wrong.second) for wrong in (*part.mistakes, part.otherwise))
        assert len(hints) >= 2
        assert all(second not in first for first, second in hints)


def test_an_unknown_number_is_refused() -> None:
    with pytest.raises(ValueError, match=r"'9\.9'"):
        check("9.9", 1)


def test_the_letters_of_a_word_are_no_parts() -> None:
    assert "the number of parts is 1" in check("3.3", "transpose", hint=2).text


def test_a_number_is_refused_twice() -> None:
    with pytest.raises(ValueError, match=r"3\.1 has two checks"):
        exercise("3.1", expects="nothing")(lambda: [])


def test_a_hint_has_two_stages() -> None:
    first, second = (check("3.1", [2, -1, 3], hint=stage) for stage in (1, 2))
    assert first.text == ('not yet. This turns clockwise.\nFor more: check("3.1", answer, hint=2)')
    assert second.text == "not yet. Seen from the tip of W, where does U go first?"


OTHER = Wrong("another", "more")


class TestPart:
    def test_every_number_must_be_right(self) -> None:
        swapped = Mistake([2, 1], "a mistake", "more")
        pair = Part([1, 2], swapped, otherwise=OTHER, within=0.1)
        assert pair.judge(np.array([1.09, 1.91])) is None
        assert pair.judge(np.array([1.09, 1.89])) is OTHER
        assert pair.judge(np.array([2.0, 1.0])) is swapped

    def test_a_sign_may_not_count(self) -> None:
        double = Mistake([2, 2], "a mistake", "more")
        pair = Part([1, -1], double, otherwise=OTHER, either_sign=True)
        verdicts = [pair.judge(np.array(given)) for given in ([1, -1], [-1, 1], [-2, -2], [1, 1])]
        assert verdicts == [None, None, double, OTHER]

    def test_full_turns_do_not_count(self) -> None:
        quarter = Mistake(90, "a mistake", "more")
        angle = Part(350, quarter, otherwise=OTHER, within=1, period=360)
        verdicts = [angle.judge(number) for number in (-10, 710, 351, 450, 352)]
        assert verdicts == [None, None, None, quarter, OTHER]
        assert Part(350, otherwise=OTHER, within=1).judge(-10) is OTHER

    def test_a_function_takes_a_tuple_as_arguments(self) -> None:
        assert Part(lambda a, b: a > b, otherwise=OTHER).judge((2, 1)) is None
        assert Part(lambda a: a[0] > a[1], otherwise=OTHER).judge(np.array([1, 2])) is OTHER


@pytest.mark.parametrize("number", [n for n, asked in EXERCISES.items() if asked.fields])
class TestNumeric:
    def test_has_a_field_for_each_number(self, number: str) -> None:
        asked = EXERCISES[number]
        assert sum(np.size(part.right) for part in asked.parts) == len(asked.fields)

    def test_refuses_complex_numbers(self, number: str) -> None:
        right = np.concatenate([np.ravel(part.right) for part in EXERCISES[number].parts])
        right = right if len(right) > 1 else right[0]
        assert check(number, right).right
        assert "some numbers are complex" in check(number, right + 1j, hint=2).text
