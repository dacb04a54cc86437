"""`import rotedu` needs numpy alone."""

import json
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import rotedu

HEAVY = {"IPython", "matplotlib", "pyvista", "scipy", "sympy", "vtk", "vtkmodules"}


def packages_loaded_by(statement: str) -> set[str]:
    code = f"{statement}; import json, sys; print(json.dumps(sorted(sys.modules)))"
    run = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True, timeout=60
    )
    return {name.partition(".")[0] for name in json.loads(run.stdout)}


def test_the_mathematics_loads_numpy_and_nothing_heavier() -> None:
    modules = "quaternions, general_rotation, orientations, cost"
    loaded = packages_loaded_by(f"from rotedu import {modules}")
    assert "numpy" in loaded
    assert not HEAVY & loaded


def test_the_package_alone_loads_no_module_of_its_own() -> None:
    code = "import rotedu, sys; print([m for m in sys.modules if m.startswith('rotedu.')])"
    run = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert run.stdout.strip() == "[]"


def test_a_heavy_import_would_be_noticed() -> None:
    assert HEAVY & packages_loaded_by("import scipy") == {"scipy"}


def test_version_agrees_with_pyproject() -> None:
    pyproject = Path(__file__).parents[1] / "pyproject.toml"
    if not pyproject.exists():
        pytest.skip("not run from a checkout")
    assert rotedu.__version__ == tomllib.loads(pyproject.read_text("utf-8"))["project"]["version"]
