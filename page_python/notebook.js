/* The page as a notebook: the edition for students, with what the reader has written. */
import { isChanged } from "./cells.js";
import * as store from "./store.js";

const ANSWER = /^answer = .*$/m;

/** Put the reader's cells into a notebook; what its cells printed before goes. */
export function fill(notebook, cells) {
  const changes = new Map(cells.filter(isChanged).map(({ id, code }) => [id, code]));
  for (const cell of notebook.cells) {
    const code = changes.get(cell.id) ?? numbersIn(cell);
    if (code !== undefined)
      Object.assign(cell, { source: code, outputs: [], execution_count: null });
  }
  notebook.cells.push(...homeless(notebook));
  return notebook;
}

/** The starter cell of an exercise with what stands in its form. */
function numbersIn(cell) {
  const { fields } = store.read(cell.id);
  if (!Array.isArray(fields) || cell.cell_type !== "code") return undefined;
  const answer = fields.length > 1 ? `[${fields.map(written).join(", ")}]` : written(fields[0]);
  return [cell.source].flat().join("").replace(ANSWER, `answer = ${answer}`);
}

/** A number or a fraction as Python writes it; three dots for what is neither. */
function written(text) {
  const parts = text.replaceAll("\u2212", "-").replace(/°\s*$/, "").split("/");
  const numbers = parts.map((part) => (part.trim() ? Number(part) : NaN));
  const sound = Number.isFinite(numbers.reduce((top, bottom) => top / bottom));
  return sound ? numbers.join(" / ") : "...";
}

/** What was written for cells that the notebook does not have: solutions, or cells that have gone. */
function homeless({ cells }) {
  const lost = store.ids().filter((id) => store.read(id).code && !cells.some((c) => c.id === id));
  return lost.map((id, i) => ({
    cell_type: "markdown",
    id: `kept-${i}`,
    metadata: {},
    source: `You also wrote this, for the cell \`${id}\`:\n\n\`\`\`python\n${store.read(id).code}\n\`\`\``,
  }));
}
