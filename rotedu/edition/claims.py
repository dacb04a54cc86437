"""What the paper claims, and whether it is so.

This is the one source of the tables of claims. The evidence is not kept here: Chapter 6 computes
it, and gives it to `claim_table`.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from rotedu.edition.notebook import Table

__all__ = ["CLAIMS", "Claim", "claim_table"]

Verdict = Literal[
    "holds",
    "holds in part",
    "does not hold",
    "does not follow",
    "not confirmed",
    "a matter of names",
]

CHAPTERS = {
    "01-introduction": "Chapter\N{NO-BREAK SPACE}1",
    "02-quaternions": "Chapter\N{NO-BREAK SPACE}2",
    "03-ordinary-rotation": "Chapter\N{NO-BREAK SPACE}3",
    "04-general-rotation": "Chapter\N{NO-BREAK SPACE}4",
    "05-arcs": "Chapter\N{NO-BREAK SPACE}5, arcs",
    "05-control-points": "Chapter\N{NO-BREAK SPACE}5, control points",
    "05-closed-curve": "Chapter\N{NO-BREAK SPACE}5, closed curve",
    "05-orientations": "Chapter\N{NO-BREAK SPACE}5, orientations",
    "06-conclusions": "Chapter\N{NO-BREAK SPACE}6",
}


@dataclass(frozen=True, slots=True)
class Claim:
    """A claim of the paper, or one that is often made beside it.

    Attributes
    ----------
    number : int
    claim : str
        In our words, in Markdown.
    where : tuple of str
        Where it is made: "abstract", sections of the paper, or "folklore", "not claimed".
    verdict : str
        What running it has shown.
    chapter : str
        The page of this book, without its ending, that shows it.
    """

    number: int
    claim: str
    where: tuple[str, ...]
    verdict: Verdict
    chapter: str

    @property
    def link(self) -> str:
        """Link, in Markdown, from another page to the one that shows it."""
        return f"[{CHAPTERS[self.chapter]}]({self.chapter}.ipynb)"


CLAIMS = (
    Claim(
        1,
        "The product of two 3 × 3 matrices takes 27 multiplications and 18 additions",
        ("1",),
        "holds",
        "01-introduction",
    ),
    Claim(
        2,
        "The product of two quaternions takes 19 multiplications and 7 additions",
        ("1",),
        "does not hold",
        "01-introduction",
    ),
    Claim(
        3,
        "Four of the nine entries of a rotation matrix are independent",
        ("1",),
        "does not hold",
        "01-introduction",
    ),
    Claim(
        4,
        "For one point the matrix costs 33 + 16, more than the quaternion of (2-6)",
        ("3",),
        "holds in part",
        "03-ordinary-rotation",
    ),
    Claim(
        5,
        "For many points the matrix is cheaper",
        ("1", "3", "6"),
        "holds",
        "03-ordinary-rotation",
    ),
    Claim(
        6,
        "So quaternions are the less efficient choice in graphics",
        ("1", "3", "6"),
        "does not follow",
        "03-ordinary-rotation",
    ),
    Claim(
        7,
        "A rotation matrix, translation, scaling, shearing, reflection and projection make one"
        " matrix, and each point is multiplied once",
        ("1", "3", "6"),
        "holds",
        "04-general-rotation",
    ),
    Claim(
        8,
        "Quaternions cannot have that advantage",
        ("6",),
        "holds in part",
        "04-general-rotation",
    ),
    Claim(
        9,
        "Axis and angle are found in a more general way than with quaternions",
        ("1", "4", "6"),
        "does not hold",
        "04-general-rotation",
    ),
    Claim(
        10,
        "The three principal rotations of (4-1) come to a single one",
        ("4",),
        "holds",
        "04-general-rotation",
    ),
    Claim(
        11,
        "(5-2) and (5-3) give any point of an arc",
        ("5",),
        "holds",
        "05-arcs",
    ),
    Claim(
        12,
        "Slerp has no form as a matrix times a vector",
        ("5",),
        "does not hold",
        "05-arcs",
    ),
    Claim(
        13,
        "A smooth curve through points of the sphere needs no quaternions",
        ("1", "5", "6"),
        "holds",
        "05-closed-curve",
    ),
    Claim(
        14,
        "So interpolating rotations needs none",
        ("abstract", "5", "6"),
        "does not follow",
        "05-orientations",
    ),
    Claim(
        15,
        "Everything that quaternions can do, ordinary rotation can do",
        ("abstract", "6"),
        "holds in part",
        "06-conclusions",
    ),
    Claim(
        16,
        "… and more efficiently",
        ("abstract", "6"),
        "holds in part",
        "06-conclusions",
    ),
    Claim(
        17,
        "Rounding harms products of quaternions less",
        ("folklore",),
        "holds in part",
        "06-conclusions",
    ),
    Claim(
        18,
        "The control points are those of Shoemake's second approach",
        ("5",),
        "not confirmed",
        "05-control-points",
    ),
    Claim(
        19,
        "Whether $a_i$ goes one half or one third of the way makes a visible difference",
        ("not claimed",),
        "holds",
        "05-closed-curve",
    ),
    Claim(
        20,
        "The closed curve is $C^1$",
        ("5",),
        "holds",
        "05-closed-curve",
    ),
    Claim(
        21,
        "It is $C^2$, or at least $G^2$, that is, its curvature is continuous",
        ("not claimed",),
        "does not hold",
        "05-closed-curve",
    ),
    Claim(
        22,
        "It stays on the sphere and passes through the given points",
        ("5",),
        "holds",
        "05-closed-curve",
    ),
    Claim(
        23,
        "(4-3) to (4-6) belong to ordinary rotation, not to quaternions",
        ("4",),
        "a matter of names",
        "04-general-rotation",
    ),
    Claim(
        24,
        "The construction is tied to points of $S^2$",
        ("not claimed",),
        "does not hold",
        "05-orientations",
    ),
    Claim(
        25,
        "A teaspoon of 100 vertices is enough for the matrix to pay",
        ("3",),
        "holds",
        "03-ordinary-rotation",
    ),
    Claim(
        26,
        "So there is no reason at all to use quaternions in these fields",
        ("1", "6"),
        "does not hold",
        "06-conclusions",
    ),
)


def claim_table(evidence: Mapping[int, str] | None = None) -> Table:
    """Make the table of claims, with links, for a page of the book.

    Parameters
    ----------
    evidence : mapping of int to str, optional
        What shows the verdict, in Markdown, by the number of the claim: then the table has a
        column for it, and only the claims that evidence is given for.

    Returns
    -------
    Table

    Examples
    --------
    >>> claim_table({3: "three"})
    | No. | The claim | In | Verdict | Evidence | Shown in |
    | --- | --- | --- | --- | --- | --- |
    | 3 | Four of the nine entries of a rotation matrix are independent | 1 | **does not hold** | three | [Chapter\N{NO-BREAK SPACE}1](01-introduction.ipynb) |
    """  # noqa: E501
    rows = [
        [
            str(claim.number),
            claim.claim,
            ", ".join(claim.where),
            f"**{claim.verdict}**",
            claim.link,
        ]
        for claim in CLAIMS
        if evidence is None or claim.number in evidence
    ]
    heads = ["No.", "The claim", "In", "Verdict", "Shown in"]
    if evidence is not None:
        heads.insert(4, "Evidence")
        for row in rows:
            row.insert(4, evidence[int(row[0])])
    return Table(heads, rows)
