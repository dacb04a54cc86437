"""Cases of a test that make test leaves to the night, because another of their kind is tried."""

from collections.abc import Iterable
from typing import Any

import pytest


def nightly(cases: Iterable[Any], *by_day: Any) -> list[Any]:
    """Mark all cases as slow but those that make test takes."""
    listed = list(cases)
    assert all(case in listed for case in by_day), by_day
    night = pytest.mark.slow
    return [case if case in by_day else pytest.param(case, marks=night) for case in listed]
