"""What the workflows install and run is the same tomorrow, and only what must may write."""

import re
import subprocess
import sysconfig
from pathlib import Path

import yaml

FOLDER = Path(__file__).parents[1] / ".github" / "workflows"
TEXT = "".join(file.read_text("utf-8") for file in sorted(FOLDER.glob("*.yml")))


def test_only_what_the_lock_file_names_is_installed() -> None:
    installed = set(re.findall(r"pip install (.+)", TEXT))
    # The night builds with the newest Sphinx, in an environment of its own.
    installed = {what for what in installed if "_build/newest" not in what}
    assert installed == {"\"$(grep '^uv==' requirements.txt)\"", "--system -r requirements.txt"}
    assert not re.search(r"uv tool|uvx|npx|pipx", TEXT)


def test_a_release_is_checked_and_the_job_that_publishes_runs_nobodys_code() -> None:
    release = yaml.safe_load((FOLDER / "release.yml").read_text("utf-8"))
    assert release["permissions"] == {"contents": "read"}
    publish = release["jobs"].pop("publish")
    assert set(publish["needs"]) == set(release["jobs"])
    assert not any("permissions" in job for job in release["jobs"].values())
    assert set(release["jobs"]["check"]["strategy"]["matrix"]["target"]) == {"test", "test-slow"}
    download, create, push = publish["steps"]
    assert download["uses"].startswith("actions/download-artifact@")
    for command in [create["run"], *push["run"].splitlines()]:
        # Nothing else of the archive can reach the folder in which git runs.
        allowed = r'(gh|git) [^;&|`(\n]+|unzip -q -j dist/student\.zip "\*\.ipynb" -d class'
        assert re.fullmatch(allowed, command), command


def test_zizmor_finds_nothing() -> None:
    """Such as an action named by a tag, which can be moved, or a job that may write too much."""
    zizmor = Path(sysconfig.get_path("scripts"), "zizmor")
    command = [zizmor, "--offline", "--no-progress", FOLDER]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
