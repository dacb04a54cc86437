"""The errors of the paper: the one source of their table."""

from dataclasses import dataclass
from typing import Literal

from rotedu.edition.notebook import Table, linked

__all__ = ["ERRATA", "Erratum", "errata_table"]

Kind = Literal["result", "fact", "wording", "open"]


@dataclass(frozen=True, slots=True)
class Erratum:
    """An error of the paper.

    Attributes
    ----------
    number : str
        As in ``E4b``.
    title : str
        The heading of its section on the errata page.
    place : str
        Where in the paper it is.
    printed, correct : str
        What is printed there, and what it should be, in Markdown.
    kind : str
        What is wrong: a "result" that is computed, a "fact" that is stated, or only the "wording".
        An "open" one may be none: the text has another reading, or our copy lacks a part.
    """

    number: str
    title: str
    place: str
    printed: str
    correct: str
    kind: Kind

    @property
    def label(self) -> str:
        """What the errata page calls it."""
        return f"erratum-{self.number.lower()}"


# By number and kind: title, place, what is printed and what is correct.
BY_NUMBER: dict[tuple[str, Kind], tuple[str, str, str, str]] = {
    ("E1", "wording"): (
        "Quaternions are not a sphere, and their unit sphere is not S²",
        "Section 2.1",
        "all quaternions are $S^3$, the unit ones $S^2$",
        "all are $\\mathbb R^4$, the unit ones $S^3$",
    ),
    ("E2", "result"): (
        "The axis (5-9) turns the wrong way",
        "(5-9)",
        "$P_{i+1}\\times\\bar P_{i-1}$",
        "$\\bar P_{i-1}\\times P_{i+1}$",
    ),
    ("E3", "result"): (
        "(5-13) goes back instead of on",
        "(5-13)",
        "$2\\cos\\tilde\\theta_i\\,a_i-P_i$",
        "$2\\cos\\tilde\\theta_i\\,P_i-a_i$",
    ),
    ("E4", "result"): (
        "The pseudocode reads what it has not written yet",
        "Section 5, pseudocode",
        "`Q[j][k-1]`, `Q[j][k]`",
        "`Q[j-1][k-1]`, `Q[j-1][k]`",
    ),
    ("E4b", "fact"): (
        "The sine is not negative",
        "Section 5, pseudocode",
        "the comment: $\\sin\\theta<0$ if $\\cos\\theta<0$",
        "no comment: $\\sin\\theta\\ge0$",
    ),
    ("E4c", "wording"): (
        "The angle is used and never computed",
        "Section 5, pseudocode",
        "$\\cos\\theta$ and $\\sin\\theta$, no $\\theta$",
        "$\\theta$ from an arctangent",
    ),
    ("E5", "fact"): (
        "Two quaternions are composed with 16 multiplications and 12 additions, not 19 and 7",
        "Sections 1 and 3",
        "19 + 7 to compose, and to turn a point",
        "16 + 12 to compose, 18 + 12 to turn about any axis",
    ),
    ("E6", "fact"): (
        "Three entries of a rotation matrix are independent, not four",
        "Section 1",
        "four of nine",
        "three of nine",
    ),
    ("E7", "wording"): (
        "Slerp has a matrix, though not about an axis in space",
        "after (5-3)",
        "slerp cannot be a matrix times a vector, like (5-3)",
        "true of a turn about an axis in space; it has a 4 × 4 rotation matrix",
    ),
    ("E8", "wording"): (
        "An axis is a direction, not a point",
        "after (4-7)",
        "$(a_u,a_v,a_w,1)$",
        "$(a_u,a_v,a_w,0)$",
    ),
    ("E9", "wording"): (
        "The 4 × 4 matrix is that of (4-7), not (3-3)",
        "at (5-3), (5-5), (5-8), (5-11), (5-14)",
        "the 4 × 4 matrix of (3-3)",
        "the 4 × 4 matrix of (4-7)",
    ),
    ("E10", "open"): (
        "The review of interpolation is missing, at least in our copy",
        "Section 1, last paragraph",
        "Section 2 reviews interpolation",
        "in our copy it ends with (2-6)",
    ),
    ("E11", "wording"): (
        "Twice the angle is not always the angle between",
        "before (5-4)",
        "$P_{i-1}$, $\\bar P_{i-1}$ are $2\\theta_{i-1}$ apart",
        "along the arc, or if $\\theta_{i-1}\\le90^\\circ$",
    ),
    ("E12", "open"): (
        "Modulo n, the last point must be the first",
        "Section 5",
        "$P_0,\\dots,P_n$, indices modulo $n$",
        "the same, with $P_n=P_0$",
    ),
}

ERRATA = tuple(Erratum(number, *told, kind) for (number, kind), told in BY_NUMBER.items())


def errata_table() -> Table:
    """Make the table of the errata, with links, for a page of the book."""
    return Table(
        ("Number", "Where", "As printed", "What it should be", "What is wrong"),
        [
            (
                f"[{row.number}](#{row.label})",
                linked(row.place),
                linked(row.printed),
                linked(row.correct),
                row.kind,
            )
            for row in ERRATA
        ],
    )
