"""The claims of the paper: none is missing, and each is shown where it says."""

import re
from typing import get_args

import pytest
from notebook_language import pages
from reading_time import shown

from rotedu.edition.claims import (
    CHAPTERS,
    CLAIMS,
    VERDICTS,
    Claim,
    Verdict,
    claim_table,
    evidence_table,
    verdict_table,
)

PLACES = {"title", "abstract", *"123456", "folklore", "not claimed"}
HOLD = {claim.number for claim in CLAIMS if claim.verdict == "holds"}


def read(chapter: str) -> str:
    """What a reader sees of a chapter."""
    return "\n".join(block.source for block in shown(pages()[f"{chapter}.ipynb"]))


def test_claims_are_numbered_without_gaps() -> None:
    assert [claim.number for claim in CLAIMS] == list(range(1, len(CLAIMS) + 1))


def test_every_verdict_is_explained() -> None:
    assert tuple(VERDICTS) == get_args(Verdict)
    assert all(f"**{word}**" in verdict_table().markdown for word in VERDICTS)


def test_every_part_of_the_paper_has_its_claims() -> None:
    assert {place for claim in CLAIMS for place in claim.where} == PLACES


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: str(claim.number))
def test_claim(claim: Claim) -> None:
    assert claim.verdict in get_args(Verdict)
    assert set(claim.where) <= PLACES
    assert bool(claim.condition) == (claim.verdict == "holds under a condition")
    assert not claim.condition.endswith(".")
    assert "|" not in claim.condition
    assert claim.claim[0].isupper() or claim.claim[0] in "($…"
    assert not claim.claim.endswith(".")
    assert "|" not in claim.claim
    assert claim.chapter in CHAPTERS


@pytest.mark.parametrize("chapter", sorted({claim.chapter for claim in CLAIMS}))
def test_chapter_is_listed(chapter: str) -> None:
    assert f"{chapter}.ipynb" in pages()


def test_a_page_shows_each_claim_that_links_to_it() -> None:
    texts = {name: read(name) for name in CHAPTERS}
    row = r"\| {} \| .* \| \*\*"
    missing = [
        claim.number
        for claim in CLAIMS
        if not re.search(row.format(claim.number), texts[claim.chapter])
    ]
    assert missing == []


def test_the_first_page_answers_the_title() -> None:
    assert "**Do we need quaternions?**" in pages()["index.md"].text


def test_table_has_a_row_for_each_claim_that_is_asked_for() -> None:
    lines = claim_table([2, 25], {2: "counted", 25: "counted, too", 26: "not asked for"})
    heads, _, *rows = lines.markdown.splitlines()
    assert heads.count(" | ") == 4
    assert [row.split(" | ")[0] for row in rows] == ["| 2", "| 25"]
    assert all(row.count(" | ") == 4 for row in rows)


def test_a_reason_follows_the_verdict_and_its_condition() -> None:
    _, _, two, three, five = claim_table([2, 3, 5], {2: "why", 5: "why"}).markdown.splitlines()
    assert two.split(" | ")[3] == "**does not hold**: why"
    assert three.split(" | ")[3] == "**does not hold**"
    assert five.split(" | ")[3] == f"{CLAIMS[4].judgement}; why"


def test_evidence_stands_beside_the_verdict_and_has_links() -> None:
    lines = evidence_table({42: "proved", 19: "see (5-2) and E4b"}).markdown.splitlines()
    equal, visible = (line.split(" | ") for line in lines[2:])
    assert equal[0] == "| 42"
    assert equal[1].startswith("[(3-1)](#eq-3-1), [(3-2)](#eq-3-2)")
    assert equal[2:] == ["**holds**", "proved |"]
    assert visible[1].endswith(" (not claimed)")
    assert visible[3] == "see [(5-2)](#eq-5-2) and [E4b](#erratum-e4b) |"


def test_verdicts_are_counted_without_what_the_paper_does_not_say() -> None:
    told = [row.split(" | ")[2].strip(" |") for row in verdict_table().markdown.splitlines()[2:]]
    beside = [c for c in CLAIMS if {"folklore", "not claimed"} & set(c.where)]
    assert sum(map(int, told)) == len(CLAIMS) - len(beside)
    assert int(told[0]) + sum(c.verdict == "holds" for c in beside) == len(HOLD)


def test_chapter_6_lists_each_claim() -> None:
    conclusions = read("06-conclusions")
    missing = [row.number for row in CLAIMS if f"| {row.number} | " not in conclusions]
    assert missing == []


def test_chapter_6_says_why_where_a_claim_does_not_simply_hold() -> None:
    bare = re.findall(r"^\| (\d+) \| .*\*\* \| ", read("06-conclusions"), re.MULTILINE)
    assert bare
    assert set(map(int, bare)) <= HOLD


def test_without_numbers_all_claims_are_listed() -> None:
    lines = claim_table().markdown.splitlines()
    assert len(lines) == 2 + len(CLAIMS)
    assert all(line.count(" | ") == 4 for line in lines)
