"""Figures in a real JupyterLab, with a real kernel and a real browser."""

import base64
import io
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
import pytest
from live_pages import (
    CONTEXTS,
    INK,
    NO_WEBGL,
    Open,
    difference,
    drag,
    live_picture,
    lost_contexts,
    turn,
    values,
)
from PIL import Image
from servers import jupyterlab, until

from rotedu import scenes
from rotedu.figures.backend import scene_labels
from rotedu.figures.widget import packed_viewer

# Counts the buffers that the page has made on the graphics card, and those it still holds.
BUFFERS = """
    window.buffers = { made: 0, held: 0 };
    const { createBuffer, deleteBuffer } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.createBuffer = function () {
        buffers.made += 1;
        buffers.held += 1;
        return createBuffer.call(this);
    };
    WebGL2RenderingContext.prototype.deleteBuffer = function (buffer) {
        buffers.held -= 1;
        deleteBuffer.call(this, buffer);
    };
"""
# In milliseconds; a kernel needs some seconds, and much longer on a busy machine.
PATIENCE = 120_000
LIVE = ".scene[data-state=live]"
SEEN = "scenes => scenes.map(scene => scene.querySelector('canvas').ariaLabel)"
IMPORTS = "from rotedu import scenes"
KERNEL_IS_THERE = """
    () => window.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel?.status === "idle"
"""

pytestmark = pytest.mark.slow


def numbered(i: int) -> str:
    """A cell with a figure that says its number."""
    return f"plotter = scenes.figure_1()\nplotter.alt_text = 'Number {i}'\nplotter.show()"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("lab")


@pytest.fixture(scope="module")
def lab(folder: Path) -> Iterator[str]:
    """JupyterLab with its factory settings."""
    home = {"HOME": str(folder), "JUPYTER_CONFIG_DIR": str(folder / "configuration")}
    env = os.environ | home
    env.pop("PYVISTA_JUPYTER_BACKEND", None)
    # For the tests: the commands of JupyterLab's menus.
    menus = "--LabApp.expose_app_in_browser=True"
    with jupyterlab(sys.executable, folder, menus, env=env) as url:
        yield url


@pytest.fixture
def run(lab: str, folder: Path, browser: Any) -> Iterator[Open]:
    """Open a new notebook with these cells and run them; errors of the page are failures."""
    errors: list[str] = []
    contexts = []

    def run_cells(name: str, *cells: str, script: str = "") -> Any:
        notebook = nbformat.v4.new_notebook(
            cells=[nbformat.v4.new_code_cell(cell) for cell in cells],
            metadata={"kernelspec": {"name": "python3", "display_name": "Python 3"}},
        )
        nbformat.write(notebook, folder / f"{name}.ipynb")
        context = browser.new_context(viewport={"width": 1200, "height": 900})
        contexts.append(context)
        page = context.new_page()
        page.received = []
        page.on(
            "websocket",
            lambda ws: ws.on("framereceived", lambda frame: page.received.append(len(frame))),
        )
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.add_init_script(script)
        page.goto(f"{lab}/lab/tree/{name}.ipynb?reset")
        page.wait_for_function(KERNEL_IS_THERE, timeout=PATIENCE)
        command(page, "notebook:run-all-cells", wait=False)
        return page

    yield run_cells
    for context in contexts:
        context.close()
    assert errors == []


def command(page: Any, name: str, wait: bool = True, **arguments: str) -> Any:
    """Call a command of JupyterLab's menus."""
    script = "([name, arguments]) => jupyterapp.commands.execute(name, arguments)"
    if not wait:
        script = script.replace("jupyterapp", "void jupyterapp")
    return page.evaluate(script, [name, arguments])


def wear(page: Any, theme: str) -> None:
    """Change the theme, which JupyterLab remembers for all pages."""
    command(page, "apputils:change-theme", theme=f"JupyterLab {theme}")
    light = str(theme == "Light").lower()
    page.wait_for_function(f"document.body.dataset.jpThemeLight === '{light}'")


def test_a_figure_lives_in_a_notebook(run: Open) -> None:
    page = run("one", IMPORTS, "scenes.figure_1().show()", "import time\nwhile True: time.sleep(1)")
    scene = page.locator(LIVE)
    # It does not wait for the cell after it, which never ends.
    scene.wait_for(timeout=PATIENCE)
    figure_1 = scenes.figure_1()
    assert scene.locator(".scene-label .katex").count() == len(scene_labels(figure_1))
    assert scene.locator("canvas").get_attribute("aria-label") == figure_1.alt_text

    before = live_picture(scene)
    assert (before[..., 3] > 0).mean() > 0.01
    place = scene.locator(".scene-label").first.bounding_box()
    drag(scene, 120, 30)
    assert difference(before, live_picture(scene)) > 2
    assert scene.locator(".scene-label").first.bounding_box() != place

    # The keys are the figure's: in JupyterLab, 0 twice would ask whether to restart the kernel.
    active = page.locator(".jp-Cell.jp-mod-active").inner_text()
    turn(scene, "canvas", "ArrowDown", "0", "0", "Home")
    until(lambda: difference(before, live_picture(scene)) < 0.1, "the view of the start")
    assert page.locator(".jp-Dialog").count() == 0
    assert page.locator(".jp-Cell.jp-mod-active").inner_text() == active
    page.evaluate("jupyterapp.shell.currentWidget.context.model.dirty = true")
    page.keyboard.press("Control+s")
    page.wait_for_function("() => !jupyterapp.shell.currentWidget.context.model.dirty")

    light = scene.evaluate(INK)
    wear(page, "Dark")
    page.wait_for_timeout(500)
    assert scene.evaluate(INK) != light


def test_thirty_figures_stay_usable(run: Open) -> None:
    count = 30
    page = run("thirty", IMPORTS, *map(numbered, range(count)), script=CONTEXTS + BUFFERS)
    page.locator(LIVE).first.wait_for(timeout=PATIENCE)
    page.get_by_text(f"[{count + 1}]:").wait_for(state="attached", timeout=PATIENCE)
    page.locator(".jp-Cell").first.click()
    command(page, "notebook:enter-command-mode")
    page.keyboard.press("ArrowUp")
    page.locator(".jp-WindowedPanel-outer").hover()
    seen: set[str] = set()
    for _ in range(120):
        seen |= set(page.locator(LIVE).evaluate_all(SEEN))
        if len(seen) == count:
            break
        page.mouse.wheel(0, 250)
        page.wait_for_timeout(200)
    assert len(seen) == count
    assert sum(size > len(packed_viewer()) for size in page.received) == 1
    assert lost_contexts(page) == [False]
    # Far figures have given back what they had on the graphics card.
    buffers = page.evaluate("buffers")
    assert buffers["made"] > 10 * count
    assert buffers["held"] < buffers["made"] / 4

    page.mouse.wheel(0, -100_000)
    first = page.locator(LIVE, has=page.locator("canvas[aria-label='Number 0']"))
    first.wait_for(timeout=PATIENCE)
    before = live_picture(first)
    drag(first, 120, 30)
    assert difference(before, live_picture(first)) > 2

    command(page, "editmenu:clear-all")
    page.wait_for_function("buffers.held === 0", timeout=10_000)


def test_missing_webgl_is_said(run: Open) -> None:
    page = run("without", IMPORTS, numbered(7), script=NO_WEBGL)
    message = page.locator("p.scene-message")
    message.wait_for(timeout=PATIENCE)
    assert "WebGL" in message.inner_text()
    assert "Number 7" in message.inner_text()


def test_a_figure_asks_for_the_viewer_if_the_first_one_is_closed(run: Open) -> None:
    first = "from rotedu.figures.widget import figure\nfirst = figure(scenes.figure_1())"
    page = run("closed", IMPORTS, first, numbered(1), "first.close()")
    page.get_by_text("[4]:").wait_for(timeout=PATIENCE)
    command(page, "docmanager:save")
    page.received.clear()
    page.goto(page.url.partition("?")[0])
    page.locator(LIVE, has=page.locator("canvas[aria-label='Number 1']")).wait_for(timeout=PATIENCE)
    assert sum(size > len(packed_viewer()) for size in page.received) == 1


EXECUTE = """async (code) => {
    const { kernel } = jupyterapp.shell.currentWidget.sessionContext.session;
    const future = kernel.requestExecute({ code });
    let said = "";
    future.onIOPub = ({ content }) => {
        said += content.text ?? content.traceback?.join("") ?? "";
    };
    await future.done;
    return said;
}"""
EXPLORE = "from rotedu import scenes\nfrom rotedu.figures import explore"


def test_the_hand_and_python_move_the_same_figure(run: Open) -> None:
    page = run("explore", EXPLORE, "curve = explore(scenes.closed_curve_by_hand)\ncurve")
    figure = page.locator('.explorable[data-name="closed-curve-by-hand"][data-values]')
    figure.wait_for(timeout=30_000)
    handle, slider = '[data-handle="points-2"]', "input[type=range][name=u]"
    turn(figure, handle, "Shift+ArrowRight")
    told = values(figure)
    printed = page.evaluate(EXECUTE, "print(curve.points.tolist(), curve.u)")
    assert printed.strip() == f"{told['points']} {told['u']}"

    assert page.evaluate(EXECUTE, "curve.fraction, curve.u = 0.25, 0.75") == ""
    page.wait_for_function(
        "e => JSON.parse(e.dataset.values).u === 0.75", arg=figure.element_handle()
    )
    assert values(figure)["fraction"] == 0.25
    assert values(figure)["points"] == told["points"]
    assert figure.locator(slider).input_value() == "0.75"
    assert "expected 0.2 to 0.5, got 2" in page.evaluate(EXECUTE, "curve.fraction = 2")

    # JupyterLab would go to the next cell, and delete this one.
    turn(figure, slider, "End", "ArrowLeft", "d", "d")
    assert values(figure)["u"] == pytest.approx(0.995)
    turn(figure, handle, "d", "d")
    assert figure.count() == 1


