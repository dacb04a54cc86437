"""The questions before one reads on: choices to open, each with an answer."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bs4 import BeautifulSoup
from explorables import outputs
from live_pages import complaints_of_axe
from nightly import nightly
from notebook_language import Page, chapters, pages
from oracles.rigid_motion import the_arm
from scipy.spatial.transform import Rotation

from rotedu import scenes
from rotedu.arcs import angle_between, arc_axis, nlerp
from rotedu.averages import angular_distance, mean_rotation
from rotedu.closed_curve import closed_curve
from rotedu.general_rotation import euler_angles, matrix_from_euler_angles
from rotedu.motion import matrix_steps, quaternion_steps, rotation_vector
from rotedu.ordinary_rotation import axis_angle, rotation_matrix
from rotedu.orientations import nearest_rotation
from rotedu.quaternions import Quaternion
from rotedu.scenes.rigid_motion import SKINS

DOZEN = "typically erred about a dozen times as much as the quaternion; at a tenth"
FIVE_OF_SIX = "it was the closer in five of six, though by little"
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
        verdicts = [VERDICT.match(choice.body)[0] for choice in question.choices]
        assert verdicts.count("Yes") == 1
        # Class notebooks put choices into HTML, where a formula is not typeset.
        assert not re.search(r"[$`*\[]", "".join(choice.title for choice in question.choices))


class TestWhatTheAnswersSay:
    """The numbers in the answers, and what they claim, computed."""

    def test_part_of_the_way(self) -> None:
        """What four people do, a third of the way and halfway."""
        axis, angle = [-1, -2, 2], 2 * np.arctan2(3, 4)
        turn = rotation_matrix(axis, angle)

        def missed(share: float) -> tuple[float, float, float]:
            right = rotation_matrix(axis, share * angle)
            of_each = matrix_from_euler_angles(*(share * np.array(euler_angles(turn))))[:3, :3]
            tip = of_each[:, 0] @ right[:, 0]
            off = axis_angle(of_each.T @ right)[1]
            length = np.linalg.norm(((1 - share) * np.eye(3) + share * turn)[:, 0])
            return degrees(off), degrees(np.arccos(tip)), length

        said, page = answers("01-introduction"), pages()["01-introduction.ipynb"].text
        off, tip, length = missed(1 / 3)
        assert f"ends {off:.1f}° away from where it should, its tip {tip:.1f}°" in said
        assert f"to {length:.0%} of its length" in said
        mixed = nlerp([1, 0, 0, 0], [0.8, -0.2, -0.4, 0.4], 1 / 3)
        turned = f"{degrees(2 * np.arccos(mixed[0])):.1f}° instead of {degrees(angle / 3):.1f}°"
        assert turned in said
        off, tip, length = missed(1 / 2)
        assert f"by {off:.1f}°, her tip by {tip:.1f}°" in page
        assert f"down to {length:.0%} of its length" in page

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

    def test_the_arm_bent_by_120_degrees(self) -> None:
        """Page C, below Picture C-c."""
        said = pages()["beyond-rigid-motion.ipynb"].text
        averaged, repaired = (the_arm(skin, 0, 120) for skin in SKINS[:2])
        assert f"this arm has lost {100 - averaged['volume']:.0f} % of its volume" in said
        assert repaired["stretch"] == pytest.approx(400, abs=5)
        assert "its skin is stretched to four times its length" in said

    def test_worn_spoons(self) -> None:
        matrix, quaternion = (
            degrees(axis_angle(nearest_rotation(worn))[1]) for worn in scenes.worn_rotations()
        )
        said = answers("06-conclusions")
        assert f"it is {matrix:.1f} degrees off instead of {quaternion:.0f}" in said
        assert f"the repaired quaternion is {quaternion:.0f} degrees off" in said

    def test_once_round_in_steps(self) -> None:
        steady = np.tile([0, 0, 2 * np.pi], (36, 1))
        w, *v = quaternion_steps([1, 0, 0, 0], steady, 1 / 36)[-1]
        worn = Quaternion(w, v).matrix(), matrix_steps(np.eye(3), steady, 1 / 36)[-1]
        by_quaternion, by_matrix = (-rotation_vector(nearest_rotation(m))[2] for m in worn)
        assert by_quaternion == pytest.approx(36 * (np.pi / 18 - 2 * np.arctan(np.pi / 36)))
        assert f"Yes, by {degrees(by_quaternion):.1f}°" in answers("beyond-motion")
        assert f"falls short by {degrees(by_matrix):.1f}°" in answers("beyond-motion")

    def test_the_leaner_product_of_matrices_errs_more(self) -> None:
        """Chapter 6: 400 chains of 1000 turns in 32 bits, with two columns for a product."""
        rng, single = np.random.default_rng(4), np.float32

        def turns() -> Quaternion:
            q = rng.normal(size=(400, 4))
            q /= np.linalg.norm(q, axis=1, keepdims=True)
            return Quaternion(q[:, 0], q[:, 1:])

        exact = turns()
        q = Quaternion(exact.w.astype(single), exact.v.astype(single))
        columns = exact.matrix().astype(single)
        for step in (turns() for _ in range(1000)):
            exact = step * exact
            q = Quaternion(step.w.astype(single), step.v.astype(single)) * q
            left = step.matrix().astype(single)
            first, second = (
                sum(left[:, :, k] * columns[:, k, [j]] for k in range(3)) for j in (0, 1)
            )
            columns = np.stack([first, second, np.cross(first, second)], axis=-1)
        worn = Quaternion(q.w.astype(float), q.v.astype(float)).matrix(), columns.astype(float)
        right = exact.matrix().swapaxes(1, 2)
        errors = [axis_angle(right @ nearest_rotation(m))[1] for m in worn]
        assert np.divide(*np.median(errors, axis=1)) == pytest.approx(2.2, abs=0.25)
        assert "lead shrinks, to 2.2 for random turns" in pages()["06-conclusions.ipynb"].text

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
        found = mean, by_sum, by_angle
        errors = [np.median(angular_distance(np.eye(3), each)) for each in found]
        assert max(errors) < 1.01 * min(errors)
        assert "differ by less than one part in a hundred" in pages()["beyond-averages.ipynb"].text

    @pytest.mark.parametrize(
        ("slower", "times", "less", "said"), [(1, 12, 0.02, DOZEN), (10, 1, 0.845, FIVE_OF_SIX)]
    )
    def test_steps_where_the_velocity_changes(
        self, slower: float, times: float, less: float, said: str
    ) -> None:
        """A thousand random motions of two seconds: page A, what is true in the folklore."""
        rng = np.random.default_rng(0)
        size, phase = rng.normal(size=(4, 1000, 3)), rng.uniform(0, 2 * np.pi, size=(4, 1000, 3))

        def velocity(t: float) -> Any:
            return np.sum([s * np.cos(k * t + p) for k, (s, p) in enumerate(waves)], axis=0)

        def followed(rate: Any, start: Any, n: int) -> Any:
            """Runge and Kutta's method of fourth order."""
            y, h = np.repeat([start], 1000, axis=0), 2 / n
            for t in np.arange(n) * h:
                k1 = rate(t, y)
                k2 = rate(t + h / 2, y + h / 2 * k1)
                k3 = rate(t + h / 2, y + h / 2 * k2)
                y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(t + h, y + h * k3))
            return y

        def of_matrix(t: float, m: Any) -> Any:
            return np.cross(velocity(t)[:, :, np.newaxis], m, axis=1)

        def of_quaternion(t: float, q: Any) -> Any:
            return (Quaternion(0, velocity(t)) * Quaternion(q[:, 0], q[:, 1:]) / 2).components

        waves = list(zip(size / slower, phase, strict=True))
        speeds = np.linalg.norm(velocity(1), axis=1)
        assert np.mean(speeds) * slower == pytest.approx(2.2, abs=0.1)
        worn = nearest_rotation(followed(of_matrix, np.eye(3), 40))
        by_quaternion, exact = (
            Quaternion(q[:, 0], q[:, 1:]).matrix()
            for q in (followed(of_quaternion, np.eye(4)[0], n) for n in (40, 400))
        )
        back = exact.swapaxes(1, 2)
        ratio = axis_angle(back @ worn)[1] / axis_angle(back @ by_quaternion)[1]
        assert np.median(ratio) == pytest.approx(times, rel=0.1)
        assert np.mean(ratio < 1) == pytest.approx(less, abs=0.005)
        assert said in pages()["beyond-motion.ipynb"].text

    @pytest.mark.parametrize(
        ("signs", "long"), [([1, 1, 1, 1, -1], 3), ([1, 1, 1, -1, -1], 1), ([1, 1, -1, -1, -1], 1)]
    )
    def test_some_of_five_quaternions_have_the_other_sign(self, signs: Any, long: int) -> None:
        errors = 1e-4 * np.random.default_rng(5).normal(size=(1000, 5, 4)) * [0, 1, 1, 1]

        def off(signs: Any) -> Any:
            total = (np.array(signs)[:, np.newaxis] * (np.eye(4)[0] + errors)).sum(axis=1)
            assert np.allclose(np.abs(total[:, 0]), abs(sum(signs)))
            return np.std(total[:, 1:] / total[:, :1])

        assert abs(sum(signs)) == long
        assert off(signs) / off([1] * 5) == pytest.approx(5 / long, rel=0.02)
        text = answers("beyond-averages")
        assert "with three of five, as with two, the sum is one report long" in text
        assert "the sum is three reports long instead of five" in text
        assert "divided by three now, not by five" in text

    def test_the_means_of_picture_b_a(self) -> None:
        def apart(**inputs: Any) -> float:
            """How far the two means are apart, in degrees."""
            return float(outputs("mean_by_hand", **inputs)["apart"])

        page = pages()["beyond-averages.ipynb"]
        text = "\n".join(cell.source for cell in page.cells)
        assert f"which turns no spoon, by {apart(flip=True):.0f}°" in text
        assert apart() == pytest.approx(1 / 3, abs=0.05)
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
    page = browser.new_page(
        java_script_enabled=False, viewport={"width": 390, "height": 900}, has_touch=True
    )
    page.goto(f"{site}/book/03-ordinary-rotation.html")
    first, second = page.locator(".question details").all()[:2]
    assert first.locator("summary").bounding_box()["height"] >= 44
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


@pytest.mark.parametrize("scheme", nightly(["light", "dark"], "dark"))
def test_axe_finds_nothing(browser: Any, site: str, scheme: str) -> None:
    page = browser.new_page(color_scheme=scheme)
    page.goto(f"{site}/book/03-ordinary-rotation.html")
    page.evaluate("document.querySelectorAll('.question details').forEach(one => one.open = true)")
    page.locator(".answer-form input").last.fill("0.001")
    page.locator(".answer-form button").last.click()
    assert complaints_of_axe(page, ".question, .answer-form") == []
    page.close()
