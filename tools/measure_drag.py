"""Measure what figures that answer the hand cost, for `tools/audit.py`.

Of each figure: what it fetches to go live, and what dragging costs. Blocks of frames in which its
first handle is dragged alternate with blocks in which the same scene is turned, and medians are
compared. What the main thread does for a drag is timed by itself: mathematics, shapes, numbers and
charts first, then everything else of the frame, with the drawing.
"""

import gzip
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Locator, Page

# Kilobytes, packed: the viewer, what figures that answer the hand add to it, what one fetches.
HEAVIEST = {"viewer": 185, "by-hand": 35}
FETCHED = 160
# A frame of a drag beside one of turning, and milliseconds of work for it.
RATIO, WORK = 1.5, 8
BLOCKS, FRAMES = 4, 20

# Frame after frame does one thing; the intervals between frames and the work in them are returned.
RUN = """async ([figure, kind, frames]) => {
    const canvas = figure.querySelector('canvas');
    const middle = ({ left, top, width, height }) => [left + width / 2, top + height / 2];
    const first = (figure.querySelector('.scene [data-handle]') ?? canvas).getBoundingClientRect();
    // What the mouse holds may lie over the first handle.
    figure.held ??= document.elementFromPoint(...middle(first));
    const { held } = figure;
    const [x, y] = middle(held.getBoundingClientRect());
    const act = (i) => {
        const angle = i / 4;
        const place = { clientX: x + 9 * Math.cos(angle) - 9, clientY: y + 9 * Math.sin(angle) };
        if (kind === "drag") held.dispatchEvent(new PointerEvent("pointermove", place));
        else {
            const key = i % 2 ? "ArrowLeft" : "ArrowRight";
            canvas.dispatchEvent(new KeyboardEvent("keydown", { key }));
        }
    };
    const next = () => new Promise(requestAnimationFrame);
    const intervals = [], handlers = [];
    let before = await next();
    for (let i = 0; i < frames; i++) {
        const begin = performance.now();
        act(i);
        handlers.push(performance.now() - begin);
        const now = await next();
        intervals.push(now - before);
        before = now;
    }
    return { intervals, handlers };
}"""


def median(values: list[float]) -> float:
    """Return the median of a list."""
    return sorted(values)[len(values) // 2]


def packed(file: Path) -> float:
    """Return the size of a file in kilobytes, as a server sends it."""
    return len(gzip.compress(file.read_bytes(), 9)) / 1000


def weights(static: Path) -> Iterator[tuple[str, str]]:
    """Yield how heavy the scripts of figures are, and what is wrong with that."""
    for name, limit in HEAVIEST.items():
        weight = packed(max(static.glob(f"{name}-*.js"), key=lambda file: file.stat().st_mtime))
        yield f"{name}: {weight:.1f} kB gzipped", "" if weight <= limit else f"at most {limit}"


def figures(browser: Browser, host: str, html: Path, path: str) -> Iterator[tuple[str, str]]:
    """Yield what each figure of a page costs, and what is wrong with that."""
    page = browser.new_page(viewport={"width": 1000, "height": 900})
    page.goto(host + path)
    for figure in page.locator(".explorable").all():
        name = figure.get_attribute("data-name")
        files = (
            figure.get_attribute("data-explore"),
            figure.locator(".scene").get_attribute("data-scene"),
        )
        fetched = sum(packed((html / path).parent / str(file)) for file in files)
        turn, drag, work = frames(page, figure)
        found = (
            f"{name}: fetches {fetched:.0f} kB gzipped; a frame of a drag takes {drag:.1f} ms, of"
            f" turning {turn:.1f} ms, ratio {drag / turn:.2f}; work {work:.1f} ms"
        )
        wrong = [
            limit
            for limit, over in (
                (f"at most {FETCHED} kB", fetched > FETCHED),
                (f"ratio at most {RATIO}", drag > RATIO * turn),
                (f"work at most {WORK} ms", work > WORK),
            )
            if over
        ]
        yield found, ", ".join(wrong)
    page.close()


def frames(page: Page, figure: Locator) -> tuple[float, float, float]:
    """Return milliseconds: a frame of turning, a frame of a drag, and the work for a drag."""
    figure.locator(".scene").evaluate(
        "element => element.scrollIntoView({block: 'center', behavior: 'instant'})"
    )
    page.mouse.move(3, 3)
    page.mouse.move(9, 9)
    figure.locator(".scene[data-state=live]").wait_for(timeout=60_000)
    add = figure.locator("[data-action=add]")
    while add.count() and add.is_enabled():
        add.click()
    found: dict[str, dict[str, list[float]]] = {
        kind: {"intervals": [], "handlers": []} for kind in ("turn", "drag")
    }
    handle = figure.locator(".scene [data-handle]").first
    box = handle.bounding_box() if handle.count() else None
    if box:
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        page.mouse.down()
    for _ in range(BLOCKS):
        for kind, lists in found.items():
            run: dict[str, Any] = page.evaluate(RUN, [figure.element_handle(), kind, FRAMES])
            # The first frames still end what came before.
            for name, values in lists.items():
                values += run[name][3:]
    page.mouse.up()
    turn, drag = (median(found[kind]["intervals"]) for kind in ("turn", "drag"))
    return turn, drag, median(found["drag"]["handlers"])
