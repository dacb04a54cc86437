"""`import rotedu` needs numpy alone, and each extra declares what its code imports."""

import ast
import re
import subprocess
import sys
import tomllib
from importlib.metadata import packages_distributions
from pathlib import Path

import rotedu

ROOT = Path(__file__).parents[1]
MATHEMATICS = sorted(file.stem for file in Path(rotedu.__file__).parent.glob("[!_]*.py"))


def loaded(statement: str) -> set[str]:
    """The modules that a statement loads after NumPy."""
    code = f"import numpy, sys; old = {{*sys.modules}}; {statement}; print(*{{*sys.modules}} - old)"
    run = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    return set(run.stdout.split())


def test_the_mathematics_loads_numpy_and_nothing_else() -> None:
    assert "ordinary_rotation" in MATHEMATICS
    names = loaded(f"from rotedu import {', '.join(MATHEMATICS)}")
    packages = {name.partition(".")[0] for name in names} - sys.stdlib_module_names
    assert packages == {"numpy", "rotedu"}


def test_the_package_alone_loads_no_module_of_its_own() -> None:
    assert loaded("import rotedu") == {"rotedu"}


# The extra with which each file is run; a later line overrides an earlier one.
EXTRAS = {
    "rotedu/**/*.py": "notebooks",
    "rotedu/figures/model.py": "book",
    "rotedu/figures/pages.py": "book",
    "book/_ext/*.py": "book",
    "tools/*.py": "test",
    "tools/bundle.py": "book",
    "tools/class_notebooks.py": "class",
    "tools/notebook_language.py": "book",
    "tests/**/*.py": "test",
    "conftest.py": "test",
    "benchmarks/*.py": "bench",
}
EXTRA_OF = {file: extra for pattern, extra in EXTRAS.items() for file in ROOT.glob(pattern)}
OURS = {name for file in EXTRA_OF for name in (file.stem, file.parent.name)}


def imported(file: Path) -> set[str]:
    """The packages of others that a file imports, at its top or later."""
    names = set()
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            names.add(node.module)
    return {name.partition(".")[0] for name in names} - sys.stdlib_module_names - OURS


def normalized(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def declared(extra: str) -> set[str]:
    """What an extra and those that it contains install."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    names = set()
    for wanted in [*project["dependencies"], *project["optional-dependencies"][extra]]:
        if inner := re.match(r"rotedu\[(\w+)\]", wanted):
            names |= declared(inner[1])
        else:
            names.add(normalized(re.match(r"[\w.-]+", wanted)[0]))
    return names


def test_extras_declare_what_their_code_imports() -> None:
    packages = packages_distributions()
    found = {extra: declared(extra) for extra in EXTRAS.values()}
    undeclared = {
        f"{extra}: {name} ({file.name})"
        for file, extra in EXTRA_OF.items()
        for name in imported(file)
        if not found[extra] & {normalized(each) for each in (name, *packages.get(name, ()))}
    }
    assert undeclared == set()
