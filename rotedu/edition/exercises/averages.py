"""Checks of the exercises of page B."""

from collections.abc import Iterator

import numpy as np

from rotedu._vectors import Array
from rotedu.averages import angular_distance, matrix_from_two_columns, mean_rotation
from rotedu.edition.exercises.judging import (
    NOT_THE_TRUTH,
    RADIANS,
    SCALAR_LAST,
    Mistake,
    Part,
    Wrong,
    as_array,
    as_rotation,
    exercise,
)
from rotedu.general_rotation import euler_angles, matrix_from_euler_angles
from rotedu.ordinary_rotation import rotation_matrix
from rotedu.quaternions import Quaternion

__all__: list[str] = []


@exercise(
    "B.1",
    fields={"matrices": "", "quaternions": "", "other sign": ""},
    expects="three distances",
    because="The two chords of quaternions and a diameter make a right-angled triangle.",
)
def three_chords() -> Iterator[Part]:
    """Yield the chords between turns by 20 and 80 degrees about one axis."""
    theta = np.deg2rad(60)
    right = np.array([2 * 2**0.5 * np.sin(theta / 2), 2 * np.sin(theta / 4), 2 * np.cos(theta / 4)])
    matrices, quaternions, other = right
    yield Part(
        right,
        Mistake(
            [2 * 2**0.5 * np.sin(theta), 2 * np.sin(theta / 2), 2 * np.cos(theta / 2)],
            "You take the sine of twice the angle that belongs into it.",
            "A chord of a circle is twice the sine of half the arc.",
        ),
        Mistake(
            [matrices, 2 * np.sin(theta / 2), 2 * np.cos(theta / 2)],
            "Your quaternions are as far apart as the rotations.",
            "A quaternion holds half the angle. How long is the arc between yours?",
        ),
        Mistake(
            [matrices, other, quaternions],
            "The two signs are the wrong way round.",
            "Of two opposite points of a sphere, which is nearer to a third one?",
        ),
        Mistake(
            [matrices / 2**0.5, quaternions, other],
            "The first number is too small.",
            "A turn moves two of the three columns of a matrix, and each counts.",
        ),
        Mistake(
            [8 * np.sin(theta / 2) ** 2, quaternions**2, other**2],
            "These are the squares of the distances.",
            "Only the sum of squares is simple. What is missing?",
        ),
        Mistake(
            [matrices, theta / 2, np.pi - theta / 2],
            "Between quaternions you give the arcs.",
            "The chord goes straight through the sphere. How long is it?",
        ),
        Mistake(
            [60, 30, 150],
            "These are angles, in degrees.",
            "A chord has a length. What does an arc of such an angle have for a chord?",
        ),
        Mistake(
            [2 * 2**0.5 * np.sin(30), 2 * np.sin(15), 2 * np.cos(15)],
            "Have you given degrees to a function that wants radians?",
            "A distance is not negative, and no chord exceeds the diameter.",
        ),
        otherwise=Wrong(
            "How large is the turn that leads from one to the other?",
            "Draw the two quaternions as points of a circle: the arc between them is half the"
            " angle of the turn.",
        ),
        within=5e-3,
    )


@exercise(
    "B.2",
    fields={"by chord": "°", "by angle": "°"},
    expects="two angles in degrees",
    because="The chord listens less to the one that strays.",
)
def two_means_about_one_axis() -> Iterator[Part]:
    """Yield the mean of turns by 0, 0 and 90 degrees about one axis."""
    by_chord, by_angle = np.degrees(np.arctan2(1, 2)), 30.0
    by_quaternions = 2 * np.degrees(np.arctan2(0.5**0.5, 2 + 0.5**0.5))
    right = np.array([by_chord, by_angle])
    yield Part(
        right,
        Mistake(
            right[::-1],
            "You have the two the wrong way round.",
            "Which of them is the mean of the numbers 0, 0 and 90?",
        ),
        Mistake(
            [by_angle, by_angle],
            "By angle that is right, by chord it is not.",
            "Where does the mean matrix send U? In which direction is that?",
        ),
        Mistake(
            [by_chord, by_chord],
            "By chord that is right, by angle it is not.",
            "About one axis, angles are numbers. What is their mean?",
        ),
        Mistake(
            [by_quaternions, by_angle],
            "The first is the direction of the sum of the quaternions.",
            "Its chords are those of quaternions. Take those of the matrices.",
        ),
        Mistake(np.deg2rad(right), *RADIANS),
        Mistake(
            90 - right,
            "You count one turn by 0° and two by 90°.",
            "Two of the three bodies are not turned.",
        ),
        Mistake(
            [45, 45],
            "There are two turns by 0° and one by 90°.",
            "Each of the three counts once, so the mean is not halfway.",
        ),
        otherwise=Wrong(
            "In the plane each turn sends U to a point of the circle. Add up the points.",
            "The nearest rotation to the mean matrix sends U in the direction of the mean point.",
        ),
        within=0.1,
    )


