"""Stability of bicycles and of other machines: matrices, eigenvalues, critical speeds.

Every model that ships is here under its name, and calling it makes a design::

    >>> import carvallo
    >>> pista = carvallo.Whipple("pista")
    >>> pista.eigenvalues(5.0)
    >>> pista.critical_speeds()
    >>> heavier = pista.replace(mB=numpy.linspace(60, 120, 1001))
    >>> heavier.stability().stable_from

``carvallo.models()`` has all of them, ``help(carvallo.Whipple)`` its parameters. Values are in SI units, angles in rad, or texts
with a unit, as ``"18 deg"``. What is wrong is a ValueError that says so in the words of the command line.
"""

from typing import TYPE_CHECKING

from ._carvallo import __version__
from .along import Along, CriticalValue
from .checking import Comparison, Explanation, Report, check
from .comparing import Differences, Optimum, SpeedChange, compare, optimize
from .control import InputOutput, Margins, Response, SingularValues, TransferFunction
from .controllability import Controllability, LostMode
from .design import Design
from .linearized import Eigenvectors, Modes, StateSpace, System
from .model import Coordinate, Model, Parameter, models
from .motion import Motion
from .pictures import Picture
from .reading import example, measure, read, rider
from .regulators import Regulators
from .responses import TimeResponse
from .sensitivity import CriticalDerivatives, Sensitivity
from .stability import CriticalSpeed, Range, Stability
from .tables import stability
from .turns import SteadyTurns, Turns

globals().update(models())

if TYPE_CHECKING:

    def __getattr__(name: str) -> Model: ...


__all__ = [
    "Along",
    "Comparison",
    "Controllability",
    "Coordinate",
    "CriticalDerivatives",
    "CriticalSpeed",
    "CriticalValue",
    "Design",
    "Differences",
    "Eigenvectors",
    "Explanation",
    "InputOutput",
    "LostMode",
    "Margins",
    "Model",
    "Modes",
    "Motion",
    "Optimum",
    "Parameter",
    "Picture",
    "Range",
    "Regulators",
    "Report",
    "Response",
    "Sensitivity",
    "SingularValues",
    "SpeedChange",
    "Stability",
    "StateSpace",
    "SteadyTurns",
    "System",
    "TimeResponse",
    "TransferFunction",
    "Turns",
    "__version__",
    "check",
    "compare",
    "example",
    "measure",
    "models",
    "optimize",
    "read",
    "rider",
    "stability",
    *models(),
]
