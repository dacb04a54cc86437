"""Argument checks for public functions.

The annotations of a public function describe its arguments, and its body is its equation::

    @checked
    def double(p: Unit, q: Unit) -> Vector:
        return 2 * dot(p, q) * q - p

`checked` refuses bad input, scales unit vectors to length 1, and moves components to the first
axes, where `rotedu._vectors` expects them. Results have their components on the last axes again.
When one public function calls another, the inner one does not check its arguments again. Helpers
outside the ``__all__`` of a module check nothing. Callbacks from inside, such as a hook for
warnings, must not call a public function.

The package docstring of `rotedu` states how dtypes are chosen and how object arrays are treated.
"""

import operator
from collections.abc import Callable
from contextvars import ContextVar
from dataclasses import dataclass
from functools import wraps
from inspect import signature
from reprlib import repr as shortened
from typing import Annotated, Any, TypeVar, get_args, get_origin, get_type_hints

import numpy as np

from rotedu._vectors import Array

Shape = tuple[int | str, ...]
Preparation = Callable[[str, Array], Array]
Result = TypeVar("Result")

# What an array of dtype object may contain.
NO_REAL_NUMBERS = (type(None), str, bytes, complex, np.complexfloating)

# What is taken for a rotation: no entry of M^T M differs from the identity's by more. Entries with
# four decimals, and those of single precision, differ by less.
ASKEW = 1e-3

# The floating dtype of the arguments while a public function runs, which checks them.
_dtype: ContextVar[np.dtype[Any] | None] = ContextVar("dtype of the arguments", default=None)


def _as_given(name: str, array: Array) -> Array:
    return array


@dataclass(frozen=True)
class Kind:
    """A kind of argument or result."""

    # What the trailing axes may be. A letter is any length, the same in all arguments of a call.
    shapes: tuple[Shape, ...]
    # How many trailing axes the body expects at the front.
    components: int = 0
    # Checks and prepares an array, given the argument's name.
    prepare: Preparation = _as_given

    def inside(self, array: Array, axes: int) -> Array:
        """Move components to the front and add enough axes after them to broadcast."""
        missing = axes - (array.ndim - self.components)
        array = array.reshape((1,) * missing + array.shape)
        return array.transpose(*range(axes, array.ndim), *range(axes))

    def outside(self, result: Any) -> Array:
        """Move components to the last axes again."""
        array = kept(result)
        return array.transpose(*range(self.components, array.ndim), *range(self.components))


def unit_vectors(name: str, vectors: Array) -> Array:
    """Scale vectors to length 1; vectors of dtype object must have that length already."""
    if vectors.dtype == object:
        return vectors
    largest = np.abs(vectors).max(axis=-1, keepdims=True, initial=0)
    if not largest.all():
        zero = largest[..., 0] == 0
        raise ValueError(f"{name} must not be the zero vector; got zeros{place(zero)}")
    # The squares of the vectors themselves may overflow or underflow.
    scaled = vectors / largest
    return np.asarray(scaled / np.sqrt((scaled * scaled).sum(axis=-1, keepdims=True)))


def rotations(name: str, matrices: Array) -> Array:
    """Replace matrices that are rotations to four decimals with the nearest rotations."""
    if matrices.dtype == object:
        return matrices
    with np.errstate(over="ignore", invalid="ignore"):
        square = squares(matrices)
        error = np.abs(square - np.eye(3)).max(axis=(-2, -1), initial=0)
    askew = ~(error <= ASKEW)
    if askew.any():
        raise ValueError(
            f"{name} must be a rotation: M^T M may differ from the identity by {ASKEW:.0e}, but "
            f"differs by {error[askew][0]:.1e}{place(askew)}; "
            "rotedu.orientations.nearest_rotation finds the rotation nearest to a matrix"
        )
    determinant = np.linalg.det(matrices)
    if (determinant < 0).any():
        raise ValueError(
            f"{name} must be a rotation: it is orthogonal, but its determinant is "
            f"{determinant.min():.6g}, so it reflects{place(determinant < 0)}"
        )
    nearest = straightened(matrices, square)
    # One step is enough for half of the digits, and three are for what is coarser.
    coarse = error > 2 * np.sqrt(np.finfo(matrices.dtype).eps)
    if coarse.any():
        for _ in range(2):
            nearest[coarse] = straightened(nearest[coarse], squares(nearest[coarse]))
    return nearest


def squares(matrices: Array) -> Array:
    """M^T M, which is the identity for rotations."""
    return np.asarray(matrices.swapaxes(-1, -2) @ matrices)


