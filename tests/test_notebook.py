import numpy as np
import pytest

from rotedu.edition.notebook import agree, source
from rotedu.quaternions import Quaternion


@pytest.mark.parametrize(
    ("found", "said"), [(2.002, r"at most 1e-03, got 2\.0e-03"), (np.nan, "nan")]
)
def test_agree_fails_beyond_the_bound(found: float, said: str) -> None:
    with pytest.raises(AssertionError, match=said):
        agree([1.0, found], [1.0, 2.0], within=1e-3)


def test_agree_wants_one_shape() -> None:
    with pytest.raises(ValueError, match=r"\(2,\) and \(1, 2\)"):
        agree([1.0, 2.0], [[1.0, 2.0]], within=1)


def test_nothing_agrees_with_nothing() -> None:
    assert str(agree([], [], within=1)).startswith("0 numbers agree")


def test_only_a_function_defined_by_def_has_a_listing() -> None:
    with pytest.raises(ValueError, match=r"^function: expected one defined by `def`"):
        source(Quaternion)
