"""The record of the paper: what is numbered is on a page, and the citation agrees with the book."""

import functools
import importlib
import inspect
import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import pytest
import yaml
from derive import ROOT, derive_version
from html_pages import build_one_page, parse
from notebook_language import captions_by_hand, chapters, pages, tags
from uv import find_uv_bin

import rotedu
from rotedu.edition import claims, equations, errata
from rotedu.edition.claims import CHAPTERS, CLAIMS, Claim, verdict_table
from rotedu.edition.equations import EQUATIONS, FIGURES
from rotedu.edition.errata import ERRATA

PAPER = ROOT / "paper" / "paper.md"
VERSIONED = ("CITATION.cff", "book/run-a-class.md", "CHANGELOG.md")
CITATION = ROOT / "CITATION.cff"
LABELS = [row.label for row in (*EQUATIONS, *FIGURES, *ERRATA)]
LABEL = re.compile(r"(eq|figure|erratum)-")
LINK = re.compile(r"\]\(#([\w-]+)\)")


def tables() -> Iterator[list[str]]:
    """The lines of the tables that pages show."""
    names = vars(claims) | vars(equations) | vars(errata)
    for page in ("equations.md", "errata.ipynb", "claims.md"):
        source = "\n".join(cell.source for cell in pages()[page].cells)
        for call in re.findall(r"^\w+_table\(.*\)$", source, re.MULTILINE):
            yield repr(eval(call, names)).splitlines()


def sections() -> dict[str, str]:
    """The sections of the errata by their labels, and in each whether a cell prints something."""
    told = (
        cell.source
        if cell.cell_type == "markdown"
        else "[printed]" * any("text" in output for output in cell.outputs)
        for cell in pages()["errata.ipynb"].cells
    )
    _, *parts = re.split(r"^\(([\w-]+)\)=\n+", "\n".join(told), flags=re.MULTILINE)
    return dict(zip(parts[::2], parts[1::2], strict=True))


def function(name: str) -> Callable[..., Any]:
    """Import the object with a dotted name inside the package."""
    module, *path = name.split(".")
    result: Any = functools.reduce(getattr, path, importlib.import_module(f"rotedu.{module}"))
    assert callable(result)
    return result


def test_nothing_is_missing() -> None:
    numbered = {2: 6, 3: 3, 4: 7, 5: 15}
    equations = [f"{section}-{k}" for section, n in numbered.items() for k in range(1, n + 1)]
    assert [row.number for row in EQUATIONS] == equations
    assert [row.number for row in FIGURES] == list(range(1, 9))
    assert [claim.number for claim in CLAIMS] == list(range(1, len(CLAIMS) + 1))
    places = {"title", "abstract", *"123456", "folklore", "not claimed"}
    assert {place for claim in CLAIMS for place in claim.where} == places


def test_each_equation_figure_and_erratum_is_in_one_place() -> None:
    anchors = (block.anchor for page in pages().values() for block in page.blocks)
    assert Counter(filter(LABEL.match, anchors)) == Counter(LABELS)


def test_pictures_and_exercises_are_numbered_as_they_are_read() -> None:
    pictures = [
        block.title.removeprefix("Picture ").split("-")
        for page in chapters()
        for block in page.all("caption")
        if block.title.startswith("Picture")
    ]
    numbers = [number.split(".") for page in chapters() for number in page.exercises]
    for read, first in ((pictures, ord("a")), (numbers, 1)):
        for part in dict.fromkeys(part for part, _ in read):
            kept = [ord(k) if first > 1 else int(k) for of, k in read if of == part]
            assert kept == list(range(first, first + len(kept))), part


def test_each_row_is_in_a_table_and_its_links_lead_to_what_there_is() -> None:
    found = list(tables())
    assert all(line.count("|") == table[0].count("|") for table in found for line in table)
    rows = [row for table in found for row in table[2:]]
    firsts = [LINK.findall(row.split("|")[1]) for row in rows]
    assert Counter(label for label, *_ in filter(None, firsts)) == Counter(LABELS)
    assert {link for row in rows for link in LINK.findall(row)} <= {*LABELS, "likely-glitches"}
    numbers = re.findall(r"^\| \[(\d+)\]\{#claim-\1\} \|", "\n".join(rows), re.MULTILINE)
    assert Counter(map(int, numbers)) == Counter(claim.number for claim in CLAIMS)


def test_the_functions_say_what_they_do_and_scenes_need_no_arguments() -> None:
    for name in (name for row in EQUATIONS for name in row.functions):
        assert inspect.getdoc(function(name)), name
        module, public, *_ = name.split(".")
        assert public in importlib.import_module(f"rotedu.{module}").__all__, name
    for row in FIGURES:
        inspect.signature(function(row.function)).bind()


