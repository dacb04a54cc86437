"""The figures of the book in three dimensions: one function each, returning a pyvista scene.

Each module holds the scenes of the chapter with the same name. `parts` holds what they share, and
`rotedu.colors` lists what the colours mean. To show a scene, write ``figure_1().show()``.
"""

from rotedu.scenes.arcs import CAMERA_SEES, CAMERA_TARGETS, camera_arcs, figure_2, slerp_by_hand
from rotedu.scenes.averages import mean_by_hand
from rotedu.scenes.closed_curve import (
    ARCS,
    FIGURE_8,
    arcs_of_arcs,
    camera_by_hand,
    closed_curve_by_hand,
    figure_8,
)
from rotedu.scenes.conclusions import worn_rotations, worn_spoons_by_hand
from rotedu.scenes.control_points import (
    LOOP,
    NEIGHBOURS,
    control_points_by_hand,
    figure_3,
    figure_4,
    figure_5,
    figure_6,
    figure_7,
    reversed_axis,
)
from rotedu.scenes.errata import two_curves
from rotedu.scenes.general_rotation import (
    euler_angles_by_hand,
    one_for_three,
    stages,
    three_turns_by_hand,
)
from rotedu.scenes.introduction import four_descriptions
from rotedu.scenes.motion import spinning_by_hand
from rotedu.scenes.ordinary_rotation import figure_1, figure_1_by_hand, rotated_mesh
from rotedu.scenes.orientations import (
    TWO_ORIENTATIONS,
    animate,
    carried_around_by_hand,
    four_ways_between,
    routes_by_hand,
)
from rotedu.scenes.parts import teaspoon
from rotedu.scenes.quaternions import (
    double_cover_by_hand,
    grab_the_spoon,
    letter_f,
    two_mirrors_by_hand,
)

__all__ = [
    "ARCS",
    "CAMERA_SEES",
    "CAMERA_TARGETS",
    "FIGURE_8",
    "LOOP",
    "NEIGHBOURS",
    "TWO_ORIENTATIONS",
    "animate",
    "arcs_of_arcs",
    "camera_arcs",
    "camera_by_hand",
    "carried_around_by_hand",
    "closed_curve_by_hand",
    "control_points_by_hand",
    "double_cover_by_hand",
    "euler_angles_by_hand",
    "figure_1",
    "figure_1_by_hand",
    "figure_2",
    "figure_3",
    "figure_4",
    "figure_5",
    "figure_6",
    "figure_7",
    "figure_8",
    "four_descriptions",
    "four_ways_between",
    "grab_the_spoon",
    "letter_f",
    "mean_by_hand",
    "one_for_three",
    "reversed_axis",
    "rotated_mesh",
    "routes_by_hand",
    "slerp_by_hand",
    "spinning_by_hand",
    "stages",
    "teaspoon",
    "three_turns_by_hand",
    "two_curves",
    "two_mirrors_by_hand",
    "worn_rotations",
    "worn_spoons_by_hand",
]
