"""Measure what the first run of a cell costs, for `tools/audit.py`.

A reader opens a page with nothing in the browser's cache and presses *Run*. The page is opened
again, with all of it in the cache, and the cell is run; then it is endless, is stopped, and runs.
"""

import time
from pathlib import Path

from playwright.sync_api import Browser, Locator, Request

PAGE, CELL = "book/05-closed-curve.html", ".cell[data-cell=code-6]"
ENDLESS = "while True:\n    pass"


def first_output(browser: Browser, host: str) -> str:
    """Tell what is fetched by a click, how long the output takes, and how the tab grows."""
    with browser.new_context(viewport={"width": 1000, "height": 900}) as context:
        page = context.new_page()
        requests: list[Request] = []
        context.on("requestfinished", lambda r: requests.append(r))
        page.goto(host + PAGE, wait_until="networkidle")
        cell = page.locator(CELL)
        before, small = len(requests), memory(browser)
        cold = seconds_to_output(cell)
        large = memory(browser)
        page.wait_for_load_state("networkidle")
        sizes = [r.sizes()["responseBodySize"] for r in requests[before:]]
        page.goto(host + PAGE, wait_until="networkidle")
        warm = seconds_to_output(cell)
        code = cell.locator(".cm-content")
        written = code.inner_text()
        code.fill(ENDLESS)
        cell.locator("button[name=run]").click()
        page.locator(f"{CELL}[data-run=running]").wait_for()
        page.locator("button[name=stop]:visible").first.click()
        code.fill(written)
        again = seconds_to_output(cell)
    return (
        f"Run fetches {sum(sizes) / 1e6:.1f} MB; first output after {cold:.1f} s, from the"
        f" cache {warm:.1f} s, after Stop {again:.1f} s; the tab grows by {large - small:.0f} MB"
    )


def seconds_to_output(cell: Locator) -> float:
    """Run a cell, and wait until it is done."""
    begin = time.monotonic()
    cell.locator("button[name=run]").click()
    cell.page.locator(f"{CELL}[data-run=done]").wait_for()
    return time.monotonic() - begin


def memory(browser: Browser) -> float:
    """Return the megabytes that the tabs of a browser take; 0 where the system does not say."""
    found = browser.new_browser_cdp_session().send("SystemInfo.getProcessInfo")
    tabs = [p["id"] for p in found["processInfo"] if p["type"] == "renderer"]
    states = [Path(f"/proc/{process}/statm") for process in tabs]
    return sum(int(s.read_text().split()[1]) * 4096 / 1e6 for s in states if s.exists())
