"""Pictures of designs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ._described import Described
from .pictures import Picture
from .samples import varied_of

if TYPE_CHECKING:
    from .design import Design


class Drawn(Described):
    """Pictures of one design, and of many."""

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


__all__ = ["Drawn"]
