"""What parts of a design are written against."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from . import _carvallo
    from ._dicts import About


class Described(ABC):
    """One design with what is known of it."""

    name: str
    """What the design is called."""
    _about: About

    @abstractmethod
    def _one(self) -> _carvallo.Designs:
        """For what there is of one design alone."""
