"""What is asked of the stability of designs."""

from __future__ import annotations

from numpy.typing import ArrayLike

from ._described import Described
from .along import Along, along_of
from .sensitivity import Sensitivity
from .stability import CriticalSpeed, Range, Stability, stability_of


class Analyzed(Described):
    """Where the stability of designs changes: along the speed, along a parameter, and with each parameter."""

    def stability(self, v: ArrayLike = (), *, threads: int | None = None) -> Stability:
        """Critical speeds and stable ranges of all designs, as masked arrays in their shape; with verdicts and eigenvalues at
        the forward speeds v in m/s.

        Critical speeds are not scanned for: all are found, to full precision.

        Raises
        ------
        ValueError
            If a design is none, or has no answer, as with a singular mass matrix. :func:`carvallo.stability` has tables in
            which single designs may be wrong.
        """
        return stability_of(self, v, threads)

    def critical_speeds(self) -> tuple[CriticalSpeed, ...]:
        """All critical speeds of one design, ascending; :meth:`stability` has those of many."""
        return tuple(CriticalSpeed(*speed) for speed in self._one().critical()[0])

    def stable_ranges(self) -> tuple[Range, ...]:
        """The ranges of forward speed in which one design is stable, ascending."""
        return tuple(Range(*ends) for ends in self._one().critical()[1])

    def marginal_ranges(self) -> tuple[Range, ...]:
        """The ranges of forward speed in which no motion of one design grows, and some do not die away."""
        return tuple(Range(*ends) for ends in self._one().critical()[2])

    def undecided_ranges(self) -> tuple[Range, ...]:
        """The ranges of forward speed in which a critical speed of one design may be missing, since rounding decides there
        whether an eigenvalue crosses the imaginary axis: nearly always none."""
        return tuple(Range(*ends) for ends in self._one().critical()[3])

    def sensitivity(self) -> Sensitivity:
        """How the critical speeds of one design change with its parameters, and what their standard deviations make of them.

        Raises
        ------
        ValueError
            If the model was compiled without derivatives.
        """
        return Sensitivity(self)

    def along(self, parameter: str, low: float | str, high: float | str, v: float | None = None, *, count: int = 101) -> Along:
        """One design along one of its parameters, at a forward speed in m/s: the values between ``low`` and ``high``, numbers in SI
        units or texts with a unit, at which its stability changes, and the eigenvalues at ``count`` values from end to end.

        Critical values are not scanned for: all are found, to full precision.

        Raises
        ------
        ValueError
            If there is no such parameter or no such range of it, if there is no speed and the model depends on it, or if there
            is no answer.
        """
        return along_of(self, parameter, low, high, v, count)


__all__ = ["Analyzed"]
