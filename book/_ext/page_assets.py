"""A page loads what it uses, and no script holds up its first picture.

Jupyter Book and the theme add the files of all their extensions to every page. Here those go
that no page uses, others stay only where the page has something for them, and all scripts but
the one that chooses the colours wait until the page is there. Nothing is inline but what the
theme's own templates have: its buttons to print and to fill the screen, which browsers have
too, give way to one that downloads the notebook. Code keeps the elements that colour it.
"""

import html
import re
import textwrap
from pathlib import PurePosixPath
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

# The book folds with <details> (folded.py) and has no kernel behind its pages.
UNUSED = {"sphinx-thebe.css", "sphinx-thebe.js", "togglebutton.css", "togglebutton.js"}
# A file, and what is in the text of every page that uses it.
USED_WITH = {
    "clipboard.min.js": 'class="highlight',
    "copybutton.js": 'class="highlight',
    "design-tabs.js": 'class="sd-tab',
    "sphinx-design.min.css": 'class="sd-',
}
# Names, punctuation and spaces have the colour of the code around them.
UNCOLOURED = re.compile(r'<span class="(?:n|nn|p|w)">([^<]*)</span>')
BEFORE_THE_PAGE = "before-the-page.js"
AFTER_THE_PAGE = "in-parts.js"
DOWNLOAD = {
    "type": "link",
    "tooltip": "Download this page as a notebook",
    "icon": "fas fa-download",
    "label": "download-notebook-button",
}
DESCRIPTION_LENGTH = 160


def name_of(asset: Any) -> str:
    """Return the name of the file, or nothing for what is inline."""
    return PurePosixPath(str(asset.filename or "")).name


def is_used(asset: Any, body: str) -> bool:
    """Tell whether a page with this text needs the file."""
    name = name_of(asset)
    return bool(name) and name not in UNUSED and USED_WITH.get(name, "") in body


def choose(
    app: Sphinx,
    pagename: str,
    template: str,
    context: dict[str, Any],
    doctree: nodes.document | None,
) -> None:
    """Choose the files of a page, after all extensions have added theirs."""
    for kind in ("css_files", "script_files"):
        context[kind] = [file for file in context[kind] if is_used(file, context.get("body", ""))]
    for script in context["script_files"]:
        name = name_of(script)
        # The theme's search page runs its scripts in the order of the page.
        if name == BEFORE_THE_PAGE or (pagename == "search" and name != AFTER_THE_PAGE):
            script.attributes.pop("defer", None)
        else:
            script.attributes["defer"] = "defer"
    if context.get("page_source_suffix") == ".ipynb":
        source = context["pathto"](f"_sources/{context['sourcename']}", resource=True)
        context["header_buttons"].append(DOWNLOAD | {"url": source})
    if doctree and (paragraph := next(iter(doctree.findall(nodes.paragraph)), None)):
        words = html.escape(textwrap.shorten(paragraph.astext(), DESCRIPTION_LENGTH))
        context["metatags"] += f'\n    <meta name="description" content="{words}">'


def unwrap_code(
    app: Sphinx,
    pagename: str,
    template: str,
    context: dict[str, Any],
    doctree: nodes.document | None,
) -> None:
    """Take the elements off what has no colour of its own: most of the words of a program."""
    if "body" in context:
        context["body"] = UNCOLOURED.sub(r"\1", context["body"])


def remove_scripts(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """Remove the scripts that sphinx-thebe puts at the end of every page."""
    for node in [node for node in doctree.children if isinstance(node, nodes.raw)]:
        if node.astext().lstrip().startswith("<script"):
            doctree.remove(node)


def setup(app: Sphinx) -> dict[str, Any]:
    """Come last: the priorities of others are 500."""
    app.connect("doctree-resolved", remove_scripts, priority=900)
    app.connect("html-page-context", choose, priority=900)
    app.connect("html-page-context", unwrap_code)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
