"""Measure what dragging a point costs, for `tools/audit.py`.

The page draws the closed curve through eight points. Blocks of frames in which a point is dragged
alternate with blocks in which the same scene is turned, and medians are compared. What the main
thread does for a drag is timed by itself: mathematics, shapes, numbers and charts first, then
everything else of the frame, with the drawing.
"""

import gzip
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser

PAGE, FIGURE = "book/05-closed-curve.html", ".explorable[data-name=closed-curve-by-hand]"
BLOCKS, FRAMES = 6, 25

# Frame after frame does one thing; the intervals between frames and the work in them are returned.
RUN = """async ([figure, kind, frames]) => {
    const handle = figure.querySelector('[data-handle=points-2]');
    const canvas = figure.querySelector('canvas');
    const box = handle.getBoundingClientRect();
    const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
    const act = (i) => {
        const angle = i / 4;
        const place = { clientX: x + 9 * Math.cos(angle) - 9, clientY: y + 9 * Math.sin(angle) };
        if (kind === "drag") handle.dispatchEvent(new PointerEvent("pointermove", place));
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


def weights(static: Path) -> Iterator[str]:
    """Tell how heavy the viewer is, and what figures that answer the hand add to it."""
    for name in ("viewer", "by-hand"):
        file = max(static.glob(f"{name}-*.js"), key=lambda file: file.stat().st_mtime)
        packed = len(gzip.compress(file.read_bytes(), 9))
        yield f"{name}: {packed / 1000:.1f} kB gzipped"


def frames(browser: Browser, host: str) -> str:
    """Compare frames in which a point is dragged with frames in which the scene is turned."""
    page = browser.new_page(viewport={"width": 1000, "height": 900})
    page.goto(host + PAGE)
    figure = page.locator(FIGURE)
    figure.locator(".scene").evaluate("element => element.scrollIntoView({block: 'center'})")
    page.mouse.move(3, 3)
    page.mouse.move(9, 9)
    figure.locator("[data-handle=points-2]").wait_for(timeout=30_000)
    for _ in range(4):
        figure.locator("[data-action=add]").click()
    box = figure.locator("[data-handle=points-2]").bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    found: dict[str, dict[str, list[float]]] = {
        kind: {"intervals": [], "handlers": []} for kind in ("turn", "drag")
    }
    for _ in range(BLOCKS):
        for kind, lists in found.items():
            run: dict[str, Any] = page.evaluate(RUN, [figure.element_handle(), kind, FRAMES])
            # The first frames still end what came before.
            for name, values in lists.items():
                values += run[name][3:]
    page.close()
    turn, drag = (median(found[kind]["intervals"]) for kind in ("turn", "drag"))
    work = median(found["drag"]["handlers"])
    return (
        f"dragging one of eight points: a frame takes {drag:.1f} ms, turning {turn:.1f} ms,"
        f" ratio {drag / turn:.2f}; mathematics, shapes and numbers {work:.1f} ms"
    )
