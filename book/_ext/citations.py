"""The list of references is a list for those who hear it, too.

docutils gives its entries a role that has been dropped, so that the list seems empty.
"""

from typing import Any

from docutils import nodes
from sphinx.application import Sphinx


def is_neighbour(node: nodes.Node | None) -> bool:
    """Tell whether this is another entry of the same list."""
    return isinstance(node, nodes.citation)


def visit_citation(writer: Any, node: nodes.citation) -> None:
    """Open an entry, and the list before the first."""
    if not is_neighbour(node.previous_sibling()):
        writer.body.append('<div role="list" class="citation-list">\n')
    writer.body.append(writer.starttag(node, "div", CLASS="citation", role="listitem"))


def depart_citation(writer: Any, node: nodes.citation) -> None:
    """Close an entry, and the list after the last."""
    writer.body.append("</div>\n")
    if not is_neighbour(node.next_node(descend=False, siblings=True)):
        writer.body.append("</div>\n")


def setup(app: Sphinx) -> dict[str, Any]:
    """Take the place of docutils' functions."""
    app.add_node(nodes.citation, override=True, html=(visit_citation, depart_citation))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
