"""A ball of glass with a graticule: one shader, `ball.glsl`, in VTK and in the viewer.

No geometry draws the graticule. The mesh of a ball only has to contain it, and thin parts that
stand behind it are pale.
"""

from pathlib import Path

import numpy as np
import pyvista
from numpy.typing import ArrayLike

SHADER = Path(__file__).with_name("ball.glsl")
"""What both renderers compile; ``viewer/build.js`` reads it, too."""
VERTEX = """
  vec3 eyeMC = (inverse(MCVCMatrix) * vec4(0.0, 0.0, 0.0, 1.0)).xyz;
  ballEye = (eyeMC - {center}) / {radius};
  ballPlace = (vertexMC.xyz - {center}) / {radius};
"""
COLOR = "fragOutput0 = ballColor(ballEye, ballPlace, gl_FrontFacing);"
# The back of a pale part would show through its front.
FADE = """
  float clear = ballClear(ballEye, ballPlace);
  if (clear < 1.0 && !gl_FrontFacing) discard;
  fragOutput0.a *= clear;
"""


def draw_as_ball(actor: pyvista.Actor, center: ArrayLike, radius: float) -> None:
    """Draw the sphere that a mesh contains as a ball of glass."""
    _shade(actor, "ball", center, radius, COLOR)


def fade_behind_ball(actor: pyvista.Actor, center: ArrayLike, radius: float) -> None:
    """Let an opaque part be pale where it stands behind a ball."""
    _shade(actor, "behind", center, radius, FADE)


def ball_looks(actor: pyvista.Actor) -> dict[str, list[float]]:
    """Tell the viewer which ball a part is, or which it may stand behind: its center and radius."""
    return getattr(actor, "ball_looks", {})


def _shade(actor: pyvista.Actor, look: str, center: ArrayLike, radius: float, code: str) -> None:
    """Put a step into VTK's shaders, and record it for the viewer."""
    x, y, z = np.asarray(center, float).tolist()
    vertex = VERTEX.format(center=f"vec3({x}, {y}, {z})", radius=float(radius))
    declared, given = "//VTK::PositionVC::Dec", "//VTK::PositionVC::Impl"
    shader = actor.GetShaderProperty()
    varying = "{} vec3 ballEye;\n{} vec3 ballPlace;\n"
    shader.AddVertexShaderReplacement(
        declared, True, f"{declared}\n{varying.format('out', 'out')}", False
    )
    shader.AddVertexShaderReplacement(given, True, given + vertex, False)
    shader.AddFragmentShaderReplacement(
        declared,
        True,
        f"{declared}\n{varying.format('in', 'in')}{SHADER.read_text('utf-8')}",
        False,
    )
    lit = "//VTK::Light::Impl"
    shader.AddFragmentShaderReplacement(lit, True, f"{lit}\n{code}", False)
    pyvista.set_new_attribute(actor, "ball_looks", {look: [x, y, z, float(radius)]})
