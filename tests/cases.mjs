/* Cases that Python has computed, and how close Node must come to them. */
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

/**
 * Say where a result differs from Python's, which may have more keys.
 * @param {function} allowed the difference allowed from a number
 */
export function difference(mine, python, allowed, where = "") {
  if (typeof mine === "number" && typeof python === "number") {
    return Math.abs(mine - python) <= allowed(python) ? "" : `${where}: ${mine}, Python: ${python}`;
  }
  if (mine === null || typeof mine !== "object" || python === null || typeof python !== "object") {
    return mine === python ? "" : `${where}: ${mine}, Python: ${python}`;
  }
  if (Array.isArray(mine) && mine.length !== python.length) {
    return `${where}: ${mine.length} of them, Python: ${python.length}`;
  }
  const found = Object.keys(mine).map((key) =>
    difference(mine[key], python[key], allowed, `${where} ${key}`),
  );
  return found.find(Boolean) ?? "";
}
