"""What ``make watch`` does when a file changes."""

import sys
from types import SimpleNamespace
from unittest.mock import Mock

import pytest
import watch
from notebook_language import BOOK, ROOT

sys.path.append(str(BOOK / "_ext"))
import cache_keys


@pytest.mark.parametrize(
    ("file", "builds"),
    [
        ("book/05-arcs.ipynb", True),
        ("book/_ext/front.py", True),
        ("rotedu/arcs.py", True),
        ("book/_static/book.css", False),
        ("book/.ipynb_checkpoints/05-arcs-checkpoint.ipynb", False),
        ("rotedu/scenes/arcs.js", False),
        ("rotedu/figures/static/starts.json", False),
    ],
)
def test_a_source_builds_the_book_and_nothing_else_does(file: str, builds: bool) -> None:
    assert watch.no_source(str(ROOT / file)) != builds


def test_a_watched_book_keeps_its_pages_and_the_next_build_writes_them(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    built, watched = SimpleNamespace(frame_digest=""), SimpleNamespace(frame_digest="")
    monkeypatch.delenv(cache_keys.WATCHED, raising=False)
    cache_keys.note(Mock(), built)
    monkeypatch.setenv(cache_keys.WATCHED, "yes")
    cache_keys.note(Mock(), watched)
    assert built.frame_digest
    assert watched.frame_digest == ""
