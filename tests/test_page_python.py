"""The Python of the pages: what a notebook stores comes out there, too, and answers are judged."""

import inspect
import json
import re
import zipfile
from pathlib import Path
from typing import Any

import pytest
import test_exercises
import test_right_answers
from bs4 import BeautifulSoup, Tag
from html_pages import build_one_page, parse
from nbformat import NotebookNode
from node import run_node
from notebook_language import BOOK, ROOT, Page, notebooks, part_of, tags
from runtime import CANNOT_WORK, put_together

SCRIPT = "page_python/page_python.js"
EXPLORED = re.compile(r"\bexplore\(scenes\.(\w+)")
# Lets the page's Python read the tests of the checks.
STAND_INS = """\
import sys
from unittest.mock import MagicMock

for name in ("pytest", "notebook_language"):
    sys.modules[name] = MagicMock()
sys.modules["pytest"].mark.parametrize = lambda *_, **__: lambda test: test
"""
# What the conventions say of the Python of a page; no word comes of the division.
FACTS = """\
import platform
import numpy as np
import matplotlib.pyplot as plt
versions = np.__version__, plt.matplotlib.__version__
print(platform.python_version(), *versions, np.arange(1, 14).prod())
with np.errstate(all="raise"):
    np.ones(1) / 0
"""
JUDGE = """\
for number, answer, hint in WRONG:
    test_a_wrong_answer_hears_what_is_wrong(number, answer, hint)
for number, answer in RIGHT:
    test_a_right_answer_passes_in_every_form(number, answer)
for number in EXERCISES:
    TestCheck().test_each_mistake_and_all_else_get_their_own_hints(number)
    TestCheck().test_says_what_it_expects(number)
"""
LACKS = (
    "NotInPage: {} is not in this page, which has NumPy, Matplotlib and rotedu alone."
    " It works in the notebook of the page, at a desk.\n"
)
IN_CELL = 'Traceback (most recent call last):\n  File "Cell 1", line {}, in <module>\n    {}\n'
# The figures of the page, and what the hand has set.
SHOWN: dict[str, Any] = {"arcs-of-arcs": {"u": 0.25, "length": 1}, "slerp-by-hand": {}}
EXPLORE = "from rotedu import scenes\nfrom rotedu.figures import explore\n"
LONG = "0" * 100_000 + "\n(cut here: it is longer)"
# What a reader may try, and what comes of it.
SAYS: dict[str, dict[str, Any]] = {
    "1 + 1": {"out": "", "value": "2", "kind": "text", "error": ""},
    "1 + 1;": {"out": "", "value": "", "kind": ""},
    "print(1)\nprint(2)\n3": {"out": "1\n2\n", "value": "3"},
    "def f(x):\n    return 1 / x\n\nf(0)": {
        "kind": "ZeroDivisionError",
        "error": IN_CELL.format(4, "f(0)")
        + '  File "Cell 1", line 2, in f\n    return 1 / x\n           ~~^~~\n'
        "ZeroDivisionError: division by zero\n",
    },
    "x = (1 +": {
        "error": '  File "Cell 1", line 1\n    x = (1 +\n        ^\n'
        "SyntaxError: '(' was never closed\n"
    },
    # Of the package nothing is shown.
    "from rotedu.closed_curve import closed_curve\nclosed_curve([[1, 0, 0]])": {
        "error": IN_CELL.format(2, "closed_curve([[1, 0, 0]])")
        + "ValueError: points must number at least 3 to make a closed curve; got 1\n"
    },
    "print('0' * 10**6)": {"out": LONG, "error": ""},
    "print('0' * 10**5)": {"out": LONG},
    "class Long:\n    def __repr__(self):\n        return '0' * 10**6\n\nLong()": {"value": LONG},
    "import sys\nsys.stdout.close()\nprint(1)": {"out": "1\n", "error": ""},
    "import sys\nsys.stderr.write('1')": {"out": "1"},
    "import sys\nsys.exit(1)": {"kind": "SystemExit"},
    "def f():\n    f()\n\nf()": {"kind": "RecursionError"},
    "import sys\nsys.setrecursionlimit(10**9)": {"error": ""},
    "a = []\nfor _ in range(10**5):\n    a = [a]\nrepr(a)": {"kind": "RecursionError"},
    "import pandas": {"error": IN_CELL.format(1, "import pandas") + LACKS.format("pandas")},
    "import scipy.linalg": {"error": ""},
    "from scipy.linalg import expm\nexpm(0)": {
        "error": IN_CELL.format(2, "expm(0)") + LACKS.format("scipy.linalg.expm")
    },
    "import matplotlib.pyplot as plt\nplt.style.use('rotedu.book')": {"error": "", "charts": []},
    "import pyvista\npyvista.Plotter().add_mesh(1)": {"kind": "NotInPage"},
    "try:\n    import pandas\nexcept ImportError:\n    print(1)": {"out": "1\n"},
    "input('name')": {"error": IN_CELL.format(1, "input('name')") + LACKS.format("input()")},
    "%timeit 1 + 1": {"error": LACKS.format("%timeit")},
    "!ls": {"error": LACKS.format("!ls")},
    "%config InlineBackend.figure_format = 'svg'\n1": {"value": "1"},
    "from numpy import *\nlinalg.norm([3, 4])": {"value": "np.float64(5.0)"},
    # Integers have 32 bits, and an overflow passes without a word.
    "import numpy as np\nnp.array([2**31 - 1]) + 1": {"value": "array([-2147483648])"},
    "import numpy as np\nnp.zeros(10**9)": {"kind": "ValueError"},
    "from rotedu.edition.exercises import check\ncheck('3.2', ...);": {
        "verdict": {"number": "3.2", "right": None, "text": "not answered yet."}
    },
    "from rotedu import scenes\nscenes.figure_1().show()": {"value": "", "error": ""},
    EXPLORE + "explore(scenes.arcs_of_arcs).u": {"value": "0.25", "changed": {}},
    EXPLORE + "figure = explore(scenes.arcs_of_arcs)\nfigure.u = 1\nfigure.u": {
        "value": "1.0",
        "changed": {"arcs-of-arcs": {"u": 1.0}},
    },
    EXPLORE + "explore(scenes.slerp_by_hand)": {"value": "", "changed": {}},
}
PLOT = "import matplotlib.pyplot as plt\n"
# Charts of a reader, and what their elements are, among others.
CHARTS = {
    PLOT + "plt.hist([1, 1, 2])": "path",
    PLOT + "plt.imshow([[0, 1], [1, 0]])": "image",
    PLOT + "plt.title('$\\\\theta^2$')\nplt.show()": "tspan",
    PLOT + "plt.title('<script>1</script>')": "text",
    PLOT + "plt.title('x').set_url('javascript:alert(1)')": "text",
    "from matplotlib import pyplot\nclass Own(pyplot.Figure):\n    pass\n\n"
    "pyplot.figure(FigureClass=Own)": "svg",
    "from pylab import *\nplot([1])": "svg",
    "import matplotlib\nassert matplotlib.__version__\nmatplotlib.pyplot.gcf()": "svg",
    PLOT + "plt.bar([1], [1], hatch='x', color='gold')": "pattern",
    PLOT
    + "from datetime import date\nplt.plot([date(2024, 1, 1), date(2024, 3, 1)], [1, 2])": "text",
    PLOT + "plt.title('$\\\\frac$')\n1 / 0": "",
    # None that nobody shows, or that comes before an error.
    "from matplotlib.figure import Figure\nFigure().subplots()": "",
    PLOT + "plt.plot([1])\n1 / 0": "",
}
Done = dict[str, list[dict[str, Any]]]


