"""What the pages of the book say: nothing else reads their notebooks and texts.

What a cell is, its id says: ``exercise-3-2`` asks Exercise 3.2, ``start-3-2`` is its starter cell,
``solution-3-2`` solves it, ``why-3-2`` gives the reasons. Texts are read for headings, captions and
boxes. Numbers are names: there may be an Exercise A.1 and a Picture A-a.
"""

import functools
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path

import nbformat
import yaml
from markdown_it import MarkdownIt
from markdown_it.token import Token
from mdit_py_plugins.colon_fence import colon_fence_plugin
from mdit_py_plugins.dollarmath import dollarmath_plugin
from mdit_py_plugins.front_matter import front_matter_plugin
from mdit_py_plugins.myst_blocks import myst_block_plugin
from mdit_py_plugins.myst_role import myst_role_plugin
from nbformat import NotebookNode
from nbformat.v4 import new_markdown_cell, new_notebook

ROOT = Path(__file__).parents[1]
BOOK = ROOT / "book"

PART = re.compile(r"(exercise|start|solution|why)-(\w+)-(\d+)")
CAPTION = re.compile(r"((?:Figure|Picture) \w+(?:-\w+)?)\.")
EXERCISE = re.compile(r"Exercise (\w+\.\d+)")
QUESTION = re.compile(rf"\*\*{EXERCISE.pattern}\*\* \((.+), (\d+) minutes?\)\.")
DIRECTIVE = re.compile(r"\{([\w-]+)\} *(.*)")
OPTIONS = re.compile(r"(?::[\w-]+:.*\n)*")
BY_HAND = re.compile(r"(\w+ = )?explore\(scenes\.")
OPTION = re.compile(r":([\w-]+): *(.*)")

MYST = MarkdownIt("commonmark").enable("table").use(dollarmath_plugin, allow_labels=True)
for plugin in (colon_fence_plugin, front_matter_plugin, myst_block_plugin, myst_role_plugin):
    MYST.use(plugin)


def part_of(cell_id: str) -> tuple[str, str]:
    """Return the part of an exercise that a cell is, and its number; else two empty strings."""
    part = PART.fullmatch(cell_id)
    return (part[1], f"{part[2]}.{part[3]}") if part else ("", "")


def caption_title(bold: str) -> str:
    """Return the title, such as ``Picture 3-a``, if these words in bold begin a caption."""
    title = CAPTION.fullmatch(bold)
    return title[1] if title else ""


def exercise_number(bold: str) -> str:
    """Return the number if these words in bold begin an exercise."""
    number = EXERCISE.fullmatch(bold)
    return number[1] if number else ""


@dataclass(frozen=True)
class Block:
    """A part of a text, such as a paragraph or a box."""

    kind: str  #: ``caption``, or the name of a directive, else the type of markdown-it's token
    source: str  #: its lines
    title: str = ""  #: what a directive, a caption or a target is called
    body: str = ""  #: what is inside a directive, a formula or a listing
    options: dict[str, str] = field(default_factory=dict)  #: of a directive

    @property
    def anchor(self) -> str:
        """The name by which links find a target, an equation or a caption; else nothing."""
        match self.kind:
            case "math":
                return self.options["label"]
            case "myst_target":
                return self.title
            case "caption":
                return self.title.lower().replace(" ", "-")
        return ""

    @property
    def choices(self) -> list["Block"]:
        """The folded texts in a box: the choices of a question."""
        return [block for block in blocks(self.body) if block.kind == "dropdown"]


def blocks(text: str) -> Iterator[Block]:
    """Yield the blocks of a text."""
    lines = text.splitlines()
    tokens = MYST.parse(text)
    for token, inside in zip(tokens, [*tokens[1:], Token("", "", 0)], strict=True):
        if token.level or not token.map:
            continue
        source = "\n".join(lines[slice(*token.map)]).strip()
        directive = DIRECTIVE.fullmatch(token.info)
        if token.type in ("colon_fence", "fence") and directive:
            options = OPTIONS.findall(token.content)[0]
            body = token.content[len(options) :].strip()
            if directive[1] == "literalinclude":
                body = (BOOK / directive[2]).read_text("utf-8")
            yield Block(directive[1], source, directive[2], body, dict(OPTION.findall(options)))
        elif token.type == "paragraph_open" and (
            title := caption_title(bold(inside.children or []))
        ):
            yield Block("caption", source, title)
        else:
            title = token.content if token.type == "myst_target" else ""
            yield Block(token.type, source, title, token.content)


def bold(words: list[Token]) -> str:
    """Return the words in bold with which a paragraph begins."""
    # An empty text stands before a word in bold.
    begins = [token.type for token in words[1:4]] == ["strong_open", "text", "strong_close"]
    return words[2].content if begins and not words[0].content else ""


def plain(text: str) -> str:
    """Return the words of a text without boxes; each formula becomes one word."""
    written = {"math_inline": "formula", "html_inline": "", "softbreak": " "}
    texts = [token.children or [] for token in MYST.parse(text) if token.type == "inline"]
    return "\n".join("".join(written.get(t.type, t.content) for t in words) for words in texts)


