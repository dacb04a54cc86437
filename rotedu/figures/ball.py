"""A ball of glass with a graticule, what stands behind it, and the shadow of a spoon.

No geometry draws the graticule. The mesh of a ball only has to contain it, and thin parts that
stand behind it are pale. Nor does one draw a shadow: the mesh is the ground on which it lies.
"""

from typing import Any

import numpy as np
import pyvista
from numpy.typing import ArrayLike

from rotedu.figures.light import shade


def draw_as_ball(actor: pyvista.Actor, center: ArrayLike, radius: float) -> None:
    """Draw the sphere that a mesh contains as a ball of glass."""
    _look(actor, "ball", center, radius)


def fade_behind_ball(actor: pyvista.Actor, center: ArrayLike, radius: float) -> None:
    """Let an opaque part be pale where it stands behind a ball."""
    _look(actor, "behind", center, radius)


def show_shadow(actor: pyvista.Actor, of: str, center: ArrayLike, length: float) -> None:
    """Draw a level surface as the shadow of a spoon, a part with a name and a half length."""
    _look(actor, "shadow", center, length, of=of)


def ball_looks(actor: pyvista.Actor) -> dict[str, Any]:
    """Tell the viewer which ball a part is, or may stand behind: its center and radius.

    Or where it shows a ``shadow``, in units of which length, and ``of`` which part.
    """
    return getattr(actor, "ball_looks", {})


def _look(actor: pyvista.Actor, look: str, center: ArrayLike, radius: float, **more: str) -> None:
    """Record looks for the viewer, and let VTK have them as well."""
    looks = {look: [*np.asarray(center, float).tolist(), float(radius)]} | more
    pyvista.set_new_attribute(actor, "ball_looks", looks)
    shade(actor, actor.mapper.dataset, looks)
