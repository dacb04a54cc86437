/* What stands out in a picture, and what steps back. */
import { all } from "./elements.js";

// How much a part is stressed: at 1 it looks as it was made.
const BRIGHT = 2;
const PLAIN = 1;
// What helps, while the hand holds something else; and what a word does not mean.
const ASIDE = 0.6;
const OTHER = 0.35;
// Below this difference of red, green and blue a colour is grey, and says nothing.
const GREY = 0.15;

export class Stress {
  /**
   * @param {Map<string, import("./types.js").Part>} parts
   * @param {HTMLElement[]} pictures whose labels have the colours of what they name
   */
  constructor(parts, pictures) {
    this.parts = parts;
    this.labels = pictures.flatMap((picture) => all(picture, ".scene-label"));
  }

  /** The names of the parts that only help: their colour has no meaning. */
  helping() {
    return [...this.parts].filter(([, part]) => isGrey(base(part))).map(([name]) => name);
  }

  /** Whether something that shows has a colour. */
  has(color) {
    const shown = [...this.parts.values()].filter(({ objects }) => objects[0].visible);
    return shown.some((part) => colorOf(part) === color);
  }

  /** Let some parts stand out and others step back, by name; the rest is plain. */
  light(bright = [], faint = []) {
    this.set((name) => (bright.includes(name) ? BRIGHT : faint.includes(name) ? ASIDE : PLAIN));
    for (const label of this.labels) label.removeAttribute("data-faint");
  }

  /** Let what has a colour stand out from all else. */
  mean(color) {
    this.set((_, part) => (colorOf(part) === color ? BRIGHT : OTHER));
    for (const label of this.labels) label.toggleAttribute("data-faint", colorIn(label) !== color);
  }

  set(level) {
    for (const [name, part] of this.parts) {
      for (const { material } of part.objects) material.uniforms.stress.value = level(name, part);
    }
  }
}

const base = ({ objects }) => objects[0].material.uniforms.base.value;
/** The colour of a part as it is now, as in a style. */
const colorOf = (part) => `#${base(part).getHexString()}`;
const isGrey = ({ r, g, b }) => Math.max(r, g, b) - Math.min(r, g, b) < GREY;

/** The colour in the style of an element or of the first in it that has one. */
export function colorIn(element) {
  const colored = element.matches(COLORED) ? element : element.querySelector(COLORED);
  return colored
    ?.getAttribute("style")
    .match(/#[0-9a-f]{6}/i)?.[0]
    .toLowerCase();
}

/** What has a colour of its own. */
export const COLORED = "[style*='color:']";
