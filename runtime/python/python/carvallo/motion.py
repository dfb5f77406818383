"""Motions in time."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._dicts import Asked, AskedEvent
from .values import items_of

if TYPE_CHECKING:
    from ._described import Described

Force = Union[float, str, "tuple[ArrayLike, ArrayLike]"]
"""A constant in SI units, a text with a unit, or times in s with a force at each, linear between them."""

Event = Callable[[float, "dict[str, float]"], float]
"""A function ``event(t, state)`` of the time in s and of a dict with all positions and rates, which is zero where something happens; as
``scipy.integrate.solve_ivp`` takes it, with the attributes ``terminal`` and ``direction``."""

ROWS = 100
"""Steps of a motion, unless it is said how many."""


class Motion(Mapping[str, NDArray[np.float64]]):
    """A motion in time. It maps names to arrays over :attr:`t`: ``phi`` to the position, ``phi_rate`` to the rate, and
    ``phi_acceleration`` to the acceleration, in rad, rad/s and rad/s^2, or m, m/s and m/s^2."""

    t: NDArray[np.float64]
    """The times in s."""
    is_linear: bool
    """Whether it is by the linear equations."""
    units: dict[str, str]
    """The units of the positions, by their names."""
    energy: NDArray[np.float64] | None
    """Kinetic and potential energy in J, of shape (times, 2); None of linear motions."""
    contact_forces: dict[str, NDArray[np.float64]]
    """The force of the ground in N on each wheel that touches it, of shape (times, 3), z downward; none of linear motions."""
    feedback_forces: dict[str, NDArray[np.float64]]
    """The forces of the laws of :attr:`Design.feedback` over :attr:`t`, by what they are on, in N m or N."""
    end: str | None
    """Why it ended before its time, as by a fall; None if it did not. Rows end there."""
    t_events: tuple[NDArray[np.float64], ...]
    """Of each event that was watched, the times in s at which it happened, to rounding."""
    y_events: tuple[dict[str, NDArray[np.float64]], ...]
    """Of each event the motion there: arrays over its :attr:`t_events`, by the same names as those of the motion."""
    notes: tuple[str, ...]
    """What happened on the way: a stop, or a wheel that would lift off."""

    def __init__(self, design: Described, asked: Asked) -> None:
        self._design, self._designs, self._asked = design, design._one(), asked
        told = self._designs.simulate(design._about, asked)
        self.t, self.is_linear, self.energy, self.end = told["t"], told["is_linear"], told["energy"], told["end"]
        self.notes = tuple(told["notes"])
        self.units = {name: unit for name, _, unit in told["quantities"]}
        self.contact_forces = {name: told["contact_forces"][:, place] for place, name in enumerate(told["wheels"])}
        self.feedback_forces = {name: told["feedback"][:, place] for place, (name, _) in enumerate(told["laws"])}
        self._columns = self._named(told["positions"], told["rates"], told["accelerations"])
        happened = self._named(told["happened_positions"], told["happened_rates"], told["happened_accelerations"])
        own = [np.array(told["happened"], dtype=np.intp) == place for place in range(len(asked["events"]))]
        self.t_events = tuple(told["happened_t"][is_own] for is_own in own)
        self.y_events = tuple({name: values[is_own] for name, values in happened.items()} for is_own in own)

    def _named(self, *kinds: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
        """Positions, rates and accelerations by their names."""
        suffixes = zip(("", "_rate", "_acceleration"), kinds)
        return {f"{name}{suffix}": rows[:, place] for suffix, rows in suffixes for place, name in enumerate(self.units)}

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def svg(self) -> str:
        """The motion against time, with the linear one beside a nonlinear one and the paths of wheels, as SVG."""
        # As far as it went: nothing has to be watched again.
        asked: Asked = {**self._asked, "times": self.t.tolist(), "events": []}
        return self._designs.motion_svg(self._design._about, asked)

    def _repr_svg_(self) -> str | None:
        return self.svg() if self.t[-1] > 0.0 else None

    def __repr__(self) -> str:
        kind = "linear" if self.is_linear else "nonlinear"
        return f"<{kind} motion of {self._design.name}: {len(self.t)} rows to {self.t[-1]:g} s{f'; {self.end}' if self.end else ''}>"


def simulate(design: Described, v: float, duration: float | None, times: ArrayLike | None, initial: Mapping[str, float | str],
             forces: Mapping[str, Force], events: Event | Sequence[Event], linear: bool) -> Motion:
    """The motion of one design; what :meth:`Design.simulate` does."""
    constant, varying = [], []
    for name, force in items_of("forces", forces):
        if isinstance(force, tuple):
            at, values = (np.asarray(part, dtype=np.float64) for part in force)
            if at.ndim != 1 or at.shape != values.shape:
                raise ValueError(f"the force `{name}` has times of shape {at.shape} and values of shape {values.shape}")
            varying.append((name, list(zip(at.tolist(), values.tolist()))))
        else:
            constant.append(f"{name}={as_quantity(force)}")
    asked: Asked = {
        "speed": float(v),
        "times": times_of(duration, times),
        "initial": [f"{name}={as_quantity(value)}" for name, value in items_of("initial", initial)],
        "constant": constant,
        "varying": varying,
        "events": [_event(event) for event in (events if isinstance(events, Sequence) else [events])],
        "linear": linear,
    }
    return Motion(design, asked)


def _event(event: Event) -> AskedEvent:
    """With what SciPy has as attributes of the function."""
    if not callable(event):
        raise TypeError(f"the event is {event!r}; expected a function of the time and the state")
    terminal = getattr(event, "terminal", False)
    ends = int(terminal) if terminal else None
    if ends is not None and (ends != terminal or ends < 1):
        raise ValueError(f"`terminal` of an event is {terminal!r}; expected True, False or a number of times")
    name = getattr(event, "__name__", type(event).__name__)
    return {"name": name, "function": event, "ends": ends, "direction": float(getattr(event, "direction", 0.0))}


def times_of(duration: float | None, times: ArrayLike | None) -> list[float]:
    """The times that are asked for in s, one way or the other."""
    if (duration is None) == (times is None):
        raise ValueError("expected either `duration` in s or `times` in s")
    if times is not None:
        asked: list[float] = np.asarray(times, dtype=np.float64).ravel().tolist()
        if not asked or asked[0] != 0.0:
            raise ValueError(f"the first time is {asked[0] if asked else 'missing'}; it must be 0 s, where the motion begins")
        return asked
    if not (duration is not None and 0.0 <= duration < np.inf):
        raise ValueError(f"the duration is {duration} s; it must be >= 0")
    return np.linspace(0.0, duration, ROWS + 1).tolist() if duration > 0.0 else [0.0]


def as_quantity(value: Any) -> str:
    """A value as it stands on the command line: numbers with all their digits."""
    return value if isinstance(value, str) else repr(float(value))


__all__ = ["Motion"]
