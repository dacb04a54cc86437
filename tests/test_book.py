"""The built book, page by page: as files, and as a browser sees it."""

import re
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import nbformat
import pytest
from bs4 import BeautifulSoup
from html_pages import anchors, parse
from notebook_language import notebooks, part_of

FILES = ("href", "src", "data-scene", "data-shared")


@pytest.fixture(scope="module")
def pages(book: Path) -> dict[str, BeautifulSoup]:
    """Every page of the book by its path."""
    files = [file for file in book.rglob("*.html") if "_static" not in file.parts]
    return {file.relative_to(book).as_posix(): parse(file) for file in sorted(files)}


NOWHERE = {
    "an error": ".stderr, .traceback, .katex-error, .cell_output:-soup-contains('Traceback (most')",
    "a picture without a caption": (
        "article .cell_output :is(.scene, .chart, img):not(figure:has(figcaption) *)"
    ),
    "a formula that is none": "article :is(p, li, dd, td):-soup-contains-own('$')",
    "a chart that is a file": "article img[src$='.svg']",
    # Half of a listing is punctuation and spaces, which no style colours.
    "elements for commas": ".highlight :is(.p, .w)",
    "a picture that no words describe": "article img:not([alt*=' '])",
    "a link without a name": "article a[href]:not(.headerlink, [title]):empty",
    "what is loaded from another host": "[src*='//'], link[rel=stylesheet][href*='//']",
    "a link that runs a script": "[href^='javascript:' i]",
    "a form that is sent, but for the search": "form[action]:not([role=search])",
    # What answers the hand is disabled until a script takes over.
    "a form that waits for no script": "form:not([role=search], :has(fieldset[disabled]))",
}


@pytest.mark.parametrize("selector", NOWHERE.values(), ids=NOWHERE)
def test_no_page_has(selector: str, pages: dict[str, BeautifulSoup]) -> None:
    assert [name for name, page in pages.items() if page.select(selector)] == []


def test_no_page_is_too_long_for_a_slow_phone(pages: dict[str, BeautifulSoup]) -> None:
    elements = {name: len(page.find_all(True)) for name, page in pages.items()}
    assert {name: n for name, n in elements.items() if n > 12_000} == {}


def test_the_root_leads_to_the_first_page(book: Path) -> None:
    assert "url=book/index.html" in (book / "index.html").read_text(encoding="utf-8")


def test_links_and_anchors_lead_somewhere(book: Path, pages: dict[str, BeautifulSoup]) -> None:
    broken = []
    for name, soup in pages.items():
        for reference in (e[a] for a in FILES for e in soup.find_all(attrs={a: True})):
            url = urlsplit(reference)
            if url.scheme or url.netloc:
                continue
            target = ((book / name).parent / unquote(url.path or Path(name).name)).resolve()
            # The state of a figure follows its name.
            anchor = unquote(url.fragment).partition("?")[0]
            lost = anchor and target.suffix == ".html" and anchor not in anchors(target)
            if lost or not target.exists():
                broken.append(f"{name}: {reference}")
    assert broken == []


def test_equations_carry_the_numbers_of_the_paper(pages: dict[str, BeautifulSoup]) -> None:
    shown = [
        (number.find_parent("div")["id"], number.get_text().split(")")[0])
        for soup in pages.values()
        for number in soup.select(".eqno")
    ]
    assert len(shown) > 30
    assert [pair for pair in shown if pair[0] != f"equation-eq-{pair[1].strip('(')}"] == []


@dataclass
class Visit:
    """What a browser finds on a page."""

    complaints: list[str]
    """Requests that fail or go elsewhere, errors of scripts, pictures that do not load."""
    too_wide: dict[int, int]
    """By how many pixels the page is wider than the window, by its width."""
    reachable: list[str]
    """On a phone, what scrolls sideways and can have the focus."""
    unreachable: list[str]
    letters: float
    """On a phone, the size of the smallest letters of charts, in pixels."""


