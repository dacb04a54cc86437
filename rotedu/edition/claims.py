"""What the paper claims, and whether it is true.

This is the one source of the tables of claims. The evidence is not kept here: the page that a claim
links to runs it.
"""

from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Any

from rotedu.edition.notebook import Table, linked

__all__ = ["CLAIMS", "VERDICTS", "Claim", "claim_table", "verdict_table", "verdicts_on"]

VERDICTS = {
    "holds": "true; cases that numbers taken at random never meet do not count, such as 0/0 between"
    " equal points, but may be named beside it",
    "holds under a condition": "true in one use, range or reading of the words, which is named"
    " beside it, and false in another",
    "does not hold": "false in every use, range and reading that we know, such rare cases apart",
    "does not follow": "no consequence of the reason given, though perhaps of another",
    "not confirmed": "nothing that we could read or run decides it",
    "a matter of names": "the formulas are right, under either of two names in use",
}

SIGNS = {"holds": "\N{CHECK MARK}", "holds under a condition": "~"}
SIGNS |= {"does not hold": "\N{MULTIPLICATION SIGN}"}
"""What is seen of a verdict before it is read; ``?`` stands before the others."""

OTHERS = {"folklore", "not claimed"}
"""What is often said outside the paper, and what a reader may suspect."""

CHAPTERS = {
    "01-introduction": "Chapter\N{NO-BREAK SPACE}1",
    "02-quaternions": "Chapter\N{NO-BREAK SPACE}2",
    "03-ordinary-rotation": "Chapter\N{NO-BREAK SPACE}3",
    "04-general-rotation": "Chapter\N{NO-BREAK SPACE}4",
    "05-arcs": "Page\N{NO-BREAK SPACE}5\N{NO-BREAK SPACE}I",
    "05-control-points": "Page\N{NO-BREAK SPACE}5\N{NO-BREAK SPACE}II",
    "05-closed-curve": "Page\N{NO-BREAK SPACE}5\N{NO-BREAK SPACE}III",
    "05-orientations": "Page\N{NO-BREAK SPACE}5\N{NO-BREAK SPACE}IV",
    "05-orientation-curves": "Page\N{NO-BREAK SPACE}5\N{NO-BREAK SPACE}V",
    "06-conclusions": "Chapter\N{NO-BREAK SPACE}6",
}


def signed(verdict: str) -> str:
    """Return a verdict with its sign, in Markdown."""
    return f"{SIGNS.get(verdict, '?')} **{verdict}**"


@dataclass(frozen=True, slots=True)
class Claim:
    """A claim of the paper, or one that is often made outside it.

    Attributes
    ----------
    number : int
        It stays the same for good; a new claim gets a new one.
    claim : str
        In our words, in Markdown.
    where : tuple of str
        Where it is made: "title", "abstract", sections of the paper, or "folklore", "not claimed".
    verdict : str
        What running it has shown; `VERDICTS` says what the words mean. A misprint is judged in a
        row of its own, and the other rows are read with it mended.
    chapter : str
        The page of this book, without its ending, that shows it.
    condition : str
        For a claim that holds under a condition: which, without its *if*.
    reason : str
        Why, in a few words of Markdown, for the list of all claims.
    slip : bool
        Whether what is false in it is a slip, which the errata mend and on which no thesis rests.
    """

    number: int
    claim: str
    where: tuple[str, ...]
    verdict: str
    chapter: str
    condition: str = ""
    reason: str = ""
    slip: bool = False

    @property
    def link(self) -> str:
        """Link, in Markdown, from another page to the one that shows it."""
        return f"[{CHAPTERS[self.chapter]}]({self.chapter}.ipynb)"

    @property
    def of_paper(self) -> bool:
        """Whether the paper claims or reports it."""
        return not OTHERS & set(self.where)

    @property
    def judgement(self) -> str:
        """The verdict, in Markdown, with its condition and its reason, if there are any."""
        condition = self.condition and f"if {self.condition}"
        why = "; ".join(text for text in (condition, self.reason) if text)
        return signed(self.verdict) + ", a slip" * self.slip + (f": {why}" if why else "")


def judged(verdict: str, **more: Any) -> Callable[..., partial[Claim]]:
    """Return a function that makes a claim but for its number, its places and its page."""
    return lambda claim, reason="": partial(
        Claim, claim=claim, verdict=verdict, reason=reason, **more
    )


