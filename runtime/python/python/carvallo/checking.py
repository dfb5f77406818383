"""Whether somebody's numbers are right, and which slip makes them if not."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from . import _carvallo


class Comparison(NamedTuple):
    """One number beside the one that it should be."""

    name: str
    """What it is of: ``M_12``, with row and column from one, or ``Re s2 at 5 m/s``."""
    unit: str
    """In SI unless ``units`` say otherwise, as ``kg*m^2``; empty where it has none."""
    yours: str
    """As it was given."""
    ours: float | None
    """As it should be; None where there is none, as of a critical speed."""
    digits: int
    """How many significant digits agree."""
    agrees: bool
    """Whether that is all that was given."""
    cut_off: str | None
    """Where the digits that were given are cut off and not rounded: as it is rounded. Else None."""


class Explanation(NamedTuple):
    """What reproduces all numbers to the digits that were given."""

    causes: tuple[str, ...]
    """What is otherwise, all of it together."""
    group: int
    """Explanations of one group make the same matrices of this machine."""
    formula: int
    """Those of one number in a group make the same matrices of every machine: no number tells them apart."""


class Report(NamedTuple):
    """What comes of a check; ``print`` shows it as the command line does."""

    agrees: bool
    """Whether all numbers agree to the digits that were given."""
    numbers: tuple[Comparison, ...]
    """All numbers, those of matrices first."""
    explanations: tuple[Explanation, ...]
    """What reproduces all numbers, the likeliest first; none where all agree, or where nothing does."""
    json: dict[str, Any]
    """All of it, as ``carvallo check --format json`` has it, but in the units that were asked for."""
    text: str

    def __str__(self) -> str:
        return self.text


def check(
    given: Mapping[str, Any] | str | os.PathLike[str],
    bicycle: str | None = None,
    *,
    model: str | None = None,
    feedback: str | Sequence[str] = (),
    units: str = "si",
) -> Report:
    """Hold numbers against those of a design, and explain where they do not agree.

    ``given`` has any of ``M``, ``C1``, ``K0``, ``K2`` and the other matrices, ``A`` and ``eigenvalues`` with ``speed``,
    ``critical_speeds`` and ``accelerations``, as lists or arrays, in the form of `the files of carvallo check`_; or it is the
    path of such a file. A text keeps zeros at the end: ``"2.320"``. ``bicycle`` is what ships, or a file, unless ``given`` says
    what the numbers are of. ``feedback`` has a law or several, as ``"Tdelta = -10*phi_rate"``, if they are of a closed loop and
    ``given`` does not say so. What is given is in SI units; the report is in ``units``, as ``"km/h,lb"`` or ``"imperial"``.

    .. _the files of carvallo check: ../../../cli/docs/check.md

    Raises ValueError for what is not understood, with everything that is wrong, and OSError for a file that cannot be read.
    """
    if isinstance(given, Mapping):
        path, document = None, json.dumps(dict(given), default=_plain)
    else:
        path, document = os.fspath(given), None
    if not isinstance(units, str):
        raise TypeError(f"`units` is {units!r}; expected a text such as 'km/h,lb'")
    laws = [feedback] if isinstance(feedback, str) else list(feedback)
    found, text = _carvallo.check(path, document, bicycle, model, laws, units)
    report: dict[str, Any] = json.loads(found)
    explanations = tuple(
        Explanation(tuple(own["causes"]), at, own["class"])
        for at, group in enumerate(report["explanations"])
        for own in group["explanations"]
    )
    numbers = tuple(Comparison(**own) for own in report["numbers"])
    return Report(report["agrees"], numbers, explanations, report, text)


def _plain(value: object) -> object:
    """What JSON has no form for."""
    if isinstance(value, complex):
        return {"re": value.real, "im": value.imag}
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} is no number, list or dict")
