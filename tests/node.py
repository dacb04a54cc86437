"""Run tests in Node, which read cases that Python has computed."""

import json
import os
import subprocess
from pathlib import Path
from typing import Any

from browser import node

ROOT = Path(__file__).parents[1]
CASES = ROOT / "_build" / "cases"


def run_node(*arguments: str) -> None:
    """Run Node in the checkout, and fail if it does."""
    libraries = ROOT / "node_modules" / "happy-dom"
    assert libraries.exists(), "no browser libraries: install them with python tools/bundle.py"
    run = subprocess.run(
        [node(), *arguments],
        cwd=ROOT,
        env=os.environ | {"CASES": str(CASES)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr


def run_cases(name: str, cases: dict[str, Any]) -> None:
    """Write cases, and run the tests in Node that read them."""
    text = json.dumps(cases, default=lambda array: array.tolist())
    # JSON has neither NaN nor infinities; a number beyond all others is read as infinity.
    text = text.replace("NaN", '"NaN"').replace("Infinity", "1e999")
    CASES.mkdir(parents=True, exist_ok=True)
    (CASES / f"{name}.json").write_text(text, encoding="utf-8")
    run_node("--test", f"tests/{name}*.test.mjs")
