"""How listings and tables are written.

What no style colours in a listing needs no element: each costs a phone time, and commas, brackets
and spaces are half of a listing's. On paper, only a long listing may go over the page. A cell of a
table says in which column it stands: on a phone, rows are cards (book.css).
"""

from collections.abc import Iterable
from html import escape
from typing import Any

from docutils import nodes
from pygments.formatters import HtmlFormatter
from pygments.token import Punctuation, Text, Whitespace
from sphinx.application import Sphinx
from sphinx.highlighting import PygmentsBridge
from sphinx.writers.html5 import HTML5Translator

# Lines of code from which on it may go over the page
LONG = 12
# Letters of cells that stand side by side in a card
SHORT = 12


class PlainPunctuation(HtmlFormatter):
    """Listings in which punctuation and spaces are text without an element."""

    def format_unencoded(self, tokensource: Iterable[tuple[Any, str]], outfile: Any) -> None:
        """Write the tokens."""
        plain = [
            (Text if kind in Punctuation or kind in Whitespace else kind, text)
            for kind, text in tokensource
        ]
        if "".join(text for _, text in plain).strip().count("\n") + 1 >= LONG:
            self.cssclass += " long"
        super().format_unencoded(plain, outfile)


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
    """Let both be written so."""
    PygmentsBridge.html_formatter = PlainPunctuation
    writers = (visit_entry, HTML5Translator.depart_entry)
    app.add_node(nodes.entry, override=True, html=writers)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
