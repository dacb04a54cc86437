"""What the paper consists of, part by part, and where this book keeps each part.

This is the one source of the tables of equations, figures and errata. The tests check that nothing
is missing and that every row points at something: a function that can be imported, a test that
exists, a label or a heading that one page of the book has.
"""

import re
from dataclasses import dataclass
from typing import Literal

from rotedu.edition.notebook import Table

__all__ = [
    "EQUATIONS",
    "ERRATA",
    "FIGURES",
    "Equation",
    "Erratum",
    "Figure",
    "equation_table",
    "errata_table",
    "figure_table",
]


@dataclass(frozen=True, slots=True)
class Equation:
    """A numbered equation of the paper.

    Attributes
    ----------
    number : str
        Without parentheses, as in ``5-2``.
    words : str
        What it says.
    functions : tuple of str
        The functions that compute it, as ``module.name`` inside the package.
    test : str
        A test that fails if they do not, as pytest names it.
    status : str
        "as printed" if the code computes what is printed, perhaps in a form that rounds better;
        "convention" if that is right when read as the remark says; "corrected" if it is not.
    remark : str
        In Markdown.
    """

    number: str
    words: str
    functions: tuple[str, ...]
    test: str
    status: Literal["as printed", "convention", "corrected"]
    remark: str = ""

    @property
    def label(self) -> str:
        """What its page calls it, so that all pages can link to it."""
        return f"eq-{self.number}"