def test_each_equation_has_a_test_that_bears_its_number() -> None:
    tests = "\n".join(file.read_text("utf-8") for file in Path(__file__).parent.glob("test_*.py"))
    marks = re.findall(r"^ *@pytest\.mark\.equation\((.*)\)$", tests, re.MULTILINE)
    assert set(re.findall(r"\d-\d+", " ".join(marks))) == {row.number for row in EQUATIONS}


def test_what_does_not_simply_hold_says_why() -> None:
    for row in EQUATIONS:
        assert row.remark or row.status == "as printed", row
        if row.status == "corrected":
            assert re.search(r"\bE\d|\(#likely-glitches\)", row.remark), row
    for claim in CLAIMS:
        assert bool(claim.condition) == (claim.verdict == "holds under a condition"), claim
        assert claim.verdict == "holds" or claim.condition or claim.reason, claim
        # A slip is false by itself, and the errata have it under a number.
        if claim.slip:
            assert claim.verdict == "does not hold", claim
            assert re.search(r"\bE\d", claim.reason), claim


def test_a_page_shows_each_claim_that_links_to_it() -> None:
    tables = {
        name: output.data["text/markdown"]
        for name in CHAPTERS
        for cell in pages()[f"{name}.ipynb"].cells
        for output in (cell.outputs if "claims" in tags(cell) else [])
    }
    for claim in CLAIMS:
        row = rf"\| [✓~×?] \*\*{claim.verdict}\*\* \| .*\(#claim-{claim.number}\)"
        assert re.search(row, tables[claim.chapter]), claim


def test_a_reason_follows_the_verdict_and_its_condition() -> None:
    judged = Claim(1, "A", ("1",), "holds under a condition", "05-arcs", "so", "why").judgement
    assert judged == "~ **holds under a condition**: if so; why"
    assert Claim(1, "A", ("1",), "holds", "05-arcs").judgement == "✓ **holds**"


def test_verdicts_are_counted_with_and_without_what_the_paper_does_not_say() -> None:
    rows = [row.strip("| ").split(" | ") for row in verdict_table().markdown.splitlines()[2:]]
    given, of_paper = (list(map(int, column)) for column in list(zip(*rows, strict=True))[2:])
    beside = [c for c in CLAIMS if {"folklore", "not claimed"} & set(c.where)]
    assert (sum(given), sum(of_paper)) == (len(CLAIMS), len(CLAIMS) - len(beside))
    assert given[0] == sum(claim.verdict == "holds" for claim in CLAIMS)
    assert of_paper[0] == given[0] - sum(claim.verdict == "holds" for claim in beside)


def test_an_erratum_says_what_is_printed_what_is_right_and_what_it_changes() -> None:
    texts = sections()
    assert list(filter(LABEL.match, texts)) == [row.label for row in ERRATA]
    for row in ERRATA:
        text = texts[row.label]
        assert text.startswith(f"## {row.number}. {row.title}\n"), row
        for part in ("**As printed.**", "**What it should be.**", "**What it changes.**"):
            assert text.count(part) == 1, (row, part)
        chapters = re.findall(r"\]\((\d\d-[\w-]+\.ipynb)\)", text)
        computed_there = any(f"](#{row.label})" in pages()[chapter].text for chapter in chapters)
        assert "[printed]" in text or computed_there, row


def test_a_box_in_the_colour_of_errata_links_to_one() -> None:
    boxes = [box for page in pages().values() for box in page.boxes("erratum")]
    assert len(boxes) > 10
    assert all("](#erratum-e" in box.body for box in boxes)


def test_the_authors_are_the_same_everywhere() -> None:
    """The citation, the package, the record in the archive and the paper name them."""
    files = ("CITATION.cff", ".zenodo.json", "pyproject.toml", "paper/paper.md")
    citation, archive, project, paper = ((ROOT / file).read_text("utf-8") for file in files)
    names = [
        author.get("name") or f"{author['given-names']} {author['family-names']}"
        for author in yaml.safe_load(citation)["authors"]
    ]
    creators = [author["name"].split(", ") for author in json.loads(archive)["creators"]]
    assert [" ".join(reversed(name)) for name in creators] == names
    assert [author["name"] for author in tomllib.loads(project)["project"]["authors"]] == names
    authors = yaml.safe_load(paper.split("---")[1])["authors"]
    assert [author["name"] for author in authors] == names


