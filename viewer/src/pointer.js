/* How pointer and keys hold what can be dragged: in a picture (handles.js), or along a chart (panel.js). */

/** Steps of the arrow keys along a number. */
export const ALONG = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };

/** The value that a slider can have next to a number. */
export function stepped({ low, high, step }, number) {
  return Math.min(high, Math.max(low, low + step * Math.round((number - low) / step)));
}

/**
 * Let a pointer drag an element.
 * @param {Element} element
 * @param {Element} layer what places are in
 * @param {{grab: function, move: function, drop?: function, focus?: HTMLElement}} hands what to do; a
 *   place is given in fractions of the layer, whose aspect is its width over its height
 * @returns a function that tells whether it is held
 */
export function drag(element, layer, { grab, move, drop, focus = element }) {
  let grip = null;
  const at = ({ clientX, clientY }) => {
    const { left, top, width, height } = layer.getBoundingClientRect();
    return { share: [(clientX - left) / width, (clientY - top) / height], aspect: width / height };
  };
  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    focus.focus({ preventScroll: true });
    element.setPointerCapture(event.pointerId);
    grip = grab(at(event));
  });
  element.addEventListener("pointermove", (event) => {
    if (grip) move(grip, at(event));
  });
  for (const kind of ["pointerup", "pointercancel"]) {
    element.addEventListener(kind, () => {
      const held = grip;
      grip = null;
      if (held) drop?.();
    });
  }
  return () => grip !== null;
}
