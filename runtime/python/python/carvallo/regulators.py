"""Linear quadratic regulators: gains that keep a machine upright."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._dicts import AskedRegulators
from .values import items_of

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
    """Of shape (speeds, inputs, states), in units of the inputs by those of the states: those of the SI unless others were asked
    for."""
    eigenvalues: NDArray[np.complex128]
    """Those of the closed loop in 1/s, of shape (speeds, states), sorted by real part, then by imaginary part."""
    unstable_between: tuple[tuple[float, float], ...]
    """Speeds between which gains that are interpolated linearly do not hold the machine."""

    def __init__(self, design: Described, asked: AskedRegulators) -> None:
        self._name, self._about, self._designs, self._asked = design.name, design._about, design._one(), asked
        self._names = tuple(design.model)
        told = self._designs.lqr(self._about, asked)
        found = told["speeds"]
        self.v = None if found is None else np.array(found)
        self.inputs, self.states = tuple(told["inputs"]), tuple(told["states"])
        self.gains, self.eigenvalues = told["gains"], told["eigenvalues"]
        self.unstable_between = tuple((low, high) for low, high in told["unstable"])

    def sensitivities(self) -> dict[str, NDArray[np.float64]]:
        """The derivatives of the gains by each parameter of the design, by their names: arrays of the shape of :attr:`gains`, in their
        units by that of the parameter. Exact, by a Lyapunov equation for each; weights and the gains of feedback stay what they are.

        Raises
        ------
        ValueError
            If the model was compiled without derivatives.
        """
        found = self._designs.lqr_sensitivities(self._about, self._asked)
        return {name: found[:, place] for place, name in enumerate(self._names)}

    def to_rust(self) -> str:
        """A module of Rust without the standard library that interpolates the gains along the speed, in SI
        units."""
        return self._designs.lqr_code(self._about, self._asked, "rust")

    def to_c(self) -> str:
        """The same in C99."""
        return self._designs.lqr_code(self._about, self._asked, "c")

    def __repr__(self) -> str:
        speeds = "" if self.v is None else f" at {len(self.v)} speeds"
        return f"<regulators of {self._name} by {', '.join(self.inputs)}{speeds}>"


def lqr_of(design: Described, v: ArrayLike, inputs: list[str] | None, weights: Mapping[str, float] | None,
           units: str) -> Regulators:
    """What :meth:`Design.lqr` does."""
    texts = [f"{name}={_weight(name, weight)!r}" for name, weight in items_of("weights", weights or {})]
    speeds = [float(speed) for speed in np.atleast_1d(np.asarray(v, dtype=float)).reshape(-1)]
    if not speeds:
        raise ValueError("expected at least one speed")
    if any(not np.isfinite(speed) or speed < 0.0 for speed in speeds):
        raise ValueError("speeds must be finite and >= 0")
    return Regulators(design, {"speeds": speeds, "inputs": inputs, "weights": texts, "units": units})


def _weight(name: str, weight: float) -> float:
    try:
        return float(weight)
    except (TypeError, ValueError):
        raise ValueError(f"the weight of `{name}` is {weight!r}; expected a number") from None


__all__ = ["Regulators"]
