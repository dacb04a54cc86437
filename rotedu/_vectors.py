"""Vectors and matrices with their components first: shapes (3, ...) and (3, 3, ...).

An array of numbers, such as one angle for each vector, then multiplies vectors without
reshaping, and the functions of this package read like their equations.
"""

from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]


def dot(a: Array, b: Array) -> Array:
    """Dot products."""
    return np.add.reduce(a * b)


def cross(a: Array, b: Array) -> Array:
    """Cross products, in three dimensions."""
    (au, av, aw), (bu, bv, bw) = a, b
    return np.stack([av * bw - aw * bv, aw * bu - au * bw, au * bv - av * bu])


def length(v: Array) -> Array:
    """Lengths of vectors."""
    return np.sqrt(dot(v, v))


def safe_length(v: Array) -> Array:
    """Lengths of vectors whose squares may overflow or underflow."""
    if v.dtype.kind == "O":
        return length(v)
    largest = np.max(np.abs(v), axis=0)
    return largest * length(v / np.where(largest == 0, 1, largest))


def axis_and_length(v: Array, negligible: Array | float = 0) -> tuple[Array, Array]:
    """Divide vectors by their lengths; return both. Negligible vectors become (1, 0, 0)."""
    size = safe_length(v)
    zero = size <= negligible
    first = np.reshape([1, 0, 0], (3,) + (1,) * (v.ndim - 1)).astype(v.dtype)
    return np.where(zero, first, v) / np.where(zero, 1, size), size


def unit(v: Array) -> Array:
    """Divide vectors by their lengths; zero vectors stay as they are."""
    size = length(v)
    return v / np.where(size == 0, 1, size)


def times(matrix: Array, vectors: Array) -> Array:
    """Multiply vectors, as columns, by matrices."""
    rows, columns = matrix.shape[:2]
    if matrix.size == rows * columns and vectors.ndim > 1:
        # One matrix for all: the product that BLAS computes.
        images = matrix.reshape(rows, columns) @ vectors.reshape(columns, -1)
        return images.reshape(rows, *vectors.shape[1:])
    return np.add.reduce(matrix * vectors, axis=1)


def product(a: Array, b: Array) -> Array:
    """Multiply matrices."""
    return np.add.reduce(a[:, :, np.newaxis] * b, axis=1)


def transpose(matrix: Array) -> Array:
    """Exchange rows and columns."""
    return matrix.swapaxes(0, 1)
