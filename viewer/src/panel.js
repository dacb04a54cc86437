/* The controls, numbers and charts below a figure, as `rotedu.figures.panel` writes them. */
import { ALONG, drag, stepped } from "./pointer.js";
import { numberText, statement } from "./speak.js";

const ROUNDING = 1e-9;
// Points whose sum is a smaller share of their length lie opposite each other.
const OPPOSITE = 1e-6;
// Seconds for which Play stays at the end, before it starts over, unless it goes round only once.
const REST = 2;
// The arrow where a curve leaves its chart: half its width, and its length.
const ARROW = [4, 7];
// How far apart the names of curves are, as a share of the height of their chart.
const LINE = 0.13;
// How many numbers matter where no figure says so.
const MAIN = 2;
const calm = matchMedia("(prefers-reduced-motion: reduce)");

/**
 * Bind the controls to the inputs.
 * @param {HTMLElement} element the figure
 * @param specs its inputs
 * @param {function} now returns the present inputs
 * @param {{change: function, reset: function, link: function, follow: function}} actions
 * @returns {{show: function, withhold: function, outcome: function, playOnce: function}} writes inputs and
 *   a frame into the panel; puts a dash for each number that does not hold; says the numbers that matter;
 *   plays the first slider by itself, for who wants motion, by a function that sets inputs
 */
export function bindPanel(element, specs, now, { change, reset, link, follow }) {
  const form = element.querySelector(".explorable-panel");
  const all = (selector) => [...form.querySelectorAll(selector)];
  // Nothing is looked up while the hand moves.
  const controls = Object.entries(specs).map(([name, spec]) => ({
    name,
    spec,
    inputs: all(`input[name="${name}"]`),
    field: form.elements[`${name}-number`],
    digits: decimals(spec.step),
    buttons: all(`[data-input="${name}"]`),
  }));
  form.querySelector("fieldset").disabled = false;
  form.addEventListener("submit", (event) => event.preventDefault());

  const player = playing(element, specs, now, change);
  const scrub = (name, value) => {
    player.stop();
    change({ [name]: stepped(specs[name], value) });
  };
  const charts = new Map(
    all("[data-chart]").map((chart) => [chart.dataset.chart, bindChart(chart, specs, now, scrub)]),
  );
  form.addEventListener("input", ({ target }) => {
    const name = target.name.replace(/-number$/, "");
    const { kind, low, high } = specs[name] ?? {};
    if (kind === "number" && target.value === "") return;
    player.stop();
    if (kind === "number") change({ [name]: Math.min(high, Math.max(low, Number(target.value))) });
    else if (kind === "switch") change({ [name]: target.checked });
    else if (kind === "choice") change({ [name]: target.value });
  });
  // What was typed beyond the bounds was shown as the nearest bound.
  form.addEventListener("change", ({ target }) => {
    const held = controls.find(({ field }) => field && field === target);
    if (held) target.value = now()[held.name].toFixed(held.digits);
  });
  form.addEventListener("click", (event) => {
    const { target } = event;
    // With a key held, a link opens elsewhere.
    if (target.matches("a.try") && !(event.ctrlKey || event.metaKey || event.shiftKey)) {
      event.preventDefault();
      player.stop();
      follow(target);
    }
    const { action, input } = target.dataset;
    const points = input && now()[input];
    if (action !== "play") player.stop();
    if (action === "play") player.toggle(target, input);
    else if (action === "step") player.step(input);
    else if (action === "add") change({ [input]: added(points) }, () => "Point added");
    else if (action === "remove") change({ [input]: points.slice(0, -1) }, () => "Point removed");
    else if (action === "reset") reset();
    else if (action === "link") link();
  });
  // Without motion there is nothing to play.
  const plays = all("[data-action=play]");
  for (const button of plays) button.hidden = calm.matches;
  // What the hand takes is not moved by anything else.
  for (const kind of ["pointerdown", "keydown"]) {
    element.addEventListener(kind, ({ target }) => target.closest("[data-handle]") && player.stop());
  }

  return {
    show(values, { outputs = {}, charts: drawn = {} }) {
      for (const { name, spec, inputs, field, digits, buttons } of controls) {
        const value = values[name];
        for (const input of inputs) {
          if (spec.kind === "switch") input.checked = value;
          else if (spec.kind === "choice") input.checked = input.value === value;
          else input.value = value;
          if (input.type === "range") input.setAttribute("aria-valuetext", numberText(spec, value));
        }
        if (field && field !== document.activeElement) field.value = value.toFixed(digits);
        if (spec.most) {
          const [add, remove] = buttons;
          add.disabled = value.length >= spec.most;
          remove.disabled = value.length <= spec.least;
        }
      }
      for (const [name, value] of Object.entries(outputs)) {
        // A form has properties of its own, such as length.
        const output = form.elements.namedItem(name);
        output.textContent = text(value, output.dataset);
        output.classList.toggle("explorable-loud", value === output.dataset.loud);
      }
      for (const [name, chart] of charts) chart.draw(drawn[name] ?? {}, values[chart.over]);
    },
    withhold() {
      for (const output of all("output")) output.textContent = output.textContent.replace(/\S+/g, "–");
    },
    outcome() {
      const large = all(".explorable-numbers output");
      const told = large.length ? large : all("output").slice(0, MAIN);
      return told.map((output) => output.parentElement.textContent).join(", ");
    },
    playOnce(set) {
      if (!calm.matches) player.toggle(plays[0], plays[0].dataset.input, set);
    },
  };
}

