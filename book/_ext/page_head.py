"""Write what stands around the title of a page: where it belongs, one line of facts, and one fold.

The notebook that a page offers is the students' edition, which runs wherever rotedu is installed. A
page also leads to the sources and to a form for mistakes, once the repository has an address.
"""

import re
import sys
import textwrap
import tomllib
from collections.abc import Iterator
from html import escape
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import nbformat
from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

sys.path.append(str(Path(__file__).parents[2] / "tools"))
from class_notebooks import class_names, classroom
from notebook_language import notebooks

from cells import bold, caption_of, folded, is_dropdown
from names import BETWEEN

PROJECT = Path(__file__).parents[2] / "pyproject.toml"
NOTEBOOKS = "_static/notebooks"
# How a page begins for JupyterLab: how long it takes, and what it needs.
TIME = re.compile(r"(\d+) minutes to read(?:, (\d+) for the exercises)?\.")
NEEDS = "Before you start"
SECTION = re.compile(r"(\d)(?: (I+V?))? (.+)")
DESCRIPTION_LENGTH = 160


class WritePageHead(SphinxTransform):
    """Add the line, the fold and the description, before Sphinx collects the files to download."""

    # After misprints.py, which makes folds of what is counted.
    default_priority = 410

    def apply(self, **_: Any) -> None:
        """Take the description from the first paragraph that is neither head nor caption."""
        title = next(self.document.findall(nodes.title), None)
        if title is None:
            return
        paragraphs = [
            paragraph
            for paragraph in self.document.findall(nodes.paragraph)
            if isinstance(paragraph.parent, nodes.section)
        ]
        head = next((each for each in paragraphs if bold(each) == "Time"), None)
        prose = next((p for p in paragraphs if p is not head and not caption_of(p)), None)
        if prose:
            words = textwrap.shorten(prose.astext(), DESCRIPTION_LENGTH)
            self.document += nodes.meta(name="description", content=words)
        if head:
            line = nodes.paragraph("", "", *self.facts(head.astext()), classes=["page-head"])
            head.replace_self([line, *rest(head)])

    def facts(self, said: str) -> Iterator[nodes.Node]:
        """Yield the minutes, the number of misprints, and the notebook."""
        minutes, exercises = TIME.findall(said)[0]
        times = f"{minutes} min" + (f", exercises {exercises}" if exercises else "")
        yield nodes.inline("", times)
        count = sum(
            "misprint" in fold["container_classes"] for fold in self.document.findall(is_dropdown)
        )
        if count:
            name = "misprint" if count == 1 else "misprints"
            text = f'<a href="errata.html">{count} {name}</a>'
            yield nodes.raw("", text, format="html")
        if file := class_names().get(f"{Path(self.env.docname).name}.ipynb"):
            text = f'<a href="../{NOTEBOOKS}/{file}" download>Notebook</a>'
            yield nodes.raw("", text, format="html")


def rest(head: nodes.paragraph) -> list[nodes.Element]:
    """Return what the paragraph says besides the minutes; what a page needs is folded."""
    # MyST puts an empty text before a word in bold.
    _, first, *others = (child for child in head.children if child.astext().strip())
    said = TIME.sub("", first.astext()).lstrip()
    if others and others[0].astext() == NEEDS:
        words, *others = others[1:]
        needs = words.astext().lstrip()
        said = needs[0].upper() + needs[1:]
        paragraph = nodes.paragraph("", "", nodes.Text(said), *others)
        return [folded("head-more", [nodes.Text(NEEDS)], [paragraph])]
    return [nodes.paragraph("", "", nodes.Text(said), *others)] if said or others else []


def eyebrow(app: Sphinx, page: str, title: str) -> str:
    """Return where a page belongs: to a section of the paper, or to a part of the book.

    A title that is a sentence leaves the subject to this line.
    """
    name = app.config.short_names.get(page, "")
    if found := SECTION.match(name):
        number, piece, subject = found.groups()
        where = f"Section {number} of the paper" + (f", part {piece}" if piece else "")
    else:
        subject = name.partition(" ")[2]
        parts = app.env.get_doctree(app.config.root_doc).findall(addnodes.toctree)
        where = next((str(part["caption"]) for part in parts if page in part["includefiles"]), "")
    return f"{where}{BETWEEN}{escape(subject)}" if BETWEEN in title else where


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
    title = "" if doctree is None else doctree.next_node(nodes.title).astext()
    if title and (words := eyebrow(app, page, title)):
        line = f'<p class="eyebrow">{words}</p>\n<h1>'
        context["body"] = context["body"].replace("<h1>", line, 1)
    context["repository"] = app.config.repository.rstrip("/")
    if app.config.repository and doctree is not None:
        query = urlencode({"template": "mistake.yml", "place": title})
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
