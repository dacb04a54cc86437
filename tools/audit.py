"""Judge every page of the built book; ``python tools/audit.py index 03`` judges some.

Of each page: what it weighs, packed as hosts do, on a first visit and for readers who come from the
front page; how far its content jumps while it loads; what its console says; what axe finds and what
is cut off, at five widths in both themes. Then what figures (`measure_drag`) and a first run
(`measure_run`) cost. A page that misses a budget ends the audit with 1.
"""

import itertools
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Literal
from urllib.parse import urlsplit

import measure_drag
from browser import launch, serve
from measure_drag import packed
from measure_run import first_output
from playwright.sync_api import Browser

ROOT = Path(__file__).parents[1]
HTML = ROOT / "_build" / "html"
AXE_CORE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
FRONT = "book/index.html"
# With fonts and the posters that load before a scroll, before a scene is live.
FIRST_KILOBYTES, NEXT_KILOBYTES = 400, 200
LAYOUT_SHIFT = 0.02
WIDTHS = (360, 820, 1024, 1440, 1920)
THEMES: tuple[Literal["light", "dark"], ...] = ("light", "dark")

# A reader who saves data gets posters, but no live scene.
OPENED = """
Object.defineProperty(navigator, "connection", { value: { saveData: true } });
window.shift = 0;
new PerformanceObserver((list) => {
    for (const { value } of list.getEntries()) window.shift += value;
}).observe({ type: "layout-shift", buffered: true });
"""
# What unfolds fades in.
UNFOLD = """async () => {
    document.querySelectorAll("details").forEach((details) => { details.open = true; });
    await Promise.all(document.getAnimations().map(({ finished }) => finished));
}"""
AXE = """async () => (await axe.run()).violations.map(({ id, nodes }) => {
    const places = nodes.map((node) => node.target.join(" "));
    const more = places.length > 3 ? ` and ${places.length - 3} more` : "";
    return `axe ${id}: ${places.slice(0, 3).join(", ")}${more}`;
})"""
# What is wider than its place. On a phone formulas and columns of numbers scroll, and show it.
CUT = """() => {
    const wide = (element) => element.scrollWidth > element.clientWidth + 1;
    const boxes = "pre, .table-wrapper, .text_html, .chart, .katex-display";
    const inside = innerWidth < 500 ? [] : document.querySelectorAll(`article :is(${boxes})`);
    return [document.documentElement, ...inside].filter(wide)
        .map((element) => `${element.tagName} ${element.textContent.trim().slice(0, 40)}`);
}"""


def weigh(browser: Browser, host: str, path: str) -> tuple[dict[str, float], list[str]]:
    """Open a page; return the kilobytes of each file that it loads, and what went wrong."""
    loaded: list[str] = []
    findings: list[str] = []
    page = browser.new_page()
    page.add_init_script(OPENED)
    page.on("requestfinished", lambda request: loaded.append(request.url))
    page.on("console", lambda message: findings.append(f"console: {message.text}"))
    page.goto(host + path, wait_until="networkidle")
    shift = page.evaluate("window.shift")
    if shift >= LAYOUT_SHIFT:
        findings.append(f"layout shift: {shift:.3f}, below {LAYOUT_SHIFT}")
    page.close()
    loaded = [url for url in loaded if url.startswith(host)]
    return {url: packed(HTML / urlsplit(url).path.lstrip("/")) for url in loaded}, findings


def seen(browser: Browser, url: str) -> Iterator[str]:
    """Yield what axe finds and what is cut off, at all widths in both themes."""
    for width, theme in itertools.product(WIDTHS, THEMES):
        page = browser.new_page(viewport={"width": width, "height": 900}, color_scheme=theme)
        page.goto(url, wait_until="load")
        page.evaluate(UNFOLD)
        page.add_script_tag(path=AXE_CORE)
        found = [*page.evaluate(AXE), *(f"cut: {what}" for what in page.evaluate(CUT))]
        yield from (f"{finding} [{width} {theme}]" for finding in found)
        page.close()


def judged(browser: Browser, host: str, path: str, cached: dict[str, float]) -> Iterator[str]:
    """Print what a page weighs and its figures cost, and yield what is wrong with it."""
    files, findings = weigh(browser, host, path)
    first = sum(files.values())
    after = sum(size for url, size in files.items() if url not in cached)
    print(f"{path:34}{first:8.0f} kB first{after:8.0f} kB next", flush=True)
    for weight, budget in ((first, FIRST_KILOBYTES), (after, NEXT_KILOBYTES)):
        if weight > budget:
            yield f"weight: {weight:.0f} kB, at most {budget}"
    yield from findings
    yield from seen(browser, host + path)
    yield from measure_drag.figures(browser, host, HTML, path)


def main(wanted: list[str]) -> int:
    """Print what is measured and each finding; return 1 if a page misses a budget."""
    missed = list(measure_drag.weights(HTML / "_static" / "scene"))
    # The root only redirects.
    pages = [*sorted(HTML.glob("book/**/*.html")), HTML / "search.html"]
    with serve(HTML) as address, launch() as browser:
        host = f"{address}/"
        cached, _ = weigh(browser, host, FRONT)
        for path in (page.relative_to(HTML).as_posix() for page in pages):
            if not wanted or any(word in path for word in wanted):
                missed += [f"{path}: {wrong}" for wrong in judged(browser, host, path, cached)]
        print(first_output(browser, host))
    print(*missed or ["All budgets are met."], sep="\n")
    return bool(missed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