def holds_if(claim: str, condition: str, reason: str = "") -> partial[Claim]:
    """Make one that holds under a condition."""
    return judged("holds under a condition", condition=condition)(claim, reason)


holds = judged("holds")
does_not_hold = judged("does not hold")
slip = judged("does not hold", slip=True)
does_not_follow = judged("does not follow")
not_confirmed = judged("not confirmed")
a_matter_of_names = judged("a matter of names")

# By page, then by number and places.
ON_PAGE = {
    "01-introduction": {
        (1, "1"): holds(
            "The product of two 3 × 3 matrices takes 27 multiplications and 18 additions",
            "24 + 15 are enough for rotations",
        ),
        (2, "1"): slip(
            "The product of two quaternions takes 19 multiplications and 7 additions",
            "it takes 16 + 12 when counted, E5",
        ),
        (3, "1"): slip(
            "Four of the nine entries of a rotation matrix are independent", "three are, E6"
        ),
        (34, "1"): not_confirmed(
            "Section 2 also reviews the interpolation of quaternions",
            "in our copy it ends with (2-6), E10",
        ),
    },
    "02-quaternions": {
        (29, "abstract, 1"): holds_if(
            "The geometric meaning of quaternions is more obvious (reported as a belief)",
            "the question is about axis and angle; where a point goes, a matrix shows better",
        ),
        (30, "abstract, 1"): holds(
            "Axis and angle are easily recovered from a quaternion",
            "by an arctangent; at 1 and −1 any axis will do",
        ),
        (35, "2"): slip(
            "The quaternions are called $S^3$, the unit quaternions $S^2$",
            "they have four and three dimensions, E1",
        ),
        (36, "2"): holds(
            "Numbers and vectors are among the quaternions, as $[w,\\vec 0\\,]$ and $[0,\\vec"
            " v\\,]$"
        ),
        (37, "2"): holds("Products are associative and do not commute; norms multiply"),
        (38, "2"): holds(
            "Each unit quaternion is $[\\cos\\theta,\\sin\\theta\\,\\hat n]$ with"
            " $0\\le\\theta\\le\\pi$",
            "at 1 and −1 any unit vector will do",
        ),
        (39, "2"): holds(
            "$qq^*=q^*q=\\lvert q\\rvert^2$, so (2-4) is the inverse from both sides; for a unit"
            " quaternion it is the conjugate",
            "0 has no inverse",
        ),
        (40, "2"): holds(
            "Division is an inverse operation of multiplication: $(q_1q_2)/q_2=q_1$",
            "dividing takes away the factor on the right, not the one on the left",
        ),
        (41, "2"): holds("$q\\,[0,\\vec r\\,]\\,q^*$ rotates about the U axis, (2-6)"),
    },
    "03-ordinary-rotation": {
        (4, "3"): holds(
            "For one point the matrix costs 33 + 16, more than the quaternion of (2-6)",
            "33 + 16, or 19 + 17 by the leanest formula, against the quaternion's 18 + 12",
        ),
        (5, "1, 3, 6"): holds_if(
            "For many points the matrix is cheaper than the quaternion",
            "each point is turned by the quaternion itself, not by its matrix",
        ),
        (6, "1, 6"): does_not_follow(
            "So, for most applications of these fields, ordinary rotation is the more efficient",
            "a quaternion can be made into a matrix once, and then costs the same",
        ),
        (25, "3"): holds(
            "A teaspoon of 100 vertices is enough for the matrix to pay, against (2-6)",
            "4 are enough by the paper's 19 + 7, 3 by 18 + 12, and 2 by the leanest formulas",
        ),
        (31, "1"): holds_if(
            "Axis and angle are not easy to find in a matrix (reported as a reason for"
            " quaternions)",
            "the turn is nearly a half turn, where a matrix needs a choice among four cases",
            "elsewhere a sum and three differences give both, by an arctangent as in 30",
        ),
        (42, "3"): holds("(3-1), (3-2) and (3-3) are the same rotation"),
        (43, "3"): holds(
            "Building (3-3) takes 24 multiplications and 10 additions, applying it 9 and 6",
            "10 + 11 are enough to build it",
        ),
        (44, "3"): holds_if(
            "Turning a point by the quaternion of (2-6) takes 19 multiplications and 7 additions",
            "the fourth line of (2-6), for turns about U, is counted as it is printed, but for the"
            " sum of its scalar part, which is 0",
            "about any axis it takes 18 + 12, E5",
        ),
        (45, "3"): holds("For many points the cost of building the matrix can be ignored"),
        (71, "3"): holds(
            "By the matrix, $n$ points take $24+9n$ multiplications and $10+6n$ additions",
            "10 + 11 are enough to build it, as in 43",
        ),
    },
    "04-general-rotation": {
        (7, "1, 3, 6"): holds(
            "Rotation, translation, scaling, shearing, reflection and projection make one matrix,"
            " and each point is multiplied once",
            "with a perspective, each point is then divided by its last number",
        ),
        (8, "6"): holds_if(
            "Quaternions cannot have that advantage",
            "shears, uneven scalings or projections are among them, and the quaternion stays a"
            " quaternion",
            "one of any length, with a sign, merges turns with even scalings and mirrors, a dual"
            " one (the paper's reference [2], page C) with translations",
        ),
        (9, "1, 4, 6"): does_not_hold(
            "Axis and angle are found in a more general way than with quaternions",
            "the formulas start from three angles in one order; taken further, they are as general"
            " as products of quaternions, and the same",
        ),
        (10, "4"): holds("The three principal rotations of (4-1) come to a single one"),
        (23, "4"): a_matter_of_names(
            "(4-3) to (4-6) are ordinary rotation",
            "they are the product of quaternions in other letters, sign included",
        ),
        (33, "1, 3"): not_confirmed(
            "Besides hardware, multiplying each point only once makes real-time performance"
            " possible",
            "what is fast enough depends on the machine",
        ),
        (46, "4"): holds("(4-2) is the product (4-1)"),
        (47, "4"): holds(
            "Axis and angle of the single rotation are those of (4-3) to (4-6)",
            "where nothing turns, no axis is singled out",
        ),
        (48, "4"): holds_if(
            "In homogeneous coordinates the axis is $(a_u,a_v,a_w,1)$",
            "the tip of the axis is meant, a point; a direction ends in 0, E8",
        ),
        (65, "4, 6"): holds_if(
            "Axis and angle are easily recovered by the methods of Sections 3 and 4",
            "the three angles of (4-1) are given",
            "for a matrix the paper has no method",
        ),
        (69, "4"): holds(
            "The matrices about U, V and W are the three principal rotations",
            "each is (3-3) about its axis",
        ),
    },
    "05-arcs": {
        (11, "5"): holds(
            "(5-2) and (5-3) give any point of an arc",
            "between equal points they are 0/0, and opposite ones have no single arc",
        ),
        (12, "5"): holds_if(
            "Slerp has no form as a matrix times a vector like (5-3)",
            "*slerp* is that of quaternions, and *like (5-3)* means that a cross product finds the"
            " axis, an axis in space",
            "as a matrix times a vector it has a form in four dimensions, E7, which with three"
            " components is (5-3)",
        ),
        (49, "5"): holds(
            "The axis of the arc is (5-1)",
            "between equal points, which have no single axis, and between opposite ones, which have"
            " many arcs, it is 0/0",
        ),
        (50, "5"): slip(
            "The 4 × 4 matrix in (5-3), and in formulas like it, is defined in (3-3)",
            "that one is 3 × 3; (4-7) is meant, E9",
        ),
    },
    "05-control-points": {
        (52, "5"): holds(
            "$a_i$ and $b_i$ follow by Double and Bisect from three points",
            "for opposite points Bisect has no answer",
        ),
        (53, "5"): holds(
            "Each step has a formula and a rotation matrix",
            "the axis is 0/0 if the two points are equal or opposite",
        ),
        (54, "5"): holds(
            "The formulas give the control points",
            "(5-7) and (5-10) are 0/0 if the two points are equal, and have no answer if they are"
            " opposite",
        ),
        (55, "5"): holds_if(
            "The angle between $P_{i-1}$ and $\\bar P_{i-1}$ is $2\\theta_{i-1}$",
            "$\\theta_{i-1}$ is at most 90°, or the angle of the rotation is meant, E11",
        ),
        (56, "5"): holds_if(
            "The indices $i-1$ and $i+1$ count modulo $n$",
            "$P_n$ is $P_0$, as the caption of Figure 8 says, E12",
        ),
        (57, "5"): slip(
            "The axis of the second step is (5-9)",
            "the factors of the cross product are exchanged, E2",
        ),
        (58, "5"): slip("$b_i$ is (5-13)", "the points are exchanged, E3"),
    },
    "05-closed-curve": {
        (13, "1, 5, 6"): holds("A smooth curve through points of the sphere needs no quaternions"),
        (18, "5"): not_confirmed(
            "The control points are those of Shoemake's second approach",
            "the paper goes one half of the way, Shoemake one third according to a secondary"
            " source; we had no copy of his article",
        ),
        (19, "not claimed"): holds(
            "Whether $a_i$ goes one half or one third of the way makes a visible difference"
        ),
        (20, "5"): holds("The closed curve is $C^1$"),
        (21, "not claimed"): does_not_hold(
            "It is $C^2$, or at least of continuous curvature, $G^2$",
            "its second derivative and its curvature jump at the points",
        ),
        (22, "5"): holds(
            "The closed curve stays on the sphere and passes through the given points"
        ),
        (51, "5"): holds(
            "Arcs alone make no smooth curve; cubic pieces do",
            "all the way round one great circle arcs are enough, if their lengths or speeds are"
            " equal",
        ),
        (59, "5"): slip(
            "The program, as printed, generates a good $C^1$ curve on the sphere through all"
            " points",
            "it reads what was never written, E4, and no line computes $\\theta$, E4c; once"
            " corrected, its points lie on the curve, joined by straight lines",
        ),
        (60, "5"): slip(
            "The sine of an angle is negative if its cosine is", "the sine of 120° is positive, E4b"
        ),
        (61, "5"): holds_if(
            "(5-2) or (5-3) is used for the control polygon only",
            "every level of de Casteljau's construction counts as a control polygon",
            "the program applies (5-2) to all of them",
        ),
        (66, "5"): holds("Piece $C_i$ has the control points $P_{i-1}$, $a_{i-1}$, $b_i$, $P_i$"),
        (67, "5"): holds(
            "De Casteljau's construction, with arcs in place of segments, draws each piece",
            "(5-2) is 0/0 if the two points that it joins are equal, and has no answer if they are"
            " opposite",
        ),
        (68, "5"): holds_if(
            "A smooth curve needs cubic composite Bézier curves",
            "*needs* means that arcs alone will not do, as in 51",
            "a sum of sines and cosines, scaled to length 1, is smooth without them",
        ),
    },
    "05-orientations": {
        (14, "abstract, 1, 5, 6"): does_not_follow(
            "So interpolating rotations needs none",
            "points leave the roll open, and an arc brings one that nobody chose; but there is"
            " another way, see 15",
        ),
        (64, "5"): holds(
            "For the task of Section 5, two vectors on $S^2$ will do instead of two quaternions on"
            " $S^3$",
            "the task as stated is to join points of a sphere; for rotations see 14",
        ),
    },
    "05-orientation-curves": {
        (24, "not claimed"): does_not_hold(
            "The construction is tied to points of $S^2$",
            "with four components the same lines make a spline of rotations",
        ),
    },
    "06-conclusions": {
        (15, "abstract, 6"): holds_if(
            "Everything that quaternions can do, ordinary rotation can do",
            "*do* means what is to be done (turn, compose, tell turns apart, average, interpolate),"
            " and not by which formula, for a sum of quaternions has no counterpart",
            "a matrix alone cannot tell an odd number of full turns from an even one, nor the long"
            " way round from the short one; an axis with an angle up to 360° can",
        ),
        (16, "abstract"): does_not_hold(
            "… and more efficiently",
            "not everything: composing general turns takes less with quaternions, and so does an"
            " arc used once; turning many points (5) or about one axis takes less without",
        ),
        (17, "folklore"): holds_if(
            "Rounding harms products of quaternions less",
            "the harm that counts is to shapes, which a quaternion never bends; or memory is what"
            " is equal, and not digits; or, mostly, a turn of a few degrees is repeated and the"
            " matrix is composed by two columns or repaired by Gram and Schmidt's method",
            "otherwise the matrix, repaired once, mostly ends closer to the truth",
        ),
        (26, "1"): does_not_hold(
            "So there is no reason at all to use quaternions in these fields",
            "one is enough: composing general turns takes less with them, and so does an arc used"
            " once",
        ),
        (27, "title, 6"): holds_if(
            "Quaternions are not really needed in geometric modeling, computer graphics and"
            " animation",
            "*not needed* means that every task can be done without them, as in 15, at whatever"
            " cost",
        ),
        (28, "abstract, 1"): holds_if(
            "Quaternions are more efficient for rotations than ordinary rotation (reported as a"
            " belief)",
            "general turns are composed, or joined by an arc used once; many points are best turned"
            " by a matrix, whatever it is made from",
            "keeping or repairing a turn takes less with quaternions than with matrices, but no"
            " less than with an axis and its angle",
        ),
        (32, "abstract"): holds_if(
            "Rotations, too, are interpolated more efficiently by ordinary rotation",
            "all turns are about one axis, as of a wheel or a door, so that only the angle changes",
            "otherwise an arc used once takes more, and many samples of one arc, wanted as"
            " matrices, take about as much either way",
        ),
        (62, "6"): not_confirmed(
            "Most applications in these fields deal with models of many points",
            "the paper counts no applications, and neither do we",
        ),
        (63, "6"): not_confirmed(
            "Quaternions are commonly used for smooth curves through points of a sphere",
            "the paper names no example; Shoemake's curves join orientations",
        ),
        (70, "1"): holds(
            "The usual reasons for quaternions are partly true, but pass over what matrices do"
            " well",
            "composing takes less, while turning a point takes up to twice as much as by a"
            " matrix that is there, until the"
            " quaternion is made into a matrix",
        ),
    },
}

