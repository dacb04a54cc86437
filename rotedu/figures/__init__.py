"""Figures for a book, made from pyvista scenes.

A page in a browser has no Python behind it, so this package turns the window that
``Plotter.show()`` would open into something that a page can carry. `backend` makes a poster,
labels and an alternative text, `gltf` writes the scene to a file, and `pages` puts everything on a
page of Sphinx. There the viewer in the folder ``viewer`` replaces the poster with the scene, which
the reader can turn. A notebook shows the same figure as a `widget`. With `explorable`, a reader
can change what a scene shows. Nothing here depends on the contents of the scenes.

Use in another book
-------------------
1. Install the package next to `pyvista` and `myst_nb`. Two entry points announce it:
   the group ``pyvista.jupyter_backends`` brings the backends ``book``
   (`rotedu.figures.backend.book_figure`) and ``widget`` (`rotedu.figures.widget.figure`), the
   group ``myst_nb.mime_renderers`` brings `rotedu.figures.pages.SceneRenderer`.
2. Bundle the viewer once, with Node: ``npm install three esbuild``, then ``node
   viewer/build.js <folder>``; the folder must be one of Sphinx's ``html_static_path``. All
   files come from the book's own host, and no script is inline.
3. Add ``rotedu.figures.pages`` to the Sphinx extensions (in Jupyter Book:
   ``sphinx: extra_extensions``). While Sphinx runs, notebooks then use the backend
   ``book``; anywhere else ``widget``, unless they choose another. Pages with scenes load
   ``scene/scene.css`` and ``scene/loader.js``; the viewer follows when a scene comes near the
   screen.
4. Describe the scene in words, then show it as usual::

       plotter = pyvista.Plotter()
       plotter.add_mesh(pyvista.Sphere())
       plotter.add_point_labels([[0, 0, 1]], ["$P_0$"], show_points=False)
       describe(plotter, "A ball with its north pole marked P0.")
       plotter.show()

5. For a figure that answers the hand, write a model, as `rotedu.figures.state` describes its
   states, in a file of JavaScript beside the module, and a function that draws a state, decorated
   with `explorable`; show it with ``explore(function)``. The models come into the bundle in
   ``viewer/explorables.js`` and ``viewer/notebook.js``, and to the panels of pages in
   ``viewer/write-panels.js``; the viewer itself knows none.

A label may hold a formula between dollar signs; in a panel, ``*t*`` is a quantity. Meshes added
with ``pickable=False`` never hide the labels behind them. A scene raises a `ValueError` on a page,
and is a still picture in a notebook, if the viewer could not show it like the poster: if it has
lines that are not tubes, colours by point or lights that stay in place, for example.
"""

from rotedu.figures.announce import announce_backend
from rotedu.figures.backend import describe
from rotedu.figures.explorable import explorable, explore
from rotedu.figures.inputs import Choice, Handles, Poses, Slider, Switch
from rotedu.figures.model import RefusedError
from rotedu.figures.state import (
    State,
    add_view,
    draw_chart,
    limit_turning,
    place_part,
    read_out,
    stack_on_phone,
)

__all__ = [
    "Choice",
    "Handles",
    "Poses",
    "RefusedError",
    "Slider",
    "State",
    "Switch",
    "add_view",
    "describe",
    "draw_chart",
    "explorable",
    "explore",
    "limit_turning",
    "place_part",
    "read_out",
    "stack_on_phone",
]

announce_backend()
