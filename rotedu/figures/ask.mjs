/*
 * Computes states for Python: node ask.mjs <file of models> takes the name of a model and, for each
 * state, its arguments, as JSON, and answers with the states, or how the model refuses them.
 */
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const models = await import(pathToFileURL(process.argv[2]));
const [name, questions] = JSON.parse(readFileSync(0, "utf8"));
if (!models[name])
  throw new ReferenceError(`expected an export ${name}, got ${Object.keys(models)}`);

function answer(question) {
  try {
    return models[name](...question);
  } catch (error) {
    if (error.name !== "DegenerateError") throw error;
    return { refused: error.message };
  }
}

process.stdout.write(JSON.stringify(questions.map(answer)));
