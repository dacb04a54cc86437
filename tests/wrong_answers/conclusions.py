"""Wrong answers to the exercises of Chapter 6, each with a word of the hint meant for it."""

from typing import Any

import numpy as np

MINUTES, DAYS = np.array([27.0, 18.8, 35.3]), 578.7

WRONG: dict[str, list[tuple[Any, str]]] = {
    "6.1": [
        ((900, 600), "each point twice"),
        ((1800, 1200), "again for each point"),
        ((450, 300), "not free"),
        ((504, 336), "one product"),
        ((318, 477), "changed places"),
        ((486, 324), "each of the points once"),
    ],
    "6.2": [
        ((9e-6, 9e-6), "partly cancel"),
        ((3e-6, 3e-6), "always the same"),
        ((9e-6, 3e-6), "wrong way round"),
        ((1e-6, 9e-6), "completely"),
        ((81e-6, 9e-6), "more slowly"),
        ((3, 9), "the factors"),
        ((2.7e-2, 2.7e-2), "How many times"),
    ],
    "6.3": [
        (2, "quite enough"),
        (4, "already cheaper"),
        (6, "one joint fewer"),
        (2.41, "whole number"),
    ],
    "6.4": [
        ((*60 * MINUTES, DAYS), "in seconds"),
        ((*3600 * MINUTES, DAYS), "numbers of steps"),
        ((*MINUTES / 60, DAYS), "in hours"),
        ((*2 * MINUTES, DAYS), "square of the length"),
        ((*MINUTES / 2, DAYS), "a square"),
        ((1000, 1000, 1000, DAYS), "32 bits"),
        ((MINUTES[0], MINUTES[0], MINUTES[0], DAYS), "of its own"),
        ((*MINUTES, DAYS / 1000), "in proportion"),
        ((*MINUTES, DAYS * 1000**-1.5), "inverse"),
        ((*MINUTES, DAYS * 1440), "in minutes"),
        ((*MINUTES, 365), "the days are not"),
    ],
    "6.5": [
        ((0, 1.0), "between two quaternions"),
        ((0, np.radians(2.0)), "in radians"),
        ((0, 0), "not the same"),
        ((2, 2), "Do yours"),
        ((0, 5), "the second is not yet"),
    ],
}
