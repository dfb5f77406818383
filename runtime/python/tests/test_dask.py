"""Dask: partitioned Parquet to partitioned Parquet, and a worker that is killed."""

import os
import signal
import time
from pathlib import Path

import carvallo
import numpy as np
import pytest

arrow = pytest.importorskip("pyarrow", reason="pyarrow is not installed")
distributed = pytest.importorskip("distributed", reason="Dask is not installed")
parquet = pytest.importorskip("pyarrow.parquet")
pytestmark = pytest.mark.filterwarnings("ignore")

FILES, ROWS = 12, 2000
EXAMPLES = Path(__file__).parents[1] / "examples"


@pytest.fixture
def designs(tmp_path, benchmark):
    rng = np.random.default_rng(3)
    (tmp_path / "designs").mkdir()
    for part in range(FILES):
        columns = {name: np.full(ROWS, value) for name, value in benchmark.items()} | {"w": rng.uniform(0.9, 1.2, ROWS)}
        columns["id"] = np.arange(part * ROWS, (part + 1) * ROWS)
        parquet.write_table(arrow.table(columns), tmp_path / "designs" / f"part.{part}.parquet")
    return tmp_path


def test_a_killed_worker_loses_and_doubles_nothing(designs, monkeypatch):
    monkeypatch.syspath_prepend(EXAMPLES)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(EXAMPLES), str(Path(carvallo.__file__).parents[1])]))
    from dask_parquet import sweep

    killed = []

    def slowly(source, target):
        """The same, so slow that the worker can be killed in the middle of it."""
        import time

        from dask_parquet import compute

        time.sleep(0.3)
        return compute(source, target)

    target = designs / "results"
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, \
            distributed.Client(cluster) as client:
        files = sorted((designs / "designs").glob("*.parquet"))
        target.mkdir()
        tasks = client.map(slowly, files, [target / file.name for file in files], pure=False)
        while len(list(target.glob("*.parquet"))) < 2:
            time.sleep(0.01)
        worker = next(iter(client.run(os.getpid).values()))
        os.kill(worker, signal.SIGKILL)
        killed.append(worker)
        assert sum(client.gather(tasks)) == FILES * ROWS
        assert worker not in client.run(os.getpid).values()
        # And the whole of the example, which finds that all is there.
        assert sweep(client, designs / "designs", target) == FILES * ROWS
    assert killed and sorted(path.name for path in target.glob("*.parquet")) == sorted(path.name for path in files)
    results = arrow.concat_tables([parquet.read_table(path) for path in sorted(target.glob("*.parquet"))])
    assert sorted(results["id"].to_pylist()) == list(range(FILES * ROWS))
    given = arrow.concat_tables([parquet.read_table(path) for path in files]).sort_by("id")
    expected = carvallo.stability(given)
    assert results.sort_by("id")["stable_from_1"].equals(expected["stable_from_1"])
