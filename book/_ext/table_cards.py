"""Say in each cell of a table in which column it stands: on a phone, rows are cards (book.css)."""

from html import escape
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.writers.html5 import HTML5Translator

# Letters of cells that stand side by side in a card
SHORT = 12


def visit_entry(writer: HTML5Translator, cell: nodes.entry) -> None:
    """Open a cell."""
    at = len(writer.body)
    HTML5Translator.visit_entry(writer, cell)
    row = cell.parent
    if isinstance(row.parent, nodes.tbody):
        head = row.parent.parent.next_node(nodes.thead)
        name = head[0][row.index(cell)].astext() if head else ""
        short = ' data-short=""' if 0 < len(cell.astext()) <= SHORT else ""
        told = f'<td data-column="{escape(name)}"{short}'
        writer.body[at] = writer.body[at].replace("<td", told, 1)


def setup(app: Sphinx) -> dict[str, Any]:
    """Let cells be written so."""
    writers = (visit_entry, HTML5Translator.depart_entry)
    app.add_node(nodes.entry, override=True, html=writers)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
