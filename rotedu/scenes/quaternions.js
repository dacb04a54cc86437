/* Models of Chapter 2. */
import {
  columns,
  DEGREES,
  IDENTITY,
  joined,
  lamp,
  ORIGIN,
  placing,
  scaled,
  shown,
  spread,
  turning,
  U,
  V,
  W,
} from "./parts.js";
import {
  combine,
  dot,
  eulerAngles,
  length,
  nlerp,
  quaternionFromAxisAngle,
  quaternionMatrix,
  quaternionProduct,
  rotate,
  rotateByQuaternion,
  rotationMatrix,
  slerp,
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
// The place of the spoon on the ribbon, and the radius of the ring about it.
const HOME = scaled(-2.35, ACROSS);
const RING = 0.6;
// The ribbon reaches from a bar down to a spoon about the middle of shells that turn.
const [SPOON, BAR, WIDTH, STEM] = [0.42, 1.26, 0.11, 0.06];
const MIDDLE_OF_BAR = combine(1, HOME, BAR, W);
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

/** A spoon that has turned on a ribbon, and how the ribbon is passed round it. */
export function doubleCoverByHand({ turns, passed: wanted }, { on_its_way, reach }) {
  const passed = Math.min(wanted, passes(turns));
  const hangs = Number.isInteger(passed);
  const angle = 2 * Math.PI * turns;
  const matrix = rotationMatrix(W, angle);

  const bar = [-2.5, 2.5].map((far) => combine(1, MIDDLE_OF_BAR, far * WIDTH, U));
  const edges = [-WIDTH, 0, WIDTH].map((width) => sideOfRibbon(turns, passed, width));
  const onRing = (theta, side) => combine(1, HOME, RING, onBand(theta, side));
  const rounds = spread(97).map((t) => 2 * Math.PI * t);
  const [q, opposite] = [1, -1].map((side) => onRing(angle, side));
  const { axes, shares } = turnsOf(alongRibbon(turns, passed, spread(161)));
  const path = axes.map((axis, i) => scaled(shares[i], axis));
  const end = path.at(-1);
  const drawn = pieces(path);
  const way = spread(97).map((t) => onRing(t * angle, 1));

  return {
    inputs: wanted > passed ? { passed } : {},
    parts: {
      bar: { paths: [bar] },
      spoon: { matrix: placing(matrix, HOME) },
      "one half": { points: [...edges[0], ...edges[1]] },
      "other half": { points: [...edges[1], ...edges[2]] },
      borders: { paths: [edges[0], edges[2]].map(everyOther) },
      band: {
        points: rounds.flatMap((theta) => [1, 0, -1].map((side) => onRing(theta, side))),
        hidden: !hangs,
      },
      ring: { paths: [everyOther(rounds).map((theta) => onRing(theta, 0))], hidden: !hangs },
      way: shown(hangs && turns > 0 && { paths: [way] }),
      stick: { paths: [[q, opposite]], hidden: !hangs },
      q: { at: q, hidden: !hangs },
      "-q": { at: opposite, hidden: !hangs },
      path: shown(drawn.length && { paths: drawn }),
      end: { at: end },
      skin: { hidden: shares.at(-1) <= ON_SKIN },
    },
    labels: {
      q: hangs ? onRing(angle, 1.6) : null,
      "-q": hangs ? onRing(angle, -1.6) : null,
      end: beside(end),
    },
    grips: {
      turns: { path: onceForEachTurn(reach), holds: ["spoon"] },
      passed: { path: wayOfRibbon(turns), holds: ["one half", "other half"] },
    },
    outputs: {
      twists: hangs ? turns - 2 * passed : on_its_way,
      spoon_back: lamp(isBack(360 * turns, 360)),
      q_back: lamp(isBack(360 * turns, 720)),
      q: quaternionFromAxisAngle(W, angle),
      matrix,
    },
  };
}

/** How often a ribbon must be passed round the spoon to lose all twists but one. */
const passes = (turns) => (turns <= 2 ? 1 : 2);

const everyOther = (list) => list.filter((_, i) => i % 2 === 0);

/**
 * Rotations of the ribbon at fractions of its way from the bar to the spoon, which goes at constant
 * speed.
 */
function alongRibbon(turns, passed, fractions) {
  const { axis, radius, length, side, staying } = movingArc(turns, passed);
  return fractions.map((s) => {
    const gone = s * (length + Math.PI * staying);
    const turned = Math.min(gone, length) / Math.max(radius, TINY);
    const [w, along, aside] = rotate([1, 0, 0], axis, turned);
    const moved = [w, ...combine(along, W, aside, side)];
    return quaternionProduct(quaternionFromAxisAngle(W, 2 * Math.max(gone - length, 0)), moved);
  });
}

/**
 * The arc of unit quaternions to which the ribbon is a path, beside turns that stay next to the
 * spoon: a part of a circle about an axis, whose coordinates are along 1, W and a direction to the
 * side. The quaternion of so many turns about W, which stay as they are, follows the arc.
 *
 * Its ends are held: 1 at the bar, a quaternion about W at the other end. Two turns are a great
 * circle from 1 to 1, which shrinks to a point. Fewer are an arc of it, which goes over to the
 * other arc between its ends, with two turns less. On the way the circle is that through the ends
 * and the middle of the arc, which moves evenly from one side to the other.
 */
function movingArc(turns, passed) {
  const done = Math.min(Math.floor(passed), passes(turns) - 1);
  const [left, tau] = [turns - 2 * done, passed - done];
  const [moving, staying] = [Math.min(left, 2), Math.max(left - 2, 0)];
  const half = (Math.PI * moving) / 2;
  const rise = Math.cos(Math.PI * tau) - Math.cos(half);
  const out = Math.sin(Math.PI * tau);
  const tilt = Math.atan2(out, rise);
  const axis = [-Math.sin(tilt) * Math.cos(half), -Math.sin(tilt) * Math.sin(half), Math.cos(tilt)];
  const radius = Math.hypot(axis[1], axis[2]);
  const arc = radius * 4 * Math.atan2(Math.hypot(rise, out), Math.sin(half));
  const side = rotate(ACROSS, W, (Math.PI / 6) * (2 - moving));
  return { axis, radius, length: arc, side, staying };
}

/**
 * A line of the ribbon, which is so far from its middle, from spoon to bar. Shells about the spoon
 * turn as the ribbon does. So it crosses neither itself nor the spoon.
 */
function sideOfRibbon(turns, passed, width) {
  const radii = spread(201).map((t) => STEM + t * (BAR - STEM));
  const places = radii.map((r) => {
    const x = Math.min(1, Math.max(0, (r - SPOON) / (BAR - SPOON)));
    return 1 - x * x * (3 - 2 * x);
  });
  const turned = alongRibbon(turns, passed, places);
  return turned.map((q, i) =>
    combine(1, HOME, 1, rotateByQuaternion(q, combine(width, U, radii[i], W))),
  );
}

/**
 * Where the middle of what moves is, for all values of `passed`. At the end the way goes on to the
 * bar: a path that ended where it begins would have no end.
 */
function wayOfRibbon(turns) {
  const most = passes(turns);
  const middle = (passed) => {
    const { length, staying } = movingArc(turns, passed);
    const s = staying ? length / (length + Math.PI * staying) / 2 : 0.5;
    // The inverse of the smooth step by which a shell's radius gives its place on the way.
    const x = 0.5 - Math.sin(Math.asin(2 * s - 1) / 3);
    const [q] = alongRibbon(turns, passed, [s]);
    return combine(1, HOME, SPOON + x * (BAR - SPOON), rotateByQuaternion(q, W));
  };
  return spread(97).map((t) => {
    const beyond = Math.max(2 * t - most, 0);
    const there = middle(Math.min(2 * t, most));
    return beyond ? combine(1 - beyond, there, beyond, MIDDLE_OF_BAR) : there;
  });
}

/** The way of the tip of the spoon, which opens a little: four turns have two ends. */
function onceForEachTurn(reach) {
  return spread(97).map((t) => {
    return combine(1, HOME, reach * (1 + 0.01 * t), rotate(U, W, 8 * Math.PI * t));
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

/**
 * Where the quaternion (side 1) or its opposite (side -1) of a turn about the W axis is on the
 * band; other sides are fractions of the way from the ring, which has radius 1, to q.
 */
function onBand(theta, side) {
  const [w, s] = [Math.cos(theta / 2), Math.sin(theta / 2)].map((x) => 0.33 * side * x);
  return [(1 + s) * Math.cos(theta), (1 + s) * Math.sin(theta), w];
}

/** Whether a turn, in degrees, ends where it began: after whole laps. */
const isBack = (angle, lap) => (Math.abs(angle) + BACK) % lap < 2 * BACK;
