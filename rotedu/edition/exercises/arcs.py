"""Checks of the exercises of page 5 I."""

from collections.abc import Iterable, Iterator
from itertools import count

import numpy as np

from rotedu._vectors import Array
from rotedu.arcs import angle_between, arc_axis, nlerp, slerp
from rotedu.edition.exercises.answers import (
    along_equator,
    close,
    normalised,
    numbers,
    on_equator,
    outcomes,
)
from rotedu.edition.exercises.judging import Part, exercise, in_radians, otherwise, when
from rotedu.quaternions import Quaternion


@exercise(
    "5.2", "three angles in degrees", fields={"at t = 1/4": "°", "at t = 2": "°", "at t = −1": "°"}
)
def beyond_the_ends() -> Iterator[Part]:
    """A fraction of the arc is a fraction of its angle, also beyond its ends."""
    start, end, t = 10, 70, np.array([1 / 4, 2, -1])
    right = along_equator(slerp(*on_equator([start, end]), t))
    hints = {
        "You count from the first point, not from 0°.": when(
            t * (end - start), "At t = 0 the point is the first one, but your angles have it at 0°."
        ),
        "You took the whole angle of the second point for the arc.": when(
            t * end, "The arc begins at 10°, so it is shorter than 70°."
        ),
        "The point need not stop at the ends of the arc.": when(
            start + np.clip(t, 0, 1) * (end - start),
            "Beyond the ends it goes on along the equator, at the same speed.",
        ),
        **in_radians(np.deg2rad(right)),
        "How long is the arc, and where does it begin?": otherwise(
            "Go the fraction t of the length of the arc, from the first point. If t is negative, go"
            " backwards."
        ),
    }
    yield Part(right, hints, within=0.01, period=360)


@exercise("5.3", "three vectors, shape (3, 3): the axis, then two points", read=numbers(3, 3))
def ends_exchanged() -> Iterator[Part]:
    """The axis is reversed, and it is the same point of the same arc."""
    here, there, t = np.array([0.6, 0, 0.8]), np.array([0.48, 0.8, 0.36]), 0.3
    hints = {
        "About your axis, a positive angle leads away from the new second point.": when(
            arc_axis(here, there), "What happens to a cross product if its factors change places?"
        ),
        "Your axis does not have length 1.": when(
            np.cross(there, here), "(5-1) divides the cross product by the sine of the angle."
        ),
        "The axis is not right yet.": otherwise(
            "Only the order of the factors of one cross product has changed."
        ),
    }
    yield Part(arc_axis(there, here), hints, item=0, within=2e-3)
    hints = {
        "The ends are exchanged, but is t?": when(
            [slerp(there, here, t)] * 2,
            "Your points have covered 0.3 of the way from the new start. How far should they go?",
        ),
        "One of the points is not right yet.": otherwise(
            "How far is the old point from each end? And the new one?"
        ),
    }
    yield Part([slerp(there, here, 1 - t)] * 2, hints, item=slice(1, 3), within=2e-3)


def place(north: float, east: float) -> Array:
    """Return the point of the sphere at a latitude and a longitude, in degrees."""
    lat, lon = np.deg2rad(north), np.deg2rad(east)
    return np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])


def angle(one: Iterable[float], other: Iterable[float]) -> float:
    """Return the angle between two places, in radians."""
    return float(angle_between(place(*one), place(*other)))