def straightened(matrices: Array, square: Array) -> Array:
    """Take a step of Newton's method for the polar decomposition: right digits double."""
    return np.asarray(matrices @ (3 * np.eye(3, dtype=matrices.dtype) - square) / 2)


def at_least(
    number: int, axis: int, prepare: Preparation = _as_given, why: str = ""
) -> Preparation:
    """Return a preparation that first refuses arrays with too few entries along an axis."""

    def counted(name: str, array: Array) -> Array:
        if array.shape[axis] < number:
            got = array.shape[axis]
            raise ValueError(f"{name} must number at least {number}{why}; got {got}")
        return prepare(name, array)

    return counted


def _shares(name: str, weights: Array) -> Array:
    """Scale weights to the sum 1."""
    if weights.dtype == object:
        return weights
    if (weights < 0).any():
        worst = weights[weights < 0][0]
        raise ValueError(f"{name} must not be negative; got {worst}{place(weights < 0)}")
    # The sum of the weights themselves may overflow.
    largest = weights.max(axis=-1, keepdims=True, initial=0)
    if not largest.all():
        raise ValueError(f"{name} must not all be zero; got zeros{place(largest[..., 0] == 0)}")
    scaled = weights / largest
    return np.asarray(scaled / scaled.sum(axis=-1, keepdims=True))


def _from_zero_to_one(name: str, number: Array) -> Array:
    if number.ndim or not 0 <= number <= 1:
        raise ValueError(f"{name} must be one number from 0 to 1; got {number}")
    return number


def _one_not_zero(name: str, number: Array) -> Array:
    if number.ndim:
        raise ValueError(f"{name} must be one number; got shape {number.shape}")
    return _not_zero(name, number)


def _three_at_the_end(name: str, numbers: Array) -> Array:
    if numbers.ndim and numbers.shape[-1] != 3:
        raise ValueError(f"{name} must have shape () or (..., 3); got shape {numbers.shape}")
    return numbers


def _not_zero(name: str, numbers: Array) -> Array:
    if numbers.dtype != object and (numbers == 0).any():
        raise ValueError(f"{name} must not be zero; got 0{place(numbers == 0)}")
    return numbers


def _rotation_part(name: str, matrices: Array) -> Array:
    if matrices.shape[-1] == 3:
        return rotations(name, matrices)
    rest = matrices - np.eye(4, dtype=matrices.dtype)
    rest[..., :3, :3] = 0
    if rest.any():
        raise ValueError(
            f"{name} must be a rotation: its fourth row and column must be those of the identity, "
            f"but differ by {np.abs(rest).max():.1e}{place(rest.any(axis=(-2, -1)))}"
        )
    return rotations(name, matrices[..., :3, :3])


def _poses(name: str, matrices: Array) -> Array:
    if matrices.dtype == object:
        return matrices
    askew = (matrices[..., 3, :] != (0, 0, 0, 1)).any(axis=-1)
    if askew.any():
        raise ValueError(
            f"{name} must be a rigid motion: its fourth row must be 0, 0, 0, 1, but is"
            f" {', '.join(f'{x:.6g}' for x in matrices[askew][0, 3])}{place(askew)}"
        )
    poses = matrices.copy()
    poses[..., :3, :3] = rotations(f"the upper left part of {name}", matrices[..., :3, :3])
    return poses


NUMBER = Kind(((),))
VECTOR = Kind((("d",),), 1)
VECTOR3 = Kind(((3,),), 1)
UNIT = Kind((("d",),), 1, prepare=unit_vectors)
MATRIX = Kind(((3, 3), (4, 4)), 2)
TO_CLOSE = " to make a closed curve"

