"""Give equations the numbers of the paper: the label ``eq-3-1`` gets the number (3-1)."""

from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.domains.math import MathDomain
from sphinx.transforms import SphinxTransform

PREFIX = "eq-"


class PaperMathDomain(MathDomain):
    """Sphinx's domain for formulas, with numbers taken from the labels."""

    def note_equation(self, docname: str, labelid: str, location: Any = None) -> None:
        """Give an equation the number that follows ``eq-`` in its label."""
        super().note_equation(docname, labelid, location)
        if not labelid.startswith(PREFIX):
            raise ValueError(f"equation label: expected {PREFIX}<number>, got {labelid!r}")
        self.equations[labelid] = (docname, labelid.removeprefix(PREFIX))  # type: ignore[assignment]


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


def setup(app: Sphinx) -> dict[str, Any]:
    """Replace Sphinx's own domain, and register the step."""
    app.add_domain(PaperMathDomain, override=True)
    app.add_transform(IndexNumbers)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
