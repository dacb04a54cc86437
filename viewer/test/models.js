/*
 * Runs models for tests/test_explorables.py: reads names, inputs and constants from stdin,
 * writes the names of all models and a frame, or the refusal, for each case.
 */
import { text } from "node:stream/consumers";
import * as models from "../../rotedu/scenes/models.js";

function answer([name, inputs, constants]) {
  try {
    return { frame: models[name](inputs, constants) };
  } catch (error) {
    return { error: error.name, message: error.message };
  }
}

const cases = JSON.parse(await text(process.stdin));
console.log(JSON.stringify({ models: Object.keys(models), answers: cases.map(answer) }));
