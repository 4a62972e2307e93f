"""Experiments and their jobs, as the program `experiment` does them.

A job is a line of text: an experiment with its parameters, on a seed, by the program built from a
commit. Its result is a line of JSON with the values that it measured. Both are those of `experiment`,
to the byte (docs/experiments.md).

    for job in gt2003.jobs.select(seeds="1..4", only=["match"], settings=["minutes=1"]):
        print(gt2003.jobs.measure(job))
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from . import _core, _files, _parquet
from ._error import Error

__all__ = [
    "Experiment", "Parameter", "complete", "convert", "experiments", "measure", "merge", "read", "results", "select"
]


@dataclass(frozen=True)
class Parameter:
    """A parameter of an experiment: one of `values` (each, choice), or of which this is the default."""

    name: str
    description: str
    kind: str
    values: tuple[str, ...]


@dataclass(frozen=True)
class Experiment:
    """Something that can be measured on a seed."""

    name: str
    description: str
    parameters: tuple[Parameter, ...]


def experiments() -> list[Experiment]:
    """Return all experiments, in the order of their names."""
    return [
        Experiment(name, description, tuple(Parameter(*p[:3], tuple(p[3])) for p in parameters))
        for name, description, parameters in _core._experiments()
    ]


def select(
    seeds: str = "1..10", only: Iterable[str] = (), settings: Iterable[str] = ()
) -> list[str]:
    """Return the jobs of experiments or groups of them (all, if none is named).

    seeds: a range like 1..10, or one; settings: NAME=VALUE of parameters, for all experiments that
    have them. The same as `experiment list`.
    """
    return _core._list_jobs(seeds, list(only), list(settings))


def complete(job: str) -> str:
    """Return a job with all its parameters and the commit; an Error says what is wrong with it."""
    return _core._complete_job(job)


def read(file: str | os.PathLike[str]) -> list[str]:
    """Return the jobs that a file lists, one a line, completed and each once; # begins a comment."""
    try:
        lines = Path(file).read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise Error(getattr(error, "strerror", None) or "is not text", str(file)) from None
    jobs: dict[str, None] = {}
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            jobs[complete(line)] = None
        except Error as error:
            raise Error(error.what, str(file), number, error.field) from None
    return list(jobs)


def measure(job: str, *, root: str = "") -> str:
    """Do a job and return its result, a line of JSON. The interpreter's lock is released meanwhile.

    root: the data root, instead of the package's own.
    """
    return _core._measure_job(job, root)


def merge(
    files: Iterable[str | os.PathLike[str]],
    json: str | os.PathLike[str],
    jobs: Iterable[str] = (),
    note: str = "",
) -> list[str]:
    """Merge files of results (lines of JSON, or *.parquet) to figures in a file `json`, and pages beside it.

    note: a sentence for the top of the pages. Returns warnings: what was dropped, and which of the
    jobs have no result. The same results give the same bytes as `experiment merge`, in whatever order
    they come.
    """
    with tempfile.TemporaryDirectory() as folder:
        lines = []
        for number, file in enumerate(map(os.fspath, files)):
            if file.endswith(".parquet"):
                made = Path(folder) / f"{number}.jsonl"
                made.write_text("".join(line + "\n" for line in _parquet.read(file)))
                file = str(made)
            lines.append(file)
        return _core._merge_results(lines, list(jobs), os.fspath(json), note)


def results(file: str | os.PathLike[str]) -> list[str]:
    """Return the results that a file holds, lines of JSON. Its name tells the form: *.parquet, or lines of JSON.

    Lines that are not whole are passed over.
    """
    if os.fspath(file).endswith(".parquet"):
        return _parquet.read(file)
    try:
        text = Path(file).read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise Error(getattr(error, "strerror", None) or "is not text", str(file)) from None
    lines = []
    for line in text.splitlines():
        try:
            lines.append(_core._result_line(line))
        except Error:
            continue
    return lines


def convert(file: str | os.PathLike[str], to: str | os.PathLike[str]) -> None:
    """Write the results of a file into another one; their names tell the forms, as of `results`.

    Parquet has a row for each value that a job measured: job, experiment, parameters, seed, commit,
    name, unit, value, aim, aim_value. `pandas.read_parquet` reads it, too.
    """
    lines = results(file)
    if os.fspath(to).endswith(".parquet"):
        _parquet.write(lines, to)
    else:
        _files.write(to, "".join(line + "\n" for line in lines))
