/**
 * The mathematics of figures that answer the hand: functions of rotedu, their names in camelCase.
 *
 * Where rotedu scales vectors to length 1 and makes rotation matrices exact, so do the exports; they
 * refuse what has no answer, but not numbers that no control can give.
 *
 * @typedef {number[]} Vector of any number of dimensions
 * @typedef {number[]} Point u, v, w
 * @typedef {number[]} Quaternion w, x, y, z
 * @typedef {Vector[]} Matrix rows
 */

const ANTIPODAL = Math.sqrt(Number.EPSILON);
// What is taken for a rotation: no entry of M^T M differs from the identity's by more. So says
// rotedu/_arguments.py.
const ASKEW = 1e-3;
const ROUNDING = 4 * Number.EPSILON;

/** The error for a geometry without an answer: `rotedu.errors.DegenerateError`. */
export class DegenerateError extends Error {
  name = "DegenerateError";
}

// Any number of dimensions.

/** Dot product. */
export function dot(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i] * b[i];
  return sum;
}

/** Length of a vector. */
export const length = (v) => Math.sqrt(dot(v, v));

/** The sum s a + t b. */
export function combine(s, a, t, b) {
  const sum = [];
  for (let i = 0; i < a.length; i++) sum[i] = s * a[i] + t * b[i];
  return sum;
}

/** Scale a vector to length 1: `rotedu._arguments.unit_vectors`. */
export function unit(v) {
  const largest = v.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  if (!(largest > 0 && largest < Infinity)) {
    throw new RangeError("a direction needs finite numbers that are not all zero");
  }
  // The squares of the numbers themselves may overflow or underflow.
  const scaled = v.map((x) => x / largest);
  const size = length(scaled);
  return scaled.map((x) => x / size);
}

/** The angle between two vectors: `rotedu.arcs.angle_between`. */
export const angleBetween = (p, q) => theta(...units([p, q]));

/** A point of the shortest arc (5-2): `rotedu.arcs.slerp`. */
export const slerp = (p, q, t) => arc(...units([p, q]))(t);

/** A point of the chord, projected onto the sphere: `rotedu.arcs.nlerp`. */
export function nlerp(p, q, t) {
  [p, q] = units([p, q]);
  refuseAntipodal(theta(p, q), "p and q");
  return unit(combine(1 - t, p, t, q));
}

/** Reflect p in q (5-4): `rotedu.control_points.double`. */
export const double = (p, q) => reflected(...units([p, q]));

/** The midpoint of the shortest arc (5-7): `rotedu.control_points.bisect`. */
export function bisect(p, q) {
  [p, q] = units([p, q]);
  refuseAntipodal(theta(p, q), "p and q");
  return unit(combine(1, p, 1, q));
}

/** The control points after and before each point: `rotedu.control_points.control_points`. */
export function controlPoints(points, fraction = 1 / 2) {
  const p = units(points);
  const after = rolled(p, 1);
  const doubled = rolled(p, -1).map((before, i) => reflected(before, p[i]));
  refuseAntipodalAmong(doubled, after, "Double({h}, {i}) and {j}");
  const middle = doubled.map((q, i) => unit(combine(1, q, 1, after[i])));
  refuseAntipodalAmong(p, middle, "{i} and Bisect(Double({h}, {i}), {j})");
  const a = p.map((q, i) => arc(q, middle[i])(fraction));
  return { a, b: a.map((q, i) => reflected(q, p[i])) };
}

/** All points of de Casteljau's construction: `rotedu.closed_curve.de_casteljau_levels`. */
export const deCasteljauLevels = (control, u) => levelsFrom(units(control))(u);

/** Points of a Bezier curve on the sphere: `rotedu.closed_curve.de_casteljau`, for a list of u. */
export const deCasteljau = (control, places) => places.map(arcsOfArcs(units(control)));

/** Points of a closed curve, `samples` on each segment: `rotedu.closed_curve.closed_curve`. */
export function closedCurve(points, samples = 100, fraction = 1 / 2) {
  const { a, b } = controlPoints(points, fraction);
  const p = units(points);
  const nextB = rolled(b, 1);
  refuseAntipodalAmong(a, nextB, "control points a and b between {i} and {j}");
  return sampled(arcsOfArcs, [p, a, nextB, rolled(p, 1)], samples);
}

