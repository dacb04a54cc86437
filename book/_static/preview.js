// Look without leaving: what a link leads to, an equation, a figure, an erratum, a claim or a term,
// shows beside it when a mouse rests on it or the keyboard reaches it. It is read from its own page.
{
  const KINDS = ["equation", "figure", "picture", "erratum", "claim", "term"];
  const LINKS = KINDS.map(
    (kind) => `article a[href*="#${kind}-"]:not(.headerlink, .look *)`,
  ).join();
  const FOCUSED = `:is(${LINKS}):focus-visible`;
  const UNWANTED = ".headerlink, .explorable > :not(.scene), noscript, script";
  // Milliseconds that the mouse rests, and pixels between link, box and the edges of the window
  const REST = 250;
  const ROOM = 6;
  const pages = new Map();
  const box = Object.assign(document.createElement("div"), {
    className: "look",
    popover: "manual",
  });
  let timer;
  /** @type {HTMLAnchorElement?} */
  let shown = null;
  document.querySelector("article")?.append(box);
  const load = async (url) =>
    new DOMParser().parseFromString(await (await fetch(url)).text(), "text/html");
  const read = (url) => pages.get(url) ?? pages.set(url, load(url)).get(url);

  /** The parts of a page that an anchor stands for. */
  const named = (page, id) => {
    const anchor = page.getElementById(id);
    if (!anchor) return [];
    if (id.startsWith("term-")) return [anchor, anchor.nextElementSibling];
    const all = (selector) => [...anchor.closest("section, tr").querySelectorAll(selector)];
    // The claim and its verdict
    if (id.startsWith("claim-")) return all(":nth-child(even) > p");
    // As printed, what it should be, what it changes
    if (id.startsWith("erratum-")) return all(":scope > :is(h2, p)");
    return [anchor, ...page.querySelectorAll("link[href*='scene.css']")];
  };
  /** A copy without names, whose addresses hold on this page. */
  const copied = (part, url) => {
    const copy = document.importNode(part, true);
    for (const piece of copy.querySelectorAll(UNWANTED)) piece.remove();
    for (const piece of [copy, ...copy.querySelectorAll(":not(svg *)")]) {
      piece.removeAttribute("id");
      for (const name of ["src", "href"]) {
        if (piece[name]) piece.setAttribute(name, new URL(piece.getAttribute(name), url));
      }
    }
    return copy;
  };
  /** Put the box below its link, or above if it fits there only. */
  const place = () => {
    if (!shown) return;
    const { left, top, bottom } = shown.getBoundingClientRect();
    const [width, height] = [box.offsetWidth + ROOM, box.offsetHeight + ROOM];
    const below = bottom + height < innerHeight || top < height;
    box.style.left = `${Math.max(ROOM, Math.min(left, innerWidth - width))}px`;
    box.style.top = `${below ? bottom + ROOM : top - height}px`;
  };
  const close = () => {
    clearTimeout(timer);
    shown = null;
    box.hidePopover();
  };
  const open = async (link) => {
    clearTimeout(timer);
    shown = link;
    const [url, id] = link.href.split("#");
    const page = await read(url).catch(() => null);
    if (shown !== link) return;
    const parts = page ? named(page, id) : [];
    if (!parts.length) return close();
    // The browser would show it, too.
    link.removeAttribute("title");
    box.replaceChildren(...parts.map((part) => copied(part, url)));
    box.showPopover();
    place();
  };
  addEventListener("pointerover", ({ target, pointerType }) => {
    if (!(target instanceof Element)) return;
    clearTimeout(timer);
    const link = /** @type {HTMLAnchorElement?} */ (target.closest(LINKS));
    if (pointerType !== "mouse" || link === shown || box.contains(target)) return;
    // A page that scrolls under a mouse at rest takes nothing from the keyboard.
    if (shown?.matches(":focus-visible")) return;
    timer = setTimeout(() => (link ? open(link) : close()), REST);
  });
  addEventListener("focusin", ({ target }) => {
    if (target instanceof HTMLAnchorElement && target.matches(FOCUSED)) open(target);
  });
  addEventListener("focusout", close);
  addEventListener("scroll", place, { passive: true });
  new ResizeObserver(place).observe(box);
  const leave = (event) => {
    if (event.key !== "Escape" || !box.matches(":popover-open")) return;
    // The key ends nothing else.
    event.stopImmediatePropagation();
    close();
  };
  addEventListener("keydown", leave, { capture: true });
}
