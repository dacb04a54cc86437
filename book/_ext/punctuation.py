"""A comma after a formula stays on its line.

Browsers break a line after any formula, as after a picture; no character prevents it.
"""

import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

MARKS = re.compile(r"[.,;:!?)\N{RIGHT DOUBLE QUOTATION MARK}]+")
UNSEEN = re.compile(r"\\textcolor\{[^}]*\}|\\[A-Za-z]+|[\\{}^_\s]")
# A longer formula has to break somewhere, on a phone.
SHORT = 16


class KeepPunctuation(SphinxPostTransform):
    """Put a short formula and the marks after it into one element, which does not break."""

    default_priority = 5

    def run(self, **_: Any) -> None:
        """Look at what follows each formula in a text."""
        for formula in list(self.document.findall(nodes.math)):
            after = formula.next_node(descend=False, siblings=True)
            if not isinstance(after, nodes.Text) or not (marks := MARKS.match(after)):
                continue
            if len(UNSEEN.sub("", formula.astext())) > SHORT:
                continue
            together = nodes.inline(classes=["unbroken"])
            formula.replace_self(together)
            together += [formula, nodes.Text(marks[0])]
            after.parent.replace(after, nodes.Text(after[marks.end() :]))


def setup(app: Sphinx) -> dict[str, Any]:
    """Come before links are made of words."""
    app.add_post_transform(KeepPunctuation)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
