"""JupyterLab for the tests that need a server of their own."""

import subprocess
import time
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.error import URLError

from browser import free_port

PATIENCE = 300  # seconds


def until(done: Callable[[], bool], what: str) -> None:
    """Ask again and again."""
    end = time.monotonic() + PATIENCE
    while not done():
        if time.monotonic() > end:
            raise TimeoutError(f"{what}: not there after {PATIENCE} seconds")
        time.sleep(0.5)


def get(url: str) -> str:
    return urllib.request.urlopen(url, timeout=30).read().decode()


def answers(url: str) -> bool:
    try:
        get(url)
    except URLError:
        return False
    return True


@contextmanager
def jupyterlab(
    python: Path | str, folder: Path, *options: str, env: dict[str, str] | None = None
) -> Iterator[str]:
    """JupyterLab in a folder, without a window, for everybody who knows the address."""
    port = free_port()
    command = [python, "-m", "jupyterlab", "--no-browser", "--allow-root", f"--port={port}"]
    command += ["--IdentityProvider.token=", *options]
    with (folder / "lab.log").open("w") as log:
        server = subprocess.Popen(command, cwd=folder, env=env, stdout=log, stderr=log)
    url = f"http://127.0.0.1:{port}"
    until(lambda: answers(f"{url}/api"), f"JupyterLab in {folder}")
    yield url
    server.terminate()
    try:
        server.wait(30)
    except subprocess.TimeoutExpired:
        # Its loop has ended, but a thread at work for it may wait for ever.
        server.kill()
        server.wait()