def test_the_version_of_the_package_is_named_everywhere_with_its_date(tmp_path: Path) -> None:
    for file in VERSIONED:
        (tmp_path / file).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / file, tmp_path / file)
    derive_version(tmp_path, rotedu.__version__)
    changes = tmp_path / "CHANGELOG.md"
    newest = re.search(r"(What version |## \[)(\d+\.\d+\.\d+)", changes.read_text("utf-8"))
    assert newest[2] == rotedu.__version__
    for file in VERSIONED[:2]:
        written = (tmp_path / file).read_text("utf-8") == (ROOT / file).read_text("utf-8")
        assert written, f"{file} is not up to date: run .venv/bin/python tools/derive.py"
    changes.write_text(f"## [2.3.4] - 2027-01-31\n\n{changes.read_text('utf-8')}", "utf-8")
    derive_version(tmp_path, "2.3.4")
    derive_version(tmp_path, "2.3.4")
    citation = yaml.safe_load((tmp_path / "CITATION.cff").read_text("utf-8"))
    assert citation["version"] == "2.3.4"
    assert str(citation["date-released"]) == "2027-01-31"
    commands = (tmp_path / "book/run-a-class.md").read_text("utf-8")
    assert set(re.findall(r"rotedu-([^-]+)-py3-none-any\.whl", commands)) == {"2.3.4"}
    # One that has not been released yet has no date.
    derive_version(tmp_path, "2.4.0")
    citation = yaml.safe_load((tmp_path / "CITATION.cff").read_text("utf-8"))
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
    counted = {
        "numbered equations": len(EQUATIONS),
        "claims": len(CLAIMS),
        "errata": sum(erratum.kind != "open" for erratum in ERRATA),
        "figures can be moved by hand": len(captions_by_hand()),
    }
    assert [what for what, number in counted.items() if f"{number} {what}" not in text] == []


def test_the_paper_cites_what_it_lists() -> None:
    cited = set(re.findall(r"@([a-z]+\d{4})", PAPER.read_text("utf-8")))
    library = (ROOT / "paper" / "paper.bib").read_text("utf-8")
    assert cited == set(re.findall(r"(?m)^@\w+\{(.+),$", library))


def test_both_bibliographies_agree() -> None:
    paper, book = (
        dict(re.findall(r"(?ms)^@\w+\{(\w+),\n(.*?)^\}$", (ROOT / file).read_text("utf-8")))
        for file in ("paper/paper.bib", "book/references.bib")
    )
    shared = paper.keys() & book.keys()
    assert {key: paper[key] for key in shared} == {key: book[key] for key in shared}


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
    # Contents of one page give it no short name.
    name = page.locator("article h1").inner_text().rstrip("#").strip()
    section = page.locator("article h2").nth(2)
    title = section.inner_text().rstrip("#").strip()
    section.evaluate("e => e.scrollIntoView({block: 'start', behavior: 'instant'})")
    page.route("**/issues/new**", lambda route: route.fulfill(body="asked"))
    page.locator(".toc-tree").hover()
    page.locator(".toc-drawer a.report").click()
    page.wait_for_url("**/issues/new**")
    asked = urlsplit(page.url)
    page.close()
    assert f"{asked.scheme}://{asked.netloc}{asked.path}" == f"{address}/issues/new"
    fields = parse_qs(asked.query)
    assert fields.keys() == {"template", "place"}
    assert fields["template"] == ["mistake.yml"]
    assert "place" in {field.get("id") for field in form["body"]}
    assert fields["place"] == [f"{name}, § {title}"]


@pytest.mark.slow
def test_the_citation_is_valid() -> None:
    command = [find_uv_bin(), "tool", "run", "cffconvert", "--validate", "-i", str(CITATION)]
    subprocess.run(command, check=True)


def test_the_search_keeps_the_numbers_of_pages_that_stay(tmp_path: Path) -> None:
    for name, number in (("index", "1-1"), ("other", "1-2")):
        page = f":orphan:\n\n{name}\n=====\n\n.. math:: a\n   :label: eq-{number}\n\n"
        (tmp_path / f"{name}.rst").write_text(page)
    extension = ["-C", "-D", "extensions=paper_numbers", tmp_path, tmp_path / "built"]
    environment = os.environ | {"PYTHONPATH": str(ROOT / "book" / "_ext")}
    for changed in ("", "A word more.\n"):
        with (tmp_path / "index.rst").open("a") as index:
            index.write(changed)
        command = [sys.executable, "-m", "sphinx", "-q", *extension]
        subprocess.run(command, env=environment, check=True)
        built = (tmp_path / "built" / "searchindex.js").read_text("utf-8")
        entries = re.search(r'"indexentries": ?\{(.*?)\}', built)[1]
        assert re.findall(r'"(\d-\d)":', entries) == ["1-1", "1-2"]
