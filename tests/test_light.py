"""The light on solid bodies and their shadows, where VTK's pixels can be foretold."""

import io
from typing import Any

import numpy as np
import pytest
import pyvista
from PIL import Image
from test_colors import linear

from rotedu.figures.backend import take_poster
from rotedu.figures.light import INSIDE
from rotedu.scenes.parts import add_shadow, new_scene
from rotedu.scenes.shapes import teaspoon


def poster(plotter: pyvista.Plotter) -> np.ndarray:
    seen = np.asarray(Image.open(io.BytesIO(take_poster(plotter))), float)
    plotter.close()
    return seen / 255


def drawn(mesh: pyvista.PolyData, color: str = "#0072b2", **looks: Any) -> np.ndarray:
    """A mesh seen along the U axis from afar: V to the right, W up."""
    plotter = new_scene((50, 0, 0), (0, 0, 0), 3)
    plotter.add_mesh(mesh, color=color, smooth_shading=True, **looks)
    return poster(plotter)


@pytest.mark.parametrize("color", ["#0072b2", "#d55e00", "#7d858d"])
def test_what_faces_the_eye_has_its_colour_times_the_light(color: str) -> None:
    """Sky and ground by the height of the normal, the key by its angle, a little of the ceiling."""
    seen = drawn(pyvista.Plane(direction=(1, 0, 0)), color)
    height = (1 + 0.425) / 2
    light = np.array([0.30, 0.28, 0.26]) * (1 - height) + np.array([0.66, 0.68, 0.72]) * height
    light += np.array([0.58, 0.57, 0.55]) * ((0.592 + 0.2) / 1.2) ** 2
    t = (0.425 - 0.15) / 0.6
    gleam = 0.35 * 0.03 * t * t * (3 - 2 * t)
    expected = linear(color) * light + gleam
    here = seen[seen.shape[0] // 2, seen.shape[1] // 2]
    np.testing.assert_allclose(linear(here[:3]), expected, atol=0.006)
    assert here[3] == 1


def test_light_comes_from_above_on_the_left_and_a_window_is_seen_there() -> None:
    ball = drawn(pyvista.Sphere(radius=1, theta_resolution=60, phi_resolution=60))
    brightness = ball[..., :3].sum(axis=2) * (ball[..., 3] == 1)
    rows, columns = (size // 2 for size in brightness.shape)
    upper, lower = brightness[:rows], brightness[rows:]
    assert upper[:, :columns].mean() > 1.1 * upper[:, columns:].mean()
    assert upper.mean() > 1.2 * lower.mean()
    brightest = np.array(np.unravel_index(brightness.argmax(), brightness.shape))
    assert (brightest < [rows, columns]).all()


def test_what_is_seen_through_mirrors_nothing_and_unlit_parts_keep_their_colour() -> None:
    clear = drawn(pyvista.Sphere(radius=1), opacity=0.5)[..., :3].max()
    solid = drawn(pyvista.Sphere(radius=1))[..., :3].max()
    assert clear < solid - 0.1
    flat = drawn(pyvista.Sphere(radius=1), lighting=False)
    inks = flat[flat[..., 3] == 1][:, :3]
    np.testing.assert_allclose(inks, [pyvista.Color("#0072b2").float_rgb] * len(inks), atol=0.005)


def test_the_inside_is_lighter() -> None:
    plane = pyvista.Plane(direction=(1, 0, 0))
    outside = drawn(plane.copy())
    plane.point_data[INSIDE] = np.ones(plane.n_points)
    inside = drawn(plane)
    middle = tuple(size // 2 for size in outside.shape[:2])
    assert (inside[middle][:3] > outside[middle][:3] + 0.01).all()


def test_a_spoon_has_no_corner() -> None:
    spoon = teaspoon()
    # Its outline from above, the same at both sides, turns by little from station to station.
    outline = np.array([[ring[:, 0].mean(), ring[:, 1].max()] for ring in rings(spoon)])
    steps = np.diff(outline[np.abs(outline[:, 0]) < 0.9], axis=0)
    turned = np.diff(np.unwrap(np.arctan2(steps[:, 1], steps[:, 0])))
    assert np.degrees(np.abs(turned)).max() < 12
    np.testing.assert_allclose([r[:, 1].max() + r[:, 1].min() for r in rings(spoon)], 0, atol=1e-6)


def rings(spoon: pyvista.PolyData) -> np.ndarray:
    return np.reshape(np.asarray(spoon.points), (121, 40, 3))


def shadow_of(pose: np.ndarray) -> np.ndarray:
    """How dark the ground is below a spoon, seen from high above: U to the right, V up."""
    plotter = new_scene((0.001, 0, 50), (0, 0, 0), 4)
    body = plotter.add_mesh(teaspoon(31, 12), color="#0072b2", name="spoon", opacity=0)
    body.user_matrix = pose
    add_shadow(plotter, "spoon", (0, 0, 0), 1, 0.8)
    return poster(plotter)[..., 3]


def test_a_shadow_lies_below_its_spoon_and_follows_it() -> None:
    lying, upright = shadow_of(np.eye(4)), shadow_of(np.eye(4)[[1, 2, 0, 3]])
    assert 0.1 < lying.max() < 0.3
    # The bowl is wider than the handle, and an upright spoon is short from above.
    down, across = np.nonzero(lying > 0.05)
    assert np.ptp(down) != pytest.approx(np.ptp(across), rel=0.3)
    assert (upright > 0.05).sum() < 0.6 * (lying > 0.05).sum()
    assert lying[:4].max() == lying[-4:].max() == 0
