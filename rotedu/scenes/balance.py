"""Scenes of Chapters 3 and 6: a balance that weighs what a computation costs, in teaspoons."""

import numpy as np
import pyvista
from numpy.typing import NDArray

from rotedu.colors import AXIS, MATRIX, NEUTRAL, QUATERNION
from rotedu.figures import State, describe, explorable, read_out
from rotedu.figures.inputs import Choice, Slider
from rotedu.quaternions import Quaternion
from rotedu.scenes.looks import UNTOUCHED, Heap, Lines, Look, Mesh, Text, draw
from rotedu.scenes.parts import add_label, add_lines, new_scene
from rotedu.scenes.shapes import U, V, W, lathe, teaspoon

__all__ = ["the_balance", "the_balance_of_works"]

WORKS: dict[str, dict[str, list[tuple[int, int]]]] = {
    "turn points by one turn": {"matrix": [(21, 15)], "quaternion": [(7, 24), (0, 30)]},
    "compose turns": {"matrix": [(0, 39)], "quaternion": [(0, 28)]},
    "orientations along one arc": {"matrix": [(73, 34)], "quaternion": [(11, 13)]},
    "the same, as matrices": {"matrix": [(73, 34)], "quaternion": [(11, 33)]},
    "repair turns": {"matrix": [(0, 28)], "quaternion": [(0, 7)]},
}
"""Of each work, by the leanest formulas of the ledger: what it takes once, and what each time.

Multiplications and additions together. Where there are two formulas, the cheaper one is taken.
"""
MOST = 300
"""Spoons that a pan holds."""
TWICE = float(np.log10(2))
DECADES = Slider(0, 4, "how many, as a power of ten", step=0.02, stride=TWICE, plays=9, start=0)
RULER = (-1.5, 1.5, -1.5)
"""Ends and height of the ruler."""
SIZE = (1.25, 1.05)
"""Half the length of the beam, and how far below it a pan hangs."""
CONSTANTS = {"works": WORKS, "most": MOST, "ruler": RULER, "size": SIZE}
PAN = [(0, 0), (0.42, 0), (0.52, 0.06), (0.54, 0.06), (0.44, -0.03), (0, -0.03)]
"""Its profile, from the middle of the dish to that of its bottom."""


def heap_of_spoons() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Pile spoons on a pan: where they lie, shape (n, 3), and quaternions, shape (n, 4)."""
    i = np.arange(MOST)
    layer, k = np.divmod(i, 20)
    out = (0.38 - 0.02 * layer) * np.sqrt((k + 0.5) / 20)
    angle = 2.39996 * i + 0.7 * layer
    up = 0.03 + 0.045 * layer
    heading, tilt, roll = 3.7 * angle, 0.1 * np.sin(5.1 * i), 0.4 * np.sin(2.3 * i)
    w, v, u = map(Quaternion.from_axis_angle, (W, V, U), (heading, tilt, roll))
    return np.column_stack([out * np.cos(angle), out * np.sin(angle), up]), (w * v * u).components


def balance(state: State, what: str) -> pyvista.Plotter:
    """Draw a balance with two heaps of spoons, and a ruler on which numbers are powers of ten.

    ``what`` says which number that is.
    """
    plotter = new_scene((0, -9, 1.6), (0, 0, 0.04), view_angle=22.5, size=(720, 440))
    spoon = teaspoon(stations=17, around=8)
    spoon.points *= 0.18
    places = heap_of_spoons()
    looks: dict[str, Look] = {
        "beam": Lines(NEUTRAL, 0.03),
        "pointer": Lines(AXIS, 0.02),
        "strings": Lines(NEUTRAL, 0.008),
        "pan *": Mesh(lathe(PAN), NEUTRAL, UNTOUCHED),
        "left": Heap(spoon, places, MATRIX),
        "right": Heap(spoon, places, QUATERNION),
        "level": Lines(AXIS, 0.02),
    }
    texts = {
        "left": Text(MATRIX, "matrix"),
        "right": Text(QUATERNION, "quaternion"),
        "level": Text(AXIS, "level"),
    }
    draw(plotter, state, looks, texts)
    post = [[0, 0, -1.2], [0, 0, 1.05]], [[-0.3, 0, -1.2], [0.3, 0, -1.2]]
    add_lines(plotter, post, NEUTRAL, radius=0.035)
    low, high, floor = RULER
    ruler = [[[low, 0, floor], [high, 0, floor]]]
    for decade, x in enumerate(np.linspace(low, high, 5)):
        ruler.append([[x, 0, floor], [x, 0, floor + 0.07]])
        add_label(plotter, [x, 0, floor - 0.17], f"{10**decade:,}", name=f"10^{decade}")
    add_lines(plotter, ruler, NEUTRAL, radius=0.008)

    read_out(plotter, "number", what, 0, where="picture")
    read_out(plotter, "matrix", "matrix", 0, where="picture", color=MATRIX)
    read_out(plotter, "quaternion", "quaternion", 0, where="picture", color=QUATERNION)
    read_out(plotter, "spoon", "operations a spoon", 0, where="picture")
    told = state["outputs"]
    heavier = "left" if told["matrix"] > told["quaternion"] else "right"
    describe(
        plotter,
        f"A balance. On the left pan a heap of teaspoons for the {told['matrix']:.0f} operations of"
        f" the matrix, on the right one for the {told['quaternion']:.0f} of the quaternion; the"
        f" {heavier} pan is lower. Below, a ruler from 1 to 10,000.",
    )
    return plotter


@explorable(
    tries={
        "two points": {"decades": TWICE},
        "ten points": {"decades": 1},
        "10,000 points": {"decades": 4},
    },
    answer={"decades": 1},
    constants=CONSTANTS,
    decades=DECADES,
)
def the_balance(state: State) -> pyvista.Plotter:
    """Weigh what it takes to turn points by a matrix, and by a quaternion.

    Parameters
    ----------
    decades : float
        How many points are turned, as a power of ten.
    """
    return balance(state, "points")


@explorable(
    tries={
        "many points": {"work": "turn points by one turn", "decades": 3},
        "turns in a row": {"work": "compose turns", "decades": 1},
        "one arc, 60 times": {"work": "orientations along one arc", "decades": 1.78},
        "worn turns": {"work": "repair turns", "decades": 2},
    },
    constants=CONSTANTS,
    work=Choice("The work", tuple(WORKS), start="turn points by one turn"),
    decades=DECADES,
)
def the_balance_of_works(state: State) -> pyvista.Plotter:
    """Weigh what works take by a matrix, and by a quaternion.

    Parameters
    ----------
    work : str
        One of `WORKS`.
    decades : float
        How often, as a power of ten.
    """
    return balance(state, "how often")
