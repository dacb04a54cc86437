import numpy as np
import pytest

from rotedu.edition.notebook import agree, source
from rotedu.ordinary_rotation import rotate


def test_source_is_the_code_without_its_docstring() -> None:
    code = repr(source(rotate))
    assert "def rotate(" in code
    assert '"""' not in code
    assert "cross(n, r)" in code
    compile(code, "rotate", "exec")


def test_source_is_shown_as_code() -> None:
    assert source(rotate)._repr_markdown_() == f"```python\n{source(rotate)!r}\n```"


def test_agree_fails_beyond_the_bound() -> None:
    with pytest.raises(AssertionError, match=r"at most 1e-03, got 2\.0e-03"):
        agree([1.0, 2.0], [1.0, 2.002], within=1e-3)


def test_agree_fails_for_nan() -> None:
    with pytest.raises(AssertionError, match="got nan"):
        agree([np.nan], [1.0], within=1e-3)


def test_agree_wants_one_shape() -> None:
    with pytest.raises(ValueError, match=r"\(2,\) and \(1, 2\)"):
        agree([1.0, 2.0], [[1.0, 2.0]], within=1)
