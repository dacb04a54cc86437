"""A pyvista scene as binary glTF: all that a viewer needs to draw it as pyvista does.

Surfaces, their colours and opacity, and the camera are stored as the glTF standard says. VTK's
looks go beyond the standard and travel as ``extras``. The scene has the camera's target; each
material says whether light falls on it and how much it gleams; each node says whether its part
hides labels (``pickable``).

Round lines, arrows, points and balls of glass travel as the points that they are drawn through or
around, because the viewer can draw them anew.

The surfaces of spoons come last, and ``shared`` says how many bytes they take: a page has these in
a file of their own, which its figures share.

Positions are float32. Normals are rounded to 1/127. Colours are linear, as the standard requires.
"""

import json
import struct
from collections.abc import Iterator
from typing import Any, cast

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.figures.ball import ball_looks
from rotedu.figures.light import INSIDE, gleam_of

COMPONENT_TYPES = {
    "float32": 5126,
    "int8": 5120,
    "uint8": 5121,
    "uint16": 5123,
    "uint32": 5125,
}
VERTEX_DATA, INDICES = 34962, 34963
INSTANCES = "EXT_mesh_gpu_instancing"
STRIP = 5
# glTF reserves the largest index of a type.
USHORT_POINTS = 65535


def scene_gltf(plotter: pyvista.Plotter) -> bytes:
    """Write a scene, without its labels, as binary glTF (``.glb``); refuse what it cannot carry."""
    _refuse_what_cannot_travel(plotter)
    named = part_names(plotter)
    recorded = getattr(plotter, "record", None)
    places = {name: recorded.parts.get(name, {}) if recorded else {} for name, _ in named}
    binary = _Binary()
    made: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {}
    for are_spoons in (False, True):
        start = len(binary.content)
        for name, actor in named:
            if _is_spoon(actor, places[name]) == are_spoons:
                made[name] = _part(actor, name, places[name], binary)
    nodes = [made[name][0] | {"mesh": mesh} for mesh, (name, _) in enumerate(named)]
    primitives = [made[name][1] | {"material": mesh} for mesh, (name, _) in enumerate(named)]
    camera, camera_node = _camera(plotter)
    document = {
        "asset": {
            "version": "2.0",
            "generator": "rotedu.figures.gltf",
            "extras": {"shared": len(binary.content) - start},
        },
        "extensionsUsed": ["KHR_materials_unlit", "KHR_mesh_quantization", INSTANCES],
        "extensionsRequired": ["KHR_mesh_quantization"],
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes) + 1)), "extras": _surroundings(plotter)}],
        "nodes": [*nodes, camera_node],
        "meshes": [
            {"name": name, "primitives": [primitive]}
            for (name, _), primitive in zip(named, primitives, strict=True)
        ],
        "materials": [_material(actor) for _, actor in named],
        "cameras": [camera],
        "accessors": binary.accessors,
        "bufferViews": binary.views,
        "buffers": [{"byteLength": len(binary.content)}],
    }
    return _container(json.dumps(document, separators=(",", ":")).encode(), bytes(binary.content))


def part_names(plotter: pyvista.Plotter) -> list[tuple[str, pyvista.Actor]]:
    """Name the parts of a scene that are drawn, or hidden for now; without a name by a number."""
    recorded = getattr(plotter, "record", None)
    named: list[tuple[str, pyvista.Actor]] = []
    for name, actor in plotter.actors.items():
        if isinstance(actor, pyvista.Actor) and (
            actor.visibility or (recorded and name in recorded.parts)
        ):
            # pyvista names an actor without a name after its address in memory.
            named.append((f"part {len(named)}" if "Addr=" in name else name, actor))
    return named


