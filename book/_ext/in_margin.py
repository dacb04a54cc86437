"""Repeat in the margin which errata a paragraph speaks of, so that they are found by leafing."""

from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

# A screen reader has met the link itself.
NOTE = '<span class="in-margin" aria-hidden="true">{}</span>'


class InMargin(SphinxPostTransform):
    """Add the numbers, once links know where they lead; book.css says where there is a margin."""

    # After all that looks at how a paragraph begins.
    default_priority = 900
    formats = ("html",)

    def run(self, **_: Any) -> None:
        """Treat the paragraphs that stand beside the margin."""
        for paragraph in self.document.findall(nodes.paragraph):
            links = paragraph.findall(nodes.reference)
            found = [link.astext() for link in links if "#erratum-" in link.get("refuri", "")]
            if found and isinstance(paragraph.parent, nodes.section):
                paragraph.insert(0, nodes.raw("", NOTE.format(" ".join(found)), format="html"))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step."""
    app.add_post_transform(InMargin)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
