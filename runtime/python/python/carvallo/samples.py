"""Arrays of designs: drawn from what was measured, and over two parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from .design import Design


def samples_of(design: Design, count: int, seed: int | np.random.Generator | None) -> Design:
    """What :meth:`Design.samples` does."""
    design._one()
    deviations = design.deviations
    if not deviations:
        raise ValueError(f"{design.name} has no parameter with a standard deviation: there is nothing to draw")
    if count < 1:
        raise ValueError(f"`count` is {count}; it must be >= 1")
    names = list(deviations)
    correlation = np.eye(len(names))
    for (first, second), value in design.correlations.items():
        if first in deviations and second in deviations:
            pair = names.index(first), names.index(second)
            correlation[pair] = correlation[pair[::-1]] = value
    # Of correlations, and not of covariances, whose sizes differ by the units of the parameters.
    drawn = np.random.default_rng(seed).multivariate_normal(np.zeros(len(names)), correlation, count, method="eigh")
    return design.replace(**{
        name: float(design[name]) + deviations[name] * drawn[:, place] for place, name in enumerate(names)
    })


def varied_of(values: list[float | NDArray[np.float64]], shape: tuple[int, ...],
              base: Design | None) -> list[tuple[int, list[float], float | None]]:
    """Which parameter varies along each of the two axes of designs: its place, its values, and that of a design to mark."""
    if len(shape) != 2 or min(shape) < 2:
        raise ValueError(f"the designs are of shape {shape}; a map needs two axes, with at least two values along each")
    varied = []
    for axis in (0, 1):
        found = [place for place, value in enumerate(values) if not isinstance(value, float) and _varies(value, axis)]
        if len(found) != 1:
            raise ValueError(f"{len(found)} parameters vary along axis {axis} of the designs; a map needs one along each axis")
        (place,) = found
        array = values[place]
        assert not isinstance(array, float)
        if _varies(array, 1 - axis):
            raise ValueError("a parameter varies along both axes of the designs; a map needs one along each axis")
        along = array[:, 0] if axis == 0 else array[0]
        marked = None if base is None else list(base.to_dict().values())[place]
        varied.append((place, along.tolist(), marked))
    return varied


def _varies(value: NDArray[np.float64], axis: int) -> bool:
    return bool((np.diff(value, axis=axis) != 0.0).any())
