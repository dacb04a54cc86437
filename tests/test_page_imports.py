"""A page is computed again if what it computes with has changed, and only then."""

import shutil
import sys
from functools import cache
from pathlib import Path

import pytest
from notebook_language import Page, chapters, notebooks

from rotedu.edition.exercises.judging import EXERCISES

sys.path.append(str(Path(__file__).parents[1] / "book" / "_ext"))
import page_imports

ARCS = {"05-arcs"}
AVERAGES = {"beyond-averages"}
WITH_SCENES = {
    page.file.stem for page in notebooks() if any("scenes." in cell.source for cell in page.code)
}
EVERY_PAGE = {page.file.stem for page in notebooks()}


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of the package, which may be edited."""
    before()
    shutil.copytree(page_imports.ROOT / "rotedu", tmp_path / "rotedu")
    shutil.copy(page_imports.ROOT / "requirements.txt", tmp_path)
    monkeypatch.setattr(page_imports, "ROOT", tmp_path)
    return tmp_path / "rotedu"


@cache
def before() -> dict[str, str]:
    return digests()


def digests() -> dict[str, str]:
    page_imports.with_imports.cache_clear()
    return {
        page.file.stem: page_imports.digest(page.file, [cell.source for cell in page.code])
        for page in notebooks()
    }


@pytest.mark.parametrize(
    ("file", "old", "new", "changed"),
    [
        ("edition/exercises/arcs.py", "You count from the first", "You count, from the first", ()),
        ("edition/exercises/arcs.py", "At t = 0 the point", "At 0 the point", ()),
        ("edition/exercises/arcs.py", "A fraction of the arc is", "A part of the arc is", ARCS),
        ("edition/exercises/arcs.py", "within=0.01", "within=0.02", ARCS),
        ("scenes/arcs.py", "from ", "# A comment.\nfrom ", ()),
        ("figures/state.py", '"""', '"""A docstring. ', ()),
        # The page shows its functions.
        ("arcs.py", "\nimport numpy", "\n# A comment.\nimport numpy", ARCS),
        ("arcs.py", "\nimport numpy", "\nNEW = 1\nimport numpy", EVERY_PAGE),
        ("scenes/averages.py", "from ", "NEW = 1\nfrom ", AVERAGES),
        ("scenes/averages.js", "", "// A comment.\n", AVERAGES),
        ("scenes/rotations.js", "", "// A comment.\n", WITH_SCENES),
        ("scenes/__init__.py", "__all__ = [", "NEW = 1\n__all__ = [", ()),
        ("figures/gltf.py", "import json\n", "import json\nNEW = 1\n", EVERY_PAGE),
        ("figures/ball.glsl", "", "// ", EVERY_PAGE),
        ("book.mplstyle", "# Charts", "# The charts", EVERY_PAGE),
        ("../requirements.txt", "numpy==", "numpy==9", EVERY_PAGE),
    ],
)
def test_a_page_changes_with_what_it_computes_with(
    package: Path, file: str, old: str, new: str, changed: set[str]
) -> None:
    source = (package / file).read_text("utf-8")
    assert old in source
    (package / file).write_text(source.replace(old, new, 1), encoding="utf-8")
    after = digests()
    assert {page for page, now in after.items() if now != before()[page]} == set(changed)


@pytest.mark.parametrize("page", chapters(), ids=repr)
def test_a_page_computes_with_what_judges_its_exercises(page: Page) -> None:
    judges = {EXERCISES[number].state.__module__ for number in page.exercises}
    assert {name.rpartition(".")[2] for name in judges} == {page_imports.judge(page.file).stem}


@pytest.mark.parametrize("page", notebooks(), ids=repr)
def test_no_page_prints_a_hint(page: Page) -> None:
    assert "not yet. " not in str([cell.outputs for cell in page.code])
