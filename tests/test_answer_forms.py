"""The page checks answers that are a few numbers, and its verdict is Python's."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from html_pages import parse
from nightly import nightly

from rotedu.edition.exercises import check
from rotedu.edition.exercises.judging import EXERCISES

NUMERIC = {number: asked for number, asked in EXERCISES.items() if asked.fields}
FORM = ".answer-form:has(legend:text-is('Check your answer to {} here'))"
# Fill in each of several answers afresh, check it twice, and return both verdicts.
CHECK_ALL = """(place, answers) => answers.map((answer) => {
    const form = place.querySelector("form");
    form.querySelectorAll("input").forEach((input, i) => { input.value = answer[i]; });
    return [1, 2].map(() => {
        form.requestSubmit();
        return form.querySelector("output").textContent;
    });
})"""


@pytest.fixture(scope="module")
def pages(book: Path) -> dict[str, str]:
    """The page of each exercise with a form."""
    found = {}
    for file in sorted((book / "book").glob("*.html")):
        for place in parse(file).select(".answer-form"):
            number = json.loads(place["data-asked"])["number"]
            assert f'check("{number}", answer)' in place.find_previous_sibling("div").get_text()
            found[number] = f"book/{file.name}"
    return found


@pytest.fixture
def form(browser: Any, site: str, pages: dict[str, str], request: Any) -> Iterator[Any]:
    """The form of an exercise, in a browser."""
    page = browser.new_page()
    page.goto(f"{site}/{pages[request.param]}")
    yield page.locator(FORM.format(request.param))
    page.close()


@pytest.fixture(scope="module")
def reader(browser: Any) -> Iterator[Any]:
    """A page of the browser that stays open, because loading takes longer than checking."""
    page = browser.new_page()
    yield page
    page.close()


def answers_to(number: str) -> Iterator[list[float]]:
    """Right and wrong answers, some of them just inside and just outside the tolerance."""
    right, bounds, periods = np.zeros((3, len(NUMERIC[number].fields)))
    for part in NUMERIC[number].parts:
        here = slice(None) if part.item is None else part.item
        right[here], bounds[here], periods[here] = part.right, part.within, part.period or 0
    for share in (0, 0.9, -0.9, 1.1, -2):
        yield list(right + share * bounds)
    for other in (right + periods, right - 3 * periods, right + 1e30, -right):
        yield list(other)
    for part in NUMERIC[number].parts:
        *mistakes, _ = part.hints.values()
        for result in (result for mistake in mistakes for result in mistake.results):
            answer = right.copy()
            answer[slice(None) if part.item is None else part.item] = result
            yield list(answer)


def in_page(number: str, answer: Any) -> list[str]:
    """What a form should say at the first and at the second check."""
    first, second = (check(number, answer, hint) for hint in (1, 2))
    if first.right:
        return [first.text.capitalize()[:1] + first.text[1:]] * 2
    text, _, _ = first.text.partition("\n")
    return [f"N{text[1:]} For a hint, press Check again.", f"N{second.text[1:]}"]


def test_every_numeric_exercise_has_its_form(pages: dict[str, str]) -> None:
    assert set(pages) == set(NUMERIC)


@pytest.mark.parametrize("number", nightly(NUMERIC, "5.24"))
def test_the_verdict_is_pythons(number: str, reader: Any, site: str, pages: dict[str, str]) -> None:
    address = f"{site}/{pages[number]}"
    if reader.url != address:
        reader.goto(address)
    form = reader.locator(FORM.format(number))
    answers = [list(map(float, answer)) for answer in answers_to(number)]
    assert form.locator("label").count() == len(answers[0])
    said = form.evaluate(CHECK_ALL, [[repr(x) for x in answer] for answer in answers])
    shaped = [answer if len(answer) > 1 else answer[0] for answer in answers]
    previous = ""
    for answer, (first, second) in zip(shaped, said, strict=True):
        expected = in_page(number, answer)
        # The same kind of mistake twice in a row earns the second stage at once.
        assert first == expected[previous == expected[0]], answer
        assert second == expected[1], answer
        previous = previous if second.startswith("Right.") else expected[0]
    assert any(second.startswith("Right.") for _, second in said)


@pytest.mark.slow
@pytest.mark.parametrize("form", ["5.24"], indirect=True)
def test_a_form_says_what_it_has_read(form: Any) -> None:
    asked = EXERCISES["5.24"]
    odd = ["-", "40/", "<b>40</b>", "alert(1)", "1e999", "NaN", "1/0", "1/2/3", "2**9", "4_0"]
    expected = {
        "": "Not answered yet.",
        "40,0": "Write a point, not a comma: 0.5.",
        **dict.fromkeys(
            ["40", "-320", "40\N{DEGREE SIGN}", "\u2212640/2"], f"Right. {asked.because}"
        ),
        **dict.fromkeys(odd, f"Expected {asked.expects}."),
    }
    said = form.evaluate(CHECK_ALL, [[text] for text in expected])
    assert said == [[text, text] for text in expected.values()]
    assert form.locator("output *").count() == 0
    assert form.get_by_label("angle °").get_attribute("maxlength") == "60"


@pytest.mark.slow
@pytest.mark.parametrize("form", ["5.2"], indirect=True)
def test_a_form_answers_the_keyboard_also_while_the_page_is_presented(form: Any) -> None:
    page, field = form.page, form.locator("input").first
    field.focus()
    page.keyboard.type("12")
    page.keyboard.press("Enter")
    assert form.get_by_role("status").text_content() == "Fill in every field."
    assert page.url.endswith("05-arcs.html")
    page.get_by_role("button", name="Slides").click()
    for _ in range(page.locator("article section").count()):
        if not form.is_visible():
            page.keyboard.press("ArrowRight")
    field.press("Home")
    page.keyboard.type("3")
    assert field.input_value() == "312"
    field.press("Escape")
    assert page.locator("html.presenting").count() == 1
