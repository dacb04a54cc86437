/* Cases that Python has computed, and how close Node must come to them. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";

/** Read the cases that `tests/node.py` has written. */
export async function read(name) {
  const text = await readFile(`${process.env.CASES}/${name}.json`, "utf8");
  return JSON.parse(text, (_, value) => (value === "NaN" ? NaN : value));
}

/** What a function computes, or how it refuses. */
export function answer(compute) {
  try {
    return { value: compute() };
  } catch (error) {
    return { error: error.name, message: error.message };
  }
}

const rounding = (value) => 2e-6 * Math.max(1, Math.abs(value));

/**
 * A result is Python's, which may have more keys.
 * @param {function} allowed the difference allowed from a number
 */
export function close(mine, python, allowed = rounding, where = "") {
  const compared = `${where}: ${mine}, Python: ${python}`;
  if (typeof mine === "number" && typeof python === "number") {
    assert.ok(Math.abs(mine - python) <= allowed(python), compared);
  } else if ([mine, python].some((value) => value === null || typeof value !== "object")) {
    assert.equal(mine, python, compared);
  } else {
    if (Array.isArray(mine)) assert.equal(mine.length, python.length, compared);
    for (const key of Object.keys(mine)) close(mine[key], python[key], allowed, `${where} ${key}`);
  }
}
