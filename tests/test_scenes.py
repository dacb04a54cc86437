"""The figures in three dimensions: what they show is what they say."""

import numpy as np

from rotedu import scenes
from rotedu.interpolation import angle_between, bisect, control_points, double
from rotedu.ordinary_rotation import rotate


def test_construction_of_figures_3_to_7_is_that_of_control_points() -> None:
    points = np.random.default_rng(3).normal(size=(3, 3))
    found = scenes.neighbours(points)
    a, b = control_points(points)
    np.testing.assert_allclose(found[scenes.A], a[1], atol=1e-14)
    np.testing.assert_allclose(found[scenes.B], b[1], atol=1e-14)


def test_their_points_hide_no_lost_bar() -> None:
    """Each bisected angle differs from the one named without the bar."""
    p = scenes.neighbours(scenes.NEIGHBOURS)
    pairs = (
        ((scenes.REFLECTED, scenes.AFTER), (scenes.BEFORE, scenes.HERE)),
        ((scenes.MIDDLE, scenes.HERE), (scenes.HERE, scenes.AFTER)),
    )
    for with_bar, without in pairs:
        angles = [angle_between(p[start], p[end]) for start, end in (with_bar, without)]
        assert abs(np.sin(angles[0]) - np.sin(angles[1])) > 0.05


def test_reversed_axis_is_that_of_5_9_as_printed() -> None:
    p = np.asarray(scenes.LOOP) / np.linalg.norm(scenes.LOOP, axis=1, keepdims=True)
    reflected, after = double(np.roll(p, 1, axis=0), p), np.roll(p, -1, axis=0)
    printed = np.cross(after, reflected)
    middle = rotate(reflected, printed, angle_between(reflected, after) / 2)
    a, b = scenes.astray(p)
    np.testing.assert_allclose(a, bisect(p, middle), atol=1e-14)
    np.testing.assert_allclose(b, double(a, p), atol=1e-14)
