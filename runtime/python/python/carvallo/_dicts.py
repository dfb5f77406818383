"""What goes to and fro between this package and its extension module."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypedDict

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from ._carvallo import Kernel


class Loaded(TypedDict):
    """A design that was read; parameters in the order of the model, deviations 0 where there is none."""

    kernel: Kernel
    name: str
    kind: str | None
    source: str | None
    values: list[float]
    deviations: list[float]
    correlations: list[tuple[int, int, float]]
    feedback: list[str]
    notes: list[str]
    warnings: list[str]


class About(TypedDict):
    """What is known of a design beside its parameters."""

    name: str
    kind: str | None
    source: str | None
    deviations: list[float]
    correlations: list[tuple[int, int, float]]
    feedback: list[str]


class AskedNames(TypedDict):
    """Inputs and outputs by their names, and the units that they are in, as ``deg,km/h`` or ``si``."""

    inputs: list[str] | None
    outputs: list[str] | None
    units: str


class AskedPorts(TypedDict):
    """Between what, at which speed in m/s."""

    speed: float
    names: AskedNames


class AskedTransfers(TypedDict):
    """Between what, and at which frequencies in rad/s: a list, or from one to another."""

    ports: AskedPorts
    omega: tuple[float, float] | list[float] | None


class AskedResponse(TypedDict):
    """To what, and at which times; ``kind`` is ``step``, ``impulse`` or ``initial``."""

    ports: AskedPorts
    kind: str
    given: list[str]
    times: list[float]


class Responded(TypedDict):
    """A response as an array, by time and output; outputs have names and units."""

    outputs: list[tuple[str, str]]
    t: NDArray[np.float64]
    values: NDArray[np.float64]
    end: str | None
    title: str


class AskedMeasures(TypedDict):
    """At which speeds in m/s, between what."""

    speeds: list[float] | None
    inputs: list[str] | None
    outputs: list[str] | None


class Measured(TypedDict):
    """Modal measures: arrays run over the speeds, the modes, and the inputs or outputs."""

    speeds: list[float] | None
    inputs: list[str]
    outputs: list[str]
    modes: list[str]
    eigenvalues: NDArray[np.complex128]
    controllability: NDArray[np.float64]
    observability: NDArray[np.float64]
    excitation: NDArray[np.complex128]
    share: NDArray[np.complex128]
    lost: list[tuple[str, bool, float, complex]]


class AskedAlong(TypedDict):
    """``NAME=LOW:HIGH`` and a speed in m/s."""

    range: str
    speed: float | None


class ToldAlong(TypedDict):
    """A design along a parameter; critical values are fields of :class:`CriticalValue`."""

    parameter: str
    unit: str
    speed: float | None
    critical_values: list[tuple[str, float, float, complex, str, str, str]]
    stable: list[tuple[float, float]]
    undecided: list[tuple[float, float]]
    values: NDArray[np.float64]
    verdicts: list[str]
    eigenvalues: NDArray[np.complex128]


class AskedRegulators(TypedDict):
    """At which speeds in m/s, by which inputs, weights as ``NAME=VALUE``, and units as ``deg,km/h`` or ``si``."""

    speeds: list[float]
    inputs: list[str] | None
    weights: list[str]
    units: str


class Regulated(TypedDict):
    """Regulators along speeds: arrays run over the speeds first."""

    speeds: list[float] | None
    inputs: list[str]
    states: list[str]
    gains: NDArray[np.float64]
    eigenvalues: NDArray[np.complex128]
    unstable: list[list[float]]


class AskedEvent(TypedDict):
    """A function of the time and the state, which ends the motion when it has changed its sign so often."""

    name: str
    function: Callable[[float, dict[str, float]], float]
    ends: int | None
    direction: float


class Asked(TypedDict):
    """What a motion begins with, what acts on it, and by which equations it goes."""

    speed: float
    times: list[float]
    initial: list[str]
    constant: list[str]
    varying: list[tuple[str, list[tuple[float, float]]]]
    events: list[AskedEvent]
    linear: bool


class Told(TypedDict):
    """A motion as arrays, by time and quantity."""

    is_linear: bool
    quantities: list[tuple[str, str, str]]
    wheels: list[str]
    t: NDArray[np.float64]
    positions: NDArray[np.float64]
    rates: NDArray[np.float64]
    accelerations: NDArray[np.float64]
    energy: NDArray[np.float64] | None
    contact_forces: NDArray[np.float64]
    feedback: NDArray[np.float64]
    laws: list[tuple[str, str]]
    happened: list[int]
    happened_t: NDArray[np.float64]
    happened_positions: NDArray[np.float64]
    happened_rates: NDArray[np.float64]
    happened_accelerations: NDArray[np.float64]
    end: str | None
    notes: list[str]


class Derivatives(TypedDict):
    """The derivatives of a critical speed with respect to each parameter, or the reason why it has none."""

    name: str
    speed: float
    eigenvalue: complex
    by: list[float]
    eigenvalue_by: list[complex]
    deviation: float | None
    shares: list[float] | None
    reason: str | None


class Curve(TypedDict):
    """A curve of turns; lists run over the turns."""

    capsize: float | None
    begin: str
    end: str
    speed: list[float]
    radius: list[float | None]
    verdict: list[str]
    eigenvalues: list[list[complex]]
    positions: list[tuple[str, list[float]]]
    rates: list[tuple[str, list[float]]]
