"""The notebooks for a class, compared with those of the book."""

import importlib.util
import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import nbformat
import pytest
from browser import node
from bs4 import BeautifulSoup
from bundle import LIBRARIES
from class_notebooks import Classroom
from html_pages import anchors
from IPython.core.inputtransformer2 import TransformerManager
from markdown_it import MarkdownIt
from mdit_py_plugins.dollarmath import dollarmath_plugin
from nbclient import NotebookClient
from notebook_language import Page, notebooks, part_of

import rotedu
from rotedu import colors
from rotedu.edition.equations import EQUATIONS

ROOT = Path(__file__).parents[1]
READERS = ("student", "teacher")
SOURCES = notebooks()
TITLE = re.compile(r"^# \w.*", re.MULTILINE)
TAG = re.compile(r"\\tag\{(.*?)\}")
ANCHOR = re.compile(r'\bid="([^"]+)"')
BORDER = re.compile(r"border-left: 4px solid (#\w+)")
MYST = re.compile(r"^:::|^:\w+: |^\(.+\)=|\{[\w:]+\}`|\$\$ \(|<!--|\\def", re.MULTILINE)
FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)

# Without MyST: what other places read.
PLAIN = MarkdownIt("commonmark").enable("table").use(dollarmath_plugin, allow_labels=False)

KATEX = """
const katex = require("katex");
const formulas = JSON.parse(require("fs").readFileSync(0));
for (const [displayMode, formula] of formulas)
    katex.renderToString(formula, { displayMode, throwOnError: true, strict: "error" });
console.log(formulas.length);
"""


def cells(file: Path, kind: str = "") -> list[Any]:
    return [cell for cell in Page(file).cells if cell.cell_type.startswith(kind)]


def text(file: Path) -> str:
    return Page(file).text


def tokens(source: str) -> Iterator[Any]:
    for token in PLAIN.parse(source):
        yield token
        yield from token.children or ()


def links(file: Path) -> list[str]:
    found = (token for token in tokens(text(file)) if token.type == "link_open")
    return [token.attrs["href"] for token in found]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("class")
    (folder / "student").mkdir()
    (folder / "student" / "06-of-last-year.ipynb").touch()
    Classroom().write(folder)
    return folder


@pytest.fixture(params=READERS)
def reader(request: pytest.FixtureRequest, folder: Path) -> list[Path]:
    """The notebooks of a reader, in the order of the folder."""
    return sorted((folder / str(request.param)).iterdir())


def test_the_folder_is_in_teaching_order_and_holds_nothing_else(reader: list[Path]) -> None:
    assert [TITLE.findall(text(file)) for file in reader] == [
        TITLE.findall(page.text) for page in SOURCES
    ]


def test_students_read_how_to_begin_below_the_title(folder: Path) -> None:
    for file in (folder / "student").iterdir():
        assert TITLE.match(cells(file)[1].source)
        assert "**Run All Cells**" in cells(file)[2].source


def test_two_runs_write_the_same_bytes(folder: Path, tmp_path: Path) -> None:
    write = f"import sys; sys.path.append({str(ROOT / 'tools')!r}); import class_notebooks as c; "
    write += f"c.Classroom().write(c.Path({str(tmp_path)!r}))"
    subprocess.run(
        [sys.executable, "-c", write], check=True, env=os.environ | {"PYTHONHASHSEED": "7"}
    )
    first, second = (
        {file.relative_to(root): file.read_bytes() for file in root.rglob("*.ipynb")}
        for root in (folder, tmp_path)
    )
    assert first == second
    assert len(first) == 2 * len(SOURCES)


def everything(notebook: list[Any]) -> str:
    """All that a reader of these cells can see: sources and outputs."""
    outputs = [output for cell in notebook for output in cell.get("outputs", ())]
    shown = [output.get("text") or "\n".join(output["data"].values()) for output in outputs]
    return "\n".join([cell.source for cell in notebook] + shown)


def test_students_see_no_solution(folder: Path) -> None:
    for page, file in zip(SOURCES, sorted((folder / "student").iterdir()), strict=True):
        asked = page.exercises.values()
        secrets = [cell for e in asked for cell in (e.solution, e.why) if cell]
        public = everything([cell for cell in page.cells if cell not in secrets])
        lines = re.split(r"\n|(?<=\.) ", everything(secrets))
        # Short lines, such as "else:" and "]", tell nothing.
        secret = {line for line in lines if len(line) > 12 and line not in public}
        assert len(secret) >= len(asked)
        seen = everything(cells(file))
        assert [line for line in secret if line in seen] == []


def test_every_exercise_has_its_starter_and_its_check(reader: list[Path]) -> None:
    for page, file in zip(SOURCES, reader, strict=True):
        written = {cell.id: cell.source for cell in cells(file)}
        for number, exercise in page.exercises.items():
            assert f"**Exercise {number}**" in written[exercise.text.id]
            assert written[exercise.start.id] == exercise.start.source
            assert exercise.start.source.splitlines()[-1] == f'check("{number}", answer)'


