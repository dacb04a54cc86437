/* The model of `rotedu.scenes.camera_by_hand`. */
import {
  arcAxis,
  bisect,
  closedCurve,
  combine,
  controlPoints,
  cross,
  deCasteljau,
  dot,
  double,
  length,
  unit,
} from "../src/sphere.js";
import { DEGREES, ORIGIN, motion } from "./common.js";

const SEEN = ["door", "clock", "window", "desk"];
const LEG = 24;
const [WIDTH, HEIGHT] = [0.21, 0.14];
const SMALL = 1e-4;
const ANGLE = 60;

/** `camera_by_hand` */
export function camera({ targets, path, roll, ride, u }) {
  const p = targets.map(unit);
  const after = p.map((_, i) => p[(i + 1) % p.length]);
  const { a, b } = controlPoints(p);
  const arcs = p.map((point, i) => [point, after[i]]);
  const curves = p.map((point, i) => [point, a[i], b[(i + 1) % p.length], after[i]]);
  const t = Array.from({ length: LEG }, (_, i) => i / LEG);
  const ways = {
    arcs: arcs.flatMap((leg) => t.map((x) => deCasteljau(leg, x))),
    curve: closedCurve(p, LEG),
  };
  const legs = path === "arcs" ? arcs : curves;
  const leg = Math.min(Math.floor(4 * u), 3);
  const within = 4 * u - leg;
  const ahead = deCasteljau(legs[leg], within);
  const vertical = upright(ahead);
  let up = vertical;
  if (roll === "carried") {
    const passed = Math.min(Math.floor(4 * LEG * u), 4 * LEG - 1) + 1;
    up = carried(upright(p[0]), [...ways[path].slice(0, passed), ahead]);
  }

  const corners = picture(ahead, up);
  const level = picture(ahead, vertical);
  const top = combine(1, ahead, HEIGHT, up);
  const parts = {
    arcs: { paths: [[...ways.arcs, p[0]]], hidden: ride && path !== "arcs" },
    curve: { paths: [[...ways.curve, p[0]]], hidden: ride && path !== "curve" },
    camera: { matrix: [...ahead, 0, ...cross(up, ahead), 0, ...up, 0, ...ORIGIN, 1], hidden: ride },
    upright: { paths: [[...level, level[0]]], hidden: ride },
    picture: { paths: [[...corners, corners[0]]], hidden: ride },
    edges: { paths: corners.map((corner) => [ORIGIN, corner]), hidden: ride },
    up: { from: top, to: combine(1, top, 0.28, up), hidden: ride },
  };
  const labels = { up: ride ? null : combine(1, top, 0.36, up) };
  const middle = p.reduce((sum, q) => combine(1, sum, 1 / p.length, q), ORIGIN);
  SEEN.forEach((name, i) => {
    parts[name] = { at: p[i] };
    labels[name] = outside(p[i], middle);
  });

  const arriving = legs.map((four) => motion(four, 1).velocity);
  const leaving = legs.map((four) => motion(four, 0).velocity);
  const bends = leaving.map((v, i) => angle(arriving.at(i - 1), v));
  return {
    parts,
    labels,
    outputs: {
      rolled: DEGREES * Math.atan2(dot(cross(vertical, up), ahead), dot(vertical, up)),
      speed: DEGREES * length(motion(legs[leg], within).velocity),
      bends: bends.map((bend) => DEGREES * bend),
    },
    view: ride ? { eye: ORIGIN, target: ahead, up, angle: ANGLE } : null,
  };
}

/** The upward direction of the picture of an upright camera. */
const upright = (ahead) => cross(ahead, arcAxis([0, 0, 1], ahead));

/** Carry a direction along a path on the sphere: two half turns make up the rotation of an arc. */
function carried(up, way) {
  return way.slice(1).reduce((v, q, i) => double(double(v, way[i]), bisect(way[i], q)), up);
}

/** The corners of what a camera sees, where it meets the unit sphere. */
function picture(ahead, up) {
  const left = cross(up, ahead);
  const signs = [[1, 1], [1, -1], [-1, -1], [-1, 1]];
  return signs.map(([x, y]) =>
    combine(1, ahead, 1, combine(x * WIDTH, left, y * HEIGHT, up)),
  );
}

/** The angle between two velocities; one that is zero makes none. */
const angle = (v, w) => Math.atan2(length(cross(v, w)), dot(v, w));

/** The place of a label: near the sphere, away from the middle of the targets and to one side. */
function outside(point, middle) {
  const chord = combine(1, point, -1, middle);
  const tangent = combine(1, chord, -dot(chord, point), point);
  const away = tangent.map((x) => x / Math.max(length(tangent), SMALL));
  return combine(1.1, point, 0.16, combine(1, away, 1, cross(point, away)));
}
