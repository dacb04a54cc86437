/* Models of `rotedu.scenes.quaternions`. */
import { DEGREES, ORIGIN, columns, spread, turning } from "./parts.js";
import { combine, quaternionProduct, rotate, rotationMatrix, transpose } from "./sphere.js";

const W = [0, 0, 1];
const SMALLEST_ARC = 8;
const BACK = 0.5;

/** A point off the axis. */
const out = (angle, radius = 1) => rotate([radius, 0, 0], W, angle / DEGREES);

/** `two_mirrors_by_hand` */
export function twoMirrors({ first, second, both, letter }, { lamp }) {
  const between = second - first;
  const angles = [first + both, second + both];
  const m = angles.map((angle) => [0, ...out(angle + 90)]);
  const mirrored = (images, k) =>
    images.map((v) => quaternionProduct(quaternionProduct(m[k], [0, ...v]), m[k]).slice(1));
  const start = transpose(rotationMatrix(W, letter / DEGREES));
  const once = mirrored(start, 0);
  const twice = mirrored(once, 1);

  const parts = {
    letter: { matrix: columns(start) },
    image: { matrix: columns(once) },
    "image of the image": { matrix: columns(twice) },
  };
  const labels = {};
  angles.forEach((angle, k) => {
    const name = k + 1;
    const size = [1.4, 1.65][k];
    const foot = out(angle, size);
    const top = [0, 0, 0.3];
    const corner = combine(1, foot, 1, top);
    const edge = [ORIGIN, foot, corner, top];
    const [, ...normal] = m[k];
    parts[`mirror ${name}`] = { points: edge };
    parts[`edge ${name}`] = { paths: [[out(angle, -size), ...edge]] };
    parts[`m ${name}`] = { from: corner, to: combine(1, corner, 0.3, normal) };
    labels[`m ${name}`] = combine(1, corner, 0.42, normal);
  });
  for (const [name, begin, angle, radius] of [
    ["half", angles[0], between, 0.45],
    ["whole", letter, 2 * between, 1.5],
  ]) {
    const drawn = Math.abs(angle) >= SMALLEST_ARC;
    const arc = drawn && spread(61).map((t) => out(begin + t * angle, radius));
    const ahead = out(begin + angle + 90);
    parts[name] = drawn ? { paths: [arc], hidden: false } : { hidden: true };
    parts[`${name}, head`] = drawn
      ? {
          from: combine(1, arc.at(-1), -0.1 * Math.sign(angle), ahead),
          to: arc.at(-1),
          hidden: false,
        }
      : { hidden: true };
    labels[name] = drawn ? out(begin + angle / 2, radius + 0.16) : null;
  }

  return {
    parts,
    labels,
    grips: { letter: { path: turning(out(-180, 1.05), W, 2 * Math.PI, 48) } },
    outputs: {
      between,
      turned: 2 * between,
      home: lamp[Number((Math.abs(2 * between) + BACK) % 360 < 2 * BACK)],
      q: quaternionProduct(m[1], m[0]).map((x) => -x),
    },
  };
}
