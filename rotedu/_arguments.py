"""The border: every argument of a public function passes through here, once.

How dtypes are chosen and what happens to arrays of dtype object is stated in `rotedu`.
"""

import math
from reprlib import repr as shortened
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]


Shape = tuple[int | str, ...]


def arrays(**arguments: tuple[Any, *tuple[Shape, ...]]) -> list[Array]:
    """Turn arguments, given as for `shaped`, into finite arrays of one dtype."""
    given = shaped(**arguments)
    for name, array in zip(arguments, given, strict=True):
        require_finite(name, array)
    return given


def shaped(**arguments: tuple[Any, *tuple[Shape, ...]]) -> list[Array]:
    """Turn arguments, given as ``name=(value, shape, ...)``, into arrays of one dtype.

    Each `shape` is one that the trailing axes may have; the leading axes must broadcast. A letter
    stands for any length, the same in all arguments.
    """
    values = {name: value for name, (value, *_) in arguments.items()}
    given = {name: _numbers(name, value) for name, value in values.items()}
    floating = {
        array.dtype
        for name, array in given.items()
        if array.dtype == np.float32 or (array.dtype.kind == "f" and hasattr(values[name], "dtype"))
    }
    dtype = np.dtype(np.float32 if floating == {np.dtype(np.float32)} else np.float64)

    leading = []
    lengths: dict[int | str, int] = {}
    for name, (_, *shapes) in arguments.items():
        array = given[name] = _cast(given[name], dtype)
        known = [tuple(lengths.get(axis, axis) for axis in shape) for shape in shapes]
        split = array.ndim - len(shapes[0])
        matches = [shape for shape in known if split >= 0 and _matches(array.shape[split:], shape)]
        if not matches:
            wanted = " or ".join(map(_shape, known))
            raise ValueError(f"{name} must have shape {wanted}; got shape {array.shape}")
        named = zip(matches[0], array.shape[split:], strict=True)
        lengths |= {axis: length for axis, length in named if isinstance(axis, str)}
        leading.append(array.shape[:split])
    try:
        np.broadcast_shapes(*leading)
    except ValueError:
        names = " and ".join(given)
        got = " and ".join(str(array.shape) for array in given.values())
        raise ValueError(f"{names} must broadcast over their leading axes; got {got}") from None
    return list(given.values())


def require_finite(name: str, array: Array) -> None:
    """Refuse infinities and NaN; objects are taken to have none."""
    # The sum of the squares is found fastest. If it is finite, so is all; if not, it may be too
    # large.
    if array.dtype.char == "O" or math.isfinite(np.vdot(array, array)):
        return
    finite = np.isfinite(array)
    if not finite.all():
        raise ValueError(
            f"{name} must be finite in {array.dtype}; got {array[~finite][0]}{place(~finite)}"
        )


def unit(name: str, vectors: Array) -> Array:
    """Scale vectors to length 1; those of dtype object are taken to have it."""
    if vectors.dtype == object:
        return vectors
    zero = ~vectors.any(axis=-1)
    if zero.any():
        raise ValueError(f"{name} must not be the zero vector; got zeros{place(zero)}")
    return normalised(vectors)


def length(vectors: Array) -> Array:
    """Lengths of vectors, whose squares may overflow or underflow."""
    if vectors.dtype == object:
        return np.asarray(np.sqrt((vectors * vectors).sum(axis=-1)))
    largest = np.abs(vectors).max(axis=-1, keepdims=True)
    scaled = vectors / np.where(largest == 0, 1, largest)
    return np.asarray(largest[..., 0] * np.sqrt((scaled * scaled).sum(axis=-1)))


def normalised(vectors: Array) -> Array:
    """Divide nonzero vectors by their lengths, whose squares may overflow or underflow."""
    scaled: Array = vectors / np.abs(vectors).max(axis=-1, keepdims=True)
    return np.asarray(scaled / np.sqrt((scaled * scaled).sum(axis=-1, keepdims=True)))


def require_rotation(name: str, matrices: Array) -> None:
    """Refuse matrices that are not orthogonal to half of the digits, or that reflect."""
    if matrices.dtype == object:
        return
    allowed = np.sqrt(np.finfo(matrices.dtype).eps)
    with np.errstate(over="ignore", invalid="ignore"):
        error = np.abs(matrices.mT @ matrices - np.eye(3)).max(axis=(-2, -1))
    skewed = ~(error <= allowed)
    if skewed.any():
        raise ValueError(
            f"{name} must be a rotation: M^T M may differ from the identity by {allowed:.1e}, "
            f"but differs by {error[skewed][0]:.1e}{place(skewed)}"
        )
    determinant = np.linalg.det(matrices)
    if (determinant < 0).any():
        raise ValueError(
            f"{name} must be a rotation: it is orthogonal, but its determinant is "
            f"{determinant.min():.6g}, so it reflects{place(determinant < 0)}"
        )


def place(mask: Array | np.bool) -> str:
    """Say where a mask is first true, if there is more than one place to look at."""
    if not np.ndim(mask):
        return ""
    return f" at index {tuple(int(i) for i in np.argwhere(mask)[0])}"


def _numbers(name: str, value: Any) -> Array:
    """Make an array of real numbers, or of objects that calculate but are not numbers."""
    try:
        array = np.asarray(value)
        if array.dtype == object:
            array = _floats_if_numbers(array)
    except (ValueError, OverflowError):
        array = np.empty(0, str)
    if array.dtype.kind not in "iufO":
        raise ValueError(f"{name} must be an array of real numbers; got {shortened(value)}")
    return array


def _floats_if_numbers(objects: Array) -> Array:
    """Tell big integers and fractions, which become floats, from symbols and the like."""
    if any(element is None for element in objects.flat):
        raise ValueError
    try:
        return objects.astype(np.float64)
    except TypeError:
        if all(hasattr(element, "__truediv__") for element in objects.flat):
            return objects
        raise ValueError from None


def _cast(array: Array, dtype: np.dtype[Any]) -> Array:
    if array.dtype in (dtype, object):
        return array
    with np.errstate(over="ignore"):
        return array.astype(dtype)


def _matches(trailing: tuple[int, ...], shape: Shape) -> bool:
    return len(trailing) == len(shape) and all(
        isinstance(axis, str) or axis == length
        for axis, length in zip(shape, trailing, strict=True)
    )


def _shape(trailing: Shape) -> str:
    return f"({', '.join(['...', *map(str, trailing)])})"
