"""The notebooks for a class, compared with those of the book."""

import importlib.util
import re
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import nbformat
import pytest
from bs4 import BeautifulSoup
from class_notebooks import Classroom
from html_pages import anchors
from IPython.core.inputtransformer2 import TransformerManager
from markdown_it import MarkdownIt
from mdit_py_plugins.dollarmath import dollarmath_plugin
from nbclient import NotebookClient
from nightly import nightly
from notebook_language import ROOT, Page, notebooks

import rotedu
from rotedu import colors
from rotedu.edition.equations import EQUATIONS

SOURCES = notebooks()
TAG = re.compile(r"\\tag\{(.*?)\}")
KNOWN = r"https://(doi\.org/10\.|arxiv\.org/abs/|splines\.|eater\.net/|marctenbosch\.com/)"
BUTTONS = re.compile(r'<a href="(.+?)"[^>]*>Open in (\w+)</a>')
# Macros of colours, too.
MYST = re.compile(
    r"^:::|^:\w+: |^\(.+\)=|\{[\w:]+\}`|\$\$ \(|<!--|\\def|"
    rf"\\(?:{'|'.join(colors.__all__).lower()})\b",
    re.MULTILINE,
)
FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
REPOSITORY = "https://github.example/someone/rotedu"

# Without MyST: what other places read.
PLAIN = MarkdownIt("commonmark").enable("table").use(dollarmath_plugin, allow_labels=False)


def tokens(source: str) -> Iterator[Any]:
    for token in PLAIN.parse(source):
        yield token
        yield from token.children or ()


def links(page: Page) -> list[str]:
    found = (token for token in tokens(page.text) if token.type == "link_open")
    return [token.attrs["href"] for token in found]


def tables(cells: list[Any]) -> list[str]:
    """What cells put out as Markdown."""
    outputs = [output for cell in cells for output in cell.get("outputs", ())]
    shown = [output.get("data", {}).get("text/markdown") for output in outputs]
    return list(filter(None, shown))


def everything(cells: list[Any]) -> str:
    """All that a reader of these cells can see: sources and outputs."""
    outputs = [output for cell in cells for output in cell.get("outputs", ())]
    shown = [output.get("text") or "\n".join(output["data"].values()) for output in outputs]
    return "\n".join([cell.source for cell in cells] + shown)


def by_id(page: Page) -> dict[str, Any]:
    return {cell.id: cell for cell in page.cells}


Pairs = list[tuple[Page, Page]]


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Pairs]:
    """The notebooks of each reader, in the order of the folder, beside those of the book."""
    folder = tmp_path_factory.mktemp("class")
    (folder / "student").mkdir()
    (folder / "student" / "06-of-last-year.ipynb").touch()
    readers = ("student", "teacher", "nbgrader")
    Classroom().write(folder, readers)
    found = {name: sorted((folder / name).glob("*.ipynb")) for name in readers}
    return {
        name: list(zip(SOURCES, map(Page, files), strict=True)) for name, files in found.items()
    }


@pytest.fixture(params=["student", "teacher"])
def reader(request: pytest.FixtureRequest, written: dict[str, Pairs]) -> Pairs:
    return written[request.param]


def test_students_see_no_solution(written: dict[str, Pairs]) -> None:
    for page, mine in written["student"]:
        asked = page.exercises.values()
        secrets = [cell for e in asked for cell in (e.solution, e.why) if cell]
        public = everything([cell for cell in page.cells if cell not in secrets])
        lines = re.split(r"\n|(?<=\.) ", everything(secrets))
        # Short lines, such as "else:" and "]", tell nothing.
        secret = {line for line in lines if len(line) > 12 and line not in public}
        assert len(secret) >= len(asked)
        seen = everything(mine.cells)
        assert [line for line in secret if line in seen] == []


def test_exercises_have_their_starters_and_for_the_teacher_folded_solutions(
    written: dict[str, Pairs],
) -> None:
    for page, mine in (*written["student"], *written["teacher"]):
        cells = by_id(mine)
        for number, exercise in page.exercises.items():
            assert f"**Exercise {number}**" in cells[exercise.text.id].source
            assert cells[exercise.start.id].source == exercise.start.source
    for page, mine in written["teacher"]:
        cells = by_id(mine)
        for exercise in page.exercises.values():
            solution = cells[exercise.solution.id]
            assert solution.source == exercise.solution.source
            assert solution.metadata.jupyter == {"source_hidden": True, "outputs_hidden": True}
            if exercise.why:
                assert "\n<summary>Why</summary>\n" in cells[exercise.why.id].source


