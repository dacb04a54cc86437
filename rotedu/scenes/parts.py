"""What the scenes share: an empty scene and the parts to put into it."""

from collections.abc import Sequence

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.arcs import slerp
from rotedu.colors import AXIS, NEUTRAL
from rotedu.figures.ball import draw_as_ball, fade_behind_ball, show_shadow
from rotedu.figures.state import limit_turning, place_label, place_part, stack_on_phone
from rotedu.scenes.shapes import ORIGIN, fan

SIZE = (720, 480)
NARROW = (576, 480)
"""Size of a scene that is about as wide as high: on a phone, its parts are larger."""
ROUND = (540, 480)
"""Size of a scene with a sphere, which then fills it, also on a phone."""
WEIGHTS = (1.2, 2.6, 5.0)
"""Widths of lines in pixels of the scene: of hairs, of things, and of what a picture is about."""
BODY = 6.5
"""What is wider, in pixels, is no line."""
TIP, HEAD = 1 / 3, 0.8
"""How much of a short arrow its head takes, and of one that only ends a bent line."""
LITTLE = (480, 240)
"""Size of the scene of a small figure."""
FILLED = 0.865
"""How much of the height the sphere fills; above and below, there is room for a label."""


def new_scene(
    eye: ArrayLike,
    target: ArrayLike,
    view_angle: float = 24.0,
    size: tuple[int, int] = SIZE,
    swing: float = 0,
    stack: Sequence[tuple[float, float, float, float, float]] = (),
) -> pyvista.Plotter:
    """Open an empty scene with the W axis pointing up.

    The camera at `eye` looks at `target` and sees `view_angle` degrees from top to bottom. If
    given, `limit_turning` gets `swing`, and `stack_on_phone` gets `stack`.
    """
    plotter = pyvista.Plotter(window_size=list(size))
    plotter.enable_anti_aliasing("ssaa")
    plotter.camera_position = (tuple(np.asarray(eye)), tuple(np.asarray(target)), (0, 0, 1))
    plotter.camera.view_angle = view_angle
    if swing:
        limit_turning(plotter, swing)
    if stack:
        stack_on_phone(plotter, *stack)
    return plotter


def sphere_scene(eye: ArrayLike, target: ArrayLike = ORIGIN) -> pyvista.Plotter:
    """Open a scene with the unit sphere, equally large from wherever it is seen."""
    radius = np.tan(np.arcsin(1 / np.linalg.norm(eye)))
    plotter = new_scene(eye, target, 2 * float(np.degrees(np.arctan(radius / FILLED))), ROUND)
    add_sphere(plotter)
    return plotter


def weight(plotter: pyvista.Plotter, radius: float) -> float:
    """Return the radius of a line whose width is one of `WEIGHTS`; what is thicker is a body."""
    camera = plotter.camera
    far = np.linalg.norm(np.subtract(camera.position, camera.focal_point))
    height = 2 * far * np.tan(np.deg2rad(camera.view_angle) / 2)
    wide = 2 * radius * plotter.window_size[1] / height
    if wide > BODY:
        return radius
    nearest = min(WEIGHTS, key=lambda width: abs(np.log(width / wide)))
    return float(radius * nearest / wide)


def add_line(
    plotter: pyvista.Plotter,
    points: ArrayLike,
    color: str,
    radius: float = 0.008,
    name: str = "line",
) -> pyvista.Actor:
    """Add a round line through points, shape (n, 3)."""
    return add_lines(plotter, [points], color, radius, name)


def add_lines(
    plotter: pyvista.Plotter,
    paths: Sequence[ArrayLike],
    color: str,
    radius: float = 0.008,
    name: str = "line",
) -> pyvista.Actor:
    """Add round lines as one part, each through points of shape (n, 3)."""
    arrays = [np.asarray(path, float) for path in paths]
    radius = weight(plotter, radius)
    tubes = [pyvista.MultipleLines(path).tube(radius=radius, n_sides=8) for path in arrays]
    mesh = tubes[0] if len(tubes) == 1 else pyvista.merge(tubes)
    return add_thin(plotter, mesh, color, place_part(plotter, name, paths=arrays, radius=radius))


