"""A page says how long it takes to read, and no page takes longer than half an hour."""

from pathlib import Path

import pytest
from reading_time import EXERCISE, LIMIT, count, lines_in, pages, text_of

CHAPTERS = [page for page in pages() if page.stem[0].isdigit()]

PAGE = """\
# Three words here

A [link of five words](elsewhere.md), a role: {cite:t}`one2000`, and $x + y$.

$$
a = b
$$

:::{math}
:label: eq-1-1

b = a
:::

```python
one = 1

two = 2
```

**Figure 1.** Two words.

:::{dropdown} A folded title
:class: unread

Is read.
:::

## Exercises

**Exercise 1.1** (recall, 5 minutes). This is not counted.

**Exercise 1.2** (apply, 10 minutes). Nor is this.

## To take along

Done.
"""


def test_what_is_counted(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(PAGE, "utf-8")
    title, sentence, caption, folded, end = 3, 10, 4, 5, 4
    counted = count(page)
    assert counted == (title + sentence + caption + folded + end, 2, 2, 1, 15)
    assert counted.minutes == 2  # 26 words at 0.3 s, 2 lines at 5, 2 formulas at 20, a figure at 30
    assert counted.time == "**Time** 2 minutes to read, 15 for the exercises."


def test_empty_lines_are_not_read() -> None:
    assert lines_in("a = 1\n\n    \nb = 2\n") == 2


@pytest.mark.parametrize("page", pages(), ids=lambda page: page.stem)
def test_no_page_takes_longer_than_half_an_hour(page: Path) -> None:
    assert count(page).minutes <= LIMIT


@pytest.mark.parametrize("page", CHAPTERS, ids=lambda page: page.stem)
def test_a_chapter_says_how_long_it_takes(page: Path) -> None:
    # python tools/reading_time.py updates this line.
    assert count(page).time in text_of(page)


@pytest.mark.parametrize("page", CHAPTERS, ids=lambda page: page.stem)
def test_every_exercise_says_how_long_it_takes(page: Path) -> None:
    text = text_of(page)
    assert len(EXERCISE.findall(text)) == text.count("\n**Exercise ")
