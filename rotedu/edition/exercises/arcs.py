"""Checks of the exercises of page 5 I."""

from collections.abc import Iterator
from itertools import count

import numpy as np

from rotedu._vectors import Array
from rotedu.arcs import angle_between, arc_axis, nlerp, slerp
from rotedu.edition.exercises.judging import (
    RADIANS,
    Mistake,
    Part,
    Wrong,
    along_equator,
    close,
    exercise,
    numbers,
    on_equator,
)
from rotedu.quaternions import Quaternion

__all__: list[str] = []


@exercise(
    "5.1",
    fields={"at t = 1/4": "°", "at t = 2": "°", "at t = −1": "°"},
    expects="three angles in degrees",
    because="A fraction of the arc is a fraction of its angle, also beyond its ends.",
)
def beyond_the_ends() -> Iterator[Part]:
    """Yield three places on the great circle of an arc."""
    start, end, t = 10, 70, np.array([1 / 4, 2, -1])
    right = along_equator(slerp(*on_equator([start, end]), t))
    yield Part(
        right,
        Mistake(
            t * (end - start),
            "You count from the first point, not from 0°.",
            "At t = 0 the point is the first one, but your angles have it at 0°.",
        ),
        Mistake(
            t * end,
            "You took the whole angle of the second point for the arc.",
            "The arc begins at 10°, so it is shorter than 70°.",
        ),
        Mistake(
            start + np.clip(t, 0, 1) * (end - start),
            "The point need not stop at the ends of the arc.",
            "Beyond the ends it goes on along the equator, at the same speed.",
        ),
        Mistake(np.deg2rad(right), *RADIANS),
        otherwise=Wrong(
            "How long is the arc, and where does it begin?",
            "Go the fraction t of the length of the arc, from the first point. If t is negative, go"
            " backwards.",
        ),
        within=0.01,
        period=360,
    )


@exercise(
    "5.2",
    expects="three vectors, shape (3, 3): the axis, then two points",
    because="The axis is reversed, and it is the same point of the same arc.",
    read=numbers(3, 3),
)
def ends_exchanged() -> Iterator[Part]:
    """Yield the axis and the point, twice, after an exchange of the ends."""
    here, there, t = np.array([0.6, 0, 0.8]), np.array([0.48, 0.8, 0.36]), 0.3
    yield Part(
        arc_axis(there, here),
        Mistake(
            arc_axis(here, there),
            "About your axis, a positive angle leads away from the new second point.",
            "What happens to a cross product if its factors change places?",
        ),
        Mistake(
            np.cross(there, here),
            "Your axis does not have length 1.",
            "(5-1) divides the cross product by the sine of the angle.",
        ),
        otherwise=Wrong(
            "The axis is not right yet.",
            "Only the order of the factors of one cross product has changed.",
        ),
        item=0,
        within=2e-3,
    )
    yield Part(
        [slerp(there, here, 1 - t)] * 2,
        Mistake(
            [slerp(there, here, t)] * 2,
            "The ends are exchanged, but is t?",
            "Your points have covered 0.3 of the way. How much is left after 1 - t?",
        ),
        otherwise=Wrong(
            "One of the points is not right yet.",
            "How far is the old point from each end? And the new one?",
        ),
        item=slice(1, 3),
        within=2e-3,
    )


@exercise(
    "5.3",
    fields={"length": "km", "latitude": "°"},
    expects="two numbers: a length in km and a latitude in degrees",
    because="The flight goes farther north than both its ends.",
    read=numbers(2),
)
def great_circle_flight() -> Iterator[Part]:
    """Yield the length of a flight and its northernmost latitude."""
    radius = 6371
    frankfurt, san_francisco = (50.0, 8.6), (37.6, -122.4)

    def place(north: float, east: float) -> Array:
        lat, lon = np.deg2rad(north), np.deg2rad(east)
        return np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])

    def angle(one: tuple[float, float], other: tuple[float, float]) -> float:
        return float(angle_between(place(*one), place(*other)))

    theta = angle(frankfurt, san_francisco)
    as_radians = angle(*(tuple(np.rad2deg(city)) for city in (frankfurt, san_francisco)))
    # The axis leans from the pole by as much as the great circle leans from the equator.
    northernmost = np.arccos(abs(arc_axis(place(*frankfurt), place(*san_francisco))[2]))
    yield Part(
        radius * theta,
        Mistake(
            radius * 2 * np.sin(theta / 2),
            "That is the straight way, through the Earth.",
            "An arc is as long as the radius times its angle, in radians.",
        ),
        Mistake(
            radius * np.rad2deg(theta),
            "The angle must be in radians before you multiply.",
            "The whole circle has the length 2 pi times the radius.",
        ),
        Mistake(
            radius * as_radians,
            "Your cosines and sines took degrees for radians.",
            "np.deg2rad converts an angle.",
        ),
        Mistake(
            radius * angle(frankfurt, (37.6, 122.4)),
            "San Francisco is west of Greenwich.",
            "Mind the sign of its longitude: your flight goes to East Asia.",
        ),
        Mistake(
            radius * angle(frankfurt[::-1], san_francisco[::-1]),
            "Latitude and longitude have changed places.",
            "The first of the two numbers says how far north a place is.",
        ),
        Mistake(
            np.rad2deg(theta),
            "That is an angle. How long is its arc on the Earth?",
            "An arc is as long as the radius times its angle, in radians.",
        ),
        Mistake(
            theta,
            "Is that an angle in radians? How long is its arc on the Earth?",
            "Multiply by the radius.",
        ),
        Mistake(np.rad2deg(northernmost), "Is this the latitude?", "The length in km comes first."),
        Mistake(
            np.round(radius * theta, -2),
            "The length is close, but not to within 5 km.",
            "Round it less, or not at all.",
        ),
        otherwise=Wrong(
            "The length is not right yet. Do your two points have length 1?",
            "Turn degrees into radians, then latitude and longitude into a vector. The third"
            " coordinate is the sine of the latitude.",
        ),
        item=0,
        within=5,
    )
    yield Part(
        np.rad2deg(northernmost),
        Mistake(
            max(frankfurt[0], san_francisco[0]),
            "Somewhere on the way the flight is farther north than at both ends.",
            "Look at many points of the arc, or at the lean of its great circle.",
        ),
        Mistake(northernmost, "Is your latitude in radians?", "The exercise asks for degrees."),
        Mistake(
            90 - np.rad2deg(northernmost),
            "You found how close the flight comes to the pole.",
            "Latitudes are counted from the equator.",
        ),
        Mistake(
            np.rad2deg(northernmost).round(),
            "The latitude is close, but not to within 0.1°.",
            "Round it less, or not at all.",
        ),
        otherwise=Wrong(
            "The length is right, but the latitude is not yet.",
            "The latitude of a point is the arcsine of its third coordinate. Take the largest"
            " on the way.",
        ),
        item=1,
        within=0.1,
    )


