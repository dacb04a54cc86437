"""The ledger: how a turn can be written down, where each way breaks, what it forgets and costs.

This is the one source of its rows. Three senses are kept apart. A notation *breaks* where a turn
has no name or several, or where the name jumps and the turn does not. It *forgets* what cannot be
read from it: how often something turned, by which way, its roll. It *costs* what `rotedu.cost`
counts in the formulas of `rotedu.edition.lean`, whose docstring says by which rule.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from rotedu.cost import OperationCount, count
from rotedu.edition import lean
from rotedu.edition.claims import CHAPTERS
from rotedu.edition.notebook import Table

__all__ = ["LEDGER", "TASKS", "Found", "Row", "cost_table", "ledger", "priced"]

PAGES = (
    *CHAPTERS,
    "beyond-motion",
    "beyond-averages",
    "beyond-rigid-motion",
    "beyond-five-numbers",
)

IN_PART = {"05-orientations", "05-orientation-curves", "beyond-motion", "beyond-rigid-motion"}
"""Pages that show the rows they add to, and link to the others."""

TASKS = {
    "compose": "compose two",
    "point": "turn one point",
    "prepare": "prepare for many points",
    "many": "… then turn each",
    "matrix": "build the matrix that turns points",
    "between": "go a part of the way between two",
    "sample": "take one of many samples of that arc",
    "sampled matrix": "… as a matrix",
    "repair": "repair one",
}
"""What people do with rotations; "many" follows "prepare", "sampled matrix" follows "sample"."""


@dataclass(frozen=True, slots=True)
class Found:
    """What a row says, and the page of the book, without its ending, that finds it out."""

    text: str
    page: str


@dataclass(frozen=True, slots=True)
class Row:
    """A way to write a turn, or a direction, down.

    Attributes
    ----------
    written_as : str
        Its name.
    size : tuple of int
        How many numbers it takes, and how many equations tie them to one another.
    opened : str
        The page, without its ending, that introduces it.
    breaks : Found
        Where a turn has no name in it, or several, or its name jumps; "nowhere" else.
    forgets : Found
        What cannot be read from the numbers.
    counted : str
        The page that says what it costs.
    formulas : mapping of str to tuple
        For each of `TASKS` that it can do, the leanest formula that we know and its arguments.
    """

    written_as: str
    size: tuple[int, int]
    opened: str
    breaks: Found
    forgets: Found
    counted: str
    formulas: Mapping[str, tuple[Any, ...]] = field(default_factory=dict)

    @property
    def numbers(self) -> str:
        """How many numbers, and how many equations tie them."""
        numbers, equations = self.size
        return f"{numbers}, tied by {equations}" if equations else f"{numbers}"

    def cost(self, task: str) -> OperationCount:
        """Count what a task takes, by running its formula."""
        formula, *arguments = self.formulas[task]
        return count(formula, *arguments)

    @property
    def price(self) -> str:
        """What it costs to compose two and to turn points, or to draw an arc."""
        words = {"compose": "two in one", "point": "a point", "many": "each of many"}
        if "compose" not in self.formulas:
            words = {"between": "a point of an arc"}
        return "; ".join(
            f"{text} {priced(self.cost(task))}"
            for task, text in words.items()
            if task in self.formulas
        )


def ledger(page: str) -> Table:
    """Show the ledger as far as a page of the book has come; what the page adds is bold.

    What later pages find out is an ellipsis. Pages `IN_PART` show only the rows that they add to.

    Parameters
    ----------
    page : str
        The page's file without its ending.

    Raises
    ------
    ValueError
        If there is no such page.

    Examples
    --------
    >>> print(str(ledger("01-introduction")).splitlines()[-1])
    | **quaternion** | 4, tied by 1 | … | … | … |
    """
    if page not in PAGES:
        raise ValueError(f"page must be one of {', '.join(PAGES)}; got {page!r}")

    met = PAGES[: PAGES.index(page) + 1]

    def known(text: str, since: str) -> str:
        return text if since in met else "…"

    def added(row: Row) -> bool:
        return page in (row.opened, row.counted, row.breaks.page, row.forgets.page)

    rows = [
        [
            f"**{row.written_as}**" if added(row) else row.written_as,
            row.numbers,
            known(row.breaks.text, row.breaks.page),
            known(row.forgets.text, row.forgets.page),
            known(row.price, row.counted),
        ]
        for row in LEDGER
        if row.opened in met and (added(row) or page not in IN_PART)
    ]
    return Table(
        ["Written as", "Numbers", "Where it breaks", "What it forgets", "What it costs"], rows
    )


def cost_table() -> Table:
    """Show what each task costs in the four notations that can do all of them.

    Returns
    -------
    Table
        Multiplications + additions, and whatever else there is; a dash where nothing is to be done.
    """
    names = ("matrix", "quaternion", "axis and angle", "rotation vector")
    rows = [row for name in names for row in LEDGER if row.written_as == name]
    costs = [
        [words, *(priced(row.cost(task)) if task in row.formulas else "–" for row in rows)]
        for task, words in TASKS.items()
    ]
    stored = ["keep it: numbers", *(row.numbers for row in rows)]
    return Table(["A turn: to …", *names], [stored, *costs])


def priced(cost: OperationCount) -> str:
    """Write a cost as multiplications + additions, and whatever else there is.

    Parameters
    ----------
    cost : OperationCount

    Returns
    -------
    str
        With spaces that do not break.

    Examples
    --------
    >>> priced(OperationCount(18, 12, 6, 2)).replace("\N{NO-BREAK SPACE}", " ")
    '18 + 12, 6 divisions, 2 roots'
    """
    words = [f"{cost.multiplications} + {cost.additions}"]
    for word, number in (
        ("division", cost.divisions),
        ("root", cost.square_roots),
        ("function", cost.trigonometric),
    ):
        if number:
            words.append(f"{number} {word}{'s' * (number > 1)}")
    return ", ".join(text.replace(" ", "\N{NO-BREAK SPACE}") for text in words)


# Two turns in each notation, a point and a place between them, to count with. The mathematics does
# not depend on them.
P, Q = np.array([4, 2, 1, 2]) / 5, np.array([8, 1, 4, 0]) / 9
POINT, PLACE = np.array([1, 2, 3]), 0.3
A, B = (lean.matrix_of_quaternion(q) for q in (P, Q))
V, W = (lean.vector_whole(q, lean.sine_of_unit(q)) for q in (P, Q))
TURN, NEXT_TURN = (lean.whole(q, lean.sine_of_unit(q)) for q in (P, Q))
ANGLES, NEXT_ANGLES = np.array([0.1, 0.2, 0.3]), np.array([0.4, 0.5, 0.6])
ARC = P, lean.unit(Q - np.dot(P, Q) * P), 0.6, PLACE
"""Two quaternions at right angles, the angle to go, and a place."""
ARC_OF_MATRICES = A, B, A, 0.6, PLACE

FIVE, NEXT_FIVE = (lean.five_of_columns(m[:, :2]) for m in (A, B))
DUAL, NEXT_DUAL = (np.stack([q, lean.compose_quaternions(np.array([0, *V]), q)]) for q in (P, Q))

ROUTE = "in which sense, and how many times"

LEDGER = (
    Row(
        "where the tip points",
        (2, 0),
        "01-introduction",
        Found("straight up and down, where every heading is the same", "01-introduction"),
        Found("the roll", "01-introduction"),
        "01-introduction",
    ),
    Row(
        "three angles",
        (3, 0),
        "01-introduction",
        Found(
            "where the middle one is ±90°, only two count; elsewhere two names, of which a rule"
            " keeps one, and the outer ones jump at ±180°",
            "04-general-rotation",
        ),
        Found(ROUTE, "05-orientation-curves"),
        "04-general-rotation",
        {
            "compose": (lean.compose_angles, ANGLES, NEXT_ANGLES),
            "matrix": (lean.matrix_of_angles, *ANGLES),
        },
    ),
    Row(
        "axis and angle",
        (4, 1),
        "01-introduction",
        Found(
            "at no turn, which has every axis; up to 180°, at half a turn, where the axis turns"
            " over; up to 360°, everywhere, by two names",
            "03-ordinary-rotation",
        ),
        Found(f"up to 180°, {ROUTE}; up to 360°, pairs of whole turns", "05-orientation-curves"),
        "03-ordinary-rotation",
        {
            "compose": (lean.compose_turns, TURN, NEXT_TURN),
            "point": (lean.turn_about_axis, TURN, POINT),
            "prepare": (lean.prepare_axis, TURN),
            "many": (lean.turn_prepared, *lean.prepare_axis(TURN), POINT),
            "matrix": (lean.matrix_of_turn, TURN),
            "between": (lean.turn_between, TURN, NEXT_TURN, PLACE),
            "sample": (lean.turn_on_arc, *ARC),
            "sampled matrix": (lean.matrix_on_arc_of_quaternions, *ARC),
            "repair": (lean.unit, TURN[:3]),
        },
    ),
    Row(
        "rotation vector",
        (3, 0),
        "06-conclusions",
        Found(
            "read from a matrix, at half a turn, where it jumps; kept, at whole turns, which all"
            " lead home",
            "beyond-motion",
        ),
        Found(f"read from a matrix, {ROUTE}; kept, nothing", "beyond-motion"),
        "06-conclusions",
        {
            "compose": (lean.compose_vectors, V, W),
            "point": (lean.turn_by_vector, V, POINT),
            "prepare": (lean.prepare_vector, V),
            "many": (lean.turn_prepared, *lean.prepare_vector(V), POINT),
            "matrix": (lean.matrix_of_vector, V),
            "between": (lean.vector_between, V, W, PLACE),
            "sample": (lean.vector_on_arc, *ARC),
            "sampled matrix": (lean.matrix_on_arc_of_quaternions, *ARC),
        },
    ),
    Row(
        "matrix",
        (9, 6),
        "01-introduction",
        Found("nowhere", "03-ordinary-rotation"),
        Found(ROUTE, "05-orientation-curves"),
        "03-ordinary-rotation",
        {
            "compose": (lean.compose_matrices, A, B),
            "point": (np.matmul, A, POINT),
            "many": (np.matmul, A, POINT),
            "between": (lean.matrix_between, A, B, PLACE),
            "sample": (lean.matrix_on_arc, *ARC_OF_MATRICES),
            "sampled matrix": (lean.matrix_on_arc, *ARC_OF_MATRICES),
            "repair": (lean.repair_columns, A),
        },
    ),
    Row(
        "quaternion",
        (4, 1),
        "01-introduction",
        Found(
            "two names everywhere, $q$ and $-q$: by a rule, they jump; followed, they never do",
            "02-quaternions",
        ),
        Found("pairs of whole turns", "02-quaternions"),
        "02-quaternions",
        {
            "compose": (lean.compose_quaternions, P, Q),
            "point": (lean.turn_by_quaternion, P, POINT),
            "prepare": (lean.prepare_quaternion, P),
            "many": (lean.turn_prepared, *lean.prepare_quaternion(P), POINT),
            "matrix": (lean.matrix_of_quaternion, P),
            "between": (lean.quaternion_between, P, Q, PLACE),
            "sample": (lean.quaternion_on_arc, *ARC),
            "sampled matrix": (lean.matrix_on_arc_of_quaternions, *ARC),
            "repair": (lean.unit, P),
        },
    ),
    Row(
        "direction",
        (3, 1),
        "05-arcs",
        Found("nowhere", "05-arcs"),
        Found("the roll", "05-orientations"),
        "05-arcs",
        {"between": (lean.quaternion_between, lean.unit(V), lean.unit(W), PLACE)},
    ),
    Row(
        "dual quaternion, of a turn and a step",
        (8, 2),
        "beyond-rigid-motion",
        Found("everywhere, by two names, as the quaternion", "beyond-rigid-motion"),
        Found("pairs of whole turns", "beyond-rigid-motion"),
        "beyond-rigid-motion",
        {
            "compose": (lean.compose_dual_quaternions, DUAL, NEXT_DUAL),
            "point": (lean.move_by_dual_quaternion, DUAL, POINT),
        },
    ),
    Row(
        "two columns",
        (6, 3),
        "beyond-five-numbers",
        Found("nowhere", "beyond-five-numbers"),
        Found(ROUTE, "beyond-five-numbers"),
        "beyond-five-numbers",
        {
            "compose": (lean.turn_by_two_columns, A[:, :2], B[:, :2]),
            "point": (lean.turn_by_two_columns, A[:, :2], POINT),
            "many": (np.matmul, A, POINT),
            "repair": (lean.repair_two_columns, A[:, :2]),
        },
    ),
    Row(
        "five numbers of a map",
        (5, 2),
        "beyond-five-numbers",
        Found("nowhere", "beyond-five-numbers"),
        Found(ROUTE, "beyond-five-numbers"),
        "beyond-five-numbers",
        {
            "compose": (lean.compose_five, FIVE, NEXT_FIVE),
            "point": (lean.turn_by_five, FIVE, POINT),
            "many": (np.matmul, A, POINT),
            "repair": (lean.repair_five, FIVE),
        },
    ),
)
"""The rows, in the order of their numbers and of the pages."""
