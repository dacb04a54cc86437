"""Labels of figures that answer the hand: whatever a slider does, none lies on another."""

from typing import Any

import numpy as np
import pytest
from explorables import EXPLORABLES
from live_pages import PHONE, Open, come_to, live, open_figure, open_page, pages, values
from spheres import random_units

from rotedu.figures import Choice, Slider, Switch

__all__ = ["open_figure", "open_page", "pages"]

WIDTHS = {"wide": {"viewport": {"width": 1440, "height": 900}}, "phone": PHONE}
# By how many pixels two labels may cover each other: less than what is empty around letters.
COVERED = 1.5
# How far a label may be pushed, in heights of a label: it still stands beside its point.
FAR = 2.5
# Sets inputs one after the other; returns for each the labels that cover each other, and the push.
SWEEP = """async ([figure, states]) => {
    const frame = () => new Promise(requestAnimationFrame);
    const aside = ({ style }) => style.getPropertyValue("--aside") || "0 0";
    const found = [];
    for (const detail of states) {
        figure.dispatchEvent(new CustomEvent("rotedu:set", { detail }));
        await frame();
        await frame();
        const labels = [...figure.querySelectorAll(".scene-label")]
            .filter((label) => getComputedStyle(label).visibility === "visible");
        const boxes = labels.map((label) => label.getBoundingClientRect());
        let worst = [-Infinity];
        boxes.forEach((a, i) => boxes.slice(0, i).forEach((b, j) => {
            const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
            const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
            const names = [labels[i], labels[j]].map((label) => label.dataset.label).join(" on ");
            if (Math.min(across, down) > worst[0]) worst = [Math.min(across, down), names];
        }));
        const ways = labels.map((label) =>
            Math.hypot(...aside(label).split(" ").map(parseFloat)) / label.offsetHeight);
        found.push([...worst, Math.max(0, ...ways)]);
    }
    return found;
}"""


# Sets the spoon; returns how far down the name of its axis is then, as a share of the height.
NAMED = """async ([figure, spoons]) => {
    const [scene, label] = [".scene", "[data-label='axis']"].map((s) => figure.querySelector(s));
    const found = [];
    for (const spoon of spoons) {
        figure.dispatchEvent(new CustomEvent("rotedu:set", { detail: { spoon, way: "by hand" } }));
        await new Promise(requestAnimationFrame);
        await new Promise(requestAnimationFrame);
        const [all, name] = [scene, label].map((element) => element.getBoundingClientRect());
        found.push((name.top - all.top) / all.height);
    }
    return found;
}"""


def swept(inputs: dict[str, Any], count: int = 13) -> list[dict[str, Any]]:
    """Each slider from end to end, for each switch and choice, the rest as at the start."""
    switched: list[dict[str, Any]] = [{}]
    for name, kind in inputs.items():
        if isinstance(kind, Switch):
            switched += [{name: True}, {name: False}]
        if isinstance(kind, Choice):
            switched += [{name: option} for option in kind.options]
    return [
        base | {name: float(value)}
        for base in switched
        for name, kind in inputs.items()
        if isinstance(kind, Slider)
        for value in np.linspace(kind.low, kind.high, count)
    ]


def check_sweep(figure: Any, name: str, states: list[dict[str, Any]]) -> None:
    """Set a figure to some states, each from its start, and look at its labels."""
    come_to(figure.locator(".scene"))
    told = values(figure)
    start = {key: told[key] for key in EXPLORABLES[name].inputs}
    found = figure.page.evaluate(SWEEP, [figure.element_handle(), [start | s for s in states]])
    assert len(found) == len(states)
    for state, (covered, *labels, pushed) in zip(states, found, strict=True):
        assert covered is None or covered < COVERED, (state, covered, labels)
        assert pushed < FAR, (state, pushed)


@pytest.mark.slow
@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("name", EXPLORABLES)
def test_no_label_lies_on_another(name: str, width: str, open_figure: Open) -> None:
    figure = live(open_figure(name, **WIDTHS[width]))
    check_sweep(figure, name, swept(EXPLORABLES[name].inputs))


@pytest.mark.parametrize(
    ("name", "states"),
    [
        ("figure_1_by_hand", [{"theta": 330.0}, {"theta": 60.0}, {"theta": 30.0}]),
        ("control_points_by_hand", [{"one_circle": True, "step": step} for step in (4.0, 2.0)]),
    ],
)
def test_labels_that_met_give_way(name: str, states: list[Any], open_figure: Open) -> None:
    check_sweep(live(open_figure(name, **PHONE)), name, states)


def test_on_a_phone_the_axis_is_named_beside_the_spoon(open_figure: Open) -> None:
    figure = live(open_figure("grab_the_spoon", **PHONE))
    spoons = random_units(40, 4).tolist()
    found = figure.page.evaluate(NAMED, [figure.element_handle(), spoons])
    assert max(found) < 0.45
