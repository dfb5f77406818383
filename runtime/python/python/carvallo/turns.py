"""Steady turns: circles that a machine runs in hands free."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from ._described import Described


class Turns(NamedTuple):
    """A curve of steady turns. Arrays run over the turns, in the order in which they follow from each other."""

    capsize: float | None
    """The capsize speed in m/s at which the curve begins, if it begins at one."""
    begin: str
    """Where it begins, in words."""
    end: str
    """Where it ends, in words."""
    speed: NDArray[np.float64]
    """In m/s, of the point at which the rear wheel touches the ground."""
    radius: np.ma.MaskedArray[Any, Any]
    """Of the circle that this point runs in, in m; masked for straight running."""
    verdict: tuple[str, ...]
    """``stable``, ``marginal`` or ``unstable``."""
    eigenvalues: NDArray[np.complex128]
    """In 1/s, near each turn: of shape (turns, eigenvalues)."""
    positions: dict[str, NDArray[np.float64]]
    """Lean, steer and so on, by their names, in rad."""
    rates: dict[str, NDArray[np.float64]]
    """Of the yaw and the wheels, by the names of their positions, in rad/s."""


class SteadyTurns(Sequence[Turns]):
    """All curves of steady turns of a design."""

    def __init__(self, design: Described, curves: Sequence[Turns]) -> None:
        self._designs, self._about, self._curves = design._one(), design._about, tuple(curves)

    @overload
    def __getitem__(self, index: int) -> Turns: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Turns]: ...
    def __getitem__(self, index: int | slice) -> Turns | Sequence[Turns]:
        return self._curves[index]

    def __len__(self) -> int:
        return len(self._curves)

    def svg(self) -> str:
        """The curves, as SVG."""
        return self._designs.turns_svg(self._about)

    def _repr_svg_(self) -> str:
        return self.svg()


def turns_of(design: Described, steer: ArrayLike | None) -> SteadyTurns:
    """The curves, or of them the turns with the given steers in rad; what :meth:`Design.turns` does."""
    steers = None if steer is None else np.atleast_1d(np.asarray(steer, dtype=np.float64)).tolist()
    curves = [
        Turns(
            curve["capsize"],
            curve["begin"],
            curve["end"],
            np.array(curve["speed"]),
            np.ma.MaskedArray([radius or 0.0 for radius in curve["radius"]], mask=[radius is None for radius in curve["radius"]]),
            tuple(curve["verdict"]),
            np.array(curve["eigenvalues"], dtype=np.complex128),
            {name: np.array(values) for name, values in curve["positions"]},
            {name: np.array(values) for name, values in curve["rates"]},
        )
        for curve in design._one().turns(design._about, steers)
    ]
    return SteadyTurns(design, curves)


__all__ = ["SteadyTurns", "Turns"]
