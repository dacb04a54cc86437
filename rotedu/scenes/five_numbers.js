/* Model of page D. */
import { DEGREES, placing, shown, spread, U } from "./parts.js";
import { combine, quaternionFromAxisAngle, rotationMatrix } from "./rotations.js";

// Where the spoon and the middle of the ball are.
const [SPOON, BALL] = [
  [-1.3, 0, 0],
  [1.3, 0, 0],
];
// Half a turn, in degrees, is the skin.
const HALF = 180;

/** A spoon that turns about U, and the name of its turn whose first number is not negative. */
export function oneName({ angle }) {
  const turned = (degrees) => (degrees > HALF ? degrees - 2 * HALF : degrees);
  const at = (degrees) => combine(1, BALL, turned(degrees) / HALF, U);
  const out = [BALL, at(Math.min(angle, HALF))];
  const back = [combine(1, BALL, -1, U), at(angle)];
  const [w, x] = quaternionFromAxisAngle(U, turned(angle) / DEGREES);
  return {
    parts: {
      spoon: { matrix: placing(rotationMatrix(U, angle / DEGREES), SPOON, 0.9) },
      axis: { paths: [[-1, 1].map((far) => combine(1, BALL, far, U))] },
      gone: shown(angle > 0 && { paths: angle > HALF ? [out, back] : [out] }),
      name: { at: at(angle) },
      middle: { at: BALL },
    },
    labels: { name: null },
    grips: { angle: { path: spread(97).map((t) => at(2 * HALF * t)), holds: ["name", "spoon"] } },
    outputs: { q: [w, x] },
  };
}
