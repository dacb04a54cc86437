"""The Sphinx side of `rotedu.figures.backend`, which puts the output of a scene on a page.

A scene is a box with the shape of its picture. It contains the poster and, over the poster, one
element for each label, placed in per cent of the box so that it keeps its place at any size. A
reader sees all this without any script; where there is one, it waits until a scene comes near the
screen and then makes it live.

On paper and in an EPUB (every builder but ``html``) the poster and its labels are all there is.
"""

import base64
import hashlib
import io
import json
import os
import posixpath
import struct
from pathlib import Path
from typing import Any, ClassVar, TypeVar

import numpy as np
from docutils import nodes
from PIL import Image
from sphinx import addnodes
from sphinx.application import Sphinx

from rotedu.figures.backend import MIME_TYPE
from rotedu.figures.model import run_node
from rotedu.figures.state import in_stack

NO_SCRIPT = "With JavaScript on, this figure can be turned."
ON_PAPER = "Online, the points and sliders of this figure can be moved."
# WebP stores opacity without loss, and glass is a gradient of it, which takes twice as many bytes
# unless dense glass has fewer levels than clear glass. AVIF would take fewer bytes still, but
# Chromium 156 reads its opacity as if it went from 16 to 235.
OPACITIES = np.rint([*range(12), *np.geomspace(12, 255, 28)]).astype(int)
NEAREST = OPACITIES[np.abs(np.arange(256)[:, np.newaxis] - OPACITIES).argmin(axis=1)]
# How far from its place a label reaches up and down, in pixels: half the height of a formula.
LABEL = 12
# Width in pixels of a stacked poster, which is seen on phones only.
STACKED = 600
Filled = TypeVar("Filled", bound=nodes.Element)
BUILDERS = ("html", "singlehtml", "epub")
WRITE_PANELS = Path(__file__).parents[2] / "viewer" / "write-panels.js"


class scene(addnodes.download_reference):  # noqa: N801 (docutils names nodes so)
    """A figure drawn by pyvista: a poster, its labels, and a file with the scene to turn."""


class scene_shared(addnodes.download_reference):  # noqa: N801
    """The end of a scene's file, which other scenes have as well."""


class scene_view(nodes.Element):  # noqa: N801
    """A second picture of a scene, from elsewhere or in another state: a poster and its labels."""


class scene_poster(nodes.image):  # noqa: N801
    """The picture of a scene at rest."""


class scene_stacked(nodes.image):  # noqa: N801
    """The same picture, with its parts one above the other."""


class scene_label(nodes.inline):  # noqa: N801
    """A text at a place in the scene."""


class explorable(addnodes.download_reference):  # noqa: N801
    """A figure that answers the hand: a scene, its panel, and a file that says what moves it."""


class SceneRenderer:
    """Renderer of MyST-NB for the notebook output of a scene."""

    mime_priority_overrides: ClassVar[list[tuple[str, str, int]]] = [
        (builder, MIME_TYPE, 1) for builder in BUILDERS
    ]

    @staticmethod
    def handle_mime(renderer: Any, data: Any, inline: bool) -> list[nodes.Element] | None:
        """Return the nodes of a scene, or None for an output of another type."""
        if data.mime_type != MIME_TYPE:
            return None
        content = json.loads(data.content) if isinstance(data.content, str) else data.content
        node = scene_node(renderer, content)
        if "spec" not in content:
            return [node]
        shown = [node, *(view_node(renderer, view) for view in content["views"])]
        if "answer" in content:
            asks = addnodes.only("", *shown, expr="builder_html")
            told = filled(renderer, scene_view(), content["answer"])
            shown = [asks, addnodes.only("", told, expr="not builder_html")]
        return [explorable_node(renderer, content["spec"], shown)]


def explorable_node(renderer: Any, spec: str, pictures: list[nodes.Element]) -> explorable:
    """Write the file of an explorable, and build its node around its pictures."""
    content = json.loads(spec)
    moving = {key: content[key] for key in ("name", "inputs", "start", "model", "constants")}
    target = write_file(renderer, json.dumps(moving, separators=(",", ":")).encode(), "json")
    node = explorable("", "", *pictures, reftarget=target, spec=spec, title=content["name"])
    node["small"] = content["small"]
    return node


def scene_node(renderer: Any, content: dict[str, Any]) -> scene:
    """Write the files of a scene and build its node."""
    own, shared = in_two(base64.b64decode(content["gltf"]))
    gltf = write_file(renderer, own, "glb")
    poster = base64.b64decode(content["poster"])
    # Pictures side by side stay on one line.
    blank = (0, 0) if content["views"] else blanks(poster, content["height"], content["labels"])
    node = scene(reftarget=gltf, stack=content["stack"], blank=blank)
    if shared:
        node += scene_shared(reftarget=write_file(renderer, shared, "bin"))
    return filled(renderer, node, content)


