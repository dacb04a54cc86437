"""The stylesheets of all pages become one, fetched at once and kept for the whole book.

A page would ask for a dozen, one of them through another. The theme's own, which its template
would link, come first; our copy of it (``_templates/static/webpack-macros.html``) links the one.
When a style changes, so does its digest, and all pages are written again.
"""

import hashlib
import posixpath
import re
from importlib.metadata import version
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.config import Config

from page_assets import USED_WITH, name_of

NAME = "pages.css"
# styles/theme.css of the theme does nothing but import basic.css.
THEME = ["basic.css", "styles/pydata-sphinx-theme.css"]
PACKAGES = ["sphinx", "sphinx-book-theme", "pydata-sphinx-theme", "myst-nb"]
REMARKS = re.compile(r'@charset "UTF-8";|/\*# sourceMappingURL=.*?\*/')
LINK = re.compile(r"""url\((["']?)(?!data:|#|/|[a-z]+:)([^"')]+)\1\)""")


def note_digest(app: Sphinx, config: Config) -> None:
    """Tell Sphinx and the template what is in the stylesheet."""
    digest = hashlib.sha256("".join(map(version, PACKAGES)).encode())
    for folder in config.html_static_path:
        for file in sorted((Path(app.confdir) / folder).rglob("*.css")):
            digest.update(file.read_bytes())
    config.stylesheet_digest = digest.hexdigest()[:16]
    config.html_context["stylesheet_digest"] = config.stylesheet_digest


def stylesheet(file: Any) -> str:
    """Return the path of a stylesheet, or nothing for another file."""
    is_one = file.attributes["rel"] == "stylesheet"
    return str(file.filename).removeprefix("_static/") if is_one else ""


class OneStylesheet:
    """The stylesheet of a build."""

    def __init__(self) -> None:
        self.parts: list[str] = []

    def link(
        self,
        app: Sphinx,
        pagename: str,
        template: str,
        context: dict[str, Any],
        doctree: nodes.document | None,
    ) -> None:
        """Leave to a page only the files that are not part of it."""
        if not self.parts:
            in_order = sorted(context["css_files"], key=lambda file: file.priority)
            shared = [stylesheet(file) for file in in_order if name_of(file) not in USED_WITH]
            self.parts = THEME + list(filter(None, shared))
        context["css_files"] = [
            file for file in context["css_files"] if stylesheet(file) not in self.parts
        ]

    def write(self, app: Sphinx, error: Exception | None) -> None:
        """Write it, when all extensions have written theirs."""
        if self.parts and not error:
            static = Path(app.outdir) / "_static"
            (static / NAME).write_text(joined(static, self.parts), encoding="utf-8")


def joined(static: Path, names: list[str]) -> str:
    """Return the stylesheets one after the other, with links that hold where they end up."""
    parts = []
    for name in names:
        here = posixpath.dirname(name) or "."
        styles = REMARKS.sub("", (static / name).read_text(encoding="utf-8"))
        parts.append(LINK.sub(rf"url({here}/\2)", styles))
    return "\n".join(parts)


def setup(app: Sphinx) -> dict[str, Any]:
    """Come after page_assets, which chooses the files of a page."""
    one = OneStylesheet()
    app.add_config_value("stylesheet_digest", "", "html")
    app.connect("config-inited", note_digest, priority=900)
    app.connect("html-page-context", one.link, priority=950)
    app.connect("build-finished", one.write, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": False}
