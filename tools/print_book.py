"""Build the book as a PDF or as an EPUB: ``print_book.py pdf`` or ``print_book.py epub``.

book/_ext/on_paper.py decides what stands in them. Notebooks whose results are stored do not run
again. Chromium prints the PDF twice: the first print tells on which pages the chapters begin, the
second one has these numbers in its contents.
"""

import logging
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from browser import launch
from lock import ROOT, hold_checkout
from pypdf import PdfReader, PdfWriter
from pypdf.generic import NameObject, TextStringObject

import rotedu

BUILD = ROOT / "_build"
PDF = BUILD / "pdf" / "rotedu.pdf"
BUILDERS = {"pdf": "singlehtml", "epub": "epub"}
PRINT = {
    "path": PDF,
    "outline": True,
    "tagged": True,
    "prefer_css_page_size": True,
    "print_background": True,
}

# A chapter's title runs along the top of its pages.
RUNNING_TITLES = """() => [...document.querySelectorAll("article h1")].map((title, i) => {
    const name = `chapter-${i}`, text = JSON.stringify(title.textContent);
    title.parentElement.style.page = name;
    return `@page ${name} { @top-right { content: ${text} } }`;
}).join("\\n")"""

# The website hides these signs from those who listen, for whom MathML stands beside them.
SHOW_FORMULAS = """() => document.querySelectorAll(".katex-html").forEach(
    formula => formula.removeAttribute("aria-hidden"))"""

# Chromium makes no target of some of the signatures of functions, but of a text in them it does.
NAME_SIGNATURES = """() => document.querySelectorAll("dt.sig[id]").forEach(signature => {
    signature.querySelector(".descname").id = signature.id;
    signature.removeAttribute("id");
})"""

# Formulas end with spaces of no width.
TITLES = """() => [...document.querySelectorAll("article :is(h1, h2, h3, h4, h5, h6)")].map(
    title => title.textContent.replaceAll("\\u200b", ""))"""

NUMBER_CONTENTS = """pages => document.querySelectorAll("#contents a").forEach(link => {
    const number = document.createElement("span");
    number.className = "page-number";
    number.textContent = pages[decodeURIComponent(link.hash.slice(1))];
    link.append(number);
})"""


def build(edition: str) -> None:
    """Build the pages anew, and treat every warning as an error."""
    builder = BUILDERS[edition]
    hold_checkout()
    shutil.rmtree(BUILD / builder, ignore_errors=True)
    jupyter_book = Path(sys.executable).with_name("jupyter-book")
    options = ["-W", "--keep-going", "--builder", "custom", "--custom-builder", builder]
    subprocess.run([jupyter_book, "build", ROOT, *options], cwd=ROOT, check=True)


def starts(pdf: Path) -> dict[str, int]:
    """Return the number of the page on which each target of a link stands."""
    reader = PdfReader(pdf)
    targets = reader.named_destinations
    return {
        name.removeprefix("/"): (reader.get_destination_page_number(target) or 0) + 1
        for name, target in targets.items()
    }


def bookmarks(parent: Any) -> Iterator[Any]:
    """Yield the bookmarks below one, in the order of the book."""
    following = parent.get("/First")
    while following:
        mark = following.get_object()
        yield mark
        yield from bookmarks(mark)
        following = mark.get("/Next")


def print_pages(page: Any) -> list[str]:
    """Print the page that holds the whole book, and return its titles."""
    page.goto((BUILD / "singlehtml" / "index.html").as_uri(), timeout=180_000)
    page.add_style_tag(content=page.evaluate(RUNNING_TITLES))
    page.evaluate(SHOW_FORMULAS)
    page.evaluate(NAME_SIGNATURES)
    page.evaluate("document.fonts.ready")
    page.pdf(**PRINT)
    page.evaluate(NUMBER_CONTENTS, starts(PDF))
    page.pdf(**PRINT)
    titles: list[str] = page.evaluate(TITLES)
    return titles


def print_book() -> None:
    """Build and print the book, and say in the file what it is."""
    # First, since a build takes minutes and may be for nothing without a browser.
    with launch() as browser:
        build("pdf")
        PDF.parent.mkdir(exist_ok=True)
        titles = print_pages(browser.new_page(color_scheme="light"))
    # It would warn that the copy has more objects than the original.
    logging.getLogger("pypdf").setLevel(logging.ERROR)
    writer = PdfWriter(clone_from=PDF)
    # Chromium leaves out the space where a title breaks, and says some twice.
    for mark, title in zip(bookmarks(writer.root_object["/Outlines"]), titles, strict=True):
        mark[NameObject("/Title")] = TextStringObject(title)
    writer.add_metadata(
        {
            "/Author": "The rotedu developers",
            "/Subject": f"A paper on rotations, run and checked; edition {rotedu.__version__}",
        }
    )
    writer.write(PDF)


if __name__ == "__main__":
    edition = sys.argv[1]
    if edition == "pdf":
        print_book()
    else:
        build(edition)
    file = BUILD / edition / f"rotedu.{edition}"
    print(f"The book is here: {file.relative_to(ROOT)} ({file.stat().st_size / 1e6:.1f} MB)")
