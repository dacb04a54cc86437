"""Offer each notebook for download below the title of its page, and describe the page in its head.

A notebook therefore needs no link to itself.
"""

import textwrap
from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

LINK = "Download this page as a notebook"
DESCRIPTION_LENGTH = 160


class WritePageHead(SphinxTransform):
    """Add the link and the description, before Sphinx collects the files to download."""

    default_priority = 400

    def apply(self, **_: Any) -> None:
        """Take the description from the first paragraph."""
        title = next(self.document.findall(nodes.title), None)
        paragraphs = self.document.findall(nodes.paragraph)
        prose = next((p for p in paragraphs if isinstance(p.parent, nodes.section)), None)
        if title is None or prose is None:
            return
        words = textwrap.shorten(prose.astext(), DESCRIPTION_LENGTH)
        self.document += nodes.meta(name="description", content=words)
        source = self.env.doc2path(self.env.docname, base=False)
        if str(source).endswith(".ipynb"):
            link = addnodes.download_reference("", LINK, reftarget=f"/{source}")
            head = nodes.paragraph("", "", link, classes=["page-head"])
            title.parent.insert(title.parent.index(title) + 1, head)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step, and set an option that furo adds too late for _config.yml."""
    app.config.pygments_dark_style = "github-dark-high-contrast"
    app.add_transform(WritePageHead)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
