"""Stubs that are those of the compiled module, and types that hold."""

import os
import subprocess
import sys
from pathlib import Path

import carvallo
import pytest

pytest.importorskip("mypy", reason="mypy is not installed")
FOUND_IN = Path(carvallo.__file__).parents[1]
# Where it is not installed, mypy has to be told.
ENVIRONMENT = os.environ | ({} if FOUND_IN.name == "site-packages" else {"MYPYPATH": str(FOUND_IN)})
PYPROJECT = Path(__file__).parents[1] / "pyproject.toml"


def test_stubs_are_those_of_the_modules(tmp_path):
    # Models are attributes of the module by what it finds compiled, and their type is that of `__getattr__`.
    allowed = tmp_path / "allowed"
    allowed.write_text("carvallo.__getattr__\ncarvallo.__all__\n" + "\n".join(f"carvallo.{name}" for name in carvallo.models()))
    command = [sys.executable, "-m", "mypy.stubtest", "carvallo", "--allowlist", allowed, "--ignore-unused-allowlist",
               "--mypy-config-file", PYPROJECT]
    found = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=ENVIRONMENT)
    assert found.returncode == 0, found.stdout + found.stderr


def test_what_users_write_is_typed(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(
        "import carvallo\nimport numpy as np\n"
        "pista = carvallo.Whipple('pista', mB=np.linspace(60, 120, 3), lam='18 deg')\n"
        "reveal_type(pista)\nreveal_type(pista.eigenvalues(5.0))\nreveal_type(pista.critical_speeds()[0].speed)\n"
        "pista.eigenvalues(speed=5.0)\n"
    )
    command = [sys.executable, "-m", "mypy", "--config-file", PYPROJECT, program]
    text = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=ENVIRONMENT).stdout
    assert 'Revealed type is "carvallo.design.Design"' in text and "complex" in text and '"float"' in text
    assert 'Unexpected keyword argument "speed"' in text and "Found 1 error" in text
