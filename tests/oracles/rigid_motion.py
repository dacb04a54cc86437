"""The outputs of the figures of page C, by rotedu and numpy."""

from typing import Any

import numpy as np

from rotedu.arcs import angle_between, rotation_between
from rotedu.general_rotation import compose, rotation_u, rotation_v, translation
from rotedu.ordinary_rotation import transform
from rotedu.rigid_motion import blend_dual_quaternions, blend_matrices
from rotedu.scenes.rigid_motion import BANDS, ELBOW, STATIONS, WRIST, radii

SIDES = 16


def the_arm(skin: str, twist: float, bend: float) -> dict[str, float]:
    repair = skin == "the same, repaired"
    if skin != "matrices, averaged" and abs(twist - 180) < 0.01:
        twist = 179.99  # There are two averages; the other is its mirror image.
    joint = translation([ELBOW, 0, 0])
    fore = compose(joint, rotation_v(-np.radians(bend)), np.linalg.inv(joint))
    bones = np.stack([np.eye(4), fore, fore @ rotation_u(np.radians(twist))])
    parts = [
        np.clip((STATIONS - x + r) / (2 * r), 0, 1)
        for x, r in zip((ELBOW, WRIST), BANDS, strict=True)
    ]
    weights = np.stack([1 - parts[0], parts[0] - parts[1], parts[1]], axis=1)
    if skin == "dual quaternions":
        poses = blend_dual_quaternions(bones, weights)
    else:
        poses = blend_matrices(bones, weights, repair)
    wide, thick = radii().T
    angle = 2 * np.pi * np.arange(1, SIDES + 1) / SIDES
    rest = np.stack(
        np.broadcast_arrays(
            STATIONS[:, np.newaxis], np.outer(wide, np.cos(angle)), np.outer(thick, np.sin(angle))
        ),
        axis=-1,
    )
    moved = transform(poses[:, np.newaxis], rest)
    middle = np.searchsorted(STATIONS, WRIST)
    lengths = [np.linalg.norm(np.diff(rings, axis=0), axis=-1) for rings in (rest, moved)]
    out = moved[middle, SIDES // 4 - 1] - transform(bones[1], [STATIONS[middle], 0, 0])
    return {
        "wrist": 100 * np.linalg.norm(out) / thick[middle],
        "stretch": 100 * np.max(lengths[1] / lengths[0]),
        "volume": 100 * enclosed(moved) / enclosed(rest),
    }


def enclosed(rings: Any) -> float:
    """The volume between a tube's triangles, as a sum of determinants."""
    a, b = rings[:-1], np.roll(rings[:-1], -1, axis=1)
    c, d = rings[1:], np.roll(rings[1:], -1, axis=1)
    triangles = np.concatenate([np.stack([a, b, c], axis=-1), np.stack([b, d, c], axis=-1)])
    return float(abs(np.linalg.det(triangles).sum()) / 6)


def the_wrist(twist: float) -> dict[str, float]:
    return {"wrist": 100 * abs(np.cos(np.radians(twist) / 2))}


def from_a_to_b(a: Any, b: Any) -> dict[str, float]:
    turned = rotation_between(a, b)
    angle = np.degrees(np.arccos(np.clip((np.trace(turned) - 1) / 2, -1, 1)))
    assert abs(angle - np.degrees(angle_between(a, b))) < 1e-3
    return {"angle": np.degrees(angle_between(a, b)), "share": 1 / (1 + np.cos(np.radians(angle)))}
