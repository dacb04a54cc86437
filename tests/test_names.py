"""The short names of pages, beside the sentences that are their titles."""

from pathlib import Path

import pytest
from bs4 import BeautifulSoup
from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace, patch_docutils

PAGES = {
    "conf.py": """\
from page_head import WritePageHead, offer

author = copyright = version = html_title = "1"
extensions = ["myst_parser", "sphinx_external_toc", "names"]
html_theme, html_sidebars, epub_tocscope = "basic", {"**": ["globaltoc.html"]}, "includehidden"

def setup(app):
    app.add_config_value("repository", "", "env")
    app.add_transform(WritePageHead)
    app.connect("html-page-context", offer)
""",
    "_toc.yml": "{root: index, entries: [{file: a, title: 1 Start}, {file: b, title: 2 II Q & A}]}",
    "index.md": "# Book\n\nSee [](a.md) and [](b.md).",
    "a.md": "# 1 Start\n\nIt begins.",
    "b.md": "# A spoon's way\n\n**Picture 2-a.** A spoon.\n\nIt turns.",
}
SENTENCE = "A spoon’s way"
NAMES, WHOLE = ["1 Start", "2 II Q & A"], ["1 Start", f"2 II Q & A · {SENTENCE}"]


def test_pages_have_names_and_titles(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def build(edition: str) -> None:
        # The editions share what Sphinx has stored of the pages.
        folders = (tmp_path, tmp_path, tmp_path / edition, tmp_path / "doctrees")
        with patch_docutils(), docutils_namespace():
            Sphinx(*folders, edition, status=None, warningiserror=True).build()

    def read(file: str) -> str:
        return (tmp_path / file).read_text("utf-8")

    def said(page: str, selector: str) -> list[str]:
        found = BeautifulSoup(read(page), "html.parser").select(selector)
        return [element.get("title") or element.get_text().rstrip("¶") for element in found]

    monkeypatch.syspath_prepend(Path(__file__).parents[1] / "book" / "_ext")
    for name, text in PAGES.items():
        (tmp_path / name).write_text(text, "utf-8")

    build("html")
    assert said("html/b.html", ".toctree-l1") == NAMES
    assert said("html/index.html", "p > a") == WHOLE
    assert said("html/a.html", "h1, [rel=next]") == [WHOLE[1], NAMES[0]]
    assert said("html/b.html", "title, h1") == [f"{WHOLE[1]} — 1", SENTENCE]
    assert said("html/b.html", ".eyebrow") == ["Section 2 of the paper, part II · Q & A"]
    assert 'content="It turns." name="description"' in read("html/b.html")
    index = read("html/searchindex.js").replace(r"\u00b7", "·").replace(r"\u2019", "’")
    assert index.count(SENTENCE) == index.replace("&amp;", "&").count(WHOLE[1]) == 2

    build("singlehtml")
    assert said("singlehtml/index.html", "h2") == WHOLE
    build("epub")
    assert said("epub/nav.xhtml", "li a") == ["Book", *WHOLE]
    assert said("epub/b.xhtml", "h1") == [WHOLE[1]]

    (tmp_path / "_toc.yml").write_text(read("_toc.yml").replace("2 II", "3"), "utf-8")
    build("html")
    assert said("html/a.html", "[rel=next]") == [WHOLE[1].replace("2 II", "3")]
