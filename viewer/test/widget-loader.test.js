import assert from "node:assert/strict";
import { test } from "node:test";

globalThis.DIGEST = "test";
const { default: loader } = await import("../src/widget-loader.js");

/** A figure without a viewer, and what it has asked its kernel for. */
function figure() {
  const asked = [];
  let hear;
  const traits = { viewer: new DataView(new ArrayBuffer(0)) };
  const model = {
    get: (name) => traits[name],
    on: (_, callback) => (hear = callback),
    send: ({ get }) => asked.push(get),
  };
  loader.initialize({ model });
  loader.render({ model });
  return { asked, live: () => hear({ got: "sign of life" }, []) };
}

test("only one figure asks for the viewer, until that has taken too long", ({ mock }) => {
  mock.timers.enable({ apis: ["Date", "setTimeout"], now: 1e9 });
  const [dead, first, second] = [figure(), figure(), figure()];
  for (const { asked } of [dead, first, second]) assert.deepEqual(asked, ["sign of life"]);
  mock.timers.tick(60_000);
  assert.deepEqual(dead.asked, ["sign of life"]);
  first.live();
  second.live();
  assert.deepEqual(first.asked, ["sign of life", "viewer"]);
  mock.timers.tick(9_000);
  assert.deepEqual(second.asked, ["sign of life"]);
  mock.timers.tick(2_000);
  assert.deepEqual(second.asked, ["sign of life", "viewer"]);
});
