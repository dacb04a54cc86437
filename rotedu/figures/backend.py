"""The pyvista backends ``book`` and ``still``: what ``Plotter.show()`` leaves in a notebook.

``book`` makes a poster (a picture with a transparent background, at twice the size shown), an
alternative text, the labels of the scene as text over the poster, typeset like the formulas of the
page, and the scene itself as binary glTF. ``still`` makes a picture.
"""

import base64
import contextlib
import ctypes
import io
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
import pyvista
from IPython import get_ipython
from PIL import Image
from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingLabel import vtkPointSetToLabelHierarchy

from rotedu.figures.ball import ball_looks
from rotedu.figures.gltf import part_names, scene_gltf, surface_of
from rotedu.figures.light import shade
from rotedu.figures.state import record_of

MIME_TYPE = "application/vnd.pyvista.scene+json"
POSTER_SCALE = 2
# Samples across each pixel of the poster, and as many down.
POSTER_SAMPLES = 2
# Libraries that draw without a display, and the window of VTK for each. OSMesa needs no device.
WINDOWS = {"libOSMesa.so.8": "vtkOSOpenGLRenderWindow", "libEGL.so.1": "vtkEGLRenderWindow"}
NO_OPENGL = (
    "a picture needs an OpenGL library, and this machine has none. Install one, then restart the"
    " kernel: the package libosmesa6 or libegl1 on Debian and Ubuntu,"
    " mesa-libEGL with mesa-dri-drivers on Fedora"
)


def can_load(library: str) -> bool:
    """Tell whether the system has a shared library."""
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def needs_no_display() -> bool:
    """Tell whether VTK has to draw with one of `WINDOWS`."""
    return sys.platform == "linux" and not os.environ.get("DISPLAY")


def choose_render_window() -> None:
    """Tell VTK which off-screen window to use where there is no display.

    Otherwise VTK would try the display first and complain on stderr, in the middle of the page.
    Since a widget needs no picture, VTK without any library gets a window that must never be
    drawn.
    """
    if not needs_no_display():
        return
    found = [window for library, window in WINDOWS.items() if can_load(library)]
    if not found:
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", [*found, "vtkEGLRenderWindow"][0])


def require_opengl() -> None:
    """Refuse to draw a picture where VTK would crash, for want of a display and a library."""
    if needs_no_display() and not any(map(can_load, WINDOWS)):
        raise RuntimeError(NO_OPENGL)


choose_render_window()


def describe(plotter: pyvista.Plotter, alt: str) -> None:
    """Give a scene the text that replaces it where it cannot be seen: a few plain sentences."""
    if not alt.strip():
        raise ValueError("alt: expected a text that says what the scene shows, got an empty one")
    pyvista.set_new_attribute(plotter, "alt_text", " ".join(alt.split()))


@dataclass(repr=False)
class BookFigure:
    """A scene as a notebook output: a picture for any front end, and the scene for the book."""

    scene: dict[str, Any]
    poster: bytes
    gltf: bytes

    def __repr__(self) -> str:
        return f"<scene: {self.scene['alt']}>"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, Any]:
        content = self.content()
        return {"text/plain": repr(self), "image/png": content["poster"], MIME_TYPE: content}

    def content(self) -> dict[str, Any]:
        """Return what a page needs, as JSON holds it."""
        files = {"poster": self.poster, "gltf": self.gltf}
        return self.scene | {name: base64.b64encode(x).decode() for name, x in files.items()}


def book_figure(plotter: pyvista.Plotter, **_: object) -> BookFigure:
    """Make the figure of a scene, as the handler of the pyvista backend ``book``.

    Raises
    ------
    ValueError
        If the scene has no alternative text, or contains something that a page cannot show.
    RuntimeError
        If there is no OpenGL library.
    """
    require_opengl()
    alt = getattr(plotter, "alt_text", None)
    if alt is None:
        raise ValueError(
            "plotter: expected a scene with an alternative text, got one without;"
            " call rotedu.figures.describe(plotter, ...) before show()"
        )
    close_after_cell(plotter)
    scene = described(plotter) | {"alt": alt, "views": views_of(plotter, with_poster=True)}
    return BookFigure(scene, take_poster(plotter), scene_gltf(plotter))


def described(plotter: pyvista.Plotter, view: str = "") -> dict[str, Any]:
    """Return the size of a picture, its labels, and how it is stacked on a phone."""
    width, height = plotter.window_size
    stack = {} if view else record_of(plotter).stack
    labels = scene_labels(plotter, view)
    return {"width": width, "height": height, "labels": labels, "stack": stack}


