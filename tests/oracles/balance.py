"""The outputs of the balance, by the ledger."""

from typing import Any

import numpy as np

from rotedu.edition.ledger import LEDGER

ROWS = {row.written_as: row for row in LEDGER}


def weight(notation: str, task: str) -> int:
    """Multiplications and additions of a task."""
    cost = ROWS[notation].cost(task)
    return cost.multiplications + cost.additions


def costs(notation: str, work: str, n: int) -> int:
    """The cheapest of the ways to do a work so often."""
    if work == "turn points by one turn":
        if notation == "matrix":
            return weight("axis and angle", "matrix") + n * weight("matrix", "many")
        prepared = weight("quaternion", "prepare") + n * weight("quaternion", "many")
        return min(prepared, n * weight("quaternion", "point"))
    if work in ("compose turns", "repair turns"):
        return n * weight(notation, work.split()[0].removesuffix("s"))
    sample = "sampled matrix" if work.endswith("matrices") else "sample"
    # The first point of an arc holds what the others need as well.
    once = weight(notation, "between") - weight(notation, "sample")
    return once + n * weight(notation, sample)


def the_balance_of_works(work: str, decades: float) -> dict[str, Any]:
    number = int(np.rint(10**decades))
    matrix, quaternion = (costs(name, work, number) for name in ("matrix", "quaternion"))
    spoon = next(
        size for size in (1, 10, 100, 1000, 10_000) if max(matrix, quaternion) <= 300 * size
    )
    return {"number": number, "matrix": matrix, "quaternion": quaternion, "spoon": spoon}


def the_balance(decades: float) -> dict[str, Any]:
    return the_balance_of_works("turn points by one turn", decades)
