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

import pytest
import set_up
from browser import CHROMIUMS, free_port
from servers import answers, until

fcntl = pytest.importorskip("fcntl", reason="Windows has no make")

ROOT = Path(__file__).parents[1]
by_make = pytest.mark.skipif(not set_up.PYTHON.exists(), reason="needs the .venv that make makes")
# A package is whole if every file is there that its record lists.
MISSING = """
from importlib.metadata import distributions
lost = [file for package in distributions() for file in package.files if not file.locate().exists()]
print(len(list(distributions())), *lost)
"""


def make(folder: Path, *arguments: str, **options: str) -> subprocess.Popen[str]:
    """Call make in a group of its own, as a shell does, in a locale that knows ASCII alone."""
    # The make that runs the tests has options of its own.
    environment = os.environ | {"MAKEFLAGS": "", "LC_ALL": "C"} | options
    pipes = {"stderr": subprocess.PIPE, "text": True, "start_new_session": True}
    return subprocess.Popen(["make", "-s", *arguments], cwd=folder, env=environment, **pipes)


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
    for name in ("lock.py", "set_up.py"):
        ast.parse((ROOT / "tools" / name).read_text("utf-8"), feature_version=(3, 6))


def test_package_and_binder_support_the_same_pythons() -> None:
    wanted = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    (_, oldest), (_, newest) = set_up.OLDEST, set_up.NEWEST
    assert wanted["requires-python"] == f">=3.{oldest},<3.{newest + 1}"
    pinned = (ROOT / ".binder" / "runtime.txt").read_text("utf-8").strip()
    assert oldest <= int(pinned.removeprefix("python-3.")) <= newest


@by_make
def test_uv_asks_the_index_that_pip_is_told_of(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    nowhere = f"http://127.0.0.1:{free_port()}/simple"
    monkeypatch.setenv("PIP_INDEX_URL", nowhere)
    monkeypatch.setenv("UV_HTTP_RETRIES", "0")
    with pytest.raises(subprocess.CalledProcessError):
        set_up.uv("pip", "install", "--no-cache", "--target", tmp_path, "numpy")
    assert f"{nowhere}/numpy/" in capfd.readouterr().err


@pytest.mark.parametrize(
    "command",
    [
        pytest.param(["tools/set_up.py", "--browser"], marks=by_make),
        ["-m", "pytest", "-m", "", "tests/test_book.py"],
    ],
    ids=["set-up", "tests"],
)
def test_a_browser_that_fails_is_said_at_once_and_in_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: list[str]
) -> None:
    for name in CHROMIUMS:
        (tmp_path / name).write_text("#!/bin/sh\nexit 1\n")
        (tmp_path / name).chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    call = [sys.executable, *command]
    run = subprocess.run(call, cwd=ROOT, capture_output=True, text=True, check=False)
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
)
def test_everything_that_writes_waits(tmp_path: Path, code: str) -> None:
    shutil.copytree(ROOT / "tools", tmp_path / "tools")
    shutil.copytree(ROOT / "book" / "_ext", tmp_path / "book" / "_ext")
    for name in ("pyproject.toml", "requirements.txt"):
        shutil.copy(ROOT / name, tmp_path)
    path = f"import sys; sys.path[:0] = ['{tmp_path}/tools', '{tmp_path}/book/_ext']; "
    folder = os.open(tmp_path, os.O_RDONLY)
    fcntl.flock(folder, fcntl.LOCK_EX)
    command = [sys.executable, "-c", path + code]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as second:
        assert second.stdout.readline().startswith("waiting until another set-up or build")
        second.kill()
    os.close(folder)


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
    arguments = ("rotedu/figures/static/figure.js", f"PYTHON={sys.executable}")
    first = make(checkout, *arguments)
    until(lambda: len([*checkout.glob(".venv/lib/*/site-packages/*")]) > 20, "some packages")
    os.killpg(first.pid, signal.SIGKILL)
    first.wait()
    both = [make(checkout, *arguments), make(checkout, *arguments)]
    assert [call.wait() for call in both] == [0, 0]
    python = checkout / ".venv" / "bin" / "python"
    [count] = subprocess.check_output([python, "-c", MISSING], text=True).split()
    assert int(count) > 150
    began = time.monotonic()
    assert make(checkout, *arguments).wait() == 0
    assert time.monotonic() - began < 2
    # An environment that has been moved does not work.
    moved = checkout.rename(checkout.with_name("moved"))
    assert make(moved, *arguments).wait() == 0
    subprocess.check_call([moved / ".venv" / "bin" / "jupyter-book", "--version"])
