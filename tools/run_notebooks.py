"""Run the notebooks of the book and store them as they are committed.

The notebooks keep execution counts and printed outputs, which the tests compare. They lose their
pictures, because the build of the book draws them again. At the end ``derive.py`` brings all pages
up to date. Name notebooks to run only those.
"""

import os
import sys
from pathlib import Path

import nbformat
from derive import derive_all
from nbclient import NotebookClient
from notebook_language import notebooks


def is_picture(output: nbformat.NotebookNode) -> bool:
    """Tell whether an output shows a picture."""
    return any(mime.startswith("image/") for mime in output.get("data", {}))


def run(file: Path) -> None:
    """Execute a notebook in place."""
    notebook = nbformat.read(file, as_version=4)
    client = NotebookClient(notebook, timeout=300, kernel_name="python3", coalesce_streams=True)
    client.execute()
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        if cell.cell_type == "code":
            cell.outputs = [output for output in cell.outputs if not is_picture(output)]
    nbformat.write(notebook, file)


if __name__ == "__main__":
    # Draw without a window on every machine, in a kernel that warns of errors alone.
    os.environ["PYVISTA_JUPYTER_BACKEND"] = "still"
    os.environ["JUPYTER_PATH"] = str(Path(__file__).parent / "jupyter")
    for file in [Path(name) for name in sys.argv[1:]] or [page.file for page in notebooks()]:
        print(f"running {file.name}", flush=True)
        run(file)
    derive_all()
