"""What functions do with their arguments: shapes, dtypes, counting, and, of all, bad input."""

from fractions import Fraction
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.spatial.transform import Rotation
from spheres import E1, E2, E3, HERE, PAIRS, RNG, UNEVEN, close, on_the_sphere

import rotedu
from rotedu import _arguments as arguments
from rotedu.arcs import slerp, slerp_by_rotation
from rotedu.closed_curve import closed_curve
from rotedu.control_points import double
from rotedu.cost import OperationCount, count
from rotedu.errors import DegenerateError
from rotedu.general_rotation import perspective
from rotedu.ordinary_rotation import axis_angle, rotate, rotation_matrix
from rotedu.orientation_curves import closed_rotation_curve
from rotedu.quaternions import Quaternion
from rotedu.rigid_motion import DualQuaternion

# The warnings about unstable curves have tests of their own.
pytestmark = pytest.mark.filterwarnings("ignore:.* are almost .*:UserWarning")


NOT_CHECKED = "_arguments", "_vectors", "colors", "cost", "errors"
MODULES = [
    import_module(f"rotedu.{module.name}")
    for module in iter_modules(rotedu.__path__)
    if not module.ispkg and module.name not in NOT_CHECKED
]
PUBLIC = {name: getattr(module, name) for module in MODULES for name in module.__all__}
METHODS = {
    "DualQuaternion.from_matrix": DualQuaternion.from_matrix,
    "from_axis_angle": Quaternion.from_axis_angle,
    "from_matrix": Quaternion.from_matrix,
    "Quaternion.rotate": Quaternion(np.float32(1), np.ones(3, "f4")).rotate,
}
FUNCTIONS = PUBLIC | METHODS
TURN, THREE = {"matrix": np.eye(3)}, np.stack([np.eye(3)] * 3)
TWO = {"r1": np.eye(3), "r2": np.eye(3)}
PAIR = {"p": E1, "q": [0, 0.6, 0.8]}
EULER = {"u": 1, "v": 1, "w": 1}
POSE = {"matrix": np.array([[0.8, -0.6, 0, 0.1], [0.6, 0.8, 0, 0.2], [0, 0, 1, 0.3], [0, 0, 0, 1]])}
MOTIONS = {"m1": np.eye(4), "m2": POSE["matrix"], "t": 0.5}
BONES = {"matrices": np.stack([np.eye(4), POSE["matrix"]]), "weights": [0.25, 0.75]}
ANGLE, VECTOR = {"angle": 1}, {"v": [1, 2, 3]}
CURVE = {"points": np.eye(3), "fraction": 0.5}
BEZIER = {"control": np.eye(3), "u": 0.5}
# Good arguments of every public function.
GOOD: dict[str, dict[str, Any]] = {
    "Quaternion": {"w": 1, "v": [1, 2, 3]},
    "from_axis_angle": {"axis": E1, "angle": 1},
    "Quaternion.rotate": {"points": [1, 2, 3]},
    "rotate_about_u": {"points": [1, 2, 3], "angle": 1},
    "rotate": {"points": [1, 2, 3], "axis": E3, "angle": 1},
    "rotation_matrix": {"axis": E3, "angle": 1},
    "transform": TURN | {"points": [1, 2, 3]},
    **dict.fromkeys(["from_matrix", "axis_angle", "sixteen_products", "euler_angles"], TURN),
    **dict.fromkeys(["homogeneous", "nearest_rotation", "rotation_vector"], TURN),
    **dict.fromkeys(["rotation_u", "rotation_v", "rotation_w"], ANGLE),
    **dict.fromkeys(["matrix_from_euler_angles", "quaternion_from_euler_angles"], EULER),
    "axis_angle_from_euler_angles": EULER,
    **dict.fromkeys(["translation", "matrix_from_rotation_vector"], VECTOR),
    "scaling": {"s": [1, 2, 3]},
    "shearing": {"uv": 1, "uw": 1, "vu": 1, "vw": 1, "wu": 1, "wv": 1},
    "reflection": {"normal": [0, 0.6, 0.8]},
    "perspective": {"distance": 1},
    **dict.fromkeys(["angle_between", "arc_axis", "double", "double_by_rotation"], PAIR),
    **dict.fromkeys(["bisect", "bisect_by_rotation"], PAIR),
    **dict.fromkeys(["slerp", "slerp_by_rotation", "nlerp"], PAIR | {"t": 0.5}),
    **dict.fromkeys(["control_points", "closed_curve"], CURVE),
    **dict.fromkeys(["de_casteljau", "de_casteljau_levels"], BEZIER),
    "slerp_rotations": TWO | {"t": 0.5},
    "closed_rotation_curve": {"rotations": THREE, "fraction": 0.5},
    "squad": {"quaternions": np.eye(4)},
    "periodic_spline": {"values": np.eye(3)},
    "angular_velocity": {"rotations": THREE, "dt": 0.1},
    "integrate": {"rotation": np.eye(3), "velocities": np.eye(3), "dt": 0.1},
    "matrix_steps": TURN | {"velocities": np.eye(3), "dt": 0.1},
    "quaternion_steps": {"q": np.eye(4)[0], "velocities": np.eye(3), "dt": 0.1},
    "look_at": {"direction": E1, "up": [0, 0.6, 0.8]},
    "mean_rotation": {"rotations": THREE, "weights": [1, 2, 3]},
    **dict.fromkeys(["angular_distance", "chordal_distance"], TWO),
    "rotation_between": {"a": E1, "b": [0, 0.6, 0.8], "axis": E3},
    "swing_twist": TURN | {"axis": E3},
    "DualQuaternion.from_matrix": POSE,
    "screw": POSE,
    **dict.fromkeys(["screw_motion", "straight_motion"], MOTIONS),
    **dict.fromkeys(["blend_matrices", "blend_dual_quaternions"], BONES),
    "matrix_from_two_columns": {"a": E1, "b": [0, 0.6, 0.8]},
    "five_numbers": {"rotation": np.eye(3)},
    "matrix_from_five_numbers": {"numbers": [0, 0, 0, 1 + 2**0.5, 0]},
}
NEED_LAPACK = {"nearest_rotation", "mean_rotation", "periodic_spline"}
ARGUMENTS = [(f, name) for f, arguments in GOOD.items() for name in arguments]
OPTIONAL = [("mean_rotation", "weights"), ("rotation_between", "axis")]
# Arguments whose length has no meaning, or which must be points of the sphere.
DIRECTIONS = [
    (f, name)
    for f, name in ARGUMENTS
    if name in ("p", "q", "a", "b", "axis", "normal", "control", "direction", "up")
    or f in ("control_points", "closed_curve", "squad")
    if name != "fraction"
]
NOT_NUMBERS: list[Any] = ["text", None, True, {}, ["1", "2", "3"], [[1], [2, 3]], [1j, 0, 0]]
NOT_NUMBERS += [[None, 1, 2], [None, None, 1j], [{}, {}, {}], [True, False, True], [10**400, 0, 0]]
NOT_NUMBERS += [np.array(["2020"], "M8[D]"), *(np.array([x, 0, 0], object) for x in ("1", 1j))]


