"""Scenes in a real browser: the book's own, and a small book of demanding ones."""

import io
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
import pytest
import pyvista
from browser import QuietHandler, serve
from demanding import SIZE, demanding_scene, scene_of_all_looks
from live_pages import (
    AT_REST,
    CONTEXTS,
    INK,
    LABELS,
    LIKE_A_POSTER,
    NO_WEBGL,
    PHONE,
    ROOT,
    Open,
    bring_live,
    center,
    come_to,
    complaints_of_axe,
    difference,
    drag,
    live_picture,
    loaded,
    lost_contexts,
    on_white,
    open_page,
    pictures,
    settle,
    swipe,
    turn,
    wait_until,
)
from nightly import nightly
from PIL import Image

from rotedu.figures.backend import BookFigure, book_figure
from rotedu.figures.pages import light_poster

__all__ = ["open_page"]

# Mean difference, out of 255, between the poster and the first frame, written like a poster: over
# the whole picture, and away from edges, where both surely show the same part.
TOLERANCE, TOLERANCE_INSIDE = 1.0, 5.0
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
FRAMES = """
    window.frames_drawn = 0;
    const drawImage = CanvasRenderingContext2D.prototype.drawImage;
    CanvasRenderingContext2D.prototype.drawImage = function (...rest) {
        window.frames_drawn += 1;
        return drawImage.apply(this, rest);
    };
"""
# How far down, in its middle column, a scene is held by nothing but its canvas.
FREE = """canvas => [0.25, 0.1, 0.9, 0.03].find((down) => {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    return document.elementFromPoint(left + width / 2, top + down * height) === canvas;
})"""
RESET = re.compile("^Reset( the view)?$")
SPACE = "element => [element.offsetHeight, element.closest('figure').offsetHeight]"


class Strict(QuietHandler):
    """Serves files under a policy that allows scripts from this host alone, none inline."""

    def end_headers(self) -> None:
        policy = "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:"
        self.send_header("Content-Security-Policy", policy)
        super().end_headers()


def notebook_of(figures: list[BookFigure]) -> nbformat.NotebookNode:
    """A notebook that has run and shows figures."""
    shown = [figure._repr_mimebundle_() for figure in figures]
    outputs = [nbformat.v4.new_output("display_data", bundle) for bundle in shown]
    cells = [
        nbformat.v4.new_markdown_cell("# Scenes"),
        nbformat.v4.new_code_cell("plotter.show()", outputs=outputs),
        nbformat.v4.new_markdown_cell('<div style="height: 2000px"></div>'),
    ]
    metadata = {"orphan": True, "language_info": {"name": "python", "pygments_lexer": "python"}}
    return nbformat.v4.new_notebook(cells=cells, metadata=metadata)