def views_of(plotter: pyvista.Plotter, *, with_poster: bool = False) -> list[dict[str, Any]]:
    """Describe the other pictures of a scene, each with its poster if wanted."""
    views = []
    for name, view in record_of(plotter).views.items():
        with seen_from(plotter, name):
            poster = base64.b64encode(take_poster(plotter)).decode() if with_poster else ""
            about = {"name": name, "alt": view.alt, "without": list(view.without)}
            views.append(about | described(plotter, name) | {"poster": poster})
    return views


@contextlib.contextmanager
def seen_from(plotter: pyvista.Plotter, name: str) -> Iterator[None]:
    """Look at a scene as one of its views does, for a while."""
    recorded = record_of(plotter)
    view = recorded.views[name]
    actors = dict(plotter.actors)
    labels = {f"{label}-labels" for label in recorded.labels}
    own = {f"{label}-labels" for label, where in recorded.seen_in.items() if where == name}
    absent = {f"{label}-labels" for label, place in recorded.labels.items() if place is None}
    before = {key: actor.GetVisibility() for key, actor in actors.items()}
    camera, size = plotter.camera, plotter.window_size
    plotter.camera = pyvista.Camera()  # type: ignore[no-untyped-call]
    plotter.camera.position, plotter.camera.focal_point, plotter.camera.up = (
        tuple(np.asarray(view.place[key], float)) for key in ("eye", "target", "up")
    )
    plotter.camera.view_angle = view.place["angle"]
    plotter.window_size = list(view.size)
    for key, actor in actors.items():
        hidden = key in view.without or key in labels - own or key in absent
        actor.SetVisibility((before[key] or key in own) and not hidden)
    try:
        yield
    finally:
        for key, actor in actors.items():
            actor.SetVisibility(before[key])
        plotter.camera, plotter.window_size = camera, size


