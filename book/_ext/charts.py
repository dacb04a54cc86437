"""Make charts part of the page: what Matplotlib has drawn, in the page's letters and colours.

In a notebook a chart is a picture on white paper. On the page its drawings stand in the text,
without paper, side by side where there is room. Ink takes the colour of the text and each other
colour the shade that the page gives it, as in formulas; the styles choose the letters.
"""

import re
from collections.abc import Iterator
from html import escape
from pathlib import Path
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

from cells import code_cells

SVG, XLINK = "http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"
GROUP, HREF = f"{{{SVG}}}g", f"{{{XLINK}}}href"
# Metadata are Matplotlib's own, and its style would hold for the whole page.
LEFT_OUT = (f"{{{SVG}}}metadata", f"{{{SVG}}}style")
PAPER, INK = "#ffffff", "#3b434b"
# The least width on a screen, in pixels for each unit of a drawing, unless the screen has less.
SCALE = 1.1

ElementTree.register_namespace("", SVG)
ElementTree.register_namespace("xlink", XLINK)


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


def inlined(drawing: str, name: str) -> str:
    """Return a drawing of Matplotlib as an element of a page.

    Parameters
    ----------
    drawing : str
        The file, in which text is text.
    name : str
        What ids begin with, so that no other drawing of the page has them.
    """
    # Hundredths of a unit are finer than any screen.
    drawing = re.sub(r"\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", drawing)
    root = ElementTree.fromstring(drawing)
    sizes = zip(("width", "height"), root.attrib["viewBox"].split()[2:], strict=True)
    size = {side: f"{SCALE * float(length):.0f}" for side, length in sizes}
    root.attrib = {"viewBox": root.attrib["viewBox"], **size}
    root[:] = needed(root, set(re.findall(r"#(\w+)[\")]", drawing)), name)
    return re.sub(r"\s*\n\s*", " ", ElementTree.tostring(root, "unicode"))


def needed(parent: Element, targets: set[str], name: str) -> Iterator[Element]:
    """Yield what a page needs of a drawing; groups that say nothing are dissolved."""
    for element in parent:
        own = element.attrib
        style = dict(pair.split(": ", 1) for pair in own.pop("style", "").split("; ") if pair)
        is_paper = style.get("fill") in ("none", PAPER) and "stroke" not in style
        if element.tag in LEFT_OUT or is_paper:
            continue
        target = own.pop("id", None)
        if target in targets:
            # Its style is that of each use.
            own["id"] = f"{name}-{target}"
        elif style:
            own["style"] = "; ".join(f"{key}: {value}" for key, value in of_page(style).items())
        for link in own.keys() & {HREF, "clip-path"}:
            own[link] = own[link].replace("#", f"#{name}-")
        if own.get("transform", "").startswith("rotate(-0 "):
            del own["transform"]
        element[:] = needed(element, targets, name)
        if element.tag == GROUP and not own:
            yield from element
        elif own or len(element):
            yield element


def of_page(style: dict[str, str]) -> dict[str, str]:
    """Leave the letters to the page, and say colours as those of text, which have shades there."""
    style = {key: style[key] for key in style if key not in ("font-family", "font-size")}
    for part in [key for key in style if key in ("fill", "stroke")]:
        if style[part] not in ("none", INK):
            style["color"] = style[part]
        if style[part] != "none":
            style[part] = "currentcolor"
    return style


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step."""
    app.add_post_transform(InlineCharts)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
