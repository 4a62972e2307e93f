"""The figures that are kept (docs/figures.json), and the list of those that are measured (measured.toml).

The file is an array of figures as `experiment` and `bench` write them, with what it takes to measure and judge them again. An Error says
in one line which entry and which field is wrong.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from gt2003 import Error, _files, _json, _tables
from gt2003._intervals import mean_interval
from verdicts import KINDS, Sample

DIGITS = 6
NOTHING = "nothing"  # counts as worse: the figure is not judged


def rounded(value: float) -> float:
    """Return a value with as many digits as the file keeps."""
    return float(f"{value:.{DIGITS}g}")


@dataclass(frozen=True)
class Kept:
    """A figure of the file.

    interval: 95 %, of the mean (Student); empty if there is one run. seeds: in the order of the runs; empty if the runs have none.
    seconds: processor time of the command, which may give other figures, too. worse: greater, less, different, or nothing if it is
    only quoted by pages.
    """

    name: str
    value: float
    interval: tuple[float, ...]
    unit: str
    n: int
    worse: str
    command: str
    seconds: float
    commit: str
    seeds: tuple[int, ...]
    runs: tuple[float, ...]

    @property
    def sample(self) -> Sample:
        return Sample(self.runs, self.seeds)


def keep(name: str, unit: str, worse: str, command: str, seconds: float, commit: str, sample: Sample) -> Kept:
    """Return a figure with mean and interval of its runs."""
    runs = tuple(map(rounded, sample.runs))
    interval = tuple(map(rounded, mean_interval(runs) or ()))
    return Kept(name, rounded(math.fsum(runs) / len(runs)), interval, unit, len(runs), worse, command, rounded(seconds), commit, sample.seeds, runs)


def _check(figure: Kept, file: str) -> None:
    def check(good: bool, name: str, what: str) -> None:
        if not good:
            raise Error(what, file, field=f"{figure.name}.{name}")

    check(figure.worse in (*KINDS, NOTHING), "worse", f"expected one of: {', '.join((*KINDS, NOTHING))}")
    check(re.fullmatch("[0-9a-f]{7,40}", figure.commit) is not None, "commit", "expected a commit")
    check(figure.seconds >= 0, "seconds", "expected 0 or more")
    check(len(figure.runs) == figure.n > 0, "n", f"there are {len(figure.runs)} runs")
    check(not figure.seeds or len(figure.seeds) == figure.n == len(set(figure.seeds)), "seeds", "expected one for each run")
    made = keep(figure.name, figure.unit, figure.worse, figure.command, figure.seconds, figure.commit, figure.sample)
    for name, value, expected in (("value", (figure.value,), (made.value,)), ("interval", figure.interval, made.interval)):
        near = len(value) == len(expected) and all(math.isclose(a, b, rel_tol=1e-4, abs_tol=1e-9) for a, b in zip(value, expected))
        check(near, name, f"is not that of the runs: {', '.join(f'{v:g}' for v in expected)}")


def read(path: Path) -> dict[str, Kept]:
    """Return the figures of a file by their names; none if there is no file."""
    file = str(path)
    try:
        entries = _json.parse(path.read_text(), file) if path.exists() else []
    except (OSError, UnicodeDecodeError) as error:
        raise Error(getattr(error, "strerror", None) or "is not text", file) from None
    if not isinstance(entries, list):
        raise Error("expected an array of figures", file)
    figures: dict[str, Kept] = {}
    for i, entry in enumerate(entries, 1):
        name = entry.get("name") if isinstance(entry, dict) else None
        figure = _tables.made(Kept, entry, file, name if isinstance(name, str) else f"figure {i}")
        if figure.name in figures:
            raise Error("is there twice", file, field=figure.name)
        _check(figure, file)
        figures[figure.name] = figure
    return figures


LINES = (("name", "value", "interval", "unit", "n", "worse"), ("command", "seconds", "commit"), ("seeds", "runs"))


def _text(value: object) -> str:
    """Return a value as JSON; whole numbers without a point."""
    if isinstance(value, tuple):
        return f"[{', '.join(map(_text, value))}]"
    whole = isinstance(value, float) and value.is_integer() and abs(value) < 1e15
    return json.dumps(int(value) if whole else value, ensure_ascii=False)  # type: ignore[call-overload]


def text(figures: Iterable[Kept]) -> str:
    """Return the text of a file: ordered by names, a few lines each."""
    entries = []
    for figure in sorted(figures, key=lambda f: f.name):
        lines = [", ".join(f'"{name}": {_text(getattr(figure, name))}' for name in names) for names in LINES]
        entries.append(" {" + ",\n  ".join(lines) + "}")
    return "[\n" + ",\n".join(entries) + "\n]\n" if entries else "[]\n"


def write(path: Path, figures: Iterable[Kept]) -> None:
    """Write a file of figures, whole or not at all."""
    _files.write(path, text(figures))


@dataclass(frozen=True)
class Measured:
    """A figure that a command gives. Differences up to the tolerance, or up to a share of the kept value, do not matter."""

    name: str
    worse: str
    tolerance: float = 0
    share: float = 0

    def tolerated(self, value: float) -> float:
        return max(self.tolerance, self.share * abs(value))


@dataclass(frozen=True)
class Measurement:
    """A command with the figures that are taken from what it writes.

    seeds: a range, for a command that has the option --seeds. core: whether it belongs to the core set. calibrated: files of
    config/calibrated.cfg of which the figures tell whether they fit. recheck: arguments in the place of the seeds, with which some of the
    figures are measured within seconds, where all of them take longer. quoted: how names begin, of figures that are kept besides if a
    page quotes them, and not judged.
    """

    command: str
    figure: tuple[Measured, ...] = ()
    quoted: str = ""
    seeds: str = ""
    core: bool = False
    calibrated: tuple[str, ...] = ()
    recheck: str = ""

    def gives(self, name: str) -> bool:
        """Return whether a figure that a page quotes is one of the command's."""
        return bool(self.quoted) and f"{name}.".startswith(f"{self.quoted}.")


@dataclass(frozen=True)
class _List:
    measurement: tuple[Measurement, ...]


def measurements(path: Path) -> tuple[Measurement, ...]:
    """Read the list of what is measured."""
    file = str(path)
    listed = _tables.made(_List, _tables.load(path), file).measurement
    names: set[str] = set()
    for i, measurement in enumerate(listed, 1):
        if not measurement.command.split():
            raise Error("expected a program with its arguments", file, field=f"measurement {i}.command")
        if not measurement.figure and not measurement.quoted:
            raise Error("gives no figures", file, field=f"measurement {i}")
        if measurement.recheck and not measurement.calibrated:
            raise Error("names no files of config/calibrated.cfg", file, field=f"measurement {i}.recheck")
        for figure in measurement.figure:
            if figure.worse not in KINDS:
                raise Error(f"expected one of: {', '.join(KINDS)}", file, field=f"{figure.name}.worse")
            if figure.tolerance < 0:
                raise Error("expected 0 or more", file, field=f"{figure.name}.tolerance")
            if not 0 <= figure.share <= 1:
                raise Error("expected 0 to 1", file, field=f"{figure.name}.share")
            if figure.name in names:
                raise Error("is measured twice", file, field=figure.name)
            names.add(figure.name)
    return listed
