"""What parts of a design are written against."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from . import _carvallo
    from ._dicts import About
    from .model import Model


class Described(ABC):
    """One design with what is known of it, or an array of designs."""

    name: str
    """What the design is called."""
    model: Model
    """The model that it is of."""
    _values: list[float | NDArray[np.float64]]
    _kernel: _carvallo.Kernel
    _designs: _carvallo.Designs
    _about: About

    @property
    @abstractmethod
    def shape(self) -> tuple[int, ...]:
        """The shape of the array of designs; ``()`` for one design."""

    @abstractmethod
    def _one(self) -> _carvallo.Designs:
        """For what there is of one design alone."""


__all__ = ["Described"]
