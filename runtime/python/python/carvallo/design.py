"""Designs: a model with its parameters."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from numbers import Real
from typing import TYPE_CHECKING, Any, NamedTuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _carvallo
from ._dicts import About, Loaded
from .along import Along, along_of
from .control import InputOutput, state_space_of
from .controlled import Controlled
from .motion import Event, Force, Motion, simulate
from .pictures import Picture
from .samples import samples_of, varied_of
from .sensitivity import Sensitivity
from .stability import CriticalSpeed, Range, Stability, stability_of
from .turns import SteadyTurns, turns_of

if TYPE_CHECKING:
    from .model import Model

Value = Union[float, str, ArrayLike]
"""The value of a parameter: a number, a text with a unit, or an array with one number for each design."""


class StateSpace(NamedTuple):
    """The state-space form ``x' = A x + B f``."""

    A: NDArray[np.float64]
    """Of shape (…, states, states)."""
    B: NDArray[np.float64]
    """Of shape (…, states, coordinates): the inputs f are the generalized forces."""


class System(NamedTuple):
    """The equations of motion ``M q'' + C q' + K q = f`` at one speed."""

    M: NDArray[np.float64]
    C: NDArray[np.float64]
    K: NDArray[np.float64]


class Eigenvectors(NamedTuple):
    """Eigenvalues s with the shapes of their modes."""

    values: NDArray[np.complex128]
    """In 1/s, of shape (…, states), sorted by real part, then by imaginary part."""
    right: NDArray[np.complex128]
    """Of shape (…, states, coordinates): ``right[..., k, :]`` is the x of eigenvalue k with ``(s^2 M + s C + K) x = 0``. Its
    largest component is 1; the coordinates move as ``Re(x exp(s t))``, and rates are s times as large."""
    left: NDArray[np.complex128]
    """Of the same shape: the y with ``y^H (s^2 M + s C + K) = 0``, scaled by ``y^H (2 s M + C) x = 1``, so that an impulse f
    excites the mode by ``y^H f``."""


class Modes(NamedTuple):
    """Eigenvalues with the names of their modes."""

    values: NDArray[np.complex128]
    """In 1/s, of shape (speeds…, states), in the order of the modes: each is continuous along the speeds."""
    names: NDArray[np.str_]
    """Of the same shape: ``castering``, ``capsize``, ``weave``, ``wobble``, of machines that do not lean and steer ``divergence``
    and ``flutter``, and ``real`` or ``oscillatory`` where there is no name."""


