/* Play and Step: a number that moves by itself. */

const ROUNDING = 1e-9;
// Seconds for which Play stays at the end, before it starts over, unless it goes there only once.
const REST = 2;

/**
 * Move a slider from its low to its high end, again and again, while the figure is on the screen.
 * @param {HTMLElement} element the figure
 * @param {Record<string, any>} specs
 * @param {() => import("./types.js").Inputs} now returns the present inputs
 * @param {(changes: import("./types.js").Inputs) => void} change
 * @param {(changes: import("./types.js").Inputs, then: () => void) => void} back leads back to some
 *   inputs by a way, and calls a function there
 */
export function playing(element, specs, now, change, back) {
  let frame = 0;
  /** @type {HTMLElement | null} the button of what plays */
  let button = null;
  const stop = () => {
    cancelAnimationFrame(frame);
    if (button) button.textContent = "Play";
    button = null;
  };
  /** Play or pause; with a function that sets inputs, go to the end once, and back to where it began. */
  const toggle = (pressed, name, once) => {
    const going = pressed === button;
    stop();
    if (going) return;
    pressed.textContent = "Pause";
    button = pressed;
    const { low, high, plays } = specs[name];
    const start = now()[name];
    const rest = once ? 0 : (REST * (high - low)) / plays;
    const set = once ?? change;
    const run = () => {
      if (button !== pressed) return;
      let value = now()[name];
      let last;
      const tick = (time) => {
        const { top, bottom } = element.getBoundingClientRect();
        if (bottom < 0 || top > innerHeight) return stop();
        value += (((time - (last ?? time)) / 1000) * (high - low)) / plays;
        last = time;
        if (value <= high + rest) {
          frame = requestAnimationFrame(tick);
          return set({ [name]: Math.min(high, value) });
        }
        if (now()[name] < high) set({ [name]: high });
        back({ [name]: once ? start : low }, once ? stop : run);
      };
      frame = requestAnimationFrame(tick);
    };
    if (start < high) run();
    else back({ [name]: low }, run);
  };
  /** Go on to the next stride, which another input may say; after the end, begin again. */
  const step = (name) => {
    const { low, high, stride: wide } = specs[name];
    const stride = now()[wide] ?? wide;
    const taken = Math.floor((now()[name] - low) / stride + ROUNDING);
    if (now()[name] >= high) back({ [name]: low }, () => {});
    else change({ [name]: Math.min(high, low + (taken + 1) * stride) });
  };
  return { stop, toggle, step };
}
