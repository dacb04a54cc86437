"""The committed notebooks, whose outputs nbval must be able to compare."""

import json
import re
import tomllib
from pathlib import Path

import nbformat
import pytest
from notebook_language import Page, notebooks, tags

ROOT = Path(__file__).parents[1]
SHOWN = re.compile(r"\bsource\((?:\w+\.)*(\w+)\)")
PRIVATE = re.compile(r"_(?!_)")
WIDTH = tomllib.loads((ROOT / "book" / "ruff.toml").read_text(encoding="utf-8"))["line-length"]


@pytest.mark.parametrize("page", notebooks(), ids=repr)
class TestNotebook:
    def test_is_valid(self, page: Page) -> None:
        nbformat.validate(page.notebook)

    def test_was_run_from_top_to_bottom(self, page: Page) -> None:
        """Nbval does not compare a cell without a count."""
        counts = [cell.execution_count for cell in page.code]
        assert counts == list(range(1, len(counts) + 1))

    def test_holds_no_pictures_and_no_errors(self, page: Page) -> None:
        for cell in page.code:
            for output in cell.outputs:
                assert output.output_type != "error"
                assert output.get("name") != "stderr"
                assert not [mime for mime in output.get("data", {}) if mime.startswith("image/")]

    def test_shows_no_private_function(self, page: Page) -> None:
        """A listing is a public function; operators are methods with two underscores."""
        shown = [name for cell in page.code for name in SHOWN.findall(cell.source)]
        assert [name for name in shown if PRIVATE.match(name)] == []
        printed = json.dumps([cell.outputs for cell in page.code])
        assert not re.search(r"\bdef _[a-z]", printed)

    def test_shows_no_function_wider_than_the_page(self, page: Page) -> None:
        """Ruff holds the cells to this width; the package has wider lines."""
        listings = [cell.outputs for cell in page.code if SHOWN.search(cell.source)]
        lines = [
            line
            for outputs in listings
            for output in outputs
            for line in output.data["text/plain"].splitlines()
        ]
        assert len(lines) >= 2 * len(listings)
        assert [line for line in lines if len(line) > WIDTH] == []

    def test_cells_to_try_are_short_and_use_the_figure_of_the_page(self, page: Page) -> None:
        cells = [cell for cell in page.code if "try" in tags(cell) or cell.id.startswith("try-")]
        figures = [
            found[1]
            for cell in page.code
            if (found := re.match(r"(\w+) = explore\(scenes\.", cell.source))
        ]
        assert len(figures) == len(set(figures))
        for cell in cells:
            assert "try" in tags(cell)
            assert cell.id.startswith("try-")
            assert len(cell.source.splitlines()) <= 8
            assert any(f"{name}." in cell.source for name in figures)

    def test_compares_what_it_prints(self, page: Page) -> None:
        """Only pictures and timings may go uncompared."""
        compared = [
            cell
            for cell in page.code
            if cell.outputs and "nbval-ignore-output" not in cell.metadata.get("tags", [])
        ]
        printed = [cell for cell in page.code if cell.outputs]
        assert len(compared) >= 0.8 * len(printed) > 0
