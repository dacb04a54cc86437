"""Make each box with a question a group, named by its question, with choices to open.

The choices are folded texts, which need no script. Several may be open, to be compared.
"""

from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform


class prediction(nodes.admonition):  # noqa: N801 (docutils names nodes so)
    """A box with a question and its choices."""


class BuildPredictions(SphinxTransform):
    """Replace the boxes of the class ``question``."""

    default_priority = 400

    def apply(self, **_: Any) -> None:
        """Give the question of each box an id, by which the group is named."""
        boxes = list(self.document.findall(nodes.admonition))
        asked = [box for box in boxes if "question" in box["classes"]]
        for number, box in enumerate(asked, start=1):
            question = next(child for child in box if isinstance(child, nodes.paragraph))
            question["ids"].append(f"question-{number}")
            box.replace_self(prediction("", *box.children, **box.attributes))


def visit_prediction(writer: Any, node: prediction) -> None:
    """Open the group."""
    question = next(child for child in node if isinstance(child, nodes.paragraph))
    attributes = {"role": "group", "aria-labelledby": question["ids"][0]}
    writer.body.append(writer.starttag(node, "div", CLASS="admonition", **attributes))


def depart_prediction(writer: Any, node: prediction) -> None:
    """Close the group."""
    writer.body.append("</div>\n")


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step and its node."""
    app.add_node(prediction, html=(visit_prediction, depart_prediction))
    app.add_transform(BuildPredictions)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
