"""A model of one's own: built by one command, and as good as those that ship.

It builds Symbolica, which takes a minute or more: run where CARVALLO_TEST_TEMPLATE is set, as `.ci/run` does.
"""

import os
import subprocess
import sys
from pathlib import Path

import carvallo
import pytest

TEMPLATE = Path(__file__).parents[1] / "template"
PROGRAM = """
import math, pickle
from coin import Coin
euro = Coin("euro")
(marginal,) = euro.marginal_ranges()
# sqrt(g r / 3), of textbooks. States are the lean, its rate and that of the yaw.
assert abs(marginal.start - math.sqrt(9.81 * 0.011625 / 3)) < 1e-12, marginal
assert euro.replace(r=[0.01, 0.02]).eigenvalues(0.3).shape == (2, 3)
assert pickle.loads(pickle.dumps(euro)) == euro
try:
    Coin("euro", r=-1)
except ValueError as error:
    assert str(error) == "`r` is -1 m; it must be > 0", error
else:
    raise AssertionError
print("done")
"""


@pytest.mark.skipif("CARVALLO_TEST_TEMPLATE" not in os.environ, reason="it builds Symbolica: set CARVALLO_TEST_TEMPLATE")
def test_a_model_of_ones_own(tmp_path):
    install = [sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "--target", tmp_path, TEMPLATE]
    # Where the interpreter is, maturin is.
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    environment = os.environ | {"CARGO_TARGET_DIR": str(TEMPLATE.parents[2] / "target" / "template"), "PATH": path}
    # Without optimization, which a test does not need.
    subprocess.run([*install, "--config-settings=build-args=--profile=dev"], check=True, env=environment)
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(tmp_path), str(Path(carvallo.__file__).parents[1])])}
    found = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, env=environment, cwd=tmp_path)
    assert found.stdout == "done\n", found.stderr