# The annotations of public functions. Numbers have the type Any, because a default is no array.
Number = Annotated[Any, NUMBER]
Fraction = Annotated[Any, Kind(((),), prepare=_from_zero_to_one)]
Step = Annotated[Any, Kind(((),), prepare=_one_not_zero)]
NotZero = Annotated[Array, Kind(((),), prepare=_not_zero)]
OneOrThree = Annotated[Array, Kind(((),), prepare=_three_at_the_end)]
Vector = Annotated[Array, VECTOR]
Vector3 = Annotated[Array, VECTOR3]
Unit = Annotated[Array, UNIT]
Unit3 = Annotated[Array, Kind(((3,),), 1, prepare=unit_vectors)]
Unit4 = Annotated[Array, Kind(((4,),), 1, prepare=unit_vectors)]
Five = Annotated[Array, Kind(((5,),), 1)]
Matrix = Annotated[Array, MATRIX]
HomogeneousMatrix = Annotated[Array, Kind(((4, 4),), 2)]
Matrix3 = Annotated[Array, Kind(((3, 3),), 2)]
Rotation = Annotated[Array, Kind(((3, 3),), 2, prepare=rotations)]
RotationOrPose = Annotated[Array, Kind(((3, 3), (4, 4)), 2, prepare=_rotation_part)]
Pose = Annotated[Array, Kind(((4, 4),), 2, prepare=_poses)]
Poses = Annotated[Array, Kind((("n", 4, 4),), 2, at_least(1, -3, _poses))]
Control = Annotated[Array, Kind((("m", "d"),), 2, at_least(1, -2, unit_vectors))]
ClosedPoints = Annotated[Array, Kind((("n", "d"),), 1, at_least(3, -2, unit_vectors, TO_CLOSE))]
ClosedValues = Annotated[Array, Kind((("n", "d"),), 1, at_least(3, -2, why=TO_CLOSE))]
ClosedRotations = Annotated[Array, Kind((("n", 3, 3),), 2, at_least(3, -3, rotations, TO_CLOSE))]
Motion = Annotated[Array, Kind((("n", 3, 3),), 2, at_least(2, -3, rotations))]
# The axis of what a body goes through one after another comes first.
Vectors = Annotated[Array, Kind((("n", 3),), 2)]
Matrices = Annotated[Array, Kind((("n", 3, 3),), 3)]
Quaternions = Annotated[Array, Kind((("n", 4),), 2)]
Rotations = Annotated[Array, Kind((("n", 3, 3),), 2, at_least(1, -3, rotations))]
Weights = Annotated[Any, Kind((("n",),), prepare=_shares)]
Count = Annotated[int, "a positive integer"]


def checked(function: Callable[..., Result]) -> Callable[..., Result]:
    """Check a public function's arguments, and move components to where its body expects them."""
    hints = get_type_hints(function, include_extras=True)
    outside = _outside(hints.pop("return"))
    kinds = {name: kind for name, hint in hints.items() if (kind := _kind(hint))}
    counts = [name for name, hint in hints.items() if hint == Count]
    parameters = signature(function)
    optional = {name for name in kinds if parameters.parameters[name].default is None}

    @wraps(function)
    def border(*args: Any, **kwargs: Any) -> Any:
        if _dtype.get() is not None:
            return function(*args, **kwargs)
        try:
            given = parameters.bind(*args, **kwargs)
        except TypeError:
            # Python's own message names the function.
            return function(*args, **kwargs)
        given.apply_defaults()
        values = given.arguments
        left_out = {name for name in optional if values[name] is None}
        arrays = prepared({n: (values[n], kind) for n, kind in kinds.items() if n not in left_out})
        values |= arrays
        for name in counts:
            values[name] = positive_integer(name, values[name])
        floating = (array.dtype for array in arrays.values() if array.dtype.kind != "O")
        inside = _dtype.set(next(floating, np.dtype(np.float64)))
        try:
            return outside(function(**values))
        finally:
            _dtype.reset(inside)

    return border


def prepared(arguments: dict[str, tuple[Any, Kind]]) -> dict[str, Array]:
    """Turn arguments into finite arrays of one dtype, check them, and put components first."""
    arrays = _of_one_dtype({name: value for name, (value, _) in arguments.items()})
    lengths: dict[int | str, int] = {}
    leading = []
    axes = 0
    for name, (_, kind) in arguments.items():
        array = arrays[name]
        shape = _matching(name, array, kind.shapes, lengths)
        leading.append(array.shape[: array.ndim - len(shape)])
        _require_finite(name, array)
        arrays[name] = array = kind.prepare(name, array)
        axes = max(axes, array.ndim - kind.components)
    require_broadcasting(leading, {name: value for name, (value, _) in arguments.items()})
    return {name: kind.inside(arrays[name], axes) for name, (_, kind) in arguments.items()}


def kept(result: Any) -> Array:
    """Return a result as an array with the dtype of the arguments.

    In NumPy 1 a single float32 times a Python number is a float64.
    """
    array, dtype = np.asarray(result), _dtype.get()
    return array if dtype is None else _cast(array, dtype)


def rounding(numbers: Array) -> float:
    """Relative rounding error of numbers computed from the arguments; zero for objects."""
    return 0.0 if np.asarray(numbers).dtype.kind == "O" else float(np.finfo(_dtype.get()).eps)


def positive_integer(name: str, value: Any) -> int:
    """Return an argument as an integer, or refuse it if it is not a positive integer."""
    try:
        count = operator.index(value)
    except TypeError:
        count = 0
    if count < 1:
        raise ValueError(f"{name} must be a positive integer; got {value!r}")
    return count


def place(mask: Any) -> str:
    """Describe the first place where a mask is true, unless there is only one place."""
    if not np.ndim(mask):
        return ""
    return f" at index {tuple(int(i) for i in np.argwhere(mask)[0])}"


