"""The plans for teachers add up, and every chapter can be presented in a lecture room."""

import re
from collections.abc import Iterator
from typing import Any, NamedTuple

import pytest
from live_pages import AT_REST
from nightly import nightly
from notebook_language import captions_by_hand, chapters, exercises, pages
from reading_time import count

TEXT = pages()["teaching.md"].text

UNFOLD = "for (const box of document.querySelectorAll('details')) box.open = true"
# A heading is small where it only says what the visible section belongs to.
VISIBLE = """() => [...document.querySelectorAll("article :is(h1, h2, h3)")]
    .filter((heading) => heading.checkVisibility())
    .filter((heading) => parseFloat(getComputedStyle(heading).fontSize)
        > parseFloat(getComputedStyle(heading.parentElement).fontSize))
    .map((heading) => heading.parentElement.id)"""


def table(heading: str) -> list[list[str]]:
    """The rows of the table below a heading, its head apart."""
    section = re.split(r"^#+ ", TEXT.partition(f"# {heading}\n")[2], flags=re.MULTILINE)[0]
    cells = [row.strip("|").split("|") for row in section.splitlines() if row.startswith("|")]
    return [[cell.replace("**", "").strip() for cell in row] for row in cells[2:]]


PLANS = {"Three weeks": 1, "Six weeks": 1, "Two weeks more": 7}
NOTEBOOKS = {repr(page): page for page in chapters()}
EXERCISES = exercises()


def numbers(cell: str) -> list[str]:
    """The exercises that a cell names."""
    return re.findall(r"\w\.\d+", cell)


class Unit(NamedTuple):
    """A row of the plans: its page, its minutes, and the exercises of the lab and for home."""

    page: str
    lecture: int
    lab: int
    in_lab: list[str]
    at_home: list[str]
    chosen: list[str]


def units() -> dict[str, Unit]:
    found, page = {}, ""
    for name, what, lecture, lab, in_lab, home in table("Three plans"):
        page = link[1] if (link := re.search(r"\((\w[\w-]+)\.ipynb\)", what)) else page
        # Small projects, in italics, are for choice.
        chosen = numbers("".join(re.findall(r"\*[^*]+\*", home)))
        fixed = [number for number in numbers(home) if number not in chosen]
        found[name] = Unit(page, int(lecture), int(lab), numbers(in_lab), fixed, chosen)
    return found


def minutes(exercises: list[str]) -> int:
    return sum(EXERCISES[number].minutes for number in exercises)


def test_one_lecture_takes_the_minutes_that_it_promises() -> None:
    assert f"{sum(int(row[2]) for row in table('One lecture'))} minutes for" in TEXT


@pytest.mark.parametrize("number", EXERCISES)
def test_an_exercise_has_its_place(number: str) -> None:
    page = next(name for name, page in NOTEBOOKS.items() if number in page.exercises)
    own = {name: unit for name, unit in units().items() if unit.page == page}
    found = [n for unit in own.values() for n in (*unit.in_lab, *unit.at_home, *unit.chosen)]
    assert found.count(number) == 1, (
        f"Exercise {number} of {page} must stand once in the first table of book/teaching.md,"
        f" under *Exercises in the lab* or *At home* of unit {' or '.join(own)}:"
        f" there it stands {found.count(number)} times"
    )


@pytest.mark.parametrize("name", units())
def test_a_lab_takes_the_minutes_of_its_exercises(name: str) -> None:
    unit = units()[name]
    assert EXERCISES.keys() >= {*unit.in_lab, *unit.at_home, *unit.chosen}
    assert unit.lab == minutes(unit.in_lab) or not unit.in_lab
    assert all("project" in EXERCISES[number].kind for number in unit.chosen)


def test_plans_name_sections_that_exist() -> None:
    tables = ("Three plans", *PLANS, "The pages, one by one")
    rows = [" ".join(row) for heading in tables for row in table(heading)]
    named = re.findall(r"(?<!\*)\*([A-Z][^*.]{6,})\*(?!\*)", " ".join(rows))
    headings = {name for page in chapters() for name in re.findall(r"^#+ (.+)", page.text, re.M)}
    assert len(named) > 15
    assert set(named) <= headings


