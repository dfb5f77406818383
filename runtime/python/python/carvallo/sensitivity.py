"""How critical speeds change with parameters, and what measured standard deviations make of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from ._described import Described


class CriticalDerivatives(NamedTuple):
    """A critical speed with its derivatives with respect to each parameter."""

    name: str
    """As :class:`CriticalSpeed` has it."""
    speed: float
    """In m/s."""
    eigenvalue: complex
    """In 1/s."""
    by: dict[str, float] | None
    """The derivatives of the speed, in m/s per unit of the parameter; None where it has none."""
    eigenvalue_by: dict[str, complex] | None
    """Those of the eigenvalue there, in 1/s per unit of the parameter."""
    deviation: float | None
    """The standard deviation of the speed in m/s; None where parameters have none."""
    shares: dict[str, float] | None
    """The share of the variance that comes from each parameter; they sum to one."""
    reason: str | None
    """Why it has no derivatives."""


class Sensitivity:
    """The derivatives of the critical speeds of one design, exact to first order: nothing is differenced."""

    critical_speeds: tuple[CriticalDerivatives, ...]
    """All of them, ascending."""
    steps: dict[str, float | None]
    """What 1 % of each parameter is, in its unit: of its value, or where that is zero of others in its unit; None where there are
    no others."""
    matrix_deviations: dict[str, NDArray[np.float64]] | None
    """The standard deviations of the entries of the matrices; None where parameters have none."""

    def __init__(self, design: Described) -> None:
        self._design, self._designs = design, design._one()
        found, steps, deviations = self._designs.sensitivity(design._about)
        names = tuple(design.model)
        self.steps = dict(zip(names, steps))
        self.critical_speeds = tuple(
            CriticalDerivatives(
                critical["name"],
                critical["speed"],
                critical["eigenvalue"],
                None if critical["reason"] else dict(zip(names, critical["by"])),
                None if critical["reason"] else dict(zip(names, critical["eigenvalue_by"])),
                critical["deviation"],
                None if critical["shares"] is None else dict(zip(names, critical["shares"])),
                critical["reason"],
            )
            for critical in found
        )
        has = design.model.matrices
        arrays = {name: np.array(rows) for name, rows in deviations or () if name in has}
        self.matrix_deviations = None if deviations is None else arrays

    def svg(self) -> str:
        """What 1 % of each parameter does to the critical speeds, as SVG."""
        return self._designs.sensitivity_svg(self._design._about)

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        return f"<sensitivity of {self._design.name}: {len(self.critical_speeds)} critical speeds>"


__all__ = ["CriticalDerivatives", "Sensitivity"]
