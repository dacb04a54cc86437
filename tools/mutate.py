"""Break the mathematics, one small edit at a time, and see whether a test notices.

cosmic-ray makes the edits: another sign, operator or number, a reversed condition, a missing
decorator. Each edit goes into a copy of the package, and the tests of its module run until one
fails. ``python tools/mutate.py`` takes every module; name modules to take only those. It lists the
edits that no test notices, and returns 1 unless tools/equivalent.toml expects and explains as many
of the same operator in the same function.
"""

import math
import os
import re
import resource
import shutil
import sys
import tempfile
import tomllib
from collections import defaultdict
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from difflib import unified_diff
from importlib import import_module
from itertools import repeat
from multiprocessing import get_context
from pathlib import Path
from time import monotonic
from typing import Any, NamedTuple

import pytest
from cosmic_ray.ast import ast_nodes, get_ast
from cosmic_ray.ast.ast_query import ASTQuery
from cosmic_ray.mutating import mutate_code
from cosmic_ray.plugins import get_operator, operator_names
from hypothesis import Phase, settings

ROOT = Path(__file__).parents[1]
EQUIVALENT = ROOT / "tools" / "equivalent.toml"
COPIED = "rotedu", "tests", "conftest.py", "pyproject.toml"
NO_MATHEMATICS = {"__init__", "colors", "errors"}
MODULES = sorted({file.stem for file in (ROOT / "rotedu").glob("*.py")} - NO_MATHEMATICS)
# cosmic-ray also knows edits that nobody makes by mistake, such as << for + or >= for ==.
OPERATORS = re.compile(
    "core/(AddNot|ExceptionReplacer|NumberReplacer|RemoveDecorator|ZeroIterationForLoop"
    "|Replace(AndWithOr|OrWithAnd|TrueWithFalse|FalseWithTrue)|ReplaceUnaryOperator_Delete_.*"
    "|ReplaceBinaryOperator_(Add_Sub|Sub_Add|Mul_Add|Mul_Div|Div_Mul|FloorDiv_Mul|Mod_Mul|Pow_Mul)"
    "|ReplaceComparisonOperator_(Eq_NotEq|NotEq_Eq|Is_IsNot|IsNot_Is"
    "|Lt_LtE|Lt_GtE|LtE_Lt|LtE_Gt|Gt_GtE|Gt_LtE|GtE_Gt|GtE_Lt))"
)
# The test processes are forked, so importing these once is enough.
SLOW_IMPORTS = "hypothesis.extra.numpy", "nbval.plugin", "scipy.spatial.transform", "sympy"
FORK = get_context("fork")


class Edit(NamedTuple):
    """One edit of a module."""

    module: str
    function: str
    """The innermost function or class, or ``<module>``."""
    operator: str
    line: int
    before: str
    after: str
    code: str


def edits(module: str) -> Iterator[Edit]:
    """Yield every edit of a module."""
    source = (ROOT / "rotedu" / f"{module}.py").read_text("utf-8")
    for name in filter(OPERATORS.fullmatch, operator_names()):
        operator = get_operator(name)()
        nodes = [n for n in ast_nodes(get_ast(source)) for _ in operator.mutation_positions(n)]
        for occurrence, node in enumerate(nodes):
            function = ASTQuery(node).get_definition_name() or "<module>"
            code = mutate_code(source, operator, occurrence)
            place, *changed = list(unified_diff(source.split("\n"), code.split("\n"), n=0))[2:]
            before, after = (
                "\n".join(line[1:].strip() for line in changed if line[0] == sign) for sign in "-+"
            )
            line = int(re.findall(r"\d+", place)[0])
            yield Edit(module, function, name.removeprefix("core/"), line, before, after, code)


def tests_of(module: str) -> list[str]:
    """Return the tests of a module; a module that serves all others also runs their tests."""
    others = MODULES if module.startswith("_") else ["arguments"]
    names = dict.fromkeys(f"tests/test_{name.strip('_')}.py" for name in [module, *others])
    return [name for name in names if (ROOT / name).exists()]


