"""Fixtures: the built book, a server for it and a browser to read it."""

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from browser import launch, serve
from hypothesis import settings

# Notebooks under test draw still pictures, which need neither a window nor a server.
os.environ["PYVISTA_JUPYTER_BACKEND"] = "still"

ROOT = Path(__file__).parent
LOG = ROOT / "_build" / "book.log"

settings.register_profile("repeatable", derandomize=True, deadline=None, database=None)
# For make test-slow: more random input, different each time.
settings.register_profile("long", max_examples=5_000, deadline=None)
settings.load_profile("repeatable")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add an option to read the pages in another browser."""
    names = ("chromium", "firefox", "webkit")
    parser.addoption("--browser", choices=names, default="chromium", help="for tests of the book")


def needs_book(item: pytest.Item) -> bool:
    """Say whether a test reads the built book."""
    return "book" in getattr(item, "fixturenames", ())


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Mark the tests of the built book, and put them last."""
    items.sort(key=needs_book)
    for item in filter(needs_book, items):
        item.add_marker("book")
        if item.get_closest_marker("chromium") and config.option.browser != "chromium":
            item.add_marker(pytest.mark.skip(reason="needs Chromium"))


def pytest_collection_finish(session: pytest.Session) -> None:
    """See that a browser answers: now, and not after minutes."""
    needed = any("browser" in getattr(item, "fixturenames", ()) for item in session.items)
    if needed and not session.config.option.collectonly:
        try:
            with launch(session.config.option.browser):
                pass
        except SystemExit as no_browser:
            raise pytest.UsageError(no_browser.code) from None


@pytest.fixture(scope="session")
def book(request: pytest.FixtureRequest) -> Path:
    """Build the book: a warning is an error."""
    reporter = request.config.pluginmanager.get_plugin("terminalreporter")
    reporter.ensure_newline()
    reporter.write_line(f"building the book; {LOG.relative_to(ROOT)} says how far it is")
    LOG.parent.mkdir(exist_ok=True)
    jupyter_book = Path(sys.executable).with_name("jupyter-book")
    with LOG.open("w") as log:
        command = [jupyter_book, "build", ".", "-W", "--keep-going"]
        build = subprocess.run(command, cwd=ROOT, stdout=log, stderr=log, check=False)
    if build.returncode != 0:
        pytest.fail(LOG.read_text(errors="replace")[-10_000:])
    return ROOT / "_build" / "html"


@pytest.fixture(scope="session")
def site(book: Path) -> Iterator[str]:
    """Serve the book under a sub-path, as a host of many sites does."""
    with serve(book.parent) as host:
        yield f"{host}/{book.name}"


@pytest.fixture(scope="session")
def browser(request: pytest.FixtureRequest) -> Iterator[Any]:
    """Start a browser."""
    with launch(request.config.option.browser) as browser:
        yield browser