def still_picture(plotter: pyvista.Plotter, **_: object) -> Image.Image:
    """Take a picture of a scene, as the handler of the pyvista backend ``still``.

    While pyvista's own backend ``static`` keeps every scene open, at 40 MB each, this one closes a
    scene when its cell has run. Without an OpenGL library there is a `RuntimeError`.
    """
    require_opengl()
    close_after_cell(plotter)
    shade_parts(plotter, plotter)

    def taken() -> Image.Image:
        plotter.reset_camera_clipping_range()
        plotter.render()
        return Image.fromarray(np.asarray(plotter.screenshot(return_img=True)))

    pictures = [taken()]
    for name in record_of(plotter).views:
        with seen_from(plotter, name):
            pictures.append(taken())
    # Side by side, all in the middle of one line.
    size = sum(picture.width for picture in pictures), max(picture.height for picture in pictures)
    joined = Image.new("RGB", size, "white")
    left = 0
    for picture in pictures:
        joined.paste(picture, (left, (joined.height - picture.height) // 2))
        left += picture.width
    return joined


def close_after_cell(plotter: pyvista.Plotter) -> None:
    """Close a scene when its cell has run, because pyvista needs it until then."""
    shell = get_ipython()
    if shell is None:
        return

    def close(*_: object) -> None:
        shell.events.unregister("post_run_cell", close)
        plotter.close()

    shell.events.register("post_run_cell", close)


def take_poster(plotter: pyvista.Plotter) -> bytes:
    """Take the picture of a scene without its labels, `POSTER_SCALE` times its size, as PNG."""
    large = enlarged(plotter, POSTER_SCALE * POSTER_SAMPLES)
    samples = np.asarray(large.screenshot(transparent_background=True, return_img=True))
    large.close()
    n = POSTER_SAMPLES
    corners = np.stack([samples[i::n, j::n] for i, j in np.ndindex(n, n)])
    mean = corners.mean(axis=0, dtype=np.float32)
    # VTK has multiplied the colours by their alpha. Bytes would make steps in what is nearly clear.
    mean[..., :3] *= 255 / np.maximum(mean[..., 3:], 1)
    picture = Image.fromarray(np.rint(np.minimum(mean, 255)).astype(np.uint8), "RGBA")
    file = io.BytesIO()
    # A page makes a WebP of it.
    picture.save(file, "PNG", compress_level=1)
    return file.getvalue()


def enlarged(plotter: pyvista.Plotter, scale: int) -> pyvista.Plotter:
    """Copy the parts of a scene, without its labels, into a larger one on black."""
    # Enlarge the window, not the picture: VTK would draw tiles and cut points at their borders.
    size = [scale * length for length in plotter.window_size]
    copy = pyvista.Plotter(off_screen=True, window_size=size, lighting="none")
    # Without any light VTK would compute no normals.
    copy.add_light(pyvista.Light(light_type="headlight"))
    for name, actor in part_names(plotter):
        twin = actor.copy(deep=False)
        copy.add_actor(twin, name=name, reset_camera=False, render=False)
    shade_parts(plotter, copy)
    copy.camera = plotter.camera.copy()  # type: ignore[no-untyped-call]
    # As near as it can be: pyvista's own range would keep too few digits of a depth.
    copy.reset_camera_clipping_range()
    # Our own samples make smooth edges; those of VTK would make lines thinner.
    copy.disable_anti_aliasing()
    # Draw see-through surfaces in the order of their depth, as the viewer does.
    copy.renderer.enable_depth_peeling(8)  # type: ignore[no-untyped-call]
    # VTK mixes the colour of the background into every edge. Black adds nothing to it.
    copy.renderer.set_background("black")
    return copy


def shade_parts(plotter: pyvista.Plotter, drawn: pyvista.Plotter) -> None:
    """Let VTK draw the parts of a scene, there or in its copy, as the viewer does."""
    parts = dict(part_names(plotter))
    for name, twin in part_names(drawn):
        looks = ball_looks(parts[name])
        spoon = parts[looks["of"]].GetMatrix() if "of" in looks else vtkMatrix4x4()
        lying = pyvista.array_from_vtkmatrix(spoon)[:3, :3]
        shade(twin, surface_of(parts[name]), looks, lying)


def scene_labels(plotter: pyvista.Plotter, view: str = "") -> list[dict[str, Any]]:
    """Find the labels of a scene, or of a view of it, and their places in the picture.

    Returns
    -------
    list of dict
        For each label its ``name``, ``text``, ``color`` (as ``#rrggbb``), ``position`` (x, y, z, or
        None if it is absent), ``left`` and ``top`` (fractions of the picture's width and height)
        and ``hidden`` (whether it is absent, behind the camera or behind a surface).
    """
    width, height = plotter.window_size
    camera = plotter.camera
    lens = pyvista.array_from_vtkmatrix(
        camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
    )
    recorded, seen_in = record_of(plotter).labels, record_of(plotter).seen_in
    labels = []
    for title, actor in plotter.actors.items():
        name = title.removesuffix("-labels")
        if name == title or seen_in.get(name, "") != view:
            continue
        mapper = cast(Any, actor).GetMapper()
        hierarchy = cast(vtkPointSetToLabelHierarchy, mapper.GetInputAlgorithm())
        points = pyvista.wrap(hierarchy.GetInputDataObject(0, 0))
        texts = points.point_data[hierarchy.GetLabelArrayName()]
        color = pyvista.Color(hierarchy.GetTextProperty().GetColor()).hex_rgb
        for position, text in zip(np.asarray(points.points, float), texts, strict=True):
            x, y, _, w = lens @ [*position, 1.0]
            absent = recorded.get(name, position) is None
            labels.append(
                {
                    "name": name,
                    "text": str(text),
                    "color": color,
                    "position": None if absent else position.tolist(),
                    "left": round((1 + x / w) / 2, 4),
                    "top": round((1 - y / w) / 2, 4),
                    "hidden": absent
                    or bool(w <= 0)
                    or _stands_behind(plotter, np.asarray(camera.position), position),
                }
            )
    return labels


def _stands_behind(plotter: pyvista.Plotter, eye: np.ndarray, point: np.ndarray) -> bool:
    """Tell whether surfaces come between the eye and a point.

    One opaque surface hides everything behind it. A see-through surface does so only where the
    line of sight goes in and out again, so the inside of a glass ball keeps its labels.
    """
    for actor in plotter.actors.values():
        if not isinstance(actor, pyvista.Actor) or not actor.GetPickable():
            continue
        moved = pyvista.array_from_vtkmatrix(actor.GetMatrix())
        surface = surface_of(actor).transform(moved, inplace=False)
        # Stop just short of the point, because it often lies on a surface itself.
        hits, _ = surface.ray_trace(eye, eye + (point - eye) * (1 - 1e-3))
        if len(hits) >= (1 if actor.prop.opacity == 1 else 2):
            return True
    return False
