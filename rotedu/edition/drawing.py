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
GROUP, LINK, TSPAN, PATH = (f"{{{SVG}}}{tag}" for tag in ("g", "a", "tspan", "path"))
HREF = f"{{{XLINK}}}href"
# Metadata are Matplotlib's own, and its style would hold for the whole page.
LEFT_OUT = (f"{{{SVG}}}metadata", f"{{{SVG}}}style")
# What has white paper below it, unless a reader has chosen another.
ON_PAPER = re.compile(r"(figure|axes|legend)_\d+")
INK, BLACK, WHITE = "#3b434b", "#000000", "#ffffff"
# The size of letters in the style of the book; the page has its own for it.
LETTERS = 11
# The least width on a screen, in pixels for each unit of a drawing, unless the screen has less.
SCALE = 1.1

NUMBER = re.compile(r"\d+\.\d{3,}")

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
    # Signs that XML does not allow
    drawing = re.sub(r"[\x00-\x08\x0b\x0c\x0e-\x1f]", "", drawing)
    root = ElementTree.fromstring(drawing)
    sizes = zip(("width", "height"), root.attrib["viewBox"].split()[2:], strict=True)
    size = {side: f"{SCALE * float(length):.0f}" for side, length in sizes}
    # What the drawing says is said by the description of its chart.
    root.attrib = {"viewBox": root.attrib["viewBox"], **size, "aria-hidden": "true"}
    root[:] = needed(root, set(re.findall(r"#([\w-]+)[\")]", drawing)), name)
    return re.sub(r"\s*\n\s*", " ", ElementTree.tostring(root, "unicode"))


def needed(
    parent: Element, targets: set[str], name: str, within: str = "figure_0"
) -> Iterator[Element]:
    """Yield what a page needs of a drawing; groups that say nothing are dissolved."""
    for i, element in enumerate(list(parent)):
        own = element.attrib
        style = dict(pair.split(": ", 1) for pair in own.pop("style", "").split("; ") if pair)
        target = own.pop("id", "")
        unseen = style.get("fill") == "none" and "stroke" not in style
        paper = i == 0 and ON_PAPER.fullmatch(within) and is_white(element)
        if element.tag in LEFT_OUT or unseen or paper:
            continue
        own.update({key: NUMBER.sub(rounded, value) for key, value in own.items()})
        if target in targets:
            # Its style is that of each use.
            own["id"] = f"{name}-{target}"
        elif style:
            style = of_page(style, element.tag)
            own["style"] = "; ".join(f"{key}: {value}" for key, value in style.items())
            own["style"] = own["style"].replace("url(#", f"url(#{name}-")
        if element.tag == LINK:
            own.clear()
        for link in own.keys() & {HREF, "clip-path"}:
            own[link] = own[link].replace("#", f"#{name}-")
        if own.get("transform", "").startswith("rotate(-0 "):
            del own["transform"]
        element[:] = needed(element, targets, name, target)
        if element.tag in (GROUP, LINK) and not own:
            yield from element
        elif own or len(element):
            yield element


def is_white(group: Element) -> bool:
    """Tell whether a group is one white patch."""
    styles = [part.get("style", "") for part in group]
    return bool(styles) and all(f"fill: {WHITE}" in style for style in styles)


def rounded(number: re.Match[str]) -> str:
    """Round a length; hundredths of a unit are finer than any screen."""
    length = float(number[0])
    return f"{length:.2f}" if length >= 1 else f"{length:.4g}"


def of_page(style: dict[str, str], tag: str) -> dict[str, str]:
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
    style = {key: style[key] for key in style if key not in ("font", "font-family")}
    size = style.get("font-size", "")
    if size == f"{LETTERS}px" and tag != TSPAN:
        del style["font-size"]
    elif size and tag != TSPAN:
        style["font-size"] = f"{float(size.removesuffix('px')) / LETTERS:.4g}em"
    paints = {style[part] for part in ("fill", "stroke") if style.get(part, "none")[0] == "#"}
    # Text has one colour; what has two keeps both, and a black area stays black.
    is_area = tag == PATH and style.get("fill") == BLACK
    if len(paints) == 1 and not is_area:
        [color] = paints
        if color not in (INK, BLACK):
            style["color"] = color
        style |= {part: "currentcolor" for part in ("fill", "stroke") if style.get(part) == color}
    return style
