"""Lead readers to the sources and to a form for mistakes, once the repository has an address."""

import tomllib
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

from docutils import nodes
from sphinx.application import Sphinx

PROJECT = Path(__file__).parents[2] / "pyproject.toml"


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
    """Take the address from the settings of the project."""
    settings = tomllib.loads(PROJECT.read_text("utf-8"))["tool"]["rotedu"]
    app.add_config_value("repository", settings["repository"], "env", types=[str])
    app.connect("html-page-context", offer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
