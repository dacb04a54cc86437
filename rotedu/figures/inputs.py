"""What the hand can change in a figure: numbers, points, orientations, switches and choices.

Each kind checks the values that enter, describes itself to the viewer and writes its controls.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np

SAME = 1e-12
# A letter that stands for a quantity, with hat or bar and indices, or a product of such
SYMBOL = re.compile(
    r"(?<![\w'’/])(?!(?:a|A|I)\b)(?:(?:[a-z][₀-₉]+)+|[A-Za-zθ][\u0302\u0304]?)(?:,?[₀-₉ᵢ₊₋])*"
    r"(?![\w’'\u0302\u0304])"
)
INDEX = re.compile(r"[₀-₉ᵢ₊₋]+(?:,[₀-₉ᵢ₊₋]+)*")
LOWERED = dict(zip(map(ord, "₀₁₂₃₄₅₆₇₈₉ᵢ₊₋"), [*"0123456789", "<i>i</i>", "+", "−"], strict=True))


def unit_vectors(
    name: str,
    given: Any,
    size: int,
    names: str | Sequence[str],
    least: int,
    most: int,
    length: float = 1.0,
) -> list[Any]:
    """Check one vector, shape (size,), or several, shape (n, size), and scale them to a length."""
    vectors = np.asarray(given, float)
    several = not isinstance(names, str)
    least, most = least or len(names), most or len(names)
    if vectors.shape[-1:] != (size,) or vectors.ndim != 1 + several:
        shape = f"(n, {size})" if several else f"({size},)"
        raise ValueError(f"{name}: expected shape {shape}, got {vectors.shape}")
    what = "points" if size == 3 else "quaternions"
    if several and not least <= len(vectors) <= most:
        raise ValueError(f"{name}: expected {least} to {most} {what}, got {len(vectors)}")
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    if not (np.isfinite(lengths) & (lengths > 0)).all():
        origin = "the origin" if size == 3 else "0"
        raise ValueError(f"{name}: expected finite {what} other than {origin}, got {given}")
    # What has the length already stays exactly as it is.
    wanted = np.where(abs(lengths - length) < SAME, lengths, length or lengths)
    scaled: list[Any] = (vectors * (wanted / lengths)).tolist()
    return scaled


def written(text: str) -> str:
    """Write words as HTML, with letters that stand for quantities as in formulas.

    Parameters
    ----------
    text : str
        The words.

    Returns
    -------
    str
        HTML.

    Examples
    --------
    >>> print(written("slerp's angle θ at a point P₀, in °/s"))
    slerp's angle <i>θ</i> at a point <i>P<sub>0</sub></i>, in °/s
    """
    symbols = SYMBOL.sub(r"<i>\g<0></i>", escape(text, quote=False))
    return INDEX.sub(lambda index: f"<sub>{index[0].translate(LOWERED)}</sub>", symbols)


def add_and_remove(name: str, what: str) -> str:
    """Write the buttons that change the number of points or bodies."""
    buttons = "".join(
        f'<button type="button" data-action="{action}" data-input="{name}">'
        f"{action.title()} a {what}</button>"
        for action in ("add", "remove")
    )
    return f'<div class="explorable-buttons">{buttons}</div>'


@dataclass(frozen=True)
class Slider:
    """A number between two bounds.

    Parameters
    ----------
    low, high : float
        The bounds.
    label : str
        What the number is.
    step : float
        Smallest difference; 0 means a two-hundredth of the range.
    stride : float or str
        How far the button *Step* goes, or the input that says so; 0 means an eighth of the range.
    plays : float
        Seconds that the button *Play* takes from `low` to `high`, where it starts over; 0 means no
        buttons.
    row : bool
        Whether the slider is shown. Without a row the number is changed where `place_grip` says,
        in a chart, or by a link to a state.
    """

    low: float
    high: float
    label: str = ""
    step: float = 0
    stride: float | str = 0
    plays: float = 0
    row: bool = True

    kind = "number"

    def value(self, name: str, given: Any) -> float:
        """Check a number."""
        number = float(given)
        if not self.low <= number <= self.high:
            raise ValueError(f"{name}: expected {self.low:g} to {self.high:g}, got {number:g}")
        return number

    def spec(self) -> dict[str, Any]:
        """Describe the slider to the viewer."""
        width = self.high - self.low
        return {
            "low": self.low,
            "high": self.high,
            "step": self.step or width / 200,
            "stride": self.stride or width / 8,
            "plays": self.plays,
            "label": self.label,
        }

    def controls(self, name: str, start: float) -> str:
        """Write a slider, the same number to type, and buttons if it plays."""
        if not self.row:
            return ""
        spec = self.spec()
        bounds = f'min="{self.low:g}" max="{self.high:g}" step="{spec["step"]:g}"'
        label, spoken = written(self.label or name), escape(self.label or name)
        buttons = (
            '<span class="explorable-buttons">'
            f'<button type="button" data-action="play" data-input="{name}">Play</button>'
            f'<button type="button" data-action="step" data-input="{name}">Step</button></span>'
        )
        return (
            f'<div class="explorable-row"><label for="{{id}}-{name}">{label}</label>'
            f'<input type="range" id="{{id}}-{name}" name="{name}" {bounds} value="{start:g}">'
            f'<input type="number" name="{name}-number" aria-label="{spoken}" {bounds}'
            f' value="{start:g}">{buttons if self.plays else ""}</div>'
        )


@dataclass(frozen=True)
class Handles:
    """A point of a sphere about the origin, or several, that can be dragged.

    Parameters
    ----------
    names : str or sequence of str
        Name of the point, or of each point, for those who cannot see it.
    least, most : int
        How many points there may be; 0 means as many as at the start. The buttons *Add* and
        *Remove* change the last point.
    length : float
        Points are scaled to this length; 0 means that they keep their own.
    reach : float
        The handle lies at this multiple of the point.
    through : bool
        Whether a point on the far side can be caught, too, because nothing hides it.
    """

    names: str | Sequence[str]
    least: int = 0
    most: int = 0
    length: float = 1.0
    reach: float = 1.0
    through: bool = False

    kind = "points"

    def value(self, name: str, given: Any) -> list[Any]:
        """Check one point, shape (3,), or several, shape (n, 3)."""
        return unit_vectors(name, given, 3, self.names, self.least, self.most, self.length)

    def spec(self) -> dict[str, Any]:
        """Describe the handles to the viewer."""
        return {
            "names": self.names,
            "least": self.least,
            "most": self.most,
            "length": self.length,
            "reach": self.reach,
            "through": self.through,
        }

    def controls(self, name: str, start: Any) -> str:
        """Write the buttons that add and remove a point, if their number may change."""
        return add_and_remove(name, "point") if self.most else ""


@dataclass(frozen=True)
class Poses:
    """An orientation, or several, of bodies that are grabbed and turned.

    A value is a unit quaternion, scalar first. The hand changes it continuously, so a whole turn
    leads from a quaternion to its opposite. `place_grip` says where the bodies are.

    Parameters
    ----------
    names : str or sequence of str
        Name of the body, or of each body, for those who cannot see it.
    least, most : int
        How many bodies there may be; 0 means as many as at the start. The buttons *Add* and
        *Remove* change the last one.
    """

    names: str | Sequence[str]
    least: int = 0
    most: int = 0

    kind = "poses"

    def value(self, name: str, given: Any) -> list[Any]:
        """Check one unit quaternion, shape (4,), or several, shape (n, 4)."""
        return unit_vectors(name, given, 4, self.names, self.least, self.most)

    def spec(self) -> dict[str, Any]:
        """Describe the bodies to the viewer."""
        return {"names": self.names, "least": self.least, "most": self.most}

    def controls(self, name: str, start: Any) -> str:
        """Write the buttons that add and remove a body, if their number may change."""
        return add_and_remove(name, "pose") if self.most else ""


@dataclass(frozen=True)
class Switch:
    """Yes or no.

    Parameters
    ----------
    label : str
        What is switched on.
    """

    label: str

    kind = "switch"

    def value(self, name: str, given: Any) -> bool:
        """Check a truth value."""
        if not isinstance(given, (bool, np.bool_)):
            raise ValueError(f"{name}: expected True or False, got {given!r}")
        return bool(given)

    def spec(self) -> dict[str, Any]:
        """Describe the switch to the viewer."""
        return {"label": self.label}

    def controls(self, name: str, start: bool) -> str:
        """Write a check box."""
        checked = " checked" if start else ""
        return (
            f'<label class="explorable-switch"><input type="checkbox" name="{name}"{checked}>'
            f" {written(self.label)}</label>"
        )


@dataclass(frozen=True)
class Choice:
    """One of several words.

    Parameters
    ----------
    label : str
        What is chosen.
    options : sequence of str
        The words.
    """

    label: str
    options: Sequence[str]

    kind = "choice"

    def value(self, name: str, given: Any) -> str:
        """Check a word."""
        if given not in self.options:
            raise ValueError(f"{name}: expected one of {', '.join(self.options)}, got {given!r}")
        return str(given)

    def spec(self) -> dict[str, Any]:
        """Describe the choice to the viewer."""
        return {"options": list(self.options), "label": self.label}

    def controls(self, name: str, start: str) -> str:
        """Write a group of radio buttons."""
        buttons = "".join(
            f'<label><input type="radio" name="{name}" value="{escape(option)}"'
            f"{' checked' if option == start else ''}> {written(option)}</label>"
            for option in self.options
        )
        return (
            f'<fieldset class="explorable-choice"><legend>{written(self.label)}</legend>'
            f"{buttons}</fieldset>"
        )


Input = Slider | Handles | Poses | Switch | Choice
