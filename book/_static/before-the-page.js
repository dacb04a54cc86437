// The theme asks for its mode before the page is drawn, but does not answer before all its
// scripts have run; until then a page would have neither the light nor the dark colours.
{
  const page = document.documentElement.dataset;
  const prefersDark = matchMedia("(prefers-color-scheme: dark)").matches;
  if (!["light", "dark"].includes(page.mode)) {
    page.mode = "auto";
  }
  page.theme = page.mode === "auto" ? (prefersDark ? "dark" : "light") : page.mode;
}

// A page that is opened at its top is laid out in parts (in-parts.js), if the browser can do that.
// One that is opened again is not: the browser goes back to where the reader was, and needs the
// height of all above.
{
  const [opening] = performance.getEntriesByType("navigation");
  const can = CSS.supports("content-visibility", "auto");
  document.documentElement.classList.toggle("in-parts", can && opening?.type === "navigate");
}
