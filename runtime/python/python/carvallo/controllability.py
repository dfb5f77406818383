"""Which modes inputs excite and outputs show, along the speed."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._dicts import AskedMeasures

if TYPE_CHECKING:
    from ._described import Described


class LostMode(NamedTuple):
    """A speed at which a mode is out of reach of an input, or out of sight of an output."""

    port: str
    """The name of the input or of the output."""
    is_input: bool
    speed: float
    """In m/s."""
    eigenvalue: complex
    """Of the mode, in 1/s; real, since an oscillation is lost at no single speed but by chance."""


class Controllability:
    """How much of each mode inputs excite and outputs show.

    By the left eigenvector w and the right eigenvector x of a mode in the states of :meth:`Design.state_space`, in SI units (Hamdan
    & Nayfeh 1989): a mode is out of reach of an input exactly where its cosine is zero, by the test of Popov, Belevitch and Hautus,
    and out of sight of an output likewise. How large cosines are otherwise depends on the units of the states.

    Arrays have the shape of the speeds in front (none for one speed, or where nothing depends on it), then the modes.
    """

    v: NDArray[np.float64] | None
    """The speeds in m/s; None where nothing depends on them."""
    eigenvalues: NDArray[np.complex128]
    """In 1/s, of shape (speeds…, modes), in the order of :meth:`Design.modes`."""
    modes: NDArray[np.str_]
    """What the modes are called, of the same shape."""
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    controllability: NDArray[np.float64]
    """``|w^H b| / (|w| |b|)``, from 0 to 1, of shape (speeds…, modes, inputs)."""
    observability: NDArray[np.float64]
    """``|c x| / (|c| |x|)``, from 0 to 1, of shape (speeds…, modes, outputs)."""
    excitation: NDArray[np.complex128]
    """``w^H b``: by how much an impulse of an input excites the mode, with ``w^H x = 1``."""
    share: NDArray[np.complex128]
    """``c x``: what an output shows of the mode, where the largest of the coordinates in x is 1."""
    lost: tuple[LostMode, ...]
    """The speeds above zero, up to the largest of :attr:`v`, at which a mode that does not oscillate is lost."""

    def __init__(self, design: Described, v: ArrayLike | None, inputs: list[str] | None, outputs: list[str] | None) -> None:
        speeds = None if v is None else np.asarray(v, dtype=np.float64)
        self._name, self._about, self._designs = design.name, design._about, design._one()
        self._asked: AskedMeasures = {
            "speeds": None if speeds is None else speeds.ravel().tolist(), "inputs": inputs, "outputs": outputs,
        }
        told = self._designs.controllability(self._about, self._asked)
        found, shape = told["speeds"], speeds if speeds is None else speeds.shape
        if found is not None and speeds is not None and len(found) < speeds.size:
            raise ValueError("at rest there are no equations of motion")
        front = () if found is None else (len(found),) if shape is None else shape
        states = told["eigenvalues"].shape[1]
        self.v = None if found is None else np.array(found).reshape(front)
        self.inputs, self.outputs = tuple(told["inputs"]), tuple(told["outputs"])
        self.eigenvalues = told["eigenvalues"].reshape(*front, states)
        self.modes = np.array(told["modes"], dtype=np.str_).reshape(*front, states)
        self.controllability = told["controllability"].reshape(*front, states, len(self.inputs))
        self.observability = told["observability"].reshape(*front, states, len(self.outputs))
        self.excitation = told["excitation"].reshape(self.controllability.shape)
        self.share = told["share"].reshape(self.observability.shape)
        self.lost = tuple(LostMode(*lost) for lost in told["lost"])

    def svg(self) -> str:
        """The cosines against the speed, as SVG.

        Raises
        ------
        ValueError
            If there is one speed alone, or nothing depends on it.
        """
        return self._designs.controllability_svg(self._about, self._asked)

    def _repr_svg_(self) -> str | None:
        return None if self.v is None or np.unique(self.v).size < 2 else self.svg()

    def __repr__(self) -> str:
        return f"<controllability of {self._name} by {', '.join(self.inputs)}: {len(self.lost)} modes lost>"


__all__ = ["Controllability", "LostMode"]
