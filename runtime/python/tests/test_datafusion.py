"""DataFusion: a function over Arrow arrays, as the page on many machines has it."""

import numpy as np
import pytest

arrow = pytest.importorskip("pyarrow", reason="pyarrow is not installed")
pytest.importorskip("datafusion", reason="DataFusion is not installed")
parquet = pytest.importorskip("pyarrow.parquet")


def test_the_page_averages_over_what_is_stable(tmp_path, program, monkeypatch, benchmark):
    columns = {name: np.full(1000, value) for name, value in benchmark.items()} | {"c": np.linspace(-0.3, 0.1, 1000)}
    (tmp_path / "designs").mkdir()
    parquet.write_table(arrow.table(columns), tmp_path / "designs" / "part.0.parquet")
    monkeypatch.chdir(tmp_path)
    head, _, query = program("datafusion").rstrip().rpartition("\n")
    scope = {}
    exec(head, scope)
    (batch,) = eval(query, scope).collect()
    expected = benchmark.replace(c=columns["c"]).stability().stable_from
    assert expected.mask.any() and batch.column(0)[0].as_py() == pytest.approx(expected.mean(), rel=1e-12)
