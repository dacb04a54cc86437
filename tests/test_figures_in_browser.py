"""Scenes in a real browser: the book's own, and a small book of demanding ones."""

import base64
import functools
import io
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
import pytest
import pyvista
from browser import QuietHandler, serve
from demanding import SIZE, demanding_scene, scene_of_all_looks
from PIL import Image
from playwright.sync_api import Route

from rotedu.figures.backend import BookFigure, book_figure

ROOT = Path(__file__).parents[1]
AXE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
# Mean difference, out of 255, between the poster and the first frame: over the whole picture, and
# away from edges, where both surely show the same part. WebP alone accounts for 1.
TOLERANCE, TOLERANCE_INSIDE = 1.0, 4.0
MANY = 18
Open = Callable[..., Any]
# The size of a poster, if the device has two pixels for each of the page.
LIKE_A_POSTER = """
.scene, .scene-view { width: var(--scene-width) !important; max-width: none !important; }
.explorable { display: block !important; }
"""
# A theme without styles of its own, so everything visible comes with the scenes.
CONFIGURATION = """
extensions = ["browser_libraries", "myst_nb", "rotedu.figures.pages", "sphinxcontrib.katex"]
root_doc = "one"
html_theme = "basic"
html_sidebars = {"**": []}
html_math_renderer = "katex"
katex_prerender = True
nb_execution_mode = "off"
nb_ipywidgets_js = {}
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
FRAMES = """
    window.frames_drawn = 0;
    const drawImage = CanvasRenderingContext2D.prototype.drawImage;
    CanvasRenderingContext2D.prototype.drawImage = function (...rest) {
        window.frames_drawn += 1;
        return drawImage.apply(this, rest);
    };
"""
SAVE_DATA = "Object.defineProperty(navigator, 'connection', {value: {saveData: true}})"
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
# How long after the page's load event the browser has asked for each file, in milliseconds.
WAITS = """() => {
    const [{ loadEventStart }] = performance.getEntriesByType("navigation");
    return performance.getEntriesByType("resource")
        .map(({ name, startTime }) => [name, startTime - loadEventStart]);
}"""
INK = "element => getComputedStyle(element.querySelector('[data-label=O] > *')).color"
AT_REST = """() => {
    const before = window.scrolled;
    window.scrolled = scrollY;
    return before === scrollY;
}"""
SPACE = "element => [element.offsetHeight, element.closest('figure').offsetHeight]"
LABELS = """(element) => [...element.querySelectorAll(".scene-label")].map((label) => {
    const { left, top, width, height } = label.getBoundingClientRect();
    const box = element.getBoundingClientRect();
    // Labels give way to each other.
    const push = (way) => parseFloat(label.style.getPropertyValue(way)) || 0;
    const [dx, dy] = [push("--dx"), push("--dy")];
    return {
        name: label.dataset.label,
        text: label.textContent,
        seen: getComputedStyle(label).visibility === "visible",
        left: (left - dx + width / 2 - box.left) / box.width,
        top: (top - dy + height / 2 - box.top) / box.height,
    };
})"""


class Strict(QuietHandler):
    """Serves files under a policy that allows scripts from this host alone, none inline."""

    def end_headers(self) -> None:
        policy = "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:"
        self.send_header("Content-Security-Policy", policy)
        super().end_headers()


def notebook_of(figures: list[BookFigure]) -> nbformat.NotebookNode:
    """A notebook that has run and shows figures."""
    outputs = [
        nbformat.v4.new_output("display_data", figure._repr_mimebundle_()) for figure in figures
    ]
    cells = [
        nbformat.v4.new_markdown_cell("# Scenes"),
        nbformat.v4.new_code_cell("plotter.show()", outputs=outputs),
        nbformat.v4.new_markdown_cell('<div style="height: 2000px"></div>'),
    ]
    metadata = {"orphan": True, "language_info": {"name": "python", "pygments_lexer": "python"}}
    return nbformat.v4.new_notebook(cells=cells, metadata=metadata)


def build(source: Path, **pages: list[Any]) -> Path:
    """Write pages with figures and build them in the same way as the book."""
    (source / "conf.py").write_text(CONFIGURATION)
    for name, figures in pages.items():
        nbformat.write(notebook_of(figures), source / f"{name}.ipynb")
    icon = f"html_favicon={ROOT}/book/_static/favicon.svg"
    command = [sys.executable, "-m", "sphinx", "-W", "-D", icon, source, source / "html"]
    path = os.environ | {"PYTHONPATH": str(ROOT / "book" / "_ext")}
    run = subprocess.run(command, env=path, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    return source / "html"


@pytest.fixture(scope="module")
def small_book(book: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A page with one demanding scene, and one with another beside it."""
    figure, looks = book_figure(demanding_scene()), book_figure(scene_of_all_looks())
    return build(tmp_path_factory.mktemp("small"), one=[figure], both=[figure, looks])


