"""Wrong answers to the exercises of Chapter 1, with words of the hints."""

from typing import Any

WRONG: dict[str, list[tuple[Any, str]]] = {}
