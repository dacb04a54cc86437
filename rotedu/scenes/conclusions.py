"""Scene of Chapter 6: what rounding does to a rotation."""

from collections.abc import Callable, Iterator
from functools import cache, reduce
from typing import Any

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.colors import MATRIX, NEUTRAL, QUATERNION, VECTOR
from rotedu.figures import State, describe, draw_chart, explorable, read_out
from rotedu.figures.inputs import Choice, Slider, Switch
from rotedu.quaternions import Quaternion
from rotedu.scenes.looks import Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import new_scene
from rotedu.scenes.shapes import ORIGIN, W, merged, teaspoon

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
MAGNIFIERS = {"2 decimals": 1, "3 decimals": 10, "16 bits": 10, "32 bits": 100_000}
"""How many times as large the magnifier shows what rounding does, so that it is seen."""
CRANK: dict[str, Any] = {"place": [0, 0, -0.7], "radius": 0.28, "laps": 10}
"""The wheel that turns both spoons: a hundred turns a lap, clockwise."""
# The spoon at the start is thinner by so much, and one in the same place covers it.
THINNER = 0.005


def dice(seed: int = 3) -> Iterator[float]:
    """Throw numbers from -1 to 1, which are the same in every language."""
    while True:
        seed = (1664525 * seed + 1013904223) % 2**32
        yield seed / 2**31 - 1


@cache
def random_turns() -> list[Quaternion]:
    """Return unit quaternions whose directions are evenly spread."""
    thrown = dice()
    turns: list[Quaternion] = []
    while len(turns) < MOST:
        w, *v = (next(thrown) for _ in range(4))
        if 0.01 < w * w + np.dot(v, v) <= 1:
            q = Quaternion(w, v)
            turns.append(q / q.norm())
    return turns


def worn_rotations(turns: int = MOST, precision: str = "2 decimals") -> list[NDArray[np.float64]]:
    """Multiply random rotations that lead back to the start, and round every product.

    Parameters
    ----------
    turns : int
        Number of random rotations, up to 1000; one more undoes them all.
    precision : str
        What is left of every number after every turn: ``2 decimals``, ``3 decimals``, ``16 bits``
        or ``32 bits``.

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
    gone = random_turns()[:turns]
    matrix, q = np.eye(3), Quaternion(1, ORIGIN)
    back = reduce(lambda product, turn: turn * product, gone, q).conjugate()
    for turn in [*gone, back]:
        matrix = rounded(turn.matrix() @ matrix)
        w, *v = rounded((turn * q).components)
        q = Quaternion(w, v)
    return [matrix, q.norm() ** 2 * q.matrix()]


def crank() -> pyvista.PolyData:
    """Model the crank about the origin: a rim, a spoke and a knob at the top."""
    angles = np.linspace(0, 2 * np.pi, 49)
    across = np.array([0.93, 0.36, 0])
    radius = CRANK["radius"]
    rim = radius * (np.outer(np.sin(angles), across) + np.outer(np.cos(angles), W))
    thin = pyvista.lines_from_points(rim).tube(radius=0.022, n_sides=12)
    spoke = pyvista.Line(ORIGIN, radius * W).tube(radius=0.03, n_sides=12)
    knob = pyvista.Sphere(radius=0.065, center=radius * W, theta_resolution=20, phi_resolution=20)
    return merged(thin, spoke, knob)


@explorable(
    answer={"turns": MOST},
    tries={
        "a thousand turns": {"turns": MOST},
        "then repair both": {"turns": MOST, "repair": True},
        "with 32 bits": {"turns": MOST, "precision": "32 bits"},
        "… under the magnifier": {"turns": MOST, "precision": "32 bits", "magnified": True},
    },
    constants={
        "most": MOST,
        "crank": CRANK,
        "magnifiers": MAGNIFIERS,
        "degree": "°",
        "in_length": " % in length",
    },
    turns=Slider(0, MOST, "turns", step=1, stride=100, plays=10, start=0),
    precision=Choice("rounded to", tuple(ROUNDED), start="2 decimals"),
    repair=Switch("repair both: take the nearest rotation", start=False),
    magnified=Switch("under a magnifier", start=False),
)
def worn_spoons_by_hand(state: State) -> pyvista.Plotter:
    """Draw what rounding does to a product of matrices and to a product of quaternions.

    Parameters
    ----------
    turns : float
        Number of random rotations, from 0 to 1000; one more leads back to the start.
    precision : str
        What is left of every number after every turn.
    repair : bool
        Whether both products are replaced by the nearest rotation at the end.
    magnified : bool
        Whether what rounding does is drawn larger, the more digits are left.
    """
    spoon = teaspoon(stations=61, around=20)
    spoon.points = spoon.points / 2
    thin = spoon.copy()
    thin.points = spoon.points + THINNER * spoon.point_normals
    eye, target = (2.93, -7.43, 3.64), (-0.03, -0.03, -0.13)
    plotter = new_scene(eye, target, view_angle=13.7, size=(720, 400), swing=20)
    draw(plotter, state, {"crank": Mesh(crank(), NEUTRAL)})
    for name, ink in INKS.items():
        looks: dict[str, Look] = {
            f"box, {name} at the start": Lines(VECTOR, 0.004),
            f"{name} at the start": Mesh(thin, VECTOR),
            f"box, {name}": Lines(ink, 0.012),
            name: Mesh(spoon, ink),
        }
        draw(plotter, state, looks, {name: Text(ink, "{}")})
        read_out(plotter, f"{name}_off", f"{name} off by", where="picture")
        read_out(plotter, f"{name}_edges", f"edges of the cube, {name}", 3)
    read_out(plotter, "times", "drawn larger, times", 0)
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
        " the left, matrices are multiplied: the ochre box goes askew, and its spoon bends. On the"
        " right, quaternions are multiplied: the violet box stays a cube, but of another size, and"
        " is turned further from the blue one. A crank between them turns both.",
    )
    return plotter
