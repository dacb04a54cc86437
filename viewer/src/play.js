/* Play and Step: a number that moves by itself. */

const ROUNDING = 1e-9;
// Seconds for which Play stays at the end, before it starts over, unless it goes round only once.
const REST = 2;

/** Move a slider from its low to its high end, again and again, while the figure is on the screen. */
export function playing(element, specs, now, change) {
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
