"""Designs beyond one machine: from partitioned Parquet to partitioned Parquet, by Dask. ::

    pip install dask distributed pyarrow
    python runtime/python/examples/dask_parquet.py designs/ results/

``designs/`` has ``*.parquet`` with a column for each parameter. For each file there is one of the same name in ``results/``, with
its columns, those of critical speeds and stable ranges, and ``error``. A worker that dies loses nothing: its files are computed
by another one. A file appears when it is whole, under its own name, so that none is there twice or in part, however often it was
tried; what is there already is not computed again.
"""

import sys
import uuid
from pathlib import Path

import carvallo
import pyarrow.parquet as parquet


def compute(source: Path, target: Path) -> int:
    """The results of one file; how many designs it has."""
    if not target.exists():
        # Workers share the cores: one thread each.
        results = carvallo.stability(parquet.read_table(source), threads=1)
        partial = target.with_suffix(f".{uuid.uuid4().hex}.partial")
        parquet.write_table(results, partial)
        partial.replace(target)
    return parquet.read_metadata(target).num_rows


def sweep(client, source: Path, target: Path) -> int:
    """All files of a folder; how many designs there are."""
    files = sorted(source.glob("*.parquet"))
    if not files:
        raise FileNotFoundError(f"there is no file `*.parquet` in `{source}`")
    target.mkdir(parents=True, exist_ok=True)
    tasks = client.map(compute, files, [target / file.name for file in files], pure=False)
    return sum(client.gather(tasks))


if __name__ == "__main__":
    from dask.distributed import Client, LocalCluster

    if len(sys.argv) != 3:
        sys.exit("usage: dask_parquet.py DESIGNS RESULTS, two folders")
    # Or `Client("scheduler:8786")` for a cluster that is there.
    with LocalCluster(threads_per_worker=1) as cluster, Client(cluster) as client:
        print(sweep(client, Path(sys.argv[1]), Path(sys.argv[2])), "designs")
