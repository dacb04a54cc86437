"""Measure what a first run of a cell costs, for `tools/audit.py`: nothing cached, then all."""

import time

from playwright.sync_api import Browser, Page, Request

PAGE, CELL = "book/05-closed-curve.html", ".cell[data-cell=code-6]"


def first_output(browser: Browser, host: str) -> str:
    """Tell what is fetched by a click, and how long the output takes."""
    with browser.new_context(viewport={"width": 1000, "height": 900}) as context:
        page = context.new_page()
        page.goto(host + PAGE, wait_until="networkidle")
        requests: list[Request] = []
        context.on("requestfinished", lambda request: requests.append(request))
        cold = seconds_to_output(page)
        page.wait_for_load_state("networkidle")
        fetched = sum(request.sizes()["responseBodySize"] for request in requests) / 1e6
        page.goto(host + PAGE, wait_until="networkidle")
        warm = seconds_to_output(page)
    return f"Run fetches {fetched:.1f} MB; output after {cold:.1f} s, from the cache {warm:.1f} s"


def seconds_to_output(page: Page) -> float:
    """Run a cell, and wait until it is done."""
    begin = time.monotonic()
    page.locator(f"{CELL} button[name=run]").click()
    page.locator(f"{CELL}[data-run=done]").wait_for()
    return time.monotonic() - begin
