"""The colours of the book: each means the same thing in scenes, formulas and charts.

Blue, orange and green are those of the colour-blind-safe set of Okabe and Ito, the purple is a
darker shade of theirs, and the red stands apart from them in lightness, too. Violet and ochre stand
apart from all of these, also for the colour-blind, and far from each other: they tell the two
contenders of the book apart. All of them are visible on white and on black, so a scene needs no
background of its own. Charts in notebooks, ``book.css`` and ``_config.yml`` repeat the codes.
"""

__all__ = ["AXIS", "CROSS", "MATRIX", "NEUTRAL", "QUATERNION", "RESULT", "VECTOR", "WRONG"]

VECTOR = "#0072b2"  #: the thing turned, or given
AXIS = "#d55e00"  #: the axis of the turn
RESULT = "#009e73"  #: the result
CROSS = "#b65f92"  #: a step towards the result, or something to compare with it
NEUTRAL = "#7d858d"  #: a visual aid
WRONG = "#cc002a"  #: the result of an error
QUATERNION = "#7c3aed"  #: a quaternion, where it is compared with a matrix
MATRIX = "#8a7740"  #: a matrix, where it is compared with a quaternion
