"""State spaces with inputs and outputs, and transfer functions."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _carvallo
from ._dicts import AskedNames, AskedPorts, AskedTransfers
from .pictures import Picture
from .values import pair_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ._described import Described


class InputOutput(NamedTuple):
    """The state-space form ``x' = A x + B u``, ``y = C x + D u``, as ``control.ss`` and ``scipy.signal.StateSpace`` take it."""

    A: NDArray[np.float64]
    """Of shape (speeds…, states, states)."""
    B: NDArray[np.float64]
    """Of shape (speeds…, states, inputs)."""
    C: NDArray[np.float64]
    """Of shape (speeds…, outputs, states)."""
    D: NDArray[np.float64]
    """Of shape (speeds…, outputs, inputs)."""


class Response(NamedTuple):
    """A frequency response."""

    omega: NDArray[np.float64]
    """Frequencies in rad/s."""
    gain: NDArray[np.float64]
    """The size of the output by that of the input; infinite at a pole on the imaginary axis."""
    phase: NDArray[np.float64]
    """By how much the output leads, in rad, without jumps along the frequency."""


class Margins(NamedTuple):
    """How far a transfer function is from -1, at which the loop ``u = -y`` is about to become unstable, or stable."""

    gain: tuple[tuple[float, float], ...]
    """Frequencies in rad/s at which it is real and negative, each with the factor that makes it -1."""
    phase: tuple[tuple[float, float], ...]
    """Frequencies in rad/s at which its gain is one, each with the phase margin in rad."""
    stable: bool
    """Whether the loop ``u = -y`` is stable."""


class SingularValues(NamedTuple):
    """The singular values of the matrix of transfer functions: its gains over all directions of inputs."""

    omega: NDArray[np.float64]
    """Frequencies in rad/s, without those of poles on the imaginary axis."""
    values: NDArray[np.float64]
    """Of shape (frequencies, the smaller number of inputs and outputs), descending: the largest gain first. In units of the outputs
    by those of the inputs."""


class TransferFunction(NamedTuple):
    """``G(s) = gain prod(s - zeros) / prod(s - poles)``, as ``scipy.signal.ZerosPolesGain`` and ``control.zpk`` take it."""

    zeros: NDArray[np.complex128]
    """In 1/s, sorted by real part, then by imaginary part; from a generalized eigenproblem, not from polynomials."""
    poles: NDArray[np.complex128]
    """In 1/s, sorted likewise."""
    gain: float
    """The leading coefficient of the numerator."""

    def __call__(self, s: ArrayLike) -> NDArray[np.complex128]:
        """The value at complex frequencies in 1/s."""
        at = np.asarray(s, dtype=np.complex128)[..., np.newaxis]
        value: NDArray[np.complex128] = self.gain * np.prod(at - self.zeros, axis=-1) / np.prod(at - self.poles, axis=-1)
        return value

    @property
    def static_gain(self) -> float | None:
        """What a constant input of one comes to where the motion is stable, the value at zero; ``None`` where a pole is there."""
        return self._minimal()[2]

    def minimal(self) -> TransferFunction:
        """The same function without the poles and zeros that cancel each other. Those poles are modes that the input does not
        excite, or that the output does not show."""
        zeros, poles, _ = self._minimal()
        return TransferFunction(zeros, poles, self.gain)

    def _minimal(self) -> tuple[NDArray[np.complex128], NDArray[np.complex128], float | None]:
        return _carvallo.minimal(self.zeros.tolist(), self.poles.tolist(), self.gain)

    def bode(self, omega: ArrayLike | None = None) -> Response:
        """The response at frequencies in rad/s; without them at those that show all of it."""
        asked = None if omega is None else np.asarray(omega, dtype=np.float64).ravel().tolist()
        return Response(*_carvallo.frequency_response(self.zeros.tolist(), self.poles.tolist(), self.gain, asked))


def state_space_of(design: Described, v: ArrayLike, names: AskedNames) -> InputOutput:
    """What :meth:`Design.state_space` does with inputs or outputs."""
    speeds = np.asarray(v, dtype=np.float64)
    arrays, _ = design._one().state_spaces(design._about, speeds.ravel().tolist(), names)
    return InputOutput(*(array.reshape(speeds.shape + array.shape[1:]) for array in arrays))


def transfer_function_of(design: Described, ports: AskedPorts) -> TransferFunction:
    """What :meth:`Design.transfer_function` does."""
    return TransferFunction(*design._one().transfer_function(design._about, ports))


def margins_of(design: Described, ports: AskedPorts) -> Margins:
    """What :meth:`Design.margins` does."""
    gain, phase, stable = design._one().margins(design._about, ports)
    return Margins(tuple(gain), tuple(phase), stable)


def singular_values_of(design: Described, ports: AskedPorts, omega: ArrayLike | None) -> SingularValues:
    """What :meth:`Design.singular_values` does."""
    frequencies: list[float] | None = None if omega is None else np.asarray(omega, dtype=np.float64).ravel().tolist()
    return SingularValues(*design._one().singular_values(design._about, {"ports": ports, "omega": frequencies}))


def transfer_picture(design: Described, of: str, ports: AskedPorts, omega: tuple[float, float] | None) -> Picture:
    """What :meth:`Design.bode`, :meth:`Design.nyquist` and :meth:`Design.sigma` do."""
    asked: AskedTransfers = {"ports": ports, "omega": None}
    if omega is not None:
        low, high = pair_of("omega", omega)
        asked["omega"] = (float(low), float(high))
    return Picture(design._one().transfer_svg(design._about, asked, of))


def ports_of(v: float, inputs: Sequence[str] | str | None, outputs: Sequence[str] | str | None, units: str) -> AskedPorts:
    """What is asked for at a speed in m/s."""
    return {"speed": float(v), "names": asked_names(inputs, outputs, units)}


def asked_names(inputs: Sequence[str] | str | None, outputs: Sequence[str] | str | None, units: str) -> AskedNames:
    """What is asked for at any speed."""
    if not isinstance(units, str):
        raise TypeError(f"`units` is {units!r}; expected a text such as 'deg,km/h'")
    return {"inputs": names_of(inputs), "outputs": names_of(outputs), "units": units}


def names_of(names: Sequence[str] | str | None) -> list[str] | None:
    """Names, of which several may stand in one text."""
    if names is None:
        return None
    found = [name.strip() for name in names.split(",") if name.strip()] if isinstance(names, str) else list(names)
    for name in found:
        if not isinstance(name, str):
            raise TypeError(f"the name of an input or output is {name!r}; expected a text such as 'Tdelta'")
    if not found:
        raise ValueError("there are no names of inputs or outputs; expected at least one name, or None for all that are usual")
    return found


__all__ = ["InputOutput", "Margins", "Response", "SingularValues", "TransferFunction"]
