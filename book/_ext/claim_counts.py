"""Count what the book holds, for pages that say ``{{ claims }}``."""

from typing import Any

from sphinx.application import Sphinx
from sphinx.config import Config

from rotedu import scenes
from rotedu.edition.claims import CLAIMS
from rotedu.edition.equations import EQUATIONS
from rotedu.edition.errata import ERRATA


def count(app: Sphinx, config: Config) -> None:
    """Add what is counted to the substitutions of MyST."""
    config.myst_substitutions |= {
        "claims": len(CLAIMS),
        "claims_of_paper": sum(claim.of_paper for claim in CLAIMS),
        "equations": len(EQUATIONS),
        # Open entries are no errors.
        "errata": sum(erratum.kind != "open" for erratum in ERRATA),
        "figures": sum(hasattr(scene, "inputs") for scene in vars(scenes).values()),
    }


def setup(app: Sphinx) -> dict[str, Any]:
    """Count before pages are read."""
    app.connect("config-inited", count)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
