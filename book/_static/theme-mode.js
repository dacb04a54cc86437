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
