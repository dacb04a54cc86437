"""Checks of exercises accept every right form; the answers here were found by hand."""

from itertools import combinations_with_replacement
from typing import Any

import numpy as np
import pytest

from rotedu import scenes
from rotedu.cost import OperationCount
from rotedu.edition.exercises import check, general_rotation
from rotedu.quaternions import Quaternion

SECRET = np.random.default_rng(12)
AXIS_OF_THE_SPOON, ANGLE_OF_THE_SPOON = SECRET.normal(size=3), SECRET.uniform(0, np.pi)
AXIS_OF_THE_SPOON /= np.linalg.norm(AXIS_OF_THE_SPOON)
A_THIRD_BACK = [[0, 0, 1], [-1, 0, 0], [0, -1, 0]]


def spoon_and_order(camera: Any, chosen: Any = slice(None)) -> Any:
    """Return an answer to 4.7 with some triangles of the spoon, and the order in which they are."""
    spoon = scenes.teaspoon(stations=81, around=24)
    corners = spoon.points[spoon.faces.reshape(-1, 4)[chosen, 1:]].astype(float)
    columns = np.concatenate([corners, np.ones((*corners.shape[:2], 1))], axis=2) @ camera.T
    photo = columns[:, :, :3] / columns[:, :, 3:]
    order = photo[:, :, 2].mean(axis=1).argsort()
    return camera, photo[order], np.arange(len(order))


def photographed_from(distance: float, tilt: float = -1.1, back: float = 0.5) -> Any:
    """Return the matrix that tilts the spoon, seen along its handle, moves it and projects it."""
    cos, sin = np.cos(tilt), np.sin(tilt)
    quarter = np.array([[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    tilted = np.array([[1, 0, 0, 0], [0, cos, -sin, 0], [0, sin, cos, 0], [0, 0, 0, 1]])
    moved = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -back], [0, 0, 0, 1]])
    seen = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, -1 / distance, 1]])
    return seen @ moved @ tilted @ quarter


A_PHOTOGRAPH = spoon_and_order(photographed_from(2.2))


def with_one_triangle_twice(camera: Any, photo: Any, order: Any) -> Any:
    """Return an answer to 4.7 whose second triangle is the first, from another corner on."""
    photo = photo.copy()
    photo[1] = photo[0, [1, 2, 0]]
    return camera, photo, order


def rule_with_jump(limit: float) -> Any:
    """Return an answer to 5.11 that jumps where the gaps differ by more than this."""
    return lambda before, after: (
        (before + after) / 4 - 90 * np.sign(before + after) * (abs(before - after) > limit)
    )


# Along the axis x, whose neighbours are equally far apart.
A_RHOMBUS = [[0.87, 0.49, 0], [0.64, 0, 0.77], [0.87, -0.49, 0], [0.64, 0, -0.77]]

