"""The notebooks for a class, compared with those of the book."""

import importlib.util
import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
import pytest
import yaml
from browser import node
from bs4 import BeautifulSoup
from bundle import LIBRARIES
from class_notebooks import Classroom
from html_pages import anchors
from IPython.core.inputtransformer2 import TransformerManager
from markdown_it import MarkdownIt
from mdit_py_plugins.dollarmath import dollarmath_plugin
from nbclient import NotebookClient

from rotedu import colors
from rotedu.edition.equations import EQUATIONS

ROOT = Path(__file__).parents[1]
READERS = ("student", "teacher")
CHAPTERS = [
    chapter["file"]
    for part in yaml.safe_load((ROOT / "_toc.yml").read_text("utf-8"))["parts"]
    for chapter in part["chapters"]
]
SOURCES = [file for file in (ROOT / f"{name}.ipynb" for name in CHAPTERS) if file.exists()]
TITLE = re.compile(r"^# \w.*", re.MULTILINE)
EXERCISE = re.compile(r"^\*\*Exercise ([\d.]+)\*\*", re.MULTILINE)
SOLUTION = re.compile(r"# Solution of Exercise ([\d.]+)$", re.MULTILINE)
REASONS = re.compile(r"^:::\{dropdown\} Why\n(.*?)^:::$", re.MULTILINE | re.DOTALL)
BOX = re.compile(r"^:class: (\w+)", re.MULTILINE)
TITLE_OF_QUESTION = "Before you read on"
QUESTION = re.compile(
    rf"^::::\{{admonition\}} {TITLE_OF_QUESTION}\n(.*?)^::::$", re.MULTILINE | re.DOTALL
)
CHOICE = re.compile(r"^:::\{dropdown\} (.+)$", re.MULTILINE)
TAG = re.compile(r"\\tag\{(.*?)\}")
LABEL = re.compile(r"^:label: eq-(.*)$", re.MULTILINE)
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
    notebook = nbformat.read(file, as_version=4)
    return [cell for cell in notebook.cells if cell.cell_type.startswith(kind)]


def text(file: Path) -> str:
    return "\n\n".join(cell.source for cell in cells(file, "markdown"))


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
        TITLE.findall(text(file)) for file in SOURCES
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
    for source, file in zip(SOURCES, sorted((folder / "student").iterdir()), strict=True):
        solutions = [cell for cell in cells(source, "code") if SOLUTION.search(cell.source)]
        others = [cell for cell in cells(source) if cell not in solutions]
        reasons = REASONS.findall(everything(others))
        public = REASONS.sub("", everything(others))
        lines = everything(solutions).splitlines() + re.split(r"\n|(?<=\.) ", "\n".join(reasons))
        # Short lines, such as "else:" and "]", tell nothing.
        secret = {line for line in lines if len(line) > 12 and line not in public}
        assert len(secret) >= 5 * len(solutions)
        seen = everything(cells(file))
        assert [line for line in secret if line in seen] == []
        assert not SOLUTION.search(seen)


def test_every_exercise_has_its_starter_and_its_check(reader: list[Path]) -> None:
    for source, file in zip(SOURCES, reader, strict=True):
        written = text(file)
        assert EXERCISE.findall(written) == EXERCISE.findall(text(source))
        code = [cell.source for cell in cells(file, "code")]
        for number in EXERCISE.findall(written):
            assert any(cell.splitlines()[-1].startswith(f'check("{number}", ') for cell in code)
        exercise = False
        for cell in cells(source):
            exercise |= bool(cell.cell_type == "markdown" and EXERCISE.search(cell.source))
            if exercise and cell.cell_type == "code" and not SOLUTION.search(cell.source):
                assert cell.source in code


def test_the_teachers_solutions_are_folded(folder: Path) -> None:
    for source, file in zip(SOURCES, sorted((folder / "teacher").iterdir()), strict=True):
        solutions = [cell for cell in cells(file, "code") if SOLUTION.search(cell.source)]
        numbers = [SOLUTION.match(cell.source)[1] for cell in solutions]  # type: ignore[index]
        assert numbers == EXERCISE.findall(text(source))
        for cell in solutions:
            assert cell.metadata.jupyter == {"source_hidden": True, "outputs_hidden": True}
        reasons = len(REASONS.findall(text(source)))
        assert text(file).count("\n<summary>Why</summary>\n") == reasons


def test_no_myst_is_left(reader: list[Path]) -> None:
    assert sum(len(MYST.findall(text(source))) for source in SOURCES) > 300
    for file in reader:
        assert MYST.findall(FENCE.sub("", text(file))) == []


def test_boxes_keep_their_colours(reader: list[Path]) -> None:
    meaning = {
        colors.VECTOR: "claim",
        colors.AXIS: "erratum",
        colors.RESULT: "fair",
        colors.NEUTRAL: "question",
    }
    for source, file in zip(SOURCES, reader, strict=True):
        cells_of_book = [cell for cell in cells(file, "markdown") if cell.id != "notes"]
        found = BORDER.findall("\n".join(cell.source for cell in cells_of_book))
        assert [meaning[color] for color in found] == BOX.findall(text(source))