def test_the_teachers_solutions_are_folded(folder: Path) -> None:
    for page, file in zip(SOURCES, sorted((folder / "teacher").iterdir()), strict=True):
        written = {cell.id: cell for cell in cells(file)}
        for exercise in page.exercises.values():
            solution = written[exercise.solution.id]
            assert solution.source == exercise.solution.source
            assert solution.metadata.jupyter == {"source_hidden": True, "outputs_hidden": True}
            if exercise.why:
                assert "\n<summary>Why</summary>\n" in written[exercise.why.id].source


def test_no_myst_is_left(reader: list[Path]) -> None:
    assert sum(len(MYST.findall(page.text)) for page in SOURCES) > 300
    for file in reader:
        assert MYST.findall(FENCE.sub("", text(file))) == []


def test_boxes_keep_their_colours(reader: list[Path]) -> None:
    meaning = {
        colors.VECTOR: "claim",
        colors.AXIS: "erratum",
        colors.RESULT: "fair",
        colors.NEUTRAL: "question",
    }
    for page, file in zip(SOURCES, reader, strict=True):
        cells_of_book = [cell for cell in cells(file, "markdown") if cell.id != "notes"]
        found = BORDER.findall("\n".join(cell.source for cell in cells_of_book))
        boxes = [box.options["class"].split()[0] for box in page.all("admonition")]
        assert [meaning[color] for color in found] == boxes


def test_choices_fold_inside_the_box_with_their_question(reader: list[Path]) -> None:
    for page, file in zip(SOURCES, reader, strict=True):
        boxes = page.boxes("question")
        html = BeautifulSoup(PLAIN.render(text(file)), "html.parser")
        titles = {box.title for box in boxes}
        found = [box for box in html.find_all("blockquote") if box.p.get_text() in titles]
        assert len(found) == len(boxes)
        assert boxes or not page.exercises
        for box, written in zip(found, boxes, strict=True):
            choices = box.find_all("details", recursive=False)
            expected = [choice.title for choice in written.choices]
            assert [choice.summary.get_text() for choice in choices] == expected
            assert len(choices) >= 2
            assert all(choice.p.get_text() for choice in choices)


def test_html_is_balanced(reader: list[Path]) -> None:
    for file in reader:
        for cell in cells(file, "markdown"):
            html = "".join(token.content for token in tokens(cell.source) if "html" in token.type)
            for name in ("details", "summary", "blockquote", "div", "a"):
                assert len(re.findall(rf"<{name}\b", html)) == html.count(f"</{name}>")


def test_equations_carry_the_papers_numbers(reader: list[Path]) -> None:
    for page, file in zip(SOURCES, reader, strict=True):
        formulas = [token for token in tokens(text(file)) if token.type == "math_block"]
        numbers = [tag for token in formulas for tag in TAG.findall(token.content)]
        labels = [equation.options["label"] for equation in page.all("math")]
        assert [f"eq-{number}" for number in numbers] == labels
        for number in numbers:
            assert f'<div id="eq-{number}"></div>\n\n$$\n' in text(file)
    written = {number for file in reader for number in TAG.findall(text(file))}
    assert written == {equation.number for equation in EQUATIONS}


def test_every_link_leads_somewhere(reader: list[Path]) -> None:
    there = {file.name: ANCHOR.findall(text(file)) for file in reader}
    cells = {file.name: {cell.id for cell in nbformat.read(file, 4).cells} for file in reader}
    for file in reader:
        assert len(set(there[file.name])) == len(there[file.name])
        for link in links(file):
            assert link
            name, _, anchor = link.partition("#")
            if "://" in link:
                assert re.match(r"https://(doi\.org/10\.|arxiv\.org/abs/|splines\.)", link)
            else:
                assert name in there or not name
                # JupyterLab goes to a place of another notebook by its cell alone.
                places = cells[name] if name else there[file.name]
                assert not anchor or anchor.removeprefix("cell-id=") in places
                assert anchor.startswith("cell-id=") == bool(name and anchor)
    assert sum(len(links(file)) for file in reader) > 300


def test_links_can_lead_to_the_published_book(book: Path, tmp_path: Path) -> None:
    address = "https://book.example/rotations"
    Classroom(address + "/").write(tmp_path)
    linked = set()
    for file in (tmp_path / "teacher").iterdir():
        for link in links(file):
            if link.startswith(address):
                name, _, anchor = link.removeprefix(f"{address}/").partition("#")
                linked.add(name)
                # The page must be there, also for a link without an anchor.
                targets = anchors(book / name)
                assert not anchor or anchor in targets
            else:
                assert link.startswith(("#", "https://"))
    assert len(linked) > 12


