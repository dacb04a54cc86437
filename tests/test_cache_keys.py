"""The build runs side by side what is in no cache, and reports what fails."""

import os
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

ROOT = Path(__file__).parents[1]
CONFIG = f"""
import sys
sys.path[:0] = ["{(ROOT / "book" / "_ext").as_posix()}", "{(ROOT / "tools").as_posix()}"]
extensions = ["myst_nb", "cache_keys"]
nb_execution_mode = "cache"
nb_execution_timeout = 120
exclude_patterns = ["_build"]
"""
# Each run leaves a letter, and prints in two pieces.
CELL = """\
print(open("{0}.ran", "a").write("x"), end=" ", flush=True)
print("is what {0} says")"""


class Book:
    """A small book in a folder of its own."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        (folder / "conf.py").write_text(CONFIG, encoding="utf-8")
        (folder / "index.md").write_text("# Book\n\n```{toctree}\none\ntwo\n```\n", "utf-8")
        for name in ("one", "two"):
            self.write(name, CELL.format(name))

    def write(self, name: str, code: str, text: str = "") -> None:
        cells = [new_markdown_cell(f"# {name}\n\n{text}"), new_code_cell(code)]
        nbformat.write(new_notebook(cells=cells), self.folder / f"{name}.ipynb")

    def build(self) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "sphinx", "-W", "--keep-going", ".", "_build/html"]
        command += ["-d", "_build/.doctrees"]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False)

    def runs(self) -> list[int]:
        return [len((self.folder / f"{name}.ran").read_text()) for name in ("one", "two")]

    def page(self, name: str) -> str:
        return (self.folder / "_build" / "html" / f"{name}.html").read_text("utf-8")


@pytest.fixture
def small_book(tmp_path: Path) -> Book:
    return Book(tmp_path)


def test_notebooks_run_once_until_their_code_changes(small_book: Book) -> None:
    built = small_book.build()
    assert built.returncode == 0, built.stderr
    assert "Executed notebook" not in built.stdout
    assert small_book.runs() == [1, 1]
    assert "1 is what two says" in small_book.page("two")
    small_book.write("one", CELL.format("one"), "Another text.")
    small_book.write("two", CELL.format("two") + "\n1 + 1")
    assert small_book.build().returncode == 0
    assert small_book.runs() == [1, 2]
    assert "Another text." in small_book.page("one")


@pytest.mark.slow
def test_a_failing_cell_stops_the_build_and_is_named(small_book: Book) -> None:
    small_book.write("two", "1 / 0")
    built = small_book.build()
    assert built.returncode != 0
    assert "two.ipynb: WARNING: Executing notebook failed: CellExecutionError" in built.stderr
    assert "is what one says" in small_book.page("one")


@pytest.mark.slow
def test_notebooks_run_at_the_same_time(small_book: Book) -> None:
    """Each waits for the other."""
    if os.cpu_count() == 1:
        pytest.skip("needs two cores")
    for name, other in (("one", "two"), ("two", "one")):
        small_book.write(
            name,
            "import pathlib, time\n"
            f'pathlib.Path("{name}.ran").write_text("x")\n'
            f'while not pathlib.Path("{other}.ran").exists():\n'
            "    time.sleep(0.1)",
        )
    built = small_book.build()
    assert built.returncode == 0, built.stderr
