"""The ledger: its formulas are right and counted, and each notation breaks where it says."""

import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from bs4 import BeautifulSoup
from docutils import nodes
from docutils.core import publish_doctree, publish_from_doctree
from notebook_language import BOOK
from scipy.spatial.transform import RigidTransform, Rotation, RotationSpline, Slerp
from spheres import close

from rotedu.cost import count
from rotedu.edition import lean
from rotedu.edition.ledger import LEDGER, ledger, priced
from rotedu.five_numbers import five_numbers, matrix_from_five_numbers
from rotedu.general_rotation import euler_angles, homogeneous
from rotedu.motion import rotation_vector
from rotedu.ordinary_rotation import axis_angle, rotation_matrix
from rotedu.quaternions import Quaternion
from rotedu.rigid_motion import DualQuaternion, blend_dual_quaternions, blend_matrices

sys.path.append(str(BOOK / "_ext"))
from listings_and_tables import LedgerAndClaims

ROWS = {row.written_as: row for row in LEDGER}
RNG = np.random.default_rng(20261)
PAIRS = [tuple(Rotation.random(2, rng=RNG)) for _ in range(50)]
Array = np.ndarray[Any, Any]


def turn(r: Rotation) -> Array:
    """An axis and an angle."""
    v, angle = r.as_rotvec(), r.magnitude()
    return np.array([*(v / angle), angle])


def quaternion(r: Rotation) -> Array:
    return np.asarray(r.as_quat(canonical=True, scalar_first=True))


def of_columns(m: Array) -> Rotation:
    return Rotation.from_matrix(np.stack([*m.T, np.cross(*m.T)], axis=1))


# How SciPy writes a rotation in each notation, and reads it again.
WRITTEN: dict[str, tuple[Callable[[Rotation], Any], Callable[[Any], Rotation]]] = {
    "three angles": (lambda r: r.as_euler("xyz"), lambda x: Rotation.from_euler("xyz", x)),
    "axis and angle": (turn, lambda x: Rotation.from_rotvec(x[3] * x[:3])),
    "rotation vector": (lambda r: r.as_rotvec(), Rotation.from_rotvec),
    "matrix": (lambda r: r.as_matrix(), Rotation.from_matrix),
    "quaternion": (quaternion, lambda q: Rotation.from_quat(q, scalar_first=True)),
    "two columns": (lambda r: r.as_matrix()[:, :2], of_columns),
    "five numbers of a map": (
        lambda r: five_numbers(r.as_matrix()),
        lambda x: Rotation.from_matrix(matrix_from_five_numbers(x)),
    ),
}


def agrees(found: Rotation, expected: Rotation) -> None:
    assert (found.inv() * expected).magnitude() < 1e-12


