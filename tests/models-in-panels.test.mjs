/* After a change of inputs the panel of a figure is the one that Python writes for these inputs. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { figure, liveScene, tell } from "../viewer/test/dom.js";
import * as models from "../rotedu/scenes/models.js";
import { explore } from "../viewer/src/explore.js";
import { read } from "./cases.mjs";

const { seed, figures } = await read("models");

/** What a panel shows, by name; Python rounds some numbers to six digits. */
function shown(element) {
  const all = (selector) => [...element.querySelectorAll(selector)];
  const numbers = (path) => (path.match(/-?[\d.]+/g) ?? []).map(Number);
  return {
    texts: all("output").map(({ name, textContent, className }) => [name, textContent, className]),
    paths: all("[data-curve]").map((curve) => numbers(curve.getAttribute("d"))),
    marks: all(".explorable-marks span").map(({ hidden }) => hidden),
    names: all("[data-name]").map(({ hidden, style }) => [hidden, hidden || style.top]),
    places: all("[data-mark]").map((mark) => numbers(mark.getAttribute("x1"))),
    checked: all("[type=checkbox], [type=radio]").map(({ checked }) => checked),
  };
}

function near(mine, python, within, where) {
  assert.deepEqual(mine.map(({ length }) => length), python.map(({ length }) => length), where);
  mine.forEach((numbers, i) =>
    numbers.forEach((x, k) => {
      assert.ok(Math.abs(x - python[i][k]) <= within, `${where}: ${x}, Python: ${python[i][k]}`);
    }),
  );
}

for (const { spec, panel, cases } of figures) {
  test(`the panel of ${spec.name} shows what Python shows`, () => {
    const element = figure(panel);
    const { set } = explore(element, liveScene(element.firstElementChild), spec, models);
    for (const { inputs, error, panel: wanted } of cases) {
      const where = `EXPLORE_SEED=${seed}: ${spec.name}(${JSON.stringify(inputs)})`;
      set(inputs);
      if (error) continue;
      const other = document.createElement("div");
      other.innerHTML = wanted;
      const [mine, python] = [shown(element), shown(other)];
      for (const kind of ["texts", "marks", "names", "checked"]) {
        assert.deepEqual(mine[kind], python[kind], where);
      }
      near(mine.paths, python.paths, 0.11, where);
      near(mine.places, python.places, 0.06, where);
      for (const { name, value } of element.querySelectorAll("[type=range], [type=number]")) {
        const key = name.replace("-number", "");
        // A model may have corrected it.
        const now = JSON.parse(element.dataset.values)[key];
        assert.ok(Math.abs(value - now) <= spec.inputs[key].step / 2, `${where}: ${name}`);
      }
    }
  });

  test(`each slider of ${spec.name} moves its own input`, () => {
    const element = figure(panel);
    explore(element, liveScene(element.firstElementChild), spec, models);
    for (const slider of element.querySelectorAll("[type=range]")) {
      const before = JSON.parse(element.dataset.values);
      const { low, high } = spec.inputs[slider.name];
      const wanted = before[slider.name] === high ? low : high;
      slider.value = String(wanted);
      tell(slider, "input");
      const after = JSON.parse(element.dataset.values);
      const given = { ...before, [slider.name]: wanted };
      const { inputs: corrected = {} } = models[spec.model](given, spec.constants, [slider.name]);
      for (const name of Object.keys(spec.inputs).filter((name) => !(name in corrected))) {
        assert.deepEqual(after[name], name === slider.name ? wanted : before[name], name);
      }
    }
  });
}
