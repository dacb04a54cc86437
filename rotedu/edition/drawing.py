"""Make a chart part of a page: what Matplotlib has drawn, in the page's letters and colours.

The build of the book uses it, and so does the Python of the pages. Ink takes the colour of the text
and each other colour the shade that the page gives it, as in formulas; the styles choose the
letters.
"""

import re
from collections.abc import Iterator
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

SVG, XLINK = "http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"
GROUP, LINK, TSPAN, HREF = f"{{{SVG}}}g", f"{{{SVG}}}a", f"{{{SVG}}}tspan", f"{{{XLINK}}}href"
# Metadata are Matplotlib's own, and its style would hold for the whole page.
LEFT_OUT = (f"{{{SVG}}}metadata", f"{{{SVG}}}style")
PAPER, INK = "#ffffff", "#3b434b"
# The least width on a screen, in pixels for each unit of a drawing, unless the screen has less.
SCALE = 1.1

ElementTree.register_namespace("", SVG)
ElementTree.register_namespace("xlink", XLINK)


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
            style = of_page(style, in_formula=element.tag == TSPAN)
            own["style"] = "; ".join(f"{key}: {value}" for key, value in style.items())
        if element.tag == LINK:
            own.clear()
        for link in own.keys() & {HREF, "clip-path"}:
            own[link] = own[link].replace("#", f"#{name}-")
        if own.get("transform", "").startswith("rotate(-0 "):
            del own["transform"]
        element[:] = needed(element, targets, name)
        if element.tag in (GROUP, LINK) and not own:
            yield from element
        elif own or len(element):
            yield element


def of_page(style: dict[str, str], *, in_formula: bool) -> dict[str, str]:
    """Leave the letters to the page, and say colours as those of text, which have shades there.

    In a formula each letter has its place, and so its size.
    """
    # The Matplotlib of a page, 3.8, says all of letters in one.
    for word in style.get("font", "").split():
        if word in ("italic", "oblique"):
            style["font-style"] = word
        elif word == "700":
            style["font-weight"] = word
        elif word.endswith("px"):
            style["font-size"] = word
    letters = ("font", "font-family") if in_formula else ("font", "font-family", "font-size")
    style = {key: style[key] for key in style if key not in letters}
    for part in [key for key in style if key in ("fill", "stroke")]:
        if style[part] not in ("none", INK):
            style["color"] = style[part]
        if style[part] != "none":
            style[part] = "currentcolor"
    return style
