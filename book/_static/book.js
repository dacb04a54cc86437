/**
 * The elements that a selector finds.
 *
 * @param {string} selector
 * @param {ParentNode} within
 * @returns {HTMLElement[]}
 */
const every = (selector, within = document) => Array.from(within.querySelectorAll(selector));

/** What a title says, once. */
const saidBy = (title) => {
  const words = title.cloneNode(true);
  for (const unsaid of every(".katex-mathml, .headerlink", words)) unsaid.remove();
  return words.textContent.trim();
};

// Let the keyboard reach every box that scrolls sideways.
const letReach = () => {
  for (const box of every("article :is(pre, .table-wrapper, .text_html, .katex-display)")) {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
  }
};

for (const event of ["load", "resize"]) addEventListener(event, letReach);
document.addEventListener("toggle", letReach, true);

// MyST-NB gives the buttons of hidden cells a label that differs from their text.
for (const button of every(".cell summary")) button.removeAttribute("aria-label");

// Who reports a mistake need not say in which section.
for (const link of every("a.report")) {
  link.addEventListener("click", () => {
    const titles = every("article :is(h1, h2, h3)");
    const above = (title) => title.getBoundingClientRect().top < innerHeight / 2;
    const title = titles.findLast(above);
    if (!title || title.tagName === "H1") return;
    const url = new URL(link.getAttribute("href") ?? "");
    const page = url.searchParams.get("place")?.split(", § ")[0];
    url.searchParams.set("place", `${page}, § ${saidBy(title)}`);
    link.setAttribute("href", url.href);
  });
}

// The squares of the first page are one stop for Tab; arrow keys go from one to the next.
const squares = every(".squares a");

squares.forEach((square, i) => {
  square.tabIndex = i ? -1 : 0;
  square.addEventListener("keydown", ({ key, ctrlKey, altKey, metaKey }) => {
    const next = squares[i + { ArrowRight: 1, ArrowLeft: -1 }[key]];
    if (!next || ctrlKey || altKey || metaKey) return;
    [square.tabIndex, next.tabIndex] = [-1, 0];
    next.focus();
  });
});

// What the search quotes is text: no labels and buttons of figures, and each formula once.
// @ts-expect-error: Sphinx defines it, on its page.
const sphinxSearch = typeof Search === "undefined" ? null : Search;

if (sphinxSearch) {
  const { htmlToText } = sphinxSearch;
  const unsaid =
    ".scene, .explorable, .chart, .cell:has(figure) > :not(.cell_output), .page-head, form, noscript, .katex-mathml";
  sphinxSearch.htmlToText = (html, anchor) => {
    const page = new DOMParser().parseFromString(html, "text/html");
    for (const part of every(unsaid, page)) part.remove();
    return htmlToText(page.documentElement.outerHTML, anchor);
  };
}

// A page opened from a file cannot preload its fonts, so there they may load late.
if (location.protocol === "file:") {
  const { src } = /** @type {HTMLScriptElement} */ (document.currentScript);
  for (const style of ["normal", "italic"]) {
    const url = new URL(`fonts/source-serif-4-latin-wght-${style}.woff2`, src);
    const font = new FontFace("Source Serif 4", `url(${url})`, { style, weight: "400 700" });
    font.load().then(() => document.fonts.add(font));
  }
}

// Present a page: one section at a time. A figure, a field, or a box that
// scrolls, keeps the keys it uses.
const pageHead = document.querySelector(".page-head");

