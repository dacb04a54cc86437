/* On a phone, parts of a wide picture stand one above the other. */
import { lens } from "./aim.js";
import { project } from "./labels.js";

/** @import { Place, Row } from "./types.js" */

/** @type {Row[]} a picture that is one part, and all of it */
export const WHOLE = [{ from: [0, 0, 1, 1], to: [0, 0, 1, 1] }];

/** The rows in which a scene is shown, wherever the camera has gone. */
export class Rows {
  /**
   * @param {{rows?: Row[], aspect?: number}} stack
   * @param {import("./aim.js").Aim} aim
   */
  constructor({ rows, aspect = 1 }, aim) {
    this.aim = aim;
    this.stack = rows;
    this.aspect = aspect;
    this.middles = rows?.map(({ from }) => aim.middleOf(from)) ?? [];
    this.fixed = WHOLE;
    this.now = WHOLE;
  }

  /** Choose the rows for a box. */
  fit(box) {
    this.fixed = stacked(this.stack, this.aspect, box);
  }

  /** A stack consists of parts of the picture as it was made. */
  get isWhole() {
    return this.fixed === WHOLE;
  }

  /** Let each row show what it showed at rest, in its middle and as large. */
  follow() {
    const { aim, middles } = this;
    const followed = ({ from, to }, i) => {
      const { left, top } = project(lens(aim.camera), middles[i]);
      const scale = aim.depth(aim.pose.target) / aim.depth(middles[i]);
      const [width, height] = [from[2] * scale, from[3] * scale];
      return { from: [left - width / 2, top - height / 2, width, height], to };
    };
    this.now = this.isWhole ? WHOLE : this.fixed.map(followed);
  }

  /** The number of the row that shows what is near a point. */
  at(point) {
    return this.stack && !this.isWhole ? rowOf(this.stack, project(this.aim.lensAtRest, point)) : 0;
  }

  /** The row that shows what is near a point, as it is now. */
  near(point) {
    return this.now[this.at(point)];
  }

  /** Where a point is in the box, in the row that shows what is near another one. */
  project(point, other = point) {
    return toBox(this.near(other), project(lens(this.aim.camera), point));
  }

  /** The line of sight through a place of the box, where it shows what is near a point. */
  sight(left, top, other) {
    const [x, y] = toPicture(this.near(other), left, top);
    return { eye: this.aim.eye(), direction: this.aim.through(x, y) };
  }
}

/**
 * Say which part of a picture goes where in a box.
 * @param {Row[] | undefined} rows the parts of the picture and their places in the stack
 * @param {number} aspect width over height of the stack, which is shown as a whole
 * @param {{width: number, height: number}} box only one that is higher than wide has a stack
 */
export function stacked(rows, aspect, { width, height }) {
  if (!rows || height <= width) return WHOLE;
  const across = Math.min(1, (aspect * height) / width);
  const down = Math.min(1, width / aspect / height);
  return rows.map(({ from, to: [x, y, width, height] }) => {
    const [left, top] = [x * across + (1 - across) / 2, y * down + (1 - down) / 2];
    return fromSideToSide(from, [left, top, width * across, height * down]);
  });
}

/**
 * A row that is as wide as its box, so that what turns is not cut off where there is room.
 * @returns {Row}
 */
function fromSideToSide(from, to) {
  const [left, above, across, down] = from;
  const [x, y, width, height] = to;
  const shown = [left - (x * across) / width, above, across / width, down];
  return { from: shown, to: [0, y, 1, height] };
}

/** Which row shows what is at a place of the picture at rest: that in which it is, or the next to its side. */
export function rowOf(rows, { left }) {
  const beyond = rows.map(({ from: [x, , width] }) => Math.max(x - left, left - x - width));
  return beyond.indexOf(Math.min(...beyond));
}

/**
 * Where a place of the picture is in the box, and whether its row shows it.
 * @returns {Place}
 */
export function toBox({ from, to }, { left, top, inside }) {
  const [x, y] = [left, top].map((value, i) => (value - from[i]) / from[i + 2]);
  const shown = inside && Math.max(Math.abs(x - 0.5), Math.abs(y - 0.5)) <= 0.5;
  return { left: to[0] + x * to[2], top: to[1] + y * to[3], inside: shown };
}

/** The place in the picture of a place in the box, as if its row went on beyond its border. */
export function toPicture({ from, to }, left, top) {
  return [left, top].map((value, i) => from[i] + ((value - to[i]) / to[i + 2]) * from[i + 2]);
}
