"""Count the claims, for pages that say ``{{ claims }}``."""

from typing import Any

from sphinx.application import Sphinx
from sphinx.config import Config

from rotedu.edition.claims import CLAIMS


def count(app: Sphinx, config: Config) -> None:
    """Add what is counted to the substitutions of MyST."""
    config.myst_substitutions |= {"claims": len(CLAIMS)}


def setup(app: Sphinx) -> dict[str, Any]:
    """Count before pages are read."""
    app.connect("config-inited", count)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
