/* Model of `rotedu.scenes.conclusions`. */
import { CUBE, DEGREES, ORIGIN } from "./parts.js";
import {
  axisAngle,
  combine,
  conjugate,
  length,
  nearestRotation,
  product,
  quaternionMatrix,
  quaternionProduct,
  transform,
  transpose,
  unit,
} from "./rotations.js";

const MOST = 1000;
const SIZES = { "any size": 0, "about 2°": 0.02, "about 0.02°": 0.0002 };
const EVERY = 10;
const FLOOR = 1e-8;
const ACROSS = [0.93, 0.36, 0].map((x) => 0.88 * x);
const IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const ROUNDED = {
  // Ties, which Python rounds to even, do not occur.
  "2 decimals": (x) => Math.round(100 * x) / 100,
  "3 decimals": (x) => Math.round(1000 * x) / 1000,
  "16 bits": to16Bits,
  "32 bits": Math.fround,
};
const known = new Map();

/** A number with the eleven significant bits of 16-bit numbers, fewer near zero. */
function to16Bits(x) {
  const [, high] = new Uint32Array(new Float64Array([x]).buffer);
  const exponent = ((high >>> 20) & 2047) - 1023;
  const step = 2 ** (Math.max(exponent, -14) - 10);
  return Math.round(x / step) * step;
}

/** Unit quaternions, of any size or near 1: `random_turns`. */
function* randomTurns(size) {
  const small = SIZES[size];
  let seed = 3;
  const thrown = () => {
    seed = (Math.imul(1664525, seed) + 1013904223) >>> 0;
    return seed / 2 ** 31 - 1;
  };
  for (let found = 0; found < MOST; ) {
    const [w, ...v] = [0, 0, 0, 0].map(thrown);
    const square = length([w, ...v]) ** 2;
    if (square <= 0.01 || square > 1) continue;
    found++;
    yield unit(small ? [1, ...v.map((x) => small * x)] : [w, ...v]);
  }
}

/** Products, rounded after every turn, and one turn more back to the start: `chains`. */
function chains(precision, size) {
  const name = `${precision} ${size}`;
  if (!known.has(name)) {
    const round = ROUNDED[precision];
    const rounded = (rows) => rows.map((row) => row.map(round));
    let exact = [1, 0, 0, 0];
    let matrix = IDENTITY;
    let kept = exact;
    const worn = { matrix: [], quaternion: [] };
    for (const turn of [...randomTurns(size), exact]) {
      const back = conjugate(exact);
      worn.matrix.push(rounded(product(quaternionMatrix(back), matrix)));
      worn.quaternion.push(quaternionProduct(back, kept).map(round));
      exact = quaternionProduct(turn, exact);
      matrix = rounded(product(quaternionMatrix(turn), matrix));
      kept = quaternionProduct(turn, kept).map(round);
    }
    const near = (k) => [nearestRotation(worn.matrix[k]), quaternionMatrix(worn.quaternion[k])];
    const off = (k) => near(k).map((rotation) => DEGREES * axisAngle(rotation).angle);
    // Only repaired products have curves.
    let sampled;
    const curves = () =>
      (sampled ??= transpose(worn.matrix.flatMap((_, k) => (k % EVERY ? [] : [off(k)]))));
    known.set(name, { ...worn, near, off, curves });
  }
  return known.get(name);
}

/** A number with two digits, however small it is: `two_digits`. */
function twoDigits(value) {
  return value.toFixed(value > FLOOR ? Math.max(0, 1 - Math.floor(Math.log10(value))) : 0);
}

/** `worn_spoons_by_hand` */
export function wornSpoons({ turns, precision, size, repair }, { degree, in_length }) {
  const worn = chains(precision, size);
  const k = Math.round(turns);
  const q = worn.quaternion[k];
  const square = length(q) ** 2;
  const unrepaired = [worn.matrix[k], quaternionMatrix(q).map((row) => row.map((x) => square * x))];
  const rotations = repair ? worn.near(k) : unrepaired;
  const off = worn.off(k);
  const frame = { parts: {}, labels: {}, outputs: {}, charts: { off: {} } };
  ["matrix", "quaternion"].forEach((name, i) => {
    const rotation = rotations[i];
    const place = combine(i ? 1 : -1, ACROSS, 0, ORIGIN);
    const columns = transpose(rotation);
    frame.parts[name] = { matrix: [...columns.flatMap((column) => [...column, 0]), ...place, 1] };
    const moved = (point) => combine(1, place, 1, transform(rotation, point));
    frame.parts[`box, ${name}`] = { paths: CUBE.map((edge) => edge.map(moved)) };
    const edges = columns.map(length);
    const bent = Math.max(...edges.map((x) => Math.abs(x - 1)));
    frame.outputs[`${name}_off`] = repair ? twoDigits(off[i]) + degree : twoDigits(100 * bent) + in_length;
    frame.outputs[`${name}_edges`] = edges;
    const heights = (angles) => angles.map((angle) => Math.log10(Math.max(angle, FLOOR)));
    frame.charts.off[name] = repair ? heights(worn.curves()[i]) : null;
  });
  return frame;
}