def results(f: str, **arguments: Any) -> tuple[Any, ...]:
    """The parts of a function's result for good arguments, or for others in their place."""
    result = FUNCTIONS[f](**GOOD[f] | arguments)
    if isinstance(result, Quaternion):
        result = result.components
    if isinstance(result, DualQuaternion):
        result = result.real.components, result.dual.components
    return tuple(map(np.asarray, result if isinstance(result, tuple | list) else (result,)))


def refusal(f: str, **bad: Any) -> str:
    """What a function says about bad arguments."""
    try:
        results(f, **bad)
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return f"{f} takes {bad}"


class TestShapes:
    @pytest.mark.parametrize(
        ("f", "name"), [case for case in ARGUMENTS if case[1] not in ("fraction", "dt")]
    )
    def test_a_leading_axis_is_a_loop(self, f: str, name: str) -> None:
        good = np.asarray(GOOD[f][name], float)
        other = np.roll(good, 1, axis=-1) if good.ndim else good + 0.25
        if good.shape[-2:] == (4, 4):
            other = np.concatenate([np.roll(good[..., :3], 1, axis=-1), good[..., 3:] / 2], -1)
            other[..., 3, 3] = 1
        several = np.array([good, other, other])
        none = results(f, **{name: several[:0]})
        assert [part.shape for part in none] == [(0, *part.shape) for part in results(f)]
        loop = zip(*(results(f, **{name: one}) for one in several), strict=True)
        for found, expected in zip(results(f, **{name: several}), loop, strict=True):
            close(found, expected)

    @pytest.mark.parametrize(
        ("p", "q", "t"), [((3,), (7, 3), ()), ((7, 3), (2, 1, 1, 3), (5, 1)), ((0, 3), (3,), ())]
    )
    def test_broadcasting_is_a_loop(self, p: Any, q: Any, t: Any) -> None:
        p, q, t = RNG.normal(size=p), RNG.normal(size=q), RNG.uniform(size=t)
        loop = np.vectorize(slerp, [float], signature="(d),(d),()->(d)")
        close(slerp(p, q, t), loop(p, q, t), 1e-15)

    @pytest.mark.parametrize("f", GOOD)
    def test_results_share_no_memory_with_arguments(self, f: str) -> None:
        given = {name: np.array(value, float) for name, value in GOOD[f].items()}
        shared = [np.shares_memory(p, x) for p in results(f, **given) for x in given.values()]
        assert not any(shared)

    def test_sequences_integers_and_views(self) -> None:
        expected = rotate(np.array([1.0, 2, 3]), np.array([0.0, 0, 1]), 2.0)
        for r, n in [
            ([1, 2, 3], (0, 0, 1)),
            (np.array([1, 2, 3], np.int8), (0, 0, Fraction(1, 3))),
            (np.array([3, 0, 2, 0, 1.0])[::-2], [0, 0, 10**30]),
        ]:
            close(rotate(r, n, 2), expected, 0)


