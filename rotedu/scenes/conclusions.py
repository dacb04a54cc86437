"""Scene of Chapter 6: what rounding does to a rotation."""

from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.colors import MATRIX, QUATERNION, VECTOR
from rotedu.figures import (
    Choice,
    Slider,
    Switch,
    describe,
    draw_chart,
    explorable,
    limit_turning,
    place_part,
    read_out,
)
from rotedu.ordinary_rotation import axis_angle
from rotedu.orientations import nearest_rotation
from rotedu.quaternions import Quaternion
from rotedu.scenes.parts import CUBE, ORIGIN, add_label, add_lines, add_thin, new_scene, teaspoon

MOST = 1000
INKS = {"matrix": MATRIX, "quaternion": QUATERNION}
ROUNDED: dict[str, Callable[[NDArray[np.float64]], NDArray[np.float64]]] = {
    "2 decimals": lambda x: np.round(x, 2),
    "3 decimals": lambda x: np.round(x, 3),
    "16 bits": lambda x: np.asarray(x, np.float16).astype(float),
    "32 bits": lambda x: np.asarray(x, np.float32).astype(float),
}
"""What is left of a number after every turn."""
SIZES = {"any size": 0.0, "about 2°": 0.02, "about 0.02°": 0.0002}
"""How large turns are: twice as much is the largest angle of small ones, in radians."""
# The chart shows every tenth number of turns, and nothing below 1e-8 degrees.
EVERY = 10
FLOOR = 1e-8
ACROSS = 0.88 * np.array([0.93, 0.36, 0])
# The spoon at the start is thinner by so much, and one in the same place covers it.
THINNER = 0.005
# What is off before repair.
IN_LENGTH = " % in length"


def dice(seed: int = 3) -> Iterator[float]:
    """Throw numbers from -1 to 1, which are the same in every language."""
    while True:
        seed = (1664525 * seed + 1013904223) % 2**32
        yield seed / 2**31 - 1


@cache
def random_turns(size: str) -> list[Quaternion]:
    """Return unit quaternions whose directions are evenly spread, of any size or near 1."""
    thrown = dice()
    turns: list[Quaternion] = []
    while len(turns) < MOST:
        w, *v = (next(thrown) for _ in range(4))
        if 0.01 < w * w + np.dot(v, v) <= 1:
            small = SIZES[size]
            q = Quaternion(1, small * np.array(v)) if small else Quaternion(w, v)
            turns.append(q / q.norm())
    return turns


@cache
def chains(precision: str, size: str) -> dict[str, NDArray[np.float64]]:
    """Multiply turns as matrices and as quaternions, and round every number after every turn.

    Parameters
    ----------
    precision : str
        One of `ROUNDED`.
    size : str
        One of `SIZES`.

    Returns
    -------
    dict
        After 0, 1, ... turns: ``matrix``, shape (1001, 3, 3), and ``quaternion``, shape (1001, 4).
        Each was then multiplied by one turn more, which leads back to the start.
    """
    rounded = ROUNDED[precision]
    exact = one = Quaternion(1, ORIGIN)
    matrix: NDArray[np.float64] = np.eye(3)
    kept: NDArray[np.float64] = one.components
    worn: dict[str, list[Any]] = {"matrix": [], "quaternion": []}
    for turn in [*random_turns(size), one]:
        back = exact.conjugate()
        worn["matrix"].append(rounded(back.matrix() @ matrix))
        worn["quaternion"].append(rounded((back * quaternion(kept)).components))
        exact = turn * exact
        matrix = rounded(turn.matrix() @ matrix)
        kept = rounded((turn * quaternion(kept)).components)
    return {name: np.array(values) for name, values in worn.items()}


def quaternion(components: NDArray[np.float64]) -> Quaternion:
    """Make quaternions of components, shape (..., 4)."""
    return Quaternion(components[..., 0], components[..., 1:])


def worn_rotations(
    turns: int = MOST, precision: str = "2 decimals", size: str = "any size"
) -> list[NDArray[np.float64]]:
    """Multiply random rotations that lead back to the start, and round every product.

    Parameters
    ----------
    turns : int
        Number of random rotations, up to 1000; one more undoes them all.
    precision : str
        What is left of every number after every turn: ``2 decimals``, ``3 decimals``, ``16 bits``
        or ``32 bits``.
    size : str
        Turns of ``any size``, of ``about 2°`` or of ``about 0.02°``.

    Returns
    -------
    list of ndarray, shape (3, 3)
        Two matrices that would be the identity without rounding: the product of the matrices,
        and the matrix that takes r to q [0, r] q*, where q is the product of the quaternions.
        Neither is repaired.

    Examples
    --------
    >>> for kept in worn_rotations(turns=10, precision="32 bits"):
    ...     print(np.abs(kept - np.eye(3)).max() < 1e-6)
    True
    True
    """
    worn = chains(precision, size)
    q = quaternion(worn["quaternion"][turns])
    return [worn["matrix"][turns], q.norm() ** 2 * q.matrix()]


