/*
 * What stands below a figure, as HTML: its numbers, controls, charts and what to try, in the order in
 * which they are read and reached by Tab. The build of a page and a notebook write the same, switched
 * off until the figure is live; `panel.js` finds everything in it by name.
 */
import { HEIGHT, isCut, nameTops, path, WIDTH } from "./chart.js";
import { toText } from "./link.js";
import { outputText, plain } from "./speak.js";

// So many curves have their names beside their ends; more have them above.
const NAMED = 3;
const INDEX = /[₀-₉ᵢ₊₋]+(?:,[₀-₉ᵢ₊₋]+)*/gu;
const LOWERED = { ᵢ: "<i>i</i>", "₊": "+", "₋": "\u2212", ",": "," };
// No line begins with a dot.
const BETWEEN = "\u00a0·</span> <span>";
const MORE = '<details class="explorable-more"><summary>More numbers</summary>';

/**
 * Write the panel of a figure.
 * @param {import("./types.js").Spec} data
 * @param {import("./types.js").State} state what its model computes at the start
 * @returns {string}
 */
export function panelHtml({ name, inputs, start, outputs, charts, tries, small }, state) {
  const values = { ...start, ...state.inputs };
  const controls = Object.entries(inputs).map(([key, spec]) =>
    CONTROLS[spec.kind](key, spec, values[key], name),
  );
  const numbers = (place) =>
    outputs
      .filter(({ where }) => where === place)
      .map((output) => outputHtml(output, state.outputs[output.name]))
      .join("");
  const box = (kind, content) => content && `<div class="explorable-${kind}">${content}</div>`;
  const drawn = charts.map((chart) => chartHtml(chart, state.charts?.[chart.name], values, inputs));
  const links = tries.map(([words, wanted]) => {
    const address = `#explore-${name}?${toText(wanted, {})}`;
    return `<a class="try" href="${escaped(address)}">${written(words)}</a>`;
  });
  const folded = box("outputs", numbers("folded"));
  const controlled = box("controls", controls.join(""));
  const whole =
    '<div class="explorable-buttons explorable-whole">' +
    '<button type="button" data-action="reset">Reset</button>' +
    '<button type="button" name="copy" data-action="link">Copy link</button></div>';
  return (
    '<p class="explorable-status" role="status"></p>' +
    '<form class="explorable-panel" autocomplete="off"><fieldset disabled>' +
    '<legend class="explorable-legend">Controls of the figure</legend>' +
    box("numbers", numbers("picture")) +
    (small ? controlled + whole : whole + controlled) +
    box("charts", drawn.join("")) +
    box("outputs", numbers("panel")) +
    (folded && `${MORE}${folded}</details>`) +
    box("tries", links.length ? `<span>Try: </span><span>${links.join(BETWEEN)}</span>` : "") +
    "</fieldset></form>"
  );
}

/** Write words as HTML; what stands between asterisks is a quantity, as in formulas. */
export function written(text) {
  const lowered = (index) => [...index].map((sign) => LOWERED[sign] ?? "₀₁₂₃₄₅₆₇₈₉".indexOf(sign));
  return escaped(text)
    .replace(/\*(.+?)\*/g, "<i>$1</i>")
    .replace(INDEX, (index) => `<sub>${lowered(index).join("")}</sub>`);
}

function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}

const quoted = (text) => escaped(text).replaceAll('"', "&quot;");

/** @type {Record<string, (name: string, spec: any, value: any, figure: string) => string>} */
const CONTROLS = {
  number: sliderHtml,
  points: (name, { most }) => (most ? addAndRemove(name, "point") : ""),
  poses: (name, { most }) => (most ? addAndRemove(name, "pose") : ""),
  switch: (name, { label }, value) =>
    `<label class="explorable-switch"><input type="checkbox" name="${name}"${value ? " checked" : ""}>` +
    ` ${written(label)}</label>`,
  choice: (name, { label, options, words }, value) => {
    const buttons = options.map((option, i) => {
      const checked = option === value ? " checked" : "";
      const button = `<input type="radio" name="${name}" value="${quoted(option)}"${checked}>`;
      return `<label>${button} ${written(words[i])}</label>`;
    });
    const legend = `<legend>${written(label)}</legend>`;
    return `<fieldset class="explorable-choice">${legend}${buttons.join("")}</fieldset>`;
  },
};

/** A slider, the same number to type, and buttons if it plays. */
function sliderHtml(name, { row, low, high, step, plays, label }, value, figure) {
  if (!row) return "";
  const bounds = `min="${low}" max="${high}" step="${shortest(step)}" value="${shortest(value)}"`;
  const id = `${figure}-${name}`;
  const button = (action, text) =>
    `<button type="button" data-action="${action}" data-input="${name}">${text}</button>`;
  const buttons = button("play", "Play") + button("step", "Step");
  return (
    `<div class="explorable-row"><label for="${id}">${written(label || name)}</label>` +
    `<input type="range" id="${id}" name="${name}" ${bounds}>` +
    `<input type="number" name="${name}-number" aria-label="${quoted(plain(label || name))}" ${bounds}>` +
    `${plays ? `<span class="explorable-buttons">${buttons}</span>` : ""}</div>`
  );
}

