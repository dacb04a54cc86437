"""Turn a paragraph that begins **Figure 1.** or **Picture 3-a.** into the caption of a figure.

In JupyterLab the caption is an ordinary paragraph below the picture. On the page the two become a
real figure, which links can name: ``[Figure 1](#figure-1)``. The paragraph below a small figure is
its caption, and has the figure's name as its target.
"""

from typing import Any

from docutils import nodes
from myst_nb.sphinx_ import HideCodeCellNode
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.nodes import NodeMatcher

from cells import caption_of, code_cells
from charts import chart
from rotedu.figures.pages import explorable, scene


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
    """Join pictures and captions, once charts.py has made each chart one picture."""

    default_priority = 5

    def run(self, **_: Any) -> None:
        """Move the last picture of a cell and the caption below it into one figure."""
        paragraphs = list(self.document.findall(nodes.paragraph))
        for caption in [p for p in paragraphs if caption_of(p) or is_below_small(p)]:
            cell = before(caption)
            pictures = list(cell.findall(NodeMatcher(scene, chart)))
            if not pictures:
                raise ValueError(f"{caption_of(caption)}: no picture above the caption")
            picture = pictures[-1]
            while isinstance(picture.parent, explorable | addnodes.only):
                picture = picture.parent
            figure = nodes.figure(ids=caption["ids"] or [picture["title"]])
            picture.replace_self(figure)
            figure += [picture, nodes.caption("", "", *caption.children)]
            caption.parent.remove(caption)


def before(paragraph: nodes.Element) -> nodes.Element:
    """Return what stands before a paragraph."""
    return paragraph.parent[max(paragraph.parent.index(paragraph) - 1, 0)]


def is_below_small(paragraph: nodes.Element) -> bool:
    """Tell whether a paragraph stands below a small figure."""
    cell = before(paragraph)
    return isinstance(cell, nodes.container) and any(f["small"] for f in cell.findall(explorable))


class PutCodeBelow(SphinxPostTransform):
    """Put the folded code that has drawn a figure below it, where it is reached after it."""

    # After MyST-NB has folded it.
    default_priority = 200

    def run(self, **_: Any) -> None:
        """Move the fold to the end of its cell."""
        for cell in code_cells(self.document):
            folded = len(cell) > 1 and isinstance(cell[0], HideCodeCellNode)
            if folded and cell[-1].next_node(nodes.figure):
                cell.append(cell.pop(0))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the steps."""
    # Its step has the same priority and comes first.
    app.setup_extension("charts")
    app.add_transform(NameCaptions)
    app.add_post_transform(BuildFigures)
    app.add_post_transform(PutCodeBelow)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
