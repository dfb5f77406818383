"""The names of BicycleParameters' ``Meijaard2007Model``, computed by Carvallo: its users change one import. ::

    from carvallo.bicycleparameters import Meijaard2007Model

What is returned is theirs, to rounding, but for two orders: eigenvalues are sorted by real part, then by imaginary part, and
where an array is varied plots follow each eigenvalue by continuity.
"""

from __future__ import annotations

import itertools
import warnings
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .design import Design
from .model import models

Floats = NDArray[np.float64]

_PERMUTATIONS = np.array(list(itertools.permutations(range(4))))


class Meijaard2007Model:
    """The Whipple-Carvallo bicycle of Meijaard, Papadopoulos, Ruina & Schwab (2007).

    Parameters
    ----------
    parameter_set
        A parameter set of BicycleParameters, which has ``to_parameterization``, or a mapping with the same keys: ``IBxx``,
        ``IBxz``, ``IBzz``, ``IFxx``, ``IFyy``, ``IHxx``, ``IHxz``, ``IHzz``, ``IRxx``, ``IRyy``, ``c``, ``g``, ``lam``, ``mB``,
        ``mF``, ``mH``, ``mR``, ``rF``, ``rR``, ``v``, ``w``, ``xB``, ``xH``, ``zB``, ``zH``, in SI units.

    All methods take parameters as keywords in the place of those of the set: numbers, or arrays of one length n.
    """

    input_vars = ["Tphi", "Tdelta"]
    state_vars = ["phi", "delta", "phidot", "deltadot"]
    input_units = ["N-m", "N-m"]
    state_units = ["rad", "rad", "rad/s", "rad/s"]
    input_vars_latex = [r"T_\phi", r"T_\delta"]
    state_vars_latex = [r"\phi", r"\delta", r"\dot{\phi}", r"\dot{\delta}"]

    def __init__(self, parameter_set: Any) -> None:
        if hasattr(parameter_set, "to_parameterization"):
            self.parameter_set = parameter_set.to_parameterization("Meijaard2007")
        else:
            self.parameter_set = _Parameters(parameter_set)

    def _parse_parameter_overrides(self, **parameter_overrides: Any) -> tuple[dict[str, Any], list[str], int | None]:
        """All parameters, the keys of those that are arrays, and their length."""
        par = dict(self.parameter_set.parameters)
        array_keys, array_len = [], None
        for key, value in parameter_overrides.items():
            if key not in par:
                warnings.warn(f"{key} is not a valid parameter, ignoring", stacklevel=3)
            elif np.ndim(value) == 0:
                par[key] = float(value)
            else:
                if array_len not in (None, len(value)):
                    raise ValueError("All array valued parameters must have the same length.")
                array_len = len(value)
                array_keys.append(key)
                par[key] = np.asarray(value, dtype=np.float64)
        return par, array_keys, array_len

    def _design(self, par: Mapping[str, Any], leave_out: tuple[str, ...] = ()) -> Design:
        """Of what the equations of motion need; a wheel's inertias are about two axes."""
        whipple = models()["Whipple"]
        used = {key: value for key, value in par.items() if key in set(whipple) and key not in leave_out}
        return whipple("benchmark", **({"IByy": 0.0, "IHyy": 0.0} | used))

    def form_reduced_canonical_matrices(self, **parameter_overrides: Any) -> tuple[Floats, Floats, Floats, Floats]:
        """The matrices of ``M q'' + v C1 q' + (g K0 + v^2 K2) q = f``, with q = (phi, delta) and f = (Tphi, Tdelta).

        Returns
        -------
        M, C1, K0, K2 : ndarray, shape (2, 2) or (n, 2, 2)
        """
        par, _, _ = self._parse_parameter_overrides(**parameter_overrides)
        matrices = self._design(par, ("g",)).matrices()
        return matrices["M"], matrices["C1"], matrices["K0"], matrices["K2"]

    def form_state_space_matrices(self, **parameter_overrides: Any) -> tuple[Floats, Floats]:
        """A and B of ``x' = A x + B u``, with x = (phi, delta, phidot, deltadot) and u = (Tphi, Tdelta).

        Returns
        -------
        A : ndarray, shape (4, 4) or (n, 4, 4)
        B : ndarray, shape (4, 2) or (n, 4, 2)
        """
        design, speed, paired = self._at_speed(**parameter_overrides)
        a, b = design.state_space(speed, paired=paired)
        return a, b

    def _at_speed(self, **parameter_overrides: Any) -> tuple[Design, Any, bool]:
        """The designs, the speed, and whether each design has its own."""
        par, _, _ = self._parse_parameter_overrides(**parameter_overrides)
        design, speed = self._design(par), par["v"]
        paired = bool(design.shape)
        return design, np.broadcast_to(speed, design.shape) if paired else speed, paired

    def calc_eigen(self, left: bool = False, **parameter_overrides: Any) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """The eigenvalues, and the right or left eigenvectors of A, for which ``A.T v = s v``.

        Returns
        -------
        evals : ndarray, shape (4,) or (n, 4)
            In 1/s, sorted by real part, then by imaginary part.
        evecs : ndarray, shape (4, 4) or (n, 4, 4)
            The columns are the vectors, of length 1 and with a real largest component.
        """
        design, speed, paired = self._at_speed(**parameter_overrides)
        values, right, of_left = design.eigenvectors(speed, paired=paired)
        s = values[..., np.newaxis]
        if left:
            # Of A, the vectors of the quadratic problem, y^H (s^2 M + s C + K) = 0, make w^T = y^H (s M + C, M).
            m, c, _ = design.system(speed, paired=paired)
            y = of_left.conj()
            vectors = np.concatenate([s * (y @ m) + y @ c, y @ m], axis=-1)
        else:
            vectors = np.concatenate([right, s * right], axis=-1)
        vectors /= np.linalg.norm(vectors, axis=-1, keepdims=True)
        largest = np.take_along_axis(vectors, np.abs(vectors).argmax(axis=-1)[..., np.newaxis], axis=-1)
        vectors *= np.abs(largest) / largest
        return values, np.swapaxes(vectors, -1, -2)

    def simulate(self, times: ArrayLike, initial_conditions: ArrayLike,
                 input_func: Callable[[float, Floats], ArrayLike] | None = None, **parameter_overrides: Any) -> tuple[Floats, Floats]:
        """The states and inputs at times.

        Parameters
        ----------
        times : array_like, shape (n,)
            Ascending, in s.
        initial_conditions : array_like, shape (4,)
            In rad and rad/s.
        input_func : function
            ``u = f(t, x)``, of shape (2,) in N m; with it the equations are integrated by SciPy. Without it the solution is
            exact.

        Returns
        -------
        states : ndarray, shape (n, 4)
        inputs : ndarray, shape (n, 2)
        """
        self._require_numbers(**parameter_overrides)
        t, start = np.asarray(times, dtype=np.float64), np.asarray(initial_conditions, dtype=np.float64)
        a, b = self.form_state_space_matrices(**parameter_overrides)
        if input_func is None:
            return self._exact(t, start, **parameter_overrides), np.zeros((len(t), 2))
        from scipy.integrate import solve_ivp

        def rates(at: float, x: Floats) -> Floats:
            rate: Floats = a @ x + b @ np.asarray(input_func(at, x))
            return rate

        found = solve_ivp(rates, (t[0], t[-1]), start, t_eval=t, method="LSODA", rtol=1e-9, atol=1e-12)
        states: Floats = found.y.T
        return states, np.array([input_func(at, x) for at, x in zip(t, states)], dtype=np.float64)

    def simulate_modes(self, times: ArrayLike, **parameter_overrides: Any) -> Floats:
        """The motion of each mode alone, from the real part of its eigenvector: ndarray, shape (4, n, 4) by mode, time and
        state."""
        self._require_numbers(**parameter_overrides)
        t = np.asarray(times, dtype=np.float64)
        _, evecs = self.calc_eigen(**parameter_overrides)
        return np.array([self._exact(t, vector.real, **parameter_overrides) for vector in evecs.T])

    def _exact(self, times: Floats, start: Floats, **parameter_overrides: Any) -> Floats:
        design, speed, _ = self._at_speed(**parameter_overrides)
        names = ("phi", "delta", "phi_rate", "delta_rate")
        motion = design.simulate(speed, times=times - times[0], initial=dict(zip(names, start.tolist())), linear=True)
        return np.stack([motion[name] for name in names], axis=-1)

    def _require_numbers(self, **parameter_overrides: Any) -> None:
        if self._parse_parameter_overrides(**parameter_overrides)[1]:
            raise ValueError("Can only simulate with fixed parameters.")

    def plot_eigenvalue_parts(self, ax: Any = None, colors: Any = None, show_stable_regions: bool = True,
                              hide_zeros: bool | float = False, sort_modes: bool = True, **parameter_overrides: Any) -> Any:
        """Real (solid) and imaginary (dashed) parts of the eigenvalues against the parameter that is an array: an Axes of
        matplotlib, a new one unless it is given."""
        par, array_keys, _ = self._parse_parameter_overrides(**parameter_overrides)
        if not array_keys:
            raise ValueError("a parameter must be an array, such as v=numpy.linspace(0, 10, 101)")
        import matplotlib.pyplot as plt

        key, along = array_keys[0], par[array_keys[0]]
        ax = plt.subplots()[1] if ax is None else ax
        evals, _ = self.calc_eigen(**parameter_overrides)
        if sort_modes:
            evals = follow(evals)
        if show_stable_regions:
            low, high = min(evals.real.min(), evals.imag.min()), max(evals.real.max(), evals.imag.max())
            ax.fill_between(along, low, high, where=np.all(evals.real <= 0.0, axis=1), color="grey", alpha=0.25,
                            transform=ax.get_xaxis_transform())
        tolerance = hide_zeros if isinstance(hide_zeros, float) else 1e-14
        colors = [f"C{index}" for index in range(4)] if colors is None else list(colors)
        for part, style, dots in ((np.abs(evals.imag), "--", "C1"), (evals.real, "-", "black")):
            shown = np.where(bool(hide_zeros) & (np.abs(part) < tolerance), np.nan, part)
            for index, (values, color) in enumerate(zip(shown.T, colors)):
                line = {"linestyle": style, "color": color} if sort_modes else {
                    "linestyle": "none", "marker": ".", "markersize": 1, "color": dots}
                ax.plot(along, values, label=f"M{index + 1}", **line)
        ax.set_ylabel("Real and Imaginary Parts of the Eigenvalue [1/s]")
        ax.set_xlabel(f"${self.parameter_set.par_strings[key]}$")
        ax.set_xlim((along[0], along[-1]))
        ax.grid()
        if sort_modes:
            ax.legend(ncol=5)
        return ax

    def plot_eigenvectors(self, hide_zeros: bool | float = False, **parameter_overrides: Any) -> Any:
        """The components of the eigenvectors in the complex plane: Axes of shape (n, modes), a row for each value of the
        parameter that is an array of at most 10."""
        par, array_keys, length = self._parse_parameter_overrides(**parameter_overrides)
        if (length or 1) > 10:
            raise ValueError("Plots will be too large, use fewer than 11 values in the varied parameter.")
        import matplotlib.pyplot as plt

        evals, evecs = self.calc_eigen(**parameter_overrides)
        evals, evecs = np.atleast_2d(evals), evecs.reshape(-1, 4, 4)
        tolerance = hide_zeros if isinstance(hide_zeros, float) else 1e-14
        shown = [index for index in range(4) if not hide_zeros or abs(evals[-1, index]) >= tolerance]
        _, axes = plt.subplots(len(evals), len(shown), subplot_kw={"projection": "polar"}, layout="constrained", squeeze=False,
                               figsize=(3 * len(shown), 3 * len(evals)))
        for row, (values, vectors) in enumerate(zip(evals, evecs)):
            if array_keys:
                axes[row, 0].set_ylabel(f"{array_keys[0]} = {par[array_keys[0]][row]:1.2f}", labelpad=30)
            for ax, index in zip(axes[row], shown):
                vector = vectors[:, index] / np.abs(vectors[:, index]).max()
                for place, component in enumerate(vector):
                    ax.plot([0, np.angle(component)], [0, abs(component)], lw=4 - place)
                ax.set_rmax(1.0)
                ax.set_title(f"Eigenvalue: {values[index]:1.3f}", color="red" if values[index].real >= 0.0 else "black")
        axes[0, 0].legend([f"${name}$" for name in self.state_vars_latex], loc="upper center", bbox_to_anchor=(0.5, 1.05), ncol=4)
        return axes

    def plot_mode_simulations(self, times: ArrayLike, hide_zeros: bool | float = False, **parameter_overrides: Any) -> Any:
        """The motion of each mode alone: Axes of shape (modes, 2), angles in degrees and their rates."""
        import matplotlib.pyplot as plt

        motions = self.simulate_modes(times, **parameter_overrides)
        evals, _ = self.calc_eigen(**parameter_overrides)
        tolerance = hide_zeros if isinstance(hide_zeros, float) else 1e-12
        shown = [index for index in range(4) if not hide_zeros or abs(evals[index]) >= tolerance]
        _, axes = plt.subplots(len(shown), 2, sharex=True, squeeze=False, layout="constrained", figsize=(6.0, 2.0 * len(shown)))
        for row, index in zip(axes, shown):
            for ax, states, unit in zip(row, (slice(0, 2), slice(2, 4)), ("rad", "rad/s")):
                ax.plot(times, np.rad2deg(motions[index][:, states]), label=[f"${name}$" for name in self.state_vars_latex[states]])
                ax.set_ylabel(f"[{unit}]".replace("rad", "deg"))
                ax.set_title(f"Eigenvalue: {evals[index]:1.3f}", color="red" if evals[index].real >= 0.0 else "black")
                ax.legend()
        for ax in axes[-1]:
            ax.set_xlabel("Time [s]")
        return axes

    def plot_simulation(self, times: ArrayLike, initial_conditions: ArrayLike,
                        input_func: Callable[[float, Floats], ArrayLike] | None = None, **parameter_overrides: Any) -> Any:
        """Torques, angles and rates against time: three Axes."""
        import matplotlib.pyplot as plt

        states, inputs = self.simulate(times, initial_conditions, input_func=input_func, **parameter_overrides)
        _, axes = plt.subplots(3, sharex=True, layout="constrained")
        shown = ((inputs, self.input_vars_latex, "Torque\n[Nm]"), (np.rad2deg(states[:, :2]), self.state_vars_latex[:2], "Angle\n[deg]"),
                 (np.rad2deg(states[:, 2:]), self.state_vars_latex[2:], "Angular Rate\n[deg/s]"))
        for ax, (values, names, label) in zip(axes, shown):
            ax.plot(times, values)
            ax.legend([f"${name}$" for name in names])
            ax.set_ylabel(label)
        axes[-1].set_xlabel("Time [s]")
        return axes


class _Parameters:
    """A mapping in the place of a parameter set."""

    def __init__(self, parameters: Mapping[str, float]) -> None:
        self.parameters = dict(parameters)
        self.par_strings = {key: key for key in self.parameters}


def follow(evals: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Rows of four eigenvalues in the order in which each column moves least from row to row."""
    followed = np.array(evals)
    for before, row in zip(followed, followed[1:]):
        moved = np.abs(row[_PERMUTATIONS] - before).sum(axis=1)
        row[:] = row[_PERMUTATIONS[moved.argmin()]]
    return followed


__all__ = ["Meijaard2007Model", "follow"]
