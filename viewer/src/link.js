/* The state of a figure in the address of the page, or kept with it: what differs from the start. */
import { changedSince } from "./speak.js";

const DIGITS = 5;

/** Write inputs; points are separated by blanks, their coordinates by commas. */
export function toText(inputs, start) {
  const text = (value) => {
    if (typeof value === "number") return Number(value.toFixed(DIGITS)).toString();
    if (!Array.isArray(value)) return String(value);
    return value.map(text).join(Array.isArray(value[0]) ? " " : ",");
  };
  const changed = changedSince(start, inputs);
  return new URLSearchParams(changed.map((name) => [name, text(inputs[name])])).toString();
}

/** The address of a figure as it is set. */
export function address({ name, start }, inputs) {
  return `#explore-${name}?${toText(inputs, start)}`;
}

/**
 * Keep the state with this page of the browser's history, for Back and for a reload. An address that
 * speaks of another state of the figure would be wrong from now on.
 */
export function keep(data, inputs) {
  const now = address(data, inputs);
  const wanted = fromText(location.hash, data);
  const stale = wanted && address(data, { ...data.start, ...wanted }) !== now;
  const url = stale ? location.pathname + location.search : undefined;
  history.replaceState({ ...history.state, [data.name]: now }, "", url);
}

/** The inputs that the address or, if it speaks of none, the history has for a figure; or null. */
export function found(data) {
  return fromText(location.hash, data) ?? fromText(history.state?.[data.name] ?? "", data);
}

/** Read the inputs of a figure from an address; null if it speaks of none or makes no sense. */
export function fromText(hash, { name, inputs, start }) {
  const [whose, text] = hash.slice(1).split("?");
  if (whose !== `explore-${name}` || text === undefined) return null;
  const found = {};
  for (const [key, value] of new URLSearchParams(text)) {
    if (!(key in inputs)) return null;
    found[key] = read(value, inputs[key], start[key]);
    if (found[key] === undefined) return null;
  }
  return found;
}

function read(text, { kind, low, high, options, names, least, most, length = 1 }, start) {
  if (kind === "number") {
    const number = Number(text);
    return number >= low && number <= high ? number : undefined;
  }
  if (kind === "switch") return text === "true";
  if (kind === "choice") return options.includes(text) ? text : undefined;
  const size = kind === "poses" ? 4 : 3;
  const points = text.split(" ").map((point) => point.split(",").map(Number));
  const sound = points.every(
    (p) => p.length === size && p.every(Number.isFinite) && Math.hypot(...p) > 0,
  );
  if (!sound) return undefined;
  // The digits of an address do not give points quite the length that they must have.
  const right = points.map((p) => p.map((x) => (length ? (x * length) / Math.hypot(...p) : x)));
  if (!Array.isArray(start[0])) return right.length === 1 ? right[0] : undefined;
  const enough = right.length >= (least || names.length) && right.length <= (most || names.length);
  return enough ? right : undefined;
}
