"""The short name of a page, ``title`` in _toc.yml, beside the sentence that may be its title.

The sidebar, the cards of the front page and the line above a title say the name, and a title on the
screen is the sentence alone. Whatever else names a page has both, as ``2 Quaternions · sentence``:
they are the title that Sphinx reads, so that previous and next pages, the tab, the search, links
without a text, the outline of the PDF and the contents of the EPUB agree.
"""

from html import escape
from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.transforms import SphinxTransform
from sphinx.transforms.post_transforms import SphinxPostTransform

BETWEEN = " · "


class NamePage(SphinxTransform):
    """Put the name of a page before its title, unless it is the title."""

    # After quotation marks have become typographical: those of a name are as they should be.
    default_priority = 800

    def apply(self, **_: Any) -> None:
        """Take the first title, which is the page's."""
        title = self.document.next_node(nodes.title)
        name = self.config.short_names.get(self.env.docname)
        if title and name and title.astext() != name:
            title.insert(0, nodes.Text(name + BETWEEN))


class ListTitles(SphinxPostTransform):
    """List the pages of an EPUB, which has no sidebar, by their whole titles."""

    default_priority = 5
    builders = ("epub",)

    def run(self, **_: Any) -> None:
        """Take the names out of the contents."""
        for contents in self.document.findall(addnodes.toctree):
            contents["entries"] = [(None, page) for _, page in contents["entries"]]


def read_names(app: Sphinx, config: Config) -> None:
    """Read the names of all pages that have one."""
    pages = config.external_site_map.items()
    config.short_names = {page: entry.title for page, entry in pages if entry.title}


def leave_sentence(
    app: Sphinx, page: str, _template: str, context: dict[str, Any], _tree: Any
) -> None:
    """Leave of a title on the screen the sentence."""
    name = app.config.short_names.get(page)
    if name and app.builder.name == "html":
        begins = f"<h1>{escape(name, quote=False)}{BETWEEN}"
        context["body"] = context["body"].replace(begins, "<h1>", 1)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the steps; a change of a name has all pages read again."""
    app.add_config_value("short_names", {}, "env", types=[dict])
    # Once sphinx_external_toc has read the file
    app.connect("config-inited", read_names, priority=901)
    app.add_transform(NamePage)
    app.add_post_transform(ListTitles)
    app.connect("html-page-context", leave_sentence)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