class TestSinglePrecision:
    @pytest.mark.parametrize("f", GOOD)
    def test_is_kept_and_gives_way_to_double(self, f: str) -> None:
        def dtypes(**arguments: Any) -> set[Any]:
            return {x.dtype for x in results(f, **arguments)}

        single = {name: np.asarray(value, np.float32) for name, value in GOOD[f].items()}
        plain = {name: np.asarray(value).tolist() for name, value in GOOD[f].items()}
        for name in single:
            assert dtypes(**plain | {name: single[name]}) == {np.dtype(np.float32)}
            assert dtypes(**single | {name: single[name].astype(float)}) == {np.dtype(np.float64)}

    @pytest.mark.parametrize("dtype", [np.float16, np.longdouble, ">f8"])
    def test_gives_way_to_every_other_type(self, dtype: Any) -> None:
        found = double(np.array(E1, dtype), E2.astype(np.float32))
        assert found.dtype == np.float64

    def test_is_right_to_its_digits(self) -> None:
        curve = closed_curve(UNEVEN.astype(np.float32))
        close(curve, closed_curve(UNEVEN), 2e-6)
        on_the_sphere(curve, 5e-7)
        matrices = rotation_matrix([1, 2, 2], np.arange(5) * 2 * np.pi / 5)
        single = closed_rotation_curve(matrices.astype(np.float32), 5)
        close(single, closed_rotation_curve(matrices, 5), 3e-6)

    def test_antipodal_to_half_of_its_digits(self) -> None:
        p, q = np.float32([[1, 0, 0], [-1, 1e-4, 0]])
        with pytest.raises(DegenerateError):
            slerp(p, q, 0.5)
        slerp(p.astype(float), q, 0.5)


class TestCounts:
    def test_of_the_code(self) -> None:
        assert count(double, E1, HERE) == OperationCount(7, 5)
        plain, turned = count(slerp, E1, HERE, 0.3), count(slerp_by_rotation, E1, HERE, 0.3)
        assert plain.multiplications < turned.multiplications
        assert plain.additions < turned.additions

    @pytest.mark.parametrize("f", GOOD.keys() - NEED_LAPACK)
    def test_results_are_those_of_the_floats(self, f: str) -> None:
        found: list[Any] = []

        def compute(*values: Any) -> None:
            found.extend(results(f, **dict(zip(GOOD[f], values, strict=True))))

        count(compute, *(np.asarray(value, float) for value in GOOD[f].values()))
        for counted, expected in zip(found, results(f), strict=True):
            value = np.vectorize(lambda x: getattr(x, "value", x), otypes=[float])(counted)
            close(value, expected, 3e-7 if expected.dtype == np.float32 else 1e-15)

    def test_out_and_back_costs_as_much_as_other_ways(self) -> None:
        """Here a_i is P_i: angles are zero, and arrays of floats are clipped."""
        out_and_back = np.array([E1, UNEVEN[1], E1, UNEVEN[2]]) * (1 + 1e-15)
        with np.errstate(invalid="ignore"):
            found = count(lambda p: closed_curve(p, 2), out_and_back)
        assert found == count(lambda p: closed_curve(p, 2), UNEVEN[:4])


