"""The claims of the paper: none is missing, and each is shown where it says."""

import re
from typing import Any, get_args

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


def listed() -> str:
    """The tables on the page of all claims."""
    cells = [block.body.splitlines() for block in pages()["claims.md"].all("code-cell")]
    names: dict[str, Any] = {}
    exec("\n".join(line for *imports, _ in cells for line in imports), names)
    return "\n".join(eval(table, names).markdown for *_, table in cells)


def test_claims_are_numbered_without_gaps() -> None:
    assert [claim.number for claim in CLAIMS] == list(range(1, len(CLAIMS) + 1))


def test_every_verdict_is_explained() -> None:
    assert tuple(VERDICTS) == get_args(Verdict)
    assert all(f"**{word}**" in verdict_table().markdown for word in VERDICTS)


def test_every_part_of_the_paper_has_its_claims() -> None:
    assert {place for claim in CLAIMS for place in claim.where} == PLACES


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: str(claim.number))
def test_claim(claim: Claim) -> None:
    assert bool(claim.condition) == (claim.verdict == "holds under a condition")
    assert not any(text.endswith(".") for text in (claim.claim, claim.condition, claim.reason))
    assert "|" not in claim.claim + claim.condition + claim.reason
    # A slip is false by itself, and the errata have it under a number.
    assert not claim.slip or claim.verdict == "does not hold"
    assert not claim.slip or re.search(r"\bE\d", claim.reason)
    assert claim.claim[0].isupper() or claim.claim[0] in "($…"


def test_a_page_shows_each_claim_that_links_to_it() -> None:
    texts = {name: read(name) for name in CHAPTERS}
    for claim in CLAIMS:
        assert re.search(rf"\| {claim.number} \| .* \| [✓~×?] \*\*", texts[claim.chapter])


def test_table_has_a_row_for_each_claim_that_is_asked_for() -> None:
    heads, _, *rows = claim_table([2, 25]).markdown.splitlines()
    assert heads.count(" | ") == 4
    assert [row.split(" | ")[0] for row in rows] == ["| [2]{#claim-2}", "| [25]{#claim-25}"]
    assert all(row.count(" | ") == 4 for row in rows)


def test_a_reason_follows_the_verdict_and_its_condition() -> None:
    judged = Claim(1, "A", ("1",), "holds under a condition", "05-arcs", "so", "why").judgement
    assert judged == "~ **holds under a condition**: if so; why"
    false = Claim(1, "A", ("1",), "does not hold", "05-arcs", reason="why")
    assert false.judgement == "× **does not hold**: why"
    assert Claim(1, "A", ("1",), "holds", "05-arcs").judgement == "✓ **holds**"


def test_evidence_stands_beside_the_verdict_and_has_links() -> None:
    lines = evidence_table({42: "proved", 19: "see (5-2) and E4b"}).markdown.splitlines()
    equal, visible = (line.split(" | ") for line in lines[2:])
    assert equal[0] == "| 42"
    assert equal[1].startswith("[(3-1)](#eq-3-1), [(3-2)](#eq-3-2)")
    assert equal[2:] == ["✓ **holds**", "proved |"]
    assert visible[1].endswith(" (not claimed)")
    assert visible[3] == "see [(5-2)](#eq-5-2) and [E4b](#erratum-e4b) |"


def test_verdicts_are_counted_with_and_without_what_the_paper_does_not_say() -> None:
    rows = [row.strip("| ").split(" | ") for row in verdict_table().markdown.splitlines()[2:]]
    given, of_paper = (list(map(int, column)) for column in list(zip(*rows, strict=True))[2:])
    assert sum(given) == len(CLAIMS)
    assert given[0] == len(HOLD)
    beside = [c for c in CLAIMS if {"folklore", "not claimed"} & set(c.where)]
    assert beside
    assert sum(of_paper) == len(CLAIMS) - len(beside)
    assert of_paper[0] == len(HOLD) - sum(c.verdict == "holds" for c in beside)


def test_the_page_of_claims_lists_each_claim_once() -> None:
    rows = re.findall(r"^\| \[(\d+)\]\{#claim-(\d+)\} \| ", listed(), re.MULTILINE)
    assert all(number == target for number, target in rows)
    assert sorted(int(number) for number, _ in rows) == [claim.number for claim in CLAIMS]


def test_the_page_of_claims_says_why_where_a_claim_does_not_simply_hold() -> None:
    bare = re.findall(r"^\| \[(\d+)\].* \| .*\*\* \| ", listed(), re.MULTILINE)
    assert bare
    assert set(map(int, bare)) <= HOLD
