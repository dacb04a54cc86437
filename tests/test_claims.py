"""The claims of the paper: none is missing, and each is judged on a page that exists."""

from pathlib import Path
from typing import get_args

import pytest

from rotedu.edition.claims import CHAPTERS, CLAIMS, Claim, Verdict, claim_table

BOOK = Path(__file__).parents[1] / "book"
PLACES = {"abstract", "1", "3", "4", "5", "6", "folklore", "not claimed"}


def test_claims_are_numbered_without_gaps() -> None:
    assert [claim.number for claim in CLAIMS] == list(range(1, 27))


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: str(claim.number))
def test_claim(claim: Claim) -> None:
    assert claim.verdict in get_args(Verdict)
    assert set(claim.where) <= PLACES
    assert claim.claim[0].isupper() or claim.claim[0] in "(…"
    assert not claim.claim.endswith(".")
    assert "|" not in claim.claim
    assert claim.chapter in CHAPTERS


@pytest.mark.parametrize("chapter", sorted({claim.chapter for claim in CLAIMS}))
def test_chapter_exists_and_is_listed(chapter: str) -> None:
    assert (BOOK / f"{chapter}.ipynb").exists()
    contents = BOOK.with_name("_toc.yml").read_text("utf-8")
    assert f"book/{chapter}\n" in contents


def test_table_has_a_row_for_each_claim_with_evidence() -> None:
    lines = claim_table({2: "counted", 25: "counted, too"}).markdown.splitlines()
    assert [line.split(" | ")[0] for line in lines[2:]] == ["| 2", "| 25"]
    assert all(line.count(" | ") == 5 for line in lines)


def test_chapter_6_gives_evidence_for_each_claim() -> None:
    conclusions = (BOOK / "06-conclusions.ipynb").read_text("utf-8")
    missing = [row.number for row in CLAIMS if f"| {row.number} | " not in conclusions]
    assert missing == []


def test_without_evidence_all_claims_are_listed() -> None:
    lines = claim_table().markdown.splitlines()
    assert len(lines) == 2 + len(CLAIMS)
    assert all(line.count(" | ") == 4 for line in lines)
