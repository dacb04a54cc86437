"""Checks of the exercises of Chapter 4."""

from collections.abc import Iterator
from itertools import permutations
from typing import Any

import numpy as np

from rotedu._vectors import Array
from rotedu.edition.exercises.answers import (
    as_array,
    close,
    numbers,
    parts,
    radians_for_degrees,
    same_turn,
    word,
)
from rotedu.edition.exercises.judging import (
    Mistake,
    Part,
    angle_in_radians,
    exercise,
    otherwise,
    when,
)
from rotedu.general_rotation import (
    euler_angles,
    matrix_from_euler_angles,
    perspective,
    rotation_u,
    rotation_v,
    rotation_w,
    scaling,
    shearing,
    translation,
)
from rotedu.ordinary_rotation import rotation_matrix


@exercise("4.2", "a point, three numbers", fields={"U": "", "V": "", "W": ""})
def end_of_v() -> Iterator[Part]:
    """The second turn is about W itself."""
    u, w = (turn(np.pi / 2)[:3, :3] for turn in (rotation_u, rotation_w))
    v = [0, 1, 0]
    hints = {
        "You turned about W first.": when(
            u @ w @ v, "In a product that acts on a column, which factor acts first?"
        ),
        "You turned clockwise.": when(
            w.T @ u.T @ v,
            "Seen from the tip of U, which axis is a quarter turn anticlockwise of V?",
        ),
        "V ends elsewhere.": otherwise(
            "Follow V through the first turn alone, then go on from there."
        ),
    }
    yield Part(w @ u @ v, hints, within=1e-3)


def with_or_without_a_fourth(answer: Any) -> Array:
    """Read three coordinates, or four."""
    given = as_array(answer, (None,))
    if len(given) not in (3, 4):
        raise ValueError(f"one of them has {len(given)}.")
    return given


@exercise("4.3", "two times three numbers", read=parts(*2 * [with_or_without_a_fourth]))
def point_and_direction() -> Iterator[Part]:
    """A translation moves points and leaves directions alone."""
    chain = translation([5, 0, 0]) @ scaling(2)
    turned_round = scaling(2) @ translation([5, 0, 0])
    moved, only_scaled = ((chain @ [1, 2, 3, last])[:3] for last in (1, 0))
    moved_first = (turned_round @ [1, 2, 3, 1])[:3]
    hints = {
        "The fourth coordinates are known: 1 for the point and 0 for the direction.": otherwise(
            "Answer with the first three coordinates of each.",
            example=(chain @ [1, 2, 3, 1], chain @ [1, 2, 3, 0]),
        )
    }
    yield Part(lambda point, direction: len(point) == len(direction) == 3, hints)
    hints = {
        "The point was moved before it was made larger.": when(
            lambda point, direction: close(point, moved_first),
            "In a product that acts on a column, which factor acts first?",
            example=(moved_first, only_scaled),
        ),
        "Point and direction are exchanged.": when(
            lambda point, direction: close(point, only_scaled) and close(direction, moved),
            "Which one has a place?",
            example=(only_scaled, moved),
        ),
        "The point goes elsewhere.": otherwise(
            "Do the two steps one after the other.", example=([6, 2, 3], only_scaled)
        ),
    }
    yield Part(lambda point, direction: close(point, moved), hints)
    hints = {
        "You treated the direction as a point.": when(
            moved, "What is the fourth coordinate of a direction?"
        ),
        "The direction goes elsewhere.": otherwise(
            "Multiply out the first row of the matrix by the column of the direction."
        ),
    }
    yield Part(only_scaled, hints, item=1)


