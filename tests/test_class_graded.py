"""A class of six, graded by the commands of *Run a class*: nbgrader in its own environment."""

import csv
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import nbformat
import pytest
from bs4 import BeautifulSoup
from class_notebooks import Classroom
from notebook_language import ROOT, blocks, notebooks, pages, part_of
from uv import find_uv_bin

from rotedu.edition.exercises import check

CHAPTER = pages()["03-ordinary-rotation.ipynb"]
ASKED = CHAPTER.exercises

pytestmark = pytest.mark.slow

READ = """
from nbgrader.api import Gradebook

with Gradebook("sqlite:///gradebook.db", "rotations") as book:
    works = book.assignment_submissions("chapter-3")
    assert [work.student.id for work in works if work.needs_manual_grade] == ["solutions"]
    place = "why-3-6", "03-ordinary-rotation", "chapter-3", "solutions"
    book.find_grade(*place).manual_score = 2
    book.find_comment(*place).manual_comment = "Say what warns you."
    book.db.commit()
"""

WRONG = {
    "3.1": "lambda r, n, theta: r",
    "3.2": "[2, -1, 3]",
    "3.3": "([1, 1, 1], 60)",
    "3.4": '("transpose", "same")',
    "3.5": "(([0, 0, 1], 180), ([1, 1, 1], 120))",
    "3.6": "0.001",
    "3.7": "([0, 0, 1], 1)",
}
# A mistake of each kind, then an end of the kernel's work, and after it two right answers.
CRASHES = {"3.2": "1 / 0", "3.3": "answer = = 3", "3.4": "import sys; sys.exit()", "3.5": "raise"}


def commands() -> tuple[str, str]:
    """What the page says to type, before the class and after it."""
    section = pages()["run-a-class.md"].text.partition("(grade)=")[2].partition("\n(")[0]
    before, after = [block.body for block in blocks(section) if block.kind == "fence"]
    return before, after


def bash(commands: str, folder: Path) -> None:
    subprocess.run(["bash", "-e", "-c", commands], cwd=folder, check=True)


class Course(NamedTuple):
    """A course of nbgrader, in a folder beside its environment."""

    folder: Path

    def run(self, command: str) -> None:
        """Type a command."""
        bash(f". ../grading/bin/activate\n{command}", self.folder)

    def hand_in(self, student: str, released: Path, answer: Callable[[str, str], str]) -> None:
        """Hand in a notebook in which each answer's cell is made anew of its number and code."""
        notebook = nbformat.read(released, as_version=4)
        for cell in notebook.cells:
            part, number = part_of(cell.id)
            if part == "start":
                cell.source = answer(number, cell.source)
            elif part == "why" and student == "solutions":
                cell.source = "Since the axis is too long."
        place = self.folder / "submitted" / student / released.parent.name / released.name
        place.parent.mkdir(parents=True, exist_ok=True)
        nbformat.write(notebook, place)

    def scores(self, assignment: str) -> dict[str, float]:
        """What each student has got, as it is exported."""
        with (self.folder / "grades.csv").open(encoding="utf-8", newline="") as file:
            rows = [row for row in csv.DictReader(file) if row["assignment"] == assignment]
        return {row["student_id"]: float(row["score"]) for row in rows}


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Course:
    """Type what the page says, with uv in place of the slower venv and pip."""
    folder = tmp_path_factory.mktemp("class")
    Classroom().write(folder, ["nbgrader"])
    uv = find_uv_bin()
    build = (uv, "build", "--quiet", "--wheel", "--no-build-isolation", "-p", sys.executable)
    subprocess.run([*build, "-o", folder, ROOT], check=True)
    before, _ = commands()
    for slow, fast in (
        ("python3 -m venv", f"'{uv}' venv --quiet -p '{sys.executable}'"),
        ("pip install", f"'{uv}' pip install --quiet"),
    ):
        assert slow in before
        before = before.replace(slow, fast)
    bash(before, folder)
    return Course(folder / "course")


def solved(number: str, _: str) -> str:
    page = next(page for page in notebooks() if number in page.exercises)
    asked = page.exercises[number]
    return asked.start.source.rpartition("\n")[0] + "\n" + asked.solution.source