def run_tests(tests: list[str], seconds: int) -> None:
    """Run tests in this process until one fails, and exit with the result."""
    # Seconds of a processor: other work on the machine must not count.
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    for stream in (1, 2):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
    # There is no need to shrink a failing example.
    phases = Phase.explicit, Phase.generate
    settings.register_profile("mutate", settings.get_profile("ci"), phases=phases)
    options = ["-o", "addopts=", "-x", "-p", "no:cacheprovider", "--hypothesis-profile=mutate"]
    os._exit(pytest.main([*options, *tests]))


def passes(tests: list[str], seconds: int = resource.RLIM_INFINITY) -> bool:
    """Tell whether tests pass in time, in a process of their own."""
    process = FORK.Process(target=run_tests, args=(tests, seconds))
    process.start()
    process.join()
    return process.exitcode == 0


def copy_package(folder: str) -> None:
    """Make a copy of the package for this worker, and import from it."""
    place = Path(tempfile.mkdtemp(dir=folder))
    for name in COPIED:
        copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
        copy(ROOT / name, place / name)
    os.chdir(place)
    sys.path.insert(0, str(place))
    # Cached bytecode would confuse edits made within the same second.
    sys.dont_write_bytecode = True
    # There is a worker for each core.
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    for name in SLOW_IMPORTS:
        import_module(name)


def survives(edit: Edit, seconds: int) -> bool:
    """Make an edit, and tell whether the tests of its module still pass."""
    file = Path("rotedu", f"{edit.module}.py")
    source = file.read_text("utf-8")
    file.write_text(edit.code, "utf-8")
    try:
        return passes(tests_of(edit.module), seconds)
    finally:
        file.write_text(source, "utf-8")


def check(module: str, pool: ProcessPoolExecutor) -> list[Edit]:
    """Try every edit of a module; return those that no test notices."""
    start = monotonic()
    if not pool.submit(passes, tests_of(module)).result():
        sys.exit(f"{module}: the tests fail before anything is edited")
    # An edited loop may never end.
    limit = 10 * math.ceil(monotonic() - start)
    tried = list(edits(module))
    results = zip(tried, pool.map(survives, tried, repeat(limit)), strict=True)
    unnoticed = sorted(edit for edit, alive in results if alive)
    seconds = monotonic() - start
    print(
        f"{module}: {len(tried)} edits, {len(unnoticed)} not noticed, {seconds:.0f} s", flush=True
    )
    return unnoticed


def report(module: str, unnoticed: list[Edit], known: dict[str, Any]) -> bool:
    """Print the edits whose number differs from what is known; tell whether there are any."""
    found = defaultdict(list)
    for edit in unnoticed:
        found[edit.function, edit.operator].append(edit)
    counts = {
        (function, operator): entry["count"]
        for function, operators in known.items()
        for operator, entry in operators.items()
    }
    differ = {key for key in {*found, *counts} if len(found[key]) != counts.get(key, 0)}
    for function, operator in sorted(differ):
        alive, count = found[function, operator], counts.get((function, operator), 0)
        print(f"{module}, {function}: {len(alive)} by {operator} not noticed, {count} expected")
        if len(alive) < count:
            print("The entry in tools/equivalent.toml is out of date.")
        for edit in alive:
            print(f"rotedu/{module}.py:{edit.line}")
            print(*(f"- {line}" for line in edit.before.split("\n")), sep="\n")
            print(*(f"+ {line}" for line in edit.after.split("\n")), "", sep="\n", flush=True)
    return bool(differ)


def main() -> int:
    """Print the edits that are neither noticed nor expected; return 1 if there are any."""
    known = tomllib.loads(EQUIVALENT.read_text("utf-8"))
    with (
        tempfile.TemporaryDirectory() as folder,
        ProcessPoolExecutor(mp_context=FORK, initializer=copy_package, initargs=(folder,)) as pool,
    ):
        reported = [
            report(module, check(module, pool), known.get(module, {}))
            for module in sys.argv[1:] or MODULES
        ]
    return int(any(reported))


if __name__ == "__main__":
    sys.exit(main())
