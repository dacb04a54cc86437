"""Scene of Chapter 6: what rounding does to a rotation."""

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.colors import RESULT, VECTOR
from rotedu.figures import describe
from rotedu.ordinary_rotation import transform
from rotedu.quaternions import Quaternion
from rotedu.scenes.parts import ORIGIN, add_label, add_line, new_scene, teaspoon


def worn_rotations(
    turns: int = 1000, decimals: int = 2, seed: int = 3
) -> list[NDArray[np.float64]]:
    """Multiply random rotations that lead back to the start, and round every product.

    Parameters
    ----------
    turns : int
        Number of random rotations; one more undoes them all.
    decimals : int
        Number of decimals to which every number is rounded after every turn.
    seed : int
        Seed of the random rotations.

    Returns
    -------
    list of ndarray, shape (3, 3)
        Two matrices that would be the identity without rounding: the product of the matrices,
        and the matrix that takes r to q [0, r] q*, where q is the product of the quaternions.
        Neither is repaired.

    Examples
    --------
    >>> for kept in worn_rotations(turns=10, decimals=12):
    ...     print(np.abs(kept - np.eye(3)).max() < 1e-10)
    True
    True
    """
    factors = np.random.default_rng(seed).normal(size=(turns, 4))
    factors /= np.linalg.norm(factors, axis=1, keepdims=True)
    exact, rounded, matrix = Quaternion(1, ORIGIN), Quaternion(1, ORIGIN), np.eye(3)
    for w, *v in factors:
        exact = Quaternion(w, v) * exact
    last = exact.conjugate().components
    for w, *v in (*factors, last):
        step = Quaternion(w, v)
        matrix = np.round(step.matrix() @ matrix, decimals)
        w, *v = np.round((step * rounded).components, decimals)
        rounded = Quaternion(w, v)
    return [matrix, rounded.norm() ** 2 * rounded.matrix()]


def worn_spoons(turns: int = 1000) -> pyvista.Plotter:
    """Draw what coarse rounding does to a product of matrices and a product of quaternions.

    Parameters
    ----------
    turns : int
        Number of random rotations; one more leads back to the start.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    corners = np.array(list(np.ndindex(2, 2, 2))) - 0.5
    edges = [(p, q) for p in corners for q in corners if (q - p).sum() == (q != p).sum() == 1]
    spoon = teaspoon(stations=81, around=28)
    spoon.points = spoon.points / 2

    plotter = new_scene(eye=(3.0, -7.4, 3.6), target=(0.04, 0, -0.1), view_angle=15.2)
    across = np.array([0.93, 0.36, 0]) * 0.88
    for side, matrix, name in zip(
        (-1, 1), worn_rotations(turns), ("matrices", "quaternions"), strict=True
    ):
        place = side * across
        for which, color, radius in ((np.eye(3), VECTOR, 0.005), (matrix, RESULT, 0.009)):
            for p, q in edges:
                add_line(plotter, [place + which @ p, place + which @ q], color, radius)
            turned = spoon.copy()
            turned.points = transform(which, spoon.points) + place
            plotter.add_mesh(turned, color=color, smooth_shading=True, pickable=False)
        add_label(plotter, place - np.array([0, 0, 1]), name)
    describe(
        plotter,
        "Two teaspoons, each in a wire box and each drawn twice: blue at the start, and green after"
        f" {turns} turns that should lead back to the start. On the left, matrices were multiplied:"
        " the green box is askew, and its spoon is bent. On the right, quaternions were multiplied:"
        " the green box is still a cube, but it is larger, and turned further from the blue one.",
    )
    return plotter
