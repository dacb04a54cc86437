"""The load test: what it computes, and, slowly, a class on a real JupyterHub."""

import json
import sys
from dataclasses import replace
from pathlib import Path

import class_load
import pytest
from class_load import PAGE, RESULTS, Run, Sample, busy_share, limit, table

STORED = [Run(**run) for run in json.loads(RESULTS.read_text("utf-8"))]


def test_busy_share_ends_with_the_last_first_figure() -> None:
    samples = [
        Sample(time=t, busy=b, free=0) for t, b in [(0, 100), (5, 102), (10, 110), (20, 130)]
    ]
    assert busy_share(samples, end=12, processors=2) == 10 / 10 / 2


@pytest.mark.parametrize(
    ("busy", "free", "named"),
    [
        (0.99, 0.5, "processors"),
        (0.99, 0.05, "memory"),
        (0.5, 0.5, "the pace of the starts"),
    ],
)
def test_what_limits(busy: float, free: float, named: str) -> None:
    assert limit(replace(STORED[0], busy_share=busy, free_share=free)) == named


def test_the_stored_runs_are_those_of_a_whole_class() -> None:
    assert [(run.students, run.browsers, run.within) for run in STORED] == [(30, 3, 1), (30, 3, 60)]
    assert [run.failures for run in STORED] == [[], []]
    assert all(len(run.first_figure) == len(run.saved) == 30 for run in STORED)


def test_the_page_quotes_the_stored_runs() -> None:
    assert table(STORED) in PAGE.read_text("utf-8")


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="tried on Linux alone")
@pytest.mark.parametrize("within", [1, 60])
def test_thirty_students_at_once(within: float, installed: Path) -> None:
    run = class_load.hold_class(installed, students=30, browsers=3, within=within)
    print(table([run]))
    assert run.failures == []


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A hub and what the notebooks need."""
    folder = tmp_path_factory.mktemp("class")
    class_load.prepare(folder)
    return folder
