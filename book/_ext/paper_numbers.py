"""Give equations the numbers of the paper: the label ``eq-3-1`` gets the number (3-1).

Beside its label, an equation has the two options by which MyST in JupyterLab numbers it.
"""

from typing import Any

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.directives.patches import MathDirective
from sphinx.domains.math import MathDomain
from sphinx.transforms import SphinxTransform
from sphinx.util.index_entries import split_index_msg

PREFIX = "eq-"


class PaperMathDomain(MathDomain):
    """Sphinx's domain for formulas, with numbers taken from the labels."""

    def note_equation(self, docname: str, labelid: str, location: Any = None) -> None:
        """Give an equation the number that follows ``eq-`` in its label."""
        super().note_equation(docname, labelid, location)
        if not labelid.startswith(PREFIX):
            raise ValueError(f"equation label: expected {PREFIX}<number>, got {labelid!r}")
        self.equations[labelid] = (docname, labelid.removeprefix(PREFIX))  # type: ignore[assignment]


class NumberedEquation(MathDirective):
    """Sphinx's directive, with the options ``enumerated`` and ``enumerator``."""

    option_spec = MathDirective.option_spec | {
        "enumerated": directives.unchanged,
        "enumerator": directives.unchanged,
    }


class IndexNumbers(SphinxTransform):
    """Make equations searchable by their numbers."""

    default_priority = 400

    def apply(self, **_: Any) -> None:
        """Insert an index entry before each numbered equation."""
        for equation in list(self.document.findall(nodes.math_block)):
            if label := equation.get("label"):
                number = label.removeprefix(PREFIX)
                entry = ("single", number, f"equation-{label}", "main", None)
                around = equation.parent
                around.insert(around.index(equation), addnodes.index(entries=[entry]))


def remember_entries(app: Sphinx) -> list[Any]:
    """Give the search the entries of all pages: Sphinx forgets those of pages that it keeps."""
    for docname, entries in app.env.domains["index"].entries.items():
        words = {
            (word, target, main)
            for kind, value, target, main, _ in entries
            for word in split_index_msg(kind, value)
        }
        app.env._search_index_index_entries[docname] = sorted(words)
    return []


def setup(app: Sphinx) -> dict[str, Any]:
    """Replace Sphinx's own domain and directive, and register the steps."""
    app.add_domain(PaperMathDomain, override=True)
    app.add_directive("math", NumberedEquation, override=True)
    app.add_transform(IndexNumbers)
    # Before the index of the search is written
    app.connect("html-collect-pages", remember_entries)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