@pytest.fixture(scope="module")
def strict_site(small_book: Path) -> Iterator[str]:
    with serve(small_book, Strict) as site:
        yield site


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

        def complain(what: str) -> None:
            if quiet:
                complaints.append(what)

        def look_at(message: Any) -> None:
            if message.type in ("error", "warning"):
                complain(f"console: {message.text}")

        def look_where(request: Any) -> None:
            if not request.url.startswith((url.rpartition(":")[0], "data:", "blob:")):
                complain(request.url)

        page.on("pageerror", lambda error: complain(f"script: {error}"))
        page.on("console", look_at)
        page.on("request", look_where)
        page.goto(url)
        return page

    yield open_one
    for context in contexts:
        context.close()
    assert complaints == []


@pytest.fixture
def one(strict_site: str, open_page: Open) -> Open:
    """Open the page with one scene, and return the scene."""
    return lambda **options: open_page(f"{strict_site}/one.html", **options).locator(".scene")


def come_to(scene: Any) -> None:
    """Scroll to a scene, as a reader does."""
    scene.evaluate("element => element.scrollIntoView({block: 'center'})")
    scene.page.mouse.move(3, 3)
    scene.page.mouse.move(5, 5)


def bring_live(scene: Any) -> Any:
    """Scroll to a scene and wait until it is live."""
    come_to(scene)
    scene.page.wait_for_function(
        "element => ['live', 'failed'].includes(element.dataset.state)",
        arg=scene.element_handle(),
        timeout=20_000,
    )
    assert scene.get_attribute("data-state") == "live"
    return scene


def settle(page: Any) -> None:
    """Wait until the browser has drawn the requested frame."""
    page.evaluate("() => new Promise(done => requestAnimationFrame(() => setTimeout(done, 60)))")


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


def inside(a: np.ndarray, b: np.ndarray, depth: int = 3) -> np.ndarray:
    """The places where both pictures show something, some pixels away from any edge."""
    both = (a[..., 3] > 0) & (b[..., 3] > 0)
    steps = range(-depth, depth + 1)
    return np.logical_and.reduce(
        [np.roll(both, (i, j), (0, 1)) for i in steps for j in steps if i * j == 0]
    )


def compare_with_poster(scene: Any, where: str) -> np.ndarray:
    """Return the first frame, after checking that it looks like the poster."""
    poster, first = pictures(scene)
    assert (first[..., 3] > 0).mean() > 0.005, where
    assert difference(poster, first) < TOLERANCE, where
    core = inside(poster, first)
    assert np.abs(on_white(poster) - on_white(first))[core].mean() < TOLERANCE_INSIDE, where
    return first


def cut_off(picture: np.ndarray) -> float:
    """The fraction of the border of a picture that is not empty."""
    opacity = picture[..., 3]
    border = np.concatenate([opacity[0], opacity[-1], opacity[:, 0], opacity[:, -1]])
    return float((border > 0).mean())


