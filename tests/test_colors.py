"""A colour has one code, in scenes, formulas, charts and on the page that explains it."""

import re
from itertools import combinations
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.colors import to_hex, to_rgb
from notebook_language import BOOK, notebooks, pages

from rotedu import colors

CODES = {name: getattr(colors, name) for name in colors.__all__}
# How linear light is seen: by most people, and without the cones for red, green or blue (Machado,
# Oliveira and Fernandes, 2009).
EYES = {
    "usual": np.eye(3),
    "protanopia": [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    "deuteranopia": [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
    "tritanopia": [
        [1.255528, -0.076749, -0.178779],
        [-0.078411, 0.930809, 0.147602],
        [0.004733, 0.691367, 0.303900],
    ],
}
TO_XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])


def linear(color: Any) -> np.ndarray:
    """What a screen makes of a colour, as the standard of sRGB says."""
    color = np.array(to_rgb(color))
    return np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)


def contrast(code: str, other: str) -> float:
    dark, light = sorted((TO_XYZ @ linear(one))[1] for one in (code, other))
    return float((light + 0.05) / (dark + 0.05))


def lab(code: str, eyes: str) -> np.ndarray:
    seen = np.clip(np.asarray(EYES[eyes]) @ linear(code), 0, 1)
    share = TO_XYZ @ seen / TO_XYZ.sum(axis=1)
    x, y, z = np.where(share > 216 / 24389, np.cbrt(share), (24389 / 27 * share + 16) / 116)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def settings() -> tuple[dict[str, str], dict[str, str]]:
    """The colours of text and paper on light and on dark pages."""
    text = (BOOK.parent / "_config.yml").read_text("utf-8")
    light, dark = text.split("dark_css_variables:")
    pattern = r"color-([\w-]+): \"(#\w{6})\""
    return dict(re.findall(pattern, light)), dict(re.findall(pattern, dark))


def test_a_formula_names_its_colours() -> None:
    assert not [page.name for page in notebooks() if "textcolor" in page.text]


def test_charts_use_the_same_colours() -> None:
    with plt.style.context("rotedu.book"):
        cycle = plt.rcParams["axes.prop_cycle"].by_key()["color"]
        ink = to_hex(plt.rcParams["text.color"])
    known = {*CODES.values(), ink}
    assert set(map(to_hex, cycle)) <= known
    for cell in (cell for page in notebooks() for cell in page.code):
        assert set(re.findall(r"#[0-9a-f]{6}\b", cell.source)) <= known


def test_the_page_of_conventions_lists_them() -> None:
    table = re.findall(r"\| `(\w+)` \| `(#\w+)` \|", pages()["conventions.md"].text)
    assert dict(table) == CODES


def test_text_has_a_shade_of_each_for_light_and_dark_pages() -> None:
    styles = " ".join((BOOK / "_static" / "book.css").read_text("utf-8").split())
    for name in CODES.keys() - {"NEUTRAL"}:
        rule = f'[style*="{CODES[name]}"] {{ color: var(--color-{name.lower()})'
        assert rule in styles
        for shades in settings():
            assert contrast(shades[name.lower()], shades["background-primary"]) > 4.5


@pytest.mark.parametrize("eyes", EYES)
def test_contenders_and_verdicts_stand_apart(eyes: str) -> None:
    """A difference of 2 in CIELAB is just seen; lines want ten."""

    def apart(one: str, other: str) -> float:
        return float(np.linalg.norm(lab(one, eyes) - lab(other, eyes)))

    for code in (colors.QUATERNION, colors.MATRIX):
        assert min(apart(code, other) for other in CODES.values() if other != code) > 12
    assert apart(colors.QUATERNION, colors.MATRIX) > 30
    for shades in settings():
        kinds = [shades[kind] for kind in ("result", "condition", "wrong", "background-border")]
        assert min(apart(*two) for two in combinations(kinds, 2)) > 15
        for kind, ink in zip(kinds, ("background", "foreground") * 2, strict=True):
            assert contrast(kind, shades[f"{ink}-primary"]) > 4


@pytest.mark.parametrize("name", CODES)
def test_every_colour_is_seen_on_light_and_dark_pages(name: str) -> None:
    for shades in settings():
        assert contrast(CODES[name], shades["background-primary"]) > 3
