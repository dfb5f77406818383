import re
from pathlib import Path

import carvallo
import pytest

PAGE = Path(__file__).parents[1] / "docs" / "many_machines.md"


@pytest.fixture
def benchmark():
    return carvallo.Whipple("benchmark")


@pytest.fixture
def program():
    """The program on the page about many machines that imports an engine."""

    def found(engine):
        programs = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
        (own,) = [own for own in programs if re.search(rf"(import|from)\b.*\b{engine}\b", own)]
        return own

    return found
