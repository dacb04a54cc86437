"""A class of six, graded by the commands of *Run a class*: nbgrader in its own environment."""

import csv
import json
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import nbformat
import pytest
from bs4 import BeautifulSoup
from class_notebooks import Classroom
from notebook_language import blocks, notebooks, pages, part_of
from uv import find_uv_bin

from rotedu.edition.exercises import check

ROOT = Path(__file__).parents[1]
CHAPTER = pages()["03-ordinary-rotation.ipynb"]
ASKED = CHAPTER.exercises

pytestmark = pytest.mark.slow

POINTS = """
import json
from nbgrader.api import Gradebook

found = {}
with Gradebook("sqlite:///gradebook.db", "rotations") as book:
    for work in book.assignment_submissions(ASSIGNMENT):
        grades = [grade for notebook in work.notebooks for grade in notebook.grades]
        found[work.student.id] = {g.name: [g.score, g.needs_manual_grade] for g in grades}
print(json.dumps(found))
"""
READ = """
from nbgrader.api import Gradebook

with Gradebook("sqlite:///gradebook.db", "rotations") as book:
    place = "why-3-5", "03-ordinary-rotation", "chapter-3", "solutions"
    book.find_grade(*place).manual_score = 2
    book.find_comment(*place).manual_comment = "Say what warns you."
    book.db.commit()
"""

WRONG = {
    "3.1": "[2, -1, 3]",
    "3.2": "([1, 1, 1], 60)",
    "3.3": '("transpose", "same")',
    "3.4": "(([0, 0, 1], 180), ([1, 1, 1], 120))",
    "3.5": "0.001",
    "3.6": "([0, 0, 1], 1)",
}
# A mistake of each kind, then an end of the kernel's work, and after it two right answers.
CRASHES = {"3.1": "1 / 0", "3.2": "answer = = 3", "3.3": "import sys; sys.exit()", "3.4": "raise"}


def commands() -> tuple[str, str]:
    """What the page says to type, before the class and after it."""
    section = pages()["run-a-class.md"].text.partition("(grade)=")[2].partition("\n(")[0]
    before, after = [block.body for block in blocks(section) if block.kind == "fence"]
    return before, after


