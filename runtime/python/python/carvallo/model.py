"""Models: what a design is of."""

from __future__ import annotations

import importlib
import os
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from . import _carvallo
from ._carvallo import Kernel
from .design import Design
from .values import Value, as_text, is_array


class Parameter(NamedTuple):
    """A parameter of a model."""

    name: str
    unit: str
    """As in formulas, such as ``kg*m^2``; ``1`` for pure numbers."""
    description: str
    domain: str
    """The values that it can have, such as ``> 0``."""


class Coordinate(NamedTuple):
    """A coordinate q of a model: a row of its matrices."""

    name: str
    label: str
    """What it is, such as ``lean``."""
    unit: str
    description: str
    has_position: bool
    """Whether its position is a state."""
    has_rate: bool
    """Whether its rate is a state."""


class Model:
    """A compiled model, such as :data:`carvallo.Whipple`. Calling it makes a :class:`~carvallo.Design`::

        >>> from carvallo import Whipple
        >>> Whipple("pista")                        # a measured bicycle, or a named set of another model
        >>> Whipple("benchmark", w=1.1, lam="18 deg")
        >>> Whipple("my-bicycle.toml")              # a file, in any of the forms that the command line reads
        >>> Whipple({"mB": 85.0, ...})              # a dict with all parameters
        >>> Whipple("pista", mB=np.linspace(60, 120, 7))   # seven designs

    """

    def __init__(self, kernel: Kernel, module: str = "carvallo") -> None:
        """Of compiled code; ``module`` is the Python module that has it, under the name of the model."""
        self._kernel = kernel
        self._closed: dict[tuple[str, ...], Kernel] = {}
        self._module = module
        self.__doc__ = _documentation(self)

    def __call__(self, source: str | os.PathLike[str] | Mapping[str, Value] | Design | None = None, /,
                 **parameters: Value) -> Design:
        """A design, or many.

        Parameters
        ----------
        source
            The name of what ships for the model (:attr:`sets`), the path of a file, a mapping from names to values, as a
            dict or a row of pandas, or another design; without it and without parameters, the first set that ships.
        **parameters
            Values by their names, in the place of those of the source; without a source all must be there. A value is a
            number in SI units, a text as the command line reads it (``"18 deg"``, ``"102 cm"``, ``"pi/10"``), or an array of
            numbers: then there is a design for each, and arrays broadcast against each other.

        Raises
        ------
        ValueError
            With everything that is wrong, in the words of the command line.
        OSError
            If a file cannot be read.
        """
        if source is None and not parameters:
            source = self._kernel.default_set
            if source is None:
                raise ValueError(f"no parameter set ships for the model {self.name}: expected parameters, or a file")
        if isinstance(source, Design):
            if source.model.name != self.name:
                given = {name: source[name] for name in source if name in self._names}
                return self._of_mapping(given)._replaced(parameters)
            return source._replaced(parameters)
        if isinstance(source, (str, os.PathLike)):
            return Design._loaded(self, self._kernel.load(os.fspath(source)))._replaced(parameters)
        if source is None:
            for name in parameters:
                self._kernel.position(name)
            return self._of_mapping(parameters)
        if hasattr(source, "keys") and hasattr(source, "__getitem__"):
            return self._of_mapping({str(name): source[name] for name in source.keys()})._replaced(parameters)
        kind = type(source).__name__
        raise ValueError(f"the parameters are of the type {kind}; expected a name, a path, or a mapping from names to values")

    def _closed_by(self, laws: tuple[str, ...]) -> Kernel:
        """Itself with feedback; one for each set of laws, since they stay as long as the program."""
        if not laws:
            return self._kernel
        if laws not in self._closed:
            self._closed[laws] = self._kernel.with_feedback(laws)
        return self._closed[laws]

    def _of_mapping(self, values: Mapping[str, Value]) -> Design:
        arrays = {name: np.asarray(value, dtype=float) for name, value in values.items() if is_array(value)}
        texts = [(name, self._first(name, arrays[name]) if name in arrays else as_text(value)) for name, value in values.items()]
        design = Design._loaded(self, self._kernel.given("parameters", texts))
        known = {name: array for name, array in arrays.items() if self._is_parameter(name)}
        return design._replaced(known)

    def _first(self, name: str, array: np.ndarray[Any, np.dtype[np.float64]]) -> str:
        """What stands for an array while the other values are judged: its first number, or of no designs any that is valid."""
        if array.size:
            return as_text(array.flat[0])
        default = self._kernel.default_set
        return "1" if default is None or not self._is_parameter(name) else as_text(self(default)[name])

    def _is_parameter(self, name: str) -> bool:
        try:
            self._kernel.position(name)
        except ValueError:
            return False
        return True

    @property
    def name(self) -> str:
        """The name of its type, such as ``Whipple``."""
        return self._kernel.name

    @property
    def source(self) -> str:
        """Where it comes from."""
        return self._kernel.source

    @property
    def sets(self) -> tuple[str, ...]:
        """The names of the parameter sets, or of the bicycles, that ship for it."""
        return tuple(self._kernel.sets)

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters, in their order."""
        return tuple(Parameter(*parameter) for parameter in self._kernel.parameters)

    @property
    def coordinates(self) -> tuple[Coordinate, ...]:
        """The coordinates, in the order of the rows of the matrices."""
        return tuple(Coordinate(*coordinate) for coordinate in self._kernel.coordinates)

    @property
    def states(self) -> tuple[str, ...]:
        """The states x of the state-space form: positions, then rates, such as ``phi``, ``delta``, ``phi_rate``, ``delta_rate``."""
        positions = [coordinate.name for coordinate in self.coordinates if coordinate.has_position]
        return (*positions, *(f"{coordinate.name}_rate" for coordinate in self.coordinates if coordinate.has_rate))

    @property
    def matrices(self) -> tuple[str, ...]:
        """Which matrices it has, such as ``M``, ``C1``, ``K0``, ``K2``; the others are zero."""
        return tuple(self._kernel.matrices)

    def equations(self, notation: str = "text") -> str:
        """The equations of motion, with the definitions in them and their units in kg, m and s: as ``text``, ``latex`` (with the
        package amsmath) or ``typst``.

        Raises
        ------
        ValueError
            If there is no such notation.
        """
        return self._kernel.equations(notation)

    @property
    def depends_on_speed(self) -> bool:
        """Whether its equations of motion have the speed in them."""
        return self._kernel.depends_on_speed

    @property
    def _names(self) -> list[str]:
        return [parameter.name for parameter in self.parameters]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __repr__(self) -> str:
        return f"<model {self.name}: {len(self.parameters)} parameters, {len(self.coordinates)} coordinates>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Model) and (self._module, self.name) == (other._module, other.name)

    def __hash__(self) -> int:
        return hash((self._module, self.name))

    def __reduce__(self) -> tuple[Any, ...]:
        return _find, (self._module, self.name)


def _find(module: str, name: str) -> Model:
    """The model of a module: what is pickled of one is where it is."""
    model = getattr(importlib.import_module(module), name)
    assert isinstance(model, Model)
    return model


def _documentation(model: Model) -> str:
    parameters = "\n".join(f"    {name}: {unit}, {domain}. {description}".rstrip() for name, unit, description, domain in model.parameters)
    sets = ", ".join(model.sets) or "none"
    return f"{model._kernel.docs}\n\nParameters\n----------\n{parameters}\n\nSets: {sets}.\n\nSource: {model.source or 'none'}."


def models() -> dict[str, Model]:
    """The models that ship, by their names."""
    return dict(_SHIPPED)


_SHIPPED = {kernel.name: Model(kernel) for kernel in _carvallo.MODELS}

__all__ = ["Coordinate", "Model", "Parameter", "models"]

