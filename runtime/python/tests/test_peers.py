"""What other libraries take."""

import numpy as np
import pytest


def test_python_control_takes_the_state_space(benchmark):
    control = pytest.importorskip("control", reason="python-control is not installed")
    a, b = benchmark.state_space(5.0)
    system = control.ss(a, b, np.eye(4), 0)
    np.testing.assert_allclose(np.sort_complex(system.poles()), np.sort_complex(benchmark.eigenvalues(5.0)), rtol=1e-10)
    gain, _, _ = control.lqr(a, b[:, [1]], np.eye(4), np.eye(1))
    assert np.linalg.eigvals(a - b[:, [1]] @ gain).real.max() < 0.0


def test_xarray_takes_eigenvalues(benchmark):
    xarray = pytest.importorskip("xarray", reason="xarray is not installed")
    speeds = np.linspace(0.0, 10.0, 11)
    values = xarray.DataArray(benchmark.eigenvalues(speeds), {"v": speeds}, ["v", "mode"])
    stable = values.real.max("mode") < 0.0
    assert stable.sel(v=5.0) and not stable.sel(v=2.0)
