"""The edits of tools/mutations.py fit the code; running it tells whether tests notice them."""

import runpy
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
MUTATIONS = runpy.run_path(str(ROOT / "tools" / "mutations.py"))["MUTATIONS"]


@pytest.mark.parametrize("module", MUTATIONS)
def test_each_edit_is_of_code_that_is_there_once(module: str) -> None:
    source = (ROOT / "rotedu" / f"{module}.py").read_text("utf-8")
    for equation, code, wrong in MUTATIONS[module]:
        assert source.count(code) == 1, f"{equation}: {code}"
        compile(source.replace(code, wrong), module, "exec")
