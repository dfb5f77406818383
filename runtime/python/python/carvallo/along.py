"""Stability along a parameter, at one speed."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._dicts import AskedAlong
from .motion import as_quantity
from .pictures import Picture

if TYPE_CHECKING:
    from ._described import Described


class CriticalValue(NamedTuple):
    """A value of a parameter at which the kind of motion changes."""

    name: str
    """As :class:`CriticalSpeed` has it."""
    value: float
    """In the unit of the parameter."""
    error: float
    """An estimate of the absolute error of the value."""
    eigenvalue: complex
    """In 1/s."""
    change: str
    """What changes as the parameter grows: ``stabilizes``, ``destabilizes``, ``merges``, ``splits`` or ``touches``."""
    below: str
    """Whether the motion is stable just below: ``stable``, ``marginal`` or ``unstable``."""
    above: str
    """The same just above."""


class Along:
    """One design along one of its parameters, at a fixed speed: critical values are not scanned for."""

    parameter: str
    """Its name."""
    unit: str
    """Its unit, ``1`` for a pure number."""
    v: float | None
    """The speed in m/s; None where nothing depends on it."""
    critical_values: tuple[CriticalValue, ...]
    """All of them between the ends, ascending."""
    stable_ranges: tuple[tuple[float, float], ...]
    """The ranges of the parameter in which the design is stable."""
    undecided_ranges: tuple[tuple[float, float], ...]
    """The ranges in which a critical value may be missing: nearly always none."""
    values: NDArray[np.float64]
    """Values of the parameter from end to end, of shape (count,)."""
    eigenvalues: NDArray[np.complex128]
    """There in 1/s, of shape (count, states), sorted by real part, then by imaginary part."""
    verdicts: tuple[str, ...]
    """``stable``, ``marginal`` or ``unstable`` at each of the values."""

    def __init__(self, design: Described, asked: AskedAlong, count: int) -> None:
        self._name, self._about, self._designs, self._asked = design.name, design._about, design._one(), asked
        told = self._designs.along(self._about, asked, count)
        self.parameter, self.unit, self.v = told["parameter"], told["unit"], told["speed"]
        self.critical_values = tuple(CriticalValue(*value) for value in told["critical_values"])
        self.stable_ranges, self.undecided_ranges = tuple(told["stable"]), tuple(told["undecided"])
        self.values, self.eigenvalues, self.verdicts = told["values"], told["eigenvalues"], tuple(told["verdicts"])

    def plot(self, values: tuple[float, float] | None = None) -> Picture:
        """The eigenvalues against the parameter, between two values in 1/s or as far as there is something to see."""
        return Picture(self._designs.along_svg(self._about, self._asked, values))

    def _repr_svg_(self) -> str:
        return self.plot().svg

    def __repr__(self) -> str:
        return f"<{self._name} along {self.parameter}: {len(self.critical_values)} critical values>"


def along_of(design: Described, parameter: str, low: float | str, high: float | str, v: float | None, count: int) -> Along:
    """What :meth:`Design.along` does."""
    if count < 2:
        raise ValueError(f"`count` is {count}; it must be >= 2, for both ends")
    asked: AskedAlong = {"range": f"{parameter}={as_quantity(low)}:{as_quantity(high)}",
                         "speed": None if v is None else float(v)}
    return Along(design, asked, count)


__all__ = ["Along", "CriticalValue"]
