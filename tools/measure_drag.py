"""Measure what figures that answer the hand cost, for `tools/audit.py`.

Blocks of frames in which the first handle of a figure is led round, or its slider where it has no
handle, alternate with blocks in which the same scene is turned. Their means are compared, since
frames come in steps of a screen's 16.7 ms, and medians would jump by them. Of what a drag takes at
once the median is taken.
"""

import gzip
from collections.abc import Iterator
from pathlib import Path
from statistics import fmean, median

from playwright.sync_api import Browser, Locator, Page

# Kilobytes, packed: the viewer, what figures that answer the hand add to it, what one fetches.
HEAVIEST = {"viewer": 185, "explorables": 35}
FETCHED = 160
# A frame of a drag beside one of turning, and milliseconds of work for it.
RATIO, WORK = 1.5, 8
# In how many frames of a drag something has to move: numbers go in steps, and the hand in circles.
MOVED = 1 / 4
BLOCKS, FRAMES = 4, 20

# At its end a number is not dragged any further.
HALFWAY = """(sliders) => {
    for (const slider of sliders) {
        slider.value = (Number(slider.min) + Number(slider.max)) / 2;
        slider.dispatchEvent(new InputEvent("input", { bubbles: true }));
    }
}"""
# Frame after frame does one thing. Returned are the intervals between frames, the work in them, and
# the number of frames in which the figure's numbers changed.
RUN = """async ([figure, held, kind, frames]) => {
    const canvas = figure.querySelector('canvas');
    const middle = (element) => {
        const { left, top, width, height } = element.getBoundingClientRect();
        return [left + width / 2, top + height / 2];
    };
    const turn = (i) => {
        const key = i % 2 ? "ArrowLeft" : "ArrowRight";
        canvas.dispatchEvent(new KeyboardEvent("keydown", { key }));
    };
    const slide = (i) => {
        const slider = figure.querySelector("input[type=range]");
        slider.value = Number(slider.min) + ((slider.max - slider.min) * i) / frames;
        slider.dispatchEvent(new InputEvent("input", { bubbles: true }));
    };
    const [x, y] = held ? middle(held) : [];
    const move = (i) => {
        const angle = i / 4;
        const place = { clientX: x + 30 * Math.cos(angle), clientY: y + 30 * Math.sin(angle) };
        held.dispatchEvent(new PointerEvent("pointermove", place));
    };
    const act = kind === "turn" ? turn : held ? move : slide;
    const next = () => new Promise(requestAnimationFrame);
    // A browser hands over what a mouse does once the last frame is drawn, and its layout known.
    const drawn = () => new Promise((done) => setTimeout(done));
    const intervals = [], handlers = [];
    let [before, changed] = [await next(), 0];
    for (let i = 0; i < frames; i++) {
        const { values } = figure.dataset;
        const begin = performance.now();
        act(i);
        handlers.push(performance.now() - begin);
        changed += figure.dataset.values !== values;
        const now = await next();
        intervals.push(now - before);
        before = now;
        await drawn();
    }
    // The first frames still end what came before.
    return [intervals.slice(3), handlers.slice(3), changed];
}"""


def packed(file: Path) -> float:
    """Return the size of a file in kilobytes, as a server sends it."""
    return len(gzip.compress(file.read_bytes(), 9)) / 1000


def weights(static: Path) -> Iterator[str]:
    """Print how heavy the scripts of figures are, and yield what is too heavy."""
    for name, limit in HEAVIEST.items():
        weight = packed(max(static.glob(f"{name}-*.js"), key=lambda file: file.stat().st_mtime))
        print(f"{name}: {weight:.1f} kB gzipped")
        if weight > limit:
            yield f"{name}: {weight:.1f} kB gzipped, at most {limit}"


def figures(browser: Browser, host: str, html: Path, path: str) -> Iterator[str]:
    """Print what each figure of a page costs, and yield what costs too much."""
    page = browser.new_page(viewport={"width": 1000, "height": 900})
    page.goto(host + path)
    for figure in page.locator(".explorable").all():
        name = figure.get_attribute("data-name")
        scene = figure.locator(".scene")
        told = figure.get_attribute("data-explore")
        files = (told, *map(scene.get_attribute, ("data-scene", "data-shared")))
        fetched = sum(packed((html / path).parent / file) for file in files if file)
        turn, drag, work, moved = frames(page, figure)
        print(
            f"  {name}: fetches {fetched:.0f} kB gzipped; a frame of a drag takes {drag:.1f} ms, of"
            f" turning {turn:.1f} ms, ratio {drag / turn:.2f}; work {work:.1f} ms;"
            f" {moved:.0%} of its frames move it"
        )
        yield from (
            f"{name}: {what} {value:.1f}, at most {limit}"
            for what, value, limit in (
                ("kilobytes", fetched, FETCHED),
                ("drag beside turning", drag / turn, RATIO),
                ("milliseconds of work", work, WORK),
            )
            if value > limit
        )
        if moved < MOVED:
            yield f"{name}: {moved:.0%} of a drag's frames move it, at least {MOVED:.0%}"
    page.close()


def frames(page: Page, figure: Locator) -> tuple[float, float, float, float]:
    """Return milliseconds: a frame of turning, of a drag, its work; and how many frames moved."""
    figure.locator(".scene").scroll_into_view_if_needed()
    page.mouse.move(3, 3)
    page.mouse.move(9, 9)
    figure.locator(".scene[data-state=live]").wait_for(timeout=60_000)
    add = figure.locator("[data-action=add]")
    while add.count() and add.is_enabled():
        add.click()
    figure.locator("input[type=range]").evaluate_all(HALFWAY)
    handle = figure.locator(".scene [data-handle]:not([data-behind])").first
    held = None
    if handle.count():
        # Bodies move together to make room for those that were added.
        handle.element_handle().wait_for_element_state("stable")
        handle.hover(force=True)
        # What the mouse holds may lie over the handle.
        held = page.evaluate_handle("[...document.querySelectorAll(':hover')].at(-1)")
        page.mouse.down()
    element = figure.element_handle()
    turns, drags, works, moved = [], [], [], 0
    for _ in range(BLOCKS):
        turns += page.evaluate(RUN, [element, held, "turn", FRAMES])[0]
        intervals, handlers, changed = page.evaluate(RUN, [element, held, "drag", FRAMES])
        drags += intervals
        works += handlers
        moved += changed
    page.mouse.up()
    return fmean(turns), fmean(drags), median(works), moved / (BLOCKS * FRAMES)
