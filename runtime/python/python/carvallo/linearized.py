"""The linearized equations of motion, with their eigenvalues."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._described import Described
from .control import InputOutput, asked_names, state_space_of


class StateSpace(NamedTuple):
    """The state-space form ``x' = A x + B f``."""

    A: NDArray[np.float64]
    """Of shape (…, states, states)."""
    B: NDArray[np.float64]
    """Of shape (…, states, coordinates): the inputs f are the generalized forces."""


class System(NamedTuple):
    """The equations of motion ``M q'' + C q' + K q = f`` at one speed."""

    M: NDArray[np.float64]
    C: NDArray[np.float64]
    K: NDArray[np.float64]


class Eigenvectors(NamedTuple):
    """Eigenvalues s with the shapes of their modes."""

    values: NDArray[np.complex128]
    """In 1/s, of shape (…, states), sorted by real part, then by imaginary part."""
    right: NDArray[np.complex128]
    """Of shape (…, states, coordinates): ``right[..., k, :]`` is the x of eigenvalue k with ``(s^2 M + s C + K) x = 0``. Its
    largest component is 1; the coordinates move as ``Re(x exp(s t))``, and rates are s times as large."""
    left: NDArray[np.complex128]
    """Of the same shape: the y with ``y^H (s^2 M + s C + K) = 0``, scaled by ``y^H (2 s M + C) x = 1``, so that an impulse f
    excites the mode by ``y^H f``."""


class Modes(NamedTuple):
    """Eigenvalues with the names of their modes."""

    values: NDArray[np.complex128]
    """In 1/s, of shape (speeds…, states), in the order of the modes: each is continuous along the speeds."""
    names: NDArray[np.str_]
    """Of the same shape: ``castering``, ``capsize``, ``weave``, ``wobble``, of machines that do not lean and steer ``divergence``
    and ``flutter``, and ``real`` or ``oscillatory`` where there is no name."""


class Linearized(Described):
    """``M q'' + C q' + K q = f`` of one design or many, at forward speeds v in m/s."""

    def matrices(self, *, threads: int | None = None) -> dict[str, NDArray[np.float64]]:
        """The coefficient matrices of
        ``M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f`` that the model has, by their names.

        Returns
        -------
        dict of arrays of shape (designs…, coordinates, coordinates)
            For coordinates that are angles in rad, M in kg m^2, C-1 in N m^2, C0 in N m s, C1 in kg m, Kc in N m, K0 in kg m,
            K1 in N s and K2 in kg.
        """
        names = ("M", "C-1", "C0", "C1", "Kc", "K0", "K1", "K2")
        matrices = dict(zip(names, self._designs.matrices(threads)))
        return {name: matrices[name] for name in self._kernel.matrices}

    def system(self, v: ArrayLike = 0.0, *, paired: bool = False, threads: int | None = None) -> System:
        """M, C and K of ``M q'' + C q' + K q = f`` at forward speeds in m/s, each of shape
        (designs…, speeds…, coordinates, coordinates)."""
        return System(*self._designs.system(v, paired, threads))

    @overload
    def state_space(self, v: ArrayLike = 0.0, *, paired: bool = False, threads: int | None = None) -> StateSpace: ...

    @overload
    def state_space(self, v: ArrayLike = 0.0, *, inputs: Sequence[str] | str,
                    outputs: Sequence[str] | str | None = None, units: str = "si") -> InputOutput: ...

    @overload
    def state_space(self, v: ArrayLike = 0.0, *, inputs: Sequence[str] | str | None = None,
                    outputs: Sequence[str] | str, units: str = "si") -> InputOutput: ...

    def state_space(self, v: ArrayLike = 0.0, *, inputs: Sequence[str] | str | None = None,
                    outputs: Sequence[str] | str | None = None, units: str = "si", paired: bool = False,
                    threads: int | None = None) -> StateSpace | InputOutput:
        """A and B of ``x' = A x + B f`` at forward speeds in m/s; the states x are those of
        :attr:`Model.states <carvallo.Model.states>`, in rad, rad/s and so on, and the inputs f the generalized forces.

        With ``inputs`` or ``outputs`` A, B, C and D of one design, as in
        ``control.ss(*design.state_space(5.0, inputs="Tdelta", outputs=["phi", "phi_rate"]))``. Inputs are torques and forces as
        ``Tdelta``, all of them unless they are named; outputs are coordinates, rates and accelerations, ``phi``, ``phi_rate``,
        ``phi_acceleration``, of bicycles also of the yaw ``psi`` and the lateral place ``y``, and the states unless they are named.
        Positions that the motion does not depend on become states, the last, where an output asks for them. ``units`` are those of
        states, inputs and outputs, as ``"deg,lbf*ft"``; those of the SI unless they are given.

        Raises
        ------
        ValueError
            If the mass matrix is singular, or at rest if there is a C-1; if there is no input or output of a name, or no such
            unit.
        """
        if inputs is None and outputs is None:
            if units != "si":
                raise ValueError("`units` are those of inputs and outputs: expected `inputs` or `outputs`")
            return StateSpace(*self._designs.state_space(v, paired, threads))
        return state_space_of(self, v, asked_names(inputs, outputs, units))

    def eigenvalues(self, v: ArrayLike = 0.0, *, paired: bool = False, threads: int | None = None) -> NDArray[np.complex128]:
        """The eigenvalues in 1/s at forward speeds in m/s.

        Returns
        -------
        complex array of shape (designs…, speeds…, states)
            Sorted by real part, then by imaginary part: the last one grows fastest.
        """
        return self._designs.eigenvalues(v, paired, threads)

    def eigenvectors(self, v: ArrayLike = 0.0, *, paired: bool = False, threads: int | None = None) -> Eigenvectors:
        """The eigenvalues at forward speeds in m/s, with their right and left eigenvectors."""
        return Eigenvectors(*self._designs.eigenvectors(v, paired, threads))

    def modes(self, v: ArrayLike = 0.0) -> Modes:
        """The eigenvalues of one design at forward speeds from 0 in m/s, followed mode by mode, with their names."""
        values, names = self._one().modes(self._about, v)
        return Modes(values, np.array(names).reshape(values.shape))


__all__ = ["Eigenvectors", "Linearized", "Modes", "StateSpace", "System"]
