"""The packages of the pages' Python: what Pyodide has built, wherever it comes from."""

import shutil
from pathlib import Path

import packages
import pytest
from browser import serve
from packages import SHELF, listed, on_shelf

SMALL = "six"
NAME, _ = listed(SMALL)


@pytest.fixture(autouse=True)
def empty_shelf(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is there, and the package index has nothing."""
    monkeypatch.setattr(packages, "SHELF", tmp_path / "packages")
    monkeypatch.setattr(packages, "download", lambda _: False)


def test_the_release_has_them_if_the_index_has_not(monkeypatch: pytest.MonkeyPatch) -> None:
    with serve(SHELF) as release:
        monkeypatch.setattr(packages, "RELEASE", f"{release}/")
        assert on_shelf(SMALL) == [(SHELF / NAME).read_bytes()]


def test_a_changed_byte_is_refused_from_the_release(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content = bytearray((SHELF / NAME).read_bytes())
    content[-1] ^= 1
    (tmp_path / NAME).write_bytes(content)
    with serve(tmp_path) as release:
        monkeypatch.setattr(packages, "RELEASE", f"{release}/")
        with pytest.raises(RuntimeError, match=rf"^{NAME} is not what Pyodide has built: "):
            on_shelf(SMALL)
    assert not (packages.SHELF / NAME).exists()


def test_a_changed_byte_is_refused_on_the_shelf(monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(SHELF, packages.SHELF)
    assert len(on_shelf(SMALL)) == 1
    with (packages.SHELF / NAME).open("ab") as file:
        file.write(b"0")
    with pytest.raises(RuntimeError, match=rf"^{NAME} is not what Pyodide has built: "):
        on_shelf(SMALL)


def test_without_any_source_the_build_says_how_to_do_without_python(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(packages, "RELEASE", "nowhere:")
    with pytest.raises(RuntimeError, match=r"set python_in_page: false in _config\.yml"):
        on_shelf(SMALL)
