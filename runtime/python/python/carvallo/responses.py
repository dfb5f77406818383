"""Responses in time: to steps, to impulses and from initial states."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._dicts import AskedPorts, AskedResponse
from .motion import times_of

if TYPE_CHECKING:
    from ._described import Described


class TimeResponse(Mapping[str, NDArray[np.float64]]):
    """Outputs of a state space in time. It maps their names to arrays over :attr:`t`, in :attr:`units`."""

    t: NDArray[np.float64]
    """The times in s."""
    units: dict[str, str]
    """The units of the outputs, by their names: ``rad``, ``rad/s`` and so on, unless others were asked for."""
    title: str
    """What it is a response to."""
    end: str | None
    """Why it ended before its time, as where it leaves the range of doubles; None if it did not. Rows end there."""

    def __init__(self, design: Described, asked: AskedResponse) -> None:
        self._about, self._designs, self._asked = design._about, design._one(), asked
        told = self._designs.respond(self._about, asked)
        self.t, self.title, self.end = told["t"], told["title"], told["end"]
        self.units = dict(told["outputs"])
        self._columns = {name: told["values"][:, place] for place, name in enumerate(self.units)}

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def svg(self) -> str:
        """The outputs against time, as SVG."""
        return self._designs.response_svg(self._about, self._asked)

    def _repr_svg_(self) -> str | None:
        return self.svg() if self.t[-1] > 0.0 else None

    def __repr__(self) -> str:
        return f"<{self.title}: {len(self.t)} rows to {self.t[-1]:g} s{f'; {self.end}' if self.end else ''}>"


def response_of(design: Described, ports: AskedPorts, kind: str, given: list[str], duration: float,
                times: ArrayLike | None) -> TimeResponse:
    """The response to a ``step`` or an ``impulse`` of an input, by its size, or from an ``initial`` state."""
    asked: AskedResponse = {"ports": ports, "kind": kind, "given": given,
                            "times": times_of(None if times is not None else duration, times)}
    return TimeResponse(design, asked)


__all__ = ["TimeResponse"]