class Course:
    """A course of nbgrader, in a folder beside its environment."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def run(self, command: str) -> str:
        """Type a command."""
        activated = f". ../grading/bin/activate\n{command}"
        return bash(activated, self.folder)

    def python(self, code: str) -> str:
        """Run Python beside nbgrader."""
        return self.run(f"python - <<'END'\n{code}\nEND")

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

    def points(self, assignment: str) -> dict[str, dict[str, tuple[float, bool]]]:
        """Points of each cell, and whether somebody must read it, for each student."""
        code = f"ASSIGNMENT = {assignment!r}{POINTS}"
        return json.loads(self.python(code))  # type: ignore[no-any-return]


def bash(commands: str, folder: Path) -> str:
    command = ["bash", "-e", "-c", commands]
    return subprocess.run(command, cwd=folder, check=True, stdout=subprocess.PIPE, text=True).stdout


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
    "half": lambda n, code: solved(n, code) if n <= "3.3" else code,
    "wrong": answered,
    "empty": lambda n, code: code,
    "redefined": lambda n, code: (
        "from types import SimpleNamespace\n"
        "check = judge = lambda *a: SimpleNamespace(right=True)\n" + answered(n, code)
    ),
    "crash": lambda n, code: CRASHES.get(n) or solved(n, code),
}


@pytest.fixture(scope="module")
def graded(course: Course) -> dict[str, dict[str, tuple[float, bool]]]:
    """What the class of six earns for Chapter 3."""
    for student, answer in CLASS.items():
        course.hand_in(student, course.folder / "release" / "chapter-3" / CHAPTER.name, answer)
    _, after = commands()
    for command in after.splitlines():
        if command == "jupyter lab":
            course.python(READ)
        else:
            course.run(command)
    return course.points("chapter-3")


@pytest.mark.parametrize(
    ("student", "right"),
    [
        ("solutions", list(ASKED)),
        ("half", ["3.1", "3.2", "3.3"]),
        ("wrong", []),
        ("empty", []),
        ("redefined", []),
        ("crash", ["3.5", "3.6"]),
    ],
)
def test_right_answers_alone_earn_points(
    student: str, right: list[str], graded: dict[str, dict[str, tuple[float, bool]]]
) -> None:
    found = {name: points for name, (points, _) in graded[student].items() if "test" in name}
    whole = {number: asked.minutes for number, asked in ASKED.items()} | {"3.5": 7}
    assert found == {f"test-{n.replace('.', '-')}": whole[n] * (n in right) for n in ASKED}


def test_somebody_must_read_the_reasons_that_were_given(
    graded: dict[str, dict[str, tuple[float, bool]]],
) -> None:
    found = {student: work["why-3-5"] for student, work in graded.items()}
    assert found.pop("solutions") == [2, True]
    assert list(found.values()) == 5 * [[0, False]]


@pytest.mark.usefixtures("graded")
def test_grades_are_exported(course: Course) -> None:
    with (course.folder / "grades.csv").open(encoding="utf-8", newline="") as file:
        scores = {row["student_id"]: float(row["score"]) for row in csv.DictReader(file)}
    # The reasons of the first have got two points of three.
    assert scores == {
        "solutions": 62,
        "half": 13,
        "wrong": 0,
        "empty": 0,
        "redefined": 0,
        "crash": 37,
    }


def feedback(course: Course, student: str) -> str:
    file = course.folder / "feedback" / student / "chapter-3" / f"{CHAPTER!r}.html"
    page = BeautifulSoup(file.read_text("utf-8"), "html.parser")
    return " ".join(page.get_text().split())


@pytest.mark.usefixtures("graded")
def test_feedback_has_the_verdict_and_a_hint(course: Course) -> None:
    wrong, redefined = (feedback(course, student) for student in ("wrong", "redefined"))
    for number, answer in WRONG.items():
        verdict = " ".join(str(check(number, eval(answer))).split())
        assert "not yet" in verdict
        assert f"AssertionError: {verdict}" in wrong
        assert f"AssertionError: {verdict}" in redefined
    right = feedback(course, "solutions")
    assert right.count(": right.") == 2 * len(ASKED)
    assert "AssertionError" not in right
    assert "Say what warns you." in right
    crashed = feedback(course, "crash")
    assert crashed.count("AssertionError: 3.") == len(CRASHES)
    assert all(f"AssertionError: {n}: not answered yet." in crashed for n in CRASHES)


@pytest.mark.usefixtures("graded")
def test_run_all_does_not_stop_at_a_stub(course: Course) -> None:
    """As a student has it, who has not begun."""
    released = course.folder / "release" / "chapter-3" / CHAPTER.name
    course.run(f"jupyter nbconvert --to=notebook --execute --output=run '{released}'")
    said = released.with_name("run.ipynb").read_text("utf-8")
    assert said.count(": not answered yet.") == len(ASKED)
    assert "SOLUTION" not in said
    assert "HIDDEN" not in said
    released.with_name("run.ipynb").unlink()


def test_the_solutions_of_all_chapters_earn_all_points(course: Course) -> None:
    shutil.copytree(course.folder.parent / "nbgrader", course.folder / "source" / "book")
    course.run("nbgrader generate_assignment book")
    for released in (course.folder / "release" / "book").glob("*.ipynb"):
        course.hand_in("teacher", released, solved)
    course.run("nbgrader autograde book")
    (work,) = course.points("book").values()
    everything = [asked for page in notebooks() for asked in page.exercises.values()]
    for asked in everything:
        points, _ = work[f"test-{asked.number.replace('.', '-')}"]
        assert 0 < points <= asked.minutes
        assert (points < asked.minutes) is (asked.kind == "judge")
    assert sum("test" in name for name in work) == len(everything)