@pytest.fixture(scope="module")
def visits(browser: Any, site: str, pages: dict[str, BeautifulSoup]) -> dict[str, Visit]:
    """Open every page once, wide and narrow, with all its folded texts."""
    context = browser.new_context()
    page = context.new_page()
    complaints: list[str] = []
    page.on("request", lambda r: r.url.startswith((site, "data:")) or complaints.append(r.url))
    page.on("response", lambda r: r.status < 400 or complaints.append(f"{r.status} {r.url}"))
    page.on("pageerror", lambda error: complaints.append(str(error)))
    found = {}
    # The root only leads to the front page.
    for name in pages.keys() - {"index.html"}:
        complaints.clear()
        page.goto(f"{site}/{name}")
        missing = page.evaluate(
            """async () => {
                await document.fonts.ready;
                const seen = [...document.images].filter((image) => image.checkVisibility());
                for (const image of seen) image.loading = "eager";
                await Promise.allSettled(seen.map((image) => image.decode()));
                return seen.filter((image) => !image.naturalWidth).map((image) => image.src);
            }"""
        )
        page.evaluate("for (const box of document.querySelectorAll('details')) box.open = true")
        too_wide = {}
        for width in (1440, 390):
            page.set_viewport_size({"width": width, "height": 900})
            too_wide[width] = page.evaluate("document.documentElement.scrollWidth - innerWidth")
        page.evaluate("new Promise(done => requestAnimationFrame(() => setTimeout(done)))")
        unreachable, reachable = page.evaluate(
            """() => {
                const boxes = [...document.querySelectorAll("article *")].filter((box) =>
                    box.scrollWidth > box.clientWidth && box.clientWidth > 0
                    && /auto|scroll/.test(getComputedStyle(box).overflowX));
                return [-1, 0].map((index) => boxes.filter(({ tabIndex }) => tabIndex === index)
                    .map(({ localName, className }) => `${localName}.${className}`));
            }"""
        )
        letters = page.evaluate(
            """() => Math.min(100, ...[...document.querySelectorAll(".chart text")].map((text) =>
                parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a))"""
        )
        found[name] = Visit([*complaints, *missing], too_wide, reachable, unreachable, letters)
    context.close()
    return found


def test_a_browser_finds_everything_here(visits: dict[str, Visit]) -> None:
    assert {name: visit.complaints for name, visit in visits.items() if visit.complaints} == {}


def test_no_page_scrolls_sideways(visits: dict[str, Visit]) -> None:
    wide = {name: v.too_wide for name, v in visits.items() if max(v.too_wide.values()) > 0}
    assert wide == {}


def test_tables_are_no_wider_than_a_phone(visits: dict[str, Visit]) -> None:
    assert [name for name, v in visits.items() if any("table" in box for box in v.reachable)] == []


def test_cells_say_where_they_stand(pages: dict[str, BeautifulSoup]) -> None:
    """On a phone, where rows are cards, and by ear, nothing else says it."""
    wide = heads = 0
    for soup in pages.values():
        for table in soup.select("table.docutils:has(thead)"):
            names = [head.get_text() for head in table.select("thead th")]
            wide += len(names) > 3
            heads += bool(table.select("tbody th"))
            for row in table.select("tbody tr"):
                assert [cell["data-column"] for cell in row(["th", "td"])] == names
                assert row("th") in ([], [row.find(scope="row")])
    assert wide > 20
    assert heads > 50


def test_letters_of_charts_are_read_on_a_phone(visits: dict[str, Visit]) -> None:
    sizes = {name: visit.letters for name, visit in visits.items() if visit.letters < 100}
    assert len(sizes) >= 6
    assert {name: size for name, size in sizes.items() if size < 11} == {}


def test_what_scrolls_sideways_can_be_reached_with_the_keyboard(visits: dict[str, Visit]) -> None:
    assert {name: visit.unreachable for name, visit in visits.items() if visit.unreachable} == {}
    seen = {box for visit in visits.values() for box in visit.reachable}
    assert {"pre.", "span.katex-display"} <= seen


def test_posters_are_light(book: Path) -> None:
    weights = [file.stat().st_size for file in (book / "_images").glob("scene-*.webp")]
    assert len(weights) > 20
    assert max(weights) <= 80_000


