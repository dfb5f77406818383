"""Tables: columns of numpy, pandas and Arrow in, the same out."""

import carvallo
import numpy as np
import pytest

ROWS = 5000


@pytest.fixture
def columns(benchmark):
    rng = np.random.default_rng(2)
    columns = {name: np.full(ROWS, value) for name, value in benchmark.items()}
    columns["w"] = rng.uniform(0.9, 1.2, ROWS)
    columns["c"] = rng.uniform(-0.3, 0.1, ROWS)
    columns["w"][7] = -1.0
    return columns


@pytest.fixture
def expected(columns, benchmark):
    """The first stable range of each design by itself."""
    def of(w, c):
        ranges = benchmark.replace(w=w, c=c).stable_ranges() if w > 0 else ()
        return ranges[0] if ranges else (None, None)

    return [of(w, c) for w, c in zip(columns["w"], columns["c"])]


def test_a_mapping_gives_masked_arrays(columns, expected):
    table = carvallo.stability(columns | {"id": np.arange(ROWS)})
    assert list(zip(table["stable_from_1"].tolist(), table["stable_to_1"].tolist())) == [tuple(ends) for ends in expected]
    assert table["error"][7] == "`w` is -1 m; it must be > 0" and table["error"][8] is None
    assert table["weave_count"].mask[7] and not table["weave_count"].mask[8]
    assert table["id"][3] == 3
    once = carvallo.stability(columns, threads=1)
    assert all(np.ma.allequal(table[name], once[name]) for name in once if name != "error")


def test_pandas_in_and_out(columns, expected):
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    frame = pandas.DataFrame(columns, index=pandas.RangeIndex(100, 100 + ROWS))
    table = carvallo.stability(frame, v=[5.0])
    assert table.index.equals(frame.index) and list(table.columns[: len(columns)]) == list(frame.columns)
    assert table["stable_from_1"].dtype == "Float64" and table["weave_count"].dtype == "Int32"
    assert [None if pandas.isna(value) else value for value in table["stable_from_1"]] == [start for start, _ in expected]
    assert table["error"].notna().sum() == 1 and set(table["verdict_at_5"].dropna()) == {"stable", "unstable"}
    nullable = frame.convert_dtypes()
    nullable.loc[100, "c"] = pandas.NA
    assert carvallo.stability(nullable)["error"].notna().tolist()[0]


def test_arrow_in_and_out(columns, expected):
    arrow = pytest.importorskip("pyarrow", reason="pyarrow is not installed")
    given = arrow.table(columns | {"name": [f"design {index}" for index in range(ROWS)]})
    table = carvallo.stability(given, v=[5.0])
    assert isinstance(table, arrow.Table) and table.column_names[: len(columns) + 1] == given.column_names
    assert table["stable_from_1"].to_pylist() == [start for start, _ in expected]
    assert table["stable_to_1"].to_pylist() == [end for _, end in expected]
    assert table["error"].null_count == ROWS - 1 and table["weave_count"].type == arrow.int32()
    assert table.schema.field("weave_1").metadata == {b"unit": b"m/s"}
    table.validate(full=True)
    (batch,) = given.to_batches()
    assert carvallo.stability(batch, v=[5.0]).equals(table.to_batches()[0])
    chunked = arrow.concat_tables([given.slice(0, 1000), given.slice(1000)])
    assert carvallo.stability(chunked, v=[5.0]).combine_chunks().equals(table)


def test_arrow_columns_are_not_copied(columns):
    arrow = pytest.importorskip("pyarrow", reason="pyarrow is not installed")
    from carvallo.tables import _numbers

    column = arrow.table(columns)["w"]
    assert _numbers("w", column).ctypes.data == column.chunk(0).buffers()[1].address


def test_a_base_gives_what_has_no_column(benchmark):
    table = carvallo.stability({"mB": np.array([60.0, 85.0])}, benchmark)
    assert table["stable_from_1"][1] == benchmark.stable_ranges()[0].start
    assert carvallo.stability({"mB": np.zeros(0)}, benchmark)["stable_from_1"].shape == (0,)
    car = carvallo.stability({"a": np.array([1.0, 1.6])}, carvallo.Car("oversteering"))
    assert "divergence_1" in car


def test_mistakes(benchmark):
    with pytest.raises(ValueError, match="missing: `w`, `c`"):
        carvallo.stability({"mB": [85.0]})
    with pytest.raises(ValueError, match="`ww` is not a parameter of Whipple; did you mean `w`?"):
        carvallo.stability({"ww": [1.0]}, benchmark)
    with pytest.raises(ValueError, match="the columns differ in length: 1, 2"):
        carvallo.stability({"w": [1.0], "c": [0.1, 0.2]}, benchmark)
    with pytest.raises(ValueError, match="the column `w` is not of numbers"):
        carvallo.stability({"w": ["long"]}, benchmark)
    with pytest.raises(ValueError, match="the table is of the type int"):
        carvallo.stability(3)
