/*
 * The cells of the page. Run opens one for editing and runs it, after the cells above it that have
 * not run yet. The data-run of a cell is stored, waiting, running, done or error.
 */
import { button, drawing, findAll, home, make, output, say } from "./elements.js";
import * as figures from "./figures.js";
import * as runtime from "./runtime.js";
import * as store from "./store.js";

const TYPING = 400;
const SILENT = "Done, nothing printed.";
const DRAWN = "A new chart is drawn.";
const UNRUN = "Your code, which has not run yet: below is what the book’s printed.";
const SERVE =
  "To run this, the page must come from a server: run “python -m http.server” in the folder of" +
  " the book and open http://localhost:8000.";
const KEYS = "Shift+Enter runs the cell. To leave it with Tab, press Escape first.";
const LIMITS = { href: "conventions.html#python-in-the-page" };
const DESK = "Runs at a desk, in the notebook: it needs SciPy or SymPy.";
const ALONE = /^(start|solution|try)-/;
const PICTURE = ":is(figure, img, .scene, .explorable)";

// All that run, and those whose code the page shows.
const cells = [];
const listed = [];
const bar = make("progress", { className: "live-progress" });
const stopButton = button("stop", "Stop", () => stop());
let notebook;
let failures = 0;

/** Find the cells that can run, and give them their buttons; sources() promises all code, by id. */
export function bind(sources) {
  notebook = sources;
  findAll(".cell").forEach((box, index) => {
    const listing = box.querySelector(".cell_input");
    const { cell: id } = box.dataset;
    if (!id) return listing?.after(make("p", { className: "live-tools" }, make("a", LIMITS, DESK)));
    const cell = { id, box, listing, name: `Cell ${index + 1}`, ran: false };
    box.dataset.run = "stored";
    cells.push(cell);
    if (listing) listed.push(dress(cell));
  });
  return listed;
}

function dress(cell) {
  const { box, listing, name } = cell;
  const pre = listing.querySelector("pre");
  const called = name.toLowerCase();
  box.id ||= `cell-${cell.id}`;
  Object.assign(cell, {
    pre,
    source: pre.textContent.trimEnd(),
    asPrinted: [...pre.childNodes],
    stored: box.querySelectorAll(`.cell_output > :not(${PICTURE}, :has(${PICTURE}))`),
    open: button("edit", "Edit", () => editHere(cell), `Edit ${called}`),
    run: button("run", "Run", () => editAndRun(cell), `Run ${called}`),
    reset: button("reset", "Reset", () => reset(cell), `Reset ${called}`),
    message: make("span", { className: "live-message" }),
    output: make("div", { className: "live-output" }),
  });
  const number = make("span", { className: "live-name" }, name);
  const tools = [cell.open, cell.run, cell.reset, cell.message, number];
  cell.tools = make("div", { className: "live-tools" }, ...tools);
  listing.after(cell.tools);
  pre.title = "Click to change the code";
  // A click that ends a selection only selects.
  pre.addEventListener("click", (event) => getSelection()?.isCollapsed && edit(cell, event));
  restore(cell);
  return cell;
}

/** Tell whether a reader has changed a cell, and whether it looks other than in the book. */
export const isChanged = ({ code, source }) => code !== source;
export const isTouched = (cell) => isChanged(cell) || cell.output.isConnected;

/** Show the code that is stored for a cell, else that of the book. */
export function restore(cell) {
  const { code } = store.read(cell.id);
  cell.code = typeof code === "string" ? code : cell.source;
  cell.editor?.dom.parentNode.remove();
  cell.editor = null;
  cell.pre.parentNode.hidden = false;
  cell.open.hidden = false;
  cell.pre.replaceChildren(...(isChanged(cell) ? [cell.code] : cell.asPrinted));
  cell.reset.hidden = !isChanged(cell);
  tell(cell, isChanged(cell) ? UNRUN : "");
}

/** Put a cell back to what the book has. */
export function reset(cell) {
  clearTimeout(cell.typing);
  const inside = cell.box.contains(document.activeElement);
  cell.ran = false;
  cell.output.remove();
  erase(cell);
  for (const each of cell.stored) each.hidden = false;
  if (isChanged(cell)) cell.doubt?.();
  outdate(cell);
  store.write(cell.id, { code: undefined });
  restore(cell);
  if (inside) cell.run.focus();
}

/** Say something beside the buttons of a cell. */
const tell = (cell, ...content) => cell.message.replaceChildren(...content);

