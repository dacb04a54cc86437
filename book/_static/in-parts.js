/*
 * Lays a long page out a few milliseconds at a time, so that it answers the reader meanwhile: with
 * hundreds of formulas the whole takes too long. The theme's scripts measure everything on the
 * page, so they start when it is there.
 */
{
  const SLICE = 4;
  const nextFrame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

  const layOut = async () => {
    await nextFrame();
    let end = performance.now() + SLICE;
    for (const section of document.querySelectorAll(".in-parts article section section")) {
      const shown = section.firstElementChild.checkVisibility({ contentVisibilityAuto: true });
      const blocks = shown ? [] : [...section.children];
      for (const block of blocks) block.classList.add("later");
      section.classList.add("now");
      for (const block of blocks) {
        block.classList.remove("later");
        // To ask for its height is to have it laid out.
        if (block.offsetHeight >= 0 && performance.now() < end) continue;
        await nextFrame();
        end = performance.now() + SLICE;
      }
    }
  };

  const start = ({ href }) =>
    new Promise((onload) => {
      const script = document.createElement("script");
      document.body.append(Object.assign(script, { src: href, onload }));
    });

  const startTheme = async () => {
    for (const link of document.querySelectorAll("link[as=script]")) await start(link);
    // It begins by itself only in pages that are still loading.
    window.bootstrap.ScrollSpy.getOrCreateInstance(document.body);
  };

  layOut().then(startTheme);
}