@dataclass(frozen=True)
class Exercise:
    """An exercise: what its text says about it, and its cells."""

    number: str
    kind: str
    minutes: int
    text: NotebookNode
    start: NotebookNode
    solution: NotebookNode
    why: NotebookNode | None = None


class Page:
    """A page of the book.

    Parameters
    ----------
    file : Path
        A notebook, or a text, which becomes a notebook of one cell.
    """

    def __init__(self, file: Path) -> None:
        self.file = file
        self.name = file.name
        if file.suffix == ".ipynb":
            self.notebook = nbformat.read(file, as_version=4)
        else:
            self.notebook = new_notebook(cells=[new_markdown_cell(file.read_text("utf-8"))])
        self.cells: list[NotebookNode] = self.notebook.cells

    def __repr__(self) -> str:
        return self.file.stem

    @functools.cached_property
    def code(self) -> list[NotebookNode]:
        """The cells with code."""
        return [cell for cell in self.cells if cell.cell_type == "code"]

    @property
    def text_cells(self) -> list[NotebookNode]:
        """The cells with text, without what the book leaves out."""
        cells = (cell for cell in self.cells if cell.cell_type == "markdown")
        return [cell for cell in cells if "remove-cell" not in tags(cell)]

    @functools.cached_property
    def text(self) -> str:
        """The text, without what the book leaves out."""
        return "\n\n".join(cell.source for cell in self.text_cells)

    @functools.cached_property
    def blocks(self) -> list[Block]:
        """The blocks of the text, each box before what is inside it."""
        return list(unfolded(self.text))

    def all(self, kind: str) -> list[Block]:
        """Return the blocks of a kind."""
        return [block for block in self.blocks if block.kind == kind]

    def boxes(self, meaning: str) -> list[Block]:
        """Return the boxes of a class: ``claim``, ``erratum``, ``fair`` or ``question``."""
        return [b for b in self.all("admonition") if meaning in b.options["class"].split()]

    @functools.cached_property
    def exercises(self) -> dict[str, Exercise]:
        """The exercises by number."""
        cells: dict[str, dict[str, NotebookNode]] = {}
        for cell in self.cells:
            part, number = part_of(cell.id)
            if part:
                cells.setdefault(number, {})[part] = cell
        return {number: self.exercise(number, parts) for number, parts in cells.items()}

    def exercise(self, number: str, cells: dict[str, NotebookNode]) -> Exercise:
        """Read an exercise, and refuse one without a question, a starter cell or a solution."""
        if list(cells)[:3] != ["exercise", "start", "solution"]:
            raise ValueError(
                f"{self.name}, Exercise {number}: expected cells exercise, start, solution and"
                f" perhaps why, got {', '.join(cells)}"
            )
        asked = QUESTION.search(cells["exercise"].source)
        if not asked or asked[1] != number:
            raise ValueError(
                f"{self.name}, cell {cells['exercise'].id}: expected"
                f" **Exercise {number}** (kind, 5 minutes)., got {cells['exercise'].source[:50]!r}"
            )
        return Exercise(number, asked[2], int(asked[3]), *cells.values())


def unfolded(text: str) -> Iterator[Block]:
    """Yield the blocks of a text, and after each box those inside it."""
    for block in blocks(text):
        yield block
        if block.kind in ("admonition", "div", "dropdown"):
            yield from unfolded(block.body)


def tags(cell: NotebookNode) -> set[str]:
    """Return the tags of a cell."""
    return set(cell.metadata.get("tags", []))


def answers_the_hand(cell: NotebookNode) -> bool:
    """Tell whether a cell shows a figure that answers the hand."""
    return bool(BY_HAND.match(cell.source))


@functools.cache
def pages() -> dict[str, Page]:
    """Read all pages, in the order of the contents."""
    contents = yaml.safe_load((ROOT / "_toc.yml").read_text("utf-8"))
    listed = [chapter["file"] for part in contents["parts"] for chapter in part["chapters"]]
    files = [ROOT / name for name in (contents["root"], *listed)]
    found = [next(file.parent.glob(f"{file.name}.*")) for file in files]
    return {file.name: Page(file) for file in found}


def notebooks() -> list[Page]:
    """Return the pages that are notebooks."""
    return [page for page in pages().values() if page.file.suffix == ".ipynb"]


def chapters() -> list[Page]:
    """Return the pages that have exercises."""
    return [page for page in notebooks() if page.exercises]


@functools.cache
def exercises() -> dict[str, Exercise]:
    """Return the exercises of all pages by number."""
    found: dict[str, Exercise] = {}
    for page in chapters():
        if twice := found.keys() & page.exercises.keys():
            raise ValueError(f"{page.name}: expected numbers of its own, got {sorted(twice)} again")
        found |= page.exercises
    return found


def captions_by_hand() -> list[Block]:
    """Return the captions of all figures that answer the hand."""
    return [
        next(blocks(below.source))
        for page in chapters()
        for cell, below in pairwise(page.cells)
        if answers_the_hand(cell)
    ]
