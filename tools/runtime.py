"""Put together the Python of the pages: Pyodide, packages that it has built, and rotedu.

``python tools/runtime.py`` does it before a build, which then asks for nothing.
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
import zipfile
from collections.abc import Iterable, Iterator
from itertools import chain
from pathlib import Path

import yaml
from browser import node
from bundle import LIBRARIES, ROOT, install
from lock import hold_checkout
from packages import PYODIDE, WANTED, on_shelf

LIVE = ROOT / "page_python"
STAND_INS = LIVE / "python"
IN_NODE = Path(__file__).with_name("page_python.mjs")
# It changes with what is set up, but for rotedu.
RUNTIME = ROOT / ".venv" / "page_python" / "runtime"
# What the large files there have been made of; written last.
MADE_OF = RUNTIME / ".made-of"
# What the worker of a page fetches after its scripts, and what when a cell first draws a chart.
FETCHED = ("pyodide.asm.wasm.gz", "python_stdlib.zip", "numpy.zip", "rotedu.zip")
CHARTS = "matplotlib.zip"
# Matplotlib and what it needs; it does without the others that it asks for.
DRAWING = (
    *("matplotlib", "contourpy", "cycler", "kiwisolver", "packaging", "pillow", "pyparsing"),
    *("python-dateutil", "six"),
)

# Where a page has the standard library, and packages.
LIBRARY = "/lib/python312.zip/"
PACKAGES = "/lib/python3.12/site-packages/"
# Of the standard library, what only charts need.
FOR_CHARTS = re.compile(r"xml/(__init__\.py|etree/.*)")
NEEDLESS = re.compile(
    # Of packages: tests, what builds others, and what only compilers and type checkers read.
    r"[^/]*\.(dist-info|data)/.*|.*/((distutils|f2py|include|tests|testing/jpl_units)/.*|setup\.py"
    r"|lapack_lite\..*|_(operand_flag|rational|struct_ufunc|umath)_tests\..*"
    r"|[^/]*\.(pyi|pxd|pxi|pyx|typed|[ach]))"
    # Of those that draw: windows, PDF, PostScript and TeX, letters with serifs, formats of photos.
    r"|matplotlib/(backends/(backend_(?!agg|mixed|svg)|_backend_(gtk|pdf|tk)|_macosx|_tkagg|qt|web).*"
    r"|_type1font\.py|fontlist\.json|mpl-data/kpsewhich\.lua|sphinxext/.*|_(qhull|ttconv)\..*"
    r"|mpl-data/(images|plot_directive|sample_data|fonts/(afm|pdfcorefonts))/.*"
    r"|mpl-data/fonts/ttf/(cm|DejaVuSansMono|DejaVuSerif|Humor).*)"
    r"|PIL/(_imaging(cms|ft|math|morph|tk)|_webp|Image(Cms|Font|Grab|Qt|Tk)"
    r"|(?!Bmp|Gif|Jpeg(?!2K)|Ppm|Png)\w*Plugin).*"
    r"|dateutil/(tz/win.*|zoneinfo/.*\.tar\.gz)"
    # Of the standard library: processes, mail, servers, and letters of other decades.
    r"|(multiprocessing|wsgiref|xml|xmlrpc)/.*"
    r"|(cgi|ftplib|imaplib|mailbox|nntplib|pdb|smtplib|socketserver)\.py"
    r"|encodings/(?!__init__|aliases|ascii|cp1252|cp437|idna|latin_1|punycode|unicode|utf).*"
)
CANNOT_WORK = {
    f"rotedu/figures/{name}.py" for name in ("announce", "backend", "gltf", "pages", "widget")
}
Files = Iterable[tuple[str, bytes]]


def digest(*files: Path) -> str:
    """Return a digest of the contents of files."""
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def version(*files: Path) -> str:
    """Return what an address ends with: a new one for each edition, as browsers keep files."""
    return digest(*files)[:8]


def files_of(archive: bytes) -> Iterator[tuple[str, bytes]]:
    """Yield the files of an archive."""
    with zipfile.ZipFile(io.BytesIO(archive)) as opened:
        for name in opened.namelist():
            yield name, opened.read(name)


def needed(archive: bytes) -> Iterator[tuple[str, bytes]]:
    """Yield those of its files without which a page cannot do."""
    return (file for file in files_of(archive) if not NEEDLESS.fullmatch(file[0]))


def rotedu_files() -> Files:
    """Yield what a wheel has of rotedu, without what draws, and the stand-ins."""
    data = (ROOT / "rotedu" / name for name in ("edition/benchmark.json", "book.mplstyle"))
    package = [*ROOT.glob("rotedu/**/*.py"), *data]
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
    lists = {"FILES": [*map(entry, FETCHED)], "CHARTS": entry(CHARTS)}
    text = "".join(f"self.{name} = {json.dumps(each)};\n" for name, each in lists.items())
    write("files.js", text.encode())
    return RUNTIME


def entry(name: str) -> dict[str, str | int]:
    """Return what a page must know of a file to fetch it."""
    file = RUNTIME / name
    return {"name": name, "size": file.stat().st_size, "version": version(file)}


def large_files_are_current() -> bool:
    """Tell whether the large files are there, made of what they are made of now."""
    return MADE_OF.exists() and MADE_OF.read_text("utf-8") == inputs()


def inputs() -> str:
    """Return a digest of what the large files are made of."""
    recipe = (Path(__file__), Path(__file__).with_name("packages.py"), IN_NODE)
    return digest(PYODIDE / "package.json", WANTED, *recipe)


def put_together_large_files() -> None:
    """Pack Pyodide and packages; what a page loads at once is compiled, which saves it a second."""
    library = (PYODIDE / "python_stdlib.zip").read_bytes()
    numpy, *drawing = on_shelf("numpy", *DRAWING)
    for_charts = [file for file in files_of(library) if FOR_CHARTS.fullmatch(file[0])]
    contents = {
        "python_stdlib.zip": (LIBRARY, [*needed(library)]),
        "numpy.zip": (PACKAGES, [*needed(numpy)]),
        CHARTS: (PACKAGES, [*chain(*map(needed, drawing)), *for_charts]),
    }
    shutil.rmtree(RUNTIME, ignore_errors=True)
    RUNTIME.mkdir(parents=True)
    for script in ("pyodide.js", "pyodide.asm.js"):
        shutil.copy(PYODIDE / script, RUNTIME)
    # Small on any server, also on one that compresses nothing.
    module = gzip.compress((PYODIDE / "pyodide.asm.wasm").read_bytes(), mtime=0)
    write("pyodide.asm.wasm.gz", module)
    write("rotedu.zip", packed(rotedu_files()))
    for name, (_, files) in contents.items():
        write(name, packed(files))
    answers = RUNTIME / "compiled.json"
    subprocess.run([node(), IN_NODE, RUNTIME, answers], check=True)
    compiled = json.loads(answers.read_text("utf-8"))
    answers.unlink()
    for name, (folder, files) in contents.items():
        when = "charts" if name == CHARTS else "core"
        write(name, packed(with_compiled(files, folder, compiled[when])))
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


def is_wanted() -> bool:
    """Tell whether the book has Python in its pages, by the setting ``python_in_page``."""
    config = yaml.safe_load((ROOT / "_config.yml").read_text("utf-8"))
    return bool(config["sphinx"]["config"]["python_in_page"])


if __name__ == "__main__":
    install()
    if is_wanted():
        put_together()
    else:
        print("_config.yml says python_in_page: false, so no cell runs in a page")
        RUNTIME.mkdir(parents=True, exist_ok=True)
    # For make, which compares times.
    MADE_OF.touch()
