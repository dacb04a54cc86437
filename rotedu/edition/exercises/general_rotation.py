"""Checks of the exercises of Chapter 4."""

from collections.abc import Iterator
from itertools import permutations
from typing import Any

import numpy as np

from rotedu.edition.exercises.judging import (
    Numbers,
    Wrong,
    as_array,
    as_number,
    as_parts,
    as_word,
    close,
    exercise,
    judged,
    numeric,
    radians_for_degrees,
    same_rotation,
)
from rotedu.general_rotation import (
    matrix_from_euler_angles,
    rotation_u,
    rotation_v,
    rotation_w,
    scaling,
    shearing,
    translation,
)


@numeric(
    "4.1",
    fields={"U": "", "V": "", "W": ""},
    expects="a point, three numbers",
    because="The second turn is about W itself.",
)
def end_of_v() -> Iterator[Numbers]:
    """Yield the end of the chain, then those of the other order and the other sense."""
    u, w = (turn(np.pi / 2)[:3, :3] for turn in (rotation_u, rotation_w))
    v = [0, 1, 0]
    yield Numbers(
        w @ u @ v,
        (
            u @ w @ v,
            Wrong(
                "You turned about W first.",
                "In a product that acts on a column, which factor acts first?",
            ),
        ),
        (
            w.T @ u.T @ v,
            Wrong(
                "You turned clockwise.",
                "Seen from the tip of U, the shortest way from V goes to which axis?",
            ),
        ),
        otherwise=Wrong(
            "V ends elsewhere.", "Follow V through the first turn alone, then go on from there."
        ),
        within=1e-3,
    )


@exercise(
    "4.2",
    expects="two times three numbers",
    because="A translation moves points and leaves directions alone.",
)
def point_and_direction(answer: Any) -> Wrong | None:
    """Compare with the images of a point and a direction."""
    point, direction = (as_array(part, (3,)) for part in as_parts(answer, 2))
    chain, turned_round = (
        translation([5, 0, 0]) @ scaling(2),
        scaling(2) @ translation([5, 0, 0]),
    )
    moved, only_scaled = ((chain @ [1, 2, 3, last])[:3] for last in (1, 0))
    if close(point, (turned_round @ [1, 2, 3, 1])[:3]):
        return Wrong(
            "The point was moved before it was made larger.",
            "In a product that acts on a column, which factor acts first?",
        )
    if close(point, only_scaled) and close(direction, moved):
        return Wrong("Point and direction are exchanged.", "Which one has a place?")
    if not close(point, moved):
        return Wrong("The point goes elsewhere.", "Do the two steps one after the other.")
    return judged(
        direction,
        only_scaled,
        (
            moved,
            Wrong(
                "You treated the direction as a point.",
                "What is the fourth coordinate of a direction?",
            ),
        ),
        otherwise=Wrong(
            "The direction goes elsewhere.",
            "Multiply out the first row of the matrix by the column of the direction.",
        ),
    )


@exercise(
    "4.3",
    expects='three letters such as "VWU", an axis of three numbers, and an angle in degrees',
    because="What acts first stands on the right.",
)
def order_of_a_product(answer: Any) -> Wrong | None:
    """Test the order at three angles; the sign of the axis is free."""
    letters, n, angle = as_parts(answer, 3)
    word = as_word(letters, ["".join(order) for order in permutations("uvw")])
    axis, degrees = as_array(n, (3,)), as_number(angle)
    turns = {"u": rotation_u(0.3), "v": rotation_v(0.5), "w": rotation_w(0.7)}
    first, second, third = (turns[letter] for letter in word)
    product = first @ second @ third
    if close(product, turns["w"] @ turns["v"] @ turns["u"]):
        return Wrong(
            "This product turns about U first.",
            "The column stands on the right of the product. Which matrix does it meet first?",
        )
    if not close(product, turns["u"] @ turns["v"] @ turns["w"]):
        return Wrong(
            "The letters are in another order.",
            "Which of the turns comes first, and which comes last?",
        )
    single = matrix_from_euler_angles(np.pi, np.pi, 0)
    if radians_for_degrees(abs(degrees), 180):
        return Wrong("Your angle is in radians.", "A full turn has 360 degrees.")
    if close(degrees % 360, 0, 0.1):
        return Wrong(
            "This turns nothing.",
            "Angles about different axes do not add up. Where does the tip of U end?",
        )
    if not same_rotation((axis, np.deg2rad(degrees)), single[:3, :3], 1e-2):
        return Wrong(
            "The two half turns make another rotation.",
            "Follow the tips of U, V and W. Which one comes back?",
        )
    return None


@exercise("4.4", expects="a matrix, shape (4, 4)", because="The last step has to be undone first.")
def way_back(answer: Any) -> Wrong | None:
    """Multiply by the way there."""
    back = as_array(answer, (4, 4))
    angles = np.array([0.4, 0.7, -1.1])
    there = matrix_from_euler_angles(*angles)
    u, v, w = angles
    return judged(
        back @ there,
        np.eye(4),
        (
            there @ there,
            Wrong("This is the way there, not the way back.", "What undoes one turn?"),
        ),
        (
            matrix_from_euler_angles(*-angles) @ there,
            Wrong(
                "The signs are changed, but that is not enough.",
                "You put on socks, then shoes. What do you take off first?",
            ),
        ),
        (
            rotation_u(u) @ rotation_v(v) @ rotation_w(w) @ there,
            Wrong(
                "The order is reversed, but that is not enough.",
                "What undoes a single turn about U?",
            ),
        ),
        otherwise=Wrong(
            "Multiplied by the way there, this is not the unit matrix.",
            "Write the product (4-1) out, and undo one factor at a time.",
        ),
    )


