"""Several designs beside each other, which parameters make the difference, and the best design within ranges."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _carvallo
from .pictures import Picture
from .values import items_of, pair_of

if TYPE_CHECKING:
    from .design import Design


class SpeedChange(NamedTuple):
    """How a critical speed of one design comes from that of the first one."""

    kind: str
    """Such as ``weave`` or ``capsize``."""
    before: float | None
    """In the first design, in m/s; None where that has none."""
    after: float | None
    """In the other design, in m/s; None where that has none."""
    contributions: dict[str, float] | None
    """What each parameter that differs contributes to the difference, in m/s; they sum to it. None where only one design has the
    critical speed."""
    event: str | None
    """Where only one has it: why it vanishes, or appears, on the way."""
    place: float | None
    """And which part of the way, from 0 to 1."""


class Differences:
    """Several designs, and what makes them differ from the first one."""

    labels: tuple[str, ...]
    """What the designs are called."""
    parameters: tuple[str, ...]
    """The parameters that all have and that differ."""
    changes: tuple[tuple[SpeedChange, ...], ...]
    """Of each design but the first, how its critical speeds come from those of the first; none where the models differ."""
    json: dict[str, Any]
    """All of it, as ``carvallo compare --format json`` has it."""

    def __init__(self, designs: Sequence[Design], labels: Sequence[str] | None = None) -> None:
        for design in designs:
            if not hasattr(design, "_about"):
                raise TypeError(f"one of the designs is {design!r}; expected a design, such as carvallo.Whipple('pista')")
        names = [design.name for design in designs] if labels is None else list(labels)
        if len(names) != len(designs):
            raise ValueError(f"there are {len(designs)} designs and {len(names)} labels")
        if len(set(names)) < len(names):
            names = [f"{name} {index}" for index, name in enumerate(names, 1)]
        self._designs = [(design._one(), design._about, name) for design, name in zip(designs, names)]
        self.json = json.loads(_carvallo.compare(self._designs))
        self.labels = tuple(names)
        self.parameters = tuple(self.json["differing_parameters"])
        self.changes = tuple(
            tuple(_change(own) for own in difference["critical_speeds"] or ()) for difference in self.json["differences"]
        )

    def plot(self) -> Picture:
        """The eigenvalues of all against the speed, laid over each other."""
        return self._picture("eigenvalues")

    def side_view(self) -> Picture:
        """All of them from the side, to one scale. Raises ValueError if one is no bicycle."""
        return self._picture("side views")

    def contributions(self) -> Picture:
        """What each parameter contributes to the differences of the last design from the first. Raises ValueError if no critical
        speed is one of both."""
        return self._picture("contributions")

    def _picture(self, of: str) -> Picture:
        svg = _carvallo.compare_svg(self._designs, of)
        if svg is None:
            raise ValueError(f"there are no {of} to draw of {', '.join(self.labels)}")
        return Picture(svg)

    def __repr__(self) -> str:
        return f"<differences of {', '.join(self.labels)}: {len(self.parameters)} parameters>"


class Optimum(NamedTuple):
    """The best design within ranges; it keeps every constraint exactly."""

    design: Design
    """The design itself."""
    value: float
    """The measure, in m/s or in the unit of the parameter."""
    before: float | None
    """The same of the design that it began with; None where that has none."""
    at: dict[str, str | None]
    """Of each parameter that was varied, at which end of its range it is: ``low``, ``high`` or None."""
    tight: tuple[str, ...]
    """The constraints that leave no room."""
    json: dict[str, Any]
    """All of it, as ``carvallo optimize --format json`` has it."""


def compare(designs: Sequence[Design], labels: Sequence[str] | None = None) -> Differences:
    """Hold designs against the first of them: which parameters make the difference of each critical speed.

    Exact derivatives are integrated along the straight path between the parameters of two designs, so that what the parameters
    contribute sums to the difference.

    Raises ValueError for fewer than two designs, or for one with several values of a parameter.
    """
    return Differences(designs, labels)


def optimize(
    design: Design,
    vary: Mapping[str, tuple[float | str, float | str]],
    *,
    maximize: str | None = None,
    minimize: str | None = None,
    keep: Sequence[str] | str = (),
    speeds: tuple[float, float] = (0.0, 20.0),
    starts: int = 8,
    seed: int = 1,
) -> Optimum:
    """The best design within ranges of its parameters.

    ``vary`` has the lowest and the highest value of each parameter that may change. Either ``maximize`` or ``minimize`` names a
    measure: ``stable-range``, ``weave-speed``, ``capsize-speed``, ``flutter-speed`` or a parameter. ``keep`` has inequalities such
    as ``"xB >= 0.2"`` or ``"stable_range >= 1"``; ``speeds`` are those that count for stable ranges, in m/s. The search begins at
    ``starts`` designs, which come from a generator with ``seed``.

    Raises ValueError for what is not understood, or if no design keeps everything and has what is measured.
    """
    if (maximize is None) == (minimize is None):
        raise ValueError("expected one measure, to maximize or to minimize")
    for name, whole in (("starts", starts), ("seed", seed)):
        if isinstance(whole, str) or whole != int(whole) or not 0 <= whole < 2**32:
            raise ValueError(f"`{name}` is {whole!r}; it must be a whole number from 0 on, below 2^32")
    pairs = [(name, pair_of(f"vary[{name!r}]", pair)) for name, pair in items_of("vary", vary)]
    written = [f"{name}={_text(low)}:{_text(high)}" for name, (low, high) in pairs]
    search: dict[str, Any] = {
        "vary": written,
        "measure": minimize if maximize is None else maximize,
        "maximize": maximize is not None,
        "keep": [keep] if isinstance(keep, str) else list(keep),
        "speeds": tuple(float(end) for end in pair_of("speeds", speeds)),
        "starts": starts,
        "seed": seed,
    }
    found, values = design._one().optimize(design._about, search)
    report: dict[str, Any] = json.loads(found)
    changed = {name: value for name, value in zip(design, values) if name in report["varied"]}
    return Optimum(
        design.replace(**changed),
        report["goal"]["after"],
        report["goal"]["before"],
        {name: own["at"] for name, own in report["varied"].items()},
        tuple(own["constraint"] for own in report["constraints"] if own["tight"]),
        report,
    )


def _text(value: float | str) -> str:
    return value if isinstance(value, str) else repr(float(value))


def _change(own: Mapping[str, Any]) -> SpeedChange:
    event = own["vanishes"] or own["appears"] or {}
    return SpeedChange(
        own["kind"], own["from"], own["to"], own["contributions"], event.get("reason"), event.get("place")
    )


__all__ = ["Differences", "Optimum", "SpeedChange", "compare", "optimize"]