class TestFormulas:
    """Against SciPy, which writes and reads each notation."""

    @pytest.mark.parametrize("name", WRITTEN)
    def test_compose_turn_and_repair(self, name: str) -> None:
        write, read = WRITTEN[name]
        formulas = {task: formula for task, (formula, *_) in ROWS[name].formulas.items()}
        for a, b in PAIRS:
            p, q, r = write(a), write(b), RNG.normal(size=3)
            agrees(read(formulas["compose"](p, q)), a * b)
            if "point" in formulas:
                close(formulas["point"](p, r), a.apply(r), 1e-13)
            if "matrix" in formulas:
                given = p if name == "three angles" else (p,)
                close(formulas["matrix"](*given), a.as_matrix(), 1e-13)
            if name == "axis and angle":
                close(formulas["repair"](1.1 * p[:3]), p[:3])
            elif name == "five numbers of a map":
                agrees(read(formulas["repair"](1.1 * p)), read(1.1 * p))
            elif "repair" in formulas:
                agrees(read(formulas["repair"](1.1 * p)), a)

    @pytest.mark.parametrize("name", ["matrix", "quaternion", "axis and angle", "rotation vector"])
    def test_go_a_part_of_the_way(self, name: str) -> None:
        write, read = WRITTEN[name]
        between = ROWS[name].formulas["between"][0]
        for a, b in PAIRS:
            p, q, t = write(a), write(b), RNG.uniform()
            if name != "matrix" and quaternion(a) @ quaternion(b) < 0:
                continue  # The formulas go the way that the signs say: here the long one.
            agrees(read(between(p, q, t)), Slerp([0, 1], Rotation.concatenate([a, b]))(t))

    def test_samples_of_a_prepared_arc(self) -> None:
        for a, b in PAIRS:
            p, q = quaternion(a), quaternion(b)
            q, t = q * np.sign(p @ q), RNG.uniform()
            across, theta = lean.unit(q - p @ q * p), np.arccos(p @ q)
            expected = Slerp([0, 1], Rotation.concatenate([a, b]))(t)
            for name in ("quaternion", "axis and angle", "rotation vector"):
                sample = ROWS[name].formulas["sample"][0](p, across, theta, t)
                agrees(WRITTEN[name][1](sample), expected)
            doubled = np.sqrt(2) * p, np.sqrt(2) * across, theta, t
            close(lean.matrix_on_arc_of_quaternions(*doubled), expected.as_matrix(), 1e-12)
            (*n, angle), m = turn(a.inv() * b), a.as_matrix()
            still = np.outer(m @ n, n)
            prepared = still, m - still, np.cross(m, n), angle
            close(lean.matrix_on_arc(*prepared, t), expected.as_matrix(), 1e-12)

    def test_what_is_prepared_for_many_points(self) -> None:
        for a, _ in PAIRS:
            r = RNG.normal(size=3)
            for name in ("quaternion", "axis and angle", "rotation vector"):
                prepared = ROWS[name].formulas["prepare"][0](WRITTEN[name][0](a))
                close(lean.turn_prepared(*prepared, r), a.apply(r), 1e-13)

    def test_newton_s_step_straightens(self) -> None:
        for a, _ in PAIRS:
            m = a.as_matrix()
            worn = m + 1e-5 * RNG.normal(size=(3, 3))
            u, _, vt = np.linalg.svd(worn)
            close(lean.repair_evenly(worn), u @ vt, 1e-8)
        cost = count(lean.repair_evenly, worn)
        assert (cost.multiplications, cost.additions) == (51, 33)


class TestRigidMotions:
    def test_formulas(self) -> None:
        for a, b in PAIRS:
            steps, r = RNG.normal(size=(2, 3)), RNG.normal(size=3)
            m, n = (
                RigidTransform.from_components(t, x) for t, x in zip(steps, (a, b), strict=True)
            )
            p, q = (dual_numbers(x.as_matrix()).reshape(2, 4) for x in (m, n))
            both = lean.compose_dual_quaternions(p, q)
            close(lean.move_by_dual_quaternion(both, r), (m * n).apply(r), 1e-13)
            rows = [x.as_matrix()[:3] for x in (m, n)]
            close(lean.compose_poses(*rows), (m * n).as_matrix()[:3], 1e-14)
            bones, share = np.stack([m.as_matrix(), n.as_matrix()]), RNG.uniform()
            weights, ratios = np.array([share, 1 - share]), np.array([1 / share - 1])
            for moved, blend in (
                (lean.skin_by_poses(np.stack(rows), weights, r), blend_matrices),
                (
                    lean.skin_by_dual_quaternions(np.stack([p, q]), ratios, r),
                    blend_dual_quaternions,
                ),
            ):
                pose = blend(bones, weights)
                close(moved, pose[:3, :3] @ r + pose[:3, 3], 1e-12)
            turned, moved = lean.compose_with_steps(p[0], steps[0], q[0], steps[1])
            close(lean.move_by_quaternion_and_step(turned, moved, r), (m * n).apply(r), 1e-13)

    def test_costs_that_page_c_names(self) -> None:
        """A bone more is moved by, 9 + 9, weighed, 3, and added, 3; or eight numbers and a sign."""
        rows, dual, step = np.ones((4, 3, 4)), np.ones((4, 2, 4)), np.ones(3)
        q, two, four = dual[0, 0], np.ones(2), np.ones(4)
        for formula, given, cost in (
            (lean.compose_poses, rows[:2], "33 + 24"),
            (lean.move_by_pose, (rows[0], step), "9 + 9"),
            (lean.compose_with_steps, (q, step, q, step), "34 + 27"),
            (lean.move_by_quaternion_and_step, (q, step, step), "18 + 15"),
            (lean.compose_dual_quaternions, dual[:2], "48 + 40"),
            (lean.move_by_dual_quaternion, (dual[0], step), "21 + 18"),
            (lean.skin_by_poses, (rows[:2], two, step), "24 + 21"),
            (lean.skin_by_poses, (rows, four, step), "48 + 45"),
            (lean.skin_by_dual_quaternions, (dual[:2], two[1:], step), "37 + 32, 1 division"),
            (lean.skin_by_dual_quaternions, (dual, four[1:], step), "61 + 54, 1 division"),
        ):
            assert priced(count(formula, *given)).replace("\N{NO-BREAK SPACE}", " ") == cost


