"""A scene with everything that the figures need: a glass ball, arcs, points, twenty labels."""

import numpy as np
import pyvista

from rotedu.figures import describe
from rotedu.figures.ball import draw_as_ball, fade_behind_ball

SIZE = (720, 540)
EYE, TARGET, UP = (4.0, -2.0, 2.2), (0.0, 0.0, 0.1), (0.0, 0.0, 1.0)
VIEW_ANGLE = 30.0


def new_plotter() -> pyvista.Plotter:
    plotter = pyvista.Plotter(window_size=list(SIZE), off_screen=True)
    plotter.enable_anti_aliasing("ssaa")
    plotter.camera_position = (EYE, TARGET, UP)
    plotter.camera.view_angle = VIEW_ANGLE
    return plotter


def add_label(plotter: pyvista.Plotter, point: object, text: str, color: str = "black") -> None:
    plotter.add_point_labels(
        np.reshape(np.asarray(point, float), (1, 3)),
        [text],
        name=f"label {len(plotter.actors)}",
        text_color=color,
        shape=None,
        show_points=False,
        always_visible=True,
    )


def great_circle(p: np.ndarray, q: np.ndarray, steps: int = 33) -> np.ndarray:
    t = np.linspace(0, 1, steps)[:, None]
    chord = (1 - t) * p + t * q
    return chord / np.linalg.norm(chord, axis=1, keepdims=True)


def ball(center: np.ndarray, radius: float = 0.035) -> pyvista.PolyData:
    return pyvista.Sphere(radius=radius, center=center, theta_resolution=16, phi_resolution=12)


def demanding_scene() -> pyvista.Plotter:
    """Draw six points on a glass ball, the arcs between them and the arcs between their ends."""
    plotter = new_plotter()
    glass = pyvista.Sphere(radius=1.003, theta_resolution=60, phi_resolution=60)
    draw_as_ball(plotter.add_mesh(glass, opacity=0.2, name="glass"), (0, 0, 0), 1)
    turn = np.linspace(0, 2 * np.pi, 6, endpoint=False)
    tilt = 0.5 * np.cos(2 * turn)
    points = np.column_stack(
        [np.cos(turn) * np.cos(tilt), np.sin(turn) * np.cos(tilt), np.sin(tilt)]
    )
    thin = {"smooth_shading": True, "pickable": False}
    for i, p in enumerate(points):
        arc = great_circle(p, points[i - 1])
        inner = great_circle(arc[11], arc[22], 17)
        other = great_circle(arc[16], points[(i + 1) % 6], 25)
        looks = ((arc, "#0072b2", 0.012), (inner, "#d55e00", 0.017), (other, "#009e73", 0.014))
        for line, color, radius in looks:
            tube = pyvista.MultipleLines(line).tube(radius=radius, n_sides=8)
            fade_behind_ball(plotter.add_mesh(tube, color=color, **thin), (0, 0, 0), 1)
        plotter.add_mesh(ball(p), color="#0072b2", name=f"P{i}", **thin)
        plotter.add_mesh(ball(arc[16]), color="#d55e00", **thin)
        add_label(plotter, 1.12 * p, f"$P_{i}$", "#0072b2")
        add_label(plotter, 1.12 * arc[16], f"$A_{i}$", "#d55e00")
        add_label(plotter, 1.12 * other[12], f"$B_{i}$")
    add_label(plotter, (0, 0, 0), "$O$")
    add_label(plotter, (0, 0, 1.15), "north")
    sector = np.vstack([np.zeros(3), 0.6 * great_circle(points[0], points[1], 25)])
    corners = np.column_stack([np.zeros(24, int), np.arange(24) + 1, np.arange(24) + 2])
    fan = pyvista.PolyData.from_regular_faces(sector, corners)
    plotter.add_mesh(fan, color="#b65f92", opacity=0.4, lighting=False, pickable=False)
    describe(plotter, "Six points on a glass ball, joined by arcs of great circles.")
    return plotter


def scene_of_all_looks() -> pyvista.Plotter:
    """Draw one of each kind of surface."""
    plotter = new_plotter()
    round_ball = pyvista.Sphere(radius=0.5, theta_resolution=40, phi_resolution=40)
    shiny = {"specular": 0.6, "specular_power": 15, "smooth_shading": True}
    plotter.add_mesh(pyvista.Cube().scale(0.7).translate((0, -1.2, 0)), color="#0072b2")
    plotter.add_mesh(round_ball, color="#d55e00", **shiny)
    plotter.add_mesh(round_ball.translate((0, 1.2, 0)), color="#009e73")
    describe(plotter, "A box and two balls in a row, one smooth, one with facets.")
    return plotter