def add_arrow(
    plotter: pyvista.Plotter,
    start: ArrayLike,
    end: ArrayLike,
    color: str,
    radius: float = 0.016,
    name: str = "arrow",
    tip: float = TIP,
) -> pyvista.Actor:
    """Add an arrow whose head has one size at any length, but takes no more than `tip` of it."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    radius = weight(plotter, radius)
    length = float(np.linalg.norm(end - start))
    head = min(9 * radius, tip * length)
    arrow = pyvista.Arrow(
        start=tuple(start),
        direction=tuple(end - start),
        scale=length,
        shaft_radius=min(radius, head / 4) / length,
        tip_radius=head / 3 / length,
        tip_length=head / length,
        tip_resolution=20,
        shaft_resolution=12,
    )
    name = place_part(plotter, name, **{"from": start, "to": end, "radius": radius, "tip": tip})
    return add_thin(plotter, arrow, color, name)


def add_point(
    plotter: pyvista.Plotter,
    point: ArrayLike,
    color: str,
    radius: float = 0.03,
    name: str = "point",
) -> pyvista.Actor:
    """Add a point, drawn as a small ball."""
    center = np.asarray(point, float)
    ball = pyvista.Sphere(
        radius=radius, center=tuple(center), theta_resolution=16, phi_resolution=12
    )
    return add_thin(plotter, ball, color, place_part(plotter, name, at=center, radius=radius))


def add_thin(
    plotter: pyvista.Plotter,
    mesh: pyvista.PolyData,
    color: str | NDArray[np.float64],
    name: str | None = None,
) -> pyvista.Actor:
    """Add a thin part, which does not hide the labels behind it, and is pale behind a ball.

    A mesh that brings no normals is smooth but for its sharp edges.
    """
    actor = plotter.add_mesh(
        mesh,
        color=color,
        smooth_shading=True,
        split_sharp_edges=mesh.point_data.active_normals is None,
        pickable=False,
        name=name,
    )
    if hasattr(plotter, "ball"):
        fade_behind_ball(actor, *plotter.ball)
    return actor


def add_shadow(
    plotter: pyvista.Plotter, spoon: str, place: ArrayLike, length: float, below: float
) -> pyvista.Actor:
    """Lay a soft shadow below a spoon, a part of half a `length` about a `place`."""
    x, y, z = np.asarray(place, float)
    ground = pyvista.Plane(center=(x, y, z - below), i_size=3 * length, j_size=3 * length)
    ground.clear_data()
    actor = plotter.add_mesh(
        ground,
        color=NEUTRAL,
        opacity=0.5,
        lighting=False,
        pickable=False,
        name=place_part(plotter, f"shadow of {spoon}"),
    )
    show_shadow(actor, spoon, (x, y, z - below), length)
    return actor


def add_label(
    plotter: pyvista.Plotter,
    point: ArrayLike | None,
    text: str,
    color: str = "black",
    name: str | None = None,
    view: str = "",
) -> None:
    """Write a text, or a formula between dollar signs, centred at a point, or nowhere for now."""
    place = place_label(plotter, name or text.strip("$"), point, view)
    actor = plotter.add_point_labels(
        np.reshape(np.asarray(ORIGIN if point is None else point, float), (1, 3)),
        [text],
        name=place,
        text_color=color,
        font_size=20,
        shape=None,
        show_points=False,
        always_visible=True,
        justification_horizontal="center",
        justification_vertical="center",
    )
    actor.SetVisibility(point is not None and not view)


def add_coordinate_axes(plotter: pyvista.Plotter, length: float) -> None:
    """Add the right-handed axes U, V, W and their origin O."""
    for direction, name in zip(np.eye(3), "UVW", strict=True):
        add_arrow(plotter, ORIGIN, length * direction, NEUTRAL, radius=0.006)
        add_label(plotter, (length + 0.07) * direction, f"${name}$")


def add_axis(plotter: pyvista.Plotter, axis: ArrayLike, text: str, length: float = 1.3) -> None:
    """Add a rotation axis, drawn as an arrow, and its name."""
    axis = np.asarray(axis, float)
    add_arrow(plotter, ORIGIN, length * axis, AXIS)
    add_label(plotter, (length + 0.1) * axis, text, AXIS)


def add_sphere(
    plotter: pyvista.Plotter, center: ArrayLike = ORIGIN, radius: float = 1.0
) -> pyvista.Actor:
    """Add a sphere of glass, which hides the labels behind it; its thin parts come after it."""
    # The mesh contains the sphere: the middles of its faces touch it.
    mesh = pyvista.Sphere(
        radius=radius / np.cos(np.pi / 60) ** 2,
        center=tuple(np.asarray(center, float)),
        theta_resolution=60,
        phi_resolution=31,
    )
    mesh.clear_data()
    actor = plotter.add_mesh(mesh, color=NEUTRAL, opacity=0.3, smooth_shading=False)
    draw_as_ball(actor, center, radius)
    vars(plotter)["ball"] = (center, radius)
    return actor


def add_arc(
    plotter: pyvista.Plotter, start: ArrayLike, end: ArrayLike, color: str, radius: float = 0.006
) -> None:
    """Add the shortest arc of the unit sphere from one point to another."""
    add_line(plotter, slerp(start, end, np.linspace(0, 1, 17)), color, radius)


def add_angle(
    plotter: pyvista.Plotter,
    start: ArrayLike,
    end: ArrayLike,
    text: str,
    size: float = 0.45,
    place: float = 0.64,
) -> None:
    """Mark and name the angle at the origin between two directions."""
    rim = size * slerp(start, end, np.linspace(0, 1, 25))
    sector = fan([ORIGIN, *rim])
    plotter.add_mesh(sector, color=NEUTRAL, opacity=0.35, lighting=False, pickable=False)
    for direction in (start, end):
        add_line(plotter, [ORIGIN, np.asarray(direction, float)], NEUTRAL, radius=0.004)
    add_label(plotter, place * rim[len(rim) // 2], text)