PICTURES_OF_FIGURES = "img.rotedu-picture"
ERROR = "Error displaying widget"


def image(png: bytes) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB"), float)


def saved_pictures(page: Any, folder: Path, name: str, count: int) -> list[np.ndarray]:
    """Save a notebook once its figures have pictures, and read these."""
    pictures = page.locator(PICTURES_OF_FIGURES)
    pictures.nth(count - 1).wait_for(state="attached", timeout=PATIENCE)
    command(page, "docmanager:save")
    notebook = nbformat.read(folder / f"{name}.ipynb", as_version=4)
    found = [
        base64.b64decode(output.data["image/png"])
        for cell in notebook.cells
        for output in cell.outputs
        if "image/png" in output.get("data", {})
    ]
    assert max(map(len, found)) < 100_000
    return list(map(image, found))


def test_a_saved_notebook_shows_its_figures(run: Open, folder: Path) -> None:
    far = "from IPython.display import HTML\nHTML('<div style=\"height: 3000px\"></div>')"
    unseen = "explore(scenes.closed_curve_by_hand)"
    page = run("saved", EXPLORE, "scenes.figure_1().show()", far, unseen)
    live = page.locator(LIVE).first
    live.wait_for(timeout=PATIENCE)
    canvas = live.locator("canvas").element_handle()
    seen, far_off = saved_pictures(page, folder, "saved", 2)
    # The figure is the same as before, and its picture is not seen while it lives.
    assert canvas.evaluate("canvas => canvas.isConnected")
    assert page.locator(PICTURES_OF_FIGURES).first.is_hidden()

    wear(page, "Light")
    page.wait_for_timeout(500)
    # The figure may begin between two pixels, and then the screenshot has one more.
    shot = image(live.screenshot())[: seen.shape[0], : seen.shape[1]]
    assert np.abs(seen - shot).mean() < 1
    box = live.bounding_box()
    for label in live.locator(".scene-label").all():
        place = label.bounding_box()
        left, top = int(place["x"] - box["x"]), int(place["y"] - box["y"])
        part = np.s_[top : top + int(place["height"]) + 1, left : left + int(place["width"]) + 1]
        assert shot[part].min() < 128
        assert np.abs(seen[part] - shot[part]).mean() < 10
    assert (far_off < 128).mean() > 0.01

    command(page, "kernelmenu:shutdown", wait=False)
    page.goto(page.url.partition("?")[0])
    again = page.locator(PICTURES_OF_FIGURES).first
    again.wait_for(timeout=PATIENCE)
    assert again.bounding_box()["width"] == box["width"]
    page.get_by_text(ERROR).first.wait_for(state="attached", timeout=PATIENCE)
    assert not any(error.is_visible() for error in page.get_by_text(ERROR).all())


def test_a_saved_notebook_shows_a_figure_as_the_hand_has_left_it(run: Open, folder: Path) -> None:
    page = run("left", EXPLORE, "explore(scenes.spinning_by_hand)")
    live = page.locator(LIVE).first
    live.wait_for(timeout=PATIENCE)
    wear(page, "Light")
    picture = page.locator(PICTURES_OF_FIGURES).first
    (before,) = saved_pictures(page, folder, "left", 1)

    def after(act: Callable[[], None]) -> np.ndarray:
        old = picture.get_attribute("src")
        act()
        until(lambda: picture.get_attribute("src") != old, "another picture")
        (found,) = saved_pictures(page, folder, "left", 1)
        return found

    turned = after(lambda: drag(live, 120, 30))
    assert np.abs(turned - before).mean() > 1
    # Whatever the theme, a picture is black on white.
    wear(page, "Dark")
    slid = after(lambda: turn(page, "input[type=range][name=t]", "End"))
    assert (slid[0] == 255).all()
    assert np.abs(slid - turned).mean() > 0.1
    assert picture.get_attribute("alt").startswith("Changed: ")
    wear(page, "Light")
    page.wait_for_timeout(500)
    shot = image(live.screenshot())[: slid.shape[0], : slid.shape[1]]
    assert np.abs(slid - shot).mean() < 1


def test_a_notebook_from_elsewhere_shows_its_pictures(run: Open, folder: Path) -> None:
    """JupyterLab trusts only what has run on the machine."""
    page = run("sent", IMPORTS, "scenes.figure_1().show()")
    saved_pictures(page, folder, "sent", 1)
    notebook = nbformat.read(folder / "sent.ipynb", as_version=4)
    notebook.cells.append(nbformat.v4.new_markdown_cell("Changed by somebody."))
    notebook.cells[1].source += "  # changed"
    nbformat.write(notebook, folder / "received.ipynb")
    page.goto(page.url.partition("?")[0].replace("sent", "received") + "?reset")
    picture = page.locator(PICTURES_OF_FIGURES)
    picture.wait_for(timeout=PATIENCE)
    assert picture.evaluate("image => image.complete && image.naturalWidth > 0")
    assert "turned" in picture.get_attribute("alt")
    assert page.get_by_text(ERROR).count() == 0
