"""Link the first use of each glossary term on a page to its explanation.

The notebooks therefore need no markup for these links, which JupyterLab would show as plain text.
"""

import re
from collections.abc import Iterator
from functools import lru_cache
from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.nodes import make_refnode

PAGES_WITHOUT = ("book/glossary", "book/api", "book/equations", "book/references")
PLURALS = {"matrix": "matrices", "erratum": "errata", "degrees of freedom": "degree of freedom"}
NOT_PROSE = (
    addnodes.pending_xref,
    nodes.emphasis,
    nodes.caption,
    nodes.literal,
    nodes.math,
    nodes.reference,
    nodes.thead,
    nodes.title,
)


def spellings(term: str) -> list[str]:
    """Return all spellings of a term: ``C1, C2`` are two terms, and each has a plural."""
    return [form for name in term.split(", ") for form in (name, PLURALS.get(name, f"{name}s"))]


def pattern(spelling: str) -> str:
    """Return a pattern that finds a spelling in a text, also at the start of a sentence or line."""
    first, rest = spelling[0], re.escape(spelling[1:])
    rest = rest.replace("'", "['\N{RIGHT SINGLE QUOTATION MARK}]").replace(r"\ ", r"\s+")
    return f"[{first.upper()}{first}]{rest}"


@lru_cache
def finder(forms: tuple[str, ...]) -> re.Pattern[str]:
    """Return a pattern that finds any of some spellings, and in which group."""
    uses = "|".join(f"(?P<_{i}>{pattern(form)})" for i, form in enumerate(forms))
    return re.compile(rf"(?<![\w-])(?:{uses})(?![\w-])")


def is_prose(node: nodes.Node) -> bool:
    """Tell whether a node is part of running text, which may contain links."""
    inside_paragraph = False
    while node := node.parent:
        if isinstance(node, NOT_PROSE):
            return False
        inside_paragraph |= isinstance(node, nodes.paragraph)
    return inside_paragraph


class LinkFirstUses(SphinxPostTransform):
    """Link the terms of the glossary, longer terms before shorter ones."""

    # After the paragraphs of captions have become captions.
    default_priority = 6

    def run(self, **_: Any) -> None:
        """Walk through the running text of a page, once."""
        if self.env.docname.startswith(PAGES_WITHOUT):
            return
        objects = self.env.domains["std"].get_objects()
        terms = {name: (page, label) for name, _, kind, page, label, _ in objects if kind == "term"}
        unseen = {form: name for name in terms for form in spellings(name)}

        def link(form: str, content: nodes.Node) -> nodes.reference:
            name = unseen[form]
            for other in spellings(name):
                del unseen[other]
            page, label = terms[name]
            link = make_refnode(self.app.builder, self.env.docname, page, label, [content], name)
            link["classes"].append("first-use")
            return link

        def linked(text: str) -> Iterator[nodes.Node]:
            longest_first = tuple(sorted(unseen, key=len, reverse=True))
            found = finder(longest_first).search(text)
            if found is None or found.lastgroup is None:
                yield nodes.Text(text)
                return
            form = longest_first[int(found.lastgroup[1:])]
            yield nodes.Text(text[: found.start()])
            yield link(form, nodes.Text(found[0]))
            yield from linked(text[found.end() :])

        for node in [node for node in self.document.findall() if is_prose(node)]:
            if isinstance(node, nodes.Text):
                node.parent.replace(node, list(linked(node.astext())))
            elif isinstance(node, nodes.math):
                form = node.astext().replace("^", "")
                if form in unseen:
                    node.replace_self(link(form, node.deepcopy()))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step."""
    app.add_post_transform(LinkFirstUses)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
