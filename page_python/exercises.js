/*
 * Exercises: Check gives the verdict, with hints in stages, on the numbers of a form or on what the
 * starter cell computes. Verdicts are stored with the code of that cell.
 */
import { editAndRun, isChanged } from "./cells.js";
import { button, findAll, make } from "./elements.js";
import { values } from "./figures.js";
import * as runtime from "./runtime.js";
import * as store from "./store.js";

const exercises = [];

/** Find the exercises, give them their buttons, and show what is stored. */
export function bind(cells) {
  for (const box of findAll(".exercise[data-exercise]")) {
    const { exercise: number = "" } = box.dataset;
    const id = `start-${number.replace(".", "-")}`;
    const cell = cells.find((each) => each.id === id);
    const form = box.querySelector(".answer-form form");
    const exercise = { number, id, cell, form, hinted: "", asked: false };
    if (!form && !cell) continue;
    if (form) followForm(box, exercise);
    else addCheck(exercise);
    if (cell) cell.judge = (done) => judge(exercise, done);
    if (cell) cell.doubt = () => exercise.fields?.some(({ value }) => value) || doubt(exercise);
    exercises.push(exercise);
  }
  restore();
}

/** Show the verdicts and numbers that are stored. */
export function restore() {
  for (const exercise of exercises) {
    const stored = store.read(exercise.id);
    show(exercise, stored);
    exercise.fields?.forEach((field, i) => (field.value = stored.fields?.[i] ?? ""));
  }
}

/** How many exercises there are, and how many are solved. */
export function count() {
  return { right: exercises.filter(({ id }) => store.read(id).right).length, of: exercises.length };
}

function addCheck(exercise) {
  const { cell, number } = exercise;
  cell.run.after(button("check", "Check", () => answer(exercise), `Check exercise ${number}`));
  exercise.verdict = make("output", { className: "verdict" });
  cell.box.after(exercise.verdict);
}

/** A form judges its numbers itself (answers.js); where there are none, the cell has the answer. */
function followForm(box, exercise) {
  const { form, cell, id } = exercise;
  const fields = [...form.querySelectorAll("input")];
  const empty = () => !fields.some(({ value }) => value.trim());
  const check = (event) => {
    if (!empty() || !cell || !isChanged(cell)) return;
    event.preventDefault();
    event.stopPropagation();
    answer(exercise);
  };
  box.addEventListener("submit", check, { capture: true });
  form.addEventListener("input", () => {
    doubt(exercise);
    store.write(id, { fields: empty() ? undefined : fields.map(({ value }) => value) });
  });
  form.addEventListener("rotedu:verdict", ({ detail }) => keep(exercise, detail));
  Object.assign(exercise, { fields, verdict: form.querySelector("output") });
}

async function answer(exercise) {
  show(exercise, {});
  exercise.asked = true;
  await editAndRun(exercise.cell);
  exercise.asked = false;
}

/** Show the verdict of a cell that has run; the same mistake twice earns a second hint. */
async function judge(exercise, { verdict, error }) {
  const { asked, cell, fields, hinted, number } = exercise;
  if (verdict?.number !== number) {
    const text = `To be checked, the cell must end with check("${number}", answer).`;
    if (asked && !error) show(exercise, { text });
    return;
  }
  let [text] = verdict.text.split("\n");
  if (verdict.right === false) {
    exercise.hinted = text;
    const code = `check("${number}", answer, hint=2)`;
    const more =
      hinted === text && (await runtime.run({ code, name: cell.name, figures: values() }));
    text = more?.verdict?.text ?? `${text} For a hint, press Check again.`;
  }
  // Nobody has answered by a cell that only computes what goes into a form.
  if (verdict.right === null && fields && !asked) return;
  const said = { right: verdict.right, text: text[0].toUpperCase() + text.slice(1) };
  show(exercise, said);
  keep(exercise, said);
}

/** Of what has been changed nobody knows whether it is right; the exercise stays solved. */
function doubt(exercise) {
  if (exercise.verdict.dataset.right !== "true") return;
  show(exercise, {});
  store.write(exercise.id, { text: undefined });
}

function show({ verdict }, /** @type {{ right?: boolean, text?: string }} */ { right, text = "" }) {
  if (text && typeof right === "boolean") verdict.dataset.right = right;
  else delete verdict.dataset.right;
  verdict.textContent = text;
}

const keep = ({ id }, { right, text }) =>
  store.write(id, right === null ? { right: undefined, text: undefined } : { right, text });