@exercise(
    "4.4",
    'three letters such as "VWU", an axis of three numbers, and an angle in degrees',
    read=parts(word(*map("".join, permutations("uvw"))), numbers(3), numbers()),
)
def order_of_a_product() -> Iterator[Part]:
    """What acts first stands on the right."""
    u, v, w = np.eye(3)

    def product(letters: str) -> Array:
        turns = {"u": rotation_u(0.3), "v": rotation_v(0.5), "w": rotation_w(0.7)}
        first, second, third = (turns[letter] for letter in letters)
        return first @ second @ third

    hints = {
        "This product turns about U first.": when(
            lambda letters: close(product(letters), product("wvu")),
            "The column comes on the right of the product. Which matrix does it meet first?",
            example=("WVU", w, 180),
        ),
        "The letters are in another order.": otherwise(
            "Which of the turns comes first, and which comes last?", example=("UWV", w, 180)
        ),
    }
    yield Part(lambda letters: close(product(letters), product("uvw")), hints, item=0)
    single = matrix_from_euler_angles(np.pi, np.pi, 0)
    hints = {
        **angle_in_radians(
            lambda axis, degrees: radians_for_degrees(abs(degrees), 180), example=("UVW", w, np.pi)
        ),
        "This turns nothing.": when(
            lambda axis, degrees: close(degrees % 360, 0, 0.1),
            "Angles about different axes do not add up. Where does the tip of U end?",
            example=("UVW", w, 360),
        ),
        "The two half turns make another rotation.": otherwise(
            "Follow the tips of U, V and W. Which one comes back?", example=("UVW", u + v, 180)
        ),
    }
    yield Part(lambda *turn: same_turn(turn, single, 1e-2), hints, item=slice(1, 3))


THERE = np.array([0.4, 0.7, -1.1])


@exercise(
    "4.5",
    "a matrix, shape (4, 4)",
    read=lambda back: numbers(4, 4)(back) @ matrix_from_euler_angles(*THERE),
)
def way_back() -> Iterator[Part]:
    """The last step has to be undone first."""
    u, v, w = THERE
    there = matrix_from_euler_angles(u, v, w)
    hints = {
        "This is the way there, not the way back.": when(there @ there, "What undoes one turn?"),
        "Changing the signs is not enough.": when(
            matrix_from_euler_angles(-u, -v, -w) @ there,
            "You put on socks, then shoes. What do you take off first?",
        ),
        "Reversing the order is not enough.": when(
            rotation_u(u) @ rotation_v(v) @ rotation_w(w) @ there,
            "What undoes a single turn about U?",
        ),
        "Multiplied by the matrix of the way there, yours is nearly the unit matrix.": when(
            lambda both: close(both, np.eye(4), 2e-2),
            "Answer with the matrix as it is computed, not rounded.",
            example=there.T.round(2),
        ),
        "Multiplied by the matrix of the way there, yours is not the unit matrix.": otherwise(
            "Write the product (4-1) out, and undo one factor at a time.", example=np.eye(4)
        ),
    }
    yield Part(np.eye(4), hints)


