import assert from "node:assert/strict";
import { test } from "node:test";
import { Color } from "three";
import { Held } from "../src/held.js";
import { Stress } from "../src/stress.js";
import { heedWords, ignoreWords, nextColor } from "../src/words.js";
import { figure, liveScene, tell } from "./dom.js";

const BLUE = "#0072b2";
const GREEN = "#009e73";
const GREY = "#7d858d";
const LABELS = `<span class="scene-label"><span style="color: ${BLUE}">r</span></span>
  <span class="scene-label"><span style="color: #000000">O</span></span>`;

/** A scene with parts in three colours, of which the green one is hidden. */
function shown() {
  const scene = figure("").querySelector(".scene");
  scene.insertAdjacentHTML("beforeend", LABELS);
  const part = (color, visible = true) => {
    const uniforms = { base: { value: new Color(color) }, stress: { value: 1 } };
    return { objects: [{ visible, material: { uniforms } }] };
  };
  const parts = new Map([
    ["arrow", part(BLUE)],
    ["arc", part(GREEN, false)],
    ["ground", part(GREY)],
    ["axes", part(GREY)],
  ]);
  const stress = new Stress(parts, [scene]);
  const levels = () => [...parts.values()].map((p) => p.objects[0].material.uniforms.stress.value);
  const faint = () => [...scene.querySelectorAll("[data-faint]")].map((x) => x.textContent);
  return { scene, stress, levels, faint };
}

test("what is lit stands out, what is faint steps back, and both end", () => {
  const { stress, levels } = shown();
  stress.light(["arrow"], ["ground"]);
  assert.deepEqual(levels(), [2, 1, 0.6, 1]);
  stress.light();
  assert.deepEqual(levels(), [1, 1, 1, 1]);
});

test("what has the colour of a word stands out, its label with it; what is hidden has none", () => {
  const { stress, levels, faint } = shown();
  assert.deepEqual([stress.has(BLUE), stress.has(GREEN)], [true, false]);
  assert.deepEqual(stress.helping(), ["ground", "axes"]);
  stress.mean(BLUE);
  assert.deepEqual([levels(), faint()], [[2, 0.35, 0.35, 0.35], ["O"]]);
  stress.light();
  assert.deepEqual(faint(), []);
});

test("what only helps and does not move steps back once the hand moves something", () => {
  const view = liveScene(shown().scene);
  const held = new Held(view);
  held.take(["arrow"]);
  for (const at of [0, 0, 1]) held.follow({ arrow: { at: [at] }, ground: { at: [at] } });
  held.take([]);
  held.follow({ ground: { at: [2] } });
  assert.deepEqual(view.lit, [
    [["arrow"]],
    [["arrow"], ["ground"]],
    [["arrow"], ["ground"]],
    [["arrow"], []],
    [[]],
  ]);
});

test("a coloured word lights the nearest picture that shows its colour; C goes from one to the next", () => {
  const { scene, stress } = shown();
  const html = `<figure><figcaption><b style="color:${BLUE};">The <i style="color:${BLUE}">arrow</i></b>
    on <u style="color: ${GREEN}">its arc</u>, <s style="color:#7d858d">on the ground</s></figcaption></figure>`;
  document.body.insertAdjacentHTML("beforeend", html);
  document.querySelector("figure").prepend(scene);
  const meant = [];
  const view = { element: scene, stress, mean: (color) => meant.push(color) };
  const other = { ...view, element: document.createElement("p"), mean: () => assert.fail() };
  scene.getBoundingClientRect = () => ({ top: 10, bottom: 200 });
  other.element.getBoundingClientRect = () => ({ top: 300, bottom: 400 });
  const find = (selector) => document.querySelector(selector);
  for (const each of [other, view]) heedWords(each);
  tell(find("i"), "pointerover");
  assert.ok(find("b").classList.contains("means"));
  for (const word of ["b", "figure", "u", ".scene-label span", "figure"])
    tell(find(word), "pointerover");
  assert.ok(!find(".means"));
  assert.deepEqual(meant.splice(0), [BLUE, null]);
  // No part that shows is green.
  for (let i = 0; i < 3; i++) nextColor(view);
  assert.deepEqual(meant, [BLUE, null, GREY, null]);
  for (const each of [other, view]) ignoreWords(each);
  tell(find("b"), "pointerover");
  assert.equal(meant.length, 4);
});
