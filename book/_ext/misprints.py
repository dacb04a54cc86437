"""Make each box of the class ``erratum`` one line that unfolds; book.css has a margin for it."""

import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

from cells import folded, spoken

# What the title of a box begins with, for JupyterLab.
PRINTED = re.compile(r"^As printed: (.)")
NUMBER = re.compile(r"erratum-(e\d+)")


class FoldMisprints(SphinxTransform):
    """Replace the boxes by folds, which are open on paper."""

    default_priority = 400

    def apply(self, **_: Any) -> None:
        """Name each misprint by the number to which its box leads."""
        boxes = list(self.document.findall(nodes.admonition))
        for box in (box for box in boxes if "erratum" in box["classes"]):
            printed, *content = box.children
            number = NUMBER.search(box.pformat())
            if not number:
                raise ValueError(f"{self.env.docname}: a misprint without its number: {printed}")
            name = nodes.strong("", f"Misprint {number[1].upper()}")
            first, *rest = printed.children
            words = PRINTED.sub(lambda found: f" {found[1].upper()}", first.astext())
            title = [name, spoken(", as printed:"), nodes.Text(words), *rest]
            box.replace_self(folded("misprint", title, content))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step."""
    app.add_transform(FoldMisprints)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