@pytest.mark.parametrize(
    ("name", "task", "cost"),
    [
        # 18 + 12 for two columns, 6 + 3 for the third.
        ("matrix", "compose", "24 + 15"),
        # 24 + 15 twice without a third column that nobody asks for, 3 + 2 for a length, 3 + 3 for
        # its vector and the trace, 10 + 7 for two columns of (3-3), and t times the angle.
        ("matrix", "between", "62 + 45, 2 divisions, 1 root, 3 functions"),
        # Two cross products, 6 + 3 each, and two lengths, 3 + 2 each.
        ("matrix", "repair", "18 + 10, 6 divisions, 2 roots"),
        ("quaternion", "compose", "16 + 12"),
        # Two cross products, 6 + 3 each, and two sums.
        ("quaternion", "many", "12 + 12"),
        # Those, a doubling and a product by w, 3 each.
        ("quaternion", "point", "18 + 12"),
        # Nine products, three doublings, six sums off the diagonal and five on it.
        ("quaternion", "matrix", "9 + 14"),
        # 4 + 3 for the cosine, 1 + 1 for the sine, 2 + 1 for the shares, 8 + 4 for the sum.
        ("quaternion", "between", "15 + 9, 1 division, 1 root, 3 functions"),
        # Halves: 2; vector: 12 + 9; scalar: 4 + 3; its length: 3 + 2; a doubling: 1.
        ("axis and angle", "compose", "21 + 14, 3 divisions, 1 root, 3 functions"),
        ("axis and angle", "matrix", "10 + 11, 2 functions"),
        ("three angles", "matrix", "14 + 4, 6 functions"),
        # Ten products, six sums and a division to two columns, 15 + 9 there.
        ("five numbers of a map", "point", "25 + 15, 1 division"),
        # Four inner angles: 4 products and 1 sum shared, 15 + 6 for five entries; 2 outer sums.
        ("three angles", "compose", "19 + 9, 11 functions"),
    ],
)
def test_as_counted_by_hand(name: str, task: str, cost: str) -> None:
    assert priced(ROWS[name].cost(task)).replace("\N{NO-BREAK SPACE}", " ") == cost


def paths() -> Array:
    """Random smooth motions, in steps of less than two degrees."""
    rng, t = np.random.default_rng(39), np.linspace(0, 7, 4000)
    through = [Rotation.random(8, rng=rng) for _ in range(20)]
    motions = np.array([RotationSpline(range(8), some)(t).as_matrix() for some in through])
    assert angle_of(motions[:, :-1], motions[:, 1:]).max() < np.radians(2)
    return motions


def angle_of(a: Array, b: Array) -> Array:
    return 2 * np.arcsin(np.minimum(np.linalg.norm(a - b, axis=(-2, -1)) / np.sqrt(8), 1))


NUMBERS: dict[str, Callable[[Array], Array]] = {
    "where the tip points": lambda m: np.stack(
        [np.arctan2(m[..., 1, 0], m[..., 0, 0]), np.arcsin(np.clip(m[..., 2, 0], -1, 1))], -1
    ),
    "three angles": lambda m: np.stack(euler_angles(m), -1),
    "axis and angle": lambda m: np.concatenate(
        [(found := axis_angle(m))[0], found[1][..., np.newaxis]], -1
    ),
    "rotation vector": rotation_vector,
    "matrix": lambda m: m.reshape(*m.shape[:-2], 9),
    "quaternion": lambda m: Quaternion.from_matrix(m).components,
    "direction": lambda m: m[..., 0],
    "two columns": lambda m: m[..., :2].reshape(*m.shape[:-2], 6),
    "five numbers of a map": five_numbers,
    "dual quaternion, of a turn and a step": lambda m: dual_numbers(homogeneous(m)),
}


