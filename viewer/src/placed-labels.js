/* The labels over a picture: read from the page, and put where their points are seen. */
import { lens } from "./aim.js";
import { all } from "./elements.js";
import { apart, isHidden, project } from "./labels.js";
import { toBox, WHOLE } from "./stack.js";

// Between labels side by side, in pixels, so that two names are not one.
const GAP = 5;
// What is empty below a paragraph. Into the rest of what is empty in a picture its text reaches.
const BELOW_TEXT = 12;

export class Labels {
  /** @param {HTMLElement} box the picture */
  constructor(box) {
    this.box = box;
    // One that is absent for now has no position.
    this.entries = all(box, ".scene-label").map((label) => ({
      label,
      name: label.dataset.label,
      position: label.dataset.position ? label.dataset.position.split(" ").map(Number) : null,
      width: 0,
      height: 0,
    }));
    this.size = [0, 0];
    this.above = 0;
  }

  /** Read how large all are: seldom, because the browser has to lay out the page. */
  measure() {
    this.size = [this.box.clientWidth, this.box.clientHeight];
    const pulled = -Number.parseFloat(getComputedStyle(this.box).marginTop) || 0;
    this.above = Math.max(0, pulled - BELOW_TEXT);
    for (const entry of this.entries) {
      entry.width = entry.label.offsetWidth + GAP;
      entry.height = entry.label.offsetHeight;
    }
  }

  /**
   * @param {import("three").PerspectiveCamera} camera
   * @param {import("./types.js").Surface[]} surfaces that hide labels
   * @param {(point: number[]) => import("./types.js").Row} [rowFor] the row that shows a point
   */
  place(camera, surfaces, rowFor = () => WHOLE[0]) {
    const matrix = lens(camera);
    const eye = camera.position.toArray();
    const [across, down] = this.size;
    const seen = [];
    for (const { label, position, width, height } of this.entries) {
      const place = position && toBox(rowFor(position), project(matrix, position));
      const hidden = !place?.inside || isHidden(surfaces, eye, position);
      label.toggleAttribute("data-behind", hidden);
      if (!place) continue;
      label.style.setProperty("--at", `${100 * place.top}% auto auto ${100 * place.left}%`);
      if (hidden) continue;
      const at = place.top * down;
      const y = Math.max(this.above + height / 2, Math.min(down - height / 2, at));
      seen.push({ label, x: place.left * across, y, at, width, height });
    }
    apart(seen).forEach((moved, i) => {
      const { label, y, at } = seen[i];
      label.style.setProperty("--aside", `${moved.x}px ${y + moved.y - at}px`);
    });
  }
}
