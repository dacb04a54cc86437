"""The colours of the book: each means the same thing in scenes, formulas and charts.

Blue, orange and green are those of the colour-blind-safe set of Okabe and Ito, the purple is a
darker shade of theirs, and the red stands apart from them in lightness, too. All of them can be
seen on white as well as on black, so a scene needs no background of its own.
"""

__all__ = ["AXIS", "CROSS", "NEUTRAL", "RESULT", "VECTOR", "WRONG"]

VECTOR = "#0072b2"  #: what is turned, or given
AXIS = "#d55e00"  #: what it is turned about
RESULT = "#009e73"  #: what comes of it
CROSS = "#b65f92"  #: what helps on the way to the result, or is compared with it
NEUTRAL = "#7d858d"  #: what only helps to see
WRONG = "#cc002a"  #: what an error makes of the result