def dual_numbers(poses: Array) -> Array:
    d = DualQuaternion.from_matrix(poses)
    return np.concatenate([d.real.components, d.dual.components], axis=-1)


def largest_jump(name: str, matrices: Array) -> float:
    """The largest change of the numbers over that of the orientation, in one step."""
    numbers = NUMBERS[name](matrices)
    change = np.linalg.norm(np.diff(numbers, axis=-2), axis=-1)
    return float((change / angle_of(matrices[..., :-1, :, :], matrices[..., 1:, :, :])).max())


def about(axis: Any, *degrees: float) -> Array:
    return rotation_matrix(axis, np.radians(degrees))


JUMPS = [
    ("where the tip points", about([0, -1, 0], 89.9, 90.1)),
    ("three angles", about([0, 1, 0], 89.9, 90.1)),
    ("three angles", about([1, 0, 0], 179.9, 180.1)),
    ("three angles", about([0, 0, 1], 179.9, 180.1)),
    ("axis and angle", about([1, 2, 2], -0.1, 0.1)),
    ("axis and angle", about([1, 2, 2], 179.9, 180.1)),
    ("rotation vector", about([1, 2, 2], 179.9, 180.1)),
    ("quaternion", about([1, 2, 2], 179.9, 180.1)),
    ("dual quaternion, of a turn and a step", about([1, 2, 2], 179.9, 180.1)),
]


class TestBreaks:
    @pytest.mark.parametrize("name", [r.written_as for r in LEDGER if r.breaks.text == "nowhere"])
    def test_nowhere(self, name: str) -> None:
        # An entry of a matrix moves no faster than the point whose coordinate it is, and a map
        # stretches.
        assert largest_jump(name, paths()) < (3.5 if "map" in name else 1.5)

    def test_every_notation_is_tried(self) -> None:
        breaking = {row.written_as for row in LEDGER if row.breaks.text != "nowhere"}
        assert breaking == {name for name, _ in JUMPS}
        assert set(NUMBERS) == set(ROWS)

    @pytest.mark.parametrize(("name", "path"), JUMPS)
    def test_where_it_says(self, name: str, path: Array) -> None:
        """A fifth of a degree, and the numbers change by 1 and more."""
        assert largest_jump(name, path) * np.radians(0.2) > 1

    @pytest.mark.parametrize(("more", "sign"), [(0, 1), (360, -1), (720, 1), (-360, -1)])
    def test_a_quaternion_forgets_pairs_of_whole_turns(self, more: float, sign: int) -> None:
        once, q = (
            Quaternion.from_axis_angle([1, 2, 2], np.radians(angle)) for angle in (100, 100 + more)
        )
        close(q.components, sign * once.components, 1e-14)
        close(np.degrees(q.axis_angle()[1]), 100 if sign > 0 else 260, 1e-12)


class TestTables:
    def test_the_last_page_knows_all_rows(self) -> None:
        assert "two columns" not in str(ledger("06-conclusions"))
        assert str(ledger("beyond-five-numbers")).count("\n") == len(LEDGER) + 1

    def test_no_such_page(self) -> None:
        with pytest.raises(ValueError, match=r"^page must be one of 01-introduction, .*; got '7'$"):
            ledger("7")

    def test_the_rows_that_a_page_adds_have_a_class(self) -> None:
        document = publish_doctree("")
        for tags in (["ledger"], ["claims"], ["nbval-ignore-output"]):
            table = publish_doctree(str(ledger("02-quaternions")), parser_name="myst").children
            document += nodes.container(
                "",
                *table,
                nb_element="cell_code",
                classes=["cell", *(f"tag_{tag}" for tag in tags)],
            )
        LedgerAndClaims(document).apply()
        written = publish_from_doctree(document, writer_name="html5").decode()
        page = BeautifulSoup(written, "html.parser")
        here = [row.td.get_text() for row in page.select(".tag_ledger .ledger tr.here")]
        names = [name.get_text() for name in page.select(".ledger strong")]
        assert names == ["quaternion"]
        assert here == [f"new here: {name}" for name in names]
        assert len(page.select(".ledger tbody tr")) > len(here) == len(page.select(".here"))
        (fold,) = page.select("details.rows")
        assert fold.find_parent(class_="cell")["class"][1] == "tag_claims"
        assert len(page("table")) == len(page.select(".ledger")) + 2 == 3