if (pageHead) {
  const root = document.documentElement;
  const sections = every("article section");
  const steps = { ArrowRight: 1, PageDown: 1, " ": 1, ArrowLeft: -1, PageUp: -1 };
  const ends = { Home: 0, End: sections.length - 1 };
  let place = 0;

  pageHead.insertAdjacentHTML("beforeend", ' <button type="button">Slides</button>');
  document.body.insertAdjacentHTML(
    "beforeend",
    `<nav class="present-bar" aria-label="Sections">
      <button type="button" aria-label="Previous section">←</button>
      <span role="status"></span>
      <button type="button" aria-label="Next section">→</button>
      <button type="button">Full screen</button>
      <button type="button">Leave</button>
    </nav>`,
  );
  document
    .querySelector(".toc-sticky")
    ?.insertAdjacentHTML("beforeend", '<button type="button">Present from here</button>');
  const [bar] = every(".present-bar");
  const [status] = every("span", bar);

  const show = (index) => {
    const section = sections[index];
    if (!section) return;
    place = index;
    for (const each of sections) {
      each.classList.toggle("presented", each === section);
      each.classList.toggle("around", each !== section && each.contains(section));
    }
    section.tabIndex = -1;
    section.focus({ preventScroll: true });
    scrollTo({ top: 0, behavior: "instant" });
    const [title] = every("h1, h2, h3, h4", section);
    status.textContent = `${place + 1} of ${sections.length}: ${saidBy(title)}`;
    letReach();
  };
  const start = (index = place) => {
    root.classList.add("presenting");
    show(index);
  };
  const startHere = () => {
    const middle = innerHeight / 2;
    start(
      Math.max(
        0,
        sections.findLastIndex((s) => s.getBoundingClientRect().top < middle),
      ),
    );
  };
  const fill = () => {
    if (document.fullscreenElement) document.exitFullscreen();
    else root.requestFullscreen();
    // The button gives back the space bar.
    sections[place].focus({ preventScroll: true });
  };
  const leave = () => {
    if (document.fullscreenElement) document.exitFullscreen();
    root.classList.remove("presenting");
    sections[place].scrollIntoView({ behavior: "instant" });
    letReach();
  };
  const presents = () => root.classList.contains("presenting");
  const scrolls = (step) =>
    step > 0 ? root.scrollTop + root.clientHeight < root.scrollHeight - 2 : root.scrollTop > 0;
  // A figure that the lower edge of the screen would cut.
  const cut = () =>
    every(".explorable, .scene, .chart", sections[place]).find((figure) => {
      const { top, bottom } = figure.getBoundingClientRect();
      const edge = bar.getBoundingClientRect().top;
      return top > edge / 10 && top < edge && bottom > edge;
    });

  const actions = {
    ".page-head button": [() => start()],
    ".present-bar button": [() => show(place - 1), () => show(place + 1), fill, leave],
    ".toc-sticky button": [startHere],
  };
  for (const [buttons, act] of Object.entries(actions))
    every(buttons).forEach((button, i) => button.addEventListener("click", act[i]));

  /** @param {KeyboardEvent & { target: HTMLElement }} event */
  const steer = (event) => {
    const { key, target } = event;
    if (!presents() || event.ctrlKey || event.metaKey || event.altKey) return;
    const kept = target.closest(".scene, .explorable, input, [contenteditable], [tabindex='0']");
    if (key === "Escape") return kept ? sections[place].focus() : leave();
    if (kept || (key === " " && target.closest("a, button, summary"))) return;
    if (key === "F5") {
      event.preventDefault();
      return fill();
    }
    const step = key === " " && event.shiftKey ? -1 : steps[key];
    if (!step && !(key in ends)) return;
    // A section taller than the screen scrolls before it makes way for another.
    if (step && !key.startsWith("Arrow") && scrolls(step)) {
      const figure = step > 0 && cut();
      if (!figure) return;
      event.preventDefault();
      return figure.scrollIntoView({ behavior: "instant" });
    }
    event.preventDefault();
    show(ends[key] ?? place + step);
  };
  addEventListener("keydown", /** @type {any} */ (steer));

  // A link to another section of the page goes there.
  addEventListener("click", (event) => {
    const target = /** @type {Element} */ (event.target);
    const link = /** @type {HTMLAnchorElement?} */ (target.closest("a[href^='#']"));
    const aim =
      presents() && link && document.getElementById(decodeURIComponent(link.hash.slice(1)));
    if (aim) show(sections.findLastIndex((section) => section.contains(aim)));
  });
}
