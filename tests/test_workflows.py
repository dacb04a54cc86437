"""What the workflows install and run is the same tomorrow, and only what must may write."""

import re
import subprocess
import sysconfig
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[1]
FOLDER = ROOT / ".github" / "workflows"
TEXTS = [file.read_text("utf-8") for file in sorted(FOLDER.glob("*.yml"))]
UV = "\"$(grep '^uv==' requirements.txt)\""


def test_actions_are_named_by_commit() -> None:
    """A tag can be moved; the comment says which one the commit had."""
    used = [use for text in TEXTS for use in re.findall(r"uses: (.+)", text)]
    pinned = [re.fullmatch(r"([\w/-]+)@([0-9a-f]{40}) # (v[\d.]+)", use) for use in used]
    assert len(used) > 10
    assert all(pinned), used
    commits = {pin.groups() for pin in pinned}
    assert len(commits) == len({name for name, _, _ in commits})


def test_only_what_the_lock_file_names_is_installed() -> None:
    (uv,) = re.findall(r"(?m)^uv==\d+\.\d+\.\d+$", (ROOT / "requirements.txt").read_text("utf-8"))
    installed = [what for text in TEXTS for what in re.findall(r"pip install (.+)", text)]
    assert set(installed) == {UV, "--system -r requirements.txt"}, (
        f"install {uv}, and what is locked"
    )
    for text in TEXTS:
        assert not re.search(r"uv tool|uvx|npx|pipx", text)


def test_a_release_is_checked_before_it_is_published() -> None:
    release = yaml.safe_load((FOLDER / "release.yml").read_text("utf-8"))
    jobs = release["jobs"]
    publish = jobs.pop("publish")
    assert set(publish["needs"]) == set(jobs)
    assert set(jobs["check"]["strategy"]["matrix"]["target"]) == {"test", "test-slow"}
    assert release["permissions"] == {"contents": "read"}
    assert not any("permissions" in job for job in jobs.values())


def test_the_job_that_publishes_runs_nobodys_code() -> None:
    publish = yaml.safe_load((FOLDER / "release.yml").read_text("utf-8"))["jobs"]["publish"]
    assert publish["permissions"] == {"contents": "write"}
    download, create, push = publish["steps"]
    assert download["uses"].startswith("actions/download-artifact@")
    unzip, *commands = push["run"].splitlines()
    for command in [create["run"], *commands]:
        assert re.fullmatch(r"(gh|git) [^;&|`(\n]+", command), command
    # Nothing else of the archive can reach the folder in which git runs.
    assert unzip == 'unzip -q -j dist/student.zip "*.ipynb" -d class'


def test_a_release_has_package_notebooks_and_book() -> None:
    steps = yaml.safe_load((FOLDER / "release.yml").read_text("utf-8"))["jobs"]["build"]["steps"]
    commands = "\n".join(step.get("run", "") for step in steps)
    assert "cp _build/pdf/rotedu.pdf _build/epub/rotedu.epub dist\n" in commands
    assert "cd _build/html\nzip --quiet --recurse-paths ../../dist/site.zip ." in commands
    assert "in student teacher; do zip" in commands
    (built,) = (i for i, step in enumerate(steps) if "pdf epub book" in step.get("run", ""))
    (handed,) = (i for i, step in enumerate(steps) if step.get("with", {}).get("path") == "dist")
    assert built < handed == len(steps) - 1


@pytest.mark.slow
def test_zizmor_finds_nothing() -> None:
    zizmor = Path(sysconfig.get_path("scripts"), "zizmor")
    command = [zizmor, "--offline", "--no-progress", FOLDER]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
