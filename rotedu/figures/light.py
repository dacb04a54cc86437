"""How VTK draws what the viewer draws: its shaders get the same two texts of GLSL.

The light on solid bodies takes the place of VTK's lights and of what a material says of diffuse and
specular light. A ball of glass is seen from where it stands, and so is what stands behind it.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pyvista
from numpy.typing import ArrayLike

IDENTITY = np.eye(3)
SHADERS = [Path(__file__).with_name(name) for name in ("light.glsl", "ball.glsl")]
"""What both renderers compile; ``viewer/build.js`` reads them, too."""
INSIDE = "inside"
"""Point data of a surface: how far a point belongs to its hollow side, from 0 to 1."""
GLEAM = 0.8
"""How much of the room a surface with a hollow side mirrors; others mirror less."""

PLACE = "ballPlace = (vertexMC.xyz - {center}) / {radius};"
# VTK has this matrix, and normals, only where light falls.
EYE = """
  vec3 eyeMC = (inverse(MCVCMatrix) * vec4(0.0, 0.0, 0.0, 1.0)).xyz;
  ballEye = (eyeMC - {center}) / {radius};
"""
LIT = """
  fragOutput0.rgb =
    lightOn(diffuseColor, normalVCVSOutput, normalize(-vertexVC.xyz), isInside, {gleam});
"""
BALL = "fragOutput0 = ballColor(ballEye, ballPlace, gl_FrontFacing);"
# The back of a pale part would show through its front.
BEHIND = """
  float clear = ballClear(ballEye, ballPlace);
  if (clear < 1.0 && !gl_FrontFacing) discard;
  fragOutput0.a *= clear;
"""
SHADOW = "fragOutput0 = lightShadow(ballPlace.xy, mat3(LYING));"


def gleam_of(actor: pyvista.Actor, surface: pyvista.DataSet) -> float:
    """How much of the room a part mirrors; what is seen through, nothing. `specular` sets it."""
    if actor.prop.opacity < 1:
        return 0.0
    return float(actor.prop.specular) or (GLEAM if INSIDE in surface.point_data else 0.35)


def shade(
    actor: pyvista.Actor,
    surface: pyvista.DataSet,
    looks: Mapping[str, Any],
    lying: ArrayLike = IDENTITY,
) -> None:
    """Let VTK draw an actor as the viewer does.

    Parameters
    ----------
    actor : pyvista.Actor
        What draws `surface`.
    looks : mapping
        What `rotedu.figures.ball.ball_looks` says of it.
    lying : array_like, shape (3, 3), optional
        The axes, as columns, of the spoon whose shadow lies on it.
    """
    hollow = INSIDE in surface.point_data
    vertex = f"isInside = {'inside' if hollow else '0.0'};"
    color = LIT.format(gleam=gleam_of(actor, surface)) if actor.prop.lighting else ""
    for look, steps, drawn in (
        ("ball", EYE + PLACE, BALL),
        ("behind", EYE + PLACE, color + BEHIND),
        ("shadow", PLACE, SHADOW),
    ):
        if look in looks:
            *center, radius = looks[look]
            vertex += steps.format(center=f"vec3{tuple(center)}", radius=radius)
            color = drawn
    columns = np.transpose(lying).ravel()
    color = color.replace("LYING", ", ".join(map(str, columns)))
    between = "{0} vec3 ballEye;\n{0} vec3 ballPlace;\n{0} float isInside;\n"
    functions = "".join(file.read_text("utf-8") for file in SHADERS)
    shader = actor.GetShaderProperty()
    of_vertex, of_pixel = shader.AddVertexShaderReplacement, shader.AddFragmentShaderReplacement
    for add, mark, text in (
        (of_vertex, "//VTK::PositionVC::Dec", "in float inside;\n" + between.format("out")),
        (of_vertex, "//VTK::PositionVC::Impl", vertex),
        (of_pixel, "//VTK::PositionVC::Dec", between.format("in") + functions),
        (of_pixel, "//VTK::Light::Impl", color),
    ):
        add(mark, True, f"{mark}\n{text}", False)
    if hollow:
        _tell_inside(actor, surface)


def _tell_inside(actor: pyvista.Actor, surface: pyvista.DataSet) -> None:
    """Let the shader of vertices know which points are inside, as pyvista's mapper cannot."""
    # Python in a page has no VTK, and draws nothing.
    from vtkmodules.vtkCommonDataModel import vtkDataObject
    from vtkmodules.vtkRenderingCore import vtkPolyDataMapper

    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    mapper.MapDataArrayToVertexAttribute(
        "inside", INSIDE, vtkDataObject.FIELD_ASSOCIATION_POINTS, -1
    )
    actor.SetMapper(mapper)
