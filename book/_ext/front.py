"""What the front page shows of the others: a square for each claim, a card for each chapter.

Only the website has them: in a book on paper, the contents and the list of claims say as much. How
many there are of what, any page may say: ``{{ claims }}``.
"""

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from docutils import nodes
from PIL import Image
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.environment import BuildEnvironment
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.docutils import SphinxDirective

from rotedu import scenes
from rotedu.edition.claims import CLAIMS, SIGNS, VERDICTS
from rotedu.edition.equations import EQUATIONS
from rotedu.edition.errata import ERRATA
from rotedu.figures.pages import scene_poster

# What a square says, and how many of them it says it of.
SAID = {"holds": "hold", "holds under a condition": "hold under a condition"}
SLIPS = sum(claim.slip for claim in CLAIMS)
SAID |= {"does not hold": f"do not hold, of which {SLIPS} are slips that the errata mend (hollow)"}
SAID |= {"left open": "do not follow, or are left open"}
MARK = "verdict-mark"
# Twice the size that a card has room for.
PICTURE = (432, 264)
MINUTES = re.compile(r"\b\d+ min\b")


class shown(nodes.Element):  # noqa: N801 (docutils names nodes so)
    """The place of squares or cards."""


class Place(SphinxDirective):
    """``{verdicts}``, or ``{chapters}`` with a line on each: ``03-ordinary-rotation: words``."""

    has_content = True

    def run(self) -> list[nodes.Node]:
        """Note the place."""
        return [shown(what=self.name, lines=[line.split(": ", 1) for line in self.content])]


class ShowPages(SphinxPostTransform):
    """Write squares and cards, once all pages have been read."""

    # After the first uses of words have become links, which a card, itself one, has no room for.
    default_priority = 7

    def run(self, **_: Any) -> None:
        """Replace each place."""
        for place in list(self.document.findall(shown)):
            if self.app.builder.name != "html":
                place.replace_self([])
            elif place["what"] == "verdicts":
                place.replace_self(list(self.verdicts()))
            else:
                cards = [self.card(f"book/{name}", words) for name, words in place["lines"]]
                place.replace_self(nodes.container("", *cards, classes=["cards"]))

        for cell in self.document.findall(nodes.entry):
            self.colour(cell)
        for box in list(self.document.findall(nodes.container)):
            if "ways" in box["classes"] and self.app.builder.name == "html":
                box.parent.remove(box)
                # Below the first picture and its controls, before the caption.
                self.document.next_node(nodes.figure).insert(1, box)

    def colour(self, cell: nodes.entry) -> None:
        """Put the sign before a verdict into a square, as among the claims of the front page."""
        for verdict in list(cell.findall(nodes.strong)):
            place, said = verdict.parent, verdict.astext()
            sign = place[place.index(verdict) - 1] if place.index(verdict) else None
            if isinstance(sign, nodes.Text) and said in VERDICTS:
                kind = said if said in SIGNS else "left open"
                square = nodes.inline("", sign.strip(), classes=[MARK, nodes.make_id(kind)])
                place.replace(sign, [square, nodes.Text(" ")])

    def verdicts(self) -> Iterator[nodes.paragraph]:
        """Yield a row of links, one to each claim, sorted by verdict, and how many there are."""
        order = list(SAID)
        of_paper = [claim for claim in CLAIMS if claim.of_paper]
        kinds = {c: c.verdict if c.verdict in SIGNS else "left open" for c in of_paper}
        squares = [
            nodes.reference(
                "",
                "",
                nodes.inline(
                    "", f"Claim {claim.number}: {claim.verdict}" + ", a slip" * claim.slip
                ),
                refuri=f"{self.address('book/claims')}#claim-{claim.number}",
                internal=True,
                classes=["slip"] * claim.slip + [MARK, nodes.make_id(kind)],
            )
            for claim, kind in sorted(
                kinds.items(), key=lambda pair: (order.index(pair[1]), pair[0].slip)
            )
        ]
        yield nodes.paragraph("", "", *squares, classes=["squares"])
        numbers = Counter(kinds.values())
        legend = [
            nodes.inline("", f"{numbers[kind]} {said}", classes=[MARK, nodes.make_id(kind)])
            for kind, said in SAID.items()
        ]
        yield nodes.paragraph("", "", *legend, classes=["legend"])

    def card(self, docname: str, words: str) -> nodes.container:
        """Show the first picture of a page, its name and minutes, and a line on it."""
        page = self.env.get_doctree(docname)
        title = nodes.strong("", self.config.short_names[docname])
        link = nodes.reference("", "", title, refuri=self.address(docname), internal=True)
        minutes = nodes.inline("", MINUTES.findall(page.astext())[0], classes=["minutes"])
        return nodes.container(
            "",
            self.small(next(page.findall(scene_poster))),
            nodes.paragraph("", "", link, nodes.Text(" "), minutes),
            nodes.paragraph("", words),
            classes=["card"],
        )

    def small(self, poster: scene_poster) -> scene_poster:
        """Make a small picture of a poster, without what is empty around it."""
        source = Path(self.env.srcdir, poster["uri"])
        with Image.open(source) as large:
            picture = large.crop(large.getbbox())
        picture.thumbnail(PICTURE)
        target = source.with_name(f"small-{source.name}")
        # At this size nobody sees what is lost of the opacity of glass, which is most of the file.
        picture.save(target, quality=60, alpha_quality=50, method=6)
        uri = target.relative_to(self.env.srcdir).as_posix()
        self.env.images.add_file(self.env.docname, uri)
        width, height = picture.size
        says = poster["alt"].split(". ")[0]
        return scene_poster(uri=uri, candidates={"*": uri}, alt=says, width=width, height=height)

    def address(self, docname: str) -> str:
        """Return the address of a page, as seen from this one."""
        return self.app.builder.get_relative_uri(self.env.docname, docname)


def follow(
    app: Sphinx, env: BuildEnvironment, added: set[str], changed: set[str], removed: set[str]
) -> list[str]:
    """Read the first page again where others have changed."""
    return [app.config.root_doc] if added or changed else []


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
    """Register the directives and the step, and count before pages are read."""
    app.add_node(shown)
    app.add_directive("verdicts", Place)
    app.add_directive("chapters", Place)
    app.add_post_transform(ShowPages)
    app.connect("config-inited", count)
    app.connect("env-get-outdated", follow)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