@exercise(
    "5.4",
    expects="three numbers: a sign, an angle in degrees and a number of parts",
    because="The error falls with the cube of the angle of a part.",
    read=numbers(3),
)
def nlerp_between_keys() -> Iterator[Part]:
    """Yield a sign, the error of nlerp, and the number of parts that makes it small."""
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
    yield Part(
        sign,
        otherwise=Wrong(
            "With your sign the table turns the long way.",
            "The dot product of the two quaternions tells whether the signs agree.",
        ),
        item=0,
        within=0,
    )
    yield Part(
        right_off,
        Mistake(
            right_off / 2,
            "That is the angle between the quaternions, not between the orientations.",
            "A quaternion holds only a part of the angle of its rotation. Which part?",
        ),
        Mistake(
            lambda off: abs(off) < 1e-3,
            "They agree only at some moments.",
            "Compare both at many times, not only at the ends and in the middle.",
            example=(sign, 0, enough),
        ),
        Mistake(
            np.deg2rad(right_off), "Is your error in radians?", "The exercise asks for degrees."
        ),
        Mistake(
            error(-near, 1),
            "That is the error on the long way round.",
            "Use the sign that you have found before you interpolate.",
        ),
        otherwise=Wrong(
            "The error is not right yet. Where on the way is it largest?",
            "Compare both at many times, not only in the middle, where they agree.",
        ),
        item=1,
        within=0.02,
        example=(sign, 5, enough),
    )
    yield Part(
        enough,
        Mistake(
            enough - 1,
            "Not quite enough: each part is still off by a little more than 0.1°.",
            "Have you compared orientations, not quaternions?",
        ),
        otherwise=Wrong(
            "The number of parts is not right yet.",
            "Take the first part alone: its key is on the arc, and all parts have the same error.",
        ),
        item=2,
    )


@exercise(
    "5.5",
    expects="directions, shape (1000, 3)",
    because="A step that contains a station cuts the corner, so it is shorter than the others.",
    read=numbers(1000, 3),
)
def even_sweep() -> Iterator[Part]:
    """Judge directions at equal distances along a chain of arcs."""
    stations = np.array([[1, 0, 0], [0, 1, 0], [0, 0.6, 0.8], [-0.8, 0, 0.6]])
    arcs = len(stations) - 1
    ends = np.concatenate([[0], np.cumsum(angle_between(stations[:-1], stations[1:]))])

    def at(covered: Array) -> Array:
        k = np.clip(np.searchsorted(ends, covered, side="right") - 1, 0, arcs - 1)
        fraction = (covered - ends[k]) / (ends[k + 1] - ends[k])
        return slerp(stations[k], stations[k + 1], fraction)

    right = at(np.linspace(0, ends[-1], 1000))
    yield Part(
        lambda directions: close(np.linalg.norm(directions, axis=1), np.ones(1000), 1e-3),
        otherwise=Wrong(
            "Some of your directions do not have length 1.",
            "A point between two directions on a straight line is inside the sphere.",
        ),
        example=np.linspace(stations[0], stations[-1], 1000),
    )
    yield Part(
        lambda directions: close(directions[[0, -1]], stations[[0, -1]], 1e-3),
        otherwise=Wrong(
            "The sweep should begin at the first station and end at the last.",
            "Both ends are among the 1000 directions, and the sweep does not return.",
        ),
        example=right[::-1],
    )
    equal_times = np.interp(np.linspace(0, arcs, 1000), range(arcs + 1), ends)
    yield Part(
        right,
        Mistake(
            at(equal_times),
            "Each arc takes the same time, so the speed changes from arc to arc.",
            "Are the arcs equally long? A longer one needs more directions.",
        ),
        Mistake(
            lambda directions: close(directions, right, 1e-3),
            "Your directions are close, but not to nine digits.",
            "Answer with the directions as they are computed in 64 bits, not rounded.",
            example=right.round(3),
        ),
        otherwise=Wrong(
            "The steps are not equal.",
            "Find the distance covered in each direction first. Which arc is that on, and how far"
            " along?",
        ),
        within=1e-9,
    )