ASKEW = "must be a rotation: M^T M may differ from the identity by 1e-03, but differs by"
EXACT = Rotation.random(102, rng=np.random.default_rng(39)).as_matrix()
COARSE = {
    "single precision": EXACT.astype(np.float32).astype(float),
    "almost too coarse": (1 + 4.9e-4) * EXACT,
    "one that is coarse": np.concatenate([EXACT[:-1], EXACT[-1:].round(4)]),
    **{f"{n} decimals": EXACT.round(n) for n in (4, 5, 6, 7, 8, 12)},
}
TAKE_ROTATIONS = [
    (f, name)
    for f, name in ARGUMENTS
    if name in ("matrix", "r1", "r2", "rotation", "rotations")
    and f not in ("transform", "homogeneous", "nearest_rotation", "matrix_steps")
    and "rigid_motion" not in FUNCTIONS[f].__module__
]


class TestCoarseRotations:
    """Matrices that have been in single precision, or in a text with few decimals."""

    @pytest.mark.parametrize(("f", "name"), TAKE_ROTATIONS)
    def test_every_function_takes_the_nearest(self, f: str, name: str) -> None:
        twice = 2 * np.asarray(GOOD[f][name])
        assert refusal(f, **{name: twice}).startswith(f"ValueError: {name} {ASKEW} 3.0e+00")
        shape = (-1, *np.shape(GOOD[f][name]))
        for coarse, given in COARSE.items():
            u, _, vt = np.linalg.svd(given)
            of_given, of_nearest = (results(f, **{name: m.reshape(shape)}) for m in (given, u @ vt))
            for found, expected in zip(of_given, of_nearest, strict=True):
                close(found, expected, 1e-10, coarse)

    @pytest.mark.parametrize("coarse", COARSE)
    def test_what_comes_out_is_as_near_as_what_came_in(self, coarse: str) -> None:
        given = COARSE[coarse]
        found = Quaternion.from_matrix(given).matrix()
        angle = Rotation.from_matrix(EXACT.swapaxes(1, 2) @ found).magnitude()
        came_in = np.linalg.norm(given - EXACT, axis=(1, 2))
        assert (angle <= 1.001 * came_in / np.sqrt(2) + 4e-15).all()
        u, _, vt = np.linalg.svd(given)
        close(arguments.rotations("m", given), u @ vt, 1e-14)
        one_by_one = [Quaternion.from_matrix(m).components for m in given[-50:]]
        close(one_by_one, Quaternion.from_matrix(given).components[-50:], 0)

    def test_within_half_of_the_digits_no_bit_changes(self) -> None:
        given = EXACT.round(9)
        one_step = given @ (3 * np.eye(3) - given.swapaxes(1, 2) @ given) / 2
        close(arguments.rotations("m", given), one_step, 0)

    def test_only_what_is_beyond_is_refused(self) -> None:
        for dtype in (np.float32, np.float64):
            axis_angle(((1 + 4.9e-4) * EXACT[0]).astype(dtype))
            found = refusal("axis_angle", matrix=((1 + 5.1e-4) * EXACT[0]).astype(dtype))
            assert found.startswith(f"ValueError: matrix {ASKEW} 1.0e-03; rotedu.orientations.near")


class TestListings:
    """What a page shows with `source` is the function that it calls, without its checks."""

    def test_every_public_function_is_checked_by_its_annotations(self) -> None:
        plain = {name for name, f in PUBLIC.items() if not hasattr(f, "__wrapped__")}
        assert plain == {"Quaternion", "DualQuaternion", "compose"}

    def test_what_was_checked_is_not_checked_again(self, monkeypatch: pytest.MonkeyPatch) -> None:
        seen = []
        check = arguments.prepared
        monkeypatch.setattr(
            arguments, "prepared", lambda given: seen.append(list(given)) or check(given)
        )
        closed_curve(UNEVEN, 2)
        slerp_by_rotation(E1, E2, 0.5)
        assert seen == [["points", "fraction"], ["p", "q", "t"]]

    def test_after_an_error_arguments_are_checked_again(self) -> None:
        with pytest.raises(DegenerateError):
            slerp(E1, -E1, 0.5)
        with pytest.raises(ValueError, match=r"^p must not be the zero vector"):
            slerp([0, 0, 0], E1, 0.5)