@pytest.fixture(scope="module")
def small_book(book: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A page with one demanding scene, and one with another beside it, built like the book."""
    source = tmp_path_factory.mktemp("small")
    (source / "conf.py").write_text(CONFIGURATION)
    figure, looks = book_figure(demanding_scene()), book_figure(scene_of_all_looks())
    nbformat.write(notebook_of([figure]), source / "one.ipynb")
    nbformat.write(notebook_of([figure, looks]), source / "both.ipynb")
    icon = f"html_favicon={ROOT}/book/_static/favicon.svg"
    command = [sys.executable, "-m", "sphinx", "-W", "-D", icon, source, source / "html"]
    path = os.environ | {"PYTHONPATH": str(ROOT / "book" / "_ext")}
    run = subprocess.run(command, env=path, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    return source / "html"


@pytest.fixture(scope="module")
def strict_site(small_book: Path) -> Iterator[str]:
    with serve(small_book, Strict) as site:
        yield site


@pytest.fixture
def one(strict_site: str, open_page: Open) -> Open:
    """Open the page with one scene, and return the scene."""
    return lambda **options: open_page(f"{strict_site}/one.html", **options).locator(".scene")


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
    file = io.BytesIO()
    Image.fromarray(first.astype("u1")).save(file, "PNG")
    written = np.asarray(Image.open(io.BytesIO(light_poster(file.getvalue()))), float)
    assert difference(poster, written) < TOLERANCE, where
    core = inside(poster, written)
    assert np.abs(on_white(poster) - on_white(written))[core].mean() < TOLERANCE_INSIDE, where
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
        for way in ("left", "top") if now["seen"] else ():
            assert abs(now[way] - before[way]) < 0.002, now
            assert 0 < now[way] < 1, now


@pytest.mark.parametrize("which", nightly(["few", "all"], "few"))
def test_scenes_of_the_book_live(book: Path, site: str, open_page: Open, which: str) -> None:
    """Each scene shows its labels, looks like its poster, turns and comes back, in one context.

    Few is the first scene of one page; ``make test-slow`` takes all scenes of all pages.
    """
    files = {file.relative_to(book).as_posix(): file for file in sorted(book.rglob("*.html"))}
    names = [name for name, file in files.items() if 'class="scene"' in file.read_text("utf-8")]
    assert len(names) >= 10
    if which == "few":
        names = ["book/03-ordinary-rotation.html"]
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
            # Its own button or that of its panel, after which a model has drawn the figure.
            reset = scene.locator("xpath=..").get_by_role("button", name=RESET)
            reset.click()
            settle(page)
            at_start = live_picture(scene)
            come_to(scene)
            # In the middle of Figure 1 an arrow would be dragged.
            drag(scene, 70, 25, down=scene.locator("canvas").evaluate(FREE))
            after = live_picture(scene)
            assert difference(at_start, after) > 0.3, where
            assert cut_off(after) <= cut_off(first) + 0.002, where
            reset.click()
            settle(page)
            assert difference(at_start, live_picture(scene)) < 0.01, where
        assert lost_contexts(page) == [False], name
        page.context.close()


@pytest.mark.slow
def test_the_page_shows_through_light_and_dark(site: str, open_page: Open) -> None:
    inks, papers = [], []
    for scheme in ("light", "dark"):
        page = open_page(f"{site}/book/03-ordinary-rotation.html", color_scheme=scheme)
        scene = bring_live(page.locator(".scene:has([data-label=O])").first)
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
    lens = plotter.camera.GetCompositeProjectionTransformMatrix(SIZE[0] / SIZE[1], -1, 1)
    matrix = pyvista.array_from_vtkmatrix(lens)

    def opacity(picture: np.ndarray, azimuth: float, height: float) -> float:
        """The largest opacity of nine pixels about a place of the sphere."""
        a, b = np.deg2rad([azimuth, height])
        x, y, _, w = matrix @ [np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b), 1]
        column, row = ((1 + np.array([x, -y]) / w) * SIZE).round().astype(int)
        return float(picture[row - 1 : row + 2, column - 1 : column + 2, 3].max() / 255)

    for picture in pictures(bring_live(scene)):
        before, behind = opacity(picture, -40, 30), opacity(picture, 165, -30)
        assert opacity(picture, 165, -22) + 0.1 < behind < before - 0.15 < 0.6


def test_nothing_heavy_comes_before_the_page(one: Open) -> None:
    """A scene in sight goes live without a sign of a reader, but only when all else is there."""
    scene = one()
    wait_until(scene, "element => element.dataset.state === 'live'")
    waits = loaded(scene.page)
    heavy = [wait for name, wait in waits.items() if name.startswith("viewer-") or ".glb" in name]
    assert len(heavy) == 2
    assert min(heavy) >= 0
    assert "loader.js" in waits


def test_labels_follow_and_hide(one: Open) -> None:
    scene = bring_live(one())
    before = scene.evaluate(LABELS)
    # Half a turn: what was behind the ball is in front.
    turn(scene, "canvas", *24 * ["ArrowRight"])
    settle(scene.page)
    after = {label["text"]: label["seen"] for label in scene.evaluate(LABELS)}
    hidden = [label["text"] for label in before if not label["seen"]]
    assert 3 <= len(hidden) < len(before)
    assert all(after[text] for text in hidden)
    assert after["north"]


def test_keys(one: Open) -> None:
    scene = bring_live(one())
    page = scene.page
    seen = [first := live_picture(scene)]
    for key in ("ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "+", "-"):
        turn(scene, "canvas", key)
        settle(page)
        seen.append(live_picture(scene))
        assert difference(*seen[-2:]) > 0.1, key
        if key in ("ArrowRight", "ArrowDown", "-"):
            assert difference(first, seen[-1]) < 0.05, key
    page.emulate_media(reduced_motion="reduce")
    turn(scene, "canvas", "ArrowUp", "Home")
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
    page.mouse.move(*center(scene))
    down = page.evaluate("scrollY")
    page.mouse.wheel(0, 60)
    page.wait_for_function("before => scrollY > before", arg=down)
    settle(page)
    assert difference(first, live_picture(scene)) == 0
    page.mouse.move(*center(scene))
    down = page.evaluate("scrollY")
    page.keyboard.down("Control")
    page.mouse.wheel(0, -120)
    page.keyboard.up("Control")
    settle(page)
    assert page.evaluate("scrollY") == down
    assert difference(first, live_picture(scene)) > 0.3


@pytest.mark.chromium
def test_fingers(one: Open) -> None:
    """One finger scrolls up and down and turns sideways; two turn and zoom."""
    scene = bring_live(one(**PHONE))
    page = scene.page
    assert scene.locator(".scene-hint").is_visible()
    steps = range(0, 90, 10)

    def swiped(*ways: tuple[int, int, int]) -> tuple[float, np.ndarray]:
        """How far the page has gone down, and the picture, after fingers have gone their ways."""
        (x, y), before = center(scene), page.evaluate("scrollY")
        paths = [[(x + left + i * dx, y + i * dy) for i in steps] for left, dx, dy in ways]
        swipe(page, *paths, pause=20)
        # A page may continue to scroll for a moment.
        page.wait_for_function(AT_REST, polling=100)
        settle(page)
        return page.evaluate("scrollY") - before, live_picture(scene)

    first = live_picture(scene)
    down, picture = swiped((0, 0, -1))
    assert down > 0
    assert difference(first, picture) == 0
    down, turned = swiped((0, 1, 0))
    assert down == 0
    assert difference(first, turned) > 0.3
    assert not scene.locator(".scene-hint").count()
    down, zoomed = swiped((-20, -1, 0), (20, 1, 0))
    assert down == 0
    assert difference(turned, zoomed) > 0.3
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
        ("no webgl", {}, "WebGL"),
    ],
)
def test_what_does_not_load_is_said(one: Open, files: str, answer: Any, said: str) -> None:
    script = "" if answer else NO_WEBGL
    assert said in failure(one(quiet=False, answers={files: answer}, script=script))


def test_without_a_server_the_page_says_how_to_get_one(small_book: Path, open_page: Open) -> None:
    page = open_page((small_book / "one.html").as_uri(), quiet=False)
    said = failure(page.locator(".scene"))
    assert "move this figure" in said
    assert "python -m http.server" in said


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


def test_a_live_scene_is_accessible(one: Open) -> None:
    # The policy of this site would block the test's own script.
    scene = bring_live(one(bypass_csp=True))
    scene.hover()
    assert complaints_of_axe(scene.page, ".scene") == []
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
