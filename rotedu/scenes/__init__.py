"""The figures of the book in three dimensions: one function each, returning a pyvista scene.

Each module holds the scenes of the chapter with the same name. `parts`, `looks` and `shapes` hold
what they share, and `rotedu.colors` lists what the colours mean. To show a scene, write
``figure_1().show()``.
"""

from rotedu.scenes import (
    arcs,
    averages,
    balance,
    closed_curve,
    conclusions,
    control_points,
    errata,
    five_numbers,
    general_rotation,
    introduction,
    motion,
    ordinary_rotation,
    orientation_curves,
    orientations,
    quaternions,
    rigid_motion,
    shapes,
)
from rotedu.scenes.arcs import *
from rotedu.scenes.averages import *
from rotedu.scenes.balance import *
from rotedu.scenes.closed_curve import *
from rotedu.scenes.conclusions import *
from rotedu.scenes.control_points import *
from rotedu.scenes.errata import *
from rotedu.scenes.five_numbers import *
from rotedu.scenes.general_rotation import *
from rotedu.scenes.introduction import *
from rotedu.scenes.motion import *
from rotedu.scenes.ordinary_rotation import *
from rotedu.scenes.orientation_curves import *
from rotedu.scenes.orientations import *
from rotedu.scenes.quaternions import *
from rotedu.scenes.rigid_motion import *
from rotedu.scenes.shapes import *

__all__ = [
    *arcs.__all__,
    *averages.__all__,
    *balance.__all__,
    *closed_curve.__all__,
    *conclusions.__all__,
    *control_points.__all__,
    *errata.__all__,
    *five_numbers.__all__,
    *general_rotation.__all__,
    *introduction.__all__,
    *motion.__all__,
    *ordinary_rotation.__all__,
    *orientation_curves.__all__,
    *orientations.__all__,
    *quaternions.__all__,
    *rigid_motion.__all__,
    *shapes.__all__,
]
