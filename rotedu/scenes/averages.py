"""Scene of page B: three orientations, and their mean by matrices and by quaternions."""

import numpy as np
import pyvista
from numpy.typing import ArrayLike, NDArray

from rotedu.averages import angular_distance, mean_rotation
from rotedu.colors import MATRIX, QUATERNION, VECTOR
from rotedu.figures import (
    Poses,
    Switch,
    describe,
    explorable,
    limit_turning,
    place_grip,
    read_out,
)
from rotedu.figures.frames import stack_on_phone
from rotedu.quaternions import Quaternion
from rotedu.scenes.orientations import add_spoon, matrices
from rotedu.scenes.parts import ORIGIN, add_label, add_point, add_sphere, new_scene, normalised

U, V, W = np.eye(3)
GIVEN = ((0.31, -0.59, -0.39, -0.64), (0.62, -0.21, -0.27, -0.71), (0.69, -0.61, 0, -0.38))
SPREAD = ((-0.06, 0.16, 0.92, -0.36), (-0.28, 0.68, -0.37, -0.57), (0.47, 0.15, 0.31, -0.81))
"""Here no choice of signs lets each pair agree."""
FACING = Quaternion.from_axis_angle(U, np.pi / 2)
THIRDS = (Quaternion.from_axis_angle(V, np.radians([-120, 0, 120])) * FACING).components.tolist()
UNCLEAR = 1e-3
"""A mean that is no clearer is none: links keep five digits, and a hand keeps fewer."""
BESIDE = np.array([[-2.13, 0, 0.36], [-1.42, 0, 0.36], [-1.77, 0, -0.28]])
"""Where the given orientations are turned, quite beside the ball, and where their names are."""
NAMES = BESIDE + np.outer([1, 1, -1], [0, 0, 0.43])
SIZE = 0.36
INKS = {"matrices": MATRIX, "quaternions": QUATERNION}
NO_MEAN = "no unique mean"
SMALLEST = 1e-9
"""A sum of quaternions that is shorter has no direction."""


@explorable(
    model="mean",
    constants={"no_mean": NO_MEAN},
    tries={
        "give q₃ the other sign": {"flip": False},
        "no choice of signs helps": {"poses": SPREAD, "flip": False},
        "thirds of a whole turn": {"poses": THIRDS, "flip": False},
    },
    poses=Poses([f"spoon {k}" for k in (1, 2, 3)]),
    flip=Switch("−q₃ in place of q₃, the same orientation"),
)
def mean_by_hand(poses: ArrayLike = GIVEN, flip: bool = True) -> pyvista.Plotter:
    """Draw the mean of three orientations by their matrices and by their quaternions.

    Parameters
    ----------
    poses : array_like, shape (3, 4)
        The orientations as quaternions; they are normalised, but their signs count.
    flip : bool
        Whether the third quaternion is replaced by its opposite.

    Returns
    -------
    pyvista.Plotter
        The scene.
    """
    q = normalised(poses) * [[1], [1], [-1 if flip else 1]]
    given = matrices(q)
    means = {"matrices": mean_of_matrices(given), "quaternions": mean_of_quaternions(q)}

    # From far away, so that spoons in the same pose look the same wherever they are.
    middle = -0.73 * U
    plotter = new_scene(middle - 32 * V + 6 * W, middle, view_angle=4.18)
    limit_turning(plotter, 20)
    stack_on_phone(plotter, (0, 66, 303, 332, 0.56), (295, 29, 425, 422, 1))
    add_sphere(plotter)
    for k, (place, turn) in enumerate(zip(BESIDE, given, strict=True), start=1):
        add_spoon(plotter, turn, place, SIZE, VECTOR, f"R_{k}")
        add_spoon(plotter, turn, ORIGIN, 1, VECTOR, f"R_{k} in the ball").prop.opacity = 0.18
        add_point(plotter, turn[:, 0], VECTOR, name=f"tip {k}")
    place_grip(plotter, "poses", at=BESIDE, size=SIZE)
    for name, k, shown in (
        ("q_1", 0, True),
        ("q_2", 1, True),
        ("q_3", 2, not flip),
        ("-q_3", 2, flip),
    ):
        add_label(plotter, NAMES[k] if shown else None, f"${name}$", VECTOR)
    for side, (name, mean) in zip((-1, 1), means.items(), strict=True):
        turn = np.eye(3) if mean is None else mean
        for actor in (
            add_spoon(plotter, turn, ORIGIN, 1, INKS[name], name),
            add_point(plotter, turn[:, 0], INKS[name], 0.04, name=f"tip by {name}"),
        ):
            actor.visibility = mean is not None
        add_label(plotter, (0.72 * side, 0, -0.97), f"by {name}", INKS[name], name=name)

    both = [mean for mean in means.values() if mean is not None]
    apart = np.degrees(angular_distance(*both)) if len(both) == 2 else NO_MEAN
    read_out(plotter, "apart", apart, "means apart", 1, "°", where="picture")
    for name, mean in means.items():
        far = NO_MEAN if mean is None else np.degrees(angular_distance(given, mean))
        read_out(
            plotter,
            f"by_{name}",
            far,
            f"{name}: from the spoons",
            0,
            "°",
            where="picture",
            color=INKS[name],
        )
    read_out(
        plotter,
        "singular",
        singular_values(given.mean(axis=0)),
        "singular values of the mean matrix",
        3,
        where="folded",
    )
    describe(
        plotter,
        "Three blue teaspoons in a row can be turned. Below them, in a see-through ball, pale"
        " spoons in the same poses cross at the middle, and two more show their mean. The ochre"
        " one, by matrices, lies among the pale ones."
        + (
            " The violet one, by quaternions with the sign of the third changed, points elsewhere."
            if flip
            else ""
        ),
    )
    return plotter


def mean_of_matrices(given: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Return the mean of rotations, or None where others are nearly as near."""
    _, second, third = singular_values(given.mean(axis=0))
    return mean_rotation(given) if second + third > UNCLEAR else None


def singular_values(matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the singular values from the largest down, the last with the sign of the determinant.

    The nearest rotation is unique if the two smaller ones do not add up to zero.
    """
    _, values, _ = np.linalg.svd(matrix)
    return np.asarray(values * [1, 1, np.sign(np.linalg.det(matrix))])


def mean_of_quaternions(q: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Return the rotation of the sum of quaternions, whatever their signs, or None."""
    total = q.sum(axis=0)
    if np.linalg.norm(total) < SMALLEST:
        return None
    return Quaternion(total[0], total[1:]).matrix()