RIGHT: list[tuple[str, Any]] = [
    ("2.3", (0.87, 0, 0.3, 0.4)),
    ("3.3", ([0.58, 0.58, 0.58], 60)),
    ("3.7", ([0.005, -0.816, -0.578], 2 * np.pi - 0.5633)),
    ("4.8", A_PHOTOGRAPH),
    ("4.8", spoon_and_order(photographed_from(2.2).round(2))),
    ("5.2", [25, 130, -50]),
    ("5.2", (385, 130, 310)),
    ("5.3", [[0.783, -0.206, -0.587], [0.622, 0.277, 0.732], [0.622, 0.277, 0.732]]),
    ("5.4", (9156, 67.2)),
    ("5.5", (-1, 0.92, 3)),
    ("5.9", [-0.333, -0.667, 0.667]),
    ("5.10", (0.8, 0.6, 0)),
    ("5.11", [60, 80, 40, 320, 35]),
    ("5.12", (75, 63, 77, 50)),
    ("5.14", rule_with_jump(180)),
    ("5.16", (60, 30, 90)),
    ("5.16", (60, 30, 450)),
    ("5.17", [6, 55]),
    ("5.19", (0.22, 0.96, 0.16)),
    ("5.21", (1.63, False)),
    ("5.21", (1.62, "no")),
    ("5.22", A_THIRD_BACK),
    ("5.22", np.pad(A_THIRD_BACK, (0, 1)) + np.diag([0, 0, 0, 1])),
    ("5.22", Quaternion(0.5, [-0.5, 0.5, -0.5])),
    ("5.22", [-0.5, 0.5, -0.5, 0.5]),
    ("5.23", (150, -30, -30)),
    ("5.23", (150, 330, 330)),
    ("5.24", 40),
    ("5.24", -320),
    ("5.28", [30, 0]),
    ("5.25", [[4, 1.01, 1.0], [-3, 1.02, 1.4], [24, 1.18, 3.9], [5, 1.01, 1.0]]),
    ("5.18", A_RHOMBUS),
    ("6.1", (477, 318)),
    ("6.1", OperationCount(477, 318)),
    ("6.2", (3e-6, 9e-6)),
    ("6.3", 3),
    ("6.4", (27, 19, 35, 579)),
    ("6.5", (0, 2.0)),
    ("A.1", [0, 0, -1.57]),
    ("A.2", (2, 0, 0)),
    ("A.3", (1.02, 1.005)),
    ("A.4", [0.6258, 0.6278, 0.3384, 0.3158]),
    ("A.5", (256, 32)),
    ("A.6", (76.4, 75.5)),
    ("B.1", (1.41, 0.52, 1.93)),
    ("B.2", (26.6, 30)),
    ("B.3", (1, 0, 0, 0, 1)),
    ("B.3", [True, False, False, False, True]),
    ("B.4", [0.3153, 0.6325, -0.3189, 0.6316]),
    ("B.5", (3.44, 3.91, 3.92)),
    ("C.1", (0, 2, 2, 0)),
    ("C.2", (1, 1.732, -1)),
    ("C.3", lambda p, c, q, d: (p * q, c * q + p * d)),
    ("C.4", lambda bend: 2 * np.sin(bend / 4) ** 2),
    ("C.5", (50, 230)),
    ("C.6", ([1, 2, 0], 3.1416)),
    ("C.6", [[-0.6, 0.8, 0], [0.8, 0.6, 0], [0, 0, -1]]),
    ("C.6", [0, 0.4472, 0.8944, 0]),
    ("C.7", [[0.5, 0.854, 0.142], [-0.142, 0.243, -0.96], [-0.854, 0.46, 0.243]]),
    ("D.5", (179.9, 180, 0, 0.1)),
    ("D.3", (2.414, 2.414, 3.414)),
    ("D.4", [4, 6, 2, 5, 1]),
]


PAIRS = [([0, 0, 1], 180), ([0, 0, 0], 0), ([0, 1, 0], 90), ([1, 1, 1], 120)]
A, LOGICAL = [[0.6, -0.8, 0]] * 4, "True, False and None are not numbers"

