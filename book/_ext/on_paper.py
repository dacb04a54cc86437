"""The book on paper and as EPUB: what Sphinx's builders ``singlehtml`` and ``epub`` write.

Nothing folds or moves there. Folded texts stand open. Folded code, which draws charts and imports
names, is left out, and so is what tells the hand what to do. The answers to the questions and the
solutions of the exercises become a chapter at the end. tools/print_book.py calls the builders, and
the first page of the website links to what they have made.
"""

import re
import shutil
from collections import Counter
from collections.abc import Iterator
from itertools import takewhile
from pathlib import Path
from string import Template
from typing import Any, ClassVar

from bundle import LIBRARIES
from docutils import nodes
from PIL import Image
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.builders.epub3 import Epub3Builder
from sphinx.builders.singlehtml import SingleFileHTMLBuilder
from sphinx.config import Config
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.transforms.post_transforms.images import ImageConverter
from sphinx.util.docutils import SphinxDirective, new_document
from sphinx.util.nodes import inline_all_toctrees
from sphinxcontrib import katex

import rotedu
from cells import (
    belongs_to_solution,
    caption_of,
    code_cells,
    exercise_of,
    is_dropdown,
    part_of_exercise,
)
from predictions import prediction

ON_PAPER = ("singlehtml", "epub")
SOLUTIONS = "book/solutions"
SOLUTIONS_TITLE = "Answers and solutions"
REFERENCE = "book/api/"
# What only works on a screen.
ON_SCREEN = {"page-head", "ways", "on-screen"}
LINK = re.compile(r"</?a\b[^>]*>")
UNANSWERED = "not answered yet."
# The end of a starter cell: an answer without a word on its form, and the call that judges it.
STUB = re.compile(r"\s*(^answer = [.,()\[\] ]+\n)?^check\(.*\)$", re.MULTILINE)
SENTENCES = re.compile(r"(?<=[.?])\s+")
# A cell that only shows a figure for later cells
FIGURE = "figure = explore("
HAND = re.compile(r"\b(click|drag(ged)?|grab(bed)?|open|press|pull)\b", re.IGNORECASE)
# What begins with an order to the hand
ORDER = re.compile(
    r"^(Drag|Press|Tip|Switch|Set the mirrors|Let t run|Try an arc|Turn a spoon"
    r"|You get there by hand)\b"
)
PAPER = Path(__file__).parents[1] / "_paper"
BUILD = Path(__file__).parents[2] / "_build"
FONTS = LIBRARIES / "@fontsource" / "source-serif-4" / "files"
EDITIONS = {"PDF": BUILD / "pdf" / "rotedu.pdf", "EPUB": BUILD / "epub" / "rotedu.epub"}


def name_of(prefix: str, number: str) -> str:
    """Return the name of a target: ``exercise-3-1``."""
    return f"{prefix}-{number.replace('.', '-')}"


def link(target: str, text: str, *content: nodes.Node) -> nodes.reference:
    """Make a link inside the book."""
    return nodes.reference("", text, *content, refuri=target, internal=True)


def opened(dropdown: nodes.Element) -> nodes.Element:
    """Return the content of a folded text, with its title above it."""
    title, *content = dropdown.children
    head = nodes.paragraph("", "", nodes.strong("", "", *title.children), classes=["opened-title"])
    return nodes.container("", head, *content, classes=["opened"])


def take_solutions(tree: nodes.Element, back: str, forth: str) -> list[nodes.section]:
    """Take the solutions out of a page, leave links to them, and return a section for each.

    Parameters
    ----------
    tree : Element
        The page.
    back, forth : str
        What the addresses of an exercise and of a solution begin with.
    """
    for paragraph in tree.findall(nodes.paragraph):
        if number := exercise_of(paragraph):
            paragraph["ids"].append(name_of("exercise", number))
    sections = []
    for cell in code_cells(tree):
        part, number = part_of_exercise(cell)
        if part == "solution":
            around, at = cell.parent, cell.parent.index(cell)
            reasons = list(takewhile(belongs_to_solution, around[at + 1 :]))
            around[at : at + 1 + len(reasons)] = [
                nodes.paragraph(
                    "",
                    "",
                    link(f"{forth}#{name_of('solution', number)}", f"Solution {number}"),
                    classes=["to-solution"],
                )
            ]
            del cell["hide_mode"]
            title = link(f"{back}#{name_of('exercise', number)}", f"Exercise {number}")
            sections.append(
                nodes.section(
                    "",
                    nodes.title("", "", title),
                    cell,
                    *reasons,
                    ids=[name_of("solution", number)],
                )
            )
    return sections