/**
 * What draws the curves of a chart, and its mark at the value of the input along it. In the chart this
 * input is dragged.
 */
function bindChart(chart, specs, now, scrub) {
  const { over, x, y } = chart.dataset;
  const [[first, last], [low, high]] = [x, y].map((range) => range.split(" ").map(Number));
  const { width, height } = chart.querySelector("svg").viewBox.baseVal;
  const box = { width, height, low, high };
  const lines = new Map(
    [...chart.querySelectorAll("[data-curve]")].map((line) => [line.dataset.curve, line]),
  );
  const names = [...chart.querySelectorAll("[data-name]")];
  const ends = {};
  const marks = chart.querySelectorAll(".explorable-marks span");
  const here = chart.querySelectorAll("[data-mark]");
  const plot = chart.querySelector("svg");
  if (specs[over]?.kind === "number") {
    grabbed(plot, chart.dataset.chart, specs[over], {
      to: (share) => scrub(over, first + share * (last - first)),
      by: (steps) => scrub(over, now()[over] + steps * specs[over].step),
    });
  }
  return {
    over,
    draw(curves, value) {
      for (const [curve, heights] of Object.entries(curves)) {
        const pieces = Array.isArray(heights?.[0]) ? heights : [heights ?? []];
        lines.get(curve).setAttribute("d", path(pieces, box));
        ends[curve] = pieces.at(-1).at(-1);
        marks.forEach((mark, i) => (mark.hidden = i >= pieces.length));
      }
      placeNames(names, ends, box);
      chart.hidden = [...lines.values()].every((line) => !line.getAttribute("d"));
      const at = ((value - first) / (last - first)) * width;
      for (const line of here) for (const x of ["x1", "x2"]) line.setAttribute(x, at);
      plot.setAttribute("aria-valuenow", value);
      if (specs[over]) plot.setAttribute("aria-valuetext", statement(specs, [over], { [over]: value }));
    },
  };
}