def test_no_myst_is_left_and_html_is_balanced(reader: Pairs) -> None:
    assert sum(len(MYST.findall(page.text)) for page in SOURCES) > 500
    for _, mine in reader:
        assert MYST.findall(FENCE.sub("", "\n".join([mine.text, *tables(mine.cells)]))) == []
        for cell in mine.text_cells:
            html = "".join(token.content for token in tokens(cell.source) if "html" in token.type)
            for name in ("details", "summary", "blockquote", "div", "a"):
                assert len(re.findall(rf"<{name}\b", html)) == html.count(f"</{name}>")


def test_boxes_keep_their_colours_and_their_choices(reader: Pairs) -> None:
    meaning = {
        colors.VECTOR: "claim",
        colors.AXIS: "erratum",
        colors.RESULT: "fair",
        colors.NEUTRAL: "question",
    }
    for page, mine in reader:
        text = "\n\n".join(cell.source for cell in mine.text_cells if cell.id != "notes")
        boxes = page.all("admonition")
        borders = re.findall(r"border-left: 4px solid (#\w+)", text)
        kinds = [box.options["class"].split()[0] for box in boxes]
        assert [meaning[color] for color in borders] == kinds
        html = BeautifulSoup(PLAIN.render(text), "html.parser")
        questions = {box.title: box for box in page.boxes("question")}
        assert questions or not page.exercises
        found = [box for box in html.find_all("blockquote") if box.p.get_text() in questions]
        assert len(found) == len(questions)
        for box in found:
            choices = box.find_all("details", recursive=False)
            expected = [choice.title for choice in questions[box.p.get_text()].choices]
            assert [choice.summary.get_text() for choice in choices] == expected
            assert len(choices) >= 2
            assert all(choice.p.get_text() for choice in choices)


def test_equations_carry_the_papers_numbers(reader: Pairs) -> None:
    for page, mine in reader:
        formulas = [token for token in tokens(mine.text) if token.type == "math_block"]
        numbers = [tag for token in formulas for tag in TAG.findall(token.content)]
        assert [f"eq-{n}" for n in numbers] == [e.options["label"] for e in page.all("math")]
        assert all(f'<div id="eq-{n}"></div>\n\n$$\n' in mine.text for n in numbers)
    written = {number for _, mine in reader for number in TAG.findall(mine.text)}
    assert written == {equation.number for equation in EQUATIONS}


def test_every_link_leads_somewhere(reader: Pairs) -> None:
    there = {mine.name: re.findall(r'\bid="([^"]+)"', mine.text) for _, mine in reader}
    cells = {mine.name: by_id(mine) for _, mine in reader}
    for _, mine in reader:
        assert len(set(there[mine.name])) == len(there[mine.name])
        for link in links(mine):
            assert link
            name, _, anchor = link.partition("#")
            if "://" in link:
                assert re.match(KNOWN, link)
                continue
            assert name in there or not name
            # JupyterLab goes to a place of another notebook by its cell alone.
            places = cells[name] if name else there[mine.name]
            assert not anchor or anchor.removeprefix("cell-id=") in places
            assert anchor.startswith("cell-id=") == bool(name and anchor)
    assert sum(len(links(mine)) for _, mine in reader) > 300


def test_links_can_lead_to_the_published_book(book: Path, tmp_path: Path) -> None:
    address = "https://book.example/rotations"
    Classroom(address + "/").write(tmp_path)
    found = [link for file in (tmp_path / "teacher").iterdir() for link in links(Page(file))]
    assert all(link.startswith(("#", "https://")) for link in found)
    there = {link.removeprefix(f"{address}/") for link in found if link.startswith(address)}
    for link in there:
        name, _, anchor = link.partition("#")
        # The page must be there, also for a link without an anchor.
        targets = anchors(book / name)
        assert not anchor or anchor in targets
    assert len({link.partition("#")[0] for link in there}) > 12


def linking(cells: list[Any]) -> list[str]:
    """Tables with links, which Python makes for the book."""
    return [table for table in tables(cells) if "](" in FENCE.sub("", table)]


def test_tables_with_links_are_text(reader: Pairs) -> None:
    assert sum(len(linking(page.cells)) for page in SOURCES) >= 5
    for page, mine in reader:
        assert linking(mine.cells) == []
        texts = [cell.source for cell in mine.text_cells if cell.source[0] == "|"]
        bars = [[line.count("|") for line in text.splitlines()] for text in texts]
        for table in linking(page.cells):
            assert [line.count("|") for line in table.splitlines()] in bars


