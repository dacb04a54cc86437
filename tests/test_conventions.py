"""Conventions of other software: what `book/conventions.md` says, by running what is installed."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
import pyvista
from node import run_node
from notebook_language import chapters
from pytransform3d import rotations as pr
from scipy.spatial.transform import Rotation
from spheres import E1, E2, E3, Array, close

from rotedu.figures.gltf import scene_gltf
from rotedu.general_rotation import matrix_from_euler_angles
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion

PAGE = Path(__file__).parents[1] / "book" / "conventions.md"
QUARTER = {"x": 0.0, "y": 0.0, "z": 0.5**0.5, "w": 0.5**0.5}
ANGLES = (0.3, 0.5, 0.7)
FIRST, SECOND, THIRD = map(rotation_matrix, np.eye(3), ANGLES)


def row(software: str) -> list[str]:
    """Cells of a row of the table: axes, quaternion, Euler angles, matrices, what rotations do."""
    (line,) = (
        line for line in PAGE.read_text("utf-8").splitlines() if line.startswith(f"| {software}")
    )
    return line.strip("| ").split(" | ")[1:]


def in_order(cell: str) -> list[float]:
    """A quarter turn about the third axis, in the order that a cell names first."""
    return [QUARTER[letter] for letter in cell[1 : cell.index(")")].split(", ")]


def test_this_book() -> None:
    axes, order, angles, matrices, rotation = row("this book")
    q = Quaternion.from_axis_angle(E3, np.pi / 2)
    assert (axes, rotation) == ("right-handed", "moves points")
    close(q.components, in_order(order))
    close(q.rotate(E1), E2)
    assert angles == "U, V, W, fixed axes"
    close(matrix_from_euler_angles(*ANGLES)[:3, :3], THIRD @ SECOND @ FIRST)
    assert matrices == "times a column"
    close(q.matrix() @ E1, E2)


def test_scipy() -> None:
    axes, order, angles, matrices, rotation = row("SciPy")
    quarter = Rotation.from_rotvec(np.pi / 2 * E3)
    close(quarter.as_quat(), in_order(order))
    close(quarter.as_quat(scalar_first=True), in_order(order[order.index("; ") + 2 :]))
    assert (axes, rotation) == ("right-handed", "moves points")
    close(quarter.apply(E1), E2)
    assert matrices == "times a column"
    close(quarter.as_matrix() @ E1, E2)
    assert "capital letters are carried, small ones are fixed" in angles
    close(Rotation.from_euler("XYZ", ANGLES).as_matrix(), FIRST @ SECOND @ THIRD)
    close(Rotation.from_euler("xyz", ANGLES).as_matrix(), THIRD @ SECOND @ FIRST)


def test_pytransform3d() -> None:
    axes, order, angles, matrices, rotation = row("[pytransform3d]")
    quarter = pr.quaternion_from_axis_angle([*E3, np.pi / 2])
    close(quarter, in_order(order))
    assert (axes, rotation) == ("right-handed", "moves points")
    close(pr.q_prod_vector(quarter, E1), E2)
    assert matrices == "times a column"
    close(pr.matrix_from_quaternion(quarter) @ E1, E2)
    assert angles.endswith("the function says whether they are carried")
    for extrinsic, product in [(False, FIRST @ SECOND @ THIRD), (True, THIRD @ SECOND @ FIRST)]:
        close(pr.matrix_from_euler(ANGLES, 0, 1, 2, extrinsic), product)


def test_gltf_as_the_package_writes_it_and_the_viewer_reads_it() -> None:
    plotter = pyvista.Plotter(off_screen=True)
    placed = np.eye(4)
    placed[:3, :3], placed[:3, 3] = FIRST, [1, 2, 3]
    plotter.add_mesh(pyvista.Sphere(theta_resolution=4, phi_resolution=4)).user_matrix = placed
    content = scene_gltf(plotter)
    document = json.loads(content[20 : 20 + int.from_bytes(content[12:16], "little")])
    node = document["nodes"][0]["matrix"]
    assert row("[glTF 2.0]")[3] == "times a column; stored by columns"
    close(np.reshape(node, (4, 4), order="F"), placed, 1e-7)


def test_three() -> None:
    run_node("--test", "tests/conventions.test.mjs")


@pytest.mark.parametrize("angle", [0.3, 3.0])
def test_changing_hands(angle: float) -> None:
    mirror = np.diag([1, 1, -1])
    q = Quaternion.from_axis_angle([1, 2, 3], angle)
    mirrored: Array = mirror @ q.matrix() @ mirror
    x, y, z = q.v
    close(Quaternion(q.w, [-x, -y, z]).matrix(), mirrored)


def test_fixed_axes_in_the_other_order_turn_along() -> None:
    fixed = Rotation.from_euler("xyz", ANGLES).as_matrix()
    close(fixed, Rotation.from_euler("ZYX", ANGLES[::-1]).as_matrix())


def test_a_listing_has_no_annotation_that_is_not_explained() -> None:
    outputs = [output for page in chapters() for cell in page.code for output in cell.outputs]
    listings = [output.get("data", {}).get("text/plain", "") for output in outputs]
    used = set(re.findall(r"(?:: |-> )([A-Z]\w+)", "".join(t for t in listings if "@checked" in t)))
    assert len(used) > 10
    section = PAGE.read_text("utf-8").partition("(listings)=")[2].partition("(bad-input)=")[0]
    assert used - {"Quaternion", "DualQuaternion"} <= set(re.findall(r"`(\w+)`", section))
