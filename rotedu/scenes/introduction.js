/* Model of Chapter 1. */
import { DEGREES, ORIGIN, placing, turning, U } from "./parts.js";
import { axisAngle, rotationMatrix } from "./rotations.js";

/** A spoon that rolls about its own length: its tip stays where it should be. */
export function theRoll({ roll }, { side }) {
  const turn = rotationMatrix(U, roll / DEGREES);
  return {
    parts: {
      spoon: { matrix: placing(turn, ORIGIN) },
      path: { paths: [turning(side, U, 2 * Math.PI, 36)] },
    },
    labels: { tip: [1.2, 0, 0.06] },
    grips: { roll: { path: turning(side, U, 2 * Math.PI, 36), holds: ["spoon"] } },
    outputs: { off: DEGREES * axisAngle(turn).angle },
  };
}
