/* Models of page C. */
import { DEGREES, placing, SIDES, scaled, shown, spread, stripes, turning, U, V } from "./parts.js";
import {
  angleBetween,
  arcAxis,
  blendDualQuaternions,
  blendMatrices,
  combine,
  cross,
  dot,
  length,
  product,
  rotationBetween,
  rotationMatrix,
  slerp,
  transform,
  transpose,
  unit,
} from "./rotations.js";

const AVERAGED = "matrices, averaged";
const SKINS = {
  [AVERAGED]: blendMatrices,
  "the same, repaired": (poses, weights) => blendMatrices(poses, weights, true),
  "dual quaternions": blendDualQuaternions,
};
const HALF = 180;
// At half a turn there are two averages: those of turns that are less or more by this, in degrees.
const NEAR = 0.01;
// A ring, and where on it is the top.
const ROUND = turning(V, U, 2 * Math.PI, SIDES).slice(1);
const TOP = SIDES / 4 - 1;
// Steps of the path of the vertex, and where the hand is held.
const [STEP, PALM] = [5, 3.9];

/** An arm of three bones, bent at the elbow and turned at the wrist, and a vertex of its skin. */
export function theArm({ skin, twist, bend }, arm) {
  const bones = bonesOf(arm, twist, bend);
  const palm = arm.rings.find(([x]) => x >= PALM);
  const round = spread(97).map((t) => at(bonesOf(arm, 360 * t, bend)[2], ringOf(palm)[TOP]));
  const forearm = [(arm.elbow + arm.wrist) / 2, 0, 0];
  const lifted = spread(49).map((t) => at(bonesOf(arm, 0, 140 * t)[1], forearm));
  const state = skinned(skin, arm, arm.rings, twist, bend);
  const other = state.parts["or here"];
  return {
    ...state,
    grips: { twist: { path: round, holds: ["vertex"] }, bend: { path: lifted, holds: ["vertex"] } },
    labels: {
      bend: at(bones[0], [arm.elbow, 0, -0.55]),
      "or here": other.hidden
        ? null
        : combine(1, other.at, 0.25, unit(combine(1, other.at, -1, state.parts.vertex.at))),
    },
  };
}

/** A forearm and a hand that turns, skinned by averaged matrices. */
export function theWrist({ twist }, arm) {
  const rings = arm.rings.filter(([x]) => x > arm.elbow + arm.bands[0]);
  const { parts, outputs } = skinned(AVERAGED, arm, rings, twist, 0);
  const palm = rings.find(([x]) => x >= PALM);
  const path = spread(97).map((t) => at(bonesOf(arm, 360 * t, 0)[2], ringOf(palm)[TOP]));
  return {
    parts,
    labels: {},
    grips: { twist: { path, holds: ["vertex"] } },
    outputs: { wrist: outputs.wrist },
  };
}

/** Parts and outputs of rings of a skin. */
function skinned(skin, arm, rings, twist, bend) {
  const split = skin !== AVERAGED && Math.abs(twist - HALF) < NEAR;
  if (split) twist = HALF - NEAR;
  const bones = bonesOf(arm, twist, bend);
  const rest = rings.map(ringOf);
  const moved = rest.map((ring, i) => {
    const pose = poseAt(skin, arm, bones, rings[i][0]);
    return ring.map((point) => at(pose, point));
  });
  const middle = rings.findIndex(([x]) => x >= arm.wrist);
  const followed = (degrees) =>
    at(poseAt(skin, arm, bonesOf(arm, degrees, bend), rings[middle][0]), rest[middle][TOP]);
  const angles = [...Array(Math.floor(twist / STEP) + 1).keys()].map((k) => STEP * k);
  // Where the vertex jumps, at half a turn, its path begins anew.
  const ways = [
    [...angles.filter((x) => x < HALF), Math.min(twist, HALF - NEAR)],
    twist > HALF ? [HALF + NEAR, ...angles.filter((x) => x > HALF), twist] : [],
  ];
  const paths = ways.filter((way) => way.length).map((way) => way.map(followed));
  const vertex = moved[middle][TOP];
  const out = combine(1, vertex, -1, at(bones[1], [rings[middle][0], 0, 0]));
  return {
    parts: {
      "one half": { points: stripes(moved, 0) },
      "other half": { points: stripes(moved, 2) },
      way: shown(twist > 0 && { paths }),
      vertex: { at: vertex },
      "or here": shown(split && { at: followed(HALF + NEAR) }),
    },
    outputs: {
      wrist: (100 * length(out)) / rings[middle][2],
      stretch: 100 * stretch(rest, moved),
      volume: (100 * volume(moved)) / volume(rest),
    },
  };
}

