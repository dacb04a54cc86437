"""The book on paper and as EPUB: what Sphinx's builders ``singlehtml`` and ``epub`` write.

Nothing folds or moves there. Folded texts stand open. Folded code, which draws charts and imports
names, is left out, and so is what a text marks ``<span class="on-screen">``, which no notebook
shows. The answers to the questions and the solutions of the exercises become a chapter at the end.
tools/print_book.py calls the builders, and the first page of the website links to what they make.
"""

import re
import shutil
from collections.abc import Iterator
from itertools import takewhile
from pathlib import Path
from string import Template
from typing import Any

from bundle import LIBRARIES
from docutils import nodes
from PIL import Image
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.builders.epub3 import Epub3Builder
from sphinx.builders.singlehtml import SingleFileHTMLBuilder
from sphinx.config import Config
from sphinx.transforms import SphinxTransform
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.transforms.post_transforms.images import ImageConverter
from sphinx.util.docutils import new_document
from sphinx.util.nodes import inline_all_toctrees
from sphinxcontrib import katex

import rotedu
from cells import belongs_to_solution, code_cells, exercise_of, is_dropdown, part_of_exercise
from predictions import prediction

SOLUTIONS = "book/solutions"
SOLUTIONS_TITLE = "Answers and solutions"
REFERENCE = "book/api/"
MARK, END = '<span class="on-screen">', "</span>"
# What only works on a screen.
ON_SCREEN = {"page-head", "ways", "on-screen"}
# Of the EPUB
STYLES = ("still.css", "ebook.css")
LINK = re.compile(r"</?a\b[^>]*>")
UNANSWERED = "not answered yet."
# The end of a starter cell: an answer without a word on its form, and the call that judges it.
STUB = re.compile(
    r"\s*(^answer = [.,()\[\] ]+\n)?(^if check\(.*\n.*\n)?^check\(.*\)$", re.MULTILINE
)
# A cell that only shows a figure for later cells
FIGURE = "figure = explore("
PAPER = Path(__file__).parents[1] / "_paper"
BUILD = Path(__file__).parents[2] / "_build"
FONTS = LIBRARIES / "@fontsource"
# Where the first page links to them
PLACE = "<!-- editions -->"
LINKED = '<a class="reference external" href="../{}">{}</a> ({:.1f} MB)'
EDITIONS = {"PDF": BUILD / "pdf" / "rotedu.pdf", "EPUB": BUILD / "epub" / "rotedu.epub"}

Sections = list[nodes.Element]


def link(target: str, *content: nodes.Node) -> nodes.reference:
    """Make a link inside the book."""
    return nodes.reference("", "", *content, refuri=target, internal=True)


def pointer(target: str, text: str) -> nodes.paragraph:
    """Make a line that leads to an answer or a solution."""
    return nodes.paragraph("", "", link(target, nodes.Text(text)), classes=["to-solution"])


def section(name: str, title: nodes.Node, *content: nodes.Node) -> nodes.section:
    """Make a section that links can name."""
    return nodes.section("", nodes.title("", "", title), *content, ids=[name])


def take_solutions(tree: nodes.Element, back: str, forth: str) -> Sections:
    """Take the solutions out of a page, leave links to them, and return a section for each.

    What the addresses of an exercise and of a solution begin with is ``back`` and ``forth``.
    """
    for paragraph in tree.findall(nodes.paragraph):
        if number := exercise_of(paragraph):
            paragraph["ids"].append(f"exercise-{number.replace('.', '-')}")
    sections: Sections = []
    for cell in code_cells(tree):
        part, number = part_of_exercise(cell)
        if part == "solution":
            name, around, at = number.replace(".", "-"), cell.parent, cell.parent.index(cell)
            del cell["hide_mode"]
            solution = [cell, *takewhile(belongs_to_solution, around[at + 1 :])]
            line = pointer(f"{forth}#solution-{name}", f"Solution {number}")
            around[at : at + len(solution)] = [line]
            title = link(f"{back}#exercise-{name}", nodes.Text(f"Exercise {number}"))
            sections.append(section(f"solution-{name}", title, *solution))
    return sections


