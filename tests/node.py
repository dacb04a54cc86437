"""Run a script of the viewer's tests in Node."""

import json
import subprocess
from pathlib import Path
from typing import Any

from browser import node

ROOT = Path(__file__).parents[1]


def run_node(*arguments: str, stdin: str | None = None) -> str:
    """Run Node in the checkout; return what it writes, and fail if it does."""
    command = [node(), *arguments]
    run = subprocess.run(
        command, cwd=ROOT, input=stdin, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout


def ask_node(script: str, question: str) -> dict[str, Any]:
    """Give JSON to a script of `viewer/test`, and read the JSON that it answers."""
    answer: dict[str, Any] = json.loads(run_node(f"viewer/test/{script}", stdin=question))
    return answer
