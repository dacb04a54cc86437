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

  const start = ({ href }) => {
    const script = Object.assign(document.createElement("script"), { src: href, async: false });
    document.body.append(script);
  };

  layOut().then(() => document.querySelectorAll("link[as=script]").forEach(start));
}