def take_answers(tree: nodes.Element, back: str, forth: str) -> Sections:
    """Take the answers out of the questions of a page, as `take_solutions` does with solutions."""
    page = next(tree.findall(nodes.section))["ids"][0]
    sections: Sections = []
    for number, box in enumerate(tree.findall(prediction), start=1):
        name = f"{page}-{number}"
        question = next(child for child in box if isinstance(child, nodes.paragraph))
        repeated = question.deepcopy()
        question["ids"], repeated["ids"] = [f"question-{name}"], []
        choices = [child for child in box if is_dropdown(child)]
        for reference in (ref for choice in choices for ref in choice.findall(nodes.reference)):
            if "refid" in reference:
                reference["refuri"] = f"{back}#{reference.attributes.pop('refid')}"
        names = (nodes.paragraph("", "", *choice[0].deepcopy().children) for choice in choices)
        items = [nodes.list_item("", name) for name in names]
        box.children = [child for child in box if child not in choices]
        box += [nodes.bullet_list("", *items), pointer(f"{forth}#answer-{name}", "Answer")]
        title = link(f"{back}#question-{name}", nodes.Text(box.next_node(nodes.title).astext()))
        sections.append(section(f"answer-{name}", title, repeated, *choices))
    return sections


def taken(tree: nodes.Element, back: str, forth: str) -> Sections:
    """Take answers and solutions out of a page."""
    return [*take_answers(tree, back, forth), *take_solutions(tree, back, forth)]


def chapter_of_solutions(parts: Iterator[tuple[str, Sections]]) -> nodes.section:
    """Make the chapter of the solutions, from the title and the solutions of each page."""
    chapter = section("solutions", nodes.Text(SOLUTIONS_TITLE))
    for title, sections in parts:
        if sections:
            chapter += section(f"solutions-{nodes.make_id(title)}", nodes.Text(title), *sections)
    # What was on the same page as its target no longer is.
    for reference in chapter.findall(addnodes.pending_xref):
        reference["refdoc"] = SOLUTIONS
    return chapter


def title_page(config: Config) -> nodes.raw:
    """Return the page that says what the book is, who made it and what may be done with it."""
    page = Template((PAPER / "title-page.html").read_text(encoding="utf-8"))
    told = {"title": config.html_title, "version": rotedu.__version__}
    text = page.substitute(told, figures=config.myst_substitutions["figures"])
    return nodes.raw("", text, format="html")


class PaperBuilder(SingleFileHTMLBuilder):
    """Puts the whole book into one page: title, contents, chapters, solutions."""

    def init(self) -> None:
        """Take the styles for paper."""
        # A tagged PDF cannot hold the MathML beside each formula.
        katex.KATEX_DEFAULT_OPTIONS["output"] = "html"
        fonts = FONTS.glob("*/files/source-*-latin-[46]00-*.woff2")
        own = [str(file) for file in (*PAPER.glob("*.css"), *fonts)]
        self.config.html_static_path = [*self.config.html_static_path, *own]
        self.config.html_js_files = []
        self.config.html_permalinks = False
        super().init()
        for styles in ("still.css", "paper.css"):
            self.add_css_file(styles, priority=900)

    def get_outfilename(self, pagename: str) -> str:
        """Put the page where Sphinx believes that it is: its addresses begin there."""
        return str(Path(self.outdir, "index.html"))

    def assemble_doctree(self) -> nodes.document:
        """Put the pages one after another, and make links between them links inside the page."""
        root = self.config.root_doc
        first = self.env.get_doctree(root)
        parts = list(first.findall(addnodes.toctree))
        tree = inline_all_toctrees(self, set(), root, first, str, [root])
        tree["docname"] = root
        pages: list[nodes.Element] = []
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
                taken(page, f"#document-{page['docname']}", f"#document-{SOLUTIONS}"),
            )
            for page in pages
        )
        tree.insert(0, title_page(self.config))
        tree += [*pages, addnodes.start_of_file("", solutions, docname=SOLUTIONS)]
        self.env.resolve_references(tree, root, self)
        name_pages(tree)
        captions = {part["includefiles"][0]: part["caption"] for part in parts}
        contents = section("contents", nodes.Text("Contents"), *entries(tree, captions))
        tree.insert(1, contents)
        return tree