@pytest.mark.parametrize("weeks", PLANS)
def test_the_weeks_add_up(weeks: str) -> None:
    *plan, total = table(weeks)
    assert weeks.startswith({2: "Two", 3: "Three", 6: "Six"}[len(plan)])
    for number, row in enumerate(plan, start=PLANS[weeks]):
        taken = [units()[unit] for unit in row[1].split()]
        lab = sum(unit.lab for unit in taken)
        assert row[0] == str(number)
        assert sum(unit.lecture for unit in taken) == int(row[2]) == 90
        assert 55 <= lab == int(row[3]) <= 90
    for column in (2, 3):
        assert int(total[column]) == sum(int(row[column]) for row in plan)


@pytest.mark.parametrize("weeks", ["Six weeks", "Two weeks more"])
def test_what_is_done_at_home_is_about_right(weeks: str) -> None:
    """Pages to read, which may grow by some lines, and exercises that are not for choice."""
    *plan, total = table(weeks)
    for row in plan:
        taken = {name: units()[name] for name in row[1].split()}
        read = {unit.page for name, unit in taken.items() if name not in "OP"}
        fixed = sum(minutes(unit.at_home) for unit in taken.values())
        counted = sum(count(NOTEBOOKS[page]).minutes for page in read) + fixed
        assert int(row[5]) == pytest.approx(counted, abs=5), row
    assert int(total[5]) == sum(int(row[5]) for row in plan)


def test_six_weeks_leave_out_no_page_of_the_paper() -> None:
    """The others make units, too, for a class that has more time."""
    taught = {units()[name].page for row in table("Six weeks")[:-1] for name in row[1].split()}
    assert {unit.page for unit in units().values()} == set(NOTEBOOKS)
    assert taught == {name for name in NOTEBOOKS if not name.startswith("beyond-")}


def test_the_marks_make_a_hundred() -> None:
    *marks, total = table("Marking scheme")
    assert sum(int(row[1]) for row in marks) == int(total[1]) == 100


def test_every_figure_that_answers_the_hand_cures_something() -> None:
    rows = table("What students get wrong, and the figure that cures it")
    cures = {target for row in rows for target in re.findall(r"\(#([\w-]+)\)", row[1])}
    # A small figure has no name.
    names = {caption.anchor for caption in captions_by_hand()} - {""}
    assert names
    assert names <= cures


def test_the_page_for_teachers_gives_no_number_of_an_exercise() -> None:
    assert not re.search(r"Exercise \w+\.\w", TEXT)


@pytest.fixture
def page(browser: Any, site: str) -> Iterator[Any]:
    """A chapter that is being presented."""
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    complaints: list[str] = []
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.goto(f"{site}/book/03-ordinary-rotation.html")
    present = page.get_by_role("button", name="Slides")
    present.focus()
    page.keyboard.press("Enter")
    yield page
    page.close()
    assert complaints == []


def place(page: Any) -> int:
    """The number of the section, as it is announced, if that section alone is visible."""
    said = page.locator("nav[aria-label=Sections] [role=status]").inner_text()
    [visible] = page.evaluate(VISIBLE)
    assert page.evaluate("document.activeElement.id") == visible
    number, name = re.fullmatch(r"(\d+) of \d+: (.*)", said).groups()
    title = page.locator(f"[id='{visible}'] > :is(h1, h2, h3)").inner_text()
    assert title[:10] == name[:10]
    return int(number)


def press(page: Any, key: str) -> int:
    page.keyboard.press(key)
    return place(page)


def test_arrows_and_buttons_go_from_section_to_section(page: Any) -> None:
    last = page.locator("article section").count()
    assert last > 10
    assert place(page) == 1
    assert press(page, "ArrowLeft") == 1
    assert [press(page, "ArrowRight") for _ in range(last)] == [*range(2, last + 1), last]
    assert press(page, "ArrowLeft") == last - 1
    assert press(page, "Home") == 1
    assert press(page, "End") == last
    bar = page.get_by_role("navigation", name="Sections")
    for name, section in (("Previous section", last - 1), ("Next section", last)):
        bar.get_by_role("button", name=name).click()
        assert place(page) == section
    bar.get_by_role("button", name="Leave").click()
    assert not bar.is_visible()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("forward", "backward"), [("PageDown", "PageUp"), ("Space", "Shift+Space")]
)
def test_a_tall_section_scrolls_before_the_next_comes(
    page: Any, forward: str, backward: str
) -> None:
    assert [press(page, "ArrowRight") for _ in range(2)] == [2, 3]
    assert page.evaluate("document.documentElement.scrollHeight > innerHeight")
    assert press(page, forward) == 3
    page.wait_for_function("scrollY > 0")
    # The browser scrolls by itself for a moment.
    page.wait_for_function(AT_REST, polling=400)
    page.evaluate("scrollTo({ top: document.documentElement.scrollHeight, behavior: 'instant' })")
    assert press(page, forward) == 4
    page.wait_for_function("scrollY === 0", timeout=5_000)
    assert press(page, backward) == 3


