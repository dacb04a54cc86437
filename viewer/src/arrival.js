/* How a reader comes to a figure: by a link to one of its states, or by a drag that began too early. */

const HANDS = ["pointerdown", "touchstart", "wheel", "keydown"];
const LET_GO = ["pointerup", "pointercancel", "scroll"];

/** The figure that an address such as #explore-slerp-by-hand?t=0.5 speaks of. */
export function spokenOf(hash) {
  const [whose, state] = hash.slice(1).split("?");
  const figure = state === undefined ? null : document.getElementById(whose);
  return figure?.matches(".explorable") ? figure : null;
}

/** Tell whether the middle of a scene is on the screen. */
export function isInSight(scene) {
  const { top, bottom } = scene.getBoundingClientRect();
  return top + bottom > 0 && top + bottom < 2 * innerHeight;
}

/** Go to a figure, and stay until the reader moves, since fonts and pictures that come late move it. */
export function goTo(figure) {
  // Smooth scrolling would end where the figure was at first.
  const observer = new ResizeObserver(() => figure.scrollIntoView({ behavior: "instant" }));
  // What comes above the figure makes something that holds both higher.
  for (let around = figure; around; around = around.parentElement) observer.observe(around);
  const stop = () => observer.disconnect();
  for (const hand of HANDS) addEventListener(hand, stop, { once: true, passive: true });
}

/** Tell whether the reader has come anew; else the browser goes where the reader was. */
export function isNew() {
  /** @type {Partial<PerformanceNavigationTiming>[]} */
  const [opening] = performance.getEntriesByType("navigation");
  return opening?.type === "navigate";
}

/**
 * Let a drag that begins on a poster go on when its scene is live.
 * @param {HTMLElement[]} scenes
 * @returns a function to be called with a scene that has become live
 */
export function keepDrags(scenes) {
  /** @type {{scene: HTMLElement, event: PointerEvent} | null} */
  let held = null;
  for (const scene of scenes) {
    scene.addEventListener("pointerdown", (event) => (held = { scene, event }));
    // The browser would drag the picture.
    scene.addEventListener("dragstart", (event) => event.preventDefault());
  }
  for (const kind of LET_GO) addEventListener(kind, () => (held = null));
  return (/** @type {HTMLElement} */ scene) => {
    if (held?.scene !== scene) return;
    const { event } = held;
    const below = document.elementFromPoint(event.clientX, event.clientY);
    below?.dispatchEvent(new PointerEvent("pointerdown", event));
  };
}