/** Points of Shoemake's closed curve, `samples` on each segment: `rotedu.orientation_curves.squad`. */
export function squad(quaternions, samples = 100) {
  const q = units(quaternions);
  const [before, after] = [rolled(q, -1), rolled(q, 1)];
  refuseAntipodalAmong(q, after, "{i} and {j}", "quaternions");
  const s = q.map((p, i) => {
    return onward(p, combine(-1 / 4, towards(p, after[i]), -1 / 4, towards(p, before[i])));
  });
  const nextS = rolled(s, 1);
  refuseAntipodalAmong(s, nextS, "points s of {i} and {j}", "quaternions");
  return sampled(arcTowardsArc, [q, s, nextS, after], samples);
}

/** Points of the closed cubic curve through values: `rotedu.orientation_curves.periodic_spline`. */
export function periodicSpline(values, samples = 100) {
  const after = rolled(values, 1);
  const right = rolled(values, -1).map((before, i) => combine(3, after[i], -3, before));
  // What is wrong with the rates is halved by each step.
  let rates = right;
  for (let step = 0; step < 60; step++) {
    rates = right.map((sum, i) => {
      const neighbours = combine(1, rates.at(i - 1), 1, rates[(i + 1) % rates.length]);
      return combine(1 / 4, sum, -1 / 4, neighbours);
    });
  }
  return sampled(cubic, [values, rates, rolled(rates, 1), after], samples);
}

// Three dimensions.

/** Cross product. @type {(a: Point, b: Point) => Point} */
export const cross = ([au, av, aw], [bu, bv, bw]) => [
  av * bw - aw * bv,
  aw * bu - au * bw,
  au * bv - av * bu,
];

/** The axis of the arc from p to q (5-1): `rotedu.arcs.arc_axis`. */
export function arcAxis(p, q) {
  [p, q] = units([p, q]);
  const chord = combine(1, q, -1, p);
  if (length(chord) <= ROUNDING) {
    throw new DegenerateError("p and q coincide: any axis would do");
  }
  refuseAntipodal(theta(p, q), "p and q");
  return unit(cross(combine(1, p, 1, q), chord));
}

/** The smallest rotation that takes a direction to another: `rotedu.arcs.rotation_between`. */
export function rotationBetween(a, b) {
  [a, b] = units([a, b]);
  refuseAntipodal(theta(a, b), "a and b");
  const chord = combine(1, b, -1, a);
  const sum = combine(1, a, 1, b);
  // As in an arc.
  const middle = combine(1, sum, -dot(sum, chord) / 4, chord);
  const v = scaled(1 / 2, cross(middle, chord));
  const [cos, share] = [1 - dot(chord, chord) / 2, 2 / dot(middle, middle)];
  const skew = [
    [cos, -v[2], v[1]],
    [v[2], cos, -v[0]],
    [-v[1], v[0], cos],
  ];
  return skew.map((row, i) => combine(1, row, share * v[i], v));
}

/** Rotate a point about an axis (3-1): `rotedu.ordinary_rotation.rotate`. */
export function rotate(point, axis, angle) {
  const n = unit(axis);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return combine(1, combine(cos, point, (1 - cos) * dot(point, n), n), sin, cross(n, point));
}

/** The matrix of a rotation about an axis (3-3): `rotedu.ordinary_rotation.rotation_matrix`. */
export function rotationMatrix(axis, angle) {
  const [nu, nv, nw] = unit(axis);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const k = 1 - cos;
  return [
    [cos + k * nu * nu, k * nu * nv - sin * nw, k * nu * nw + sin * nv],
    [k * nu * nv + sin * nw, cos + k * nv * nv, k * nv * nw - sin * nu],
    [k * nu * nw - sin * nv, k * nv * nw + sin * nu, cos + k * nw * nw],
  ];
}

/** Multiply a point by a matrix (3-2): `rotedu.ordinary_rotation.transform`. */
export const transform = (matrix, point) => matrix.map((row) => dot(row, point));

/** The axis and angle of a rotation matrix: `rotedu.ordinary_rotation.axis_angle`. */
export const axisAngle = (matrix) => turnOf(rotation(matrix));

/** The axis and angle of the turn from one orientation to another, both exact, as its body sees them. */
export const turnBetween = (r1, r2) => turnOf(product(transpose(r1), r2));

