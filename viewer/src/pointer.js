/* How pointer and keys hold what can be dragged: in a picture (handles.js), or along a chart (chart.js). */

/** Steps of keys along a number. */
export const ALONG = {
  ArrowLeft: -1,
  ArrowDown: -1,
  PageDown: -10,
  ArrowRight: 1,
  ArrowUp: 1,
  PageUp: 10,
};
const STEPS = { Shift: 5, Alt: 0.1 };
// Share of the picture from its border to a handle.
const BORDER = 0.02;

/**
 * The value that a slider can have next to a number.
 * @param {{low: number, high: number, step: number}} spec
 */
export function stepped({ low, high, step }, number) {
  return Math.min(high, Math.max(low, low + step * Math.round((number - low) / step)));
}

/**
 * Put a handle to a place of the picture. What has left the picture can be caught at its border.
 * @param {HTMLElement} handle
 * @param {{left: number, top: number}} place
 */
export function put2d({ style }, { left, top }) {
  const percent = (x) => `${100 * Math.min(1 - BORDER, Math.max(BORDER, x))}%`;
  style.left = percent(left);
  style.top = percent(top);
}

/** Let some keys move a handle, with others by larger and smaller steps. */
export function keys(handle, ways, move) {
  handle.addEventListener("keydown", (event) => {
    const way = ways[event.key];
    if (!way || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    move(way, (event.shiftKey ? STEPS.Shift : 1) * (event.altKey ? STEPS.Alt : 1));
  });
}

/**
 * Let a pointer drag an element.
 * @template G what is held
 * @param {HTMLElement | SVGElement} element
 * @param {Element} layer what places are in
 * @param {object} hands what to do; a place is given in fractions of the layer, whose aspect is its
 *   width over its height
 * @param {(place: {share: number[], aspect: number}) => G} hands.grab
 * @param {(grip: G, place: {share: number[], aspect: number}) => void} hands.move
 * @param {() => void} [hands.drop]
 * @param {HTMLElement | SVGElement} [hands.focus]
 * @returns a function that tells whether it is held
 */
export function drag(element, layer, { grab, move, drop, focus = element }) {
  /** @type {G | null} */
  let grip = null;
  const at = ({ clientX, clientY }) => {
    const { left, top, width, height } = layer.getBoundingClientRect();
    return { share: [(clientX - left) / width, (clientY - top) / height], aspect: width / height };
  };
  const press = (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    focus.focus({ preventScroll: true });
    element.setPointerCapture(event.pointerId);
    grip = grab(at(event));
  };
  const follow = (event) => {
    if (grip) move(grip, at(event));
  };
  const letGo = () => {
    const held = grip;
    grip = null;
    if (held) drop?.();
  };
  element.addEventListener("pointerdown", press);
  element.addEventListener("pointermove", follow);
  element.addEventListener("pointerup", letGo);
  element.addEventListener("pointercancel", letGo);
  return () => grip !== null;
}
