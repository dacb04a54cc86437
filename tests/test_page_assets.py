"""What a page loads: what it uses, light, and nothing that a strict host would refuse."""

import base64
import gzip
import io
import re
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from bs4 import BeautifulSoup
from fontTools.ttLib import TTFont

# Fonts of formulas, at most about 90 kB, come on top; `make audit` measures all in a browser.
BUDGET = 500_000
# Classes of Font Awesome that say how an icon looks, not which it is.
LOOKS = {"fa-solid", "fa-lg", "fa-fw", "fa-sm"}
# The theme's own: it reads which colours the reader chose, and puts the cursor into the search.
INLINE = ("document.documentElement.dataset.mode", "// Activate the search field")


@pytest.fixture(scope="module")
def pages(book: Path) -> dict[Path, BeautifulSoup]:
    """Every page of the book."""
    files = [file for file in sorted(book.rglob("*.html")) if "_static" not in file.parts]
    return {file: BeautifulSoup(file.read_text(encoding="utf-8"), "html.parser") for file in files}


@pytest.fixture(scope="module")
def styles(book: Path) -> str:
    """The stylesheet of all pages."""
    return (book / "_static" / "pages.css").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def glyphs(styles: str) -> set[int]:
    """The characters of the icon font."""
    [font] = re.findall(r"data:font/woff;base64,([\w+/=]+)", styles)
    return set(TTFont(io.BytesIO(base64.b64decode(font))).getBestCmap())


def test_every_icon_is_in_the_font(
    book: Path, pages: dict[Path, BeautifulSoup], styles: str, glyphs: set[int]
) -> None:
    shown = {
        name
        for soup in pages.values()
        for icon in soup.select("[class*='fa-']")
        for name in icon["class"]
        if name.startswith("fa-")
    }
    # What the script of the theme adds.
    script = (book / "_static/scripts/pydata-sphinx-theme.js").read_text(encoding="utf-8")
    shown |= set(re.findall(r"\bfa-[a-z-]+", script))
    assert {"fa-sun", "fa-magnifying-glass", "fa-xmark"} <= shown
    missing = []
    for name in sorted(shown - LOOKS):
        rule = re.search(rf'\.{name}:before[^{{]*{{content:"\\([0-9a-f]+)"}}', styles)
        if not rule or int(rule[1], 16) not in glyphs:
            missing.append(name)
    assert missing == []


def test_every_box_has_its_icon(styles: str, glyphs: set[int]) -> None:
    code_points = dict(re.findall(r'--pst-icon-([a-z-]+):"(.)"', styles))
    used = re.findall(
        r"--pst-icon-(?:admonition|versionmodified)-[a-z]+:var\(--pst-icon-(.+?)\)", styles
    )
    assert len(used) > 10
    assert [name for name in used if ord(code_points[name]) not in glyphs] == []


def test_no_page_loads_what_the_book_does_without(pages: dict[Path, BeautifulSoup]) -> None:
    unneeded = ("fontawesome", "thebe", "togglebutton", "require", "mathjax")
    found = [
        f"{page.name}: {source}"
        for page, soup in pages.items()
        for element in soup.select("script[src], link[href]")
        if (source := element.get("src") or element.get("href"))
        if any(word in source.lower() for word in unneeded)
    ]
    assert found == []


def test_scripts_wait_and_nothing_else_is_inline(pages: dict[Path, BeautifulSoup]) -> None:
    """So a host may refuse all scripts but the book's files and two texts of the theme."""
    wrong = []
    for page, soup in pages.items():
        for script in soup.find_all("script"):
            text = (script.string or "").strip()
            if text and not text.startswith(INLINE):
                wrong.append(f"{page.name}: {text[:60]}")
            source = script.get("src", "")
            in_order = page.name == "search.html" or "before-the-page.js" in source
            if source and not in_order and not script.has_attr("defer"):
                wrong.append(f"{page.name}: {source} does not wait")
        wrong += [
            f"{page.name}: {element.name} {name}"
            for element in soup.find_all(True)
            for name in element.attrs
            if name.startswith("on")
        ]
    assert wrong == []


def test_pages_are_light(pages: dict[Path, BeautifulSoup]) -> None:
    """All that a page refers to, posters in both themes included, as it goes over the wire."""
    heavy = []
    for page, soup in pages.items():
        references = [e["src"] for e in soup.select("script[src], img[src]")]
        references += [e["href"] for e in soup.select("link[rel=stylesheet], link[as=script]")]
        files = {(page.parent / urlsplit(reference).path).resolve() for reference in references}
        size = sum(len(gzip.compress(file.read_bytes())) for file in {page, *files})
        if size > BUDGET:
            heavy.append(f"{page.name}: {size / 1000:.0f} kB")
    assert heavy == []


def test_only_code_with_a_colour_of_its_own_has_an_element(
    book: Path, pages: dict[Path, BeautifulSoup]
) -> None:
    """What page_assets unwraps looks the same without: in either theme it has the plain colour."""
    code = [soup for soup in pages.values() if soup.select(".highlight .k")]
    assert code
    for soup in code:
        assert not soup.select(".highlight :is(.n, .nn, .p, .w)")
    styles = (book / "_static" / "pygments.css").read_text(encoding="utf-8")
    for theme in ("light", "dark"):
        in_theme = rf'html\[data-theme="{theme}"\] \.highlight'
        [plain] = re.findall(in_theme + r" {.*?[ ;]color: (#\w+)", styles)
        for name in ("n", "nn", "p", "w"):
            assert re.findall(rf"{in_theme} \.{name} {{ color: (#\w+)", styles) == [plain], name
