"""The Python side of figures in notebooks, with a comm that keeps what is sent."""

import base64
import gzip
import io
from pathlib import Path
from typing import Any, ClassVar

import comm
import nbformat
import numpy as np
import pytest
import pyvista
from bs4 import BeautifulSoup
from comm.base_comm import BaseComm
from demanding import demanding_scene, new_plotter
from nbclient import NotebookClient
from nbconvert import HTMLExporter
from PIL import Image

from rotedu import scenes
from rotedu.figures import widget
from rotedu.figures.backend import scene_labels
from rotedu.figures.gltf import scene_gltf
from rotedu.figures.widget import Figure, figure, figure_of

VIEWER = b"export const render = () => 'the viewer';" * 100


class Wire(BaseComm):
    """A comm that keeps what is sent, in place of a browser."""

    sent: ClassVar[list[tuple[str, str, dict[str, Any], list[bytes]]]] = []

    def publish_msg(
        self, msg_type: str, data: Any = None, metadata: Any = None, buffers: Any = None, **_: Any
    ) -> None:
        self.sent.append((self.comm_id, msg_type, data or {}, list(buffers or [])))


@pytest.fixture
def sent(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[Any]:
    """What a new kernel sends, with a viewer that is easy to recognise."""
    (tmp_path / "figure.js").write_bytes(VIEWER)
    (tmp_path / "figure-loader.js").write_text("export default {};")
    monkeypatch.setattr(widget, "STATIC", tmp_path)
    monkeypatch.setattr(Figure, "is_first", True)
    monkeypatch.setattr(comm, "create_comm", Wire)
    monkeypatch.setattr(Wire, "sent", [])
    return Wire.sent


def opened(sent: list[Any], made: Figure) -> dict[str, Any]:
    """What a figure sends when it is made: its state with all buffers in place."""
    ((_, _, data, buffers),) = [
        message for message in sent if message[:2] == (made.model_id, "comm_open")
    ]
    held = {path[0]: bytes(b) for path, b in zip(data["buffer_paths"], buffers, strict=True)}
    return data["state"] | held


def ask(sent: list[Any], made: Figure, question: dict[str, Any]) -> list[Any]:
    """Ask as the browser does, and return the answers: content and buffers."""
    sent.clear()
    message = {"data": {"method": "custom", "content": question}}
    made._handle_msg({"content": message, "buffers": []})
    return [(data["content"], buffers) for _, _, data, buffers in sent]


def test_a_figure_carries_its_scene(sent: list[Any]) -> None:
    plotter = demanding_scene()
    state = opened(sent, figure_of(plotter))
    assert state["gltf"] == scene_gltf(plotter)
    assert state["scene"] == {
        "alt": plotter.alt_text,
        "width": plotter.window_size[0],
        "height": plotter.window_size[1],
        "labels": scene_labels(plotter),
        "stack": {},
        "views": [],
    }


def test_a_scene_needs_no_description_here(sent: list[Any]) -> None:
    assert figure_of(new_plotter()).scene["alt"]


def test_a_scene_that_only_vtk_can_draw_is_a_picture(capsys: pytest.CaptureFixture[str]) -> None:
    plotter = pyvista.Plotter(off_screen=True)
    plotter.add_mesh(pyvista.Sphere(), scalars=range(842))
    assert figure(plotter).size == tuple(plotter.window_size)
    assert "got colours by point or cell" in capsys.readouterr().out


def test_the_viewer_travels_with_the_first_figure_alone(sent: list[Any]) -> None:
    plotter = scenes.figure_1()
    states = [opened(sent, figure_of(plotter)) for _ in range(3)]
    assert gzip.decompress(states[0]["viewer"]) == VIEWER
    assert [state["viewer"] for state in states[1:]] == 2 * [b""]


def test_a_figure_answers_the_loader(sent: list[Any]) -> None:
    made = figure_of(scenes.figure_1())
    assert ask(sent, made, {"get": "sign of life"}) == [({"got": "sign of life"}, [])]
    ((content, (buffer,)),) = ask(sent, made, {"get": "viewer"})
    assert content == {"got": "viewer"}
    assert gzip.decompress(buffer) == VIEWER
    assert ask(sent, made, {"get": "something else"}) == []


def test_a_missing_viewer_is_said(sent: list[Any]) -> None:
    (widget.STATIC / "figure.js").unlink()
    with pytest.raises(FileNotFoundError, match="make lab"):
        figure_of(scenes.figure_1())


def run(monkeypatch: pytest.MonkeyPatch, *cells: str, reader: bool) -> nbformat.NotebookNode:
    """Run cells in a kernel without a backend in its environment, with or without a reader."""
    monkeypatch.delenv("PYVISTA_JUPYTER_BACKEND")
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    client = NotebookClient(notebook, timeout=120, kernel_name="python3", coalesce_streams=True)
    with client.setup_kernel():
        # Front ends say so: whoever can answer a question can turn a figure, too.
        client.kc.allow_stdin = reader
        for i, cell in enumerate(notebook.cells):
            client.execute_cell(cell, i)
    return notebook


# What the browser sends once, as a picture in true colours.
HAND_OVER = """
import io
import numpy as np
from PIL import Image
colors = np.random.default_rng(0).integers(100, 256, (48, 72, 3), np.uint8)
colors[:24] -= 100
colors[:2, :3] = 138, 119, 64
file = io.BytesIO()
Image.fromarray(colors).save(file, "PNG")
size = {"width": 36, "height": 24}
content = {"picture": size, "alt": 'Turned by "hand" & left so.'}
message = {"content": {"data": {"method": "custom", "content": content}}}
shown._handle_msg(message | {"buffers": [memoryview(file.getvalue())]})
"""


@pytest.mark.filterwarnings("error:Your element")
def test_for_a_reader_widgets_are_the_default_and_vtk_draws_nothing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    notebook = run(
        monkeypatch,
        "from rotedu import scenes\nplotter = scenes.figure_1()",
        "shown = plotter.show(return_viewer=True)\nshown",
        HAND_OVER,
        "print(plotter._rendered)",
        reader=True,
    )
    view, picture = notebook.cells[1].outputs
    assert "application/vnd.jupyter.widget-view+json" in view.data
    assert "turned" in picture.data["text/plain"]
    left = 'Turned by "hand" & left so.'
    assert picture.metadata["image/png"]["alt"] == left
    assert notebook.cells[3].outputs[0].text == "False\n"

    file = base64.b64decode(picture.data["image/png"])
    kept = Image.open(io.BytesIO(file)).convert("RGB")
    assert kept.size == (72, 48)
    # Six pixels of a name, among thousands of others.
    np.testing.assert_allclose(kept.getpixel((1, 1)), (138, 119, 64), atol=8)
    assert len(file) < 72 * 48 * 1.5
    html, _ = HTMLExporter().from_notebook_node(notebook)
    (image,) = BeautifulSoup(html, "html.parser").select(".jp-OutputArea img")
    assert base64.b64decode(image["src"].partition(",")[2]) == file
    assert (image["width"], image["height"], image["alt"]) == ("36", "24", left)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("first", "reader"), [("", False), ("import sys\nsys.modules['anywidget'] = None\n", True)]
)
def test_without_a_reader_or_widgets_there_are_pictures(
    first: str, reader: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    cells = [
        first + "from rotedu import scenes\nfrom rotedu.figures import explore",
        "scenes.figure_1().show()",
        "explore(scenes.spinning_by_hand)",
    ]
    _, *shown = run(monkeypatch, *cells, reader=reader).cells
    assert ["image/png" in output.data for cell in shown for output in cell.outputs] == [True, True]
