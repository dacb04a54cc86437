"""The error for a geometry without an answer."""

__all__ = ["DegenerateError"]


class DegenerateError(ValueError):
    """The arguments are valid, yet the geometry they describe has no answer, or no single one."""
