"""Write the notebooks for a class: without solutions in ``student``, with them in ``teacher``.

With ``--nbgrader`` a third folder, ``nbgrader``, becomes a source for nbgrader.
They are the notebooks of the book in plain Markdown, for places that know no MyST. The settings
``book``, ``repository`` and ``wheel`` are in ``pyproject.toml``, under ``tool.rotedu``.
"""

import itertools
import re
import shutil
import sys
import tomllib
from collections.abc import Iterable, Iterator
from pathlib import Path
from string import ascii_lowercase
from typing import Literal
from urllib.parse import urlsplit

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell
from notebook_language import (
    BOOK,
    ROOT,
    Block,
    Exercise,
    Page,
    blocks,
    notebooks,
    pages,
    part_of,
    tags,
    unfolded,
)
from pybtex.database import parse_file

from rotedu import __version__, colors
from rotedu.edition.claims import CLAIMS

CLASS = ROOT / "class"

Reader = Literal["student", "teacher", "nbgrader"]

BOXES = {
    "claim": colors.VECTOR,
    "erratum": colors.AXIS,
    "fair": colors.RESULT,
    "question": colors.NEUTRAL,
}
MACRO = re.compile(rf"\\({'|'.join(name.lower() for name in colors.__all__)})(?![A-Za-z])")
# What a text may hold besides words. Each is found where it begins, so code and formulas may
# contain what looks like the others.
INLINE = re.compile(
    r"\{(?P<role>[\w:]+)\}`(?P<key>[^`]+)`"
    r"|(?P<ticks>`+).+?(?P=ticks)"
    r"|\$(?P<formula>[^$]+)\$"
    r"|\[(?P<text>[^][]+)\]\((?P<address>[^)\s]+)\)",
    re.DOTALL,
)

INSTALL = """\
# Installs rotedu if it is missing.
from importlib.util import find_spec

if find_spec("rotedu") is None:
    print("Installing rotedu from {wheel}")
    %pip install --quiet "{requirement}"\
"""
NO_WHEEL = """\
# Says so if rotedu is missing.
from importlib.util import find_spec

if find_spec("rotedu") is None:
    raise ModuleNotFoundError("Please install rotedu. The book's page Run a class says how.")\
"""
FOR_THE_STUDENT = """\
*Begin with **Run**, **Run All Cells**. Figures and exercises need the cells above them.*\
"""
# Where students need to install nothing themselves. The workflow Release makes tag and branch.
PLACES = {
    "Binder": "https://mybinder.org/v2/gh/{project}/v{version}?urlpath=lab/tree/class/student/{name}",
    "Colab": "https://colab.research.google.com/github/{project}/blob/class/{name}",
}
BUTTON = (
    '<a href="{address}" style="border: 1px solid; border-radius: 4px; padding: 0.2em 0.6em">'
    "Open in {place}</a>"
)
WHEEL = "{repository}/releases/download/v{version}/rotedu-{version}-py3-none-any.whl"
FOR_THE_TEACHER = """\
Solutions are folded below their exercises: click the bar that stands for the code, then the bar \
that stands for the output. The students' notebook has none of them.

A solution that has run shows its output. In front of a class, do not run all cells: select the \
heading *Exercises* and choose *Run All Above Selected Cell*.\
"""
# What nbgrader shows to a student as an answer, and to a teacher with the solution in it.
ANSWER = """\
{start}
### BEGIN SOLUTION
{solution}
### END SOLUTION
{check}\
"""
# A student gets the first line alone. The test trusts nothing that a student may have renamed, and
# an answer that a crash has prevented must not be the one before.
TEST = """\
# nbgrader grades Exercise {number} here.
### BEGIN HIDDEN TESTS
from rotedu.edition.exercises import check as judge

verdict = judge("{number}", globals().pop("answer", ...))
assert verdict.right, verdict
print(verdict)
### END HIDDEN TESTS\
"""
REASONS = """\
**Reasons for your answer to Exercise {number}**, in two to five sentences:

### BEGIN SOLUTION
{why}
### END SOLUTION\
"""
# Of the points of a judgement, one in so many is for the reasons.
FOR_REASONS = 3
# The settings of a course with these notebooks.
SETTINGS = """\
c = get_config()
c.CourseDirectory.course_id = "rotations"
# What students see in place of a solution, where "Run All" must not stop.
c.ClearSolutions.code_stub = {"python": "# Your code, which gives answer its value."}
c.ClearSolutions.text_stub = "*Your reasons.*"
# Seconds for a cell.
c.Execute.timeout = 120
"""
EXERCISES = "\n\n| Exercise | Kind | Minutes |\n| --- | --- | --- |\n"


