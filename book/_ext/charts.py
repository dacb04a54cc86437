"""Make charts part of the page.

In a notebook a chart is a picture on white paper. On the page its drawings stand in the text,
without paper, side by side where there is room.
"""

import re
from html import escape
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

from cells import code_cells
from rotedu.edition.drawing import inlined


class chart(nodes.raw):  # noqa: N801 (docutils names nodes so)
    """The drawings of a cell, as HTML."""


class InlineCharts(SphinxPostTransform):
    """Write the drawings of a cell into the page, once MyST-NB has chosen what outputs show."""

    default_priority = 5

    def run(self, **_: Any) -> None:
        """Replace pictures by drawings."""
        for number, cell in enumerate(code_cells(self.document)):
            pictures = [p for p in cell.findall(nodes.image) if p["uri"].endswith(".svg")]
            if pictures:
                pictures[0].replace_self(self.chart_of(pictures, f"chart-{number}"))
                for picture in pictures[1:]:
                    picture.parent.remove(picture)

    def chart_of(self, pictures: list[nodes.image], name: str) -> chart:
        """Join pictures, which have one description."""
        alt = pictures[0].get("alt")
        if not alt:
            raise ValueError(f"{self.env.docname}: a chart without alt text (mystnb: image: alt)")
        files = [Path(self.env.srcdir, picture["uri"].lstrip("/")) for picture in pictures]
        drawings = "".join(
            inlined(file.read_text(encoding="utf-8"), f"{name}-{i}") for i, file in enumerate(files)
        )
        width, *_ = re.findall(r' width="(\d+)"', drawings)
        about = f'class="chart" role="img" aria-label="{escape(alt)}" style="--least: {width}px"'
        html = f"<div {about}>{drawings}</div>"
        return chart("", html, format="html")


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step."""
    app.add_post_transform(InlineCharts)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