/** The buttons that change the number of points or bodies. */
function addAndRemove(name, what) {
  const button = (action, text) =>
    `<button type="button" data-action="${action}" data-input="${name}">${text} a ${what}</button>`;
  return `<div class="explorable-buttons">${button("add", "Add")}${button("remove", "Remove")}</div>`;
}

function outputHtml({ name, label, digits, unit, loud, color }, value) {
  const text = outputText(value, { digits, unit });
  const kind = text.includes("\n") ? " explorable-matrix" : "";
  const ink = color && ` style="color: ${color}"`;
  // The status line below the scene speaks; numbers that change with the hand are silent.
  const attributes = `name="${name}" aria-live="off" data-digits="${digits}" data-unit="${unit}"`;
  return (
    `<label class="explorable-output${kind}"><span${ink}>${written(label)}</span> ` +
    `<output ${attributes} data-loud="${loud}"${value === loud ? ' class="explorable-loud"' : ""}>` +
    `${escaped(text)}</output></label>`
  );
}

function chartHtml(chart, curves, values, inputs) {
  const { name, label, over, x, y, colors, marks, dashed } = chart;
  const entries = Object.entries(curves);
  const look = (curve) =>
    `style="color: ${colors[curve] ?? "inherit"}"${dashed.includes(curve) ? " data-dashed" : ""}`;
  const lines = entries.map(
    ([curve, heights]) =>
      `<path data-curve="${quoted(curve)}" d="${path(heights, y)}" ${look(curve)}${isCut(heights, y) ? " data-cut" : ""}/>`,
  );
  const keys =
    entries.length > NAMED ? entries.map(([curve]) => `<span ${look(curve)}>${curve}</span>`) : [];
  const named = entries.length > 1 && entries.length <= NAMED ? entries : [];
  const tops = nameTops(curves, y);
  const names = named.map(([curve]) => {
    const place = `color: ${colors[curve] ?? "inherit"}; top: ${tops[curve] ?? "0%"}`;
    const hidden = tops[curve] ? "" : " hidden";
    return `<span data-name="${quoted(curve)}" style="${place}"${hidden}>${escaped(curve)}</span>`;
  });
  const ticks = chart.ticks.length ? chart.ticks : roundHeights(...y).map((h) => [h, signed(h)]);
  const down = (height) => (y[1] - height) / (y[1] - y[0]);
  const hairlines = ticks.map(([h]) => {
    const at = (HEIGHT * down(h)).toFixed(1);
    return `<line data-tick="${shortest(h)}" x2="${WIDTH}" y1="${at}" y2="${at}"/>`;
  });
  const numbers = ticks.map(([h, text]) => {
    return `<span style="top: ${(100 * down(h)).toFixed(1)}%">${text}</span>`;
  });
  const pieces = Math.max(
    ...entries.map(([, heights]) => (Array.isArray(heights?.[0]) ? heights.length : 1)),
  );
  const begins = marks.map(
    (text, i) => `<span${i < pieces ? "" : " hidden"}>${written(text)}</span>`,
  );
  const at = (((values[over] - x[0]) / (x[1] - x[0])) * WIDTH).toFixed(1);
  const mark = (from) => `<line data-mark="" x1="${at}" x2="${at}" y1="${from}" y2="${HEIGHT}"/>`;
  const widest = (texts) => Math.max(0, ...texts.map((text) => [...text].length));
  const room = `--digits: ${widest(ticks.map(([, text]) => text))}; --letters: ${widest(named.map(([c]) => c))}`;
  return (
    `<figure class="explorable-chart" data-chart="${name}" data-over="${over}" data-x="${x.join(" ")}"` +
    ` data-y="${y.join(" ")}"${entries.every(([, heights]) => !heights) ? " hidden" : ""} style="${room}">` +
    `<figcaption>${written(label)} ${keys.join(" ")}</figcaption><div class="explorable-plot">` +
    `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" preserveAspectRatio="none" role="img"` +
    ` aria-label="${quoted(plain(label))}">${hairlines.join("")}${lines.join("")}` +
    // A line, and a knob at its foot: WebKit makes an ellipse of one that has no length.
    `${mark(0)}${mark(HEIGHT - 0.01)}</svg>` +
    `<div class="explorable-ticks">${numbers.join("")}</div>` +
    `<div class="explorable-names">${names.join("")}</div>` +
    `<div class="explorable-marks" style="color: ${colors.marks ?? "inherit"}">${begins.join("")}</div>` +
    `</div><div class="explorable-axis"><span>${signed(x[0])}</span>` +
    `<span>${written(inputs[over]?.label || over)}</span><span>${signed(x[1])}</span></div></figure>`
  );
}

/** Heights for the hairlines of a chart, both ends among them: even steps of one digit, or the ends alone. */
export function roundHeights(low, high) {
  for (const steps of [4, 3]) {
    const step = (high - low) / steps;
    if (step === Number(step.toExponential(0))) {
      return Array.from({ length: steps + 1 }, (_, k) => low + k * step);
    }
  }
  return [low, high];
}

/** A number in six digits, without those that say nothing. */
const shortest = (x) => String(Number(x.toPrecision(6)));

const signed = (x) => shortest(x).replace("-", "\u2212");
