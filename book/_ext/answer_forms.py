"""Let the page check an answer of a few numbers, as `rotedu.edition.exercises` does.

What judges it stands below the starter cell, and ``_static/answers.js`` makes a form of it. Without
scripts there is no form, and the text is complete.
"""

import html
import json
from typing import Any

import numpy as np
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

from cells import code_cells, part_of_exercise
from rotedu.edition.exercises.judging import EXERCISES, Exercise, Part


def judged_by(part: Part, numbers: int) -> dict[str, Any]:
    """Return what judges one step as plain data."""
    items = np.arange(numbers)[slice(None) if part.item is None else part.item]
    *hints, (first, last) = part.hints.items()
    return {
        "items": np.ravel(items).tolist(),
        "right": np.ravel(part.right).tolist(),
        "mistakes": [
            {"result": np.ravel(result).tolist(), "hint": [hint, mistake.second]}
            for hint, mistake in hints
            for result in mistake.results
        ],
        "otherwise": [first, last.second],
        "within": part.within,
        "period": part.period,
        "eitherSign": part.either_sign,
    }


def form_of(exercise: Exercise) -> nodes.raw:
    """Return an empty element for the script to fill."""
    asked = {
        "number": exercise.number,
        "fields": list(exercise.fields.items()),
        "expects": exercise.expects,
        "because": exercise.because,
        "parts": [judged_by(part, len(exercise.fields)) for part in exercise.parts],
    }
    data = html.escape(json.dumps(asked, ensure_ascii=False))
    return nodes.raw("", f'<div class="answer-form" data-asked="{data}"></div>', format="html")


class AddForms(SphinxPostTransform):
    """Put a form below each starter cell with a check of numbers."""

    default_priority = 5
    # Paper runs no script.
    builders = ("html",)

    def run(self, **_: Any) -> None:
        """Find the starter cells whose exercises ask for numbers."""
        for cell in code_cells(self.document):
            part, number = part_of_exercise(cell)
            if part == "start" and EXERCISES[number].fields:
                cell.parent.insert(cell.parent.index(cell) + 1, form_of(EXERCISES[number]))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the step."""
    app.add_post_transform(AddForms)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
