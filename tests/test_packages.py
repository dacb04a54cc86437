"""The packages of the pages' Python: what Pyodide has built, wherever it comes from."""

from pathlib import Path

import packages
import pytest
from browser import serve
from packages import SHELF, listed, on_shelf

SMALL = "six"
NAME, _ = listed(SMALL)
CHANGED = f"^{NAME} is not what Pyodide has built: "


@pytest.fixture(autouse=True)
def empty_shelf(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is there, and the package index has nothing."""
    monkeypatch.setattr(packages, "SHELF", tmp_path / "packages")
    monkeypatch.setattr(packages, "download", lambda _: False)


def test_the_release_has_them_if_the_index_has_not(monkeypatch: pytest.MonkeyPatch) -> None:
    with serve(SHELF) as release:
        monkeypatch.setattr(packages, "RELEASE", f"{release}/")
        assert on_shelf(SMALL) == [(SHELF / NAME).read_bytes()]
    # From now on they are on the shelf.
    assert len(on_shelf(SMALL)) == 1
    (packages.SHELF / NAME).write_bytes(b"changed")
    with pytest.raises(RuntimeError, match=CHANGED):
        on_shelf(SMALL)


def test_a_changed_byte_is_refused_from_the_release(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content = bytearray((SHELF / NAME).read_bytes())
    content[-1] ^= 1
    (tmp_path / NAME).write_bytes(content)
    with serve(tmp_path) as release:
        monkeypatch.setattr(packages, "RELEASE", f"{release}/")
        with pytest.raises(RuntimeError, match=CHANGED):
            on_shelf(SMALL)
    assert not (packages.SHELF / NAME).exists()


def test_without_any_source_the_build_says_how_to_do_without_python(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(packages, "RELEASE", "nowhere:")
    with pytest.raises(RuntimeError, match=r"set python_in_page: false in _config\.yml"):
        on_shelf(SMALL)