@exercise("4.6", "three triples of angles in radians, shape (3, 3)", read=numbers(3, 3))
def angles_of_a_matrix() -> Iterator[Part]:
    """The angles need not be those that went in."""
    # Matrices are compared, not angles, except at gimbal lock.
    triples = np.deg2rad([(10, 20, 30), (10, 160, 30), (40, 90, 10)])
    targets = matrix_from_euler_angles(*triples.T)
    found = np.transpose(euler_angles(targets))

    def reaches(
        angles: Array, count: int = 3, targets: Array = targets, within: float = 1e-12
    ) -> bool:
        return close(matrix_from_euler_angles(*angles.T)[:count], targets[:count], within)

    hints = {
        "Your angles are in degrees.": when(
            lambda found: reaches(np.deg2rad(found)),
            "Arctangents give radians: leave them so.",
            example=np.rad2deg(found),
        ),
        "The matrices are close to the given ones, but not to 1e-12.": when(
            lambda found: reaches(found, within=2e-2),
            "Answer with the angles as your function returns them, not rounded.",
            example=found.round(2),
        ),
        "Your angles are in the order W, V, U.": when(
            lambda found: reaches(found[:, ::-1]), "(4-1) begins with U.", example=found[:, ::-1]
        ),
        "Your triples are the columns.": when(
            lambda found: reaches(found.T),
            "Each row should hold the three angles of one matrix.",
            example=found.T,
        ),
        "The triple at gimbal lock gives another matrix.": when(
            lambda found: reaches(found, 2),
            "Where the cosine of the second angle is 0, which entries depend on the other two?",
            example=[*found[:2], (0, np.pi / 2, 0)],
        ),
        "The second triple gives another matrix.": when(
            lambda found: reaches(found, 1),
            "A second angle between -90° and 90° has a positive cosine. In which quadrants do the"
            " entries put the other two, then?",
            example=found[[0, 0, 2]],
        ),
        "Your angles belong to the transposed matrices.": when(
            lambda found: reaches(found, targets=np.swapaxes(targets, 1, 2)),
            "In which corner of (4-2) does the sine of the second angle stand alone?",
            example=np.transpose(euler_angles(np.swapaxes(targets, 1, 2))),
        ),
        "Even the first triple gives another matrix.": otherwise(
            "Which entries of (4-2) contain only the second angle, or only that and one other?",
            example=-triples,
        ),
    }
    yield Part(reaches, hints)
    # The matrix at gimbal lock tells only a difference of angles.
    hints = {
        "At gimbal lock neither of your outer angles is 0.": otherwise(
            "Many triples give this matrix, among them the one that went in. Choose.",
            example=triples,
        )
    }
    yield Part(lambda found: np.isclose(found[2, [0, 2]], 0).any(), hints)


@exercise("4.7", "three matrices, each of shape (3, 3)", read=parts(*3 * [numbers(3, 3)]))
def shear_by_rotations() -> Iterator[Part]:
    """Rotations and unequal scalings already shear."""
    shear = shearing(uv=0.8)[:3, :3]
    # The SVD may mirror on both sides; the product stays if both signs change.
    last, sizes, first = np.linalg.svd(shear)
    last, first = np.linalg.det(last) * last, np.linalg.det(first) * first
    stretch = np.diag(sizes)

    hints = {
        "The matrix in the middle does not stretch along the axes.": otherwise(
            "np.diag makes a diagonal matrix of three numbers.", example=(last, last, first)
        )
    }
    yield Part(lambda middle: close(middle, np.diag(np.diag(middle)), 1e-14), hints, item=1)
    sides = {"left": 0, "right": 2}
    for side, item in sides.items():
        hints = {
            f"The matrix on the {side} is nearly orthogonal.": when(
                lambda matrix: close(matrix.T @ matrix, np.eye(3), 2e-2),
                "Answer with the matrices as they are computed, not rounded.",
                example=(last, stretch, first.round(2))
                if item
                else (last.round(2), stretch, first),
            ),
            f"The matrix on the {side} is not orthogonal.": otherwise(
                "A rotation keeps lengths. Multiply the matrix by its transpose.",
                example=(last, stretch, 2 * first) if item else (2 * last, stretch, first),
            ),
        }
        yield Part(lambda matrix: close(matrix.T @ matrix, np.eye(3), 1e-12), hints, item=item)
    for side, item in sides.items():
        hints = {
            f"The matrix on the {side} mirrors.": otherwise(
                "What happens to a determinant if the sign of a 3 × 3 matrix changes?",
                example=(last, stretch, -first) if item else (-last, stretch, first),
            )
        }
        yield Part(lambda matrix: np.linalg.det(matrix) > 0, hints, item=item)
    hints = {
        "The factor on the right is transposed.": when(
            lambda left, middle, right: close(left @ middle @ right.T, shear, 1e-12),
            "Which of its factors does np.linalg.svd return already transposed?",
            example=(last, stretch, first.T),
        ),
        "The three matrices are in the wrong order.": when(
            lambda left, middle, right: close(right @ middle @ left, shear, 1e-12),
            "Write the product as it is computed.",
            example=(first, stretch, last),
        ),
        "The product is not the shear.": otherwise(
            "Multiply the three matrices and compare.", example=(np.eye(3), stretch, np.eye(3))
        ),
    }
    yield Part(lambda left, middle, right: close(left @ middle @ right, shear, 1e-14), hints)


