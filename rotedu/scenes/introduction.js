/* Model of Chapter 1. */
import { DEGREES, IDENTITY, ORIGIN, placing, scaled, spread, turning, U, W } from "./parts.js";
import {
  axisAngle,
  combine,
  matrixFromEulerAngles,
  quaternionFromAxisAngle,
  rotationMatrix,
  transform,
  turnBetween,
} from "./rotations.js";

const SHARES = spread(41);

/** A spoon that rolls about its own length: its tip stays where it should be. */
export function theRoll({ roll }, { side }) {
  const turn = rotationMatrix(U, roll / DEGREES);
  const path = turning(side, U, 2 * Math.PI, 36);
  return {
    parts: { spoon: { matrix: placing(turn, ORIGIN) }, path: { paths: [path] } },
    labels: { tip: [1.2, 0, 0.06] },
    grips: { roll: { path, holds: ["spoon"] } },
    outputs: { off: DEGREES * axisAngle(turn).angle },
  };
}

/** Three spoons that stop a share of the way to where one turn, or three, would take them. */
export function onTheWay({ share }, { axis, angle, angles }) {
  const turns = {
    mechanic: (t) => rotationMatrix(axis, t * angle),
    pilot: (t) => matrixFromEulerAngles(...angles.map((each) => t * each)),
    draughtsman: (t) =>
      IDENTITY.map((row, i) => combine(1 - t, row, t, rotationMatrix(axis, angle)[i])),
  };
  const parts = {};
  // Where all three lie in one place, one is drawn.
  const together = share === 0 || share === 1;
  for (const [name, turn] of Object.entries(turns)) {
    const hidden = together && name !== "mechanic";
    parts[name] = { matrix: placing(turn(share), ORIGIN), hidden };
    parts[`${name}'s path`] = { paths: [SHARES.map((t) => transform(turn(t), U))] };
  }
  const [right, missed] = [turns.mechanic(share), turns.pilot(share)];
  return {
    parts,
    labels: {},
    grips: { share: { path: parts["mechanic's path"].paths[0], holds: ["mechanic"] } },
    outputs: { off: DEGREES * turnBetween(right, missed).angle },
  };
}

/** A level spoon that turns about W, and the axis of the shorter turn to where it lies. */
export function onceRound({ turned }) {
  const angle = turned / DEGREES;
  const shorter = turned - 360 * Math.floor(turned / 360 + 1 / 2);
  return {
    parts: {
      spoon: { matrix: placing(rotationMatrix(W, angle), ORIGIN) },
      axis: { from: ORIGIN, to: scaled(shorter < 0 ? -0.6 : 0.6, W) },
    },
    labels: {},
    grips: { turned: { path: turning(scaled(1.1, U), W, 4 * Math.PI, 96), holds: ["spoon"] } },
    outputs: { numbers: quaternionFromAxisAngle(W, angle) },
  };
}
