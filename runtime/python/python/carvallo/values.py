"""The values of parameters, as they are given."""

from __future__ import annotations

from numbers import Real
from typing import Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

Value = Union[float, str, ArrayLike]
"""The value of a parameter: a number, a text with a unit, or an array with one number for each design."""


def is_array(value: object) -> bool:
    """Whether a value has a number for each of many designs."""
    return not isinstance(value, (str, Real)) and np.ndim(value) > 0  # type: ignore[arg-type]


def as_number(name: str, value: object) -> float | NDArray[np.float64]:
    """Numbers as doubles."""
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(f"`{name}` is {value!r}; expected a number, a text with one, or an array of numbers") from None
    return array if array.ndim else float(array)


def as_text(value: object) -> str:
    """A value as it would stand in a file: numbers with all their digits."""
    return value if isinstance(value, str) else repr(float(value)) if isinstance(value, (Real, np.generic)) else str(value)


__all__ = ["Value"]