/** What stands below a change looks as if it had not run. */
function outdate(cell) {
  for (const { box } of cells.slice(cells.indexOf(cell))) {
    if (["done", "error"].includes(box.dataset.run)) box.dataset.run = "stored";
  }
}

/** Open the editor of a cell, where it was clicked. */
async function edit(cell, click) {
  if (cell.editor) return;
  if (location.protocol === "file:") return tell(cell, SERVE);
  try {
    const { open } = await import(`${home}${globalThis.EDITOR}&again=${failures}`);
    if (!cell.editor) show(cell, open);
    if (!click) return;
    const anchor = cell.editor.posAtCoords({ x: click.clientX, y: click.clientY }, false);
    cell.editor.dispatch({ selection: { anchor } });
    cell.editor.focus();
  } catch {
    failures += 1;
    tell(cell, "The editor could not be fetched. Click the code to try again.");
  }
}

/** Open the editor of a cell for a hand on the keys. */
async function editHere(cell) {
  await edit(cell);
  cell.editor?.focus();
}

function show(cell, open) {
  const place = make("div", { className: "highlight live-editor" });
  cell.pre.parentNode.after(place);
  cell.pre.parentNode.hidden = true;
  cell.open.hidden = true;
  const label = `Code of ${cell.name.toLowerCase()}`;
  const said = { "aria-label": label, "aria-description": KEYS, tabindex: "0" };
  const change = (code) => {
    cell.code = code;
    cell.reset.hidden = !isChanged(cell);
    cell.doubt?.();
    outdate(cell);
    clearTimeout(cell.typing);
    cell.typing = setTimeout(keep, TYPING, cell);
  };
  cell.editor = open(place, cell.code, said, { run: () => void run(cell), change });
}

function keep(cell) {
  clearTimeout(cell.typing);
  store.write(cell.id, { code: isChanged(cell) ? cell.code : undefined });
}

// Cells run one after the other, in the order in which they were asked for.
let last = Promise.resolve();
let stops = 0;

/** Run a cell, once if it is asked for twice. A cell may have a judge for what comes out. */
function run(cell) {
  if (location.protocol === "file:") return tell(cell, SERVE);
  if (cell.busy) return cell.busy;
  keep(cell);
  const [before, asked] = [cell.box.dataset.run, stops];
  cell.box.dataset.run = "waiting";
  cell.busy = last.then(async () => {
    if (asked === stops) await work(cell).catch((error) => fail(cell, error));
    else cell.box.dataset.run = before;
    cell.busy = null;
  });
  last = cell.busy;
  return cell.busy;
}

/** Open the editor of a cell, and run it. */
export function editAndRun(cell) {
  edit(cell);
  return run(cell);
}

/** End Python and whatever waits for it. */
export function stop() {
  stops += 1;
  for (const cell of cells) cell.ran = false;
  runtime.stop();
}

/** The cells above one that must run first: none of other exercises, sets a figure or draws. */
function above(cell) {
  const own = cell.id.replace(/^solution-/, "start-");
  const alone = ({ id, box }) => ALONE.test(id) || box.querySelector(".chart");
  const needed = (each) => !each.ran && (each.id === own || !alone(each));
  return cells.slice(0, cells.indexOf(cell)).filter(needed);
}

async function work(cell) {
  const begun = stops;
  cell.run.setAttribute("aria-disabled", "true");
  cell.message.before(stopButton, bar);
  bar.hidden = true;
  cell.output.toggleAttribute("data-old", true);
  try {
    const sources = await notebook();
    if (begun !== stops) throw new Error(runtime.STOPPED);
    const first = above(cell);
    for (const [index, each] of first.entries()) {
      const place = `${index + 1} of ${first.length}, ${each.name.toLowerCase()}`;
      const far = `The cells above run first: ${place}`;
      const { error } = await runOne(each, cell, each.code ?? sources.get(each.id), far);
      if (error) return blame(cell, each, error);
    }
    const done = await runOne(cell, cell, cell.code, "Running");
    const words = done.error || done.out + done.value || cell.message.textContent;
    if (!done.verdict) say(`${cell.name}: ${words}`);
    await cell.judge?.(done);
  } finally {
    if (document.activeElement === stopButton) cell.run.focus();
    stopButton.remove();
    bar.remove();
    cell.run.removeAttribute("aria-disabled");
    store.changed();
  }
}