def in_two(gltf: bytes) -> tuple[bytes, bytes]:
    """Cut a scene's file where its spoons begin."""
    (length,) = struct.unpack_from("<I", gltf, 12)
    shared = json.loads(gltf[20 : 20 + length])["asset"]["extras"]["shared"]
    return gltf[: len(gltf) - shared], gltf[len(gltf) - shared :]


def view_node(renderer: Any, content: dict[str, Any]) -> scene_view:
    """Write the poster of a view and build its node."""
    without = json.dumps(content["without"])
    return filled(renderer, scene_view(title=content["name"], without=without), content)


def filled(renderer: Any, node: Filled, content: dict[str, Any]) -> Filled:
    """Put a poster and its labels into a node."""
    size = {key: content[key] for key in ("width", "height")}
    node.attributes |= size
    poster, stack = base64.b64decode(content["poster"]), content["stack"]
    uri = write_file(renderer, light_poster(poster), "webp")
    node += scene_poster(uri=uri, alt=content["alt"], **size)
    if stack:
        uri = write_file(renderer, light_poster(stacked_poster(poster, stack)), "webp")
        node += scene_stacked(uri=uri, alt=content["alt"])
    for label in content["labels"]:
        text = label.pop("text")
        if stack:
            label["stacked"] = in_stack(stack, label["left"], label["top"])
        if text.startswith("$") and text.endswith("$"):
            child: nodes.Node = nodes.math(text, text.strip("$"))
        else:
            child = nodes.Text(text)
        node += scene_label("", "", child, **label)
    return node


def blanks(png: bytes, height: int, labels: list[dict[str, Any]]) -> tuple[float, float]:
    """Return the shares of a picture's height that are empty above and below drawing and labels."""
    alpha = Image.open(io.BytesIO(png)).convert("RGBA").getchannel("A")
    _, top, _, bottom = alpha.getbbox() or (0, 0, *alpha.size)
    places = [label["top"] for label in labels if not label["hidden"]]
    half = LABEL / height
    above = min([top / alpha.height, *(place - half for place in places)])
    below = max([bottom / alpha.height, *(place + half for place in places)])
    return max(0, above), max(0, 1 - below)


def light_poster(png: bytes) -> bytes:
    """Return a poster as the page has it."""
    poster = Image.open(io.BytesIO(png)).convert("RGBA")
    poster.putalpha(poster.getchannel("A").point(NEAREST.tolist()))
    file = io.BytesIO()
    # Thin coloured lines of a flat drawing show a loss most, and it costs least to spare them.
    flat = len(png) < 65_000
    # Method 6 takes seconds to save 1 %.
    poster.save(file, "WEBP", quality=85 if flat else 75, method=5)
    return file.getvalue()


def stacked_poster(png: bytes, stack: dict[str, Any]) -> bytes:
    """Return a poster whose parts stand one above the other."""
    poster = Image.open(io.BytesIO(png)).convert("RGBA")
    stacked = Image.new("RGBA", (STACKED, round(STACKED / stack["aspect"])))
    for row in stack["rows"]:
        (left, top, across, down), to = (
            np.multiply(place, [*size, *size])
            for place, size in ((row["from"], poster.size), (row["to"], stacked.size))
        )
        part = poster.crop(tuple(np.rint([left, top, left + across, top + down]).astype(int)))
        x, y, *size = np.rint(to).astype(int).tolist()
        stacked.paste(part.resize(size, Image.Resampling.LANCZOS), (x, y))
    file = io.BytesIO()
    stacked.save(file, "PNG")
    return file.getvalue()


def write_file(renderer: Any, content: bytes, suffix: str) -> str:
    """Write a file under a name that changes with its content, and return its path."""
    digest = hashlib.sha256(content).hexdigest()[:16]
    return str(renderer.write_file([f"scene-{digest}.{suffix}"], content, exists_ok=True))


def is_live(writer: Any) -> bool:
    """Tell whether figures can move where a writer's pages are read."""
    return bool(writer.builder.name == "html")


def visit_box(writer: Any, node: scene | scene_view) -> None:
    """Open the box of a picture, in its shape and at most as wide as it was made."""
    if not is_live(writer):
        writer.body.append('<div class="scene">')
        return
    width, height = node["width"], node["height"]
    attributes = {"style": f"--aspect: {width} / {height}; --scene-width: {width / 16:g}rem"}
    if isinstance(node, scene_view):
        attributes |= {"data-view": node["title"], "data-without": node["without"]}
    else:
        attributes["data-scene"] = posixpath.join(writer.builder.dlpath, node["filename"])
        for end in node.findall(scene_shared):
            attributes["data-shared"] = posixpath.join(writer.builder.dlpath, end["filename"])
        if node["stack"]:
            attributes["style"] += f"; --stacked: {node['stack']['aspect']:.4f}"
            attributes["data-stack"] = json.dumps(node["stack"])
        for side, share in zip(("top", "bottom"), node["blank"], strict=True):
            if round(share, 3):
                attributes["style"] += f"; --blank-{side}: {share:.3f}"
    name = "scene-view" if isinstance(node, scene_view) else "scene"
    writer.body.append(writer.starttag(node, "div", CLASS=name, **attributes))


