"""Python in the page, as readers meet it: they run and change cells, answer, stop and save."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import nbformat
import pytest
from live_pages import PHONE, Open, arrived, complaints_of_axe, figure_in, open_page
from nbformat import NotebookNode
from nightly import nightly
from notebook_language import notebooks, pages, tags

__all__ = ["open_page"]

# Milliseconds; Python starts in two or three seconds, and much later on a busy machine.
PATIENCE = 60_000
CURVE = "05-closed-curve"
ENDED = """id => ["done", "error"].includes(document.querySelector(
    `.cell[data-cell="${id}"]`).dataset.run)"""
HINT = "For a hint, press Check again."
KEYS = "Object.keys(localStorage).filter((key) => key.startsWith('rotedu-2:'))"
RUNNABLE = """[...document.querySelectorAll(".cell[data-cell]:has(button[name=run])")].map(
    (cell) => cell.dataset.cell)"""


SHOWN = "all => all.map((chart) => [chart.checkVisibility(), chart.ariaLabel])"
Read = Callable[..., "Reader"]


class Reader:
    """Somebody who reads a page, types into its cells and presses buttons."""

    def __init__(self, page: Any) -> None:
        self.page = page

    def cell(self, name: str) -> Any:
        return self.page.locator(f'.cell[data-cell="{name}"]')

    def button(self, name: str, within: str = "") -> Any:
        return self.page.locator(f"{within} button[name={name}]")

    def state(self, name: str) -> str:
        return str(self.cell(name).get_attribute("data-run"))

    def write(self, name: str, code: str) -> None:
        """Put code into a cell, as a reader does: click, select all, type."""
        fold = self.cell(name).locator("details:not([open]) > summary")
        if fold.count():
            fold.click()
        editor = self.cell(name).locator(".cm-content")
        if not editor.count():
            self.cell(name).locator(".cell_input pre").first.click()
        editor.focus()
        self.page.keyboard.press("ControlOrMeta+a")
        self.page.keyboard.insert_text(code)

    def press(self, name: str, button: str = "run") -> None:
        self.cell(name).locator(f"button[name={button}]").click()

    def wait(self, name: str) -> str:
        """Wait until a cell has come to its end, and return what it shows."""
        self.page.wait_for_function(ENDED, arg=name, timeout=PATIENCE)
        return self.output(name)

    def output(self, name: str) -> str:
        return "".join(self.cell(name).locator(".live-output").all_text_contents())

    def run(self, name: str, code: str | None = None) -> str:
        """Run a cell, changed or not, and return what it shows."""
        if code is not None:
            self.write(name, code)
        self.cell(name).evaluate("cell => { delete cell.dataset.run }")
        self.press(name)
        return self.wait(name)

    def message(self, name: str) -> str:
        return str(self.cell(name).locator(".live-message").text_content())

    def code(self, name: str) -> str:
        """What a listing or an editor shows."""
        shown = self.cell(name).locator(".cell_input :is(pre, .cm-content):visible").first
        return shown.inner_text().rstrip()

    def python(self) -> str:
        return str(self.page.locator("html").get_attribute("data-python"))

    def exercise(self, number: str) -> Any:
        return self.page.locator(f'.exercise[data-exercise="{number}"]')

    def verdict(self, number: str) -> tuple[str, str | None]:
        verdict = self.exercise(number).locator(".verdict")
        return verdict.text_content(), verdict.get_attribute("data-right")

    def check(self, number: str, answer: str | None = None) -> tuple[str, str | None]:
        """Answer an exercise in its cell, and return the verdict."""
        name = f"start-{number.replace('.', '-')}"
        if answer is not None:
            code = notebook_cell(number).source
            self.write(name, code.replace("answer = ...", f"answer = {answer}"))
        self.exercise(number).locator("button[name=check]").click()
        self.page.wait_for_function(
            "number => document.querySelector(`[data-exercise='${number}'] .verdict`).textContent",
            arg=number,
            timeout=PATIENCE,
        )
        return self.verdict(number)

    def fill(self, number: str, *numbers: str) -> tuple[str, str | None]:
        """Answer an exercise in its form, and return the verdict."""
        for field, text in zip(self.exercise(number).locator("input").all(), numbers, strict=True):
            field.fill(text)
        self.exercise(number).locator("button[name=check]").click()
        return self.verdict(number)

    def solved(self) -> str:
        return str(self.page.locator(".solved").text_content())


def notebook_cell(number: str) -> NotebookNode:
    """The starter cell of an exercise."""
    return next(page.exercises[number].start for page in notebooks() if number in page.exercises)


@pytest.fixture
def read(site: str, open_page: Open) -> Read:
    """Open a page of the book."""
    return lambda name=CURVE, **options: Reader(
        open_page(f"{site}/book/{name}.html", accept_downloads=True, **options)
    )


@pytest.fixture(scope="module")
def busy(browser: Any, site: str) -> Iterator[Reader]:
    """A page on which Python runs already."""
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    complaints: list[str] = []
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.on("console", lambda m: m.type == "error" and complaints.append(m.text))
    page.goto(f"{site}/book/{CURVE}.html")
    yield Reader(page)
    page.close()
    assert complaints == []


@pytest.fixture
def at_desk(busy: Reader) -> Iterator[Reader]:
    """The same, and as the book has it after each test."""
    yield busy
    for button in ("reset-all", "forget"):
        if busy.button(button).is_visible():
            busy.button(button).click()


def fold(reader: Reader, name: str) -> None:
    """Open or close the folds of a cell."""
    reader.cell(name).locator("summary").evaluate_all("all => all.forEach((s) => s.click())")


def stored_output(name: str, page: str = CURVE) -> str:
    """What a cell of the book prints."""
    cell = next(cell for cell in pages()[f"{page}.ipynb"].cells if cell.id == name)
    return str(cell.outputs[0].text)


def test_nothing_is_fetched_before_a_click(read: Read, site: str) -> None:
    reader = read()
    asked: list[str] = []
    reader.page.on("request", lambda request: asked.append(request.url))
    reader.page.reload(wait_until="networkidle")
    assert [url.partition("?")[0] for url in asked if "/page_python/" in url] == [
        f"{site}/_static/page_python/page_python.js"
    ]
    assert reader.python() == "absent"
    assert {reader.state(name) for name in ("code-6", "verdicts")} == {"stored"}


@pytest.mark.slow
def test_a_change_runs_and_goes(at_desk: Reader) -> None:
    reader = at_desk
    assert reader.run("code-6") == stored_output("code-6")
    assert (reader.state("code-6"), reader.python()) == ("done", "ready")
    assert reader.cell("code-6").locator(".cell_output > *:visible").count() == 0
    assert not reader.button("reset", "[data-cell=code-6]").is_visible()
    assert reader.run("code-6", "len(scenes.FIGURE_8)") == "4"
    # Firefox and WebKit type such spaces after a sign.
    assert reader.run("code-6", "four\N{NO-BREAK SPACE}= 4") == ""
    assert reader.message("code-6") == "Done, nothing printed."
    reader.write("code-6", "7")
    reader.page.keyboard.type("/2")
    assert reader.run("code-6") == "3.5"
    reader.press("code-6", "reset")
    assert reader.state("code-6") == "stored"
    assert reader.code("code-6").startswith("def pieces(")
    assert reader.cell("code-6").locator(".cell_output > *:visible").count() == 1
    assert reader.output("code-6") == ""
    assert reader.page.evaluate(KEYS) == []


@pytest.mark.slow
def test_cells_above_run_first_and_once(at_desk: Reader) -> None:
    reader = at_desk
    reader.run("code-15")
    assert (reader.state("code-6"), reader.state("start-5-16")) == ("done", "stored")
    # Python has the name, whatever has become of the cell.
    reader.write("code-6", "del pieces")
    assert reader.state("code-15") == "stored"
    assert reader.run("code-17", "pieces.__name__") == "'pieces'"
    reader.run("code-6")
    assert "NameError" in reader.run("code-17")
    reader.button("reset-all").click()
    reader.run("code-15", "'earlier'")
    reader.write("code-6", "1 / 0")
    reader.run("code-6")
    reader.press("code-15")
    assert reader.wait("code-15") == ""
    assert reader.message("code-15") == "Cell 6 above has failed, so this cell has not run."
    assert "ZeroDivisionError" in reader.output("code-6")


@pytest.mark.slow
def test_what_comes_out_is_text(at_desk: Reader) -> None:
    html = "<img src=x onerror='document.title = 1'><b>bold</b>"
    assert at_desk.run("code-6", f'print("{html}")\n"<script>1</script>"').startswith(html)
    code = "class T:\n    def _repr_markdown_(self):\n        return '| a |\\n| - |\\n| <b>x</b> |'"
    assert at_desk.run("code-6", f"{code}\nT()") == "a<b>x</b>"
    shown = at_desk.cell("code-6").locator(".live-output")
    assert shown.locator("td").count() == 1
    assert shown.locator("img, b, script").count() == 0


@pytest.mark.slow
def test_impatient_readers_get_everything_once_and_in_order(at_desk: Reader) -> None:
    reader = at_desk
    reader.write("code-6", "count = globals().get('count', 0) + 1\ncount")
    reader.write("code-15", "count * 10")
    reader.page.evaluate(
        """() => ["code-6", "code-6", "code-15"].forEach((name) =>
            document.querySelector(`[data-cell="${name}"] button[name=run]`).click())"""
    )
    assert reader.wait("code-15") == "10"
    assert reader.output("code-6") == "1"


@pytest.mark.slow
def test_stop_and_go_on_without_a_network(at_desk: Reader) -> None:
    reader = at_desk
    reader.run("code-6")
    for worker in reader.page.workers:
        # A spare worker answers when its scripts are there.
        worker.evaluate("FILES")
    reader.page.context.set_offline(True)
    reader.write("code-6", "i = 0\nwhile True:\n    i += 1\n    if i % 10**6 == 0: print(i)")
    reader.press("code-6")
    reader.cell("code-6").locator(".live-output:has-text('1000000')").wait_for(timeout=PATIENCE)
    reader.press("code-15")
    assert (reader.state("code-6"), reader.state("code-15")) == ("running", "waiting")
    assert reader.message("code-6") == "Running"
    reader.button("stop").click()
    assert reader.wait("code-6").startswith("1000000")
    reader.page.wait_for_function("document.querySelector('[data-run=waiting]') === null")
    assert reader.message("code-6").startswith("Stopped.")
    assert (reader.python(), reader.state("code-15")) == ("absent", "stored")
    assert reader.button("stop").count() == 0
    # What earlier code printed does not stand beside this one.
    reader.write("code-6", "while True: pass")
    reader.press("code-6")
    reader.cell("code-6").locator(".live-message:text-is('Running')").wait_for(timeout=PATIENCE)
    reader.button("stop").click()
    assert reader.wait("code-6") == ""
    assert reader.run("code-6", "1 + 1") == "2"
    reader.page.context.set_offline(False)


def test_the_hand_and_python_meet(read: Read) -> None:
    reader = read("05-arcs")
    figure = figure_in(reader.page, "slerp_by_hand")
    reader.run("try-farthest")
    # Nobody has touched the figure: it comes to life with what Python has set.
    assert f"at t = {arrived(figure)['t']:.2f}" in reader.output("try-farthest")
    assert reader.message("try-farthest") == "Show the figure that Python has set"
    slider = figure.locator("input[type=range][name=t]")
    slider.fill("0.125")
    assert reader.run("try-farthest", "figure.t") == "0.125"
    reader.run("try-farthest", "figure.t = 0.75")
    reader.page.wait_for_function("document.querySelector('[name=t]').value === '0.75'")


MOVES = {
    "2.1": ("02-quaternions", "two-mirrors-by-hand", {"first": 0, "second": 90}),
    "3.1": ("03-ordinary-rotation", "figure-1-by-hand", {"drawn": 3}),
    "4.1": ("04-general-rotation", "three-turns-by-hand", {"order": "U V W"}),
    "5.1": ("05-arcs", "the-detour", {"aside": 0}),
    "5.8": ("05-control-points", "arrow-at-the-clock", {"aim": 38}),
    "5.15": (CURVE, "arcs-of-arcs", {"u": 1}),
}


@pytest.mark.parametrize("number", nightly(MOVES, "5.8"))
def test_a_right_answer_moves_the_figure(number: str, read: Read) -> None:
    page, figure, expected = MOVES[number]
    reader = read(page)
    solution = next(p.exercises[number].solution for p in notebooks() if number in p.exercises)
    function = solution.source.partition("check(")[0].rstrip()
    start = notebook_cell(number).source.partition("\n")[2]
    reader.write(f"start-{number.replace('.', '-')}", f"{function}\n\n{start}")
    assert reader.check(number)[1] == "true"
    reader.page.wait_for_function(
        """([name, wanted]) => {
          const told = JSON.parse(document.querySelector(`[data-name="${name}"]`).dataset.values);
          return Object.entries(wanted).every(([key, value]) => told[key] === value);
        }""",
        arg=[figure, expected],
        timeout=PATIENCE,
    )


def test_a_chart_is_drawn_where_the_book_has_it(read: Read) -> None:
    reader = read("05-closed-curve", quiet=False)
    charts = reader.cell("code-39").locator("figure .chart")
    [[_, alt]] = charts.evaluate_all(SHOWN)
    fold(reader, "code-39")
    reader.page.route("**/matplotlib.zip*", lambda route: route.abort())
    assert "Matplotlib could not be fetched (the server does not" in reader.run("code-39")
    reader.page.unroute("**/matplotlib.zip*")
    assert reader.run("code-39") == ""
    assert charts.evaluate_all(SHOWN) == [[False, alt], [True, alt]]
    before = charts.last.inner_html()
    reader.run("code-39", f"u = 1\n{reader.code('code-39')}")
    changed = f"Drawn with your changes. In the book: {alt}"
    assert charts.evaluate_all(SHOWN) == [[False, alt], [True, changed]]
    assert charts.last.inner_html() == before
    # What was fetched is kept for the next worker.
    reader.button("reset-all").click()
    assert charts.evaluate_all(SHOWN) == [[True, alt]]
    reader.page.context.set_offline(True)
    assert reader.run("code-39") == ""
    assert charts.last.inner_html() == before
    reader.run("code-39", "1 / 0")
    assert charts.evaluate_all(SHOWN) == [[False, alt]]
    reader.press("code-39", "reset")
    reader.run(
        "code-6", "plt.imshow([[0, 1]])\nplt.show()\nplt.title('own').set_url('javascript:1')"
    )
    own = reader.cell("code-6").locator(".live-output .chart")
    assert (own.get_attribute("aria-label"), own.locator("svg").count()) == ("Chart of cell 6", 2)
    assert own.locator("image").count() == 1
    assert own.locator("a").count() == 0
    assert reader.message("code-39") == ""
    # What a hostile cell draws neither runs nor loads anything.
    forged = (
        "<svg xmlns='http://www.w3.org/2000/svg' onload='x=1'><script>x=1</script>"
        "<image href='//rotedu.invalid/x' onerror='x=1'/>"
        "<g class='x' style='position: fixed; fill: image-set(url(//x) 1x); color: red'/></svg>"
    )
    forge = f"charts.taken = lambda _: [{forged!r}]"
    reader.run("code-6", f"import charts\nplt.gcf()\nplt.show()\n{forge}")
    kept = reader.cell("code-6").locator(".live-output .chart").inner_html()
    assert kept.endswith('"><image></image><g style="color: red"></g></svg>')


def test_an_answer_is_judged_kept_and_handed_in(read: Read, tmp_path: Path) -> None:
    reader = read()
    assert reader.solved() == "0 of 7 solved"
    assert reader.check("5.19") == ("Not answered yet.", None)
    wrong = "Not yet. Your point is not on the sphere."
    assert reader.check("5.19", "[1, 2, 3]") == (f"{wrong} {HINT}", "false")
    text, right = reader.check("5.19")
    assert right == "false"
    assert text.startswith("Not yet.")
    assert text != f"{wrong} {HINT}"
    text, right = reader.check("5.19", "de_casteljau(wide, 0.4)")
    assert (text.split()[0], right) == ("Right.", "true")
    assert "For more" not in reader.output("start-5-19")
    assert reader.fill("5.16", "60", "30", "\u221290")[1] == "false"
    assert reader.fill("5.16", "60", "30", "180/2\u00b0")[1] == "true"
    assert reader.solved() == "2 of 7 solved"

    saved = save(reader, tmp_path)
    sources = {cell.id: cell.source for cell in saved.cells}
    assert "answer = de_casteljau(wide, 0.4)" in sources["start-5-19"]
    assert "answer = [60, 30, 180 / 2]" in sources["start-5-16"]
    assert sources["start-5-17"] == notebook_cell("5.17").source
    assert not any(name.startswith(("solution", "why")) for name in sources)

    reader.page.reload()
    assert reader.solved() == "2 of 7 solved"
    assert reader.verdict("5.19") == (text, "true")
    assert "de_casteljau(wide, 0.4)" in reader.code("start-5-19")
    assert reader.exercise("5.16").locator("input").last.input_value() == "180/2\u00b0"
    reader.button("forget").click()
    assert (reader.solved(), reader.page.evaluate(KEYS)) == ("0 of 7 solved", [])
    assert reader.exercise("5.16").locator("input").last.input_value() == ""
    assert reader.page.locator(".live-head .live-message").inner_text().startswith("Your code")
    reader.button("undo").click()
    assert reader.solved() == "2 of 7 solved"
    reader.button("reset-all").click()
    assert reader.page.locator(".live-head .live-message").inner_text().startswith("All cells are")
    assert (reader.solved(), reader.verdict("5.19")) == ("2 of 7 solved", ("", None))
    reader.button("undo").click()
    assert reader.verdict("5.19") == (text, "true")
    reader.write("start-5-19", "answer = 0")
    assert (reader.solved(), reader.verdict("5.19")) == ("2 of 7 solved", ("", None))


def save(reader: Reader, folder: Path) -> NotebookNode:
    """Save the page as a notebook, and read it."""
    with reader.page.expect_download() as download:
        reader.page.locator("a.answers[download]").click()
    file = folder / download.value.suggested_filename
    assert file.stem.endswith("-my-work")
    download.value.save_as(file)
    saved = nbformat.read(file, as_version=4)
    nbformat.validate(saved)
    return saved


@pytest.mark.slow
def test_a_page_from_a_file_says_what_to_do(book: Path, open_page: Open) -> None:
    reader = Reader(open_page((book / "book" / f"{CURVE}.html").as_uri(), quiet=False))
    reader.press("code-6")
    assert "python -m http.server" in reader.message("code-6")
    assert reader.state("code-6") == "stored"
    assert reader.fill("5.16", "60", "30", "90")[1] == "true"
    assert reader.solved() == "1 of 7 solved"


# What only a worker bounds: its end, memory, stack and network.
HOSTILE = {
    "import os\nos._exit(0)": "Python has ended",
    "list(range(10**9))": "MemoryError",
    "a = []\nfor _ in range(10**5):\n    a = [a]\na": "RecursionError",
    "import js\njs.fetch('https://rotedu.invalid')": "Error",
    "import js\njs.XMLHttpRequest.new()": "Error",
    "import js\njs.WebSocket.new('wss://rotedu.invalid')": "Error",
}


@pytest.mark.slow
@pytest.mark.parametrize("code", HOSTILE, ids=lambda code: code.split("\n")[-1])
def test_a_hostile_cell_harms_nobody(at_desk: Reader, code: str) -> None:
    reader = at_desk
    assert HOSTILE[code] in reader.run("code-6", code) + reader.message("code-6")
    reader.button("reset-all").click()
    assert reader.run("code-6") == stored_output("code-6")


# Where the cells of a page stand.
PLACES = """() => [...document.querySelectorAll(".cell")].map((cell) =>
    Math.round(cell.getBoundingClientRect().top))"""


@pytest.mark.slow
@pytest.mark.parametrize("width", [390, 1280])
def test_nothing_moves_when_the_script_comes(read: Read, width: int) -> None:
    reader = read(viewport={"width": width, "height": 900}, quiet=False)
    places = reader.page.evaluate(PLACES)
    reader.page.route("**/page_python/page_python.js*", lambda route: route.abort())
    reader.page.reload()
    assert reader.button("run").count() == 0
    assert reader.page.evaluate(PLACES) == places


@pytest.mark.slow
def test_every_cell_runs_where_it_stands(read: Read) -> None:
    for page in notebooks():
        reader = read(page.file.stem)
        for name in reader.page.evaluate(RUNNABLE):
            fold(reader, name)
            reader.run(name)
            assert reader.state(name) == "done", (page, name, reader.output(name))
        counted = reader.page.locator(".cell.tag_desk .live-tools").count()
        assert counted == sum("desk" in tags(cell) for cell in page.code)


@pytest.mark.slow
def test_a_fetch_that_fails_half_way_can_be_repeated(read: Read) -> None:
    reader = read(quiet=False)
    reader.page.route("**/numpy.zip*", lambda route: route.abort())
    reader.press("code-6")
    reader.page.wait_for_selector("html[data-python=failed]", timeout=PATIENCE)
    assert reader.message("code-6").startswith("Python could not be fetched")
    assert (reader.state("code-6"), reader.output("code-6")) == ("error", "")
    reader.page.unroute("**/numpy.zip*")
    assert reader.run("code-6") == stored_output("code-6")
    reader.page.route("**/*.ipynb", lambda route: route.abort())
    reader.page.reload()
    reader.press("code-6")
    reader.wait("code-6")
    assert reader.message("code-6").startswith("The notebook of this page could not be fetched")


@pytest.mark.slow
def test_without_an_editor_a_cell_still_runs(read: Read) -> None:
    reader = read(quiet=False)
    reader.page.route("**/editor.js*", lambda route: route.abort())
    assert reader.run("code-6") == stored_output("code-6")
    reader.page.unroute("**/editor.js*")
    assert reader.run("code-6", "1 + 1") == "2"


NOTHING_KEPT = """Object.defineProperty(window, "localStorage", { get() {
    throw new DOMException("denied", "SecurityError"); } });"""


@pytest.mark.slow
def test_where_nothing_is_kept_the_page_says_so(read: Read, tmp_path: Path) -> None:
    reader = read(script=NOTHING_KEPT, quiet=False)
    assert reader.fill("5.16", "60", "30", "90")[1] == "true"
    assert reader.solved() == "1 of 7 solved"
    assert "keeps nothing" in reader.page.locator(".live-head").inner_text()
    assert any("[60, 30, 90]" in cell.source for cell in save(reader, tmp_path).cells)
    reader.page.reload()
    assert reader.solved() == "0 of 7 solved"


@pytest.mark.slow
def test_what_an_older_edition_kept_is_not_lost(read: Read, tmp_path: Path) -> None:
    reader = read()
    reader.fill("5.16", "60", "30", "90")
    [key] = reader.page.evaluate(KEYS)
    old = {"start-5-99": '{"code": "x = 1", "right": true}', "start-5-19": "no JSON", "code-6": "5"}
    for name, text in old.items():
        key_of = key.replace("start-5-16", name)
        reader.page.evaluate("([key, text]) => localStorage.setItem(key, text)", [key_of, text])
    reader.page.reload()
    assert reader.solved() == "1 of 7 solved"
    assert reader.run("code-6") == stored_output("code-6")
    last = save(reader, tmp_path).cells[-1]
    assert (last.cell_type, "x = 1" in last.source) == ("markdown", True)
    reader.button("forget").click()
    assert reader.page.evaluate(KEYS) == []


@pytest.mark.slow
def test_two_tabs_do_not_undo_one_another(read: Read) -> None:
    one = read()
    other = Reader(one.page.context.new_page())
    other.page.goto(one.page.url)
    one.fill("5.16", "60", "30", "90")
    other.page.wait_for_function("document.querySelector('.solved').textContent[0] === '1'")
    other.fill("5.17", "6", "55")
    one.page.wait_for_function("document.querySelector('.solved').textContent[0] === '2'")


@pytest.mark.slow
def test_the_keyboard_reaches_everything_and_leaves(read: Read) -> None:
    reader, focused = read(), "document.activeElement.getAttribute('aria-label')"
    keyboard = reader.page.keyboard
    reader.cell("code-6").locator("button[name=run]").focus()
    keyboard.press("Enter")
    reader.wait("code-6")
    assert reader.page.evaluate(focused) == "Run cell 6"
    keyboard.press("Shift+Tab")
    assert reader.page.evaluate(focused) == "Code of cell 6"
    reader.cell("start-5-15").locator("button[name=edit]").focus()
    keyboard.press("Enter")
    reader.page.wait_for_function(f"{focused}?.startsWith('Code of ')")
    reader.cell("code-6").locator(".cm-content").focus()
    keyboard.press("ControlOrMeta+a")
    keyboard.type("for i in range(3):\nprint(i)")
    keyboard.press("Shift+Enter")
    assert reader.wait("code-6") == "0\n1\n2\n"
    keyboard.press("Tab")
    assert reader.page.evaluate(focused) == "Code of cell 6"
    keyboard.press("Escape")
    keyboard.press("Tab")
    assert reader.page.evaluate(focused) == "Run cell 6"
    keyboard.press("Tab")
    keyboard.press("Enter")
    assert reader.page.evaluate(focused) == "Run cell 6"
    assert reader.state("code-6") == "stored"


# Every text that a screen reader is given to say.
SPOKEN = """window.spoken = [];
new MutationObserver((changes) => changes.forEach(({ target }) => {
    if (target.matches?.(".live-spoken, .verdict") && target.textContent) {
        spoken.push(target.textContent);
    }
})).observe(document, { subtree: true, childList: true });"""


@pytest.mark.slow
def test_what_comes_out_is_said_once(read: Read) -> None:
    reader = read(script=SPOKEN)
    reader.run("code-6", "print('hello')")
    said = reader.page.evaluate("spoken")
    assert said[-1] == "Cell 6: hello\n"
    assert len(said) == len(set(said)) == 2
    assert said[0].startswith("Python is being fetched: ")
    reader.press("code-6", "reset")
    reader.run("code-15")
    reader.check("5.19", "[1, 2, 3]")
    *_, before, last = reader.page.evaluate("spoken")
    assert before.startswith("Cell 7: ")
    assert last.startswith("Not yet.")


# How many pixels a finger finds of what can be pressed, from top to bottom: what is cut off has a
# box, too.
HIT = """button => {
    button.scrollIntoView({ block: "center", behavior: "instant" });
    const { left, right, top, bottom } = button.getBoundingClientRect();
    const found = (y) => button.contains(document.elementFromPoint((left + right) / 2, y));
    const rows = Array.from({ length: bottom - top }, (_, i) => top + i + 0.5);
    return rows.filter(found).length;
}"""


@pytest.mark.slow
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_a_finger_can_do_it_and_axe_agrees(read: Read, theme: str) -> None:
    reader = read(color_scheme=theme, **PHONE)
    # There is nothing yet to save or to forget.
    assert reader.page.locator(".live-head button:visible").count() == 0
    reader.cell("code-6").locator("button[name=run]").tap()
    reader.wait("code-6")
    reader.check("5.19", "[1, 2, 3]")
    reader.run("code-6", "1 / 0")
    reader.fill("5.16", "60", "30", "90")
    for button in reader.page.locator(":is(.live-tools, .live-head) :is(button, a):visible").all():
        if button.get_attribute("name") == "edit":
            # Unseen until the focus comes, and in no finger's way.
            assert button.evaluate(HIT) == 0
            continue
        box = button.bounding_box()
        assert min(box["width"], box["height"]) >= 44, button.inner_text()
        assert button.evaluate(HIT) >= 42, button.inner_text()
    assert reader.page.evaluate("document.documentElement.scrollWidth") <= 390
    assert complaints_of_axe(reader.page, "html") == []