CLAIMS = tuple(
    sorted(
        (
            claim(number=number, where=tuple(where.split(", ")), chapter=page)
            for page, claims in ON_PAGE.items()
            for (number, where), claim in claims.items()
        ),
        key=lambda claim: claim.number,
    )
)


def claim_table(numbers: Iterable[int]) -> Table:
    """Make a table of claims, with links, for a page of the book.

    Parameters
    ----------
    numbers : iterable of int
        Which claims, in which order.

    Returns
    -------
    Table
        Numbers of equations and errata are links; other pages can link to a row, ``#claim-3``.

    Examples
    --------
    >>> claim_table([3])
    | No. | The claim | In | Verdict | Shown in |
    | --- | --- | --- | --- | --- |
    | [3]{#claim-3} | Four of the nine entries of a rotation matrix are independent | 1 | × **does not hold**, a slip: three are, [E6](#erratum-e6) | [Chapter\N{NO-BREAK SPACE}1](01-introduction.ipynb) |
    """  # noqa: E501
    known = {claim.number: claim for claim in CLAIMS}
    rows = [
        [
            f"[{claim.number}]{{#claim-{claim.number}}}",
            linked(claim.claim),
            ", ".join(claim.where),
            linked(claim.judgement),
            claim.link,
        ]
        for claim in map(known.__getitem__, numbers)
    ]
    return Table(["No.", "The claim", "In", "Verdict", "Shown in"], rows)