def take_answers(tree: nodes.Element, back: str, forth: str) -> list[nodes.section]:
    """Take the answers out of the questions of a page, as `take_solutions` does with solutions."""
    page = next(tree.findall(nodes.section))["ids"][0]
    sections = []
    for number, box in enumerate(tree.findall(prediction), start=1):
        title = next(box.findall(nodes.title)).astext()
        question = next(child for child in box if isinstance(child, nodes.paragraph))
        asked, answered = f"question-{page}-{number}", f"answer-{page}-{number}"
        repeated = question.deepcopy()
        question["ids"], repeated["ids"] = [asked], []
        choices = [child for child in box if is_dropdown(child)]
        for reference in (ref for c in choices for ref in c.findall(nodes.reference)):
            if "refid" in reference:
                reference["refuri"] = f"{back}#{reference.attributes.pop('refid')}"
        names = [choice[0].deepcopy().children for choice in choices]
        items = [nodes.list_item("", nodes.paragraph("", "", *name)) for name in names]
        answer = nodes.paragraph("", "", link(f"{forth}#{answered}", "Answer"))
        answer["classes"].append("to-solution")
        box.children = [child for child in box if child not in choices]
        box += [nodes.bullet_list("", *items), answer]
        heading = nodes.title("", "", link(f"{back}#{asked}", title))
        sections.append(nodes.section("", heading, repeated, *choices, ids=[answered]))
    return sections


def chapter_of_solutions(parts: Iterator[tuple[str, list[nodes.section]]]) -> nodes.section:
    """Make the chapter of the solutions, from the title and the solutions of each page."""
    chapter = nodes.section("", nodes.title("", SOLUTIONS_TITLE), ids=["solutions"])
    for title, sections in parts:
        if sections:
            name = f"solutions-{nodes.make_id(title)}"
            chapter += nodes.section("", nodes.title("", title), *sections, ids=[name])
    # What was on the same page as its target no longer is.
    for reference in chapter.findall(addnodes.pending_xref):
        reference["refdoc"] = SOLUTIONS
    return chapter


def title_page(config: Config) -> nodes.raw:
    """Return the page that says what the book is, who made it and what may be done with it."""
    page = Template((PAPER / "title-page.html").read_text(encoding="utf-8"))
    text = page.substitute(title=config.html_title, version=rotedu.__version__)
    return nodes.raw("", text, format="html")


def leave_out_stub(cell: nodes.Element) -> None:
    """Leave in a starter cell what is given, and what is said about the form of the answer."""
    code = next(cell.findall(nodes.literal_block))
    given = STUB.sub("", code.astext())
    if given:
        code.replace_self(nodes.literal_block(given, given, **code.attributes))
    else:
        cell.parent.remove(cell)


def mark_hand(paragraph: nodes.paragraph, words: re.Pattern[str]) -> None:
    """Mark the sentences that tell the hand what to do: they are for the screen alone."""
    sentences: list[list[nodes.Node]] = [[]]
    for child in paragraph.children:
        texts = SENTENCES.split(child) if isinstance(child, nodes.Text) else []
        first, *others = map(nodes.Text, texts) if texts else [child]
        sentences[-1].append(first)
        sentences += [[text] for text in others]
        if isinstance(child, nodes.strong):
            sentences.append([])
    paragraph.children = []
    for sentence in sentences:
        text = "".join(part.astext() for part in sentence)
        content = [*sentence, nodes.Text(" ")]
        for_hand = words.search(text.strip())
        paragraph += nodes.inline("", "", *content, classes=["on-screen"]) if for_hand else content


