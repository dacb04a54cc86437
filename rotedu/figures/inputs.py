"""What the hand can change in a figure: numbers, points, switches and choices.

Each kind checks the values that enter, describes itself to the viewer and writes its controls.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np

SAME = 1e-12


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
    stride : float
        How far the button *Step* goes; 0 means an eighth of the range.
    plays : float
        Seconds that the button *Play* takes from `low` to `high`, where it starts over; 0 means no
        buttons.
    grip : float
        The number is also an angle in degrees from the x axis of the scene to its y axis: a handle
        on the circle of this radius about the z axis can be dragged; 0 means no handle.
    """

    low: float
    high: float
    label: str = ""
    step: float = 0
    stride: float = 0
    plays: float = 0
    grip: float = 0

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
            "grip": self.grip,
        }

    def controls(self, name: str, start: float) -> str:
        """Write a slider, the same number to type, and buttons if it plays."""
        spec = self.spec()
        bounds = f'min="{self.low:g}" max="{self.high:g}" step="{spec["step"]:g}"'
        label = escape(self.label or name)
        buttons = (
            '<span class="explorable-buttons">'
            f'<button type="button" data-action="play" data-input="{name}">Play</button>'
            f'<button type="button" data-action="step" data-input="{name}">Step</button></span>'
        )
        return (
            f'<div class="explorable-row"><label for="{{id}}-{name}">{label}</label>'
            f'<input type="range" id="{{id}}-{name}" name="{name}" {bounds} value="{start:g}">'
            f'<input type="number" name="{name}-number" aria-label="{label}" {bounds}'
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
    """

    names: str | Sequence[str]
    least: int = 0
    most: int = 0
    length: float = 1.0
    reach: float = 1.0

    kind = "points"

    def value(self, name: str, given: Any) -> list[Any]:
        """Check one point, shape (3,), or several, shape (n, 3)."""
        points = np.asarray(given, float)
        several = not isinstance(self.names, str)
        least, most = (self.least or len(self.names), self.most or len(self.names))
        if points.shape[-1:] != (3,) or points.ndim != 1 + several:
            shape = "(n, 3)" if several else "(3,)"
            raise ValueError(f"{name}: expected shape {shape}, got {points.shape}")
        if several and not least <= len(points) <= most:
            raise ValueError(f"{name}: expected {least} to {most} points, got {len(points)}")
        lengths = np.linalg.norm(points, axis=-1, keepdims=True)
        if not (np.isfinite(lengths) & (lengths > 0)).all():
            raise ValueError(f"{name}: expected finite points other than the origin, got {given}")
        # What has the length already stays exactly as it is.
        wanted = np.where(abs(lengths - self.length) < SAME, lengths, self.length or lengths)
        scaled: list[Any] = (points * (wanted / lengths)).tolist()
        return scaled

    def spec(self) -> dict[str, Any]:
        """Describe the handles to the viewer."""
        return {
            "names": self.names,
            "least": self.least,
            "most": self.most,
            "length": self.length,
            "reach": self.reach,
        }

    def controls(self, name: str, start: Any) -> str:
        """Write the buttons that add and remove a point, if their number may change."""
        if not self.most:
            return ""
        return (
            '<div class="explorable-buttons">'
            f'<button type="button" data-action="add" data-input="{name}">Add a point</button>'
            f'<button type="button" data-action="remove" data-input="{name}">Remove a point'
            "</button></div>"
        )


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
        return {}

    def controls(self, name: str, start: bool) -> str:
        """Write a check box."""
        checked = " checked" if start else ""
        return (
            f'<label class="explorable-switch"><input type="checkbox" name="{name}"{checked}>'
            f" {escape(self.label)}</label>"
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
        return {"options": list(self.options)}

    def controls(self, name: str, start: str) -> str:
        """Write a group of radio buttons."""
        buttons = "".join(
            f'<label><input type="radio" name="{name}" value="{escape(option)}"'
            f"{' checked' if option == start else ''}> {escape(option)}</label>"
            for option in self.options
        )
        return (
            f'<fieldset class="explorable-choice"><legend>{escape(self.label)}</legend>'
            f"{buttons}</fieldset>"
        )


Input = Slider | Handles | Switch | Choice
