"""What the cells and paragraphs of a page are, by `tools/notebook_language.py`."""

import sys
from pathlib import Path

from docutils import nodes
from nbformat import NotebookNode
from sphinx_design.shared import create_component

sys.path.append(str(Path(__file__).parents[2] / "tools"))
from notebook_language import caption_title, exercise_number, pages, part_of


def code_cells(tree: nodes.Node) -> list[nodes.Element]:
    """Return all cells with code."""
    return [node for node in tree.findall(nodes.container) if node.get("nb_element") == "cell_code"]


def notebook_cell(cell: nodes.Element) -> NotebookNode | None:
    """Return what the notebook of the page says about a cell; nothing for a text with cells."""
    # MyST-NB leaves out the id of a cell, but says where the cell stands in which notebook.
    page = pages()[Path(cell.source).name]
    return page.cells[cell["cell_index"]] if page.code else None


def part_of_exercise(cell: nodes.Element) -> tuple[str, str]:
    """Return which part of an exercise a cell is, and the number; else two empty strings."""
    found = notebook_cell(cell)
    return part_of(found.id) if found else ("", "")


def bold(paragraph: nodes.Element) -> str:
    """Return the words in bold with which a paragraph begins."""
    # MyST puts an empty text before a word in bold.
    first = next((child for child in paragraph.children if child.astext()), None)
    return first.astext() if isinstance(first, nodes.strong) else ""


def caption_of(paragraph: nodes.Element) -> str:
    """Return the title, such as ``Picture 3-a``, if a paragraph is a caption."""
    return caption_title(bold(paragraph))


def exercise_of(paragraph: nodes.Element) -> str:
    """Return the number if a paragraph begins an exercise."""
    return exercise_number(bold(paragraph))


def spoken(words: str) -> nodes.inline:
    """Make words for those who hear a page and do not see its colours and bold letters."""
    return nodes.inline("", words, classes=["spoken", "on-screen"])


def is_dropdown(node: nodes.Node) -> bool:
    """Tell whether a node is a folded text of sphinx-design."""
    return isinstance(node, nodes.container) and node.get("design_component") == "dropdown"


def folded(name: str, title: list[nodes.Node], content: list[nodes.Node]) -> nodes.container:
    """Make a folded text of a class, as sphinx-design makes one, which opens on paper."""
    made = create_component("dropdown", children=[nodes.rubric("", "", *title), *content])
    classes = {"container_classes": [name], "title_classes": [], "body_classes": []}
    options = {"type": "dropdown", "opened": False, "has_title": True, "icon": "", "chevron": ""}
    made.attributes |= options | classes
    return made


def belongs_to_solution(node: nodes.Node) -> bool:
    """Tell whether a node is the reason of a solution, or the caption of its picture."""
    return is_dropdown(node) or (isinstance(node, nodes.paragraph) and bool(caption_of(node)))