@exercise(
    "4.5",
    expects="three triples of angles in radians, shape (3, 3)",
    because="The angles need not be those that went in.",
)
def angles_of_a_matrix(answer: Any) -> Wrong | None:
    """Compare the matrices, not the angles."""
    found = as_array(answer, (3, 3))
    triples = np.deg2rad([(10, 20, 30), (10, 160, 30), (40, 90, 10)])
    targets = matrix_from_euler_angles(*triples.T)

    def right(angles: Any) -> list[bool]:
        pairs = zip(matrix_from_euler_angles(*angles.T), targets, strict=True)
        return [close(matrix, target, 1e-12) for matrix, target in pairs]

    if all(right(found)):
        return None
    if all(right(np.deg2rad(found))):
        return Wrong("Your angles are in degrees.", "Arctangents give radians: leave them so.")
    if all(right(found[:, ::-1])):
        return Wrong("Your angles stand in the order W, V, U.", "(4-1) begins with U.")
    if all(right(found)[:2]):
        return Wrong(
            "The triple at gimbal lock gives another matrix.",
            "Where the cosine of the second angle is 0, which four entries are left?",
        )
    if right(found)[0]:
        return Wrong(
            "The second triple gives another matrix.",
            "Your second angle lies between -90° and 90°. Does its cosine have the right sign?",
        )
    transposed = zip(matrix_from_euler_angles(*found.T), targets.swapaxes(1, 2), strict=True)
    if all(close(matrix, target, 1e-12) for matrix, target in transposed):
        return Wrong(
            "Your angles belong to the transposed matrices.",
            "In which corner of (4-2) does the sine of the second angle stand alone?",
        )
    return Wrong(
        "Already the first triple gives another matrix.",
        "Which entries of (4-2) hold only the second angle, or that and one other?",
    )


@exercise(
    "4.6",
    expects="three matrices, each of shape (3, 3)",
    because="Rotations and unequal scalings already shear.",
)
def shear_by_rotations(answer: Any) -> Wrong | None:
    """Test the three factors and their product."""
    last, stretch, first = (as_array(part, (3, 3)) for part in as_parts(answer, 3))
    shear = shearing(uv=0.8)[:3, :3]
    if not close(stretch, np.diag(np.diag(stretch)), 1e-14):
        return Wrong(
            "The matrix in the middle does not stretch along the axes.",
            "np.diag makes a diagonal matrix of three numbers.",
        )
    outer = [("left", last), ("right", first)]
    for side, matrix in outer:
        if not close(matrix.T @ matrix, np.eye(3), 1e-12):
            return Wrong(
                f"The matrix on the {side} is not orthogonal.",
                "A rotation keeps lengths. Multiply the matrix by its transpose.",
            )
    for side, matrix in outer:
        if np.linalg.det(matrix) < 0:
            return Wrong(
                f"The matrix on the {side} mirrors.",
                "What happens to a determinant if the sign of a 3 × 3 matrix changes?",
            )
    if close(last @ stretch @ first, shear, 1e-14):
        return None
    if close(last @ stretch @ first.T, shear, 1e-12):
        return Wrong(
            "The factor on the right is transposed.",
            "Which of its factors does np.linalg.svd return already transposed?",
        )
    if close(first @ stretch @ last, shear, 1e-12):
        return Wrong(
            "The three matrices stand in the wrong order.", "Write the product as it is computed."
        )
    return Wrong("The product is not the shear.", "Multiply the three matrices and compare.")


@exercise(
    "4.7",
    expects="a matrix of shape (4, 4), triangles of shape (n, 3, 3), and an order of n numbers",
    because="Near parts hide far ones.",
)
def photograph_of_a_spoon(answer: Any) -> Wrong | None:
    """Test the perspective and the order; the picture itself is for your eyes."""
    matrix, triangles, numbers = as_parts(answer, 3)
    camera = as_array(matrix, (4, 4))
    picture = as_array(triangles, (None, 3, 3))
    order = as_array(numbers, (len(picture),)).astype(int)
    *_, into_depth, last = camera[:, :3]
    if close(last, np.zeros(3)):
        return Wrong(
            "This camera has no perspective.",
            "Look at the last row. What must it hold to make far things small?",
        )
    if not close(np.cross(last, into_depth), np.zeros(3)):
        return Wrong(
            "The camera projects before the scene has moved into place.",
            "What acts last stands first in the product.",
        )
    if last @ into_depth > 0:
        return Wrong(
            "In this camera far things look larger.", "Compare the sign in (0, 0, -1/d, 1)."
        )
    depth = picture[:, :, 2].mean(axis=1)
    if not close(np.sort(order), np.arange(len(picture))):
        return Wrong(
            "The order does not name each triangle once.",
            "np.argsort gives the numbers, np.sort only the depths.",
        )
    steps = np.diff(depth[order])
    if (steps >= -1e-9).all():
        return None
    if (steps <= 1e-9).all():
        return Wrong(
            "You fill the near triangles first.",
            "What is filled later hides what is there. Is a larger depth nearer or farther?",
        )
    return Wrong(
        "The triangles are not sorted by depth.",
        "Give each triangle one depth, the mean of its corners, and sort by it.",
    )
