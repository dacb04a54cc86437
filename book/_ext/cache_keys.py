"""Decide from what has changed whether to run notebooks again, or only to write pages again.

MyST-NB's cache compares only the code of a notebook, so a page could go on showing what an older
`rotedu` computed. Therefore a digest of the package names the cache. Sphinx compares only sources
and templates. Therefore a digest of the frame (styles, extensions, viewer, glossary) is a setting:
when it changes, Sphinx writes all pages again.
"""

import hashlib
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.config import Config

ROOT = Path(__file__).parents[2]
FRAME = (
    "book/_ext/**/*",
    "book/_paper/**/*",
    "book/_static/**/*",
    "page_python/*.*",
    "tools/notebook_language.py",
    "viewer/**/*",
    "rotedu/scenes/*.js",
    # Every page links to it.
    "book/glossary.md",
)


def digest(files: Iterable[Path]) -> str:
    """Return a digest of the contents of files."""
    total = hashlib.sha256()
    for file in sorted(files):
        # Neither compiled modules nor the bundled viewer say anything that their sources do not.
        if file.is_file() and not {"__pycache__", "static"} & set(file.parts[-3:-1]):
            total.update(file.read_bytes())
    return total.hexdigest()[:16]


def note(app: Sphinx, config: Config) -> None:
    """Set both digests, and point MyST-NB to the cache for this state of the package."""
    # No notebook runs the models of scenes.
    package = (file for file in ROOT.glob("rotedu/**/*") if file.suffix != ".js")
    config.package_digest = digest([*package, ROOT / "requirements.txt"])
    config.frame_digest = digest(file for part in FRAME for file in ROOT.glob(part))
    caches = Path(app.doctreedir).parent / ".jupyter_cache"
    config.nb_execution_cache_path = str(caches / config.package_digest)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the digests: one makes Sphinx read all pages again, the other write them again."""
    # Its kernel does not warn, page by page, that others on this machine could listen.
    os.environ["JUPYTER_PATH"] = str(ROOT / "tools" / "jupyter")
    app.add_config_value("package_digest", "", "env")
    app.add_config_value("frame_digest", "", "html")
    app.connect("config-inited", note)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