@pytest.mark.slow
def test_escape_leaves_where_the_reader_was(page: Any) -> None:
    assert [press(page, "ArrowRight") for _ in range(2)] == [2, 3]
    page.keyboard.press("Escape")
    assert len(page.evaluate(VISIBLE)) == page.locator("article section").count()
    assert not page.get_by_role("navigation", name="Sections").is_visible()
    # A browser scrolls to a whole pixel.
    assert -1 < page.locator("#rodrigues-formula > h2").bounding_box()["y"] < 200
    page.keyboard.press("ArrowRight")
    assert len(page.evaluate(VISIBLE)) > 1
    page.get_by_role("button", name="Slides").click()
    assert place(page) == 3


def test_a_figure_is_live_and_large_and_keeps_its_keys(page: Any) -> None:
    assert [press(page, "ArrowRight") for _ in range(2)] == [2, 3]
    figure = page.locator(".explorable[data-name='figure-1-by-hand']")
    figure.scroll_into_view_if_needed()
    figure.locator(".scene[data-state=live]").wait_for(timeout=20_000)
    scene = figure.locator(".scene").bounding_box()
    assert scene["width"] > 640
    panel = figure.locator("form").bounding_box()
    assert panel["x"] >= scene["x"] + scene["width"]
    for kept in ("canvas", "input[type=range] >> nth=0"):
        figure.locator(kept).focus()
        for key in ("ArrowRight", "PageDown", "End"):
            page.keyboard.press(key)
        assert page.get_by_text(re.compile("^3 of ")).is_visible()
        assert press(page, "Escape") == 3
    assert figure.locator("input[type=range]").first.input_value() == "3"
    assert [press(page, key) for key in ("ArrowRight", "ArrowLeft")] == [4, 3]
    chip = figure.locator("a.try").last
    chip.click()
    words = re.split(r"\s", chip.inner_text())[0]
    figure.locator(".explorable-status", has_text=words).wait_for(state="attached")
    assert page.evaluate(VISIBLE) == ["rodrigues-formula"]


CUT = """() => [...document.querySelectorAll(".presented .explorable")]
    .filter((figure) => figure.checkVisibility())
    .map((figure) => [figure, ...figure.querySelectorAll(".scene, .explorable-panel")])
    .filter((boxes) => Math.max(...boxes.map((box) => box.getBoundingClientRect().height))
        > document.querySelector(".present-bar").getBoundingClientRect().top)
    .map(([figure]) => figure.dataset.name)"""


# Lecture rooms project one or the other.
@pytest.mark.parametrize("screen", nightly([(1280, 720), (1920, 1080)], (1280, 720)), ids=str)
@pytest.mark.parametrize("name", nightly(NOTEBOOKS, "05-closed-curve"))
def test_a_figure_fits_a_slide_and_its_code_is_not_shown(
    browser: Any, site: str, name: str, screen: tuple[int, int]
) -> None:
    page = browser.new_page(viewport=dict(zip(("width", "height"), screen, strict=True)))
    page.goto(f"{site}/book/{name}.html")
    page.get_by_role("button", name="Slides").click()
    code = page.locator(".cell:has(.explorable) > :is(details, .cell_input, .live-tools)")
    for _ in range(page.locator("article section").count()):
        assert page.evaluate(CUT) == []
        assert not code.locator("visible=true").count()
        page.keyboard.press("ArrowRight")
    page.close()


def test_page_down_shows_a_figure_whole(page: Any) -> None:
    figure = page.locator(".presented .explorable").first
    before = figure.bounding_box()
    edge = page.get_by_role("navigation", name="Sections").bounding_box()["y"]
    assert before["y"] + before["height"] > edge
    press(page, "PageDown")
    for part in (".scene", ".explorable-panel"):
        box = figure.locator(part).bounding_box()
        assert 0 <= box["y"] <= box["y"] + box["height"] <= edge