def test_katex_sets_every_formula_without_macros(reader: list[Path]) -> None:
    formulas = []
    for cell in (cell for file in reader for cell in cells(file)):
        tables = [output.get("data", {}).get("text/markdown") for output in cell.get("outputs", ())]
        for source in [cell.source] if cell.cell_type == "markdown" else filter(None, tables):
            formulas += [
                ("block" in token.type, token.content)
                for token in tokens(source)
                if token.type.startswith("math")
            ]
    command = [node(), "-e", KATEX]
    run = subprocess.run(
        command,
        cwd=LIBRARIES.parent,
        input=json.dumps(formulas),
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.stderr == ""
    assert int(run.stdout) == len(formulas) > 800


def linking_outputs(notebook: list[Any]) -> list[str]:
    """Outputs in Markdown that have links, which Python makes for the book."""
    outputs = [output for cell in notebook for output in cell.get("outputs", ())]
    shown = [output.get("data", {}).get("text/markdown", "") for output in outputs]
    return [output for output in shown if "](" in FENCE.sub("", output)]


def test_tables_with_links_are_text(reader: list[Path]) -> None:
    for page, file in zip(SOURCES, reader, strict=True):
        tables = linking_outputs(page.cells)
        assert linking_outputs(cells(file)) == []
        for table in tables:
            rows = [line.count("|") for line in table.splitlines()]
            written = [cell.source for cell in cells(file, "markdown") if cell.source[0] == "|"]
            assert rows in [[line.count("|") for line in text.splitlines()] for text in written]
    assert sum(len(linking_outputs(page.cells)) for page in SOURCES) >= 5


QUICK = "01-introduction"


@pytest.mark.parametrize(
    "page",
    [pytest.param(page, marks=() if repr(page) == QUICK else pytest.mark.slow) for page in SOURCES],
    ids=repr,
)
def test_a_students_notebook_runs_unanswered(page: Page, folder: Path, tmp_path: Path) -> None:
    file = sorted((folder / "student").iterdir())[SOURCES.index(page)]
    notebook = nbformat.read(file, as_version=4)
    place = {"metadata": {"path": tmp_path}}
    NotebookClient(notebook, timeout=300, kernel_name="python3", resources=place).execute()
    assert linking_outputs(notebook.cells) == []
    said = everything(notebook.cells).count(": not answered yet.")
    assert said == len(page.exercises)


@pytest.mark.parametrize(
    ("wheel", "requirement"),
    [
        ("https://host.example/r.whl", "rotedu[notebooks] @ https://host.example/r.whl"),
        ("/srv/r.whl", "/srv/r.whl[notebooks]"),
    ],
)
def test_the_first_cell_installs_rotedu_only_where_it_is_missing(
    wheel: str,
    requirement: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    first = Classroom(wheel=wheel).notebook(SOURCES[0], "student").cells[0]
    code = TransformerManager().transform_cell(first.source)
    magics: list[tuple[str, str]] = []

    class Shell:
        def run_line_magic(self, *magic: str) -> None:
            magics.append(magic)  # type: ignore[arg-type]

    exec(code, {"get_ipython": Shell})
    assert magics == []
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    exec(code, {"get_ipython": Shell})
    assert magics == [("pip", f'install --quiet "{requirement}"')]
    assert wheel in capsys.readouterr().out


def test_without_a_wheel_the_first_cell_says_what_is_missing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    first = Classroom().notebook(SOURCES[0], "student").cells[0]
    exec(first.source, {})
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    with pytest.raises(ModuleNotFoundError, match="install rotedu"):
        exec(first.source, {})


BUTTONS = re.compile(r'<a href="(.+?)"[^>]*>Open in (\w+)</a>')


def test_a_student_can_open_a_notebook_of_the_release_elsewhere(folder: Path) -> None:
    """On Binder, which runs postBuild at the tag, and on Colab, for which a branch is pushed."""
    release = (ROOT / ".github" / "workflows" / "release.yml").read_text("utf-8")
    assert '/$GITHUB_REPOSITORY" class\n' in release
    tag = f"v{rotedu.__version__}"
    classroom = Classroom(repository="https://github.example/someone/rotedu/")
    written = {file.name for file in (folder / "student").iterdir()}
    for page in SOURCES:
        found = BUTTONS.findall(classroom.notebook(page, "student").cells[2].source)
        (binder, _), (colab, _) = found
        assert [place for _, place in found] == ["Binder", "Colab"]
        place, _, name = binder.rpartition("/class/student/")
        assert place == f"https://mybinder.org/v2/gh/someone/rotedu/{tag}?urlpath=lab/tree"
        place, _, on_colab = colab.rpartition("/blob/class/")
        assert place == "https://colab.research.google.com/github/someone/rotedu"
        assert name == on_colab
        written.remove(name)
        first = classroom.notebook(page, "student").cells[0].source
        wheel = f"rotedu-{rotedu.__version__}-py3-none-any.whl"
        assert f"https://github.example/someone/rotedu/releases/download/{tag}/{wheel}" in first
    assert not written


def test_only_students_are_sent_elsewhere_and_only_with_a_repository() -> None:
    page = SOURCES[0]
    classroom = Classroom(repository="https://github.example/someone/rotedu")
    for reader in ("teacher", "nbgrader"):
        assert not BUTTONS.findall(everything(classroom.notebook(page, reader).cells))
    assert "github.example" not in everything(classroom.notebook(page, "teacher").cells[1:])
    for cell in Classroom().notebook(page, "student").cells:
        assert not BUTTONS.findall(cell.source)
        assert "releases/download" not in cell.source
    named = Classroom(repository="https://github.example/someone/rotedu", wheel="/srv/r.whl")
    assert '"/srv/r.whl[notebooks]"' in named.first_cell().source


@pytest.fixture(scope="module")
def graded(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """The notebooks for nbgrader, in the order of the folder."""
    folder = tmp_path_factory.mktemp("graded")
    Classroom().write(folder, ["nbgrader"])
    return sorted((folder / "nbgrader").glob("*.ipynb"))


def marked(file: Path, part: str) -> dict[str, Any]:
    """The cells of a part of the exercises that nbgrader knows, by number."""
    found = [cell for cell in cells(file) if "nbgrader" in cell.metadata]
    assert all(cell.metadata.nbgrader.grade_id == cell.id for cell in found)
    parts = [(part_of(cell.id.replace("test-", "start-")), cell) for cell in found]
    return {number: cell for (_, number), cell in parts if cell.id.startswith(part)}


SOLUTION = re.compile("### BEGIN SOLUTION\n(.*?)### END SOLUTION\n?", re.DOTALL)
HIDDEN = re.compile("### BEGIN HIDDEN TESTS\n.*### END HIDDEN TESTS", re.DOTALL)


def lines(code: str) -> list[str]:
    """The lines of a listing that are not empty."""
    return list(filter(None, code.split("\n")))


def test_nbgrader_gets_one_cell_for_each_answer(folder: Path, graded: list[Path]) -> None:
    for page, plain, file in zip(
        SOURCES, sorted((folder / "student").iterdir()), graded, strict=True
    ):
        asked = page.exercises
        starts = marked(file, "start")
        assert list(starts) == list(asked)
        for number, start in starts.items():
            (solution,) = SOLUTION.findall(start.source)
            check = f'check("{number}", answer)'
            assert [*lines(solution), check] == lines(asked[number].solution.source)
            # Without its solution it is what every student gets.
            assert lines(SOLUTION.sub("", start.source)) == lines(asked[number].start.source)
        ours = [cell for cell in cells(file) if "nbgrader" not in cell.metadata]
        assert ours == [cell for cell in cells(plain) if part_of(cell.id)[0] != "start"]


def test_a_student_who_renames_check_changes_no_test(graded: list[Path]) -> None:
    def cheats(*_: object) -> Any:
        return SimpleNamespace(right=True)

    for page, file in zip(SOURCES, graded, strict=True):
        tests = marked(file, "test")
        assert list(tests) == list(page.exercises)
        for number, test in tests.items():
            assert test.metadata.nbgrader.locked
            # What "Run All" meets has nothing that could fail.
            assert HIDDEN.sub("", test.source) == f"# nbgrader grades Exercise {number} here.\n"
            names = {"check": cheats, "judge": cheats, "answer": 0}
            with pytest.raises(AssertionError, match=f"^{re.escape(number)}: not yet"):
                exec(test.source, names)
            # What the next exercise finds, if its own answer crashes.
            with pytest.raises(AssertionError, match=": not answered yet"):
                exec(test.source, names)


def test_points_are_minutes_and_reasons_are_graded_by_hand(graded: list[Path]) -> None:
    for page, file in zip(SOURCES, graded, strict=True):
        reasons, tests = marked(file, "why"), marked(file, "test")
        judged = [n for n, asked in page.exercises.items() if asked.kind == "judge"]
        assert list(reasons) == judged
        for number, asked in page.exercises.items():
            graded_cells = [tests[number], *filter(None, [reasons.get(number)])]
            points = [cell.metadata.nbgrader.points for cell in graded_cells]
            assert min(points) > 0
            assert sum(points) == asked.minutes
        for number, cell in reasons.items():
            assert cell.cell_type == "markdown"
            assert cell.metadata.nbgrader.solution
            # The reasons of the book are between the marks, and nowhere else.
            (why,) = SOLUTION.findall(cell.source)
            assert "<summary>Why</summary>" in why
            assert f"answer to Exercise {number}**" in SOLUTION.sub("", cell.source)