def test_choices_fold_inside_the_box_with_their_question(reader: list[Path]) -> None:
    for source, file in zip(SOURCES, reader, strict=True):
        boxes = QUESTION.findall(text(source))
        page = BeautifulSoup(PLAIN.render(text(file)), "html.parser")
        found = [
            box for box in page.find_all("blockquote") if box.p.get_text() == TITLE_OF_QUESTION
        ]
        assert len(found) == len(boxes)
        assert boxes or not source.name[0].isdigit()
        for box, written in zip(found, boxes, strict=True):
            choices = box.find_all("details", recursive=False)
            assert [choice.summary.get_text() for choice in choices] == CHOICE.findall(written)
            assert len(choices) >= 2
            assert all(choice.p.get_text() for choice in choices)


def test_html_is_balanced(reader: list[Path]) -> None:
    for file in reader:
        for cell in cells(file, "markdown"):
            html = "".join(token.content for token in tokens(cell.source) if "html" in token.type)
            for name in ("details", "summary", "blockquote", "div", "a"):
                assert len(re.findall(rf"<{name}\b", html)) == html.count(f"</{name}>")


def test_equations_carry_the_papers_numbers(reader: list[Path]) -> None:
    for source, file in zip(SOURCES, reader, strict=True):
        formulas = [token for token in tokens(text(file)) if token.type == "math_block"]
        numbers = [tag for token in formulas for tag in TAG.findall(token.content)]
        assert numbers == LABEL.findall(text(source))
        for number in numbers:
            assert f'<div id="eq-{number}"></div>\n\n$$\n' in text(file)
    written = {number for file in reader for number in TAG.findall(text(file))}
    assert written == {equation.number for equation in EQUATIONS}


def test_every_link_leads_somewhere(reader: list[Path]) -> None:
    there = {file.name: ANCHOR.findall(text(file)) for file in reader}
    for file in reader:
        assert len(set(there[file.name])) == len(there[file.name])
        for link in links(file):
            assert link
            name, _, anchor = link.partition("#")
            if "://" in link:
                assert re.match(r"https://(doi\.org/10\.|splines\.)", link)
            else:
                assert not anchor or anchor in there[name or file.name]
                assert name in there or not name
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
    for source, file in zip(SOURCES, reader, strict=True):
        tables = linking_outputs(cells(source))
        assert linking_outputs(cells(file)) == []
        for table in tables:
            rows = [line.count("|") for line in table.splitlines()]
            written = [cell.source for cell in cells(file, "markdown") if cell.source[0] == "|"]
            assert rows in [[line.count("|") for line in text.splitlines()] for text in written]
    assert sum(len(linking_outputs(cells(source))) for source in SOURCES) >= 5


QUICK = "01-introduction"


@pytest.mark.parametrize(
    "page",
    [
        pytest.param(page, marks=() if page == QUICK else pytest.mark.slow)
        for page in (source.stem for source in SOURCES)
    ],
)
def test_a_students_notebook_runs_unanswered(page: str, folder: Path, tmp_path: Path) -> None:
    pages = [source.stem for source in SOURCES]
    file = sorted((folder / "student").iterdir())[pages.index(page)]
    notebook = nbformat.read(file, as_version=4)
    place = {"metadata": {"path": tmp_path}}
    NotebookClient(notebook, timeout=300, kernel_name="python3", resources=place).execute()
    assert linking_outputs(notebook.cells) == []
    said = everything(notebook.cells).count(": not answered yet.")
    assert said == len(EXERCISE.findall(text(file)))


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
    first = Classroom(wheel=wheel).notebook("01-introduction.ipynb", "student").cells[0]
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
    first = Classroom().notebook("01-introduction.ipynb", "student").cells[0]
    exec(first.source, {})
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    with pytest.raises(ModuleNotFoundError, match="install rotedu"):
        exec(first.source, {})


def test_marks_for_nbgrader(folder: Path, tmp_path: Path) -> None:
    """It cuts out what stands between the marks; the rest is what students get."""
    Classroom().write(tmp_path, ["nbgrader"])
    files = [sorted(each.iterdir()) for each in (folder / "student", tmp_path / "nbgrader")]
    for source, plain, file in zip(SOURCES, *files, strict=True):
        marked = [cell for cell in cells(file) if "nbgrader" in cell.metadata]
        assert [cell for cell in cells(file) if cell not in marked] == cells(plain)
        solutions = [cell.source for cell in marked if cell.metadata.nbgrader.solution]
        assert solutions == [
            f"### BEGIN SOLUTION\n{cell.source}\n### END SOLUTION"
            for cell in cells(source, "code")
            if SOLUTION.search(cell.source)
        ]
        tests = [cell.source for cell in marked if cell.metadata.nbgrader.grade]
        numbers = EXERCISE.findall(text(source))
        assert tests == [f'assert check("{number}", answer).right' for number in numbers]
