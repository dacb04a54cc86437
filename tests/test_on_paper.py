"""The book as PDF and as EPUB: built, and read back."""

import functools
import re
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from bs4 import BeautifulSoup
from notebook_language import ROOT, captions_by_hand, exercises, pages
from pypdf import PdfReader
from pypdf._text_extraction import mult
from pypdf.generic import Destination

CAPTIONS = [caption.title for page in pages().values() for caption in page.all("caption")]
MARKED = re.compile(r'<span class="on-screen">(.*?)</span>', re.DOTALL)
HAND = re.compile(r"\b(drag|press|click|grab|pull)\b", re.IGNORECASE)
EPUBCHECK = Path("/usr/bin/epubcheck")

pytestmark = pytest.mark.slow


def made(edition: str) -> Path:
    """Make an edition."""
    command = [sys.executable, ROOT / "tools" / "print_book.py", edition]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout[-5_000:] + run.stderr[-5_000:]
    return ROOT / "_build" / edition / f"rotedu.{edition}"


@pytest.fixture(scope="module")
def pdf(browser: Any) -> PdfReader:
    # The script starts a browser of its own; without any, this fixture has said so by now.
    return PdfReader(made("pdf"))


@pytest.fixture(scope="module")
def extracted(pdf: PdfReader) -> list[tuple[str, float]]:
    """The text of each page, and the height of its last line above the page's number."""
    found = []
    for page in pdf.pages:
        heights: list[float] = []

        def note(text: str, cm: Any, tm: Any, *_: Any, heights: list[float] = heights) -> None:
            if text.strip():
                heights.append(mult(tm, cm)[5])

        text = page.extract_text(visitor_text=note)
        found.append((text, min(y for y in heights if y > 60)))
    return found


@pytest.fixture(scope="module")
def texts(extracted: list[tuple[str, float]]) -> list[str]:
    return [text for text, _ in extracted]


@pytest.fixture(scope="module")
def epub() -> dict[str, BeautifulSoup]:
    """The pages of the EPUB by their paths."""
    with zipfile.ZipFile(made("epub")) as archive:
        return {
            name: BeautifulSoup(archive.read(name), "html.parser")
            for name in archive.namelist()
            if name.endswith(".xhtml")
        }


def bookmarks(outline: list[Any], level: int = 1) -> Iterator[tuple[int, str]]:
    for entry in outline:
        if isinstance(entry, Destination):
            yield level, str(entry.title)
        else:
            yield from bookmarks(entry, level + 1)


@functools.cache
def source() -> Any:
    """The PDF's source."""
    html = (ROOT / "_build" / "singlehtml" / "index.html").read_text(encoding="utf-8")
    return BeautifulSoup(html, "html.parser").article


def without_spaces(text: str) -> str:
    return "".join(text.replace("\N{ZERO WIDTH SPACE}", "").split())


def test_every_chapter_and_section_has_a_bookmark(pdf: PdfReader) -> None:
    found = source().find_all(["h1", "h2", "h3", "h4"])
    titles = [(int(title.name[1]), without_spaces(title.get_text())) for title in found]
    marks = list(bookmarks(pdf.outline))
    assert [(level, without_spaces(title)) for level, title in marks] == titles
    assert not any(re.search(r"[a-z],[a-z]", title) for _, title in marks)
    chapters = [title for level, title in marks if level == 1]
    assert {"3 Ordinary rotation", "Answers and solutions"} <= {c.split(" · ")[0] for c in chapters}


def test_the_pdf_is_tagged_and_says_what_it_is(pdf: PdfReader, texts: list[str]) -> None:
    root, about = pdf.trailer["/Root"], pdf.metadata
    assert root["/MarkInfo"]["/Marked"]
    assert root["/Lang"] == "en"
    assert (about.title, about.author) == ("Do We Need Quaternions?", "The rotedu developers")
    assert 200 < len(pdf.pages) < 400
    sizes = {(round(float(p.mediabox.width)), round(float(p.mediabox.height))) for p in pdf.pages}
    assert sizes == {(595, 842)}
    assert [n for n, text in enumerate(texts, 1) if len(text.strip()) < 60] == []


def test_a_page_is_half_full_before_the_end_of_its_chapter(
    pdf: PdfReader, extracted: list[tuple[str, float]]
) -> None:
    entries = (entry for entry in pdf.outline if isinstance(entry, Destination))
    begins = {pdf.get_destination_page_number(entry) for entry in entries} | {len(pdf.pages)}
    lowest = [last for _, last in extracted]
    assert [n for n, y in enumerate(lowest, 1) if y > 842 / 2 and n not in begins] == []


def test_code_does_not_break_near_its_ends(texts: list[str]) -> None:
    on_pages = [without_spaces(text) for text in texts]

    def together(lines: list[str]) -> bool:
        return any(without_spaces("".join(lines)) in text for text in on_pages)

    codes = [code.get_text().strip().splitlines() for code in source().find_all("pre")]
    assert len(codes) > 300
    assert [code for code in codes if len(code) < 12 and not together(code)] == []
    assert [code for code in codes if not (together(code[:2]) and together(code[-2:]))] == []


