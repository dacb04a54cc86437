"""Set-up survives: interrupted at any instant, it is mended by the next call.

The copy of the checkout stands in a folder with a space and letters outside ASCII, and the locale
knows only ASCII.
"""

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from set_up import MARK

ROOT = Path(__file__).parents[1]
# What an update installs, here.
UPDATED = ("numpy", "sympy", "sphinx", "vtk")
# A package is whole if every file is there that its record lists.
MISSING = """
from importlib.metadata import distributions
lost = [file for package in distributions() for file in package.files if not file.locate().exists()]
print(len(list(distributions())), *lost)
"""
WHEN = (0.2, 0.6, 0.8)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(os.name == "nt", reason="Windows has neither make nor these signals"),
]


class Checkout:
    """A copy of what git tracks, whose set-up can be interrupted."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        tracked = subprocess.check_output(["git", "ls-files", "-z"], cwd=ROOT, text=True)
        for name in filter(None, tracked.split("\0")):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / name)
        self.mark = folder / MARK.relative_to(ROOT)
        self.python = folder / ".venv" / "bin" / "python"
        self.seconds = {"first": self.set_up("first"), "updating": self.set_up("updating")}

    def prepare(self, kind: str) -> None:
        """Leave everything, or something, to be installed."""
        if kind == "first":
            shutil.rmtree(self.folder / ".venv", ignore_errors=True)
            return
        uv = [self.python, "-m", "uv", "pip", "uninstall", "--quiet", "--python", self.python]
        subprocess.run([*uv, *UPDATED], check=True)
        (self.folder / "requirements.txt").touch()

    def start(self) -> subprocess.Popen[bytes]:
        command = ["make", f"PYTHON={sys.executable}", self.mark.relative_to(self.folder)]
        environment = os.environ | {"LC_ALL": "C"}
        # A group of its own, as a shell gives to what somebody may interrupt.
        return subprocess.Popen(command, cwd=self.folder, env=environment, start_new_session=True)

    def set_up(self, kind: str) -> float:
        """Return the seconds that a set-up takes."""
        self.prepare(kind)
        began = time.monotonic()
        assert self.start().wait() == 0
        return time.monotonic() - began

    def interrupt(self, kind: str, number: signal.Signals, share: float) -> None:
        """Interrupt a set-up after a share of the time that it takes."""
        self.prepare(kind)
        run = self.start()
        time.sleep(share * self.seconds[kind])
        os.killpg(run.pid, number)
        run.wait()

    def missing(self) -> list[str]:
        """Return how many packages there are, then the files that are not."""
        return subprocess.check_output([self.python, "-c", MISSING], text=True).split()


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Checkout:
    return Checkout(tmp_path_factory.mktemp("checkout") / "rotedu é ü 漢字")


@pytest.mark.parametrize("share", WHEN)
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
@pytest.mark.parametrize("kind", ["first", "updating"])
def test_the_next_call_mends_what_was_interrupted(
    checkout: Checkout, kind: str, number: signal.Signals, share: float
) -> None:
    whole = checkout.missing()
    assert len(whole) == 1
    checkout.interrupt(kind, number, share)
    assert checkout.start().wait() == 0
    assert checkout.missing() == whole
    assert checkout.mark.exists()
