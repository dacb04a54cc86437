"""Judge every page of the built book.

``python tools/audit.py`` serves _build/html compressed, as a web server does. It measures for every
page its weight on a first visit and for readers who come from the front page, its number of
elements, its scores in Lighthouse (mobile preset), the findings of axe at two widths in both
themes, and what is cut off at four widths. It prints a table, then what figures cost
(`tools/measure_drag.py`), what a first run costs (`tools/measure_run.py`) and each finding, and
returns 1 if a page misses a budget.

Name pages to judge only those: ``python tools/audit.py index 03``.
"""

import functools
import gzip
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import bundle
import measure_drag
from browser import CHROMIUM_FLAGS, QuietHandler, installed_chromium, launch, node, serve
from measure_run import first_output
from playwright.sync_api import Browser, Page, Request

ROOT = Path(__file__).parents[1]
HTML = ROOT / "_build" / "html"
FRONT = "book/index.html"
MODULES = ROOT / "node_modules"
KILOBYTE = 1000
# With fonts and the posters that load before a scroll, before a scene is live.
FIRST_KILOBYTES, NEXT_KILOBYTES = 400, 200
LAYOUT_SHIFT = 0.02
BUDGETS = {"accessibility": 100, "best-practices": 95}
CATEGORIES = ["performance", *BUDGETS, "seo"]
WIDTHS = {1440: 900, 390: 844}
THEMES = ("light", "dark")
READ_AT = (360, 820, 1024, 1440)

# A reader who saves data gets posters, but no live scene.
SAVE_DATA = "Object.defineProperty(navigator, 'connection', {value: {saveData: true}})"
AXE = """async () => {
    document.querySelectorAll("details").forEach(details => { details.open = true; });
    return (await axe.run()).violations.map(({id, nodes}) => {
        const places = nodes.map(node => node.target.join(" "));
        const more = places.length > 3 ? ` and ${places.length - 3} more` : "";
        return `axe ${id}: ${places.slice(0, 3).join(", ")}${more}`;
    });
}"""

# What is wider than its place. On a phone formulas and columns of numbers scroll, and show it.
CUT = """() => {
    document.querySelectorAll("details").forEach(details => { details.open = true; });
    const wide = element => element.scrollWidth > element.clientWidth + 1;
    const boxes = "pre, .table-wrapper, .text_html, .chart, .katex-display";
    const inside = innerWidth < 500 ? [] : document.querySelectorAll(`article :is(${boxes})`);
    return [document.documentElement, ...inside].filter(wide)
        .map(element => `${element.tagName} ${element.textContent.trim().slice(0, 40)}`);
}"""

# Hosts cache compressed files; compressing again would take time from the browser.
compress = functools.cache(gzip.compress)


class Compressing(QuietHandler):
    """Serves files compressed where this helps."""

    protocol_version = "HTTP/1.1"
    extensions_map = QuietHandler.extensions_map | {
        ".glb": "model/gltf-binary",
        ".webp": "image/webp",
        ".woff2": "font/woff2",
    }
    packed = ("application/gzip", "application/zip", "image/jpeg", "image/png", "image/webp")
    packed += ("font/woff2",)

    def do_GET(self) -> None:  # noqa: N802
        """Send a file."""
        file = Path(self.translate_path(self.path))
        if not file.is_file():
            self.send_error(404)
            return
        content, kind = file.read_bytes(), self.guess_type(file)
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Cache-Control", "max-age=600")
        if kind not in self.packed:
            content = compress(content)
            self.send_header("Content-Encoding", "gzip")
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)


def pages(wanted: list[str]) -> Iterator[str]:
    """Yield the paths of the built pages, except the root, which only redirects."""
    for file in sorted(HTML.rglob("*.html")):
        path = file.relative_to(HTML).as_posix()
        if path == "index.html" or path.startswith("_"):
            continue
        if not wanted or any(word in path for word in wanted):
            yield path


def weigh(browser: Browser, url: str, host: str) -> tuple[dict[str, int], int, list[str]]:
    """Return the bytes of each file that a page loads, its elements, and what its console says."""
    page = browser.new_page()
    page.add_init_script(SAVE_DATA)
    requests: list[Request] = []
    findings: list[str] = []
    page.on("requestfinished", lambda r: requests.append(r))
    page.on(
        "console",
        lambda m: m.type in ("error", "warning") and findings.append(f"console: {m.text}"),
    )
    page.goto(url, wait_until="networkidle")
    elements = page.evaluate("document.querySelectorAll('*').length")
    sizes = {r.url: r.sizes() for r in requests if r.url.startswith(host)}
    page.close()
    files = {
        url: size["responseBodySize"] + size["responseHeadersSize"] for url, size in sizes.items()
    }
    return files, elements, findings


