"""Scene of Chapter 6: what rounding does to a rotation."""

from collections.abc import Callable, Iterator
from functools import cache, reduce

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.colors import MATRIX, QUATERNION, VECTOR
from rotedu.figures import State, describe, draw_chart, explorable, read_out
from rotedu.figures.inputs import Choice, Slider, Switch
from rotedu.quaternions import Quaternion
from rotedu.scenes.looks import Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import new_scene
from rotedu.scenes.shapes import ORIGIN, teaspoon

__all__ = ["worn_rotations", "worn_spoons_by_hand"]

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
# The spoon at the start is thinner by so much, and one in the same place covers it.
THINNER = 0.005


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
    rounded = ROUNDED[precision]
    gone = random_turns(size)[:turns]
    matrix, q = np.eye(3), Quaternion(1, ORIGIN)
    back = reduce(lambda product, turn: turn * product, gone, q).conjugate()
    for turn in [*gone, back]:
        matrix = rounded(turn.matrix() @ matrix)
        w, *v = rounded((turn * q).components)
        q = Quaternion(w, v)
    return [matrix, q.norm() ** 2 * q.matrix()]


@explorable(
    tries={
        "repair both": {"repair": True},
        "after 100 turns": {"repair": True, "turns": 100},
        "32 bits": {"repair": True, "precision": "32 bits"},
        "tiny turns, 16 bits": {"repair": True, "precision": "16 bits", "size": "about 0.02°"},
    },
    constants={"most": MOST, "sizes": SIZES, "degree": "°", "in_length": " % in length"},
    turns=Slider(0, MOST, "turns", step=1, stride=100, plays=10, start=MOST),
    precision=Choice("rounded to", tuple(ROUNDED), start="2 decimals"),
    size=Choice("turns of", tuple(SIZES), start="any size"),
    repair=Switch("repair both: take the nearest rotation", start=False),
)
def worn_spoons_by_hand(state: State) -> pyvista.Plotter:
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
    """
    spoon = teaspoon(stations=61, around=20)
    spoon.points = spoon.points / 2
    thin = spoon.copy()
    thin.points = spoon.points + THINNER * spoon.point_normals
    eye, target = (2.93, -7.43, 3.64), (-0.03, -0.03, -0.06)
    plotter = new_scene(eye, target, view_angle=11.6, size=(720, 366), swing=20)
    for name, ink in INKS.items():
        looks: dict[str, Look] = {
            f"box, {name} at the start": Lines(VECTOR, 0.005),
            f"{name} at the start": Mesh(thin, VECTOR),
            f"box, {name}": Lines(ink, 0.009),
            name: Mesh(spoon, ink),
        }
        draw(plotter, state, looks, {name: Text(ink, "{}")})
        read_out(plotter, f"{name}_off", f"{name} off by", where="picture")
        read_out(plotter, f"{name}_edges", f"edges of the cube, {name}", 3)
    draw_chart(
        plotter,
        "off",
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
        f" colour after {state['inputs']['turns']:.0f} turns that should lead back to the start. On"
        " the left, matrices were multiplied: the ochre box is askew, and its spoon is bent. On the"
        " right, quaternions were multiplied: the violet box is still a cube, but of another size,"
        " and turned further from the blue one.",
    )
    return plotter
