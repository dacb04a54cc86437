"""Two columns and five numbers: against QR and SciPy, and without a jump."""

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from scipy.spatial.transform import Rotation
from spheres import E1, E2, Array, close, random_units, refuses, vectors

from rotedu.five_numbers import five_numbers, matrix_from_five_numbers, matrix_from_two_columns

RNG = np.random.default_rng(1964)
TURNS = Rotation.random(20_000, rng=RNG)
M1 = TURNS.as_matrix()


class TestTwoColumns:
    @given(vectors(3), vectors(3))
    def test_against_qr_and_in_what_it_says(self, a: Array, b: Array) -> None:
        across = np.linalg.norm(np.cross(a, b))
        assume(across > 1e-3 * np.linalg.norm(a) * np.linalg.norm(b) > 1e-9)
        found = matrix_from_two_columns(a, b)
        close(found.T @ found, np.eye(3), 1e-12)
        close(found[:, 2], np.cross(a, b) / across, 1e-12)
        close(found[:, 0], a / np.linalg.norm(a))
        q, r = np.linalg.qr(np.stack([a, b], axis=1))
        close(found[:, :2], q * np.sign(np.diag(r)), 1e-12)

    def test_gives_back_a_rotation(self) -> None:
        a, b, _ = np.moveaxis(M1, -1, 0)
        close(matrix_from_two_columns(3 * a, b / 7 - 5 * a), M1, 1e-12)

    @pytest.mark.parametrize("b", [E1, -E1, [1, 1e-9, 0]])
    def test_parallel(self, b: Any) -> None:
        refuses("a and b are parallel: no unique second", matrix_from_two_columns, 2 * E1, b)
        refuses("a and b at index (1,) are parallel", matrix_from_two_columns, E1, [E2, b])

    def test_nearly_parallel(self) -> None:
        close(matrix_from_two_columns(E1, [1, 1e-6, 0]), np.eye(3), 1e-9)

    @pytest.mark.parametrize(("kind", "apart"), [(np.float64, 1e-6), (np.float32, 3e-3)])
    def test_stays_a_rotation_where_they_are_nearly_parallel(self, kind: Any, apart: float) -> None:
        a = RNG.normal(size=(300, 3))
        b = a + apart * np.linalg.norm(a, axis=1, keepdims=True) * random_units(300, 3, rng=RNG)
        across = np.linalg.norm(np.cross(a, b), axis=1) / np.linalg.norm(a, axis=1) ** 2
        clear = across > apart / 2
        found = matrix_from_two_columns(a[clear].astype(kind), b[clear].astype(kind))
        close(found.swapaxes(1, 2) @ found - np.eye(3), 0, 10 * np.finfo(kind).eps)


class TestFiveNumbers:
    def test_there_and_back(self) -> None:
        close(matrix_from_five_numbers(five_numbers(M1)), M1, 1e-12)

    def test_is_a_map_of_the_sphere(self) -> None:
        """A point of the map, the point of the sphere and the pole are in one line."""
        pole = np.array([2**0.5, 0, 0, 0, 0, 0])
        sphere = np.concatenate([M1[:, :, 0], M1[:, :, 1]], axis=1)
        plane = np.insert(five_numbers(M1), 0, 0, axis=1)
        # On the map the sphere's radius is 1.
        ray, away = sphere - pole, 2**0.5 * plane - pole
        close(np.sum(ray * away, axis=1), np.linalg.norm([ray, away], axis=2).prod(axis=0))

    @pytest.mark.parametrize("size", [1e-3, 1e-6])
    def test_nothing_jumps_anywhere(self, size: float) -> None:
        """Also across half turns, where axes turn over and the sign of a quaternion jumps."""
        axes = random_units(len(TURNS), 3, rng=RNG)
        half = Rotation.from_rotvec(np.pi * random_units(len(TURNS), 3, rng=RNG))
        for turns in (TURNS, half):
            near = Rotation.from_rotvec(size * axes) * turns
            moved = five_numbers(near.as_matrix()) - five_numbers(turns.as_matrix())
            assert np.linalg.norm(moved, axis=1).max() < 3.42 * size

    def test_what_belongs_to_no_rotation(self) -> None:
        numbers = RNG.normal(size=(1000, 5))
        found = matrix_from_five_numbers(numbers)
        close(found.swapaxes(1, 2) @ found, np.broadcast_to(np.eye(3), (1000, 3, 3)), 1e-12)
        two = "the two columns of numbers"
        for columns in ([0] * 5, [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [2, 0, 0, 0, 0]):
            refuses(f"{two} are parallel: no unique second", matrix_from_five_numbers, columns)
        refuses(f"{two} at index (1,) are", matrix_from_five_numbers, [[0, 0, 0, 2.4, 0], [0] * 5])

    @pytest.mark.parametrize("size", [1e9, 1e200])
    def test_large_numbers_stand_near_the_pole(self, size: float) -> None:
        numbers = RNG.normal(size=(1000, 5))
        a, b = np.broadcast_to(E1, (1000, 3)), numbers[:, 2:]
        close(matrix_from_five_numbers(size * numbers), matrix_from_two_columns(a, b), 1e-6)