class PaperBuilder(SingleFileHTMLBuilder):
    """Puts the whole book into one page: title, contents, chapters, solutions."""

    def init(self) -> None:
        """Take the styles for paper."""
        fonts = FONTS.glob("source-serif-4-latin-[46]00-*.woff2")
        own = [str(file) for file in (PAPER / "paper.css", *fonts)]
        self.config.html_static_path = [*self.config.html_static_path, *own]
        self.config.html_js_files = []
        self.config.html_permalinks = False
        super().init()
        self.add_css_file("paper.css", priority=900)

    def get_outfilename(self, pagename: str) -> str:
        """Put the page where Sphinx believes that it is: its addresses begin there."""
        return str(Path(self.outdir, "index.html"))

    def copy_download_files(self) -> None:
        """Copy nothing: on paper there are no downloads."""

    def assemble_doctree(self) -> nodes.document:
        """Put the pages one after another, and make links between them links inside the page."""
        root = self.config.root_doc
        first = self.env.get_doctree(root)
        parts = list(first.findall(addnodes.toctree))
        tree = inline_all_toctrees(self, set(), root, first, str, [root])
        tree["docname"] = root
        pages = []
        for page in list(tree.findall(addnodes.start_of_file)):
            page.parent.remove(page)
            # The modules are sections of one chapter.
            if page["docname"].startswith(REFERENCE):
                next(pages[-1].findall(nodes.section)).append(page)
            else:
                pages.append(page)
        solutions = chapter_of_solutions(
            (
                self.env.titles[page["docname"]].astext(),
                [*take_answers(page, "", ""), *take_solutions(page, "", "")],
            )
            for page in pages
        )
        contents = nodes.section("", nodes.title("", "Contents"), ids=["contents"])
        tree[:0] = [title_page(self.config), contents]
        tree += [*pages, addnodes.start_of_file("", solutions, docname=SOLUTIONS)]
        self.env.resolve_references(tree, root, self)
        make_names_unique(tree)
        captions = {part["includefiles"][0]: part["caption"] for part in parts}
        contents += list_of_contents(tree, captions)
        return tree


def make_names_unique(tree: nodes.document) -> None:
    """Rename what has the same name on several pages, and mend the links between the pages."""
    pages = {page["docname"]: page for page in tree.findall(addnodes.start_of_file)}
    named = {
        docname: [node for node in page.findall(nodes.Element) if node["ids"]]
        for docname, page in pages.items()
    }
    uses = Counter(
        name for page in named.values() for name in {i for node in page for i in node["ids"]}
    )

    def unique(docname: str, name: str) -> str:
        return f"{Path(docname).name}-{name}" if uses[name] > 1 else name

    for docname, page in pages.items():
        for node in named[docname]:
            node["ids"] = [unique(docname, name) for name in node["ids"]]
        for reference in page.findall(nodes.reference):
            if "refid" in reference:
                reference["refid"] = unique(docname, reference["refid"])
    for reference in tree.findall(nodes.reference):
        page, _, name = reference.get("refuri", "").removeprefix("#document-").partition("#")
        if page in pages:
            first = next(pages[page].findall(nodes.section))["ids"][0]
            reference["refuri"] = f"#{unique(page, name) if name else first}"


def list_of_contents(tree: nodes.document, captions: dict[str, str]) -> list[nodes.Element]:
    """List the pages and their sections; print_book.py adds the numbers of the pages."""
    entries: list[nodes.Element] = []
    for page in tree.findall(addnodes.start_of_file):
        if caption := captions.get(page["docname"]):
            entries.append(nodes.paragraph("", caption, classes=["contents-part"]))
        chapter = next(page.findall(nodes.section))
        sections = [node for node in chapter if isinstance(node, nodes.section)]
        top = 2 if page["docname"].startswith(REFERENCE) else 1
        for level, section in [(top, chapter), *((2, section) for section in sections)]:
            words = (child.deepcopy() for child in section[0].children)
            entry = link(f"#{section['ids'][0]}", "", *words)
            entries.append(nodes.paragraph("", "", entry, classes=[f"contents-{level}"]))
    return entries


