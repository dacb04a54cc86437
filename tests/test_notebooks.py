"""The committed notebooks, whose outputs nbval must be able to compare."""

import json
import re
from pathlib import Path
from typing import Any

import nbformat
import pytest

SHOWN = re.compile(r"\bsource\((?:\w+\.)*(\w+)\)")
PRIVATE = re.compile(r"_(?!_)")
NOTEBOOKS = sorted((Path(__file__).parents[1] / "book").glob("*.ipynb"))


def code_cells(file: Path) -> list[Any]:
    notebook = nbformat.read(file, as_version=4)
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
class TestNotebook:
    def test_is_valid(self, file: Path) -> None:
        nbformat.validate(nbformat.read(file, as_version=4))

    def test_was_run_from_top_to_bottom(self, file: Path) -> None:
        """Nbval does not compare a cell without a count."""
        counts = [cell.execution_count for cell in code_cells(file)]
        assert counts == list(range(1, len(counts) + 1))

    def test_holds_no_pictures_and_no_errors(self, file: Path) -> None:
        for cell in code_cells(file):
            for output in cell.outputs:
                assert output.output_type != "error"
                assert output.get("name") != "stderr"
                assert not [mime for mime in output.get("data", {}) if mime.startswith("image/")]

    def test_is_folded_in_jupyterlab_as_in_the_book(self, file: Path) -> None:
        for cell in code_cells(file):
            tags = set(cell.metadata.get("tags", []))
            folded = cell.metadata.get("jupyter", {})
            assert ("source_hidden" in folded) == bool(
                tags & {"hide-input", "remove-input", "hide-cell"}
            )
            assert ("outputs_hidden" in folded) == ("hide-cell" in tags)

    def test_shows_no_private_function(self, file: Path) -> None:
        """A listing is a public function; operators are methods with two underscores."""
        shown = [name for cell in code_cells(file) for name in SHOWN.findall(cell.source)]
        assert [name for name in shown if PRIVATE.match(name)] == []
        printed = json.dumps([cell.outputs for cell in code_cells(file)])
        assert not re.search(r"\bdef _[a-z]", printed)

    def test_names_no_backend_and_no_path(self, file: Path) -> None:
        for cell in code_cells(file):
            for word in ("jupyter_backend", "PYVISTA", "__file__", "os.path", "pathlib"):
                assert word not in cell.source

    def test_compares_what_it_prints(self, file: Path) -> None:
        """Only pictures and timings may go uncompared."""
        compared = [
            cell
            for cell in code_cells(file)
            if cell.outputs and "nbval-ignore-output" not in cell.metadata.get("tags", [])
        ]
        printed = [cell for cell in code_cells(file) if cell.outputs]
        assert len(compared) >= 0.8 * len(printed) > 0
