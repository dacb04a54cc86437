"""A user's installation: the built wheel with each extra, in a new environment and folder.

Nothing here can reach the checkout, so any code of the package that reads it fails.
"""

import json
import os
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from collections.abc import Callable
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient
from notebook_language import ROOT, notebooks
from packaging.metadata import Metadata
from servers import get, jupyterlab
from set_up import OLDEST
from uv import find_uv_bin

NOTEBOOKS = [page.name for page in notebooks()]
VIEWER = "rotedu/figures/static/figure.js"

pytestmark = pytest.mark.slow


def run(*command: str | Path, cwd: Path) -> str:
    return subprocess.run(command, cwd=cwd, check=True, stdout=subprocess.PIPE, text=True).stdout


def uv(*arguments: str | Path, cwd: Path) -> str:
    return run(find_uv_bin(), *arguments, cwd=cwd)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Another folder that contains only the notebooks."""
    folder = tmp_path_factory.mktemp("elsewhere")
    for name in NOTEBOOKS:
        shutil.copy(ROOT / "book" / name, folder)
    return folder


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built from the source distribution beside it."""
    folder = tmp_path_factory.mktemp("dist")
    # As the workflow Release builds it: with the locked hatchling.
    locked = ("--no-build-isolation", "-p", sys.executable)
    uv("build", "--quiet", *locked, "--out-dir", folder, ROOT, cwd=folder)
    (wheel,) = folder.glob("rotedu-*.whl")
    return wheel


