/* Figures that answer the hand, as Python reads and sets them. */
import { find, findAll, make } from "./elements.js";

/** The values of all figures of the page, by name; none for one that is not live yet. */
export function values() {
  const entry = ({ dataset }) => [dataset.name, JSON.parse(dataset.values ?? "{}")];
  return Object.fromEntries(findAll(".explorable").map(entry));
}

/** Let figures show what Python has set; return links to them. */
export function set(changed) {
  return Object.entries(changed).map(([name, detail]) => {
    const figure = find(`.explorable[data-name="${name}"]`);
    const tell = () => figure.dispatchEvent(new CustomEvent("rotedu:set", { detail }));
    if (figure.dataset.values) tell();
    else wake(figure, tell);
    return make("a", { href: `#${figure.id}` }, "Show the figure that Python has set");
  });
}

/** Bring a figure to life, then call back. */
function wake(figure, callback) {
  const observer = new MutationObserver(() => {
    if (!figure.dataset.values) return;
    observer.disconnect();
    callback();
  });
  observer.observe(figure, { attributeFilter: ["data-values"] });
  figure.querySelector(".scene").dispatchEvent(new Event("rotedu:live"));
}