@exercise(
    "B.3",
    fields={f"set {k}": "" for k in range(1, 6)},
    expects="five numbers, each 1 or 0",
    because="What decides is the mean matrix: whether it has one nearest rotation.",
    read=lambda answer: as_array([float(each) for each in answer], (5,)),
)
def which_have_a_mean() -> Iterator[Part]:
    """Yield which of five sets of rotations have a unique mean."""
    right = np.array([1, 0, 0, 0, 1])

    def slip(at: int, first: str, second: str) -> Mistake:
        return Mistake(np.where(np.arange(5) == at, 1 - right, right), first, second)

    yield Part(
        right,
        slip(
            0,
            "Almost half a turn apart is not half a turn apart.",
            "How does the mean of the two look if you come closer to 180°?",
        ),
        slip(
            1,
            "Look at the second set again: how far apart are those two?",
            "Multiply the inverse of one by the other. Which half turns follow each other?",
        ),
        slip(
            2,
            "Look at the third set again: no orientation among the three is special.",
            "Turn all three by 120° about W. What happens to the set, and to its mean?",
        ),
        slip(
            3,
            "Add up the four matrices of the fourth set.",
            "Each is diagonal. Which rotation is nearest to what you find?",
        ),
        slip(
            4,
            "The fifth set counts one of its rotations twice.",
            "Add up the five matrices. Which rotation is nearest to the sum?",
        ),
        otherwise=Wrong(
            "More than one of the five is not right yet.",
            "Try each set with `mean_rotation`, and say why it refuses.",
        ),
    )


TRACKED = [2, -1, 2], 2.5


def two_trackers() -> tuple[Array, Array]:
    """Return what two trackers have measured, and how large their errors are, in degrees."""
    seeded = np.random.default_rng(19)
    errors = np.array([2, 2, 2, 6, 6, 6, 6, 6, 6, 6.0])
    noise = rotation_matrix(seeded.normal(size=(10, 3)), np.deg2rad(errors))
    return noise @ rotation_matrix(*TRACKED), errors


@exercise(
    "B.4",
    expects="a rotation: a matrix, shape (3, 3), or a unit quaternion",
    because="Seven coarse measurements still add a little to three fine ones.",
    read=as_rotation,
)
def weighted_mean() -> Iterator[Part]:
    """Yield the mean of measurements of two qualities."""
    measured, errors = two_trackers()
    right = mean_rotation(measured, errors**-2)
    w, x, y, z = Quaternion.from_matrix(right).components
    yield Part(
        right,
        Mistake(
            mean_rotation(measured),
            "All ten count the same in your mean.",
            "How much does a measurement count whose error is three times as large?",
        ),
        Mistake(
            mean_rotation(measured, 1 / errors),
            "Your weights fall too slowly.",
            "Variances add up, and they are squares of errors.",
        ),
        Mistake(
            mean_rotation(measured, errors**2),
            "The coarse measurements count most in your mean.",
            "A large error should make a weight small.",
        ),
        Mistake(
            mean_rotation(measured[:3]),
            "You leave the coarse tracker out.",
            "It knows less, but it does not know nothing. Give it a small weight.",
        ),
        Mistake(
            mean_rotation(measured[3:]),
            "You leave the fine tracker out.",
            "It knows most. Use both.",
        ),
        Mistake(
            np.tensordot(errors**-2, measured, 1) / np.sum(errors**-2),
            "Your weights are right, but this matrix does not only turn.",
            "A mean matrix shrinks. Which rotation is nearest to it?",
        ),
        Mistake(rotation_matrix(*TRACKED), *NOT_THE_TRUTH),
        Mistake(Quaternion(x, [y, z, w]).matrix(), *SCALAR_LAST),
        Mistake(
            right.T,
            "This rotation turns back.",
            "Your answer is the inverse of the mean. Is a quaternion of yours conjugated?",
        ),
        otherwise=Wrong(
            "Give each measurement a weight, and let `mean_rotation` do the rest.",
            "The best weight of a measurement is one over the square of its error.",
        ),
        within=1e-3,
    )


def noisy_copies() -> Array:
    """Return fifty rotations scattered widely around none."""
    seeded = np.random.default_rng(6)
    return rotation_matrix(seeded.normal(size=(50, 3)), seeded.normal(scale=1.0, size=50))


