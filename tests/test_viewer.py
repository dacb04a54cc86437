"""The viewer's own tests, run by Node."""

from pathlib import Path

import pytest
from node import run_node

ROOT = Path(__file__).parents[1]


def test_the_viewer_passes_its_own_tests() -> None:
    if not (ROOT / "node_modules" / "three").exists():
        pytest.skip("the browser libraries are not installed: build the book first")
    run_node("--test", "viewer/test/*.test.js")
