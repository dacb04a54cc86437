"""The figures in three dimensions: what they show is what they say."""

import numpy as np
import pytest
import pyvista

from rotedu import scenes
from rotedu.ordinary_rotation import rotate


def meshes(plotter: pyvista.Plotter, color: str) -> list[pyvista.PolyData]:
    actors = [a for a in plotter.actors.values() if isinstance(a, pyvista.Actor)]
    return [a.mapper.dataset for a in actors if a.prop.color == pyvista.Color(color)]


@pytest.mark.parametrize("between", [0.3, np.deg2rad(50), 1.2])
def test_two_mirrors_turn_the_letter_by_twice_their_angle(between: float) -> None:
    plotter = scenes.two_mirrors(between)
    (before,), (after,) = (meshes(plotter, color) for color in (scenes.VECTOR, scenes.RESULT))
    turned = rotate(before.points, [0, 0, 1], 2 * between)
    np.testing.assert_allclose(after.points, turned, rtol=0, atol=1e-6)
    np.testing.assert_allclose(after.volume, before.volume, rtol=1e-5)
    assert before.volume > 0


def test_no_turn_maps_the_letter_f_to_its_mirror_image() -> None:
    corners = np.unique(scenes.letter_f().points.round(6), axis=0)
    mirrored = corners * [-1, 1, 1]
    for angle in np.linspace(0, 2 * np.pi, 73):
        distances = np.linalg.norm(rotate(mirrored, [0, 0, 1], angle)[:, None] - corners, axis=-1)
        assert distances.min(axis=1).max() > 0.05
