"""Equations carry the numbers of the paper: the label ``eq-3-1`` is numbered (3-1)."""

from typing import Any

from sphinx.application import Sphinx
from sphinx.domains.math import MathDomain

PREFIX = "eq-"


class PaperMathDomain(MathDomain):
    """Sphinx's domain for formulas, with numbers read from the labels."""

    def note_equation(self, docname: str, labelid: str, location: Any = None) -> None:
        """Give an equation the number that follows ``eq-`` in its label."""
        super().note_equation(docname, labelid, location)
        if not labelid.startswith(PREFIX):
            raise ValueError(f"equation label: expected {PREFIX}<number>, got {labelid!r}")
        self.equations[labelid] = (docname, labelid.removeprefix(PREFIX))  # type: ignore[assignment]


def setup(app: Sphinx) -> dict[str, Any]:
    """Put the domain in the place of Sphinx's own."""
    app.add_domain(PaperMathDomain, override=True)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
