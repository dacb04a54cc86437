"""What a page does not have: libraries that draw or need a compiler, and the words that say so."""

import importlib.machinery
import sys
from typing import Any, NoReturn

# A page imports these in its first cell, for cells that run at a desk.
KNOWN = ("IPython", "matplotlib", "pyvista", "scipy", "sympy")
# Settings for pictures, which nobody draws here.
SETTINGS = ("matplotlib.pyplot.rcParams.update", "matplotlib.pyplot.style.use")
WORDS = (
    "{} is not in this page, which has NumPy and rotedu alone."
    " It works in the notebook of the page, at a desk."
)


class NotInPage(ModuleNotFoundError):  # noqa: N818 (a reader sees the name)
    """Something needs more than a page has."""

    # As an error of Python it is shown without the name of a module.
    __module__ = "builtins"

    def __init__(self, what: str) -> None:
        super().__init__(WORDS.format(what))


class Absent:
    """A name of an absent library: it may be imported and looked into, but not used."""

    def __init__(self, name: str) -> None:
        vars(self)["_name"] = name

    def __getattr__(self, name: str) -> "Absent":
        if name.startswith("__"):
            raise AttributeError(name)
        return Absent(f"{self._name}.{name}")

    def __call__(self, *_: Any, **__: Any) -> None:  # noqa: D102
        if self._name not in SETTINGS:
            self._refuse()

    def _refuse(self, *_: Any) -> NoReturn:
        raise NotInPage(self._name)

    __iter__ = __getitem__ = __setattr__ = __setitem__ = _refuse


class Finder:
    """Lets a page import what it knows to be absent, and says of all else that it is absent."""

    @staticmethod
    def find_spec(name: str, path: Any = None, target: Any = None) -> Any:
        """Find one of the absent libraries."""
        if name.partition(".")[0] in KNOWN:
            return importlib.machinery.ModuleSpec(name, Finder, is_package=True)
        if path is None and name != "__main__" and not name.startswith("_"):
            raise NotInPage(name)
        return None

    @staticmethod
    def create_module(spec: Any) -> None:
        """Let Python make the module."""

    @staticmethod
    def exec_module(module: Any) -> None:
        """Give a module names that are absent."""
        module.__getattr__ = Absent(module.__name__).__getattr__


def announce() -> None:
    """Tell Python where to look last."""
    sys.meta_path.append(Finder)
