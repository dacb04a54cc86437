/* How a figure goes from one state to another: by states on the way, in a time that the eye can follow. */

/** @import { Inputs, Specs } from "./types.js" */

// Milliseconds: the more, the farther a number goes on its slider; half of it is far.
export const SHORT = 600;
const LONG = 900;
const FAR = 0.5;
// A number that can be in no more places than these goes from one to the next.
const FEW = 40;
const PARALLEL = 1e-6;

const ease = (t) => t * t * (3 - 2 * t);
const mix = (a, b, t) => a + (b - a) * t;

/** Whether the reader wants no motion. */
export const isCalm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/**
 * Call a function with each frame, slow at both ends, until it is called with 1.
 * @param {number} lasts milliseconds
 * @param {(t: number) => void} show
 * @returns {() => void} stops it where it is
 */
export function glide(lasts, show) {
  let start;
  const tick = (time) => {
    start ??= time;
    const t = Math.min(1, (time - start) / lasts);
    if (t < 1) frame = requestAnimationFrame(tick);
    show(ease(t));
  };
  let frame = requestAnimationFrame(tick);
  return () => cancelAnimationFrame(frame);
}

/**
 * The inputs on the way: numbers evenly, points and orientations by the shortest arc, choices and
 * switches as they will be.
 * @param {Specs} specs
 * @param {Inputs} from
 * @param {Inputs} to
 * @param {number} t from 0 to 1
 * @returns {Inputs}
 */
export function between(specs, from, to, t) {
  const one = (name) => inputBetween(specs[name], from[name], to[name], t);
  return Object.fromEntries(Object.keys(to).map((name) => [name, one(name)]));
}

function inputBetween(spec, a, b, t) {
  if (t === 1) return b;
  if (spec.kind === "number") return numberBetween(spec, a, b, t);
  if (!Array.isArray(b)) return b;
  if (!Array.isArray(b[0])) return slerp(a, b, t);
  return a.length === b.length ? a.map((point, i) => slerp(point, b[i], t)) : b;
}

function numberBetween({ low, high, step }, a, b, t) {
  const value = mix(a, b, t);
  return (high - low) / step > FEW ? value : low + step * Math.round((value - low) / step);
}

/** The direction on the shortest arc, the length evenly; where no arc is the shortest, it jumps half way. */
export function slerp(a, b, t) {
  const [p, q] = [Math.hypot(...a), Math.hypot(...b)];
  const cosine = a.reduce((sum, x, k) => sum + (x * b[k]) / (p * q), 0);
  const angle = Math.acos(Math.min(1, Math.max(-1, cosine)));
  if (angle < PARALLEL) return a.map((x, k) => mix(x, b[k], t));
  if (angle > Math.PI - PARALLEL) return t < 0.5 ? a : b;
  const length = mix(p, q, t) / Math.sin(angle);
  const [u, v] = [Math.sin((1 - t) * angle) / p, Math.sin(t * angle) / q];
  return a.map((x, k) => length * (u * x + v * b[k]));
}

/**
 * Where a way begins: as things are. But what plays begins at its low end if a choice changes what it
 * plays, for it may stand at its high end already.
 * @param {Specs} specs
 * @param {Inputs} now
 * @param {Inputs} to
 * @returns {Inputs}
 */
export function beginning(specs, now, to) {
  const chosen = Object.entries(specs).some(
    ([name, { kind }]) => /switch|choice/.test(kind) && now[name] !== to[name],
  );
  const first = ([name, value]) => {
    const spec = specs[name];
    const anew = chosen && "plays" in spec && spec.plays && to[name] > spec.low;
    return [name, anew ? spec.low : value];
  };
  return Object.fromEntries(Object.entries(now).map(first));
}

/**
 * How long a way takes, in milliseconds.
 * @param {Specs} specs
 * @param {Inputs} from
 * @param {Inputs} to
 */
export function duration(specs, from, to) {
  const shares = Object.entries(specs).map(([name, spec]) =>
    spec.kind === "number" ? Math.abs(to[name] - from[name]) / (spec.high - spec.low) : FAR / 2,
  );
  return mix(SHORT, LONG, Math.min(1, Math.max(...shares) / FAR));
}
