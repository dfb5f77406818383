"""Stability of tables of designs: columns of numpy, pandas or Arrow in, the same out."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .design import Design
from .model import Model, models
from .stability import VERDICTS, Column, columns_of

KEPT = ("name", "id", "index", "bike", "bicycle")
"""Columns that are no parameters, but copied to the result."""


def stability(table: Any, base: Design | Model | None = None, *, v: ArrayLike = (), threads: int | None = None) -> Any:
    """The critical speeds and stable ranges of a table of designs, as ``carvallo sweep`` has them.

    Parameters
    ----------
    table
        A mapping from names of parameters to arrays of one dimension and equal length, a ``pandas.DataFrame``, or a
        ``pyarrow`` Table or RecordBatch. Values are in SI units. ``name``, ``id``, ``index``, ``bike`` and ``bicycle`` are
        copied. Columns of doubles without nulls are read where they are; no rows are made.
    base
        What parameters without a column are taken from: a design. A model, by default ``carvallo.Whipple``, has none to give:
        then all must have a column.
    v
        Forward speeds in m/s at which verdicts and eigenvalues are added.
    threads
        How many threads work: as many as there are cores unless it is given. Inside Dask, Ray or Spark, whose workers share
        the cores, 1 is right.

    Returns
    -------
    A table of the kind of the given one with its columns and those of the result: ``weave_count``, ``weave_1`` and so on, as
    :class:`carvallo.Stability` has them, and ``error``. What there is not is null (in a mapping: masked arrays), never NaN. A
    design that is none has nothing but an ``error``, which says why, and the others are not affected.

    Raises
    ------
    ValueError
        If a column is no parameter, or a parameter has neither a column nor a base.
    """
    given = _read(table)
    model = base.model if isinstance(base, Design) else base or models()["Whipple"]
    parameters = {name: column for name, column in given.items() if name not in KEPT}
    positions = {model._kernel.position(name): name for name in parameters}
    names = list(model)
    lengths = {len(column) for column in given.values()}
    if len(lengths) > 1:
        raise ValueError(f"the columns differ in length: {', '.join(map(str, sorted(lengths)))}")
    values: list[Any] = list(base._values) if isinstance(base, Design) else [None] * len(names)
    if isinstance(base, Design) and base.shape:
        raise ValueError(f"the base is {base.size} designs; it must be one")
    for position, name in positions.items():
        values[position] = _numbers(name, parameters[name])
    missing = [f"`{names[position]}`" for position, value in enumerate(values) if value is None]
    if missing:
        raise ValueError(f"missing: {', '.join(missing)} (of {len(names)} parameters); a design as `base` has them")
    count = lengths.pop() if lengths else 1
    designs = model._kernel.designs(values, [count])
    columns, errors = columns_of(designs, v, threads)
    return _write(table, columns, errors)


def _read(table: Any) -> dict[str, Any]:
    """Columns by their names."""
    if _is_arrow(table):
        return dict(zip(table.schema.names, table.columns))
    if isinstance(table, Mapping) or hasattr(table, "columns"):
        return {str(name): table[name] for name in (table if isinstance(table, Mapping) else table.columns)}
    raise ValueError(f"the table is of the type {type(table).__name__}; expected a mapping, or a table of pandas or pyarrow")


def _numbers(name: str, column: Any) -> NDArray[np.float64]:
    """Doubles, one behind the other; those that are there already are not copied. Nulls are NaN, which no parameter can be."""
    if hasattr(column, "combine_chunks"):
        column = column.chunk(0) if column.num_chunks == 1 else column.combine_chunks()
    if hasattr(column, "to_numpy") and hasattr(column, "null_count"):
        column = column.to_numpy(zero_copy_only=False)
    elif hasattr(column, "to_numpy") and getattr(column.dtype, "na_value", None) is not None:
        column = column.to_numpy(dtype=np.float64, na_value=np.nan)
    elif isinstance(column, np.ma.MaskedArray):
        column = np.ma.MaskedArray(column, dtype=np.float64).filled(np.nan)
    try:
        numbers = np.ascontiguousarray(column, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(f"the column `{name}` is not of numbers") from None
    if numbers.ndim != 1:
        raise ValueError(f"the column `{name}` has {numbers.ndim} dimensions; it must have one")
    return numbers


def _write(table: Any, columns: dict[str, Column], errors: list[str | None]) -> Any:
    if _is_arrow(table):
        return _write_arrow(table, columns, errors)
    if isinstance(table, Mapping):
        masked: dict[str, Any] = {name: column.masked() for name, column in columns.items()}
        return {**table, **masked, "error": np.array(errors, dtype=object)}
    return _write_pandas(table, columns, errors)


def _write_pandas(table: Any, columns: dict[str, Column], errors: list[str | None]) -> Any:
    import pandas

    def series(column: Column) -> Any:
        masked = column.masked()
        if column.kind == "number":
            return pandas.arrays.FloatingArray(column.cells, ~column.present)
        if column.kind == "count":
            return pandas.arrays.IntegerArray(masked.data, ~column.present)
        return pandas.array(masked.tolist(), dtype="string")

    results = {name: series(column) for name, column in columns.items()}
    results["error"] = pandas.array(errors, dtype="string")
    return pandas.concat([table, pandas.DataFrame(results, index=table.index)], axis=1)


def _write_arrow(table: Any, columns: dict[str, Column], errors: list[str | None]) -> Any:
    import pyarrow

    def validity(column: Column) -> Any:
        return pyarrow.py_buffer(np.packbits(column.present, bitorder="little"))

    def array(column: Column) -> Any:
        if column.kind == "number":
            buffers = [validity(column), pyarrow.py_buffer(column.cells)]
            return pyarrow.Array.from_buffers(pyarrow.float64(), len(column.cells), buffers)
        whole = column.cells.astype(np.int32)
        if column.kind == "count":
            return pyarrow.Array.from_buffers(pyarrow.int32(), len(whole), [validity(column), pyarrow.py_buffer(whole)])
        places = pyarrow.array(whole, mask=~column.present)
        return pyarrow.DictionaryArray.from_arrays(places, pyarrow.array(VERDICTS)).cast(pyarrow.string())

    names, arrays = list(table.schema.names), list(table.columns)
    fields = [table.schema.field(index) for index in range(len(names))]
    for name, column in columns.items():
        arrays.append(array(column))
        fields.append(pyarrow.field(name, arrays[-1].type, metadata={"unit": column.unit} if column.unit else None))
    arrays.append(pyarrow.array(errors, pyarrow.string()))
    fields.append(pyarrow.field("error", pyarrow.string()))
    return type(table).from_arrays(arrays, schema=pyarrow.schema(fields, metadata=table.schema.metadata))


def _is_arrow(table: Any) -> bool:
    return type(table).__module__.partition(".")[0] == "pyarrow"


__all__ = ["stability"]
