/* After a change of inputs the panel of a figure is the one that is written for these inputs. */
// Before the viewer, which asks the document at once.
import "../viewer/test/dom.js";
import assert from "node:assert/strict";
import { test } from "node:test";
import * as models from "../rotedu/scenes/models.js";
import { explore } from "../viewer/src/explore.js";
import { fromText } from "../viewer/src/link.js";
import { panelHtml } from "../viewer/src/panel-html.js";
import { figure, liveScene, tell, tick } from "../viewer/test/dom.js";
import { answer, read } from "./cases.mjs";

const { seed, figures } = await read("models");

/** What a panel shows. */
function shown(element) {
  const all = (selector) => [...element.querySelectorAll(selector)];
  return {
    texts: all("output").map(({ name, textContent, className }) => [name, textContent, className]),
    paths: all("[data-curve]").map((curve) => curve.getAttribute("d")),
    marks: all(".explorable-marks span").map(({ hidden }) => hidden),
    names: all("[data-name]").map(({ hidden, style }) => [hidden, hidden || style.top]),
    places: all("[data-mark]").map((mark) => Number(mark.getAttribute("x1")).toFixed(1)),
    checked: all("[type=checkbox], [type=radio]").map(({ checked }) => checked),
  };
}

for (const { spec, cases } of figures) {
  const model = models[spec.model];
  const written = (start) => panelHtml({ ...spec, start }, model(start, spec.constants, []));
  const begun = () => {
    const element = figure(written(spec.start));
    const view = liveScene(element.firstElementChild);
    const { set } = explore(element, view, spec, models);
    return { element, view, set, values: () => JSON.parse(element.dataset.values) };
  };

  test(`the panel of ${spec.name} follows`, () => {
    const { element, set, values } = begun();
    for (const inputs of cases) {
      set(inputs);
      const { value: panel } = answer(() => written(inputs));
      if (!panel) continue;
      const other = document.createElement("div");
      other.innerHTML = panel;
      const where = `EXPLORE_SEED=${seed}: ${JSON.stringify(inputs)}`;
      assert.deepEqual(shown(element), shown(other), where);
      for (const { name, value } of element.querySelectorAll("[type=range], [type=number]")) {
        const key = name.replace("-number", "");
        // A model may have corrected it.
        assert.ok(Math.abs(value - values()[key]) <= spec.inputs[key].step / 2, name);
      }
    }
  });

  test(`each chip of ${spec.name} moves where it leads, and Reset back`, () => {
    history.replaceState(null, "", "/");
    const { element, view, set, values } = begun();
    const [[only, { high }]] = Object.entries(spec.inputs);
    // A small figure has no chips.
    if (!spec.tries.length) set({ [only]: high });
    const find = (selector) => [...element.querySelectorAll(selector)];
    for (const chip of [...find("a.try"), ...find("[data-action=reset]")]) {
      const drawn = view.applied.length;
      chip.click();
      for (let time = 0; time <= 1000; time += 20) tick(time);
      const arrived = values();
      assert.ok(view.applied.length - drawn > 20, `${chip.textContent} moves`);
      assert.equal(arrived.refused, undefined);
      set({ ...spec.start, ...fromText(chip.hash ?? "", spec) });
      assert.deepEqual(arrived, values(), chip.textContent);
    }
  });

  test(`each handle of ${spec.name} names the parts that it holds`, () => {
    const { element, view } = begun();
    const { parts } = model(spec.start, spec.constants, []);
    for (const handle of element.querySelectorAll(".scene [data-handle]")) {
      tell(handle, "pointerover");
      const [names] = view.lit.pop();
      assert.ok(names.length, handle.dataset.handle);
      for (const name of names) assert.ok(name in parts, name);
      tell(handle, "pointerout");
      assert.deepEqual(view.lit.pop(), [[]]);
    }
  });
}
