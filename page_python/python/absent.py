"""What a page does not have, or not yet: other libraries, and the words that say so."""

import importlib.machinery
import os
import sys
from typing import Any, NoReturn

import shelf

# A page imports these in its first cell, for cells that run at a desk.
KNOWN = {"IPython", "pyvista", "scipy", "sympy"}
# What is fetched when a cell first uses it; nothing when it is here.
LATER = {"matplotlib", "mpl_toolkits", "pylab"}
# The styles that cells choose for charts before that.
STYLES: list[Any] = []
WORDS = (
    "{} is not in this page, which has NumPy, Matplotlib and rotedu alone."
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

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise NotInPage(self._name)

    __call__ = __iter__ = __getitem__ = __setattr__ = __setitem__ = _refuse


class Later(Absent):
    """A module that is not here yet: what is asked of it is asked of the real one, once it is."""

    def __getattr__(self, name: str) -> Any:
        if LATER:
            full = f"{self._name}.{name}"
            if full == "matplotlib.pyplot.style":
                return Later("matplotlib.style")
            if full == "matplotlib.style.use":
                return STYLES.append
            # Python itself asks modules for such names.
            if name.startswith("__") and name not in ("__all__", "__version__"):
                raise AttributeError(name)
            provide()
        module = importlib.import_module(self._name)
        if name == "__all__":
            return [each for each in dir(module) if not each.startswith("_")]
        return getattr(module, name)


def provide() -> None:
    """Fetch Matplotlib, and set it up for the page."""
    if why := shelf.unpack_charts():
        raise ConnectionError(f"Matplotlib could not be fetched ({why}). Run tries again.")
    for name in [name for name in sys.modules if name.partition(".")[0] in LATER]:
        del sys.modules[name]
    LATER.clear()
    importlib.invalidate_caches()
    # It would say that it lists its letters. A page without charts needs no logging.
    logging = importlib.import_module("logging")
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    os.environ["MPLBACKEND"] = "module://charts"
    pyplot = importlib.import_module("matplotlib.pyplot")
    for style in STYLES:
        pyplot.style.use(style)


class Finder:
    """Lets a page import what it knows to be absent, and says of all else that it is absent."""

    @staticmethod
    def find_spec(name: str, path: Any = None, target: Any = None) -> Any:
        """Find one of the absent libraries."""
        if name.partition(".")[0] in KNOWN | LATER:
            return importlib.machinery.ModuleSpec(name, Finder, is_package=True)
        # Matplotlib here draws for the page alone.
        elsewhere = path is None or name.startswith("matplotlib.backends.backend_")
        if elsewhere and name != "__main__" and not name.startswith("_"):
            raise NotInPage(name)
        return None

    @staticmethod
    def create_module(spec: Any) -> None:
        """Let Python make the module."""

    @staticmethod
    def exec_module(module: Any) -> None:
        """Give a module names that are absent."""
        stand_in = Later if module.__name__.partition(".")[0] in LATER else Absent
        module.__getattr__ = stand_in(module.__name__).__getattr__


def announce() -> None:
    """Tell Python where to look last."""
    sys.meta_path.append(Finder)
