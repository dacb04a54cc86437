"""How listings and tables are written.

What no style colours in a listing needs no element: each costs a phone time, and commas, brackets
and spaces are half of a listing's. On paper, only a long listing may go over the page. A cell of a
table says in which column it stands: on a phone, rows are cards (book.css). The first cell of a row
is its head, for who hears the table, unless it is a formula, which axe takes for nothing. Of the
ledger, which a cell with the tag ``ledger`` shows, the rows that a page adds can be told from the
others. The claims, which a cell with the tag ``claims`` shows, are folded.
"""

from collections.abc import Iterable
from html import escape
from typing import Any

from docutils import nodes
from pygments.formatters import HtmlFormatter
from pygments.token import Punctuation, Text, Whitespace
from sphinx.application import Sphinx
from sphinx.highlighting import PygmentsBridge
from sphinx.transforms import SphinxTransform
from sphinx.writers.html5 import HTML5Translator

from cells import code_cells, spoken

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


# Beside the table that it hides on a screen
FOLD = '<details class="rows"><summary>The claims that this page judges</summary></details>'


class LedgerAndClaims(SphinxTransform):
    """Mark the rows of the ledger that a page adds, whose first cell is bold; fold the claims."""

    default_priority = 400

    def apply(self, **_: Any) -> None:
        """Find the cells that show them."""
        for cell in code_cells(self.document):
            for table in list(cell.findall(nodes.table)):
                if "tag_claims" in cell["classes"]:
                    hides = nodes.raw("", FOLD, format="html")
                    at = table.parent.index(table)
                    table.parent.insert(at, nodes.container("", hides, classes=["on-screen"]))
                elif "tag_ledger" in cell["classes"]:
                    mark_rows(table)


def mark_rows(ledger: nodes.table) -> None:
    """Give the ledger a class; let eye and ear find the rows whose first cell is bold."""
    ledger["classes"].append("ledger")
    for row in ledger.findall(nodes.row):
        if row[0].next_node(nodes.strong):
            row["classes"].append("here")
            row[0].next_node(nodes.paragraph).insert(0, spoken("new here: "))


def visit_entry(writer: HTML5Translator, cell: nodes.entry) -> None:
    """Open a cell."""
    at = len(writer.body)
    HTML5Translator.visit_entry(writer, cell)
    row = cell.parent
    if isinstance(row.parent, nodes.tbody):
        head = row.parent.parent.next_node(nodes.thead)
        name = head[0][row.index(cell)].astext() if head else ""
        short = ' data-short=""' if 0 < len(cell.astext()) <= SHORT else ""
        words = [
            text for text in cell.findall(nodes.Text) if not isinstance(text.parent, nodes.math)
        ]
        is_head = cell is row[0] and "".join(words).strip()
        tag = 'th scope="row"' if is_head else "td"
        told = f'<{tag} data-column="{escape(name)}"{short}'
        writer.body[at] = writer.body[at].replace("<td", told, 1)
        if is_head:
            writer.context[-1] = "</th>"


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step, and let listings and tables be written so."""
    PygmentsBridge.html_formatter = PlainPunctuation
    writers = (visit_entry, HTML5Translator.depart_entry)
    app.add_transform(LedgerAndClaims)
    app.add_node(nodes.entry, override=True, html=writers)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