def coloured(formula: str) -> str:
    """Write out the macros for colours, which other places do not define."""
    return MACRO.sub(lambda m: rf"\textcolor{{{getattr(colors, m[1].upper())}}}", formula)


def numbered(equation: Block) -> str:
    """Return an equation with its number."""
    label, formula = equation.anchor, coloured(equation.body)
    number = label.removeprefix("eq-")
    return f'<div id="{label}"></div>\n\n$$\n{formula}\n\\tag{{{number}}}\n$$'


def quotation(color: str, title: str, body: str) -> str:
    """Return a box: a quotation, with a rule in its colour where styles are allowed."""
    style = f"border-left: 4px solid {color}; padding-left: 1em"
    return f'<blockquote style="{style}">\n\n**{title}**\n\n{body}\n\n</blockquote>'


def class_names() -> dict[str, str]:
    """Name the notebooks of the book so that folders show them in order: 05a-arcs for 05-arcs."""
    names = {}
    files = [page.name for page in notebooks()]
    for chapter, group in itertools.groupby(files, key=lambda name: name.partition("-")[0]):
        of_chapter = list(group)
        joined = "" if chapter.isdigit() else "-"
        for letter, page in zip(ascii_lowercase, of_chapter, strict=False):
            lettered = page.replace(chapter, f"{chapter}{joined}{letter}")
            names[page] = lettered if of_chapter[1:] else page
    return names


