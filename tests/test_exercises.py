"""Every exercise checks its answer: it knows the right ones, the usual wrong ones, and nonsense."""

import re
from functools import cache
from itertools import product
from typing import Any

import matplotlib
import numpy as np
import pytest
from matplotlib import pyplot
from notebook_language import Page, chapters, exercises, pages

from rotedu.edition.exercises import check
from rotedu.edition.exercises.answers import plain
from rotedu.edition.exercises.judging import EXERCISES, Part, anything, exercise, otherwise, when

IN_BOOK = {number: page for page in chapters() for number in page.exercises}
GARBAGE = [None, "x", np.nan, (None, None), np.full((2, 5), 7.0), object(), {}, [], [[1], [2, 3]]]
GARBAGE.append(GARBAGE)


@cache
def answers(number: str) -> tuple[Any, Any]:
    """Run an exercise alone, after the imports and the figure of its page; return both answers."""
    page = IN_BOOK[number]
    asked = page.exercises[number]
    lines = [line for line in page.code[0].source.splitlines() if not line.startswith("%")]
    lines += [cell.source for cell in page.code if cell.source.startswith("figure = ")][:1]
    names: dict[str, Any] = {}
    with matplotlib.rc_context():
        exec("\n".join([*lines, asked.start.source]), names)
        before = names.get("answer")
        exec(asked.solution.source, names)
        pyplot.close("all")
    return before, names.get("answer")


def printed(cell: Any) -> str:
    return "".join(
        output.get("text", output.get("data", {}).get("text/plain", "")) for output in cell.outputs
    )


def test_every_exercise_of_the_book_has_a_check_and_its_own_number() -> None:
    assert set(EXERCISES) == set(exercises())


def test_a_teacher_finds_the_verdict_on_every_exercise() -> None:
    [listed] = re.findall(r"^grep -Ho '(.+?)'", pages()["run-a-class.md"].text, re.MULTILINE)
    assert not [number for number in EXERCISES if not re.search(listed, f"{number}: right")]


@pytest.mark.parametrize("page", chapters(), ids=repr)
def test_a_page_begins_with_two_drills(page: Page) -> None:
    assert max(asked.minutes for asked in list(page.exercises.values())[:2]) <= 5


@pytest.mark.parametrize("page", chapters(), ids=repr)
def test_what_looks_like_an_exercise_is_one(page: Page) -> None:
    """A cell that JupyterLab has added is no part of an exercise until it gets its id."""
    assert page.text.count("**Exercise ") == len(page.exercises)
    assert sum("check(" in cell.source for cell in page.code) == 2 * len(page.exercises)


@pytest.mark.parametrize("number", IN_BOOK)
class TestInTheBook:
    def test_the_starter_is_unanswered_and_the_solution_right(self, number: str) -> None:
        """It needs the imports of its page and nothing that another cell has made."""
        before, after = answers(number)
        assert check(number, before).right is None
        assert check(number, after).right is True

    def test_the_page_shows_both_verdicts(self, number: str) -> None:
        asked = IN_BOOK[number].exercises[number]
        assert asked.solution.source.startswith(f"# Solution of Exercise {number}\n")
        for cell, verdict in ((asked.start, "not answered yet."), (asked.solution, "right.")):
            assert cell.source.splitlines()[-1] == f'check("{number}", answer)'
            assert f"{number}: {verdict}" in printed(cell)


@pytest.mark.parametrize("number", EXERCISES)
class TestCheck:
    def test_knows_that_there_is_no_answer(self, number: str) -> None:
        for answer in (..., (..., ...), (1.0, ...), [[...]]):
            verdict = check(number, answer)
            assert verdict.right is None, answer
            assert str(verdict) == f"{number}: not answered yet.", answer

    def test_says_what_it_expects(self, number: str) -> None:
        for answer, hint in product(GARBAGE, [1, 2]):
            verdict = check(number, answer, hint)
            assert verdict.right is False, answer
            assert EXERCISES[number].expects in verdict.text, answer

    def test_each_mistake_and_all_else_get_their_own_hints(self, number: str) -> None:
        asked = EXERCISES[number]
        hints = {(first, m.second) for part in asked.parts for first, m in part.hints.items()}
        for part in asked.parts:
            for first, mistake in part.hints.items():
                for result in mistake.results:
                    if mistake.example is not None:
                        hint = asked.judge(plain(mistake.example))
                    elif result is anything:
                        hint = part.judge(1.37 * np.array(part.right) + 0.79)
                    else:
                        hint = part.judge(result)
                    assert hint == (first, mistake.second)
            assert part.right is None or mistake.result is anything
        assert len(hints) >= 2
        assert all(second not in first for first, second in hints)


def test_an_unknown_number_is_refused() -> None:
    with pytest.raises(ValueError, match=r"'9\.9'"):
        check("9.9", 1)


def test_a_number_is_refused_twice() -> None:
    with pytest.raises(ValueError, match=r"3\.2 has two checks"):
        exercise("3.2", "nothing")(lambda: [])


def test_a_hint_has_two_stages() -> None:
    first, second = (check("3.2", [2, -1, 3], hint=stage) for stage in (1, 2))
    assert first.text == ('not yet. This turns clockwise.\nFor more: check("3.2", answer, hint=2)')
    assert second.text == "not yet. Seen from the tip of W, where does U go first?"
    assert check("3.2", [-2, 1, 3]).text == "right. What lies along the axis stays where it is."


MISTAKE, OTHER = ("a mistake", "more"), ("another", "even more")


def judged(right: Any, mistake: Any, *given: Any, **asked: Any) -> list[Any]:
    """What a part with one mistake says to answers."""
    hints = {MISTAKE[0]: when(mistake, MISTAKE[1]), OTHER[0]: otherwise(OTHER[1])}
    return [Part(right, hints, **asked).judge(np.array(answer)) for answer in given]


class TestPart:
    def test_a_sign_may_not_count(self) -> None:
        said = judged([1, -1], [2, 2], [1, -1], [-1, 1], [-2, -2], [1, 1], either_sign=True)
        assert said == [None, None, MISTAKE, OTHER]

    def test_full_turns_do_not_count(self) -> None:
        said = judged(350, 90, -10, 710, 351, 450, 352, within=1, period=360)
        assert said == [None, None, None, MISTAKE, OTHER]
        assert judged(350, 90, 1e30, -1e60, 1e300, within=1, period=360) == 3 * [OTHER]
        assert judged(350, 90, -10, within=1) == [OTHER]


def test_a_form_has_a_field_for_each_number() -> None:
    for asked in filter(lambda asked: asked.fields, EXERCISES.values()):
        assert sum(np.size(part.right) for part in asked.parts) == len(asked.fields), asked.number