@exercise(
    "B.5",
    fields={"first": "°", "second": "°", "third": "°"},
    expects="three angles in degrees",
    because="The column that comes first keeps its direction, and the errors of the rest are lost.",
)
def by_two_columns() -> Iterator[Part]:
    """Yield how far the means by two columns are from the mean, by the column that begins."""
    copies = noisy_copies()
    mean, columns = mean_rotation(copies), np.moveaxis(copies.mean(axis=0), 1, 0)
    made = [matrix_from_two_columns(columns[k], columns[(k + 1) % 3]) for k in range(3)]
    rolled = np.array([np.roll(matrix, k, axis=1) for k, matrix in enumerate(made)])
    right = np.degrees(angular_distance(mean, rolled))
    not_rolled = np.degrees(angular_distance(mean, np.array(made)))
    apart = np.degrees(angular_distance(rolled, np.roll(rolled, -1, axis=0)))
    yield Part(
        right,
        Mistake(np.deg2rad(right), *RADIANS),
        Mistake(
            not_rolled,
            "Only the first is right.",
            "The function puts what it gets first into the first column. Put the columns back.",
        ),
        Mistake(
            apart,
            "These are the distances between the three.",
            "Measure each from `mean_rotation` of all fifty.",
        ),
        Mistake(
            np.zeros(3),
            "They are near the mean, but they are not the mean.",
            "The mean columns have lost their lengths and their right angles. What does Gram and"
            " Schmidt's method do with each of them?",
        ),
        Mistake(
            right[[1, 2, 0]],
            "Your three answers are in another order.",
            "Begin with the first column, then with the second, then with the third.",
        ),
        otherwise=Wrong(
            "Average the columns over all fifty, then make a rotation of two of them.",
            "`copies.mean(axis=0)` holds the three mean columns. Those that follow the third one"
            " begin anew with the first.",
        ),
        within=0.02,
    )


def table_of_a_turn() -> Array:
    """Return the orientations of a body in one turn about (1, 2, 2), every ten degrees."""
    return rotation_matrix([1, 2, 2], np.deg2rad(np.arange(5, 366, 10)))


def halfway_errors() -> Array:
    """Return the errors, in degrees, halfway between the rows: a row for each form.

    The forms are the four of the exercise and, last, Euler angles without jumps.
    """
    table = table_of_a_turn()
    truth = rotation_matrix([1, 2, 2], np.deg2rad(np.arange(10, 361, 10)))
    q = Quaternion.from_matrix(table).components
    signs = np.cumprod(np.sign(np.sum(q[1:] * q[:-1], axis=1)))
    followed = np.concatenate([q[:1], signs[:, np.newaxis] * q[1:]])

    def middle(rows: Array) -> Array:
        return (rows[1:] + rows[:-1]) / 2

    def matrices(rows: Array) -> Array:
        return Quaternion(rows[:, 0], rows[:, 1:]).matrix()

    def from_angles(angles: Array) -> Array:
        return matrix_from_euler_angles(*middle(angles).T)[:, :3, :3]

    angles, columns = np.stack(euler_angles(table), axis=-1), middle(table)
    found = [
        from_angles(angles),
        matrices(middle(q)),
        matrices(middle(followed)),
        matrix_from_two_columns(columns[..., 0], columns[..., 1]),
        from_angles(np.unwrap(angles, axis=0)),
    ]
    return np.rad2deg([angular_distance(truth, way) for way in found])


@exercise(
    "B.6",
    fields={
        "Euler angles": "°",
        "quaternions as they come": "°",
        "quaternions followed": "°",
        "two columns": "°",
    },
    expects="four angles in degrees",
    because="A sign that is followed is as good as two columns; a rule for the sign is not.",
)
def worst_of_a_table() -> Iterator[Part]:
    """Yield the worst error of a table that is read by linear interpolation, in four forms."""
    errors = halfway_errors()
    euler, rule, followed, columns, unwrapped = errors.max(axis=1)
    right = np.array([euler, rule, followed, columns])
    yield Part(
        right,
        Mistake(np.deg2rad(right), *RADIANS),
        Mistake(
            errors[:4].mean(axis=1),
            "These are mean errors.",
            "One bad row is enough to break a machine. Take the worst.",
        ),
        Mistake(
            [euler, rule, rule, columns],
            "Your followed quaternions still jump.",
            "Compare each with the one before it, as it is after its own sign has been chosen.",
        ),
        Mistake(
            [euler, followed, followed, columns],
            "Your second form has no jump.",
            "Leave the signs as `from_matrix` chooses them.",
        ),
        Mistake(
            2 * 2**0.5 * np.sin(np.deg2rad(right) / 2),
            "These are chords.",
            "The exercise asks for angles. Which function measures them?",
        ),
        Mistake(
            [unwrapped, rule, followed, columns],
            "Your Euler angles do not jump.",
            "The machine knows nothing of full turns. Average the angles as `euler_angles` gives"
            " them.",
        ),
        otherwise=Wrong(
            "In each form, take the mean of neighbouring rows, make a rotation, and compare.",
            "The truth halfway is a turn about the same axis by 10°, 20°, 30° and so on.",
        ),
        within=0.1,
    )