# What takes the place of good arguments, and what is said about it.
CLOSED = {
    "control_points": "points",
    "closed_curve": "points",
    "closed_rotation_curve": "rotations",
    "squad": "quaternions",
    "periodic_spline": "values",
}
OF_ANY_DIMENSION = {"de_casteljau", "de_casteljau_levels", *CLOSED} - {"closed_rotation_curve"}
MIRROR, NEARLY, MOVED = -np.eye(3), np.diag([1 - 1e-9, 1, 1]), np.eye(4) + np.diag([5], 3)
NEAREST = "rotedu.orientations.nearest_rotation finds the rotation nearest to a matrix"
NO_ROTATION = "must be a rotation: it is orthogonal, but its determinant is -1, so it reflects"
BAD: list[tuple[str, dict[str, Any], str]] = [
    ("slerp", {"q": [1, 0]}, "q must have shape (..., 3); got shape (2,)"),
    ("slerp", {"p": 1}, "p must have shape (..., d); got shape ()"),
    ("slerp", {"p": [0, np.nan, np.inf]}, "p must be finite in float64; got nan at index (1,)"),
    (
        "slerp",
        {"p": PAIRS[0, :4], "q": PAIRS[1, :5]},
        "p and q and t must broadcast over their leading axes; got (4, 3) and (5, 3) and ()",
    ),
    # Objects are not exempt from the check of shapes.
    ("rotate", {"axis": sp.symbols("x y")}, "axis must have shape (..., 3); got shape (2,)"),
    (
        "rotation_matrix",
        {"axis": [E3, 0 * E3]},
        "axis must not be the zero vector; got zeros at index (1,)",
    ),
    (
        "transform",
        {"matrix": np.ones((3, 4))},
        "matrix must have shape (..., 3, 3) or (..., 4, 4); got shape (3, 4)",
    ),
    ("scaling", {"s": np.ones((2, 4))}, "s must have shape () or (..., 3); got shape (2, 4)"),
    ("perspective", {"distance": [1, 0]}, "distance must not be zero; got 0 at index (1,)"),
    (
        "de_casteljau",
        {"control": THREE, "u": [1, 2]},
        "control and u must broadcast over their leading axes; got (3, 3, 3) and (2,)",
    ),
    ("de_casteljau", {"control": np.empty((0, 3))}, "control must number at least 1; got 0"),
    (
        "closed_curve",
        {"points": np.empty((3, 0))},
        "points must not be the zero vector; got zeros at index (0,)",
    ),
    ("closed_curve", {"points": E1}, "points must have shape (..., n, d); got shape (3,)"),
    ("axis_angle", {"matrix": np.full((3, 3), 1e200)}, f"matrix {ASKEW} inf; {NEAREST}"),
    ("slerp_rotations", {"r1": np.eye(4)}, "r1 must have shape (..., 3, 3); got shape (4, 4)"),
    ("slerp_rotations", {"r2": MIRROR}, f"r2 {NO_ROTATION}"),
    (
        "closed_rotation_curve",
        {"rotations": np.eye(3)},
        "rotations must have shape (..., n, 3, 3); got shape (3, 3)",
    ),
    (
        "closed_rotation_curve",
        {"rotations": np.eye(3) * [[[1]], [[2]], [[3]]]},
        f"rotations {ASKEW} 3.0e+00 at index (1,); {NEAREST}",
    ),
    (
        "closed_rotation_curve",
        {"rotations": [NEARLY, MIRROR, NEARLY]},
        f"rotations {NO_ROTATION} at index (1,)",
    ),
    (
        "euler_angles",
        {"matrix": [np.eye(4), np.eye(4), MOVED]},
        "matrix must be a rotation: its fourth row and column must be those of the identity, "
        "but differ by 5.0e+00 at index (2,)",
    ),
    (
        "screw",
        {"matrix": MOVED.T},
        "matrix must be a rigid motion: its fourth row must be 0, 0, 0, 1, but is 5, 0, 0, 1",
    ),
    (
        "screw",
        {"matrix": np.diag([2, 2, 2, 1])},
        f"the upper left part of matrix {ASKEW} 3.0e+00; {NEAREST}",
    ),
    ("angular_velocity", {"rotations": THREE[:1]}, "rotations must number at least 2; got 1"),
    ("angular_velocity", {"dt": 0}, "dt must not be zero; got 0"),
    ("angular_velocity", {"dt": [1, 1]}, "dt must be one number; got shape (2,)"),
    ("mean_rotation", {"rotations": THREE[:0]}, "rotations must number at least 1; got 0"),
    ("mean_rotation", {"weights": [1, 2]}, "weights must have shape (..., 3); got shape (2,)"),
    ("mean_rotation", {"weights": 1}, "weights must have shape (..., 3); got shape ()"),
    (
        "mean_rotation",
        {"weights": [1, -0.5, -2]},
        "weights must not be negative; got -0.5 at index (1,)",
    ),
    ("mean_rotation", {"weights": [0, 0, 0]}, "weights must not all be zero; got zeros"),
    (
        "mean_rotation",
        {"weights": [[1, 0, 0], [0, 0, 0]]},
        "weights must not all be zero; got zeros at index (1,)",
    ),
]


