/* What a figure says to those who do not see it: the values of its inputs, in words. */

const UNIT = /, (°)$/;

/** What an input is, without its unit. */
export function titleOf({ label, names }, name) {
  return label?.replace(UNIT, "") || (typeof names === "string" ? names : name);
}

/** The value of a slider with its unit. */
export function numberText({ label = "" }, value) {
  return Number(value.toFixed(5)).toString().replace("-", "\u2212") + (label.match(UNIT)?.[1] ?? "");
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
