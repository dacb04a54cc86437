/*
 * Lays a long page out one section a frame, so that it answers the reader meanwhile: with
 * hundreds of formulas the whole takes too long at once. The theme's scripts measure everything
 * on the page, so they start when it is there.
 */
{
  const nextFrame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

  const layOut = async () => {
    for (const section of document.querySelectorAll(".in-parts article section section")) {
      await nextFrame();
      section.style.contentVisibility = "visible";
    }
    await nextFrame();
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