class EbookBuilder(Epub3Builder):
    """Writes an EPUB that epubcheck accepts."""

    def init(self) -> None:
        """Leave out what only the website needs."""
        katex.KATEX_DEFAULT_OPTIONS["output"] = "mathml"
        self.config.html_static_path = [str(PAPER / "ebook.css")]
        self.config.html_js_files = []
        self.config.html_favicon = self.config.html_logo = None
        self.config.templates_path = []
        super().init()

    def copy_theme_static_files(self, context: dict[str, Any]) -> None:
        """Copy nothing of the theme."""

    def copy_translation_js(self) -> None:
        """Copy no script."""

    def copy_image_files(self) -> None:
        """Copy the pictures, without the type that Matplotlib declares: EPUB allows none."""
        super().copy_image_files()
        for chart in Path(self.outdir, self.imagedir).glob("*.svg"):
            text = re.sub(r"<!DOCTYPE[^>]*>", "", chart.read_text(encoding="utf-8"))
            chart.write_text(text, encoding="utf-8")

    def toc_metadata(self, level: int, navpoints: list[Any]) -> dict[str, Any]:
        """Name the book in both tables of contents by the same identifier."""
        return super().toc_metadata(level, navpoints) | {"uid": self.config.epub_identifier}

    def build_content(self) -> None:
        """Tell readers which pages have formulas and drawings, as EPUB demands."""
        # A role that Docutils gives and ARIA has withdrawn
        references = Path(self.outdir, "book", "references.xhtml")
        text = references.read_text(encoding="utf-8").replace(' role="doc-biblioentry"', "")
        references.write_text(text, encoding="utf-8")
        super().build_content()
        package = Path(self.outdir, "content.opf")

        def with_properties(item: re.Match[str]) -> str:
            page = Path(self.outdir, item[1]).read_text(encoding="utf-8")
            found = [name for tag, name in (("<math", "mathml"), ("<svg", "svg")) if tag in page]
            return f'{item[0]} properties="{" ".join(found)}"' if found else item[0]

        item = r'href="([^"]+\.xhtml)" media-type="application/xhtml\+xml"(?! properties)'
        text = re.sub(item, with_properties, package.read_text(encoding="utf-8"))
        package.write_text(text, encoding="utf-8")


class MarkHand(SphinxPostTransform):
    """Mark what tells the hand what to do, in captions and in the text of notebooks."""

    default_priority = 0

    def run(self, **_: Any) -> None:
        """Mark sentences; a page for teachers says what to do in front of the class."""
        for paragraph in list(self.document.findall(nodes.paragraph)):
            words = HAND if caption_of(paragraph) else ORDER
            if words is ORDER and not str(paragraph.source).endswith(".ipynb"):
                continue
            if any(words.search(text) for text in SENTENCES.split(paragraph.astext())):
                mark_hand(paragraph, words)


class UnfoldForPaper(SphinxPostTransform):
    """Open what is folded, and leave out what only works on a screen."""

    # Before MyST-NB chooses outputs and all other steps look at what is there.
    default_priority = 1
    builders = ON_PAPER

    def run(self, **_: Any) -> None:
        """Treat a page, or the whole book."""
        if self.app.builder.name == "epub" and self.env.docname != SOLUTIONS:
            here = self.env.docname
            forth = self.app.builder.get_relative_uri(here, SOLUTIONS)
            take_answers(self.document, "", forth)
            take_solutions(self.document, "", forth)
            if here == self.config.root_doc:
                self.document.insert(0, title_page(self.config))
        for node in list(self.document.findall(nodes.Element)):
            if ON_SCREEN.intersection(node.get("classes", ())):
                node.parent.remove(node)
        for dropdown in list(self.document.findall(is_dropdown)):
            dropdown.replace_self(opened(dropdown))
        for cell in code_cells(self.document):
            hidden = cell.attributes.pop("hide_mode", None)
            if hidden in ("input", "input+output") or cell.astext().startswith(FIGURE):
                cell.remove(cell[0])
            elif cell.astext().endswith(UNANSWERED):
                cell.remove(cell[-1])
                leave_out_stub(cell)
        for drawing in list(self.document.findall(nodes.raw)):
            # The map leads to pages of the website; without its links it is a picture.
            picture = LINK.sub("", drawing.astext()).replace('role="group"', 'role="img"')
            drawing.replace_self(nodes.raw("", picture, format="html"))
        for paragraph in list(self.document.findall(nodes.paragraph)):
            # Sphinx puts lists of exceptions into paragraphs, where EPUB allows none.
            if any(isinstance(child, nodes.bullet_list) for child in paragraph):
                paragraph.replace_self(paragraph.children)


