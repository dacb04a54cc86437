"""A page says how long it takes to read."""

from pathlib import Path

import nbformat
from nbformat.v4 import new_code_cell, new_notebook, new_output
from notebook_language import Page
from reading_time import count, told

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

```{literalinclude} ../.binder/runtime.txt
```

**Figure 1.** Two words.

:::{dropdown} A folded title
:class: unread

Is not counted.
:::

:::{div} opening
Asked the long way?
:::

:::{admonition} As printed: a misprint
:class: erratum warning

Is folded.
:::

## To take along

Done.
"""


def test_what_is_counted(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(PAGE, "utf-8")
    title, sentence, caption, folded, opening, misprint, end = 3, 10, 4, 3, 4, 4, 4
    counted = count(Page(page))
    before = title + sentence + caption + folded + opening + misprint
    assert counted == (before + end, 3, 2, 1, 0, 0, 0)
    assert told(Page(page)) == {
        "folded": 5,
        "opening": opening,
        "to heading": before,
        "way": 1,
        "agree": 0,
        "a figure": before + end,
    }
    # 32 words at 0.46 s, 3 lines at 6, 2 formulas at 30, a scene at 60
    assert counted.minutes == 3
    assert counted._replace(by_hand=1).minutes == 6
    assert counted._replace(small=2).minutes == 4
    assert counted.time == "**Time** 3 minutes to read."
    assert counted._replace(exercises=9).time == "**Time** 3 minutes to read, 9 for the exercises."


def test_claims_are_counted_where_they_are_folded(tmp_path: Path) -> None:
    table = "| Head | here |\n| --- | --- |\n| **one** | two three |\n| four | five six |"
    output = new_output("execute_result", data={"text/markdown": table})
    cell = new_code_cell("table()", outputs=[output], metadata={"tags": ["claims"]})
    nbformat.write(new_notebook(cells=[cell]), tmp_path / "page.ipynb")
    assert told(Page(tmp_path / "page.ipynb"))["folded"] == 8
