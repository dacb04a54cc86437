/*
 * Calls functions of sphere.js for tests/test_sphere_js.py: reads pairs of a name and arguments
 * from stdin, writes the names of all exports and an answer to each call.
 */
import { text } from "node:stream/consumers";
import * as sphere from "../../rotedu/scenes/sphere.js";

function answer([name, args]) {
  try {
    return { value: sphere[name](...args) };
  } catch (error) {
    return { error: error.name, message: error.message };
  }
}

const calls = JSON.parse(await text(process.stdin), (_, value) => (value === "NaN" ? NaN : value));
console.log(JSON.stringify({ exports: Object.keys(sphere), answers: calls.map(answer) }));
