"""Critical speeds, stable ranges and verdicts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _carvallo

if TYPE_CHECKING:
    from ._described import Described

# What a verdict is called, by its number.
VERDICTS: tuple[str, ...] = tuple(_carvallo.VERDICTS)


class CriticalSpeed(NamedTuple):
    """A speed above zero at which the kind of motion changes."""

    name: str
    """``weave``, ``capsize``, ``wobble`` or ``double_root`` of machines that lean and steer, ``flutter`` and ``divergence`` of
    others."""
    speed: float
    """In m/s."""
    error: float
    """An estimate of the absolute error of the speed in m/s."""
    eigenvalue: complex
    """In 1/s: zero at capsize speeds, imaginary at weave speeds."""
    change: str
    """What changes as the speed grows: ``stabilizes``, ``destabilizes``, ``merges``, ``splits`` or ``touches``."""
    below: str
    """Whether the motion is stable just below: ``stable``, ``marginal`` or ``unstable``."""
    above: str
    """The same just above."""


class Range(NamedTuple):
    """An open range of forward speeds in m/s."""

    start: float
    end: float | None
    """None if it has no end."""


class Column(NamedTuple):
    """A column of numbers, of which some may be missing."""

    unit: str
    """Of a number; empty where there is none."""
    kind: str
    """``number``, ``count``, or ``verdict``: a place in :data:`VERDICTS`."""
    cells: NDArray[np.float64]
    present: NDArray[np.bool_]

    def masked(self) -> np.ma.MaskedArray[Any, Any]:
        """As numpy has it: masked where there is none."""
        if self.kind == "number":
            return np.ma.MaskedArray(self.cells, mask=~self.present)
        whole = self.cells.astype(np.int32)
        return np.ma.MaskedArray(whole if self.kind == "count" else np.array(VERDICTS)[whole], mask=~self.present)


class Stability(Mapping[str, "np.ma.MaskedArray[Any, Any]"]):
    """Critical speeds and stable ranges of an array of designs, or of one.

    It maps headings to masked arrays in the shape of the designs: the same headings as ``carvallo sweep`` has, such as
    ``weave_count``, ``weave_1``, ``stable_from_1``, ``stable_to_1``. What there is not is masked, never NaN: a design that is
    nowhere stable has neither ``stable_from_1`` nor ``stable_to_1``, one whose range has no end has no ``stable_to_1``.

    Of machines that lean and steer the columns of weave have the wobble speeds, too. Where there may be ranges in which a speed
    is missing since rounding decides, ``undecided_count`` counts them.
    """

    def __init__(self, columns: dict[str, Column]) -> None:
        self._columns = columns

    def __getitem__(self, heading: str) -> np.ma.MaskedArray[Any, Any]:
        return self._columns[heading].masked()

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def speeds(self, kind: str) -> np.ma.MaskedArray[Any, Any]:
        """The critical speeds of a kind in m/s, ascending: a masked array of shape (designs…, the most that there are).

        ``kind`` is ``weave``, ``capsize`` or ``double_root`` of machines that lean and steer, ``flutter``, ``divergence`` or
        ``double_root`` of others.

        Raises
        ------
        ValueError
            If there is no such kind.
        """
        kinds = [heading.removesuffix("_count") for heading in self if heading.endswith("_count")]
        kinds = [name for name in kinds if name not in ("stable", "undecided")]
        if kind not in kinds:
            raise ValueError(f"`{kind}` is no kind of critical speed; they are {', '.join(kinds) or 'none'}")
        return self._side_by_side(f"{kind}_", self[f"{kind}_count"])

    @property
    def stable_from(self) -> np.ma.MaskedArray[Any, Any]:
        """The speed in m/s at which the first stable range begins; masked where there is none."""
        return self["stable_from_1"]

    @property
    def stable_to(self) -> np.ma.MaskedArray[Any, Any]:
        """The speed in m/s at which the first stable range ends; masked where there is none, or no end."""
        return self["stable_to_1"]

    @property
    def stable_ranges(self) -> np.ma.MaskedArray[Any, Any]:
        """All stable ranges in m/s: a masked array of shape (designs…, the most that there are, 2)."""
        count = self["stable_count"]
        ends = [self._side_by_side(f"stable_{end}_", count) for end in ("from", "to")]
        return np.ma.stack(ends, axis=-1)

    def _side_by_side(self, prefix: str, count: np.ma.MaskedArray[Any, Any]) -> np.ma.MaskedArray[Any, Any]:
        most = int(count.max()) if count.size and count.count() else 0
        columns = [self[f"{prefix}{index}"] for index in range(1, most + 1)]
        if not columns:
            return np.ma.MaskedArray(np.zeros((*np.shape(count), 0)), mask=np.zeros((*np.shape(count), 0), dtype=bool))
        return np.ma.stack(columns, axis=-1)

    def __repr__(self) -> str:
        return f"<stability: {', '.join(self)}>"


def columns_of(designs: _carvallo.Designs, speeds: ArrayLike, threads: int | None) -> tuple[dict[str, Column], list[str | None]]:
    """The columns, and why a design has no results."""
    columns, errors = designs.sheet(np.atleast_1d(np.asarray(speeds, dtype=np.float64)).ravel().tolist(), threads)
    return {name: Column(unit, kind, cells, present) for name, unit, kind, cells, present in columns}, errors


def stability_of(design: Described, speeds: ArrayLike, threads: int | None) -> Stability:
    """The stability of designs, all of which must have one."""
    columns, errors = columns_of(design._designs, speeds, threads)
    for index, error in enumerate(errors):
        if error is not None:
            place = ", ".join(str(i) for i in np.unravel_index(index, design.shape)) if design.shape else ""
            raise ValueError(f"design {place}: {error}" if place else error)
    return Stability(columns)


__all__ = ["CriticalSpeed", "Range", "Stability"]
