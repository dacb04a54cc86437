"""The paper's numbered equations and figures, and the functions that compute and draw them.

Their tables are made from this list alone, and the test of an equation carries its number as a
mark, ``@pytest.mark.equation("5-2")``.
"""

from dataclasses import dataclass
from typing import Literal

from rotedu.edition.notebook import Table, linked

__all__ = ["EQUATIONS", "FIGURES", "Equation", "Figure", "equation_table", "figure_table"]


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
    status : str
        "as printed" if the code computes what is printed, perhaps in a form that rounds better;
        "convention" if that is right when read as the remark says; "corrected" if it is not.
    remark : str
        In Markdown.
    """

    number: str
    words: str
    functions: tuple[str, ...]
    status: Literal["as printed", "convention", "corrected"]
    remark: str = ""

    @property
    def label(self) -> str:
        """The label on its page, to which all pages can link."""
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
        """The label on its page."""
        return f"figure-{self.number}"


EQUATIONS = (
    Equation(
        "2-1",
        "a quaternion is a scalar and a vector",
        ("quaternions.Quaternion",),
        "convention",
        "together they make up $\\mathbb R^4$: E1",
    ),
    Equation(
        "2-2",
        "sum and difference, component by component",
        ("quaternions.Quaternion.__add__", "quaternions.Quaternion.__sub__"),
        "as printed",
    ),
    Equation(
        "2-3",
        "Hamilton's product",
        ("quaternions.Quaternion.__mul__",),
        "as printed",
        "$\\times$ for the paper's $\\otimes$",
    ),
    Equation(
        "2-4",
        "the inverse",
        ("quaternions.Quaternion.inverse",),
        "convention",
        "not for $q=0$",
    ),
    Equation(
        "2-5",
        "the quotient of two quaternions",
        ("quaternions.Quaternion.__truediv__",),
        "convention",
        "undoes a product only from the right",
    ),
    Equation(
        "2-6",
        "a point is turned about the U axis by a quaternion",
        ("quaternions.rotate_about_u", "quaternions.Quaternion.rotate"),
        "corrected",
        "a lost comma, and $\\theta_v$ for $\\theta_u$: [glitch](#likely-glitches)",
    ),
    Equation(
        "3-1",
        "Rodrigues' formula: a vector is turned about an axis",
        ("ordinary_rotation.rotate",),
        "as printed",
        "the code normalises the axis",
    ),
    Equation(
        "3-2",
        "the same as a matrix times a vector",
        ("ordinary_rotation.transform",),
        "as printed",
    ),
    Equation(
        "3-3",
        "the matrix, entry by entry",
        ("ordinary_rotation.rotation_matrix",),
        "as printed",
        "the code normalises the axis",
    ),
    Equation(
        "4-1",
        "three principal rotations, one after the other",
        ("general_rotation.compose", "general_rotation.matrix_from_euler_angles"),
        "convention",
        "U first, then V, then W; the axes stay where they are",
    ),
    Equation(
        "4-2",
        "their product, multiplied out",
        ("general_rotation.matrix_from_euler_angles",),
        "as printed",
    ),
    Equation(
        "4-3",
        "the axis of the one rotation that replaces the three",
        ("general_rotation.axis_angle_from_euler_angles",),
        "convention",
        "0/0 where nothing turns; the code then returns the U axis",
    ),
    Equation(
        "4-4",
        "the numbers $\\alpha,\\beta,\\gamma$ from half angles",
        ("general_rotation.quaternion_from_euler_angles",),
        "as printed",
    ),
    Equation(
        "4-5",
        "the sine of half its angle",
        ("general_rotation.axis_angle_from_euler_angles",),
        "convention",
        "gives the angle only together with (4-6)",
    ),
    Equation(
        "4-6",
        "the cosine of half its angle",
        ("general_rotation.quaternion_from_euler_angles",),
        "as printed",
    ),
    Equation(
        "4-7",
        "the matrix (3-3) in homogeneous coordinates",
        ("general_rotation.homogeneous",),
        "as printed",
        "the axis in its text: E8",
    ),
    Equation(
        "5-1",
        "the axis of the arc between two points",
        ("arcs.arc_axis",),
        "convention",
        "for ${0<\\theta<\\pi}$",
    ),
    Equation(
        "5-2",
        "a point of the arc from sines (slerp)",
        ("arcs.slerp",),
        "convention",
        "for ${0<\\theta<\\pi}$; the code uses an equal form that allows ${\\theta=0}$",
    ),
    Equation(
        "5-3",
        "a point of the arc by rotation",
        ("arcs.slerp_by_rotation",),
        "as printed",
        "the text around it: E7, E9",
    ),
    Equation(
        "5-4",
        "Double: a point reflected in the next",
        ("control_points.double",),
        "as printed",
        "the text around it: E11",
    ),
    Equation(
        "5-5",
        "Double by rotation",
        ("control_points.double_by_rotation",),
        "as printed",
        "the text around it: E9",
    ),
    Equation(
        "5-6",
        "the axis of (5-5)",
        ("arcs.arc_axis",),
        "convention",
        "for ${0<\\theta_{i-1}<\\pi}$; (5-9) uses the same letter for another axis",
    ),
    Equation(
        "5-7",
        "Bisect: midway to the next point",
        ("control_points.bisect",),
        "corrected",
        "a bar lost in the denominators: [glitch](#likely-glitches);"
        " for ${0<\\bar\\theta_{i-1}<\\pi}$, the code also for 0",
    ),
    Equation(
        "5-8",
        "Bisect by rotation",
        ("control_points.bisect_by_rotation",),
        "as printed",
        "once its axis (5-9) is corrected; the text around it: E9",
    ),
    Equation(
        "5-9",
        "the axis of (5-8)",
        ("arcs.arc_axis",),
        "corrected",
        "E2; also a bar lost: [glitch](#likely-glitches); for ${0<\\bar\\theta_{i-1}<\\pi}$",
    ),
    Equation(
        "5-10",
        "the control point $a_i$",
        ("control_points.bisect", "control_points.control_points"),
        "corrected",
        "a bar lost in the denominators: [glitch](#likely-glitches);"
        " for ${0<\\bar\\theta_i<\\pi}$, the code also for 0",
    ),
    Equation(
        "5-11",
        "$a_i$ by rotation",
        ("control_points.bisect_by_rotation",),
        "as printed",
        "the text around it: E9",
    ),
    Equation(
        "5-12",
        "the axis of (5-11)",
        ("arcs.arc_axis",),
        "corrected",
        "a bar lost in the denominator: [glitch](#likely-glitches); for ${0<\\bar\\theta_i<\\pi}$",
    ),
    Equation(
        "5-13",
        "the control point $b_i$",
        ("control_points.double", "control_points.control_points"),
        "corrected",
        "E3",
    ),
    Equation(
        "5-14",
        "$b_i$ by rotation",
        ("control_points.double_by_rotation",),
        "as printed",
        "the text around it: E9",
    ),
    Equation(
        "5-15",
        "the axis of (5-14)",
        ("arcs.arc_axis",),
        "convention",
        "for ${0<\\tilde\\theta_i<\\pi}$; the same vector as (5-12)",
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
        ("Number", "What it says", "Status", "Function"),
        [
            (
                f"[({row.number})](#{row.label})",
                linked(row.words),
                f"**{row.status}**" + (f"; {linked(row.remark)}" if row.remark else ""),
                ", ".join(map(_function_link, row.functions)),
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
                linked(row.words),
                _function_link(row.function),
            )
            for row in FIGURES
        ],
    )


def _function_link(function: str) -> str:
    """Link to a function; an operator to its class, where it is described."""
    *outer, name = function.split(".")
    if not name.startswith("__"):
        return f"{{py:obj}}`~rotedu.{function}`"
    return f"{{py:obj}}`{outer[-1]}.{name} <rotedu.{'.'.join(outer)}>`"
