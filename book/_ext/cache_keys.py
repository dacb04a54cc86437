"""Decide from what has changed whether to run notebooks again, read pages again or write them.

MyST-NB's cache compares only the code of a notebook, so a page could go on showing what an older
`rotedu` computed. Therefore each page has a cache of its own, named by a digest of what it computes
with (`page_imports`), and a page with another cache than before is read again. What is in no cache
yet runs side by side, before MyST-NB asks for it.

Sphinx compares only sources and templates. Therefore two digests are settings. When an extension
changes, Sphinx reads all pages again. When the frame changes (styles, viewer, glossary, and the
package, which pages carry with them), it writes all pages again.
"""

import hashlib
import logging
import os
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any

from jupyter_cache import get_cache
from jupyter_cache.executors import load_executor, utils
from myst_nb.core.read import create_nb_reader
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.environment import BuildEnvironment

from page_imports import digest as digest_of_imports
from page_imports import judge

ROOT = Path(__file__).parents[2]
EXTENSIONS = ("book/_ext/*.py", "rotedu/figures/*.py", "tools/notebook_language.py")
FRAME = (
    "book/_paper/**/*",
    "book/_static/**/*",
    "page_python/**/*",
    "viewer/**/*",
    "rotedu/**/*",
    # Every page links to it.
    "book/glossary.md",
)
SILENT = logging.getLogger("jupyter_cache.silent")
SILENT.disabled = True
# What a busy machine prints in pieces is one text again, without empty lines between them.
utils.executenb = partial(utils.executenb, coalesce_streams=True)
# Set by tools/watch.py, which copies styles and scripts itself and keeps the pages around them.
WATCHED = "ROTEDU_WATCHED"


def digest(files: Iterable[Path]) -> str:
    """Return a digest of the contents of files."""
    total = hashlib.sha256()
    for file in sorted(files):
        # Neither compiled modules nor the bundled viewer say anything that their sources do not.
        if file.is_file() and not {"__pycache__", "static"} & set(file.parts[-3:-1]):
            total.update(file.read_bytes())
    return total.hexdigest()[:16]


def note(app: Sphinx, config: Config) -> None:
    """Set both digests."""
    config.extension_digest = digest(file for part in EXTENSIONS for file in ROOT.glob(part))
    if WATCHED not in os.environ:
        config.frame_digest = digest(file for part in FRAME for file in ROOT.glob(part))


def choose_caches(
    app: Sphinx, env: BuildEnvironment, added: set[str], changed: set[str], removed: set[str]
) -> list[str]:
    """Choose the cache of each page with cells, and return the pages that have another one now."""
    before = getattr(env, "caches", {})
    caches = Path(app.doctreedir).parent / ".jupyter_cache"
    env.caches = {}
    for page in env.found_docs:
        file = Path(env.doc2path(page))
        text = file.read_text("utf-8")
        if reader := reader_of(env, file, text):
            cells = [cell.source for cell in reader.read(text).cells if cell.cell_type == "code"]
            env.caches[page] = str(caches / digest_of_imports(file, cells))
    return [page for page, cache in env.caches.items() if before.get(page) != cache]


def reader_of(env: BuildEnvironment, file: Path, text: str) -> Any:
    """Return what MyST-NB reads the cells of a page with; None if it has no cells."""
    return create_nb_reader(str(file), env.myst_config, env.mystnb_config, text)


def run_side_by_side(app: Sphinx, env: BuildEnvironment, pages: list[str]) -> None:
    """Run what the caches lack, one notebook for each core.

    MyST-NB finds a notebook that has failed in no cache, runs it again and reports what is wrong.
    """
    config = env.mystnb_config

    def run(page: str) -> None:
        file = Path(env.doc2path(page))
        cache = get_cache(env.caches[page])
        read_data = reader_of(env, file, file.read_text("utf-8")).read_fmt
        cache.add_nb_to_project(str(file), **({"read_data": read_data} if read_data else {}))
        load_executor("local-serial", cache, SILENT).run_and_cache(
            timeout=config.execution_timeout, allow_errors=config.execution_allow_errors
        )

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(run, (page for page in pages if page in env.caches)))


def use_cache(app: Sphinx, page: str, source: list[str]) -> None:
    """Point MyST-NB to the cache of the page that Sphinx now reads, and Sphinx to its hints."""
    env = app.env
    if page in env.caches:
        env.mystnb_config = env.mystnb_config.copy(execution_cache_path=env.caches[page])
        if (hints := judge(Path(page))).exists():
            env.note_dependency(str(hints))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the digests and the steps."""
    # Its kernel does not warn, page by page, that others on this machine could listen.
    os.environ["JUPYTER_PATH"] = str(ROOT / "tools" / "jupyter")
    app.add_config_value("extension_digest", "", "env")
    app.add_config_value("frame_digest", "", "html")
    app.connect("config-inited", note)
    app.connect("env-get-outdated", choose_caches)
    app.connect("env-before-read-docs", run_side_by_side)
    app.connect("source-read", use_cache)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
