/* Models of page D. */
import { DEGREES, IDENTITY, lamp, ORIGIN, placing, scaled, shown, spread, U } from "./parts.js";
import {
  angleBetween,
  combine,
  dot,
  length,
  quaternionFromAxisAngle,
  quaternionMatrix,
  rotationMatrix,
  slerp,
  unit,
} from "./rotations.js";

// Where the spoon and the middle of the ball are.
const SPOON = [-1.3, 0, 0];
const BALL = [1.3, 0, 0];
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
    outputs: { q: `${angle.toFixed(0)}°; ${written(w)}, ${written(x)}` },
  };
}

/** Two decimals, and no sign before nothing. */
const written = (number) => (Math.round(100 * number) / 100).toFixed(2).replace("-", "−");

// A thread is a path of unit quaternions, each near the one before. Angles on their sphere are half of
// those of turns.
const ONE = [1, 0, 0, 0];
const TABLE = [-2.5, 0, 0];
// How many places of a thread are kept, and how many are pulled.
const [KEPT, PULLED] = [40, 40];
// A new place is kept after so much, and nearer than this the spoon falls into its first place.
const [APART, HOME, SAME] = [8 / DEGREES, 6 / DEGREES, 1e-6];
// Rounds of pulling until any thread is tight, and the tremble without which one could balance.
const [ROUNDS, TREMBLE] = [4000, 0.02];
// Degrees by which what is tight may differ from it.
const [TIGHT, FINE] = [3, 3];

/** A spoon, the thread that its turns leave in the ball of half a turn, and how far that is pulled tight. */
export function pullTheThread({ spoon, thread, pulled }) {
  let kept = lifted(thread);
  const first = nearer(ONE, spoon);
  const at = angleBetween(first, spoon) < HOME ? first : unit(spoon);
  if (angleBetween(nearer(at, kept.at(-1)), kept.at(-1)) > SAME) {
    kept = extended(pulled ? even(tightened(kept, pulled), PULLED / 2) : kept, at);
    pulled = 0;
  }
  const path = fine(pulled ? tightened(kept, pulled) : kept);
  const end = path.at(-1);
  const { strands, crossings } = inBall(path);
  const degrees = 2 * DEGREES * lengthOf(path);
  const home = angleBetween(nearer(ONE, end), end) < SAME;
  const strand = (parity) => {
    const paths = strands.filter((_, i) => i % 2 === parity);
    return shown(paths.length && { paths });
  };
  return {
    inputs: { spoon: end, thread: padded(kept), pulled },
    parts: {
      "at the start": { matrix: placing(IDENTITY, TABLE) },
      spoon: { matrix: placing(quaternionMatrix(end), TABLE) },
      even: strand(0),
      odd: strand(1),
      middle: { at: ORIGIN },
      "even end": shown(crossings % 2 === 0 && { at: placeOf(end) }),
      "odd end": shown(crossings % 2 === 1 && { at: placeOf(end) }),
    },
    labels: { middle: home || degrees < 60 ? null : [0, 0, -0.17] },
    grips: { spoon: { at: TABLE, size: 0.95, holds: ["spoon"] } },
    outputs: {
      crossings,
      degrees,
      home: lamp(home),
      verdict: verdict(path, degrees, home, crossings),
    },
  };
}

/** What a thread is like. */
function verdict([start, ...rest], degrees, home, crossings) {
  const shortest = 2 * DEGREES * angleBetween(start, rest.at(-1) ?? start);
  if (degrees > shortest + TIGHT) return "loose";
  if (!home) return "tight";
  return crossings % 2 ? "sticks" : "gone";
}

/** Of two opposite quaternions, the one that is nearer to another. */
const nearer = (q, to) => scaled(dot(q, to) < 0 ? -1 : 1, q);

/** The places of a thread without a jump from one to the next; repeated ones at its end are none. */
function lifted([first, ...rest]) {
  const all = [scaled(first[0] < 0 ? -1 : 1, unit(first))];
  for (const q of rest) all.push(nearer(unit(q), all.at(-1)));
  while (all.length > 1 && angleBetween(all.at(-2), all.at(-1)) < SAME) all.pop();
  return all;
}

/** As many places as are kept: the last is repeated. */
const padded = (thread) =>
  Array.from({ length: KEPT }, (_, i) => thread[Math.min(i, thread.length - 1)]);

/** A thread that goes on to where the spoon is now. */
function extended(thread, spoon) {
  const to = nearer(spoon, thread.at(-1));
  const replaces = thread.length > 1 && angleBetween(thread.at(-2), to) < APART;
  const all = [...(replaces ? thread.slice(0, -1) : thread), to];
  if (all.length <= KEPT) return all;
  // The place that is missed least goes.
  const gaps = all.slice(2).map((q, i) => angleBetween(all[i], q));
  return all.toSpliced(1 + gaps.indexOf(Math.min(...gaps)), 1);
}

const lengthOf = (path) => path.slice(1).reduce((sum, q, i) => sum + angleBetween(path[i], q), 0);

/** A thread by so many places at equal distances. */
function even(thread, count) {
  let far = 0;
  const upTo = thread.map((q, i) => {
    far += i ? angleBetween(thread[i - 1], q) : 0;
    return far;
  });
  const whole = upTo.at(-1);
  if (!whole) return thread;
  return spread(count).map((t) => {
    const reached = upTo.findIndex((x) => x >= t * whole * (1 - 1e-12));
    const i = Math.max(1, reached);
    const share = (t * whole - upTo[i - 1]) / (upTo[i] - upTo[i - 1]);
    return slerp(thread[i - 1], thread[i], share);
  });
}

/** Both ends held, each place goes halfway to the middle of its neighbours, again and again. */
function tightened(thread, pulled) {
  const path = even(thread, PULLED);
  for (let i = 1; i < path.length - 1; i++) {
    path[i] = unit(path[i].map((x, k) => x + TREMBLE * Math.sin((i + 1) * (k + 2) ** 2)));
  }
  const rounds = Math.ceil(ROUNDS * pulled ** 2);
  for (let round = 0; round < 2 * rounds; round++) {
    for (let i = 1 + (round % 2); i < path.length - 1; i += 2) {
      const [a, b, c, d] = path[i];
      const [[e, f, g, h], [k, l, m, n]] = [path[i - 1], path[i + 1]];
      path[i] = unit([2 * a + e + k, 2 * b + f + l, 2 * c + g + m, 2 * d + h + n]);
    }
  }
  return path;
}

/** A thread by places close to one another. */
const fine = (path) =>
  path.flatMap((q, i) => {
    if (!i) return [q];
    const steps = Math.max(1, Math.ceil((DEGREES * angleBetween(path[i - 1], q)) / FINE));
    return spread(steps + 1)
      .slice(1)
      .map((t) => slerp(path[i - 1], q, t));
  });

/** Where a turn is in the ball whose skin is half a turn. */
function placeOf([w, ...v], side = w < 0 ? -1 : 1) {
  const far = length(v);
  return far ? scaled((side * 2 * Math.atan2(far, Math.abs(w))) / Math.PI / far, v) : ORIGIN;
}

/** A thread in the ball: it leaves through the skin where its scalar part is zero, and comes in opposite. */
function inBall(path) {
  let strand = [placeOf(path[0])];
  const strands = [strand];
  for (const [i, q] of path.slice(1).entries()) {
    const before = path[i];
    if (before[0] * q[0] < 0) {
      const skin = unit(combine(Math.abs(q[0]), before, Math.abs(before[0]), q));
      const out = placeOf(skin, Math.sign(before[0]));
      strand.push(out);
      strand = [scaled(-1, out)];
      strands.push(strand);
    }
    strand.push(placeOf(q));
  }
  return { strands, crossings: strands.length - 1 };
}