def named(pair: str, mask: Any, sequence: str = "") -> str:
    """Name a pair by the first place where a mask is true.

    In `pair`, {h}, {i} and {j} stand for three neighbours in the argument named by `sequence`.
    """
    if not sequence:
        return pair + place(mask)
    *leading, i = (int(k) for k in np.argwhere(mask)[0])
    n = mask.shape[-1]
    places = [", ".join(map(str, [*leading, k % n])) for k in (i - 1, i, i + 1)]
    names = (f"{sequence}[{at}]" for at in places)
    return pair.format(**dict(zip("hij", names, strict=True)))


def _kind(hint: Any) -> Kind | None:
    return next((kind for kind in get_args(hint) if isinstance(kind, Kind)), None)


def _outside(hint: Any) -> Callable[[Any], Any]:
    """Return a function that moves the components of each result to the last axes."""
    if get_origin(hint) is tuple:
        several = tuple(map(_outside, get_args(hint)))
        return lambda result: tuple(f(part) for f, part in zip(several, result, strict=True))
    if get_origin(hint) is list:
        (each,) = map(_outside, get_args(hint))
        return lambda result: list(map(each, result))
    kind = _kind(hint)
    return kind.outside if kind else lambda result: result


def _matching(
    name: str, array: Array, shapes: tuple[Shape, ...], lengths: dict[int | str, int]
) -> Shape:
    """Find the shape that the trailing axes match, and record the length of each letter in it."""
    for shape in shapes:
        trailing = array.shape[max(0, array.ndim - len(shape)) :]
        pairs = [(lengths.get(axis, axis), n) for axis, n in zip(shape, trailing, strict=False)]
        if len(pairs) == len(shape) and all(isinstance(a, str) or a == n for a, n in pairs):
            lengths.update(zip(shape, trailing, strict=True))
            return shape
    known = (", ".join(["...", *(str(lengths.get(a, a)) for a in shape)]) for shape in shapes)
    wanted_shapes = " or ".join(f"({axes})" for axes in known)
    raise ValueError(f"{name} must have shape {wanted_shapes}; got shape {array.shape}")


def require_broadcasting(leading: list[tuple[int, ...]], arguments: dict[str, Any]) -> None:
    """Refuse leading axes that do not broadcast."""
    try:
        np.broadcast_shapes(*leading)
    except ValueError:
        names = " and ".join(arguments)
        got = " and ".join(str(np.shape(value)) for value in arguments.values())
        raise ValueError(f"{names} must broadcast over their leading axes; got {got}") from None


def _require_finite(name: str, array: Array) -> None:
    """Refuse infinities and NaN, except in object arrays."""
    if array.dtype.kind == "O":
        return
    finite = np.isfinite(array)
    if not finite.all():
        raise ValueError(
            f"{name} must be finite in {array.dtype}; got {array[~finite][0]}{place(~finite)}"
        )


def _of_one_dtype(values: dict[str, Any]) -> dict[str, Array]:
    """Make arrays of one dtype.

    The dtype is float32 if an argument is float32 and no array has another floating type.
    """
    arrays = {name: _numbers(name, value) for name, value in values.items()}
    single = double = False
    for name, array in arrays.items():
        if array.dtype.char == "f":
            single = True
        elif array.dtype.kind == "f" and hasattr(values[name], "dtype"):
            double = True
    dtype = np.dtype(np.float32 if single and not double else np.float64)
    return {name: _cast(array, dtype) for name, array in arrays.items()}


def _numbers(name: str, value: Any) -> Array:
    """Make an array of real numbers, or of objects that support arithmetic but are not numbers."""
    try:
        array = np.asarray(value)
        if array.dtype.kind == "O":
            array = _floats_if_numbers(array)
    except (ValueError, OverflowError):
        array = np.empty(0, str)
    if array.dtype.kind not in "iufO":
        raise ValueError(f"{name} must be an array of real numbers; got {shortened(value)}")
    return array


def _floats_if_numbers(objects: Array) -> Array:
    """Convert big integers and fractions to floats, but leave symbols and the like alone."""
    if any(isinstance(element, NO_REAL_NUMBERS) for element in objects.flat):
        raise ValueError
    try:
        return objects.astype(np.float64)
    except TypeError:
        if all(hasattr(element, "__truediv__") for element in objects.flat):
            return objects
        raise ValueError from None


def _cast(array: Array, dtype: np.dtype[Any]) -> Array:
    if array.dtype.kind == "O":
        return array
    with np.errstate(over="ignore"):
        return array.astype(dtype, copy=False)