class Classroom:
    """Turns the pages of the book into notebooks for a class.

    Parameters
    ----------
    book : str
        The address of the published book. Without one, links lead to the notebooks beside, and
        pages that are no notebooks are not linked.
    wheel : str
        The address or path from which a notebook installs rotedu, if any.
    repository : str
        The address of the repository on GitHub. With one, a student's notebook can be opened on
        Binder and on Colab, and installs the wheel of its release unless another is named.
    alone : bool
        Whether a notebook is on its own, with no others beside it to lead to.
    """

    def __init__(
        self, book: str = "", wheel: str = "", repository: str = "", *, alone: bool = False
    ) -> None:
        self.book = book.rstrip("/")
        self.alone = alone
        self.repository = repository.rstrip("/")
        release = {"repository": self.repository, "version": __version__}
        self.wheel = wheel or (WHEEL.format(**release) if repository else "")
        self.names = class_names()
        self.anchors = {
            # On the page of the book, equations have names of their own.
            name: (page.name, f"equation-{name}" if block.kind == "math" else name, cell.id)
            for page in pages().values()
            for cell in page.text_cells
            for block in unfolded(cell.source)
            if (name := block.anchor)
        }
        claims = (f"claim-{claim.number}" for claim in CLAIMS)
        self.anchors |= {name: ("claims.md", name, "") for name in claims}
        self.sources = parse_file(BOOK / "references.bib").entries

    def linked(self, page: str, text: str, address: str) -> str:
        """Return a text with a link, if there is something to lead to."""
        if "://" in address:
            return f"[{text}]({address})"
        target, _, anchor = address.partition("#")
        in_book = in_lab = ""
        if anchor:
            if anchor not in self.anchors:
                raise ValueError(f"{page}: expected a target on some page, got #{anchor}")
            target, in_book, cell = self.anchors[anchor]
            anchor, in_book, in_lab = f"#{anchor}", f"#{in_book}", f"#cell-id={cell}"
        if target == page:
            return f"[{text}]({anchor})" if anchor else text
        if self.book:
            return f"[{text}]({self.book}/book/{Path(target).stem}.html{in_book})"
        beside = target in self.names and not self.alone
        # JupyterLab goes to a place of another notebook by its cell alone.
        return f"[{text}]({self.names[target]}{in_lab})" if beside else text

    def cited(self, page: str, role: str, key: str) -> str:
        """Return a citation as text, with a link to its source."""
        source = self.sources[key]
        authors = [" ".join(person.last_names) for person in source.persons["author"]]
        names = f"{authors[0]} et al." if len(authors) > 2 else " and ".join(authors)
        year = source.fields["year"]
        text = {"cite:t": f"{names} ({year})", "cite:p": f"({names}, {year})"}[role]
        doi = source.fields.get("doi")
        address = f"https://doi.org/{doi}" if doi else source.fields.get("url", "references.md")
        return self.linked(page, text, address)

    def inline(self, page: str, text: str) -> str:
        """Rewrite citations, formulas and links."""

        def rewrite(match: re.Match[str]) -> str:
            if match["role"]:
                return self.cited(page, match["role"], match["key"])
            if match["formula"]:
                return f"${coloured(match['formula'])}$"
            if match["address"]:
                return self.linked(page, self.inline(page, match["text"]), match["address"])
            return match[0]

        return INLINE.sub(rewrite, text)

    def box(self, page: str, box: Block) -> str:
        """Return a box as a coloured quotation."""
        meaning = box.options.get("class", "").partition(" ")[0]
        if meaning not in BOXES:
            raise ValueError(f"{page}: the box {box.title!r} has no class of {', '.join(BOXES)}")
        return quotation(
            BOXES[meaning], self.inline(page, box.title), self.markdown(page, box.body)
        )

    def block(self, page: str, block: Block) -> str:
        """Rewrite a block without MyST."""
        match block.kind:
            case "admonition":
                return self.box(page, block)
            case "dropdown":
                body = self.markdown(page, block.body)
                summary = f"<summary>{block.title}</summary>"
                return f'<details style="margin: 1em 0">\n{summary}\n\n{body}\n\n</details>'
            case "div":
                return self.markdown(page, block.body)
            case "math":
                return numbered(block)
            case "math_block":
                return f"$$\n{coloured(block.body.strip())}\n$$"
            case "myst_target":
                return f'<div id="{block.title}"></div>'
            case "caption":
                return f'<a id="{block.anchor}"></a>{self.inline(page, block.source)}'
            case "fence" | "code_block":
                return block.source
        if block.source.startswith((":::", "```")):
            raise ValueError(f"{page}: cannot write {block.kind} without MyST")
        return self.inline(page, block.source)

    def markdown(self, page: str, text: str) -> str:
        """Rewrite a text without MyST."""
        return "\n\n".join(self.block(page, block) for block in blocks(text))

    def first_cell(self) -> NotebookNode:
        """Return a cell that installs rotedu where it is missing."""
        requirement = (
            f"rotedu[notebooks] @ {self.wheel}"
            if "://" in self.wheel
            else f"{self.wheel}[notebooks]"
        )
        code = INSTALL.format(wheel=self.wheel, requirement=requirement)
        return new_code_cell(
            code if self.wheel else NO_WHEEL,
            id="install",
            metadata={"jupyter": {"source_hidden": True}},
        )

    def begin(self, page: Page, reader: Reader) -> NotebookNode:
        """Return a cell that says how to begin, and leads a student to where all is installed."""
        text = FOR_THE_STUDENT
        if self.repository and reader == "student":
            project = urlsplit(self.repository).path.strip("/")
            known = {"project": project, "version": __version__, "name": self.names[page.name]}
            buttons = (
                BUTTON.format(place=place, address=address.format(**known))
                for place, address in PLACES.items()
            )
            text += "\n\n" + " ".join(buttons)
        return new_markdown_cell(text, id="begin")

    def code_cells(self, page: Page, cell: NotebookNode) -> Iterator[NotebookNode]:
        """Yield a cell with code, or the text of the table that it makes, if that has links."""
        table = "".join(output.get("data", {}).get("text/markdown", "") for output in cell.outputs)
        if "](" not in table:
            yield code_cell(cell)
            return
        if "remove-input" not in tags(cell):
            # Shown by Python, the links of the table would lead nowhere.
            yield code_cell(NotebookNode(cell, source=f"{cell.source};", outputs=[]))
        yield new_markdown_cell(self.markdown(page.name, table), id=f"{cell.id}-table")

    def cells(self, page: Page, reader: Reader) -> Iterator[NotebookNode]:
        """Yield the cells of a page that a reader gets."""
        yield self.first_cell()
        for cell in page.cells:
            part, number = part_of(cell.id)
            if "remove-cell" in tags(cell) and not (
                reader == "teacher" and "teacher" in tags(cell)
            ):
                continue
            if part == "start" and reader == "nbgrader":
                yield from self.graded(page, page.exercises[number])
            elif part in ("solution", "why") and reader != "teacher":
                continue
            elif cell.cell_type == "markdown":
                yield new_markdown_cell(self.markdown(page.name, cell.source), id=cell.id)
            elif part == "solution":
                yield code_cell(cell)
            else:
                yield from self.code_cells(page, cell)

    def graded(self, page: Page, asked: Exercise) -> Iterator[NotebookNode]:
        """Yield what nbgrader needs of an exercise: its answer, its test and perhaps reasons."""
        name = asked.number.replace(".", "-")
        for_reasons = asked.minutes // FOR_REASONS if asked.kind == "judge" else 0
        # A right answer may move a figure.
        start, check = re.split(r"\n(?=(?:if )?check\()", asked.start.source, maxsplit=1)
        solution, _, _ = asked.solution.source.rpartition("\n")
        answer = ANSWER.format(start=start.rstrip(), solution=solution.rstrip(), check=check)
        yield marked(new_code_cell(answer, id=f"start-{name}"), solution=True)
        test = new_code_cell(TEST.format(number=asked.number), id=f"test-{name}")
        yield marked(test, points=asked.minutes - for_reasons)
        if for_reasons and asked.why:
            why = self.markdown(page.name, asked.why.source)
            text = REASONS.format(number=asked.number, why=why)
            reasons = new_markdown_cell(text, id=f"why-{name}")
            yield marked(reasons, solution=True, points=for_reasons)

    def notebook(self, page: Page, reader: Reader) -> NotebookNode:
        """Return a page as a notebook for a reader."""
        cells = list(self.cells(page, reader))
        # Below the title.
        cells.insert(2, notes(page) if reader == "teacher" else self.begin(page, reader))
        return nbformat.v4.new_notebook(cells=cells, metadata=page.notebook.metadata)

    def write(self, folder: Path, readers: Iterable[Reader] = ("student", "teacher")) -> None:
        """Write a folder for each reader, with nothing else in it."""
        for reader in readers:
            shutil.rmtree(folder / reader, ignore_errors=True)
            (folder / reader).mkdir(parents=True)
            for page in notebooks():
                notebook = self.notebook(page, reader)
                nbformat.validate(notebook)
                nbformat.write(notebook, folder / reader / self.names[page.name])
            if reader == "nbgrader":
                (folder / reader / "nbgrader_config.py").write_text(SETTINGS, encoding="utf-8")


