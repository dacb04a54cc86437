"""What a link leads to shows beside it, for a mouse and for the keyboard, and for nobody else."""

from typing import Any

import pytest

OPEN = ".look:popover-open"
EQUATION = "article a[href*='#equation-eq-']:not(.headerlink)"
# What the box holds, by the link.
SHOWN = {
    EQUATION: ".katex-display",
    "article a[href*='errata.html#erratum-']": "h2 ~ p:has-text('What it should be')",
    "article a.first-use": "dt + dd",
    "article a[href$='#figure-1']:not(.headerlink)": ".scene img",
    "#the-claims-judged a[href*='#claim-']": "p:has-text('holds')",
}
TO_THE_MIDDLE = "link => link.scrollIntoView({ block: 'center', behavior: 'instant' })"
FITS = """box => {
    const { left, top, right, bottom } = box.getBoundingClientRect();
    return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
}"""


def read(browser: Any, site: str, name: str, **how: Any) -> Any:
    """Open a page of the book."""
    page = browser.new_page(**how)
    page.goto(f"{site}/book/{name}.html")
    return page


def hover(page: Any, link: str) -> Any:
    """Rest the mouse on the first link that is in view, and return the box."""
    first = page.locator(link).locator("visible=true").first
    first.evaluate(TO_THE_MIDDLE)
    first.hover()
    return page.locator(OPEN)


def test_a_link_shows_what_it_leads_to(browser: Any, site: str) -> None:
    page = read(browser, site, "03-ordinary-rotation")
    # Errata and claims are folded.
    page.locator("details:has(a[href*='errata.html#']) > summary").first.click()
    page.locator("#the-claims-judged summary").first.click()
    for link, holds in SHOWN.items():
        box = hover(page, link)
        box.locator(holds).first.wait_for()
        assert box.evaluate(FITS)
        assert not box.locator("[id], .headerlink, .explorable-panel").count()
        page.keyboard.press("Escape")
        assert not box.count()

    # Whoever reads on in the box keeps it.
    hover(page, EQUATION).wait_for()
    box.hover()
    page.wait_for_timeout(400)
    assert box.count()
    page.emulate_media(media="print")
    assert not box.is_visible()
    page.emulate_media(media="screen")
    page.mouse.move(2, 2)
    box.wait_for(state="detached")

    # The keyboard has just been used, so that what gets the focus shows it.
    page.keyboard.press("Tab")
    link = page.locator(EQUATION).locator("visible=true").last
    link.focus()
    box.locator(".katex-display").wait_for()
    # The page scrolls to the link, smoothly, and the box goes with it.
    page.wait_for_function(FITS, arg=box.element_handle())
    page.keyboard.press("Tab")
    assert not page.locator(".look:popover-open .katex-display").count()


@pytest.mark.slow
def test_a_finger_only_follows_links(browser: Any, site: str) -> None:
    page = read(browser, site, "03-ordinary-rotation", has_touch=True, is_mobile=True)
    page.evaluate("addEventListener('click', event => event.preventDefault())")
    link = page.locator(EQUATION).locator("visible=true").first
    link.evaluate(TO_THE_MIDDLE)
    link.tap()
    page.wait_for_timeout(600)
    assert not page.locator(OPEN).count()


@pytest.mark.slow
def test_the_key_that_closes_the_box_leaves_the_slides_alone(browser: Any, site: str) -> None:
    page = read(browser, site, "03-ordinary-rotation")
    page.get_by_role("button", name="Slides").click()
    box = hover(page, "article a.first-use")
    box.wait_for()
    page.keyboard.press("Escape")
    assert not box.count()
    assert page.locator("html.presenting").count()
    page.keyboard.press("Escape")
    assert not page.locator("html.presenting").count()


@pytest.mark.slow
def test_a_figure_is_styled_on_a_page_without_figures(browser: Any, site: str) -> None:
    box = hover(read(browser, site, "teaching"), "article a[href$='#picture-2-c']")
    box.locator(".scene-label").first.wait_for()
    label = box.locator(".scene-label").first
    label.evaluate("label => new Promise(done => setTimeout(done, 300))")
    assert label.evaluate("label => getComputedStyle(label).position") == "absolute"
