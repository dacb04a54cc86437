/*
 * Runs models for tests/test_explorables.py: reads pairs of a name and inputs from stdin, writes
 * the names of all models and a frame, or the refusal, for each pair.
 */
import { text } from "node:stream/consumers";
import * as models from "../../rotedu/scenes/models.js";

function answer([name, inputs]) {
  try {
    return { frame: models[name](inputs) };
  } catch (error) {
    return { error: error.name, message: error.message };
  }
}

const pairs = JSON.parse(await text(process.stdin));
console.log(JSON.stringify({ models: Object.keys(models), answers: pairs.map(answer) }));
