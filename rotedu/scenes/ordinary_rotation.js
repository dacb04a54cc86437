/* Model of Chapter 3. */
import { DEGREES, joined, ORIGIN, scaled, shown, turning } from "./parts.js";
import { combine, cross, dot, length, rotate, rotationMatrix, unit } from "./rotations.js";

// A shorter piece is not drawn.
const HAIR = 1e-6;
// To the right in the picture, clear of the ring around a tip.
const ASIDE = [-0.03, 0.13, 0];

/** Two vectors turned about one axis, and the three terms of (3-1) for each. */
export function figure1ByHand({ vector: r, axis, theta, around }, _, changed) {
  const n = unit(axis);
  const angle = theta / DEGREES;
  const center = scaled(dot(r, n), n);
  const turned = rotate(r, n, angle);
  const other = rotate(r, n, around / DEGREES);
  const otherEnd = rotate(other, n, angle);
  const [here, there] = [r, other].map((vector) => terms(vector, n, angle));
  const circle = turning(r, n, 2 * Math.PI, 80);
  const beside = (tip, up) => combine(1, combine(1.17, tip, -0.17, center), up, n);
  const apart = here.map((term, i) => length(combine(1, there[i], -1, term)));
  const second = {
    parts: {
      other: { paths: [[ORIGIN, other]] },
      "other start": { at: other },
      "other end": { at: otherEnd },
      ...headToTail(here, "term"),
      ...headToTail(there, "other term"),
      halo: halo(unchanged(changed, center, here, there)),
    },
    grips: {
      vector: { holds: ["r"] },
      axis: { holds: ["n"] },
      theta: { path: circle, body: [ORIGIN, turned], holds: ["turned"] },
      around: { path: circle, body: [ORIGIN, other], holds: ["other", "other start"] },
    },
    labels: {
      "\\vec r": beside(r, -0.12),
      "\\vec r^{\\,\\prime}": beside(turned, 0.12),
      "\\vec r_2": beside(other, 0),
      "\\vec r_2^{\\,\\prime}": beside(otherEnd, 0.25),
    },
    outputs: {
      first: Math.cos(angle),
      first_apart: apart[0],
      along: (1 - Math.cos(angle)) * dot(r, n),
      along_apart: apart[1],
      across: Math.sin(angle),
      across_apart: apart[2],
      matrix: rotationMatrix(n, angle),
    },
  };
  return joined(oneTurn(r, n, angle, center, circle), second);
}

/** A vector on its circle, before and after a turn. */
function oneTurn(r, n, angle, center, circle) {
  const spoke = combine(1, r, -1, center);
  const turned = rotate(r, n, angle);
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
      "\\theta": combine(1, center, 0.28, rotate(spoke, n, 0.5 * angle)),
      "\\vec r_\\parallel": combine(0.4, center, -0.16, spoke),
      "\\vec r_\\perp": combine(1, combine(1, center, 0.72, spoke), 0.09, n),
      "\\hat n": combine(1.1, n, 1, ASIDE),
    },
  };
}

/** The three terms of (3-1). */
function terms(r, n, angle) {
  const cos = Math.cos(angle);
  return [scaled(cos, r), scaled((1 - cos) * dot(r, n), n), scaled(Math.sin(angle), cross(n, r))];
}

/** What stays as it is while one number changes, as lines. */
function unchanged(changed, center, here, there) {
  if (changed.length !== 1) return [];
  const second = ([first, along]) => [first, combine(1, first, 1, along)];
  return { theta: [[ORIGIN, center]], around: [second(here), second(there)] }[changed[0]] ?? [];
}

/** What stays as it is shines, but only while the hand moves: lines, without those that vanish. */
function halo(lines) {
  const paths = lines.filter(([from, to]) => length(combine(1, to, -1, from)) > HAIR);
  return shown(paths.length && { paths });
}

/** Arrows for terms, without those that vanish. */
function headToTail(three, name) {
  let from = ORIGIN;
  const arrows = three.map((term, i) => {
    const to = combine(1, from, 1, term);
    const arrow = shown(length(term) > HAIR && { from, to });
    from = to;
    return [`${name} ${i + 1}`, arrow];
  });
  return Object.fromEntries(arrows);
}