def test_pages_can_be_read_from_the_file_system(browser: Any, book: Path) -> None:
    """Without a server, text and formulas have their fonts, and posters are visible."""
    page = browser.new_page()
    page.goto((book / "book" / "03-ordinary-rotation.html").as_uri())
    page.locator(".scene-poster").first.scroll_into_view_if_needed()
    page.wait_for_function("document.querySelector('.scene-poster').naturalWidth > 900")
    family = page.evaluate("getComputedStyle(document.querySelector('.katex')).fontFamily")
    assert family.startswith("KaTeX_Main")
    assert page.evaluate("document.fonts.check('16px KaTeX_Main')")
    page.wait_for_function(
        """() => [...document.fonts].filter(({ family, status }) =>
            family.includes("Source Serif") && status === "loaded").length >= 2"""
    )
    page.close()


@pytest.mark.slow
def test_nothing_moves_when_fonts_come_late(browser: Any, site: str) -> None:
    page = browser.new_page()
    page.route("**/*.woff2", lambda route: (time.sleep(0.3), route.continue_()))
    page.add_init_script(
        """window.moved = 0;
        new PerformanceObserver((list) => list.getEntries().forEach(({ value }) => moved += value))
            .observe({ type: "layout-shift", buffered: true });"""
    )
    page.goto(f"{site}/book/02-quaternions.html")
    page.evaluate("document.fonts.ready")
    assert page.evaluate("moved") < 0.02
    page.close()


def test_the_theme_works(browser: Any, site: str) -> None:
    """A click changes the colours, of charts too, and the contents follow the reader."""
    page = browser.new_page(viewport={"width": 1440, "height": 900}, color_scheme="dark")
    page.goto(f"{site}/book/beyond-motion.html")
    chart = """getComputedStyle(document.querySelector(
        ".chart [style*='stroke: currentcolor'][style*='#009e73']")).stroke"""
    assert page.evaluate(chart) == "rgb(47, 191, 149)"
    page.locator(".theme-toggle-content .theme-toggle").click()
    assert page.evaluate("document.body.dataset.theme") == "light"
    assert page.evaluate(chart) == "rgb(0, 122, 89)"
    for name in ("the-ledger", "exercises"):
        page.locator(f".toc-tree a[href='#{name}']").click()
        page.wait_for_selector(f".toc-tree .scroll-current > a[href='#{name}']")
    page.close()


SEARCHES = {
    "mirrors": "02-quaternions.html",
    "gimbal lock": "04-general-rotation.html",
    "slerp": "05-arcs.html",
    "shortest path": "05-arcs.html",
    "exponential map": "beyond-motion.html",
    "5-9": "05-control-points.html#equation-eq-5-9",
}


def test_the_search_finds_and_quotes_what_is_text(browser: Any, site: str) -> None:
    """It quotes no labels and buttons of figures, and each formula once."""
    page = browser.new_page()
    page.goto(f"{site}/book/index.html")
    wrong = re.compile(r"explore\(|With JavaScript|\\[a-z]")
    for query, wanted in SEARCHES.items():
        page.locator("input[name=q]").first.fill(query)
        page.keyboard.press("Enter")
        page.wait_for_url(f"**/search.html?q={query.replace(' ', '+')}*")
        page.wait_for_selector(".search-summary:has-text('found')")
        found = page.locator("#search-results li > a").evaluate_all("all => all.map(a => a.href)")
        # The glossary and the list of functions may come first.
        assert any(address.endswith(wanted) for address in found[:7]), query
        quoted = page.locator("#search-results .context")
        quoted.first.wait_for()
        assert [text for text in quoted.all_text_contents() if wrong.search(text)] == []
    page.close()


def test_pages_offer_the_notebooks_of_students(book: Path, pages: dict[str, BeautifulSoup]) -> None:
    """Each stands alone, with no solution in it and no link to a notebook that is not there."""
    assert len(notebooks()) > 5
    for page in notebooks():
        head = pages[f"book/{Path(page.name).stem}.html"].select_one("h1 + .page-head")
        offered = nbformat.read(book / "book" / head.select_one("a[download]")["href"], 4)
        parts = {part_of(cell.id)[0] for cell in offered.cells}
        assert not {"solution", "why"} & parts
        assert bool(page.exercises) == ("start" in parts)
        texts = "".join(cell.source for cell in offered.cells if cell.cell_type == "markdown")
        assert not re.findall(r"\]\((?!https?://|#)[^)]*\)", texts), page


