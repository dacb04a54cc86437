"""What the tests of figures in a browser share: pages, scenes that come to life, and pictures."""

import base64
import functools
import io
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from explorables import EXPLORABLES, expected, spec
from PIL import Image
from playwright.sync_api import Route

ROOT = Path(__file__).parents[1]
PHONE = {"viewport": {"width": 390, "height": 800}, "has_touch": True, "is_mobile": True}
Open = Callable[..., Any]
Place = tuple[float, float]

# The size of a poster, if the device has two pixels for each of the page.
LIKE_A_POSTER = """
.scene, .scene-view { width: var(--scene-width) !important; max-width: none !important; }
.explorable { display: block !important; }
"""
# Keeps every WebGL context that the page opens.
CONTEXTS = """
    window.contexts = [];
    const getContext = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        const context = getContext.call(this, kind, ...rest);
        if (kind.startsWith("webgl") && context && !contexts.includes(context)) {
            contexts.push(context);
        }
        return context;
    };
"""
# Software draws a scene twice as fast without smooth edges.
ROUGH = """
    const smooth = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, options) {
        return smooth.call(this, kind, { ...options, antialias: false });
    };
"""
NO_WEBGL = """
    const getContext = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        return kind.startsWith("webgl") ? null : getContext.call(this, kind, ...rest);
    };
"""
TOLD = """figure => [
    JSON.parse(figure.dataset.values),
    Object.fromEntries([...figure.querySelectorAll("output")].map(o => [o.name, o.textContent])),
]"""
PICTURES = """async (element, which) => {
    const draw = async (source) => {
        if (source.decode) await source.decode();
        const { width, height } = element.querySelector("canvas");
        const paper = Object.assign(document.createElement("canvas"), { width, height });
        paper.getContext("2d").drawImage(source, 0, 0, width, height);
        return paper.toDataURL();
    };
    return Promise.all([...element.querySelectorAll(which)].map(draw));
}"""
COMPLAINTS = """async (where) => (await axe.run(where)).violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target }) => `${id}: ${target}`))"""
INK = "element => getComputedStyle(element.querySelector('[data-label=O] > *')).color"
AT_REST = """() => {
    const before = window.scrolled;
    window.scrolled = scrollY;
    return before === scrollY;
}"""
LABELS = """(element) => [...element.querySelectorAll(".scene-label")].map((label) => {
    const { left, top, width, height } = label.getBoundingClientRect();
    const box = element.getBoundingClientRect();
    // Labels give way to each other.
    const aside = label.style.getPropertyValue("--aside") || "0 0";
    const [dx, dy] = aside.split(" ").map(parseFloat);
    return {
        name: label.dataset.label,
        text: label.textContent,
        seen: getComputedStyle(label).visibility === "visible",
        left: (left - dx + width / 2 - box.left) / box.width,
        top: (top - dy + height / 2 - box.top) / box.height,
    };
})"""


@pytest.fixture
def open_page(browser: Any) -> Iterator[Open]:
    """Open pages, each in a context of its own; any complaint is a failure."""
    complaints: list[str] = []
    contexts = []

    def open_one(
        url: str,
        script: str = "",
        quiet: bool = True,
        answers: dict[str, dict[str, Any]] | None = None,
        **options: Any,
    ) -> Any:
        context = browser.new_context(**{"viewport": {"width": 1000, "height": 800}} | options)
        contexts.append(context)
        page = context.new_page()
        # Where a picture is compared with a poster, it has its size and its edges.
        page.add_init_script(script if "device_scale_factor" in options else ROUGH + script)
        for files, answer in (answers or {}).items():
            page.route(files, functools.partial(Route.fulfill, **answer))
        own = (url.rpartition(":")[0], "data:", "blob:")

        def look_at(message: Any) -> None:
            if message.type in ("error", "warning"):
                complaints.append(f"console: {message.text}")

        def look_where(request: Any) -> None:
            if not request.url.startswith(own):
                complaints.append(request.url)

        if quiet:
            page.on("pageerror", lambda error: complaints.append(f"script: {error}"))
            page.on("console", look_at)
            page.on("request", look_where)
        page.goto(url)
        return page

    yield open_one
    for context in contexts:
        context.close()
    assert complaints == []


@pytest.fixture(scope="session")
def pages(book: Path) -> dict[str, str]:
    """The chapter in which each figure stands; the first page shows one without its controls."""
    texts = {file: file.read_text("utf-8") for file in sorted(book.glob("book/*.html"))}
    return {
        name: file.relative_to(book).as_posix()
        for file, text in texts.items()
        for name in EXPLORABLES
        if f'data-name="{name.replace("_", "-")}"' in text
    }


@pytest.fixture
def open_figure(site: str, pages: dict[str, str], open_page: Open) -> Open:
    """Open the page of a figure, and return the figure."""

    def open_one(name: str, hash: str = "", **options: Any) -> Any:
        return figure_in(open_page(f"{site}/{pages[name]}{hash}", **options), name)

    return open_one


def figure_in(page: Any, name: str) -> Any:
    return page.locator(f'.explorable[data-name="{name.replace("_", "-")}"]')


def come_to(scene: Any) -> None:
    """Scroll to a scene, as a reader does."""
    scene.evaluate("element => element.scrollIntoView({block: 'center', behavior: 'instant'})")
    scene.page.mouse.move(3, 3)
    scene.page.mouse.move(5, 5)


def wait_until(element: Any, condition: str) -> None:
    """Wait until something, written in JavaScript, is true of an element."""
    element.page.wait_for_function(condition, arg=element.element_handle(), timeout=20_000)