def name_pages(tree: nodes.document) -> None:
    """Put the name of its page before each name, and mend the links between the pages."""
    pages = {page["docname"]: page for page in tree.findall(addnodes.start_of_file)}
    first = {}
    for docname, page in pages.items():
        for node in page.findall(nodes.Element):
            node["ids"] = [f"{Path(docname).name}-{name}" for name in node.get("ids", ())]
            if "refid" in node:
                node["refid"] = f"{Path(docname).name}-{node['refid']}"
            # A reference lists who cites it, and nobody sees the list.
            node["backrefs"] = []
        first[docname] = next(page.findall(nodes.section))["ids"][0]
    for reference in tree.findall(nodes.reference):
        docname, _, name = reference.get("refuri", "").removeprefix("#document-").partition("#")
        if docname in pages:
            reference["refuri"] = f"#{Path(docname).name}-{name}" if name else f"#{first[docname]}"


def entries(tree: nodes.document, captions: dict[str, str]) -> Iterator[nodes.paragraph]:
    """List the pages and their sections; print_book.py adds the numbers of the pages."""
    for page in tree.findall(addnodes.start_of_file):
        if caption := captions.get(page["docname"]):
            yield nodes.paragraph("", caption, classes=["contents-part"])
        chapter = next(page.findall(nodes.section))
        top = 2 if page["docname"].startswith(REFERENCE) else 1
        for part in (chapter, *(node for node in chapter if isinstance(node, nodes.section))):
            entry = link(f"#{part['ids'][0]}", *(child.deepcopy() for child in part[0].children))
            level = top if part is chapter else 2
            yield nodes.paragraph("", "", entry, classes=[f"contents-{level}"])


class EbookBuilder(Epub3Builder):
    """Writes an EPUB that epubcheck accepts."""

    def init(self) -> None:
        """Leave out what only the website needs."""
        katex.KATEX_DEFAULT_OPTIONS["output"] = "mathml"
        self.config.templates_path = []
        super().init()

    def copy_static_files(self) -> None:
        """Copy the book's own styles, and nothing of theme and extensions."""
        static = Path(self.outdir, "_static")
        static.mkdir(exist_ok=True)
        self.create_pygments_style_file()
        for name in STYLES:
            shutil.copy(PAPER / name, static)

    def toc_metadata(self, level: int, navpoints: list[Any]) -> dict[str, Any]:
        """Name the book in both tables of contents by the same identifier."""
        return super().toc_metadata(level, navpoints) | {"uid": self.config.epub_identifier}

    def build_content(self) -> None:
        """Tell readers which pages have formulas and drawings, as EPUB demands."""
        super().build_content()
        package = Path(self.outdir, "content.opf")

        def with_properties(item: re.Match[str]) -> str:
            page = Path(self.outdir, item[1]).read_text(encoding="utf-8")
            found = [name for tag, name in (("<math", "mathml"), ("<svg", "svg")) if tag in page]
            return f'{item[0]} properties="{" ".join(found)}"' if found else item[0]

        item = r'href="([^"]+\.xhtml)" media-type="application/xhtml\+xml"(?! properties)'
        text = re.sub(item, with_properties, package.read_text(encoding="utf-8"))
        package.write_text(text, encoding="utf-8")


class MarkScreen(SphinxTransform):
    """Make an element of what stands between the marks of what is for the screen alone."""

    default_priority = 400

    def apply(self, **_: Any) -> None:
        """Find the marks, which MyST hands on as they are."""
        for mark in [raw for raw in self.document.findall(nodes.raw) if raw.astext() == MARK]:
            around, at = mark.parent, mark.parent.index(mark)
            marked = list(takewhile(lambda node: node.astext() != END, around[at + 1 :]))
            element = nodes.inline("", "", *marked, classes=["on-screen"])
            around[at : at + len(marked) + 2] = [element]