@dataclass(frozen=True, slots=True)
class Figure:
    """A figure of the paper; the scene that shows it is ``rotedu.scenes.figure_<number>``."""

    number: int
    words: str

    @property
    def function(self) -> str:
        """The function that draws it, as ``module.name`` inside the package."""
        return f"scenes.figure_{self.number}"

    @property
    def label(self) -> str:
        """What its page calls it."""
        return f"figure-{self.number}"


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
        What is there, and what should be, in Markdown.
    kind : str
        What is wrong: a "result" that is computed, a "fact" that is stated, or only the "wording".
    """

    number: str
    title: str
    place: str
    printed: str
    correct: str
    kind: Literal["result", "fact", "wording"]

    @property
    def label(self) -> str:
        """What the errata page calls it."""
        return f"erratum-{self.number.lower()}"


def _quaternions(test: str) -> str:
    return f"tests/test_quaternions.py::{test}"


def _ordinary(test: str) -> str:
    return f"tests/test_ordinary_rotation.py::{test}"


def _general(test: str) -> str:
    return f"tests/test_general_rotation.py::{test}"


def _curves(test: str) -> str:
    return f"tests/test_interpolation.py::{test}"


EQUATIONS = (
    Equation(
        "2-1",
        "a quaternion is a scalar and a vector",
        ("quaternions.Quaternion",),
        _quaternions("TestAlgebra::test_parts"),
        "convention",
        "the set of all is $\\mathbb R^4$: E1",
    ),
    Equation(
        "2-2",
        "sum and difference, component by component",
        ("quaternions.Quaternion.__add__", "quaternions.Quaternion.__sub__"),
        _quaternions("TestAlgebra::test_sums_are_componentwise"),
        "as printed",
    ),
    Equation(
        "2-3",
        "Hamilton's product",
        ("quaternions.Quaternion.__mul__",),
        _quaternions("TestProofs::test_product_is_the_one_of_2_3"),
        "as printed",
        "$\\times$ for the paper's $\\otimes$",
    ),
    Equation(
        "2-4",
        "the inverse",
        ("quaternions.Quaternion.inverse",),
        _quaternions("TestProofs::test_inverse_on_both_sides_and_division_on_the_right"),
        "convention",
        "not for $q=0$",
    ),
    Equation(
        "2-5",
        "the quotient of two quaternions",
        ("quaternions.Quaternion.__truediv__",),
        _quaternions("TestAlgebra::test_division_is_from_the_right"),
        "convention",
        "undoes a product from the right only",
    ),
    Equation(
        "2-6",
        "a point is turned about the U axis by a quaternion",
        ("quaternions.rotate_about_u", "quaternions.Quaternion.rotate"),
        _quaternions("TestProofs::test_last_line_of_2_6"),
        "corrected",
        "a lost comma, and $\\theta_v$ for $\\theta_u$: [glitch](#likely-glitches)",
    ),
    Equation(
        "3-1",
        "Rodrigues' formula: a vector is turned about an axis",
        ("ordinary_rotation.rotate",),
        _ordinary("TestProofs::test_the_first_line_of_3_1_is_the_second"),
        "as printed",
    ),
    Equation(
        "3-2",
        "the same as a matrix times a vector",
        ("ordinary_rotation.transform",),
        _ordinary("TestProofs::test_transform_is_the_matrix_product"),
        "as printed",
    ),
    Equation(
        "3-3",
        "the matrix, entry by entry",
        ("ordinary_rotation.rotation_matrix",),
        _ordinary("TestProofs::test_matrix_times_vector_is_rodrigues_formula"),
        "convention",
        "for an axis of length 1; the code normalises it",
    ),
    Equation(
        "4-1",
        "three principal rotations, one after the other",
        ("general_rotation.compose", "general_rotation.matrix_from_euler_angles"),
        _general("TestCompose::test_three_principal_rotations"),
        "convention",
        "U first, then V, then W; the axes stay where they are",
    ),
    Equation(
        "4-2",
        "their product, multiplied out",
        ("general_rotation.matrix_from_euler_angles",),
        _general("TestProofs::test_4_2_is_4_1_multiplied_out"),
        "as printed",
    ),
    Equation(
        "4-3",
        "the axis of the one rotation that replaces the three",
        ("general_rotation.axis_angle_from_euler_angles",),
        _general("TestSingleRotation::test_identity"),
        "convention",
        "0/0 where nothing turns; there the code returns the U axis",
    ),
    Equation(
        "4-4",
        "the numbers $\\alpha,\\beta,\\gamma$ from half angles",
        ("general_rotation.quaternion_from_euler_angles",),
        _general("TestProofs::test_4_4_and_4_6_are_the_product_of_three_quaternions"),
        "as printed",
    ),
    Equation(
        "4-5",
        "the sine of half its angle",
        ("general_rotation.axis_angle_from_euler_angles",),
        _general("TestSingleRotation::test_the_sine_alone_would_not_do"),
        "convention",
        "gives the angle only together with (4-6)",
    ),
    Equation(
        "4-6",
        "the cosine of half its angle",
        ("general_rotation.quaternion_from_euler_angles",),
        _general("TestProofs::test_4_4_and_4_6_are_the_product_of_three_quaternions"),
        "as printed",
    ),
    Equation(
        "4-7",
        "the matrix (3-3) in homogeneous coordinates",
        ("general_rotation.homogeneous",),
        _general("TestTransforms::test_homogeneous"),
        "as printed",
        "the axis in its text: E8",
    ),
    Equation(
        "5-1",
        "the axis of the arc between two points",
        ("arcs.arc_axis",),
        _curves("TestAxis::test_is_perpendicular_and_right_handed"),
        "convention",
        "for ${0<\\theta<\\pi}$",
    ),
    Equation(
        "5-2",
        "a point of the arc from sines (slerp)",
        ("arcs.slerp",),
        _curves("TestProofs::test_arc_is_5_2"),
        "convention",
        "0/0 where the ends coincide; the code uses an equal form that is not",
    ),
    Equation(
        "5-3",
        "a point of the arc by rotation",
        ("arcs.slerp_by_rotation",),
        _curves("TestProofs::test_arc_by_rotation_is_5_2"),
        "as printed",
        "the text around it: E7, E9",
    ),
    Equation(
        "5-4",
        "Double: a point reflected in the next",
        ("control_points.double",),
        _curves("TestDouble::test_reflects"),
        "as printed",
        "the text around it: E11",
    ),
    Equation(
        "5-5",
        "Double by rotation",
        ("control_points.double_by_rotation",),
        _curves("TestSteps::test_5_4_and_5_5"),
        "as printed",
        "the text around it: E9",
    ),
    Equation(
        "5-6",
        "the axis of (5-5)",
        ("arcs.arc_axis",),
        _curves("TestSteps::test_5_4_and_5_5"),
        "convention",
        "for ${0<\\theta_{i-1}<\\pi}$; (5-9) uses the same letter for another axis",
    ),
    Equation(
        "5-7",
        "Bisect: midway to the next point",
        ("control_points.bisect",),
        _curves("TestSteps::test_bars_that_are_lost_would_be_noticed"),
        "corrected",
        "a bar lost in the denominators: [glitch](#likely-glitches)",
    ),
    Equation(
        "5-8",
        "Bisect by rotation",
        ("control_points.bisect_by_rotation",),
        _curves("TestSteps::test_5_7_to_5_9"),
        "as printed",
        "once its axis (5-9) is corrected; the text around it: E9",
    ),
    Equation(
        "5-9",
        "the axis of (5-8)",
        ("arcs.arc_axis",),
        _curves("TestSteps::test_5_9_as_printed_turns_away_from_the_next_point"),
        "corrected",
        "E2; also a bar lost: [glitch](#likely-glitches)",
    ),
    Equation(
        "5-10",
        "the control point $a_i$",
        ("control_points.bisect", "control_points.control_points"),
        _curves("TestSteps::test_bars_that_are_lost_would_be_noticed"),
        "corrected",
        "a bar lost in the denominators: [glitch](#likely-glitches)",
    ),
    Equation(
        "5-11",
        "$a_i$ by rotation",
        ("control_points.bisect_by_rotation",),
        _curves("TestSteps::test_5_10_to_5_12"),
        "as printed",
        "the text around it: E9",
    ),
    Equation(
        "5-12",
        "the axis of (5-11)",
        ("arcs.arc_axis",),
        _curves("TestSteps::test_5_10_to_5_12"),
        "corrected",
        "a bar lost in the denominator: [glitch](#likely-glitches)",
    ),
    Equation(
        "5-13",
        "the control point $b_i$",
        ("control_points.double", "control_points.control_points"),
        _curves("TestSteps::test_5_13_to_5_15"),
        "corrected",
        "E3",
    ),
    Equation(
        "5-14",
        "$b_i$ by rotation",
        ("control_points.double_by_rotation",),
        _curves("TestSteps::test_5_13_to_5_15"),
        "as printed",
        "the text around it: E9",
    ),
    Equation(
        "5-15",
        "the axis of (5-14)",
        ("arcs.arc_axis",),
        _curves("TestSteps::test_5_13_to_5_15"),
        "as printed",
        "the same vector as (5-12)",
    ),
)

FIGURES = (
    Figure(1, "a vector is turned about an axis"),
    Figure(2, "two points, their arc and its axis"),
    Figure(3, "three neighbours and the control points $a_i$, $b_i$"),
    Figure(4, "Double: the axis (5-6) and twice the arc"),
    Figure(5, "the first Bisect: the axis (5-9)"),
    Figure(6, "the second Bisect, which gives $a_i$: the axis (5-12)"),
    Figure(7, "Double again, which gives $b_i$: the axis (5-15)"),
    Figure(8, "the closed curve through $P_0$ to $P_4=P_0$"),
)

ERRATA = (
    Erratum(
        "E1",
        "Quaternions are not a sphere, and their unit sphere is not S²",
        "Section 2.1",
        "all quaternions are $S^3$, the unit ones $S^2$",
        "all are $\\mathbb R^4$, the unit ones $S^3$",
        "wording",
    ),
    Erratum(
        "E2",
        "The axis (5-9) turns the wrong way",
        "(5-9)",
        "$P_{i+1}\\times\\bar P_{i-1}$",
        "$\\bar P_{i-1}\\times P_{i+1}$",
        "result",
    ),
    Erratum(
        "E3",
        "(5-13) goes back instead of on",
        "(5-13)",
        "$2\\cos\\tilde\\theta_i\\,a_i-P_i$",
        "$2\\cos\\tilde\\theta_i\\,P_i-a_i$",
        "result",
    ),
    Erratum(
        "E4",
        "The pseudocode reads what it has not written yet",
        "Section 5, pseudocode",
        "`Q[j][k-1]`, `Q[j][k]`",
        "`Q[j-1][k-1]`, `Q[j-1][k]`",
        "result",
    ),
    Erratum(
        "E4b",
        "The sine is not negative",
        "Section 5, pseudocode",
        "the comment: $\\sin\\theta<0$ if $\\cos\\theta<0$",
        "no comment: $\\sin\\theta\\ge0$",
        "result",
    ),
    Erratum(
        "E4c",
        "The angle is used and never computed",
        "Section 5, pseudocode",
        "$\\cos\\theta$ and $\\sin\\theta$, no $\\theta$",
        "$\\theta$ from an arctangent",
        "result",
    ),
    Erratum(
        "E5",
        "No quaternion formula takes 19 multiplications and 7 additions",
        "Sections 1 and 3",
        "19 + 7 to compose, and to turn a point",
        "16 + 12 to compose, 18 + 12 to turn",
        "fact",
    ),
    Erratum(
        "E6",
        "Three entries of a rotation matrix are independent, not four",
        "Section 1",
        "four of nine",
        "three of nine",
        "fact",
    ),
    Erratum(
        "E7",
        "Slerp does have a matrix",
        "after (5-3)",
        "slerp cannot be a matrix times a vector",
        "it can: a 4 × 4 rotation matrix",
        "fact",
    ),
    Erratum(
        "E8",
        "An axis is a direction, not a point",
        "after (4-7)",
        "$(a_u,a_v,a_w,1)$",
        "$(a_u,a_v,a_w,0)$",
        "wording",
    ),
    Erratum(
        "E9",
        "The 4 × 4 matrix is that of (4-7), not (3-3)",
        "at (5-3), (5-5), (5-8), (5-11), (5-14)",
        "the 4 × 4 matrix of (3-3)",
        "the 4 × 4 matrix of (4-7)",
        "wording",
    ),
    Erratum(
        "E10",
        "Section 2 does not interpolate",
        "Section 1, last paragraph",
        "Section 2 reviews interpolation",
        "it ends with (2-6)",
        "wording",
    ),
    Erratum(
        "E11",
        "Twice the angle is not always the angle between",
        "before (5-4)",
        "$P_{i-1}$, $\\bar P_{i-1}$ are $2\\theta_{i-1}$ apart",
        "along the arc, or if $\\theta_{i-1}\\le90^\\circ$",
        "wording",
    ),
    Erratum(
        "E12",
        "Modulo n needs n different points",
        "Section 5",
        "$P_0,\\dots,P_n$, indices modulo $n$",
        "the same, with $P_n=P_0$",
        "wording",
    ),
)


def equation_table(section: int) -> Table:
    """Make the table of a section's equations, with links, for a page of the book.

    Parameters
    ----------
    section : int
        Section of the paper, from 2 to 5.

    Returns
    -------
    Table

    Examples
    --------
    >>> print(repr(equation_table(3)).splitlines()[3].split(" | ")[1])
    the same as a matrix times a vector
    """
    return Table(
        ("Number", "What it says", "Status", "Function", "Test"),
        [
            (
                f"[({row.number})](#{row.label})",
                _linked(row.words),
                f"**{row.status}**" + (f"; {_linked(row.remark)}" if row.remark else ""),
                ", ".join(map(_function_link, row.functions)),
                _breakable(row.test.partition("::")[2]),
            )
            for row in EQUATIONS
            if row.number.startswith(f"{section}-")
        ],
    )


def figure_table() -> Table:
    """Make the table of the figures, with links, for a page of the book.

    Returns
    -------
    Table
    """
    return Table(
        ("Figure", "What it shows", "Function"),
        [
            (
                f"[Figure {row.number}](#{row.label})",
                _linked(row.words),
                _function_link(row.function),
            )
            for row in FIGURES
        ],
    )


def errata_table() -> Table:
    """Make the table of the errata, with links, for a page of the book.

    Returns
    -------
    Table
    """
    return Table(
        ("Number", "Where", "As printed", "What it should be", "What is wrong"),
        [
            (
                f"[{row.number}](#{row.label})",
                _linked(row.place),
                _linked(row.printed),
                _linked(row.correct),
                row.kind,
            )
            for row in ERRATA
        ],
    )


def _function_link(function: str) -> str:
    """Link to a function; an operator to its class, where it is described."""
    *outer, name = function.split(".")
    if not name.startswith("__"):
        return f"{{py:obj}}`~rotedu.{function}`"
    return f"{{py:obj}}`{outer[-1]}.{name} <rotedu.{'.'.join(outer)}>`"


def _breakable(name: str) -> str:
    """Write a long name as code that may be broken after its words."""
    parts = re.split("(?<=[a-z]_)|(?<=::)", name)
    return f'<code class="docutils literal">{"<wbr>".join(parts)}</code>'.replace("_", r"\_")


def _linked(text: str) -> str:
    """Link the numbers of equations and errata in a text."""
    text = re.sub(r"\((\d-\d+)\)", r"[(\1)](#eq-\1)", text)
    return re.sub(r"\bE\d+[bc]?\b", lambda n: f"[{n[0]}](#erratum-{n[0].lower()})", text)
