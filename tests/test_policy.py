"""The book works under the strictest policy that CONTRIBUTING tells its hosts to send."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from browser import QuietHandler, serve
from test_figures_in_browser import bring_live, settle

CONTRIBUTING = Path(__file__).parents[1] / "CONTRIBUTING.md"
# Once, because each of the thousand formulas of a page may break a rule.
LISTEN = """document.addEventListener("securitypolicyviolation", (event) => {
    violated(`${event.effectiveDirective} ${event.blockedURI}`);
}, { once: true });"""
Uses = list[Callable[[Any], None]]
THEME = "document.body.dataset.theme"


def policy() -> str:
    """The policy as CONTRIBUTING has it, on one line."""
    text = CONTRIBUTING.read_text("utf-8")
    [found] = re.findall(r"Content-Security-Policy: (.*?)\n *```", text, re.DOTALL)
    return " ".join(found.split())


def under(policy: str) -> type[QuietHandler]:
    """A server that sends a policy."""

    class Policed(QuietHandler):
        def end_headers(self) -> None:
            self.send_header("Content-Security-Policy", policy)
            super().end_headers()

    return Policed


def drag(page: Any) -> None:
    """Bring the first figure live that answers the hand, and move what it lets one move."""
    figure = page.locator(".explorable").first
    bring_live(figure.locator(".scene"))
    page.wait_for_function("document.querySelector('.explorable').dataset.values")
    before = figure.get_attribute("data-values")
    handle = figure.locator("[data-handle]:visible").first
    handle.scroll_into_view_if_needed()
    settle(page)
    box = handle.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + 30, box["y"] + 20, steps=4)
    page.mouse.up()
    settle(page)
    assert figure.get_attribute("data-values") != before


def answer(page: Any) -> None:
    """Check an answer in the first form."""
    form = page.locator(".answer-form").first
    for field in form.locator("input").all():
        field.fill("1")
    form.get_by_role("button").click()
    assert form.get_by_role("status").text_content()


def run(page: Any) -> None:
    """Run the first cell, if there is a button; hear from the page why it has not run."""
    button = page.locator("button[name=run]:visible")
    if button.count():
        button.first.click()
        page.wait_for_selector("[data-run=done], [data-run=error]", state="attached")
        for reason in page.locator("[data-run=error] .live-message").all_text_contents():
            page.evaluate("reason => violated(reason)", reason)


def turn(page: Any) -> None:
    """Bring the first scene live."""
    bring_live(page.locator(".scene").first)


def toggle_theme(page: Any) -> None:
    before = page.evaluate(THEME)
    page.locator(".theme-toggle:visible").first.click()
    assert before != page.evaluate(THEME)


def see_charts(page: Any) -> None:
    """Have every picture of the page drawn."""
    page.evaluate("document.querySelectorAll('img').forEach((img) => { img.loading = 'eager' })")
    page.wait_for_function("[...document.images].every((img) => img.naturalWidth)")


def ask(page: Any) -> None:
    """Send the form of the search."""
    page.locator("input[name=q]").fill("slerp")
    page.keyboard.press("Enter")


def search(page: Any) -> None:
    """Search from the field, and see the text around what is found."""
    ask(page)
    page.wait_for_selector("#search-results li p.context")


USES: dict[str, Uses] = {
    "book/index.html": [toggle_theme, turn, search],
    "book/05-control-points.html": [toggle_theme, drag, answer, run],
    "book/06-conclusions.html": [toggle_theme, see_charts, answer],
    "search.html?q=slerp": [toggle_theme, search],
}


def complaints(browser: Any, book: Path, policy: str, pages: dict[str, Uses]) -> list[str]:
    """Use pages under a policy, and return what the browser says against it."""
    said: list[str] = []
    for address, uses in pages.items():
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        page.expose_function("violated", lambda what: said.append(what))
        page.add_init_script(LISTEN)
        page.on("console", lambda message: message.type == "error" and said.append(message.text))
        page.on("pageerror", lambda error: said.append(str(error)))
        with serve(book.parent, under(policy)) as host:
            page.goto(f"{host}/{book.name}/{address}", wait_until="networkidle")
            for use in uses:
                use(page)
            # What has just gone wrong may still be on its way.
            page.wait_for_timeout(200)
            page.close()
    return said


def stricter(policy: str) -> dict[str, str]:
    """The policies that lack one source of the given one, by that source."""
    found = {}
    directives = [directive.split() for directive in policy.split("; ")]
    for i, (name, *sources) in enumerate(directives):
        for source in sources:
            rest = [other for other in sources if other != source] or ["'none'"]
            changed = [*directives[:i], [name, *rest], *directives[i + 1 :]]
            if source != "'none'":
                found[f"{name} {source}"] = "; ".join(map(" ".join, changed))
    return found


def test_pages_load_under_the_policy(browser: Any, book: Path) -> None:
    pages: dict[str, Uses] = {"book/03-ordinary-rotation.html": [], "search.html?q=slerp": []}
    assert complaints(browser, book, policy(), pages) == []
    without_fonts = stricter(policy())["font-src 'self'"]
    assert "font-src" in " ".join(complaints(browser, book, without_fonts, {"search.html": []}))


@pytest.mark.slow
@pytest.mark.parametrize("address", USES)
def test_pages_are_used_under_the_policy(browser: Any, book: Path, address: str) -> None:
    assert complaints(browser, book, policy(), {address: USES[address]}) == []


@pytest.mark.slow
@pytest.mark.parametrize("source", stricter(policy()))
def test_each_source_is_needed(browser: Any, book: Path, source: str) -> None:
    pages: dict[str, Uses] = {"book/05-control-points.html": [run], "search.html?q=slerp": [ask]}
    said = complaints(browser, book, stricter(policy())[source], pages)
    assert source.split()[0] in " ".join(said)