@pytest.mark.slow
def test_the_screen_is_filled_and_given_back(page: Any) -> None:
    filled = "document.fullscreenElement !== null"
    page.keyboard.press("F5")
    page.wait_for_function(filled)
    page.get_by_role("button", name="Full screen", exact=True).last.click()
    page.wait_for_function(f"!({filled})")
    assert place(page) == 1


def test_slides_begin_where_the_reader_is_and_say_a_formula_once(browser: Any, site: str) -> None:
    page = browser.new_page(viewport={"width": 1400, "height": 720})
    page.goto(f"{site}/book/05-control-points.html")
    page.locator("article section").nth(6).evaluate(
        "section => section.scrollIntoView({ behavior: 'instant' })"
    )
    page.locator(".toc-tree").hover()
    page.get_by_role("button", name="Present from here").click()
    said = page.locator("nav[aria-label=Sections] [role=status]").inner_text()
    # KaTeX ends an index with a space of no width.
    said = re.sub(r"\W+$", "", said.replace("\N{ZERO WIDTH SPACE}", ""))
    assert said == "7 of 10: From Pi to ai and bi, as the paper draws it"
    page.close()


@pytest.mark.slow
def test_space_opens_a_folded_answer_and_a_link_leads_elsewhere(page: Any) -> None:
    assert [press(page, "ArrowRight") for _ in range(2)] == [2, 3]
    answer = page.locator(".presented details.sd-dropdown > summary").first
    answer.focus()
    page.keyboard.press("Space")
    assert answer.evaluate("summary => summary.parentElement.open")
    assert [press(page, "ArrowRight") for _ in range(5)] == [4, 5, 6, 7, 8]
    page.locator(".presented a[href='#picture-3-a']").first.click()
    page.wait_for_function("scrollY > 0")
    assert page.evaluate(VISIBLE) == ["one-term-one-matrix"]


ON_SCREEN = (
    ".skip-to-content, .sidebar-drawer, .toc-drawer, .related-pages, footer, .headerlink",
    ".explorable-panel, .explorable-status, a.try, .scene-handles",
    "article button, .page-head, .live-head",
    "[data-cell^='start-'] > .cell_output, .exercise > .sd-dropdown",
)


@pytest.mark.slow
def test_paper_has_the_whole_page_and_nothing_of_the_screen(page: Any) -> None:
    # As wide as a sheet on its side, where the frame of the page has room
    page.set_viewport_size({"width": 1120, "height": 790})
    page.emulate_media(media="print")
    assert len(page.evaluate(VISIBLE)) == page.locator("article section").count()
    assert not page.get_by_role("navigation", name="Sections").is_visible()
    for name in ON_SCREEN:
        assert page.locator(name).count(), name
        assert not page.locator(name).locator("visible=true").count(), name
    # Answers are not, and what is not an answer is open.
    boxes = page.locator(".question .sd-summary-text, #the-claims-judged > .sd-dropdown li")
    assert boxes.locator("visible=true").count() == boxes.count() > 3
    assert not page.locator(".question .sd-summary-content").locator("visible=true").count()
    # Chromium makes all letters smaller where a hidden label stands beside the sheet.
    page.goto(page.url.replace("03-ordinary-rotation", "05-closed-curve"))
    shown = "labels => labels.map(label => getComputedStyle(label).display)"
    assert set(page.locator(".scene-label[data-hidden]").evaluate_all(shown)) == {"none"}


@pytest.mark.parametrize("width", nightly([1280, 390], 390))
def test_type_is_large_and_nothing_sticks_out(browser: Any, site: str, width: int) -> None:
    page = browser.new_page(viewport={"width": width, "height": 720})
    for name in ("04-general-rotation", "05-control-points"):
        page.goto(f"{site}/book/{name}.html")
        size = "parseFloat(getComputedStyle(document.querySelector('article')).fontSize)"
        before = page.evaluate(size)
        page.get_by_role("button", name="Slides").click()
        assert page.evaluate(size) >= (27 if width == 1280 else before)
        for _ in range(page.locator("article section").count()):
            page.evaluate(UNFOLD)
            assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), name
            page.keyboard.press("ArrowRight")
    page.close()