def test_links_in_the_pdf_lead_to_its_pages_or_to_the_web(pdf: PdfReader) -> None:
    inside, wrong = 0, []
    for page in pdf.pages:
        for link in (note.get_object() for note in page.get("/Annots", [])):
            address = link.get("/A", {}).get("/URI")
            if address is None:
                inside += 1
                target = link.get("/Dest") or link["/A"]["/D"]
                if isinstance(target, str) and target not in pdf.named_destinations:
                    wrong.append(target)
            elif not address.startswith(("https://", "http://")):
                wrong.append(address)
    assert inside > 500
    assert wrong == []


def test_contents_give_the_pages_of_the_chapters(pdf: PdfReader, texts: list[str]) -> None:
    contents = "\n".join(texts[1:5])
    for entry in pdf.outline:
        if isinstance(entry, Destination) and entry.title[0].isdigit():
            number = pdf.get_destination_page_number(entry) + 1
            # A long title takes two lines.
            title = r"\s*".join(map(re.escape, without_spaces(entry.title)))
            assert re.search(rf"{title}\s*{number}\b", contents), entry.title


def test_fonts_are_in_the_pdf(pdf: PdfReader) -> None:
    names = set()
    for page in pdf.pages:
        for font in page["/Resources"].get("/Font", {}).values():
            font = font.get_object()
            # Its letters would be drawings.
            assert font["/Subtype"] != "/Type3"
            details = font.get("/DescendantFonts", [font])[0].get_object()["/FontDescriptor"]
            assert {"/FontFile", "/FontFile2", "/FontFile3"} & set(details.get_object())
            names.add(font["/BaseFont"])
    assert any("KaTeX" in name for name in names)


def test_the_pdf_has_every_figure_and_solution(texts: list[str]) -> None:
    text = "\n".join(texts)
    assert [title for title in CAPTIONS if f"{title}." not in text] == []
    assert [number for number in ("(2-1)", "(3-1)", "(5-4)") if number not in text] == []
    solutions = text[text.rindex("Answers and solutions\n1 Introduction") :]
    assert [n for n in exercises() if f"# Solution of Exercise {n}\n" not in solutions] == []


def test_what_is_marked_for_the_screen_is_not_printed(epub: dict[str, BeautifulSoup]) -> None:
    marked = [text for page in pages().values() for text in MARKED.findall(page.text)]
    assert len(marked) > 30
    plain = [text for text in marked if not re.search(r"[$*`\[]", text)]
    assert len(plain) > 10
    for edition in (source(), *epub.values()):
        printed = " ".join(edition.get_text().split())
        assert [text for text in plain if text in printed] == []
        captions = [caption.get_text() for caption in edition.find_all("figcaption")]
        assert [text for text in captions if HAND.search(text)] == []
    # What else the caption says is there.
    [mirrors] = [c.text for c in source().find_all("figcaption") if "Picture 2-a." in c.text]
    assert "The turn" in mirrors


def test_answers_stand_at_the_end(epub: dict[str, BeautifulSoup], pdf: PdfReader) -> None:
    answers = ":is([id^='answer-'], [id^='solutions-answer-'])"
    starters = "section:not([id*='solution-']) > .cell pre"
    for edition in ([source()], epub.values()):
        boxes = [box for page in edition for box in page.select(".question")]
        assert len(boxes) == sum(len(page.select(answers)) for page in edition) >= 8
        assert [box for box in boxes if box.select(".opened") or len(box.select("li")) < 2] == []
        assert not any("check(" in code.text for page in edition for code in page.select(starters))


def test_the_epub_has_every_figure_and_solution(epub: dict[str, BeautifulSoup]) -> None:
    figures = [figure for page in epub.values() for figure in page.find_all("figure")]
    small = [caption for caption in captions_by_hand() if caption.kind != "caption"]
    assert len(figures) == len(CAPTIONS) + len(small)
    assert all(figure.select_one("img[alt], [role=img][aria-label]") for figure in figures)
    solutions = epub["book/solutions.xhtml"].find_all(id=re.compile(r"^solution-"))
    assert len(solutions) == len(exercises())


def test_the_epub_has_mathml_and_nothing_that_needs_a_script(
    epub: dict[str, BeautifulSoup],
) -> None:
    pages = epub.values()
    assert sum(len(page.find_all("math")) for page in pages) > 1_000
    assert [tag for page in pages for tag in page.select(".katex-html, script, button, form")] == []
    assert [tag for page in pages for tag in page.select("[role=doc-biblioentry]")] == []


def test_epubcheck_finds_nothing(epub: dict[str, BeautifulSoup]) -> None:
    assert EPUBCHECK.exists(), "no epubcheck: install it with sudo apt-get install epubcheck"
    file = ROOT / "_build" / "epub" / "rotedu.epub"
    command = ["java", "-jar", EPUBCHECK, "--failonwarnings", file]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
