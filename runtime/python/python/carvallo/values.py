"""The values of parameters, as they are given."""

from __future__ import annotations

from collections.abc import ItemsView, Mapping
from numbers import Real
from typing import Any, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

Value = Union[float, str, ArrayLike]
"""The value of a parameter: a number, a text with a unit, or an array with one number for each design."""


Of = TypeVar("Of")


def items_of(argument: str, mapping: Mapping[str, Of]) -> ItemsView[str, Of]:
    """The names and values of an argument that maps one to the other."""
    if not isinstance(mapping, Mapping):
        raise TypeError(f"`{argument}` is {mapping!r}; expected a mapping from names to values")
    return mapping.items()


def pair_of(argument: str, pair: Any) -> tuple[Any, Any]:
    """The two ends of an argument that is a range."""
    if isinstance(pair, str) or not hasattr(pair, "__len__") or len(pair) != 2:
        raise ValueError(f"`{argument}` is {pair!r}; expected a pair, from one to another")
    return pair[0], pair[1]


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
