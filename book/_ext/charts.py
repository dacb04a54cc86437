"""A chart of matplotlib belongs to the page, be the page light or dark.

Charts are SVG drawings in the style ``rotedu.book``. Each is shown as it is on light pages;
for dark pages a copy with other ink is made.
"""

import posixpath
import re
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

INKS_ON_DARK = {"#3b434b": "#cdd4da", "#c9d0d6": "#434c55", "#0072b2": "#3b9ad6"}
PAPER = "fill: #ffffff"
SHAPE = re.compile(r'viewBox="0 0 ([\d.]+) ([\d.]+)"')


class chart(nodes.image):  # noqa: N801 (docutils names nodes so)
    """A drawing that comes when the reader comes near it; until then its place is kept."""


class ChartsForBothThemes(SphinxPostTransform):
    """Put two pictures in the place of each chart, one for either theme."""

    default_priority = 6

    def run(self, **_: Any) -> None:
        """Write the two drawings beside the one from the notebook."""
        for image in list(self.document.findall(nodes.image)):
            drawing = Path(self.env.srcdir) / image["uri"].lstrip("/")
            if drawing.suffix != ".svg" or "jupyter_execute" not in drawing.parts:
                continue
            if not image.get("alt"):
                raise ValueError(
                    f"{self.env.docname}: a chart without alt text (mystnb: image: alt)"
                )
            svg = drawing.read_text(encoding="utf-8").replace(PAPER, "fill: none")
            dark = svg
            for light_ink, dark_ink in INKS_ON_DARK.items():
                dark = dark.replace(light_ink, dark_ink)
            pair = [
                self.variant(image, drawing, *kind) for kind in (("light", svg), ("dark", dark))
            ]
            # Apart from the caption: the theme hides what follows a picture it hides.
            image.replace_self(nodes.container("", *pair))

    def variant(self, image: nodes.image, drawing: Path, theme: str, svg: str) -> nodes.image:
        """Write one drawing and return its picture."""
        file = drawing.with_stem(f"{drawing.stem[:16]}-{theme}")
        file.write_text(svg, encoding="utf-8")
        uri = file.relative_to(self.env.srcdir).as_posix()
        self.env.images.add_file(self.env.docname, uri)
        width, height = SHAPE.search(svg).groups()
        return chart(
            uri=uri,
            candidates={"*": uri},
            alt=image["alt"],
            classes=["chart", f"only-{theme}"],
            width=round(float(width)),
            height=round(float(height)),
        )


def visit_chart(writer: Any, node: chart) -> None:
    """Write the picture with its shape."""
    source = posixpath.join(writer.builder.imgpath, writer.builder.images[node["uri"]])
    attributes = {key: node[key] for key in ("alt", "width", "height")}
    writer.body.append(writer.emptytag(node, "img", src=source, loading="lazy", **attributes))
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step."""
    app.add_node(chart, html=(visit_chart, None))
    app.add_post_transform(ChartsForBothThemes)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