/** Run one cell; how far Python is stands beside the cell that was asked for. */
async function runOne(cell, asked, code, far) {
  const { box, listing, name } = cell;
  // What a cell above prints is known, unless it has changed.
  const visible = cell === asked || (listing && isChanged(cell));
  box.dataset.run = "running";
  cell.output?.toggleAttribute("data-old", visible);
  const loading = (...bytes) => (bytes.length ? load(asked, ...bytes) : tell(asked, far));
  loading();
  const printing = (out) => visible && print(cell, { out });
  const done = await runtime.run({ code, name, figures: figures.values() }, loading, printing);
  outdate(cell);
  cell.ran = !done.error;
  box.dataset.run = done.error ? "error" : "done";
  // A verdict stands below the cell.
  if (cell.judge && done.verdict) done.value = "";
  if (visible || (listing && done.error)) print(cell, done);
  const links = figures.set(done.changed);
  const shown = done.verdict || done.error || done.out || done.value || links.length;
  const drawn = done.charts.length ? [DRAWN] : [SILENT];
  tell(asked, ...(shown ? links : drawn));
  return done;
}

/** Say how far Python or Matplotlib is, to the eye at every step, aloud once. */
function load(cell, fetched, total, what) {
  const size = `${(total / 1e6).toFixed(1)} MB`;
  if (bar.hidden && fetched < total) say(`${what} is being fetched: ${size}, once.`);
  Object.assign(bar, { hidden: fetched === total, max: total, value: fetched });
  const far = fetched ? `${(fetched / 1e6).toFixed(1)} of ${size}` : size;
  const then = what === "Python" ? "Python starts" : "Running";
  tell(cell, fetched < total ? `${what} is being fetched, once: ${far}` : then);
}

/** Put what a cell prints in the place of what is stored. */
function print(cell, done) {
  for (const each of cell.stored) each.hidden = true;
  cell.output.replaceChildren(...output(done));
  cell.output.removeAttribute("data-old");
  if (done.charts) draw(cell, done.charts);
  // Outside the fold of a listing, where the stored output is; a figure stands above its listing.
  const below = cell.box.querySelector(".cell_output");
  if (below?.querySelector("figure")) cell.box.append(cell.output);
  else if (below) below.before(cell.output);
  else cell.tools.after(cell.output);
  const scrolls = (box) => box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight;
  for (const box of cell.output.children) if (scrolls(box)) box.tabIndex = 0;
}

/** Put charts in the place of those that are stored, with the caption, else below what is printed. */
function draw(cell, charts) {
  erase(cell);
  const [stored] = findAll(".chart", cell.box);
  // What the book's code has drawn is not what this code has drawn, or has failed to draw.
  if (stored) stored.hidden = true;
  if (!charts.length) return;
  const drawn = make("div", {
    className: "chart",
    role: "img",
    ariaLabel: described(cell, stored),
  });
  drawn.append(...charts.map(drawing));
  drawn.style.setProperty("--least", `${drawn.firstElementChild.getAttribute("width")}px`);
  if (stored) stored.after(drawn);
  else cell.output.append(drawn);
  cell.drawn = drawn;
}

/** The alternative text of a chart: that of the book, marked if a change may show in it. */
function described(cell, stored) {
  if (!stored) return `Chart of ${cell.name.toLowerCase()}`;
  const mark = listed.some(isChanged) ? "Drawn with your changes. In the book: " : "";
  return mark + stored.ariaLabel;
}

/** Take away charts, and show those that are stored. */
function erase(cell) {
  cell.drawn?.remove();
  cell.drawn = null;
  for (const each of findAll(".chart", cell.box)) each.hidden = false;
}

/** Say which cell above has failed. */
function blame(cell, { name, box, listing }, error) {
  const where = listing ? make("a", { href: `#${box.id}` }, name) : `${name} (${error.trim()})`;
  cell.box.dataset.run = "error";
  clear(cell);
  tell(cell, where, " above has failed, so this cell has not run.");
  say(cell.message.textContent);
}

/** Take away what a cell printed before, but not what the book has for the book's code. */
function clear(cell) {
  if (cell.output?.hasAttribute("data-old") && isTouched(cell)) print(cell, {});
}

/** Say why a cell has not come to its end. */
function fail(cell, error) {
  for (const each of cells) {
    each.ran = false;
    if (each !== cell && each.box.dataset.run !== "running") continue;
    each.box.dataset.run = "error";
    clear(each);
  }
  tell(cell, error.message);
  say(error.message);
}
