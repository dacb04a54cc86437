"""Let cells run in the page: mark them and the exercises, and put Python beside the pages.

The setting is ``python_in_page``. Without it the book is as it would be without this extension.
"""

import re
import shutil
import sys
from itertools import takewhile
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.writers.html5 import HTML5Translator

from cells import (
    belongs_to_solution,
    code_cells,
    exercise_of,
    is_dropdown,
    notebook_cell,
    part_of_exercise,
)

sys.path.append(str(Path(__file__).parents[2] / "tools"))
from notebook_language import tags
from runtime import LIVE, bundle, put_together

SCRIPT = "page_python/page_python.js"
# The end of a starter cell as Pygments writes it, as in on_paper.py.
STUB = re.compile(
    r'(?:(?<=\n)|(?<=<pre><span></span>))(<span class="n">answer</span>((?! class="c1").)*\n)?'
    r'<span class="n">check</span>\(.*\)\n(?=</pre>)'
)


class marked(nodes.container):  # noqa: N801 (docutils names nodes so)
    """A cell or an exercise with a mark for the script of the page."""


class heard(nodes.strong):  # noqa: N801
    """The bold name of an exercise, a heading for those who hear the page."""


class MarkCells(SphinxPostTransform):
    """Mark what runs, after captions and forms have come, and before anything is folded."""

    default_priority = 100
    builders = ("html",)

    def run(self, **_: Any) -> None:
        """Mark the cells, then the exercises around some of them."""
        if not self.config.python_in_page:
            return
        for cell in code_cells(self.document):
            found = notebook_cell(cell)
            if not found or "desk" in tags(found):
                continue
            runs = marked("", *cell.children, **cell.attributes, mark={"data-cell": found.id})
            runs.source = cell.source
            cell.replace_self(runs)
        for cell in code_cells(self.document):
            part, number = part_of_exercise(cell)
            if part == "solution":
                enclose(cell, number)


def enclose(solution: nodes.Element, number: str) -> None:
    """Put an exercise, from its question to its reason, into one element, with one fold."""
    around, last = solution.parent, solution.parent.index(solution)
    questions = (i for i, node in enumerate(around[:last]) if asks(node, number))
    first, end = next(questions), last + 1
    end += len(list(takewhile(belongs_to_solution, around[end:])))
    if is_dropdown(around[end - 1]):
        end -= 1
        _, *reason = around.pop(end).children
        solution += reason
    title = around[first].next_node(nodes.strong)
    title.replace_self(heard("", *title.children))
    mark = {"data-exercise": number, "role": "group", "aria-label": f"Exercise {number}"}
    around[first:end] = [marked("", *around[first:end], classes=["exercise"], mark=mark)]


def asks(node: nodes.Node, number: str) -> bool:
    """Tell whether a node is the paragraph with which an exercise begins."""
    return isinstance(node, nodes.paragraph) and exercise_of(node) == number


def visit_heard(writer: Any, node: heard) -> None:
    """Open a bold text as a heading."""
    level = str(writer.section_level + 1)
    writer.body.append(writer.starttag(node, "strong", "", role="heading", **{"aria-level": level}))


def visit_marked(writer: Any, node: marked) -> None:
    """Write a container with its mark."""
    writer.body.append(writer.starttag(node, "div", CLASS="docutils container", **node["mark"]))


def depart_marked(writer: Any, node: marked) -> None:
    """Close it."""
    writer.body.append("</div>\n")


def add_script(app: Sphinx, page: str, template: str, context: Any, tree: Any) -> None:
    """Let a page with cells that run load what runs them, and print no line that only judges."""
    if tree and any(tree.findall(marked)):
        app.add_js_file(SCRIPT, defer="defer")
        context["body"] = STUB.sub(r'<span class="on-screen">\g<0></span>', context["body"])


def serve(app: Sphinx) -> None:
    """Put Python among the static files of the website."""
    if not app.config.python_in_page or app.builder.name != "html":
        return
    folder = Path(app.outdir).parent / "static" / "page_python"
    shutil.copytree(put_together(), folder)
    bundle(folder)
    licences = [file.read_text("utf-8") for file in sorted(LIVE.glob("licences/*.txt"))]
    with (folder.parent / "licences.txt").open("a", encoding="utf-8") as file:
        file.write("\n\n\n".join(["", *licences]))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the setting, the marks and the files."""
    app.add_config_value("python_in_page", True, "html", [bool])
    app.add_node(marked, html=(visit_marked, depart_marked))
    app.add_node(heard, html=(visit_heard, HTML5Translator.depart_strong))
    app.add_post_transform(MarkCells)
    app.connect("builder-inited", serve)
    app.connect("html-page-context", add_script)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
