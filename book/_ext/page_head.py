"""Offer each notebook for download below the title of its page, and describe the page in its head.

What is offered is the students' edition, which runs wherever rotedu is installed. A page also leads
to the sources and to a form for mistakes, once the repository has an address.
"""

import sys
import textwrap
import tomllib
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import nbformat
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

sys.path.append(str(Path(__file__).parents[2] / "tools"))
from class_notebooks import class_names, classroom
from notebook_language import notebooks

PROJECT = Path(__file__).parents[2] / "pyproject.toml"
NOTEBOOKS = "_static/notebooks"
HEAD = (
    '<a href="../{folder}/{file}" download>Download notebook</a>'
    ' (<a href="run-a-class.html#laptops">what it needs</a>)'
)
DESCRIPTION_LENGTH = 160


class WritePageHead(SphinxTransform):
    """Add the link and the description, before Sphinx collects the files to download."""

    default_priority = 400

    def apply(self, **_: Any) -> None:
        """Take the description from the first paragraph."""
        title = next(self.document.findall(nodes.title), None)
        paragraphs = self.document.findall(nodes.paragraph)
        prose = next((p for p in paragraphs if isinstance(p.parent, nodes.section)), None)
        if title is None or prose is None:
            return
        words = textwrap.shorten(prose.astext(), DESCRIPTION_LENGTH)
        self.document += nodes.meta(name="description", content=words)
        file = class_names().get(f"{Path(self.env.docname).name}.ipynb")
        if file:
            text = HEAD.format(folder=NOTEBOOKS, file=file)
            link = nodes.raw("", text, format="html")
            head = nodes.paragraph("", "", link, classes=["page-head"])
            title.parent.insert(title.parent.index(title) + 1, head)


def write_notebooks(app: Sphinx) -> None:
    """Put the notebooks to download among the static files of the website."""
    if app.builder.name != "html":
        return
    folder = Path(app.outdir).parent / "static" / Path(NOTEBOOKS).name
    folder.mkdir()
    edition = classroom(alone=True)
    for page in notebooks():
        nbformat.write(edition.notebook(page, "student"), folder / edition.names[page.name])


def offer(
    app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None
) -> None:
    """Give a page both addresses; the form's names the page, to which book.js adds the section."""
    context["repository"] = app.config.repository.rstrip("/")
    if app.config.repository and doctree is not None:
        place = doctree.next_node(nodes.title).astext()
        query = urlencode({"template": "mistake.yml", "place": place})
        context["report"] = f"{context['repository']}/issues/new?{query}"


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the steps, and set an option that furo adds too late for _config.yml."""
    app.config.pygments_dark_style = "github-dark-high-contrast"
    app.add_transform(WritePageHead)
    settings = tomllib.loads(PROJECT.read_text("utf-8"))["tool"]["rotedu"]
    app.add_config_value("repository", settings["repository"], "env", types=[str])
    app.connect("builder-inited", write_notebooks)
    app.connect("html-page-context", offer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
