"""The ball of glass: VTK's pixels where geometry says that something must be seen."""

import io

import numpy as np
import pytest
import pyvista
from numpy.typing import ArrayLike
from PIL import Image

from rotedu.figures.backend import take_poster
from rotedu.figures.ball import ball_looks
from rotedu.figures.pages import light_poster
from rotedu.scenes.parts import add_line, add_point, add_sphere, new_scene

EYE = np.array([5.0, 0, 0])
VIEW_ANGLE = 28.0
HALF = np.tan(np.deg2rad(VIEW_ANGLE / 2))
# Half the height of a poster in pixels.
MIDDLE = 480


def scene() -> pyvista.Plotter:
    """An empty scene, seen along the U axis: V to the right, W up."""
    return new_scene(EYE, (0, 0, 0), VIEW_ANGLE)


def pixels(file: bytes) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(file)), float) / 255


def pixel(point: ArrayLike) -> tuple[int, int]:
    depth, right, up = np.asarray(point, float)
    scale = MIDDLE / HALF / (EYE[0] - depth)
    return round(MIDDLE - scale * up - 0.5), round(1.5 * MIDDLE + scale * right - 0.5)


def opacity(seen: np.ndarray, point: ArrayLike) -> float:
    """The opacity of the strongest of nine pixels about a point."""
    row, column = pixel(point)
    return float(seen[row - 1 : row + 2, column - 1 : column + 2, 3].max())


def place(azimuth: float, height: float, radius: float = 1) -> np.ndarray:
    azimuth, height = np.deg2rad([azimuth, height])
    level = np.cos(height)
    return radius * np.array([level * np.cos(azimuth), level * np.sin(azimuth), np.sin(height)])


@pytest.fixture(scope="module")
def poster() -> bytes:
    plotter = scene()
    add_sphere(plotter)
    return take_poster(plotter)


@pytest.fixture(scope="module")
def ball(poster: bytes) -> np.ndarray:
    return pixels(poster)


def test_its_outline_is_a_circle_whatever_the_mesh(ball: np.ndarray) -> None:
    radius = MIDDLE / HALF / np.sqrt(EYE @ EYE - 1)
    rows, columns = np.nonzero(ball[..., 3] > 0.1)
    distance = np.hypot(rows - MIDDLE + 0.5, columns - 1.5 * MIDDLE + 0.5)
    assert distance.max() < radius + 1
    angle = np.degrees(np.arctan2(rows - MIDDLE, columns - 1.5 * MIDDLE)).astype(int)
    for degree in range(-179, 180):
        assert distance[angle == degree].max() > radius - 1


def test_it_is_clear_in_the_middle_and_dense_at_the_rim(ball: np.ndarray) -> None:
    assert max(opacity(ball, place(azimuth, 15)) for azimuth in (-15, 15)) < 0.12
    # No line crosses the rim in this row.
    across = ball[MIDDLE - 60, : 3 * MIDDLE // 2, 3]
    edge = np.flatnonzero(across > 0.1)[0]
    assert across[edge + 1 : edge + 4].min() > 0.45
    assert np.median(across[edge + 20 : edge + 40]) < 0.3


@pytest.mark.parametrize("angle", [-60, -30, 0, 30, 60])
def test_lines_are_30_degrees_apart(ball: np.ndarray, angle: float) -> None:
    """Parallels and meridians, each compared with a place beside it."""
    beside = angle + (4 if angle < 0 else -4)
    for other in (-15, 10, 20):
        assert opacity(ball, place(other, angle)) > opacity(ball, place(other, beside)) + 0.1
        assert opacity(ball, place(angle, other)) > opacity(ball, place(beside, other)) + 0.1


def test_the_back_is_fainter_than_the_front_and_light_comes_from_above(ball: np.ndarray) -> None:
    before, behind = (opacity(ball, place(azimuth, 30)) for azimuth in (15, 165))
    assert opacity(ball, place(165, 20)) + 0.05 < behind < before - 0.15
    up, down = (ball[pixel(place(15, height))][:3].mean() for height in (45, -45))
    assert up > down + 0.05


def test_on_a_page_it_has_fewer_levels_than_anyone_can_see(poster: bytes) -> None:
    """Its opacity is off by no more than a sixteenth."""
    light = light_poster(poster)
    assert len(light) < 60_000
    before, after = pixels(poster)[..., 3], pixels(light)[..., 3]
    assert (np.abs(after - before) <= np.maximum(0.06 * before, 1.01 / 255)).all()
    assert len(np.unique(after)) < len(np.unique(before)) / 3


@pytest.mark.parametrize(("center", "radius"), [((0, 0, 0), 1), ((-0.2, 0.9, -0.3), 0.5)])
def test_what_stands_behind_it_is_pale(center: ArrayLike, radius: float) -> None:
    """Points and lines; but not before it, within it and beside it."""
    plotter = scene()
    add_sphere(plotter, center, radius)
    before, behind = (place(azimuth, 15) for azimuth in (15, 165))
    others = (0, -0.4, -0.4), (-1, 1.4, 0.3)
    for point in (before, behind, *others):
        add_point(plotter, center + radius * np.array(point), "#00ff00", radius=0.06 * radius)
    path = np.array([place(a, -15) for a in np.linspace(150, 170, 9)])
    add_line(plotter, center + radius * path, "#00ff00", radius=0.03 * radius)
    seen = pixels(take_poster(plotter))
    line, glass = (opacity(seen, center + radius * place(20, height)) for height in (30, 17))
    assert line > 0.3 > 0.15 + glass
    for point in (behind, place(160, -15)):
        r, g, b, alpha = seen[pixel(center + radius * point)]
        assert 0.35 < alpha < 0.7
        assert g > max(r, b) + 0.1
    for point in (before, *others):
        assert seen[pixel(center + radius * np.array(point))][3] > 0.99


def test_the_viewer_is_told_of_it() -> None:
    plotter = scene()
    apart = add_point(plotter, (1, 0, 0), "#00ff00")
    sphere = add_sphere(plotter, (1, 2, 3), 4)
    point = add_point(plotter, (1, 0, 0), "#00ff00")
    assert ball_looks(sphere) == {"ball": [1, 2, 3, 4]}
    assert ball_looks(point) == {"behind": [1, 2, 3, 4]}
    assert ball_looks(apart) == {}
