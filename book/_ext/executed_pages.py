"""Executed notebooks are kept until the notebook, the package or its environment changes.

MyST-NB's cache compares the code of a notebook alone. A page would go on showing what an
older `rotedu` computed, so the digest of the package names the cache.
"""

import hashlib
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.config import Config

ROOT = Path(__file__).parents[2]


def digest_of_package() -> str:
    """Return a digest of everything that can change an output without changing a notebook."""
    digest = hashlib.sha256()
    for file in [*sorted(ROOT.glob("rotedu/**/*.*")), ROOT / "requirements.txt"]:
        if file.suffix != ".pyc":
            digest.update(file.read_bytes())
    return digest.hexdigest()[:16]


def name_cache(app: Sphinx, config: Config) -> None:
    """Point MyST-NB to the cache of this state of the package."""
    config.package_digest = digest_of_package()
    caches = Path(app.doctreedir).parent / ".jupyter_cache"
    config.nb_execution_cache_path = str(caches / config.package_digest)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the digest as a setting: when it changes, Sphinx reads every page again."""
    app.add_config_value("package_digest", "", "env")
    app.connect("config-inited", name_cache)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
