"""`import rotedu` needs numpy alone."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

import rotedu

MATHEMATICS = sorted(file.stem for file in Path(rotedu.__file__).parent.glob("[!_]*.py"))


def modules_loaded_by(statement: str) -> set[str]:
    code = f"{statement}; import json, sys; print(json.dumps(sorted(sys.modules)))"
    run = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True, timeout=60
    )
    return set(json.loads(run.stdout))


def packages_loaded_by(statement: str) -> set[str]:
    names = {name.partition(".")[0] for name in modules_loaded_by(statement)}
    return names - sys.stdlib_module_names


def test_the_mathematics_loads_numpy_and_nothing_else() -> None:
    assert "ordinary_rotation" in MATHEMATICS
    loaded = packages_loaded_by(f"from rotedu import {', '.join(MATHEMATICS)}")
    assert loaded - packages_loaded_by("import numpy") == {"rotedu"}


def test_the_package_alone_loads_no_module_of_its_own() -> None:
    assert not [name for name in modules_loaded_by("import rotedu") if name.startswith("rotedu.")]


def test_another_package_would_be_noticed() -> None:
    assert "scipy" in packages_loaded_by("import scipy") - packages_loaded_by("import numpy")


# Where the version stands that is not read from the package; the changelog keeps older ones, too.
VERSIONS = {
    "CHANGELOG.md": r"\A(?s:.*?)(?:What version |## \[)(\d+\.\d+\.\d+)",
    "CITATION.cff": r"^version: (.+)",
    "book/run-a-class.md": r"rotedu-(.+)-py3",
}


@pytest.mark.parametrize("file", VERSIONS)
def test_the_version_is_that_of_the_package(file: str) -> None:
    text = (Path(__file__).parents[1] / file).read_text(encoding="utf-8")
    assert set(re.findall(VERSIONS[file], text, re.MULTILINE)) == {rotedu.__version__}