def assert_labels_stay(scene: Any, at_rest: list[dict[str, Any]]) -> None:
    """Check that the labels keep their places, and that as many are visible."""
    for now, before in zip(scene.evaluate(LABELS), at_rest, strict=True):
        assert now["text"]
        assert now["seen"] == before["seen"], now
        if not now["seen"]:
            continue
        assert abs(now["left"] - before["left"]) < 0.002, now
        assert abs(now["top"] - before["top"]) < 0.002, now
        assert 0 < now["left"] < 1, now
        assert 0 < now["top"] < 1, now


def middle(scene: Any) -> tuple[float, float]:
    box = scene.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def drag(scene: Any, dx: float, dy: float, down: float = 0.5) -> None:
    x, y = middle(scene)
    y += (down - 0.5) * scene.bounding_box()["height"]
    mouse = scene.page.mouse
    mouse.move(x, y)
    mouse.down()
    mouse.move(x + dx, y + dy)
    mouse.up()
    settle(scene.page)


def lost_contexts(page: Any) -> list[bool]:
    """Tell for each WebGL context of a page whether it is lost."""
    return page.evaluate("contexts.map(context => context.isContextLost())")


def loaded(page: Any) -> list[str]:
    """Names of the files that a page has loaded."""
    names = page.evaluate("performance.getEntriesByType('resource').map(entry => entry.name)")
    return [name.rpartition("/")[2] for name in names]


@pytest.mark.parametrize("which", ["few", pytest.param("all", marks=pytest.mark.slow)])
def test_scenes_of_the_book_live(book: Path, site: str, open_page: Open, which: str) -> None:
    """Each scene shows its labels, looks like its poster, turns and comes back, in one context.

    Few is the first scene of one page; ``make test-slow`` takes all scenes of all pages.
    """
    few = "03-ordinary-rotation"
    files = {file.relative_to(book).as_posix(): file for file in sorted(book.rglob("*.html"))}
    names = [name for name, file in files.items() if 'class="scene"' in file.read_text("utf-8")]
    assert len(names) >= 10
    if which == "few":
        names = [name for name in names if Path(name).stem == few]
    for name in names:
        # Nothing plays by itself.
        calm = {"reduced_motion": "reduce"}
        page = open_page(f"{site}/{name}", CONTEXTS, device_scale_factor=2, **calm)
        # Use the poster's own size, because scaling would blur its edges.
        page.add_style_tag(content=LIKE_A_POSTER)
        scenes = page.locator(".scene").all()
        for i, scene in enumerate(scenes if which == "all" else scenes[:1]):
            where = f"{name}, scene {i}"
            at_rest = scene.evaluate(LABELS)
            space = scene.evaluate(SPACE)
            bring_live(scene)
            assert scene.evaluate(SPACE) == space, where
            assert_labels_stay(scene, at_rest)
            first = compare_with_poster(scene, where)
            # In the middle of Figure 1 an arrow would be dragged.
            drag(scene, 70, 25, down=0.25)
            after = live_picture(scene)
            assert difference(first, after) > 0.3, where
            assert cut_off(after) <= cut_off(first) + 0.002, where
            scene.get_by_role("button", name="Reset the view").click()
            settle(page)
            assert difference(first, live_picture(scene)) < 0.01, where
        assert lost_contexts(page) == [False], name
        page.context.close()


@pytest.mark.slow
def test_the_page_shows_through_light_and_dark(site: str, open_page: Open) -> None:
    inks, papers = [], []
    for scheme in ("light", "dark"):
        page = open_page(f"{site}/book/03-ordinary-rotation.html", color_scheme=scheme)
        scene = bring_live(page.locator(".scene").first)
        assert live_picture(scene)[0, 0, 3] == 0
        inks.append(scene.evaluate(INK))
        papers.append(np.median(Image.open(io.BytesIO(scene.screenshot())).convert("L")))
    assert inks[0] != inks[1]
    assert papers[0] > 200
    assert papers[1] < 60