def test_figures_and_equations_show_their_links_to_mouse_and_keyboard(
    browser: Any, site: str
) -> None:
    page = browser.new_page()
    page.goto(f"{site}/book/03-ordinary-rotation.html")
    for place in ("figcaption", "div.math"):
        link = page.locator(f"{place} a.headerlink").first
        seen = "link => getComputedStyle(link).opacity"
        assert link.evaluate(seen) == "0"
        page.locator(place).first.hover()
        assert link.evaluate(seen) == "1"
        page.mouse.move(2, 2)
        assert link.evaluate(seen) == "0"
        link.focus()
        assert link.evaluate(seen) == "1"
    page.close()


def test_no_word_runs_into_the_next(pages: dict[str, BeautifulSoup]) -> None:
    for name, page in pages.items():
        for marked in page.select("article p :is(a, em, strong, code)"):
            before, word = str(marked.previous_sibling or " "), marked.get_text() or " "
            assert not (before[-1].isalnum() and word[0].isalnum()), (name, before[-20:], word)


def test_pages_say_what_they_are_about(pages: dict[str, BeautifulSoup]) -> None:
    described = [soup.select("meta[name=description]") for soup in pages.values()]
    texts = [tags[-1]["content"] for tags in described if tags]
    assert len(set(texts)) == len(texts) == len(pages) - len({"index.html", "search.html"})


def test_what_is_served_comes_with_its_licence(book: Path, pages: dict[str, BeautifulSoup]) -> None:
    text = (book / "_static" / "licences.txt").read_text(encoding="utf-8")
    drawing = ("Google Inc.", "Khan Academy", "with Reserved Font Names", "three.js authors")
    python = ("Mozilla Public", "Python Software Foundation", "NumPy Developers", "Haverbeke")
    assert [words for words in (*drawing, *python) if words not in text] == []
    link = "footer a[href$='licences.txt']"
    assert {name for name, soup in pages.items() if not soup.select(link)} <= {"index.html"}


def test_words_of_the_glossary_are_links_where_they_are_first_used(
    pages: dict[str, BeautifulSoup],
) -> None:
    explained = {term["id"] for term in pages["book/glossary.html"].select("dl.glossary dt[id]")}
    assert {"term-cross-product", "term-Bezier-curve", "term-degrees-of-freedom"} <= explained
    for name, soup in pages.items():
        links = [urlsplit(link["href"]).fragment for link in soup.select("article a.first-use")]
        assert len(links) == len(set(links)), name
        assert set(links) <= explained, name
        if re.match(r"book/(0|errata)", name):
            assert len(links) > 10, name
            uses = [
                text
                for paragraph in soup.select("article p:not(.eyebrow)")
                if not paragraph.find_parent("figcaption")
                for text in paragraph.find_all(string=re.compile(r"\b[Rr]otations?\b(?! v)"))
                if not text.find_parent(["code", "em"])
            ]
            # A page that is told may do without the word.
            assert all(first.find_parent("a") for first in uses[:1]), (name, uses)


def test_what_belongs_together_stays_on_one_line(
    browser: Any, site: str, pages: dict[str, BeautifulSoup]
) -> None:
    page = browser.new_page(viewport={"width": 390, "height": 900})
    page.goto(f"{site}/book/05-control-points.html")
    torn = page.evaluate(
        """() => [...document.querySelectorAll("article .unbroken")]
            .filter((element) => {
                const boxes = [...element.getClientRects()].filter(({ width }) => width > 2);
                const tops = boxes.map(({ top }) => top);
                return Math.max(...tops) > Math.min(...boxes.map(({ bottom }) => bottom));
            })
            .map((element) => element.textContent)"""
    )
    page.close()
    assert torn == []
    followed = [
        formula.parent.get("class", [])
        for soup in pages.values()
        for formula in soup.select("article p > .math, article .unbroken > .math")
        if (mark := formula.next_sibling) and str(mark)[0] in ".,;:"
    ]
    whole = {span.get_text() for soup in pages.values() for span in soup.select(".unbroken")}
    assert {"(2-6)", "18 + 12"} <= whole
    assert not [each for each in whole if re.match(r"\d{4} ", each)], "a part of a decimal"
    assert followed.count(["unbroken"]) > 0.8 * len(followed) > 100