/** The poses of upper arm, forearm and hand: rows of three. The shoulder is the origin. */
function bonesOf({ elbow }, twist, bend) {
  const turn = rotationMatrix(V, -bend / DEGREES);
  const joint = [elbow, 0, 0];
  const step = combine(1, joint, -1, transform(turn, joint));
  const hand = product(turn, rotationMatrix(U, twist / DEGREES));
  const upper = [U, V, [0, 0, 1]].map((row) => [...row, 0]);
  return [upper, ...[turn, hand].map((m) => m.map((row, i) => [...row, step[i]]))];
}

/** The pose of the skin so far along the arm: of two bones at most. */
function poseAt(skin, { elbow, wrist, bands }, bones, x) {
  const [upper, fore, hand] = bones;
  const share = (joint, band) => Math.min(1, Math.max(0, (x - joint + band) / (2 * band)));
  const beyond = x > elbow + bands[0];
  const t = beyond ? share(wrist, bands[1]) : share(elbow, bands[0]);
  return SKINS[skin](beyond ? [fore, hand] : [upper, fore], [1 - t, t]);
}

/** Where a pose takes a point. */
const at = (pose, point) => pose.map((row) => dot(point, row) + row[3]);

/** Points round the arm, given how far along it, how wide and how thick they are. */
const ringOf = ([x, wide, thick]) => ROUND.map(([, v, w]) => [x, wide * v, thick * w]);

/** How many times as long the skin is, along the arm and where it is stretched most. */
function stretch(rest, moved) {
  const steps = (rings) =>
    rings.slice(1).flatMap((ring, i) => ring.map((p, k) => length(combine(1, p, -1, rings[i][k]))));
  const before = steps(rest);
  return Math.max(...steps(moved).map((step, k) => step / before[k]));
}

/** What rings enclose, up to their small ends. */
function volume(rings) {
  const six = (a, b, c) => dot(a, cross(b, c));
  let sum = 0;
  for (let i = 1; i < rings.length; i++) {
    for (let k = 0; k < SIDES; k++) {
      const next = (k + 1) % SIDES;
      const [a, b] = [rings[i - 1][k], rings[i - 1][next]];
      const [c, d] = [rings[i][k], rings[i][next]];
      sum += six(a, b, c) + six(b, d, c);
    }
  }
  return Math.abs(sum) / 6;
}

/** The smallest turn from a to b, carried out on a spoon that points along a. */
export function fromAToB({ a, b }, { beside }) {
  [a, b] = [a, b].map(unit);
  const turn = rotationBetween(a, b);
  const angle = angleBetween(a, b);
  // A spoon along a, its bowl turned up as far as it can be.
  const side = unit(cross(Math.abs(a[2]) < 0.99 ? [0, 0, 1] : V, a));
  const held = transpose([a, side, cross(a, side)]);
  const still = angle < 1e-3;
  const axis = still ? [0, 0, 1] : arcAxis(a, b);
  const spoon = (m, place) => ({ matrix: placing(m, place) });
  return {
    parts: {
      arc: shown(!still && { paths: [spread(61).map((t) => slerp(a, b, t))] }),
      axis: shown(!still && { from: scaled(-1.25, axis), to: scaled(1.25, axis) }),
      a: { from: [0, 0, 0], to: a },
      b: { from: [0, 0, 0], to: b },
      "tip a": { at: a },
      "tip b": { at: b },
      opposite: { at: scaled(-1, a) },
      "spoon before": spoon(held, beside),
      "spoon after": spoon(product(turn, held), beside),
    },
    labels: {
      a: angle < 0.2 ? null : scaled(1.17, a),
      b: scaled(1.17, b),
      v: still ? null : scaled(1.4, axis),
      opposite: Math.PI - angle < 0.2 ? null : scaled(-1.17, a),
    },
    grips: { a: { holds: ["a", "tip a"] }, b: { holds: ["b", "tip b"] } },
    outputs: { angle: DEGREES * angle, share: 2 / dot(combine(1, a, 1, b), combine(1, a, 1, b)) },
  };
}