class PostersAsJPEG(ImageConverter):
    """Converts posters to a format that a PDF stores as it is and every EPUB reader knows."""

    conversion_rules: ClassVar[list[tuple[str, str]]] = [("image/webp", "image/jpeg")]

    def match(self, node: nodes.image) -> bool:
        """Leave the lighter pictures of the website alone."""
        return self.app.builder.name in ON_PAPER and super().match(node)

    def is_available(self) -> bool:
        """Say yes: Pillow is there."""
        return True

    def convert(self, _from: str, _to: str) -> bool:
        """Convert a picture."""
        poster = Image.open(_from).convert("RGBA")
        paper = Image.new("RGBA", poster.size, "white")
        Image.alpha_composite(paper, poster).convert("RGB").save(_to, quality=90)
        return True


def write_solutions(app: Sphinx) -> Iterator[tuple[str, dict[str, Any], str]]:
    """Add the chapter of the solutions to the EPUB."""
    builder, env = app.builder, app.env
    if builder.name != "epub":
        return

    def parts() -> Iterator[tuple[str, list[nodes.section]]]:
        for docname in env.toctree_includes[app.config.root_doc]:
            back = builder.get_relative_uri(SOLUTIONS, docname)
            page = env.get_doctree(docname)
            sections = [*take_answers(page, back, ""), *take_solutions(page, back, "")]
            yield env.titles[docname].astext(), sections

    document = new_document(SOLUTIONS)
    document += chapter_of_solutions(parts())
    env.resolve_references(document, SOLUTIONS, builder)
    builder.post_process_images(document)
    body = builder.render_partial(document[0])["fragment"]
    yield SOLUTIONS, {"title": SOLUTIONS_TITLE, "body": body}, "page.html"


def keep_own_styles(
    app: Sphinx, pagename: str, template: str, context: dict[str, Any], doctree: Any
) -> None:
    """Link an EPUB's pages to the book's styles alone: the others are not in it."""
    if app.builder.name == "epub":
        context["css_files"] = ["_static/pygments.css", "_static/ebook.css"]
        context["script_files"] = []


class editions(nodes.Element):  # noqa: N801 (docutils names nodes so)
    """The place of the links to PDF and EPUB."""


class Editions(SphinxDirective):
    """Links to PDF and EPUB, on the website, where they were built."""

    def run(self) -> list[nodes.Node]:
        """Note the place."""
        return [editions()]


class LinkEditions(SphinxPostTransform):
    """Write the links."""

    default_priority = 1

    def run(self, **_: Any) -> None:
        """Link what there is, with its size."""
        for place in list(self.document.findall(editions)):
            links = nodes.paragraph("", "To print, or to read away from the web: ")
            for name in self.config.editions:
                size = f" ({EDITIONS[name].stat().st_size / 1e6:.1f} MB)"
                reference = nodes.reference("", name, refuri=f"../{EDITIONS[name].name}")
                links += [nodes.Text(", " if len(links) > 1 else ""), reference, nodes.Text(size)]
            links += nodes.Text(".")
            website = self.app.builder.name == "html" and self.config.editions
            place.replace_self([links] if website else [])


def note_editions(app: Sphinx, config: Config) -> None:
    """Note which editions there are, and the version, which an EPUB must have."""
    config.editions = [name for name, file in EDITIONS.items() if file.is_file()]
    config.version = rotedu.__version__


def copy_editions(app: Sphinx, exception: Exception | None) -> None:
    """Put the editions into the website."""
    if app.builder.name == "html" and not exception:
        for name in app.config.editions:
            shutil.copy(EDITIONS[name], app.outdir)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register builders, steps and the directive."""
    app.setup_extension("sphinx.builders.singlehtml")
    app.setup_extension("sphinx.builders.epub3")
    app.add_builder(PaperBuilder, override=True)
    app.add_builder(EbookBuilder, override=True)
    app.add_config_value("editions", [], "html")
    app.add_directive("editions", Editions)
    app.add_node(editions)
    app.add_post_transform(MarkHand)
    app.add_post_transform(UnfoldForPaper)
    app.add_post_transform(PostersAsJPEG)
    app.add_post_transform(LinkEditions)
    app.connect("config-inited", note_editions)
    app.connect("html-collect-pages", write_solutions)
    app.connect("html-page-context", keep_own_styles)
    app.connect("build-finished", copy_editions)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
