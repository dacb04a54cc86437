"""The metadata of the package leads where the settings of pyproject.toml say, or nowhere."""

import re
import shutil
from pathlib import Path

import pytest
from hatchling.metadata.core import ProjectMetadata
from hatchling.plugin.manager import PluginManager

import rotedu

ROOT = Path(__file__).parents[1]
BOOK, REPOSITORY = "https://book.example", "https://github.example/somebody/rotedu"


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    for name in ("README.md", "tools/hatch_build.py", "pyproject.toml", "rotedu/__init__.py"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    return tmp_path


def fill(checkout: Path, book: str, repository: str) -> None:
    """Set the settings of a copy."""
    file = checkout / "pyproject.toml"
    text = re.sub(r'(?m)^book = ".*"$', f'book = "{book}"', file.read_text("utf-8"))
    text = re.sub(r'(?m)^repository = ".*"$', f'repository = "{repository}"', text)
    file.write_text(text, "utf-8")


def metadata(checkout: Path) -> tuple[dict[str, str], list[str], str]:
    """Return addresses, links and description of a copy."""
    core = ProjectMetadata(str(checkout), PluginManager()).core
    return core.urls, re.findall(r"\]\((.+?)\)", core.readme), core.readme


def test_without_addresses_nothing_leads_to_a_file(checkout: Path) -> None:
    fill(checkout, "", "")
    urls, links, text = metadata(checkout)
    assert urls == {}
    assert links
    assert all(link.startswith("https://") for link in links)
    assert "The other conventions are in book/conventions.md." in text
    assert "A teaspoon" not in text


def test_with_addresses_every_link_leads_to_a_file_of_the_release(checkout: Path) -> None:
    fill(checkout, BOOK, REPOSITORY + "/")
    urls, links, text = metadata(checkout)
    assert urls == {"Documentation": BOOK, "Repository": REPOSITORY + "/"}
    tag = f"v{rotedu.__version__}"
    files = [link for link in links if link.startswith(REPOSITORY)]
    assert f"{REPOSITORY}/blob/{tag}/LICENSE" in files
    assert f"{REPOSITORY}/raw/{tag}/book/_static/preview.webp" in files
    for link in files:
        assert (ROOT / link.split(f"/{tag}/")[1]).is_file()
    assert all(link.startswith("https://") for link in links)
    assert "\n![A teaspoon" in text
