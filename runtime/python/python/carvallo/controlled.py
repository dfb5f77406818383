"""What a control engineer asks of one design."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._described import Described
from .control import (
    Margins,
    SingularValues,
    TransferFunction,
    margins_of,
    names_of,
    ports_of,
    singular_values_of,
    transfer_function_of,
    transfer_picture,
)
from .controllability import Controllability
from .motion import as_quantity
from .pictures import Picture
from .regulators import Regulators, lqr_of
from .responses import TimeResponse, response_of
from .values import items_of

Names = Sequence[str] | str
"""The names of inputs or outputs: one, several in one text with commas, or a list."""


class Controlled(Described):
    """The linearized motion of one design from inputs to outputs.

    Inputs are torques and forces as ``Tdelta``, all of them unless they are named; outputs are coordinates, rates and accelerations
    as ``phi``, ``phi_rate`` and ``phi_acceleration``, of bicycles also of the yaw ``psi`` and the lateral place ``y``, and the
    coordinates unless they are named. Names are those of :meth:`Design.state_space`.

    ``units`` are those of inputs, states and outputs, as ``"deg,lbf*ft"``, and so those of all gains; rates and accelerations follow the
    unit of their coordinate. Frequencies stay in rad/s, zeros and poles in 1/s, times in s, and what is given is in SI units or
    has its unit behind it.
    """

    def transfer_function(self, v: float, input: str, output: str, *, units: str = "si") -> TransferFunction:
        """The transfer function of one design at a forward speed in m/s, from an input to an output: zeros, poles and gain.

        Raises
        ------
        ValueError
            If there are no equations of motion at the speed, or no input or output of the name.
        """
        return transfer_function_of(self, ports_of(v, [input], [output], units))

    def transmission_zeros(self, v: float, inputs: Names | None = None,
                           outputs: Names | None = None) -> NDArray[np.complex128] | None:
        """The transmission zeros in 1/s of one design at a forward speed in m/s, between all inputs and outputs together, sorted by
        real part, then by imaginary part: where the matrix of transfer functions loses its rank.

        None where there are not as many outputs as inputs, or where outputs depend on each other at every frequency.
        """
        return self._one().transmission_zeros(self._about, ports_of(v, inputs, outputs, "si"))

    def singular_values(self, v: float, inputs: Names | None = None, outputs: Names | None = None, *,
                        omega: ArrayLike | None = None, units: str = "si") -> SingularValues:
        """The singular values of the matrix of transfer functions of one design at a forward speed in m/s: its largest gain over all
        directions of inputs, the smallest, and those between; at frequencies in rad/s, or at those that show all of them. They are
        worth no more than the choice of units.

        Raises
        ------
        ValueError
            If there are no equations of motion at the speed, no input or output of a name, or a frequency that is not above 0.
        """
        return singular_values_of(self, ports_of(v, inputs, outputs, units), omega)

    def margins(self, v: float, input: str, output: str, *, units: str = "si") -> Margins:
        """The gain and phase margins of the loop ``u = -y`` of one design at a forward speed in m/s, wherever its gain is one or
        its phase half a turn; none is scanned for."""
        return margins_of(self, ports_of(v, [input], [output], units))

    def bode(self, v: float, inputs: Names | None = None, outputs: Names | None = None, *,
             omega: tuple[float, float] | None = None, units: str = "si") -> Picture:
        """Gains and phases from inputs to outputs against the frequency at a forward speed in m/s: between two frequencies in
        rad/s, or over all that show something. :meth:`TransferFunction.bode` has the numbers."""
        return transfer_picture(self, "bode", ports_of(v, inputs, outputs, units), omega)

    def nyquist(self, v: float, inputs: Names | None = None, outputs: Names | None = None, *,
                omega: tuple[float, float] | None = None, units: str = "si") -> Picture:
        """The frequency responses from inputs to outputs in the complex plane, with the point -1; otherwise as :meth:`bode`."""
        return transfer_picture(self, "nyquist", ports_of(v, inputs, outputs, units), omega)

    def sigma(self, v: float, inputs: Names | None = None, outputs: Names | None = None, *,
              omega: tuple[float, float] | None = None, units: str = "si") -> Picture:
        """The singular values of all transfer functions together against the frequency, in decibels; otherwise as :meth:`bode`.
        :meth:`singular_values` has the numbers."""
        return transfer_picture(self, "sigma", ports_of(v, inputs, outputs, units), omega)

    def step_response(self, v: float, input: str, outputs: Names | None = None, duration: float = 5.0, *,
                      size: float | str = 1.0, times: ArrayLike | None = None, units: str = "si") -> TimeResponse:
        """The response of one design at a forward speed in m/s to an input that is constant from time zero on; it begins at rest
        in straight running. Exact, by the matrix exponential.

        Parameters
        ----------
        duration, times
            How long in s, or in its place at which times in s, ascending from 0.
        size
            In N m or N, or a text with a unit, ``"2 N m"``.

        Raises
        ------
        ValueError
            With everything that is wrong; or if there are no equations of motion at the speed.
        """
        return response_of(self, ports_of(v, [input], outputs, units), "step", [as_quantity(size)], duration, times)

    def impulse_response(self, v: float, input: str, outputs: Names | None = None, duration: float = 5.0, *,
                         size: float | str = 1.0, times: ArrayLike | None = None, units: str = "si") -> TimeResponse:
        """The response to an impulse of an input, whose integral over time is ``size`` in N m s or N s; otherwise as
        :meth:`step_response`. What follows the input at once, as an acceleration, is over when it is told."""
        return response_of(self, ports_of(v, [input], outputs, units), "impulse", [as_quantity(size)], duration, times)

    def initial_response(self, v: float, initial: Mapping[str, float | str], outputs: Names | None = None,
                         duration: float = 5.0, *, times: ArrayLike | None = None, units: str = "si") -> TimeResponse:
        """The response from a state, ``{"phi": "5 deg", "phi_rate": 0.5}``, the others zero; otherwise as :meth:`step_response`.
        :meth:`Design.simulate` has forces that change in time, and the nonlinear equations."""
        given = [f"{name}={as_quantity(value)}" for name, value in items_of("initial", initial)]
        return response_of(self, ports_of(v, None, outputs, units), "initial", given, duration, times)

    def controllability(self, v: ArrayLike | None = None, inputs: Names | None = None,
                        outputs: Names | None = None) -> Controllability:
        """Of each mode, how much of it inputs excite and outputs show, at forward speeds in m/s, or unless they are given as far as
        there is something to see; and the speeds at which a mode is lost to an input or an output.

        Raises
        ------
        ValueError
            If there is no input or output of a name, or an output is an integral, which no mode is of; or if there are no
            equations of motion at some speed.
        """
        return Controllability(self, v, names_of(inputs), names_of(outputs))

    def lqr(self, v: ArrayLike = 0.0, *, inputs: Names | None = None,
            weights: Mapping[str, float] | None = None, units: str = "si") -> Regulators:
        """Linear quadratic regulators at forward speeds in m/s: the gains K of ``u = -K x`` that keep the integral of the weighted
        squares of outputs and inputs as small as it can be.

        Parameters
        ----------
        inputs
            The names of forces, such as ``"Tdelta"``; all of them unless given.
        weights
            By the names of positions, rates and inputs, ``{"phi": 10, "Tdelta": 0.5}``. Without one for an output every state has
            the weight 1, with one the others have none; inputs without one have 1. In SI units.

        Raises
        ------
        ValueError
            If there are no such gains, as where no input reaches a mode that grows; or for an array of designs.
        """
        return lqr_of(self, v, names_of(inputs), weights, units)


__all__ = ["Controlled"]