/** The axis and angle of an exact rotation matrix. */
function turnOf(matrix) {
  const products = sixteenProducts(matrix, 1);
  const squares = products.map((row, i) => row[i]);
  const [w, ...v] = products[squares.indexOf(Math.max(...squares))];
  const sine = length(v);
  const axis = sine ? v.map((x) => x / sine) : [1, 0, 0];

  // Of q and -q the one with w > 0; at a half turn, the one whose axis begins above zero.
  const halfTurn = Math.abs(w) <= ROUNDING * sine;
  const [sign] = halfTurn ? axis.filter((x) => Math.abs(x) > ROUNDING) : [w];
  return {
    axis: sign < 0 ? axis.map((x) => -x) : axis,
    angle: 2 * Math.atan2(sine, halfTurn ? 0 : Math.abs(w)),
  };
}

/** Multiply two 3x3 matrices: `rotedu._vectors.product`. */
export const product = (a, b) =>
  a.map(([u, v, w]) => combine(1, combine(u, b[0], v, b[1]), w, b[2]));

/** Exchange rows and columns: `rotedu._vectors.transpose`. */
export const transpose = (a) => a[0].map((_, j) => a.map((row) => row[j]));

/** An orientation on the shortest turn: `rotedu.orientations.slerp_rotations`. */
export function slerpRotations(r1, r2, t) {
  const start = rotation(r1);
  const { axis, angle } = turnBetween(start, rotation(r2));
  refuseTwoWays([angle], 64 * Number.EPSILON, "r1 and r2", "", "half a turn apart");
  return product(start, rotationMatrix(axis, t * angle));
}

/** Orientations of a closed curve: `rotedu.orientation_curves.closed_rotation_curve`. */
export function closedRotationCurve(rotations, samples = 100, fraction = 1 / 2) {
  const given = rotations.map(rotation);
  const turns = rolled(given, 1).map((after, i) => turnBetween(given[i], after));
  const angles = turns.map(({ angle }) => angle);
  refuseTwoWays(angles, 64 * Number.EPSILON, "{i} and {j}", "rotations", "half a turn apart");
  const toNext = turns.map(({ axis, angle }) => scaled(angle, axis));
  const toHere = rolled(toNext, -1);
  const fromDouble = toHere.map((turn, i) => oneTurn(scaled(-1, turn), toNext[i]));
  const halves = fromDouble.map((turn) => length(turn) / 2);
  const pair = "Double({h}, {i}) and {j}";
  refuseTwoWays(halves, ANTIPODAL, pair, "rotations", "a whole turn apart");
  const toA = toHere.map((turn, i) =>
    scaled(fraction, oneTurn(turn, scaled(1 / 2, fromDouble[i]))),
  );
  const fromNextB = rolled(toA, 1);
  const between = toA.map((turn, i) =>
    oneTurn(oneTurn(scaled(-1, turn), toNext[i]), scaled(-1, fromNextB[i])),
  );
  return sampled(follow, [given, toA, between, fromNextB], samples);
}

/** The rotation that differs least from a matrix: `rotedu.orientations.nearest_rotation`. */
export function nearestRotation(matrix) {
  // Its quaternion makes the sum of products with the entries, q^T K q, as large as it can be.
  const { values, vectors } = eigen(sixteenProducts(matrix, 0));
  const [, , second, largest] = [...values].sort((a, b) => a - b);
  // Twice the sum of the smaller singular values, and twice the largest.
  if (largest - second <= ANTIPODAL * (largest + second)) {
    throw new DegenerateError("matrix has several nearest rotations");
  }
  return quaternionMatrix(vectors[values.indexOf(largest)]);
}

/**
 * The singular values of a 3x3 matrix from the largest down, the last with the sign of the determinant. The
 * nearest rotation is unique if the two smaller ones do not add up to zero.
 */
export function singularValues(matrix) {
  const { values } = eigen(sixteenProducts(matrix, 0));
  // a + b + c, a - b - c, -a + b - c, -a - b + c
  const [first, second, third] = values.sort((x, y) => y - x);
  return [(first + second) / 2, (first + third) / 2, -(second + third) / 2];
}

/** Turns about U, V, W, as 3x3 matrix: `rotedu.general_rotation.matrix_from_euler_angles`. */
export function matrixFromEulerAngles(u, v, w) {
  const [cu, cv, cw] = [u, v, w].map(Math.cos);
  const [su, sv, sw] = [u, v, w].map(Math.sin);
  return [
    [cv * cw, su * sv * cw - cu * sw, cu * sv * cw + su * sw],
    [cv * sw, su * sv * sw + cu * cw, cu * sv * sw - su * cw],
    [-sv, su * cv, cu * cv],
  ];
}