def verdicts_on(page: str) -> Table:
    """Make the table of the claims that a page judges, by their verdicts.

    Parameters
    ----------
    page : str
        The page's file without its ending.

    Returns
    -------
    Table
        Each number leads to the claim and to the reason of its verdict.

    Raises
    ------
    ValueError
        If there is no such page, or it judges none.

    Examples
    --------
    >>> verdicts_on("05-orientation-curves")
    | Verdict | Claims |
    | --- | --- |
    | × **does not hold** | [24](#claim-24) (not claimed) |
    """
    if page not in ON_PAGE:
        raise ValueError(f"page must be one of {', '.join(ON_PAGE)}; got {page!r}")

    links: dict[str, list[str]] = {word: [] for word in VERDICTS}
    for claim in CLAIMS:
        if claim.chapter == page:
            others = "".join(f" ({where})" for where in claim.where if where in OTHERS)
            links[claim.verdict].append(f"[{claim.number}](#claim-{claim.number}){others}")
    rows = [[signed(word), ", ".join(some)] for word, some in links.items() if some]
    return Table(["Verdict", "Claims"], rows)


def verdict_table() -> Table:
    """Make the table of what the verdicts mean, and how often each was given.

    Returns
    -------
    Table
        It counts all claims, and those of the paper, without folklore and what nobody claimed.
    """
    given = Counter(claim.verdict for claim in CLAIMS)
    of_paper = Counter(claim.verdict for claim in CLAIMS if claim.of_paper)
    return Table(
        ["Verdict", "Means", "Claims", "Of the paper"],
        [
            [signed(word), VERDICTS[word], str(given[word]), str(of_paper[word])]
            for word in VERDICTS
        ],
    )
