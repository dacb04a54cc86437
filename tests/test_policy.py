"""The book works under the strictest policy that MAINTAINING.md tells hosts to send."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from browser import QuietHandler, serve
from live_pages import ROOT, bring_live

# Once, because each of the thousand formulas of a page may break a rule.
LISTEN = """document.addEventListener("securitypolicyviolation", (event) => {
    violated(`${event.effectiveDirective} ${event.blockedURI}`);
}, { once: true });"""
Use = Callable[[Any], None]


def policy() -> str:
    """The policy, on one line."""
    text = (ROOT / ".github" / "MAINTAINING.md").read_text("utf-8")
    [found] = re.findall(r"Content-Security-Policy: (.*?)\n *```", text, re.DOTALL)
    return " ".join(found.split())


def run(page: Any) -> None:
    """Run the first cell, if there is a button; hear from the page why it has not run."""
    for button in page.locator("button[name=run]:visible").all()[:1]:
        button.click()
        page.wait_for_selector("[data-run=done], [data-run=error]", state="attached")
        for reason in page.locator("[data-run=error] .live-message").all_text_contents():
            page.evaluate("reason => violated(reason)", reason)


def search(page: Any) -> None:
    """Send the form of the search."""
    page.locator("input[name=q]").fill("slerp")
    page.keyboard.press("Enter")


def see(page: Any) -> None:
    """See all pictures in the other theme, a figure that can be moved, and a judged answer."""
    page.locator(".theme-toggle:visible").first.click()
    page.evaluate("for (const img of document.images) img.loading = 'eager'")
    page.wait_for_function("() => [...document.images].every((img) => img.naturalWidth)")
    for scene in page.locator(".scene").all()[:1]:
        bring_live(scene)
    for form in page.locator(".answer-form").all()[:1]:
        for field in form.locator("input").all():
            field.fill("1")
        form.get_by_role("button").click()
        assert form.get_by_role("status").text_content()


def complaints(browser: Any, book: Path, policy: str, address: str, *uses: Use) -> str:
    """Open a page under a policy, use it, and return what the browser says against it."""

    class Policed(QuietHandler):
        def end_headers(self) -> None:
            self.send_header("Content-Security-Policy", policy)
            super().end_headers()

    said: list[str] = []
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    page.expose_function("violated", lambda what: said.append(what))
    page.add_init_script(LISTEN)
    page.on("console", lambda message: message.type == "error" and said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    with serve(book.parent, Policed) as host:
        page.goto(f"{host}/{book.name}/{address}", wait_until="networkidle")
        for use in uses:
            use(page)
        # What has just gone wrong may still be on its way.
        page.wait_for_timeout(200)
        page.close()
    return " ".join(said)


def test_pages_load_under_the_policy(browser: Any, book: Path) -> None:
    for address in ("book/03-ordinary-rotation.html", "search.html?q=slerp"):
        assert complaints(browser, book, policy(), address) == ""
    without_fonts = policy().replace("font-src 'self'", "font-src 'none'")
    assert "font-src" in complaints(browser, book, without_fonts, "search.html")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["index", "05-control-points", "06-conclusions"])
def test_pages_are_used_under_the_policy(browser: Any, book: Path, name: str) -> None:
    assert complaints(browser, book, policy(), f"book/{name}.html", see, run, search) == ""
