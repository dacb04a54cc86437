"""Which code of `rotedu` a page computes with.

That is the package, without the scenes that its cells do not name and the exercises of other pages.
Docstrings and comments do not count, except in a module of which the page shows the `source`. Nor
do the hints of exercises: no page prints one, since its answers are right.
"""

import ast
import hashlib
import re
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
APART = ("scenes", "edition/exercises")
SHOWN = re.compile(r"\bsource\((\w+)")
DEFINED = re.compile(r"^(?:def|class) (\w+)", re.MULTILINE)
SCENE = re.compile(r"\bscenes\.(\w+)")
EXPORTS = re.compile(r"__all__ = \[.*?\]", re.DOTALL)
HINTS = ("when", "otherwise", "usual")
BESIDE = re.compile(r'from (?:rotedu\.scenes\.|rotedu\.edition\.exercises\.|"\./)(\w+)')


def digest(page: Path, cells: list[str]) -> str:
    """Return a digest of all that a page computes with, but for its own code."""
    code = "\n".join(cells)
    shown = set(SHOWN.findall(code))
    # No two pages share one, since pages run at the same time.
    total = hashlib.sha256(str(page).encode())
    for file in sorted(computing(page, code)):
        source = file.read_text("utf-8")
        as_written = file.suffix != ".py" or shown & set(DEFINED.findall(source))
        total.update(source.encode() if as_written else essence(source))
    return total.hexdigest()[:16]


def computing(page: Path, code: str) -> set[Path]:
    """Return the files that a page computes with."""
    package = ROOT / "rotedu"
    apart = {file for folder in APART for file in (package / folder).iterdir()}
    kinds = {".js", ".pyc"}
    files = {
        f for f in package.glob("**/*.*") if f.suffix not in kinds and f.parent.name != "static"
    }
    found = (files - apart) | {ROOT / "requirements.txt"} | with_imports(judge(page))
    for scene in scenes(frozenset(SCENE.findall(code))):
        found |= with_imports(scene.with_suffix(".js"))
        found.add(scene)
    return found


def scenes(names: frozenset[str]) -> set[Path]:
    """Return the modules of scenes that have some names, and those that they import."""
    found: set[Path] = set()
    for file in ROOT.glob("rotedu/scenes/*.py"):
        exported = EXPORTS.search(file.read_text("utf-8"))
        if exported and file.stem != "__init__" and any(f'"{n}"' in exported[0] for n in names):
            found |= with_imports(file)
    return found


def judge(page: Path) -> Path:
    """Return the module that judges a page's exercises, if it has any."""
    section = page.stem.partition("-")[2].replace("-", "_")
    return ROOT / "rotedu" / "edition" / "exercises" / f"{section}.py"


@cache
def with_imports(file: Path) -> frozenset[Path]:
    """Return a file, if it is there, and those beside it that it imports."""
    if not file.exists():
        return frozenset()
    beside = (file.with_stem(name) for name in BESIDE.findall(file.read_text("utf-8")))
    return frozenset({file}).union(*map(with_imports, beside))


@cache
def essence(source: str) -> bytes:
    """Return what a module computes."""
    return ast.dump(WithoutTexts().visit(ast.parse(source))).encode()


class WithoutTexts(ast.NodeTransformer):
    """Leaves out docstrings and hints."""

    def visit_Expr(self, node: ast.Expr) -> ast.AST | None:
        """Leave out a text that is no part of a statement."""
        return None if is_text(node.value) else self.generic_visit(node)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        """Leave in the docstring of an exercise: a verdict prints why an answer is right."""
        names = [getattr(getattr(call, "func", None), "id", "") for call in node.decorator_list]
        reason = node.body[:1] if "exercise" in names else []
        self.generic_visit(node)
        node.body[:0] = reason
        return node

    def visit_Dict(self, node: ast.Dict) -> ast.AST:
        """Leave out the first stage of a hint, a key."""
        pairs = zip(node.keys, node.values, strict=True)
        node.keys = [None if is_hint(value) else key for key, value in pairs]
        return self.generic_visit(node)

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Leave out the second stage, an argument."""
        if is_hint(node):
            node.args = [argument for argument in node.args if not is_text(argument)]
        return self.generic_visit(node)


def is_hint(node: ast.AST) -> bool:
    """Tell whether an expression makes a hint."""
    return isinstance(node, ast.Call) and getattr(node.func, "id", "") in HINTS


def is_text(node: ast.AST) -> bool:
    """Tell whether an expression is a text."""
    return isinstance(node, ast.JoinedStr) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str)
    )