def degrees_off(precision: str, size: str) -> dict[str, NDArray[np.float64]]:
    """Return by how much the nearest rotations are off, after 0 to 1000 turns."""
    worn = chains(precision, size)
    nearest = {
        "matrix": nearest_rotation(worn["matrix"]),
        "quaternion": quaternion(worn["quaternion"]).matrix(),
    }
    return {name: np.degrees(axis_angle(rotation)[1]) for name, rotation in nearest.items()}


def two_digits(value: float) -> str:
    """Write a number with two digits, however small it is."""
    digits = max(0, 1 - int(np.floor(np.log10(value)))) if value > FLOOR else 0
    return f"{value:.{digits}f}"


@explorable(
    model="wornSpoons",
    constants={"degree": "°", "in_length": IN_LENGTH},
    tries={
        "repair both": {"repair": True},
        "after 100 turns": {"repair": True, "turns": 100},
        "32 bits": {"repair": True, "precision": "32 bits"},
        "tiny turns, 16 bits": {"repair": True, "precision": "16 bits", "size": "about 0.02°"},
    },
    turns=Slider(0, MOST, "turns", step=1, stride=100, plays=10),
    precision=Choice("rounded to", tuple(ROUNDED)),
    size=Choice("turns of", tuple(SIZES)),
    repair=Switch("repair both: take the nearest rotation"),
)
def worn_spoons_by_hand(
    turns: float = MOST,
    precision: str = "2 decimals",
    size: str = "any size",
    repair: bool = False,
) -> pyvista.Plotter:
    """Draw what rounding does to a product of matrices and to a product of quaternions.

    Parameters
    ----------
    turns : float
        Number of random rotations, from 0 to 1000; one more leads back to the start.
    precision : str
        What is left of every number after every turn.
    size : str
        Turns of ``any size``, of ``about 2°`` or of ``about 0.02°``.
    repair : bool
        Whether both products are replaced by the nearest rotation at the end.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    spoon = teaspoon(stations=61, around=20)
    spoon.points = spoon.points / 2
    thin = spoon.copy()
    thin.points = spoon.points + THINNER * spoon.point_normals
    off = degrees_off(precision, size)
    kept = worn_rotations(round(turns), precision, size)
    if repair:
        kept = [nearest_rotation(rotation) for rotation in kept]

    plotter = new_scene(
        (2.93, -7.43, 3.64), (-0.03, -0.03, -0.06), view_angle=11.6, size=(720, 366)
    )
    limit_turning(plotter, 20)
    for side, rotation, (name, color) in zip((-1, 1), kept, INKS.items(), strict=True):
        place = side * ACROSS
        for mesh, which, ink, radius, title in (
            (thin, np.eye(3), VECTOR, 0.005, f"{name} at the start"),
            (spoon, rotation, color, 0.009, name),
        ):
            box = list(place + CUBE @ which.T)
            add_lines(plotter, box, ink, radius, f"box, {title}")
            pose = np.eye(4)
            pose[:3, :3], pose[:3, 3] = which, place
            part = place_part(plotter, title, matrix=pose.T.ravel())
            add_thin(plotter, mesh, ink, part).user_matrix = pose
        add_label(plotter, place - np.array([0, 0, 0.95]), name, color)
        lengths = np.linalg.norm(rotation, axis=0)
        bent = two_digits(100 * np.abs(lengths - 1).max())
        now = f"{two_digits(off[name][round(turns)])}°" if repair else f"{bent}{IN_LENGTH}"
        read_out(plotter, f"{name}_off", now, f"{name} off by", where="picture")
        read_out(plotter, f"{name}_edges", lengths, f"edges of the cube, {name}", 3)
    draw_chart(
        plotter,
        "off",
        {
            name: np.log10(np.maximum(angle[::EVERY], FLOOR)) if repair else None
            for name, angle in off.items()
        },
        over="turns",
        x=(0, MOST),
        y=(-8, 2),
        label="degrees off once repaired",
        colors=INKS,
        ticks={-8: "10⁻⁸", -6: "10⁻⁶", -4: "10⁻⁴", -2: "0.01", 0: "1", 2: "100"},
    )
    describe(
        plotter,
        "Two teaspoons, each in a wire box and each drawn twice: blue at the start, and in a second"
        f" colour after {turns:.0f} turns that should lead back to the start. On the left, matrices"
        " were multiplied: the ochre box is askew, and its spoon is bent. On the right, quaternions"
        " were multiplied: the violet box is still a cube, but of another size, and turned further"
        " from the blue one.",
    )
    return plotter
