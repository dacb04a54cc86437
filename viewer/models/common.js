/* What the models share. */
import { combine, cross, deCasteljau, dot, length, slerp } from "../src/sphere.js";

export const DEGREES = 180 / Math.PI;
export const ORIGIN = [0, 0, 0];

const STEP = 1e-4;

/** Numbers evenly spread from 0 to 1, both included. */
export function spread(count) {
  return Array.from({ length: count }, (_, i) => i / (count - 1));
}

/** Arcs from each point to another: `rotedu.scenes.closed_curve.add_arcs`. */
export function arcs(starts, ends) {
  const t = spread(13);
  return starts.map((p, i) => t.map((x) => slerp(p, ends[i], x)));
}

/** Velocity and geodesic curvature: `rotedu.scenes.closed_curve.motion`. */
export function motion(control, u) {
  const [before, here, after] = [-STEP, 0, STEP].map((x) => deCasteljau(control, u + x));
  const velocity = combine(1 / (2 * STEP), after, -1 / (2 * STEP), before);
  const acceleration = here.map((x, i) => (after[i] - 2 * x + before[i]) / STEP ** 2);
  const speed = Math.max(length(velocity), STEP);
  return { velocity, curvature: dot(cross(here, velocity), acceleration) / speed ** 3 };
}
