"""A class of browsers on one server of static files, which all press Run within a second."""

import json
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest
from browser import serve
from notebook_language import pages

PAGE = "03-ordinary-rotation"
CELL = "code-34c"
# Thirty, as in *Run a class*, take 9 GB on one machine.
STUDENTS = 10
PATIENCE = 300_000  # milliseconds
# Resolves when the cell has run: how it ended, and what it prints.
RUN = """([name, pause]) => new Promise((resolve) => {
    const cell = document.querySelector(`[data-cell="${name}"]`);
    new MutationObserver(() => {
        const { run } = cell.dataset;
        const printed = () => cell.querySelector(".live-output").textContent;
        if (["done", "error"].includes(run)) resolve([run, printed()]);
    }).observe(cell, { attributeFilter: ["data-run"] });
    setTimeout(() => cell.querySelector("button[name=run]").click(), pause);
})"""


@pytest.fixture
def room(browser: Any, book: Path) -> Iterator[list[Any]]:
    """The page in front of each student; nobody shares anything with another."""
    with ExitStack() as stack:
        host = stack.enter_context(serve(book))
        students = [stack.enter_context(browser.new_context()).new_page() for _ in range(STUDENTS)]
        for student in students:
            student.set_default_timeout(PATIENCE)
            student.goto(f"{host}/book/{PAGE}.html")
        yield students


def all_run(room: list[Any], cell: str) -> list[list[str]]:
    """Let all students run a cell within a second."""
    for k, student in enumerate(room):
        # All of them are told before the first clicks.
        pause = 1000 * (2 + k / len(room))
        student.evaluate(f"(told) => {{ window.outcome = ({RUN})(told); }}", [cell, pause])
    return [student.evaluate("window.outcome") for student in room]


def hand_in(student: Any, answer: list[int]) -> dict[str, Any]:
    """Answer the first exercise, and save the notebook."""
    exercise = student.locator('[data-exercise="3.1"]')
    for field, number in zip(exercise.locator("form input").all(), answer, strict=True):
        field.fill(str(number))
    exercise.locator("form button").click()
    with student.expect_download() as download:
        student.locator("a.answers").click()
    notebook: dict[str, Any] = json.loads(Path(download.value.path()).read_text("utf-8"))
    return notebook


@pytest.mark.slow
@pytest.mark.chromium
def test_all_run_at_once_and_hand_in_their_own(room: list[Any]) -> None:
    [cell] = [cell for cell in pages()[f"{PAGE}.ipynb"].code if cell.id == CELL]
    for outcome in all_run(room, CELL):
        assert outcome == ["done", cell.outputs[0].text]

    for number, student in enumerate(room):
        notebook = hand_in(student, [-2, 1, number])
        [start] = [cell for cell in notebook["cells"] if cell["id"] == "start-3-1"]
        assert f"answer = [-2, 1, {number}]" in start["source"]
        solved = student.locator(".solved").text_content()
        assert solved.startswith("1" if number == 3 else "0")
