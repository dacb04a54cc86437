import assert from "node:assert/strict";
import { test } from "node:test";
import { createTools } from "../src/elements.js";
import { figure } from "./dom.js";

test("a scene has a button that resets its view, unless the panel of its figure has one", () => {
  document.fullscreenEnabled = true;
  const titles = (scene) => [...createTools(scene, {}).tools.children].map(({ title }) => title);
  assert.deepEqual(titles(document.createElement("div")), ["Reset the view", "Full screen"]);
  assert.deepEqual(titles(figure("").querySelector(".scene")), ["Full screen"]);
});