@pytest.mark.slow
def test_all_looks_are_those_of_the_poster(strict_site: str, open_page: Open) -> None:
    page = open_page(f"{strict_site}/both.html", device_scale_factor=2)
    for i, scene in enumerate(page.locator(".scene").all()):
        compare_with_poster(bring_live(scene), f"scene {i}")


def test_the_ball_is_that_of_the_poster(one: Open) -> None:
    """Its lines are where they must be, those before clearer than those behind."""
    scene = one(device_scale_factor=2)
    scene.page.add_style_tag(content=LIKE_A_POSTER)
    plotter = demanding_scene()
    matrix = pyvista.array_from_vtkmatrix(
        plotter.camera.GetCompositeProjectionTransformMatrix(SIZE[0] / SIZE[1], -1, 1)
    )

    def opacity(picture: np.ndarray, azimuth: float, height: float) -> float:
        """The largest opacity of nine pixels about a place of the sphere."""
        a, b = np.deg2rad([azimuth, height])
        x, y, _, w = matrix @ [np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b), 1]
        column, row = ((1 + np.array([x, -y]) / w) * SIZE).round().astype(int)
        return float(picture[row - 1 : row + 2, column - 1 : column + 2, 3].max() / 255)

    for picture in pictures(bring_live(scene)):
        before, behind = opacity(picture, -40, 30), opacity(picture, 165, -30)
        assert opacity(picture, 165, -22) + 0.1 < behind < before - 0.15 < 0.6


@pytest.mark.slow
def test_many_scenes_share_one_context(book: Path, tmp_path: Path, open_page: Open) -> None:
    many = MANY * [book_figure(demanding_scene())]
    with serve(build(tmp_path, one=many), Strict) as site:
        page = open_page(f"{site}/one.html", CONTEXTS)
        scenes = page.locator(".scene").all()
        assert len(scenes) == MANY
        for scene in scenes:
            bring_live(scene)
        assert lost_contexts(page) == [False]
        assert difference(live_picture(scenes[0]), live_picture(scenes[-1])) < 0.01
        assert sum(name.startswith("viewer-") for name in loaded(page)) == 1


def test_nothing_heavy_comes_before_the_page(one: Open) -> None:
    """A scene in sight goes live without a sign of a reader, but only when all else is there."""
    scene = one()
    scene.page.wait_for_function(
        "element => element.dataset.state === 'live'", arg=scene.element_handle(), timeout=20_000
    )
    waits = scene.page.evaluate(WAITS)
    heavy = [wait for name, wait in waits if "viewer-" in name or name.endswith(".glb")]
    assert len(heavy) == 2
    assert min(heavy) >= 0
    assert "loader.js" in {name.partition("?")[0] for name in loaded(scene.page)}


def test_labels_follow_and_hide(one: Open) -> None:
    scene = bring_live(one())
    before = scene.evaluate(LABELS)
    assert {label["seen"] for label in before} == {True, False}
    # Half a turn: what was behind the ball is in front.
    scene.locator("canvas").focus()
    for _ in range(24):
        scene.page.keyboard.press("ArrowRight")
    settle(scene.page)
    after = {label["text"]: label["seen"] for label in scene.evaluate(LABELS)}
    hidden = [label["text"] for label in before if not label["seen"]]
    assert len(hidden) >= 3
    assert all(after[text] for text in hidden)
    assert after["north"]


