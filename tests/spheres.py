"""Points of the unit sphere for the tests of Section 5, and checks of such points."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from symbolic import matrix, symbolic

from rotedu.control_points import control_points, double
from rotedu.errors import DegenerateError
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion

Array = np.ndarray[Any, Any]

RNG = np.random.default_rng(515)
E1, E2, E3 = np.eye(3)
# At 60 and 90 degrees a test notices a bar lost from a theta; the octant would hide it.
BEFORE, HERE, AFTER = E1, np.array([0.5, 0.75**0.5, 0]), E3
FRACTIONS = [1 / 2, 1 / 3]


def random_units(*shape: int, rng: np.random.Generator = RNG) -> Array:
    vectors = rng.normal(size=shape)
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def vectors(largest: float) -> st.SearchStrategy[Array]:
    """What hypothesis tries: vectors of three components up to a size."""
    return arrays(float, 3, elements=st.floats(-largest, largest))


UNITS = (
    arrays(float, 3, elements=st.floats(-1, 1, allow_subnormal=False))
    .filter(lambda v: bool(np.linalg.norm(v) > 1e-3))
    .map(lambda v: v / np.linalg.norm(v))
)


def great_circle(degrees: Any) -> Array:
    """Points at these angles in a plane that contains no coordinate axis."""
    angle = np.radians(degrees)[..., None]
    m = rotation_matrix([1, 2, 3], 0.8)
    return np.asarray(np.cos(angle) * m[0] + np.sin(angle) * m[1])


def where(points: Array) -> Array:
    """The angles of such points, in degrees, from -180 to 180."""
    m = rotation_matrix([1, 2, 3], 0.8)
    close(points @ m[2], 0, 1e-12)
    return np.asarray(np.degrees(np.arctan2(points @ m[1], points @ m[0])))


def close(actual: Any, desired: Any, atol: float = 1e-14, case: object = "") -> None:
    parts = (x.components if isinstance(x, Quaternion) else x for x in (actual, desired))
    np.testing.assert_allclose(*parts, rtol=0, atol=atol, err_msg=str(case))


def on_the_sphere(points: Array, atol: float = 1e-15, case: object = "") -> None:
    close(np.linalg.norm(points, axis=-1), 1, atol, case)


def refuses(message: str, function: Callable[..., Any], *given: Any) -> None:
    """A geometry without an answer is refused, by a message that begins so."""
    with pytest.raises(DegenerateError) as refusal:
        function(*given)
    assert str(refusal.value).startswith(message)


PAIRS = random_units(2, 500, 3)
AXES = np.array([*np.eye(3), *-np.eye(3), [0.6, 0.8, 0], [0, -0.6, 0.8], *PAIRS[0]])
POINTS = np.random.default_rng(32).normal(size=AXES.shape)
# Gaps from 12.8 to 164 degrees in many directions.
UNEVEN = great_circle(np.array([0, 12.8, 90, 210, 260])) + 0.4 * np.outer([0, 1, 0, -1, 2], E3)
UNEVEN /= np.linalg.norm(UNEVEN, axis=-1, keepdims=True)
DATA = {
    "octahedron square": great_circle(np.arange(4) * 90),
    "hexagon": great_circle(np.arange(6) * 60),
    "uneven": UNEVEN,
    "obtuse": np.array([[1, 0, 0], [-0.8, 0.6, 0], [0.1, -0.7, 0.7], [-0.5, -0.5, -0.7]]),
    "three": np.eye(3),
    "random": random_units(40, 3),
    "on the circle": random_units(6, 2),
    "in four dimensions": random_units(30, 4),
    "in seven dimensions": random_units(12, 7),
}
CURVES = [
    pytest.param(
        points / np.linalg.norm(points, axis=-1, keepdims=True), fraction, id=f"{name}-{k}"
    )
    for name, points in DATA.items()
    for k, fraction in zip("23", FRACTIONS, strict=True)
]


def segments(points: Any, fraction: float = 1 / 2) -> Array:
    """The control points of each segment, collected by hand."""
    a, b = control_points(points, fraction)
    n = len(points)
    return np.array([[points[i - 1], a[i - 1], b[i % n], points[i % n]] for i in range(1, n + 1)])


def bezier(points: Array, fraction: float, u: Array) -> Array:
    """The same with straight lines: points of the segments, shape (n, samples, d)."""
    before, after = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
    handle = fraction * (after - before) / 2
    control = points, points + handle, after - np.roll(handle, -1, axis=0), after
    weights = (1 - u) ** 3, 3 * u * (1 - u) ** 2, 3 * u**2 * (1 - u), u**3
    return np.asarray(sum(np.multiply.outer(w, c) for w, c in zip(weights, control, strict=True)))


def with_inner_control_points(rest: float) -> Array:
    """Points for which a_0 and b_1 are this short of antipodal: half a turn exchanges them."""
    half_turn = np.array([-1, -1, 1])
    a0 = np.array([np.cos(rest / 2), 0, np.sin(rest / 2)])
    p0 = np.array([0.4, 0.8, 0.2**0.5])
    p1 = half_turn * p0
    p3 = double(double(p1, double(p0, a0)), p0)
    return np.array([p0, p1, half_turn * p3, p3])


class TwoPoints:
    """Two points h to either side of the first axis, as symbols."""

    h, t = sp.symbols("h t", positive=True)
    c, s = sp.symbols("c s", positive=True)
    p, q = symbolic(c, -s, 0), symbolic(c, s, 0)

    def back(self, result: Any) -> sp.Matrix:
        """In terms of h; atan2 of its sine and cosine is h itself."""
        angle = {sp.atan2(2 * self.s, 2 * self.c): self.h, sp.atan2(self.s, self.c): self.h}
        found = matrix(result).subs(angle).applyfunc(sp.simplify).subs(self.c**2 + self.s**2, 1)
        return found.subs({self.c: sp.cos(self.h), self.s: sp.sin(self.h)})

    def of_5_2(self, t: Any) -> sp.Matrix:
        theta = 2 * self.h
        first, second = sp.sin((1 - t) * theta), sp.sin(t * theta)
        return (first * self.back(self.p) + second * self.back(self.q)) / sp.sin(theta)