/** Put the names of curves beside their ends, but apart; one without a curve has no name. */
function placeNames(names, ends, { low, high }) {
  for (const name of names) name.hidden = ends[name.dataset.name] === undefined;
  const found = names.filter(({ hidden }) => !hidden).map(({ dataset, style }) => {
    const end = (high - ends[dataset.name]) / (high - low);
    return { style, end: Math.round(100 * Math.min(1, Math.max(0, end))) / 100 };
  });
  found.sort((one, other) => one.end - other.end);
  let above = -LINE;
  found.forEach(({ style, end }, k) => {
    above = Math.min(Math.max(end, above + LINE), 1 - LINE * (found.length - 1 - k));
    style.top = `${(100 * above).toFixed(0)}%`;
  });
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

/** Decimals for a number with a smallest difference. */
function decimals(step) {
  return Math.max(0, Math.ceil(-Math.log10(step)));
}

function path(pieces, { width, height, low, high }) {
  const each = width / pieces.length;
  const paths = pieces.map((heights, i) => {
    const shares = heights.map((value) => (value - low) / (high - low));
    const x = (k) => (i + k / (heights.length - 1)) * each;
    const points = shares.map((share, k) => {
      const y = height * (1 - Math.min(1.05, Math.max(-0.05, share)));
      return `${x(k).toFixed(1)},${y.toFixed(1)}`;
    });
    const arrows = cutOff(shares).map(([k, edge]) => arrow(x(k), height * (1 - edge), edge));
    return points.length ? `M${points.join(" ")}${arrows.join("")}` : "";
  });
  return paths.join("");
}

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

/** Write a number, a text or a matrix as Python does. */
function text(value, { digits, unit }) {
  if (typeof value === "string") return value;
  const number = (x) => {
    const written = x.toFixed(digits);
    return (Number(written) === 0 ? written.replace("-", "") : written).replace("-", "\u2212");
  };
  const rows = (Array.isArray(value[0]) ? value : [value]).map((row) => [row].flat().map(number));
  // The columns of a matrix are of one width; other numbers are a list.
  const [width, between] = rows.length > 1 ? [Math.max(...rows.flat().map((x) => x.length)), " "] : [0, ", "];
  return rows.map((row) => row.map((x) => x.padStart(width)).join(between)).join("\n") + unit;
}

/** A new point in the middle of the widest gap of a closed sequence. */
function added(points) {
  const after = (i) => points[(i + 1) % points.length];
  const gaps = points.map((point, i) => Math.hypot(...point.map((x, k) => x - after(i)[k])));
  const widest = gaps.indexOf(Math.max(...gaps));
  const size = Math.hypot(...points[widest]);
  const sum = points[widest].map((x, k) => x + after(widest)[k]);
  const between = Math.hypot(...sum) > OPPOSITE * size ? sum : away(points, widest);
  const scale = size / Math.hypot(...between);
  return points.toSpliced(widest + 1, 0, between.map((x) => x * scale));
}

/** A direction at right angles to a point: away from all points or, where these balance, any. */
function away(points, from) {
  const point = points[from];
  const dot = (p, q) => p.reduce((sum, x, k) => sum + x * q[k], 0);
  const outwards = point.map((_, k) => points.reduce((sum, { [k]: x }) => sum - x, 0));
  const axes = point.map((_, i) => point.map((_, k) => Number(i === k)));
  return [outwards, ...axes]
    .map((way) => way.map((x, k) => x - (dot(way, point) / dot(point, point)) * point[k]))
    .find((way) => Math.hypot(...way) > OPPOSITE * Math.hypot(...point));
}

/** Move a slider from its low to its high end, again and again, while the figure is on the screen. */
function playing(element, specs, now, change) {
  let frame = 0;
  let button;
  const stop = () => {
    cancelAnimationFrame(frame);
    frame = 0;
    if (button) button.textContent = "Play";
  };
  /** Play or pause; with a function that sets inputs, go round once, back to where it began. */
  const toggle = (pressed, name, once) => {
    const going = frame && pressed === button;
    stop();
    if (going) return;
    button = pressed;
    button.textContent = "Pause";
    const { low, high, plays } = specs[name];
    // The figure may show the nearest value for which it has a frame.
    let value = now()[name] < high ? now()[name] : low;
    const start = value;
    const rest = once ? 0 : (REST * (high - low)) / plays;
    let round = false;
    let last;
    const tick = (time) => {
      const { top, bottom } = element.getBoundingClientRect();
      if (bottom < 0 || top > innerHeight) return stop();
      const passed = last === undefined ? 0 : (time - last) / 1000;
      last = time;
      value += (passed * (high - low)) / plays;
      if (value > high + rest) [value, round] = [low, true];
      frame = requestAnimationFrame(tick);
      if (!once) return change({ [name]: Math.min(high, value) });
      const over = round && value >= start;
      if (over) stop();
      once({ [name]: over ? start : Math.min(high, value) });
    };
    frame = requestAnimationFrame(tick);
  };
  /** Go on to the next stride, which another input may say; after the end, begin again. */
  const step = (name) => {
    const { low, high, stride: wide } = specs[name];
    const stride = now()[wide] ?? wide;
    const taken = Math.floor((now()[name] - low) / stride + ROUNDING);
    change({ [name]: now()[name] >= high ? low : Math.min(high, low + (taken + 1) * stride) });
  };
  return { stop, toggle, step };
}
