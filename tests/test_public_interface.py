"""The public interface of `rotedu` stands in public-interface.txt, so each change of it is a diff.

``.venv/bin/python tests/test_public_interface.py`` writes the file anew.
"""

import importlib
import inspect
import pkgutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_origin

import rotedu

FILE = Path(__file__).with_name("public-interface.txt")


def line(name: str, value: Any) -> str:
    """Return a name, with the parameters of what can be called, and their defaults if plain."""
    kind = get_origin(value) or value
    if inspect.isclass(kind) and issubclass(kind, dict):
        # Python 3.13 sees parameters of such a class, earlier ones do not.
        return name
    try:
        parameters = inspect.signature(value).parameters.values()
    except (TypeError, ValueError):
        return name
    plain = (bool, int, float, str, type(None))
    words = []
    for one in parameters:
        default = repr(one.default) if type(one.default) in plain else "..."
        words.append(one.name if one.default is one.empty else f"{one.name}={default}")
    return f"{name}({', '.join(words)})"


def interface() -> Iterator[str]:
    """Yield a line for each name in the `__all__` of a module, and for each method of a class."""
    for module in (m.name for m in pkgutil.walk_packages(rotedu.__path__, "rotedu.")):
        # The scenes themselves offer what their modules do.
        if "._" in module or module.startswith("rotedu.scenes."):
            continue
        loaded = importlib.import_module(module)
        for name in sorted(getattr(loaded, "__all__", ())):
            value = getattr(loaded, name)
            yield line(f"{module}.{name}", value)
            if inspect.isclass(value):
                methods = (m for m in sorted(vars(value)) if not m.startswith("_"))
                yield from (line(f"    {m}", getattr(value, m)) for m in methods)


def test_a_change_of_the_public_interface_is_seen() -> None:
    listed = FILE.read_text("utf-8").splitlines()
    assert list(interface()) == listed, "If this is meant, call this file with Python"


if __name__ == "__main__":
    FILE.write_text("\n".join([*interface(), ""]), "utf-8")