@exercise(
    "5.4",
    "two numbers: a length in km and a latitude in degrees",
    fields={"length": "km", "latitude": "°"},
)
def great_circle_flight() -> Iterator[Part]:
    """The flight goes farther north than both its ends."""
    radius, frankfurt, san_francisco = 6371, (50.0, 8.6), (37.6, -122.4)

    theta = angle(frankfurt, san_francisco)
    # The axis leans from the pole by as much as the great circle leans from the equator.
    northernmost = np.arccos(abs(arc_axis(place(*frankfurt), place(*san_francisco))[2]))
    hints = {
        "That is the straight way, through the Earth.": when(
            radius * 2 * np.sin(theta / 2),
            "An arc is as long as the radius times its angle, in radians.",
        ),
        "The angle must be in radians before you multiply.": when(
            radius * np.rad2deg(theta), "The whole circle has the length 2 pi times the radius."
        ),
        "Your cosines and sines took degrees for radians.": when(
            radius * angle(*np.rad2deg([frankfurt, san_francisco])), "np.deg2rad converts an angle."
        ),
        "San Francisco is west of Greenwich.": when(
            radius * angle(frankfurt, (37.6, 122.4)),
            "Mind the sign of its longitude: your flight goes to East Asia.",
        ),
        "Latitude and longitude have changed places.": when(
            radius * angle(frankfurt[::-1], san_francisco[::-1]),
            "The first of the two numbers says how far north a place is.",
        ),
        "That is an angle. How long is its arc on the Earth?": when(
            np.rad2deg(theta), "An arc is as long as the radius times its angle, in radians."
        ),
        "Is that an angle in radians? How long is its arc on the Earth?": when(
            theta, "Multiply by the radius."
        ),
        "Is this the latitude?": when(np.rad2deg(northernmost), "The length in km comes first."),
        "The length is close, but not to within 5 km.": when(
            np.round(radius * theta, -2), "Round it less, or not at all."
        ),
        "The length is not right yet. Do your two points have length 1?": otherwise(
            "Turn degrees into radians, then latitude and longitude into a vector. The third"
            " coordinate is the sine of the latitude."
        ),
    }
    yield Part(radius * theta, hints, item=0, within=5)
    hints = {
        "Somewhere on the way the flight is farther north than at both ends.": when(
            max(frankfurt[0], san_francisco[0]),
            "Look at many points of the arc, or at the lean of its great circle.",
        ),
        "Is your latitude in radians?": when(northernmost, "The exercise asks for degrees."),
        "You found how close the flight comes to the pole.": when(
            90 - np.rad2deg(northernmost), "Latitudes are counted from the equator."
        ),
        "The latitude is close, but not to within 0.1°.": when(
            np.rad2deg(northernmost).round(), "Round it less, or not at all."
        ),
        "The length is right, but the latitude is not yet.": otherwise(
            "The latitude of a point is the arcsine of its third coordinate. Take the largest on"
            " the way."
        ),
    }
    yield Part(np.rad2deg(northernmost), hints, item=1, within=0.1)


@exercise(
    "5.5", "three numbers: a sign, an angle in degrees and a number of parts", read=numbers(3)
)
def nlerp_between_keys() -> Iterator[Part]:
    """The error falls with the cube of the angle of a part."""
    pose, other = Quaternion.from_axis_angle([0, 0, 1], np.radians([30, 300])).components
    moments, allowed = np.linspace(0, 1, 1001), 0.1

    def error(end: Array, parts: int) -> float:
        key = slerp(pose, end, 1 / parts)
        apart = angle_between(nlerp(pose, key, moments), slerp(pose, key, moments))
        return float(np.rad2deg(2 * apart.max()))

    sign = np.sign(pose @ other)
    near = sign * other
    right_off = error(near, 1)
    enough = next(n for n in count(1) if error(near, n) <= allowed)
    hints = {
        "With your sign the table turns the long way.": otherwise(
            "The dot product of the two quaternions tells whether the signs agree."
        )
    }
    yield Part(sign, hints, item=0, within=0)
    hints = {
        "That is the angle between the quaternions, not between the orientations.": when(
            right_off / 2,
            "A quaternion holds only a part of the angle of its rotation. Which part?",
        ),
        "They agree only at some moments.": when(
            lambda off: abs(off) < 1e-3,
            "Compare both at many times, not only at the ends and in the middle.",
            example=(sign, 0, enough),
        ),
        "Is your error in radians?": when(np.deg2rad(right_off), "The exercise asks for degrees."),
        "That is the error on the long way round.": when(
            error(-near, 1), "Use the sign that you have found before you interpolate."
        ),
        "The error is not right yet. Where on the way is it largest?": otherwise(
            "Compare both at many times, not only in the middle, where they agree.",
            example=(sign, 5, enough),
        ),
    }
    yield Part(right_off, hints, item=1, within=0.02)
    hints = {
        "Not quite enough: each part is still off by a little more than 0.1°.": when(
            enough - 1, "Have you compared orientations, not quaternions?"
        ),
        "The number of parts is not right yet.": otherwise(
            "Take the first part alone: its key is on the arc, and all parts have the same error."
        ),
    }
    yield Part(enough, hints, item=2)