def stored(cell: NotebookNode) -> tuple[str, str]:
    """What a notebook stores of a cell: what is printed, and the value of the last line."""
    out = "".join(o.text for o in cell.outputs if o.output_type == "stream")
    data = next((o.data for o in cell.outputs if o.output_type == "execute_result"), {})
    return out, data.get("text/markdown", data.get("text/plain", ""))


def words(*elements: Tag) -> list[str]:
    """The texts of drawings, in any order."""
    return sorted(text.get_text() for element in elements for text in element.select("text"))


def in_order(page: Page) -> list[NotebookNode]:
    """Return the cells of a page: text, charts, exercises, and at the end what needs a desk.

    When it runs the cells above one, a page leaves out all but text.
    """

    def later(cell: NotebookNode) -> int:
        alone = part_of(cell.id)[0] or "try" in tags(cell)
        return 3 if "desk" in tags(cell) else 2 if alone else "plt.subplots" in cell.source

    return sorted(page.code, key=later)


def figures(page: Page) -> dict[str, Any]:
    """Return the figures of a page that answer the hand; nobody has touched one."""
    shown = [name for cell in page.code for name in EXPLORED.findall(cell.source)]
    return {name.replace("_", "-"): {} for name in shown}


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> Done:
    """Run everything in the page's Python, each list of cells in a namespace of its own."""
    cells: dict[str, Any] = {
        page.name: {"figures": figures(page), "cells": [c.source for c in in_order(page)]}
        for page in notebooks()
    }
    cells |= {code: {"figures": SHOWN, "cells": [code]} for code in (*SAYS, *CHARTS)}
    tests = [inspect.getsource(module) for module in (test_exercises, test_right_answers)]
    cells["facts"] = {"figures": {}, "cells": [FACTS]}
    cells["answers"] = {"figures": {}, "cells": [STAND_INS, *tests, JUDGE]}
    folder = tmp_path_factory.mktemp("live")
    cases, answers = folder / "cases.json", folder / "answers.json"
    cases.write_text(json.dumps(list(cells.values())), encoding="utf-8")
    run_node("tools/page_python.mjs", str(put_together()), str(answers), str(cases))
    return dict(zip(cells, json.loads(answers.read_text("utf-8")), strict=True))