# What is known of the spoon of Exercise 4.8, by least and greatest coordinates, with its sign for
# the sense in which the corners of its triangles follow each other.
TRIANGLES = 3840
ENDS = [(-1, -0.262056, -0.152639), (1, 0.262056, 0.216594)]
VOLUME = -0.013416


def as_photograph(answer: Any) -> tuple[Array, Array, Array, Array, Array]:
    """Return a camera, the depths of triangles, their order, and the triangles before and after."""
    camera, triangles, order = parts(numbers(4, 4), numbers(None, 3, 3), numbers(None))(answer)
    if len(order) != len(triangles):
        raise ValueError(f"the order has {len(order)} numbers for {len(triangles)} triangles.")
    # Where the triangles were, and their divisors: the inverse matrix leads back.
    back = np.insert(triangles, 3, 1, axis=2) @ np.linalg.pinv(camera).T
    if (order % 1).any():
        raise ValueError("the order has numbers that are not whole.")
    return camera, triangles[:, :, 2].mean(axis=1), order.astype(int), back, triangles


def faults_of_a_camera(turned: Array, projection: Array, *rest: Any) -> dict[str, Mistake]:
    """Return the hints for a camera that should turn before it projects."""
    camera = projection @ turned
    return {
        "This camera has no perspective.": when(
            lambda camera: close(camera[3, :3], np.zeros(3)),
            "Look at the last row. What must it contain to make far things small?",
            example=(turned, *rest),
        ),
        "The camera projects before the scene has moved into place.": when(
            lambda camera: not close(np.cross(camera[3, :3], camera[2, :3]), np.zeros(3), 1e-2),
            "What acts last comes first in the product.",
            example=(turned @ projection, *rest),
        ),
        "In this camera far things look larger.": when(
            lambda camera: camera[3, :3] @ camera[2, :3] >= 0,
            "Compare the sign in (0, 0, -1/d, 1).",
            example=(np.linalg.inv(projection) @ turned, *rest),
        ),
        "You look at the spoon from straight above.": when(
            lambda camera: close(camera[3, :2], np.zeros(2)),
            "Tilt the scene, after you have turned it about W.",
            example=(projection, *rest),
        ),
        "Your matrix mirrors the spoon.": when(
            lambda camera: np.linalg.det(camera) <= 0,
            "Turns, translations and a perspective have determinant 1. Which step has another?",
            example=(camera @ scaling([1, 1, -1]), *rest),
        ),
    }


def faults_of_triangles(camera: Array, triangles: Array, near_last: Array) -> dict[str, Mistake]:
    """Return the hints for triangles that should be led back to those of the spoon."""
    many = np.random.default_rng(0).uniform(-1, 1, size=(TRIANGLES, 3, 3))
    return {
        "Some of your triangles are behind the eye.": when(
            lambda back: (back[..., 3] <= 0).any(),
            "Compute the divisors, the fourth coordinates. All must be positive.",
            example=(camera, triangles - [0, 0, 9], near_last),
        ),
        "The perspective hardly shows: your divisors are all about the same.": when(
            lambda back: back[..., 3].max() <= 1.2 * back[..., 3].min(),
            "Go nearer with the eye, or turn the spoon until one end is farther away.",
            example=(camera, triangles / 100, near_last),
        ),
        "These are not all the triangles of the spoon.": when(
            # A triangle twice is one triangle, whichever of its corners comes first.
            lambda back: (
                not len(np.unique(back.mean(axis=1).round(6), axis=0)) == TRIANGLES == len(back)
            ),
            "Keep those that others hide, too, since filling them in order hides them.",
            example=(camera, triangles, near_last),
        ),
        "The matrix does not leave the spoon's triangles like this.": when(
            lambda back: not is_spoon(back[..., :3] / back[..., 3:]),
            "Transform the points by this matrix, then take those of each triangle.",
            example=(camera, many, np.argsort(many[:, :, 2].mean(axis=1))),
        ),
    }


