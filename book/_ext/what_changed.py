"""What has changed decides what is done again: running notebooks, or only writing pages.

MyST-NB's cache compares the code of a notebook alone. A page would go on showing what an
older `rotedu` computed, so the digest of the package names the cache. Sphinx compares the
sources and templates alone. So a digest of their frame (styles, extensions, viewer, glossary)
is a setting: when it changes, all pages are written anew.
"""

import hashlib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.config import Config

ROOT = Path(__file__).parents[2]
FRAME = (
    "book/_ext/**/*",
    "book/_static/**/*",
    "viewer/**/*",
    # Every page links to it.
    "book/glossary.md",
)


def digest(files: Iterable[Path]) -> str:
    """Return a digest of the contents of files."""
    total = hashlib.sha256()
    for file in sorted(files):
        if file.is_file() and file.suffix != ".pyc":
            total.update(file.read_bytes())
    return total.hexdigest()[:16]


def note(app: Sphinx, config: Config) -> None:
    """Set both digests and point MyST-NB to the cache of this state of the package."""
    config.package_digest = digest([*ROOT.glob("rotedu/**/*"), ROOT / "requirements.txt"])
    config.frame_digest = digest(file for part in FRAME for file in ROOT.glob(part))
    caches = Path(app.doctreedir).parent / ".jupyter_cache"
    config.nb_execution_cache_path = str(caches / config.package_digest)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the digests: one makes Sphinx read every page again, the other write it."""
    app.add_config_value("package_digest", "", "env")
    app.add_config_value("frame_digest", "", "html")
    app.connect("config-inited", note)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
