"""A user's installation: the built wheel with each extra, in a new environment and folder.

Nothing here can reach the checkout, so any code of the package that reads it fails.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import nbformat
import pytest
from jupyter_server.gateway.gateway_client import GatewayClient
from nbclient import NotebookClient
from notebook_language import notebooks
from packaging.metadata import Metadata
from servers import get, jupyterlab
from set_up import OLDEST
from uv import find_uv_bin

ROOT = Path(__file__).parents[1]
NOTEBOOKS = [page.name for page in notebooks()]
THROUGH_A_SERVER = "jupyter_server.gateway.managers.GatewayKernelManager"

pytestmark = pytest.mark.slow


def run(*command: str | Path, cwd: Path) -> str:
    return subprocess.run(command, cwd=cwd, check=True, stdout=subprocess.PIPE, text=True).stdout


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
    run(find_uv_bin(), "build", "--quiet", *locked, "--out-dir", folder, ROOT, cwd=folder)
    (wheel,) = folder.glob("rotedu-*.whl")
    return wheel


@pytest.fixture(scope="module")
def install(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Install the wheel with an extra into an empty environment; return its Python."""

    def install_one(extra: str = "", *others: str, version: str = sys.executable) -> Path:
        folder = tmp_path_factory.mktemp("environment")
        run(find_uv_bin(), "venv", "--quiet", "--clear", "-p", version, folder, cwd=folder)
        python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
        packages = (f"rotedu{extra} @ {wheel.as_uri()}", *others)
        run(find_uv_bin(), "pip", "install", "--quiet", "-p", python, *packages, cwd=folder)
        return python

    return install_one


@pytest.fixture(scope="module")
def kernels(install: Callable[..., Path], folder: Path) -> Path:
    """Install what the notebooks need; return where Jupyter finds their kernel."""
    python = install("[notebooks]")
    run(python, "-m", "ipykernel", "install", "--sys-prefix", cwd=folder)
    return python.parents[1] / "share" / "jupyter"


def test_the_wheel_holds_the_package_and_nothing_else(wheel: Path) -> None:
    tracked = run("git", "ls-files", "rotedu", cwd=ROOT).split()
    names = ("figure-loader.js", "figure.js", "starts.json")
    viewer = [f"rotedu/figures/static/{name}" for name in names]
    packed = [name for name in zipfile.ZipFile(wheel).namelist() if ".dist-info/" not in name]
    assert sorted(packed) == sorted(tracked + viewer)


def test_the_metadata_hold_on_a_package_index(wheel: Path) -> None:
    archive = zipfile.ZipFile(wheel)
    (folder,) = {name.partition("/")[0] for name in archive.namelist() if ".dist-info/" in name}
    # Refuses what a package index refuses.
    metadata = Metadata.from_email(archive.read(f"{folder}/METADATA"))
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["rotedu"]
    addresses = {settings["book"], settings["repository"]} - {""}
    assert set((metadata.project_urls or {}).values()) == addresses
    assert metadata.description_content_type == "text/markdown"
    links = re.findall(r"\]\((.+?)\)", metadata.description)
    assert links
    assert all(link.startswith("https://") for link in links)
    assert metadata.license_expression == "BSD-3-Clause AND MIT AND OFL-1.1"
    assert metadata.license_files == ["LICENSE", "LICENSES/VIEWER.txt"]
    for name in metadata.license_files:
        assert archive.read(f"{folder}/licenses/{name}") == (ROOT / name).read_bytes()


def test_the_source_distribution_leaves_the_book_out_and_needs_no_git(
    wheel: Path, tmp_path: Path
) -> None:
    """The text of the book has another licence."""
    (source,) = wheel.parent.glob("rotedu-*.tar.gz")
    with tarfile.open(source) as archive:
        names = {name.split("/", 1)[1] for name in archive.getnames()}
    assert not [name for name in names if name.startswith("book/")]
    assert names >= {"LICENSE", "LICENSES/VIEWER.txt", "viewer/build.js", "tools/bundle.py"}
    run(find_uv_bin(), "venv", "--quiet", "-p", sys.executable, tmp_path / "env", cwd=tmp_path)
    install = ["pip", "install", "--quiet", "--no-deps", "-p", tmp_path / "env", source]
    no_git = os.environ | {"PATH": str(tmp_path)}
    subprocess.run([find_uv_bin(), *install], env=no_git, check=True)
    (viewer,) = (tmp_path / "env").rglob("rotedu/figures/static/figure.js")
    assert (
        viewer.read_bytes() == (ROOT / "rotedu" / "figures" / "static" / "figure.js").read_bytes()
    )