class _Binary:
    """The numbers of a glTF file, which stores equal arrays only once."""

    def __init__(self) -> None:
        self.content = bytearray()
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, Any]] = []
        self.known: dict[tuple[bytes, str], int] = {}

    def add(self, array: NDArray[Any], target: int, **properties: Any) -> int:
        """Store an array, shape (count, components), and return the index of its accessor."""
        key = (array.tobytes(), f"{array.dtype} {array.shape} {target}")
        if key in self.known:
            return self.known[key]
        count, components = array.shape
        row = components * array.itemsize
        view = {"buffer": 0, "byteOffset": len(self.content), "target": target}
        if target == VERTEX_DATA and row % 4:
            # Every vertex starts at a multiple of four bytes.
            array = np.pad(array, ((0, 0), (0, (-row % 4) // array.itemsize)))
            view["byteStride"] = row + -row % 4
        data = array.tobytes()
        self.content += data + bytes(-len(data) % 4)
        self.views.append(view | {"byteLength": len(data)})
        self.accessors.append(
            {
                "bufferView": len(self.views) - 1,
                "componentType": COMPONENT_TYPES[array.dtype.name],
                "count": count,
                "type": {1: "SCALAR", 3: "VEC3", 4: "VEC4"}[components],
            }
            | properties
        )
        self.known[key] = len(self.accessors) - 1
        return self.known[key]


def surface_of(actor: pyvista.Actor) -> pyvista.PolyData:
    """Return the surface of an actor, before its own matrix moves it."""
    # pyvista may have put filters before the mapper that have not run yet.
    actor.mapper.update()
    dataset = actor.mapper.dataset
    if isinstance(dataset, pyvista.PolyData):
        return dataset
    return cast(pyvista.PolyData, dataset.extract_surface(algorithm=None))


def _is_spoon(actor: pyvista.Actor, place: dict[str, Any]) -> bool:
    """Whether other scenes may have the same surface: a heap has places of its own."""
    return INSIDE in surface_of(actor).point_data and "heap" not in place


def _part(
    actor: pyvista.Actor, name: str, place: dict[str, Any], binary: _Binary
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Store a part of a scene, and return its node and what it draws."""
    node = _node(actor, name, place)
    if paths := _drawn_by_viewer(actor, place):
        node["extras"]["lengths"] = [len(path) for path in paths]
        points = np.concatenate(paths).astype(np.float32)
        return node, {"attributes": _positions(points, binary)}
    surface = surface_of(actor)
    if "heap" in place:
        surface, places = place["heap"]
        node["extensions"] = {INSTANCES: {"attributes": _places(binary, *places)}}
    return node, _primitive(actor, surface, binary)


def _places(binary: _Binary, points: ArrayLike, turns: ArrayLike) -> dict[str, int]:
    """Store where equal surfaces are: points, shape (n, 3), and quaternions, shape (n, 4)."""
    # glTF writes the scalar last.
    arrays = {"TRANSLATION": points, "ROTATION": np.roll(turns, -1, axis=1)}
    return {name: binary.add(np.asarray(a, np.float32), VERTEX_DATA) for name, a in arrays.items()}


def _drawn_by_viewer(actor: pyvista.Actor, place: dict[str, Any]) -> list[NDArray[np.float64]]:
    """Return the points, shape (n, 3), of each line, or of an arrow, or of a ball."""
    paths = place.get("paths", [])
    if "tip" in place:
        paths = [[place["from"], place["to"]]]
    elif "at" in place and "radius" in place:
        paths = [[place["at"]]]
    elif ball := ball_looks(actor).get("ball"):
        paths = [[ball[:3]]]
    return [np.asarray(path, float) for path in paths]


def _positions(points: NDArray[np.float32], binary: _Binary) -> dict[str, int]:
    """Store points, shape (n, 3), and where they end."""
    low, high = (extreme(axis=0).tolist() for extreme in (points.min, points.max))
    return {"POSITION": binary.add(points, VERTEX_DATA, min=low, max=high)}


def _primitive(actor: pyvista.Actor, surface: pyvista.PolyData, binary: _Binary) -> dict[str, Any]:
    """Store a surface as an actor shows it."""
    points = np.asarray(surface.points, np.float32)
    attributes = _positions(points, binary)
    normals = surface.point_data.active_normals
    if normals is not None and actor.prop.interpolation.value != 0:
        rounded = np.rint(127 * np.asarray(normals)).astype(np.int8)
        attributes["NORMAL"] = binary.add(rounded, VERTEX_DATA, normalized=True)
    if INSIDE in surface.point_data:
        share = np.rint(255 * np.asarray(surface.point_data[INSIDE])).astype(np.uint8)
        attributes["_INSIDE"] = binary.add(share.reshape(-1, 1), VERTEX_DATA, normalized=True)
    index_type = np.uint16 if len(points) <= USHORT_POINTS else np.uint32
    indices = binary.add(_strip(surface).astype(index_type).reshape(-1, 1), INDICES)
    return {"attributes": attributes, "indices": indices, "mode": STRIP}


def _strip(surface: pyvista.PolyData) -> NDArray[np.int64]:
    """Return the corners of all faces as one strip of triangles.

    A strip needs a third as many numbers as single triangles. Triangles without area join the
    strips that VTK finds. Every strip begins at an even place, so that its faces keep their front.
    """
    strips = surface.triangulate().strip(max_length=10**6)
    corners: list[int] = []
    for cells in (strips.strips, strips.faces):
        for strip in _cells(np.asarray(cells)):
            if corners:
                corners += [corners[-1], *[strip[0]] * (1 + len(corners) % 2)]
            corners += strip.tolist()
    return np.array(corners, np.int64)


def _cells(connectivity: NDArray[np.int64]) -> Iterator[NDArray[np.int64]]:
    """Yield the points of each cell from VTK's list of lengths and points."""
    start = 0
    while start < len(connectivity):
        end = start + 1 + connectivity[start]
        yield connectivity[start + 1 : end]
        start = end


def _linear(color: ArrayLike) -> NDArray[np.float64]:
    """Take the gamma of sRGB out of a colour."""
    color = np.asarray(color, float)
    return np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)


def _material(actor: pyvista.Actor) -> dict[str, Any]:
    """Describe the looks of an actor."""
    prop = actor.prop
    color = _linear(prop.color.float_rgb)
    material: dict[str, Any] = {
        "pbrMetallicRoughness": {
            "baseColorFactor": [*(round(float(x), 6) for x in color), prop.opacity],
            "metallicFactor": 0,
        },
        "doubleSided": True,
        "extras": {
            "lit": prop.lighting,
            "gleam": gleam_of(actor, surface_of(actor)),
        }
        | ball_looks(actor),
    }
    if prop.opacity < 1:
        material["alphaMode"] = "BLEND"
    if not prop.lighting:
        material["extensions"] = {"KHR_materials_unlit": {}}
    return material


def _node(actor: pyvista.Actor, name: str, place: dict[str, Any]) -> dict[str, Any]:
    """Place an actor in the scene, with what the viewer needs to draw a moved part anew."""
    extras: dict[str, Any] = {"pickable": bool(actor.GetPickable())}
    if not actor.visibility:
        extras["hidden"] = True
    extras |= {
        k: np.asarray(place[k], float).tolist()
        for k in ("at", "radius", "tip", "count")
        if k in place
    }
    node: dict[str, Any] = {"name": name, "extras": extras}
    matrix = pyvista.array_from_vtkmatrix(actor.GetMatrix())
    if not np.array_equal(matrix, np.eye(4)):
        node["matrix"] = matrix.T.ravel().tolist()
    return node


def _camera(plotter: pyvista.Plotter) -> tuple[dict[str, Any], dict[str, Any]]:
    """Describe the camera as the standard says, and its place in the scene."""
    width, height = plotter.window_size
    near, far = plotter.camera.clipping_range
    view = pyvista.array_from_vtkmatrix(plotter.camera.GetModelViewTransformMatrix())
    perspective = {
        "aspectRatio": width / height,
        "yfov": float(np.deg2rad(plotter.camera.view_angle)),
        "znear": near,
        "zfar": far,
    }
    node = {
        "camera": 0,
        "name": "camera",
        "matrix": np.linalg.inv(view.astype(float)).T.ravel().tolist(),
    }
    return {"type": "perspective", "perspective": perspective}, node


def _surroundings(plotter: pyvista.Plotter) -> dict[str, Any]:
    """Return the camera data that an orbit needs."""
    camera = plotter.camera
    recorded = getattr(plotter, "record", None)
    return {
        "camera": {
            "position": list(camera.position),
            "target": list(camera.focal_point),
            "up": list(camera.up),
            "viewAngle": camera.view_angle,
            "aspect": plotter.window_size[0] / plotter.window_size[1],
            "swing": recorded.swing if recorded else 0,
        },
    }


def _refuse_what_cannot_travel(plotter: pyvista.Plotter) -> None:
    """Refuse a scene that the poster and the viewer would show differently."""
    actors = {name: actor for name, actor in plotter.actors.items() if actor.GetVisibility()}
    parts = [actor for actor in actors.values() if isinstance(actor, pyvista.Actor)]
    others = {
        type(actor).__name__
        for name, actor in actors.items()
        if not isinstance(actor, pyvista.Actor) and not name.endswith("-labels")
    }
    refused = {
        "several views": len(plotter.renderers) > 1,
        "a parallel projection": plotter.camera.parallel_projection,
        "lights that stay in place": any(
            light.on and (light.is_scene_light or light.positional)
            for light in plotter.renderer.lights
        ),
        "textures": any(part.texture for part in parts),
        "lines or points": any(surface_of(p).n_lines + surface_of(p).n_verts for p in parts),
        "a style other than surface": any(part.prop.style != "Surface" for part in parts),
        "colours by point or cell": any(part.mapper.scalar_visibility for part in parts),
        "visible edges": any(part.prop.show_edges for part in parts),
        "physically based rendering": any(part.prop.interpolation.name == "PBR" for part in parts),
        "culled faces": any(part.prop.culling != "none" for part in parts),
        ", ".join(sorted(others)): bool(others),
    }
    if found := [what for what, is_there in refused.items() if is_there]:
        raise ValueError(f"scene: expected what a web page can show, got {'; '.join(found)}")


def _container(document: bytes, binary: bytes) -> bytes:
    """Join the two parts of the file, each padded to a multiple of four bytes."""
    chunks = b""
    for kind, content in ((b"JSON", document.ljust(-len(document) // 4 * -4)), (b"BIN\0", binary)):
        chunks += struct.pack("<I", len(content)) + kind + content
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks
