/* Models of Chapter 2. */
import {
  columns,
  DEGREES,
  IDENTITY,
  joined,
  lamp,
  ORIGIN,
  placing,
  SIDES,
  scaled,
  shown,
  spread,
  stripes,
  turning,
  U,
  V,
  W,
} from "./parts.js";
import {
  combine,
  cross,
  dot,
  eulerAngles,
  length,
  nlerp,
  product,
  quaternionFromAxisAngle,
  quaternionMatrix,
  quaternionProduct,
  rotate,
  rotateByQuaternion,
  rotationBetween,
  rotationMatrix,
  slerp,
  transform,
  transpose,
  unit,
} from "./rotations.js";

const AXES = { U, V, W };
const ONE = [1, 0, 0, 0];
// To the right in the picture, where a spoon and the ball of turns lie side by side.
const ACROSS = unit([-2.6, 4.4, 0]);
// An arc of fewer degrees has no room for the head of its arrow.
const SMALLEST_ARC = 8;
// What is within this many degrees of its start is back.
const BACK = 0.5;
// Radius of the circle of the angle between the mirrors.
const INNER = 0.55;
// The place of the spoon that is turned by hand.
const TABLE = scaled(-2.2, ACROSS);
// The letters leave room for the name of an axis along theirs.
const ASIDE = { U: [0, 0, -1], V: [0, 0, -1], W: ACROSS };
const BY_HAND = "by hand";
const STEPS_OF_WAY = 120;
const WOBBLE = 0.3;
// A smaller share of a whole turn has no axis to show.
const SHOWN_TURN = 0.01;
// Where the letter lies whose mirrors are seen from above, and how far apart the two dials are.
const [LETTER, DIAL] = [30, 1.3];
// From this share of a whole turn on, a quaternion is on the skin.
const ON_SKIN = 0.97;
// A vector part without a direction, and a step of a path that is a jump through the skin.
const [NO_AXIS, JUMP] = [1e-6, 0.35];
// The ribbon reaches from a bar down to a spoon about the middle of shells that turn.
const [SPOON, BAR, WIDTH, STEM, REACH] = [0.5, [0, 0, 1.45], 0.13, 0.06, 0.46];
// The middle of the plate, the direction of the arm at rest, and where it yields first.
const TRAY = scaled(-2.42, ACROSS);
const ARM = unit(combine(-1, ACROSS, -0.15, W));
const [WRIST, THICK] = [0.55, 0.09];
const TINY = 1e-12;

/** A point off the axis. */
const out = (angle, radius = 1) => rotate([radius, 0, 0], W, angle / DEGREES);

const round = (point) => turning(point, W, 2 * Math.PI, 48);

/** A letter mirrored twice, which turns by twice the angle between the mirrors. */
export function twoMirrorsByHand({ first, second, both, letter }, { outer }) {
  // The shorter way, as mirrors are grabbed and led round.
  const behind = (180 - second + first) % 360;
  const between = 180 - (behind < 0 ? behind + 360 : behind);
  const angles = [first + both, second + both];
  const m = angles.map((angle) => [0, ...out(angle + 90)]);
  const mirrored = (images, k) =>
    images.map((v) => quaternionProduct(quaternionProduct(m[k], [0, ...v]), m[k]).slice(1));
  const start = transpose(rotationMatrix(W, letter / DEGREES));
  const once = mirrored(start, 0);
  const pieces = {
    parts: {
      ring: { paths: [round(out(0, INNER))] },
      "ring 2": { paths: [round(out(0, outer))] },
      letter: { matrix: columns(start) },
      image: { matrix: columns(once) },
      "image of the image": { matrix: columns(mirrored(once, 1)) },
    },
    labels: { both: out(first + both + between / 2 + 130, INNER + 0.28) },
    grips: {
      letter: {
        path: round(out(-180, outer)),
        body: [-0.24, 0.24].map((far) => out(letter, outer + far)),
        holds: ["letter"],
      },
      both: { path: round(out(first + between / 2 + 130, INNER)), holds: ["mirror 1", "mirror 2"] },
    },
    outputs: {
      between,
      turned: 2 * between,
      home: lamp(isBack(2 * between, 360)),
      q: scaled(-1, quaternionProduct(m[1], m[0])),
    },
  };
  return joined(
    pieces,
    mirror(1, first + both, both),
    mirror(2, second + both, both),
    bentArrow("half", angles[0], between, INNER),
    bentArrow("whole", letter, 2 * between, 1.5),
  );
}

/** The same seen along the axis, with one mirror and the letter at rest. */
export function mirrorsInThePlane({ between }, constants) {
  const inputs = { first: 0, second: between, both: 0, letter: LETTER };
  const { parts, labels, outputs } = twoMirrorsByHand(inputs, constants);
  for (const normal of ["m 1", "m 2"]) delete parts[normal];
  return {
    parts,
    labels: { half: labels.half, whole: labels.whole },
    grips: {
      between: { path: turning(out(0, 1.65), W, Math.PI / 3, 48), holds: ["mirror 2", "edge 2"] },
    },
    outputs: { turned: outputs.turned },
  };
}

/** What the two products of q r q* do to the part of r across the axis and to the part along it. */
export function halfTheWork({ done }, { half, along }) {
  const first = half * Math.min(done, 1);
  const second = half * Math.max(done - 1, 0);
  const dials = {
    across: { middle: [-DIAL, 0, 0], length: 1, angles: [first, first + second] },
    along: { middle: [DIAL, 0, 0], length: along, angles: [-first, second - first] },
  };
  const parts = {};
  for (const [name, { middle, length, angles }] of Object.entries(dials)) {
    const at = (angle, radius) => combine(1, middle, 1, rotate([radius, 0, 0], V, -angle));
    const arc = (from, to, radius) => spread(25).map((t) => at(from + t * (to - from), radius));
    const swept = (from, to, radius) => shown(from !== to && { paths: [arc(from, to, radius)] });
    parts[`${name}: start`] = { from: middle, to: at(0, length) };
    parts[`${name}: between`] = shown(done > 0 && { from: middle, to: at(angles[0], length) });
    parts[`${name}: now`] = shown(done > 1 && { from: middle, to: at(angles[1], length) });
    parts[`${name}: first`] = swept(0, angles[0], 0.45);
    parts[`${name}: second`] = swept(angles[0], angles[1], 0.6);
  }
  return { parts, labels: {}, grips: {}, outputs: { scalar: -along * Math.sin(first - second) } };
}

/** A mirror and its normal. The second is longer: both show where they coincide. */
function mirror(number, angle, both) {
  const size = number === 1 ? 1.4 : 1.65;
  const foot = out(angle, size);
  const top = [0, 0, 0.3];
  const corner = combine(1, foot, 1, top);
  const edge = [ORIGIN, foot, corner, top];
  const halfway = (point) => combine(1, point, 0.5, top);
  const normal = out(angle + 90);
  return {
    parts: {
      [`mirror ${number}`]: { points: edge },
      // A mirror acts as if it went on beyond the axis.
      [`edge ${number}`]: { paths: [[out(angle, -size), ...edge]] },
      [`m ${number}`]: { from: corner, to: combine(1, corner, 0.3, normal) },
    },
    labels: { [`m ${number}`]: combine(1, corner, 0.42, normal) },
    grips: {
      [number === 1 ? "first" : "second"]: {
        path: round(halfway(out(both, size))),
        body: [ORIGIN, foot].map(halfway),
        holds: [`mirror ${number}`],
      },
    },
  };
}

/** An angle about the axis, with a head where there is room for one. */
function bentArrow(name, begin, angle, radius) {
  const drawn = Math.abs(angle) >= SMALLEST_ARC;
  const arc = spread(61).map((t) => out(begin + t * angle, radius));
  const to = out(begin + angle, radius);
  const from = combine(1, to, -0.1 * Math.sign(angle), out(begin + angle + 90));
  return {
    parts: {
      [name]: shown(drawn && { paths: [arc] }),
      [`${name}, head`]: shown(drawn && { from, to }),
    },
    labels: { [name]: drawn ? out(begin + angle / 2, radius + 0.16) : null },
  };
}

/** A spoon that is turned by hand, and its two quaternions in the ball of turns. */
export function grabTheSpoon(inputs, { inks, length }, changed) {
  const decided = following(inputs, changed);
  const { spoon, way, along, left } = { ...inputs, ...decided };
  const going = way !== BY_HAND;
  const times = spread(STEPS_OF_WAY + 1).filter((_, i) => i < along * STEPS_OF_WAY - TINY);
  const gone = going ? [...times, along].map(onWay(way, left)) : [spoon];
  const { axes, shares } = turnsOf(gone);
  const axis = axes.at(-1);
  const share = shares.at(-1);
  const whole = 2 * Math.PI * share;
  const turned = SHOWN_TURN < share && share < 1 - SHOWN_TURN;
  const arc = turning([length, 0, 0], axis, whole, 48);
  const onTable = (far, direction) => combine(1, TABLE, far, direction);

  const [point, opposite] = [share, share - 1].map((far) => scaled(far, axis));
  const path = (less) => {
    const runs = going ? pieces(axes.map((n, i) => scaled(shares[i] - less, n))) : [];
    return shown(runs.length && { paths: runs });
  };
  const farther = Math.max(share, 1 - share);
  const parts = {
    "at the start": { matrix: placing(IDENTITY, TABLE) },
    spoon: { matrix: placing(rotationMatrix(axis, whole), TABLE) },
    axis: shown(turned && { from: onTable(-0.8, axis), to: onTable(0.92, axis) }),
    turn: shown(turned && { paths: [arc.map((p) => onTable(1, p))] }),
    "axis in the ball": { paths: [[scaled(-1, axis), axis]], hidden: !turned },
    way: path(0),
    "opposite way": path(1),
    q: { at: point },
    "-q": { at: opposite },
    skin: shown(farther > ON_SKIN && { color: inks[Number(share > 0.5)] }),
  };
  const labels = {
    axis: turned ? onTable(1.03, axis) : null,
    q: beside(point),
    "-q": beside(opposite),
  };
  for (const [letter, direction] of Object.entries(AXES)) {
    parts[`axis ${letter}`] = { from: TABLE, to: onTable(0.9, direction) };
    labels[letter] = combine(1, onTable(0.88, direction), 0.13, ASIDE[letter]);
  }
  return {
    inputs: { ...decided, spoon: gone.at(-1) },
    ...(going ? {} : { trails: { trail: point, "opposite trail": opposite } }),
    parts,
    labels,
    grips: { spoon: { at: TABLE, size: 0.85, holds: ["spoon"] } },
    outputs: { q: gone.at(-1), angle: 360 * share, home: lamp(farther > 1 - BACK / 360) },
  };
}

/**
 * What follows from what the hand has set last: the spoon, a way, or how far the spoon has come.
 * All ways home begin where the hand has left the spoon.
 */
function following({ spoon, way }, changed) {
  const only = (name) => changed.length === 1 && changed[0] === name;
  if (only("spoon")) return { way: BY_HAND, along: 0, left: spoon };
  if (only("way")) return { along: 0 };
  return only("along") && way === BY_HAND ? { way: "home by slerp" } : {};
}

/**
 * The quaternion of the spoon on a way, as a function of the time from 0 to 1, without a jump; a
 * way home leads to 1 or -1.
 */
function onWay(way, left) {
  if (way.startsWith("half turns")) {
    const axes = [...way.slice(-7)].filter((_, i) => i % 3 === 0).map((letter) => AXES[letter]);
    return (t) =>
      axes.reduce((q, axis, k) => {
        const angle = Math.PI * Math.min(1, Math.max(0, 3 * t - k));
        return quaternionProduct(quaternionFromAxisAngle(axis, angle), q);
      }, ONE);
  }
  if (way === "full turn") {
    return (t) => {
      const sway = [4, 6].map((k) => WOBBLE * Math.sin(k * Math.PI * t));
      return quaternionFromAxisAngle([...sway, 1], 2 * Math.PI * t);
    };
  }
  if (way === "home by Euler angles") {
    const angles = eulerAngles(quaternionMatrix(left));
    const sign = Math.sign(dot(quaternionFromEulerAngles(angles), left));
    return (t) => scaled(sign, quaternionFromEulerAngles(scaled(1 - t, angles)));
  }
  const to = scaled(left[0] >= 0 ? 1 : -1, ONE);
  const between = way === "home by slerp" ? slerp : nlerp;
  return (t) => between(left, to, t);
}

/** Turns about U, V, W: `rotedu.general_rotation.quaternion_from_euler_angles`. */
function quaternionFromEulerAngles(angles) {
  const [qu, qv, qw] = angles.map((angle, i) => quaternionFromAxisAngle(IDENTITY[i], angle));
  return quaternionProduct(qw, quaternionProduct(qv, qu));
}

/** A spoon that turns twice on a ribbon, which is then passed round it. */
export function theRibbon({ done }) {
  const [turns, passed] = [Math.min(done, 2), Math.max(done - 2, 0)];
  const bar = [-2.5, 2.5].map((far) => combine(1, BAR, far * WIDTH, U));
  const edges = [-WIDTH, 0, WIDTH].map((width) => sideOfRibbon(turns, passed, width));
  const rim = turning([REACH, 0, 0], W, 4 * Math.PI, 96);
  return {
    parts: {
      bar: { paths: [bar] },
      spoon: { matrix: placing(rotationMatrix(W, 2 * Math.PI * turns), ORIGIN) },
      "one half": { points: [...edges[0], ...edges[1]] },
      "other half": { points: [...edges[1], ...edges[2]] },
      borders: { paths: [edges[0], edges[2]].map(everyOther) },
    },
    labels: { spoon: null },
    grips: { done: { path: [...rim, ...wayOfRibbon()], holds: ["spoon", "one half"] } },
    outputs: { twists: passed % 1 ? "on its way" : turns - 2 * passed },
  };
}

const everyOther = (list) => list.filter((_, i) => i % 2 === 0);

/**
 * A line of the ribbon, which is so far from its middle, from spoon to bar. Shells about the spoon
 * turn as the ribbon does. So it crosses neither itself nor the spoon.
 */
function sideOfRibbon(turns, passed, width) {
  const radii = spread(201).map((t) => STEM + t * (BAR[2] - STEM));
  return shells(turns, passed, ACROSS, radii, [SPOON, BAR[2]]).map((q, i) =>
    rotateByQuaternion(q, combine(width, U, radii[i], W)),
  );
}

/** Where the middle of the ribbon is on its way round the spoon, half as many steps as two turns. */
function wayOfRibbon() {
  const middle = (SPOON + BAR[2]) / 2;
  return spread(49)
    .slice(1)
    .map((passed) => {
      const [q] = shells(2, passed, ACROSS, [middle], [SPOON, BAR[2]]);
      return scaled(middle, rotateByQuaternion(q, W));
    });
}

/** A plate on a hand, turned about the upright, and the striped arm that holds it. */
export function plateAndArm({ turns }, { plate, reach }) {
  const places = spread(81).map((t) => reach * t);
  const turned = shells(turns, turns / 2, ACROSS, places, [WRIST, reach]);
  const skin = roundArm(turned, places);
  const { axes, shares } = turnsOf(turned);
  const path = axes.map((axis, i) => scaled(shares[i], axis));
  const drawn = pieces(path);
  const angle = 2 * Math.PI * turns;
  return {
    parts: {
      plate: { matrix: placing(rotationMatrix(W, angle), TRAY) },
      spoon: { matrix: placing(rotationMatrix(W, angle), TRAY) },
      "one half": { points: stripes(skin, 0) },
      "other half": { points: stripes(skin, 2) },
      shoulder: { at: combine(1, TRAY, reach, ARM) },
      path: shown(drawn.length && { paths: drawn }),
      end: { at: path[0] },
      skin: { hidden: shares[0] <= ON_SKIN },
    },
    labels: { end: beside(path[0]) },
    grips: { turns: { path: twiceRound(plate), holds: ["plate", "spoon"] } },
    outputs: {
      angle: 360 * turns,
      q: turned[0],
      spoon_back: lamp(isBack(360 * turns, 360)),
      arm_straight: lamp(isBack(360 * turns, 720)),
    },
  };
}

/**
 * Rings of points about a line from the plate outwards that turns with shells, shape
 * (n, SIDES, 3). Each ring stands across the line, turned there from its shell by the smallest turn.
 */
function roundArm(turned, places) {
  const middle = turned.map((q, i) => combine(1, TRAY, places[i], rotateByQuaternion(q, ARM)));
  const across = cross(W, ARM);
  const sides = turning(across, ARM, 2 * Math.PI, SIDES).slice(1);
  return middle.map((point, i) => {
    const [before, after] = [middle[i - 1] ?? point, middle[i + 1] ?? point];
    const tangent = unit(combine(1, after, -1, before));
    const outwards = rotateByQuaternion(turned[i], ARM);
    const turn = product(rotationBetween(outwards, tangent), quaternionMatrix(turned[i]));
    return sides.map((side) => combine(1, point, THICK, transform(turn, side)));
  });
}

/** Twice round the rim of the plate, a little wider at the end: two turns have two ends. */
const twiceRound = (radius) =>
  spread(97).map((t) => {
    return combine(1, TRAY, radius * (1 + 0.01 * t), rotate(U, W, 4 * Math.PI * t));
  });

/**
 * Unit quaternions of shells, by their radii: those within the first radius have turned about W so
 * often, those beyond the second not at all, and between them a path goes at constant speed, which is
 * passed round the inner ones up to once.
 *
 * The path is an arc of a circle. Its ends are held. Two turns are a great circle from 1 to 1, which
 * shrinks to a point. Fewer are an arc of it, which goes over to the other arc between its ends, with
 * two turns less. On the way the circle is that through the ends and the middle of the arc, which
 * moves evenly from one side to the other, through a direction aside.
 */
function shells(turns, passed, aside, radii, [inner, outer]) {
  const half = (Math.PI * turns) / 2;
  const rise = Math.cos(Math.PI * passed) - Math.cos(half);
  const out = Math.sin(Math.PI * passed);
  const tilt = Math.atan2(out, rise);
  const axis = [-Math.sin(tilt) * Math.cos(half), -Math.sin(tilt) * Math.sin(half), Math.cos(tilt)];
  const radius = Math.hypot(axis[1], axis[2]);
  const whole = 4 * Math.atan2(Math.hypot(rise, out), Math.sin(half));
  const side = rotate(aside, W, (Math.PI / 6) * (2 - turns));
  return radii.map((r) => {
    const x = Math.min(1, Math.max(0, (r - inner) / (outer - inner)));
    const share = radius > TINY ? 1 - x ** 3 * (10 - 15 * x + 6 * x * x) : 0;
    const [w, along, across] = rotate([1, 0, 0], axis, share * whole);
    return [w, ...combine(along, W, across, side)];
  });
}

/** Where the name of a point of the ball is: where the glass does not hide it. */
const beside = (point) => combine(0.9, point, 1, combine(0.1, ACROSS, 0.12, W));

/**
 * Axes and angles of unit quaternions one after the other, angles as shares of a whole turn: from 0
 * for the quaternion 1 over 1/2 for half a turn to 1 for -1. At 1 and -1, where any axis would do,
 * the axis is that of the one before, and at the beginning that of the first one after.
 *
 * The opposite quaternion has the same axis and a share that is less by 1.
 */
function turnsOf(path) {
  const sizes = path.map(([, ...v]) => Math.hypot(...v));
  const known = (i) => sizes[i] > NO_AXIS;
  let last = path.findIndex((_, i) => known(i));
  const axes = path.map((_, i) => {
    if (last < 0) return W;
    if (known(i)) last = i;
    return scaled(1 / sizes[last], path[last].slice(1));
  });
  return { axes, shares: path.map(([w], i) => Math.atan2(sizes[i], w) / Math.PI) };
}

const apart = (p, q) => length(combine(1, p, -1, q));

/** Cut a path where it jumps through the skin of the ball; leave out what has no length. */
function pieces(path) {
  const jumps = path.map((_, i) => i).filter((i) => i && apart(path[i - 1], path[i]) > JUMP);
  const cuts = [0, ...jumps, path.length];
  const parts = cuts.slice(1).map((end, i) => path.slice(cuts[i], end));
  const extent = (values) => Math.max(...values) - Math.min(...values);
  return parts.filter((part) => transpose(part).some((values) => extent(values) > NO_AXIS));
}

/** Whether a turn, in degrees, ends where it began: after whole laps. */
const isBack = (angle, lap) => (Math.abs(angle) + BACK) % lap < 2 * BACK;
