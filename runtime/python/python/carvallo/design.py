"""Designs: a model with its parameters."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, Union

import numpy as np
from numpy.typing import NDArray

from . import _carvallo
from ._dicts import About, Loaded
from .analyzed import Analyzed
from .controlled import Controlled
from .drawn import Drawn
from .linearized import Linearized
from .moving import Moving
from .samples import samples_of
from .values import Value, as_number

if TYPE_CHECKING:
    from .model import Model


class Design(Linearized, Analyzed, Moving, Controlled, Drawn, Mapping[str, Union[float, NDArray[np.float64]]]):
    """A model with its parameters: one design, or an array of them.

    Calling a :class:`~carvallo.Model` makes one. It maps the names of the parameters to their values in SI units, and has them
    as attributes::

        >>> pista = carvallo.Whipple("pista")
        >>> pista.w, pista["mB"]
        >>> pista.eigenvalues(5.0)

    Where a parameter is an array there is a design for each of its numbers, :attr:`shape` is that of all such arrays
    broadcast against each other, and what is computed has that shape in front, then that of the speeds. Nothing is copied into
    rows: arrays of doubles in the full shape are used as they are.

    ``v`` are forward speeds in m/s, a number or an array of any shape: each design is computed at each of them. With
    ``paired=True`` they have the shape of the designs, and each design is computed at the speed in its place; then no axes are
    added for the speeds. ``threads`` says how many threads work, as many as there are cores unless it is given; results do not
    depend on it. Long computations let other threads of Python run, and end on Ctrl-C.

    All parameters are judged: those of one design when it is made, those of many when something is computed of them. A
    ValueError says what is wrong and with which design.
    """

    kind: str | None
    """What it is."""
    source: str | None
    """Where its parameters come from."""
    notes: tuple[str, ...]
    """What was read but not used, or taken because it was not given."""

    def __init__(self) -> None:
        raise TypeError("a design is made by calling a model, as in carvallo.Whipple('benchmark')")

    @classmethod
    def _of(cls, model: Model, values: list[float | NDArray[np.float64]], about: About,
            notes: tuple[str, ...]) -> Design:
        self = cls.__new__(cls)
        self.model = model
        shape = np.broadcast_shapes(*(np.shape(value) for value in values))
        self._values = [float(value) if np.ndim(value) == 0 else np.broadcast_to(value, shape) for value in values]
        columns = [value if isinstance(value, float) else np.ascontiguousarray(value).reshape(-1) for value in self._values]
        self._kernel = model._closed_by(tuple(about["feedback"]))
        self._designs = self._kernel.designs(columns, list(shape))
        self._about = about
        self.name, self.kind, self.source = about["name"], about["kind"], about["source"]
        self.notes = notes
        return self

    @classmethod
    def _loaded(cls, model: Model, loaded: Loaded) -> Design:
        for warning in loaded["warnings"]:
            warnings.warn(warning, stacklevel=3)
        about: About = {"name": loaded["name"], "kind": loaded["kind"], "source": loaded["source"],
                                  "deviations": loaded["deviations"], "correlations": loaded["correlations"],
                                  "feedback": loaded["feedback"]}
        return cls._of(model, list(loaded["values"]), about, tuple(loaded["notes"]))

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the array of designs; ``()`` for one design."""
        return tuple(self._designs.shape)

    @property
    def size(self) -> int:
        """How many designs there are."""
        return int(np.prod(self.shape))

    @property
    def deviations(self) -> dict[str, float]:
        """The standard deviations of the parameters that were measured, in their units."""
        return {name: deviation for name, deviation in zip(self, self._about["deviations"]) if deviation > 0.0}

    @property
    def correlations(self) -> dict[tuple[str, str], float]:
        """The correlations between measured parameters that vary together, by the names of the two, each pair once."""
        names = tuple(self)
        return {(names[first], names[second]): value for first, second, value in self._about["correlations"]}

    def add(self, *bodies: str | os.PathLike[str]) -> Design:
        """The same with bodies joined to its frames, such as a rider or a rack: files, or what is in them in one line::

            >>> pista.add("rider.toml", "mass=1.2 kg, at=(-0.1, 0, -0.75), box=(0.4, 0.2, 0.02), to=rear")

        Standard deviations of one design and of bodies propagate to the whole, and vary together then.

        Raises
        ------
        ValueError
            With everything that is wrong with a body, or if the model has no such frame.
        """
        loaded = self._one().add(self._about, [os.fspath(body) for body in bodies])
        return self._loaded(self.model, loaded)

    def replace(self, **parameters: Value) -> Design:
        """The same with other values of some parameters: numbers, texts with units, or arrays.

        Raises
        ------
        ValueError
            If one is no parameter of the model, or its value is none that it can have.
        """
        return self._replaced(parameters)

    @property
    def feedback(self) -> tuple[str, ...]:
        """The laws of the forces that follow from the motion, as they were written."""
        return tuple(self._about["feedback"])

    def with_feedback(self, *laws: str) -> Design:
        """The same with forces that follow from the motion, in the place of what :attr:`feedback` it has; without laws it has none.

        Each law is of the force on one coordinate, a sum of positions and rates, each times numbers and powers of the speed v from
        1/v to v (rates) and from 1 to v^2 (positions)::

            >>> carvallo.Whipple("benchmark").with_feedback("Tdelta = 10*(4.7 - v)*phi_rate").stability()

        Matrices, eigenvalues, critical speeds, motions and all else are then of the closed loop.

        Raises
        ------
        ValueError
            With everything that is wrong with the laws.
        """
        for law in laws:
            if not isinstance(law, str):
                raise TypeError(f"a law is {law!r}; expected a text such as 'Tdelta = 10*phi_rate'")
        about: About = {**self._about, "feedback": list(laws)}
        return self._of(self.model, list(self._values), about, self.notes)

    def _replaced(self, parameters: Mapping[str, Value]) -> Design:
        if not parameters:
            return self
        values: list[Any] = list(self._values)
        for name, value in parameters.items():
            position = self.model._kernel.position(name)
            values[position] = self.model._kernel.evaluate(position, value) if isinstance(value, str) else as_number(name, value)
        design = self._of(self.model, values, self._about, self.notes)
        if not design.shape:
            design._designs.validate()
        return design

    def __getitem__(self, name: str) -> float | NDArray[np.float64]:
        try:
            return self._values[self.model._kernel.position(name)]
        except ValueError as error:
            raise KeyError(str(error)) from None

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self.model)

    def __len__(self) -> int:
        return len(self._values)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]

    def to_dict(self, parameterization: str = "paper") -> dict[str, float]:
        """The parameters of one design by their names, in SI units: those of the paper, or of a bicycle in another
        parameterization: ``moore``, ``pydy``, ``principal``, ``gyrostats``, ``libbicycle``, ``jbike6`` or ``geometry``. A dict
        in any of them makes the same design again: ``carvallo.Whipple(pista.to_dict("moore"))``.

        Raises
        ------
        ValueError
            If there is no such parameterization, or the design cannot be expressed in it.
        """
        if parameterization == "paper":
            self._one()
            return {name: float(value) for name, value in self.items()}
        return dict(self._one().parameterized(self._about, parameterization))

    def to_text(self, form: str = "toml", parameterization: str = "paper", *, units: str = "si") -> str:
        """One design as the contents of a file that :meth:`Model.__call__` and the command line read again, to the same doubles.

        Parameters
        ----------
        form
            ``toml``, with comments, deviations, correlations and feedback; of bicycles also ``json``, ``yaml``, ``csv``, a script of
            ``python`` or ``matlab``, or ``text`` as BicycleParameters has it. What has no place in a form is told by a warning.
        parameterization
            As for :meth:`to_dict`.
        units
            What values are written in, where the form has units: ``"mm,deg,km/h"``, ``"imperial"``, or those of the SI.

        Raises
        ------
        ValueError
            If there is no such form, parameterization or unit, or the design cannot be expressed so.
        """
        text, notes = self._one().text(self._about, parameterization, form, units)
        for note in notes:
            warnings.warn(f"{self.name}: {note}", stacklevel=2)
        return text

    def at(self, *index: int) -> Design:
        """One design out of an array of them, by its index along each axis."""
        values = [value if isinstance(value, float) else value[index] for value in self._values]
        if any(np.ndim(value) for value in values):
            raise IndexError(f"there are designs in {len(self.shape)} axes: expected as many indices, {len(index)} are given")
        return self._of(self.model, values, self._about, self.notes)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Design):
            return NotImplemented
        is_same = self.model == other.model and self.feedback == other.feedback
        return is_same and all(np.array_equal(a, b) for a, b in zip(self._values, other._values))

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return Design._of, (self.model, self._values, self._about, self.notes)

    def __repr__(self) -> str:
        many = f" {self.shape}" if self.shape else ""
        return f"<{self.model.name} {self.name}{many}>"

    def samples(self, count: int, seed: int | np.random.Generator | None = None) -> Design:
        """Designs that could be this one: ``count`` of them, drawn from the normal distributions of its :attr:`deviations` with their
        :attr:`correlations`, by numpy's generator with a seed. Of wide deviations a draw may be none that a design can have, as
        a negative mass: ``carvallo.stability(dict(samples))`` tells which they are and computes the others.

        Raises
        ------
        ValueError
            If no parameter has a deviation.
        """
        return samples_of(self, count, seed)

    def _one(self) -> _carvallo.Designs:
        """For what there is of one design alone."""
        if self.shape:
            raise ValueError(f"there are {self.size} designs: choose one, as in design.at({', '.join('0' for _ in self.shape)})")
        return self._designs


__all__ = ["Design"]