@pytest.fixture(scope="module")
def source(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The unpacked source distribution."""
    (packed,) = wheel.parent.glob("rotedu-*.tar.gz")
    folder = tmp_path_factory.mktemp("source")
    with tarfile.open(packed) as archive:
        archive.extractall(folder, filter="data")
    return next(folder.iterdir())


@pytest.fixture(scope="module")
def install(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Install the wheel with an extra into an empty environment; return its Python."""

    def install_one(extra: str = "", *others: str, version: str = sys.executable) -> Path:
        folder = tmp_path_factory.mktemp("environment")
        uv("venv", "--quiet", "--clear", "-p", version, folder, cwd=folder)
        python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
        packages = (f"rotedu{extra} @ {wheel.as_uri()}", *others)
        uv("pip", "install", "--quiet", "-p", python, *packages, cwd=folder)
        return python

    return install_one


def test_the_wheel_holds_the_package_and_nothing_else(wheel: Path) -> None:
    tracked = run("git", "ls-files", "rotedu", cwd=ROOT).split()
    names = ("figure-loader.js", "figure.js", "starts.json")
    viewer = [f"rotedu/figures/static/{name}" for name in names]
    packed = [name for name in zipfile.ZipFile(wheel).namelist() if ".dist-info/" not in name]
    assert sorted(packed) == sorted(tracked + viewer)


def test_the_metadata_hold_on_a_package_index(wheel: Path) -> None:
    archive = zipfile.ZipFile(wheel)
    (folder,) = {name.partition("/")[0] for name in archive.namelist() if ".dist-info/" in name}
    # Refuses what a package index refuses; tests/test_hatch_build.py sees links and addresses.
    metadata = Metadata.from_email(archive.read(f"{folder}/METADATA"))
    assert metadata.license_expression == "BSD-3-Clause AND MIT AND OFL-1.1"
    assert metadata.license_files == ["LICENSE", "LICENSES/VIEWER.txt"]
    for name in metadata.license_files:
        assert archive.read(f"{folder}/licenses/{name}") == (ROOT / name).read_bytes()


def test_the_source_distribution_can_bundle_its_viewer_and_leaves_the_book_out(
    source: Path,
) -> None:
    """The text of the book has another licence."""
    assert not (source / "book").exists()
    assert (source / "LICENSE").exists()
    packed = (source / VIEWER).read_bytes()
    assert packed == (ROOT / VIEWER).read_bytes()
    (source / VIEWER).unlink()
    run(sys.executable, "tools/bundle.py", cwd=source)
    assert (source / VIEWER).read_bytes() == packed


def test_no_wheel_is_built_without_the_viewer(source: Path, tmp_path: Path) -> None:
    """An editable installation needs no viewer, and says what to run only when it is needed."""
    bare = shutil.copytree(source, tmp_path / "bare", ignore=shutil.ignore_patterns("static"))
    build = [find_uv_bin(), "build", "--wheel", "--out-dir", tmp_path / "dist", bare]
    failed = subprocess.run(build, capture_output=True, text=True, check=False)
    assert failed.returncode != 0
    assert "python tools/bundle.py" in failed.stdout + failed.stderr
    uv("venv", "--quiet", "-p", sys.executable, tmp_path / "env", cwd=tmp_path)
    uv("pip", "install", "--quiet", "-p", tmp_path / "env", "-e", bare, cwd=tmp_path)


def test_the_mathematics_needs_numpy_alone_and_has_types(
    install: Callable[..., Path], folder: Path
) -> None:
    python = install()
    listed = json.loads(uv("pip", "list", "-p", python, "--format", "json", cwd=folder))
    assert [package["name"] for package in listed] == ["numpy", "rotedu"]
    modules = sorted(f"rotedu.{file.stem}" for file in (ROOT / "rotedu").glob("[!_]*.py"))
    run(python, "-W", "error", "-c", f"import {', '.join(modules)}", cwd=folder)
    (folder / "user.py").write_text("from rotedu.arcs import slerp\n\nreveal_type(slerp)\n")
    mypy = [sys.executable, "-m", "mypy", "--python-executable", python, "user.py"]
    assert "-> numpy.ndarray" in run(*mypy, cwd=folder)


def test_the_mathematics_needs_no_newer_numpy(install: Callable[..., Path]) -> None:
    """Blender and others have the oldest NumPy that pyproject.toml allows."""
    (numpy,) = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["dependencies"]
    oldest = numpy.replace(">=", "==") + ".*"
    used = ("hypothesis", "pytest", "pytransform3d", "scipy", "splines", "sympy")
    python = install("", oldest, *used, version="{}.{}".format(*OLDEST))
    modules = sorted((ROOT / "rotedu").glob("*.py"))
    named_alike = (ROOT / "tests" / f"test_{file.stem.strip('_')}.py" for file in modules)
    # Colours stand in pages and pictures alone.
    tests = [file for file in named_alike if file.exists() and file.stem != "test_colors"]
    assert len(tests) > 8
    options = ["-o", "addopts=", "--noconftest", "--hypothesis-profile=ci", "--doctest-modules"]
    command = [python, "-m", "pytest", *options, *modules, *tests, ROOT / "rotedu" / "edition"]
    subprocess.run(command, cwd=ROOT, check=True)


@pytest.fixture(scope="module")
def kernels(install: Callable[..., Path], folder: Path) -> Path:
    """Install what the notebooks need; return where Jupyter finds their kernel."""
    python = install("[notebooks]")
    run(python, "-m", "ipykernel", "install", "--sys-prefix", cwd=folder)
    return python.parents[1] / "share" / "jupyter"


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_runs_elsewhere(
    name: str, kernels: Path, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("JUPYTER_PATH", str(kernels))
    notebook = nbformat.read(folder / name, as_version=4)
    place = {"metadata": {"path": folder}}
    NotebookClient(notebook, timeout=300, kernel_name="python3", resources=place).execute()


def test_jupyterlab_opens_and_runs_a_notebook(install: Callable[..., Path], folder: Path) -> None:
    python, name = install("[lab]"), "03-ordinary-rotation.ipynb"
    with jupyterlab(python, folder) as url:
        assert "<title>JupyterLab</title>" in get(f"{url}/lab/tree/{name}")
    run(python, "-m", "nbconvert", "--execute", "--to", "notebook", "--stdout", name, cwd=folder)
