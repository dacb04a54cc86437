"""Wrong answers to the exercises of Chapter 2, with words of the hints."""

from typing import Any

import numpy as np

DIAGONAL = np.ones(3)
PAIRS = [([0, 0, 1], 180), ([1, 0, 0], 360), ([0, 1, 0], 90), (DIAGONAL, 120)]
HALVED = [(axis, angle / 2) for axis, angle in PAIRS]
RADIANS = [(axis, np.deg2rad(angle)) for axis, angle in PAIRS]
NO_AXIS = [PAIRS[0], ([0, 0, 0], 0), *PAIRS[2:]]
NOT_THE_THIRD = [*PAIRS[:2], ([0, 1, 0], -90), PAIRS[3]]
U, V, W = np.eye(3)


def tracked() -> np.ndarray:
    """The measurements of Exercise 2.6, made here with Hamilton's product anew."""
    tracker = np.random.default_rng(4)
    axes = tracker.normal(size=(1000, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    half = tracker.normal(scale=np.deg2rad(8), size=1000) / 2
    w1, v1 = np.cos(half), np.sin(half)[:, None] * axes
    w2, v2 = np.cos(np.deg2rad(50)), np.sin(np.deg2rad(50)) * np.array([1, -2, 2]) / 3
    vectors = w1[:, None] * v2 + w2 * v1 + np.cross(v1, v2)
    measured = np.column_stack([w1 * w2 - v1 @ v2, vectors])
    return measured * tracker.choice([-1, 1], size=(1000, 1))


U4 = np.array([1, 0, 0, 0])
TRUTH = np.array([np.cos(np.deg2rad(50)), *(np.sin(np.deg2rad(50)) * np.array([1, -2, 2]) / 3)])

WRONG: dict[str, list[tuple[Any, str]]] = {
    "2.1": [
        ([1, 7, 1, -2], "other order"),
        ([1, 7, 1, 0], "missing"),
        ([5, 7, 1, 2], "wrong sign"),
        ([3, 7, 1, 2], "incomplete"),
        ([3, 2, 0, 0], "number by number"),
        ([0, 0, 0, 0], "not the product"),
    ],
    "2.2": [
        ([0.5, 0, 0.6 * 0.75**0.5, 0.8 * 0.75**0.5], "too far"),
        ([0.75**0.5, 0, -0.3, -0.4], "opposite sense"),
        ([np.cos(30), 0, 0.6 * np.sin(30), 0.8 * np.sin(30)], "radians"),
        ([0.75**0.5, 0, 1.5, 2], "norm 1"),
        ([1, 0, 0, 0], "another rotation"),
    ],
    "2.3": [
        ((HALVED, V), "half"),
        ((RADIANS, V), "radians"),
        ((NO_AXIS, V), "zero vector"),
        ((NOT_THE_THIRD, V), "third"),
        ((PAIRS, W), "wrong way round"),
        ((PAIRS, U), "elsewhere"),
    ],
    "2.4": [
        (([0, 0, 0, 1], [0.5, 0.5, 0.5, 0.5]), "V came before U"),
        (([0, 0, 0, 1], [1, 1, 1, -1]), "norm 1"),
        (([0, 0, 0, 1], [1, 0, 0, 0]), "quarter turns make another"),
        (([-1, 0, 0, 0], [0.5, 0.5, 0.5, -0.5]), "half turns make another"),
    ],
    "2.5": [
        ((40, -V, U, "both"), "exchanged"),
        ((0.698, U, -V, "both"), "radians"),
        ((20, U, -V, "both"), "half"),
        ((40, U, V, "both"), "second colleague"),
        ((40, W, -V, "both"), "first colleague"),
        ((40, U, -V, "first"), "judgement"),
    ],
    "2.6": [
        (tracked().mean(axis=0), "random signs"),
        (abs(tracked()).mean(axis=0), "Absolute values"),
        (TRUTH * [1, -1, -1, -1], "inverse"),
        (TRUTH + 0.02 * U4, "close"),
        ([0, 0, 0, 0], "zeros"),
        ([0, 0, 0, 1], "far"),
    ],
}
