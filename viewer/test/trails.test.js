import assert from "node:assert/strict";
import { test } from "node:test";
import { trails } from "../src/trails.js";
import { points } from "./near.js";

test("a way grows with its point, breaks where it jumps, and can be forgotten", () => {
  const ways = trails();
  assert.deepEqual(ways.follow({ way: [0, 0, 0] }), { way: { hidden: true } });
  // The second is too near to be seen.
  for (const place of points("0.1,0,0 0.101,0,0 1.2,0,0")) ways.follow({ way: place });
  const { way } = ways.follow({ way: [2, 0, 0] });
  const pieces = [points("0,0,0 0.1,0,0"), points("1.2,0,0 2,0,0")];
  assert.deepEqual(way, { paths: pieces, hidden: false });
  assert.deepEqual(ways.clear(), { way: { hidden: true } });
  assert.deepEqual(ways.clear(), {});
});

test("a point that is gone breaks its way", () => {
  const ways = trails();
  for (const place of [[0, 0, 0], [0.1, 0, 0], null, [0.2, 0, 0]]) ways.follow({ way: place });
  const { way } = ways.follow({ way: [0.3, 0, 0] });
  assert.equal(way.paths.length, 2);
});

test("a long way forgets where it began", () => {
  const ways = trails();
  let way;
  for (let i = 0; i <= 1000; i++) ({ way } = ways.follow({ way: [i / 100, 0, 0] }));
  assert.equal(way.paths[0].length, 500);
  assert.deepEqual(way.paths[0].at(-1), [10, 0, 0]);
});
