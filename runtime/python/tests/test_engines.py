"""Ray and Spark: designs from Parquet to Parquet, as the page on many machines has it."""

import shutil
import sys

import numpy as np
import pytest

arrow = pytest.importorskip("pyarrow", reason="pyarrow is not installed")
parquet = pytest.importorskip("pyarrow.parquet")


@pytest.fixture
def designs(tmp_path, monkeypatch, benchmark):
    """Four files of designs, of which some are none."""
    (tmp_path / "designs").mkdir()
    trails = np.linspace(-0.3, 0.1, 1000)
    columns = {name: np.full(1000, value) for name, value in benchmark.items()} | {"c": trails}
    columns["mB"][::50] = -1.0
    table = arrow.table(columns)
    for part in range(4):
        parquet.write_table(table.slice(250 * part, 250), tmp_path / "designs" / f"part.{part}.parquet")
    monkeypatch.chdir(tmp_path)
    return trails


def agree(folder, trails, benchmark):
    """Each design is there once, with its own result."""
    found = parquet.read_table(folder).sort_by("c")
    np.testing.assert_array_equal(found["c"], trails)
    errors = np.array([error is not None for error in found["error"].to_pylist()])
    assert errors.sum() == 20 and errors[::50].all() and "`mB` is -1 kg" in found["error"][0].as_py()
    expected = benchmark.replace(c=trails).stability().stable_from
    for stable, is_none, own in zip(found["stable_from_1"].to_pylist(), errors, np.ma.MaskedArray(expected)):
        assert stable == (None if is_none or own is np.ma.masked else own)


# Theirs, of what they call themselves.
@pytest.mark.filterwarnings("ignore")
def test_ray(designs, program, benchmark, monkeypatch):
    # It would write a token to the home of the user.
    monkeypatch.setenv("RAY_AUTH_MODE", "disabled")
    ray = pytest.importorskip("ray", reason="Ray is not installed")
    pytest.importorskip("ray.data", reason="Ray is installed without ray[data]")
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        exec(program("ray"), {})
    finally:
        ray.shutdown()
    agree("results", designs, benchmark)


@pytest.mark.filterwarnings("ignore")
def test_spark(designs, program, benchmark, monkeypatch):
    pytest.importorskip("pyspark", reason="Spark is not installed")
    if shutil.which("java") is None:
        pytest.skip("Spark needs Java, and there is none")
    # Its workers take the Python that is found first.
    monkeypatch.setenv("PYSPARK_PYTHON", sys.executable)
    scope = {}
    try:
        exec(program("pyspark"), scope)
    finally:
        if "spark" in scope:
            scope["spark"].stop()
    agree("results", designs, benchmark)