def depart_box(writer: Any, node: scene | scene_view) -> None:
    """Close the box."""
    writer.body.append("</div>\n")
    if is_live(writer) and isinstance(node, scene):
        writer.body.append(f'<noscript><p class="scene-message">{NO_SCRIPT}</p></noscript>\n')


def visit_explorable(writer: Any, node: explorable) -> None:
    """Open the box around a scene and its panel."""
    if not is_live(writer):
        return
    attributes = {
        "data-name": node["title"],
        "data-explore": posixpath.join(writer.builder.dlpath, node["filename"]),
        "ids": [f"explore-{node['title']}"],
    }
    name = "explorable small" if node["small"] else "explorable"
    writer.body.append(writer.starttag(node, "div", CLASS=name, **attributes))


def depart_explorable(writer: Any, node: explorable) -> None:
    """Write the panel and close the box."""
    if is_live(writer):
        [panel] = json.loads(run_node(f"[{node['spec']}]", WRITE_PANELS))
        writer.body.append(f"{panel}</div>\n")
    else:
        writer.body.append(f'<p class="scene-note">{ON_PAPER}</p>\n')


def skip(writer: Any, node: scene_shared) -> None:
    """Write nothing; the box of the scene says where the file is."""
    raise nodes.SkipNode


def visit_picture(writer: Any, node: scene_poster | scene_stacked) -> None:
    """Write the picture, or the one that only a phone loads, with its path in the book."""
    source = posixpath.join(writer.builder.imgpath, writer.builder.images[node["uri"]])
    attributes = {key: node[key] for key in ("alt", "width", "height") if key in node}
    if is_live(writer):
        attributes["loading"] = "lazy"
    kind = "scene-poster" if isinstance(node, scene_poster) else "scene-poster scene-stacked"
    if is_live(writer) or isinstance(node, scene_poster):
        writer.body.append(writer.emptytag(node, "img", CLASS=kind, src=source, **attributes))
    raise nodes.SkipNode


def visit_scene_label(writer: Any, node: scene_label) -> None:
    """Open a label at its place over the poster."""
    if is_live(writer):
        attributes = {
            "style": f"--left: {node['left']:.2%}; --top: {node['top']:.2%}",
            "data-position": " ".join(f"{coordinate:.6g}" for coordinate in node["position"] or ()),
            "data-label": node["name"],
        }
        if "stacked" in node:
            left, top = node["stacked"]
            attributes["style"] += f"; --stacked-left: {left:.2%}; --stacked-top: {top:.2%}"
        if node["hidden"]:
            attributes["data-hidden"] = ""
    elif node["hidden"] or (
        # The page cuts off what is beside the picture.
        isinstance(node.parent, scene_view) and not all(0 < node[x] < 1 for x in ("left", "top"))
    ):
        raise nodes.SkipNode
    else:
        attributes = {"style": f"left: {node['left']:.2%}; top: {node['top']:.2%}"}
    # The description of the picture says what is where.
    attributes["aria-hidden"] = "true"
    writer.body.append(writer.starttag(node, "span", "", CLASS="scene-label", **attributes))
    # The colour has an element of its own, because the viewer rewrites the style of the outer one.
    writer.body.append(f'<span style="color: {node["color"]}">')


def depart_scene_label(writer: Any, node: scene_label) -> None:
    """Close a label."""
    writer.body.append("</span></span>")


def add_viewer(
    app: Sphinx,
    pagename: str,
    template: str,
    context: dict[str, Any],
    doctree: nodes.document | None,
) -> None:
    """Load styles and script on a page that has scenes."""
    if app.builder.name == "html" and doctree and next(iter(doctree.findall(scene)), None):
        app.add_css_file("scene/scene.css")
        app.add_js_file("scene/loader.js", loading_method="defer")


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the nodes, and choose the backend ``book`` for the notebooks that Sphinx runs."""
    os.environ["PYVISTA_JUPYTER_BACKEND"] = "book"
    app.add_node(scene, html=(visit_box, depart_box))
    app.add_node(scene_shared, html=(skip, None))
    app.add_node(explorable, html=(visit_explorable, depart_explorable))
    app.add_node(scene_view, html=(visit_box, depart_box))
    app.add_node(scene_poster, html=(visit_picture, None))
    app.add_node(scene_stacked, html=(visit_picture, None))
    app.add_node(scene_label, html=(visit_scene_label, depart_scene_label))
    app.connect("html-page-context", add_viewer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
