"""Linear quadratic regulators: gains that keep a machine upright."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._dicts import AskedRegulators

if TYPE_CHECKING:
    from ._described import Described


class Regulators:
    """Gains K of ``u = -K x`` along speeds."""

    v: NDArray[np.float64] | None
    """The speeds in m/s, ascending; None where nothing depends on them, and there is one regulator."""
    inputs: tuple[str, ...]
    """The inputs u, such as ``Tdelta``."""
    states: tuple[str, ...]
    """The states x, such as ``phi``, ``delta``, ``phi_rate``, ``delta_rate``."""
    gains: NDArray[np.float64]
    """Of shape (speeds, inputs, states), in SI units."""
    eigenvalues: NDArray[np.complex128]
    """Those of the closed loop in 1/s, of shape (speeds, states), sorted by real part, then by imaginary part."""
    unstable_between: tuple[tuple[float, float], ...]
    """Speeds between which gains that are interpolated linearly do not hold the machine."""

    def __init__(self, design: Described, asked: AskedRegulators) -> None:
        self._name, self._about, self._designs, self._asked = design.name, design._about, design._one(), asked
        told = self._designs.lqr(self._about, asked)
        found = told["speeds"]
        self.v = None if found is None else np.array(found)
        self.inputs, self.states = tuple(told["inputs"]), tuple(told["states"])
        self.gains, self.eigenvalues = told["gains"], told["eigenvalues"]
        self.unstable_between = tuple((low, high) for low, high in told["unstable"])

    def to_rust(self) -> str:
        """A module of Rust without the standard library that interpolates the gains along the speed."""
        return self._designs.lqr_code(self._about, self._asked, "rust")

    def to_c(self) -> str:
        """The same in C99."""
        return self._designs.lqr_code(self._about, self._asked, "c")

    def __repr__(self) -> str:
        speeds = "" if self.v is None else f" at {len(self.v)} speeds"
        return f"<regulators of {self._name} by {', '.join(self.inputs)}{speeds}>"


def lqr_of(design: Described, v: ArrayLike, inputs: list[str] | None, weights: Mapping[str, float] | None) -> Regulators:
    """What :meth:`Design.lqr` does."""
    texts = [f"{name}={_weight(name, weight)!r}" for name, weight in (weights or {}).items()]
    speeds = [float(speed) for speed in np.atleast_1d(np.asarray(v, dtype=float)).reshape(-1)]
    if not speeds:
        raise ValueError("expected at least one speed")
    if any(not np.isfinite(speed) or speed < 0.0 for speed in speeds):
        raise ValueError("speeds must be finite and >= 0")
    return Regulators(design, {"speeds": speeds, "inputs": inputs, "weights": texts})


def _weight(name: str, weight: float) -> float:
    try:
        return float(weight)
    except (TypeError, ValueError):
        raise ValueError(f"the weight of `{name}` is {weight!r}; expected a number") from None


__all__ = ["Regulators"]
