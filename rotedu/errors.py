"""The errors of this package that are not plain `ValueError`."""

__all__ = ["DegenerateError"]


class DegenerateError(ValueError):
    """The arguments are valid, yet the geometry they describe has no answer, or no unique one."""
