"""Results of jobs as Parquet: a row for each value that a job measured."""

from __future__ import annotations

import io
import json
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from . import _core, _files, _json
from ._error import Error

COLUMNS = ("job", "experiment", "parameters", "seed", "commit", "name", "unit", "value", "aim", "aim_value")


def _arrow() -> Any:
    try:
        import pyarrow.parquet
    except ModuleNotFoundError:
        raise Error("Parquet needs pyarrow: pip install 'gt2003[parquet]'") from None
    return pyarrow


def _row(job: str, value: dict[str, Any]) -> tuple[Any, ...]:
    experiment, *words = job.split()
    parameters = dict(word.split("=", 1) for word in words)
    seed, commit = int(parameters.pop("seed", 1)), parameters.pop("commit", "")
    aim = value.get("aim", {"kind": None, "value": None})
    measured = (value.get("name"), value.get("unit"), value.get("value"))
    return (job, experiment, list(parameters.items()), seed, commit, *measured, aim["kind"], aim["value"])


def write(lines: Iterable[str], file: str | os.PathLike[str]) -> None:
    """Write results, lines of JSON, into a file. It is whole or it is not there."""
    pa = _arrow()
    types = [pa.string(), pa.string(), pa.map_(pa.string(), pa.string()), pa.uint64(), pa.string(), pa.string(),
             pa.string(), pa.float64(), pa.string(), pa.float64()]
    rows = []
    for line in lines:
        result = _json.parse(line)
        rows += [_row(result["job"], value) for value in result["values"] or [{}]]
    columns = list(zip(*rows)) or [()] * len(COLUMNS)
    table = pa.table([pa.array(c, t) for c, t in zip(columns, types, strict=True)], names=list(COLUMNS))
    bytes_of_table = io.BytesIO()
    pa.parquet.write_table(table, bytes_of_table)
    _files.write(file, bytes_of_table.getvalue())


def read(file: str | os.PathLike[str]) -> list[str]:
    """Return the results of a file as lines of JSON, the same bytes as they were written from."""
    pa = _arrow()
    if not Path(file).is_file():
        raise Error("there is no such file", str(file))
    try:
        table = pa.parquet.read_table(file)
    except (OSError, ValueError) as error:  # pyarrow's own are of these classes
        raise Error(f"is no whole Parquet file: {str(error).splitlines()[0]}", str(file)) from None
    for name in COLUMNS:
        if name not in table.column_names:
            raise Error("is not a table of results: this column is missing", str(file), field=name)
    results: dict[str, list[dict[str, Any]]] = {}
    for row in table.select(["job", "name", "unit", "value", "aim", "aim_value"]).to_pylist():
        values = results.setdefault(row["job"], [])
        if row["name"] is not None:
            aim = {"kind": row["aim"], "value": row["aim_value"]}
            values.append({"name": row["name"], "unit": row["unit"], "value": row["value"], "aim": aim})
    lines = []
    for job, values in results.items():
        try:
            lines.append(_core._result_line(json.dumps({"job": job, "values": values})))
        except Error as error:
            raise Error(error.what, str(file), field=error.field or job) from None
    return lines