# Wrong answers that look right or came in a trial, and what one of their hints says. Right numbers
# exchanged, repeated or halved, and the examples of hints need no row: test_exercises tries them.
WRONG: list[tuple[str, Any, str]] = [
    ("2.4", (PAIRS, [0, 1, 0]), "zero vector"),
    ("3.4", "transpose", "the second for -diagonal"),
    ("3.4", ("same", "same"), "you call the same does change"),
    ("4.3", ([7, 4, 6], [2, 4, 6, 0]), "fourth coordinates are known"),
    ("5.4", (67.2, 9156), "Is this the latitude?"),
    ("6.2", (3, 9), "factors by which the errors grow"),
    ("6.2", (9, 3), "factors, and the wrong way round"),
    ("6.3", 2.41, "smallest whole number"),
    ("3.2", ["-2", "1", "3"], f"words, {LOGICAL}"),
    ("5.14", lambda before, after: None, LOGICAL),
    ("5.17", np.array([True, False]), LOGICAL),
    ("5.20", (A, False), LOGICAL),
    ("5.24", np.zeros(1).any(), LOGICAL),
    ("1.3", ([-0.8, 0, 0.6], (3, 6), np.eye(3)), "changed places"),
    ("1.4", [*combinations_with_replacement(range(9), 3)], "names a row twice"),
    ("2.2", [7, 1, 2, 1], "come last"),
    ("2.3", (0, 0.3, 0.4, 0.87), "come last"),
    ("2.7", [0.091, 0.333, -0.661, 0.666], "scalar parts positive"),
    ("2.7", [0.333, -0.667, 0.667, 0.01], "come last"),
    ("2.7", [0.0087, 0.3333, -0.6666, 0.6666], "the truth, exactly"),
    ("3.6", 0.003, "two digits"),
    ("3.7", ([-0.005, 0.816, 0.578], 0.56), "close"),
    ("3.7", (-AXIS_OF_THE_SPOON.round(5), -ANGLE_OF_THE_SPOON), "the truth, exactly"),
    ("4.6", np.deg2rad([(10, 20, 30), (-170, 20, -150), (30, 90, 0)]).round(4), "to 1e-12"),
    ("4.6", np.full((3, 3), np.nan), "not finite"),
    ("4.6", np.deg2rad([(10, 20, 30), (10, 160, 30), (400, 90, 10)]), "neither of your outer"),
    ("4.8", spoon_and_order(photographed_from(100)), "hardly shows"),
    ("4.8", spoon_and_order(photographed_from(2.2), slice(1920)), "all the triangles"),
    ("4.8", with_one_triangle_twice(*A_PHOTOGRAPH), "all the triangles"),
    ("4.8", (*A_PHOTOGRAPH[:2], A_PHOTOGRAPH[2] + 0.4), "an order of n numbers"),
    ("4.8", (A_PHOTOGRAPH[0], *spoon_and_order(photographed_from(2.1))[1:]), "leave the spoon's"),
    ("4.8", spoon_and_order(photographed_from(2.2) @ np.diag([1, 1, -1, 1])), "mirrors"),
    ("4.8", (photographed_from(2.2), *spoon_and_order(np.eye(4))[1:]), "where the spoon was"),
    ("4.8", spoon_and_order(photographed_from(2.2, tilt=0)), "straight above"),
    ("4.8", spoon_and_order(photographed_from(2.2, back=-4)), "behind the eye"),
    ("5.4", (6011, 67.2), "degrees for radians"),
    ("5.4", (9200, 67.2), "close"),
    ("5.4", (9156, 67), "close"),
    ("5.4", (82.34, 67.2), "an angle"),
    ("5.4", (1.437, 67.2), "an angle"),
    ("5.9", (-1, -2, 2), "not on the sphere"),
    ("5.10", (0, 0, 1), "in the middle"),
    ("5.12", (50, 77, 63, 75), "begin with the last"),
    ("5.14", rule_with_jump(175), "not even right"),
    ("5.14", rule_with_jump(185), "but not beyond"),
    ("5.14", lambda g, h: rule_with_jump(180)(g, h) * (g % 1 == 0), "not even right"),
    ("5.16", (60, 30, 1.571), "radians"),
    ("5.21", (1.8, False), "the mean"),
    ("5.21", (1.65, False), "not right yet"),
    ("5.24", -40, "the other way"),
    ("5.22", [-1, 1, -1, 1], "unit quaternion"),
    ("5.22", np.pad(A_THIRD_BACK, (0, 1)) + np.diag([0, 0, 0, 2]), "Expected a turn"),
    ("5.22", np.pad(A_THIRD_BACK, (0, 1), constant_values=1), "Expected a turn"),
    ("5.24", 320, "the other way"),
    ("5.25", [[4, -1.01, 1.0], [3, 1.02, 1.4], [24, 1.18, 3.9], [5, 1.01, 1.0]], "second column"),
    ("5.18", [A_RHOMBUS[k] for k in (0, 2, 1, 3)], "round their middle"),
    ("5.18", [[0.93, 0, 0.37], [0.6, 0, -0.8], [0.93, 0, -0.37], [0.6, 0, 0.8]], "less than 40"),
    ("5.18", [[0.96, 0.28, 0], [0.64, 0, 0.77], [0.6, -0.8, 0], [0.64, 0, -0.77]], "still jumps"),
    ("6.4", (27, -19, 35, 579), "positive"),
    ("6.5", (0, 0), "do differ"),
    ("A.1", [0, 0, 4.71], "a shorter one"),
    ("A.1", [0, 0, 1.57], "not the direction"),
    ("A.1", [0, 0, 270], "degrees"),
    ("A.1", [0, 0, -90], "degrees"),
    ("A.1", [0, 0, -0.785], "half of the angle"),
    ("A.1", [0, 0, -1], "the axis"),
    ("A.2", [0, 2, 0], "from the ground"),
    ("A.2", [-2, 0, 0], "along with the drone"),
    ("A.2", [0, -2, 0], "second axis"),
    ("A.2", [0, 0, 2], "third axis"),
    ("A.2", [114.6, 0, 0], "degrees"),
    ("A.2", [1, 0, 0], "derivative of the quaternion"),
    ("A.3", (1.04, 1.01), "squares"),
    ("A.3", (1.2, 1.1), "added the lengths"),
    ("A.4", [0.7024, -0.4847, 0.3376, -0.3972], "fixed frame"),
    ("A.4", [0.6258, -0.6278, -0.3384, -0.3158], "coordinates"),
    ("A.4", [0.7024, 0.4847, -0.3376, 0.3972], "something is missing"),
    ("A.4", [0.4204, -0.113, 0.8302, -0.3481], "radians"),
    ("A.4", [0.4973, 0.0653, 0.865, -0.0139], "added the rotation vectors"),
    ("A.5", (4, 4), "radians"),
    ("A.6", (1.33, 1.32), "radians"),
    ("A.6", (1.53, 1.51), "one step"),
    ("A.6", (11.3, 75.5), "line of sight alone"),
    ("A.6", (76.4, 76.4), "about the vertical"),
    ("A.6", (76.4, 11.3), "sight itself"),
    ("B.1", (2.45, 1.0, 1.73), "twice the angle"),
    ("B.1", (1.41, 1.0, 1.73), "as far apart as the rotations"),
    ("B.1", (1.0, 0.52, 1.93), "too small"),
    ("B.1", (2, 0.268, 3.732), "squares"),
    ("B.1", (-2.79, 1.3, -1.52), "radians"),
    ("B.2", (29.3, 30), "sum of the quaternions"),
    ("B.2", (0.464, 0.524), "radians"),
    ("B.3", (1, 1, 1, 1, 1), "More than one"),
    ("B.3", ("yes", "no", "no", "no", "yes"), "each 1 or 0"),
    ("B.4", [-0.3121, -0.6256, 0.3302, -0.6342], "All ten count the same"),
    ("B.4", [0.3138, 0.6293, -0.3242, 0.6328], "fall too slowly"),
    ("B.4", [-0.3104, -0.622, 0.336, -0.6355], "coarse measurements count most"),
    ("B.4", [-0.3166, -0.6353, 0.3141, -0.6304], "coarse tracker out"),
    ("B.4", [-0.3101, -0.6214, 0.3371, -0.6357], "fine tracker out"),
    ("B.4", [0.3153, 0.6327, -0.3163, 0.6327], "the truth, exactly"),
    ("B.4", [0.3153, -0.6325, 0.3189, -0.6316], "turns back"),
    ("B.4", [0.6325, -0.3189, 0.6316, 0.3153], "come last"),
    ("B.5", (0.0601, 0.0682, 0.0684), "radians"),
    ("B.5", (3.44, 120.83, 116.62), "Only the first"),
    ("B.5", (6.83, 3.29, 7.17), "between the three"),
    ("C.1", (2, 0, 0, 2), "changed places"),
    ("C.1", (0, -2, 2, 0), "the other way round"),
    ("C.1", (0, 2, 0, 2), "same"),
    ("C.2", (1, -1.732, -1), "wrong side"),
    ("C.2", (2, 3.464, -1), "one half, or half"),
    ("C.2", (1, 0.577, -1), "cotangent"),
    ("C.2", (1, 1.732, 2.236), "slide"),
    ("C.3", lambda p, c, q, d: (q * p, q * c + d * p), "other order"),
    ("C.3", lambda p, c, q, d: (p * q, d * p + q * c), "factors have changed"),
    ("C.3", lambda p, c, q, d: (p * q, c * d), "part by part"),
    ("C.4", lambda bend: 1 - np.cos(bend), "whole angle"),
    ("C.4", lambda bend: np.cos(bend / 2), "what is left"),
    ("C.4", lambda bend: 2 * np.sin(bend / 4), "without any step"),
    ("C.5", (50, -65), "half the angle"),
    ("C.5", (50, 50), "in the sum"),
    ("C.5", (50, 130), "what sign"),
    ("C.5", (0.8727, -2.2689), "radians"),
    ("C.6", ([1, 2, 3], 3.1416), "given axis itself"),
    ("C.6", np.diag([1, 1, -1]), "mirror"),
    ("C.6", [0, 1, 0, 0], "another turn"),
    ("C.7", [0.866, 0.167, 0.333, -0.333], "whole turn"),
    ("C.7", [0.866, 0, 0.493, -0.082], "twist is gone"),
    ("C.7", [0.705, 0.504, 0.449, 0.22], "order"),
    ("C.7", ([1, 2, -2], 2.2689), "Nothing is held back"),
    ("D.5", (3.141, 3.142, 0, 0.0021), "radians"),
    ("D.5", (5.2, 5.0, 0.0, 0.1), "mean errors"),
    ("D.5", (179.9, 0, 0, 0.1), "no jump"),
    ("D.5", (2.83, 2.83, 0, 0.006), "chords"),
    ("D.5", (0.4, 180, 0, 0.1), "do not jump"),
    ("D.3", (1, 1, 1.414), "map out"),
    ("D.3", (2.414, 2.414, 2.414), "Both columns"),
    ("D.3", (2.414, 2.414, 4.828), "by their squares"),
    ("D.4", (4, 6, 2, 3, 5), "not true"),
    ("D.4", (4, 6, 2, 5), "five lines, in order"),
]


@pytest.mark.parametrize(("number", "answer", "hint"), WRONG)
def test_a_wrong_answer_hears_what_is_wrong(number: str, answer: Any, hint: str) -> None:
    verdicts = [check(number, answer, stage) for stage in (1, 2)]
    assert [verdict.right for verdict in verdicts] == [False, False]
    assert any(hint in verdict.text for verdict in verdicts)


@pytest.mark.parametrize(("number", "answer"), RIGHT)
def test_a_right_answer_passes_in_every_form(number: str, answer: Any) -> None:
    assert str(check(number, answer)).startswith(f"{number}: right.")


def test_the_spoon_of_a_photograph_is_the_one_of_the_scenes() -> None:
    """4.7: the check knows it by numbers, because the edition does not draw."""
    spoon = scenes.teaspoon(stations=81, around=24)
    assert spoon.n_cells == general_rotation.TRIANGLES
    ends = [spoon.points.min(axis=0), spoon.points.max(axis=0)]
    np.testing.assert_allclose(general_rotation.ENDS, ends, atol=1e-5)
    # PyVista's volume has no sign.
    np.testing.assert_allclose(-general_rotation.VOLUME, spoon.volume, atol=1e-6)
