// Let the keyboard reach every box that scrolls sideways.
const boxes = "article :is(pre, .table-wrapper, .text_html, .chart, .katex-display)";

const letReach = () => {
  for (const box of document.querySelectorAll(boxes)) {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
  }
};

for (const event of ["load", "resize"]) addEventListener(event, letReach);
document.addEventListener("toggle", letReach, true);

// MyST-NB gives the buttons of hidden cells a label that differs from their text.
for (const button of document.querySelectorAll(".cell summary")) button.removeAttribute("aria-label");

// A page opened from a file cannot preload its fonts, so there they may load late.
if (location.protocol === "file:") {
  for (const style of ["normal", "italic"]) {
    const url = new URL(`fonts/source-serif-4-latin-wght-${style}.woff2`, document.currentScript.src);
    const font = new FontFace("Source Serif 4", `url(${url})`, { style, weight: "200 900" });
    font.load().then(() => document.fonts.add(font));
  }
}
