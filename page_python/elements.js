/* What the page adds to itself: buttons, words for those who hear it, and what a cell has printed. */

const script = /** @type {HTMLScriptElement} */ (document.currentScript);

/** Where the scripts are. */
export const home = new URL(".", script.src);

/** The element that is there. */
export const find = (selector) => /** @type {HTMLElement} */ (document.querySelector(selector));

/** @type {(selector: string, within?: ParentNode) => HTMLElement[]} */
export const findAll = (selector, within = document) =>
  Array.from(within.querySelectorAll(selector));

/** Make an element with properties; text and elements become its content. */
export function make(tag, properties, ...content) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...content);
  return made;
}

/** Make a button with a name, by which the markup knows it, and words for those who hear it. */
export function button(name, text, action, ariaLabel = text) {
  const made = make("button", { type: "button", name, ariaLabel }, text);
  made.addEventListener("click", action);
  return made;
}

const spoken = make("p", { className: "live-spoken", role: "status" });
const MOST = 300;

/** Say something, once, when the reader's machine has time. */
export function say(text) {
  if (!spoken.isConnected) find("article").append(spoken);
  spoken.textContent = text.length > MOST ? `${text.slice(0, MOST)} …` : text;
}

/** Return what a cell has printed, its value and its error. What looks like HTML stays text. */
export function output({ out = "", value = "", kind = "", error = "" }) {
  const shown = [];
  if (out) shown.push(make("pre", {}, out));
  if (value) shown.push(kind === "markdown" ? table(value) : make("pre", {}, value));
  if (error) shown.push(make("pre", { className: "live-error" }, error.trimEnd()));
  return shown;
}

const SVG = "http://www.w3.org/2000/svg";
const SHAPES =
  /^(svg|g|defs|clipPath|pattern|use|path|rect|circle|line|polyline|polygon|image|text|tspan)$/;
const ATTRIBUTES =
  /^(viewBox|width|height|d|[xy][12]?|c[xy]|r[xy]?|points|transform|fill|stroke|clip-path|pattern.*)$/;
const STYLES = /^(fill|stroke|color|opacity|font-|text-anchor|clip-path)/;
const HARMLESS = /^(url\(#[\w-]+\)|[\w\s#.,()%+-]*)$/;
const WITHIN = /^(#[\w-]+|data:image\/png;base64,[\w+/=\s]*)$/;

/** Make a drawing of its text: shapes and their looks alone, and nothing that runs or loads. */
export function drawing(svg) {
  const root = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  if (root.localName !== "svg") return make("span");
  for (const element of [root, ...root.querySelectorAll("*")]) {
    const known = element.namespaceURI === SVG && SHAPES.test(element.localName);
    if (!known) element.remove();
    for (const { name, value } of [...element.attributes]) {
      if (name === "style") element.setAttribute(name, looks(value));
      else if (!mayStay(name, value)) element.removeAttribute(name);
    }
  }
  return root;
}

function mayStay(name, value) {
  if (name === "id") return value.startsWith("Cell-");
  if (/^(xlink:)?href$/.test(name)) return WITHIN.test(value);
  return /^xmlns/.test(name) || (ATTRIBUTES.test(name) && HARMLESS.test(value));
}

/** Return of a style what says how a shape looks. */
const looks = (style) =>
  style
    .split(";")
    .map((one) => one.split(":").map((part) => part.trim()))
    .filter(([name, value, more]) => STYLES.test(name) && HARMLESS.test(value) && !more)
    .map(([name, value]) => `${name}: ${value}`)
    .join("; ");

/** Make a table of lines with bars; anything else stays text. */
function table(markdown) {
  const lines = markdown.trim().split("\n");
  if (!lines.every((line) => line.startsWith("|"))) return make("pre", {}, markdown);
  const [head, , ...body] = lines.map((line) => line.split("|").slice(1, -1).map(words));
  const row = (texts, tag) => make("tr", {}, ...texts.map((text) => make(tag, {}, text)));
  const rows = body.map((texts) => row(texts, "td"));
  const made = make("table", { className: "docutils" }, row(head, "th"), ...rows);
  return make("div", { className: "table-wrapper" }, made);
}

/** Leave out the signs for links, code and bold letters. */
const words = (text) =>
  text
    .trim()
    .replace(/\[(.+?)\]\(.+?\)/g, "$1")
    .replace(/[`*]/g, "");
