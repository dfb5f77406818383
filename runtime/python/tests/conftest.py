import carvallo
import pytest


@pytest.fixture
def benchmark():
    return carvallo.Whipple("benchmark")
