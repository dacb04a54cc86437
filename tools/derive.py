"""Write into pages and citation what follows from the rest: nothing is run.

The line **Time** takes its minutes from ``reading_time``. Each notebook begins with the macros for
the colours of its formulas, JupyterLab gets the paper's numbers of the equations, and what the book
folds, JupyterLab folds. CITATION.cff gets the addresses of ``tool.rotedu`` in pyproject.toml, the
version of the package and its date in CHANGELOG. ``make notebooks`` calls this after it
has run the notebooks.
"""

import re
import tomllib
from pathlib import Path

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_markdown_cell
from notebook_language import ROOT, Block, Page, blocks, pages, part_of, tags
from reading_time import count

from rotedu import __version__, colors

TIME = re.compile(r"\*\*Time\*\* .*? for the exercises\.|\*\*Time\*\* \d+ minutes to read\.")
INKS = ("VECTOR", "AXIS", "RESULT", "CROSS", "WRONG")
MACROS = {rf"\{ink.lower()}": rf"\textcolor{{#{getattr(colors, ink)}}}{{#1}}" for ink in INKS}
# MyST in JupyterLab reads the front matter, which other notebooks take for a comment between two
# rules; MathJax reads the formula. The book leaves the cell out.
DEFINITIONS = "\n".join(
    (
        "---",
        "<!--: Numbers and colours of formulas, for MyST in JupyterLab and for MathJax",
        "numbering:",
        "  equation: false",
        "math:",
        *(f"  {macro}: {meaning}" for macro, meaning in MACROS.items()),
        "# -->",
        "---",
        "",
        "$" + "".join(rf"\def{macro}#1{{{meaning}}}" for macro, meaning in MACROS.items()) + "$",
    )
)
FOLDED = {
    "hide-input": ["source"],
    "remove-input": ["source"],
    "hide-cell": ["source", "outputs"],
}
PROMPTS = {"code_prompt_show": "Show the solution", "code_prompt_hide": "Hide the solution"}
KERNEL = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def define_colours(cells: list[NotebookNode]) -> None:
    """Begin a notebook with the macros of its formulas."""
    if cells[0].id != "colours":
        cells.insert(0, new_markdown_cell(id="colours"))
    cells[0].update(source=DEFINITIONS, metadata={"tags": ["remove-cell"]})


def numbered(equation: Block) -> str:
    """Return an equation with the options by which JupyterLab gives it the paper's number."""
    number = equation.anchor.removeprefix("eq-")
    options = equation.options | {"enumerated": "true", "enumerator": number}
    lines = "".join(f":{name}: {value}\n" for name, value in options.items())
    return f":::{{math}}\n{lines}\n{equation.body}\n:::"


def fold(cell: NotebookNode) -> None:
    """Fold solutions in the book, and in JupyterLab what the book folds."""
    if part_of(cell.id)[0] == "solution":
        cell.metadata["tags"] = sorted(tags(cell) | {"hide-cell"})
        cell.metadata["mystnb"] = cell.metadata.get("mystnb", {}) | PROMPTS
    cell.metadata.pop("jupyter", None)
    hidden = {f"{part}_hidden": True for tag in tags(cell) for part in FOLDED.get(tag, [])}
    if hidden:
        cell.metadata["jupyter"] = hidden


def derive(file: Path) -> None:
    """Bring a page up to date."""
    page = Page(file)
    time = count(page).time
    if file.suffix == ".md":
        file.write_text(TIME.sub(time, page.text), "utf-8")
        return
    define_colours(page.cells)
    for cell in page.cells:
        if cell.cell_type == "code":
            fold(cell)
            continue
        cell.source = TIME.sub(time, cell.source)
        for block in blocks(cell.source):
            if block.kind == "math":
                cell.source = cell.source.replace(block.source, numbered(block))
    page.notebook.metadata = KERNEL
    nbformat.write(page.notebook, file)


def derive_citation(file: Path, book: str, repository: str) -> None:
    """Give a citation the addresses of book and repository, as far as they have any."""
    addresses = {"url": book, "repository-code": repository}
    lines = "".join(f'{name}: "{url}"\n' for name, url in addresses.items() if url)
    bare = re.sub(r"(?m)^(url|repository-code): .*\n", "", file.read_text("utf-8"))
    file.write_text(re.sub(r"(?m)^authors:$", rf"{lines}\g<0>", bare), "utf-8")


def derive_version(root: Path, version: str) -> None:
    """Name everywhere the version of the package, and in the citation its date if it has one."""
    heading = rf"(?m)^## \[{re.escape(version)}\] - (\S+)$"
    date = re.search(heading, (root / "CHANGELOG.md").read_text("utf-8"))
    dated = f"version: {version}\n" + (f"date-released: {date[1]}\n" if date else "")
    for name, old, new in (
        ("CITATION.cff", r"(?m)^version: .*\n(date-released: .*\n)?", dated),
        ("book/run-a-class.md", r"rotedu-[\d.]+-py3", f"rotedu-{version}-py3"),
    ):
        file = root / name
        file.write_text(re.sub(old, new, file.read_text("utf-8")), "utf-8")


def derive_all() -> None:
    """Bring pages and record up to date."""
    for page in pages().values():
        derive(page.file)
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["rotedu"]
    derive_citation(ROOT / "CITATION.cff", settings["book"], settings["repository"])
    derive_version(ROOT, __version__)


if __name__ == "__main__":
    derive_all()
