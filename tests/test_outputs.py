"""Every number beside a figure is what rotedu, SciPy or NumPy computes, for any inputs.

The models in JavaScript compute what figures show; `oracles` computes their outputs in Python. Each
run tries other inputs. Set EXPLORE_SEED to the seed in a failure's message to repeat them.
"""

from typing import Any

import numpy as np
import pytest
from explorables import EXPLORABLES, SEED, expected, moved, states

from rotedu.figures.explorable import Explorable

TRIES = 20
OPPOSITE = [[0.6, 0, 0.8], [-0.6, 0, -0.8]]


def round_about(count: int) -> list[list[float]]:
    """Points round the pole, at uneven heights: symmetry would leave names without a side."""
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return [[np.cos(x), np.sin(x), 0.5 + np.sin(2 * x + 1) / 3] for x in angles]


# As many orientations as there may be, with a half turn from the third to the fourth.
SIX = [*np.eye(4)[:3].tolist(), [0, 0.1, 1, 0], [0.5, 0.5, 0.5, 0.5], [1, 0.5, 0, 0]]
THIRD = 0.75**0.5
# Inputs that chance does not find: ends of paths, other numbers of points, what is degenerate.
SPECIAL: dict[str, list[dict[str, Any]]] = {
    "animate": [{"poses": SIX[2:], "t": 1.0}, {"poses": SIX}],
    "camera_by_hand": [{"path": "curve", "roll": "kept upright", "u": 0.54}, {"u": 0.0}],
    "carried_around_by_hand": [{"t": 0.0}, {"t": 1.0}],
    "closed_curve_by_hand": [
        *({"points": round_about(n), "u": u} for n, u in ((3, 1.0), (5, 1.0), (8, 0.5))),
        {"points": [*OPPOSITE, [0, 1, 0]]},
    ],
    "control_points_by_hand": [
        {"points": [[1, 0, 0], [0, 1, 0], [0.2, -0.5, 0.8]], "one_circle": True, "step": 4},
        *({"step": step, "printed_double": step > 3} for step in (1.0, 3.5)),
        {"printed_axis": True},
    ],
    "euler_angles_by_hand": [{"v": -90.0, "t": 0.25}, {"u": 180.0, "v": 90.0, "w": 0.0}],
    "figure_1_by_hand": [{"theta": 0.0}],
    "grab_the_spoon": [{"way": "by hand", "spoon": [-1.0, 0.0, 0.0, 0.0]}],
    "mean_by_hand": [
        # A sum of zero.
        {"poses": [[1, 0, 0, 0], [-0.5, THIRD, 0, 0], [-0.5, -THIRD, 0, 0]], "flip": False},
    ],
    "one_name": [{"angle": angle} for angle in (180.0, 360.0)],
    "slerp_by_hand": [
        {"p": OPPOSITE[0], "q": OPPOSITE[1]},
        {"p": OPPOSITE[0], "q": OPPOSITE[0], "flip": True},
        {"p": OPPOSITE[0], "q": OPPOSITE[0]},
        {"flip": True},
    ],
    "spinning_by_hand": [
        *({"t": t, "h": h} for t in (0.0, 0.01, 0.6, 1.5) for h in (0.01, 0.03, 0.1)),
    ],
    "two_mirrors_by_hand": [
        {"first": first, "second": second} for first in (0, 355) for second in (4, 170, 180)
    ],
    "worn_spoons_by_hand": [
        *(
            {"precision": precision, "turns": 997.0, "repair": repair, "magnified": not repair}
            for precision in ("2 decimals", "3 decimals", "16 bits", "32 bits")
            for repair in (False, True)
        ),
        # The quaternion's error is a tie: 0.725 %.
        {"precision": "3 decimals", "turns": 988.0, "repair": False, "magnified": True},
    ],
}


@pytest.mark.filterwarnings("ignore:.* are almost ")
@pytest.mark.parametrize("name", EXPLORABLES)
def test_outputs_are_those_of_the_oracle(name: str) -> None:
    rng = np.random.default_rng(SEED)
    figure = Explorable(EXPLORABLES[name])
    cases = [{}, *figure.scene.tries.values(), *SPECIAL.get(name, ())]
    cases += [moved(rng, name) for _ in range(TRIES)]
    for case, state in zip(cases, states(name, cases), strict=True):
        inputs = figure.start | figure.checked(case) | state.get("inputs", {})
        told, wanted = state.get("outputs", state), expected(name, inputs)
        where = f"EXPLORE_SEED={SEED}: {name}({inputs})"
        assert told.keys() == wanted.keys(), where
        for key, value in wanted.items():
            if isinstance(value, str) or isinstance(told[key], str):
                assert told[key] == value, (key, where)
            else:
                np.testing.assert_allclose(
                    told[key], value, rtol=2e-6, atol=2e-6, err_msg=f"{key}: {where}"
                )


@pytest.mark.parametrize("name", EXPLORABLES)
def test_what_a_model_corrects_it_shows_as_if_it_were_given(name: str) -> None:
    rng = np.random.default_rng(SEED)
    cases = [moved(rng, name) for _ in range(TRIES)]
    found = states(name, cases)
    corrected = [c | state.get("inputs", {}) for c, state in zip(cases, found, strict=True)]
    for state, again in zip(found, states(name, corrected), strict=True):
        for kind in ("parts", "outputs"):
            numbers = numbers_of(state.get(kind))
            assert numbers_of(again.get(kind)) == pytest.approx(numbers, abs=1e-6)


def numbers_of(value: Any) -> list[float]:
    """All numbers of a state, in its order."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        return [number for item in value for number in numbers_of(item)]
    return [value] if isinstance(value, int | float) else []