@exercise(
    "4.8",
    "a matrix of shape (4, 4), triangles of shape (n, 3, 3), and an order of n numbers",
    read=as_photograph,
)
def photograph_of_a_spoon() -> Iterator[Part]:
    """Near parts hide far ones."""
    # The picture itself is for your eyes.
    triangles = np.random.default_rng(0).uniform(-1, 1, size=(20, 3, 3))
    near_last = np.argsort(triangles[:, :, 2].mean(axis=1))
    projection = perspective(2)
    turned = matrix_from_euler_angles(0.3, 0.5, 0.7)
    camera = projection @ turned

    yield Part(None, faults_of_a_camera(turned, projection, triangles, near_last), item=0)
    hints = {
        "Your triangles are still where the spoon was.": otherwise(
            "Transform the points by the matrix before you take those of each triangle.",
            example=(camera, [[ENDS[0], ENDS[0], ENDS[1]]], [0]),
        )
    }
    yield Part(lambda photo: not close(ends_of(photo), ENDS, 1e-3), hints, item=4)
    hints = {
        "The order does not name each triangle once.": otherwise(
            "np.argsort gives the numbers, np.sort only the depths.",
            example=(camera, triangles, np.zeros(20)),
        )
    }
    yield Part(
        lambda depth, order: close(np.sort(order), np.arange(len(depth))), hints, item=slice(1, 3)
    )
    hints = {
        "You fill the near triangles first.": when(
            lambda depth, order: (np.diff(depth[order]) <= 1e-9).all(),
            "What is filled later hides what is there. Is a larger depth nearer or farther?",
            example=(camera, triangles, near_last[::-1]),
        ),
        "You have already sorted the triangles, and your order sorts them again.": when(
            lambda depth, order: (np.diff(depth) >= -1e-9).all(),
            "Give the triangles in the spoon's own order; your numbers then say which comes when.",
            example=(camera, triangles[near_last], near_last),
        ),
        "The triangles are not sorted by depth.": otherwise(
            "Give each triangle one depth, the mean of its corners, and sort by it.",
            example=(camera, triangles, np.arange(20)),
        ),
    }
    yield Part(lambda depth, order: (np.diff(depth[order]) >= -1e-9).all(), hints, item=slice(1, 3))
    yield Part(None, faults_of_triangles(camera, triangles, near_last), item=3)


def is_spoon(corners: Array) -> bool:
    """Tell whether triangles have the ends and the volume of the spoon."""
    volume = np.linalg.det(corners).sum() / 6
    return close(ends_of(corners), ENDS, 1e-3) and close(volume, VOLUME, 1e-5)


def ends_of(corners: Array) -> Array:
    """Return the least and the greatest coordinates of triangles."""
    points = corners.reshape(-1, 3)
    return np.stack([points.min(axis=0), points.max(axis=0)])


TRIPLES = [(0.3, -0.8, 2.0), (np.pi / 2, np.pi / 2, 0.0), (-1.0, 0.4, 0.7)]


@exercise(
    "4.1",
    "a function of three angles that returns a matrix, shape (3, 3)",
    read=lambda rule: [numbers(3, 3)(rule(*triple)) for triple in TRIPLES],
)
def three_turns_in_order() -> Iterator[Part]:
    """What acts first stands next to the point, on the right."""

    def rows(order: str) -> list[Array]:
        found = []
        for triple in TRIPLES:
            turns = dict(zip("uvw", rotation_matrix(np.eye(3), triple), strict=True))
            first, second, third = (turns[letter] for letter in order)
            found.append(third @ second @ first)
        return found

    hints = {
        "Your turns come in the opposite order.": when(
            rows("wvu"), "A product of matrices acts from right to left."
        ),
        "Your turns come in another order.": when(
            rows("vuw"),
            "About U, then V, then W. Which of yours stands elsewhere?",
            also=rows("uwv"),
        ),
        "That is another turn.": otherwise("Multiply three matrices, with `@` between them."),
    }
    yield Part(rows("uvw"), hints)
