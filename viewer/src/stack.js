/* On a phone, parts of a wide picture stand one above the other. */

/** A picture that is one part, and all of it. */
export const WHOLE = [{ from: [0, 0, 1, 1], to: [0, 0, 1, 1] }];

/**
 * Say which part of a picture goes where in a box.
 * @param {{from: number[], to: number[]}[]} [rows] the parts of the picture and their places in the stack,
 *   by left, top, width and height, as shares of its size
 * @param {number} aspect width over height of the stack, which is shown as a whole
 * @param {{width: number, height: number}} box only one that is higher than wide has a stack
 * @returns rows as shares of the box
 */
export function stacked(rows, aspect, { width, height }) {
  if (!rows || height <= width) return WHOLE;
  const size = [Math.min(1, (aspect * height) / width), Math.min(1, width / aspect / height)];
  return rows.map(({ from, to }) => ({
    from,
    to: to.map((x, i) => x * size[i % 2] + (i < 2 ? (1 - size[i]) / 2 : 0)),
  }));
}

/** The row in which a place of the picture is, or the next one to its side. */
export function rowOf(rows, { left }) {
  const beyond = ({ from: [x, , width] }) => Math.max(x - left, left - x - width);
  return rows.reduce((best, row) => (beyond(row) < beyond(best) ? row : best));
}

/** From where to where a row shows its part, as shares of its width: half of what another shows, too. */
export function extent(rows, { from: [x, , width] }) {
  const [low, high] = [x, x + width];
  const others = rows.map(({ from: [left, , across] }) => [left, left + across]);
  const first = Math.max(low, ...others.filter(([left]) => left < low).map(([, right]) => (low + right) / 2));
  const last = Math.min(high, ...others.filter(([left]) => left > low).map(([left]) => (high + left) / 2));
  return [(first - low) / width, (last - low) / width];
}

/** Where a place of the picture is in the box, and whether its row shows it. */
export function toBox(rows, { left, top, inside }) {
  const { from, to } = rowOf(rows, { left });
  const [x, y] = [left, top].map((value, i) => (value - from[i]) / from[i + 2]);
  const shown = inside && Math.max(Math.abs(x - 0.5), Math.abs(y - 0.5)) <= 0.5;
  return { left: to[0] + x * to[2], top: to[1] + y * to[3], inside: shown };
}

/** The place in the picture of a place in the box, as if its row went on beyond its border. */
export function toPicture({ from, to }, left, top) {
  return [left, top].map((value, i) => from[i] + ((value - to[i]) / to[i + 2]) * from[i + 2]);
}
