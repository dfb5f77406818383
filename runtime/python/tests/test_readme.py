"""What the pages show comes out."""

import doctest
from pathlib import Path

import pytest

PAGES = Path(__file__).parents[1]


@pytest.mark.parametrize("page", ["README.md"])
def test_examples_come_out(page):
    found = doctest.testfile(str(PAGES / page), module_relative=False, optionflags=doctest.ELLIPSIS, encoding="utf-8")
    assert found.attempted > 0 and found.failed == 0