def test_the_source_distribution_can_bundle_its_viewer(wheel: Path, tmp_path: Path) -> None:
    (source,) = wheel.parent.glob("rotedu-*.tar.gz")
    with tarfile.open(source) as archive:
        archive.extractall(tmp_path, filter="data")
    (folder,) = tmp_path.iterdir()
    viewer = folder / "rotedu" / "figures" / "static" / "figure.js"
    packed = viewer.read_bytes()
    viewer.unlink()
    run(sys.executable, "tools/bundle.py", cwd=folder)
    assert viewer.read_bytes() == packed


def test_no_wheel_is_built_without_the_viewer(tmp_path: Path) -> None:
    """An editable installation needs no viewer, and says what to run only when it is needed."""
    tracked = run(
        "git", "ls-files", "rotedu", "viewer", "*.toml", "*.py", "*.md", "LICENSE*", cwd=ROOT
    )
    for name in tracked.splitlines():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    build = [find_uv_bin(), "build", "--wheel", "--out-dir", tmp_path / "dist", tmp_path]
    failed = subprocess.run(build, capture_output=True, text=True, check=False)
    assert failed.returncode != 0
    assert "python tools/bundle.py" in failed.stdout + failed.stderr
    run(find_uv_bin(), "venv", "--quiet", "-p", sys.executable, tmp_path / "env", cwd=tmp_path)
    install = ["pip", "install", "--quiet", "-p", tmp_path / "env", "-e", tmp_path]
    run(find_uv_bin(), *install, cwd=tmp_path)


def test_the_types_reach_a_user(install: Callable[..., Path], folder: Path) -> None:
    (folder / "user.py").write_text("from rotedu.arcs import slerp\n\nreveal_type(slerp)\n")
    mypy = [sys.executable, "-m", "mypy", "--python-executable", install(), "user.py"]
    assert "-> numpy.ndarray" in run(*mypy, cwd=folder)


def test_the_mathematics_needs_numpy_alone(install: Callable[..., Path], folder: Path) -> None:
    python = install()
    listed = json.loads(
        run(find_uv_bin(), "pip", "list", "-p", python, "--format", "json", cwd=folder)
    )
    assert [package["name"] for package in listed] == ["numpy", "rotedu"]
    modules = sorted(f"rotedu.{file.stem}" for file in (ROOT / "rotedu").glob("[!_]*.py"))
    assert len(modules) > 5
    run(python, "-W", "error", "-c", f"import {', '.join(modules)}", cwd=folder)


def test_the_mathematics_needs_no_newer_numpy(install: Callable[..., Path]) -> None:
    """Blender and Python in the page have the oldest NumPy that pyproject.toml allows."""
    (numpy,) = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["dependencies"]
    oldest = numpy.replace(">=", "==") + ".*"
    used = ("hypothesis", "pytest", "scipy", "splines", "sympy")
    python = install("", oldest, *used, version="{}.{}".format(*OLDEST))
    modules = sorted((ROOT / "rotedu").glob("*.py"))
    named_alike = (ROOT / "tests" / f"test_{file.stem.strip('_')}.py" for file in modules)
    # Colours stand in pages and pictures alone.
    tests = [file for file in named_alike if file.exists() and file.stem != "test_colors"]
    assert len(tests) > 8
    options = ["-o", "addopts=", "--noconftest", "--hypothesis-profile=ci", "--doctest-modules"]
    # tests/test_page_python.py gives right and wrong answers to the same NumPy, in a page's Python.
    command = [python, "-m", "pytest", *options, *modules, *tests, ROOT / "rotedu" / "edition"]
    subprocess.run(command, cwd=ROOT, check=True)


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_runs_elsewhere(
    name: str, kernels: Path, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("JUPYTER_PATH", str(kernels))
    notebook = nbformat.read(folder / name, as_version=4)
    place = {"metadata": {"path": folder}}
    NotebookClient(notebook, timeout=300, kernel_name="python3", resources=place).execute()


@pytest.fixture
def lab(install: Callable[..., Path], folder: Path) -> Iterator[str]:
    # jupyter_server's client for another server sends neither token nor cookie on its socket.
    with jupyterlab(install("[lab]"), folder, "--ServerApp.disable_check_xsrf=True") as url:
        yield url


def test_jupyterlab_opens_and_runs_a_notebook(lab: str, folder: Path) -> None:
    name = "03-ordinary-rotation.ipynb"
    assert "<title>JupyterLab</title>" in get(f"{lab}/lab/tree/{name}")
    served = json.loads(get(f"{lab}/api/contents/{name}"))["content"]
    notebook = nbformat.read(folder / name, as_version=4)
    assert [cell["source"] for cell in served["cells"]] == [cell.source for cell in notebook.cells]
    GatewayClient.instance(url=lab)
    NotebookClient(notebook, timeout=300, kernel_manager_class=THROUGH_A_SERVER).execute()
