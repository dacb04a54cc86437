"""What the cells and paragraphs of a page are, by `tools/notebook_language.py`."""

import sys
from pathlib import Path

from docutils import nodes

sys.path.append(str(Path(__file__).parents[2] / "tools"))
from notebook_language import caption_title, exercise_number, pages, part_of


def code_cells(tree: nodes.Node) -> list[nodes.Element]:
    """Return all cells with code."""
    return [node for node in tree.findall(nodes.container) if node.get("nb_element") == "cell_code"]


def part_of_exercise(cell: nodes.Element) -> tuple[str, str]:
    """Return which part of an exercise a cell is, and the number; else two empty strings."""
    # MyST-NB leaves out the id of a cell, but says where the cell stands in which notebook.
    page = pages()[Path(cell.source).name]
    # A text with cells has no ids of its own.
    return part_of(page.cells[cell["cell_index"]].id) if page.code else ("", "")


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