class UnfoldForPaper(SphinxPostTransform):
    """Open what is folded, and leave out what only works on a screen."""

    # Before MyST-NB chooses outputs and all other steps look at what is there.
    default_priority = 1
    builders = ("singlehtml", "epub")

    def run(self, **_: Any) -> None:
        """Treat a page, or the whole book."""
        here = self.env.docname
        if self.app.builder.name == "epub" and here != SOLUTIONS:
            taken(self.document, "", self.app.builder.get_relative_uri(here, SOLUTIONS))
            if here == self.config.root_doc:
                self.document.insert(0, title_page(self.config))
        for node in list(self.document.findall(nodes.Element)):
            if ON_SCREEN.intersection(node.get("classes", ())):
                node.parent.remove(node)
        for dropdown in list(self.document.findall(is_dropdown)):
            title, *content = dropdown.children
            head = nodes.paragraph("", "", nodes.strong("", "", *title.children))
            head["classes"] = ["opened-title"]
            dropdown.replace_self(
                nodes.container(
                    "", head, *content, classes=["opened", *dropdown["container_classes"]]
                )
            )
        for cell in code_cells(self.document):
            leave_out_code(cell)
        for drawing in list(self.document.findall(nodes.raw)):
            # The map leads to pages of the website; without its links it is a picture.
            picture = LINK.sub("", drawing.astext()).replace('role="group"', 'role="img"')
            drawing.replace_self(nodes.raw("", picture, format="html"))
        for paragraph in list(self.document.findall(nodes.paragraph)):
            # Sphinx puts lists of exceptions into paragraphs, where EPUB allows none.
            if any(isinstance(child, nodes.bullet_list) for child in paragraph):
                paragraph.replace_self(paragraph.children)


def leave_out_code(cell: nodes.Element) -> None:
    """Leave in a cell what a reader of paper can use, as what is given for an answer."""
    hidden = cell.attributes.pop("hide_mode", None)
    if hidden in ("input", "input+output") or cell.astext().startswith(FIGURE):
        cell.remove(cell[0])
    elif cell.astext().endswith(UNANSWERED):
        code = next(cell.findall(nodes.literal_block))
        given = STUB.sub("", code.astext())
        code.replace_self(nodes.literal_block(given, given, **code.attributes))
        cell.remove(cell[-1])
        if not given:
            cell.parent.remove(cell)


class PostersAsJPEG(ImageConverter):
    """Converts posters to a format that a PDF stores as it is and every EPUB reader knows."""

    conversion_rules = [("image/webp", "image/jpeg")]  # noqa: RUF012

    def match(self, node: nodes.image) -> bool:
        """Leave the lighter pictures of the website alone."""
        return self.app.builder.name in UnfoldForPaper.builders and super().match(node)

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
    if not isinstance(builder, Epub3Builder):
        return
    chapter = chapter_of_solutions(
        (
            env.titles[name].astext(),
            taken(env.get_doctree(name), builder.get_relative_uri(SOLUTIONS, name), ""),
        )
        for name in env.toctree_includes[app.config.root_doc]
    )
    document = new_document(SOLUTIONS)
    document += chapter
    env.resolve_references(document, SOLUTIONS, builder)
    builder.post_process_images(document)
    body = builder.render_partial(document[0])["fragment"]
    yield SOLUTIONS, {"title": SOLUTIONS_TITLE, "body": body}, "page.html"


def write_for_readers(app: Sphinx, _page: str, _template: str, context: Any, _tree: Any) -> None:
    """Link an EPUB's pages to the book's styles alone: the others are not in it."""
    if app.builder.name == "epub":
        context["css_files"] = [f"_static/{name}" for name in ("pygments.css", *STYLES)]
        context["script_files"] = []
        # A role that Docutils gives and ARIA has withdrawn
        context["body"] = context.get("body", "").replace(' role="doc-biblioentry"', "")


def note_editions(app: Sphinx, config: Config) -> None:
    """Note which editions there are, and the version, which an EPUB must have."""
    config.editions = [name for name, file in EDITIONS.items() if file.is_file()]
    config.version = rotedu.__version__


def link_editions(app: Sphinx, _page: str, _template: str, context: Any, _tree: Any) -> None:
    """Link what there is, with its size, where a page of the website marks the place."""
    if app.builder.name == "html" and PLACE in context.get("body", ""):
        sizes = {name: EDITIONS[name].stat().st_size / 1e6 for name in app.config.editions}
        links = [LINKED.format(EDITIONS[name].name, name, size) for name, size in sizes.items()]
        said = f"<p>To print, or to read away from the web: {', '.join(links)}.</p>"
        context["body"] = context["body"].replace(PLACE, said if links else "")


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
    app.add_transform(MarkScreen)
    app.add_post_transform(UnfoldForPaper)
    app.add_post_transform(PostersAsJPEG)
    app.connect("config-inited", note_editions)
    app.connect("html-collect-pages", write_solutions)
    app.connect("html-page-context", write_for_readers)
    app.connect("html-page-context", link_editions)
    app.connect("build-finished", copy_editions)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
