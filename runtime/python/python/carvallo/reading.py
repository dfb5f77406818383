"""Designs from files, and files to start from."""

from __future__ import annotations

import os

from . import _carvallo
from .design import Design


def read(path: str | os.PathLike[str]) -> Design:
    """The design in a file of any form that the command line reads, of the model that the file names, or else a bicycle.

    A file may give the matrices themselves, ``{"M": [[…], […]], "C1": …}``: their entries are the parameters then.

    Raises
    ------
    ValueError
        With everything that is wrong with the file.
    OSError
        If it cannot be read.
    """
    from .model import Model, models

    loaded = _carvallo.read(os.fspath(path))
    model = models().get(loaded["kernel"].name) or Model(loaded["kernel"])
    return Design._loaded(model, loaded)


def measure(path: str | os.PathLike[str]) -> Design:
    """A bicycle from a file of measurements, as the command line's ``measure`` and BicycleParameters read it, with the standard
    deviations and correlations of its parameters.

    Raises
    ------
    ValueError
        With everything that is wrong with the file.
    OSError
        If it cannot be read.
    """
    from .model import models

    loaded = _carvallo.measure(os.fspath(path))
    return Design._loaded(models()[loaded["kernel"].name], loaded)


def rider(path: str | os.PathLike[str]) -> str:
    """A rider from a file of a few measures, by the method of Moore, Hubbard, Kooijman & Schwab (2009), as the text of a body in
    TOML: written to a file, it is one that :meth:`Design.add` and the command line take.

    Raises
    ------
    ValueError
        With everything that is wrong with the file.
    OSError
        If it cannot be read.
    """
    return _carvallo.rider(os.fspath(path))


def example(of: str) -> str:
    """A file to start from, as text: of ``"measure"`` for :func:`measure`, or of ``"rider"`` for :func:`rider`.

    Raises
    ------
    ValueError
        If there is no such example.
    """
    if of not in ("measure", "rider"):
        raise ValueError(f"there is no example of {of!r}; expected 'measure' or 'rider'")
    return _carvallo.example(of)


__all__ = ["example", "measure", "read", "rider"]
