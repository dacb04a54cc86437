"""The figures of the book as data: the glTF file, the places of labels, and what hides them."""

import base64
import io
import json
import os
import struct
from typing import Any

import nbformat
import numpy as np
import pytest
import pyvista
from demanding import EYE, SIZE, TARGET, UP, VIEW_ANGLE, add_label, demanding_scene, new_plotter
from nbclient import NotebookClient
from PIL import Image

from rotedu import scenes
from rotedu.figures import backend, describe, stack_on_phone
from rotedu.figures.backend import MIME_TYPE, POSTER_SCALE, book_figure, scene_labels
from rotedu.figures.gltf import scene_gltf
from rotedu.figures.pages import LABEL, blanks, in_two, stacked_poster
from rotedu.figures.state import in_stack
from rotedu.scenes import parts, teaspoon

TYPES = {5120: np.int8, 5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
COMPONENTS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
SCENES = [demanding_scene, scenes.figure_1, scenes.rotated_mesh]


class Gltf:
    """A binary glTF file, read exactly as the standard says."""

    def __init__(self, content: bytes) -> None:
        magic, version, length = struct.unpack_from("<4sII", content)
        assert (magic, version, length) == (b"glTF", 2, len(content))
        chunks, start = {}, 12
        while start < length:
            size, kind = struct.unpack_from("<I4s", content, start)
            assert size % 4 == 0
            chunks[kind] = content[start + 8 : start + 8 + size]
            start += 8 + size
        self.json = json.loads(chunks[b"JSON"])
        self.binary = chunks[b"BIN\0"]
        assert self.json["buffers"] == [{"byteLength": len(self.binary)}]

    def array(self, index: int) -> np.ndarray:
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        kind, width = np.dtype(TYPES[accessor["componentType"]]), COMPONENTS[accessor["type"]]
        stride = view.get("byteStride", width * kind.itemsize)
        assert view["byteOffset"] % 4 == 0
        assert accessor["count"] * stride == view["byteLength"]
        # Refuses a view that ends beyond the file.
        numbers = np.frombuffer(self.binary, np.uint8, view["byteLength"], view["byteOffset"])
        return numbers.reshape(-1, stride)[:, : width * kind.itemsize].copy().view(kind)

    def parts(self) -> list[tuple[dict[str, Any], dict[str, Any], dict[str, Any]]]:
        """The node, the first primitive and the material of every part."""
        found = []
        for node in self.json["nodes"]:
            if "mesh" in node:
                primitive = self.json["meshes"][node["mesh"]]["primitives"][0]
                found.append((node, primitive, self.json["materials"][primitive["material"]]))
        return found


# From the eye to what it looks at.
AHEAD = np.subtract(TARGET, EYE) / np.linalg.norm(np.subtract(TARGET, EYE))


def read(plotter: pyvista.Plotter) -> Gltf:
    return Gltf(scene_gltf(plotter))


def single(mesh: pyvista.DataSet, **looks: Any) -> tuple[Gltf, Any, Any, Any]:
    """A scene with one mesh, and its part of the file."""
    plotter = new_plotter()
    plotter.add_mesh(mesh, **looks)
    gltf = read(plotter)
    return gltf, *gltf.parts()[0]


def faces_of(strip: np.ndarray) -> list[tuple[int, int, int]]:
    """The triangles of a strip with an area, each starting at its smallest corner."""
    faces = []
    for i in range(len(strip) - 2):
        a, b, c = (int(x) for x in strip[i : i + 3])
        if len({a, b, c}) == 3:
            a, b, c = (a, b, c) if i % 2 == 0 else (b, a, c)
            faces.append(min((a, b, c), (b, c, a), (c, a, b)))
    return sorted(faces)


def actors_of(plotter: pyvista.Plotter) -> list[pyvista.Actor]:
    return [actor for actor in plotter.actors.values() if isinstance(actor, pyvista.Actor)]


class TestGltf:
    @pytest.mark.parametrize("scene", SCENES)
    def test_positions_and_faces_are_those_given_to_pyvista(self, scene: Any) -> None:
        plotter = scene()
        gltf = read(plotter)
        assert len(gltf.parts()) == len(actors_of(plotter))
        for (node, primitive, _), actor in zip(gltf.parts(), actors_of(plotter), strict=True):
            if "lengths" in node["extras"]:
                continue
            mesh = actor.mapper.dataset
            positions = gltf.array(primitive["attributes"]["POSITION"])
            np.testing.assert_array_equal(positions, np.asarray(mesh.points, np.float32))
            bounds = gltf.json["accessors"][primitive["attributes"]["POSITION"]]
            np.testing.assert_array_equal(bounds["min"], positions.min(axis=0))
            np.testing.assert_array_equal(bounds["max"], positions.max(axis=0))
            triangles = mesh.triangulate().regular_faces
            given = sorted(min((a, b, c), (b, c, a), (c, a, b)) for a, b, c in triangles.tolist())
            assert primitive["mode"] == 5
            assert faces_of(gltf.array(primitive["indices"]).ravel()) == given

    def test_what_the_viewer_draws_anew_travels_as_the_points_that_this_takes(self) -> None:
        plotter = parts.new_scene((4, 1, 2), (0, 0, 0))
        paths = [np.eye(3), np.array([[0, 0, 0], [2, 0, 0]])]
        parts.add_lines(plotter, paths, "#000000")
        parts.add_arrow(plotter, [1, 0, 0], [1, 0, 2], "#000000")
        parts.add_point(plotter, [1, 2, 3], "#000000")
        parts.add_sphere(plotter, [3, 2, 1])
        gltf = read(plotter)
        nodes, primitives, materials = zip(*gltf.parts(), strict=True)
        places = np.concatenate(paths), [[1, 0, 0], [1, 0, 2]], [[1, 2, 3]], [[3, 2, 1]]
        for primitive, points in zip(primitives, places, strict=True):
            assert list(primitive["attributes"]) == ["POSITION"]
            np.testing.assert_array_equal(gltf.array(primitive["attributes"]["POSITION"]), points)
            assert "indices" not in primitive
        lines, arrow, point, _ = extras = [node["extras"] for node in nodes]
        assert [more["lengths"] for more in extras] == [[3, 2], [2], [1], [1]]
        assert arrow["tip"] > 0 < lines["radius"]
        assert "tip" not in lines
        assert (point["at"], point["radius"]) == ([1, 2, 3], 0.03)
        assert materials[3]["extras"]["ball"] == [3, 2, 1, 1]

    def test_a_page_has_the_spoon_of_its_scenes_once(self) -> None:
        ends = set()
        for color in ("red", "blue"):
            plotter = parts.new_scene((4, 1, 2), (0, 0, 0))
            for name in ("spoon", "pale"):
                spoon = teaspoon(stations=9, around=6)
                plotter.add_mesh(spoon, smooth_shading=True, color=color, name=name)
            parts.add_sphere(plotter)
            parts.add_line(plotter, np.eye(3), color)
            gltf = scene_gltf(plotter)
            own, shared = in_two(gltf)
            assert own + shared == gltf
            ends.add(shared)
        assert len(ends) == 1
        assert len(*ends) > 54 * 12
        assert in_two(scene_gltf(demanding_scene()))[1] == b""

    def test_normals_are_those_of_pyvista_to_half_a_degree(self) -> None:
        gltf, _, primitive, _ = single(pyvista.Sphere(), smooth_shading=True)
        normals = gltf.array(primitive["attributes"]["NORMAL"]) / 127
        positions = gltf.array(primitive["attributes"]["POSITION"])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        cosines = np.sum(normals * positions / 0.5, axis=1)
        assert np.rad2deg(np.arccos(cosines.clip(-1, 1))).max() < 0.6

    def test_looks(self) -> None:
        looks = {"opacity": 0.25, "color": "#d55e00"}
        _, node, _, material = single(pyvista.Sphere(), pickable=False, name="glass", **looks)
        color = np.array([0xD5, 0x5E, 0x00]) / 255
        linear = np.where(color < 0.04, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)
        factor = material["pbrMetallicRoughness"]["baseColorFactor"]
        np.testing.assert_allclose(factor, [*linear, 0.25], atol=1e-6)
        assert material["alphaMode"] == "BLEND"
        assert material["doubleSided"]
        assert material["extras"] == {"lit": True, "gleam": 0}
        assert "extensions" not in material
        assert (node["name"], node["extras"]) == ("glass", {"pickable": False})

    def test_opaque_flat_and_unlit(self) -> None:
        _, node, primitive, material = single(pyvista.Plane(), lighting=False, smooth_shading=False)
        assert list(primitive["attributes"]) == ["POSITION"]
        assert "alphaMode" not in material
        assert material["extensions"] == {"KHR_materials_unlit": {}}
        assert node["extras"] == {"pickable": True}

    def test_moved_actors(self) -> None:
        plotter = new_plotter()
        actor = plotter.add_mesh(pyvista.Cube())
        actor.position = (1, 2, 3)
        node = read(plotter).json["nodes"][0]
        np.testing.assert_array_equal(np.reshape(node["matrix"], (4, 4))[3], [1, 2, 3, 1])

    def test_what_has_an_inside_says_so_and_gleams(self) -> None:
        spoon = teaspoon(31, 12)
        gltf, _, primitive, material = single(spoon, smooth_shading=True, color="red")
        inside = gltf.array(primitive["attributes"]["_INSIDE"])
        np.testing.assert_allclose(inside.ravel() / 255, spoon.point_data["inside"], atol=0.002)
        # The bowl, upwards; not the handle.
        assert set(inside.ravel()[spoon.points[:, 0] < -0.1]) == {0}
        assert inside.max() == 255
        assert material["extras"] == {"lit": True, "gleam": 0.8}

    @pytest.mark.parametrize("rendered", [False, True])
    def test_camera(self, rendered: bool) -> None:
        plotter = new_plotter()
        plotter.add_mesh(pyvista.Sphere())
        if rendered:
            plotter.render()
        gltf = read(plotter)
        surroundings = gltf.json["scenes"][0]["extras"]
        place = {"position": list(EYE), "target": list(TARGET), "up": list(UP), "swing": 0}
        seen = {"viewAngle": VIEW_ANGLE, "aspect": SIZE[0] / SIZE[1]}
        assert surroundings["camera"] == place | seen
        matrix = np.reshape(gltf.json["nodes"][-1]["matrix"], (4, 4)).T
        np.testing.assert_allclose(matrix[:, 3], [*EYE, 1], atol=1e-12)
        np.testing.assert_allclose(-matrix[:, 2], [*AHEAD, 0], atol=1e-12)

    def test_the_same_scene_is_the_same_file(self) -> None:
        assert scene_gltf(demanding_scene()) == scene_gltf(demanding_scene())

    def test_equal_arrays_are_stored_once(self) -> None:
        plotter = new_plotter()
        for _ in range(2):
            plotter.add_mesh(pyvista.Sphere())
        first, second = (primitive for _, primitive, _ in read(plotter).parts())
        assert first["attributes"] == second["attributes"]

    @pytest.mark.parametrize(
        ("spoil", "complaint"),
        [
            (lambda p: p.enable_parallel_projection(), "parallel projection"),
            (lambda p: p.add_light(pyvista.Light(position=(1, 1, 1))), "lights that stay"),
            (lambda p: p.add_mesh(pyvista.Cube(), show_edges=True), "visible edges"),
            (lambda p: p.add_mesh(pyvista.Cube(), culling="back"), "culled faces"),
            (lambda p: p.add_mesh(pyvista.Line()), "lines or points"),
            (lambda p: p.add_mesh(pyvista.Cube(), style="wireframe"), "other than surface"),
            (lambda p: p.add_mesh(pyvista.Cube(), pbr=True), "physically based"),
            (lambda p: p.add_text("title", name="title"), "CornerAnnotation"),
            (lambda p: p.add_mesh(pyvista.Cube(), scalars=np.arange(6)), "vtkScalarBarActor"),
            (lambda p: p.add_mesh(pyvista.Cube(), scalars=np.arange(6)), "colours by"),
        ],
    )
    def test_what_no_page_can_show_is_refused(self, spoil: Any, complaint: str) -> None:
        plotter = new_plotter()
        spoil(plotter)
        with pytest.raises(ValueError, match=complaint):
            scene_gltf(plotter)


def project(point: Any) -> tuple[float, float]:
    """A pinhole camera, from its definition."""
    right = np.cross(AHEAD, UP)
    right /= np.linalg.norm(right)
    above = np.cross(right, AHEAD)
    seen = np.subtract(point, EYE)
    half = np.tan(np.deg2rad(VIEW_ANGLE / 2)) * (seen @ AHEAD)
    return (1 + seen @ right / half * SIZE[1] / SIZE[0]) / 2, (1 - seen @ above / half) / 2


class TestLabels:
    def test_lie_where_the_camera_sees_their_points_and_keep_text_and_color(self) -> None:
        labels = scene_labels(demanding_scene())
        assert len(labels) == 20
        for label in labels:
            left, top = project(label["position"])
            assert abs(label["left"] - left) < 1e-4
            assert abs(label["top"] - top) < 1e-4
        colors = {label["text"]: label["color"] for label in labels}
        assert (colors["$P_3$"], colors["north"]) == ("#0072b2", "#000000")

    @pytest.mark.parametrize(
        ("looks", "hidden"),
        [
            ({}, [False, True, True, True]),
            ({"opacity": 0.3}, [False, False, False, True]),
            ({"pickable": False}, [False, False, False, False]),
        ],
    )
    def test_hide_behind_surfaces(self, looks: dict[str, Any], hidden: list[bool]) -> None:
        """In front of a ball, in its middle, on its far side and behind it."""
        plotter = new_plotter()
        plotter.add_mesh(pyvista.Sphere(radius=1, theta_resolution=60, phi_resolution=60), **looks)
        toward = np.array(EYE) / np.linalg.norm(EYE)
        for distance in (1.5, 0.0, -0.99, -1.5):
            add_label(plotter, distance * toward, "$X$")
        assert [label["hidden"] for label in scene_labels(plotter)] == hidden

    def test_hide_behind_surfaces_that_were_moved(self) -> None:
        plotter = new_plotter()
        plotter.add_mesh(pyvista.Sphere(radius=0.3)).position = (0, 3, 0)
        add_label(plotter, (0, 0, 0), "$X$")
        add_label(plotter, (0, 3, 0), "$Y$")
        assert [label["hidden"] for label in scene_labels(plotter)] == [False, True]


class TestFigure:
    def test_needs_an_alternative_text(self) -> None:
        with pytest.raises(ValueError, match="alternative text"):
            book_figure(new_plotter())
        with pytest.raises(ValueError, match="says what the scene shows"):
            describe(new_plotter(), " ")

    def test_brings_everything_in_one_output(self) -> None:
        plotter = demanding_scene()
        gltf = scene_gltf(plotter)
        bundle = book_figure(plotter)._repr_mimebundle_()
        assert set(bundle) == {"text/plain", "image/png", MIME_TYPE}
        scene = bundle[MIME_TYPE]
        assert scene["alt"].startswith("Six points")
        assert (scene["width"], scene["height"]) == SIZE
        assert base64.b64decode(scene["gltf"]) == gltf
        poster = Image.open(io.BytesIO(base64.b64decode(scene["poster"])))
        assert poster.size == (POSTER_SCALE * SIZE[0], POSTER_SCALE * SIZE[1])

    def test_the_poster_has_no_trace_of_a_background(self) -> None:
        plotter = new_plotter()
        plotter.add_mesh(pyvista.Sphere(radius=0.5), color="#0072b2", opacity=0.3, lighting=False)
        describe(plotter, "A glass ball.")
        poster = Image.open(io.BytesIO(book_figure(plotter).poster))
        assert poster.getpixel((5, 5)) == (0, 0, 0, 0)
        *color, alpha = poster.getpixel((poster.width // 2 - 100, poster.height // 2))
        np.testing.assert_allclose(color, [0x00, 0x72, 0xB2], atol=2)
        # Through both sides of the ball.
        assert abs(alpha / 255 - (1 - 0.7**2)) < 0.01

    @pytest.mark.parametrize("take", [backend.take_poster, backend.still_picture])
    def test_what_lies_a_hair_behind_is_hidden(
        self, take: Any, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(pyvista, "OFF_SCREEN", True)
        plotter = parts.new_scene((32, 0, 0), (0, 0, 0), view_angle=4)
        for x, color in ((0, "#0072b2"), (-1e-3, "#d55e00")):
            square = pyvista.Plane(center=(x, 0, 0), direction=(-1, 0.4, 0.3))
            plotter.add_mesh(square, color=color, lighting=False)
        taken = take(plotter)
        picture = Image.open(io.BytesIO(taken)) if isinstance(taken, bytes) else taken
        red, _, blue = np.asarray(picture.convert("RGB"), int).T
        assert (blue - red).min() == 0 < (blue - red).max()


@pytest.mark.parametrize(
    ("labels", "expected"),
    [
        ({}, (0.2, 0.3)),
        ({0.5: False}, (0.2, 0.3)),
        ({0.15: False, 0.85: False}, (0.15 - LABEL / 500, 0.15 - LABEL / 500)),
        ({0.01: False, 0.99: False}, (0, 0)),
        ({0.01: True, 0.99: True}, (0.2, 0.3)),
    ],
)
def test_blanks_are_measured_by_ink_and_labels(labels: dict[float, bool], expected: Any) -> None:
    """A rectangle and labels: their places, and whether they are hidden."""
    poster = Image.new("RGBA", (1200, 1000), (9, 9, 9, 0))
    poster.paste((0, 0, 0, 40), (100, 200, 1100, 700))
    file = io.BytesIO()
    poster.save(file, "PNG")
    named = [{"top": top, "hidden": hidden} for top, hidden in labels.items()]
    assert blanks(file.getvalue(), 500, named) == pytest.approx(expected)


def test_parts_of_a_picture_stand_one_above_the_other() -> None:
    plotter = pyvista.Plotter(window_size=[300, 200])
    plotter.camera_position = ((0, -10, 0), (0, 0, 0), (0, 0, 1))
    inks = {"red": (-2.5, 0, 0.3), "blue": (2.4, 0, -0.4)}
    for ink, place in inks.items():
        plotter.add_mesh(pyvista.Sphere(radius=0.2, center=place), color=ink, lighting=False)
        plotter.add_point_labels([place], [ink], show_points=False, always_visible=True)
    stack_on_phone(plotter, (-20, 0, 140, 170, 1), (150, 50, 150, 150, 0.5))
    describe(plotter, "Two balls.")
    scene = book_figure(plotter)._repr_mimebundle_()[MIME_TYPE]
    stack = scene["stack"]
    assert stack["aspect"] == pytest.approx(1 / (170 / 140 + 0.5))
    picture = stacked_poster(base64.b64decode(scene["poster"]), stack)
    poster = Image.open(io.BytesIO(picture))
    assert poster.height == round(poster.width / stack["aspect"])
    alpha = np.asarray(poster)[..., 3] > 128
    for label, first, last in zip(scene["labels"], (0, 170), (170, 240), strict=True):
        left, top = in_stack(stack, label["left"], label["top"])
        place = round(left * poster.width), round(top * poster.height)
        *color, opacity = poster.getpixel(place)
        assert (*color, opacity) == (*pyvista.Color(label["text"]).int_rgb, 255)
        # The ball lies about its label, as large as its row shows it.
        rows = slice(*(round(y / 140 * poster.width) for y in (first, last)))
        down, across = np.nonzero(alpha[rows])
        assert np.mean(across) == pytest.approx(place[0], abs=2)
        assert np.mean(down) + rows.start == pytest.approx(place[1], abs=2)
    assert not book_figure(demanding_scene()).scene["stack"]


def test_a_scene_is_closed_when_its_cell_has_run() -> None:
    sources = (
        "from rotedu import scenes\nplotter = scenes.figure_1()",
        "plotter.show()",
        "import sys\nprint(plotter.render_window, 'anywidget' in sys.modules)",
    )
    notebook = nbformat.v4.new_notebook(cells=[*map(nbformat.v4.new_code_cell, sources)])
    NotebookClient(notebook).execute()
    _, shown, after = notebook.cells
    picture = Image.open(io.BytesIO(base64.b64decode(shown.outputs[0].data["image/png"])))
    assert picture.size == parts.SIZE
    assert np.asarray(picture).std() > 1
    # conftest.py sets PYVISTA_JUPYTER_BACKEND, so other backends were not loaded.
    assert after.outputs[0].text == "None False\n"


@pytest.mark.parametrize("handler", [book_figure, backend.still_picture])
def test_without_opengl_a_picture_is_refused(handler: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backend, "needs_no_display", lambda: True)
    monkeypatch.setattr(backend, "can_load", lambda _: False)
    with pytest.raises(RuntimeError, match="the package libosmesa6 or libegl1 on Debian"):
        handler(scenes.figure_1())


def test_one_opengl_library_is_enough(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backend, "needs_no_display", lambda: True)
    monkeypatch.setattr(backend, "can_load", "libEGL.so.1".__eq__)
    backend.require_opengl()
    # Set first, so that it is restored even if it was not there.
    monkeypatch.setenv("VTK_DEFAULT_OPENGL_WINDOW", "")
    monkeypatch.delenv("VTK_DEFAULT_OPENGL_WINDOW")
    backend.choose_render_window()
    assert os.environ["VTK_DEFAULT_OPENGL_WINDOW"] == "vtkEGLRenderWindow"


def test_a_library_that_is_missing_cannot_be_loaded() -> None:
    assert not backend.can_load("libNobodyHasThis.so.8")
