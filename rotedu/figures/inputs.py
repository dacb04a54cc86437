"""What the hand can change in a figure: numbers, points, orientations, switches and choices.

Each kind has a value at the start, checks the values that enter and describes itself to the viewer,
which writes its controls. In all words of a panel, a quantity stands between asterisks: ``*t*``.
"""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any, ClassVar

import numpy as np

SAME = 1e-12


def numbers(name: str, given: Any) -> Any:
    """Turn what is given into an array of numbers."""
    try:
        return np.asarray(given, float)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: expected numbers, got {given!r}") from None


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
    vectors = numbers(name, given)
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
    # Vectors that already have the length are left exactly as they are.
    wanted = np.where(abs(lengths - length) < SAME, lengths, length or lengths)
    scaled: list[Any] = (vectors * (wanted / lengths)).tolist()
    return scaled


@dataclass(frozen=True)
class Kind:
    """What all kinds have: a value at the ``start``."""

    start: Any = field(kw_only=True)

    kind: ClassVar[str]

    def spec(self) -> dict[str, Any]:
        """Describe the input to the viewer."""
        told = asdict(self)
        del told["start"]
        return {"kind": self.kind} | told


@dataclass(frozen=True)
class Slider(Kind):
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
        Whether the slider is shown. Without a row the number is changed at its grip, in a
        chart, or by a link to a state.
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
        number = numbers(name, given)
        if number.ndim or not self.low <= number <= self.high:
            raise ValueError(f"{name}: expected {self.low:g} to {self.high:g}, got {given}")
        return float(number)

    def spec(self) -> dict[str, Any]:
        """Describe the slider to the viewer."""
        width = self.high - self.low
        steps = {"step": self.step or width / 200, "stride": self.stride or width / 8}
        return super().spec() | steps


@dataclass(frozen=True)
class Handles(Kind):
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


@dataclass(frozen=True)
class Poses(Kind):
    """An orientation, or several, of bodies that are grabbed and turned.

    A value is a unit quaternion, scalar first. The hand changes it continuously, so a whole turn
    leads from a quaternion to its opposite. A grip says where the bodies are.

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


@dataclass(frozen=True)
class Switch(Kind):
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


@dataclass(frozen=True)
class Choice(Kind):
    """One of several options.

    Parameters
    ----------
    label : str
        What is chosen.
    words : sequence of str
        The options in words, which may mark quantities; their values are without marks.
    """

    label: str
    words: Sequence[str]

    kind = "choice"

    @property
    def options(self) -> list[str]:
        """Return what can be chosen, as values."""
        return [words.replace("*", "") for words in self.words]

    def value(self, name: str, given: Any) -> str:
        """Check a word."""
        if given not in self.options:
            raise ValueError(f"{name}: expected one of {', '.join(self.options)}, got {given!r}")
        return str(given)

    def spec(self) -> dict[str, Any]:
        """Describe the choice to the viewer."""
        return super().spec() | {"options": self.options}


Input = Slider | Handles | Poses | Switch | Choice