def run_axe(browser: Browser, url: str) -> list[str]:
    """Return axe's findings at all widths in both themes."""
    findings: dict[str, list[str]] = {}
    for width, height in WIDTHS.items():
        for theme in THEMES:
            page: Page = browser.new_page(
                viewport={"width": width, "height": height}, color_scheme=theme
            )
            page.goto(url, wait_until="load")
            page.add_script_tag(path=MODULES / "axe-core" / "axe.min.js")
            for finding in page.evaluate(AXE):
                findings.setdefault(finding, []).append(f"{width} {theme}")
            page.close()
    return [f"{finding} [{', '.join(where)}]" for finding, where in findings.items()]


def cut_off(browser: Browser, url: str) -> list[str]:
    """Return what is cut off at any width."""
    found = []
    for width in READ_AT:
        page = browser.new_page(viewport={"width": width, "height": 900})
        page.goto(url, wait_until="load")
        found += [f"cut at {width}: {what}" for what in page.evaluate(CUT)]
        page.close()
    return found


def run_lighthouse(url: str, chromium: str) -> tuple[dict[str, int], list[str]]:
    """Return Lighthouse's scores, and the audits that lost points where a budget is missed."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        subprocess.run(
            [
                node(),
                str(MODULES / "lighthouse" / "cli" / "index.js"),
                url,
                "--quiet",
                "--output=json",
                f"--output-path={report}",
                f"--only-categories={','.join(CATEGORIES)}",
                f"--chrome-flags={' '.join(['--headless=new', *CHROMIUM_FLAGS])}",
            ],
            env=os.environ | {"CHROME_PATH": chromium},
            check=True,
        )
        result = json.loads(report.read_text(encoding="utf-8"))
    scores = {name: round(100 * result["categories"][name]["score"]) for name in CATEGORIES}
    shift = result["audits"]["cumulative-layout-shift"]["numericValue"]
    findings = [f"layout shift: {shift:.3f}"] if shift >= LAYOUT_SHIFT else []
    for name, budget in BUDGETS.items():
        for audit in result["categories"][name]["auditRefs"] if scores[name] < budget else ():
            found = result["audits"][audit["id"]]
            if audit["weight"] and found["score"] is not None and found["score"] < 0.9:
                value = found.get("displayValue", "")
                findings.append(f"{name}: {found['id']} {value}".rstrip())
    return scores, findings


def main() -> int:
    """Print the table and the findings; return 1 if a page misses a budget."""
    columns = ["first kB", "next kB", "elements", *CATEGORIES, "findings"]
    print(f"{'page':34}{''.join(f'{column:>15}' for column in columns)}")
    missed: list[str] = []
    with serve(HTML, Compressing) as address, launch() as browser:
        if not (MODULES / "lighthouse").exists():
            bundle.install_libraries()
        host = f"{address}/"
        chromium = installed_chromium() or browser.browser_type.executable_path
        cached, _, _ = weigh(browser, host + FRONT, host)
        for path in pages(sys.argv[1:]):
            files, elements, findings = weigh(browser, host + path, host)
            first = sum(files.values()) / KILOBYTE
            after = sum(size for url, size in files.items() if url not in cached) / KILOBYTE
            for weight, budget in ((first, FIRST_KILOBYTES), (after, NEXT_KILOBYTES)):
                if weight > budget:
                    findings.append(f"weight: {weight:.0f} kB, at most {budget}")
            findings += run_axe(browser, host + path)
            findings += cut_off(browser, host + path)
            scores, short = run_lighthouse(host + path, chromium)
            findings += short
            row = [f"{first:.0f}", f"{after:.0f}", elements, *scores.values(), len(findings)]
            print(f"{path:34}{''.join(f'{value:>15}' for value in row)}", flush=True)
            missed += [f"{path}: {finding}" for finding in findings]
        costs = list(measure_drag.weights(HTML / "_static" / "scene"))
        for path in pages(sys.argv[1:]):
            costs += measure_drag.figures(browser, host, HTML, path)
        print(*(cost for cost, _ in costs), sep="\n")
        missed += [f"{cost}: {wrong}" for cost, wrong in costs if wrong]
        print(first_output(browser, host))
    print("\n".join(missed))
    if not missed:
        print("All budgets are met.")
    return bool(missed)


if __name__ == "__main__":
    sys.exit(main())