@pytest.mark.parametrize("page", nightly(SOURCES, SOURCES[0]), ids=repr)
def test_a_students_notebook_runs_unanswered(
    page: Page, written: dict[str, Pairs], tmp_path: Path
) -> None:
    notebook = nbformat.read(dict(written["student"])[page].file, as_version=4)
    place = {"metadata": {"path": tmp_path}}
    NotebookClient(notebook, timeout=300, kernel_name="python3", resources=place).execute()
    assert linking(notebook.cells) == []
    assert everything(notebook.cells).count(": not answered yet.") == len(page.exercises)


@pytest.mark.parametrize(
    ("wheel", "requirement"),
    [
        ("https://host.example/r.whl", "rotedu[notebooks] @ https://host.example/r.whl"),
        ("/srv/r.whl", "/srv/r.whl[notebooks]"),
    ],
)
def test_the_first_cell_installs_rotedu_only_where_it_is_missing(
    wheel: str, requirement: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = Classroom(wheel=wheel).first_cell()
    code = TransformerManager().transform_cell(first.source)
    magics: list[tuple[str, ...]] = []
    shell = SimpleNamespace(run_line_magic=lambda *magic: magics.append(magic))
    exec(code, {"get_ipython": lambda: shell})
    assert magics == []
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    exec(code, {"get_ipython": lambda: shell})
    assert magics == [("pip", f'install --quiet "{requirement}"')]
    with pytest.raises(ModuleNotFoundError, match="install rotedu"):
        exec(Classroom().first_cell().source, {})


def test_a_student_can_open_a_notebook_of_the_release_elsewhere(written: dict[str, Pairs]) -> None:
    """On Binder, which runs postBuild at the tag, and on Colab, for which a branch is pushed."""
    release = (ROOT / ".github" / "workflows" / "release.yml").read_text("utf-8")
    assert '/$GITHUB_REPOSITORY" class\n' in release
    tag = f"v{rotedu.__version__}"
    binder = f"https://mybinder.org/v2/gh/someone/rotedu/{tag}?urlpath=lab/tree/class/student/"
    colab = "https://colab.research.google.com/github/someone/rotedu/blob/class/"
    classroom = Classroom(repository=f"{REPOSITORY}/")
    for page, mine in written["student"]:
        assert re.match(r"# \w", mine.cells[1].source)
        assert "**Run All Cells**" in mine.cells[2].source
        begin = classroom.notebook(page, "student").cells[2].source
        places = [(binder + mine.name, "Binder"), (colab + mine.name, "Colab")]
        assert BUTTONS.findall(begin) == places
    wheel = f"rotedu-{rotedu.__version__}-py3-none-any.whl"
    assert f"{REPOSITORY}/releases/download/{tag}/{wheel}" in classroom.first_cell().source
    named = Classroom(repository=REPOSITORY, wheel="/srv/r.whl")
    assert '"/srv/r.whl[notebooks]"' in named.first_cell().source
    for reader in ("teacher", "nbgrader"):
        assert not BUTTONS.findall(everything(classroom.notebook(SOURCES[0], reader).cells))
    assert not BUTTONS.findall(everything(written["student"][0][1].cells))


SOLUTION = re.compile("### BEGIN SOLUTION\n(.*?)### END SOLUTION\n?", re.DOTALL)
HIDDEN = re.compile("### BEGIN HIDDEN TESTS\n.*### END HIDDEN TESTS", re.DOTALL)


def lines(code: str) -> list[str]:
    """The lines of a listing that are not empty."""
    return list(filter(None, code.split("\n")))


def test_nbgrader_gets_an_answer_a_test_and_perhaps_reasons(written: dict[str, Pairs]) -> None:
    for page, mine in written["nbgrader"]:
        cells = by_id(mine)
        for number, asked in page.exercises.items():
            start, test, why = (
                cells.get(f"{part}-{number.replace('.', '-')}") for part in ("start", "test", "why")
            )
            (solution,) = SOLUTION.findall(start.source)
            assert start.source.index("### END SOLUTION") < start.source.index("check(")
            check = f'check("{number}", answer)'
            assert [*lines(solution), check] == lines(asked.solution.source)
            # Without its solution it is what every student gets.
            assert lines(SOLUTION.sub("", start.source)) == lines(asked.start.source)
            # What "Run All" meets has nothing that could fail.
            assert HIDDEN.sub("", test.source) == f"# nbgrader grades Exercise {number} here.\n"
            marks = [cell.metadata.nbgrader for cell in (start, test, why) if cell]
            points = [each.get("points", 0) for each in marks]
            assert (points[0], sum(points)) == (0, asked.minutes)
            assert (why is not None) == (asked.kind == "judge")
            if why:
                assert min(points[1:]) > 0
                # The reasons of the book are between the marks, and nowhere else.
                assert "<summary>Why</summary>" in SOLUTION.findall(why.source)[0]
                assert f"answer to Exercise {number}**" in SOLUTION.sub("", why.source)
