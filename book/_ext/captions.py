"""Turn a paragraph that begins **Figure 1.** or **Picture 3-a.** into the caption of a figure.

In JupyterLab the caption is an ordinary paragraph below the picture. On the page the two become a
real figure, which links can name: ``[Figure 1](#figure-1)``.
"""

import re
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.nodes import NodeMatcher

from cells import caption_of
from rotedu.figures.pages import scene, scene_by_hand

STYLES = Path(__file__).parents[1] / "_static" / "book.css"
# In rem. docutils takes no variables of CSS for a size.
TEXT_WIDTH = float(re.search(r"--measure: ([\d.]+)rem;", STYLES.read_text("utf-8"))[1])
SHAPE = re.compile(r'viewBox="0 0 ([\d.]+) ([\d.]+)"')


class NameCaptions(SphinxTransform):
    """Make every caption a target that all pages can link to."""

    default_priority = 210

    def apply(self, **_: Any) -> None:
        """Register the captions of a page with Sphinx's standard domain."""
        for paragraph in self.document.findall(nodes.paragraph):
            if title := caption_of(paragraph):
                name = nodes.make_id(title)
                paragraph["ids"].append(name)
                standard = self.env.domains["std"]
                standard.labels[name] = (self.env.docname, name, title)
                standard.anonlabels[name] = (self.env.docname, name)


class BuildFigures(SphinxPostTransform):
    """Join pictures and captions, once MyST-NB has chosen what each output shows."""

    default_priority = 5

    def run(self, **_: Any) -> None:
        """Move the last picture of a cell and the caption below it into one figure."""
        captions = [p for p in self.document.findall(nodes.paragraph) if caption_of(p)]
        for caption in captions:
            cell = caption.parent[caption.parent.index(caption) - 1]
            pictures = list(cell.findall(NodeMatcher(scene))) or list(cell.findall(nodes.image))
            if not pictures:
                raise ValueError(f"{caption_of(caption)}: no picture above the caption")
            picture = pictures[-1]
            if isinstance(picture.parent, scene_by_hand):
                picture = picture.parent
            figure = nodes.figure(ids=caption["ids"])
            picture.replace_self(figure)
            figure += [self.with_shape(picture), nodes.caption("", "", *caption.children)]
            caption.parent.remove(caption)

    def with_shape(self, picture: nodes.Element) -> nodes.Element:
        """Give a chart its shape, so that nothing moves when it loads, and a box to scroll in."""
        if not str(picture.get("uri")).endswith(".svg"):
            return picture
        if not picture.get("alt"):
            raise ValueError(f"{self.env.docname}: a chart without alt text (mystnb: image: alt)")
        drawing = Path(self.env.srcdir, picture["uri"].lstrip("/")).read_text(encoding="utf-8")
        width, height = map(float, SHAPE.search(drawing).groups())
        picture["width"] = f"{TEXT_WIDTH:g}rem"
        picture["height"] = f"{TEXT_WIDTH * height / width:.2f}rem"
        return nodes.container("", picture, classes=["chart"])


def setup(app: Sphinx) -> dict[str, Any]:
    """Register both steps."""
    app.add_transform(NameCaptions)
    app.add_post_transform(BuildFigures)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
