"""Running text: coloured words, what stays on one line, what links to the glossary or the margin.

A word in a colour of the book is written as a formula, which JupyterLab can show, but is text.

Browsers may break a line after any formula, as after a picture, and no character prevents it, so a
formula and its comma or brackets, (4-1), 5-b and 18 + 12 are put together. The first use of each
term on a page leads to its explanation without markup, which JupyterLab would show as plain text.
In the margin stand the errata that a paragraph speaks of, so that they are found by leafing.
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

from rotedu.colors import AXIS, CROSS, RESULT, VECTOR, WRONG

MEANINGS = {"vector": VECTOR, "axis": AXIS, "result": RESULT, "cross": CROSS, "wrong": WRONG}
WORDS = re.compile(rf"\\({'|'.join(MEANINGS)})\{{\\text\{{([^{{}}$\\]+)\}}\}}")
OPENING = re.compile(r"[(\N{LEFT DOUBLE QUOTATION MARK}]+$")
MARKS = re.compile(r"[.,;:!?)\N{RIGHT DOUBLE QUOTATION MARK}]+")
UNSEEN = re.compile(r"\\textcolor\{[^}]*\}|\\[A-Za-z]+|[\\{}^_\s]")
# Numbers of equations and of pictures, counts of operations, shapes.
NUMBERS = re.compile(r"(\(\d-\d+\)|\b[\dA-Z]-[a-z]\b|(?<![\d.])\d+ [+×] \d+(?!\.?\d))")
AROUND = (
    *(nodes.paragraph, nodes.caption, nodes.emphasis, nodes.strong),
    *(nodes.inline, nodes.reference),
)
# On a phone, a longer formula must be able to break.
SHORT = 16

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

# A screen reader has met the link itself.
NOTE = '<span class="in-margin" aria-hidden="true">{}</span>'


class coloured(nodes.Element):  # noqa: N801 (docutils names nodes so)
    """Words in a colour."""


class ColourWords(SphinxPostTransform):
    """Replace formulas that are words in a colour."""

    default_priority = 4

    def run(self, **_: Any) -> None:
        """Find them."""
        for formula in list(self.document.findall(nodes.math)):
            if found := WORDS.fullmatch(formula.astext()):
                macro, words = found.groups()
                words = words.replace("'", "\N{RIGHT SINGLE QUOTATION MARK}")
                formula.replace_self(coloured("", nodes.Text(words), colour=MEANINGS[macro]))


def visit_coloured(writer: Any, node: coloured) -> None:
    """Open an element with its colour, which book.css adapts to the page's."""
    writer.body.append(writer.starttag(node, "span", "", style=f"color:{node['colour']}"))


def depart_coloured(writer: Any, node: coloured) -> None:
    """Close it."""
    writer.body.append("</span>")


def unbroken(*content: nodes.Node) -> nodes.inline:
    """Make an element that does not break."""
    return nodes.inline("", "", *content, classes=["unbroken"])


class KeepTogether(SphinxPostTransform):
    """Put what belongs together into one element."""

    default_priority = 5

    def run(self, **_: Any) -> None:
        """Treat the numbers in all texts, and the marks around each formula."""
        for text in list(self.document.findall(nodes.Text)):
            if not isinstance(text.parent, AROUND):
                continue
            # Every second part is a match of the pattern.
            parts = [nodes.Text(part) for part in NUMBERS.split(text)]
            parts[1::2] = map(unbroken, parts[1::2])
            if len(parts) > 1:
                text.parent.replace(text, parts)
        for formula in list(self.document.findall(nodes.math)):
            around = formula.parent
            at = around.index(formula)
            before, after = around[max(at - 1, 0)], around[min(at + 1, len(around) - 1)]
            opening = isinstance(before, nodes.Text) and OPENING.search(before)
            marks = isinstance(after, nodes.Text) and MARKS.match(after)
            if not (opening or marks) or len(UNSEEN.sub("", formula.astext())) > SHORT:
                continue
            whole = [formula.deepcopy()]
            if opening:
                whole.insert(0, nodes.Text(opening[0]))
                around[at - 1] = nodes.Text(before[: opening.start()])
            if marks:
                whole.append(nodes.Text(marks[0]))
                around[at + 1] = nodes.Text(after[marks.end() :])
            around[at] = unbroken(*whole)


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
        if isinstance(node, (*NOT_PROSE, coloured)):
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


class InMargin(SphinxPostTransform):
    """Add the numbers, once links know where they lead; book.css says where there is a margin."""

    # After all that looks at how a paragraph begins.
    default_priority = 900
    formats = ("html",)

    def run(self, **_: Any) -> None:
        """Treat the paragraphs that stand beside the margin."""
        for paragraph in self.document.findall(nodes.paragraph):
            links = paragraph.findall(nodes.reference)
            found = [link.astext() for link in links if "#erratum-" in link.get("refuri", "")]
            if found and isinstance(paragraph.parent, nodes.section):
                paragraph.insert(0, nodes.raw("", NOTE.format(" ".join(found)), format="html"))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the steps; what stays together is put together before words become links."""
    app.add_node(coloured, html=(visit_coloured, depart_coloured))
    for step in (ColourWords, KeepTogether, LinkFirstUses, InMargin):
        app.add_post_transform(step)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
