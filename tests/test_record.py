"""The paper about the edition, its citation and its record in an archive agree with the book."""

import json
import re
import shutil
import subprocess
import tomllib
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import pytest
import yaml
from derive import ROOT, derive_version
from html_pages import build_one_page, parse
from notebook_language import captions_by_hand
from uv import find_uv_bin

import rotedu
from rotedu.edition.claims import CLAIMS
from rotedu.edition.equations import EQUATIONS
from rotedu.edition.errata import ERRATA

PAPER = ROOT / "paper" / "paper.md"
FILES = ("CITATION.cff", ".zenodo.json", "pyproject.toml", "paper/paper.md")
VERSIONED = ("CHANGELOG.md", "CITATION.cff", "book/run-a-class.md")
CITATION = ROOT / "CITATION.cff"


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """A copy of all files that name the version."""
    for file in VERSIONED:
        (tmp_path / file).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / file, tmp_path / file)
    return tmp_path


def test_the_authors_are_the_same_everywhere() -> None:
    """The citation, the package, the record in the archive and the paper name them."""
    citation, archive, project, paper = ((ROOT / file).read_text("utf-8") for file in FILES)
    names = [
        author.get("name") or f"{author['given-names']} {author['family-names']}"
        for author in yaml.safe_load(citation)["authors"]
    ]
    creators = [author["name"].split(", ") for author in json.loads(archive)["creators"]]
    assert [" ".join(reversed(name)) for name in creators] == names
    for authors in (
        tomllib.loads(project)["project"]["authors"],
        yaml.safe_load(paper.split("---")[1])["authors"],
    ):
        assert [author["name"] for author in authors] == names


def test_the_version_of_the_package_is_named_everywhere(copy: Path) -> None:
    derive_version(copy, rotedu.__version__)
    for file in VERSIONED:
        written = (copy / file).read_text("utf-8") == (ROOT / file).read_text("utf-8")
        assert written, f"{file} is not up to date: run .venv/bin/python tools/derive.py"


def test_a_new_version_is_named_everywhere_with_its_date(copy: Path) -> None:
    changes = copy / "CHANGELOG.md"
    changes.write_text(f"## [2.3.4] - 2027-01-31\n\n{changes.read_text('utf-8')}", "utf-8")
    derive_version(copy, "2.3.4")
    derive_version(copy, "2.3.4")
    citation = yaml.safe_load((copy / "CITATION.cff").read_text("utf-8"))
    assert citation["version"] == "2.3.4"
    assert str(citation["date-released"]) == "2027-01-31"
    commands = (copy / "book/run-a-class.md").read_text("utf-8")
    assert set(re.findall(r"rotedu-([^-]+)-py3-none-any\.whl", commands)) == {"2.3.4"}
    # One that has not been released yet has no date.
    derive_version(copy, "2.4.0")
    citation = yaml.safe_load((copy / "CITATION.cff").read_text("utf-8"))
    assert citation["version"] == "2.4.0"
    assert "date-released" not in citation


def test_the_archive_says_what_the_citation_says() -> None:
    citation = yaml.safe_load(CITATION.read_text("utf-8"))
    record = json.loads((ROOT / ".zenodo.json").read_text("utf-8"))
    for name in ("title", "keywords", "license"):
        assert record[name] == citation[name]
    assert record["description"].startswith(citation["abstract"])
    [paper] = citation["references"]
    assert record["related_identifiers"][0]["identifier"] == paper["doi"]


def test_the_paper_is_short_and_counts_what_is_there() -> None:
    text = PAPER.read_text("utf-8").split("---", 2)[2]
    assert len(text.split()) <= 1000
    mended = sum(erratum.kind != "open" for erratum in ERRATA)
    for number, thing in (
        (len(EQUATIONS), "numbered equations"),
        (len(CLAIMS), "claims"),
        (mended, "errata"),
        (len(captions_by_hand()), "figures can be moved by hand"),
    ):
        assert f"{number} {thing}" in text, f"{number} {thing}"


def test_the_paper_cites_what_it_lists() -> None:
    cited = set(re.findall(r"@([a-z]+\d{4})", PAPER.read_text("utf-8")))
    library = (ROOT / "paper" / "paper.bib").read_text("utf-8")
    assert cited == set(re.findall(r"(?m)^@\w+\{(.+),$", library))


def test_both_bibliographies_agree() -> None:
    entries = [
        dict(re.findall(r"(?ms)^@\w+\{(\w+),\n(.*?)^\}$", (ROOT / file).read_text("utf-8")))
        for file in ("paper/paper.bib", "book/references.bib")
    ]
    paper, book = entries
    for key in paper.keys() & book.keys():
        assert paper[key] == book[key], key


def test_without_a_repository_no_page_leads_there(book: Path) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    if not project["tool"]["rotedu"]["repository"]:
        found = [page for page in book.rglob("*.html") if parse(page).select(".report, .source")]
        assert not found
        # What is handed out, too.
        for notebook in (book / "_static" / "notebooks").iterdir():
            assert not re.search("mybinder|colab|github", notebook.read_text("utf-8"))


@pytest.mark.slow
def test_a_page_leads_to_its_source_and_a_report_says_page_and_section(
    tmp_path: Path, browser: Any
) -> None:
    address = "https://github.example/someone/rotedu"
    setting = "    add_module_names: false\n"
    html = build_one_page(tmp_path, setting, f"{setting}    repository: {address}\n")
    form = yaml.safe_load((ROOT / ".github/ISSUE_TEMPLATE/mistake.yml").read_text("utf-8"))
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    page.goto((html / "book" / "01-introduction.html").as_uri())
    assert page.locator(".bottom-of-page a.source").get_attribute("href") == address
    section = page.locator("article h2").nth(2)
    title = section.inner_text().rstrip("#").strip()
    section.evaluate("e => e.scrollIntoView({block: 'start', behavior: 'instant'})")
    page.route("**/issues/new**", lambda route: route.fulfill(body="asked"))
    page.locator(".toc-drawer a.report").click()
    page.wait_for_url("**/issues/new**")
    asked = urlsplit(page.url)
    page.close()
    assert f"{asked.scheme}://{asked.netloc}{asked.path}" == f"{address}/issues/new"
    fields = parse_qs(asked.query)
    assert fields.keys() == {"template", "place"}
    assert fields["template"] == ["mistake.yml"]
    assert "place" in {field.get("id") for field in form["body"]}
    assert fields["place"] == [f"1 Introduction, § {title}"]


@pytest.mark.slow
def test_the_citation_is_valid() -> None:
    command = [find_uv_bin(), "tool", "run", "cffconvert", "--validate", "-i", str(CITATION)]
    subprocess.run(command, check=True)