def bring_live(scene: Any) -> Any:
    """Scroll to a scene and wait until it is live."""
    come_to(scene)
    wait_until(scene, "element => ['live', 'failed'].includes(element.dataset.state)")
    assert scene.get_attribute("data-state") == "live"
    return scene


def arrived(figure: Any) -> dict[str, Any]:
    """Wait, without a sign of a reader, until a figure is live; return its values."""
    wait_until(figure, "element => element.dataset.values")
    settle(figure.page)
    return values(figure)


def live(figure: Any) -> Any:
    """Bring the scene of a figure live, and wait for its values."""
    bring_live(figure.locator(".scene"))
    arrived(figure)
    return figure


def settle(page: Any) -> None:
    """Wait until the browser has drawn the requested frame."""
    page.evaluate("() => new Promise(done => requestAnimationFrame(() => setTimeout(done, 60)))")


def values(figure: Any) -> dict[str, Any]:
    return json.loads(figure.get_attribute("data-values"))


def check(name: str, figure: Any) -> dict[str, Any]:
    """Compare the numbers of a figure with those of the oracle; return them."""
    settle(figure.page)
    # At once, because a figure may be playing.
    told, texts = figure.evaluate(TOLD)
    outputs = expected(name, {key: told[key] for key in EXPLORABLES[name].inputs})
    assert told.get("refused") == outputs.get("refused")
    if "refused" in told:
        return told
    for output in spec(name)["outputs"]:
        key = output["name"]
        text = texts[key]
        if isinstance(outputs[key], str):
            assert told[key] == outputs[key] == text, told
            continue
        np.testing.assert_allclose(told[key], outputs[key], rtol=2e-6, atol=2e-6, err_msg=str(told))
        plain = text.replace("\N{MINUS SIGN}", "-").removesuffix(output["unit"]).replace(",", "")
        rounding = 0.51 * 10 ** -output["digits"]
        np.testing.assert_allclose(
            np.array(plain.split(), float), np.ravel(told[key]), atol=rounding
        )
    return told


def center(handle: Any) -> Place:
    box = handle.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def fling(page: Any, start: Place, *ends: Place, steps: int = 1) -> None:
    """Drag by mouse: one event for each place, or steps on the way to it."""
    page.mouse.move(*start)
    page.mouse.down()
    for end in ends:
        page.mouse.move(*end, steps=steps)
    page.mouse.up()


def swipe(page: Any, *fingers: list[Place], pause: int = 0) -> None:
    """Move fingers over the screen; all paths have the same number of places."""
    session = page.context.new_cdp_session(page)
    for i, places in enumerate(zip(*fingers, strict=True)):
        points = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(places)]
        kind = "touchStart" if i == 0 else "touchMove"
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        page.wait_for_timeout(pause)
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


def drag(scene: Any, dx: float, dy: float, down: float = 0.5) -> None:
    """Turn a scene by mouse, held somewhere in its middle column."""
    box = scene.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + down * box["height"]
    fling(scene.page, (x, y), (x + dx, y + dy))
    settle(scene.page)


def turn(figure: Any, selector: str, *keys: str) -> None:
    """Press keys on a control or a handle."""
    control = figure.locator(selector)
    control.focus()
    for key in keys:
        control.page.keyboard.press(key)


def complaints_of_axe(page: Any, where: str) -> list[str]:
    """What axe finds wrong with a part of a page, and where."""
    page.add_script_tag(path=ROOT / "node_modules" / "axe-core" / "axe.min.js")
    return page.evaluate(COMPLAINTS, where)


def pictures(scene: Any, which: str = "img:not(.scene-stacked), .scene-canvas") -> list[np.ndarray]:
    """The poster and the live picture, at the same size."""
    return [
        np.asarray(Image.open(io.BytesIO(base64.b64decode(url.partition(",")[2]))), float)
        for url in scene.evaluate(PICTURES, which)
    ]


def live_picture(scene: Any) -> np.ndarray:
    return pictures(scene, ".scene-canvas")[0]


def on_white(picture: np.ndarray) -> np.ndarray:
    return 255 + (picture[..., :3] - 255) * picture[..., 3:] / 255


def difference(a: np.ndarray, b: np.ndarray) -> float:
    """The mean difference of two pictures on a white page."""
    return float(np.abs(on_white(a) - on_white(b)).mean())


def largest_difference(a: np.ndarray, b: np.ndarray, side: int = 16) -> float:
    """The largest difference of the mean colours of two pictures on white, square by square."""
    rows, columns = (length // side for length in a.shape[:2])
    squares = (rows, side, columns, side, 3)
    means = [
        on_white(picture)[: rows * side, : columns * side].reshape(squares).mean(axis=(1, 3))
        for picture in (a, b)
    ]
    return float(np.abs(np.subtract(*means)).max())


def lost_contexts(page: Any) -> list[bool]:
    """Tell for each WebGL context of a page whether it is lost."""
    return page.evaluate("contexts.map(context => context.isContextLost())")


def loaded(page: Any) -> dict[str, float]:
    """The files that a page has asked for, and how long after its load event, in milliseconds."""
    waits = page.evaluate(
        """() => {
            const [{ loadEventStart }] = performance.getEntriesByType("navigation");
            return performance.getEntriesByType("resource")
                .map(({ name, startTime }) => [name, startTime - loadEventStart]);
        }"""
    )
    return {name.rpartition("/")[2].partition("?")[0]: wait for name, wait in waits}
