"""Which code of `rotedu` a page computes with.

That is what its cells import, and what these modules import in turn. Docstrings and comments do not
count, except in a module of which the page shows the `source`. Nor do the hints of exercises: no
page prints one, since its answers are right. What else the package holds for notebooks, such as
stored times and the style of charts, counts for every page. The pictures of a module of scenes
are drawn from its models, which count with all that they import.
"""

import ast
import hashlib
import re
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
# They only hand on names: a page needs the modules of the names that it uses.
INDEXES = ("rotedu.scenes", "rotedu.edition.exercises")
SHOWN = re.compile(r"\bsource\((\w+)")
MAGIC = re.compile("^%.*", re.MULTILINE)
USED_MODEL = re.compile(r'from "\./(\w+\.js)"')


def digest(page: Path, cells: list[str]) -> str:
    """Return a digest of all that a page computes with, but for its own code."""
    names = set().union(*map(imported, map(parsed, cells)))
    shown = SHOWN.findall("\n".join(cells))
    shown_files = {file_of(name.rpartition(".")[0]) for name in names if says(name, shown)}
    # No two pages share one, since pages run at the same time.
    total = hashlib.sha256(str(page).encode())
    for file in sorted(modules(names | {judge(page)})):
        total.update(essence(file) if file not in shown_files else file.read_bytes())
        for model in sorted(models(file.with_suffix(".js"))):
            total.update(model.read_bytes())
    for file in (*data(), ROOT / "requirements.txt"):
        total.update(file.read_bytes())
    return total.hexdigest()[:16]


def modules(names: set[str]) -> set[Path]:
    """Return the files of what dotted names stand for, and of all that these import."""
    found: dict[str, Path] = {}
    seen: set[str] = set()
    left = set(names)
    while left:
        name = left.pop()
        seen.add(name)
        package = name.rpartition(".")[0]
        file = file_of(name)
        if file and name not in INDEXES:
            found[name] = file
            left |= imported_by(file)
        elif not file and package in INDEXES:
            used = name.rpartition(".")[2]
            left |= {other for other in imported_by(file_of(package)) if brings(other, used)}
        # Python runs the package before what is in it.
        left |= {package} - {""}
        left -= seen
    return set(found.values())


def imported(code: ast.AST) -> set[str]:
    """Return the dotted names of what code takes from rotedu, also by ``scenes.figure_1``."""
    names: set[str] = set()
    for node in ast.walk(code):
        match node:
            case ast.Import():
                names |= {alias.name for alias in node.names}
            case ast.ImportFrom():
                names |= {f"{node.module}.{alias.name}" for alias in node.names}
            case ast.Attribute(value=ast.Name(id="scenes")):
                names.add(f"rotedu.scenes.{node.attr}")
    return {name for name in names if name.split(".")[0] == "rotedu"}


def parsed(cell: str) -> ast.Module:
    """Parse a cell; one that is no Python imports nothing, and fails when it runs."""
    try:
        return ast.parse(MAGIC.sub("", cell))
    except SyntaxError:
        return ast.Module([], [])


def judge(page: Path) -> str:
    """Return the name of the module that judges a page's exercises; without a section, of all."""
    section = page.stem.partition("-")[2].replace("-", "_")
    return f"rotedu.edition.exercises.{section}".rstrip(".")


def data() -> list[Path]:
    """Return the files of the package that are no code, but for the bundle of the viewer."""
    code = {".js", ".py", ".pyc"}
    files = (file for file in ROOT.glob("rotedu/**/*.*") if file.suffix not in code)
    return sorted(file for file in files if file.parent.name != "static")


@cache
def models(file: Path) -> frozenset[Path]:
    """Return a file of models, if it is there, and those that it imports."""
    if not file.exists():
        return frozenset()
    used = (file.with_name(name) for name in USED_MODEL.findall(file.read_text("utf-8")))
    return frozenset({file}).union(*map(models, used))


def says(name: str, last: list[str]) -> bool:
    """Tell whether a dotted name ends with one of some names."""
    return name.rpartition(".")[2] in last


def brings(imported: str, name: str) -> bool:
    """Tell whether what a module imports, perhaps all of another module, has a name."""
    module, _, last = imported.rpartition(".")
    return last == name or (last == "*" and f'"{name}"' in exports(module))


@cache
def exports(module: str) -> str:
    """Return what a module says that it exports."""
    file = file_of(module)
    text = file.read_text("utf-8") if file else ""
    return text.partition("__all__ = [")[2].partition("]")[0]


def file_of(name: str) -> Path | None:
    """Return the file of a module or package, if a dotted name is one."""
    path = ROOT.joinpath(*name.split("."))
    files = (path.with_suffix(".py"), path / "__init__.py")
    return next((file for file in files if file.exists()), None)


@cache
def imported_by(file: Path) -> set[str]:
    """Return the dotted names of what a module takes from rotedu."""
    return imported(ast.parse(file.read_bytes()))


@cache
def essence(file: Path) -> bytes:
    """Return what a module computes."""
    return ast.dump(WithoutTexts().visit(ast.parse(file.read_bytes()))).encode()


class WithoutTexts(ast.NodeTransformer):
    """Leaves out docstrings and hints."""

    def visit_Expr(self, node: ast.Expr) -> ast.AST | None:
        """Leave out a text that is no part of a statement."""
        return None if is_text(node.value) else self.generic_visit(node)

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Leave out the texts of what makes a hint."""
        if is_hint(node):
            node.args = [argument for argument in node.args if not is_text(argument)]
        return self.generic_visit(node)

    def visit_Dict(self, node: ast.Dict) -> ast.AST:
        """Leave out the first stages of hints."""
        pairs = zip(node.keys, node.values, strict=True)
        node.keys = [None if is_hint(value) else key for key, value in pairs]
        return self.generic_visit(node)


def is_hint(node: ast.AST) -> bool:
    """Tell whether an expression makes a hint of an exercise."""
    names = ("when", "otherwise", "usual")
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in names


def is_text(node: ast.AST) -> bool:
    """Tell whether an expression is a text."""
    return isinstance(node, ast.JoinedStr) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str)
    )
