"""A chart of matplotlib belongs to the page, be the page light or dark.

Charts are SVG drawings in the style ``rotedu.book``. Each is shown as it is on light pages;
for dark pages a copy with other ink is made.
"""

from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

INKS_ON_DARK = {"#3b434b": "#cdd4da", "#c9d0d6": "#434c55", "#0072b2": "#3b9ad6"}
PAPER = "fill: #ffffff"


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
        return nodes.image(
            uri=uri, candidates={"*": uri}, alt=image["alt"], classes=["chart", f"only-{theme}"]
        )


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step."""
    app.add_post_transform(ChartsForBothThemes)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
