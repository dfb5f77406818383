"""Pictures as SVG, which notebooks show."""

from __future__ import annotations

import os
from pathlib import Path


class Picture:
    """A picture; notebooks show it, and :meth:`save` writes it."""

    def __init__(self, svg: str) -> None:
        self.svg = svg

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes it to a file, as SVG."""
        Path(path).write_text(self.svg, encoding="utf-8")

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<picture of {len(self.svg):,} bytes of SVG>"


__all__ = ["Picture"]
