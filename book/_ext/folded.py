"""What a page folds away opens without a script: boxes of the class ``dropdown``, hidden cells."""

from html import escape
from typing import Any

from docutils import nodes
from myst_nb.sphinx_ import HideCodeCellNode, depart_HideCellInput
from sphinx.application import Sphinx
from sphinx.locale import admonitionlabels
from sphinx.transforms.post_transforms import SphinxPostTransform

FOLDED = "dropdown"
OPEN = "toggle-shown"


class folded_box(nodes.General, nodes.Element):  # noqa: N801 (docutils names nodes so)
    """A box of which the page shows the title until the reader opens it."""


class folded_title(nodes.title):  # noqa: N801
    """What the reader clicks."""


class FoldBoxes(SphinxPostTransform):
    """Turn boxes of the class ``dropdown`` into folded ones."""

    default_priority = 800
    formats = ("html",)

    def run(self, **_: Any) -> None:
        """Give each a title: its own, or the name of its kind."""
        for box in list(self.document.findall(nodes.Admonition)):
            if FOLDED not in box["classes"]:
                continue
            kind = box.tagname
            children = box.children
            if kind in admonitionlabels:
                title = [nodes.Text(admonitionlabels[kind])]
                classes = [kind, *box["classes"]]
            else:
                title, children = children[0].children, children[1:]
                classes = box["classes"]
            fold = folded_box(ids=box["ids"], classes=classes)
            fold += [folded_title("", "", *title), *children]
            box.replace_self(fold)


def visit_folded_box(writer: Any, node: folded_box) -> None:
    """Open the box."""
    is_open = {"open": "open"} if OPEN in node["classes"] else {}
    writer.body.append(writer.starttag(node, "details", CLASS="admonition", **is_open))


def depart_folded_box(writer: Any, node: folded_box) -> None:
    """Close the box."""
    writer.body.append("</details>\n")


def visit_folded_title(writer: Any, node: folded_title) -> None:
    """Open the title."""
    writer.body.append(writer.starttag(node, "summary", "", CLASS="admonition-title"))


def depart_folded_title(writer: Any, node: folded_title) -> None:
    """Close the title."""
    writer.body.append("</summary>\n")


def visit_hidden_cell(writer: Any, node: HideCodeCellNode) -> None:
    """Open a hidden cell as MyST-NB does, but named by the text that it shows."""
    writer.body.append(writer.starttag(node, "details", CLASS="admonition hide") + "<summary>")
    for state, prompt in (("collapsed", "prompt_show"), ("expanded", "prompt_hide")):
        text = escape(node[prompt])
        writer.body.append(f'<p class="{state} admonition-title">{text}</p>')
    writer.body.append("</summary>\n")


def setup(app: Sphinx) -> dict[str, Any]:
    """Come after MyST-NB, whose hidden cells are written here too."""
    app.setup_extension("myst_nb")
    app.add_node(folded_box, html=(visit_folded_box, depart_folded_box))
    app.add_node(folded_title, html=(visit_folded_title, depart_folded_title))
    app.add_node(HideCodeCellNode, override=True, html=(visit_hidden_cell, depart_HideCellInput))
    app.add_post_transform(FoldBoxes)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
