"""Keep on one line what belongs together: a formula and its comma or brackets, (4-1), 5-b, 18 + 12.

Browsers may break a line after any formula, as after a picture, and no character prevents it.
"""

import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

OPENING = re.compile(r"[(\N{LEFT DOUBLE QUOTATION MARK}]+$")
MARKS = re.compile(r"[.,;:!?)\N{RIGHT DOUBLE QUOTATION MARK}]+")
UNSEEN = re.compile(r"\\textcolor\{[^}]*\}|\\[A-Za-z]+|[\\{}^_\s]")
# Numbers of equations and of pictures, counts of operations, shapes.
NUMBERS = re.compile(r"(\(\d-\d+\)|\b[\dA-Z]-[a-z]\b|\d+ [+×] \d+)")
AROUND = (
    *(nodes.paragraph, nodes.caption, nodes.emphasis, nodes.strong),
    *(nodes.inline, nodes.reference),
)
# On a phone, a longer formula must be able to break.
SHORT = 16


def unbroken(*content: nodes.Node) -> nodes.inline:
    """Make an element that does not break."""
    return nodes.inline("", "", *content, classes=["unbroken"])


class KeepTogether(SphinxPostTransform):
    """Put what belongs together into one element."""

    default_priority = 5

    def run(self, **_: Any) -> None:
        """Treat the numbers in all texts, and the marks around each formula."""
        for text in list(self.document.findall(nodes.Text)):
            if not isinstance(text.parent, AROUND):
                continue
            # Every second part is a match of the pattern.
            parts = [nodes.Text(part) for part in NUMBERS.split(text)]
            parts[1::2] = map(unbroken, parts[1::2])
            if len(parts) > 1:
                text.parent.replace(text, parts)
        for formula in list(self.document.findall(nodes.math)):
            around = formula.parent
            at = around.index(formula)
            before, after = around[max(at - 1, 0)], around[min(at + 1, len(around) - 1)]
            opening = isinstance(before, nodes.Text) and OPENING.search(before)
            marks = isinstance(after, nodes.Text) and MARKS.match(after)
            if not (opening or marks) or len(UNSEEN.sub("", formula.astext())) > SHORT:
                continue
            whole = [formula.deepcopy()]
            if opening:
                whole.insert(0, nodes.Text(opening[0]))
                around[at - 1] = nodes.Text(before[: opening.start()])
            if marks:
                whole.append(nodes.Text(marks[0]))
                around[at + 1] = nodes.Text(after[marks.end() :])
            around[at] = unbroken(*whole)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step, which runs before words become links."""
    app.add_post_transform(KeepTogether)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
