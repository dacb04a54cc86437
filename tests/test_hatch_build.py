"""The metadata of the package leads where the settings of pyproject.toml say, or nowhere."""

import re
import shutil
from pathlib import Path

from hatchling.metadata.core import ProjectMetadata
from hatchling.plugin.manager import PluginManager

import rotedu

ROOT = Path(__file__).parents[1]
LINK = r"\]\((.+?)\)"
BOOK, REPOSITORY = "https://book.example", "https://github.example/somebody/rotedu"


def metadata(folder: Path, book: str, repository: str) -> tuple[dict[str, str], str]:
    """Return addresses and description of a copy with these settings."""
    for name in ("README.md", "tools/hatch_build.py", "pyproject.toml", "rotedu/__init__.py"):
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    file = folder / "pyproject.toml"
    text = re.sub(r'(?m)^book = ".*"$', f'book = "{book}"', file.read_text("utf-8"))
    text = re.sub(r'(?m)^repository = ".*"$', f'repository = "{repository}"', text)
    file.write_text(text, "utf-8")
    core = ProjectMetadata(str(folder), PluginManager()).core
    return core.urls, core.readme


def test_without_addresses_nothing_leads_to_a_file(tmp_path: Path) -> None:
    urls, text = metadata(tmp_path, "", "")
    assert urls == {}
    assert all(link.startswith("https://") for link in re.findall(LINK, text))
    assert "The other conventions are in book/conventions.md." in text
    assert "A teaspoon" not in text


def test_with_addresses_every_link_leads_to_a_file_of_the_release(tmp_path: Path) -> None:
    urls, text = metadata(tmp_path, BOOK, REPOSITORY + "/")
    assert urls == {"Documentation": BOOK, "Repository": REPOSITORY + "/"}
    assert "\n![A teaspoon" in text
    release = rf"{REPOSITORY}/(blob|raw)/v{re.escape(rotedu.__version__)}/"
    files = re.findall(rf"\]\({release}(.+?)\)", text)
    assert {("blob", "LICENSE"), ("raw", "book/_static/preview.webp")} <= set(files)
    assert all((ROOT / file).is_file() for _, file in files)
    assert all(link.startswith("https://") for link in re.findall(LINK, text))