def answered(number: str, code: str) -> str:
    """Write a wrong answer below the stub."""
    above, _, check = code.rpartition("\n")
    return f"{above}\nanswer = {WRONG[number]}\n{check}"


CLASS: dict[str, Callable[[str, str], str]] = {
    "solutions": solved,
    "half": lambda n, code: solved(n, code) if n <= "3.4" else code,
    "wrong": answered,
    "empty": lambda n, code: code,
    "redefined": lambda n, code: (
        "from types import SimpleNamespace\n"
        "check = judge = lambda *a: SimpleNamespace(right=True)\n" + answered(n, code)
    ),
    "crash": lambda n, code: CRASHES.get(n) or solved(n, code),
}


@pytest.fixture(scope="module")
def graded(course: Course) -> Course:
    """Let a class of six hand in Chapter 3, and type what the page says."""
    for student, answer in CLASS.items():
        course.hand_in(student, course.folder / "release" / "chapter-3" / CHAPTER.name, answer)
    _, after = commands()
    for command in after.splitlines():
        course.run(f"python - <<'END'\n{READ}\nEND" if command == "jupyter lab" else command)
    return course


def test_right_answers_and_reasons_alone_earn_points(graded: Course) -> None:
    minutes = {number: asked.minutes for number, asked in ASKED.items()}
    right = {
        # The reasons have got two points of three.
        "solutions": sum(minutes.values()) - 1,
        "half": sum(minutes[f"3.{k}"] for k in (1, 2, 3, 4)),
        "wrong": 0,
        "empty": 0,
        "redefined": 0,
        # Without the reasons.
        "crash": minutes["3.1"] + minutes["3.6"] - 3 + minutes["3.7"],
    }
    assert graded.scores("chapter-3") == right


def feedback(course: Course, student: str) -> str:
    file = course.folder / "feedback" / student / "chapter-3" / f"{CHAPTER!r}.html"
    page = BeautifulSoup(file.read_text("utf-8"), "html.parser")
    return " ".join(page.get_text().split())


def test_feedback_has_the_verdict_and_a_hint(graded: Course) -> None:
    wrong, redefined = (feedback(graded, student) for student in ("wrong", "redefined"))
    for number, answer in WRONG.items():
        verdict = " ".join(str(check(number, eval(answer))).split())
        assert "not yet" in verdict
        assert f"AssertionError: {verdict}" in wrong
        assert f"AssertionError: {verdict}" in redefined
    right = feedback(graded, "solutions")
    assert right.count(": right.") == 2 * len(ASKED)
    assert "AssertionError" not in right
    assert "Say what warns you." in right
    crashed = feedback(graded, "crash")
    assert crashed.count("AssertionError: 3.") == len(CRASHES)
    assert all(f"AssertionError: {n}: not answered yet." in crashed for n in CRASHES)


def test_run_all_does_not_stop_at_a_stub(graded: Course) -> None:
    """As a student has it, who has not begun."""
    released = graded.folder / "release" / "chapter-3" / CHAPTER.name
    run = graded.folder.parent / "run.ipynb"
    graded.run(f"jupyter nbconvert --to=notebook --execute --output='{run}' '{released}'")
    said = run.read_text("utf-8")
    assert said.count(": not answered yet.") == len(ASKED)
    assert "SOLUTION" not in said
    assert "HIDDEN" not in said


def test_the_solutions_of_all_chapters_earn_all_points(course: Course) -> None:
    shutil.copytree(course.folder.parent / "nbgrader", course.folder / "source" / "book")
    course.run("nbgrader generate_assignment book")
    for released in (course.folder / "release" / "book").glob("*.ipynb"):
        course.hand_in("teacher", released, solved)
    course.run("nbgrader autograde book\nnbgrader export")
    asked = [exercise for page in notebooks() for exercise in page.exercises.values()]
    for_reasons = sum(each.minutes // 3 for each in asked if each.kind == "judge")
    whole = sum(each.minutes for each in asked)
    assert course.scores("book")["teacher"] == whole - for_reasons
