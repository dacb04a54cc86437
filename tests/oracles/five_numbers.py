"""The outputs of the figures of page D, by SciPy and NumPy."""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation


def one_name(angle: float) -> dict[str, Any]:
    """The first two numbers, the first of which is not negative."""
    x, _, _, w = Rotation.from_rotvec([np.radians(angle), 0, 0]).as_quat()
    sign = np.sign(w) if abs(w) > 1e-12 else np.sign(x)
    w, x = (f"{round(sign * part, 2) + 0.0:.2f}".replace("-", "−") for part in (w, x))
    return {"q": f"{angle:.0f}°; {w}, {x}"}


def pull_the_thread(spoon: Any, thread: Any, pulled: float) -> dict[str, Any]:
    """The thread on the sphere of quaternions, pulled by averages of red and black places."""
    places = np.array(thread, float)
    places[0] *= np.sign(places[0, 0])
    for k in range(1, len(places)):
        places[k] *= np.sign(places[k] @ places[k - 1])
    if pulled:
        places = even(places)
        trembling = np.sin(np.arange(1, 41)[:, np.newaxis] * np.arange(2, 6) ** 2)
        places[1:-1] = normalised(places[1:-1] + 0.02 * trembling[1:-1])
        for half in range(2 * int(np.ceil(4000 * pulled**2))):
            inner = slice(1 + half % 2, -1, 2)
            before, after = places[half % 2 : -2 : 2], places[2 + half % 2 :: 2]
            places[inner] = normalised(2 * places[inner] + before + after)
    degrees = 2 * np.degrees(gaps(places).sum())
    shortest = 2 * np.degrees(gaps(places[[0, -1]])[0])
    crossings = int((places[1:, 0] * places[:-1, 0] < 0).sum())
    home = abs(abs(places[-1, 0]) - 1) < 1e-9
    tight = ("sticks" if crossings % 2 else "gone") if home else "tight"
    return {
        "crossings": crossings,
        "degrees": degrees,
        "home": "yes" if home else "no",
        "verdict": tight if degrees <= shortest + 3 else "loose",
    }


def normalised(q: Any) -> Any:
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


def gaps(places: Any) -> Any:
    """Angles from each place to the next."""
    chords = np.linalg.norm(np.diff(places, axis=0), axis=1)
    return 2 * np.arcsin(np.clip(chords / 2, 0, 1))


def even(places: Any) -> Any:
    """Forty places at equal distances along a thread."""
    far = np.concatenate([[0], np.cumsum(gaps(places))])
    keep = np.concatenate([[True], np.diff(far) > 1e-9])
    at = np.linspace(0, far[-1], 40)
    k = np.clip(np.searchsorted(far[keep], at * (1 - 1e-12)), 1, keep.sum() - 1)
    a, b = places[keep][k - 1], places[keep][k]
    whole = (far[keep][k] - far[keep][k - 1])[:, np.newaxis]
    part = at[:, np.newaxis] - far[keep][k - 1][:, np.newaxis]
    return (np.sin(whole - part) * a + np.sin(part) * b) / np.sin(whole)
