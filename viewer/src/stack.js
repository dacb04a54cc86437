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
  return rows.map(({ from, to }) =>
    wide(
      from,
      to.map((x, i) => x * size[i % 2] + (i < 2 ? (1 - size[i]) / 2 : 0)),
    ),
  );
}

/** A row from side to side of its box, so that what turns is not cut off where there is room. */
function wide([left, above, across, down], [x, y, width, height]) {
  return {
    from: [left - (x * across) / width, above, across / width, down],
    to: [0, y, 1, height],
  };
}

/** Which row shows what is at a place of the picture at rest: that in which it is, or the next one to its side. */
export function rowOf(rows, { left }) {
  const beyond = rows.map(({ from: [x, , width] }) => Math.max(x - left, left - x - width));
  return beyond.indexOf(Math.min(...beyond));
}

/** Where a place of the picture is in the box, and whether its row shows it. */
export function toBox({ from, to }, { left, top, inside }) {
  const [x, y] = [left, top].map((value, i) => (value - from[i]) / from[i + 2]);
  const shown = inside && Math.max(Math.abs(x - 0.5), Math.abs(y - 0.5)) <= 0.5;
  return { left: to[0] + x * to[2], top: to[1] + y * to[3], inside: shown };
}

/** The place in the picture of a place in the box, as if its row went on beyond its border. */
export function toPicture({ from, to }, left, top) {
  return [left, top].map((value, i) => from[i] + ((value - to[i]) / to[i + 2]) * from[i + 2]);
}
