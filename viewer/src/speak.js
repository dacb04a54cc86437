/* What a figure says in words: the values of its inputs, for those who do not see it, and its outputs. */

const UNIT = /, (°)$/;

/** Words without the marks of quantities. */
export const plain = (text) => text.replaceAll("*", "");

/** What an input is, without its unit. */
export function titleOf({ label = "", names }, name) {
  return plain(label).replace(UNIT, "") || (typeof names === "string" ? names : name);
}

/** The value of a slider with its unit. */
export function numberText({ label = "" }, value) {
  return (
    Number(value.toFixed(2)).toString().replace("-", "\u2212") + (label.match(UNIT)?.[1] ?? "")
  );
}

/** Say what some inputs are. */
export function statement(specs, names, inputs) {
  const said = (name) => {
    const [spec, value] = [specs[name], inputs[name]];
    const title = titleOf(spec, name);
    if (spec.kind === "number") return `${title} ${numberText(spec, value)}`;
    if (spec.kind === "switch") return `${title}: ${value ? "on" : "off"}`;
    if (spec.kind === "choice") return `${title}: ${value}`;
    return `${title} moved`;
  };
  return names.map(said).join(", ");
}

/** The inputs that differ. */
export function changedSince(start, inputs) {
  const text = JSON.stringify;
  return Object.keys(inputs).filter((name) => text(inputs[name]) !== text(start[name]));
}

/**
 * What an output says: a number, a text or a matrix.
 * @param {any} value
 * @param {{digits?: number | string, unit?: string}} how
 */
export function outputText(value, { digits, unit }) {
  if (typeof value === "string") return value;
  const number = (x) => {
    const written = x.toFixed(digits);
    return (Number(written) === 0 ? written.replace("-", "") : written).replace("-", "\u2212");
  };
  const thousands = (whole) => whole.replace(/\B(?=(\d{3})+$)/g, ",");
  if (typeof value === "number") return number(value).replace(/\d+/, thousands) + unit;
  const rows = (Array.isArray(value[0]) ? value : [value]).map((row) => [row].flat().map(number));
  // The columns of a matrix are of one width; other numbers are a list.
  const [width, between] =
    rows.length > 1 ? [Math.max(...rows.flat().map((x) => x.length)), " "] : [0, ", "];
  return rows.map((row) => row.map((x) => x.padStart(width)).join(between)).join("\n") + unit;
}
