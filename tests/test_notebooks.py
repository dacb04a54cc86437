"""The committed notebooks, whose outputs nbval must be able to compare."""

import json
import re
import tomllib

import nbformat
import pytest
from notebook_language import BOOK, Page, notebooks, tags

SHOWN = re.compile(r"\bsource\((?:\w+\.)*(\w+)\)")
WIDTH = tomllib.loads((BOOK / "ruff.toml").read_text("utf-8"))["line-length"]


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
        assert [name for name in shown if re.match(r"_(?!_)", name)] == []
        printed = json.dumps([cell.outputs for cell in page.code])
        assert not re.search(r"\bdef _[a-z]", printed)

    def test_shows_no_function_wider_than_the_page(self, page: Page) -> None:
        """Ruff holds the cells to this width; the package has wider lines."""
        listings = [cell.outputs for cell in page.code if SHOWN.search(cell.source)]
        texts = [output.data["text/plain"] for outputs in listings for output in outputs]
        lines = "\n".join(texts).splitlines()
        assert len(lines) >= 2 * len(listings)
        assert [line for line in lines if len(line) > WIDTH] == []

    def test_cells_to_try_are_short_and_use_the_figure_of_the_page(self, page: Page) -> None:
        begun = [re.match(r"(\w+) = explore\(scenes\.", cell.source) for cell in page.code]
        figures = [found[1] for found in begun if found]
        assert len(figures) == len(set(figures))
        for cell in page.code:
            assert ("try" in tags(cell)) == cell.id.startswith("try-")
            if "try" not in tags(cell):
                continue
            assert len(cell.source.splitlines()) <= 8
            assert any(f"{name}." in cell.source for name in figures)

    def test_compares_what_it_prints(self, page: Page) -> None:
        """Only pictures and timings may go uncompared."""
        printed = [cell for cell in page.code if cell.outputs]
        compared = [cell for cell in printed if "nbval-ignore-output" not in tags(cell)]
        assert len(compared) >= 0.8 * len(printed) > 0
