"""The questions before one reads on: choices to open, each with an answer."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bs4 import BeautifulSoup
from explorables import outputs
from nightly import nightly
from notebook_language import Page, chapters, pages
from scipy.spatial.transform import Rotation

from rotedu import scenes
from rotedu.arcs import angle_between, arc_axis
from rotedu.averages import angular_distance, mean_rotation
from rotedu.closed_curve import closed_curve
from rotedu.control_points import bisect, control_points, double
from rotedu.general_rotation import (
    euler_angles,
    matrix_from_euler_angles,
)
from rotedu.motion import matrix_steps, quaternion_steps, rotation_vector
from rotedu.ordinary_rotation import axis_angle, rotation_matrix, transform
from rotedu.orientations import closed_rotation_curve, nearest_rotation
from rotedu.quaternions import Quaternion
from rotedu.scenes.orientations import POSES

ROOT = Path(__file__).parents[1]
AXE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
VERDICT = re.compile(r"(Yes|No|Half true)\b")

of_chapters = pytest.mark.parametrize("chapter", chapters(), ids=repr)


def answers(stem: str) -> str:
    """All that the answers on a page say."""
    [question] = pages()[f"{stem}.ipynb"].boxes("question")
    return "\n".join(choice.body for choice in question.choices)


def degrees(angle: Any) -> float:
    return float(np.rad2deg(angle))


@of_chapters
def test_a_chapter_asks_before_it_tells(chapter: Page) -> None:
    """The first word of an answer is its verdict, and one choice is right."""
    questions = chapter.boxes("question")
    assert questions
    for question in questions:
        assert 2 <= len(question.choices) <= 4
        verdicts = [VERDICT.match(choice.body) for choice in question.choices]
        assert [match and match[0] for match in verdicts].count("Yes") == 1
        assert None not in verdicts
        # Class notebooks put choices into HTML, where a formula is not typeset.
        assert not re.search(r"[$`*\[]", "".join(choice.title for choice in question.choices))


class TestWhatTheAnswersSay:
    """The numbers in the answers, and what they claim, computed."""

    def test_halfway(self) -> None:
        turn = rotation_matrix([-1, -2, 2], 2 * np.arctan2(3, 4))
        half = rotation_matrix([-1, -2, 2], np.arctan2(3, 4))
        of_each = matrix_from_euler_angles(*(np.array(euler_angles(turn)) / 2))[:3, :3]
        shorter = np.linalg.norm((np.eye(3) + turn)[:, 0]) / 2
        off = degrees(axis_angle(of_each.T @ half)[1])
        tip = degrees(np.arccos(of_each[:, 0] @ half[:, 0]))
        assert f"ends {off:.1f}° away from halfway, and its tip {tip:.1f}°" in answers(
            "01-introduction"
        )
        assert f"to {shorter:.0%} of its length" in answers("01-introduction")

    def test_one_control_point(self) -> None:
        points = np.array(scenes.FIGURE_8)
        points /= np.linalg.norm(points, axis=1, keepdims=True)
        moved = points.copy()
        moved[2] = bisect(points[2], points[3])
        changed = ~np.isclose(*(closed_curve(p, 100) for p in (points, moved))).all(axis=1)
        # Every piece has changed somewhere.
        assert changed.reshape(4, 100).any(axis=1).all()
        a, b = control_points(points)
        assert np.allclose(bisect(a, b), points)

    def test_straight_ahead(self) -> None:
        before, here = np.array([[1, 0, 0], [0.5, 0.75**0.5, 0]])
        ahead = double(before, here)
        a = bisect(here, bisect(ahead, ahead))
        assert np.allclose(np.cross(before, here)[:2], 0)
        assert a[2] == 0
        assert f"{degrees(angle_between(here, a)):.0f}° away" in answers("05-control-points")

    def test_carried_around(self) -> None:
        """The twist of the arrow, and the roll of a camera that is carried in the same way."""

        def once_round(points: Any) -> str:
            trip = np.eye(3)
            for start, end in zip(points, np.roll(points, -1, axis=0), strict=True):
                axis = arc_axis(start, end)
                assert abs(axis @ start) < 1e-12
                trip = rotation_matrix(axis, angle_between(start, end)) @ trip
            return f"by {degrees(axis_angle(trip)[1]):.0f}°"

        page = pages()["05-orientations.ipynb"]
        [question] = page.boxes("question")
        assert f"comes back turned {once_round(np.eye(3))}" in question.body
        assert "an eighth of the sphere's 720°" in answers("05-orientations")
        assert f"its picture is rolled {once_round(np.array(scenes.CAMERA_TARGETS))}" in page.text

    def test_spin_of_an_upright_camera(self) -> None:
        """A fine grid, for what is said below Picture 5-e."""
        curve = closed_curve(np.array(scenes.CAMERA_TARGETS), 20_000)
        azimuth = np.unwrap(np.arctan2(curve[:, 1], curve[:, 0]))
        spin = np.abs(np.gradient(azimuth, 1 / 20_000) * curve[:, 2]).max()
        assert f"{degrees(spin):.0f}° on the curve" in pages()["05-closed-curve.ipynb"].text

    def test_worn_spoons(self) -> None:
        matrix, quaternion = (
            degrees(axis_angle(nearest_rotation(worn))[1]) for worn in scenes.worn_rotations()
        )
        said = answers("06-conclusions")
        assert f"it is {matrix:.1f} degrees off instead of {quaternion:.0f}" in said
        assert f"matrix is {matrix:.1f} degrees off, the quaternion {quaternion:.0f}" in said

    def test_once_round_in_steps(self) -> None:
        steady = np.tile([0, 0, 2 * np.pi], (36, 1))
        w, *v = quaternion_steps([1, 0, 0, 0], steady, 1 / 36)[-1]
        worn = Quaternion(w, v).matrix(), matrix_steps(np.eye(3), steady, 1 / 36)[-1]
        by_quaternion, by_matrix = (-rotation_vector(nearest_rotation(m))[2] for m in worn)
        assert by_quaternion == pytest.approx(36 * (np.pi / 18 - 2 * np.arctan(np.pi / 36)))
        assert f"Yes, by {degrees(by_quaternion):.1f}°" in answers("beyond-motion")
        assert f"falls short by {degrees(by_matrix):.1f}°" in answers("beyond-motion")

    def test_one_half_or_one_third(self) -> None:
        """Three hundred random hexagons, as page 5 III compares the two."""
        hexagons = np.random.default_rng(5).normal(size=(300, 6, 3))
        bend, jump, even = [], [], []
        for fraction in (1 / 2, 1 / 3):
            p = closed_curve(hexagons, 300, fraction).reshape(300, 6, 300, 3)
            v, a = p[:, :, 2:] - p[:, :, :-2], np.diff(p, 2, axis=2)
            speed = np.linalg.norm(v, axis=-1)
            curvature = 4 * np.sum(p[:, :, 1:-1] * np.cross(v, a), axis=-1) / speed**3
            bend.append(np.abs(curvature).max(axis=(1, 2)))
            step = np.roll(curvature, -1, axis=1)[:, :, 0] - curvature[:, :, -1]
            jump.append(np.abs(step).max(axis=1))
            even.append(speed.max(axis=(1, 2)) / speed.min(axis=(1, 2)))
        said = pages()["05-closed-curve.ipynb"].text
        assert np.mean(np.divide(*jump) < 1) > 0.95
        assert "One half keeps the jumps of curvature small" in said
        assert np.mean(np.divide(*bend) > 1) > 0.55
        assert "but usually bends more sharply" in said
        assert np.mean(np.divide(*even) > 1) > 0.55
        assert "One third usually keeps the speed more even" in said

    def test_jumps_of_acceleration_at_the_poses(self) -> None:
        """Picture 5-l: the largest, and the mean of the five."""
        q, h = np.array(POSES), 1e-3
        rotations = Quaternion(q[:, 0], q[:, 1:]).matrix()
        jumps = []
        for fraction in (1 / 2, 1 / 3):
            curve = closed_rotation_curve(rotations, 1000, fraction)
            turns = rotation_vector(curve.swapaxes(1, 2) @ np.roll(curve, -1, axis=0)) / h
            change = np.diff(turns[np.arange(-3, 5 * 1000)], axis=0)[:-1].reshape(-1, 3) / h
            poses = 1000 * np.arange(5)
            jumps.append(np.linalg.norm(change[poses + 3] - change[poses + 1], axis=1))
        (half, third), (all_half, all_third) = np.max(jumps, axis=1), np.mean(jumps, axis=1)
        assert third > half
        assert all_third < all_half
        said = pages()["05-orientations.ipynb"].text
        assert "the largest jump of its acceleration is larger than with one half" in said

    def test_the_leaner_product_of_matrices_errs_more(self) -> None:
        """Chapter 6: 400 chains of 1000 turns in 32 bits, with two columns for a product."""
        rng, single = np.random.default_rng(4), np.float32

        def turns(size: float) -> Any:
            """Small ones of a size, or any for a size of 0."""
            v = rng.normal(scale=size or 1, size=(400, 3))
            q = np.column_stack([np.ones(400) if size else rng.normal(size=400), v])
            q /= np.linalg.norm(q, axis=1, keepdims=True)
            return Quaternion(q[:, 0], q[:, 1:])

        def chain(size: float, repeated: bool) -> float:
            """The quaternion's error over the matrix's."""
            exact, step = turns(0), turns(size)
            q = Quaternion(exact.w.astype(single), exact.v.astype(single))
            columns = exact.matrix().astype(single)
            for _ in range(1000):
                step = step if repeated else turns(size)
                exact = step * exact
                q = Quaternion(step.w.astype(single), step.v.astype(single)) * q
                left = step.matrix().astype(single)
                first, second = (
                    sum(left[:, :, k] * columns[:, k, [j]] for k in range(3)) for j in (0, 1)
                )
                columns = np.stack([first, second, np.cross(first, second)], axis=-1)
            right = exact.matrix().swapaxes(1, 2)
            by_quaternion = Quaternion(q.w.astype(float), q.v.astype(float)).matrix()
            by_matrix = nearest_rotation(columns.astype(float))
            return float(
                np.divide(
                    *(np.median(axis_angle(right @ m)[1]) for m in (by_quaternion, by_matrix))
                )
            )

        assert chain(0, repeated=False) == pytest.approx(2.2, abs=0.25)
        assert chain(np.radians(2) / 3.2, repeated=True) < 1
        said = pages()["06-conclusions.ipynb"].text
        assert (
            "the matrix's lead shrinks, to 2.2 for random turns, and after one turn of 2°" in said
        )

    def test_three_means_err_alike(self) -> None:
        """Page B, the last row of the table."""
        vectors = np.radians(40) / np.sqrt(3) * np.random.default_rng(7).normal(size=(4000, 10, 3))
        reports = Rotation.from_rotvec(vectors.reshape(-1, 3))
        matrices = reports.as_matrix().reshape(4000, 10, 3, 3)
        q = reports.as_quat(scalar_first=True).reshape(4000, 10, 4)
        total = np.sum(q * np.sign(q @ q[:, :1].swapaxes(1, 2)), axis=1)
        mean = by_angle = mean_rotation(matrices)
        for _ in range(8):
            seen = rotation_vector(by_angle.swapaxes(1, 2)[:, np.newaxis] @ matrices)
            by_angle = by_angle @ Rotation.from_rotvec(seen.mean(axis=1)).as_matrix()
        by_sum = Rotation.from_quat(total, scalar_first=True).as_matrix()
        errors = [
            np.median(angular_distance(np.eye(3), found)) for found in (mean, by_sum, by_angle)
        ]
        assert max(errors) < 1.01 * min(errors)
        assert "differ by less than one part in a hundred" in pages()["beyond-averages.ipynb"].text

    def test_steps_where_the_velocity_changes(self) -> None:
        """A thousand random motions of two seconds: page A, what is true in the folklore."""
        rng = np.random.default_rng(0)
        size, phase = rng.normal(size=(4, 1000, 3)), rng.uniform(0, 2 * np.pi, size=(4, 1000, 3))

        def velocity(t: float) -> Any:
            return np.sum([s * np.cos(k * t + p) for k, (s, p) in enumerate(waves)], axis=0)

        def followed(rate: Any, start: Any, n: int, order: int) -> Any:
            y, h = np.repeat([start], 1000, axis=0), 2 / n
            for t in np.arange(n) * h:
                k1 = k = rate(t, y)
                if order == 4:
                    k2 = rate(t + h / 2, y + h / 2 * k1)
                    k3 = rate(t + h / 2, y + h / 2 * k2)
                    k = (k1 + 2 * k2 + 2 * k3 + rate(t + h, y + h * k3)) / 6
                y = y + h * k
            return y

        def of_matrix(t: float, m: Any) -> Any:
            return np.cross(velocity(t)[:, :, np.newaxis], m, axis=1)

        def of_quaternion(t: float, q: Any) -> Any:
            return (Quaternion(0, velocity(t)) * Quaternion(q[:, 0], q[:, 1:]) / 2).components

        def off(n: int, order: int) -> Any:
            """The matrix's error over the quaternion's, both repaired at the end."""
            m = nearest_rotation(followed(of_matrix, np.eye(3), n, order))
            q = followed(of_quaternion, np.eye(4)[0], n, order)
            by = m, Quaternion(q[:, 0], q[:, 1:]).matrix()
            return np.divide(*(axis_angle(true.swapaxes(1, 2) @ found)[1] for found in by))

        waves = list(zip(size, phase, strict=True))
        q = followed(of_quaternion, np.eye(4)[0], 400, 4)
        true = Quaternion(q[:, 0], q[:, 1:]).matrix()
        said = pages()["beyond-motion.ipynb"].text
        quantiles = np.quantile(off(40, 4), [0.05, 0.5, 0.95])
        assert quantiles == pytest.approx([1.5, 12, 25], rel=0.1)
        assert "erred about a dozen times as much with the matrix in the median, from 1.5" in said
        assert np.mean(off(40, 4) < 1) == pytest.approx(0.02, abs=0.005)
        assert "to 25 times in nine of ten, and less than with the quaternion in two of a" in said
        assert 0.5 < np.mean(off(40, 1) > 1) < 0.65
        assert "the quaternion is nearer in little more than half" in said

    def test_one_of_five_quaternions_has_the_other_sign(self) -> None:
        rng = np.random.default_rng(5)
        truth, size = np.eye(4)[0], 1e-4
        errors = size * rng.normal(size=(1000, 5, 4)) * [0, 1, 1, 1]

        def off(signs: Any) -> Any:
            """Errors of the mean, and the length of the sum."""
            total = (np.array(signs)[:, np.newaxis] * (truth + errors)).sum(axis=1)
            return total[:, 1:] / total[:, :1], np.abs(total[:, 0])

        (five, length), (three, shorter) = off([1] * 5), off([1, 1, 1, 1, -1])
        assert np.allclose([length, shorter], [[5.0], [3.0]])
        assert np.std(three) / np.std(five) == pytest.approx(5 / 3, rel=0.02)
        for signs in ([1, 1, -1, -1, -1], [1, 1, 1, -1, -1]):
            (one, shortest) = off(signs)
            assert np.allclose(shortest, 1)
            assert np.std(one) / np.std(five) == pytest.approx(5, rel=0.02)
            assert ((np.array(signs) @ np.ones(5)) < 0) == (signs.count(-1) == 3)
        text = answers("beyond-averages")
        assert "with three of five, as with two, the sum is one report long" in text
        assert "the sum is three reports long instead of five" in text
        assert "divided by three now, not by five" in text
        assert "three or more of the five" in text

    def test_the_means_of_picture_b_a(self) -> None:
        def apart(**inputs: Any) -> float:
            """How far the two means are apart, in degrees."""
            return float(outputs("mean_by_hand", **inputs)["apart"])

        page = pages()["beyond-averages.ipynb"]
        text = "\n".join(cell.source for cell in page.cells)
        assert f"the means are {apart():.0f}° apart" in text
        assert apart(flip=False) == pytest.approx(1 / 3, abs=0.05)
        least = apart(**scenes.mean_by_hand.tries["no choice of signs helps"])
        assert f"the best one misses it by {least:.1f}°" in text


@of_chapters
def test_a_page_offers_its_choices_as_native_elements(book: Path, chapter: Page) -> None:
    html = (book / "book" / f"{chapter}.html").read_text("utf-8")
    page = BeautifulSoup(html, "html.parser")
    groups = page.select(".question")
    written = chapter.boxes("question")
    assert len(groups) == len(written)
    for group, question in zip(groups, written, strict=True):
        assert group["role"] == "group"
        [name] = page.select(f"#{group['aria-labelledby']}")
        assert name.get_text().endswith("?") or "?" in name.get_text()
        choices = group.find_all("details", recursive=False)
        summaries = [choice.summary.get_text().strip() for choice in choices]
        assert summaries == [choice.title for choice in question.choices]
        for choice in choices:
            assert not choice.has_attr("open")
            assert VERDICT.match(choice.select_one(".sd-summary-content").get_text().strip())


def test_choices_open_by_keyboard_without_scripts(browser: Any, site: str) -> None:
    page = browser.new_page(java_script_enabled=False)
    page.goto(f"{site}/book/03-ordinary-rotation.html")
    choices = page.locator(".question details")
    first, second = (choices.nth(k) for k in (0, 1))
    first.locator("summary").focus()
    for key, choice in (("Enter", first), ("Space", second)):
        answer = choice.locator(".sd-summary-content")
        assert not answer.is_visible()
        page.keyboard.press(key)
        assert answer.is_visible()
        page.keyboard.press("Tab")
    # Answers can be compared.
    assert first.locator(".sd-summary-content").is_visible()
    assert page.locator(".answer-form input").count() == 0
    page.close()


@pytest.mark.slow
def test_a_finger_can_hit_a_choice(browser: Any, site: str) -> None:
    page = browser.new_page(viewport={"width": 390, "height": 900}, has_touch=True)
    heights = []
    for chapter in chapters():
        page.goto(f"{site}/book/{chapter}.html")
        boxes = page.locator(".question summary, .answer-form :is(input, button)")
        heights += boxes.evaluate_all("all => all.map(box => box.getBoundingClientRect().height)")
    page.close()
    assert min(heights) >= 44


@pytest.mark.parametrize("scheme", nightly(["light", "dark"], "dark"))
def test_axe_finds_nothing(browser: Any, site: str, scheme: str) -> None:
    page = browser.new_page(color_scheme=scheme)
    page.goto(f"{site}/book/03-ordinary-rotation.html")
    page.evaluate("document.querySelectorAll('.question details').forEach(one => one.open = true)")
    page.locator(".answer-form input").last.fill("0.001")
    page.locator(".answer-form button").last.click()
    page.add_script_tag(path=AXE)
    where = "{include: ['.question', '.answer-form']}"
    run = f"axe.run({where}).then(({{violations}}) => violations.map(({{id}}) => id))"
    assert page.evaluate(run) == []
    page.close()


def test_the_roll_that_an_arc_brings_is_small_near_the_horizon_only() -> None:
    def rolled(p: Any, q: Any) -> Any:
        """Carry an upright camera along the arc by two reflections; return its roll."""

        def up(look: Any) -> Any:
            top = [0, 0, 1] - look[..., 2:] * look
            return top / np.linalg.norm(top, axis=-1, keepdims=True)

        halfway = p + q
        halfway /= np.linalg.norm(halfway, axis=-1, keepdims=True)
        top = up(p) - 2 * np.sum(up(p) * halfway, axis=-1, keepdims=True) * halfway
        turned = rotation_matrix(arc_axis(p, q), angle_between(p, q))
        np.testing.assert_allclose(transform(turned, up(p)), top, rtol=0, atol=1e-11)
        sideways = np.sum(np.cross(q, up(q)) * top, axis=-1)
        return np.degrees(np.arctan2(sideways, np.sum(up(q) * top, axis=-1)))

    camera = np.array(scenes.CAMERA_TARGETS)
    camera /= np.linalg.norm(camera, axis=1, keepdims=True)
    rolls = rolled(camera, np.roll(camera, -1, axis=0))
    np.testing.assert_allclose(rolls, [0.4, 12.7, 115.4, -4.6], rtol=0, atol=0.05)
    np.testing.assert_allclose(rolls.sum(), 123.8, rtol=0, atol=0.05)

    p, q = np.random.default_rng(51).normal(size=(2, 20_000, 3))
    p /= np.linalg.norm(p, axis=1, keepdims=True)
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    off = np.abs(rolled(p, q))
    low = (np.abs(p[:, 2]) < 0.5) & (np.abs(q[:, 2]) < 0.5)
    near = low & (np.sum(p * q, axis=1) > 0.5)
    np.testing.assert_allclose(np.median(off[near]), 3.6, rtol=0, atol=0.5)
    np.testing.assert_allclose(np.quantile(off[near], 0.95), 18, rtol=0, atol=2)