class Design(Controlled, Mapping[str, Union[float, NDArray[np.float64]]]):
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

    name: str
    """What the design is called."""
    kind: str | None
    """What it is."""
    source: str | None
    """Where its parameters come from."""
    notes: tuple[str, ...]
    """What was read but not used, or taken because it was not given."""

    model: Model
    """The model that it is of."""
    _values: list[float | NDArray[np.float64]]
    _kernel: _carvallo.Kernel
    _designs: _carvallo.Designs
    _about: About

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
        parameterization: ``moore``, ``pydy``, ``principal``, ``gyrostats``, ``jbike6`` or ``geometry``. A dict in any of them
        makes the same design again: ``carvallo.Whipple(pista.to_dict("moore"))``.

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

    def matrices(self, *, threads: int | None = None) -> dict[str, NDArray[np.float64]]:
        """The coefficient matrices of
        ``M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f`` that the model has, by their names.

        Returns
        -------
        dict of arrays of shape (designs…, coordinates, coordinates)
            For coordinates that are angles in rad, M in kg m^2, C-1 in N m^2, C0 in N m s, C1 in kg m, Kc in N m, K0 in kg m,
            K1 in N s and K2 in kg.
        """
        names = ("M", "C-1", "C0", "C1", "Kc", "K0", "K1", "K2")
        matrices = dict(zip(names, self._designs.matrices(threads)))
        return {name: matrices[name] for name in self._kernel.matrices}

    def system(self, v: ArrayLike = 0.0, *, paired: bool = False, threads: int | None = None) -> System:
        """M, C and K of ``M q'' + C q' + K q = f`` at forward speeds in m/s, each of shape
        (designs…, speeds…, coordinates, coordinates)."""
        return System(*self._designs.system(v, paired, threads))

    @overload
    def state_space(self, v: ArrayLike = 0.0, *, paired: bool = False, threads: int | None = None) -> StateSpace: ...

    @overload
    def state_space(self, v: ArrayLike = 0.0, *, inputs: Sequence[str] | str,
                    outputs: Sequence[str] | str | None = None) -> InputOutput: ...

    @overload
    def state_space(self, v: ArrayLike = 0.0, *, inputs: Sequence[str] | str | None = None,
                    outputs: Sequence[str] | str) -> InputOutput: ...

    def state_space(self, v: ArrayLike = 0.0, *, inputs: Sequence[str] | str | None = None,
                    outputs: Sequence[str] | str | None = None, paired: bool = False,
                    threads: int | None = None) -> StateSpace | InputOutput:
        """A and B of ``x' = A x + B f`` at forward speeds in m/s; the states x are those of
        :attr:`Model.states <carvallo.Model.states>`, in rad, rad/s and so on, and the inputs f the generalized forces.

        With ``inputs`` or ``outputs`` A, B, C and D of one design, as in
        ``control.ss(*design.state_space(5.0, inputs="Tdelta", outputs=["phi", "phi_rate"]))``. Inputs are torques and forces as
        ``Tdelta``, all of them unless they are named; outputs are coordinates, rates and accelerations, ``phi``, ``phi_rate``,
        ``phi_acceleration``, of bicycles also of the yaw ``psi`` and the lateral place ``y``, and the states unless they are named.
        Positions that the motion does not depend on become states, the last, where an output asks for them.

        Raises
        ------
        ValueError
            If the mass matrix is singular, or at rest if there is a C-1; if there is no input or output of a name.
        """
        if inputs is None and outputs is None:
            return StateSpace(*self._designs.state_space(v, paired, threads))
        return state_space_of(self, v, inputs, outputs)

    def eigenvalues(self, v: ArrayLike = 0.0, *, paired: bool = False, threads: int | None = None) -> NDArray[np.complex128]:
        """The eigenvalues in 1/s at forward speeds in m/s.

        Returns
        -------
        complex array of shape (designs…, speeds…, states)
            Sorted by real part, then by imaginary part: the last one grows fastest.
        """
        return self._designs.eigenvalues(v, paired, threads)

    def eigenvectors(self, v: ArrayLike = 0.0, *, paired: bool = False, threads: int | None = None) -> Eigenvectors:
        """The eigenvalues at forward speeds in m/s, with their right and left eigenvectors."""
        return Eigenvectors(*self._designs.eigenvectors(v, paired, threads))

    def stability(self, v: ArrayLike = (), *, threads: int | None = None) -> Stability:
        """Critical speeds and stable ranges of all designs, as masked arrays in their shape; with verdicts and eigenvalues at
        the forward speeds v in m/s.

        Critical speeds are not scanned for: all are found, to full precision.

        Raises
        ------
        ValueError
            If a design is none, or has no answer, as with a singular mass matrix. :func:`carvallo.stability` has tables in
            which single designs may be wrong.
        """
        return stability_of(self, v, threads)

    def critical_speeds(self) -> tuple[CriticalSpeed, ...]:
        """All critical speeds of one design, ascending; :meth:`stability` has those of many."""
        return tuple(CriticalSpeed(*speed) for speed in self._one().critical()[0])

    def stable_ranges(self) -> tuple[Range, ...]:
        """The ranges of forward speed in which one design is stable, ascending."""
        return tuple(Range(*ends) for ends in self._one().critical()[1])

    def marginal_ranges(self) -> tuple[Range, ...]:
        """The ranges of forward speed in which no motion of one design grows, and some do not die away."""
        return tuple(Range(*ends) for ends in self._one().critical()[2])

    def undecided_ranges(self) -> tuple[Range, ...]:
        """The ranges of forward speed in which a critical speed of one design may be missing, since rounding decides there
        whether an eigenvalue crosses the imaginary axis: nearly always none."""
        return tuple(Range(*ends) for ends in self._one().critical()[3])

    def modes(self, v: ArrayLike = 0.0) -> Modes:
        """The eigenvalues of one design at forward speeds from 0 in m/s, followed mode by mode, with their names."""
        values, names = self._one().modes(self._about, v)
        return Modes(values, np.array(names).reshape(values.shape))

    def sensitivity(self) -> Sensitivity:
        """How the critical speeds of one design change with its parameters, and what their standard deviations make of them.

        Raises
        ------
        ValueError
            If the model was compiled without derivatives.
        """
        return Sensitivity(self)

    def turns(self, steer: ArrayLike | None = None) -> SteadyTurns:
        """The circles that one design runs in hands free: a curve from each capsize speed, and others. With ``steer`` in rad only
        the turns with that steer, or those steers.

        Raises
        ------
        ValueError
            If the model has no nonlinear equations, or there are no turns.
        """
        return turns_of(self, steer)

    def plot(self, v: tuple[float, float] | None = None, values: tuple[float, float] | None = None) -> Picture:
        """The eigenvalues of one design against the forward speed: between two speeds in m/s, or as far as there is something to
        see; and between two values in 1/s."""
        return Picture(self._one().eigenvalues_svg(self._about, v, values))

    def locus(self, v: tuple[float, float] | None = None) -> Picture:
        """The root locus of one design: its eigenvalues in the complex plane while the forward speed grows from one to another in
        m/s, or as far as there is something to see. With :meth:`with_feedback` it is that of the closed loop."""
        return Picture(self._one().locus_svg(self._about, v))

    def phasors(self, v: ArrayLike = 0.0) -> Picture:
        """The eigenvectors of one design at forward speeds in m/s, up to 12 of them: for each mode a dial, on which the
        coordinates are arrows with their sizes and phases. :meth:`eigenvectors` has the numbers."""
        return Picture(self._one().phasors_svg(self._about, np.asarray(v, dtype=np.float64).ravel().tolist()))

    def along(self, parameter: str, low: float | str, high: float | str, v: float | None = None, *, count: int = 101) -> Along:
        """One design along one of its parameters, at a forward speed in m/s: the values between ``low`` and ``high``, numbers in SI
        units or texts with a unit, at which its stability changes, and the eigenvalues at ``count`` values from end to end.

        Critical values are not scanned for: all are found, to full precision.

        Raises
        ------
        ValueError
            If there is no such parameter or no such range of it, if there is no speed and the model depends on it, or if there
            is no answer.
        """
        return along_of(self, parameter, low, high, v, count)

    def map(self, base: Design | None = None, *, threads: int | None = None) -> Picture:
        """Where the stable range of designs begins, and how wide it is, over two parameters: of an array of designs with two axes, of
        which the first varies one parameter, upward in the picture, and the second another, to the right::

            >>> pista.replace(w=np.linspace(0.9, 1.2, 61)[:, np.newaxis], c=np.linspace(0.0, 0.1, 51)).map(pista)

        ``base`` is a design that is marked in it.

        Raises
        ------
        ValueError
            If there are not two such parameters, or more than a million designs.
        """
        if base is not None and base.model != self.model:
            raise ValueError(f"the base is of the model {base.model.name}; the designs are of {self.model.name}")
        return Picture(self._designs.map_svg(self.name, varied_of(self._values, self.shape, base), threads))

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

    def side_view(self) -> Picture:
        """The side view of a bicycle, to scale.

        Raises
        ------
        ValueError
            If the model is none of a bicycle.
        """
        svg = self._one().side_view_svg(self._about)
        if svg is None:
            raise ValueError(f"{self.model.name} {self.name} has no side view: it takes the parameters of a bicycle")
        return Picture(svg)

    def _repr_svg_(self) -> str | None:
        return None if self.shape else self.plot().svg

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

    def _one(self) -> _carvallo.Designs:
        """For what there is of one design alone."""
        if self.shape:
            raise ValueError(f"there are {self.size} designs: choose one, as in design.at({', '.join('0' for _ in self.shape)})")
        return self._designs


def is_array(value: object) -> bool:
    """Whether a value has a number for each of many designs."""
    return not isinstance(value, (str, Real)) and np.ndim(value) > 0  # type: ignore[arg-type]


def as_number(name: str, value: object) -> float | NDArray[np.float64]:
    """Numbers as doubles."""
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(f"`{name}` is {value!r}; expected a number, a text with one, or an array of numbers") from None
    return array if array.ndim else float(array)


def as_text(value: object) -> str:
    """A value as it would stand in a file: numbers with all their digits."""
    return value if isinstance(value, str) else repr(float(value)) if isinstance(value, (Real, np.generic)) else str(value)


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


__all__ = ["Design", "Eigenvectors", "Modes", "StateSpace", "System", "Value", "example", "measure", "read", "rider"]
