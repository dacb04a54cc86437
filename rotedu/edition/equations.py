"""The paper's numbered equations and figures, and the functions that compute and draw them.

Their tables are made from this list alone, and the test of an equation carries its number as a
mark, ``@pytest.mark.equation("5-2")``.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Literal, get_args

from rotedu.edition.notebook import Table, linked

__all__ = ["EQUATIONS", "FIGURES", "Equation", "Figure", "equation_table", "figure_table"]

Status = Literal["as printed", "convention", "corrected"]


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
    status: Status
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


def judged(status: Status) -> Callable[..., partial[Equation]]:
    """Return a function that makes an equation but for its number."""
    return lambda words, functions, remark="": partial(
        Equation, words=words, functions=tuple(functions.split(", ")), status=status, remark=remark
    )


as_printed, convention, corrected = map(judged, get_args(Status))

BY_NUMBER = {
    "2-1": convention(
        "a quaternion is a scalar and a vector",
        "quaternions.Quaternion",
        "together they make up $\\mathbb R^4$: E1",
    ),
    "2-2": as_printed(
        "sum and difference, component by component",
        "quaternions.Quaternion.__add__, quaternions.Quaternion.__sub__",
    ),
    "2-3": as_printed(
        "Hamilton's product",
        "quaternions.Quaternion.__mul__",
        "$\\times$ for the paper's $\\otimes$",
    ),
    "2-4": convention("the inverse", "quaternions.Quaternion.inverse", "not for $q=0$"),
    "2-5": convention(
        "the quotient of two quaternions",
        "quaternions.Quaternion.__truediv__",
        "undoes a product only from the right",
    ),
    "2-6": corrected(
        "a point is turned about the U axis by a quaternion",
        "quaternions.rotate_about_u, quaternions.Quaternion.rotate",
        "a lost comma, and $\\theta_v$ for $\\theta_u$: [glitch](#likely-glitches)",
    ),
    "3-1": as_printed(
        "Rodrigues' formula: a vector is turned about an axis",
        "ordinary_rotation.rotate",
        "the code normalises the axis",
    ),
    "3-2": as_printed("the same as a matrix times a vector", "ordinary_rotation.transform"),
    "3-3": as_printed(
        "the matrix, entry by entry",
        "ordinary_rotation.rotation_matrix",
        "the code normalises the axis",
    ),
    "4-1": convention(
        "three principal rotations, one after the other",
        "general_rotation.compose, general_rotation.matrix_from_euler_angles",
        "U first, then V, then W; the axes stay where they are",
    ),
    "4-2": as_printed("their product, multiplied out", "general_rotation.matrix_from_euler_angles"),
    "4-3": convention(
        "the axis of the one rotation that replaces the three",
        "general_rotation.axis_angle_from_euler_angles",
        "0/0 where nothing turns; the code then returns the U axis",
    ),
    "4-4": as_printed(
        "the numbers $\\alpha,\\beta,\\gamma$ from half angles",
        "general_rotation.quaternion_from_euler_angles",
    ),
    "4-5": convention(
        "the sine of half its angle",
        "general_rotation.axis_angle_from_euler_angles",
        "gives the angle only together with (4-6)",
    ),
    "4-6": as_printed(
        "the cosine of half its angle", "general_rotation.quaternion_from_euler_angles"
    ),
    "4-7": as_printed(
        "the matrix (3-3) in homogeneous coordinates",
        "general_rotation.homogeneous",
        "the axis in its text: E8",
    ),
    "5-1": convention(
        "the axis of the arc between two points", "arcs.arc_axis", "for ${0<\\theta<\\pi}$"
    ),
    "5-2": convention(
        "a point of the arc from sines (slerp)",
        "arcs.slerp",
        "for ${0<\\theta<\\pi}$; the code uses an equal form that allows ${\\theta=0}$",
    ),
    "5-3": as_printed(
        "a point of the arc by rotation", "arcs.slerp_by_rotation", "the text around it: E7, E9"
    ),
    "5-4": as_printed(
        "Double: a point reflected in the next", "control_points.double", "the text around it: E11"
    ),
    "5-5": as_printed(
        "Double by rotation", "control_points.double_by_rotation", "the text around it: E9"
    ),
    "5-6": convention(
        "the axis of (5-5)",
        "arcs.arc_axis",
        "for ${0<\\theta_{i-1}<\\pi}$; (5-9) uses the same letter for another axis",
    ),
    "5-7": corrected(
        "Bisect: midway to the next point",
        "control_points.bisect",
        "a bar lost in the denominators: [glitch](#likely-glitches); for"
        " ${0<\\bar\\theta_{i-1}<\\pi}$, the code also for 0",
    ),
    "5-8": as_printed(
        "Bisect by rotation",
        "control_points.bisect_by_rotation",
        "once its axis (5-9) is corrected; the text around it: E9",
    ),
    "5-9": corrected(
        "the axis of (5-8)",
        "arcs.arc_axis",
        "E2; also a bar lost: [glitch](#likely-glitches); for ${0<\\bar\\theta_{i-1}<\\pi}$",
    ),
    "5-10": corrected(
        "the control point $a_i$",
        "control_points.bisect, control_points.control_points",
        "a bar lost in the denominators: [glitch](#likely-glitches); for ${0<\\bar\\theta_i<\\pi}$,"
        " the code also for 0",
    ),
    "5-11": as_printed(
        "$a_i$ by rotation", "control_points.bisect_by_rotation", "the text around it: E9"
    ),
    "5-12": corrected(
        "the axis of (5-11)",
        "arcs.arc_axis",
        "a bar lost in the denominator: [glitch](#likely-glitches); for ${0<\\bar\\theta_i<\\pi}$",
    ),
    "5-13": corrected(
        "the control point $b_i$", "control_points.double, control_points.control_points", "E3"
    ),
    "5-14": as_printed(
        "$b_i$ by rotation", "control_points.double_by_rotation", "the text around it: E9"
    ),
    "5-15": convention(
        "the axis of (5-14)",
        "arcs.arc_axis",
        "for ${0<\\tilde\\theta_i<\\pi}$; the same vector as (5-12)",
    ),
}

EQUATIONS = tuple(equation(number=number) for number, equation in BY_NUMBER.items())

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
    """Make the table of the figures, with links, for a page of the book."""
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
