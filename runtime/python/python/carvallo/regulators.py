"""Linear quadratic regulators: gains that keep a machine upright."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from .design import Design


class Regulators(NamedTuple):
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


def lqr_of(design: Design, v: ArrayLike, inputs: str | Sequence[str] | None, weights: Mapping[str, float] | None) -> Regulators:
    names = [inputs] if isinstance(inputs, str) else None if inputs is None else list(inputs)
    texts = [f"{name}={float(weight)!r}" for name, weight in (weights or {}).items()]
    speeds = [float(speed) for speed in np.atleast_1d(np.asarray(v, dtype=float)).reshape(-1)]
    if not speeds:
        raise ValueError("expected at least one speed")
    if any(not np.isfinite(speed) or speed < 0.0 for speed in speeds):
        raise ValueError("speeds must be finite and >= 0")
    told = design._one().lqr(design._about, speeds, names, texts)
    found = told["speeds"]
    return Regulators(
        None if found is None else np.array(found), tuple(told["inputs"]), tuple(told["states"]), told["gains"],
        told["eigenvalues"], tuple((low, high) for low, high in told["unstable"]))
