import numpy as np
import pytest
import pyvista

from rotedu import scenes
from rotedu.book_backend import scene_labels
from rotedu.ordinary_rotation import rotate

SCENES = [
    getattr(scenes, name)
    for name in dir(scenes)
    if name.startswith("figure_") or name in ("rotated_mesh", "turning_spoon")
]


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_a_scene_says_what_it_shows_and_keeps_its_labels_in_the_picture(scene) -> None:
    plotter = scene()
    assert isinstance(plotter, pyvista.Plotter)
    assert len(plotter.alt_text) > 40
    labels = scene_labels(plotter)
    assert labels
    for label in labels:
        assert 0.01 < label["left"] < 0.99
        assert 0.01 < label["top"] < 0.99
        assert not label["hidden"]


def test_figure_1_takes_its_vector_axis_and_angle() -> None:
    vector, axis, angle = [0.8, 0.2, 0.5], [0, 0.3, 1], 1.1
    labels = {
        label["text"]: np.array(label["position"])
        for label in scene_labels(scenes.figure_1(vector, axis, angle))
    }
    for text, direction in {
        r"$\hat n$": axis,
        r"$\vec r$": vector,
        r"$\vec r^{\,\prime}$": rotate(vector, axis, angle),
    }.items():
        assert np.allclose(np.cross(labels[text], direction), 0)


def test_the_teaspoon_is_a_closed_surface_but_for_its_ends() -> None:
    spoon = scenes.teaspoon(stations=31, around=12)
    assert spoon.n_points == 31 * 12
    assert spoon.is_manifold or spoon.n_open_edges == 2 * 12


def test_a_mesh_of_ones_own_is_turned() -> None:
    plotter = scenes.rotated_mesh(pyvista.Cube())
    assert "8 vertices" in plotter.alt_text or "24 vertices" in plotter.alt_text
