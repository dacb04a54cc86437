/* The charts below a figure: curves as paths, the names beside their ends, and the input along them. */
import { all, one } from "./elements.js";
import { ALONG, drag, stepped } from "./pointer.js";
import { statement } from "./speak.js";

export const [WIDTH, HEIGHT] = [320, 128];
const ROUNDING = 1e-9;
// The arrow where a curve leaves its chart: half its width, and its length.
const ARROW = [4, 7];
// How far apart the names of curves are, as a share of the height of their chart.
const LINE = 0.13;

/** The curves of a chart, and its mark at the value of the input along it, which is dragged there. */
export class Chart {
  /**
   * @param {HTMLElement} box as `panel-html.js` writes it
   * @param {import("./types.js").Specs} specs the inputs of the figure
   * @param {() => import("./types.js").Inputs} now returns the present inputs
   * @param {(name: string, value: number) => void} scrub takes the new value of an input
   */
  constructor(box, specs, now, scrub) {
    const { chart = "", over = "", x = "", y = "" } = box.dataset;
    this.box = box;
    this.name = chart;
    this.over = over;
    this.specs = specs;
    this.x = x.split(" ").map(Number);
    this.y = y.split(" ").map(Number);
    this.plot = one(box, "svg");
    this.lines = new Map(all(box, "[data-curve]").map((line) => [line.dataset.curve, line]));
    this.names = all(box, "[data-name]");
    this.marks = all(box, ".explorable-marks span");
    this.here = all(box, "[data-mark]");
    this.known = {};
    const spec = specs[over];
    if (spec?.kind !== "number") return;
    const [first, last] = this.x;
    grabbed(this.plot, chart, spec, {
      to: (share) => scrub(over, stepped(spec, first + share * (last - first))),
      by: (steps) => scrub(over, stepped(spec, now()[over] + steps * spec.step)),
    });
  }

  /**
   * @param {import("./types.js").Curves} curves those that are others than before
   * @param {number} value of the input along the chart
   */
  draw(curves, value) {
    const { box, lines, marks, plot, specs, over, x, y } = this;
    for (const [curve, heights] of Object.entries(curves)) {
      const line = lines.get(curve);
      line?.setAttribute("d", path(heights, y));
      line?.toggleAttribute("data-cut", isCut(heights, y));
      // A curve that is not shown has no pieces.
      const pieces = heights ? piecesOf(heights).length : 0;
      if (pieces) marks.forEach((mark, i) => (mark.hidden = i >= pieces));
    }
    const tops = nameTops(Object.assign(this.known, curves), y);
    for (const name of this.names) {
      const top = tops[name.dataset.name ?? ""];
      name.hidden = !top;
      // As text, so that a page finds the colour in it that it may give another shade.
      const style = name.getAttribute("style") ?? "";
      if (top) name.setAttribute("style", style.replace(/top: [^;]*/, `top: ${top}`));
    }
    box.hidden = [...lines.values()].every((line) => !line.getAttribute("d"));
    const at = String(((value - x[0]) / (x[1] - x[0])) * WIDTH);
    for (const line of this.here) for (const end of ["x1", "x2"]) line.setAttribute(end, at);
    plot.setAttribute("aria-valuenow", String(value));
    if (specs[over])
      plot.setAttribute("aria-valuetext", statement(specs, [over], { [over]: value }));
  }
}

/** Let a number be dragged along a chart, and be moved by keys. */
function grabbed(plot, name, { low, high }, { to, by }) {
  const attributes = { role: "slider", tabindex: 0, "aria-valuemin": low, "aria-valuemax": high };
  for (const [key, value] of Object.entries(attributes)) plot.setAttribute(key, value);
  plot.dataset.handle = `chart-${name}`;
  const follow = ({ share }) => to(share[0]);
  drag(plot, plot, {
    grab(place) {
      follow(place);
      return place;
    },
    move: (_, place) => follow(place),
  });
  plot.addEventListener("keydown", (event) => {
    const way = ALONG[event.key];
    if (!way || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    by(way * (event.shiftKey ? 10 : 1));
  });
}

/** The pieces of a curve, which may be one or, for now, none. */
const piecesOf = (heights) => (Array.isArray(heights?.[0]) ? heights : [heights ?? []]);

/**
 * How far down the names of curves stand, by name: beside their ends, but apart.
 * @param {import("./types.js").Curves} curves
 * @param {number[]} range of their chart
 * @returns {Record<string, string>} as CSS says it; without the curves that are not there for now
 */
export function nameTops(curves, range) {
  const [low, high] = range;
  const found = Object.entries(curves).filter(([, heights]) => heights);
  const places = found.map(([name, heights]) => {
    const end = (high - piecesOf(heights).at(-1).at(-1)) / (high - low);
    return { name, end: Math.round(100 * Math.min(1, Math.max(0, end))) / 100 };
  });
  places.sort((one, other) => one.end - other.end);
  let above = -LINE;
  const tops = places.map(({ name, end }, k) => {
    above = Math.min(Math.max(end, above + LINE), 1 - LINE * (places.length - 1 - k));
    return [name, `${(100 * above).toFixed(0)}%`];
  });
  return Object.fromEntries(tops);
}

/**
 * A curve, in one or more pieces, as an SVG path, with arrows where it is cut off.
 * @param {import("./types.js").Curve} curve
 * @param {number[]} range of its chart
 */
export function path(curve, range) {
  const pieces = piecesOf(curve);
  const each = WIDTH / pieces.length;
  const paths = pieces.map((heights, i) => {
    const shares = sharesOf(heights, range);
    const x = (k) => (i + k / (heights.length - 1)) * each;
    const points = shares.map((share, k) => {
      const y = HEIGHT * (1 - Math.min(1.05, Math.max(-0.05, share)));
      return `${x(k).toFixed(1)},${y.toFixed(1)}`;
    });
    const arrows = cutOff(shares).map(([k, edge]) => arrow(x(k), HEIGHT * (1 - edge), edge));
    return points.length ? `M${points.join(" ")}${arrows.join("")}` : "";
  });
  return paths.join("");
}

/** Whether a curve leaves its chart and is cut off there, which takes a browser longer to draw. */
export const isCut = (curve, range) =>
  piecesOf(curve).some((heights) => cutOff(sharesOf(heights, range)).length > 0);

/** How far up in its chart a curve is. @type {(heights: number[], range: number[]) => number[]} */
const sharesOf = (heights, [low, high]) => heights.map((value) => (value - low) / (high - low));

/** Where a curve is beyond its chart: the middle of each such stretch, and the edge, 1 or 0. */
function cutOff(shares) {
  const edges = shares.map((share) => (share > 1 + ROUNDING ? 1 : share < -ROUNDING ? 0 : null));
  const found = [];
  for (let k = 0, end; k < edges.length; k = end) {
    for (end = k + 1; edges[end] === edges[k]; ) end++;
    if (edges[k] !== null) found.push([(k + end - 1) / 2, edges[k]]);
  }
  return found;
}

function arrow(x, y, edge) {
  const [half, long] = ARROW;
  const back = y + (edge ? long : -long);
  const [left, right] = [x - half, x + half].map((end) => `${end.toFixed(1)},${back.toFixed(1)}`);
  return `M${left} ${x.toFixed(1)},${y.toFixed(1)} ${right}`;
}
