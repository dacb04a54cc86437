"""Wrong answers to the exercises of Chapter 5, Points and orientations, with words of the hints."""

from typing import Any

WRONG: dict[str, list[tuple[Any, str]]] = {}
