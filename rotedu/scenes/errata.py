"""Scene of the errata: a right curve and a wrong one."""

import numpy as np
import pyvista
from numpy.typing import ArrayLike

from rotedu.colors import RESULT, VECTOR, WRONG
from rotedu.figures import describe
from rotedu.scenes.parts import add_label, add_line, add_point, sphere_scene
from rotedu.scenes.shapes import normalised

__all__ = ["two_curves"]


def two_curves(
    points: ArrayLike, right: ArrayLike, wrong: ArrayLike, difference: str
) -> pyvista.Plotter:
    """Draw the right curve through points of the sphere, and a wrong one for comparison.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Points of the unit sphere that both curves pass through.
    right, wrong : array_like, shape (m, 3)
        Points along each closed curve.
    difference : str
        Sentence for the alternative text that says how the wrong curve differs.
    """
    p = np.asarray(points, float)
    centre = p.mean(axis=0)
    plotter = sphere_scene(eye=5.2 * normalised(centre))
    for curve, color, radius in ((right, RESULT, 0.014), (wrong, WRONG, 0.012)):
        closed = np.vstack([curve, np.asarray(curve)[:1]])
        add_line(plotter, closed, color, radius)
    for i, point in enumerate(p):
        add_point(plotter, point, VECTOR, 0.036)
        away = point - centre
        add_label(plotter, 1.02 * point + 0.14 * normalised(away), f"$P_{i}$", VECTOR)
    describe(
        plotter,
        f"A see-through sphere with {len(p)} blue points and two closed curves through all of"
        f" them. The green one is smooth and even. {difference}",
    )
    return plotter
