"""Run the notebooks of the book and store them as they are committed.

The notebooks keep execution counts and printed outputs, which the tests compare. They lose their
pictures, because the build of the book draws them again. What a page folds or leaves out is folded
in JupyterLab. Name notebooks to run only those.
"""

import os
import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient

BOOK = Path(__file__).parents[1] / "book"
FOLDED = {
    "hide-input": ["source"],
    "remove-input": ["source"],
    "hide-cell": ["source", "outputs"],
}


def is_picture(output: nbformat.NotebookNode) -> bool:
    """Tell whether an output shows a picture."""
    return any(mime.startswith("image/") for mime in output.get("data", {}))


def folds(cell: nbformat.NotebookNode) -> dict[str, bool]:
    """Return how JupyterLab folds a cell, from the tags by which the book folds it."""
    tags = cell.metadata.get("tags", [])
    return {f"{part}_hidden": True for tag in tags for part in FOLDED.get(tag, [])}


def run(file: Path) -> None:
    """Execute a notebook in place."""
    notebook = nbformat.read(file, as_version=4)
    client = NotebookClient(notebook, timeout=300, kernel_name="python3", coalesce_streams=True)
    client.execute()
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        if cell.cell_type == "code":
            cell.outputs = [output for output in cell.outputs if not is_picture(output)]
            cell.metadata.pop("jupyter", None)
            if folded := folds(cell):
                cell.metadata["jupyter"] = folded
    notebook.metadata = {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    nbformat.write(notebook, file)


if __name__ == "__main__":
    # Draw without a window on every machine.
    os.environ["PYVISTA_JUPYTER_BACKEND"] = "still"
    for file in map(Path, sys.argv[1:] or sorted(BOOK.glob("*.ipynb"))):
        print(f"running {file.name}", flush=True)
        run(file)
