"""The viewer's own tests, run by Node."""

import re
from pathlib import Path

from node import run_node

ROOT = Path(__file__).parents[1]
# What no browser gets.
NODE_ALONE = ("build.js", "write-panels.js")


def test_the_viewer_knows_no_scene() -> None:
    source = ROOT / "viewer" / "src"
    for file in source.glob("*.js"):
        for name in re.findall(r"""(?:from|import\(?)\s*["'](.+?)["']""", file.read_text("utf-8")):
            outside = not (file.parent / name).resolve().is_relative_to(source)
            assert not (name.startswith(".") and outside), f"{file.name} imports {name}"


def test_the_licences_are_those_of_the_libraries() -> None:
    """What is bundled is imported by name, from JavaScript or from styles."""
    libraries = ROOT / "node_modules"
    sources = [
        *ROOT.glob("viewer/*.*s"),
        *ROOT.glob("viewer/src/*"),
        *ROOT.glob("rotedu/scenes/*.js"),
    ]
    code = "\n".join(file.read_text("utf-8") for file in sources if file.name not in NODE_ALONE)
    assert set(re.findall(r"""(?:from|import) *\(?["'](\w[^/"']*)""", code)) == {"katex", "three"}
    text = (ROOT / "LICENSES" / "VIEWER.txt").read_text("utf-8")
    for name in ("katex", "three"):
        licence = (libraries / name / "LICENSE").read_text("utf-8").strip()
        assert licence in text, f"LICENSES/VIEWER.txt has another text than the licence of {name}"
    fonts = (libraries / "katex" / "dist" / "fonts").glob("*.woff2")
    reserved = set(re.findall(r"KaTeX_\w+", text))
    assert {font.name.partition("-")[0] for font in fonts} == reserved


def test_no_page_asks_for_a_button_that_a_reader_may_not_have() -> None:
    """Where motion is reduced, Play is gone."""
    pages = [*ROOT.glob("book/*.ipynb"), *ROOT.glob("book/*.md")]
    assert len(pages) > 10
    for page in pages:
        text = page.read_text("utf-8")
        assert not re.search(r"(?i)(?:press|click|push) (?:on )?\*?Play|Play \*", text), page.name


def test_the_viewer_passes_its_own_tests() -> None:
    run_node("--test", "viewer/test/*.test.js")
