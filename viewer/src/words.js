/*
 * A coloured word or symbol of the page lights in the nearest picture what has its colour: a colour of
 * the book means one thing in both, so no list says which word belongs to which part.
 */
import { all } from "./elements.js";
import { COLORED, colorIn } from "./stress.js";

/** @import { View } from "./viewer.js" */

/** @type {Set<View>} */
const views = new Set();
/** @type {{view: View, word: Element, color: string} | null} */
let lit = null;

/** @param {View} view whose parts the words of the page light from now on */
export function heedWords(view) {
  if (!views.size) document.addEventListener("pointerover", ({ target }) => pointAt(target));
  views.add(view);
}

/** @param {View} view */
export function ignoreWords(view) {
  views.delete(view);
}

/** Light what a word means, or nothing. */
function pointAt(target) {
  const word = target.closest(COLORED);
  const color = word && !word.closest(".scene") ? colorIn(word) : undefined;
  if (color === lit?.color) return;
  clear();
  const view = color && nearest(word, color);
  if (view) light(view, word, color);
}

function light(view, word, color) {
  const outer = whole(word, color);
  outer.classList.add("means");
  view.mean(color);
  lit = { view, word: outer, color };
}

function clear() {
  lit?.word.classList.remove("means");
  lit?.view.mean(null);
  lit = null;
}

/** The largest element about a word in its colour. */
function whole(word, color) {
  const around = word.parentElement?.closest(COLORED);
  return around && colorIn(around) === color ? whole(around, color) : word;
}

/** Of the pictures on the screen that show a colour, the one nearest to a word. */
function nearest(word, color) {
  const place = word.getBoundingClientRect().top;
  const away = ({ element }) => {
    const { top, bottom } = element.getBoundingClientRect();
    const seen = bottom > 0 && top < innerHeight;
    return seen ? Math.max(0, top - place, place - bottom) : Number.POSITIVE_INFINITY;
  };
  const showing = [...views].filter((view) => view.stress.has(color) && away(view) < innerHeight);
  return showing.sort((one, other) => away(one) - away(other))[0];
}

/**
 * Light what the next colour of a picture's caption means; after the last one, nothing. So the
 * caption needs no place in the order of Tab.
 * @param {View} view
 */
export function nextColor(view) {
  const caption = view.element.closest("figure")?.querySelector("figcaption");
  const words = caption ? all(caption, COLORED) : [];
  const colors = [...new Set(words.map(colorIn))].filter((color) => view.stress.has(color));
  const next = colors[lit?.view === view ? colors.indexOf(lit.color) + 1 : 0];
  clear();
  if (next)
    light(
      view,
      words.find((word) => colorIn(word) === next),
      next,
    );
}