class TestRefusals:
    def test_everything_public_is_tested_here(self) -> None:
        assert FUNCTIONS.keys() - {"compose", "DualQuaternion"} == GOOD.keys()

    @pytest.mark.parametrize(("f", "name"), ARGUMENTS)
    def test_neither_numbers_nor_finite(self, f: str, name: str) -> None:
        for value in NOT_NUMBERS:
            if (f, name) in OPTIONAL and value is None:
                continue
            wanted = f"ValueError: {name} must be an array of real numbers; got "
            assert refusal(f, **{name: value}).startswith(wanted), value
        for bad in [np.nan, np.inf, -np.inf]:
            value = np.array(GOOD[f][name], float)
            value[(-1,) * value.ndim] = bad
            place = f" at index {tuple(n - 1 for n in value.shape)}" if value.ndim else ""
            wanted = f"ValueError: {name} must be finite in float64; got {bad}{place}"
            assert refusal(f, **{name: value}) == wanted

    @pytest.mark.parametrize(("f", "name"), ARGUMENTS)
    def test_wrong_number_of_components(self, f: str, name: str) -> None:
        shape = np.shape(GOOD[f][name])
        if shape and f not in OF_ANY_DIMENSION:
            found = refusal(f, **{name: np.ones((*shape[:-1], 7))})
            assert found.startswith("ValueError: ")
            assert " must have shape (" in found

    def test_up_to_the_limits_of_the_conventions_all_is_finite(self) -> None:
        q = Quaternion(1e150, [1e150, -1e150, 1e150])
        turned = slerp(E1, E2, 1e300), slerp_by_rotation(E1, E2, 1e300)
        numbers = (q * q).components, q.inverse().components, perspective(1e-300), *turned
        assert all(np.isfinite(x).all() for x in numbers)

    @pytest.mark.parametrize(("f", "name"), DIRECTIONS)
    def test_zero_vectors(self, f: str, name: str) -> None:
        found = refusal(f, **{name: np.zeros_like(GOOD[f][name], float)})
        assert found.startswith(f"ValueError: {name} must not be the zero vector; got zeros")

    @pytest.mark.parametrize(("f", "name"), CLOSED.items())
    def test_fewer_than_three_points(self, f: str, name: str) -> None:
        for n in range(3):
            found = refusal(f, **{name: GOOD[f][name][:n]})
            few = f"ValueError: {name} must number at least 3 to make a closed curve; got {n}"
            assert found == few

    @pytest.mark.parametrize(("f", "bad", "message"), BAD)
    def test_what_does_not_fit(self, f: str, bad: dict[str, Any], message: str) -> None:
        assert refusal(f, **bad) == f"ValueError: {message}"

    def test_a_pair_in_a_stack_of_curves_is_named(self) -> None:
        pair = r"^Double\(points\[0, 3\], points\[0, 0\]\) and points\[0, 1\] are antipodal"
        with pytest.raises(DegenerateError, match=pair):
            closed_curve(np.stack([[E1, E2, E3, E2]] * 2), 3)

    def test_a_wrong_call_is_an_error_of_python(self) -> None:
        with pytest.raises(TypeError, match=r"^rotate\(\) missing 1 required"):
            rotate(E1, E2)
        with pytest.raises(TypeError, match=r"^rotate\(\) got multiple values"):
            rotate(E1, E2, 1, angle=2)

    @pytest.mark.parametrize("samples", [0, -1, 2.0, 2.5, "2", None, [2]])
    def test_samples(self, samples: Any) -> None:
        for f in CLOSED.keys() - {"control_points"}:
            wanted = f"ValueError: samples must be a positive integer; got {samples!r}"
            assert refusal(f, samples=samples) == wanted

    @pytest.mark.parametrize("fraction", [-0.1, 1.5, [0.5, 0.5]])
    def test_fraction(self, fraction: Any) -> None:
        for f in ["control_points", "closed_curve", "closed_rotation_curve"]:
            wanted = "ValueError: fraction must be one number from 0 to 1; got"
            assert refusal(f, fraction=fraction).startswith(wanted)