def test_the_conventions_say_what_runs(done: Done) -> None:
    [facts] = done["facts"]
    assert facts["error"] == ""
    said = (BOOK / "conventions.md").read_text("utf-8").replace(" ", "")
    for fact in facts["out"].split():
        assert fact in said


@pytest.mark.parametrize("page", notebooks(), ids=repr)
def test_a_cell_prints_what_the_notebook_stores_or_needs_a_desk(page: Page, done: Done) -> None:
    for cell, ran in zip(in_order(page), done[page.name], strict=True):
        if "desk" in tags(cell):
            assert ran["kind"] == "NotInPage", cell.id
            continue
        assert ran["error"] == "", cell.id
        if "nbval-ignore-output" not in tags(cell):
            assert (ran["out"], ran["value"]) == stored(cell), cell.id
        assert bool(ran["charts"]) == ("plt.subplots" in cell.source), cell.id


def test_a_page_has_the_package_but_for_what_draws() -> None:
    with zipfile.ZipFile(put_together() / "rotedu.zip") as archive:
        there = {name for name in archive.namelist() if name.startswith("rotedu/")}
        assert all(archive.read(name) == (ROOT / name).read_bytes() for name in there)
    modules = {file.relative_to(ROOT).as_posix() for file in ROOT.glob("rotedu/**/*.py")}
    assert modules - there == CANNOT_WORK


def test_every_answer_of_the_tests_gets_its_verdict_in_a_page(done: Done) -> None:
    assert [result["error"] for result in done["answers"]] == [""] * 4


@pytest.mark.parametrize("code", SAYS)
def test_what_a_reader_may_try_gets_an_answer(code: str, done: Done) -> None:
    [result] = done[code]
    for key, expected in SAYS[code].items():
        assert result[key] == expected, result["error"]


@pytest.mark.parametrize("code", CHARTS)
def test_a_reader_draws_charts_without_scripts_and_links(code: str, done: Done) -> None:
    [result] = done[code]
    drawn = BeautifulSoup("".join(result["charts"]), "html.parser")
    assert {element.name for element in drawn.find_all()} >= {*CHARTS[code].split()}
    assert bool(drawn.svg) == bool(CHARTS[code]), result["error"]
    assert not drawn.select("script, a")


@pytest.fixture(scope="module")
def pages(book: Path) -> dict[str, BeautifulSoup]:
    return {page.name: parse(page) for page in (book / "book").glob("*.html")}


def test_pages_mark_the_cells_that_run_and_the_exercises(pages: dict[str, BeautifulSoup]) -> None:
    for page in notebooks():
        soup = pages[f"{page.file.stem}.html"]
        unseen = {"desk", "remove-cell"}
        run = [cell.id for cell in page.code if not unseen & tags(cell)]
        assert [cell["data-cell"] for cell in soup.select(".cell[data-cell]")] == run
        asked = soup.select(".exercise[data-exercise]")
        assert [each["data-exercise"] for each in asked] == list(page.exercises)
        for each, exercise in zip(asked, page.exercises.values(), strict=True):
            cells = [cell["data-cell"] for cell in each.select("[data-cell]")]
            assert cells[0] == exercise.start.id
            assert each.p.get_text().startswith(f"Exercise {exercise.number} ")
            sections = len(each.find_parents("section"))
            name = each.select_one(f"[role=heading][aria-level='{sections + 1}']")
            assert name.get_text() == f"Exercise {exercise.number}"
            assert bool(each.select(".tag_hide-cell > details > p")) == bool(exercise.why)
            assert not each.select(".sd-dropdown")
        assert len(soup.select(f"script[src*='{SCRIPT}']")) == 1
    assert not pages["glossary.html"].select(f"script[src*='{SCRIPT}']")


@pytest.mark.slow
@pytest.mark.parametrize("page", notebooks(), ids=repr)
def test_a_chart_has_the_words_that_the_book_has(
    page: Page, done: Done, pages: dict[str, BeautifulSoup]
) -> None:
    ran = zip(in_order(page), done[page.name], strict=True)
    for cell, drawn in ((cell, "".join(each["charts"])) for cell, each in ran):
        stored = pages[f"{page.file.stem}.html"].select(f'[data-cell="{cell.id}"] .chart')
        assert words(BeautifulSoup(drawn, "html.parser")) == words(*stored), cell.id


@pytest.mark.slow
def test_one_setting_leaves_python_out(tmp_path: Path) -> None:
    html = build_one_page(tmp_path, "python_in_page: true", "python_in_page: false")
    page = (html / "book" / "01-introduction.html").read_text("utf-8")
    assert "Show the solution" in page
    assert not any(mark in page for mark in ("data-cell", "data-exercise", SCRIPT))
    assert not (html / "_static" / "page_python").exists()
    assert "Mozilla Public" not in (html / "_static" / "licences.txt").read_text("utf-8")
