/*
 * What a reader leaves on this page, for each cell by its id: `code` if it is changed, `fields` of a
 * form, and the verdict, `right` and `text`. The browser keeps it; where it must not, the page does
 * until it is left.
 */
const PREFIX = `rotedu-2:${location.pathname.replace(/(\.html|\/)$/, "")}:`;
const unkept = new Map();

/** Return what is stored for a cell. */
export function read(id) {
  try {
    return unkept.get(id) ?? Object(JSON.parse(localStorage.getItem(PREFIX + id) ?? "{}"));
  } catch {
    return {};
  }
}

/** Store all that there is for a cell. */
export function replace(id, entry) {
  const text = JSON.stringify(entry);
  try {
    if (text === "{}") localStorage.removeItem(PREFIX + id);
    else localStorage.setItem(PREFIX + id, text);
    unkept.delete(id);
  } catch {
    unkept.set(id, JSON.parse(text));
  }
  changed();
}

/** Tell the head of the page that something is to be counted anew. */
export const changed = () => dispatchEvent(new Event("rotedu:changed"));

/** Store changes of what there is for a cell; undefined takes something away. */
export const write = (id, changes) => replace(id, { ...read(id), ...changes });

/** The ids of all cells for which something is stored, also of those that the page no longer has. */
export function ids() {
  let keys = [];
  try {
    keys = Object.keys(localStorage).filter((key) => key.startsWith(PREFIX));
  } catch {
    // Nothing is kept.
  }
  return [...new Set([...keys.map((key) => key.slice(PREFIX.length)), ...unkept.keys()])];
}

/** Tell whether all of it will be there another time. */
export const keeps = () => unkept.size === 0;