/** The angles about U, V, W of a 3x3 matrix: `rotedu.general_rotation.euler_angles`. */
export function eulerAngles(matrix) {
  const [[m11, m12, m13], [m21, m22, m23], [m31]] = rotation(matrix);
  const cv = length([m11, m21]);
  const w = cv <= ROUNDING ? 0 : Math.atan2(m21, m11);
  const cw = Math.cos(w);
  const sw = Math.sin(w);
  const u = Math.atan2(sw * m13 - cw * m23, cw * m22 - sw * m12);
  return [u, Math.atan2(-m31, cv), w];
}

// Quaternions.

/** The unit quaternion of a rotation: `rotedu.quaternions.Quaternion.from_axis_angle`. */
export function quaternionFromAxisAngle(axis, angle) {
  const sin = Math.sin(angle / 2);
  return [Math.cos(angle / 2), ...unit(axis).map((x) => sin * x)];
}

/**
 * Hamilton's product (2-3): `p * q` of `rotedu.quaternions.Quaternion`.
 * @param {Quaternion} p
 * @param {Quaternion} q
 */
export function quaternionProduct([w1, ...v1], [w2, ...v2]) {
  const v = combine(1, combine(w1, v2, w2, v1), 1, cross(v1, v2));
  return [w1 * w2 - dot(v1, v2), ...v];
}

/**
 * The conjugate [w, -v]: `rotedu.quaternions.Quaternion.conjugate`.
 * @type {(q: Quaternion) => Quaternion}
 */
export const conjugate = ([w, x, y, z]) => [w, -x, -y, -z];