def test_keys(one: Open) -> None:
    scene = bring_live(one())
    page = scene.page
    scene.locator("canvas").focus()
    first = live_picture(scene)
    seen = [first]
    for key in ("ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "+", "-"):
        page.keyboard.press(key)
        settle(page)
        picture = live_picture(scene)
        assert difference(seen[-1], picture) > 0.1, key
        seen.append(picture)
        if key in ("ArrowRight", "ArrowDown", "-"):
            assert difference(first, picture) < 0.05, key
    page.keyboard.press("ArrowUp")
    page.keyboard.press("Home")
    settle(page)
    assert difference(first, live_picture(scene)) < 0.01
    page.keyboard.press("f")
    page.wait_for_function("() => document.fullscreenElement?.className === 'scene'")
    page.wait_for_function("() => document.querySelector('.scene-canvas').width === innerWidth")
    # The whole poster fits in.
    labels = scene.evaluate(LABELS)
    assert all(0 < label["left"] < 1 and 0 < label["top"] < 1 for label in labels)
    page.keyboard.press("f")
    page.wait_for_function("() => !document.fullscreenElement")
    page.keyboard.press("Escape")
    assert page.evaluate("document.activeElement === document.body")


@pytest.mark.slow
def test_the_wheel_scrolls_the_page_and_zooms_with_ctrl(one: Open) -> None:
    scene = bring_live(one(viewport={"width": 1000, "height": 600}))
    page = scene.page
    first = live_picture(scene)
    page.mouse.move(*middle(scene))
    down = page.evaluate("scrollY")
    page.mouse.wheel(0, 60)
    page.wait_for_function("before => scrollY > before", arg=down)
    settle(page)
    assert difference(first, live_picture(scene)) == 0
    page.mouse.move(*middle(scene))
    down = page.evaluate("scrollY")
    page.keyboard.down("Control")
    page.mouse.wheel(0, -120)
    page.keyboard.up("Control")
    settle(page)
    assert page.evaluate("scrollY") == down
    assert difference(first, live_picture(scene)) > 0.3


def swipe(page: Any, fingers: list[list[tuple[float, float]]]) -> None:
    """Move fingers over the screen; all paths have the same number of places."""
    session = page.context.new_cdp_session(page)
    for i, places in enumerate(zip(*fingers, strict=True)):
        points = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(places)]
        kind = "touchStart" if i == 0 else "touchMove"
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        page.wait_for_timeout(20)
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    # A page may continue to scroll for a moment.
    page.wait_for_function(AT_REST, polling=100)
    settle(page)


@pytest.mark.chromium
def test_fingers(one: Open) -> None:
    """One finger scrolls up and down and turns sideways; two turn and zoom."""
    phone = {"viewport": {"width": 390, "height": 700}, "has_touch": True, "is_mobile": True}
    scene = bring_live(one(**phone))
    page = scene.page
    assert scene.locator(".scene-hint").is_visible()
    first = live_picture(scene)
    steps = range(0, 90, 10)

    x, y = middle(scene)
    down = page.evaluate("scrollY")
    swipe(page, [[(x, y - step) for step in steps]])
    assert page.evaluate("scrollY") > down
    assert difference(first, live_picture(scene)) == 0

    x, y = middle(scene)
    down = page.evaluate("scrollY")
    swipe(page, [[(x + step, y) for step in steps]])
    turned = live_picture(scene)
    assert difference(first, turned) > 0.3
    assert page.evaluate("scrollY") == down
    assert not scene.locator(".scene-hint").count()

    swipe(page, [[(x - 20 - step, y) for step in steps], [(x + 20 + step, y) for step in steps]])
    assert difference(turned, live_picture(scene)) > 0.3
    assert page.evaluate("scrollY") == down
    assert page.evaluate("visualViewport.scale") == 1


def test_without_scripts_there_are_posters(strict_site: str, open_page: Open) -> None:
    page = open_page(f"{strict_site}/both.html", java_script_enabled=False)
    scenes = page.locator(".scene").all()
    assert len(scenes) == 2
    for scene in scenes:
        assert scene.locator(".scene-poster").is_visible()
        labels = scene.locator(".scene-label:not([data-hidden])").all()
        assert all(label.is_visible() for label in labels)
        assert scene.get_by_role("button").count() == 0
    assert page.locator("noscript .scene-message").count() == 2


