/* While the hand holds something, that stands out, and what only helps and does not move steps back. */

export class Held {
  /** @param {import("./viewer.js").View} view */
  constructor(view) {
    this.view = view;
    /** @type {string[]} the parts that the hand holds, or could */
    this.names = [];
    /** @type {Record<string, string> | null} how what helps was when the hand first moved */
    this.before = null;
    this.moves = new Set();
  }

  /** Take hold of some parts, or of none. */
  take(names) {
    Object.assign(this, { names, before: null, moves: new Set() });
    this.view.light(names);
  }

  /** See what the hand moves. */
  follow(parts) {
    if (!this.names.length) return;
    const helping = this.view.stress.helping();
    const now = Object.fromEntries(helping.map((name) => [name, JSON.stringify(parts[name])]));
    this.before ??= now;
    for (const name of helping) if (now[name] !== this.before[name]) this.moves.add(name);
    const still = helping.filter((name) => !this.moves.has(name) && !this.names.includes(name));
    this.view.light(this.names, still);
  }
}
