/*
 * Python in the page. This script gives the cells their buttons; nothing else is fetched until one
 * is pressed. What a page without it has, stays.
 */
import * as cells from "./cells.js";
import { button, find, home, make, say } from "./elements.js";
import * as exercises from "./exercises.js";
import { fill } from "./notebook.js";
import * as store from "./store.js";

const name = decodeURIComponent(location.pathname).replace(/.*\/|\.html$/g, "");
const UNKEPT = "This browser keeps nothing: save your work before you leave.";
const FORGOTTEN = "Your code and answers on this page are forgotten.";
const AS_IN_BOOK = "All cells are as in the book; your score is kept.";
const SOURCE = `../../_sources/book/${name}.ipynb`;
const STUDENT = /** @type {HTMLAnchorElement} */ (find(".page-head a[download]")).href;
const fetched = {};

/** Fetch a notebook once; what has failed may be tried again. */
async function fetchNotebook(path) {
  if (!fetched[path]) {
    const answer = await fetch(new URL(path, home));
    if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
    fetched[path] = await answer.json();
  }
  return fetched[path];
}

/** The code of all cells, also of those that the page does not show, by id. */
async function sources() {
  // To be saved later, perhaps without a network.
  fetchNotebook(STUDENT).catch(() => {});
  const notebook = await fetchNotebook(SOURCE).catch(({ message }) => {
    throw new Error(
      `The notebook of this page could not be fetched (${message}). Run tries again.`,
    );
  });
  return new Map(notebook.cells.map(({ id, source }) => [id, [source].flat().join("")]));
}

const all = cells.bind(sources);
const solved = make("a", { className: "solved", href: "#exercises" });
const save = make("a", { className: "answers", download: `${name}-my-work.ipynb` }, "Save my work");
const forget = button("forget", "Forget", () => takeBack(FORGOTTEN, true));
const resetAll = button("reset-all", "Reset all", () => takeBack(AS_IN_BOOK));
const note = make("span", { className: "live-message" });
save.href = STUDENT;
save.addEventListener("click", saveNotebook);

// Another script makes the forms.
addEventListener("DOMContentLoaded", () => {
  exercises.bind(all);
  const head = make("span", { className: "live-head" }, solved, save, forget, resetAll, note);
  find(".page-head").append(head);
  // Another tab may have this page, too.
  for (const event of ["rotedu:changed", "storage"]) addEventListener(event, update);
  update();
});

/** Say how far the reader is, and offer what makes sense now. */
function update() {
  const { right, of } = exercises.count();
  Object.assign(solved, { textContent: `${right} of ${of} solved`, hidden: of === 0 });
  save.hidden = forget.hidden = store.ids().length === 0;
  resetAll.hidden = !all.some(cells.isTouched);
  note.textContent = store.keeps() ? "" : UNKEPT;
}

async function saveNotebook(event) {
  event.preventDefault();
  const notebook = await fetchNotebook(STUDENT).catch(({ message }) => {
    note.textContent = `Not saved (${message}). What you wrote stays here; try again later.`;
  });
  if (!notebook) return;
  const filled = fill(structuredClone(notebook), all);
  const href = URL.createObjectURL(new Blob([JSON.stringify(filled, null, 1)]));
  make("a", { href, download: save.download }).click();
  setTimeout(() => URL.revokeObjectURL(href), 60_000);
}

/** Put all cells back, end Python and perhaps forget the answers, too, unless it was a slip. */
function takeBack(text, answers = false) {
  const before = store.ids().map((id) => [id, store.read(id)]);
  cells.stop();
  all.forEach(cells.reset);
  if (answers) for (const [id] of before) store.replace(id, {});
  exercises.restore();
  const undo = button("undo", "Undo", () => {
    for (const [id, entry] of before) store.replace(id, entry);
    all.forEach(cells.restore);
    exercises.restore();
    update();
  });
  note.replaceChildren(text, " ", undo);
  say(text);
  undo.focus();
}