@exercise("5.6", "directions, shape (1000, 3)", read=numbers(1000, 3))
def even_sweep() -> Iterator[Part]:
    """A step that contains a station cuts the corner, so it is shorter than the others."""
    stations = np.array([[1, 0, 0], [0, 1, 0], [0, 0.6, 0.8], [-0.8, 0, 0.6]])
    arcs = len(stations) - 1
    ends = np.concatenate([[0], np.cumsum(angle_between(stations[:-1], stations[1:]))])

    def at(covered: Array) -> Array:
        k = np.clip(np.searchsorted(ends, covered, side="right") - 1, 0, arcs - 1)
        fraction = (covered - ends[k]) / (ends[k + 1] - ends[k])
        return slerp(stations[k], stations[k + 1], fraction)

    right = at(np.linspace(0, ends[-1], 1000))
    equal_times = np.interp(np.linspace(0, arcs, 1000), range(arcs + 1), ends)
    hints = {
        "Some of your directions do not have length 1.": when(
            lambda directions: not close(np.linalg.norm(directions, axis=1), np.ones(1000), 1e-3),
            "A point between two directions on a straight line is inside the sphere.",
            example=np.linspace(stations[0], stations[-1], 1000),
        ),
        "The sweep should begin at the first station and end at the last.": when(
            lambda directions: not close(directions[[0, -1]], stations[[0, -1]], 1e-3),
            "Both ends are among the 1000 directions, and the sweep does not return.",
            example=right[::-1],
        ),
        "Each arc takes the same time, so the speed changes from arc to arc.": when(
            at(equal_times), "Are the arcs equally long? A longer one needs more directions."
        ),
        "Your directions are close, but not to nine digits.": when(
            lambda directions: close(directions, right, 1e-3),
            "Answer with the directions as they are computed in 64 bits, not rounded.",
            example=right.round(3),
        ),
        "The steps are not equal.": otherwise(
            "Find the distance covered in each direction first. Which arc is that on, and how far"
            " along?",
            example=at(ends[-1] * np.linspace(0, 1, 1000) ** 2),
        ),
    }
    yield Part(right, hints, within=1e-9)


ENDS = [
    (np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), 1 / 3),
    (np.array([0.6, 0.8, 0]), np.array([0, -0.6, 0.8]), 0.8),
    (np.array([0, 0, 1.0]), np.array([2, 1, 2]) / 3, 0.1),
]


@exercise("5.1", "a function of two points and a number that returns a point", read=outcomes(ENDS))
def arc_in_two_lines() -> Iterator[Part]:
    """Two sines for the weights, and one to divide by."""

    rows = outcomes(ENDS)
    chord = rows(lambda p, q, t: (1 - t) * p + t * q)
    hints = {
        "Your point starts at the wrong end.": when(
            rows(lambda p, q, t: slerp(q, p, t)),
            "At t = 0 all the weight belongs to the first point.",
        ),
        "Your points are not on the sphere.": when(
            rows(lambda p, q, t: np.sin(np.arccos(p @ q)) * slerp(p, q, t)),
            "By what does (5-2) divide?",
        ),
        "Your points are on the chord.": when(
            chord, "The weights of (5-2) are sines. Which angles do they belong to?"
        ),
        "That is the share of the chord.": when(
            normalised(chord), "A third of the chord is not a third of the angle."
        ),
        "Your points are elsewhere.": otherwise(
            "From (1, 0, 0) to (0, 1, 0), a third of the way is at 30°."
        ),
    }
    yield Part(rows(slerp), hints)
