/* Model of Chapter 3. */
import { DEGREES, joined, ORIGIN, placing, scaled, shown, turning } from "./parts.js";
import {
  combine,
  cross,
  dot,
  length,
  rotate,
  rotationMatrix,
  transform,
  unit,
} from "./rotations.js";

// A shorter piece is not drawn.
const HAIR = 1e-6;
// To the right in the picture, clear of the ring around a tip.
const ASIDE = [-0.03, 0.13, 0];

/** A spoon turned about an axis, and the circles on which some of its points stay. */
export function everyPoint({ theta }, { axis, points }) {
  const turn = rotationMatrix(axis, theta / DEGREES);
  const circles = points.map((point) => turning(point, axis, 2 * Math.PI, 60));
  return {
    parts: {
      spoon: { matrix: placing(turn, ORIGIN) },
      circles: { paths: circles },
      point: { at: transform(turn, points[0]) },
    },
    labels: {},
    grips: { theta: { path: circles[0], holds: ["spoon"] } },
    outputs: {},
  };
}

/** A vector turned about an axis, the three terms of (3-1) as far as drawn, and a second vector. */
export function figure1ByHand({ vector: r, axis, theta, drawn, around }) {
  const n = unit(axis);
  const angle = theta / DEGREES;
  const center = scaled(dot(r, n), n);
  const circle = turning(r, n, 2 * Math.PI, 80);
  const apart = around % 360 !== 0;
  const other = rotate(r, n, around / DEGREES);
  const [here, there] = [r, other].map((vector) => terms(vector, n, angle));
  const differences = here.map((term, i) => length(combine(1, there[i], -1, term)));
  const construction = {
    parts: {
      ...headToTail(here, drawn, "term"),
      ...headToTail(there, apart ? drawn : 0, "other term"),
    },
    grips: {
      vector: { holds: ["r"] },
      axis: { holds: ["n"] },
      theta: { path: circle, body: [ORIGIN, rotate(r, n, angle)], holds: ["turned"] },
      around: {
        path: apart ? circle : null,
        body: [ORIGIN, other],
        holds: ["other", "other start"],
      },
    },
    outputs: {
      first: Math.cos(angle),
      first_apart: differences[0],
      along: (1 - Math.cos(angle)) * dot(r, n),
      along_apart: differences[1],
      across: Math.sin(angle),
      across_apart: differences[2],
      matrix: rotationMatrix(n, angle),
    },
  };
  const second = another(apart ? other : null, rotate(other, n, angle), center, n);
  return joined(oneTurn(r, n, angle, center, circle), construction, second);
}

/** A second vector on the circle, if there is one, and where it ends. */
function another(start, end, center, n) {
  return {
    parts: {
      other: shown(start && { paths: [[ORIGIN, start]] }),
      "other start": shown(start && { at: start }),
      "other end": shown(start && { at: end }),
    },
    labels: {
      "\\vec r_2": start && beside(start, center, n, 0.12),
      "\\vec r_2^{\\,\\prime}": start && beside(end, center, n, 0.25),
    },
  };
}

/** A place outside of the circle for the name of a tip, and higher or lower. */
function beside(tip, center, n, up) {
  return combine(1, combine(1.17, tip, -0.17, center), up, n);
}

/** A vector on its circle, before and after a turn. */
function oneTurn(r, n, angle, center, circle) {
  const spoke = combine(1, r, -1, center);
  const turned = rotate(r, n, angle);
  const middle = rotate(spoke, n, 0.5 * angle);
  const rim = turning(scaled(0.42, spoke), n, angle, 48);
  const spokes = [r, turned].map((end) => [center, end]);
  return {
    parts: {
      circle: { paths: [circle] },
      sector: { points: [center, ...rim.map((x) => combine(1, center, 1, x))] },
      spokes: { paths: spokes },
      centre: { at: center },
      height: { paths: [[ORIGIN, center]] },
      n: { from: ORIGIN, to: scaled(1.1, n) },
      r: { from: ORIGIN, to: r },
      turned: { from: ORIGIN, to: turned },
    },
    labels: {
      O: [0, 0.13, -0.1],
      "\\theta": combine(1, center, 0.28, middle),
      "\\vec r_\\parallel": combine(0.45, center, -1, ASIDE),
      "\\vec r_\\perp": combine(1, combine(1, center, 0.8, spoke), 0.09, n),
      "\\hat n": combine(1.1, n, 1, ASIDE),
      "\\vec r": beside(r, center, n, -0.12),
      "\\vec r^{\\,\\prime}": beside(turned, center, n, 0.12),
    },
  };
}

/** The three terms of (3-1). */
function terms(r, n, angle) {
  const cos = Math.cos(angle);
  return [scaled(cos, r), scaled((1 - cos) * dot(r, n), n), scaled(Math.sin(angle), cross(n, r))];
}

/** Arrows for terms, one after another, without those that vanish. */
function headToTail(three, drawn, name) {
  let from = ORIGIN;
  const arrows = three.map((term, i) => {
    const part = scaled(Math.min(Math.max(drawn - i, 0), 1), term);
    const to = combine(1, from, 1, part);
    const arrow = shown(length(part) > HAIR && { from, to });
    from = to;
    return [`${name} ${i + 1}`, arrow];
  });
  return Object.fromEntries(arrows);
}
