"""The viewer's own tests, run by Node."""

import re
from pathlib import Path

from node import run_node

ROOT = Path(__file__).parents[1]


def test_the_viewer_knows_no_scene() -> None:
    source = ROOT / "viewer" / "src"
    for file in source.glob("*.js"):
        for name in re.findall(r"""(?:from|import\(?)\s*["'](.+?)["']""", file.read_text("utf-8")):
            outside = not (file.parent / name).resolve().is_relative_to(source)
            assert not (name.startswith(".") and outside), f"{file.name} imports {name}"


def test_the_viewer_passes_its_own_tests() -> None:
    run_node("--test", "viewer/test/*.test.js")