/** The matrix of the rotation: `rotedu.quaternions.Quaternion.matrix`. */
export function quaternionMatrix(q) {
  const [w, x, y, z] = unit(q);
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

/** The unit quaternion of a rotation matrix: `rotedu.quaternions.Quaternion.from_matrix`. */
export function quaternionFromMatrix(matrix) {
  const { axis, angle } = axisAngle(matrix);
  return quaternionFromAxisAngle(axis, angle);
}

/** Rotate a point by q [0, r] q* (2-6): `rotedu.quaternions.Quaternion.rotate`. */
export function rotateByQuaternion(q, point) {
  const [w, ...v] = unit(q);
  const twice = scaled(2, cross(v, point));
  return combine(1, combine(1, point, w, twice), 1, cross(v, twice));
}

// Rigid motions, of which the fourth row is left out.

/** Average poses entry by entry: `rotedu.rigid_motion.blend_matrices`. */
export function blendMatrices(poses, weights, repair = false) {
  const entries = poses.map((pose) => pose.flat());
  const mean = weighted(entries, shares(weights));
  const rows = [mean.slice(0, 4), mean.slice(4, 8), mean.slice(8, 12)];
  if (!repair) return rows;
  const turn = nearestRotation(rows.map((row) => row.slice(0, 3)));
  return rows.map((row, i) => [...turn[i], row[3]]);
}

/** Average poses as dual quaternions: `rotedu.rigid_motion.blend_dual_quaternions`. */
export function blendDualQuaternions(poses, weights) {
  const real = poses.map((pose) => quaternionFromMatrix(pose.map((row) => row.slice(0, 3))));
  const dual = poses.map((pose, i) =>
    scaled(1 / 2, quaternionProduct([0, ...pose.map((row) => row[3])], real[i])),
  );
  const leader = real[weights.indexOf(Math.max(...weights))];
  const agreement = real.map((q) => dot(q, leader));
  const apart = agreement.findIndex(
    (cos, i) => weights[i] > 0 && Math.abs(cos) <= 32 * Number.EPSILON,
  );
  if (apart >= 0) {
    const those = `matrices at index (${apart},) are half a turn from those of the largest weight`;
    throw new DegenerateError(`${those}: no unique sign`);
  }
  const signed = shares(weights).map((share, i) => (agreement[i] < 0 ? -share : share));
  const [q, d] = [real, dual].map((part) => weighted(part, signed));
  const step = scaled(2 / dot(q, q), quaternionProduct(d, conjugate(q)).slice(1));
  return quaternionMatrix(q).map((row, i) => [...row, step[i]]);
}

// What the exports share. Their points are of length 1 already.

const theta = (p, q) => 2 * Math.atan2(length(combine(1, q, -1, p)), length(combine(1, p, 1, q)));

/** An arc: its point at t. Where there is none, `pair` and j name the ends. */
function arc(p, q, pair = (_j) => "p and q", j = 0) {
  const chord = combine(1, q, -1, p);
  const sum = combine(1, p, 1, q);
  // Near pi rounding tilts the short middle; put it back at a right angle.
  const middle = combine(1, sum, -dot(sum, chord) / 4, chord);
  const across = length(chord);
  const along = length(middle);
  const half = Math.atan2(across, along);
  if (2 * half >= Math.PI - ANTIPODAL) throw noArc(pair(j), "antipodal");
  return (t) => {
    const h = Math.tan((t - 1 / 2) * half);
    const cos = (1 - h * h) / (1 + h * h);
    const sin = (2 * h) / (1 + h * h);
    return combine(cos / along, middle, sin / (across || 1), chord);
  };
}

const reflected = (p, q) => combine(2 * dot(p, q), q, -1, p);

const scaled = (factor, v) => v.map((x) => factor * x);

/** Scale weights to the sum 1. */
const shares = (weights) => scaled(1 / weights.reduce((sum, x) => sum + x, 0), weights);

const weighted = (vectors, weights) =>
  vectors.reduce((sum, v, i) => combine(1, sum, weights[i], v), scaled(0, vectors[0]));

/** The arcs from each point of a level to the next. */
function arcsOf(points, level) {
  const name = level ? `points of level ${level}` : "control";
  const pair = (j) => `${name}[${j}] and ${name}[${j + 1}]`;
  return points.slice(1).map((q, j) => arc(points[j], q, pair, j));
}

/** All levels of de Casteljau's construction at u; the arcs between the given points stay. */
function levelsFrom(points) {
  const given = arcsOf(points, 0);
  return (u) => {
    const levels = [points];
    for (let arcs = given; arcs.length; arcs = arcsOf(levels.at(-1), levels.length - 1)) {
      levels.push(arcs.map((at) => at(u)));
    }
    return levels;
  };
}

function arcsOfArcs(points) {
  const levels = levelsFrom(points);
  return (u) => levels(u).at(-1)[0];
}

/** Evaluate the segments of a closed curve, given their parts: `rotedu.closed_curve.sampled`. */
function sampled(curve, parts, samples) {
  return parts[0].flatMap((_, i) => {
    const at = curve(parts.map((part) => part[i]));
    return Array.from({ length: samples }, (_, k) => at(k / samples));
  });
}

/** @param {Quaternion[]} points */
function arcTowardsArc([q, s, nextS, nextQ]) {
  const [along, aims] = [arc(q, nextQ), arc(s, nextS)];
  const pair = () => "points of the arcs from q and s";
  return (u) => arc(along(u), aims(u), pair)(2 * u * (1 - u));
}

/** @param {Vector[]} ends @returns {(u: number) => Vector} */
const cubic =
  ([value, rate, nextRate, nextValue]) =>
  (u) => {
    const begin = combine((1 - u) ** 2 * (1 + 2 * u), value, (1 - u) ** 2 * u, rate);
    const end = combine(u ** 2 * (3 - 2 * u), nextValue, -(u ** 2) * (1 - u), nextRate);
    return combine(1, begin, 1, end);
  };

const follow =
  ([start, ...turns]) =>
  (u) => {
    let route = turns;
    let turn = scaled(u, route[0]);
    while (route.length > 1) {
      route = route.slice(1).map((w, i) => oneTurn(scaled(1 - u, route[i]), scaled(u, w)));
      turn = oneTurn(turn, scaled(u, route[0]));
    }
    const angle = length(turn);
    return angle ? product(start, rotationMatrix(turn, angle)) : start;
  };

/** One turn in place of two: `rotedu.orientation_curves.one_turn`. */
function oneTurn(v, w) {
  const [a, b] = [length(v) / 2, length(w) / 2];
  const [cosA, cosB] = [Math.cos(a), Math.cos(b)];
  // Of v and w, what makes them as long as the sines.
  const [s, t] = [Math.sin(a) / (2 * a || 1), Math.sin(b) / (2 * b || 1)];
  const cos = cosA * cosB - s * t * dot(v, w);
  const axis = combine(1, combine(s * cosB, v, cosA * t, w), s * t, cross(v, w));
  const sin = length(axis);
  return scaled((2 * Math.atan2(sin, cos)) / (sin || 1), axis);
}

/** The tangent vector at p, as long as the arc, that leads to q. */
function towards(p, q) {
  const tangent = combine(1, q, -dot(p, q), p);
  return scaled(theta(p, q) / (length(tangent) || 1), tangent);
}

/** Go from p along the arc that begins with a tangent vector, as far as it is long. */
function onward(p, tangent) {
  const size = length(tangent);
  return combine(Math.cos(size), p, Math.sin(size) / (size || 1), tangent);
}

/**
 * Shepperd's table, 4 q_i q_j of a rotation matrix, if the squares get 1.
 * @type {(matrix: Matrix, one: number) => Matrix}
 */
const sixteenProducts = ([[uu, uv, uw], [vu, vv, vw], [wu, wv, ww]], one) => [
  [one + uu + vv + ww, wv - vw, uw - wu, vu - uv],
  [wv - vw, one + uu - vv - ww, uv + vu, uw + wu],
  [uw - wu, uv + vu, one - uu + vv - ww, vw + wv],
  [vu - uv, uw + wu, vw + wv, one - uu - vv + ww],
];

/** Eigenvalues of a symmetric matrix, and its eigenvectors as rows: Jacobi's method. */
function eigen(matrix) {
  const a = matrix.map((row) => [...row]);
  const vectors = a.map((row, i) => row.map((_, j) => Number(i === j)));
  const negligible = 4 * Number.EPSILON * Math.max(...matrix.flat().map(Math.abs));
  // Each sweep squares what is left beside the diagonal.
  for (let sweep = 0, left = true; left && sweep < 10; sweep++) {
    left = false;
    for (let i = 0; i < a.length; i++) {
      for (let j = i + 1; j < a.length; j++) {
        if (Math.abs(a[i][j]) <= negligible) continue;
        annul(a, vectors, i, j);
        left = true;
      }
    }
  }
  return { values: a.map((row, i) => row[i]), vectors };
}

/** Turn the i-th and j-th axis until the entry a_ij of a symmetric matrix is zero. */
function annul(a, vectors, i, j) {
  const cot = (a[j][j] - a[i][i]) / (2 * a[i][j]);
  const tan = (cot < 0 ? -1 : 1) / (Math.abs(cot) + Math.sqrt(1 + cot * cot));
  const cos = 1 / Math.sqrt(1 + tan * tan);
  const sin = tan * cos;
  for (const rows of [vectors, a]) {
    const [row, other] = [rows[i], rows[j]];
    rows[i] = combine(cos, row, -sin, other);
    rows[j] = combine(sin, row, cos, other);
  }
  for (const row of a) {
    const [x, y] = [row[i], row[j]];
    row[i] = cos * x - sin * y;
    row[j] = sin * x + cos * y;
  }
}

function refuseAntipodal(angle, pair) {
  refuseTwoWays([angle], ANTIPODAL, pair, "", "antipodal");
}

/** Compare p[i] with q[i] for all i: `refuseTwoWays`. */
function refuseAntipodalAmong(p, q, pair, sequence = "points") {
  const angles = p.map((point, i) => theta(point, q[i]));
  refuseTwoWays(angles, ANTIPODAL, pair, sequence, "antipodal");
}

/** Refuse an angle of pi; {h}, {i} and {j} in `pair` stand for three neighbours. */
function refuseTwoWays(angles, tolerance, pair, sequence, apart) {
  const i = angles.findIndex((angle) => angle >= Math.PI - tolerance);
  if (i < 0) return;
  const n = angles.length;
  const places = { h: (i + n - 1) % n, i, j: (i + 1) % n };
  const names = pair.replace(/{(.)}/g, (_, place) => `${sequence}[${places[place]}]`);
  throw noArc(names, apart);
}

const noArc = (names, apart) =>
  new DegenerateError(`${names} are ${apart}: no unique arc joins them`);

/** Start a closed sequence later, or earlier by a negative number. */
const rolled = (points, by) => points.map((_, i) => points.at((i + by) % points.length));

const units = (points) => points.map(unit);

/** Replace a matrix that is a rotation to four decimals with the nearest rotation. */
function rotation(matrix) {
  const squares = product(transpose(matrix), matrix);
  const errors = squares.flatMap((row, i) => row.map((x, j) => Math.abs(x - Number(i === j))));
  const off = Math.max(...errors);
  const [u, v, w] = matrix;
  if (!(off <= ASKEW && dot(cross(u, v), w) > 0)) {
    throw new RangeError("the matrix is not a rotation");
  }
  const nearest = straightened(matrix, squares);
  // One step is enough for half of the digits, and three are for what is coarser.
  return off <= 2 * ANTIPODAL ? nearest : straightened(straightened(nearest));
}

/** Take a step of Newton's method for the polar decomposition: right digits double. */
function straightened(matrix, squares = product(transpose(matrix), matrix)) {
  return product(matrix, squares).map((row, i) => combine(3 / 2, matrix[i], -1 / 2, row));
}