def failure(scene: Any) -> str:
    """Scroll to a scene that cannot go live, and return the message on the page."""
    come_to(scene)
    line = scene.page.locator(".scene-message[role=status]").first
    line.wait_for(timeout=20_000)
    assert scene.get_attribute("data-state") == "failed"
    assert scene.locator(".scene-poster").is_visible()
    assert scene.locator(".scene-label:not([data-hidden])").first.is_visible()
    assert scene.locator("canvas, button").count() == 0
    return line.inner_text()


@pytest.mark.parametrize(
    ("files", "answer", "said"),
    [
        ("**/*.glb", {"status": 404}, "its scene did not load (404)"),
        ("**/*.glb", {"body": b"broken"}, "stays a picture"),
        ("**/viewer-*.js", {"status": 404}, "the viewer did not load"),
    ],
)
def test_what_does_not_load_is_said(
    one: Open, files: str, answer: dict[str, Any], said: str
) -> None:
    assert said in failure(one(quiet=False, answers={files: answer}))


def test_missing_webgl_is_said(one: Open) -> None:
    assert "WebGL" in failure(one(script=NO_WEBGL))


def test_without_a_server_the_page_says_how_to_get_one(small_book: Path, open_page: Open) -> None:
    page = open_page((small_book / "one.html").as_uri(), quiet=False)
    assert "python -m http.server" in failure(page.locator(".scene"))


@pytest.mark.slow
def test_who_saves_data_clicks(one: Open) -> None:
    scene = one(script=SAVE_DATA)
    come_to(scene)
    scene.page.wait_for_timeout(300)
    assert scene.get_attribute("data-state") == "poster"
    scene.get_by_role("button", name="Turn this figure").click()
    bring_live(scene)


@pytest.mark.slow
def test_paper_shows_posters(one: Open) -> None:
    scene = one()
    at_rest = scene.evaluate(LABELS)
    drag(bring_live(scene), 90, 40)
    scene.page.emulate_media(media="print")
    assert scene.locator(".scene-poster").is_visible()
    assert not scene.locator(".scene-canvas").is_visible()
    assert not scene.get_by_role("button").first.is_visible()
    assert_labels_stay(scene, at_rest)


@pytest.mark.slow
def test_a_lost_context_comes_back(one: Open) -> None:
    scene = bring_live(one(script=CONTEXTS, quiet=False))
    first = live_picture(scene)
    scene.page.evaluate(
        """() => new Promise((done) => {
            const lose = contexts[0].getExtension("WEBGL_lose_context");
            const { canvas } = contexts[0];
            canvas.addEventListener("webglcontextrestored", () => setTimeout(done, 200));
            canvas.addEventListener("webglcontextlost", () => {
                setTimeout(() => lose.restoreContext(), 50);
            });
            lose.loseContext();
        })"""
    )
    settle(scene.page)
    assert difference(first, live_picture(scene)) < 0.01


def test_a_live_scene_is_accessible(one: Open) -> None:
    # The policy of this site would block the test's own script.
    scene = bring_live(one(bypass_csp=True))
    scene.hover()
    scene.page.add_script_tag(path=AXE)
    check = "axe.run('.scene').then(({violations}) => violations.map(({id}) => id))"
    assert scene.page.evaluate(check) == []
    name = scene.page.get_by_role("application", name="Six points on a glass ball")
    assert name.count() == 1


@pytest.mark.slow
def test_a_frame_takes_no_time_at_rest(one: Open) -> None:
    """Nothing is drawn unless the reader moves something."""
    page = bring_live(one(script=FRAMES)).page
    settle(page)
    drawn = page.evaluate("frames_drawn")
    page.wait_for_timeout(500)
    assert page.evaluate("frames_drawn") == drawn <= 3