def code_cell(cell: NotebookNode) -> NotebookNode:
    """Return a cell before it runs, with what it will print, folded as in the book."""
    metadata = {"jupyter": cell.metadata.jupyter} if "jupyter" in cell.metadata else {}
    outputs = [NotebookNode(output) for output in cell.outputs]
    for output in outputs:
        if "execution_count" in output:
            output.execution_count = None
    return new_code_cell(cell.source, id=cell.id, metadata=metadata, outputs=outputs)


def notes(page: Page) -> NotebookNode:
    """Return a cell that tells the teacher what to know about a notebook."""
    asked = page.exercises.values()
    rows = [f"| {each.number} | {each.kind} | {each.minutes} |" for each in asked]
    body = FOR_THE_TEACHER + EXERCISES + "\n".join(rows) if rows else FOR_THE_TEACHER
    return new_markdown_cell(quotation(colors.NEUTRAL, "For the teacher", body), id="notes")


def marked(cell: NotebookNode, *, solution: bool = False, points: int = 0) -> NotebookNode:
    """Return a cell with the marks of nbgrader: students write solutions, points make grades."""
    marks = {
        "schema_version": 3,
        "grade_id": cell.id,
        "solution": solution,
        "locked": not solution,
        "grade": bool(points),
        "task": False,
    }
    cell.metadata.nbgrader = marks | ({"points": points} if points else {})
    return cell


def classroom(*, alone: bool = False) -> Classroom:
    """Return what writes notebooks with the addresses of ``pyproject.toml``."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    return Classroom(**project["tool"]["rotedu"], alone=alone)


if __name__ == "__main__":
    readers: list[Reader] = ["student", "teacher"]
    if "--nbgrader" in sys.argv:
        readers.append("nbgrader")
    classroom().write(CLASS, readers)
    print("The notebooks for a class are here:", *(f"class/{reader}" for reader in readers))
