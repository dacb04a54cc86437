"""Count claims, and list the figures that answer the hand, for pages that say ``{{ claims }}``."""

import sys
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.config import Config

from rotedu.edition.claims import CLAIMS

sys.path.append(str(Path(__file__).parents[2] / "tools"))
from notebook_language import captions_by_hand


def count(app: Sphinx, config: Config) -> None:
    """Add what is counted to the substitutions of MyST."""
    *figures, last = [f"[{caption.title}](#{caption.anchor})" for caption in captions_by_hand()]
    config.myst_substitutions |= {
        "claims": len(CLAIMS),
        "figures_that_answer_the_hand": f"{', '.join(figures)} and {last}",
    }


def setup(app: Sphinx) -> dict[str, Any]:
    """Count before pages are read."""
    app.connect("config-inited", count)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
