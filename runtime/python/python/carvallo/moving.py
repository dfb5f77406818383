"""Designs in motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from numpy.typing import ArrayLike

from ._described import Described
from .motion import Event, Force, Motion, simulate
from .turns import SteadyTurns, turns_of


class Moving(Described):
    """Motions and steady turns of one design."""

    def turns(self, steer: ArrayLike | None = None) -> SteadyTurns:
        """The circles that one design runs in hands free: a curve from each capsize speed, and others. With ``steer`` in rad only
        the turns with that steer, or those steers.

        Raises
        ------
        ValueError
            If the model has no nonlinear equations, or there are no turns.
        """
        return turns_of(self, steer)

    def simulate(self, v: float = 0.0, duration: float | None = None, *, times: ArrayLike | None = None,
                 initial: Mapping[str, float | str] | None = None, forces: Mapping[str, Force] | None = None,
                 events: Event | Sequence[Event] = (), linear: bool = False) -> Motion:
        """The motion of one design in time, by the nonlinear equations if the model has any, or the linear ones.

        Parameters
        ----------
        v
            Forward speed at the beginning in m/s.
        duration, times
            How long in s, or at which times in s, ascending from 0.
        initial
            Positions and rates at the beginning, ``{"phi": "5 deg", "phi_rate": 0.5}``; the others are zero, or follow.
        forces
            Forces and torques by their names, such as ``{"delta": 2.0}`` in N m: constant, or times with values,
            ``{"delta": ([0, 1, 1, 2], [0, 2, 0, 0])}``, linear between them; two at one time are a jump.
        events
            Functions ``event(t, state)`` of the time in s and of a dict of all positions and rates, which happen where they change
            their sign, as ``scipy.integrate.solve_ivp`` has them: ``event.terminal = True`` ends the motion there, or a number when
            it has happened so often; ``event.direction`` above zero counts changes from below zero to above, below zero the
            others. They are found to rounding, if there is one at most between two of the times at which it is looked: several in
            each step of the nonlinear equations, and of the linear ones 4 or more between two rows. What a function raises
            ends the simulation and comes out of it.
        linear
            Solve the linear equations, exactly, also where there are nonlinear ones.

        Returns
        -------
        Motion
            With rows until it ends: a fall (a lean of 80 degrees, or a front wheel that turns around) ends it early, which
            :attr:`Motion.end` tells.

        Raises
        ------
        ValueError
            With everything that is wrong, in the words of the command line; or if there is no motion.
        """
        return simulate(self, v, duration, times, initial or {}, forces or {}, events, linear)


__all__ = ["Moving"]
